// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reasoners/icarus/language/signature.h"
#include "reasoners/icarus/language/walk.h"
#include "reasoners/icarus/lint/first_asked.h"
#include "reasoners/icarus/lint/lint.h"

namespace latchwork::icarus {

namespace {

/// Whether clauses change memory, and with it what the same call comes to.
bool ChangesMemory(const Program& program) {
  bool changes = false;
  for (const Skill& skill : program.skills) {
    if (skill.type == SkillType::kAction) continue;
    WalkTerms(skill, [&](const Term& term, Slot) {
      if (term.kind != TermKind::kCall) return;
      const Signature* const builtin = FindBuiltin(term.text);
      changes = changes || (builtin != nullptr && builtin->changes_memory);
    });
  }
  return changes;
}

/// Whether a clause may bind a parameter.
bool MayBind(const Skill& skill, const Clause& clause) {
  bool may = false;
  for (const Term& term : clause.terms) {
    WalkTerm(term, [&](const Term& part) {
      may = may || (part.kind == TermKind::kVariable && part.index < skill.parameters);
    });
  }
  return may && clause.kind != ClauseKind::kCall;
}

/// Whether the arguments are the parameters, and all that the other skill takes.
bool PassesItsArguments(const Program& program, const Skill& skill, const Clause& call) {
  bool same = call.terms.size() == skill.parameters &&
              program.skills[call.skill].parameters == skill.parameters;
  for (std::size_t i = 0; same && i < call.terms.size(); ++i) {
    same = call.terms[i].kind == TermKind::kVariable && call.terms[i].index == i;
  }
  return same;
}

/// No more is noted of one call, and no more calls of one skill are followed.
constexpr std::size_t kMostConditions = 32;
constexpr std::size_t kMostSteps = 64;

/// Something that is asked about the parameters alone, and what it came to.
struct Condition {
  std::string key;
  bool holds = true;
};

void AppendKey(const Skill& skill, const Term& term, std::string& key, bool& known) {
  key += static_cast<char>('a' + static_cast<int>(term.kind));
  key += term.text + ':' + std::to_string(term.index) + ':' + std::to_string(term.integer) + ':' +
         std::to_string(term.real);
  known = known && (term.kind != TermKind::kVariable || term.index < skill.parameters);
  key += '(';
  for (const Term& item : term.items) AppendKey(skill, item, key, known);
  key += ')';
}

/// Of clauses with variables of the skill's own nothing is noted. A negation that holds says that
/// what it negates does not, not the other way round: that may act.
void Note(const Skill& skill, const Clause& clause, bool holds,
          std::vector<Condition>& conditions) {
  if (conditions.size() >= kMostConditions) return;
  if (!clause.inner.empty()) {
    if (holds) Note(skill, clause.inner.front(), false, conditions);
    return;
  }
  Condition condition{
      std::to_string(static_cast<int>(clause.kind)) + '/' + std::to_string(clause.skill), holds};
  bool known = true;
  for (const Term& term : clause.terms) AppendKey(skill, term, condition.key, known);
  if (known) conditions.push_back(std::move(condition));
}

/// A call that a skill makes with its own arguments, and what was found before it.
struct Step {
  const Clause* call = nullptr;
  std::vector<Condition> before;
};

/// The calls among clauses that are asked one after the other.
void AddSteps(const Program& program, const Skill& skill, std::span<const Clause> clauses,
              std::vector<Condition> before, std::vector<Step>& steps) {
  for (const Clause& clause : clauses) {
    const Clause* call = &clause;
    while (!call->inner.empty()) call = &call->inner.front();
    if (steps.size() >= kMostSteps) return;
    if (call->kind == ClauseKind::kSkill && PassesItsArguments(program, skill, *call)) {
      steps.push_back({call, before});
    }
    if (MayBind(skill, clause)) return;
    Note(skill, clause, true, before);
  }
}

void AddMeans(const Program& program, const Skill& skill, const std::vector<Condition>& before,
              std::vector<Step>& steps) {
  const std::vector<Clause>* const required = skill.slot(Slot::kRequires);
  std::vector<Condition> found = before;
  if (required != nullptr) {
    for (const Clause& clause : *required) {
      if (MayBind(skill, clause)) return;
      Note(skill, clause, true, found);
    }
  }
  for (const Clause& clause : *skill.slot(Slot::kMeans)) {
    AddSteps(program, skill, std::span<const Clause>(&clause, 1), found, steps);
  }
}

std::vector<Step> StepsOf(const Program& program, const Skill& skill) {
  std::vector<Step> steps;
  if (!skill.is_whole) return steps;
  for (const Slot slot : {Slot::kObjective, Slot::kSequence}) {
    if (skill.slot(slot) != nullptr) AddSteps(program, skill, *skill.slot(slot), {}, steps);
  }
  std::vector<Condition> before;
  const std::vector<Clause>* const objective = skill.slot(Slot::kObjective);
  if (objective != nullptr && objective->size() == 1) {
    Note(skill, objective->front(), false, before);
  }
  if (objective != nullptr && objective->empty()) return steps;
  if (skill.slot(Slot::kRequires) != nullptr) {
    AddSteps(program, skill, *skill.slot(Slot::kRequires), before, steps);
  }
  if (skill.slot(Slot::kMeans) != nullptr) AddMeans(program, skill, before, steps);
  return steps;
}

/// Looks for ways from a skill back to it, with the same arguments all along.
class Recursion {
 public:
  explicit Recursion(const Program& program) : program_(program) {
    for (const Skill& skill : program.skills) steps_.push_back(StepsOf(program, skill));
    visited_.resize(program.skills.size());
  }

