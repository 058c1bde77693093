// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/swipl/swipl_reasoner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "core/process/spawn.h"
#include "latchwork/sdk/specs.h"
#include "reasoners/swipl/engine_text.h"

namespace latchwork::swipl {
namespace {

/// Calls of Prolog predicates that stand for one inference of a budget.
constexpr std::uint64_t kCalls = 10;
constexpr std::uint64_t kMostCalls = std::uint64_t{1} << 59U;
constexpr std::chrono::seconds kStartTime{30};
constexpr std::size_t kNoPort = SIZE_MAX;

std::uint64_t CallsFor(std::uint64_t inferences) {
  return inferences > kMostCalls / kCalls ? kMostCalls : inferences * kCalls;
}

/// Ends the program unless the conversation came to its end.
class EndGuard {
 public:
  explicit EndGuard(process::Companion& companion) : companion_(companion) {}
  EndGuard(const EndGuard&) = delete;
  EndGuard& operator=(const EndGuard&) = delete;
  ~EndGuard() {
    if (!is_done) companion_.Kill();
  }
  bool is_done = false;

 private:
  process::Companion& companion_;
};

std::string LastLine(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  if (end == std::string::npos) return "it said nothing";
  const std::size_t begin = text.find_last_of('\n', end);
  return text.substr(begin + 1, end - begin);
}

}  // namespace

std::span<const sdk::ParameterSpec> SwiplReasoner::parameters() const {
  static const std::array<sdk::ParameterSpec, 6> kTable = {
      sdk::BooleanParameter("unique_names", false,
                            "distinct constants, and compound terms of distinct functions, are "
                            "unequal"),
      sdk::BooleanParameter("equality_axioms", false,
                            "equations that clauses conclude are used everywhere; else `=` is "
                            "identity after arithmetic"),
      sdk::BooleanParameter("cache_decisions", true,
                            "what was decided stands while the latches hold the same"),
      sdk::IntegerParameter("consistency_inferences", "2000", 0, 1e9,
                            "what a cycle spends on finding that body and latches contradict each "
                            "other; 0: nothing"),
      sdk::RealParameter("seconds", "10", 0.01, 86400, "s",
                         "wall time after which a decision is broken off and the program ended; "
                         "what was decided then depends on the machine"),
      sdk::IntegerParameter("memory", "1024", 64, 16777216, "memory that the program may use",
                            "MB")};
  return kTable;
}

logic::Diagnostics SwiplReasoner::Load(const sdk::Body& body, const sdk::Parameters& parameters,
                                       logic::SymbolTable& symbols) {
  body_ = body;
  symbols_ = &symbols;
  companion_.Kill();
  program_ = process::FindProgram("swipl");
  if (program_.empty()) {
    return {{{},
             "reasoner swipl: there is no program 'swipl' in PATH",
             "install it: sudo apt-get install --no-install-recommends swi-prolog-nox",
             ""}};
  }
  unique_names_ = parameters.Boolean("unique_names");
  equality_axioms_ = parameters.Boolean("equality_axioms");
  cache_decisions_ = parameters.Boolean("cache_decisions");
  consistency_inferences_ =
      static_cast<std::uint64_t>(parameters.Integer("consistency_inferences"));
  seconds_ = parameters.Real("seconds");
  memory_mb_ = static_cast<std::uint64_t>(parameters.Integer("memory"));
  theory_ = std::make_unique<pttp::Theory>(body_, symbols);
  if (auto diagnostics = theory_->ReadFiles(); !diagnostics.empty()) return diagnostics;
  Render();
  std::string problem;
  if (!Start(problem)) return {{{}, problem, "", ""}};
  return {};
}

void SwiplReasoner::Render() {
  companion_.Kill();
  names_ = {};
  ports_.clear();
  base_.clear();
  decided_ = false;
  clauses_ = theory_->Clauses(equality_axioms_);
  writer_ = std::make_unique<RuleWriter>(body_, clauses_, names_, *symbols_, unique_names_);
  rendering_ = writer_->Write();
  for (const auto& [predicate, facts] : rendering_.facts) {
    for (const logic::Fact& fact : facts) AddRow(fact, base_);
  }
}

bool SwiplReasoner::Start(std::string& problem) {
  if (companion_.is_running()) return true;
  sent_.clear();
  const std::vector<std::string> arguments = {
      "-q",   "-f",
      "none", fmt::format("--stack-limit={}m", memory_mb_ / 2),
      "-g",   std::string(kBootGoal)};
  const std::string text = fmt::format("{}\n{}\nend.\n", EngineText(), rendering_.program);
  // What starts takes its share of address space before any stack grows.
  constexpr std::uint64_t kOwnMemory = 256;
  const process::Companion::Patience patience{process::Companion::Clock::now() + kStartTime};
  std::string line;
  if (companion_.Start(program_, arguments, memory_mb_ + kOwnMemory) &&
      companion_.Send(text, patience) &&
      companion_.ReadLine(line, patience) == process::Companion::Reply::kLine && line == "ready") {
    return true;
  }
  problem = fmt::format("reasoner swipl: {} cannot be started: {}", program_.string(),
                        LastLine(companion_.errors()));
  companion_.Kill();
  return false;
}

logic::Diagnostics SwiplReasoner::Tell(std::string_view text) {
  auto diagnostics = theory_->Tell(text);
  if (diagnostics.empty()) Render();
  return diagnostics;
}

logic::Diagnostics SwiplReasoner::Retract(std::string_view name) {
  auto diagnostics = theory_->Retract(name);
  if (diagnostics.empty()) Render();
  return diagnostics;
}

void SwiplReasoner::AddRow(const logic::Fact& fact, Rows& rows) {
  std::string& text = rows[names_.Predicate(NameOf(fact))];
  if (!text.empty()) text += ',';
  names_.Write("f", fact, text);
}

bool SwiplReasoner::LoadLatches(std::span<const sdk::Latch> latches) {
  bool changed = latches.size() != ports_.size();
  ports_.resize(latches.size());
  for (std::size_t i = 0; i < latches.size(); ++i) {
    Port& port = ports_[i];
    if (port.is_loaded && port.version == latches[i].version) continue;
    port.rows.clear();
    for (const logic::Fact& fact : latches[i].facts) AddRow(fact, port.rows);
    port.version = latches[i].version;
    port.is_loaded = true;
    changed = true;
  }
  return changed;
}

std::string SwiplReasoner::Facts(std::size_t without) {
  Rows wanted = base_;
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    if (i == without) continue;
    for (const auto& [predicate, rows] : ports_[i].rows) {
      std::string& text = wanted[predicate];
      text += (text.empty() ? "" : ",") + rows;
    }
  }
  for (const auto& [predicate, rows] : sent_) wanted[predicate];
  std::string commands;
  for (const auto& [predicate, rows] : wanted) {
    if (const auto known = sent_.find(predicate); known != sent_.end() && known->second == rows) {
      continue;
    }
    const std::size_t arity = names_.predicate(predicate).arity;
    std::string blanks;
    for (std::size_t i = 0; i < arity; ++i) blanks += i == 0 ? "(_" : ",_";
    commands +=
        fmt::format("facts(f{}{}{},[{}]).\n", predicate, blanks, arity == 0 ? "" : ")", rows);
  }
  sent_ = std::move(wanted);
  return commands;
}

