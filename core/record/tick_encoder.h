// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_TICK_ENCODER_H_
#define LATCHWORK_RECORD_TICK_ENCODER_H_

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "latchwork/schedule/agent.h"
#include "latchwork/schedule/tick_record.h"

namespace latchwork::record {

/// JSON whose members keep the order in which they were written.
using Json = nlohmann::ordered_json;

/// One line of JSON, whatever bytes the texts in it hold.
std::string Dump(const Json& json);

/// Writes ticks as JSON: everything but wall times; what is empty, and sensors that say what they
/// said before, are left out. To be fed every tick of a run, in order.
class TickEncoder {
 public:
  explicit TickEncoder(const schedule::Agent& agent);

  std::string Encode(const schedule::TickRecord& record);
  static std::string EncodeEnd(const schedule::RunResult& result);

 private:
  struct Names {
    std::string name;
    std::vector<std::string> inputs;
    std::vector<std::string> outputs;
  };

  const Names& Of(std::size_t part) const;
  Json Sensed(const schedule::TickRecord& record);
  Json Latched(const schedule::TickRecord& record) const;
  Json Refused(const schedule::TickRecord& record) const;
  Json Decisions(const schedule::TickRecord& record) const;
  Json Said(const schedule::DecisionRecord& record) const;
  Json Inhibited(const schedule::TickRecord& record) const;
  Json Commands(const schedule::TickRecord& record) const;
  Json Faults(const schedule::TickRecord& record) const;

  Names world_;
  std::vector<Names> layers_;
  std::vector<std::vector<logic::Fact>> sensed_;  ///< By sensor, as last written.
};

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_TICK_ENCODER_H_
