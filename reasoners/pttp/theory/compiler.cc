// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/theory/compiler.h"

#include <algorithm>

namespace latchwork::pttp {
namespace {

std::uint64_t Bit(std::size_t index) { return index < 64 ? std::uint64_t{1} << index : 0; }

bool IsHeadPredicate(const Predicates::Info& info) {
  return info.kind == PredicateKind::kOrdinary || info.kind == PredicateKind::kEquality;
}

/// The first argument, as far as it can rule out a match.
Word FirstKey(const CompiledLiteral& head) {
  if (head.arity == 0) return 0;
  const Word first = head.arguments[0];
  switch (TagOf(first)) {
    case Tag::kConstant:
      return first;
    case Tag::kCompound:
    case Tag::kTemplate:
      return *AddressOf(first);
    default:
      return 0;
  }
}

bool IsLinear(const CompiledLiteral& head, std::size_t slots) {
  std::vector<bool> seen(slots, false);
  std::vector<Word> visits(head.arguments, head.arguments + head.arity);
  while (!visits.empty()) {
    const Word word = visits.back();
    visits.pop_back();
    if (TagOf(word) == Tag::kSlot) {
      if (seen[NumberOf(word)]) return false;
      seen[NumberOf(word)] = true;
    } else if (TagOf(word) == Tag::kTemplate) {
      const Word* block = AddressOf(word);
      visits.insert(visits.end(), block + 1, block + 1 + ArityOf(block[0]));
    }
  }
  return true;
}

}  // namespace

bool Compiler::IsFact(const logic::Clause& clause) const {
  if (clause.literals.size() != 1 || clause.role != logic::Role::kAxiom) return false;
  const logic::Literal& literal = clause.literals.front();
  if (!literal.positive || !literal.atom.is_ground()) return false;
  return predicates_->operator[](predicates_->Number(NameOf(literal.atom))).kind ==
         PredicateKind::kOrdinary;
}

bool Compiler::ContainsArithmetic(Word word) const {
  visits_.assign(1, word);
  while (!visits_.empty()) {
    const Word current = visits_.back();
    visits_.pop_back();
    if (TagOf(current) != Tag::kCompound && TagOf(current) != Tag::kTemplate) continue;
    const Word* block = AddressOf(current);
    if ((*functors_)[NumberOf(block[0])].function) return true;
    visits_.insert(visits_.end(), block + 1, block + 1 + ArityOf(block[0]));
  }
  return false;
}

CompiledLiteral Compiler::MakeLiteral(const logic::Literal& literal, bool complement,
                                      Arena& arena) {
  CompiledLiteral result;
  result.predicate = predicates_->Number(NameOf(literal.atom));
  result.positive = literal.positive != complement;
  result.arity = static_cast<std::uint32_t>(literal.atom.arity());
  Word* arguments = arena.Allocate(result.arity);
  for (std::size_t i = 0; i < result.arity; ++i) {
    arguments[i] = functors_->Import(literal.atom.argument(i), arena);
    if (ContainsArithmetic(arguments[i])) result.arithmetic |= Bit(i);
  }
  result.arguments = arguments;
  const Predicates::Info& info = (*predicates_)[result.predicate];
  const std::uint64_t all = result.arity >= 64 ? ~std::uint64_t{0} : Bit(result.arity) - 1;
  result.needs_ground = result.arithmetic;
  if (info.kind == PredicateKind::kArithmetic) result.needs_ground = all;
  if (info.kind == PredicateKind::kAttachment) {
    result.needs_ground = result.positive ? info.inputs | result.arithmetic : all;
  }
  return result;
}

void Compiler::FlattenHead(Contrapositive& rule, Arena& arena) {
  if (rule.head.arithmetic == 0) return;
  const PredicateId equality = predicates_->Number({equality_, 2});
  Word* arguments = arena.Allocate(rule.head.arity);
  std::copy_n(rule.head.arguments, rule.head.arity, arguments);
  for (std::size_t i = 0; i < rule.head.arity; ++i) {
    if ((rule.head.arithmetic & Bit(i)) == 0) continue;
    Word* sides = arena.Allocate(2);
    sides[0] = SlotWord(rule.slots);
    sides[1] = arguments[i];
    arguments[i] = SlotWord(rule.slots++);
    rule.body.push_back({equality, true, 2, sides, 2, 2});
  }
  rule.head.arguments = arguments;
  rule.head.arithmetic = 0;
}

void Compiler::Finish(Contrapositive& rule) const {
  if (rule.has_head) {
    rule.linear = IsLinear(rule.head, rule.slots);
    rule.first_key = FirstKey(rule.head);
  }
  rule.eager = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(rule.body.size(), 64); ++i) {
    const Predicates::Info& info = (*predicates_)[rule.body[i].predicate];
    const bool computed =
        info.kind == PredicateKind::kArithmetic || info.kind == PredicateKind::kEquality;
    if (computed) rule.eager |= Bit(i);
  }
}

