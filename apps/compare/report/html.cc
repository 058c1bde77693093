// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/report/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace latchwork::compare {
namespace {

constexpr std::size_t kColours = 8;

constexpr std::string_view kOpenDetailsForPrint =
    "<script>\n"
    "addEventListener('beforeprint', () => {\n"
    "  for (const each of document.querySelectorAll('details')) each.open = true;\n"
    "});\n"
    "</script>\n";

/// Centred at the origin, some 8 wide.
constexpr std::array<std::string_view, kColours> kMarks = {
    "M4,0A4,4,0,1,1,-4,0A4,4,0,1,1,4,0Z",
    "M-3.5,-3.5H3.5V3.5H-3.5Z",
    "M0,-4.6L4.4,3.6H-4.4Z",
    "M0,-5L5,0L0,5L-5,0Z",
    "M0,4.6L4.4,-3.6H-4.4Z",
    "M-1.4,-4.5H1.4V-1.4H4.5V1.4H1.4V4.5H-1.4V1.4H-4.5V-1.4H-1.4Z",
    "M-4.6,0L3.6,-4.4V4.4Z",
    "M4.6,0L-3.6,-4.4V4.4Z",
};

}  // namespace

std::string Figures(std::string_view text) {
  std::string set;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || text[i - 1] == ' ' || text[i - 1] == '(';
    const bool number = i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9';
    if (text[i] == '-' && begins && number) {
      set += "−";
    } else {
      set += Escaped(text.substr(i, 1));
    }
  }
  return set;
}

std::string AgentClass(const Experiment& experiment, std::string_view contender) {
  const auto found = std::ranges::find(experiment.contenders, contender, &Contender::name);
  const auto index = static_cast<std::size_t>(found - experiment.contenders.begin());
  return fmt::format("a{}", index % kColours);
}

std::string Mark(std::string_view agent_class, double x, double y) {
  const auto index = static_cast<std::size_t>(agent_class.back() - '0');
  return fmt::format("<path class=\"mark {}\" transform=\"translate({:.1f},{:.1f})\" d=\"{}\"/>",
                     agent_class, x, y, kMarks[index % kColours]);
}

std::string Key(const Experiment& experiment, std::string_view contender) {
  return fmt::format(
      "<svg class=\"key\" viewBox=\"-6 -6 12 12\" width=\"12\" height=\"12\" "
      "aria-hidden=\"true\">{}</svg>",
      Mark(AgentClass(experiment, contender), 0, 0));
}

std::vector<const RunRecord*> RunsOf(const ReportInput& input, const std::string& scenario,
                                     const std::string& contender) {
  std::vector<const RunRecord*> runs;
  auto run = input.records.lower_bound({scenario, contender, 0});
  for (; run != input.records.end(); ++run) {
    if (run->first.scenario != scenario || run->first.contender != contender) break;
    runs.push_back(&run->second);
  }
  return runs;
}

std::string ToHtml(const ReportInput& input) {
  const std::string name = Escaped(input.experiment.name);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n"
      "<title>{}: agents compared</title>\n<style>\n{}</style>\n</head>\n<body>\n<main>\n",
      name, PageStyle());
  for (const auto& section : {VerdictSection, SuccessSection, TimeSection, TrajectorySection,
                              LayerSection, FailureSection, MakingSection}) {
    page += section(input);
  }
  page += "</main>\n";
  page += kOpenDetailsForPrint;
  page += "</body>\n</html>\n";
  return page;
}

}  // namespace latchwork::compare
