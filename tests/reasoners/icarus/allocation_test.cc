// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tests/reasoners/icarus/allocations.h"
#include "tests/reasoners/icarus/program_mind.h"
#include "tests/reasoners/icarus/test_attachments.h"

namespace latchwork::icarus::testing {
namespace {

using sdk::ArgumentType;
using ::testing::ElementsAre;

constexpr std::string_view kProgram = R"((top (Top))
(Top () :requires ((*not* (Note)) (bind ?s {sum}) (bind (?h ?) {halves ?s})) :means ((Pay ?h)))
(Note () :requires ((price ?x ?p) (Remember ?x ?p) (never)))
(Remember (?x ?p) :sensor ({store (known (of ?x) ?p)} {forget (known (of nobody) ?)}))
(Learnt (?x ?p) :objective ((known ?x ?p)))  ; allow I018
(Pay (?s) :action ({pay ?s} {tell (list ?s)} {store (paid)}))
)";

TEST(IcarusAllocationTest, NothingIsAllocatedOnceWarm) {
  ProgramMind mind(kProgram);
  mind.Input("price", {ArgumentType::kSymbol, ArgumentType::kInteger});
  mind.Input("never", {});
  mind.Output("pay", {ArgumentType::kInteger});
  mind.Output("tell", {ArgumentType::kAny});
  const std::vector<logic::Literal> query = {
      {true, {mind.symbols.Intern("learnt"), {logic::Term::Var(0), logic::Term::Var(1)}}}};
  mind.attachments = {std::make_shared<Halves>(), std::make_shared<Total>("sum", query, 2)};
  mind.Load();
  // Batches that take turns: facts come, go, change and change places.
  std::vector<std::vector<sdk::Latch>> turns;
  for (const auto& batch : std::vector<std::vector<std::string>>{
           {"price(a, 3)", "price(b, 4)"}, {"price(b, 4)", "price(a, 3)", "price(c, 7)"}, {}}) {
    mind.Latch(0, batch);
    turns.push_back(mind.latches);
  }
  const auto cycles = [&] {
    for (int i = 0; i < 20; ++i) {
      for (const auto& latches : turns) {
        mind.reasoner.Decide(latches, mind.budget, mind.decision);
        ASSERT_EQ(mind.decision.status, sdk::Status::kProved) << mind.decision.message;
      }
    }
  };
  cycles();
  const std::size_t before = Allocations();
  cycles();
  EXPECT_EQ(Allocations() - before, 0U);
  EXPECT_THAT(mind.decision.conclusions.size(), 2U);
}

}  // namespace
}  // namespace latchwork::icarus::testing
