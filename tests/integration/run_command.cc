// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/run_command.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tests/temporary_folder.h"

extern char** environ;

namespace latchwork::testing {
namespace {

using test::TemporaryFolder;
constexpr int kOwnerOnly = 0600;

std::vector<char*> Pointers(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Starts the words with their output going to two files; returns what waitpid says.
int SpawnAndWait(std::vector<std::string> words, const std::filesystem::path& folder,
                 const std::filesystem::path& out, const std::filesystem::path& err) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT,
                                   kOwnerOnly);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT,
                                   kOwnerOnly);
  pid_t child = 0;
  const std::vector<char*> arguments = Pointers(words);
  const int error =
      posix_spawn(&child, words.front().c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error("cannot start " + words.front());
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

CommandResult Run(std::vector<std::string> words, const std::filesystem::path& folder) {
  const TemporaryFolder scratch;
  const std::filesystem::path out = scratch.path() / "out";
  const std::filesystem::path err = scratch.path() / "err";
  const int status = SpawnAndWait(std::move(words), folder, out, err);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, ReadText(out), ReadText(err)};
}

}  // namespace

CommandResult RunLatchwork(const std::vector<std::string>& arguments,
                           const std::filesystem::path& folder) {
  std::vector<std::string> words = {LATCHWORK_BINARY_DIR "/bin/latchwork"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return Run(std::move(words), folder);
}

CommandResult RunShell(const std::string& script, const std::filesystem::path& folder) {
  return Run({"/bin/sh", "-c", "PATH=" LATCHWORK_BINARY_DIR "/bin:$PATH; " + script}, folder);
}

std::string ReadText(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void WriteText(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace latchwork::testing
