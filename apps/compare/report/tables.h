// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_REPORT_TABLES_H_
#define LATCHWORK_APPS_COMPARE_REPORT_TABLES_H_

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/compare/report/html.h"

namespace latchwork::compare {

/// A table in a box of its own that scrolls where the page is narrow: for each scenario a row for
/// each agent, with the cells (HTML) that `cells` makes.
std::string AgentTable(const ReportInput& input, std::string_view caption,
                       const std::vector<std::string>& heads,
                       const std::function<std::vector<std::string>(const Tally&)>& cells);

/// The opening of such a table up to its body; `text_columns` of the heads stand to the left.
std::string TableHead(std::string_view caption, const std::vector<std::string>& heads,
                      std::size_t text_columns);
inline constexpr std::string_view kTableEnd = "</tbody>\n</table>\n</div>\n";

/// A cell: a nought stands back.
std::string Count(std::size_t count);
/// A cell: a p value, standing out when it is at most `level`.
std::string Figure(double p, double level);

/// A cell: a difference with its interval, "+1.5 (+1.0 to +2.0)".
std::string Spread(double mean, double low, double high, int digits);

/// The comparison with the first agent; null for the first itself.
const Duel* FindDuel(const Findings& findings, const Tally& tally);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_REPORT_TABLES_H_