  void Report(std::uint32_t skill, Reporter& reporter) {
    for (const Step& step : steps_[skill]) {
      std::fill(visited_.begin(), visited_.end(), false);
      root_ = skill;
      path_.clear();
      conditions_.clear();
      tries_ = 0;
      if (!Follow(skill, step)) continue;
      if (IsFirstAsked()) continue;  // Said of the skill itself.
      Add(*step.call, reporter);
    }
  }

 private:
  static constexpr std::size_t kMostTries = 256;

  /// Whether the step leads back; each way is told of at the first of its skills.
  bool Follow(std::uint32_t from, const Step& step) {
    if (++tries_ > kMostTries) return false;
    const std::size_t known = conditions_.size();
    if (!Assume(step.before)) return Withdraw(known);
    path_.push_back(from);
    const std::uint32_t to = step.call->skill;
    if (to == root_) return true;
    if (to > root_ && !visited_[to]) {
      visited_[to] = true;
      for (const Step& next : steps_[to]) {
        if (Follow(to, next)) return true;
      }
      visited_[to] = false;
    }
    path_.pop_back();
    return Withdraw(known);
  }

  bool Withdraw(std::size_t known) {
    conditions_.resize(known);
    return false;
  }

  /// Whether this agrees with what was found on the way so far.
  bool Assume(const std::vector<Condition>& more) {
    for (const Condition& each : more) {
      const bool contradicts =
          std::any_of(conditions_.begin(), conditions_.end(), [&](const Condition& known) {
            return known.key == each.key && known.holds != each.holds;
          });
      if (contradicts) return false;
      conditions_.push_back(each);
    }
    return true;
  }

  bool IsFirstAsked() const {
    for (std::size_t i = 0; i < path_.size(); ++i) {
      const std::uint32_t next = i + 1 < path_.size() ? path_[i + 1] : root_;
      if (FirstCalled(program_.skills[path_[i]]) != next) return false;
    }
    return true;
  }

  void Add(const Clause& call, Reporter& reporter) const {
    std::string through;
    for (std::size_t i = 1; i < path_.size(); ++i) {
      through += (i == 1 ? ", through '" : ", '") + program_.skills[path_[i]].spelling + "'";
    }
    reporter.Add(Code::kEndless, call.form,
                 "the skill '" + program_.skills[root_].spelling +
                     "' calls itself with its own arguments" + through,
                 "pass it something that comes nearer to the end of the recursion");
  }

  const Program& program_;
  std::vector<std::vector<Step>> steps_;  ///< By skill.
  std::vector<bool> visited_;
  std::vector<std::uint32_t> path_;
  std::vector<Condition> conditions_;
  std::uint32_t root_ = 0;
  std::size_t tries_ = 0;
};

}  // namespace

/// What a call came to once it comes to again within the cycle.
void LintRecursion(const Program& program, Reporter& reporter) {
  if (ChangesMemory(program)) return;
  Recursion recursion(program);
  for (std::uint32_t i = 0; i < program.skills.size(); ++i) recursion.Report(i, reporter);
}

}  // namespace latchwork::icarus
