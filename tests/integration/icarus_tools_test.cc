// SPDX-License-Identifier: BSD-3-Clause
//
// `latchwork icarus` where it meets layers, traces and cycles that wait.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

class IcarusToolsTest : public ::testing::Test {
 protected:
  void Write(const std::string& file, const std::string& text) {
    WriteText(scratch_.path() / file, text);
  }
  CommandResult Run(const std::string& command) { return RunShell(command, scratch_.path()); }

  test::TemporaryFolder scratch_;
};

TEST_F(IcarusToolsTest, CheckLayer_FindsWhatTheContractDoesNotHave) {
  Write("p.icarus",
        "(Seek () :requires ((move_cmd ?x ?) (bind ?_d {baering ?x})) :means ((Push)))\n"
        "(Push () :action ({objekt push}))\n(never (move_cmd 1))\n(never (sonar_reading ? ?))\n");
  EXPECT_EQ(Run("latchwork icarus check p.icarus").exit_code, 0);
  const CommandResult result = Run("latchwork icarus check --layer seek p.icarus");
  EXPECT_EQ(result.exit_code, 3);
  for (const char* said :
       {"p.icarus:1:1: error[I030]", "p.icarus:1:47: error[I028]", "did you mean {bearing}?",
        "p.icarus:2:19: error[I028]", "p.icarus:3:8: error[I031]", "p.icarus:4:9: error[I032]"}) {
    EXPECT_NE(result.err.find(said), std::string::npos) << said << '\n' << result.err;
  }
}

TEST_F(IcarusToolsTest, CheckLayer_TakesAProgramThatFulfilsTheContract) {
  Write("p.icarus",
        "(top (Seek))\n(Seek () :requires ((move_cmd ? ?) (push_distance ?_d)) :means ((Push)))\n"
        "(Push () :action ({object push}))\n");
  const CommandResult result = Run("latchwork icarus check --werror --layer seek p.icarus");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "p.icarus: ok: 2 skills, 0 constants, 0 facts\n");
  EXPECT_EQ(Run("latchwork icarus check --layer sek p.icarus").exit_code, 4);
}

TEST_F(IcarusToolsTest, CheckAgent_ChecksTheProgramOfEachLayer) {
  const CommandResult office = RunShell(
      "latchwork icarus check --werror examples/office/scenario1.xml --scenario "
      "examples/office/icarus.xml",
      LATCHWORK_SOURCE_DIR);
  EXPECT_EQ(office.exit_code, 0) << office.err;
  for (const char* layer : {"avoid", "seek", "elevators", "itinerary"}) {
    const std::string line = std::string(layer) + ": " + layer + ".icarus: ok: ";
    EXPECT_NE(office.out.find(line), std::string::npos) << office.out;
  }
  const CommandResult theories =
      RunShell("latchwork icarus check examples/office/scenario1.xml", LATCHWORK_SOURCE_DIR);
  EXPECT_EQ(theories.exit_code, 0);
  EXPECT_EQ(theories.out,
            "examples/office/scenario1.xml: ok: no layer has an Icarus program for a body\n");
}

TEST_F(IcarusToolsTest, CheckAgent_SaysWhatIsWrongWithTheAgent) {
  Write("a.xml", "<agent");
  EXPECT_EQ(Run("latchwork icarus check a.xml").exit_code, 3);
  EXPECT_EQ(Run("latchwork icarus check b.xml").exit_code, 3);
}

