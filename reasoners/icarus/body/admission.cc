// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/body/admission.h"

#include <algorithm>
#include <limits>

namespace latchwork::icarus {

namespace {

constexpr std::uint64_t kUnknownVersion = std::numeric_limits<std::uint64_t>::max();

/// All ways in which a conjunction is True are counted, whatever acts it comes to.
RunOptions ForCounting(RunOptions options) {
  options.acts = ActMode::kFirst;
  options.expansion = Expansion::kAll;
  options.lazy = false;
  options.faults = FaultMode::kFalse;
  return options;
}

std::string ReasonOf(const Program& program, const Skill& never) {
  const logic::SourcePlace place = program.source.Place(never.form);
  std::string reason = "contradicts ";
  bool space = false;
  for (const char c : program.source.Text(never.form)) {
    const bool blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!blank && space) reason += ' ';
    if (!blank) reason += c;
    space = blank;
  }
  return reason + " (" + place.file + ':' + std::to_string(place.line) + ')';
}

}  // namespace

Admission::Admission(const sdk::Body& body, TermBridge& bridge, NamePool& names,
                     const Program& program, RunOptions options)
    : bridge_(bridge),
      host_(body, bridge),
      interpreter_(program, host_, names, ForCounting(options)),
      parameters_(interpreter_.memory()) {
  for (std::size_t i = 0; i < program.nevers.size(); ++i) {
    nevers_.push_back(
        {interpreter_.AddNever(i, findings_), 0, ReasonOf(program, program.nevers[i])});
  }
  counts_.resize(nevers_.size());
  host_.Serve(interpreter_, program);
  parameters_.Set(body.facts, bridge_, interpreter_.memory());
}

/// All latches but one, which is emptied.
void Admission::SetLatches(std::span<const sdk::Latch> latches, std::size_t port) {
  FactStore& memory = interpreter_.memory();
  while (versions_.size() < latches.size()) {
    versions_.push_back(kUnknownVersion);
    latch_facts_.emplace_back(memory);
  }
  for (std::size_t i = 0; i < latches.size(); ++i) {
    const bool emptied = i == port;
    if (!emptied && versions_[i] == latches[i].version) continue;
    versions_[i] = emptied ? kUnknownVersion : latches[i].version;
    latch_facts_[i].Set(emptied ? std::span<const logic::Fact>() : latches[i].facts, bridge_,
                        memory);
  }
}

std::size_t Admission::Count(const Never& never) {
  const CycleResult& result = interpreter_.Cycle(never.top, limits_);
  return result.limit == LimitHit::kNone ? result.environments : never.known;
}

/// What has come True in a new way; null, and counted as known, when nothing has.
const Admission::Never* Admission::FirstNew() {
  for (std::size_t i = 0; i < nevers_.size(); ++i) {
    counts_[i] = Count(nevers_[i]);
    if (counts_[i] > nevers_[i].known) return &nevers_[i];
  }
  for (std::size_t i = 0; i < nevers_.size(); ++i) nevers_[i].known = counts_[i];
  return nullptr;
}

void Admission::Admit(std::span<const sdk::Latch> latches, std::size_t port,
                      std::span<const logic::Fact> batch, const sdk::Budget& budget,
                      std::vector<sdk::Refusal>& refused) {
  limits_.depth = budget.depth;
  limits_.clauses = budget.inferences;
  limits_.cancelled = budget.cancelled;
  limits_.deadline = budget.deadline;
  host_.ResetCalls();
  SetLatches(latches, port);
  for (Never& never : nevers_) never.known = Count(never);
  admitted_.clear();
  for (std::size_t i = 0; i < batch.size(); ++i) {
    admitted_.push_back(batch[i]);
    latch_facts_[port].Set(admitted_, bridge_, interpreter_.memory());
    const Never* const contradicted = FirstNew();
    if (contradicted == nullptr) continue;
    refused.push_back({i, contradicted->reason});
    admitted_.pop_back();
    latch_facts_[port].Set(admitted_, bridge_, interpreter_.memory());
  }
  limits_.cancelled = nullptr;
  limits_.deadline.reset();
}

}  // namespace latchwork::icarus
