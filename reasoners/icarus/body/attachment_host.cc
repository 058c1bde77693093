// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/body/attachment_host.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "reasoners/icarus/language/argument_check.h"
#include "reasoners/icarus/language/source_tree.h"
#include "reasoners/icarus/machine/query_levels.h"

namespace latchwork::icarus {

namespace {

ArgumentType TypeOf(sdk::ArgumentType type) {
  switch (type) {
    case sdk::ArgumentType::kInteger:
      return ArgumentType::kInteger;
    case sdk::ArgumentType::kReal:
      return ArgumentType::kNumber;
    case sdk::ArgumentType::kSymbol:
      return ArgumentType::kSymbol;
    case sdk::ArgumentType::kAny:
      break;
  }
  return ArgumentType::kAny;
}

bool IsOfType(const Value& value, ArgumentType type) {
  switch (type) {
    case ArgumentType::kInteger:
      return value.kind == ValueKind::kInteger;
    case ArgumentType::kNumber:
      return value.is_number();
    case ArgumentType::kSymbol:
      return value.kind == ValueKind::kSymbol || value.kind == ValueKind::kString;
    default:
      return true;
  }
}

std::vector<ArgumentType> TypesOf(const sdk::PredicateSpec& predicate) {
  std::vector<ArgumentType> types;
  for (const sdk::ArgumentSpec& argument : predicate.arguments) {
    types.push_back(TypeOf(argument.type));
  }
  return types;
}

/// Terms as the language has them, for a query: variables by their numbers.
Term TermOf(const logic::Term& term) {
  using Kind = logic::Term::Kind;
  Term made;
  switch (term.kind()) {
    case Kind::kVariable:
      made.kind = TermKind::kVariable;
      made.index = term.variable();
      break;
    case Kind::kInteger:
      made.kind = TermKind::kInteger;
      made.integer = term.integer();
      break;
    case Kind::kReal:
      made.kind = TermKind::kReal;
      made.real = term.real();
      break;
    case Kind::kConstant:
      made.kind =
          term.symbol().kind() == logic::SymbolKind::kWord ? TermKind::kSymbol : TermKind::kString;
      made.text = made.kind == TermKind::kSymbol ? Fold(term.symbol().name())
                                                 : std::string(term.symbol().name());
      break;
    case Kind::kCompound:
      made.kind = TermKind::kList;
      made.items.emplace_back().text = Fold(term.symbol().name());
      for (const logic::Term& argument : term.arguments()) made.items.push_back(TermOf(argument));
  }
  return made;
}

}  // namespace

AttachmentHost::AttachmentHost(const sdk::Body& body, TermBridge& bridge)
    : body_(body), bridge_(bridge) {
  for (const auto& attachment : body.attachments) {
    std::vector<ArgumentType> types;
    std::vector<ArgumentType> answers;
    for (const auto& argument : attachment->signature().arguments) {
      const bool is_input = argument.mode == sdk::Attachment::Mode::kIn;
      (is_input ? types : answers).push_back(TypeOf(argument.spec.type));
    }
    functions_.push_back(Declare(attachment->signature().predicate, std::move(types)));
    functions_.back().answers = types_.emplace_back(std::move(answers));
  }
  for (const sdk::PortSpec& port : body.contract.outputs) {
    for (const auto& predicate : port.predicates) {
      acts_.push_back(Declare(predicate.name, TypesOf(predicate)));
    }
  }
  for (const sdk::Goal& goal : body.goals) {
    const std::string name = Fold(goal.pattern.predicate().name());
    const Signature* const known = FindSignature(acts_, name, goal.pattern.arity());
    if (known != nullptr && known->least == goal.pattern.arity()) continue;
    acts_.push_back(
        Declare(name, std::vector<ArgumentType>(goal.pattern.arity(), ArgumentType::kAny)));
  }
  for (const sdk::PortSpec& port : body.contract.inputs) {
    for (const auto& predicate : port.predicates) {
      facts_.push_back(Declare(predicate.name, TypesOf(predicate)));
    }
  }
  if (facts_.empty()) return;
  for (const logic::Fact& fact : body.facts) {
    facts_.push_back(Declare(fact.predicate().name(),
                             std::vector<ArgumentType>(fact.arity(), ArgumentType::kAny)));
  }
}

Signature AttachmentHost::Declare(std::string_view name, std::vector<ArgumentType> types) {
  texts_.push_back(Fold(name));
  types_.push_back(std::move(types));
  Signature signature;
  signature.name = texts_.back();
  signature.least = signature.most = types_.back().size();
  signature.types = types_.back();
  return signature;
}

void AttachmentHost::Serve(Interpreter& interpreter, const Program& program) {
  interpreter_ = &interpreter;
  program_ = &program;
  queries_.clear();
}

/// The first answer: true, a value, or a list of them.
class AttachmentHost::Answers final : public sdk::AnswerSink {
 public:
  Answers(TermBridge& bridge, Arena& arena, Value truth)
      : bridge_(bridge), arena_(arena), truth_(truth) {}

