// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_COMPARE_REPORT_TIME_AXIS_H_
#define LATCHWORK_APPS_COMPARE_REPORT_TIME_AXIS_H_

#include <string>
#include <vector>

#include "apps/compare/runs/run_record.h"

namespace latchwork::compare {

inline constexpr double kChartWidth = 340;  ///< Units of a chart; about a pixel each.

/// Times to the goal from left to right. Runs that do not reach it have a column of their own at
/// the right where there are any, so that they are seen beside the others.
class TimeAxis {
 public:
  TimeAxis(const std::vector<const RunRecord*>& runs, bool failure_column);

  double X(double seconds) const;
  /// Of a run: its time, or the middle of the column of failures.
  double X(const RunRecord& run) const;
  double left() const { return kLeft; }
  double right() const { return right_; }  ///< Of the times.
  bool has_failures() const { return has_failures_; }

  /// Ticks, their numbers and lines from `top` to `bottom`.
  std::string Draw(double top, double bottom) const;

 private:
  static constexpr double kLeft = 8;
  static constexpr double kColumn = 56;

  double low_ = 0;
  double high_ = 1;
  double step_ = 1;
  double right_ = 0;
  bool has_failures_ = false;
};

/// A step of 1, 2 or 5 times a power of ten that makes at most `most` of a length.
double NiceStep(double length, int most);

}  // namespace latchwork::compare

#endif  // LATCHWORK_APPS_COMPARE_REPORT_TIME_AXIS_H_
