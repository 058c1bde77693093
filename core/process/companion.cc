// SPDX-License-Identifier: BSD-3-Clause
#include "core/process/companion.h"

#include <poll.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace latchwork::process {
namespace {

constexpr std::size_t kMostErrors = 4U << 10U;
constexpr std::size_t kMostHeard = 64U << 20U;
constexpr int kPollMilliseconds = 50;

}  // namespace

bool Companion::Start(const std::filesystem::path& program,
                      const std::vector<std::string>& arguments, std::uint64_t memory_mb) {
  Kill();
  status_ = 0;
  errors_.clear();
  channels_ = std::make_unique<Channels>();
  Channels& channels = *channels_;
  if (channels.input.is_open() && channels.output.is_open() && channels.errors.is_open()) {
    child_ =
        Spawn(program, arguments, memory_mb, {&channels.input, &channels.output, &channels.errors});
  }
  if (child_ <= 0) errors_ = std::strerror(errno);
  channels.input.CloseReader();
  channels.output.CloseWriter();
  channels.errors.CloseWriter();
  return child_ > 0;
}

void Companion::End(std::chrono::milliseconds patience) {
  if (!is_running()) return;
  kill(child_, SIGTERM);
  const Clock::time_point last = Clock::now() + patience;
  siginfo_t ended{};
  const auto is_over = [&] {
    return waitid(P_PID, static_cast<id_t>(child_), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 ||
           ended.si_pid == child_;
  };
  while (!is_over() && Clock::now() < last) poll(nullptr, 0, 1);
  Kill();
}

void Companion::Kill() {
  if (child_ > 0) {
    KillGroup(child_);
    while (waitpid(child_, &status_, 0) < 0 && errno == EINTR) {
    }
    HearLast();
  }
  child_ = -1;
  channels_.reset();
  heard_.clear();
  taken_ = searched_ = 0;
}

/// What it said before it ended; others may still hold the other end.
void Companion::HearLast() {
  Channel& errors = channels_->errors;
  pollfd waiting{errors.reader(), POLLIN, 0};
  while (errors_.size() <= 2 * kMostErrors && poll(&waiting, 1, 0) > 0 && errors.Take(errors_)) {
  }
  if (errors_.size() > kMostErrors) errors_.erase(0, errors_.size() - kMostErrors);
}

std::optional<Companion::Reply> Companion::Impatience(const Patience& patience) {
  if (patience.cancelled != nullptr && *patience.cancelled) return Reply::kCancelled;
  if (patience.deadline && Clock::now() >= *patience.deadline) return Reply::kLate;
  return std::nullopt;
}

bool Companion::Exchange(bool writes, const Patience& patience, std::string_view& unwritten) {
  Channels& channels = *channels_;
  std::array<pollfd, 3> waiting = {pollfd{channels.output.reader(), POLLIN, 0},
                                   pollfd{channels.errors.reader(), POLLIN, 0},
                                   pollfd{writes ? channels.input.writer() : -1, POLLOUT, 0}};
  int milliseconds = kPollMilliseconds;
  if (patience.deadline) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(*patience.deadline - Clock::now());
    milliseconds = static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, milliseconds));
  }
  if (patience.cancelled != nullptr) milliseconds = std::min(milliseconds, 1);
  poll(waiting.data(), waiting.size(), milliseconds);
  if (waiting[1].revents != 0 && !channels.errors.Take(errors_)) channels.errors.CloseReader();
  if (errors_.size() > 2 * kMostErrors) errors_.erase(0, errors_.size() - kMostErrors);
  if (waiting[0].revents != 0 && !channels.output.Take(heard_)) return false;
  if (heard_.size() - taken_ > kMostHeard) return false;
  if (waiting[2].revents != 0) {
    const auto written = channels.input.Give(unwritten);
    if (!written) return false;
    unwritten.remove_prefix(*written);
  }
  return true;
}

bool Companion::Send(std::string_view text, const Patience& patience) {
  if (!is_running()) return false;
  if (const auto written = channels_->input.Give(text)) text.remove_prefix(*written);
  while (!text.empty()) {
    if (Impatience(patience)) return false;
    if (Exchange(true, patience, text)) continue;
    Kill();
    return false;
  }
  return true;
}

Companion::Reply Companion::ReadLine(std::string& line, const Patience& patience) {
  std::string_view nothing;
  while (is_running()) {
    const std::size_t end = heard_.find('\n', std::max(taken_, searched_));
    if (end != std::string::npos) {
      line.assign(heard_, taken_, end - taken_);
      taken_ = end + 1;
      searched_ = taken_;
      if (taken_ == heard_.size()) {
        heard_.clear();
        taken_ = searched_ = 0;
      }
      return Reply::kLine;
    }
    searched_ = heard_.size();
    if (const auto impatience = Impatience(patience)) return *impatience;
    if (!Exchange(false, patience, nothing)) Kill();
  }
  return Reply::kEnded;
}

}  // namespace latchwork::process
