// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/translations/translate.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoners/icarus/language/reader.h"
#include "reasoners/icarus/tools/formatter.h"

namespace latchwork::icarus {

namespace {

using Names = std::set<std::string, std::less<>>;

class ProgramWriter {
 public:
  explicit ProgramWriter(const ReactivePlanFile& file) : file_(file), tree_(file.source) {
    for (FormId id = 0; id < tree_.forms.size(); ++id) {
      if (tree_.kind(id) == FormKind::kSymbol) taken_.insert(tree_.Folded(id));
    }
  }

  std::string Write() {
    for (const ReactivePlan& plan : file_.plans) {
      plan_ = &plan;
      count_ = 0;
      text_ += "; " + plan.name + ", a " +
               (plan.universal ? "universal plan\n" : "teleo-reactive tree\n");
      plan.universal ? WriteUniversal(plan) : WriteTree(plan);
      text_ += '\n';
    }
    return text_ + actions_;
  }

 private:
  /// A name that nothing in the file has.
  std::string FreeName(const std::string& wanted) {
    std::string name = wanted;
    for (int i = 2; !taken_.insert(Fold(name)).second; ++i) name = wanted + '-' + std::to_string(i);
    return name;
  }

  std::string NameOf(const PlanNode& node) {
    if (!node.label.empty()) return node.label;
    return FreeName(plan_->name + '-' + std::to_string(++count_));
  }

  void Collect(FormId form, Names& variables) const {
    if (tree_.kind(form) == FormKind::kVariable) variables.insert(tree_.Folded(form));
    for (const FormId child : tree_.Children(form)) Collect(child, variables);
  }

  void Collect(const PlanNode& node, Names& variables) const {
    for (const FormId condition : node.conditions) Collect(condition, variables);
    for (const FormId act : node.acts) Collect(act, variables);
    for (const PlanNode& child : node.children) Collect(child, variables);
  }

  /// Those of `scope` that are used, in its order, each after a blank.
  static std::string Arguments(const std::vector<std::string>& scope, const Names& used) {
    std::string text;
    for (const std::string& variable : scope) {
      if (used.count(variable) != 0) text += ' ' + variable;
    }
    return text;
  }

  std::string ArgumentsOf(const PlanNode& node, const std::vector<std::string>& scope,
                          bool with_children) const {
    Names used;
    if (with_children) {
      Collect(node, used);
    } else {
      for (const FormId condition : node.conditions) Collect(condition, used);
      for (const FormId act : node.acts) Collect(act, used);
    }
    return Arguments(scope, used);
  }

  std::string ClauseText(FormId form) const {
    const std::vector<FormId> parts = tree_.Children(form);
    const bool negation =
        tree_.kind(form) == FormKind::kList && !parts.empty() && tree_.Folded(parts[0]) == "not";
    return negation ? "(*not* " + ClauseText(parts[1]) + ")" : std::string(tree_.Text(form));
  }

  std::string Conditions(const PlanNode& node) const {
    std::string text;
    for (const FormId form : node.conditions) text += ' ' + ClauseText(form);
    return text;
  }

  static std::string Slot(std::string_view keyword, const std::string& clauses) {
    return clauses.empty() ? "" : std::string(keyword) + " (" + clauses + ")\n";
  }

  void AddSkill(const std::string& name, const std::string& parameters, const std::string& slots) {
    text_ += '(' + name + " (" + parameters + ")\n" + slots + ")\n";
  }

  bool CallsPlan(const PlanNode& node) const {
    return !node.acts.empty() && tree_.kind(node.acts.front()) == FormKind::kList;
  }

  /// The call of an :action skill that does the acts; made where there is none yet.
  std::string ActClause(const PlanNode& node) {
    std::string calls;
    Names used;
    for (const FormId act : node.acts) {
      calls += ' ' + std::string(tree_.Text(act));
      Collect(act, used);
    }
    const std::vector<std::string> variables(used.begin(), used.end());
    const std::string parameters = Arguments(variables, used);
    const auto [known, is_new] = action_names_.emplace(calls, std::string());
    if (is_new) {
      const FormId function = tree_.at(node.acts.front()).first_child;
      known->second = FreeName("Do-" + std::string(tree_.Text(function)));
      actions_ += '(' + known->second + " (" + parameters + ") :action (" + calls + "))\n";
    }
    return " (" + known->second + parameters + ")";
  }

  /// The first rule that applies stops those after it: it acts, or it is True and its negation
  /// False. Shallow rules come first.
  void WriteTree(const ReactivePlan& plan) {
    const std::string skills_before = std::exchange(text_, "");
    std::string rules;
    if (!plan.root.conditions.empty()) rules += WriteGoal(plan);
    std::deque<const PlanNode*> waiting;
    for (const PlanNode& child : plan.root.children) waiting.push_back(&child);
    while (!waiting.empty()) {
      const PlanNode& node = *waiting.front();
      waiting.pop_front();
      for (const PlanNode& child : node.children) waiting.push_back(&child);
      rules += WriteRule(plan, node);
    }
    const std::string skills = std::exchange(text_, skills_before);
    std::string parameters;
    for (const std::string& parameter : plan.parameters) parameters += ' ' + parameter;
    AddSkill(plan.name, parameters, Slot(":requires", rules));
    text_ += skills;
  }

