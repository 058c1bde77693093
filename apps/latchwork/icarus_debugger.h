// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_ICARUS_DEBUGGER_H_
#define LATCHWORK_APPS_LATCHWORK_ICARUS_DEBUGGER_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/latchwork/icarus_session.h"
#include "reasoners/icarus/tools/trace_entry.h"

namespace latchwork::app {

/// A program that is run step by step, in a world that a script and a person make.
class IcarusDebugger : private icarus::EventSink {
 public:
  explicit IcarusDebugger(const IcarusSettings& settings) : settings_(settings) {}

  /// Reads the program, and the script when there is one; false with messages on standard error.
  bool Open();
  /// Reads the program again: memory and the states of unchanged sequences stay. False with
  /// messages, and the old program goes on, when something is wrong with it.
  bool Reload();

  /// Makes this call the top; else says what is wrong with it.
  std::optional<std::string> SetTop(const std::string& call);
  const std::string& top() const { return top_text_; }

  /// Is told of each event while its cycle is under way, and the cycle waits for it.
  void SetObserver(std::function<void(const icarus::TraceEntry&)> observer) {
    observer_ = std::move(observer);
  }

  /// One cycle of the script, or, after its end, in the world as it is.
  const icarus::CycleResult& Step();
  bool script_has_ended() const { return next_ >= script_.cycles.size(); }
  /// Whether a cycle came to what the script expected.
  bool is_as_expected() const { return as_expected_; }

  /// `item` as it stands in a cycle of a script, (store (car c1)), takes effect at once; else what
  /// is wrong with it.
  std::optional<std::string> Apply(const std::string& item);
  /// A list in which ? stands for anything; nothing when the text is none.
  std::optional<icarus::Value> ReadPattern(const std::string& text);

  /// Of the last cycle.
  const icarus::CycleResult& result() const { return *result_; }
  const std::vector<icarus::TraceEntry>& entries() const { return entries_; }
  bool has_run() const { return result_ != nullptr; }
  bool is_cut() const { return cut_; }
  std::string Line() const;
  std::vector<std::string> Faults() const;

  /// The facts that fit, in the order of memory; none: all.
  std::vector<std::string> Memory(const std::optional<icarus::Value>& pattern) const;
  const icarus::Program& program() const { return file_->program; }
  const icarus::NamePool& names() const { return names_; }
  /// Of the cycle that is under way, else of the last one.
  std::uint64_t cycle() const { return interpreter_->cycle(); }

 private:
  void OnEvent(const icarus::Event& event) override;
  std::unique_ptr<icarus::ProgramFile> ReadFile();
  bool DeclareFunctions(const icarus::Program& program);
  bool MakeInterpreter(const icarus::Program& program,
                       std::unique_ptr<icarus::Interpreter>& interpreter);
  std::optional<icarus::ScriptCycle> ReadItem(const std::string& item, std::string& message);
  const icarus::ScriptCycle* NextCycle();

  IcarusSettings settings_;
  icarus::NamePool names_;
  icarus::WorldScript script_;
  std::deque<icarus::ScriptCycle> by_hand_;
  std::unique_ptr<icarus::ScriptedWorld> world_;
  std::unique_ptr<icarus::ProgramFile> file_;
  std::unique_ptr<icarus::Interpreter> interpreter_;
  std::string top_text_;
  std::size_t top_ = icarus::Interpreter::kNoTop;
  std::size_t now_ = icarus::Interpreter::kNoTop;  ///< Top of the last cycle.
  std::size_t next_ = 0;
  std::int64_t repeated_ = 0;
  bool as_expected_ = true;
  bool cut_ = false;
  const icarus::CycleResult* result_ = nullptr;
  std::vector<icarus::TraceEntry> entries_;
  std::function<void(const icarus::TraceEntry&)> observer_;
  std::optional<icarus::EventDescriber> describer_;
};

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_ICARUS_DEBUGGER_H_
