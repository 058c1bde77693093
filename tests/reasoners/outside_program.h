// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_OUTSIDE_PROGRAM_H_
#define LATCHWORK_TESTS_REASONERS_OUTSIDE_PROGRAM_H_

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "core/process/spawn.h"
#include "tests/reasoners/pttp/agent_mind.h"

namespace latchwork {

/// A reasoner over a program that is no part of the project: what all such do alike.
/// `Setting` has the type Reasoner and the names kProgram and kPackage.
template <typename Setting>
class OutsideProgramTest : public ::testing::Test {
 protected:
  using Mind = pttp::MindOf<typename Setting::Reasoner>;

  void SetUp() override {
    if (process::FindProgram(Setting::kProgram).empty()) {
      GTEST_SKIP() << Setting::kPackage << " is not installed";
    }
  }
};

/// Another PATH while it lives.
class PathGuard {
 public:
  explicit PathGuard(const std::string& path) : before_(std::getenv("PATH")) {
    setenv("PATH", path.c_str(), 1);
  }
  PathGuard(const PathGuard&) = delete;
  PathGuard& operator=(const PathGuard&) = delete;
  ~PathGuard() { setenv("PATH", before_.c_str(), 1); }

  const std::string& before() const { return before_; }

 private:
  std::string before_;
};

TYPED_TEST_SUITE_P(OutsideProgramTest);

TYPED_TEST_P(OutsideProgramTest, Paths_AllAnswers) {
  typename TestFixture::Mind mind(R"(
    fof(step, axiom, ![X,Y] : (edge(X,Y) => path(X,Y))).
    fof(far, axiom, ![X,Y,Z] : ((edge(X,Y) & path(Y,Z)) => path(X,Z))).
  )");
  mind.Input("edge", 2);
  mind.Goal("path(a,X)", sdk::Goal::Answers::kAll);
  mind.Load();
  mind.Latch(0, {"edge(a,'B 1')", "edge('B 1',-1.5)", "edge(-1.5,f(7))", "edge(f(7),a)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.Conclusions(), ::testing::UnorderedElementsAre("path(a, 'B 1')", "path(a, -1.5)",
                                                                  "path(a, f(7))", "path(a, a)"));
  mind.Latch(0, {"edge(b,c)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
}

TYPED_TEST_P(OutsideProgramTest, NumbersThatComeByOnce_LeaveNothingBehind) {
  typename TestFixture::Mind mind("fof(a, axiom, ![X] : (in(X) => out(X))).");
  mind.Input("in", 1);
  mind.Goal("out(X)", sdk::Goal::Answers::kAll);
  mind.Load();
  mind.Latch(0, {"in(0.5)", "in(7)"});
  mind.Decide();
  const std::size_t symbols = mind.symbols.size();
  mind.Latch(0, {"in(-0.25)", "in(1e-300)", "in(2.5e+20)", "in(-123456789)"});
  mind.Decide();
  EXPECT_THAT(mind.Conclusions(),
              ::testing::UnorderedElementsAre("out(-0.25)", "out(1e-300)", "out(2.5e+20)",
                                              "out(-123456789)"));
  EXPECT_EQ(mind.symbols.size(), symbols);
}

TYPED_TEST_P(OutsideProgramTest, DefaultIsMadeRetractedAndRestored) {
  using State = sdk::Assumption::State;
  typename TestFixture::Mind mind(R"(
    fof(forward, axiom, ![V] : ((speed(V) & ~ halt_robot) => fwd(V))).
    fof(halt, axiom, ![O] : (ahead(O) => halt_robot)).
  )");
  mind.Input("speed", 1);
  mind.Input("ahead", 1);
  mind.Minimize("halt_robot", 0);
  mind.Goal("fwd(V)");
  mind.Load();
  mind.Latch(0, {"speed(0.5)"});
  mind.Latch(1, {});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  ASSERT_EQ(mind.decision.assumptions.size(), 1U);
  EXPECT_EQ(mind.decision.assumptions[0].state, State::kMade);
  mind.Latch(1, {"ahead(wall)"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
  ASSERT_EQ(mind.decision.assumptions.size(), 1U);
  EXPECT_EQ(mind.decision.assumptions[0].state, State::kRetracted);
  mind.Latch(1, {});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
}

TYPED_TEST_P(OutsideProgramTest, Cancellation_IsHeard) {
  typename TestFixture::Mind mind("fof(a, axiom, p).");
  mind.Goal("p");
  mind.Load();
  const std::atomic<bool> cancelled = true;
  mind.budget.cancelled = &cancelled;
  EXPECT_EQ(mind.Decide().limit, sdk::Limit::kCancelled);
}

TYPED_TEST_P(OutsideProgramTest, Contradictions_AreReportedAndRefused) {
  typename TestFixture::Mind mind("fof(both, axiom, ~ (hot & cold)). fof(a, axiom, warm => hot).");
  mind.Input("warm", 0);
  mind.Input("cold", 0);
  mind.Goal("hot");
  mind.Load();
  mind.Latch(0, {"warm"});
  mind.Latch(1, {});
  std::vector<sdk::Refusal> refused;
  const std::vector<logic::Fact> batch = {mind.Atom("warm"), mind.Atom("cold")};
  mind.reasoner.Admit(mind.latches, 1, batch, mind.budget, refused);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].index, 1U);
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  mind.Latch(1, {"cold"});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kInconsistent);
}

TYPED_TEST_P(OutsideProgramTest, TellAndRetract) {
  typename TestFixture::Mind mind("fof(a, axiom, p => q).");
  mind.Input("p", 0);
  mind.Goal("q");
  mind.Load();
  mind.Latch(0, {});
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
  EXPECT_THAT(mind.reasoner.Tell("fof(b, axiom, q)."), ::testing::IsEmpty());
  EXPECT_EQ(mind.Decide().status, sdk::Status::kProved);
  EXPECT_THAT(mind.reasoner.Retract("b"), ::testing::IsEmpty());
  EXPECT_EQ(mind.Decide().status, sdk::Status::kRefuted);
}

REGISTER_TYPED_TEST_SUITE_P(OutsideProgramTest, Paths_AllAnswers,
                            NumbersThatComeByOnce_LeaveNothingBehind,
                            DefaultIsMadeRetractedAndRestored, Cancellation_IsHeard,
                            Contradictions_AreReportedAndRefused, TellAndRetract);

/// The same where there is no such program.
template <typename Setting>
class AbsentProgramTest : public ::testing::Test {};

TYPED_TEST_SUITE_P(AbsentProgramTest);

TYPED_TEST_P(AbsentProgramTest, SaysWhatToInstall) {
  const PathGuard guard("/nowhere");
  pttp::MindOf<typename TypeParam::Reasoner> mind("fof(a, axiom, p).");
  mind.Goal("p");
  const auto diagnostics = mind.TryLoad();
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_THAT(diagnostics[0].hint, ::testing::HasSubstr("apt-get install"));
  EXPECT_THAT(diagnostics[0].hint, ::testing::EndsWith(TypeParam::kPackage));
}

REGISTER_TYPED_TEST_SUITE_P(AbsentProgramTest, SaysWhatToInstall);

}  // namespace latchwork

#endif  // LATCHWORK_TESTS_REASONERS_OUTSIDE_PROGRAM_H_