Conversation::End SwiplReasoner::Converse(const std::string& command, const sdk::Budget& budget,
                                          Listener& listener, sdk::Decision& decision) {
  using Clock = process::Companion::Clock;
  const auto own = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(seconds_));
  const bool is_own = !budget.deadline || own < *budget.deadline;
  Conversation conversation({companion_,
                             names_,
                             *writer_,
                             body_.attachments,
                             budget.depth,
                             {is_own ? own : *budget.deadline, budget.cancelled}},
                            listener);
  EndGuard guard(companion_);
  const Conversation::End end = conversation.Hold(command);
  guard.is_done = end == Conversation::End::kDone;
  decision.statistics.attachment_calls = conversation.attachment_calls();
  using End = Conversation::End;
  if (end == End::kLate) {
    decision.limit = sdk::Limit::kTime;
    if (is_own) decision.message = fmt::format("swipl was ended after {} s", seconds_);
  } else if (end == End::kCancelled) {
    decision.limit = sdk::Limit::kCancelled;
  } else if (end != End::kDone) {
    decision.status = sdk::Status::kFailed;
    decision.message =
        fmt::format("swipl {}: {}", end == End::kGone ? "ended by itself" : "went wrong",
                    end == End::kGone ? LastLine(companion_.errors()) : conversation.line());
  }
  return end;
}

