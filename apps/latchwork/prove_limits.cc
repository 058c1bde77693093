// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/prove_limits.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <new>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/latchwork/command.h"

namespace latchwork::app {
namespace {

constexpr std::array kSignals{SIGXCPU, SIGALRM, SIGTERM, SIGINT};
constexpr std::int64_t kGraceNanoseconds = 200'000'000;
constexpr std::size_t kLongestName = 1024;

// What a signal handler may touch: lock-free atomics and memory that is written before. A handler
// is given nothing, so these are the process's, and hidden here.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables)
std::atomic<bool> is_cancelled = false;
std::atomic<const char*> stopped_by = nullptr;
std::atomic<bool> is_written = false;
std::array<char, 8192> before_word{};
std::array<char, 8192> after_word{};
timer_t timer{};
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

void ArmTimer(double seconds) {
  itimerspec when{};
  const double whole = std::floor(seconds);
  when.it_value.tv_sec = static_cast<std::time_t>(whole);
  when.it_value.tv_nsec = static_cast<std::int64_t>((seconds - whole) * 1e9);
  when.it_interval.tv_nsec = kGraceNanoseconds;
  timer_settime(timer, TIMER_ABSTIME, &when, nullptr);
}

void WriteAll(const char* text) {
  for (std::size_t left = std::strlen(text); left > 0;) {
    const ssize_t written = write(STDOUT_FILENO, text, left);
    if (written <= 0) return;
    text += written;
    left -= static_cast<std::size_t>(written);
  }
}

[[noreturn]] void EndWith(const char* word) {
  if (is_written.exchange(true)) {
    // The status line is out, or on its way by another thread.
    while (true) pause();
  }
  WriteAll(before_word.data());
  WriteAll(word);
  WriteAll(after_word.data());
  _exit(kGoalNotReached);
}

const char* WordFor(int signal) {
  switch (signal) {
    case SIGINT:
      return "User";
    case SIGTERM:
      return "Forced";
    default:
      return "Timeout";
  }
}

void HandleSignal(int signal) {
  if (is_written.load()) return;
  const char* before = nullptr;
  if (!stopped_by.compare_exchange_strong(before, WordFor(signal))) EndWith(before);
  is_cancelled = true;
  // The time that is left for ending in order.
  const itimerspec grace{{0, kGraceNanoseconds}, {0, kGraceNanoseconds}};
  timer_settime(timer, 0, &grace, nullptr);
}

[[noreturn]] void HandleNoMemory() { EndWith("ResourceOut"); }

void LimitMemory(std::size_t megabytes) {
  const rlim_t bytes = static_cast<rlim_t>(megabytes) << 20U;
  rlimit limit{};
  getrlimit(RLIMIT_DATA, &limit);
  limit.rlim_cur = limit.rlim_max == RLIM_INFINITY ? bytes : std::min(bytes, limit.rlim_max);
  setrlimit(RLIMIT_DATA, &limit);
}

/// What a signal handler writes before and after the status.
void PrepareWords(std::string_view file, bool json) {
  std::string before = "% SZS status ";
  std::string after = fmt::format(" for {}", file);
  if (json) {
    const nlohmann::json name(file);
    before = fmt::format("{{\"file\": {}, \"status\": \"",
                         name.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    after = "\", \"message\": \"it was ended before it could end in order\"}";
  }
  std::replace(after.begin(), after.end(), '\n', ' ');
  after += '\n';
  before.copy(before_word.data(), before_word.size() - 1);
  after.copy(after_word.data(), after_word.size() - 1);
}

}  // namespace

ProveLimits::ProveLimits(double cpu_seconds, std::size_t memory_mb, std::string_view file,
                         bool json) {
  PrepareWords(file.substr(0, kLongestName), json);
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGXCPU;
  timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer);
  struct sigaction action {};
  action.sa_handler = HandleSignal;
  action.sa_flags = SA_RESTART;
  for (const int signal : kSignals) sigaddset(&action.sa_mask, signal);
  for (const int signal : kSignals) sigaction(signal, &action, nullptr);
  std::set_new_handler(HandleNoMemory);
  if (memory_mb > 0) LimitMemory(memory_mb);
  ArmTimer(cpu_seconds);
}

ProveLimits::~ProveLimits() { Release(); }

const std::atomic<bool>& ProveLimits::cancelled() { return is_cancelled; }

std::string_view ProveLimits::reason() {
  const char* const word = stopped_by;
  return word == nullptr ? std::string_view() : word;
}

void ProveLimits::Release() {
  if (is_written.exchange(true)) return;
  timer_delete(timer);
  for (const int signal : kSignals) std::signal(signal, SIG_DFL);
  std::set_new_handler(nullptr);
}

}  // namespace latchwork::app
