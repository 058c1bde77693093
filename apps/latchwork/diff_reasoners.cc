// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/latchwork/command.h"
#include "apps/latchwork/diff_journal.h"
#include "apps/latchwork/diff_theory.h"
#include "apps/latchwork/progress.h"
#include "latchwork/plugin/plugin_search.h"

namespace latchwork::app {
namespace {

struct DiffOptions {
  std::vector<std::string> reasoners = {"pttp", "circumscription:mode=bounded"};
  std::uint64_t random = 0;
  std::uint64_t seed = 1;
  std::uint64_t from = 0;
  std::filesystem::path journal;
  std::filesystem::path out = ".";
  bool json = false;
  bool quiet = false;
};

/// A folder that goes when this object does.
class WorkFolder {
 public:
  WorkFolder()
      : path_(std::filesystem::temp_directory_path() / fmt::format("latchwork-diff-{}", getpid())) {
    std::filesystem::create_directories(path_);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// `name:parameter=value:parameter=value`.
Contender ContenderOf(const std::string& text, const plugin::Registry& registry) {
  Contender contender;
  contender.name = text;
  std::string name = text.substr(0, text.find(':'));
  for (std::size_t at = text.find(':'); at != std::string::npos;) {
    const std::size_t end = text.find(':', at + 1);
    const std::string setting = text.substr(at + 1, end == std::string::npos ? end : end - at - 1);
    const std::size_t equals = setting.find('=');
    contender.given.push_back({setting.substr(0, equals),
                               equals == std::string::npos ? "" : setting.substr(equals + 1),
                               {"--reasoners", 0, 0}});
    at = end;
  }
  contender.make = [name = std::move(name), &registry] {
    return registry.MakeReasoner(name).object;
  };
  return contender;
}

/// Whether its plugin is here and its parameters are its own; what is not goes to standard error.
bool IsRight(const Contender& contender, const plugin::Registry& registry, int& exit_code) {
  const auto made = registry.MakeReasoner(contender.name.substr(0, contender.name.find(':')));
  if (!made.object) {
    fmt::print(stderr, "{}\n", made.error);
    exit_code = kPluginFailure;
    return false;
  }
  logic::Diagnostics diagnostics;
  sdk::Parameters::Check(made.object->parameters(), contender.given, contender.name, {},
                         diagnostics);
  const std::string_view language = made.object->language();
  if (diagnostics.empty() && !language.empty() && language != "tptp") {
    diagnostics.push_back({{"--reasoners", 0, 0},
                           fmt::format("{} reads no theories", contender.name),
                           "take one whose language is tptp",
                           ""});
  }
  if (diagnostics.empty()) return true;
  fmt::print(stderr, "{}", Format(diagnostics));
  if (exit_code == kDone) exit_code = kInvalidInput;
  return false;
}

/// The reasoners that can be used here: what is wrong with one ends the comparison, except that the
/// program it drives is not installed.
std::vector<Contender> Contenders(const DiffOptions& options, const plugin::Registry& registry,
                                  const std::filesystem::path& folder, int& exit_code) {
  std::vector<Contender> contenders;
  for (const std::string& text : options.reasoners) {
    Contender contender = ContenderOf(text, registry);
    if (!IsRight(contender, registry, exit_code)) continue;
    logic::SymbolTable symbols;
    DiffTheory trivial;
    trivial.body.goals.push_back({logic::Atom(symbols.Intern("p"))});
    const Verdict verdict = Judge(contender, trivial, symbols, folder);
    if (verdict.kind == Verdict::Kind::kRefused) {
      fmt::print(stderr, "left out: {}", verdict.remark);
    } else {
      contenders.push_back(std::move(contender));
    }
  }
  if (exit_code == kDone && contenders.size() < 2) {
    fmt::print(stderr, "there are no two reasoners to compare\n");
    exit_code = kPluginFailure;
  }
  return contenders;
}

/// Makes the folder that theories are to be written to; false with a message where that cannot be.
bool PrepareFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && !std::filesystem::is_directory(folder)) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (!error && access(folder.c_str(), W_OK) != 0) error = {errno, std::generic_category()};
  if (!error) return true;
  fmt::print(stderr, "latchwork: --out {}: nothing can be written there: {}\n", folder.string(),
             error.message());
  return false;
}

std::string Said(const Verdict& verdict) {
  return verdict.conclusions.empty() ? "nothing"
                                     : fmt::format("{}", fmt::join(verdict.conclusions, ", "));
}

/// What is found, as text or JSON, and the smallest theories as files.
class Findings {
 public:
  Findings(const DiffOptions& options, const std::vector<Contender>& contenders,
           const std::filesystem::path& folder)
      : options_(options), contenders_(contenders), folder_(folder) {}

