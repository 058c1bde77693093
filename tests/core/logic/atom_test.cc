// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/logic/atom.h"

#include <gtest/gtest.h>

#include "latchwork/logic/clause.h"

namespace latchwork::logic {
namespace {

class AtomTest : public testing::Test {
 protected:
  Symbol Name(std::string_view name) { return symbols_.Intern(name); }
  Term Constant(std::string_view name) { return Term::Constant(Name(name)); }

  SymbolTable symbols_;
};

TEST_F(AtomTest, ToString_IsTptp) {
  EXPECT_EQ(ToString(Atom(Name("halt"))), "halt");
  EXPECT_EQ(ToString(Atom(Name("p"), {Constant("a"), Term::Integer(1)})), "p(a, 1)");
  EXPECT_EQ(ToString(Atom(Name("="), {Constant("a"), Term::Var(0)})), "a = X0");
  EXPECT_EQ(ToString(NameOf(Atom(Name("p"), {Constant("a")}))), "p/1");
  EXPECT_EQ(ToString(PredicateName{Name("P q"), 2}), "'P q'/2");
}

TEST_F(AtomTest, ManyArguments_AreKept) {
  std::vector<Term> arguments;
  for (int i = 0; i < 6; ++i) arguments.push_back(Term::Integer(i));
  const Atom atom(Name("p"), arguments);
  EXPECT_EQ(atom.arity(), 6U);
  EXPECT_EQ(atom.argument(5), Term::Integer(5));
  EXPECT_EQ(Atom(atom), atom);
  EXPECT_EQ(ToString(atom), "p(0, 1, 2, 3, 4, 5)");
  EXPECT_TRUE(atom.is_ground());
}

TEST_F(AtomTest, Equality_SeesNameArityAndArguments) {
  const Atom atom(Name("p"), {Constant("a")});
  EXPECT_EQ(atom, Atom(Name("p"), {Constant("a")}));
  EXPECT_NE(atom, Atom(Name("q"), {Constant("a")}));
  EXPECT_NE(atom, Atom(Name("p"), {Constant("b")}));
  EXPECT_NE(atom, Atom(Name("p"), {Constant("a"), Constant("a")}));
  EXPECT_FALSE(Atom(Name("p"), {Term::Var(0)}).is_ground());
}

TEST_F(AtomTest, Order_IsByNameThenArityThenArguments) {
  EXPECT_LT(Atom(Name("p"), {Constant("z")}), Atom(Name("q")));
  EXPECT_LT(Atom(Name("p")), Atom(Name("p"), {Constant("a")}));
  EXPECT_LT(Atom(Name("p"), {Constant("a")}), Atom(Name("p"), {Constant("b")}));
}

TEST_F(AtomTest, Literals_PrintAsTptp) {
  const Atom equation(Name("="), {Constant("a"), Constant("b")});
  EXPECT_EQ(ToString(Literal{true, equation}), "a = b");
  EXPECT_EQ(ToString(Literal{false, equation}), "a != b");
  EXPECT_EQ(ToString(Literal{false, Atom(Name("p"))}), "~ p");
}

TEST_F(AtomTest, Clauses_PrintAsTptp) {
  Clause clause;
  EXPECT_EQ(ToString(clause), "$false");
  clause.literals = {{true, Atom(Name("p"), {Term::Var(0)})}, {false, Atom(Name("q"))}};
  clause.variable_names = {"Who"};
  EXPECT_EQ(ToString(clause), "p(Who) | ~ q");
}

}  // namespace
}  // namespace latchwork::logic
