// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EVALUATION_INSTANCE_SINK_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EVALUATION_INSTANCE_SINK_H_

#include <cstddef>
#include <span>

#include "reasoners/circumscription/evaluation/fact_table.h"
#include "reasoners/circumscription/theory/ground_theory.h"

namespace latchwork::circumscription {

/// Takes what an evaluation finds whose facts are those that may hold.
class InstanceSink {
 public:
  virtual ~InstanceSink() = default;
  virtual Atom AtomOf(std::size_t relation, std::span<const Value> cells) = 0;
  /// An instance of a clause without its literals that are decided by the body alone.
  virtual void Instance(std::size_t clause, std::span<const Literal> literals) = 0;
  /// A fact that a latch or an attachment gives.
  virtual void Give(std::size_t relation, std::span<const Value> cells) = 0;
  /// Whether all literals hold in every minimal model of the instances so far.
  virtual bool IsCertain(std::span<const Literal> literals) = 0;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EVALUATION_INSTANCE_SINK_H_
