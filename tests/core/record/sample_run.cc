// SPDX-License-Identifier: BSD-3-Clause
#include "tests/core/record/sample_run.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <utility>

namespace latchwork::record::testing {
namespace {

using logic::Term;
using schedule::testing::kWorld;
using schedule::testing::Port;
using sdk::ArgumentType;

const std::vector<std::pair<std::string, std::vector<ArgumentType>>> kEcho = {
    {"echo", {ArgumentType::kInteger, ArgumentType::kReal}}};
const std::vector<std::pair<std::string, std::vector<ArgumentType>>> kTurn = {
    {"turn", {ArgumentType::kReal}}};

}  // namespace

SampleAgent::SampleAgent(const Sample& sample) {
  agent.name = "sample";
  agent.file = "agents/sample.xml";
  agent.fingerprint = "0123";
  agent.max_ticks = sample.ticks;
  world->shape = {{Port("drive", kTurn)}, {Port("sonar", kEcho)}};
  AddLayer({Port("sonar", kEcho)}, {Port("motion", kTurn)});
  description(0).name = "avoid";
  Wire({kWorld, 0}, {0, 0});
  Wire({0, 0}, {kWorld, 0});
  world->observe = [this](std::uint64_t tick, std::span<sdk::Batch> sensors) {
    sensors[0].updated = true;
    const double range = static_cast<double>(world->setup.seed) + 0.25 * static_cast<double>(tick);
    sensors[0].facts = {Fact("echo", {Term::Integer(0), Term::Real(range)})};
  };
  world->step = [this, at = sample.reached_at](std::uint64_t tick) {
    world->say_outcome = [reached = tick >= at] {
      return reached ? sdk::Outcome{sdk::Outcome::State::kReached, "there"} : sdk::Outcome{};
    };
  };
  reasoner(0).decide = [this, gain = sample.gain](std::span<const sdk::Latch> latches,
                                                  const sdk::Budget&, sdk::Decision& decision) {
    const double range = latches[0].facts[0].argument(1).real();
    Conclude(decision, 0, Fact("turn", {Term::Real(gain * range)}));
    decision.assumptions.push_back({Fact("blocked"), sdk::Assumption::State::kMade});
    decision.conclusions[0].assumptions = {0};
    decision.statistics = {7, 3, 1};
  };
}

JournalHeader HeaderOf(const schedule::Agent& agent) {
  return MakeHeader(agent, plugin::Registry({}), {{"avoid", "gain", "2"}}, "far.xml", 99);
}

std::string WriteJournal(const Sample& sample, const std::filesystem::path& file) {
  SampleAgent fake(sample);
  schedule::AssembledAgent assembled = fake.Assemble(sample.seed);
  JournalWriter writer(file, HeaderOf(*assembled.agent), *assembled.agent);
  schedule::LockstepOptions options;
  options.threads = sample.threads;
  options.observers.push_back(&writer);
  schedule::Lockstep(std::move(*assembled.agent), options).Run();
  return writer.problem();
}

std::string JournalOf(const Sample& sample) {
  const ::testing::TestInfo* const test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) /
                                     (std::string(test->test_suite_name()) + test->name());
  EXPECT_EQ(WriteJournal(sample, file), "");
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  std::filesystem::remove(file);
  return bytes;
}

JournalReader ReaderOf(std::string_view bytes) {
  return {std::make_unique<std::istringstream>(std::string(bytes)), "run.journal"};
}

std::vector<std::string> Frames(JournalReader& reader) {
  std::vector<std::string> frames;
  while (const auto frame = reader.Next()) frames.emplace_back(frame->json);
  return frames;
}

std::vector<std::size_t> LineStarts(std::string_view bytes) {
  std::vector<std::size_t> starts = {0};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (bytes[i] == '\n') starts.push_back(i + 1);
  }
  return starts;
}

}  // namespace latchwork::record::testing
