// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/translations/reactive_plan.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "reasoners/icarus/language/reader.h"

namespace latchwork::icarus {

namespace {

using Variables = std::set<std::string, std::less<>>;

constexpr std::string_view kFileHint =
    "a file of plans holds (teleo-reactive Name (?x ...) ...) and (universal-plan Name (?x ...) "
    "...)";
constexpr std::string_view kTreeHint =
    "(teleo-reactive Name (?x ...) (goal condition ...) (when condition ... do {act} ...) ...)";
constexpr std::string_view kPlanHint =
    "(universal-plan Name (?x ...) (achieve condition ... (by {act} ...) ...))";
constexpr std::string_view kConditionHint =
    "conditions are {function ...}, (fact ...) and (not condition)";

class PlanReader {
 public:
  explicit PlanReader(ReactivePlanFile& file)
      : file_(file), tree_(file.source), reporter_(file.source, file.findings) {}

  void Read() {
    for (const FormId root : tree_.roots) AddPlan(root);
    for (auto& plan : file_.plans) FillPlan(plan);
    if (tree_.roots.empty() && file_.findings.empty()) {
      reporter_.AddAt(Code::kReactivePlan, 0, 1, 1, "the file has no plan", std::string(kFileHint));
    }
  }

 private:
  void Complain(FormId form, std::string message, std::string_view hint) {
    reporter_.Add(Code::kReactivePlan, form, std::move(message), std::string(hint));
  }

  std::vector<FormId> Parts(FormId form) const {
    return tree_.kind(form) == FormKind::kList ? tree_.Children(form) : std::vector<FormId>();
  }
  bool IsSymbol(FormId form) const { return tree_.kind(form) == FormKind::kSymbol; }
  std::string Head(FormId form) const {
    const FormId first = tree_.at(form).first_child;
    return first != kNoForm && IsSymbol(first) ? tree_.Folded(first) : std::string();
  }

  /// Name and parameters, so that plans may call plans that come later.
  void AddPlan(FormId root) {
    const std::vector<FormId> parts = Parts(root);
    const std::string head = Head(root);
    const bool universal = head == "universal-plan";
    if (tree_.kind(root) != FormKind::kList || (!universal && head != "teleo-reactive")) {
      const std::vector<std::string> heads{"universal-plan", "teleo-reactive"};
      const std::string_view nearest = logic::NearestName(head, heads);
      return Complain(
          root, "this is no plan",
          nearest.empty() ? std::string(kFileHint) : "did you mean " + std::string(nearest) + "?");
    }
    const std::string_view hint = universal ? kPlanHint : kTreeHint;
    if (parts.size() < 4 || !IsSymbol(parts[1]) || tree_.kind(parts[2]) != FormKind::kList) {
      return Complain(root, "a plan has a name, parameters, and what is to be done", hint);
    }
    ReactivePlan plan;
    plan.universal = universal;
    plan.form = root;
    plan.name = tree_.Text(parts[1]);
    for (const FormId parameter : tree_.Children(parts[2])) AddParameter(plan, parameter);
    for (std::size_t i = 3; i < parts.size(); ++i) TakeLabels(parts[i]);
    if (TakeName(plan.name, parts[1])) {
      arities_[Fold(plan.name)] = plan.parameters.size();
      universal_[Fold(plan.name)] = universal;
    }
    file_.plans.push_back(std::move(plan));
  }

  void AddParameter(ReactivePlan& plan, FormId form) {
    const std::string name = tree_.Folded(form);
    if (tree_.kind(form) != FormKind::kVariable || name == "?") {
      Complain(form, "a parameter is a variable", "write ?name");
    } else if (std::count(plan.parameters.begin(), plan.parameters.end(), name) != 0) {
      Complain(form, "the parameter " + name + " stands twice", "");
    } else {
      plan.parameters.push_back(name);
    }
  }

  bool TakeName(const std::string& name, FormId form) {
    const auto [taken, is_new] = names_.emplace(Fold(name), form);
    if (is_new) return true;
    Complain(form, "the name " + name + " is taken", "names do not depend on case");
    reporter_.Note(taken->second, "taken here");
    return false;
  }

