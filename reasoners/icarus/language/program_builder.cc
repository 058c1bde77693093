// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/program_builder.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reasoners/icarus/language/clause_builder.h"
#include "reasoners/icarus/language/top_check.h"

namespace latchwork::icarus {

namespace {

constexpr std::array<std::string_view, kSlots> kKeywords = {":objective", ":requires", ":means",
                                                            ":sequence",  ":action",   ":sensor"};
constexpr std::string_view kValueKeyword = ":value";

SkillType TypeOf(Slot slot) {
  switch (slot) {
    case Slot::kSequence:
      return SkillType::kSequence;
    case Slot::kAction:
      return SkillType::kAction;
    case Slot::kSensor:
      return SkillType::kSensor;
    default:
      return SkillType::kPlan;
  }
}

std::optional<Slot> SlotOf(std::string_view keyword) {
  const auto* const found = std::find(kKeywords.begin(), kKeywords.end(), keyword);
  if (found == kKeywords.end()) return std::nullopt;
  return static_cast<Slot>(found - kKeywords.begin());
}

class Builder {
 public:
  Builder(Program& program, Findings& findings)
      : program_(program),
        tree_(program.source),
        findings_(findings),
        reporter_(program.source, findings),
        clauses_(program.source, names_, reporter_) {}

  void Build() {
    program_.constants.push_back({"*cycle*", kNoForm, Term()});
    names_.constants.emplace("*cycle*", kCycleConstant);
    for (const FormId root : tree_.roots) Collect(root);
    for (Skill& skill : program_.skills) {
      skill.is_whole = IsClean([&] { Fill(skill); }) && skill.has_whole_head;
    }
    if (program_.top) program_.top->is_whole = IsClean([&] { FillTop(*program_.top); });
    for (Skill& never : program_.nevers) never.is_whole = IsClean([&] { FillNever(never); });
  }

 private:
  /// Whether a step of the building finds nothing wrong.
  template <typename Step>
  bool IsClean(const Step& step) {
    const std::size_t before = findings_.size();
    step();
    return findings_.size() == before && !reporter_.full();
  }

  /// Constants and facts at once; of skills the head, so that each may call every other.
  void Collect(FormId root) {
    const std::vector<FormId> children = tree_.Children(root);
    if (tree_.kind(root) != FormKind::kList || children.empty() ||
        tree_.kind(children[0]) != FormKind::kSymbol) {
      reporter_.Add(Code::kTopLevel, root, "this is no skill, no constant and no facts",
                    "write (Name (?parameter ...) :slot ...)");
      return;
    }
    const std::string head = tree_.Folded(children[0]);
    if (head == "constant") {
      AddConstant(root, children);
    } else if (head == "facts") {
      AddFacts(children);
    } else if (tree_.IsTop(root)) {
      AddTop(root, children[1]);
    } else if (tree_.IsNever(root)) {
      program_.nevers.push_back(Nameless(root, children[0]));
    } else if ((head == "top" || head == "never") && !HasParameters(children)) {
      reporter_.Add(
          head == "top" ? Code::kTop : Code::kTopLevel, root, "this is no (" + head + " ...)",
          head == "top" ? "write (top (Skill argument ...))" : "write (never clause ...)");
    } else {
      AddSkill(root, children);
    }
  }

  bool HasParameters(const std::vector<FormId>& children) const {
    return children.size() > 1 && tree_.kind(children[1]) == FormKind::kList;
  }

  void AddConstant(FormId root, const std::vector<FormId>& children) {
    if (children.size() != 3 || tree_.kind(children[1]) != FormKind::kConstant) {
      reporter_.Add(Code::kConstant, root, "a constant has a name in stars and a value",
                    "write (constant *NAME* value)");
      if (children.size() > 1 && tree_.kind(children[1]) == FormKind::kConstant) {
        AddLost(children[1]);
      }
      return;
    }
    clauses_.Begin(nullptr, Code::kConstant);
    std::optional<Term> value = clauses_.MakeTerm(children[2], false);
    const std::string name = tree_.Folded(children[1]);
    const auto index = static_cast<std::uint32_t>(program_.constants.size());
    const bool reserved = name == "*not*" || name == "*nota*";
    if (reserved || !names_.constants.emplace(name, index).second) {
      reporter_.Add(
          Code::kConstant, children[1],
          "the constant " + std::string(tree_.Text(children[1])) +
              (reserved || name == "*cycle*" ? " is part of the language" : " is already defined"),
          "give it another name");
      return;
    }
    program_.constants.push_back({name, children[1], value ? *std::move(value) : AnyValue()});
  }

  /// So that its uses are not wrong as well.
  void AddLost(FormId constant) {
    const auto index = static_cast<std::uint32_t>(program_.constants.size());
    const std::string name = tree_.Folded(constant);
    if (!names_.constants.emplace(name, index).second) return;
    program_.constants.push_back({name, constant, AnyValue()});
  }

