// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/report/tables.h"

#include <fmt/format.h>

#include "apps/compare/report/verdicts.h"

namespace latchwork::compare {

std::string TableHead(std::string_view caption, const std::vector<std::string>& heads,
                      std::size_t text_columns) {
  std::string table = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{0}\">\n<table>\n"
      "<caption>{0}</caption>\n<thead>\n<tr>",
      Escaped(caption));
  for (std::size_t i = 0; i < heads.size(); ++i) {
    table += fmt::format("<th scope=\"col\"{}>{}</th>", i < text_columns ? " class=\"l\"" : "",
                         Escaped(heads[i]));
  }
  return table + "</tr>\n</thead>\n<tbody>\n";
}

std::string AgentTable(const ReportInput& input, std::string_view caption,
                       const std::vector<std::string>& heads,
                       const std::function<std::vector<std::string>(const Tally&)>& cells) {
  std::vector<std::string> all = {"scenario", "agent"};
  all.insert(all.end(), heads.begin(), heads.end());
  std::string table = TableHead(caption, all, 2);
  std::string_view scenario;
  for (const Tally& tally : input.findings.tallies) {
    table += tally.scenario == scenario ? "<tr>" : "<tr class=\"group\">";
    if (tally.scenario != scenario) {
      table += fmt::format("<th scope=\"rowgroup\" class=\"l\" rowspan=\"{}\">{}</th>",
                           input.experiment.contenders.size(), Escaped(tally.scenario));
    }
    scenario = tally.scenario;
    table += fmt::format("<th scope=\"row\" class=\"l\">{}{}</th>",
                         Key(input.experiment, tally.contender), Escaped(tally.contender));
    for (const std::string& cell : cells(tally)) table += fmt::format("<td>{}</td>", cell);
    table += "</tr>\n";
  }
  return table.append(kTableEnd);
}

std::string Count(std::size_t count) {
  return count == 0 ? "<span class=\"zero\">0</span>" : fmt::format("{}", count);
}

std::string Figure(double p, double level) {
  const std::string figure = Escaped(PFigure(p));
  return p <= level && level < 1 ? fmt::format("<span class=\"found\">{}</span>", figure) : figure;
}

std::string Spread(double mean, double low, double high, int digits) {
  return Figures(fmt::format("{} ({} to {})", Signed(mean, digits), Signed(low, digits),
                             Signed(high, digits)));
}

const Duel* FindDuel(const Findings& findings, const Tally& tally) {
  for (const Duel& duel : findings.duels) {
    if (duel.scenario == tally.scenario && duel.second == tally.contender) return &duel;
  }
  return nullptr;
}

}  // namespace latchwork::compare
