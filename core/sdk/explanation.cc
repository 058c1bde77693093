// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/explanation.h"

#include <fmt/format.h>

namespace latchwork::sdk {
namespace {

using Kind = DerivationStep::Kind;

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
      return "reduction";
    case Kind::kSkill:
      return "skill";
    case Kind::kNotTrue:
      return "not True";
    case Kind::kBinding:
      return "by bind";
    case Kind::kMemoryChange:
      break;
  }
  return "change of memory";
}

/// A JSON string.
std::string Quote(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += code < 0x20 ? fmt::format("\\u{:04x}", code) : std::string(1, c);
  }
  return quoted + '"';
}

/// `clause Name`.
std::string TagOf(const DerivationStep& step) {
  return fmt::format("{}{}{}", NameOf(step.kind), step.source.empty() ? "" : " ", step.source);
}

}  // namespace

std::string ToText(const Derivation& derivation) {
  std::string text;
  for (const DerivationStep& step : derivation.steps) {
    text += fmt::format("  {}  [{}]\n", step.conclusion, TagOf(step));
  }
  return text;
}

namespace {

/// What the steps conclude, one after the other.
std::string Conclusions(const Derivation& derivation, bool quoted) {
  std::string text;
  for (const DerivationStep& step : derivation.steps) {
    text += text.empty() ? "" : quoted ? "," : ", ";
    text += quoted ? Quote(step.conclusion) : step.conclusion;
  }
  return text;
}

}  // namespace

std::string ToText(const Explanation& explanation) {
  std::string text;
  if (explanation.holds) {
    text = fmt::format("{} holds:\n", explanation.subject);
    return text + ToText(explanation.derivation);
  }
  text = fmt::format("nothing concludes {}{}\n", explanation.subject,
                     explanation.misses.empty() ? ", and no clause could" : ":");
  for (const NearMiss& miss : explanation.misses) {
    text += fmt::format("  '{}' has {} of {} premises and lacks {}\n", miss.clause, miss.met,
                        miss.premises, miss.lacks);
  }
  if (!explanation.derivation.steps.empty()) {
    text +=
        fmt::format("  some minimal world has {}\n", Conclusions(explanation.derivation, false));
  }
  return text;
}

std::string ToJson(const Explanation& explanation) {
  std::string json = fmt::format(R"({{"subject":{},"holds":{},"{}":[)", Quote(explanation.subject),
                                 explanation.holds, explanation.holds ? "because" : "misses");
  std::string_view separator;
  const bool lists_world = !explanation.holds && !explanation.derivation.steps.empty();
  for (const DerivationStep& step : explanation.derivation.steps) {
    if (lists_world) break;
    json +=
        fmt::format(R"({}{{"conclusion":{},"kind":"{}","source":{},"line":{}}})", separator,
                    Quote(step.conclusion), NameOf(step.kind), Quote(step.source), step.place.line);
    separator = ",";
  }
  for (const NearMiss& miss : explanation.misses) {
    json += fmt::format(R"({}{{"clause":{},"line":{},"met":{},"premises":{},"lacks":{}}})",
                        separator, Quote(miss.clause), miss.place.line, miss.met, miss.premises,
                        Quote(miss.lacks));
    separator = ",";
  }
  json += ']';
  if (lists_world) {
    json += fmt::format(R"(,"world":[{}])", Conclusions(explanation.derivation, true));
  }
  return json + '}';
}

}  // namespace latchwork::sdk
