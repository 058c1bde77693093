// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "reasoners/pttp/proofs/proof_tree.h"

namespace latchwork::pttp {
namespace {

using logic::AnnotatedFormula;
using logic::Clause;
using logic::ClauseOrigins;
using logic::Role;

constexpr std::size_t kMostLines = 400;
constexpr std::size_t kLongestText = 300;

/// What speaks of clauses by the formulas that they stem from.
class Speaker {
 public:
  Speaker(std::span<const Clause> clauses, const ProofSources& sources)
      : clauses_(clauses), sources_(sources) {}

  bool IsOfGoal(std::size_t clause) const {
    return clauses_[clause].role == Role::kNegatedConjecture;
  }

  /// `rule with X = a`, to come after "by".
  std::string Source(const ProofPremise& premise) {
    if (!premise.theory.empty()) return std::string(premise.theory);
    return Name(premise.instance.clause) + Values(premise.instance);
  }
  std::string Name(std::size_t index) {
    const Clause& clause = clauses_[index];
    if (clause.place.line == 0) return fmt::format("{} of equality", clause.name);
    used_.insert(clause.name);
    return IsConjecture(clause) ? fmt::format("the negation of {}", clause.name) : clause.name;
  }
  std::string Values(const ClauseInstance& instance) const {
    const auto& names = clauses_[instance.clause].variable_names;
    std::vector<std::string> values;
    for (std::size_t i = 0; i < std::min(names.size(), instance.values.size()); ++i) {
      if (instance.values[i].is_variable()) continue;
      values.push_back(fmt::format("{} = {}", names[i], ToString(instance.values[i])));
    }
    return values.empty() ? "" : fmt::format(" with {}", fmt::join(values, ", "));
  }
  /// `c holds with X = a`, or what else is shown by contradicting the start clause.
  std::string Goal(const ProofPremise& start) {
    if (!start.theory.empty()) return "The formulas contradict " + std::string(start.theory);
    const Clause& clause = clauses_[start.instance.clause];
    if (!IsConjecture(clause)) {
      return fmt::format("{} contradicts the other formulas", Source(start));
    }
    used_.insert(clause.name);
    return fmt::format("{} holds{}", clause.name, Values(start.instance));
  }

  void Note(const Clause& clause) {
    for (const logic::Literal& literal : clause.literals) Note(literal);
  }
  void Note(const logic::Literal& literal) {
    symbols_.insert(literal.atom.predicate());
    std::vector<const logic::Term*> visits;
    for (const logic::Term& argument : literal.atom.arguments()) visits.push_back(&argument);
    while (!visits.empty()) {
      const logic::Term& term = *visits.back();
      visits.pop_back();
      if (term.is_variable() || term.is_number()) continue;
      symbols_.insert(term.symbol());
      for (const logic::Term& argument : term.arguments()) visits.push_back(&argument);
    }
  }

  /// What was used, and what the names mean that are not in the file.
  void Finish(Explanation& lines) const {
    lines.push_back({0, fmt::format("Formulas used: {}.", fmt::join(used_, ", "))});
    for (const auto& form : sources_.origins.normal_forms) {
      for (const logic::Symbol function : form.skolem_functions) {
        if (!symbols_.contains(function)) continue;
        lines.push_back({1, fmt::format("{} is a name for what {} speaks of without naming it",
                                        function.name(), NameOf(form))});
      }
    }
    for (const auto& definition : sources_.origins.definitions) {
      if (!symbols_.contains(definition.name)) continue;
      lines.push_back({1, fmt::format("{} is an abbreviation: {}", definition.name.name(),
                                      ToString(definition.formula, definition.variable_names))});
    }
  }

 private:
  bool IsConjecture(const Clause& clause) const {
    return clause.role == Role::kNegatedConjecture &&
           std::ranges::any_of(sources_.formulas, [&](const AnnotatedFormula& formula) {
             return formula.role == Role::kConjecture && formula.name == clause.name;
           });
  }
  static std::string NameOf(const ClauseOrigins::NormalForm& form) {
    return form.clauses.empty() ? "the conjecture" : form.clauses.front().name;
  }

