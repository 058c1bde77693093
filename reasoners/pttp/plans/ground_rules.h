// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_GROUND_RULES_H_
#define LATCHWORK_PTTP_GROUND_RULES_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/pttp/plans/situation_rules.h"
#include "reasoners/pttp/terms/arena.h"
#include "reasoners/pttp/terms/row_set.h"
#include "reasoners/pttp/terms/term_copier.h"
#include "reasoners/pttp/terms/unifier.h"
#include "reasoners/pttp/terms/variant_table.h"
#include "reasoners/pttp/terms/word.h"
#include "reasoners/pttp/theory/predicates.h"

namespace latchwork::pttp {

inline constexpr std::uint32_t kNoAction = 0xffffffffU;

/// An instance of a fluent rule whose other literals hold: what remains are numbers of atoms
/// (fluents without their situation) and of an action (a situation term without the one before).
struct GroundRule {
  FluentRule::Kind kind = FluentRule::Kind::kInitial;
  bool frame = false;
  std::uint32_t head = 0;
  std::uint32_t action = kNoAction;
  std::uint32_t body = 0;  ///< Where its atoms start.
  std::uint32_t size = 0;
  std::uint32_t assumptions = 0;  ///< Where they start.
  std::uint32_t assumed = 0;
};

/// The instances of a theory's fluent rules that can matter from given initial situations.
class GroundRules {
 public:
  static constexpr std::size_t kMostAtoms = std::size_t{1} << 14U;
  static constexpr std::size_t kMostRules = std::size_t{1} << 18U;

  void Clear();
  bool too_many() const { return atoms_.size() > kMostAtoms || rules_.size() > kMostRules; }

  struct Atom {
    PredicateId predicate = 0;
    const Word* arguments = nullptr;  ///< All but the situation.
  };
  struct Entered {
    std::uint32_t number = 0;
    bool added = false;
    bool ground = true;
  };
  /// Numbers an atom; its terms are copied when it is new.
  Entered EnterAtom(PredicateId predicate, std::span<const Word> arguments);
  std::size_t atoms() const { return atoms_.size(); }
  const Atom& atom(std::uint32_t number) const { return atoms_[number]; }
  std::span<const std::uint32_t> AtomsOf(PredicateId predicate) const {
    if (predicate >= by_predicate_.size()) return {};
    return by_predicate_[predicate];
  }

  struct Action {
    Word header = 0;
    const Word* arguments = nullptr;  ///< All but the situation before.
    bool ground = true;               ///< Else it stands for all its instances.
  };
  Entered EnterAction(Word header, std::span<const Word> arguments);
  std::size_t actions() const { return actions_.size(); }
  const Action& action(std::uint32_t number) const { return actions_[number]; }
  /// Whether one action is an instance of the other.
  bool IsInstance(std::uint32_t action, std::uint32_t of);

  /// Nothing happens when it is known.
  void AddRule(GroundRule rule, std::span<const std::uint32_t> body,
               std::span<const std::size_t> assumptions);
  const std::vector<GroundRule>& rules() const { return rules_; }
  std::span<const std::uint32_t> BodyOf(const GroundRule& rule) const {
    return {bodies_.data() + rule.body, rule.size};
  }
  std::span<const std::size_t> AssumptionsOf(const GroundRule& rule) const {
    return {assumptions_.data() + rule.assumptions, rule.assumed};
  }
  bool assumes() const { return !assumptions_.empty(); }
  Arena& terms() { return terms_; }
  Word Copy(Word term) { return copier_.Copy(term, terms_); }

 private:
  const Word* Copy(std::span<const Word> terms);

  Arena terms_;
  TermCopier copier_;
  Unifier matcher_{terms_};
  VariantTable atom_numbers_;
  VariantTable action_numbers_;
  std::vector<Atom> atoms_;
  std::vector<Action> actions_;
  std::vector<std::vector<std::uint32_t>> by_predicate_;
  std::vector<GroundRule> rules_;
  std::vector<std::uint32_t> bodies_;
  std::vector<std::size_t> assumptions_;
  RowSet known_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_GROUND_RULES_H_
