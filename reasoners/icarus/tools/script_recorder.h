// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_SCRIPT_RECORDER_H_
#define LATCHWORK_ICARUS_SCRIPT_RECORDER_H_

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "reasoners/icarus/body/cycle_watch.h"
#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/value.h"

namespace latchwork::icarus {

/// The items of a fact.
using FactText = std::vector<std::string>;

/// Which order of facts matters: that of the facts of the same head and length, or of all.
enum class FactOrder : std::uint8_t { kOfHead, kOfAll };
/// That of all where a match may be with facts of any head.
FactOrder OrderSeenBy(const Program& program);

/// Items of a script that make memory hold the facts of `after` when it holds those of `before`, in
/// their order as far as it matters. Each list has a fact once.
std::vector<std::string> MemoryChanges(const std::vector<FactText>& before,
                                       const std::vector<FactText>& after, FactOrder order);

/// Writes down the cycles of a layer as those of a world script: what its latches brought into
/// memory, what its attachments answered, and what it came to. Since a cycle is a function of the
/// program, memory, the states of sequences and these answers, the program does the same in the
/// script. Thread rule: that of the reasoner that it watches.
class ScriptRecorder final : public CycleWatch {
 public:
  /// `names` are those of the watched reasoner, and outlive the recorder; `program` is its program.
  ScriptRecorder(const Program& program, const NamePool& names)
      : names_(names), order_(OrderSeenBy(program)) {}

  void OnBegin(const FactStore& memory) override;
  void OnEvent(const Event& event) override;
  void OnEnd(const CycleResult& result, const FactStore& memory) override;

  /// The last cycle, `(cycle item ...)`; what it says of memory and of answers is what changed.
  const std::string& cycle() const { return text_; }

 private:
  void Add(const std::string& item);
  std::vector<FactText> FactsOf(const FactStore& memory) const;

  const NamePool& names_;
  const FactOrder order_;
  std::string text_;
  std::size_t width_ = 0;                              ///< Of the last line.
  std::vector<FactText> facts_;                        ///< At the end of the last cycle.
  std::unordered_map<std::string, std::string> said_;  ///< The last item of each call.
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_SCRIPT_RECORDER_H_
