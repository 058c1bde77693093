// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/saturation/translation.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

namespace latchwork::pttp::saturation {
namespace {

struct ReadFrame {
  const logic::Term* term;
  std::size_t next = 0;
};

struct WriteFrame {
  TermId term;
  std::size_t next = 0;
};

/// Takes the last `count` values off a stack.
template <class Value>
std::vector<Value> Take(std::vector<Value>& stack, std::size_t count) {
  const auto first = stack.end() - static_cast<std::ptrdiff_t>(count);
  std::vector<Value> taken(first, stack.end());
  stack.erase(first, stack.end());
  return taken;
}

}  // namespace

Translation::Translation(Terms& terms, logic::SymbolTable& symbols)
    : terms_(terms), equality_(symbols.Intern("=")), sources_(terms.functor_count()) {}

FunctorId Translation::Find(const Name& name, const logic::Term& constant,
                            Functor::Distinct distinct) {
  const auto [at, is_new] = functors_.try_emplace(name, 0);
  if (is_new) {
    Functor functor;
    functor.arity = static_cast<std::uint32_t>(name.arity);
    functor.distinct = distinct;
    at->second = terms_.AddFunctor(functor);
    sources_.push_back({constant, name.kind == Kind::kPredicate, 0, false});
    const bool symbol = !constant.is_number();
    has_fixed_meaning_ = has_fixed_meaning_ || distinct != Functor::Distinct::kNo ||
                         (symbol && constant.symbol().name().starts_with('$'));
  }
  Note(at->second);
  return at->second;
}

void Translation::Note(FunctorId functor) {
  Source& source = sources_[functor];
  ++source.occurrences;
  source.in_goal = source.in_goal || reading_goal_;
}

FunctorId Translation::FindPredicate(const logic::Atom& atom) {
  return Find({Kind::kPredicate, atom.predicate().index(), atom.arity()},
              logic::Term::Constant(atom.predicate()), Functor::Distinct::kNo);
}

FunctorId Translation::FindHead(const logic::Term& term) {
  using Distinct = Functor::Distinct;
  if (term.kind() == logic::Term::Kind::kInteger) {
    const auto value = static_cast<std::uint64_t>(term.integer());
    return Find({Kind::kInteger, value, 0}, term, Distinct::kInteger);
  }
  if (term.kind() == logic::Term::Kind::kReal) {
    const double value = term.real() == 0.0 ? 0.0 : term.real();
    return Find({Kind::kReal, std::bit_cast<std::uint64_t>(value), 0}, term, Distinct::kReal);
  }
  const logic::Symbol symbol = term.symbol();
  const bool object = symbol.kind() == logic::SymbolKind::kDistinctObject;
  return Find({Kind::kFunction, symbol.index(), term.arguments().size()},
              logic::Term::Constant(symbol), object ? Distinct::kObject : Distinct::kNo);
}

TermId Translation::ReadTerm(const logic::Term& root) {
  std::vector<ReadFrame> frames;
  std::vector<TermId> results;
  frames.push_back({&root});
  while (!frames.empty()) {
    ReadFrame& frame = frames.back();
    const logic::Term& term = *frame.term;
    if (term.is_variable()) {
      results.push_back(Terms::Variable(term.variable()));
      frames.pop_back();
    } else if (frame.next < term.arguments().size()) {
      frames.push_back({&term.arguments()[frame.next++]});
    } else {
      frames.pop_back();
      const auto arguments = Take(results, term.arguments().size());
      results.push_back(terms_.Make(FindHead(term), arguments));
    }
  }
  return results.back();
}

std::vector<Literal> Translation::Read(const logic::Clause& clause) {
  reading_goal_ = clause.role == logic::Role::kNegatedConjecture;
  std::vector<Literal> literals;
  for (const logic::Literal& source : clause.literals) {
    Literal literal;
    literal.positive = source.positive;
    if (source.atom.predicate() == equality_ && source.atom.arity() == 2) {
      literal.left = ReadTerm(source.atom.argument(0));
      literal.right = ReadTerm(source.atom.argument(1));
    } else {
      std::vector<TermId> arguments;
      for (const logic::Term& argument : source.atom.arguments()) {
        arguments.push_back(ReadTerm(argument));
      }
      literal.left = terms_.Make(FindPredicate(source.atom), arguments);
    }
    literals.push_back(literal);
  }
  return literals;
}

FunctorId Translation::FrequentUnary() const {
  FunctorId best = 0;
  for (FunctorId id = 1; id < sources_.size(); ++id) {
    if (terms_.functor(id).arity != 1 || sources_[id].predicate) continue;
    if (best == 0 || sources_[id].occurrences > sources_[best].occurrences) best = id;
  }
  return best;
}

// Distinct constants come lowest, so that equations between them and other terms rewrite the
// latter. A function without weight has to come highest.
void Translation::Arrange(const Options& options) {
  std::vector<FunctorId> order(sources_.size());
  std::iota(order.begin(), order.end(), FunctorId{0});
  const FunctorId weightless = options.weightless_unary ? FrequentUnary() : 0;
  const auto rank = [&](FunctorId id) {
    const Functor& functor = terms_.functor(id);
    const auto often = static_cast<std::int64_t>(sources_[id].occurrences);
    return std::tuple(id != 0, functor.distinct == Functor::Distinct::kNo, id == weightless,
                      options.precedence == Precedence::kArity ? functor.arity : 0,
                      options.precedence == Precedence::kFrequentGreater ? often : -often,
                      functor.arity);
  };
  std::ranges::stable_sort(order, [&](FunctorId a, FunctorId b) { return rank(a) < rank(b); });
  for (std::uint32_t place = 0; place < order.size(); ++place) {
    const FunctorId id = order[place];
    Functor& functor = terms_.functor(id);
    functor.precedence = place;
    functor.weight = weightless != 0 && id == weightless ? 0 : 1;
    functor.goal_weight = sources_[id].in_goal ? 2 : 4;
  }
  terms_.Reweigh();
}

logic::Term Translation::WriteTerm(TermId root) const {
  std::vector<WriteFrame> frames;
  std::vector<logic::Term> results;
  frames.push_back({root});
  while (!frames.empty()) {
    WriteFrame& frame = frames.back();
    if (Terms::IsVariable(frame.term)) {
      results.push_back(logic::Term::Var(Terms::Number(frame.term)));
      frames.pop_back();
      continue;
    }
    const auto arguments = terms_.arguments(frame.term);
    if (frame.next < arguments.size()) {
      frames.push_back({arguments[frame.next++]});
      continue;
    }
    const logic::Term& name = sources_[terms_.head(frame.term)].term;
    frames.pop_back();
    results.push_back(arguments.empty()
                          ? name
                          : logic::Term::Compound(name.symbol(), Take(results, arguments.size())));
  }
  return results.back();
}

logic::Atom Translation::WriteAtom(const Literal& literal) const {
  if (literal.is_equation()) {
    return {equality_, {WriteTerm(literal.left), WriteTerm(literal.right)}};
  }
  std::vector<logic::Term> arguments;
  for (const TermId argument : terms_.arguments(literal.left)) {
    arguments.push_back(WriteTerm(argument));
  }
  return {sources_[terms_.head(literal.left)].term.symbol(), arguments};
}

logic::Clause Translation::Write(std::span<const Literal> literals) const {
  logic::Clause clause;
  std::uint32_t variables = 0;
  for (const Literal& literal : literals) {
    clause.literals.push_back({literal.positive, WriteAtom(literal)});
    std::vector<TermId> visits{literal.left, literal.right};
    while (!visits.empty()) {
      const TermId term = visits.back();
      visits.pop_back();
      if (Terms::IsVariable(term)) {
        variables = std::max(variables, Terms::Number(term) + 1);
      } else if (!terms_.is_ground(term)) {
        const auto arguments = terms_.arguments(term);
        visits.insert(visits.end(), arguments.begin(), arguments.end());
      }
    }
  }
  for (std::uint32_t i = 0; i < variables; ++i) {
    clause.variable_names.push_back(fmt::format("X{}", i));
  }
  return clause;
}

}  // namespace latchwork::pttp::saturation