  void Report(const DiffTheory& theory, std::size_t first, std::size_t other,
              const std::string& place, const std::string& command, logic::SymbolTable& symbols) {
    const Contender& a = contenders_[first];
    const Contender& b = contenders_[other];
    const DiffTheory smallest = Shrink(theory, a, b, symbols, folder_);
    const Verdict one = Judge(a, smallest, symbols, folder_);
    const Verdict two = Judge(b, smallest, symbols, folder_);
    const std::filesystem::path file = options_.out / fmt::format("disagreement-{}.p", ++count_);
    const std::string says = fmt::format("{}: {}\n{}: {}\n", a.name, Said(one), b.name, Said(two));
    std::string text = fmt::format("% {}\n% {}: {}\n% {}: {}\n% {}\n", place, a.name, Said(one),
                                   b.name, Said(two), command);
    text += TheoryText(smallest, one, two);
    const bool is_written = Write(file, text);
    if (options_.json) {
      found_.push_back({{"place", place},
                        {"reasoners", {a.name, b.name}},
                        {"conclusions", {one.conclusions, two.conclusions}},
                        {"clauses", smallest.clauses.size()},
                        {"file", is_written ? nlohmann::json(file.string()) : nlohmann::json()},
                        {"command", command}});
      return;
    }
    fmt::print("{}: {} and {} disagree\n", place, a.name, b.name);
    fmt::print("{}\nagain: {}\n", text, command);
    if (is_written) fmt::print("written: {0} (latchwork prove {0})\n", file.string());
    fmt::print("\n");
  }

  std::size_t count() const { return count_; }
  const nlohmann::ordered_json& found() const { return found_; }

 private:
  /// False with a message: it is not written whole.
  static bool Write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream stream(file, std::ios::binary);
    stream << text << std::flush;
    if (stream) return true;
    fmt::print(stderr, "{}: error: the theory cannot be written\n", file.string());
    return false;
  }

