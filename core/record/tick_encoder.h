// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_TICK_ENCODER_H_
#define LATCHWORK_RECORD_TICK_ENCODER_H_

#include <cstddef>
#include <string>
#include <vector>

#include "core/record/json_writer.h"
#include "latchwork/schedule/agent.h"
#include "latchwork/schedule/tick_record.h"

namespace latchwork::record {

/// Writes ticks as JSON (docs/journal.md): everything but wall times; what is empty, and commands
/// that stay as they were, are left out. To be fed every tick of a run, in order. Keeps nothing of
/// the agent but names.
class TickEncoder {
 public:
  explicit TickEncoder(const schedule::Agent& agent);

  /// Valid until the next call.
  const std::string& Encode(const schedule::TickRecord& record);
  const std::string& EncodeEnd(const schedule::RunResult& result);

 private:
  struct Layer {
    std::string name;
    std::vector<std::string> inputs;
    std::vector<std::string> outputs;
    std::vector<std::size_t> goal_ports;  ///< The output port of each goal.
  };

  void Events(const schedule::TickRecord& record);
  void Sensed(const schedule::TickRecord& record);
  void Latched(const schedule::TickRecord& record);
  void Refused(const schedule::TickRecord& record);
  void Decision(const schedule::DecisionRecord& record);
  void Undecided(const sdk::Undecided& undecided);
  void States(const std::vector<sdk::GoalState>& states);
  void Indices(const std::vector<std::size_t>& indices);
  void Conclusions(const Layer& layer, const std::vector<sdk::Conclusion>& conclusions);
  void Assumptions(const sdk::Decision& decision);
  void Said(const Layer& layer, const schedule::DecisionRecord& record);
  void Inhibited(const schedule::TickRecord& record);
  void Commands(const schedule::TickRecord& record);
  void Faults(const schedule::TickRecord& record);
  void TextMember(std::string_view name, std::string_view text);
  void NumberMember(std::string_view name, std::uint64_t number);

  std::vector<std::string> effectors_;
  std::vector<std::string> sensors_;
  std::vector<Layer> layers_;
  std::vector<std::vector<logic::Fact>> commands_;  ///< By effector, as last written.
  JsonWriter json_;
};

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_TICK_ENCODER_H_