  std::span<const Clause> clauses_;
  ProofSources sources_;
  std::set<std::string> used_;
  std::set<logic::Symbol> symbols_;
};

/// Lines up to a bound on number and length, with a word on what is left out.
void Cut(Explanation& lines) {
  for (ExplanationLine& line : lines) line.text = Shorten(std::move(line.text));
  if (lines.size() <= kMostLines) return;
  const std::size_t left_out = lines.size() - kMostLines;
  lines.resize(kMostLines);
  lines.push_back({0, fmt::format("({} more lines; --proof shows every step)", left_out)});
}

/// Instances of what is to be proved, those with negative literals alone first; then all other
/// premises without a positive literal, then the rest.
std::vector<std::size_t> Starts(std::span<const ProofPremise> premises, const Speaker& speaker) {
  std::vector<std::pair<int, std::size_t>> ranked;
  for (std::size_t i = 0; i < premises.size(); ++i) {
    const ProofPremise& premise = premises[i];
    const bool of_goal = premise.theory.empty() && speaker.IsOfGoal(premise.instance.clause);
    const bool negative =
        std::ranges::none_of(premise.instance.literals, [](const auto& l) { return l.positive; });
    ranked.emplace_back((of_goal ? 0 : 2) + (negative ? 0 : 1) + (premise.theory.empty() ? 0 : 4),
                        i);
  }
  std::ranges::sort(ranked);
  std::vector<std::size_t> starts;
  starts.reserve(ranked.size());
  for (const auto& [rank, premise] : ranked) starts.push_back(premise);
  return starts;
}

std::string HowShown(const ProofNode& node, std::span<const ProofPremise> premises,
                     Speaker& speaker) {
  switch (node.kind) {
    case ProofNode::Kind::kReduction:
      return "by the assumption above (else the goal there holds already)";
    case ProofNode::Kind::kRepeated:
      return "as above";
    case ProofNode::Kind::kPremise:
      break;
  }
  return fmt::format("by {}{}", speaker.Source(premises[node.premise]),
                     node.children.empty() ? "" : ", since");
}

Explanation TreeLines(const ProofTree& tree, std::span<const ProofPremise> premises,
                      Speaker& speaker) {
  Explanation lines;
  lines.push_back({0, fmt::format("{}, since", speaker.Goal(premises[tree.start]))});
  std::vector<std::pair<std::size_t, std::uint32_t>> visits;
  const auto push = [&](const std::vector<std::size_t>& children, std::uint32_t depth) {
    for (std::size_t i = children.size(); i > 0; --i) visits.emplace_back(children[i - 1], depth);
  };
  push(tree.children, 1);
  while (!visits.empty()) {
    const auto [index, depth] = visits.back();
    visits.pop_back();
    const ProofNode& node = tree.nodes[index];
    speaker.Note(node.goal);
    lines.push_back(
        {depth, fmt::format("{}: {}", ToString(node.goal), HowShown(node, premises, speaker))});
    push(node.children, depth + 1);
  }
  return lines;
}

Explanation PremiseLines(std::span<const ProofPremise> premises, Speaker& speaker) {
  Explanation lines{{0, "These contradict each other:"}};
  for (const ProofPremise& premise : premises) {
    Clause clause;
    clause.literals = premise.instance.literals;
    speaker.Note(clause);
    lines.push_back({1, fmt::format("{}: by {}", ToString(clause), speaker.Source(premise))});
  }
  return lines;
}

std::string StepSource(const saturation::Step& step, Speaker& speaker) {
  if (step.input) return speaker.Name(*step.input);
  std::vector<std::string> parents;
  for (const std::size_t parent : step.parents) parents.push_back(fmt::format("{}", parent + 1));
  return fmt::format("{} by {}", fmt::join(parents, " and "), step.rule);
}

}  // namespace

std::string Shorten(std::string text) {
  if (text.size() <= kLongestText) return text;
  std::size_t end = kLongestText;
  // Not within a character of several bytes.
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
  return text.substr(0, end) + "...";
}

Explanation ExplainProof(std::span<const Clause> clauses, std::span<const ProofPremise> premises,
                         const ProofSources& sources) {
  Speaker speaker(clauses, sources);
  const auto tree = ArrangeProof(premises, Starts(premises, speaker));
  Explanation lines = tree ? TreeLines(*tree, premises, speaker) : PremiseLines(premises, speaker);
  Cut(lines);
  speaker.Finish(lines);
  return lines;
}

Explanation ExplainProof(std::span<const Clause> clauses, std::span<const saturation::Step> steps,
                         const ProofSources& sources) {
  Speaker speaker(clauses, sources);
  Explanation lines{{0, "A contradiction follows, step by step:"}};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const saturation::Step& step = steps[i];
    speaker.Note(step.clause);
    const std::string text = step.clause.literals.empty() ? "contradiction" : ToString(step.clause);
    lines.push_back({1, fmt::format("{}. {}, from {}", i + 1, text, StepSource(step, speaker))});
  }
  Cut(lines);
  speaker.Finish(lines);
  return lines;
}

}  // namespace latchwork::pttp