  const DiffOptions& options_;
  const std::vector<Contender>& contenders_;
  std::filesystem::path folder_;
  std::size_t count_ = 0;
  nlohmann::ordered_json found_ = nlohmann::ordered_json::array();
};

std::string ReasonersOption(const std::vector<Contender>& contenders) {
  std::vector<std::string> names;
  for (const Contender& contender : contenders) names.push_back(contender.name);
  return fmt::format("--reasoners '{}'", fmt::join(names, ","));
}

int Finish(const DiffOptions& options, const Findings& findings, std::string_view what,
           std::uint64_t compared, const nlohmann::ordered_json& undecided) {
  if (options.json) {
    const nlohmann::ordered_json report{
        {what, compared}, {"undecided", undecided}, {"disagreements", findings.found()}};
    fmt::print("{}\n", report.dump(2));
  } else {
    fmt::print("{} {} compared: {} disagreements\nnot decided within the budget:", compared, what,
               findings.count());
    if (undecided.is_number()) fmt::print(" {}", undecided.get<std::uint64_t>());
    if (undecided.is_object()) {
      for (const auto& [name, count] : undecided.items()) {
        fmt::print(" {} {}", name, count.get<std::uint64_t>());
      }
    }
    fmt::print("\n");
  }
  return findings.count() == 0 ? kDone : kDiverged;
}

int DiffRandom(const DiffOptions& options, const std::vector<Contender>& contenders,
               const std::filesystem::path& folder) {
  Findings findings(options, contenders, folder);
  Progress progress("diff-reasoners", options.quiet);
  nlohmann::ordered_json undecided = nlohmann::ordered_json::object();
  for (const Contender& contender : contenders) undecided[contender.name] = 0;
  for (std::uint64_t i = 0; i < options.random; ++i) {
    logic::SymbolTable symbols;
    const std::uint64_t number = options.from + i;
    const DiffTheory theory = MakeRandomTheory(options.seed, number, symbols);
    std::vector<Verdict> verdicts;
    for (const Contender& contender : contenders) {
      verdicts.push_back(Judge(contender, theory, symbols, folder));
      if (verdicts.back().kind == Verdict::Kind::kDecided) continue;
      undecided[contender.name] = undecided[contender.name].get<int>() + 1;
    }
    bool reported = false;
    for (std::size_t a = 0; a < verdicts.size() && !reported; ++a) {
      for (std::size_t b = a + 1; b < verdicts.size() && !reported; ++b) {
        if (!Disagree(verdicts[a], verdicts[b])) continue;
        reported = true;
        findings.Report(theory, a, b, fmt::format("theory {} of seed {}", number, options.seed),
                        fmt::format("latchwork diff-reasoners --random 1 --from {} --seed {} {}",
                                    number, options.seed, ReasonersOption(contenders)),
                        symbols);
      }
    }
    progress.Update(i + 1, options.random);
  }
  return Finish(options, findings, "theories", options.random, undecided);
}

int DiffRecorded(const DiffOptions& options, const std::vector<Contender>& contenders,
                 const plugin::Registry& registry, const std::filesystem::path& folder) {
  logic::SymbolTable symbols;
  Findings findings(options, contenders, folder);
  JournalReport report;
  {
    Progress progress("diff-reasoners", options.quiet);
    report =
        DiffJournal(options.journal, contenders, registry, symbols,
                    [&](std::uint64_t done, std::uint64_t total) { progress.Update(done, total); });
  }
  if (!report.errors.empty()) {
    fmt::print(stderr, "{}", report.errors);
    return report.exit_code;
  }
  for (const std::string& note : report.notes) fmt::print(stderr, "note: {}\n", note);
  if (report.decisions == 0) {
    fmt::print(stderr,
               "latchwork: nothing of {} could be compared: no decision of a layer whose "
               "theory two of the reasoners take\n",
               options.journal.string());
    return kInvalidInput;
  }
  const std::string command = fmt::format("latchwork diff-reasoners --journal {} {}",
                                          options.journal.string(), ReasonersOption(contenders));
  for (const JournalDifference& difference : report.differences) {
    findings.Report(difference.theory, 0, difference.contender,
                    fmt::format("tick {}, layer {}", difference.tick, difference.layer), command,
                    symbols);
  }
  return Finish(options, findings, "decisions", report.decisions, report.undecided);
}

int Diff(const DiffOptions& options, const Context& context) {
  if ((options.random > 0) == !options.journal.empty()) {
    fmt::print(stderr, "latchwork: give either --random N or --journal FILE\n");
    return kUsage;
  }
  const plugin::Registry registry(
      plugin::MakeSearchPath(context.plugin_folders, context.executable));
  if (!PrepareFolder(options.out)) return kUsage;
  const WorkFolder folder;
  int exit_code = kDone;
  const auto contenders = Contenders(options, registry, folder.path(), exit_code);
  if (exit_code != kDone) return exit_code;
  return options.journal.empty() ? DiffRandom(options, contenders, folder.path())
                                 : DiffRecorded(options, contenders, registry, folder.path());
}

}  // namespace

void AddDiffReasoners(CLI::App& app, Context& context) {
  auto* command = app.add_subcommand("diff-reasoners",
                                     "Compare what reasoners conclude from the same theories");
  auto options = std::make_shared<DiffOptions>();
  command
      ->add_option(
          "--reasoners", options->reasoners,
          "NAME[:PARAMETER=VALUE...],...: the first is the one that a journal's others are "
          "compared with (default pttp,circumscription:mode=bounded)")
      ->delimiter(',');
  command->add_option("--random", options->random, "So many small random theories");
  command->add_option("--seed", options->seed, "Of the random theories (default 1)");
  command->add_option("--from", options->from, "The number of the first of them (default 0)");
  command->add_option("--journal", options->journal,
                      "The decisions of a recorded run, made anew from its latches");
  command->add_option("--out", options->out, "Folder for the smallest theories (default .)");
  command->add_flag("--json", options->json, "Print the findings as JSON");
  command->add_flag("-q,--quiet", options->quiet, "No progress");
  command->footer(
      "Reasoners disagree when both decide, within their budgets, and conclude different things. "
      "Each\n"
      "disagreement is shrunk to a smallest theory and written as a file that prove reads. Exit "
      "code 6:\n"
      "they disagree; 3: nothing of the journal could be compared. A reasoner whose program is not "
      "installed is left out.\n\n"
      "Examples:\n"
      "  latchwork diff-reasoners --random 1000 --reasoners "
      "pttp,circumscription:mode=bounded,eprover,swipl\n"
      "  latchwork diff-reasoners --journal out/far/run.journal --reasoners "
      "pttp,circumscription\n");
  command->callback([options, &context] { context.exit_code = Diff(*options, context); });
}

}  // namespace latchwork::app
