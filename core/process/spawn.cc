// SPDX-License-Identifier: BSD-3-Clause
#include "core/process/spawn.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <utility>

namespace latchwork::process {
namespace {

/// In the child, where only calls that are safe after fork are allowed.
[[noreturn]] void Become(const char* program, char* const* arguments, int input, int output,
                         int errors, rlim_t memory) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  dup2(input >= 0 ? input : open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  const rlimit limit{memory, memory};
  setrlimit(RLIMIT_AS, &limit);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  execv(program, arguments);
  _exit(kCannotExecute);
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
            std::uint64_t memory_mb, const Channel* input, const Channel& output,
            const Channel& errors) {
  std::vector<std::string> words = {program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    Become(words.front().c_str(), pointers.data(), input == nullptr ? -1 : input->reader(),
           output.writer(), errors.writer(), memory_mb << 20U);
  }
  return child;
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
