// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/terms/functors.h"

#include <bit>
#include <limits>

namespace latchwork::pttp {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

Word Box(Tag tag, Word bits, Arena& arena) {
  Word* cell = arena.Allocate(1);
  *cell = bits;
  return Tagged(tag, cell);
}

}  // namespace

Word IntegerWord(std::int64_t value, Arena& arena) {
  return Box(Tag::kInteger, std::bit_cast<Word>(value), arena);
}

Word RealWord(double value, Arena& arena) {
  return Box(Tag::kReal, std::bit_cast<Word>(value == 0.0 ? 0.0 : value), arena);
}

std::uint32_t Functors::Number(logic::Symbol symbol, std::size_t arity) {
  const auto fresh = static_cast<std::uint32_t>(functors_.size());
  std::uint32_t* place = nullptr;
  if (arity == 0) {
    if (symbol.index() >= constants_.size()) constants_.resize(symbol.index() + 1, kNone);
    place = &constants_[symbol.index()];
  } else {
    const std::uint64_t key = (std::uint64_t{symbol.index()} << 24U) ^ arity;
    place = &compounds_.try_emplace(key, kNone).first->second;
  }
  if (*place == kNone) {
    *place = fresh;
    functors_.push_back({symbol, static_cast<std::uint32_t>(arity),
                         arity == 0 ? std::nullopt : arithmetic_->FindFunction(symbol, arity)});
  }
  return *place;
}

Word Functors::Import(const logic::Term& term, Arena& arena) {
  using Kind = logic::Term::Kind;
  Word result = 0;
  tasks_.clear();
  tasks_.push_back({&term, &result});
  while (!tasks_.empty()) {
    const ImportTask task = tasks_.back();
    tasks_.pop_back();
    const logic::Term& source = *task.term;
    switch (source.kind()) {
      case Kind::kVariable:
        *task.place = SlotWord(source.variable());
        break;
      case Kind::kInteger:
        *task.place = IntegerWord(source.integer(), arena);
        break;
      case Kind::kReal:
        *task.place = RealWord(source.real(), arena);
        break;
      case Kind::kConstant:
        *task.place = ConstantWord(Number(source.symbol(), 0));
        break;
      case Kind::kCompound: {
        const auto arguments = source.arguments();
        Word* block = arena.Allocate(arguments.size() + 1);
        block[0] = Header(Number(source.symbol(), arguments.size()), arguments.size());
        *task.place = Tagged(source.is_ground() ? Tag::kCompound : Tag::kTemplate, block);
        for (std::size_t i = 0; i < arguments.size(); ++i) {
          tasks_.push_back({&arguments[i], block + 1 + i});
        }
        break;
      }
    }
  }
  return result;
}

namespace {

struct Visit {
  Word word;
  bool expanded;
};

logic::Term ExportVariable(Word word, std::vector<Word>& variables) {
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (variables[i] == word) return logic::Term::Var(static_cast<logic::Variable>(i));
  }
  variables.push_back(word);
  return logic::Term::Var(static_cast<logic::Variable>(variables.size() - 1));
}

}  // namespace

logic::Term Functors::Export(Word word, std::vector<Word>& variables) const {
  const auto atomic = [&](Word leaf) {
    switch (TagOf(leaf)) {
      case Tag::kInteger:
        return logic::Term::Integer(std::bit_cast<std::int64_t>(*AddressOf(leaf)));
      case Tag::kReal:
        return logic::Term::Real(std::bit_cast<double>(*AddressOf(leaf)));
      case Tag::kConstant:
        return logic::Term::Constant(functors_[NumberOf(leaf)].symbol);
      default:
        return ExportVariable(leaf, variables);
    }
  };
  word = Dereference(word);
  if (TagOf(word) != Tag::kCompound) return atomic(word);
  std::vector<Visit> visits{{word, false}};
  std::vector<logic::Term> done;
  while (!visits.empty()) {
    const Visit visit = visits.back();
    visits.pop_back();
    const Word current = Dereference(visit.word);
    if (TagOf(current) != Tag::kCompound) {
      done.push_back(atomic(current));
      continue;
    }
    const Word* block = AddressOf(current);
    const std::size_t arity = ArityOf(block[0]);
    if (!visit.expanded) {
      visits.push_back({current, true});
      for (std::size_t i = arity; i > 0; --i) visits.push_back({block[i], false});
      continue;
    }
    std::vector<logic::Term> arguments(done.end() - static_cast<std::ptrdiff_t>(arity), done.end());
    done.resize(done.size() - arity);
    done.push_back(
        logic::Term::Compound(functors_[NumberOf(block[0])].symbol, std::move(arguments)));
  }
  return std::move(done.back());
}

}  // namespace latchwork::pttp
