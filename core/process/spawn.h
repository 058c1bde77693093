// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CORE_PROCESS_SPAWN_H_
#define LATCHWORK_CORE_PROCESS_SPAWN_H_

#include <sys/resource.h>
#include <sys/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace latchwork::process {

/// The exit code of a child whose program could not be executed.
inline constexpr int kCannotExecute = 127;

/// Two ends that close themselves; neither is inherited by children.
class Channel {
 public:
  enum class Kind : std::uint8_t {
    kPipe,    ///< What end 1 writes, end 0 reads.
    kSocket,  ///< The same; writing to an end that nobody reads is an error, not a signal.
  };
  explicit Channel(Kind kind);
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;
  ~Channel();

  bool is_open() const { return is_open_; }
  int reader() const { return ends_[0]; }
  int writer() const { return ends_[1]; }
  void CloseReader() { Close(0); }
  void CloseWriter() { Close(1); }
  /// Takes what there is to read; false at the end.
  bool Take(std::string& text) const;
  /// Writes as much of the text as fits now; nothing when nobody reads. Sockets only.
  std::optional<std::size_t> Give(std::string_view text) const;

 private:
  void Close(std::size_t end);

  std::array<int, 2> ends_ = {-1, -1};
  bool is_open_ = false;
};

/// What a child reads and writes. Without `input` it has nothing to read.
struct Streams {
  const Channel* input = nullptr;
  const Channel* output = nullptr;
  const Channel* errors = nullptr;
};

/// Starts a program in a process group of its own, that ends with the calling thread at the latest.
/// -1: errno says why not.
pid_t Spawn(const std::filesystem::path& program, const std::vector<std::string>& arguments,
            std::uint64_t memory_mb, const Streams& streams);

/// The same with a copy of this process, which has one thread. It ends with what `work` returns.
pid_t Fork(const std::function<int()>& work, std::uint64_t memory_mb, const Streams& streams);

/// Ends a child and what it started; it is still to be waited for.
void KillGroup(pid_t child);

/// The program of this name in a folder of PATH; empty when there is none.
std::filesystem::path FindProgram(std::string_view name);

}  // namespace latchwork::process

#endif  // LATCHWORK_CORE_PROCESS_SPAWN_H_
