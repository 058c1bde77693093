// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/report/time_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace latchwork::compare {

constexpr double kLetter = 8;  // Wider than any of a label.

double NiceStep(double length, int most) {
  if (!(length > 0) || !std::isfinite(length)) return 1;
  const double least = length / most;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

TimeAxis::TimeAxis(const std::vector<const RunRecord*>& runs, bool failure_column) {
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
  for (const RunRecord* run : runs) {
    if (run->outcome != Outcome::kReached) {
      has_failures_ = failure_column;
      continue;
    }
    low = std::min(low, run->time_s);
    high = std::max(high, run->time_s);
  }
  if (low > high) low = high = 0;
  if (low < high / 2) low = 0;
  step_ = NiceStep(std::max(high - low, 1.0), 5);
  low_ = std::floor(low / step_) * step_;
  high_ = std::max(low_ + step_, std::ceil(high / step_) * step_);
  right_ = kChartWidth - 16 - (has_failures_ ? kColumn : 0);
}

double TimeAxis::X(double seconds) const {
  return kLeft + (seconds - low_) / (high_ - low_) * (right_ - kLeft);
}

double TimeAxis::X(const RunRecord& run) const {
  if (run.outcome == Outcome::kReached) return X(run.time_s);
  return has_failures_ ? right_ + kColumn / 2 + 4 : right_;
}

std::string TimeAxis::Draw(double top, double bottom) const {
  std::string axis;
  auto out = std::back_inserter(axis);
  const auto ticks = static_cast<int>(std::lround((high_ - low_) / step_));
  for (int i = 0; i <= ticks; ++i) {
    const double value = low_ + i * step_;
    fmt::format_to(out, "<path class=\"grid\" d=\"M{0:.1f},{1:.1f}V{2:.1f}\"/>", X(value), top,
                   bottom);
    const std::string label = fmt::format("{:g}{}", value, i == ticks ? " s" : "");
    const bool fits = X(value) + kLetter * static_cast<double>(label.size()) / 2 < kChartWidth;
    const char* middle = fits ? "middle" : "end";
    fmt::format_to(
        out, "<text class=\"soft\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>",
        fits ? X(value) : kChartWidth - 2, bottom + 14, i == 0 ? "start" : middle, label);
  }
  fmt::format_to(out, "<path class=\"axis\" d=\"M{:.1f},{:.1f}H{:.1f}\"/>", kLeft, bottom, right_);
  if (has_failures_) {
    fmt::format_to(out,
                   "<text class=\"soft\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">not "
                   "reached</text>",
                   kChartWidth - 2, bottom + 28);
    fmt::format_to(out, "<path class=\"axis\" d=\"M{:.1f},{:.1f}H{:.1f}\"/>", right_ + 12, bottom,
                   kChartWidth - 4);
  }
  return axis + "\n";
}

}  // namespace latchwork::compare
