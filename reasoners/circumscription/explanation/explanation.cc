// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/explanation/explanation.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace latchwork::circumscription {
namespace {

using Kind = sdk::DerivationStep::Kind;

std::string_view NameOf(Kind kind) {
  switch (kind) {
    case Kind::kClause:
      return "clause";
    case Kind::kLatch:
      return "latch";
    case Kind::kAssumption:
      return "assumption";
    case Kind::kAttachment:
      return "attachment";
    case Kind::kArithmetic:
      return "arithmetic";
    case Kind::kReduction:
      break;
  }
  return "reduction";
}

}  // namespace

std::string ToText(const Explanation& explanation) {
  std::string text;
  if (explanation.holds) {
    text = fmt::format("{} holds:\n", explanation.subject);
    for (const sdk::DerivationStep& step : explanation.derivation.steps) {
      text += fmt::format("  {}  [{} {}]\n", step.conclusion, NameOf(step.kind), step.source);
    }
    return text;
  }
  text = fmt::format("nothing concludes {}{}\n", explanation.subject,
                     explanation.misses.empty() ? ", nor could" : ":");
  for (const NearMiss& miss : explanation.misses) {
    text += fmt::format("  '{}' has {} of {} premises and lacks {}\n", miss.clause, miss.met,
                        miss.premises, miss.lacks);
  }
  return text;
}

std::string ToJson(const Explanation& explanation) {
  nlohmann::ordered_json json{{"subject", explanation.subject}, {"holds", explanation.holds}};
  nlohmann::ordered_json& list = json[explanation.holds ? "because" : "misses"];
  list = nlohmann::ordered_json::array();
  for (const sdk::DerivationStep& step : explanation.derivation.steps) {
    list.push_back({{"conclusion", step.conclusion},
                    {"kind", NameOf(step.kind)},
                    {"source", step.source},
                    {"line", step.place.line}});
  }
  for (const NearMiss& miss : explanation.misses) {
    list.push_back({{"clause", miss.clause},
                    {"line", miss.place.line},
                    {"met", miss.met},
                    {"premises", miss.premises},
                    {"lacks", miss.lacks}});
  }
  return json.dump();
}

}  // namespace latchwork::circumscription