/// Fills a decision with what is said.
class SwiplReasoner::DecisionListener final : public Listener {
 public:
  DecisionListener(const SwiplReasoner& reasoner, sdk::Decision& decision)
      : reasoner_(reasoner), decision_(decision) {}

  void Hear(const Answer& said) override {
    const auto& arguments = said.arguments;
    if (said.name == "concluded" && arguments.size() == 4) Conclude(arguments);
    if (said.name == "assumed" && arguments.size() == 2) Assume(arguments);
    if (said.name == "anew") decision_.assumptions.clear();
    if (said.name == "end" && arguments.size() == 2) EndGoal(arguments[1].name);
    if (said.name == "done" && arguments.size() == 3) Finish(arguments);
    if (said.name == "everything" && arguments.size() == 1) {
      decision_.message = "a goal was proved for every value, which is no fact";
    }
    if (said.name == "inconsistent" && arguments.size() == 1) {
      decision_.status = sdk::Status::kInconsistent;
      const auto number = static_cast<std::size_t>(arguments[0].integer);
      decision_.message = fmt::format("body and latches contradict each other: clause '{}'",
                                      reasoner_.rendering_.denials.at(number));
    }
  }

 private:
  void Conclude(const std::vector<Answer>& arguments) {
    const auto fact = ToFact(arguments[1], reasoner_.names_);
    if (!fact) return;
    sdk::Conclusion conclusion{static_cast<std::size_t>(arguments[0].integer), *fact, {}};
    for (const Answer& assumption : arguments[3].arguments) {
      conclusion.assumptions.push_back(static_cast<std::size_t>(assumption.integer));
    }
    std::ranges::sort(conclusion.assumptions);
    decision_.conclusions.push_back(std::move(conclusion));
    decision_.statistics.depth =
        std::max(decision_.statistics.depth, static_cast<std::uint32_t>(arguments[2].integer));
  }

  void Assume(const std::vector<Answer>& arguments) {
    using State = sdk::Assumption::State;
    const auto fact = ToFact(arguments[1], reasoner_.names_);
    if (!fact) return;
    const std::string& end = arguments[0].name;
    const State state = end == "accepted" ? State::kRetracted
                        : end == "depth"  ? State::kMadeByBound
                                          : State::kMade;
    decision_.assumptions.push_back({*fact, state});
  }

  void EndGoal(std::string_view end) {
    is_undecided_ = is_undecided_ || end == "depth" || end == "undetermined";
    if (end == "depth") decision_.limit = sdk::Limit::kDepth;
    if (end == "undetermined" && decision_.message.empty()) {
      decision_.message =
          "a literal never became ground, or a default or an attachment rests on itself";
    }
  }

  void Finish(const std::vector<Answer>& arguments) {
    decision_.statistics.inferences = static_cast<std::uint64_t>(arguments[1].integer) / kCalls;
    const bool is_stopped = arguments[0].name != "none";
    if (is_stopped) decision_.limit = sdk::Limit::kInferences;
    if (arguments[0].name == "memory") decision_.message = "swipl ran out of memory";
    if (decision_.limit == sdk::Limit::kNone && arguments[2].name == "true") {
      decision_.limit = sdk::Limit::kDepth;
    }
    if (decision_.status == sdk::Status::kInconsistent || is_stopped || is_undecided_) return;
    decision_.status = decision_.conclusions.empty() ? sdk::Status::kRefuted : sdk::Status::kProved;
  }

  const SwiplReasoner& reasoner_;
  sdk::Decision& decision_;
  bool is_undecided_ = false;
};

void SwiplReasoner::DecideAnew(const sdk::Budget& budget, sdk::Decision& decision) {
  if (!Start(decision.message)) {
    decision.status = sdk::Status::kFailed;
    return;
  }
  DecisionListener listener(*this, decision);
  const std::string command =
      fmt::format("{}decide({},{},{}).\n", Facts(kNoPort), std::max(1U, budget.depth),
                  CallsFor(budget.inferences), CallsFor(consistency_inferences_));
  Converse(command, budget, listener, decision);
}

