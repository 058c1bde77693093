// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/plans/situation_rules.h"

#include <algorithm>
#include <utility>

#include "reasoners/pttp/theory/literal_slots.h"

namespace latchwork::pttp {
namespace {

std::uint32_t KeyOf(const CompiledLiteral& literal) {
  return Signed(literal.predicate, literal.positive);
}

bool IsAtomic(Word word) {
  const Tag tag = TagOf(word);
  return tag == Tag::kConstant || tag == Tag::kInteger || tag == Tag::kReal;
}

std::optional<std::uint32_t> PlaceOf(const CompiledLiteral& literal, std::uint32_t slot) {
  for (std::uint32_t i = 0; i < literal.arity; ++i) {
    if (literal.arguments[i] == SlotWord(slot)) return i;
  }
  return std::nullopt;
}

}  // namespace

/// Guesses which arguments are situations from rules that make terms of them, then drops every
/// predicate with a rule that does not fit until all do.
class SituationRules::Finder {
 public:
  Finder(SituationRules& found, const Reach& reach) : found_(found), reach_(reach) {}

  void Find() {
    found_.positions_.assign(reach_.rules.size() / 2, std::nullopt);
    ForEachRule([&](const Contrapositive& rule) { Seed(rule); });
    if (found_.holes_.empty()) return;
    for (bool spread = true; spread;) {
      spread = false;
      ForEachRule([&](const Contrapositive& rule) { spread = Spread(rule) || spread; });
    }
    while (DropMisfits()) {
    }
    Collect();
  }

 private:
  template <typename Visit>
  void ForEachRule(Visit&& visit) const {
    for (std::uint32_t key = 1; key < reach_.rules.size(); key += 2) {
      for (const Contrapositive* rule : reach_.rules[key]) visit(*rule);
    }
  }
  bool MayBeFluent(const CompiledLiteral& literal) const {
    return literal.positive &&
           (*found_.predicates_)[literal.predicate].kind == PredicateKind::kOrdinary;
  }

  bool Leads(std::uint32_t from, std::uint32_t to) const {
    std::vector<bool> seen(reach_.rules.size(), false);
    std::vector<std::uint32_t> open = {from};
    while (!open.empty()) {
      const std::uint32_t key = open.back();
      open.pop_back();
      if (key == to) return true;
      for (const Contrapositive* rule : reach_.rules[key]) {
        for (const CompiledLiteral& literal : rule->body) {
          if (seen[KeyOf(literal)]) continue;
          seen[KeyOf(literal)] = true;
          open.push_back(KeyOf(literal));
        }
      }
    }
    return false;
  }

  bool SetPosition(PredicateId predicate, std::uint32_t position) {
    auto& known = found_.positions_[predicate];
    if (known) return false;
    known = position;
    return true;
  }

  /// p(.., f(.., S, ..), ..) from q(.., S, ..), where q can need p: S is a situation.
  void Seed(const Contrapositive& rule) {
    for (std::uint32_t i = 0; i < rule.head.arity; ++i) {
      const Word made = rule.head.arguments[i];
      if (TagOf(made) != Tag::kTemplate) continue;
      const Word* block = AddressOf(made);
      for (std::uint32_t j = 0; j < ArityOf(block[0]); ++j) {
        if (TagOf(block[j + 1]) != Tag::kSlot) continue;
        for (const CompiledLiteral& literal : rule.body) {
          const auto place = PlaceOf(literal, NumberOf(block[j + 1]));
          if (!place || !MayBeFluent(literal) || !Leads(KeyOf(literal), KeyOf(rule.head))) continue;
          SetPosition(rule.head.predicate, i);
          SetPosition(literal.predicate, *place);
          if (!found_.HoleOf(block[0])) found_.holes_.push_back({block[0], j});
        }
      }
    }
  }

