// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "reasoners/icarus/language/argument_check.h"
#include "reasoners/icarus/language/signature.h"
#include "reasoners/icarus/language/walk.h"
#include "reasoners/icarus/lint/lint.h"

namespace latchwork::icarus {

namespace {

/// The types that the parameters of skills must have, inferred from what is done with them.
class ParameterTypes {
 public:
  ParameterTypes(const Program& program, Reporter& reporter)
      : program_(program), reporter_(reporter) {
    for (const Skill& skill : program.skills) {
      types_.emplace_back(skill.parameters, ArgumentType::kAny);
    }
    do {
      changed_ = false;
      for (std::uint32_t i = 0; i < program.skills.size(); ++i) Infer(i);
    } while (changed_);
  }

  ArgumentType Of(std::uint32_t skill, std::size_t parameter) const {
    if (!program_.skills[skill].has_whole_head) return ArgumentType::kAny;
    return parameter < types_[skill].size() ? types_[skill][parameter] : ArgumentType::kAny;
  }

 private:
  void Infer(std::uint32_t index) {
    const Skill& skill = program_.skills[index];
    WalkTerms(skill, [&](const Term& term, Slot) {
      if (term.kind != TermKind::kCall) return;
      const Signature* const builtin = FindBuiltin(term.text);
      if (builtin == nullptr || builtin->changes_memory) return;
      for (std::size_t i = 0; i < term.items.size(); ++i) {
        Narrow(index, term.items[i], builtin->TypeOf(i));
      }
    });
    WalkClauses(skill, [&](const Clause& clause, Slot) {
      if (clause.kind != ClauseKind::kSkill) return;
      for (std::size_t i = 0; i < clause.terms.size(); ++i) {
        Narrow(index, clause.terms[i], Of(clause.skill, i));
      }
    });
  }

  /// The term, where it is a parameter, must be of the type.
  void Narrow(std::uint32_t skill, const Term& term, ArgumentType type) {
    if (term.kind != TermKind::kVariable || term.index >= types_[skill].size()) return;
    ArgumentType& known = types_[skill][term.index];
    if (type == known || type == ArgumentType::kAny || Contains(type, known)) return;
    if (known == ArgumentType::kAny || Contains(known, type)) {
      known = type;
      changed_ = true;
      return;
    }
    const std::pair<std::uint32_t, std::uint32_t> parameter{skill, term.index};
    if (std::find(conflicts_.begin(), conflicts_.end(), parameter) != conflicts_.end()) return;
    conflicts_.push_back(parameter);
    reporter_.Add(Code::kParameterType, term.form,
                  "the parameter " + std::string(program_.source.Text(term.form)) + " must be " +
                      std::string(NameOf(type)) + " here, and elsewhere " +
                      std::string(NameOf(known)));
  }

  static bool Contains(ArgumentType wide, ArgumentType narrow) {
    return wide == ArgumentType::kNumber && narrow == ArgumentType::kInteger;
  }

  const Program& program_;
  Reporter& reporter_;
  std::vector<std::vector<ArgumentType>> types_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> conflicts_;  ///< Skills and parameters.
  bool changed_ = false;
};

void LintArguments(const Program& program, const ParameterTypes& types, const Skill& skill,
                   Reporter& reporter) {
  WalkClauses(skill, [&](const Clause& clause, Slot) {
    if (clause.kind != ClauseKind::kSkill) return;
    const Skill& callee = program.skills[clause.skill];
    for (std::size_t i = 0; i < clause.terms.size() && i < callee.parameters; ++i) {
      const ArgumentType type = types.Of(clause.skill, i);
      if (!Offends(program, clause.terms[i], type)) continue;
      reporter.Add(Code::kParameterType, clause.terms[i].form,
                   "'" + callee.spelling + "' needs " + std::string(NameOf(type)) + " here");
      reporter.Note(callee.variable_forms[i], "for this parameter");
    }
  });
}

}  // namespace

void LintTypes(const Program& program, Reporter& reporter) {
  const ParameterTypes types(program, reporter);
  for (const Skill& skill : program.skills) LintArguments(program, types, skill, reporter);
  WalkNameless(program,
               [&](const Skill& skill) { LintArguments(program, types, skill, reporter); });
}

}  // namespace latchwork::icarus