void SwiplReasoner::Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
                           sdk::Decision& decision) {
  const bool changed = LoadLatches(latches);
  const bool is_same =
      budget.inferences == last_budget_.inferences && budget.depth == last_budget_.depth;
  if (!changed && decided_ && is_same && cache_decisions_) {
    decision = last_;
    return;
  }
  last_budget_ = budget;
  decision.Clear();
  decision.status = sdk::Status::kUnknown;
  decided_ = false;
  DecideAnew(budget, decision);
  last_ = decision;
  last_.statistics = {};
  decided_ = decision.status != sdk::Status::kFailed && decision.limit != sdk::Limit::kTime &&
             decision.limit != sdk::Limit::kCancelled;
}

bool SwiplReasoner::MayOffend(const logic::Fact& fact) {
  const auto found = rendering_.clauses.find(SignedOf(names_.Predicate(NameOf(fact)), false));
  return found != rendering_.clauses.end() &&
         std::ranges::any_of(found->second.sources,
                             [](const std::string& source) { return !source.empty(); });
}

std::string SwiplReasoner::Item(std::size_t index, const logic::Fact& fact, std::uint32_t depth) {
  std::string row;
  names_.Write("f", fact, row);
  if (!MayOffend(fact)) return fmt::format("item({},{},none,_,fail)", index, row);
  const std::string open = row.substr(1);
  const std::string call =
      open.find('(') == std::string::npos ? open + "(" : open.substr(0, open.size() - 1) + ",";
  const auto& clauses = rendering_.clauses.at(SignedOf(names_.Predicate(NameOf(fact)), false));
  const std::string arguments = call.substr(call.find('('));
  return fmt::format("item({},{},{}{}{},[]),D{},n{}D{},[]))", index, row, clauses.name, arguments,
                     depth, index, call, index);
}

/// Notes which facts are refused.
class SwiplReasoner::AdmissionListener final : public Listener {
 public:
  AdmissionListener(SwiplReasoner& reasoner, std::span<const logic::Fact> batch,
                    std::vector<sdk::Refusal>& refused)
      : reasoner_(reasoner), batch_(batch), refused_(refused) {}

  void Hear(const Answer& said) override {
    if (said.name != "offends" || said.arguments.size() != 2) return;
    const auto index = static_cast<std::size_t>(said.arguments[0].integer);
    const auto clause = static_cast<std::size_t>(said.arguments[1].integer);
    if (index >= batch_.size()) return;
    const auto predicate = reasoner_.names_.Predicate(NameOf(batch_[index]));
    const auto& sources = reasoner_.rendering_.clauses.at(SignedOf(predicate, false)).sources;
    const bool is_known = clause > 0 && clause <= sources.size();
    refused_.push_back({index, is_known
                                   ? fmt::format("contradicts clause '{}'", sources[clause - 1])
                                   : "contradicts the body"});
  }

 private:
  SwiplReasoner& reasoner_;
  std::span<const logic::Fact> batch_;
  std::vector<sdk::Refusal>& refused_;
};

void SwiplReasoner::Admit(std::span<const sdk::Latch> latches, std::size_t port,
                          std::span<const logic::Fact> batch, const sdk::Budget& budget,
                          std::vector<sdk::Refusal>& refused) {
  if (std::ranges::none_of(batch, [&](const auto& fact) { return MayOffend(fact); })) return;
  if (LoadLatches(latches)) decided_ = false;
  sdk::Decision decision;
  if (!Start(decision.message)) return;
  std::string command = Facts(port) + fmt::format("admit({},{},[", std::max(1U, budget.depth),
                                                  CallsFor(budget.inferences));
  for (std::size_t i = 0; i < batch.size(); ++i) {
    command += (i == 0 ? "" : ",") + Item(i, batch[i], std::max(1U, budget.depth));
  }
  command += "]).\n";
  AdmissionListener listener(*this, batch, refused);
  Converse(command, budget, listener, decision);
  // Admitted facts were added to what Prolog knows.
  for (const logic::Fact& fact : batch) sent_[names_.Predicate(NameOf(fact))] = "?";
}

sdk::Derivation SwiplReasoner::Explain(std::size_t /*conclusion*/) { return {}; }

}  // namespace latchwork::swipl
