// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/semantics_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <string_view>

#include "reasoners/circumscription/formats/lay_file.h"

namespace latchwork::app {
namespace {

namespace circ = latchwork::circumscription;

class Report {
 public:
  Report(const SemanticsProblem& problem, const SemanticsFindings& findings)
      : theory_(problem.theory), problem_(problem), findings_(findings) {}

  std::string Write() {
    Line("Conditions");
    Models();
    Transfers();
    Goals();
    if (!problem_.queries.empty()) Comparison();
    if (findings_.difference) Difference(*findings_.difference);
    return std::move(text_);
  }

 private:
  template <typename... Arguments>
  void Line(fmt::format_string<Arguments...> form, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }
  void Condition(std::string_view name, std::string_view value) { Line("  {:<34}{}", name, value); }

  void Models();
  void Transfers();
  void Objection(const circ::GivenUp& given_up);
  void Goals();
  void Comparison();
  void Difference(const SmallestDifference& difference);
  void Contradiction(const circ::GroundTheory& theory, const circ::Core& core);

  const circ::LayeredTheory& theory_;
  const SemanticsProblem& problem_;
  const SemanticsFindings& findings_;
  std::string text_;
};

void Report::Contradiction(const circ::GroundTheory& theory, const circ::Core& core) {
  for (const circ::Literal fact : core.latches) Line("      fact    {}", ToString(theory, fact));
  for (const std::size_t index : core.clauses) {
    Line("      clause  {}", ToString(theory, theory.clauses[index]));
  }
}

void Report::Models() {
  const auto& models = findings_.conditions.layers_have_models;
  circ::Verdict all = circ::Verdict::kYes;
  for (const circ::Verdict verdict : models) {
    if (verdict != circ::Verdict::kYes && all != circ::Verdict::kNo) all = verdict;
  }
  Condition("every layer has a model", Name(all));
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (models[i] != circ::Verdict::kNo) continue;
    Line("    {} contradicts itself, and hands nothing down:", LayerName(theory_, i));
    const circ::BridgedTheory bridged = WithBridges(theory_, i);
    const auto core = MinimalCore(bridged.theory, bridged.latches);
    if (core) Contradiction(bridged.theory, *core);
  }
}

void Report::Transfers() {
  const circ::Conditions& conditions = findings_.conditions;
  Condition("consistent with all transfers", Name(conditions.consistent_with_transfers));
  const bool kept = conditions.given_up.empty();
  const bool unknown = kept && !conditions.bridges_known;
  Condition("every bridge kept in every model", unknown ? "unknown" : kept ? "yes" : "no");
  for (const circ::GivenUp& given_up : conditions.given_up) Objection(given_up);
  Condition("smooth preference", "yes (finitely many atoms)");
}

/// Why a bridge is given up: the clauses and facts of the layer, and the bridges that are kept.
void Report::Objection(const circ::GivenUp& given_up) {
  const circ::BridgedTheory bridged = WithBridges(theory_, given_up.layer);
  const circ::Bridge& bridge = theory_.layers[given_up.layer].bridges[given_up.bridge];
  Line("    {}: {} is rejected by", LayerName(theory_, given_up.layer),
       BridgeName(theory_, given_up.layer, bridge));
  for (const circ::Literal fact : given_up.core.latches) {
    if (circ::AtomOf(fact) >
        static_cast<circ::Atom>(theory_.layers[given_up.layer].theory.atoms.size())) {
      continue;  // A premise, or that a bridge is kept.
    }
    Line("      fact    {}", ToString(bridged.theory, fact));
  }
  for (const std::size_t index : given_up.core.clauses) {
    if (index >= bridged.first_bridge && index < bridged.first_fact_clause) {
      if (index - bridged.first_bridge == given_up.bridge) continue;
      const auto& other = theory_.layers[given_up.layer].bridges[index - bridged.first_bridge];
      Line("      bridge  {}", BridgeName(theory_, given_up.layer, other));
    } else {
      Line("      {}  {}", index < bridged.first_bridge ? "clause" : "fact  ",
           ToString(bridged.theory, bridged.theory.clauses[index]));
    }
  }
}

void Report::Goals() {
  const circ::Conditions& conditions = findings_.conditions;
  if (conditions.has_model == circ::Verdict::kNo) {
    return Line("  there is no layered model: by Definition 1 everything follows");
  }
  Condition("goals decided", conditions.GoalsDecided() ? "yes" : "no");
  for (const circ::LayerGoal& goal : conditions.goals) {
    Line("    {}: {} is {}", LayerName(theory_, goal.layer),
         ToString(theory_.layers[goal.layer].theory, goal.goal), Name(goal.status));
  }
}

void Report::Comparison() {
  Line("\nProcedure against Definition 1");
  const std::size_t queries = problem_.queries.size();
  for (const TransferFindings& transfer : findings_.transfers) {
    const std::size_t unsound = findings_.Count(transfer, circ::Fault::kUnsound);
    const std::size_t incomplete = findings_.Count(transfer, circ::Fault::kIncomplete);
    const std::size_t undecided = findings_.CountUndecided(transfer);
    if (undecided > 0 && unsound + incomplete == 0) {
      Line(
          "  {:<9}not decided: {} of {} queries, a budget ran out (--conflicts, --calls, --states)",
          Name(transfer.transfer), undecided, queries);
    } else if (unsound + incomplete == 0) {
      Line("  {:<9}the same on all {} queries", Name(transfer.transfer), queries);
    } else {
      Line("  {:<9}differs on {} of {} queries: {} unsound, {} incomplete", Name(transfer.transfer),
           unsound + incomplete, queries, unsound, incomplete);
    }
  }
}

void Report::Difference(const SmallestDifference& difference) {
  const circ::Query& query = problem_.queries[difference.query];
  const bool unsound = difference.fault == circ::Fault::kUnsound;
  Line("\nCounter-example: transfer {} is {} on {}", Name(difference.transfer),
       Name(difference.fault), query.id);
  const circ::CounterExample& example = difference.example;
  Line("  {} concludes {}; {}", unsound ? "it" : "it never",
       ToString(example.theory.layers.front().theory, example.clause),
       unsound ? "yet this is a layered model:" : "yet it holds in all layered models");
  if (difference.model) {
    for (std::size_t i = difference.model->size(); i-- > 0;) {
      Line("    {}: {}", LayerName(example.theory, i), fmt::join((*difference.model)[i], " "));
    }
  }
  Line("  The smallest part of the theory that shows it:");
  const circ::Query smallest{query.id, false, example.clause};
  const std::string lay = WriteLay(example.theory, {&smallest, 1});
  for (std::size_t at = 0; at < lay.size();) {
    const std::size_t end = lay.find('\n', at);
    Line("    {}", lay.substr(at, end - at));
    at = end + 1;
  }
}

void AddLines(std::string_view letter, const SemanticsProblem& problem,
              const std::vector<circ::Verdict>& verdicts, std::string& text) {
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    text += fmt::format("{}{} {}\n", letter, problem.queries[i].id, Name(verdicts[i]));
  }
}

}  // namespace

std::string Describe(const SemanticsProblem& problem, const SemanticsFindings& findings) {
  return Report(problem, findings).Write();
}

std::string AnswerLines(const SemanticsProblem& problem, const SemanticsFindings& findings) {
  std::string text;
  if (findings.transfers.size() == 1) {
    AddLines("", problem, findings.transfers.front().verdicts, text);
    return text;
  }
  for (const TransferFindings& transfer : findings.transfers) {
    const std::string letter(1, Name(transfer.transfer).front());
    AddLines(letter + " ", problem, transfer.verdicts, text);
  }
  AddLines("= ", problem, findings.definition, text);
  return text;
}

}  // namespace latchwork::app