  void Answer(std::span<const logic::Term> terms) override {
    if (answered_) return;
    answered_ = true;
    if (terms.empty()) {
      value = truth_;
    } else if (terms.size() == 1) {
      value = bridge_.Import(terms[0], arena_);
    } else {
      const std::span<Value> items = arena_.MakeValues(terms.size());
      for (std::size_t i = 0; i < terms.size(); ++i) items[i] = bridge_.Import(terms[i], arena_);
      const bool whole = std::none_of(items.begin(), items.end(),
                                      [](const Value& item) { return item.is_none(); });
      if (whole) value = arena_.MakeList(items);
    }
    if (value.is_none()) throw std::runtime_error("the answer is no value");
  }

  Value value;

 private:
  TermBridge& bridge_;
  Arena& arena_;
  Value truth_;
  bool answered_ = false;
};

std::vector<logic::Term>& AttachmentHost::Terms() {
  if (terms_used_ == terms_.size()) terms_.emplace_back();
  std::vector<logic::Term>& terms = terms_[terms_used_++];
  terms.clear();
  return terms;
}

namespace {

/// Gives a count back to what it was.
class Restore {
 public:
  explicit Restore(std::size_t& count) : count_(count), before_(count) {}
  Restore(const Restore&) = delete;
  Restore& operator=(const Restore&) = delete;
  ~Restore() { count_ = before_; }

 private:
  std::size_t& count_;
  std::size_t before_;
};

}  // namespace

Value AttachmentHost::Call(std::size_t function, std::span<const Value> arguments, Arena& arena,
                           NamePool& names) {
  ++calls_;
  const Restore restore(terms_used_);
  const Signature& signature = functions_[function];
  std::vector<logic::Term>& inputs = Terms();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    logic::Term& input = inputs.emplace_back();
    if (!IsOfType(arguments[i], signature.TypeOf(i)) || !bridge_.Export(arguments[i], input)) {
      throw std::invalid_argument("argument " + std::to_string(i + 1) + ", " +
                                  ToString(arguments[i], names) + ", is not " +
                                  std::string(NameOf(signature.TypeOf(i))));
    }
  }
  Answers answers(bridge_, arena, Value::Symbol(names.Intern("t")));
  body_.attachments[function]->Call(inputs, *this, answers);
  return answers.value;
}

Clause AttachmentHost::ClauseOf(const logic::Literal& literal) const {
  Clause clause;
  const std::uint32_t skill = program_->Find(literal.atom.predicate().name());
  if (skill != kNoSkill && program_->skills[skill].parameters == literal.atom.arity()) {
    clause.kind = ClauseKind::kSkill;
    clause.skill = skill;
  } else {
    clause.terms.emplace_back().text = Fold(literal.atom.predicate().name());
  }
  for (const logic::Term& argument : literal.atom.arguments()) {
    clause.terms.push_back(TermOf(argument));
  }
  if (literal.positive) return clause;
  Clause negation;
  negation.kind = ClauseKind::kNot;
  negation.inner.push_back(std::move(clause));
  return negation;
}

std::size_t AttachmentHost::QueryNumber(std::span<const logic::Literal> query,
                                        std::size_t variables) {
  for (const Query& known : queries_) {
    if (std::equal(query.begin(), query.end(), known.literals.begin(), known.literals.end())) {
      return known.number;
    }
  }
  Skill skill;
  auto& clauses = skill.slots.at(static_cast<std::size_t>(Slot::kRequires)).emplace();
  for (const logic::Literal& literal : query) clauses.push_back(ClauseOf(literal));
  for (std::size_t i = 0; i < variables; ++i) skill.variables.push_back("?" + std::to_string(i));
  Query& made = queries_.emplace_back();
  made.literals.assign(query.begin(), query.end());
  made.number = interpreter_->AddQuery(std::move(skill));
  return made.number;
}

/// Hands environments on as terms.
class AttachmentHost::Environments final : public EnvironmentSink {
 public:
  Environments(TermBridge& bridge, std::vector<logic::Term>& terms, sdk::AnswerSink& sink)
      : bridge_(bridge), terms_(terms), sink_(sink) {}

  void Accept(std::span<const Value> values) override {
    terms_.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!bridge_.Export(values[i], terms_[i])) return;
    }
    sink_.Answer(terms_);
  }

 private:
  TermBridge& bridge_;
  std::vector<logic::Term>& terms_;
  sdk::AnswerSink& sink_;
};

void AttachmentHost::ForEachProvable(std::span<const logic::Literal> query, std::size_t variables,
                                     sdk::AnswerSink& sink) {
  const Restore restore(terms_used_);
  Environments environments(bridge_, Terms(), sink);
  interpreter_->Ask(QueryNumber(query, variables), environments);
}

}  // namespace latchwork::icarus
