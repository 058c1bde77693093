// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_SITUATIONS_H_
#define LATCHWORK_PTTP_SITUATIONS_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <unordered_map>
#include <vector>

#include "reasoners/pttp/plans/ground_rules.h"
#include "reasoners/pttp/plans/situation_rules.h"
#include "reasoners/pttp/plans/state_graph.h"
#include "reasoners/pttp/search/meter.h"
#include "reasoners/pttp/terms/unifier.h"
#include "reasoners/pttp/terms/variant_table.h"
#include "reasoners/pttp/terms/word.h"

namespace latchwork::pttp {

/// The situations of one decision, told apart by what holds in them: of all that share a state,
/// one that the fewest actions lead to. A search asks it for situations in which a fluent holds,
/// nearest first, and for what holds in one that it was given.
class Situations {
 public:
  explicit Situations(const SituationRules& rules) : rules_(&rules), graph_(ground_) {}

  const SituationRules& rules() const { return *rules_; }
  GroundRules& ground() { return ground_; }

  /// Forgets everything; then initial situations and ground rules may be added.
  void Clear();
  /// What holds in the beginning. `situation`: a constant or a number.
  void AddInitially(Word situation, std::uint32_t atom);
  std::uint32_t NumberOfOrigin(Word situation);
  /// After all rules and facts.
  void Begin();

  /// A question for atoms of a fluent, told apart by all arguments but the situation. kNoEntry: its
  /// terms are too long.
  std::uint32_t Ask(PredicateId fluent, std::span<const Word> arguments);
  enum class Answer : std::uint8_t { kFound, kTooFar, kNone };
  struct Instance {
    std::uint32_t state = 0;
    std::uint32_t atom = 0;
  };
  /// The answers to a question in the order of their distance; those at `limit` actions or more are
  /// too far.
  Answer Find(std::uint32_t question, std::uint32_t index, std::uint32_t limit, Meter& meter,
              Instance& instance);
  /// The answers in one state: from the place of an atom on, which moves behind the one found.
  bool FindIn(std::uint32_t state, std::uint32_t question, std::uint32_t& place,
              Instance& instance) const;

  /// kNoState: not one of those here.
  std::uint32_t StateOf(Word situation) const;
  Word SituationOf(std::uint32_t state);
  std::uint32_t LengthOf(std::uint32_t state) const { return graph_.LengthOf(state); }
  const Word* ArgumentsOf(std::uint32_t atom) const { return ground_.atom(atom).arguments; }
  /// What an instance rests on.
  std::span<const std::size_t> AssumptionsOf(const Instance& instance);

 private:
  struct Origin {
    Word situation;
    std::uint32_t state;
    std::vector<std::uint32_t> atoms;
  };
  struct Question {
    std::vector<std::uint32_t> atoms;
    std::vector<Instance> answers;
    std::uint32_t next_state = 0;
  };

  void MatchAtoms(PredicateId fluent, std::span<const Word> arguments, Question& question);
  void Support(Instance instance);
  bool Fires(const GroundRule& rule, std::uint32_t state) const;

  const SituationRules* rules_;
  GroundRules ground_;
  StateGraph graph_;
  std::vector<Origin> origins_;
  VariantTable question_numbers_;
  std::deque<Question> questions_;
  std::size_t asked_ = 0;
  std::vector<Word> situations_;  ///< By state; 0: not made yet.
  std::unordered_map<Word, std::uint32_t> states_;
  Unifier matcher_{ground_.terms()};
  std::vector<Instance> supporting_;
  std::vector<std::size_t> assumptions_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_SITUATIONS_H_
