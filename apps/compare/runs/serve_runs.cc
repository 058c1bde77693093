// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/runs/serve_runs.h"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <set>

#include "apps/compare/runs/run_record.h"
#include "apps/compare/runs/task.h"
#include "core/process/child_process.h"
#include "core/process/spawn.h"

namespace latchwork::compare {
namespace {

using process::Channel;
using process::ChildResult;

class Server {
 public:
  Server(const RunService& service, int input, int output, const std::atomic<bool>& stop)
      : service_(service), input_(input), output_(output), stop_(stop) {}

  bool Serve() {
    std::string line;
    while (!stop_ && ReadLine(line)) {
      const auto task = TaskFromText(line);
      if (!task) return false;
      if (!Make(*task)) return true;
    }
    return true;
  }

 private:
  /// Whoever asks waits for the answer: there is never more than one line.
  bool ReadLine(std::string& line) {
    line.clear();
    std::array<char, 4096> buffer{};
    while (!line.ends_with('\n')) {
      const ssize_t count = read(input_, buffer.data(), buffer.size());
      if (count == 0 || (count < 0 && (errno != EINTR || stop_))) return false;
      if (count > 0) line.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return true;
  }

  bool Say(std::string text) {
    text += '\n';
    std::string_view rest = text;
    while (!rest.empty()) {
      const ssize_t count = write(output_, rest.data(), rest.size());
      if (count < 0 && (errno != EINTR || stop_)) return false;
      if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
  }

  bool Make(const Task& task) {
    std::vector<std::string> arguments = task.run.arguments;
    arguments.insert(arguments.end(), {"--json", "--quiet"});
    Channel used(Channel::Kind::kSocket);
    const ChildResult child = process::RunForked(
        [&] {
          return service_.run(arguments, [&](const std::filesystem::path& library) {
            used.Give(library.string() + '\n');
          });
        },
        task.limits, stop_);
    if (child.end == ChildResult::End::kStopped || !Say(ToLine(Judge(task.run, child)))) {
      return false;
    }
    if (child.end == ChildResult::End::kExited) Load(used);
    return true;
  }

  void Load(const Channel& used) {
    std::string text(65536, '\0');
    const ssize_t count = recv(used.reader(), text.data(), text.size(), MSG_DONTWAIT);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
      const std::string library = text.substr(begin, end - begin);
      if (loaded_.insert(library).second) service_.load(library);
    }
  }

  const RunService& service_;
  int input_;
  int output_;
  const std::atomic<bool>& stop_;
  std::set<std::string> loaded_;
};

}  // namespace

bool ServeRuns(const RunService& service, int input, int output, const std::atomic<bool>& stop) {
  return Server(service, input, output, stop).Serve();
}

}  // namespace latchwork::compare
