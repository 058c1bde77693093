// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reasoners/icarus/language/walk.h"
#include "reasoners/icarus/lint/binding_modes.h"
#include "reasoners/icarus/lint/binding_trace.h"
#include "reasoners/icarus/lint/lint.h"
#include "reasoners/icarus/lint/program_tops.h"

namespace latchwork::icarus {

namespace {

Mode AllBound(const Program& program, std::uint32_t skill) {
  return {skill, Bits(program.skills[skill].parameters, true)};
}

/// How the skills that may be the top are called: what they are given is taken to be bound.
std::vector<Mode> EntriesOf(const Program& program, const CheckOptions& options) {
  std::vector<Mode> entries;
  if (program.top && options.top.empty()) return entries;  // Its call is followed.
  for (const std::uint32_t skill : TopsOf(program, options)) {
    if (skill != kNoSkill) entries.push_back(AllBound(program, skill));
  }
  return entries;
}

/// Follows the skills in the modes in which they may be called; those that nothing leads to, with
/// all their parameters bound.
class BindingLint final : private BindingListener {
 public:
  BindingLint(const Program& program, const CheckOptions& options, Reporter& reporter)
      : program_(program),
        modes_(program),
        trace_(program, *this),
        reporter_(reporter),
        reached_(program.skills.size(), false) {
    for (Mode& mode : EntriesOf(program, options)) Reach(std::move(mode), kNoForm);
  }

  void Check() {
    WalkNameless(program_, [&](const Skill& nameless) {
      current_ = nullptr;
      trace_.Follow(nameless, {});
    });
    Drain();
    for (std::uint32_t i = 0; i < program_.skills.size(); ++i) {
      if (reached_[i]) continue;
      Reach(AllBound(program_, i), kNoForm);
      Drain();
    }
  }

 private:
  void Reach(Mode mode, FormId call) {
    reached_[mode.skill] = true;
    const auto [place, is_new] = calls_.emplace(std::move(mode), call);
    if (is_new) waiting_.push_back(&place->first);
  }

  void Drain() {
    while (!waiting_.empty()) {
      current_ = waiting_.front();
      waiting_.pop_front();
      trace_.Follow(program_.skills[current_->skill], current_->bound);
    }
  }

  Exit Call(Mode mode, const Clause& clause) override {
    Exit exit = modes_.Of(mode);
    Reach(modes_.is_known() ? std::move(mode) : AllBound(program_, clause.skill), clause.form);
    return exit;
  }

  bool IsOpenParameter(const Term& term) const {
    return current_ != nullptr && term.kind == TermKind::kVariable &&
           term.index < current_->bound.size() && !current_->bound[term.index];
  }

  void Missing(const Term& term, const Need& need, const Bindings& bindings) override {
    if (!reported_.insert(term.form).second) return;
    if (term.kind == TermKind::kAnonymous) {
      reporter_.Add(need.code, term.form, "? has no value, which " + need.what + " needs",
                    "write a value, or a variable that is bound before");
    } else if (IsOpenParameter(term)) {
      MissingParameter(term, need);
    } else if (bindings.may[term.index]) {
      reporter_.Add(
          need.code, term.form,
          "not all that is before this binds " + Spelling(term) + ", which " + need.what + " needs",
          "bind it in each of the ways that lead here");
    } else {
      reporter_.Add(
          need.code, term.form,
          "nothing before this binds " + Spelling(term) + ", which " + need.what + " needs",
          "bind it first, or make it a parameter");
    }
  }

  /// The first place is enough: the call is what is to be mended.
  void MissingParameter(const Term& term, const Need& need) {
    const Skill& skill = program_.skills[current_->skill];
    if (!parameters_.emplace(current_->skill, term.index).second) return;
    reporter_.Add(need.code, term.form,
                  "'" + skill.spelling + "' may be called with " + Spelling(term) +
                      " unbound, which " + need.what + " needs",
                  "bind it before the call, or here");
    const FormId call = calls_.at(*current_);
    if (call != kNoForm) reporter_.Note(call, "called here");
  }

  std::string Spelling(const Term& variable) const {
    return std::string(program_.source.Text(variable.form));
  }

  const Program& program_;
  BindingModes modes_;
  BindingTrace trace_;
  Reporter& reporter_;
  std::vector<bool> reached_;
  std::map<Mode, FormId> calls_;  ///< The modes that were met, and the first call of each.
  std::deque<const Mode*> waiting_;
  const Mode* current_ = nullptr;
  std::set<FormId> reported_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> parameters_;  ///< Those that were reported.
};

/// The variables that stand where a value is needed.
std::vector<bool> Needed(const Program& program, const Skill& skill) {
  std::vector<bool> needed(skill.variables.size(), false);
  const auto mark = [&](const Term& term) {
    WalkTerm(term, [&](const Term& part) {
      if (part.kind == TermKind::kVariable) needed[part.index] = true;
    });
  };
  WalkClauses(skill, [&](const Clause& clause, Slot) {
    const bool needs_all = clause.kind == ClauseKind::kSkill &&
                           (program.skills[clause.skill].type == SkillType::kAction ||
                            program.skills[clause.skill].type == SkillType::kSequence);
    for (const Term& term : clause.terms) {
      if (needs_all || term.kind == TermKind::kCall) mark(term);
    }
  });
  return needed;
}

void LintSingles(const Program& program, const Skill& skill, Reporter& reporter) {
  if (!skill.is_whole) return;
  const std::vector<bool> needed = Needed(program, skill);
  for (std::size_t i = 0; i < skill.variables.size(); ++i) {
    if (skill.occurrences[i] > 1 || skill.variables[i].starts_with("?_")) continue;
    const std::string name(program.source.Text(skill.variable_forms[i]));
    const std::string meant = "write " + std::string(i < skill.parameters ? "" : "? or ") + "?_" +
                              name.substr(1) + " if that is meant";
    reporter.Add(Code::kVariableOnce, skill.variable_forms[i],
                 "the variable " + name + " stands only here",
                 needed[i] ? "bind it first, or make it a parameter" : meant);
  }
}

}  // namespace

void LintVariables(const Program& program, const CheckOptions& options, Reporter& reporter) {
  for (const Skill& skill : program.skills) LintSingles(program, skill, reporter);
  for (const Skill& never : program.nevers) LintSingles(program, never, reporter);
  BindingLint(program, options, reporter).Check();
}

}  // namespace latchwork::icarus