  static Term AnyValue() {
    Term term;
    term.kind = TermKind::kAnonymous;
    return term;
  }

  void AddFacts(const std::vector<FormId>& children) {
    clauses_.Begin(nullptr, Code::kFact);
    for (std::size_t i = 1; i < children.size(); ++i) {
      if (tree_.kind(children[i]) != FormKind::kList ||
          tree_.at(children[i]).first_child == kNoForm) {
        reporter_.Add(Code::kFact, children[i], "a fact is a list that is not empty",
                      "write (facts (head value ...) ...)");
        continue;
      }
      std::optional<Term> fact = clauses_.MakeTerm(children[i], false);
      if (fact) program_.facts.push_back(*std::move(fact));
    }
  }

  void AddTop(FormId root, FormId call) {
    if (program_.top) {
      reporter_.Add(Code::kTop, root, "the program has a top already", "take one of them out");
      reporter_.Note(program_.top->form, "the other top");
      return;
    }
    program_.top = Nameless(root, call);
  }

  static Skill Nameless(FormId root, FormId name_form) {
    Skill skill;
    skill.form = root;
    skill.name_form = name_form;
    skill.slot_forms.fill(kNoForm);
    return skill;
  }

  void FillNever(Skill& never) {
    clauses_.Begin(&never, Code::kClause);
    std::vector<Clause>& made = never.slots.at(static_cast<std::size_t>(Slot::kRequires)).emplace();
    for (FormId at = tree_.at(never.name_form).next_sibling; at != kNoForm;
         at = tree_.at(at).next_sibling) {
      std::optional<Clause> clause = clauses_.MakeClause(at, Slot::kRequires);
      if (clause) made.push_back(*std::move(clause));
    }
  }

  /// The skills are known by now.
  void FillTop(Skill& top) {
    clauses_.Begin(&top, Code::kTop);
    std::optional<Clause> call = clauses_.MakeClause(top.name_form, Slot::kRequires);
    if (!call) return;
    if (CheckTopCall(program_, tree_, *call, reporter_)) {
      top.slots.at(static_cast<std::size_t>(Slot::kRequires)).emplace().push_back(*std::move(call));
    }
  }

  void AddSkill(FormId root, const std::vector<FormId>& children) {
    const std::string name = tree_.Folded(children[0]);
    if (name == "bind") {
      reporter_.Add(Code::kHead, children[0], "'bind' is part of the language",
                    "give the skill another name");
      return;
    }
    const auto index = static_cast<std::uint32_t>(program_.skills.size());
    const auto [place, is_new] = names_.skills.emplace(name, index);
    if (!is_new) {
      reporter_.Add(Code::kRepeatedSkill, children[0],
                    "the skill '" + std::string(tree_.Text(children[0])) + "' is already defined",
                    "give one of them another name");
      reporter_.Note(program_.skills[place->second].name_form, "defined here");
      program_.skills[place->second].has_whole_head =
          false;  // Which of them is meant is not known.
      return;
    }
    Skill skill = Nameless(root, children[0]);
    skill.name = name;
    skill.spelling = tree_.Text(children[0]);
    skill.has_whole_head = IsClean([&] { AddParameters(skill, children); });
    program_.skills.push_back(std::move(skill));
  }

  void AddParameters(Skill& skill, const std::vector<FormId>& children) {
    if (children.size() < 2 || tree_.kind(children[1]) != FormKind::kList) {
      reporter_.Add(Code::kHead, skill.name_form, "the list of parameters is missing",
                    "write (" + skill.spelling + " () ...) when there are none");
      return;
    }
    clauses_.Begin(&skill, Code::kHead);
    for (const FormId child : tree_.Children(children[1])) {
      if (tree_.kind(child) != FormKind::kVariable || tree_.Text(child) == "?") {
        reporter_.Add(Code::kHead, child, "a parameter is a variable with a name",
                      "write ?name; a value is compared with (bind ?name value)");
      } else if (clauses_.Enter(child) != skill.parameters) {
        reporter_.Add(Code::kHead, child,
                      "the parameter " + std::string(tree_.Text(child)) + " stands twice",
                      "give it another name");
      } else {
        ++skill.parameters;
      }
    }
  }

  void Fill(Skill& skill) {
    clauses_.Begin(&skill, Code::kClause);
    std::vector<FormId> children = tree_.Children(skill.form);
    std::size_t at = children.size() > 1 && tree_.kind(children[1]) == FormKind::kList ? 2 : 1;
    bool well_formed = true;
    while (at < children.size()) {
      if (tree_.kind(children[at]) != FormKind::kKeyword) {
        reporter_.Add(Code::kSlot, children[at], "a slot begins with its name",
                      SlotHint(skill, children[at]));
        well_formed = false;
        ++at;
        continue;
      }
      const bool has_value =
          at + 1 < children.size() && tree_.kind(children[at + 1]) != FormKind::kKeyword;
      well_formed &= AddSlot(skill, children[at], has_value ? children[at + 1] : kNoForm);
      at += has_value ? 2 : 1;
    }
    CheckType(skill, well_formed);
  }

