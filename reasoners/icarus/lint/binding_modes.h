// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_BINDING_MODES_H_
#define LATCHWORK_ICARUS_BINDING_MODES_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/lint/binding_trace.h"

namespace latchwork::icarus {

/// What the skills of a program bind in each mode in which they may be called: a fixpoint, begun
/// with skills that are never True and computed for the modes that are asked for.
class BindingModes final : private BindingListener {
 public:
  explicit BindingModes(const Program& program) : program_(program), trace_(program, *this) {}

  /// Where that gets too expensive: whatever is called binds all.
  Exit Of(const Mode& mode);
  bool is_known() const { return is_known_; }

 private:
  struct Entry {
    Exit exit;
    std::vector<std::size_t> callers;
    bool waits = true;
  };

  Exit Unknown(std::uint32_t skill) const;
  std::size_t Enter(Mode mode);
  void Update(std::size_t index);
  Exit Call(Mode mode, const Clause& clause) override;
  void Missing(const Term&, const Need&, const Bindings&) override {}

  const Program& program_;
  BindingTrace trace_;
  std::map<Mode, std::size_t> indices_;
  std::vector<Mode> modes_;
  std::vector<Entry> entries_;
  std::deque<std::size_t> waiting_;
  std::size_t current_ = 0;
  std::size_t calls_ = 0;
  bool is_known_ = true;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_BINDING_MODES_H_
