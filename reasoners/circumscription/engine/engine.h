// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_ENGINE_ENGINE_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_ENGINE_ENGINE_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "reasoners/circumscription/certificate/certificate.h"
#include "reasoners/circumscription/search/minimal_models.h"
#include "reasoners/circumscription/theory/compiled_theory.h"
#include "reasoners/circumscription/theory/ground_theory.h"

namespace latchwork::circumscription {

enum class Verdict : std::uint8_t { kYes, kNo, kUnknown };

/// What an answer rests on.
enum class Basis : std::uint8_t {
  kInconsistent,  ///< There is no model at all: everything follows, and nothing should be done.
  kCertificate,   ///< Propagation found the only minimal world.
  kUnique,        ///< Search found that there is one minimal world only.
  kAllMinimal,    ///< No minimal model speaks against it.
  kWitness,       ///< A minimal model does.
  kBudget,        ///< Not decided: the budget ran out.
};

std::string_view Name(Verdict verdict);
std::string_view Name(Basis basis);

struct Answer {
  Verdict verdict = Verdict::kUnknown;
  Basis basis = Basis::kBudget;
};

struct EngineOptions {
  bool use_certificate = true;
  int conflicts = -1;                ///< Of each SAT call; < 0: no limit.
  std::size_t calls = 1'000'000;     ///< SAT calls for one query.
  std::size_t max_asked = 1024;      ///< Literals that are decided together.
  std::size_t max_learnt = 200'000;  ///< Flip formulas; with more the search starts afresh.
  Spending* spending = nullptr;      ///< What SAT calls are charged to; outlives the engine.
};

struct EngineStatistics {
  std::size_t cycles = 0;
  std::size_t certified = 0;  ///< Cycles that the certificate closed.
  std::size_t sat_calls = 0;
  std::size_t learnt = 0;  ///< Flip formulas held now.
};

/// Exact prioritized circumscription of a ground theory whose fixed atoms get new values each
/// cycle. First the certificate; where it does not close, search for minimal models by support and
/// flip formulas, which stays valid over all cycles. The same sequence of calls gives the same
/// answers. Not thread-safe.
class Engine {
 public:
  explicit Engine(const GroundTheory& theory, const EngineOptions& options = {});
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  ~Engine() = default;

  /// Starts a cycle. `latches`: literals over fixed atoms (precondition); fixed atoms without a
  /// latch may be either. Returns whether the certificate closed.
  bool SetLatches(std::span<const Literal> latches);

  /// Whether every minimal model satisfies the disjunction (cautious).
  Answer EntailsAlways(std::span<const Literal> clause);
  /// Whether some minimal model satisfies the conjunction (brave).
  Answer HoldsSomewhere(std::span<const Literal> conjunction);
  /// A minimal model in which `literal` is false. Nothing: it holds in all, or the budget ran out.
  std::optional<Model> CounterModel(Literal literal);
  /// Whether the theory has no model under the latches.
  Answer IsInconsistent();

  EngineStatistics statistics() const;

 private:
  /// What search knows of the present cycle.
  enum class World : std::uint8_t {
    kUnexplored,
    kInconsistent,
    kSome,  ///< A minimal model is known; whether there are others was not needed yet.
    kUnique,
    kPlural,
    kUndecided,
  };

  void Explore();
  void ExploreOther();
  /// Descends to a minimal model; false: the budget ran out.
  bool Descend(Model& model);
  Answer FromCertificate(std::span<const Literal> clause);
  Answer FromUnique(std::span<const Literal> clause);
  Answer Search(std::span<const Literal> clause);
  bool IsRefuted(std::span<const Literal> clause) const;
  /// Decides all literals asked for so far, in this cycle or before, together.
  void Settle();
  Answer Refute(std::span<const Literal> clause);
  Answer VaryWorld(const Model& model, Basis basis);
  bool KnowsFixed() const;
  bool IsPositive(std::span<const Literal> clause) const;

  CompiledTheory theory_;
  EngineOptions options_;
  Certificate certificate_;
  std::unique_ptr<MinimalModels> search_;
  bool certified_ = false;
  World world_ = World::kUnexplored;
  std::vector<Literal> latches_;
  std::vector<Model> minimal_;     ///< Found in this cycle.
  std::vector<Literal> negation_;  ///< Of the query.
  std::vector<Literal> asked_;     ///< Sorted: the queries of one literal that search got so far.
  std::vector<Literal> agreed_;    ///< Sorted: those that hold in all minimal models.
  bool settled_ = false;           ///< agreed_ is of this cycle.
  EngineStatistics statistics_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_ENGINE_ENGINE_H_
