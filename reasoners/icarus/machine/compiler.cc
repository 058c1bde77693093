// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/compiler.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "reasoners/icarus/language/argument_check.h"
#include "reasoners/icarus/language/clause_builder.h"
#include "reasoners/icarus/language/reader.h"
#include "reasoners/icarus/language/top_check.h"
#include "reasoners/icarus/language/walk.h"

namespace latchwork::icarus {

namespace {

class Compiler {
 public:
  Compiler(const Program& program, const Host& host, NamePool& names, Arena& arena,
           Findings& findings)
      : program_(program), host_(host), names_(names), arena_(arena), findings_(findings) {}

  CompiledProgram Run() {
    Emit({Op::kFail});
    AddConstants();
    for (const Term& fact : program_.facts) code_.facts.push_back(Ground(fact));
    code_.skills.resize(program_.skills.size());
    for (std::size_t i = 0; i < program_.skills.size(); ++i) {
      AddSkill(program_.skills[i], code_.skills[i]);
    }
    return std::move(code_);
  }

  Address AddTop(const Skill& query, const SourceTree& source, CompiledProgram& code) {
    source_ = &source;
    code_ = std::move(code);
    const Address entry = Here();
    for (const Clause& clause : *query.slot(Slot::kRequires)) AddClause(clause);
    Emit({Op::kTopEnd});
    code = std::move(code_);
    return entry;
  }

  void AddConstants() {
    for (const Constant& constant : program_.constants) {
      constants_.push_back(constant.form == kNoForm ? Value() : Ground(constant.value));
    }
  }

 private:
  Address Here() const { return static_cast<Address>(code_.instructions.size()); }
  void Emit(const Instruction& instruction) { code_.instructions.push_back(instruction); }

  void AddSkill(const Skill& skill, SkillCode& compiled) {
    compiled.type = skill.type;
    compiled.parameters = static_cast<std::uint32_t>(skill.parameters);
    compiled.variables = static_cast<std::uint32_t>(skill.variables.size());
    if (skill.value) {
      compiled.has_value = true;
      compiled.value = AddTerm(*skill.value);
    }
    compiled.entry = Here();
    switch (skill.type) {
      case SkillType::kPlan:
        AddPlan(skill);
        break;
      case SkillType::kSequence:
        code_.has_sequences = true;
        AddBranches(*skill.slot(Slot::kSequence), Op::kSequence, Op::kStepEnd);
        break;
      case SkillType::kSensor:
        AddConjunction(*skill.slot(Slot::kSensor));
        Emit({Op::kExit});
        break;
      case SkillType::kAction:
        AddAct(*skill.slot(Slot::kAction));
    }
  }

  void AddPlan(const Skill& skill) {
    const std::vector<Clause>* objective = skill.slot(Slot::kObjective);
    const std::vector<Clause>* required = skill.slot(Slot::kRequires);
    const std::vector<Clause>* means = skill.slot(Slot::kMeans);
    if (objective != nullptr) {
      const Address at = Here();
      if (required != nullptr || means != nullptr) Emit({Op::kObjective, 0, OnlyTests(*objective)});
      AddConjunction(*objective);
      Emit({Op::kExit});
      if (code_.instructions[at].op != Op::kObjective) return;
      code_.instructions[at].a = Here();
    }
    if (required != nullptr) AddConjunction(*required);
    if (means == nullptr || means->empty()) {
      Emit({Op::kFail});
    } else {
      AddBranches(*means, Op::kMeans, Op::kExit);
    }
  }

  static std::uint32_t OnlyTests(const std::vector<Clause>& clauses) {
    const bool only = std::all_of(clauses.begin(), clauses.end(), [](const Clause& clause) {
      return clause.kind == ClauseKind::kCall;
    });
    return only ? 1 : 0;
  }

  void AddConjunction(const std::vector<Clause>& clauses) {
    for (const Clause& clause : clauses) AddClause(clause);
  }

  void AddBranches(const std::vector<Clause>& clauses, Op op, Op end) {
    const auto first = static_cast<std::uint32_t>(code_.branches.size());
    const auto count = static_cast<std::uint32_t>(clauses.size());
    Emit({op, first, count});
    if (op == Op::kSequence) Emit({Op::kExit});
    code_.branches.resize(first + count);
    for (std::uint32_t i = 0; i < count; ++i) {
      Branch branch;
      branch.address = Here();
      AddClause(clauses[i]);
      Emit({end});
      const Instruction& called = code_.instructions[branch.address];
      if (called.op == Op::kCall) {
        branch.skill = called.a;
        branch.first = called.b;
        branch.count = called.c;
      }
      code_.branches[first + i] = branch;
    }
  }