  /// The slot of the situation that a rule's body may be about.
  std::optional<std::uint32_t> SituationSlot(const Contrapositive& rule) const {
    const Word word = rule.head.arguments[found_.PositionOf(rule.head.predicate)];
    if (TagOf(word) == Tag::kSlot) return NumberOf(word);
    if (TagOf(word) != Tag::kTemplate) return std::nullopt;
    const Word* block = AddressOf(word);
    const auto hole = found_.HoleOf(block[0]);
    if (!hole || TagOf(block[*hole + 1]) != Tag::kSlot) return std::nullopt;
    return NumberOf(block[*hole + 1]);
  }

  /// What shares a situation with a fluent is guessed to be a fluent.
  bool Spread(const Contrapositive& rule) {
    bool spread = !found_.IsFluent(rule.head.predicate) && SpreadToHead(rule);
    std::optional<std::uint32_t> situation;
    if (found_.IsFluent(rule.head.predicate)) {
      situation = SituationSlot(rule);
    } else {
      situation = FluentSlot(rule);
    }
    if (!situation) return spread;
    for (const CompiledLiteral& literal : rule.body) {
      const auto place = PlaceOf(literal, *situation);
      if (!place || !MayBeFluent(literal)) continue;
      spread = SetPosition(literal.predicate, *place) || spread;
    }
    return spread;
  }

  /// The situation of the first fluent of a body.
  std::optional<std::uint32_t> FluentSlot(const Contrapositive& rule) const {
    for (const CompiledLiteral& literal : rule.body) {
      if (!literal.positive || !found_.IsFluent(literal.predicate)) continue;
      const Word word = literal.arguments[found_.PositionOf(literal.predicate)];
      if (TagOf(word) == Tag::kSlot) return NumberOf(word);
    }
    return std::nullopt;
  }

  bool SpreadToHead(const Contrapositive& rule) {
    const auto situation = FluentSlot(rule);
    for (std::uint32_t i = 0; i < rule.head.arity; ++i) {
      Word word = rule.head.arguments[i];
      if (TagOf(word) == Tag::kTemplate) {
        const Word* block = AddressOf(word);
        const auto hole = found_.HoleOf(block[0]);
        if (!hole) continue;
        word = block[*hole + 1];
      } else if (!situation) {
        continue;
      }
      if (TagOf(word) != Tag::kSlot || (situation && NumberOf(word) != *situation)) continue;
      return SetPosition(rule.head.predicate, i);
    }
    return false;
  }

  bool DropMisfits() {
    MarkLeading();
    bool dropped = false;
    ForEachRule([&](const Contrapositive& rule) {
      if (!found_.IsFluent(rule.head.predicate) || Fit(rule)) return;
      found_.positions_[rule.head.predicate].reset();
      dropped = true;
    });
    return dropped;
  }

  /// Which predicates need fluents.
  void MarkLeading() {
    leads_.assign(reach_.rules.size(), false);
    for (bool changed = true; changed;) {
      changed = false;
      ForEachRule([&](const Contrapositive& rule) {
        const std::uint32_t key = KeyOf(rule.head);
        if (leads_[key]) return;
        leads_[key] = std::any_of(rule.body.begin(), rule.body.end(), [&](const auto& literal) {
          return found_.IsFluent(literal.predicate) || leads_[KeyOf(literal)];
        });
        changed = changed || leads_[key];
      });
    }
  }

  std::optional<FluentRule> Fit(const Contrapositive& rule) const {
    const std::uint32_t position = found_.PositionOf(rule.head.predicate);
    const Word about = rule.head.arguments[position];
    FluentRule fluent;
    fluent.rule = &rule;
    const auto situation = SituationSlot(rule);
    if (IsAtomic(about)) {
      fluent.kind = FluentRule::Kind::kInitial;
    } else if (!situation || Contains(rule.head, *situation, position)) {
      return std::nullopt;
    } else {
      const bool is_slot = TagOf(about) == Tag::kSlot;
      fluent.kind = is_slot ? FluentRule::Kind::kWithin : FluentRule::Kind::kSuccessor;
    }
    if (!FitBody(situation, fluent) || !FitSlots(situation, fluent)) return std::nullopt;
    return fluent;
  }

