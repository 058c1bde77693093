// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "latchwork/logic/tptp.h"

namespace latchwork::logic {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct Fault {
  std::string_view text;
  std::uint32_t line;
  std::uint32_t column;
  std::string_view message;
  std::string_view hint;
};

class TptpFaultTest : public testing::TestWithParam<Fault> {};

TEST_P(TptpFaultTest, IsReportedWithPlaceAndRemedy) {
  SymbolTable symbols;
  const Fault& fault = GetParam();
  const TptpFile file = ReadTptp(fault.text, "test.p", symbols);
  ASSERT_THAT(file.diagnostics, SizeIs(1)) << Format(file.diagnostics);
  const Diagnostic& diagnostic = file.diagnostics[0];
  EXPECT_EQ(diagnostic.place.file, "test.p");
  EXPECT_EQ(diagnostic.place.line, fault.line);
  EXPECT_EQ(diagnostic.place.column, fault.column);
  EXPECT_THAT(diagnostic.message, HasSubstr(std::string(fault.message)));
  EXPECT_THAT(diagnostic.hint, HasSubstr(std::string(fault.hint)));
}

INSTANTIATE_TEST_SUITE_P(
    Syntax, TptpFaultTest,
    testing::Values(
        Fault{"fof(a, axiom, p)\nfof(b, axiom, q).", 2, 1, "expected '.'", "').'"},
        Fault{"fof(a, axiom, (p & q).", 1, 22, "found '.'", "not closed"},
        Fault{"fof(a, axiom, p & q", 1, 20, "the end of the text", ""},
        Fault{"fof(a, axiom, p & q | r).", 1, 21, "mixed", "(a & b) | c"},
        Fault{"fof(a, axiom, p => q => r).", 1, 22, "does not associate", "parentheses"},
        Fault{"fof(a, axiom, p => q & r).", 1, 22, "without parentheses", "(a & b) => c"},
        Fault{"fof(a, axiom, p -> q).", 1, 17, "'->'", "'=>'"},
        Fault{"cnf(a, axiom, p :- q).", 1, 17, "':-'", "Prolog"},
        Fault{"fof(a, axiom, p && q).", 1, 17, "'&&'", "'&'"},
        Fault{"fof(a, axiom, (p, q)).", 1, 17, "','", "'&'"},
        Fault{"fof(a, axiom, p, q(a)).", 1, 18, "source", "'&'"},
        Fault{"fof(a, axiom, f(X) = a).", 1, 17, "'X' is not quantified", "! [X]"},
        Fault{"fof(a, axiom, ! [X] : p(X) & q(X)).", 1, 32, "'X' is not quantified", "! [X]"},
        Fault{"fof(a, axiom, Pred(a)).", 1, 15, "cannot take arguments", "'pred'"},
        Fault{"cnf(a, axiom, P | q).", 1, 15, "cannot stand for a formula", "'p'"},
        Fault{"fof(a, axiom, ! [x] : p(x)).", 1, 18, "a variable", "upper-case"},
        Fault{"fof(a, axiom, ! X : p(X)).", 1, 17, "'['", "! [X]"},
        Fault{"fof(a, axim, p).", 1, 8, "unknown role 'axim'", "'axiom'"},
        Fault{"fof(a, banana, p).", 1, 8, "unknown role", "roles are axiom"},
        Fault{"fof(a, type, p).", 1, 8, "tff", "tff(...)"},
        Fault{"fof(Name, axiom, p).", 1, 5, "a name", "lower-case"},
        Fault{"fpf(a, axiom, p).", 1, 1, "cnf, fof, tff or include", "'fof'"},
        Fault{"thf(a, axiom, p).", 1, 1, "'thf'", "cnf, fof and tff"},
        Fault{"p(a) :- q(b).", 1, 1, "cnf, fof, tff or include", "fof(name, axiom, p(a))"},
        Fault{"cnf(a, axiom, p & q).", 1, 17, "disjunction", "fof"},
        Fault{"cnf(a, axiom, ! [X] : p(X)).", 1, 15, "no quantifiers", "universal"},
        Fault{"cnf(a, axiom, ~ (p | q)).", 1, 15, "only atoms", "fof"},
        Fault{"fof(a, axiom, p = ).", 1, 19, "a term", ""},
        Fault{"fof(a, axiom, ).", 1, 15, "a formula", ""},
        Fault{"fof(a, axiom, p(q = r)).", 1, 19, "arguments of 'p'", ""},
        Fault{"fof(a, axiom, 12).", 1, 15, "a number", ""},
        Fault{"fof(a, axiom, \"o\").", 1, 15, "distinct object", ""},
        Fault{"fof(a, axiom, p(1/2)).", 1, 17, "rational", "$quotient"},
        Fault{"fof(a, axiom, p(99999999999999999999)).", 1, 17, "64 bits", "'n9999"},
        Fault{"fof(a, axiom, p(9007199254740993.0)).", 1, 17, "more digits", "9007199254740992.0"},
        Fault{"fof(a, axiom, p(0.10000000000000000001)).", 1, 17, "more digits", "write 0.1 "},
        Fault{"fof(a, axiom, p(-1.00000000000000001E5)).", 1, 17, "more digits", "-1e+05"},
        Fault{"fof(a, axiom, p(1e999)).", 1, 17, "range", ""},
        Fault{"fof(a, axiom, $lesss(1, 2)).", 1, 15, "not an interpreted predicate", "'$less'"},
        Fault{"fof(a, axiom, $less(1)).", 1, 15, "takes 2 arguments, not 1", ""},
        Fault{"fof(a, axiom, $sum(1, 2)).", 1, 15, "is a function, not a predicate", ""},
        Fault{"fof(a, axiom, p($less(1, 2))).", 1, 17, "is a predicate, not a function", ""},
        Fault{"fof(a, axiom, p($true)).", 1, 17, "not an interpreted function", ""},
        Fault{"fof(a, axiom, $distinct(a)).", 1, 15, "2 to 1000", ""},
        Fault{"fof(a, axiom, p('b)).", 1, 17, "quote is not closed", "'"},
        Fault{"fof(a, axiom, p('')).", 1, 17, "empty", ""},
        Fault{"fof(a, axiom, p('a\\n')).", 1, 17, "backslash", ""},
        Fault{"fof(a, axiom, '$true').", 1, 15, "reserved", "'$'"},
        Fault{"fof(a, axiom, '='(a, b)).", 1, 15, "reserved", "a = b"},
        Fault{"fof(a, axiom, p(\xc3\xa4)).", 1, 17, "ASCII", "quotes"},
        Fault{"fof(a, axiom, p('\xff')).", 1, 17, "not UTF-8", ""},
        Fault{"fof(a, axiom, p($)).", 1, 17, "'$'", ""},
        Fault{"/* open", 1, 1, "comment is not closed", "*/"},
        Fault{"tff(a, axiom, ! [X: person]   : p(X)).", 1, 21, "$i, $int or $real",
              "not supported"},
        Fault{"tff(a, type, person: $tType).", 1, 22, "types of one's own", ""},
        Fault{"fof(a, axiom, ! [X: $int] : p(X)).", 1, 19, "tff", "tff"},
        Fault{"fof(a, axiom, p, file(a]).", 1, 24, "closes nothing", ""},
        Fault{"include(axioms).", 1, 9, "single quotes", ""},
        Fault{"include('nowhere.ax').", 1, 9, "not found", "nowhere.ax"}));

class TptpDiagnosticsTest : public testing::Test {
 protected:
  SymbolTable symbols_;
};

TEST_F(TptpDiagnosticsTest, AllFaults_ComeAtOnce) {
  const TptpFile file = ReadTptp(
      "fof(a, axiom, P(a)).\n"
      "fof(b, axiom, q).\n"
      "fof(c, axim, p).\n"
      "  fof(d, axiom, p & ).\n"
      "fof(e, axiom, p\n"
      "cnf(f, axiom, 'x).\n"
      "fof(g, axiom, p(\x01)).\n",
      "test.p", symbols_);
  std::vector<std::uint32_t> lines;
  for (const Diagnostic& each : file.diagnostics) lines.push_back(each.place.line);
  EXPECT_THAT(lines, testing::ElementsAre(1, 3, 4, 6, 6, 7));
}

TEST_F(TptpDiagnosticsTest, Number_IsLimited) {
  std::string text;
  for (int i = 0; i < 50; ++i) text += "fof(a, axiom, ).\n";
  TptpOptions options;
  options.max_diagnostics = 7;
  EXPECT_THAT(ReadTptp(text, "test.p", symbols_, options).diagnostics, SizeIs(7));
}

TEST_F(TptpDiagnosticsTest, Excerpt_IsTheLineOfThePlace) {
  const TptpFile file = ReadTptp("fof(a, axiom,\r\n  $less(1,\r\n  2,\r\n  3)).", "t", symbols_);
  ASSERT_THAT(file.diagnostics, SizeIs(1));
  EXPECT_EQ(file.diagnostics[0].place.line, 2U);
  EXPECT_EQ(file.diagnostics[0].excerpt, "  $less(1,");
}

TEST_F(TptpDiagnosticsTest, TooManyBytesOrTokens_AreRefused) {
  TptpOptions options;
  options.max_bytes = 10;
  EXPECT_THAT(ReadTptp("fof(a, axiom, p).", "t", symbols_, options).diagnostics, SizeIs(1));
  options = {};
  options.max_tokens = 12;
  const TptpFile file = ReadTptp("fof(a, axiom, p). fof(b, axiom, p).", "t", symbols_, options);
  ASSERT_FALSE(file.diagnostics.empty());
  EXPECT_THAT(file.diagnostics[0].message, HasSubstr("too long"));
}

TEST_F(TptpDiagnosticsTest, MissingFile_IsReported) {
  const TptpFile file = ReadTptpFile("no/such/file.p", symbols_);
  ASSERT_THAT(file.diagnostics, SizeIs(1));
  EXPECT_EQ(Format(file.diagnostics), "no/such/file.p: error: no such file\n");
  EXPECT_THAT(ReadTptpFile(".", symbols_).diagnostics, SizeIs(1));
}

}  // namespace
}  // namespace latchwork::logic
