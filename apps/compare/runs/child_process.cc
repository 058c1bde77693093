// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/runs/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <utility>

namespace latchwork::compare {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostOutput = 16U << 20U;
constexpr std::size_t kMostErrors = 4U << 10U;
constexpr int kPollMilliseconds = 50;
constexpr int kCannotExecute = 127;

/// A pipe whose ends close themselves; neither is inherited by other children.
class Pipe {
 public:
  Pipe() : is_open_(pipe2(ends_.data(), O_CLOEXEC) == 0) {}
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    Close(0);
    Close(1);
  }

  bool is_open() const { return is_open_; }
  int reader() const { return ends_[0]; }
  int writer() const { return ends_[1]; }
  void CloseWriter() { Close(1); }
  void CloseReader() { Close(0); }

 private:
  void Close(std::size_t end) {
    if (ends_[end] >= 0) close(std::exchange(ends_[end], -1));
  }

  std::array<int, 2> ends_ = {-1, -1};
  bool is_open_;
};

/// In the child, where only calls that are safe after fork are allowed.
[[noreturn]] void Become(const char* program, char* const* arguments, int output, int errors,
                         rlim_t memory) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  const rlimit limit{memory, memory};
  setrlimit(RLIMIT_AS, &limit);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  execv(program, arguments);
  _exit(kCannotExecute);
}

/// Takes what there is; false at the end.
bool Take(Pipe& pipe, std::string& text) {
  std::array<char, 4096> buffer{};
  const ssize_t count = read(pipe.reader(), buffer.data(), buffer.size());
  if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

class Child {
 public:
  Child(const RunLimits& limits, const std::atomic<bool>& stop) : limits_(limits), stop_(stop) {}

  ChildResult Run(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
    if (!output_.is_open() || !errors_.is_open() || !Start(program, arguments)) {
      result_.errors = std::strerror(errno);
      return std::move(result_);
    }
    output_.CloseWriter();
    errors_.CloseWriter();
    Listen();
    Wait();
    return std::move(result_);
  }

 private:
  bool Start(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
    std::vector<std::string> words = {program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    process_ = fork();
    if (process_ == 0) {
      Become(words.front().c_str(), pointers.data(), output_.writer(), errors_.writer(),
             limits_.memory_mb << 20U);
    }
    return process_ > 0;
  }

  void Listen() {
    while (output_.reader() >= 0 || errors_.reader() >= 0) {
      std::array<pollfd, 2> waiting = {pollfd{output_.reader(), POLLIN, 0},
                                       pollfd{errors_.reader(), POLLIN, 0}};
      poll(waiting.data(), waiting.size(), kPollMilliseconds);
      if (waiting[0].revents != 0 && !Take(output_, result_.output)) output_.CloseReader();
      if (waiting[1].revents != 0 && !Take(errors_, result_.errors)) errors_.CloseReader();
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
    kill(-process_, SIGKILL);
    kill(process_, SIGKILL);
    return true;
  }

  void Wait() {
    int status = 0;
    rusage usage{};
    while (true) {
      const pid_t ended = wait4(process_, &status, WNOHANG, &usage);
      if (ended == process_ || (ended < 0 && errno != EINTR)) break;
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

  const RunLimits& limits_;
  const std::atomic<bool>& stop_;
  Clock::time_point begin_ = Clock::now();
  Pipe output_;
  Pipe errors_;
  pid_t process_ = -1;
  ChildResult result_;
};

}  // namespace

ChildResult RunChild(const std::filesystem::path& program,
                     const std::vector<std::string>& arguments, const RunLimits& limits,
                     const std::atomic<bool>& stop) {
  return Child(limits, stop).Run(program, arguments);
}

}  // namespace latchwork::compare