  void AddAct(const std::vector<Clause>& calls) {
    const auto first = static_cast<std::uint32_t>(code_.calls.size());
    const auto count = static_cast<std::uint32_t>(calls.size());
    code_.calls.resize(first + count);
    for (std::uint32_t i = 0; i < count; ++i) {
      code_.calls[first + i] = MakeCall(calls[i].terms.front(), true);
    }
    Emit({Op::kAct, first, count});
  }

  void AddClause(const Clause& clause) {
    switch (clause.kind) {
      case ClauseKind::kSkill: {
        const std::uint32_t first = AddTerms(clause.terms);
        Emit({Op::kCall, clause.skill, first, static_cast<std::uint32_t>(clause.terms.size()),
              clause.form});
        break;
      }
      case ClauseKind::kCall:
        Emit({Op::kTest, AddCall(clause.terms.front()), 0, 0, clause.form});
        break;
      case ClauseKind::kBind:
        AddBind(clause);
        break;
      case ClauseKind::kMatch: {
        CheckMatch(clause);
        const std::uint32_t first = AddTerms(clause.terms);
        const TermCode& head = code_.terms[first];
        const bool symbol =
            head.kind == TermCode::Kind::kValue && head.value.kind == ValueKind::kSymbol;
        Emit({Op::kMatch, symbol ? head.value.name : kNoName, first,
              static_cast<std::uint32_t>(clause.terms.size()), clause.form});
        break;
      }
      case ClauseKind::kNot:
      case ClauseKind::kNotOrActing: {
        const Address at = Here();
        Emit({Op::kNot, 0, clause.kind == ClauseKind::kNotOrActing ? 1U : 0U, 0, clause.form});
        AddClause(clause.inner.front());
        Emit({Op::kNotEnd});
        code_.instructions[at].a = Here();
      }
    }
  }

  void AddBind(const Clause& clause) {
    const Term& target = clause.terms[0];
    if (target.kind == TermKind::kVariable) {
      Emit({Op::kBind, target.index, AddTerm(clause.terms[1]), 0, clause.form});
    } else {
      CheckBind(target, clause.terms[1]);
      const std::uint32_t pattern = AddTerm(target);
      Emit({Op::kTakeApart, pattern, AddTerm(clause.terms[1]), 0, clause.form});
    }
  }

  std::uint32_t AddTerms(const std::vector<Term>& terms) {
    const auto first = static_cast<std::uint32_t>(code_.terms.size());
    code_.terms.resize(first + terms.size());
    for (std::size_t i = 0; i < terms.size(); ++i) {
      TermCode made = MakeTerm(terms[i]);
      code_.terms[first + i] = made;
    }
    return first;
  }

  std::uint32_t AddTerm(const Term& term) {
    const TermCode made = MakeTerm(term);
    code_.terms.push_back(made);
    return static_cast<std::uint32_t>(code_.terms.size() - 1);
  }

  std::uint32_t AddCall(const Term& term) {
    const CallCode made = MakeCall(term, false);
    code_.calls.push_back(made);
    return static_cast<std::uint32_t>(code_.calls.size() - 1);
  }

  static bool IsGround(const Term& term) {
    if (term.kind == TermKind::kVariable || term.kind == TermKind::kAnonymous ||
        term.kind == TermKind::kCall) {
      return false;
    }
    if (term.kind == TermKind::kConstant) return term.index != kCycleConstant;
    return std::all_of(term.items.begin(), term.items.end(), IsGround);
  }

  TermCode MakeTerm(const Term& term) {
    TermCode made;
    if (IsGround(term)) {
      made.value = Ground(term);
      return made;
    }
    switch (term.kind) {
      case TermKind::kVariable:
        made.kind = TermCode::Kind::kVariable;
        made.a = term.index;
        break;
      case TermKind::kConstant:
        made.kind = TermCode::Kind::kCycle;
        break;
      case TermKind::kCall:
        made.kind = TermCode::Kind::kCall;
        made.a = AddCall(term);
        break;
      case TermKind::kList:
        made.kind = TermCode::Kind::kList;
        made.a = AddTerms(term.items);
        made.b = static_cast<std::uint32_t>(term.items.size());
        break;
      default:
        made.kind = TermCode::Kind::kAnything;
    }
    return made;
  }

