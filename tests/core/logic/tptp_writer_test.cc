// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "latchwork/logic/tptp.h"
#include "tests/core/logic/random_formula.h"

namespace latchwork::logic {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

TEST(TptpWriterTest, RandomFormulas_ReadBackEqual) {
  SymbolTable symbols;
  RandomFormula random(symbols, 42);
  for (int i = 0; i < 500; ++i) {
    const std::vector<AnnotatedFormula> formulas = {random.Next(5)};
    const std::string text = WriteTptp(formulas);
    const TptpFile file = ReadTptp(text, "written.p", symbols);
    ASSERT_THAT(Format(file.diagnostics), IsEmpty());
    ASSERT_THAT(file.formulas, SizeIs(1));
    EXPECT_EQ(ToString(file.formulas[0].formula), ToString(formulas[0].formula));
    EXPECT_EQ(file.formulas[0].variable_names, formulas[0].variable_names);
    EXPECT_EQ(WriteTptp(file.formulas), text);
  }
}

TEST(TptpWriterTest, WrittenText_ReadsBackTheSame) {
  SymbolTable symbols;
  const std::string text =
      "cnf('A name', negated_conjecture, p(X) | q(X, Y) | a != \"b\").\n"
      "cnf(12, axiom, $false).\n"
      "fof(c, conjecture, ! [X] : (? [Y] : p(X, Y) & ~ (r <=> 'S'(-0.0, 1e-07)))).\n";
  EXPECT_EQ(WriteTptp(ReadTptp(text, "t", symbols).formulas), text);
}

TEST(TptpWriterTest, SameNamesOfVariables_AreToldApart) {
  SymbolTable symbols;
  AnnotatedFormula formula;
  formula.name = "f";
  formula.variable_names = {"X", "X", "lower"};
  const Symbol p = symbols.Intern("p");
  formula.formula =
      Formula::Forall({0, 1, 2}, Formula::Of(Atom(p, {Term::Var(0), Term::Var(1), Term::Var(2)})));
  EXPECT_EQ(WriteTptp(std::vector{formula}), "fof(f, axiom, ! [X, X_1, X2] : p(X, X_1, X2)).\n");
}

TEST(TptpWriterTest, Clause_IsWrittenAsCnf) {
  SymbolTable symbols;
  Clause clause;
  clause.name = "c";
  clause.role = Role::kNegatedConjecture;
  clause.variable_names = {"X"};
  clause.literals = {{false, Atom(symbols.Intern("p"), {Term::Var(0)})}};
  EXPECT_EQ(WriteTptp(clause), "cnf(c, negated_conjecture, ~ p(X)).\n");
}

}  // namespace
}  // namespace latchwork::logic