  bool FitBody(std::optional<std::uint32_t> situation, FluentRule& fluent) const {
    for (std::uint32_t i = 0; i < fluent.rule->body.size(); ++i) {
      const CompiledLiteral& literal = fluent.rule->body[i];
      if (!found_.IsFluent(literal.predicate)) {
        if (leads_[KeyOf(literal)] || (situation && Contains(literal, *situation))) return false;
        continue;
      }
      const std::uint32_t position = found_.PositionOf(literal.predicate);
      if (!literal.positive || !situation || literal.arguments[position] != SlotWord(*situation) ||
          Contains(literal, *situation, position) || literal.arithmetic != 0) {
        return false;
      }
      fluent.fluents.push_back(i);
      fluent.frame = fluent.frame || SaysTheSame(literal, fluent.rule->head, position);
    }
    return true;
  }

  static bool SaysTheSame(const CompiledLiteral& literal, const CompiledLiteral& head,
                          std::uint32_t position) {
    if (literal.predicate != head.predicate) return false;
    for (std::uint32_t i = 0; i < head.arity; ++i) {
      if (i != position && literal.arguments[i] != head.arguments[i]) return false;
    }
    return true;
  }

  /// Everything that is concluded must be ground; only frame rules may speak of any action.
  static bool FitSlots(std::optional<std::uint32_t> situation, const FluentRule& fluent) {
    const Contrapositive& rule = *fluent.rule;
    bool bound = true;
    const auto check = [&](std::uint32_t slot) {
      bound = bound && std::any_of(rule.body.begin(), rule.body.end(),
                                   [&](const auto& literal) { return Contains(literal, slot); });
    };
    std::uint32_t times = 0;
    for (const Word word : ArgumentsOf(rule.head)) {
      const bool is_action =
          fluent.kind == FluentRule::Kind::kSuccessor && situation && Contains(word, *situation);
      VisitSlots(word, [&](std::uint32_t slot) {
        if (slot == situation) {
          ++times;
        } else if (!is_action || !fluent.frame) {
          check(slot);
        }
      });
    }
    return bound && times <= 1;
  }

  void Collect() {
    for (PredicateId predicate = 0; predicate < found_.positions_.size(); ++predicate) {
      if (found_.IsFluent(predicate)) found_.fluents_.push_back(predicate);
    }
    ForEachRule([&](const Contrapositive& rule) {
      if (!found_.IsFluent(rule.head.predicate)) return;
      found_.rules_.push_back(*Fit(rule));
      const FluentRule& fluent = found_.rules_.back();
      found_.fits_ = found_.fits_ || fluent.kind == FluentRule::Kind::kSuccessor;
      found_.use_.joins = found_.use_.joins || fluent.fluents.size() > 1;
    });
  }

