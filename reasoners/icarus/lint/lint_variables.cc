// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "reasoners/icarus/language/walk.h"
#include "reasoners/icarus/lint/lint.h"

namespace latchwork::icarus {

namespace {

using Bits = std::vector<bool>;

/// Which parameters a skill may bind, as far as can be seen without running it.
class Outputs {
 public:
  explicit Outputs(const Program& program) : program_(program) {
    for (const Skill& skill : program.skills) may_bind_.emplace_back(skill.parameters, false);
    bool changed = true;
    for (int pass = 0; changed && pass < kPasses; ++pass) {
      changed = false;
      for (std::size_t i = 0; i < program.skills.size(); ++i) changed |= Update(i);
    }
    if (!changed) return;
    for (Bits& bits : may_bind_) bits.assign(bits.size(), true);
  }

  /// Adds the variables that a clause may bind.
  void Add(const Clause& clause, Bits& bound) const {
    switch (clause.kind) {
      case ClauseKind::kBind:
        if (clause.terms[1].kind != TermKind::kCall) AddAll(clause.terms[1], bound);
        AddAll(clause.terms[0], bound);
        break;
      case ClauseKind::kMatch:
        for (const Term& term : clause.terms) AddAll(term, bound);
        break;
      case ClauseKind::kSkill: {
        const Bits& outputs = may_bind_[clause.skill];
        for (std::size_t i = 0; i < clause.terms.size() && i < outputs.size(); ++i) {
          if (outputs[i]) AddAll(clause.terms[i], bound);
        }
        break;
      }
      default:
        break;
    }
  }

 private:
  static constexpr int kPasses = 64;

  static void AddAll(const Term& term, Bits& bound) {
    WalkTerm(term, [&](const Term& part) {
      if (part.kind == TermKind::kVariable) bound[part.index] = true;
    });
  }

  bool Update(std::size_t index) {
    const Skill& skill = program_.skills[index];
    Bits bound(skill.variables.size(), false);
    for (std::size_t slot = 0; slot < kSlots; ++slot) {
      if (!skill.slots.at(slot)) continue;
      for (const Clause& clause : *skill.slots.at(slot)) Add(clause, bound);
    }
    bool changed = false;
    for (std::size_t i = 0; i < skill.parameters; ++i) {
      if (!bound[i] || may_bind_[index][i]) continue;
      may_bind_[index][i] = true;
      changed = true;
    }
    return changed;
  }

  const Program& program_;
  std::vector<Bits> may_bind_;
};

/// Follows one skill in the order in which its clauses are asked.
class BindingLint {
 public:
  BindingLint(const Program& program, const Outputs& outputs, const Skill& skill,
              Reporter& reporter)
      : program_(program), outputs_(outputs), skill_(skill), reporter_(reporter) {
    entry_.assign(skill.variables.size(), false);
    std::fill_n(entry_.begin(), skill.parameters, true);
  }

  void Check() {
    for (const Slot slot : {Slot::kObjective, Slot::kSequence, Slot::kAction, Slot::kSensor}) {
      Conjunction(slot, entry_);
    }
    const Bits required = Conjunction(Slot::kRequires, entry_);
    const std::vector<Clause>* means = skill_.slot(Slot::kMeans);
    if (means == nullptr) return;
    for (const Clause& clause : *means) {
      Bits bound = required;
      CheckClause(clause, bound);
    }
  }

 private:
  Bits Conjunction(Slot slot, Bits bound) {
    const std::vector<Clause>* clauses = skill_.slot(slot);
    if (clauses == nullptr) return bound;
    for (const Clause& clause : *clauses) {
      CheckClause(clause, bound);
      outputs_.Add(clause, bound);
    }
    return bound;
  }

  void CheckClause(const Clause& clause, Bits& bound) {
    for (const Term& term : clause.terms) {
      if (term.kind == TermKind::kCall) CheckCall(term, bound);
    }
    for (const Clause& inner : clause.inner) CheckClause(inner, bound);
    if (clause.kind != ClauseKind::kSkill) return;
    const Skill& callee = program_.skills[clause.skill];
    if (callee.type == SkillType::kAction) {
      Require(clause.terms, Code::kUnboundAct, "the act '" + callee.spelling + "'", bound);
    } else if (callee.type == SkillType::kSequence) {
      Require(clause.terms, Code::kUnboundSequence, "the sequence '" + callee.spelling + "'",
              bound);
    }
  }

  /// What {forget} and {update} look for is a pattern: there variables may be unbound.
  void CheckCall(const Term& call, Bits& bound) {
    const bool pattern_first = call.text == "forget" || call.text == "update";
    for (std::size_t i = 0; i < call.items.size(); ++i) {
      if (pattern_first && i == 0) continue;
      Require({&call.items[i], 1}, Code::kUnboundCall, "{" + call.text + "}", bound);
    }
  }

  void Require(std::span<const Term> terms, Code code, const std::string& what, Bits& bound) {
    for (const Term& term : terms) {
      WalkTerm(term, [&](const Term& part) {
        if (part.kind != TermKind::kVariable || bound[part.index]) return;
        reporter_.Add(code, part.form,
                      "nothing before this binds " + std::string(Spelling(part)) + ", which " +
                          what + " needs",
                      "bind it first, or make it a parameter");
        bound[part.index] = true;
      });
    }
  }

  std::string_view Spelling(const Term& variable) const {
    return program_.source.Text(variable.form);
  }

  const Program& program_;
  const Outputs& outputs_;
  const Skill& skill_;
  Reporter& reporter_;
  Bits entry_;
};

void LintSingles(const Program& program, const Skill& skill, Reporter& reporter) {
  for (std::size_t i = 0; i < skill.variables.size(); ++i) {
    if (skill.occurrences[i] > 1 || skill.variables[i].starts_with("?_")) continue;
    const std::string name(program.source.Text(skill.variable_forms[i]));
    reporter.Add(Code::kVariableOnce, skill.variable_forms[i],
                 "the variable " + name + " stands only here",
                 "write " + std::string(i < skill.parameters ? "" : "? or ") + "?_" +
                     name.substr(1) + " if that is meant");
  }
}

}  // namespace

void LintVariables(const Program& program, Reporter& reporter) {
  const Outputs outputs(program);
  for (const Skill& skill : program.skills) {
    LintSingles(program, skill, reporter);
    BindingLint(program, outputs, skill, reporter).Check();
  }
  for (const Skill& never : program.nevers) {
    LintSingles(program, never, reporter);
    BindingLint(program, outputs, never, reporter).Check();
  }
}

}  // namespace latchwork::icarus
