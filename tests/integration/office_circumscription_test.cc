// SPDX-License-Identifier: BSD-3-Clause
//
// The office agent on the circumscription engine: it arrives unharmed, and says in each cycle what
// the same theories give on the prover.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/record/journal_reader.h"
#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

using nlohmann::json;
using test::TemporaryFolder;

constexpr const char* kExamples = LATCHWORK_SOURCE_DIR "/examples/office/";

/// Runs an agent of the office; expects it to arrive unharmed.
void Run(const TemporaryFolder& folder, const std::string& agent, const std::string& out,
         std::vector<std::string> more) {
  std::vector<std::string> arguments{"run", kExamples + agent, "--out", out, "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const CommandResult result = RunLatchwork(arguments, folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto summary = json::parse(ReadText(folder.path() / (out + "/summary.json")));
  EXPECT_EQ(summary.at("outcome"), "reached");
  EXPECT_EQ(summary.at("collisions"), 0);
}

/// What each layer concluded in each of its cycles, as text.
std::vector<std::string> ConclusionsOf(const std::filesystem::path& journal) {
  record::JournalReader reader(journal);
  std::vector<std::string> lines;
  while (const auto frame = reader.Next()) {
    if (frame->kind != record::JournalFrame::Kind::kTick) continue;
    const json tick = json::parse(frame->json);
    if (!tick.contains("decisions")) continue;
    for (const json& decision : tick.at("decisions")) {
      std::string line = std::to_string(frame->tick) + " " +
                         decision.at("layer").get<std::string>() + " " +
                         decision.at("status").get<std::string>();
      for (const json& conclusion : decision.value("conclusions", json::array())) {
        line += " " + conclusion.at("fact").get<std::string>();
      }
      lines.push_back(std::move(line));
    }
  }
  EXPECT_FALSE(reader.problem().has_value());
  return lines;
}

/// No bound is hit in these runs, so that proof and minimal models cannot differ.
void ExpectTheProversConclusions(const std::string& agent, const std::string& seed) {
  const TemporaryFolder folder;
  Run(folder, agent, "proved", {"--seed", seed});
  Run(folder, agent, "closed",
      {"--seed", seed, "--scenario", std::string(kExamples) + "circumscription.xml"});
  const auto proved = ConclusionsOf(folder.path() / "proved/run.journal");
  const auto closed = ConclusionsOf(folder.path() / "closed/run.journal");
  ASSERT_GT(proved.size(), 1000U);
  EXPECT_EQ(closed, proved);
}

TEST(OfficeCircumscriptionTest, SameFloor) { ExpectTheProversConclusions("scenario1.xml", "1"); }
TEST(OfficeCircumscriptionTest, OneFloorUp) { ExpectTheProversConclusions("scenario2.xml", "2"); }
TEST(OfficeCircumscriptionTest, AnotherFloor) { ExpectTheProversConclusions("scenario3.xml", "3"); }
TEST(OfficeCircumscriptionTest, ABadDay) { ExpectTheProversConclusions("events.xml", "1"); }

json Reflex(const TemporaryFolder& folder, std::vector<std::string> more, int exit_code) {
  std::vector<std::string> arguments{
      "run", std::string(kExamples) + "reflex.xml", "--out", "out", "--quiet", "--seed", "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  EXPECT_EQ(RunLatchwork(arguments, folder.path()).exit_code, exit_code);
  return json::parse(ReadText(folder.path() / "out/summary.json"));
}

/// A bound that is too low assumes the wall away, which is counted; minimal models do not.
TEST(OfficeCircumscriptionTest, ABoundTooLowAssumesTheWallAway) {
  const TemporaryFolder folder;
  const json exact = Reflex(folder, {}, 0);
  EXPECT_EQ(exact.at("collisions"), 0);
  EXPECT_EQ(exact.at("layers").at(0).at("assumed_by_bound"), 0);
  EXPECT_GT(exact.at("layers").at(0).at("retracted"), 0);
  const json bounded = Reflex(folder, {"--scenario", std::string(kExamples) + "bounded.xml"}, 1);
  EXPECT_EQ(bounded.at("collisions"), 1);
  EXPECT_GT(bounded.at("layers").at(0).at("assumed_by_bound"), 0);
  EXPECT_EQ(bounded.at("layers").at(0).at("retracted"), 0);
}

}  // namespace
}  // namespace latchwork::testing