Contrapositive Compiler::MakeContrapositive(Program& program, std::uint32_t index,
                                            std::size_t head) {
  const logic::Clause& clause = program.clauses_[index];
  Contrapositive rule;
  rule.clause = index;
  rule.literal = static_cast<std::uint32_t>(head);
  rule.slots = static_cast<std::uint32_t>(clause.variable_names.size());
  for (std::size_t i = 0; i < clause.literals.size(); ++i) {
    if (i == head) {
      rule.head = MakeLiteral(clause.literals[i], false, program.terms_);
      rule.has_head = true;
    } else {
      rule.body.push_back(MakeLiteral(clause.literals[i], true, program.terms_));
    }
    if (rule.has_head && i == head && rule.head.arithmetic != 0) program.has_arithmetic_ = true;
  }
  if (rule.has_head) FlattenHead(rule, program.terms_);
  Finish(rule);
  return rule;
}

void Compiler::AddClause(Program& program, std::uint32_t index) {
  const logic::Clause& clause = program.clauses_[index];
  bool negative = true;
  for (std::size_t i = 0; i < clause.literals.size(); ++i) {
    const logic::Literal& literal = clause.literals[i];
    negative = negative && !literal.positive;
    const PredicateId predicate = predicates_->Number(NameOf(literal.atom));
    if (!IsHeadPredicate((*predicates_)[predicate])) {
      program.has_arithmetic_ = true;
      continue;
    }
    const std::uint32_t key = Signed(predicate, literal.positive);
    if (key >= program.rules_.size()) program.rules_.resize(key + 1);
    program.rules_[key].push_back(MakeContrapositive(program, index, i));
  }
  const std::size_t none = clause.literals.size();
  if (clause.role == logic::Role::kNegatedConjecture) {
    program.conjectures_.push_back(MakeContrapositive(program, index, none));
  }
  if (negative) program.negatives_.push_back(MakeContrapositive(program, index, none));
}

std::unique_ptr<Program> Compiler::Compile(std::vector<logic::Clause> clauses) {
  auto program = std::make_unique<Program>();
  program->clauses_ = std::move(clauses);
  for (std::uint32_t i = 0; i < program->clauses_.size(); ++i) {
    if (!IsFact(program->clauses_[i])) AddClause(*program, i);
  }
  for (auto& rules : program->rules_) {
    std::stable_partition(rules.begin(), rules.end(),
                          [](const Contrapositive& rule) { return rule.body.empty(); });
  }
  return program;
}

void Compiler::CompileQuery(std::span<const logic::Literal> query, std::size_t variables,
                            Arena& arena, Contrapositive& target) {
  target.has_head = false;
  target.slots = static_cast<std::uint32_t>(variables);
  target.clause = kNoClause;
  target.body.clear();
  for (const logic::Literal& literal : query) {
    target.body.push_back(MakeLiteral(literal, false, arena));
  }
  Finish(target);
}

}  // namespace latchwork::pttp
