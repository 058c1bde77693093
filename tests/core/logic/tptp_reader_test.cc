// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "latchwork/logic/tptp.h"

namespace latchwork::logic {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class TptpReaderTest : public testing::Test {
 protected:
  TptpFile Read(std::string_view text) { return ReadTptp(text, "test.p", symbols_); }

  /// The one formula of a text, as it prints.
  std::string ReadOne(std::string_view text) {
    const TptpFile file = Read(text);
    EXPECT_THAT(Format(file.diagnostics), IsEmpty());
    EXPECT_THAT(file.formulas, SizeIs(1));
    if (file.formulas.size() != 1) return {};
    return ToString(file.formulas[0].formula, file.formulas[0].variable_names);
  }

  std::string ReadFof(const std::string& formula) {
    return ReadOne("fof(n, axiom, " + formula + ").");
  }
  std::string ReadCnf(const std::string& formula) {
    return ReadOne("cnf(n, axiom, " + formula + ").");
  }

  SymbolTable symbols_;
};

TEST_F(TptpReaderTest, Atoms_AreRead) {
  EXPECT_EQ(ReadFof("p"), "p");
  EXPECT_EQ(ReadFof("p(a,f(b),-1,2.5e-3)"), "p(a, f(b), -1, 0.0025)");
  EXPECT_EQ(ReadFof("a=b"), "a = b");
  EXPECT_EQ(ReadFof("a!=b"), "a != b");
  EXPECT_EQ(ReadFof("~ a = b"), "a != b");
  EXPECT_EQ(ReadFof("$true"), "$true");
  EXPECT_EQ(ReadFof("$less(1, $sum(2, +3))"), "$less(1, $sum(2, 3))");
  EXPECT_EQ(ReadFof("'cat'('Dog', \"Obj\", 'it\\'s')"), "cat('Dog', \"Obj\", 'it\\'s')");
  EXPECT_EQ(ReadFof("p(-9223372036854775808)"), "p(-9223372036854775808)");
}

TEST_F(TptpReaderTest, Connectives_AreRead) {
  EXPECT_EQ(ReadFof("a & b & c"), "a & b & c");
  EXPECT_EQ(ReadFof("(a & b) | c"), "(a & b) | c");
  EXPECT_EQ(ReadFof("a => b"), "a => b");
  EXPECT_EQ(ReadFof("a <= b"), "b => a");
  EXPECT_EQ(ReadFof("a <=> b"), "a <=> b");
  EXPECT_EQ(ReadFof("a <~> b"), "~ (a <=> b)");
  EXPECT_EQ(ReadFof("a ~| b"), "~ (a | b)");
  EXPECT_EQ(ReadFof("a ~& b"), "~ (a & b)");
  EXPECT_EQ(ReadFof("~ ~ a & b"), "~ ~ a & b");
}

TEST_F(TptpReaderTest, Quantifiers_BindTightest) {
  EXPECT_EQ(ReadFof("! [X] : p(X) & q"), "! [X] : p(X) & q");
  EXPECT_EQ(ReadFof("! [X,Y] : ? [Z] : (p(X,Z) => q(Y))"), "! [X, Y] : ? [Z] : (p(X, Z) => q(Y))");
  EXPECT_EQ(ReadFof("! [X] :-1 = X"), "! [X] : -1 = X");
}

TEST_F(TptpReaderTest, ShadowedVariable_GetsItsOwnNumber) {
  const TptpFile file = Read("fof(n, axiom, ! [X] : (? [X] : p(X) & q(X))).");
  ASSERT_THAT(file.formulas, SizeIs(1));
  EXPECT_EQ(ToString(file.formulas[0].formula), "! [X0] : (? [X1] : p(X1) & q(X0))");
}

TEST_F(TptpReaderTest, Clauses_AreClosedAndFlat) {
  EXPECT_EQ(ReadCnf("p(X) | ~ q(X,Y)"), "! [X, Y] : (p(X) | ~ q(X, Y))");
  EXPECT_EQ(ReadCnf("( ~ (p) | (q | a != b) )"), "~ p | q | a != b");
  EXPECT_EQ(ReadCnf("$false"), "$false");
}

TEST_F(TptpReaderTest, TypedFormulas_AreReadWithoutTypes) {
  EXPECT_EQ(ReadOne("tff(p_type, type, p: ($int * $real) > $o).\n"
                    "tff(n, axiom, ! [X: $int, Y: $real] : p(X, Y))."),
            "! [X, Y] : p(X, Y)");
}

TEST_F(TptpReaderTest, Numerals_AreReadHoweverTheyAreWritten) {
  EXPECT_EQ(ReadFof("p(0.1, 0.100, +1.50E2, 1E22, -0.0, 000.25e-3, 9007199254740993)"),
            "p(0.1, 0.1, 150.0, 1e+22, -0.0, 0.00025, 9007199254740993)");
}

TEST_F(TptpReaderTest, Roles_FoldIntoThree) {
  const TptpFile file = Read(
      "fof(a, lemma, p). fof(1, conjecture, p). cnf('B b', negated_conjecture, p).\n"
      "fof(d, axiom-local, p).");
  ASSERT_THAT(file.formulas, SizeIs(4)) << Format(file.diagnostics);
  EXPECT_EQ(file.formulas[0].role, Role::kAxiom);
  EXPECT_EQ(file.formulas[1].role, Role::kConjecture);
  EXPECT_EQ(file.formulas[1].name, "1");
  EXPECT_EQ(file.formulas[2].role, Role::kNegatedConjecture);
  EXPECT_EQ(file.formulas[2].name, "B b");
  EXPECT_TRUE(file.formulas[2].is_clause);
  EXPECT_EQ(file.formulas[3].place.line, 2U);
}

TEST_F(TptpReaderTest, Names_AreWrittenAsTheyAreRead) {
  for (const std::string_view name : {"a", "12", "'B b'", "'$me'", "'$it\\'s'", "'0x'"}) {
    const std::string text = "fof(" + std::string(name) + ", axiom, p).\n";
    EXPECT_EQ(WriteTptp(Read(text).formulas), text);
  }
}

TEST_F(TptpReaderTest, CommentsAndAnnotations_AreIgnored) {
  EXPECT_EQ(ReadOne("% one\n/* two\n**/fof(n, axiom, % three\n p, "
                    "inference(r,[status(thm),bind(X,$fot(f(X)))],[a:[b],'c']),[x,$fof(p&q)])."),
            "p");
  EXPECT_EQ(ReadOne("cnf(n, axiom, p, file('a.p',n), [description('x')])."), "p");
}

TEST_F(TptpReaderTest, TextsOfFormulas_AreKeptWhereWanted) {
  TptpOptions options;
  options.keep_texts = true;
  const TptpFile file = ReadTptp(
      "fof(a, axiom, ( ! [X] :\n (p(X)=>(q)) ), file(x)). cnf(b, axiom, p(Y)|~q).\n"
      "tff(c, axiom, ![X: $int]: p(X)).",
      "t", symbols_, options);
  EXPECT_THAT(file.texts, testing::ElementsAre("( ! [X] :\n (p(X)=>(q)) )", "p(Y)|~q", ""));
  EXPECT_TRUE(ReadTptp("fof(a, axiom, p).", "t", symbols_).texts.empty());
}

TEST_F(TptpReaderTest, Distinct_SpellsOutInequalities) {
  EXPECT_EQ(ReadFof("$distinct(a,b,c)"), "a != b & a != c & b != c");
}

TEST_F(TptpReaderTest, EmptyText_HasNoFormulas) {
  const TptpFile file = Read(" % nothing\n");
  EXPECT_THAT(file.formulas, IsEmpty());
  EXPECT_THAT(file.diagnostics, IsEmpty());
}

TEST_F(TptpReaderTest, Atom_IsReadAlone) {
  const TptpAtom atom = ReadTptpAtom("turn(A, b, A)", "agent.xml", symbols_);
  ASSERT_TRUE(atom.atom) << Format(atom.diagnostics);
  EXPECT_EQ(ToString(*atom.atom, atom.variable_names), "turn(A, b, A)");
  EXPECT_EQ(atom.variable_names.size(), 1U);
  for (const char* faulty : {"", "~ p", "p(a).", "p & q", "X", "a != b", "p(", "$true"}) {
    const TptpAtom none = ReadTptpAtom(faulty, "agent.xml", symbols_);
    EXPECT_FALSE(none.atom) << faulty;
    EXPECT_THAT(none.diagnostics, SizeIs(1)) << faulty;
  }
}

TEST_F(TptpReaderTest, AnyBytes_GiveFormulasOrDiagnostics) {
  const std::string text = "fof(n, axiom, p('a', \"b\") & ! [X] : (q(X) <=> ~ 1.5e3 = X)).";
  for (std::size_t at = 0; at < text.size() - 1; ++at) {
    EXPECT_THAT(Read(text.substr(0, at)).formulas, IsEmpty());
    for (const char byte : {'\0', '\xff', '(', ')', '\'', '.', 'X'}) {
      std::string changed = text;
      changed[at] = byte;
      const TptpFile file = Read(changed);
      EXPECT_EQ(file.formulas.size() + file.diagnostics.size() > 0, true) << changed;
    }
  }
}

/// What nests, what stands innermost, and what closes it.
struct Nesting {
  std::string_view open;
  std::string_view inside;
  std::string_view close;
};

class TptpNestingTest : public testing::TestWithParam<Nesting> {
 protected:
  static constexpr std::size_t kDeep = 100'000;

