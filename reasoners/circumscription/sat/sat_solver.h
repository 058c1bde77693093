// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_SAT_SAT_SOLVER_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_SAT_SAT_SOLVER_H_

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>

namespace latchwork::circumscription {

class Spending;

enum class SatResult : std::uint8_t { kSatisfiable, kUnsatisfiable, kLimit };

/// An incremental SAT solver: clauses stay, assumptions and the one-shot clause hold for the next
/// call of Solve. The same calls give the same results and models. Not thread-safe.
/// Backend: CaDiCaL (Biere, Fazekas, Fleury, Heisinger 2020).
class SatSolver {
 public:
  using Literal = std::int32_t;

  /// Variables 1 .. `variables` are there from the start.
  explicit SatSolver(int variables);
  SatSolver(const SatSolver&) = delete;
  SatSolver& operator=(const SatSolver&) = delete;
  ~SatSolver();
  SatSolver(SatSolver&&) noexcept;
  SatSolver& operator=(SatSolver&&) noexcept;

  int NewVariable() { return ++variables_; }
  void Add(std::span<const Literal> clause);
  void Add(std::initializer_list<Literal> clause) { Add(std::span(clause.begin(), clause.size())); }

  void Assume(Literal literal);
  void Assume(std::span<const Literal> literals) {
    for (const Literal literal : literals) Assume(literal);
  }
  /// A clause for the next call only; at most one, not empty.
  void Once(std::span<const Literal> clause);
  /// From now on each call, and each decision within one, is a step of `spending`, which outlives
  /// the solver; where it is spent, calls end with kLimit.
  void Charge(Spending& spending);
  /// `conflicts` < 0: without a limit.
  SatResult Solve(int conflicts = -1);

  /// After kSatisfiable: whether `literal` holds.
  bool Value(Literal literal);
  /// After kUnsatisfiable: whether the assumption was needed.
  bool Failed(Literal literal);

 private:
  struct Backend;
  std::unique_ptr<Backend> backend_;
  int variables_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_SAT_SAT_SOLVER_H_
