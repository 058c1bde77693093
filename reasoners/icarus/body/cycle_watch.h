// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_CYCLE_WATCH_H_
#define LATCHWORK_ICARUS_CYCLE_WATCH_H_

#include "reasoners/icarus/machine/event.h"
#include "reasoners/icarus/machine/fact_store.h"
#include "reasoners/icarus/machine/interpreter.h"

namespace latchwork::icarus {

/// Is told of the cycles of a layer, and of what happens in them.
class CycleWatch : public EventSink {
 public:
  /// A cycle begins; memory holds what the latches hold.
  virtual void OnBegin(const FactStore& memory) = 0;
  /// It has ended, and its acts have changed memory.
  virtual void OnEnd(const CycleResult& result, const FactStore& memory) = 0;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_CYCLE_WATCH_H_
