// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/contract_body.h"

#include <gtest/gtest.h>

namespace latchwork::sdk {
namespace {

const ArgumentSpec kAny{"x", ArgumentType::kAny, ""};

TEST(ContractBodyTest, InputsAreThePredicatesOfAllInputPorts) {
  logic::SymbolTable symbols;
  const Contract contract{{PortSpec{.name = "a", .predicates = {{"p", {kAny, kAny}, ""}}},
                           PortSpec{.name = "b", .predicates = {{"q", {}, ""}}}},
                          {}};
  const Body body = ContractBody(contract, "tptp", symbols);
  EXPECT_EQ(body.language, "tptp");
  ASSERT_EQ(body.inputs.size(), 2U);
  EXPECT_EQ(logic::ToString(body.inputs[0]), "p/2");
  EXPECT_EQ(logic::ToString(body.inputs[1]), "q/0");
  EXPECT_TRUE(body.goals.empty());
}

TEST(ContractBodyTest, GoalsLeaveByThePortOfTheirPredicate) {
  logic::SymbolTable symbols;
  const Contract contract{{},
                          {PortSpec{.name = "a", .predicates = {{"halt", {}, ""}}},
                           PortSpec{.name = "b", .predicates = {{"go", {kAny, kAny}, ""}}}}};
  const Body body = ContractBody(contract, "tptp", symbols);
  ASSERT_EQ(body.goals.size(), 2U);
  EXPECT_EQ(logic::ToString(body.goals[0].pattern), "halt");
  EXPECT_EQ(body.goals[0].variables, 0U);
  EXPECT_EQ(body.goals[0].port, 0U);
  EXPECT_EQ(body.goals[1].pattern.arity(), 2U);
  EXPECT_NE(body.goals[1].pattern.argument(0), body.goals[1].pattern.argument(1));
  EXPECT_EQ(body.goals[1].variables, 2U);
  EXPECT_EQ(body.goals[1].port, 1U);
  EXPECT_EQ(body.goals[1].answers, Goal::Answers::kFirst);
}

}  // namespace
}  // namespace latchwork::sdk