  Value Ground(const Term& term) {
    switch (term.kind) {
      case TermKind::kInteger:
        return Value::Integer(term.integer);
      case TermKind::kReal:
        return Value::Real(term.real);
      case TermKind::kString:
        return Value::String(names_.Intern(term.text));
      case TermKind::kConstant:
        return constants_.at(term.index);
      case TermKind::kList:
        return GroundList(term);
      default:
        return Value::Symbol(names_.Intern(term.text));
    }
  }

  Value GroundList(const Term& term) {
    std::vector<Value> items;
    items.reserve(term.items.size());
    for (const Term& item : term.items) items.push_back(Ground(item));
    const Value list = arena_.MakeList(items);
    if (list.is_none()) {
      Report(Code::kFact, term, "the list has more values than a list may have", "");
    }
    return list;
  }

  CallCode MakeCall(const Term& term, bool act) {
    CallCode made;
    made.form = term.form;
    made.name = names_.Intern(term.text);
    made.count = static_cast<std::uint32_t>(term.items.size());
    made.first = AddTerms(term.items);
    AddSlots(made);
    if (act) {
      const Signature* const builtin = FindBuiltin(term.text);
      if (builtin != nullptr && builtin->changes_memory) Resolve(term, made);
      CheckAct(term);
    } else {
      Resolve(term, made);
    }
    return made;
  }

  /// Where the arguments may differ from one time that the call is met to the next.
  void AddSlots(CallCode& made) {
    made.first_slot = static_cast<std::uint32_t>(code_.slots.size());
    made.comparable = true;
    for (std::uint32_t i = 0; i < made.count; ++i) {
      const TermCode& term = code_.terms[made.first + i];
      if (term.kind == TermCode::Kind::kVariable) code_.slots.push_back({i, term.a});
      made.comparable &=
          term.kind == TermCode::Kind::kValue || term.kind == TermCode::Kind::kVariable;
    }
    made.slots = static_cast<std::uint32_t>(code_.slots.size()) - made.first_slot;
  }

  void Resolve(const Term& term, CallCode& made) {
    if (const Signature* const builtin = FindBuiltin(term.text)) {
      made.function = static_cast<std::uint32_t>(builtin - BuiltinSignatures().data());
      const auto which = static_cast<Builtin>(made.function);
      const bool changes = which == Builtin::kForget || which == Builtin::kUpdate;
      made.kind = changes ? CallCode::Kind::kChange : CallCode::Kind::kBuiltin;
      Reporter reporter(Source(), findings_);
      CheckNested(term, *builtin, host_.functions(), reporter);
      return;
    }
    const auto functions = host_.functions();
    if (const Signature* const found = FindSignature(functions, term.text, term.items.size())) {
      made.function = static_cast<std::uint32_t>(found - functions.data());
      made.kind = found->changes_memory ? CallCode::Kind::kEffect : CallCode::Kind::kHost;
      Check(term, *found);
    } else {
      UnknownFunction(term, functions);
    }
  }

  void CheckAct(const Term& term) {
    const auto acts = host_.acts();
    const Signature* const builtin = FindBuiltin(term.text);
    if (!acts || (builtin != nullptr && builtin->changes_memory)) return;
    if (const Signature* const found = FindSignature(*acts, term.text, term.items.size())) {
      Check(term, *found);
    } else {
      UnknownFunction(term, *acts);
    }
  }

  void Check(const Term& term, const Signature& signature) {
    Reporter reporter(Source(), findings_);
    CheckArguments(program_, term, signature, reporter);
    CheckNested(term, signature, host_.functions(), reporter);
  }

  void CheckBind(const Term& target, const Term& call) {
    if (call.kind != TermKind::kCall || FindBuiltin(call.text) != nullptr) return;
    const Signature* const found = FindSignature(host_.functions(), call.text, call.items.size());
    Reporter reporter(Source(), findings_);
    if (found != nullptr) CheckTarget(program_, target, call, *found, reporter);
  }

  void CheckMatch(const Clause& clause) {
    const Term& head = clause.terms.front();
    if (head.kind != TermKind::kSymbol || IsStored(head.text)) return;
    const auto facts = host_.facts();
    if (facts.empty() || clause.form == kNoForm) return;
    Reporter reporter(Source(), findings_);
    if (const Signature* const found = FindSignature(facts, head.text, clause.terms.size() - 1)) {
      CheckPattern(program_, clause, *found, reporter);
    } else {
      UnknownHead(head, facts, reporter);
    }
  }

