// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/sat/sat_solver.h"

#include <cadical.hpp>

#include "reasoners/circumscription/evaluation/spending.h"

namespace latchwork::circumscription {
namespace {

// What IPASIR solvers return.
constexpr int kSatisfiableCode = 10;
constexpr int kUnsatisfiableCode = 20;

/// The backend asks it after each propagation without a conflict, and within its preparations.
class Meter final : public CaDiCaL::Terminator {
 public:
  explicit Meter(Spending& spending) : spending_(spending) {}

  bool terminate() override {
    spending_.Step();
    return spending_.is_spent();
  }

 private:
  Spending& spending_;
};

}  // namespace

struct SatSolver::Backend {
  std::unique_ptr<Meter> meter;  // Outlives the solver, which points at it.
  CaDiCaL::Solver solver;
};

SatSolver::SatSolver(int variables) : backend_(std::make_unique<Backend>()), variables_(variables) {
  CaDiCaL::Solver& solver = backend_->solver;
  solver.set("quiet", 1);
  // Models with few true atoms are near the minimal ones.
  solver.set("phase", 0);
  solver.set("forcephase", 0);
  // Most calls have a model: the search goes on from the best assignment so far.
  solver.set("target", 2);
  // Short calls, many of them: what prepares for long ones costs more than it saves.
  solver.set("lucky", 0);
  solver.set("walk", 0);
  solver.set("elim", 0);
  // Each step is counted, so that what is spent does not depend on how steps fall between polls.
  solver.set("terminateint", 0);
  solver.reserve(variables);
}

SatSolver::~SatSolver() = default;
SatSolver::SatSolver(SatSolver&&) noexcept = default;
SatSolver& SatSolver::operator=(SatSolver&&) noexcept = default;

void SatSolver::Add(std::span<const Literal> clause) {
  for (const Literal literal : clause) backend_->solver.add(literal);
  backend_->solver.add(0);
}

void SatSolver::Assume(Literal literal) { backend_->solver.assume(literal); }

void SatSolver::Once(std::span<const Literal> clause) {
  for (const Literal literal : clause) backend_->solver.constrain(literal);
  backend_->solver.constrain(0);
}

void SatSolver::Charge(Spending& spending) {
  backend_->meter = std::make_unique<Meter>(spending);
  backend_->solver.connect_terminator(backend_->meter.get());
}

SatResult SatSolver::Solve(int conflicts) {
  CaDiCaL::Solver& solver = backend_->solver;
  if (conflicts >= 0) solver.limit("conflicts", conflicts);
  const bool is_spent = backend_->meter && backend_->meter->terminate();
  const int result = is_spent ? 0 : solver.solve();
  if (result == kSatisfiableCode) return SatResult::kSatisfiable;
  if (result == kUnsatisfiableCode) return SatResult::kUnsatisfiable;
  // The backend keeps for the next call what was meant for this one.
  solver.reset_assumptions();
  solver.reset_constraint();
  return SatResult::kLimit;
}

bool SatSolver::Value(Literal literal) { return backend_->solver.val(literal) > 0; }

bool SatSolver::Failed(Literal literal) { return backend_->solver.failed(literal); }

}  // namespace latchwork::circumscription
