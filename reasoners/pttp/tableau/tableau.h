// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_TABLEAU_H_
#define LATCHWORK_PTTP_TABLEAU_TABLEAU_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "latchwork/logic/clause.h"
#include "reasoners/pttp/proofs/clause_instance.h"
#include "reasoners/pttp/strategies/strategy.h"
#include "reasoners/pttp/tableau/bindings.h"
#include "reasoners/pttp/tableau/grow_stack.h"
#include "reasoners/pttp/tableau/matrix.h"

namespace latchwork::pttp {

enum class TableauEnd : std::uint8_t {
  kClosed,     ///< A refutation was found.
  kSaturated,  ///< There is none: the search space of a complete strategy was exhausted.
  kGaveUp,     ///< The search space was exhausted, but the strategy leaves refutations out.
  kStopped,    ///< The caller had it stopped.
  kMemory,     ///< It would have needed more memory than it may use.
};

/// The connection tableau calculus (Letz and Stenz, "Model elimination and connection tableau
/// procedures", 2001) as an abstract machine: extension, reduction, regularity, lemmata, by
/// iterative deepening on the length of branches. Units, reductions, lemmata and ground clauses are
/// not charged. Nothing recurses, terms are shared, nothing is allocated once the stacks have
/// grown. Not to be used by two threads at once; different ones may share no Matrix.
class Tableau {
 public:
  /// `stop` is asked about every ten thousandth of a second of search.
  Tableau(Matrix& matrix, const Strategy& strategy, std::size_t memory_bytes,
          std::function<bool()> stop);

  TableauEnd Search();

  /// Extension and reduction steps that succeeded.
  std::uint64_t inferences() const { return inferences_; }
  std::uint32_t depth() const { return depth_; }
  /// After kClosed: the clause instances of the refutation, contradictory by propositional logic
  /// alone.
  std::vector<ClauseInstance> Refutation() const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;
  static constexpr std::uint64_t kPollPeriod = 4096;
  /// A bit by which most walks along a branch or through lemmata are found to be needless.
  static std::uint64_t MarkOf(std::uint32_t number) { return std::uint64_t{1} << (number & 63U); }
  /// Where the search goes on: at an open literal of a clause copy.
  struct Place {
    const MatrixLiteral* const* literal = nullptr;  ///< In the body of an entry.
    std::uint32_t frame = 0;
    std::uint32_t lemma = 0;  ///< The newest that holds there.
  };
  /// An open literal, as it was when the search came to it.
  struct Goal {
    const MatrixLiteral* literal = nullptr;
    Fingerprint print;
    std::uint32_t key = 0;
    std::uint32_t arguments = 0;  ///< Where they are in the bindings.
    std::uint32_t hash = 0;       ///< 0: it may have variables; then it says nothing.
  };
  /// The nearest ancestors of a goal with its predicate.
  struct Kin {
    std::uint32_t same = 0;      ///< And its sign.
    std::uint32_t opposite = 0;  ///< And the other one.
  };
  /// A goal that was extended, and the clause copy whose other literals are then to be solved. The
  /// goals of the frames that `next` leads to are its ancestors.
  struct Frame {
    Goal goal;
    Place next;
    std::uint64_t marks = 0;  ///< Of the predicates of the goal and its ancestors.
    std::uint32_t base = 0;
    std::uint32_t left = 0;  ///< How many steps may still follow each other below it.
    Kin kin;
    std::uint32_t height = 0;  ///< Choices that were there before the goal was called.
    std::uint32_t kept = 0;    ///< Choices that an exclusive cut keeps.
    std::uint32_t trail = 0;   ///< As it was when the goal was called.
    std::uint32_t fresh = 0;   ///< Variables from here on are younger than the goal.
  };
  /// A goal and what has not been tried with it.
  struct Choice {
    Goal goal;
    Place place;
    const Connection* connection = nullptr;  ///< The next to try; null: none.
    Kin kin;
    std::uint32_t ancestor = 0;  ///< The next to try, of those with the complement's predicate.
    std::uint32_t variables = 0;
    std::uint32_t trail = 0;
    std::uint32_t frames = 0;
    std::uint32_t steps = 0;
    std::uint32_t lemmata = 0;
  };
  /// By signed predicate, so that few lemmata of other predicates are looked at.
  using LemmaKinds = std::array<std::uint32_t, 8>;
  static std::size_t KindOf(const Goal& goal) { return goal.key % LemmaKinds{}.size(); }
  struct Lemma {
    Goal goal;
    std::uint32_t next = 0;  ///< The next older one of the same kind.
    LemmaKinds newest{};     ///< Of each kind, of this and all older ones.
  };
  struct Step {
    const Entry* entry = nullptr;
    std::uint32_t base = 0;
  };

  TableauEnd Run(const Entry& start);
  void Begin(const Entry& start);
  bool Advance();
  bool Call();
  bool CallConnections(Choice& choice, const Connection* end);
  bool Retry();
  bool TryReductions();
  bool TryConnections();
  bool TryEntry(const Choice& choice, const Entry& entry, std::uint32_t height);
  void Open(const Choice& choice, const Entry& entry, std::uint32_t base, std::uint32_t height);
  void SolvedAtOnce(const Choice& choice, std::uint32_t height);
  void Leave();
  bool Same(const Goal& earlier, const Goal& goal);
  Kin KinOf(const Goal& goal) const;
  bool IsIrregular(const Goal& goal, std::uint32_t same);
  bool IsLemma(const Goal& goal);
  /// The first connection from `from` on that the goal's functors allow; null: none.
  static const Connection* NextFitting(const Goal& goal, const Connection* from,
                                       const Connection* end);
  const Connection* EndOfConnections(const MatrixLiteral& literal) const;
  void Rewind(const Choice& choice);
  std::size_t bytes() const;
  ClauseInstance InstanceOf(const Step& step, std::vector<Cell>& variables) const;
  logic::Term Export(Cell cell, std::uint32_t base, std::vector<Cell>& variables) const;

  Matrix& matrix_;
  Strategy strategy_;
  std::size_t memory_bytes_;
  std::function<bool()> stop_;
  Bindings bindings_;
  GrowStack<Frame> frames_;
  GrowStack<Choice> choices_;
  GrowStack<Lemma> lemmata_;
  GrowStack<Step> steps_;
  Place place_{};
  std::uint32_t depth_ = 0;
  bool cut_off_ = false;
  bool pruned_ = false;
  std::uint64_t inferences_ = 0;
  std::uint64_t steps_taken_ = 0;
  std::uint64_t next_poll_ = kPollPeriod;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_TABLEAU_H_
