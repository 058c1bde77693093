// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/diff_journal.h"

#include <fmt/format.h>

#include <memory>
#include <set>
#include <utility>

#include "apps/latchwork/command.h"
#include "apps/latchwork/run_agent.h"
#include "latchwork/record/journal_reader.h"
#include "latchwork/schedule/lockstep.h"
#include "reasoners/pttp/theory/theory.h"

namespace latchwork::app {
namespace {

/// A layer's latches in a run, and the contenders that are asked about them.
struct Asked {
  std::string name;
  sdk::Body body;
  sdk::Budget budget;
  std::vector<sdk::Latch> latches;
  std::vector<std::shared_ptr<sdk::Reasoner>> reasoners;  ///< None for what refuses the body.
  std::set<std::size_t> reported;
  std::uint64_t left_out = 0;  ///< Of its decisions.
};

class Comparison : public schedule::RunObserver {
 public:
  Comparison(const schedule::Agent& agent, const std::vector<Contender>& contenders,
             logic::SymbolTable& symbols, JournalReport& report)
      : symbols_(symbols), report_(report) {
    for (std::size_t i = 0; i < agent.layers.size(); ++i) {
      Asked& asked = layers_.emplace_back();
      const auto& description = agent.description.layers[i];
      asked.name = description.name;
      asked.body = agent.layers[i].body;
      asked.budget.inferences = description.reasoner.inferences;
      asked.budget.depth = description.reasoner.depth;
      for (const auto& port : asked.body.contract.inputs) {
        asked.latches.push_back({port.name, {}, 0});
      }
      if (asked.body.language == "tptp") {
        Load(asked, contenders);
      } else {
        report_.notes.push_back(asked.body.language.empty()
                                    ? fmt::format("layer {} has no theory", asked.name)
                                    : fmt::format("layer {}: its body is in {}, not a theory",
                                                  asked.name, asked.body.language));
      }
    }
  }

  bool OnTick(const schedule::TickRecord& record) override {
    for (const auto& latched : record.latched) {
      sdk::Latch& latch = layers_[latched.layer].latches.at(latched.port);
      latch.facts.assign(latched.facts.begin(), latched.facts.end());
      latch.version = latched.version;
      if (latched.undecided != nullptr) latch.undecided = *latched.undecided;
    }
    for (const auto& decision : record.decisions) {
      Compare(layers_[decision.layer], record.tick);
    }
    return true;
  }

 private:
  void Load(Asked& asked, const std::vector<Contender>& contenders) {
    for (const Contender& contender : contenders) {
      auto reasoner = contender.make();
      logic::Diagnostics diagnostics;
      const auto parameters = sdk::Parameters::Check(reasoner->parameters(), contender.given,
                                                     contender.name, {}, diagnostics);
      if (diagnostics.empty()) diagnostics = reasoner->Load(asked.body, parameters, symbols_);
      if (!diagnostics.empty()) {
        report_.notes.push_back(fmt::format("layer {}: {} does not take its body: {}", asked.name,
                                            contender.name, diagnostics.front().message));
        reasoner.reset();
      }
      asked.reasoners.push_back(std::move(reasoner));
    }
  }

  Verdict Decide(const Asked& asked, std::size_t contender) {
    sdk::Decision decision;
    asked.reasoners[contender]->Decide(asked.latches, asked.budget, decision);
    return Understand(decision, asked.body);
  }

  void Compare(Asked& asked, std::uint64_t tick) {
    if (asked.reasoners.empty() || !asked.reasoners.front()) return;
    // What may hold or not takes as many decisions as there are states.
    for (const auto& latch : asked.latches) {
      if (latch.undecided.facts.empty()) continue;
      if (asked.left_out++ == 0) {
        report_.notes.push_back(fmt::format(
            "layer {}: decisions from facts that are undecided are left out", asked.name));
      }
      return;
    }
    const Verdict first = Decide(asked, 0);
    for (std::size_t i = 1; i < asked.reasoners.size(); ++i) {
      if (!asked.reasoners[i]) continue;
      const Verdict other = Decide(asked, i);
      ++report_.decisions;
      const bool both = first.kind == Verdict::Kind::kDecided && other.kind == first.kind;
      if (!both) ++report_.undecided;
      if (!Disagree(first, other) || !asked.reported.insert(i).second) continue;
      JournalDifference difference{tick, asked.name, i, {}, first, other};
      pttp::Theory theory(asked.body, symbols_);
      theory.ReadFiles();
      difference.theory = {theory.Clauses(false), asked.latches, asked.body, asked.budget};
      report_.differences.push_back(std::move(difference));
    }
  }

  logic::SymbolTable& symbols_;
  JournalReport& report_;
  std::vector<Asked> layers_;
};

class Ticker : public schedule::RunObserver {
 public:
  Ticker(const std::function<void(std::uint64_t, std::uint64_t)>& notice, std::uint64_t total)
      : notice_(notice), total_(total) {}
  bool OnTick(const schedule::TickRecord& record) override {
    notice_(record.tick + 1, total_);
    return true;
  }

 private:
  const std::function<void(std::uint64_t, std::uint64_t)>& notice_;
  std::uint64_t total_;
};

}  // namespace

JournalReport DiffJournal(const std::filesystem::path& journal,
                          const std::vector<Contender>& contenders,
                          const plugin::Registry& registry, logic::SymbolTable& symbols,
                          const std::function<void(std::uint64_t, std::uint64_t)>& notice) {
  JournalReport report;
  record::JournalReader reader(journal);
  if (!reader.header()) {
    report.errors = Format(*reader.problem());
    report.exit_code = kInvalidInput;
    return report;
  }
  const record::JournalHeader& header = *reader.header();
  RunRequest request;
  request.agent_file = header.agent_file;
  if (!header.scenario.empty()) request.scenario = header.scenario;
  request.seed = header.seed;
  request.ticks = header.max_ticks;
  request.overrides = header.overrides;
  auto [agent, diagnostics, exit_code] = PrepareAgent(request, registry, symbols);
  if (!agent) {
    report.errors = logic::Format(diagnostics);
    report.exit_code = exit_code;
    return report;
  }
  Comparison comparison(*agent, contenders, symbols, report);
  Ticker ticker(notice, header.max_ticks);
  schedule::LockstepOptions options;
  options.observers = {&comparison, &ticker};
  options.max_ticks = header.max_ticks;
  schedule::Lockstep lockstep(*std::move(agent), options);
  lockstep.Run();
  return report;
}

}  // namespace latchwork::app