  SituationRules& found_;
  const Reach& reach_;
  std::vector<bool> leads_;  ///< By signed predicate.
};

SituationRules::SituationRules(const Predicates& predicates, const Reach& reach)
    : predicates_(&predicates) {
  if (!reach.recursive || !reach.reduction_free) return;
  Finder(*this, reach).Find();
  if (!fits_) return;
  ordered_ = reach;
  Order();
}

std::optional<std::uint32_t> SituationRules::HoleOf(Word header) const {
  for (const Hole& hole : holes_) {
    if (hole.header == header) return hole.argument;
  }
  return std::nullopt;
}

void SituationRules::Order() {
  for (auto& rules : ordered_.rules) {
    for (const Contrapositive*& rule : rules) {
      if (IsFluent(rule->head.predicate)) continue;
      if (!AddUse(*rule, use_)) continue;
      if (auto better = Reorder(*rule)) rule = &reordered_.emplace_back(std::move(*better));
      NoteHarmless(*rule);
    }
  }
  std::sort(harmless_.begin(), harmless_.end());
}

SituationUse SituationRules::UseOf(const Contrapositive& start) const {
  SituationUse use = use_;
  AddUse(start, use);
  return use;
}

bool SituationRules::IsChoice(const CompiledLiteral* literal) const {
  return !std::binary_search(harmless_.begin(), harmless_.end(), literal);
}

/// True when the body looks for a situation.
bool SituationRules::AddUse(const Contrapositive& body, SituationUse& use) const {
  std::optional<std::uint32_t> situation;
  std::size_t fluents = 0;
  for (std::size_t i = 0; i < body.body.size(); ++i) {
    const CompiledLiteral& literal = body.body[i];
    if (!literal.positive || !IsFluent(literal.predicate)) {
      use.clean = use.clean && !(situation && Contains(literal, *situation));
      continue;
    }
    const Word word = literal.arguments[PositionOf(literal.predicate)];
    if (IsAtomic(word)) continue;
    if (TagOf(word) != Tag::kSlot || (situation && *situation != NumberOf(word))) {
      use.blocked = true;
      continue;
    }
    ++fluents;
    if (situation) continue;
    situation = NumberOf(word);
    for (std::size_t j = 0; j < i; ++j) {
      use.blocked = use.blocked || Contains(body.body[j], *situation);
    }
  }
  if (!situation) return false;
  use.plans = true;
  use.joins = use.joins || fluents > 1;
  use.clean = use.clean && body.has_head && !Contains(body.head, *situation);
  for (const CompiledLiteral& literal : body.body) {
    if (!IsFluent(literal.predicate)) continue;
    use.clean = use.clean && !Contains(literal, *situation, PositionOf(literal.predicate));
  }
  return true;
}

/// Literals that test what the fluents bind move before them; the others stay behind.
std::optional<Contrapositive> SituationRules::Reorder(const Contrapositive& rule) const {
  const auto is_fluent = [&](const CompiledLiteral& literal) {
    return literal.positive && IsFluent(literal.predicate);
  };
  std::vector<bool> known(rule.slots, false);
  const auto learn = [&](const CompiledLiteral& literal) {
    for (const Word word : ArgumentsOf(literal)) {
      VisitSlots(word, [&](std::uint32_t slot) { known[slot] = true; });
    }
  };
  std::vector<bool> is_situation(rule.slots, false);
  for (const CompiledLiteral& literal : rule.body) {
    if (!is_fluent(literal)) continue;
    learn(literal);
    const Word word = literal.arguments[PositionOf(literal.predicate)];
    if (TagOf(word) == Tag::kSlot) is_situation[NumberOf(word)] = true;
  }
  std::vector<std::uint32_t> before;
  std::vector<std::uint32_t> fluents;
  std::vector<std::uint32_t> after;
  for (std::uint32_t i = 0; i < rule.body.size(); ++i) {
    const CompiledLiteral& literal = rule.body[i];
    bool tests = true;
    for (const Word word : ArgumentsOf(literal)) {
      VisitSlots(word,
                 [&](std::uint32_t slot) { tests = tests && known[slot] && !is_situation[slot]; });
    }
    if (is_fluent(literal)) {
      fluents.push_back(i);
    } else if (tests || fluents.empty()) {
      before.push_back(i);
      learn(literal);
    } else {
      after.push_back(i);
    }
  }
  before.insert(before.end(), fluents.begin(), fluents.end());
  before.insert(before.end(), after.begin(), after.end());
  if (std::is_sorted(before.begin(), before.end())) return std::nullopt;
  Contrapositive better = rule;
  better.eager = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    better.body[i] = rule.body[before[i]];
    if (i < 64 && before[i] < 64) better.eager |= ((rule.eager >> before[i]) & 1U) << i;
  }
  return better;
}

void SituationRules::NoteHarmless(const Contrapositive& rule) {
  SituationUse use;
  AddUse(rule, use);
  std::vector<const CompiledLiteral*> fluents;
  for (const CompiledLiteral& literal : rule.body) {
    if (literal.positive && IsFluent(literal.predicate)) fluents.push_back(&literal);
  }
  // Only the last one may have seen all fluents agree; then the choice is made.
  if (!use.clean) fluents.pop_back();
  harmless_.insert(harmless_.end(), fluents.begin(), fluents.end());
}

}  // namespace latchwork::pttp
