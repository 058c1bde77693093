// SPDX-License-Identifier: BSD-3-Clause
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

#include "tests/faults/fault_reasoner.h"

namespace latchwork::faults {
namespace {

/// A thread that does nothing for as long as the library is loaded.
class Idler {
 public:
  ~Idler() {
    thread_.request_stop();
    thread_.join();
  }

 private:
  std::mutex mutex_;
  std::condition_variable_any stopped_;
  std::jthread thread_{[this](const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    stopped_.wait(lock, stop, [] { return false; });
  }};
};
const Idler kIdler;

class StartsAThread : public FaultReasoner {
 protected:
  void DecideFaultily(const sdk::Budget& budget, sdk::Decision& decision) override {
    static_cast<void>(budget), static_cast<void>(decision);
  }
};

}  // namespace
}  // namespace latchwork::faults

LATCHWORK_PLUGIN(latchwork::faults::StartsAThread, "starts_a_thread", "1.0",
                 "starts a thread when it is loaded")