  void FillPlan(ReactivePlan& plan) {
    const std::vector<FormId> parts = Parts(plan.form);
    const Variables bound(plan.parameters.begin(), plan.parameters.end());
    if (plan.universal) {
      if (parts.size() != 4 || Head(parts[3]) != "achieve") {
        return Complain(plan.form, "a universal plan has one goal", kPlanHint);
      }
      plan.root = Achieve(parts[3], bound);
      return;
    }
    plan.root.form = plan.form;
    for (std::size_t i = 3; i < parts.size(); ++i) {
      if (Head(parts[i]) == "goal" && i == 3) {
        const std::vector<FormId> items = Parts(parts[i]);
        std::size_t at = SetLabel(plan.root, items);
        Variables local = bound;
        for (; at < items.size(); ++at) AddCondition(plan.root, items[at], local);
        if (plan.root.conditions.empty()) Complain(parts[i], "the goal is empty", kConditionHint);
      } else if (Head(parts[i]) == "when") {
        plan.root.children.push_back(When(parts[i], bound));
      } else {
        Complain(parts[i], "this is no part of a teleo-reactive tree", kTreeHint);
      }
    }
    if (plan.root.children.empty()) Complain(plan.form, "the tree never acts", kTreeHint);
  }

  /// The label of a node is a bare symbol after its keyword.
  bool HasLabel(const std::vector<FormId>& items) const {
    return items.size() > 1 && IsSymbol(items[1]) && tree_.Folded(items[1]) != "do";
  }

  void TakeLabels(FormId form) {
    constexpr std::array<std::string_view, 4> kLabelled = {"when", "by", "achieve", "goal"};
    const std::vector<FormId> items = Parts(form);
    if (items.empty()) return;
    const bool may =
        std::find(std::begin(kLabelled), std::end(kLabelled), Head(form)) != std::end(kLabelled);
    if (may && HasLabel(items)) TakeName(std::string(tree_.Text(items[1])), items[1]);
    for (const FormId item : items) TakeLabels(item);
  }

  /// Where the rest of the node begins.
  std::size_t SetLabel(PlanNode& node, const std::vector<FormId>& items) {
    if (!HasLabel(items)) return 1;
    node.label = tree_.Text(items[1]);
    return 2;
  }

  PlanNode When(FormId form, const Variables& bound) {
    PlanNode node;
    node.kind = PlanNodeKind::kWhen;
    node.form = form;
    const std::vector<FormId> items = Parts(form);
    std::size_t at = SetLabel(node, items);
    Variables local = bound;
    const auto is_do = [&](FormId f) { return IsSymbol(f) && tree_.Folded(f) == "do"; };
    for (; at < items.size() && !is_do(items[at]); ++at) AddCondition(node, items[at], local);
    if (at == items.size()) {
      Complain(form, "what is to be done is missing", "write (when condition ... do {act} ...)");
      return node;
    }
    for (++at; at < items.size(); ++at) {
      if (Head(items[at]) == "when" && tree_.kind(items[at]) == FormKind::kList) {
        node.children.push_back(When(items[at], bound));
      } else {
        AddAct(node, items[at], local);
      }
    }
    if (node.conditions.empty() && node.acts.empty()) {
      Complain(form, "this has neither conditions nor acts", kTreeHint);
    }
    return node;
  }

  PlanNode Achieve(FormId form, const Variables& bound) {
    PlanNode node;
    node.kind = PlanNodeKind::kAchieve;
    node.form = form;
    const std::vector<FormId> items = Parts(form);
    Variables local = bound;
    bool named = false;
    for (std::size_t at = SetLabel(node, items); at < items.size(); ++at) {
      if (Head(items[at]) == "by" && tree_.kind(items[at]) == FormKind::kList) {
        node.children.push_back(By(items[at], bound));
      } else {
        AddCondition(node, items[at], local);
        named = true;
      }
    }
    if (!named) Complain(form, "what is to be achieved is missing", kPlanHint);
    return node;
  }

  PlanNode By(FormId form, Variables bound) {
    PlanNode node;
    node.kind = PlanNodeKind::kBy;
    node.form = form;
    const std::vector<FormId> items = Parts(form);
    std::vector<FormId> acts;
    for (std::size_t at = SetLabel(node, items); at < items.size(); ++at) {
      const FormId item = items[at];
      const std::string head = Head(item);
      if (tree_.kind(item) == FormKind::kCall) {
        acts.push_back(item);
      } else if (head == "if" && node.children.empty()) {
        const std::vector<FormId> conditions = Parts(item);
        for (std::size_t i = 1; i < conditions.size(); ++i) {
          AddCondition(node, conditions[i], bound);
        }
      } else if (head == "achieve") {
        node.children.push_back(Achieve(item, bound));
      } else if (IsPlan(head)) {
        node.children.push_back(Call(item, bound));
      } else {
        Complain(item, "this is no part of a way to achieve a goal",
                 "(by {act} ... (if condition ...) (achieve ...) (Plan ...) ...)");
      }
    }
    for (const FormId act : acts) AddAct(node, act, bound);
    if (acts.empty()) Complain(form, "the way has no act", "write (by {act} ...)");
    return node;
  }

