// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reasoners/icarus/language/argument_check.h"
#include "reasoners/icarus/language/signature.h"
#include "reasoners/icarus/language/walk.h"
#include "reasoners/icarus/lint/lint.h"
#include "reasoners/icarus/lint/name_words.h"

namespace latchwork::icarus {

namespace {

std::string Count(std::size_t count, std::string_view noun) {
  return std::to_string(count) + ' ' + std::string(noun) + (count == 1 ? "" : "s");
}

/// The heads of the facts that a program begins with or stores; `open` when a head is computed.
struct FactHeads {
  std::set<std::string, std::less<>> names;
  bool open = false;

  void Add(const Term& fact) {
    if (fact.kind != TermKind::kList || fact.items.empty()) return;
    const Term& head = fact.items.front();
    if (head.kind == TermKind::kSymbol) {
      names.insert(head.text);
    } else if (head.kind == TermKind::kVariable) {
      open = true;
    }
  }
};

class CallLint {
 public:
  CallLint(const Program& program, const CheckOptions& options, Reporter& reporter,
           Findings& findings)
      : program_(program), options_(options), reporter_(reporter), findings_(findings) {
    for (const Skill& skill : program.skills) names_.push_back(skill.name);
    heads_.names.insert(options.facts.begin(), options.facts.end());
    for (const Term& fact : program.facts) heads_.Add(fact);
    for (const Skill& skill : program.skills) {
      WalkTerms(skill, [&](const Term& term, Slot) {
        if (term.kind != TermKind::kCall || term.items.empty()) return;
        if (term.text == "store" || term.text == "update") heads_.Add(term.items.back());
      });
    }
  }

  void Check(const Skill& skill) {
    WalkClauses(skill, [&](const Clause& clause, Slot slot) {
      if (clause.kind == ClauseKind::kSkill) CheckArity(clause);
      if (clause.kind == ClauseKind::kMatch) CheckMatch(clause, slot);
    });
    WalkTerms(skill, [&](const Term& term, Slot slot) {
      if (term.kind == TermKind::kCall) CheckCall(term, slot);
    });
    if (skill.value) {
      WalkTerm(*skill.value, [&](const Term& term) {
        if (term.kind == TermKind::kCall) CheckCall(term, Slot::kObjective);
      });
    }
  }

 private:
  void CheckArity(const Clause& clause) {
    const Skill& callee = program_.skills[clause.skill];
    const std::size_t given = clause.terms.size();
    if (given == callee.parameters || !callee.has_whole_head) return;
    const bool more = given > callee.parameters;
    reporter_.Add(more ? Code::kTooManyArguments : Code::kTooFewArguments, clause.form,
                  "'" + callee.spelling + "' has " + Count(callee.parameters, "parameter") +
                      ", but is called with " + std::to_string(given),
                  more ? "take out what is too much" : HintForTooFew(callee));
    reporter_.Note(callee.name_form, "defined here");
    if (!more && options_.strict && !findings_.empty()) {
      findings_.back().severity = Severity::kError;
    }
  }

  static std::string HintForTooFew(const Skill& callee) {
    const bool plan = callee.type == SkillType::kPlan || callee.type == SkillType::kSensor;
    return plan ? "write ? for what is of no interest" : "give all of them a value";
  }

  /// Whether skills have names with capitals, and this is one.
  bool IsNamedLikeSkills(std::string_view name) const {
    const auto is_capital = [](std::string_view each) {
      return !each.empty() && each[0] >= 'A' && each[0] <= 'Z';
    };
    return is_capital(name) &&
           std::all_of(program_.skills.begin(), program_.skills.end(),
                       [&](const Skill& skill) { return is_capital(skill.spelling); });
  }

  /// Facts may come from a layer where there is a top, and from a script where no fact is shown.
  /// Among means, where a match never acts, that is no excuse for what is named like a skill.
  bool MayComeFromElsewhere(std::string_view name, Slot slot) const {
    if (heads_.open) return true;
    if (slot == Slot::kMeans && options_.facts.empty() && IsNamedLikeSkills(name)) return false;
    return program_.facts.empty() || program_.top;
  }

  void CheckMatch(const Clause& clause, Slot slot) {
    const Term& head = clause.terms.front();
    if (head.kind != TermKind::kSymbol || heads_.names.contains(head.text)) return;
    const std::string_view nearest = Nearest(head.text);
    const std::string name(program_.source.Text(head.form));
    const std::string meant =
        nearest.empty() ? "" : program_.skills[program_.Find(nearest)].spelling;
    if (!meant.empty() && IsSlip(name, meant)) {
      reporter_.Add(Code::kMisspeltSkill, clause.form,
                    "there is no skill '" + name + "', so this asks memory for a fact",
                    "did you mean '" + meant + "'?");
    } else if (!MayComeFromElsewhere(name, slot)) {
      const bool means = slot == Slot::kMeans;
      reporter_.Add(Code::kUnknownFact, clause.form,
                    "there is no skill '" + name + "', and no fact begins with it" +
                        (means ? ", so this never acts" : ""),
                    "define the skill, or declare the fact: (facts (" + name + " ...))");
    }
  }

  /// Compares names, as long as that stays cheap.
  std::string_view Nearest(const std::string& name) {
    constexpr std::size_t kMostComparisons = 1U << 20U;
    const auto known = nearest_.find(name);
    if (known != nearest_.end()) return known->second;
    comparisons_ += names_.size();
    if (comparisons_ > kMostComparisons) return {};
    return nearest_.emplace(name, logic::NearestName(name, names_)).first->second;
  }

  void CheckCall(const Term& call, Slot slot) {
    const Signature* signature = FindBuiltin(call.text);
    if (signature == nullptr) return;
    CheckArguments(program_, call, *signature, reporter_);
    if (!signature->changes_memory || slot == Slot::kSensor || slot == Slot::kAction) return;
    reporter_.Add(Code::kEffect, call.form, "{" + call.text + "} changes memory in a condition",
                  "put it into the :sensor or :action of a skill of its own");
  }

  const Program& program_;
  const CheckOptions& options_;
  Reporter& reporter_;
  Findings& findings_;
  std::vector<std::string> names_;
  FactHeads heads_;
  std::map<std::string, std::string_view> nearest_;
  std::size_t comparisons_ = 0;
};

}  // namespace

void LintCalls(const Program& program, const CheckOptions& options, Reporter& reporter,
               Findings& findings) {
  CallLint lint(program, options, reporter, findings);
  for (const Skill& skill : program.skills) lint.Check(skill);
  WalkNameless(program, [&](const Skill& skill) { lint.Check(skill); });
}

}  // namespace latchwork::icarus
