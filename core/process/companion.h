// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CORE_PROCESS_COMPANION_H_
#define LATCHWORK_CORE_PROCESS_COMPANION_H_

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/process/spawn.h"

namespace latchwork::process {

/// A program that is kept alive and spoken to: lines in, lines out. Ended by Kill or with this
/// object. Thread rule: used by one thread at a time.
class Companion {
 public:
  using Clock = std::chrono::steady_clock;
  enum class Reply { kLine, kEnded, kLate, kCancelled };
  /// How long to wait for a line.
  struct Patience {
    std::optional<Clock::time_point> deadline;
    const std::atomic<bool>* cancelled = nullptr;  ///< Looked at every millisecond.
  };

  Companion() = default;
  Companion(const Companion&) = delete;
  Companion& operator=(const Companion&) = delete;
  ~Companion() { Kill(); }

  /// False: errors() says why. One that runs is killed first.
  bool Start(const std::filesystem::path& program, const std::vector<std::string>& arguments,
             std::uint64_t memory_mb);
  bool is_running() const { return child_ > 0; }
  /// Takes a copy of what it is told while it does not listen. False: it is gone.
  bool Send(std::string_view text, const Patience& patience);
  /// The next line without its end. On kEnded it is gone; on kLate and kCancelled it still works.
  Reply ReadLine(std::string& line, const Patience& patience);
  /// Asks it to end, by SIGTERM, and kills it when it has not after a while.
  void End(std::chrono::milliseconds patience);
  void Kill();

  /// The last 4 KB of what it wrote to standard error.
  const std::string& errors() const { return errors_; }
  /// How the one before ended, as waitpid tells.
  int status() const { return status_; }

 private:
  struct Channels {
    Channel input{Channel::Kind::kSocket};
    Channel output{Channel::Kind::kPipe};
    Channel errors{Channel::Kind::kPipe};
  };
  /// Waits for something to happen; false: it is gone.
  bool Exchange(bool writes, const Patience& patience, std::string_view& unwritten);
  void HearLast();
  static std::optional<Reply> Impatience(const Patience& patience);

  std::unique_ptr<Channels> channels_;
  pid_t child_ = -1;
  int status_ = 0;
  std::string heard_;
  std::size_t taken_ = 0;  ///< Of `heard_`.
  std::size_t searched_ = 0;
  std::string errors_;
};

}  // namespace latchwork::process

#endif  // LATCHWORK_CORE_PROCESS_COMPANION_H_
