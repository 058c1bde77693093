// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/plans/fluent_queries.h"

#include <algorithm>

#include "reasoners/pttp/theory/literal_slots.h"

namespace latchwork::pttp {
namespace {

constexpr std::uint32_t kUnnumbered = 0xffffffffU;

class Maker {
 public:
  Maker(const SituationRules& rules, const FluentRule& rule, const std::vector<StandIns>& stand_ins,
        FluentQueries& made)
      : rules_(rules),
        rule_(rule),
        stand_ins_(stand_ins),
        made_(made),
        numbers_(rule.rule->slots, kUnnumbered) {}

  void Make() {
    made_.rule = &rule_;
    NumberSlots();
    MakeHead();
    for (const std::uint32_t index : rule_.fluents) {
      made_.body.push_back(WithoutSituation(rule_.rule->body[index]));
    }
    for (const std::uint32_t index : rule_.fluents) MakeQuery(index);
    if (rule_.fluents.empty()) MakeQuery(kUnnumbered);
  }

 private:
  bool IsFluent(std::size_t index) const {
    return std::find(rule_.fluents.begin(), rule_.fluents.end(), index) != rule_.fluents.end();
  }

  void NumberSlots() {
    const Contrapositive& rule = *rule_.rule;
    const auto number = [&](std::uint32_t slot) {
      if (numbers_[slot] == kUnnumbered) numbers_[slot] = made_.slots++;
    };
    for (std::size_t i = 0; i < rule.body.size(); ++i) {
      const CompiledLiteral& literal = rule.body[i];
      for (std::uint32_t j = 0; j < literal.arity; ++j) {
        if (IsFluent(i) && j == rules_.PositionOf(literal.predicate)) continue;
        VisitSlots(literal.arguments[j], number);
      }
    }
    made_.bound = made_.slots;
    for (const Word word : ArgumentsOf(rule.head)) VisitSlots(word, number);
  }

  Word Renumber(Word word) {
    if (TagOf(word) == Tag::kSlot) return SlotWord(numbers_[NumberOf(word)]);
    if (TagOf(word) != Tag::kTemplate) return word;
    Word result = 0;
    std::vector<std::pair<const Word*, Word*>> left = {{AddressOf(word), &result}};
    while (!left.empty()) {
      const auto [from, to] = left.back();
      left.pop_back();
      const std::size_t arity = ArityOf(from[0]);
      Word* block = made_.terms.Allocate(arity + 1);
      block[0] = from[0];
      *to = Tagged(Tag::kTemplate, block);
      for (std::size_t i = 1; i <= arity; ++i) {
        block[i] = from[i];
        if (TagOf(from[i]) == Tag::kSlot) block[i] = SlotWord(numbers_[NumberOf(from[i])]);
        if (TagOf(from[i]) == Tag::kTemplate) left.emplace_back(AddressOf(from[i]), block + i);
      }
    }
    return result;
  }

  std::vector<Word> WithoutSituation(const CompiledLiteral& literal) {
    std::vector<Word> arguments;
    for (std::uint32_t i = 0; i < literal.arity; ++i) {
      if (i != rules_.PositionOf(literal.predicate)) {
        arguments.push_back(Renumber(literal.arguments[i]));
      }
    }
    return arguments;
  }

  void MakeHead() {
    const CompiledLiteral& head = rule_.rule->head;
    made_.head = WithoutSituation(head);
    made_.about = head.arguments[rules_.PositionOf(head.predicate)];
    if (rule_.kind != FluentRule::Kind::kSuccessor) return;
    const Word* block = AddressOf(made_.about);
    made_.about = block[0];
    for (std::uint32_t i = 0; i < ArityOf(block[0]); ++i) {
      if (i != rules_.HoleOf(block[0])) made_.action.push_back(Renumber(block[i + 1]));
    }
  }

  void MakeQuery(std::uint32_t fresh) {
    Query& query = *made_.queries.emplace_back(std::make_unique<Query>());
    query.clause.slots = made_.bound;
    if (fresh != kUnnumbered) query.clause.body.push_back(StandIn(fresh, true));
    for (std::uint32_t i = 0; i < rule_.rule->body.size(); ++i) {
      if (i == fresh) continue;
      query.clause.body.push_back(IsFluent(i) ? StandIn(i, false) : Literal(i));
    }
  }

  CompiledLiteral Literal(std::uint32_t index) {
    CompiledLiteral literal = rule_.rule->body[index];
    Word* arguments = made_.terms.Allocate(literal.arity);
    for (std::uint32_t i = 0; i < literal.arity; ++i) {
      arguments[i] = Renumber(literal.arguments[i]);
    }
    literal.arguments = arguments;
    return literal;
  }

  CompiledLiteral StandIn(std::uint32_t index, bool fresh) {
    const PredicateId fluent = rule_.rule->body[index].predicate;
    const std::vector<Word> terms = WithoutSituation(rule_.rule->body[index]);
    Word* arguments = made_.terms.Allocate(terms.size());
    std::copy(terms.begin(), terms.end(), arguments);
    CompiledLiteral literal;
    literal.predicate = fresh ? stand_ins_[fluent].fresh : stand_ins_[fluent].all;
    literal.arity = static_cast<std::uint32_t>(terms.size());
    literal.arguments = arguments;
    return literal;
  }

  const SituationRules& rules_;
  const FluentRule& rule_;
  const std::vector<StandIns>& stand_ins_;
  FluentQueries& made_;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace

std::unique_ptr<FluentQueries> MakeFluentQueries(const SituationRules& rules,
                                                 const FluentRule& rule,
                                                 const std::vector<StandIns>& stand_ins) {
  auto made = std::make_unique<FluentQueries>();
  Maker(rules, rule, stand_ins, *made).Make();
  return made;
}

}  // namespace latchwork::pttp