  static std::string Repeat(std::string_view text) {
    std::string all;
    for (std::size_t i = 0; i < kDeep; ++i) all += text;
    return all;
  }
};

TEST_P(TptpNestingTest, DeepNesting_DoesNotRecurse) {
  SymbolTable symbols;
  const auto& [open, inside, close] = GetParam();
  const std::string text = Repeat(open) + std::string(inside) + Repeat(close);
  const TptpFile file = ReadTptp("fof(n, axiom, p(" + text + ")).", "test.p", symbols);
  const TptpFile formula = ReadTptp("fof(n, axiom, " + text + ").", "test.p", symbols);
  EXPECT_EQ(file.formulas.size() + formula.formulas.size(), open == "f(" ? 2U : 1U);
  EXPECT_THAT(ReadTptp("fof(n, axiom, " + Repeat(open), "t", symbols).diagnostics, SizeIs(1));
}

INSTANTIATE_TEST_SUITE_P(Syntax, TptpNestingTest,
                         testing::Values(Nesting{"(", "p", ")"}, Nesting{"~", "p", ""},
                                         Nesting{"f(", "a", ")"}, Nesting{"! [X] : ", "p(X)", ""},
                                         Nesting{"(p => ", "p", ")"},
                                         Nesting{"(p & ~ ? [Y] : ", "p", ")"}));

}  // namespace
}  // namespace latchwork::logic