TEST_F(IcarusToolsTest, Recognise_ReadsATraceAsItReadsAScript) {
  const std::string plans =
      "(Spills () :objective ((Collide)) :means ((Lap)))\n"
      "(Peace () :requires ((*not* (Avoid))) :means ((Lap)))\n"
      "(Collide () :requires ({close}) :means ((Bump)))\n"
      "(Avoid () :requires ({close}) :means ((Swerve)))\n"
      "(Bump () :action ({bump}))\n(Swerve () :action ({swerve}))\n(Lap () :action ({lap}))\n";
  Write("p.icarus", plans);
  Write("w.world", "(top (Peace))\n(cycle (answer {close} nil))\n(cycle (answer {close} t))\n");
  Write("s.world",
        "(cycle (answer {close} nil) (expect {lap}))\n(cycle (answer {close} t) (expect "
        "{swerve}))\n");
  const std::string tops = " p.icarus --top '(Spills)' --top '(Peace)'";
  const CommandResult traced =
      Run("latchwork icarus trace p.icarus --script w.world --json > t.jsonl && "
          "latchwork icarus recognise t.jsonl" +
          tops);
  EXPECT_EQ(traced.exit_code, 0) << traced.err;
  const CommandResult scripted = Run("latchwork icarus recognise s.world" + tops);
  EXPECT_EQ(traced.out, scripted.out);
  EXPECT_NE(traced.out.find("2/2       1.00  (Peace)"), std::string::npos) << traced.out;
  Write("bad.jsonl", "{\"kind\": 1}\n");
  EXPECT_EQ(Run("latchwork icarus recognise bad.jsonl" + tops).exit_code, 3);
  Write("empty.world", "");
  const CommandResult empty = Run("latchwork icarus recognise empty.world" + tops);
  EXPECT_EQ(empty.exit_code, 3) << empty.out;
  EXPECT_NE(empty.err.find("shows nothing"), std::string::npos) << empty.err;
}

TEST_F(IcarusToolsTest, LearnWithoutALearner_SaysItOnce) {
  const std::string learn =
      "latchwork icarus learn " LATCHWORK_SOURCE_DIR "/examples/office/scenario1.xml --layer ";
  const CommandResult none = Run(learn + "avoyd");
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_NE(none.err.find("there is no layer 'avoyd'"), std::string::npos) << none.err;
  EXPECT_EQ(none.err.find("error:"), none.err.rfind("error:")) << none.err;
  const CommandResult other = Run(learn + "avoid");
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_NE(other.err.find("is driven by pttp"), std::string::npos) << other.err;
}

TEST_F(IcarusToolsTest, TopWithoutASkill_IsRefused) {
  Write("p.icarus", "(Peace () :action ({rest}))\n");
  Write("s.world", "(cycle (expect {rest}))\n");
  for (const char* command : {"recognise s.world p.icarus", "run p.icarus --script s.world",
                              "trace p.icarus --script s.world"}) {
    const CommandResult result =
        Run(std::string("latchwork icarus ") + command + " --top '(Peaces)'");
    EXPECT_EQ(result.exit_code, 3) << command << result.out;
    EXPECT_NE(result.err.find("there is no skill 'Peaces'"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("did you mean 'Peace'"), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find("s.world: 1 error"), std::string::npos) << result.err;
  }
}

struct Session : IcarusToolsTest {
  std::string Repl(const std::string& commands) {
    Write("p.icarus",
          "(Top () :requires ((car ?c)) :means ((Ram ?c)))\n(Ram (?c) :means ((Go ?c)))\n"
          "(Go (?c) :action ({go ?c}))\n");
    Write("w.world", "(top (Top))\n(cycle (store (car c1)) (repeat 9))\n");
    Write("commands", commands);
    const CommandResult result = Run("latchwork icarus repl p.icarus --script w.world < commands");
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  }
};

TEST_F(Session, BreakIn_WaitsWithinTheCycle) {
  const std::string out = Repl(
      "break in Go\nbreak in Goo\nbreak\nstep 2\nwhere\nmemory (car ?)\nstore (a)\nnext\n"
      "continue\nfinish\ndelete\nstep\nmemory\nwhere\n");
  EXPECT_EQ(
      out,
      "there is no skill 'Goo'; did you mean 'Go'?\n"
      "1: in Go\n"
      "break in cycle 1:\n"
      "2:19        (Go c1)\n"
      "(Go c1)  [2:19]\n"
      "(Ram c1)  [1:38]\n"
      "(Top)\n"
      "(car c1)\n"
      "a cycle is under way: continue (to the next break), next (event), out (of this skill), "
      "finish (the cycle), where, memory [(F ..)], trace, quit\n"
      "2:19          act {go c1}\n"
      "1: start {go c1}\n"
      "break in cycle 2:\n"
      "2:19        (Go c1)\n"
      "2: continue {go c1}\n"
      "3: continue {go c1}\n"
      "(car c1)\n"
      "'where' is for a break within a cycle; 'break in SKILL' makes one\n");
}

TEST_F(Session, Out_GoesOnToTheEndOfTheSkill) {
  Write("o.icarus",
        "(top (Top))\n(Top () :requires ((Near) (*not* (Far))) :means ((Go)))\n"
        "(Near () :objective ({close} {quiet}))\n(Far () :objective ({far}))\n"
        "(Go () :action ({go}))\n");
  Write("commands",
        "answer {close} t\nanswer {quiet} t\nbreak in Near\nbreak in Far\nstep\nnext\nout\n"
        "continue\nout\ncontinue\nout\n");
  const CommandResult result = Run("latchwork icarus repl o.icarus < commands");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out,
            "break in cycle 1:\n2:20      (Near)\n3:22        {close} = t\n"
            "2:20      (Near) True\nbreak in cycle 1:\n2:34      (Far)\n"
            "2:34      (Far) False\n1: start {go}\n"
            "'out' is for a break within a cycle; 'break in SKILL' makes one\n");
}