  static std::string Negated(const std::string& name, const std::string& arguments) {
    return " (*not* (" + name + arguments + "))";
  }

  std::string WriteGoal(const ReactivePlan& plan) {
    const std::string name =
        plan.root.label.empty() ? FreeName(plan.name + "-Goal") : plan.root.label;
    const std::string arguments = ArgumentsOf(plan.root, plan.parameters, false);
    AddSkill(name, arguments, Slot(":objective", Conditions(plan.root)));
    return Negated(name, arguments);
  }

  bool IsUniversal(FormId call) const {
    const std::string name = tree_.Folded(tree_.at(call).first_child);
    return std::any_of(file_.plans.begin(), file_.plans.end(), [&](const ReactivePlan& plan) {
      return plan.universal && Fold(plan.name) == name;
    });
  }

  /// What calls another plan is True when that plan has no act, so that no later rule is asked.
  std::string WriteRule(const ReactivePlan& plan, const PlanNode& node) {
    const std::string name = NameOf(node);
    const std::string arguments = ArgumentsOf(node, plan.parameters, false);
    const std::string conditions = Conditions(node);
    if (node.acts.empty()) {
      AddSkill(name, arguments, Slot(":objective", conditions));
    } else if (CallsPlan(node)) {
      const std::string call(tree_.Text(node.acts.front()));
      const std::string objective = Slot(":objective", conditions + " (*not* " + call + ")");
      const std::string means = Slot(":requires", conditions) + Slot(":means", call);
      AddSkill(name, arguments, objective + (IsUniversal(node.acts.front()) ? means : ""));
    } else {
      AddSkill(name, arguments, Slot(":requires", conditions) + Slot(":means", ActClause(node)));
    }
    return Negated(name, arguments);
  }

  void WriteUniversal(const ReactivePlan& plan) {
    std::string parameters;
    for (const std::string& parameter : plan.parameters) parameters += ' ' + parameter;
    WriteAchieve(plan.root, plan.name, parameters, plan.parameters);
  }

  void WriteAchieve(const PlanNode& node, const std::string& name, const std::string& parameters,
                    const std::vector<std::string>& scope) {
    const std::string before = std::exchange(text_, "");
    std::string slots = Slot(":objective", Conditions(node));
    if (node.children.size() == 1) slots += WriteWay(node.children.front(), scope);
    std::string means;
    for (std::size_t i = 0; node.children.size() > 1 && i < node.children.size(); ++i) {
      const PlanNode& way = node.children[i];
      const std::string way_name =
          way.label.empty() ? FreeName(name + "-By-" + std::to_string(i + 1)) : way.label;
      const std::string arguments = ArgumentsOf(way, scope, true);
      const std::string others = std::exchange(text_, "");
      const std::string way_slots = WriteWay(way, scope);
      const std::string below = std::exchange(text_, others);
      AddSkill(way_name, arguments, way_slots);
      text_ += below;
      means.append(" (").append(way_name).append(arguments).append(")");
    }
    const std::string below = std::exchange(text_, before);
    AddSkill(name, parameters, slots + Slot(":means", means));
    text_ += below;
  }

  /// The slots of one way; the skills that it needs are added.
  std::string WriteWay(const PlanNode& way, std::vector<std::string> scope) {
    std::string required = Conditions(way);
    Names bound;
    for (const FormId condition : way.conditions) Collect(condition, bound);
    for (const std::string& variable : bound) {
      const bool known = std::find(scope.begin(), scope.end(), variable) != scope.end();
      if (!known && variable != "?") scope.push_back(variable);
    }
    for (const PlanNode& child : way.children) {
      if (child.kind == PlanNodeKind::kCall) {
        required += ' ' + std::string(tree_.Text(child.form));
        continue;
      }
      const std::string name = NameOf(child);
      const std::string arguments = ArgumentsOf(child, scope, true);
      required.append(" (").append(name).append(arguments).append(")");
      WriteAchieve(child, name, arguments, scope);
    }
    return Slot(":requires", required) + Slot(":means", ActClause(way));
  }

  const ReactivePlanFile& file_;
  const SourceTree& tree_;
  const ReactivePlan* plan_ = nullptr;
  Names taken_;
  std::map<std::string, std::string> action_names_;
  int count_ = 0;
  std::string text_;
  std::string actions_;
};

}  // namespace

std::string TranslateToIcarus(const ReactivePlanFile& file) {
  Findings findings;
  return FormatProgram(ReadForms(ProgramWriter(file).Write(), "translation", findings));
}

}  // namespace latchwork::icarus