  bool IsPlan(const std::string& head) const { return arities_.count(head) != 0; }

  PlanNode Call(FormId form, const Variables& bound) {
    PlanNode node;
    node.kind = PlanNodeKind::kCall;
    node.form = form;
    if (!universal_.at(Head(form))) {
      Complain(form, "a teleo-reactive tree is no goal that comes true", "name a universal plan");
    }
    CheckCall(form, bound);
    node.acts.push_back(form);
    return node;
  }

  void AddAct(PlanNode& node, FormId form, const Variables& bound) {
    const bool call = tree_.kind(form) == FormKind::kCall;
    if (call && !Head(form).empty()) {
      CheckBound(form, bound);
    } else if (node.kind == PlanNodeKind::kWhen && IsPlan(Head(form))) {
      CheckCall(form, bound);
    } else {
      return Complain(form, "this is no act", "acts are {function ...}, or the call of one plan");
    }
    node.acts.push_back(form);
    const bool calls_plan = tree_.kind(node.acts.front()) == FormKind::kList || !call;
    if (calls_plan && node.acts.size() > 1) {
      Complain(form, "the call of a plan stands alone", "");
    }
  }

  void CheckCall(FormId form, const Variables& bound) {
    const std::size_t given = Parts(form).size() - 1;
    const std::size_t wanted = arities_.at(Head(form));
    if (given != wanted) {
      Complain(
          form,
          "the plan takes " + std::to_string(wanted) + " arguments, not " + std::to_string(given),
          "");
    }
    CheckBound(form, bound);
  }

  void AddCondition(PlanNode& node, FormId form, Variables& bound) {
    if (CheckCondition(form, bound, true)) node.conditions.push_back(form);
  }

  bool CheckCondition(FormId form, Variables& bound, bool binds) {
    const FormKind kind = tree_.kind(form);
    const std::string head = Head(form);
    if (kind == FormKind::kCall && !head.empty()) {
      CheckBound(form, bound);
      return true;
    }
    const std::vector<FormId> parts = Parts(form);
    if (head == "not" && parts.size() == 2) return CheckCondition(parts[1], bound, false);
    if (parts.empty() || names_.count(head) != 0 || IsKeyword(head)) {
      Complain(form,
               names_.count(head) != 0 ? "a condition cannot call a plan" : "this is no condition",
               kConditionHint);
      return false;
    }
    if (binds) CollectVariables(form, bound);
    return true;
  }

  static bool IsKeyword(std::string_view head) {
    constexpr std::array<std::string_view, 8> kKeywords = {"when", "by", "achieve", "goal",
                                                           "if",   "do", "not",     "bind"};
    return std::find(std::begin(kKeywords), std::end(kKeywords), head) != std::end(kKeywords);
  }

  void CollectVariables(FormId form, Variables& variables) const {
    if (tree_.kind(form) == FormKind::kVariable) variables.insert(tree_.Folded(form));
    for (const FormId child : tree_.Children(form)) CollectVariables(child, variables);
  }

  void CheckBound(FormId form, const Variables& bound) {
    if (tree_.kind(form) == FormKind::kVariable && bound.count(tree_.Folded(form)) == 0) {
      Complain(form, "nothing before this gives " + std::string(tree_.Text(form)) + " a value",
               "name it among the parameters, or match a fact that has it before");
    }
    for (const FormId child : tree_.Children(form)) CheckBound(child, bound);
  }

  ReactivePlanFile& file_;
  const SourceTree& tree_;
  Reporter reporter_;
  std::map<std::string, FormId, std::less<>> names_;
  std::map<std::string, std::size_t, std::less<>> arities_;
  std::map<std::string, bool, std::less<>> universal_;
};

}  // namespace

ReactivePlanFile ReadReactivePlans(std::string text, std::string file) {
  ReactivePlanFile plans;
  plans.source = ReadForms(std::move(text), std::move(file), plans.findings);
  PlanReader(plans).Read();
  Settle(plans.source, plans.findings);
  return plans;
}

}  // namespace latchwork::icarus
