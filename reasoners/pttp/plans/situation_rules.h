// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SITUATION_RULES_H_
#define LATCHWORK_PTTP_SITUATION_RULES_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "reasoners/pttp/theory/predicates.h"
#include "reasoners/pttp/theory/program.h"
#include "reasoners/pttp/theory/reach.h"

namespace latchwork::pttp {

/// A rule that concludes a fluent: something that holds in a situation.
struct FluentRule {
  enum class Kind : std::uint8_t {
    kInitial,    ///< About a situation that no action led to; its body is about none.
    kWithin,     ///< About the situation that its body is about.
    kSuccessor,  ///< About the situation after an action; its body is about the one before.
  };
  const Contrapositive* rule = nullptr;
  Kind kind = Kind::kInitial;
  bool frame = false;                  ///< It concludes what a fluent of its body says.
  std::vector<std::uint32_t> fluents;  ///< Which body literals are fluents.
};

/// How the bodies that are about no situation of their own ask for fluents.
struct SituationUse {
  bool plans = false;    ///< One asks for a fluent in a situation that nothing binds before.
  bool joins = false;    ///< Fluents are needed together, here or in the rules.
  bool clean = true;     ///< Whatever situation is found, nothing but the fluents depends on it.
  bool blocked = false;  ///< A situation may be given in part.
};

/// Finds out whether rules are about situations, so that states may stand for them: fluents have
/// one argument for the situation; a rule about what holds after an action needs fluents of the
/// situation before and nothing else of it (successor rules and frame rules, as in Reiter 1991).
/// Then what holds after an action is a function of the action and of what held before.
class SituationRules {
 public:
  SituationRules(const Predicates& predicates, const Reach& reach);

  bool fits() const { return fits_; }
  bool IsFluent(PredicateId predicate) const {
    return predicate < positions_.size() && positions_[predicate].has_value();
  }
  /// Which argument of a fluent is the situation.
  std::uint32_t PositionOf(PredicateId predicate) const { return *positions_[predicate]; }
  const std::vector<PredicateId>& fluents() const { return fluents_; }
  const std::vector<FluentRule>& rules() const { return rules_; }
  /// Which argument of a successor situation is the one before, by the header of the term.
  std::optional<std::uint32_t> HoleOf(Word header) const;

  SituationUse UseOf(const Contrapositive& start) const;
  /// The rules, with bodies that ask for situations put in order: what chooses among fluents first,
  /// what looks at the situation last.
  const Reach& reach() const { return ordered_; }
  /// Whether the choice of the situation that solves this literal may matter to what follows.
  bool IsChoice(const CompiledLiteral* literal) const;

 private:
  class Finder;

  void Order();
  bool AddUse(const Contrapositive& body, SituationUse& use) const;
  std::optional<Contrapositive> Reorder(const Contrapositive& rule) const;
  void NoteHarmless(const Contrapositive& rule);

  const Predicates* predicates_;
  bool fits_ = false;
  std::vector<std::optional<std::uint32_t>> positions_;  ///< By predicate.
  std::vector<PredicateId> fluents_;
  struct Hole {
    Word header;
    std::uint32_t argument;
  };
  std::vector<Hole> holes_;
  std::vector<FluentRule> rules_;
  SituationUse use_;  ///< Of all rules that are not about situations.
  Reach ordered_;
  std::deque<Contrapositive> reordered_;
  std::vector<const CompiledLiteral*> harmless_;  ///< Sorted.
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_SITUATION_RULES_H_
