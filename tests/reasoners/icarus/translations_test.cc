// SPDX-License-Identifier: BSD-3-Clause
//
// Teleo-reactive trees and universal plans act as their translations do.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "reasoners/icarus/tools/world_script.h"
#include "reasoners/icarus/translations/translate.h"
#include "tests/reasoners/icarus/random_plan.h"

namespace latchwork::icarus::testing {
namespace {

constexpr std::size_t kSensors = 5;

/// {s i x} says what bit i of `state` says.
class StateHost : public Host {
 public:
  std::span<const Signature> functions() const override {
    static constexpr std::array<Signature, 1> kFunctions = {{{"s", 2, 2}}};
    return kFunctions;
  }
  Value Call(std::size_t /*function*/, std::span<const Value> arguments, Arena& /*arena*/,
             NamePool& /*names*/) override {
    const bool holds = (state >> static_cast<std::uint32_t>(arguments[0].integer) & 1U) != 0;
    return holds ? Value::Integer(1) : Value();
  }
  SensorState state = 0;
};

std::string Translated(const std::string& text) {
  const ReactivePlanFile file = ReadReactivePlans(text, "plans");
  for (const Finding& finding : file.findings) ADD_FAILURE() << Format(finding) << text;
  return TranslateToIcarus(file);
}

/// What the translation comes to in every state of the sensors.
std::vector<std::string> ActsInAllStates(const std::string& program) {
  const ProgramFile file = ReadProgram(program, "p.icarus");
  EXPECT_FALSE(HasErrors(file.findings)) << program;
  NamePool names;
  StateHost host;
  Interpreter interpreter(file.program, host, names, {});
  Findings findings;
  const std::size_t top = interpreter.AddTop("(Main c)", findings);
  std::vector<std::string> acts;
  for (; host.state < 1U << kSensors; ++host.state) {
    const CycleResult& result = interpreter.Cycle(top);
    EXPECT_EQ(result.fault_count, 0U);
    const std::string truth = result.environments > 0 ? "true" : "";
    acts.push_back(result.acts.empty() ? truth : ToString(result.acts[0], names));
  }
  return acts;
}

/// `{a ?x 3}` called with c.
std::string Instantiated(std::string act) {
  const std::size_t at = act.find("?x");
  return at == std::string::npos ? act : act.replace(at, 2, "c");
}

template <typename Plan>
void CompareInAllStates(std::size_t count) {
  std::size_t acting = 0;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const Plan plan(seed, kSensors);
    const std::string program = Translated(plan.Text());
    const std::vector<std::string> acts = ActsInAllStates(program);
    for (SensorState state = 0; state < acts.size(); ++state) {
      ASSERT_EQ(acts[state], Instantiated(plan.Act(state))) << "state " << state << '\n'
                                                            << plan.Text() << program;
      acting += acts[state].starts_with('{') ? 1 : 0;
    }
  }
  EXPECT_GT(acting, count * 4) << "the plans do too little to say anything";
}

TEST(IcarusTranslationsTest, RandomTrees_ActLikeTheirTranslationsInAllStates) {
  CompareInAllStates<RandomTree>(2000);
}

TEST(IcarusTranslationsTest, RandomUniversalPlans_ActLikeTheirTranslationsInAllStates) {
  CompareInAllStates<RandomUniversalPlan>(2000);
}

TEST(IcarusTranslationsTest, NamesAndVariables_AreKeptApart) {
  const std::string program = Translated(
      "(universal-plan Main (?car)\n"
      "  (achieve {hit ?car} (by {ram ?car ?p} (if (driver ?car ?p) (not (friend ?p)))\n"
      "    (achieve {near ?car ?p} (by {do-ram} (if {clear}))) (Calm ?p))))\n"
      "(universal-plan Calm (?who) (achieve (asleep ?who)))\n");
  EXPECT_EQ(program,
            "; Main, a universal plan\n"
            "(Main (?car)\n"
            "  :objective ({hit ?car})\n"
            "  :requires  ((driver ?car ?p) (*not* (friend ?p)) (Main-1 ?car ?p) (Calm ?p))\n"
            "  :means     ((Do-ram-2 ?car ?p)))\n"
            "(Main-1 (?car ?p)\n"
            "  :objective ({near ?car ?p})\n"
            "  :requires  ({clear})\n"
            "  :means     ((Do-do-ram)))\n"
            "\n; Calm, a universal plan\n"
            "(Calm (?who) :objective ((asleep ?who)))\n"
            "\n(Do-do-ram () :action ({do-ram}))\n"
            "(Do-ram-2 (?car ?p) :action ({ram ?car ?p}))\n");
}

TEST(IcarusTranslationsTest, RuleThatCallsAPlan_StopsLaterRulesWhateverThePlanSays) {
  const std::string program = Translated(
      "(teleo-reactive Main (?x) (when {s 0 ?x} do (Reach ?x)) (when do {rest}))\n"
      "(universal-plan Reach (?x) (achieve {s 1 ?x} (by {go ?x} (if {s 2 ?x}))))\n");
  const std::vector<std::string> acts = ActsInAllStates(program);
  EXPECT_EQ(acts[0], "{rest}");
  EXPECT_EQ(acts[0b001], "");
  EXPECT_EQ(acts[0b011], "");
  EXPECT_EQ(acts[0b101], "{go c}");
  EXPECT_EQ(acts[0b110], "{rest}");
}

/// The messages, with their lines.
std::vector<std::string> Mistakes(const std::string& text) {
  std::vector<std::string> mistakes;
  for (const Finding& finding : ReadReactivePlans(text, "plans").findings) {
    mistakes.push_back(std::to_string(finding.diagnostic.place.line) + ": " +
                       finding.diagnostic.message);
  }
  return mistakes;
}

TEST(IcarusTranslationsTest, Mistakes_AreAllReportedWithTheirPlaces) {
  EXPECT_EQ(Mistakes("(teleo-reactiv Main (?x)\n (when do {a}))\n"
                     "(teleo-reactive Main (?x ?x y)\n"
                     " (goal)\n (when {near ?z} do {go})\n (when (Main) do {a ?x} (Other))\n"
                     " (when {near ?x})\n (if {a}))\n"
                     "(universal-plan main () (achieve (by {go ?x} {stop}) (by)))\n"),
            (std::vector<std::string>{
                "1: this is no plan",
                "3: the parameter ?x stands twice",
                "3: a parameter is a variable",
                "4: the goal is empty",
                "5: nothing before this gives ?z a value",
                "6: a condition cannot call a plan",
                "6: this is no act",
                "7: what is to be done is missing",
                "8: this is no part of a teleo-reactive tree",
                "9: the name main is taken",
                "9: what is to be achieved is missing",
                "9: nothing before this gives ?x a value",
                "9: the way has no act",
            }));
  EXPECT_EQ(Mistakes("; nothing\n"), (std::vector<std::string>{"1: the file has no plan"}));
  EXPECT_EQ(Mistakes("(teleo-reactive A (?x)\n (when do (B) ))\n(teleo-reactive B (?y)\n"
                     " (when do (A ?y) {a}))\n(universal-plan C () (achieve {c} (by {c} (A 1))))"),
            (std::vector<std::string>{"2: the plan takes 1 arguments, not 0",
                                      "4: the call of a plan stands alone",
                                      "5: a teleo-reactive tree is no goal that comes true"}));
}

}  // namespace
}  // namespace latchwork::icarus::testing
