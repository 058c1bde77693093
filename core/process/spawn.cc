// SPDX-License-Identifier: BSD-3-Clause
#include "core/process/spawn.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace latchwork::process {
namespace {

/// Makes a child what all of them are. Only calls that are safe after fork are allowed.
void Detach(const Streams& streams, rlim_t memory, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kCannotExecute);  // It died before it could be followed.
  dup2(streams.input != nullptr ? streams.input->reader() : open("/dev/null", O_RDONLY | O_CLOEXEC),
       STDIN_FILENO);
  dup2(streams.output->writer(), STDOUT_FILENO);
  dup2(streams.errors->writer(), STDERR_FILENO);
  const rlimit limit{memory, memory};
  setrlimit(RLIMIT_AS, &limit);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
}

/// Nothing gets out of here, least of all into what this is a copy of.
[[noreturn]] void Finish(const std::function<int()>& work) noexcept {
  const int code = work();
  std::fflush(nullptr);
  _exit(code);
}

}  // namespace

Channel::Channel(Kind kind) {
  is_open_ = kind == Kind::kPipe
                 ? pipe2(ends_.data(), O_CLOEXEC) == 0
                 : socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends_.data()) == 0;
}

Channel::~Channel() {
  CloseReader();
  CloseWriter();
}

void Channel::Close(std::size_t end) {
  if (ends_[end] >= 0) close(std::exchange(ends_[end], -1));
}

bool Channel::Take(std::string& text) const {
  std::array<char, 65536> buffer;
  const ssize_t count = read(reader(), buffer.data(), buffer.size());
  if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

std::optional<std::size_t> Channel::Give(std::string_view text) const {
  const ssize_t count = send(writer(), text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (count >= 0) return static_cast<std::size_t>(count);
  if (errno == EINTR || errno == EAGAIN || errno == EWOULDBLOCK) return 0;
  return std::nullopt;
}

pid_t Spawn(const std::filesystem::path& program, const std::vector<std::string>& arguments,
            std::uint64_t memory_mb, const Streams& streams) {
  std::vector<std::string> words = {program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child != 0) return child;
  Detach(streams, memory_mb << 20U, parent);
  execv(words.front().c_str(), pointers.data());
  _exit(kCannotExecute);
}

pid_t Fork(const std::function<int()>& work, std::uint64_t memory_mb, const Streams& streams) {
  std::fflush(nullptr);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child != 0) return child;
  Detach(streams, memory_mb << 20U, parent);
  Finish(work);
}

void KillGroup(pid_t child) {
  kill(-child, SIGKILL);
  kill(child, SIGKILL);
}

std::filesystem::path FindProgram(std::string_view name) {
  const char* const path = std::getenv("PATH");
  std::string_view folders = path == nullptr ? "/usr/bin:/bin" : path;
  while (!folders.empty()) {
    const std::size_t end = folders.find(':');
    const std::filesystem::path candidate = std::filesystem::path(folders.substr(0, end)) / name;
    if (candidate.is_absolute() && access(candidate.c_str(), X_OK) == 0 &&
        !std::filesystem::is_directory(candidate)) {
      return candidate;
    }
    folders.remove_prefix(end == std::string_view::npos ? folders.size() : end + 1);
  }
  return {};
}

}  // namespace latchwork::process