  void UnknownHead(const Term& head, std::span<const Signature> facts, Reporter& reporter) {
    std::vector<std::string> known;
    for (const Signature& s : facts) known.emplace_back(s.name);
    for (const Skill& skill : program_.skills) known.push_back(skill.name);
    const std::string_view nearest = logic::NearestName(head.text, known);
    reporter.Add(Code::kNoSuchFact, head.form,
                 "there is neither a skill '" + head.text + "' nor a fact of this name",
                 nearest.empty() ? "" : "did you mean '" + std::string(nearest) + "'?");
  }

  /// Whether the program itself has facts of this name.
  bool IsStored(std::string_view name) {
    if (!stored_) {
      stored_.emplace();
      for (const Term& fact : program_.facts) AddStored(fact);
      for (const Skill& skill : program_.skills) {
        WalkTerms(skill, [&](const Term& term, Slot) {
          const bool stores = term.kind == TermKind::kCall && !term.items.empty() &&
                              (term.text == "store" || term.text == "update");
          if (stores) AddStored(term.items.back());
        });
      }
    }
    return stores_any_ || stored_->contains(name);
  }

  void AddStored(const Term& fact) {
    if (fact.items.empty()) return;
    if (fact.items.front().kind == TermKind::kSymbol) {
      stored_->insert(fact.items.front().text);
    } else {
      stores_any_ = true;
    }
  }

  void UnknownFunction(const Term& term, std::span<const Signature> functions) {
    std::vector<std::string> known;
    for (const Signature& s : functions) known.emplace_back(s.name);
    for (const Signature& s : BuiltinSignatures()) known.emplace_back(s.name);
    const std::string_view nearest = logic::NearestName(term.text, known);
    Report(
        Code::kUnknownFunction, term, "the host offers no function {" + term.text + "}",
        nearest.empty() ? host_.Remedy(term.text) : "did you mean {" + std::string(nearest) + "}?");
  }

  const SourceTree& Source() const { return source_ == nullptr ? program_.source : *source_; }

  void Report(Code code, const Term& term, std::string message, std::string hint) {
    Reporter(Source(), findings_).Add(code, term.form, std::move(message), std::move(hint));
  }

  const Program& program_;
  const Host& host_;
  NamePool& names_;
  Arena& arena_;
  Findings& findings_;
  const SourceTree* source_ = nullptr;
  std::optional<std::set<std::string, std::less<>>> stored_;
  bool stores_any_ = false;  ///< Facts whose name is known only when they are stored.
  std::vector<Value> constants_;
  CompiledProgram code_;
};

}  // namespace

CompiledProgram Compile(const Program& program, const Host& host, NamePool& names, Arena& arena,
                        Findings& findings) {
  return Compiler(program, host, names, arena, findings).Run();
}

Address CompileTop(const Program& program, const Skill& query, const SourceTree& source,
                   const Host& host, CompiledProgram& code, NamePool& names, Arena& arena,
                   Findings& findings) {
  Compiler compiler(program, host, names, arena, findings);
  compiler.AddConstants();
  return compiler.AddTop(query, source, code);
}

TopCall ReadTop(const Program& program, std::string text, Findings& findings) {
  TopCall top;
  top.source = ReadForms(std::move(text), "top", findings);
  Reporter reporter(top.source, findings);
  std::vector<Clause> clauses;
  if (top.source.roots.size() == 1) {
    Names names;
    for (std::uint32_t i = 0; i < program.skills.size(); ++i) {
      names.skills.emplace(program.skills[i].name, i);
    }
    for (std::uint32_t i = 0; i < program.constants.size(); ++i) {
      names.constants.emplace(program.constants[i].name, i);
    }
    ClauseBuilder builder(top.source, names, reporter);
    builder.Begin(&top.query, Code::kClause);
    std::optional<Clause> clause = builder.MakeClause(top.source.roots[0], Slot::kRequires);
    const bool good = clause && CheckTopCall(program, top.source, *clause, reporter) &&
                      CheckParameters(program, *clause, reporter);
    if (good) clauses.push_back(*std::move(clause));
  } else if (findings.empty()) {
    reporter.AddAt(Code::kTopLevel, 0, 1, 1, "the top of a program is one call",
                   "write (Name argument ...)");
  }
  top.query.slots[static_cast<std::size_t>(Slot::kRequires)] = std::move(clauses);
  return top;
}

}  // namespace latchwork::icarus