TEST_F(Session, Out_EndsWithItsCycle) {
  EXPECT_EQ(Repl("break in Top\nstep\nout\ndelete\ntop (Ram ?)\nstep\nwhere\n"),
            "break in cycle 1:\n        (Top)\n1: start {go c1}\n2: stop {go c1} False\n"
            "p.icarus:3:19: fault in cycle 2: an argument of the call has an unbound variable\n"
            "  in Go < Ram\n'where' is for a break within a cycle; 'break in SKILL' makes one\n");
}

TEST_F(Session, BreakFalse_WaitsWhereTheSkillFails) {
  EXPECT_EQ(Repl("break false Ram\nbreak false Raam\nbreak\nstep\ntop (Ram ?)\nstep\nwhere\n"
                 "finish\nreload\nbreak\n"),
            "there is no skill 'Raam'; did you mean 'Ram'?\n1: false Ram\n1: start {go c1}\n"
            "break in cycle 2:\n        (Ram ?) False\n(Ram ?)\n2: stop {go c1} False\n"
            "p.icarus:3:19: fault in cycle 2: an argument of the call has an unbound variable\n"
            "  in Go < Ram\n3 skills\n1: false Ram\n");
}

TEST_F(Session, Fail_LetsASensorFailUntilItIsAnswered) {
  Write("t.icarus", "(top (See))\n(See () :objective ({eye 1}))\n");
  Write("commands", "fail {eye ?} \"it is dark\"\nstep\nanswer {eye 1} t\nstep\nfail {eye} 3\n");
  const CommandResult result = Run("latchwork icarus repl t.icarus < commands");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out,
            "1: False\nt.icarus:2:21: fault in cycle 1: {eye}: it is dark\n  in See\n2: True\n"
            "this is no item of a cycle\n");
}

TEST_F(Session, QuitOrEndOfInputWithinACycle_EndsTheSession) {
  EXPECT_EQ(Repl("break in Ram\nstep 5\nquit\nstep\n"),
            "break in cycle 1:\n1:38      (Ram c1)\n1: start {go c1}\n");
  EXPECT_EQ(Repl("break in Ram\nrun"), "break in cycle 1:\n1:38      (Ram c1)\n1: start {go c1}\n");
}

}  // namespace
}  // namespace latchwork::testing
