// SPDX-License-Identifier: BSD-3-Clause
#include "core/process/child_process.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <utility>

#include "core/process/spawn.h"

namespace latchwork::process {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostOutput = 16U << 20U;
constexpr std::size_t kMostErrors = 4U << 10U;
constexpr int kPollMilliseconds = 50;

class Child {
 public:
  Child(const Limits& limits, const std::atomic<bool>& stop, std::string_view input)
      : limits_(limits), stop_(stop), unwritten_(input) {}

  using Start = std::function<pid_t(const Streams& streams)>;

  ChildResult Run(const Start& start) {
    const bool are_open = input_.is_open() && output_.is_open() && errors_.is_open();
    if (are_open) {
      process_ = start({unwritten_.empty() ? nullptr : &input_, &output_, &errors_});
    }
    if (process_ <= 0) {
      result_.errors = std::strerror(errno);
      return std::move(result_);
    }
    input_.CloseReader();
    output_.CloseWriter();
    errors_.CloseWriter();
    Write();
    Listen();
    Wait();
    return std::move(result_);
  }

 private:
  /// What it reads; closed at the end, and when it reads no more.
  void Write() {
    const auto written = input_.Give(unwritten_);
    if (written) unwritten_.remove_prefix(*written);
    if (!written || unwritten_.empty()) input_.CloseWriter();
  }

  void Listen() {
    while (output_.reader() >= 0 || errors_.reader() >= 0) {
      std::array<pollfd, 3> waiting = {pollfd{output_.reader(), POLLIN, 0},
                                       pollfd{errors_.reader(), POLLIN, 0},
                                       pollfd{input_.writer(), POLLOUT, 0}};
      poll(waiting.data(), waiting.size(), kPollMilliseconds);
      if (waiting[0].revents != 0 && !output_.Take(result_.output)) output_.CloseReader();
      if (waiting[1].revents != 0 && !errors_.Take(result_.errors)) errors_.CloseReader();
      if (waiting[2].revents != 0) Write();
      if (result_.output.size() > kMostOutput) result_.output.resize(kMostOutput);
      if (result_.errors.size() > 2 * kMostErrors) {
        result_.errors.erase(0, result_.errors.size() - kMostErrors);
      }
      if (EndIfDue()) return;
    }
  }

  bool EndIfDue() {
    const std::chrono::duration<double> spent = Clock::now() - begin_;
    const bool late = spent.count() > limits_.wall_seconds;
    if (!late && !stop_) return false;
    result_.end = late ? ChildResult::End::kTimedOut : ChildResult::End::kStopped;
    KillGroup(process_);
    return true;
  }

  void Wait() {
    int status = 0;
    rusage usage{};
    while (true) {
      const pid_t ended = wait4(process_, &status, WNOHANG, &usage);
      if (ended == process_) break;
      if (ended < 0 && errno != EINTR) {
        result_.errors = std::string("how the program ended is not known: ") + std::strerror(errno);
        return;
      }
      if (result_.end == ChildResult::End::kNotStarted) EndIfDue();
      poll(nullptr, 0, 1);
    }
    result_.wall_seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    const auto seconds = [](const timeval& time) {
      return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    result_.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    if (result_.end != ChildResult::End::kNotStarted) return;
    const bool exited = WIFEXITED(status);
    result_.code = exited ? WEXITSTATUS(status) : WTERMSIG(status);
    result_.end = exited ? ChildResult::End::kExited : ChildResult::End::kSignalled;
    if (exited && result_.code == kCannotExecute && result_.output.empty()) {
      result_.end = ChildResult::End::kNotStarted;
      result_.errors += "the program cannot be executed";
    }
  }

  const Limits& limits_;
  const std::atomic<bool>& stop_;
  std::string_view unwritten_;
  Clock::time_point begin_ = Clock::now();
  Channel input_{Channel::Kind::kSocket};
  Channel output_{Channel::Kind::kPipe};
  Channel errors_{Channel::Kind::kPipe};
  pid_t process_ = -1;
  ChildResult result_;
};

}  // namespace

ChildResult RunChild(const std::filesystem::path& program,
                     const std::vector<std::string>& arguments, const Limits& limits,
                     const std::atomic<bool>& stop, std::string_view input) {
  return Child(limits, stop, input).Run([&](const Streams& streams) {
    return Spawn(program, arguments, limits.memory_mb, streams);
  });
}

ChildResult RunForked(const std::function<int()>& work, const Limits& limits,
                      const std::atomic<bool>& stop) {
  return Child(limits, stop, {}).Run([&](const Streams& streams) {
    return Fork(work, limits.memory_mb, streams);
  });
}

}  // namespace latchwork::process
