// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/config/agent_fixture.h"

namespace latchwork::config {
namespace {

struct Case {
  std::string_view name;
  std::string_view piece;
  std::string_view replacement;
  std::string_view error;
};

std::string NameOfCase(const ::testing::TestParamInfo<Case>& test) {
  return std::string(test.param.name);
}

class SemanticTest : public AgentTest, public ::testing::WithParamInterface<Case> {};

TEST_P(SemanticTest, ReportsExactlyThis) {
  const Case& test = GetParam();
  EXPECT_THAT(Errors(GoodAgentWith(test.piece, test.replacement)),
              ::testing::ElementsAre(test.error));
}

INSTANTIATE_TEST_SUITE_P(
    Plugins, SemanticTest,
    ::testing::Values(
        Case{"UnknownWorld", "\"hall\"", "\"hal\"",
             "2:16: there is no world plugin 'hal' [did you mean 'hall'?]"},
        Case{"UnknownLayer", "plugin=\"avoid\"", "plugin=\"zzzz\"",
             "3:29: there is no layer plugin 'zzzz' [there are avoid, seek]"},
        Case{"UnloadableLayer", "plugin=\"avoid\"", "plugin=\"torn\"",
             "3:29: the layer plugin 'torn' cannot be loaded: file too short"},
        Case{"UnknownReasoner", "\"pttp\"", "\"ptpp\"",
             "4:19: there is no reasoner plugin 'ptpp' [did you mean 'pttp'?]"},
        Case{"NoBodyForReasoner", "\"pttp\"/>", "\"icarus\"/>",
             "7:19: the reasoner 'icarus' reads icarus, but layer 'seek' has no body in it [it has "
             "bodies in tptp]"},
        Case{"NoReasoner", "<reasoner plugin=\"pttp\"/>", "",
             "6:1: layer 'seek' has no reasoner [add <reasoner plugin=\"…\"/>]"},
        Case{"ReasonerWithoutPlugin", "<reasoner plugin=\"pttp\"/>", "<reasoner depth=\"3\"/>",
             "7:1: the reasoner of layer 'seek' names no plugin [there are icarus, pttp]"},
        Case{"UnknownParameter", "name=\"people\"", "name=\"peopel\"",
             "2:35: world 'hall' has no parameter 'peopel' [did you mean 'people'?]"},
        Case{"OutOfRange", "value=\"7\"", "value=\"51\"",
             "2:50: parameter 'people' of world 'hall' must be an integer from 0 to 50, not '51' "
             "[the default is '4']"},
        Case{"ParameterTwice", "</world>", "<param name=\"people\" value=\"8\"/></world>",
             "2:54: parameter 'people' stands twice in this <world> [the first is in line 2]"}),
    NameOfCase);

INSTANTIATE_TEST_SUITE_P(
    Parts, SemanticTest,
    ::testing::Values(
        Case{"SecondWorld", "<event", "<world plugin=\"hall\"/><event",
             "13:1: an agent lives in one world, this is a second one [the first is at "
             "agent.xml:2]"},
        Case{"ZeroTick", "tick=\"100ms\"", "tick=\"0s\"", "1:37: a tick must not be zero"},
        Case{"ZeroPeriod", "period=\"100ms\"", "period=\"0s\"",
             "3:44: a period must not be zero [use the tick or a multiple of it]"},
        Case{"NoMultiple", "period=\"200ms\"", "period=\"0.25s\"",
             "6:42: period '0.25s' is no multiple of the tick (100ms) [use 200ms or 300ms]"},
        Case{"ShorterThanTick", "phase=\"100ms\"", "phase=\"1ms\"",
             "6:56: phase '1ms' is no multiple of the tick (100ms) [use 100ms]"},
        Case{"MinimizedWithoutArity", "</layer>", "<minimize predicate=\"halt\"/></layer>",
             "5:22: 'halt' does not name a predicate with its number of arguments [write it as "
             "halt/0 or halt/1]"},
        Case{"MinimizedTwice", "</layer>",
             "<minimize predicate=\"p/1\"/><minimize predicate=\"p/1\"/></layer>",
             "5:49: <minimize> names 'p/1' twice"},
        Case{"MinimizedAndFixed", "</layer>",
             "<minimize predicate=\"p/1\"/><fix predicate=\"p/1\"/></layer>",
             "5:44: 'p/1' stands in <minimize> and in <fix> [a predicate is minimized, fixed, or "
             "varies]"},
        Case{"FallbackPort", "</layer>",
             "<fallback><fact port=\"mot\">halt</fact></fallback></layer>",
             "5:23: 'avoid' has no output 'mot' [there are motion, chatter]"},
        Case{"FallbackPredicate", "</layer>",
             "<fallback><fact port=\"motion\">hallt</fact></fallback></layer>",
             "5:11: the output 'avoid.motion' does not know 'hallt/0' [did you mean 'halt'?]"},
        Case{"FallbackType", "</layer>",
             "<fallback><fact port=\"motion\">turn(left)</fact></fallback></layer>",
             "5:11: argument A of 'turn' must be a number, not left"},
        Case{"UnknownOverride", "<event", "<override part=\"avid\"/><event",
             "13:17: there is no part 'avid' to override [did you mean 'avoid'?]"},
        Case{"OverrideWorldPeriod", "<event", "<override part=\"world\" period=\"1s\"/><event",
             "13:24: the world has no period [it takes <param> only]"},
        Case{"EventUnknown", "out_of_order(e2)", "out_of_odrer(e2)",
             "13:23: the world 'hall' does not know 'out_of_odrer/1' [did you mean "
             "'out_of_order'?]"},
        Case{"EventArity", "out_of_order(e2)", "out_of_order(e1,e2)",
             "13:23: 'out_of_order' has 1 arguments, not 2 [write out_of_order(E)]"},
        Case{"EventType", "out_of_order(e2)", "out_of_order(2)",
             "13:23: argument E of 'out_of_order' must be a name, not 2"}),
    NameOfCase);

INSTANTIATE_TEST_SUITE_P(
    Wires, SemanticTest,
    ::testing::Values(
        Case{"UnknownPart", "seek.push", "sek.push",
             "10:13: there is no part 'sek' [did you mean 'seek'?]"},
        Case{"UnknownInput", "to=\"avoid.sonar\"", "to=\"avoid.sonr\"",
             "9:30: 'avoid' has no input 'sonr' [did you mean 'sonar'?]"},
        Case{"UnknownTargetPart", "to=\"avoid.sonar\"", "to=\"avoidd.sonar\"",
             "9:30: there is no part 'avoidd' [did you mean 'avoid'?]"},
        Case{"WrongDirection", "from=\"world.sonar\" to=\"avoid.sonar\"",
             "from=\"world.drive\" to=\"avoid.sonar\"",
             "9:13: 'world.drive' is an input, but 'from' takes an output [facts leave by outputs "
             "and sensors and enter by inputs and effectors]"},
        Case{
            "TwoIntoOneLatch", "<event", "<wire from=\"world.sonar\" to=\"avoid.sonar\"/><event",
            "13:30: two wires lead into the latch of 'avoid.sonar' [the first is at agent.xml:9; a "
            "latch has one source]"},
        Case{
            "TwoToOneEffector", "<event", "<wire from=\"avoid.motion\" to=\"world.drive\"/><event",
            "13:31: two wires lead to the effector 'world.drive' [the first is at agent.xml:11; an "
            "effector obeys one source]"},
        Case{"SelfWire", "seek.push", "avoid.chatter",
             "10:1: this wire leads from 'avoid' back to itself [a wire connects two parts]"},
        Case{"Upwards", "from=\"world.pose\"", "from=\"avoid.chatter\"",
             "12:1: this wire leads up, from 'avoid' to the higher layer 'seek' [a higher layer "
             "(later in the file) subsumes a lower one, never the other way round; let the higher "
             "layer read the sensors]"},
        Case{"NothingInCommon", "world.sonar", "world.pose",
             "9:1: the wire from 'world.pose' to 'avoid.sonar' does not fit: no predicate is "
             "declared at both ends [it carries pose; it takes sonar_reading]"},
        Case{
            "OtherArity", "world.sonar", "world.echo",
            "9:1: the wire from 'world.echo' to 'avoid.sonar' does not fit: 'sonar_reading' leaves "
            "as sonar_reading/1 and enters as sonar_reading/2 [the two ports must declare it with "
            "the same number of arguments]"},
        Case{"OtherType", "world.sonar", "world.names",
             "9:1: the wire from 'world.names' to 'avoid.sonar' does not fit: argument 2 of "
             "'sonar_reading' leaves as symbol and enters as real"},
        Case{"OtherUnit", "world.sonar", "world.feet",
             "9:1: the wire from 'world.feet' to 'avoid.sonar' does not fit: argument 2 of "
             "'sonar_reading' leaves in ft and enters in m"},
        Case{"Unwired", "<wire from=\"world.pose\" to=\"seek.pose\"/>", "",
             "6:1: the input 'seek.pose' is not wired [add <wire from=\"world.pose\" "
             "to=\"seek.pose\"/>]"},
        Case{"StaleTooSoon", "stale-after=\"600ms\"", "stale-after=\"100ms\"",
             "10:56: stale-after '100ms' is shorter than the period of 'seek' (200ms) [the latch "
             "would be emptied before every new batch; use two or three periods]"},
        Case{"Uninhibitable", "<event", "<inhibit by=\"seek.push\" output=\"avoid.motion\"/><event",
             "13:33: 'avoid.motion' must not be inhibited [its layer declares it a safety reflex; "
             "subsume the layer's inputs instead]"},
        Case{"InhibitedFromBelow", "<event",
             "<inhibit by=\"avoid.motion\" output=\"seek.push\"/><event",
             "13:1: 'avoid' cannot inhibit 'seek', which is not below it [a higher layer (later in "
             "the file) inhibits a lower one]"},
        Case{"InhibitedSensor", "<event",
             "<inhibit by=\"seek.push\" output=\"world.sonar\"/><event",
             "13:33: 'world.sonar' is a sensor [a layer's output inhibits the output of a lower "
             "layer]"},
        Case{"HoldNothing", "<event",
             "<inhibit by=\"seek.push\" output=\"avoid.chatter\" hold=\"0s\"/><event",
             "13:54: an inhibition that holds for no time does nothing"}),
    NameOfCase);

TEST_F(AgentTest, TwoLayersOfOneNameAreReported) {
  EXPECT_THAT(
      Errors(GoodAgentWith("<event",
                           "<layer name=\"seek\" plugin=\"torn\"><reasoner "
                           "plugin=\"pttp\"/></layer><event")),
      ::testing::ElementsAre("13:14: two layers are called 'seek' [the first is at agent.xml:6]",
                             "13:28: the layer plugin 'torn' cannot be loaded: file too short"));
}

TEST_F(AgentTest, ALayerCalledWorldIsReported) {
  EXPECT_THAT(Errors(GoodAgentWith("<event",
                                   "<layer name=\"world\" plugin=\"torn\"><reasoner "
                                   "plugin=\"pttp\"/></layer><event")),
              ::testing::ElementsAre(
                  "13:14: the name 'world' is reserved for the world [give the layer another name]",
                  "13:29: the layer plugin 'torn' cannot be loaded: file too short"));
}

TEST_F(AgentTest, AnEmptyAgentLacksWorldAndLayers) {
  EXPECT_THAT(Errors("<agent format=\"1\" name=\"a\" duration=\"1s\"/>"),
              ::testing::ElementsAre("0:0: there is no <world> [add <world plugin=\"…\"/>]",
                                     "0:0: there is no <layer> [an agent has at least one]"));
}

}  // namespace
}  // namespace latchwork::config
