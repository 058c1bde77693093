// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/clause_builder.h"

#include <utility>

namespace latchwork::icarus {

namespace {

std::vector<std::string> KeysOf(const std::map<std::string, std::uint32_t, std::less<>>& names) {
  std::vector<std::string> keys;
  keys.reserve(names.size());
  for (const auto& [name, index] : names) keys.push_back(name);
  return keys;
}

std::string DidYouMean(std::string_view nearest) {
  return nearest.empty() ? std::string() : "did you mean '" + std::string(nearest) + "'?";
}

}  // namespace

void ClauseBuilder::Begin(Skill* skill, Code ground_code) {
  skill_ = skill;
  ground_code_ = ground_code;
  variables_.clear();
  if (skill == nullptr) return;
  for (const std::string& name : skill->variables) variables_.emplace(name, variables_.size());
}

std::uint32_t ClauseBuilder::Enter(FormId variable) {
  const auto index = static_cast<std::uint32_t>(variables_.size());
  const auto [entry, is_new] = variables_.emplace(tree_.Folded(variable), index);
  if (is_new) {
    skill_->variables.push_back(entry->first);
    skill_->variable_forms.push_back(variable);
    skill_->occurrences.push_back(0);
  }
  ++skill_->occurrences[entry->second];
  return entry->second;
}

std::optional<Term> ClauseBuilder::MakeTerm(FormId form, bool calls_allowed) {
  Term term;
  term.form = form;
  const Form& at = tree_.at(form);
  switch (at.kind) {
    case FormKind::kList:
      return List(std::move(term), calls_allowed);
    case FormKind::kCall:
      if (calls_allowed && skill_ != nullptr) return Call(std::move(term));
      reporter_.Add(skill_ == nullptr ? ground_code_ : Code::kClause, form,
                    "a call cannot stand here",
                    skill_ == nullptr ? "" : "bind a variable to it before: (bind ?v {...})");
      return std::nullopt;
    case FormKind::kVariable:
      return Variable(std::move(term));
    case FormKind::kConstant:
      return Constant(std::move(term));
    case FormKind::kKeyword:
      reporter_.Add(Code::kClause, form, "a keyword cannot stand in a clause",
                    "slots stand in the skill itself, after its parameters");
      return std::nullopt;
    case FormKind::kInteger:
      term.kind = TermKind::kInteger;
      term.integer = at.integer;
      return term;
    case FormKind::kReal:
      term.kind = TermKind::kReal;
      term.real = at.real;
      return term;
    case FormKind::kString:
      term.kind = TermKind::kString;
      term.text = tree_.Unquoted(form);
      return term;
    case FormKind::kSymbol:
      term.text = tree_.Folded(form);
      return term;
  }
  return std::nullopt;
}

std::optional<Term> ClauseBuilder::Variable(Term term) {
  if (skill_ == nullptr) {
    reporter_.Add(ground_code_, term.form, "a variable cannot stand here", "give a value");
    return std::nullopt;
  }
  if (tree_.Text(term.form) == "?") {
    term.kind = TermKind::kAnonymous;
    return term;
  }
  term.kind = TermKind::kVariable;
  term.index = Enter(term.form);
  return term;
}

std::optional<Term> ClauseBuilder::Constant(Term term) {
  const std::string name = tree_.Folded(term.form);
  term.kind = TermKind::kConstant;
  if (name == "*not*" || name == "*nota*") {
    reporter_.Add(Code::kClause, term.form, "a negation cannot stand here",
                  "write (" + std::string(tree_.Text(term.form)) + " clause)");
    return std::nullopt;
  }
  const auto found = names_.constants.find(name);
  if (found == names_.constants.end()) {
    const std::vector<std::string> keys = KeysOf(names_.constants);
    const std::string hint = DidYouMean(logic::NearestName(name, keys));
    reporter_.Add(Code::kConstant, term.form,
                  "the constant " + std::string(tree_.Text(term.form)) + " is not defined",
                  hint.empty()
                      ? "define it: (constant " + std::string(tree_.Text(term.form)) + " value)"
                      : hint);
    return std::nullopt;
  }
  if (skill_ == nullptr && found->second == kCycleConstant) {
    reporter_.Add(ground_code_, term.form, "*cycle* has a value while the program runs only");
    return std::nullopt;
  }
  term.index = found->second;
  return term;
}

std::optional<Term> ClauseBuilder::List(Term term, bool calls_allowed) {
  term.kind = TermKind::kList;
  for (const FormId child : tree_.Children(term.form)) {
    std::optional<Term> item = MakeTerm(child, calls_allowed);
    if (item) term.items.push_back(*std::move(item));
  }
  return term;
}

std::optional<Term> ClauseBuilder::Call(Term term) {
  term.kind = TermKind::kCall;
  const FormId head = tree_.at(term.form).first_child;
  if (head == kNoForm || tree_.kind(head) != FormKind::kSymbol) {
    reporter_.Add(Code::kClause, head == kNoForm ? term.form : head,
                  "a call begins with the name of a function", "write {function argument ...}");
    return std::nullopt;
  }
  term.text = tree_.Folded(head);
  for (FormId c = tree_.at(head).next_sibling; c != kNoForm; c = tree_.at(c).next_sibling) {
    std::optional<Term> item = MakeTerm(c, true);
    if (item) term.items.push_back(*std::move(item));
  }
  return term;
}

std::string ClauseBuilder::AtomName(FormId form) const {
  const FormKind kind = tree_.kind(form);
  return kind == FormKind::kSymbol || kind == FormKind::kConstant ? tree_.Folded(form) : "";
}

bool ClauseBuilder::IsAllowed(FormId form, Slot slot) {
  if (tree_.kind(form) == FormKind::kCall) return true;
  if (slot == Slot::kAction) {
    reporter_.Add(Code::kClause, form, "an :action holds calls of host functions only",
                  "write {function argument ...}");
    return false;
  }
  const FormId head = tree_.at(form).first_child;
  if (slot != Slot::kSensor || (head != kNoForm && AtomName(head) == "bind")) return true;
  reporter_.Add(Code::kClause, form, "a :sensor holds calls of host functions and bind only",
                "write {function argument ...} or (bind ?v {function argument ...})");
  return false;
}

std::optional<Clause> ClauseBuilder::MakeClause(FormId form, Slot slot) {
  const FormKind kind = tree_.kind(form);
  if (kind == FormKind::kKeyword) {
    reporter_.Add(Code::kClause, form, "a slot stands within the list of another",
                  "close that list with a ')' before " + std::string(tree_.Text(form)));
    return std::nullopt;
  }
  if (kind != FormKind::kList && kind != FormKind::kCall) {
    reporter_.Add(Code::kClause, form, "a clause stands in ( ) or { }",
                  "write (" + std::string(tree_.Text(form)) + ")");
    return std::nullopt;
  }
  if (!IsAllowed(form, slot)) return std::nullopt;
  if (kind == FormKind::kList) return InParentheses(form, slot);
  std::optional<Term> call = MakeTerm(form, true);
  if (!call) return std::nullopt;
  Clause clause;
  clause.kind = ClauseKind::kCall;
  clause.form = form;
  clause.terms.push_back(*std::move(call));
  return clause;
}

std::optional<Clause> ClauseBuilder::InParentheses(FormId form, Slot slot) {
  const std::vector<FormId> children = tree_.Children(form);
  Clause clause;
  clause.form = form;
  if (children.empty()) {
    reporter_.Add(Code::kClause, form, "the clause is empty",
                  "take it out; a slot that is empty is written ()");
    return std::nullopt;
  }
  const FormKind head_kind = tree_.kind(children[0]);
  const std::string head = AtomName(children[0]);
  if (head_kind == FormKind::kSymbol && head == "bind") return Bind(std::move(clause), children);
  if (head == "*not*" || head == "*nota*") {
    clause.kind = head == "*not*" ? ClauseKind::kNot : ClauseKind::kNotOrActing;
    return Negation(std::move(clause), children, slot);
  }
  const auto skill = names_.skills.find(head);
  if (head_kind == FormKind::kSymbol && skill != names_.skills.end()) {
    clause.kind = ClauseKind::kSkill;
    clause.skill = skill->second;
    return Arguments(std::move(clause), children, 1);
  }
  clause.kind = ClauseKind::kMatch;
  return Arguments(std::move(clause), children, 0);
}

std::optional<Clause> ClauseBuilder::Arguments(Clause clause, const std::vector<FormId>& children,
                                               std::size_t first) {
  for (std::size_t i = first; i < children.size(); ++i) {
    std::optional<Term> term = MakeTerm(children[i], false);
    if (!term) return std::nullopt;
    clause.terms.push_back(*std::move(term));
  }
  return clause;
}

std::optional<Clause> ClauseBuilder::Bind(Clause clause, const std::vector<FormId>& children) {
  clause.kind = ClauseKind::kBind;
  const FormKind target = children.size() == 3 ? tree_.kind(children[1]) : FormKind::kKeyword;
  if (target != FormKind::kVariable && target != FormKind::kList) {
    reporter_.Add(Code::kClause, clause.form,
                  "bind takes a variable, or a list of them, and a term",
                  "write (bind ?v term), (bind ?v {function argument ...}) or (bind (?v ?w) ...)");
    return std::nullopt;
  }
  for (std::size_t i = 1; i < 3; ++i) {
    std::optional<Term> term = MakeTerm(children[i], i == 2);
    if (!term) return std::nullopt;
    clause.terms.push_back(*std::move(term));
  }
  return clause;
}

std::optional<Clause> ClauseBuilder::Negation(Clause clause, const std::vector<FormId>& children,
                                              Slot slot) {
  if (children.size() != 2) {
    const std::string head(tree_.Text(children[0]));
    reporter_.Add(Code::kClause, clause.form, head + " takes one clause",
                  "write (" + head + " clause)");
    return std::nullopt;
  }
  std::optional<Clause> inner = MakeClause(children[1], slot);
  if (!inner) return std::nullopt;
  clause.inner.push_back(*std::move(inner));
  return clause;
}

std::vector<Clause> ClauseBuilder::MakeClauses(FormId list, Slot slot) {
  std::vector<Clause> clauses;
  for (const FormId child : tree_.Children(list)) {
    std::optional<Clause> clause = MakeClause(child, slot);
    if (clause) clauses.push_back(*std::move(clause));
  }
  return clauses;
}

}  // namespace latchwork::icarus
