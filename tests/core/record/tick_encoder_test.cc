// SPDX-License-Identifier: BSD-3-Clause
#include "core/record/tick_encoder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/record/frame.h"
#include "tests/core/record/sample_run.h"

namespace latchwork::record::testing {
namespace {

using schedule::testing::kWorld;

class TickEncoderTest : public ::testing::Test {
 protected:
  SampleAgent fake_{{}};
  schedule::Agent agent_ = std::move(*fake_.Assemble().agent);
  TickEncoder encoder_{agent_};
  schedule::TickRecord record_;
};

TEST_F(TickEncoderTest, EmptyTickIsItsNumber) {
  record_.tick = 5;
  EXPECT_EQ(encoder_.Encode(record_), R"j({"tick":5})j");
}

TEST_F(TickEncoderTest, WritesWhatWentWrong) {
  record_.events = {{fake_.Fact("shut"), ""}, {fake_.Fact("open"), "no door"}};
  record_.latched = {{0, 0, 9, true, {}}};
  record_.refused = {{{0, 0}, fake_.Fact("bad"), "why"}, {{kWorld, 0}, fake_.Fact("worse"), ""}};
  record_.inhibited = {{0, 0}};
  record_.faults = {{0, 0, "r", schedule::FaultKind::kException, "a \"b\"\n"},
                    {0, kWorld, "w", schedule::FaultKind::kTimeout, "late"}};
  EXPECT_EQ(
      encoder_.Encode(record_),
      R"j({"tick":0,"events":[{"fact":"shut"},{"fact":"open","problem":"no door"}],)j"
      R"j("latched":[{"layer":"avoid","latch":"sonar","stale":true,"facts":[],"version":9}],)j"
      R"j("refused":[{"layer":"avoid","latch":"sonar","fact":"bad","reason":"why"},)j"
      R"j({"effector":"drive","fact":"worse","reason":""}],)j"
      R"j("inhibited":[{"layer":"avoid","port":"motion"}],)j"
      R"j("faults":[{"layer":"avoid","plugin":"r","kind":"exception",)j"
      R"j("message":"a \"b\"\u000a"},{"plugin":"w","kind":"timeout","message":"late"}]})j");
}

TEST_F(TickEncoderTest, WritesTheFallback) {
  sdk::Decision decision;
  decision.status = sdk::Status::kFailed;
  decision.limit = sdk::Limit::kInferences;
  decision.message = "out of work";
  decision.conclusions = {{17, fake_.Fact("what"), {}}};
  const std::vector<sdk::Batch> said = {{true, {fake_.Fact("halt")}}};
  record_.decisions = {{0, &decision, true, said}};
  EXPECT_EQ(encoder_.Encode(record_),
            R"j({"tick":0,"decisions":[{"layer":"avoid","status":"failed","limit":"inferences",)j"
            R"j("conclusions":[{"fact":"what"}],"inferences":0,"depth":0,"attachment_calls":0,)j"
            R"j("message":"out of work","fallback":{"motion":["halt"]}}]})j");
}

TEST_F(TickEncoderTest, WritesWhatIsUndecided) {
  sdk::Decision decision;
  decision.status = sdk::Status::kUnknown;
  decision.undecided = {{0, fake_.Fact("halt"), {}}, {0, fake_.Fact("go"), {}}};
  decision.states = {{}, {0, 1}};
  record_.decisions = {{0, &decision, false, {}}};
  const sdk::Undecided undecided = {{fake_.Fact("echo")}, {{0}}};
  record_.latched = {{0, 0, 1, false, {}, &undecided}};
  EXPECT_EQ(encoder_.Encode(record_),
            R"j({"tick":0,"latched":[{"layer":"avoid","latch":"sonar","facts":[],)j"
            R"j("undecided":["echo"],"states":[[0]],"version":1}],)j"
            R"j("decisions":[{"layer":"avoid","status":"unknown",)j"
            R"j("undecided":[{"port":"motion","fact":"halt"},{"port":"motion","fact":"go"}],)j"
            R"j("states":[[],[0,1]],"inferences":0,"depth":0,"attachment_calls":0}]})j");
}

TEST_F(TickEncoderTest, WritesCommandsThatChange) {
  std::vector<sdk::Batch> commands(1);
  record_.commands = commands;
  EXPECT_EQ(encoder_.Encode(record_), R"j({"tick":0})j");
  commands[0].facts = {fake_.Fact("halt")};
  EXPECT_EQ(encoder_.Encode(record_), R"j({"tick":0,"commands":{"drive":["halt"]}})j");
  EXPECT_EQ(encoder_.Encode(record_), R"j({"tick":0})j");
  commands[0].facts.clear();
  EXPECT_EQ(encoder_.Encode(record_), R"j({"tick":0,"commands":{"drive":[]}})j");
}

TEST_F(TickEncoderTest, AnyBytesGiveJson) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::string text = {static_cast<char>(byte), 'x', static_cast<char>(byte)};
    record_.faults = {{0, kWorld, text, schedule::FaultKind::kException, text}};
    EXPECT_TRUE(IsShallowJson(encoder_.Encode(record_))) << byte;
  }
  record_.faults = {{0, kWorld, "é \xe2\x82\xac \xf0\x9f\x99\x82", {}, "\xed\xa0\x80\xc3"}};
  EXPECT_THAT(encoder_.Encode(record_),
              ::testing::HasSubstr("\"é \xe2\x82\xac \xf0\x9f\x99\x82\""));
  EXPECT_TRUE(IsShallowJson(encoder_.Encode(record_)));
}

TEST_F(TickEncoderTest, MeasuresAreExactNumbersOrNull) {
  schedule::RunResult result;
  result.state = schedule::RunResult::State::kReached;
  result.message = "there";
  result.ticks = 12;
  result.measures = {{"a", 0.1}, {"b", NAN}, {"c", std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(encoder_.EncodeEnd(result),
            R"j({"end":{"outcome":"reached","message":"there","ticks":12,)j"
            R"j("measures":{"a":0.1,"b":null,"c":null}}})j");
}

}  // namespace
}  // namespace latchwork::record::testing