  /// What begins a line is meant to be a skill of its own.
  std::string SlotHint(const Skill& skill, FormId form) const {
    if (tree_.at(form).column > 1) return "write :objective, :requires, :means, ... before it";
    return "the '(' of " + skill.spelling + " in line " +
           std::to_string(tree_.at(skill.form).line) + " is not closed before it";
  }

  bool AddSlot(Skill& skill, FormId keyword, FormId value) {
    const std::string name = tree_.Folded(keyword);
    if (value == kNoForm) {
      reporter_.Add(Code::kSlot, keyword, "nothing follows " + name, "write " + name + " (...)");
      return false;
    }
    if (name == kValueKeyword) return AddValue(skill, keyword, value);
    const std::optional<Slot> slot = SlotOf(name);
    if (!slot) return UnknownSlot(keyword, name);
    const auto index = static_cast<std::size_t>(*slot);
    if (skill.slots.at(index)) {
      reporter_.Add(Code::kSlot, keyword, name + " stands twice", "put its clauses together");
      reporter_.Note(skill.slot_forms.at(index), "first here");
      return false;
    }
    if (tree_.kind(value) != FormKind::kList) {
      reporter_.Add(Code::kSlot, value, "a list of clauses follows " + name,
                    "put one more pair of ( ) around it");
      return false;
    }
    skill.slots.at(index) = clauses_.MakeClauses(value, *slot);
    skill.slot_forms.at(index) = keyword;
    return true;
  }

  bool UnknownSlot(FormId keyword, std::string_view name) {
    std::vector<std::string> keywords(kKeywords.begin(), kKeywords.end());
    keywords.emplace_back(kValueKeyword);
    const std::string_view nearest = logic::NearestName(name, keywords);
    reporter_.Add(Code::kUnknownSlot, keyword,
                  "there is no slot " + std::string(tree_.Text(keyword)),
                  nearest.empty() ? std::string(Info(Code::kUnknownSlot).explanation)
                                  : "did you mean '" + std::string(nearest) + "'?");
    return false;
  }

  bool AddValue(Skill& skill, FormId keyword, FormId value) {
    const FormKind kind = tree_.kind(value);
    if (skill.value) {
      reporter_.Add(Code::kSlot, keyword, ":value stands twice", "take one of them out");
      return false;
    }
    if (kind != FormKind::kInteger && kind != FormKind::kReal && kind != FormKind::kCall &&
        kind != FormKind::kConstant && kind != FormKind::kVariable) {
      reporter_.Add(Code::kSlot, value, ":value is a number, a variable or a call",
                    "write :value 2.5 or :value {function argument ...}");
      return false;
    }
    skill.value = clauses_.MakeTerm(value, true);
    return true;
  }

  void CheckType(Skill& skill, bool well_formed) {
    std::optional<Slot> first;
    for (std::size_t i = 0; i < kSlots; ++i) {
      if (!skill.slots.at(i)) continue;
      const auto slot = static_cast<Slot>(i);
      if (!first) {
        first = slot;
        skill.type = TypeOf(slot);
      } else if (TypeOf(slot) != skill.type) {
        reporter_.Add(Code::kSkillType, skill.slot_forms.at(i),
                      std::string(KeywordOf(*first)) + " and " + std::string(KeywordOf(slot)) +
                          " cannot stand in one skill",
                      "make two skills of it");
        reporter_.Note(skill.slot_forms.at(static_cast<std::size_t>(*first)), "the other slot");
      }
    }
    if (first) {
      CheckAction(skill);
    } else if (well_formed) {
      reporter_.Add(Code::kSkillType, skill.name_form,
                    "the skill '" + skill.spelling + "' has no slot",
                    "add :objective, :requires, :means, :sequence, :action or :sensor");
    }
  }

  void CheckAction(const Skill& skill) {
    const std::vector<Clause>* action = skill.slot(Slot::kAction);
    if (action == nullptr || !action->empty()) return;
    const FormId keyword = skill.slot_forms[static_cast<std::size_t>(Slot::kAction)];
    const FormId list = tree_.at(keyword).next_sibling;
    if (tree_.at(list).first_child != kNoForm) return;
    reporter_.Add(Code::kClause, list, "an :action without a call does nothing",
                  "write :action ({function argument ...})");
  }

  Program& program_;
  const SourceTree& tree_;
  Findings& findings_;
  Reporter reporter_;
  Names names_;
  ClauseBuilder clauses_;
};

}  // namespace

std::string_view KeywordOf(Slot slot) { return kKeywords.at(static_cast<std::size_t>(slot)); }

void BuildProgram(Program& program, Findings& findings) { Builder(program, findings).Build(); }

}  // namespace latchwork::icarus
