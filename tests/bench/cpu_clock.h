// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_BENCH_CPU_CLOCK_H_
#define LATCHWORK_TESTS_BENCH_CPU_CLOCK_H_

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

namespace latchwork {

/// Seconds of processor time that this thread has used: figures do not depend on who else works on
/// the machine.
inline double ThreadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Collects one figure per cycle.
class Sample {
 public:
  void Add(double value) { values_.push_back(value); }
  bool empty() const { return values_.empty(); }
  /// The value that a share of all do not exceed.
  double Quantile(double share) {
    if (values_.empty()) return 0;
    const auto index = static_cast<std::size_t>(share * static_cast<double>(values_.size() - 1));
    std::nth_element(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(index),
                     values_.end());
    return values_[index];
  }
  /// Counters NAME_p50, NAME_p99 and NAME_max.
  void Report(const std::string& name, benchmark::State& state) {
    state.counters[name + "_p50"] = Quantile(0.5);
    state.counters[name + "_p99"] = Quantile(0.99);
    state.counters[name + "_max"] = Quantile(1);
  }

 private:
  std::vector<double> values_;
};

}  // namespace latchwork

#endif  // LATCHWORK_TESTS_BENCH_CPU_CLOCK_H_
