// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/program.h"

#include <gtest/gtest.h>

#include <ostream>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/reasoners/icarus/programs.h"

namespace latchwork::icarus {
namespace {

std::vector<std::string> Codes(std::string_view text, const CheckOptions& options = {}) {
  std::vector<std::string> codes;
  for (const Finding& finding : ReadProgram(std::string(text), "p.icarus", options).findings) {
    codes.push_back(std::to_string(finding.diagnostic.place.line) + ':' +
                    std::to_string(finding.diagnostic.place.column) + ' ' +
                    std::string(Info(finding.code).name));
  }
  return codes;
}

using List = std::vector<std::string>;

TEST(IcarusProgramTest, TablesOfThePaper_HaveNoFindings) {
  EXPECT_EQ(Codes(testing::kCollide), List());
  EXPECT_EQ(Codes(testing::kFastest), List());
}

TEST(IcarusProgramTest, AnUnclosedForm_TheOthersAreCheckedWithoutFollowUps) {
  EXPECT_EQ(Codes("(top (Near c))\n"
                  "(Near (?car) :objective ((Distance ?car ?d) {< ?d 1.0}) :means ((GoForwrd)))\n"
                  "(GoForward () :action ({go ?z}))\n"
                  "(Turn () :requires ((Lost 1) (Near ?_a ?_b)) :means ((GoForward)))\n"
                  "(Lost (?x) :requires ((Turn))\n"
                  "(Distance (?car ?d) :sensor ((bind ?d {range-to ?car})))\n"),
            (List{"2:65 I015", "3:28 I017", "3:28 I021", "4:30 I011", "5:1 I001", "6:49 I021"}));
}

TEST(IcarusProgramTest, BrokenSkills_TheOthersAreCheckedWithoutFollowUps) {
  constexpr std::string_view kOthers =
      "(B () :means ((C 1 2)))\n(C (?x) :action ({go {< ?x}}))\n(D () :requires ((A 1) {f ?}))";
  const auto with = [&](std::string_view broken) {
    return Codes("(top (B))\n" + std::string(kOthers) + "\n" + std::string(broken));
  };
  const auto found = [](List more) {
    List all{"2:15 I011", "3:22 I027", "4:27 I021"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  EXPECT_EQ(with("(A (?x) :mean ((C ?x)))"), found({"5:9 I006"}));
  EXPECT_EQ(with("(A (?x) :means (C ?x))"), found({"5:17 I010", "5:19 I010"}));
  EXPECT_EQ(with("(A (x) :means ((C ?x)))"), found({"5:5 I005"}));
  EXPECT_EQ(with("(A (?x) :objective ({f ?x *Lost*}) :means ((A ?x)))"), found({"5:27 I012"}));
  EXPECT_EQ(with("(A (?x) :means ((C ?x)))\n(A () :action ({go}))"), found({"6:2 I009"}));
  EXPECT_EQ(with("(A (?x) :means ((C ?x)))\n(constant *K* ?y)\n(E () :requires ({< *K* 1}))"),
            found({"6:15 I012"}));
  EXPECT_EQ(with("(A (?x) :means ((C ?x)))\n(constant *K*)\n(E () :requires ({< *K* 1}))"),
            found({"6:1 I012"}));
  EXPECT_EQ(with("(A (?x) :means ((C ?x)))\n(facts (car {f}))\n(E () :requires ((lorry 1)))"),
            found({"6:13 I013"}));
}

TEST(IcarusProgramTest, Clauses_AreResolvedInOrder) {
  const ProgramFile file = ReadProgram(
      "(facts (car c1) (c1 here 1))\n"
      "(A (?x) :requires ((bind ?y ?x) (*not* (B ?y)) (*notA* {f}) (B ?x) (car ?x) (?x ? ?)))\n"
      "(B (?x) :objective ({f ?x}))",
      "p.icarus");
  ASSERT_TRUE(file.findings.empty()) << Format(file.findings.front());
  const std::vector<Clause>& clauses = *file.program.skills[0].slot(Slot::kRequires);
  std::vector<ClauseKind> kinds;
  for (const Clause& clause : clauses) kinds.push_back(clause.kind);
  EXPECT_EQ(kinds,
            (std::vector<ClauseKind>{ClauseKind::kBind, ClauseKind::kNot, ClauseKind::kNotOrActing,
                                     ClauseKind::kSkill, ClauseKind::kMatch, ClauseKind::kMatch}));
  EXPECT_EQ(clauses[1].inner.at(0).kind, ClauseKind::kSkill);
  EXPECT_EQ(clauses[3].skill, 1U);
  EXPECT_EQ(file.program.facts.size(), 2U);
}

struct CodeCase {
  std::string_view name;
  std::string_view text;
  std::string_view finding;
};

std::ostream& operator<<(std::ostream& out, const CodeCase& c) { return out << c.name; }

class IcarusCodeTest : public ::testing::TestWithParam<CodeCase> {};

TEST_P(IcarusCodeTest, Offence_IsFoundWhereItStands) {
  EXPECT_EQ(Codes(GetParam().text), List{std::string(GetParam().finding)});
}

constexpr CodeCase kCases[] = {
    {"Bracket", "(A () :action ({go}))\n)", "2:1 I001"},
    {"Token", "(A () :action ({go \"x}))", "1:20 I002"},
    {"TopLevel", "(A () :action ({go}))\n((B))", "2:1 I004"},
    {"HeadWithoutList", "(A :action ({go}))", "1:2 I005"},
    {"HeadRepeated", "(A (?x ?X) :action ({go ?x}))", "1:8 I005"},
    {"HeadNoVariable", "(A (x) :action ({go}))", "1:5 I005"},
    {"UnknownSlot", "(A () :objectve ({f}))", "1:7 I006"},
    {"SlotTwice", "(A () :means ((B)) :means ((B)))\n(B () :action ({go}))", "1:20 I007"},
    {"SlotEmpty", "(A () :means)", "1:7 I007"},
    {"SlotNoList", "(A () :objective {f})", "1:18 I007"},
    {"Types", "(A () :objective ({f}) :action ({go}))", "1:24 I008"},
    {"NoSlot", "(A ())", "1:2 I008"},
    {"Repeated", "(A () :action ({go}))\n(a () :action ({go}))", "2:2 I009"},
    {"ClauseAtom", "(A () :objective (f))", "1:19 I010"},
    {"ClauseEmpty", "(A () :objective (()))", "1:19 I010"},
    {"ClauseBind", "(A () :objective ((bind x 1)))", "1:19 I010"},
    {"ClauseNot", "(A () :objective ((*not* {f} {g})))", "1:19 I010"},
    {"ClauseInAction", "(A () :action ((go)))", "1:16 I010"},
    {"ClauseInSensor", "(A () :sensor ((go)))", "1:16 I010"},
    {"ActionEmpty", "(A () :action ())", "1:15 I010"},
    {"TooMany", "(A () :requires ((B 1)))\n(B () :action ({go}))", "1:18 I011"},
    {"ConstantUnknown", "(A () :action ({go *Hard*}))", "1:20 I012"},
    {"ConstantTwice", "(constant *a* 1)\n(constant *A* 2)", "2:11 I012"},
    {"Fact", "(facts (a ?x))", "1:11 I013"},
    {"TooFew", "(A () :requires ((B)))\n(B (?x) :objective ((bind ?x 1)))", "1:18 I014"},
    {"Misspelt", "(Top () :means ((Trun)))\n(Turn () :action ({turn}))", "1:17 I015"},
    {"UnknownFact", "(facts (car c1))\n(A () :requires ((lorry ?)))", "2:18 I016"},
    {"Once", "(A () :requires ((car ?c)))", "1:23 I017"},
    {"AlwaysTrue", "(A () :objective () :means ((B)))\n(B () :action ({go}))", "1:7 I019"},
    {"UnboundCall", "(A () :requires ((*not* {f ?_x})))", "1:28 I021"},
    {"Hiding", "(A () :means ((B) (C)))\n(B () :action ({b}))\n(C () :action ({c}))", "1:15 I022"},
    {"Endless", "(A () :means ((B)))\n(B () :requires ((*not* (A))))", "1:2 I023"},
    {"Recursion", "(A (?x) :objective ({f ?x}) :means ((A ?x)))", "1:37 I023"},
    {"UnboundSequence", "(A () :means ((S ?_x)))\n(S (?x) :sequence ({f ?x}))", "1:18 I024"},
    {"Effect", "(A () :requires ({store (a b)}))", "1:18 I025"},
    {"Spelling", "(A (?car) :requires ({f ?Car}))", "1:25 I026"},
    {"FunctionCount", "(A (?x) :requires ({< ?x}))", "1:20 I027"},
    {"FunctionType", "(A (?x) :requires ({< ?x slow}))", "1:26 I027"},
    {"ParameterType", "(A () :requires ((B 1) (B slow)))\n(B (?x) :objective ({< ?x 2}))",
     "1:27 I035"},
    {"ParameterOfTwoTypes", "(A (?x) :objective ({< ?x 2} {member 2 ?x}))", "1:40 I035"},
    {"NeverMisspelt", "(never (Trun))\n(Turn () :action ({turn}))", "1:8 I015"},
    {"NeverOnce", "(never (car ?c))\n(A () :action ({go}))", "1:13 I017"},
    {"NeverUnbound", "(never {f ?_c})\n(A () :action ({go}))", "1:11 I021"},
    {"NeverClause", "(never (bind 1 2))\n(A () :action ({go}))", "1:8 I010"},
};

INSTANTIATE_TEST_SUITE_P(AllCodes, IcarusCodeTest, ::testing::ValuesIn(kCases),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(IcarusProgramTest, NameNearASkill_IsASlipInItsWordsAndItsStyle) {
  const auto codes = [](const std::string& head, const std::string& skill) {
    return Codes("(A () :requires ((" + head + " ?)) :means ((" + skill + ")))\n(" + skill +
                 " () :action ({go}))");
  };
  const List found{"1:18 I015"};
  EXPECT_EQ(codes("GoFoward", "GoForward"), found);
  EXPECT_EQ(codes("Goforwad", "GoForward"), found);
  EXPECT_EQ(codes("go_foward", "go_forward"), found);
  EXPECT_EQ(codes("go_forward", "GoForward"), found);
  EXPECT_EQ(codes("no_echo", "NoteEcho"), List());
  EXPECT_EQ(codes("no_echo", "note_echo"), List());
  EXPECT_EQ(codes("hour", "Pour"), List());
}

TEST(IcarusProgramTest, MeansNamedLikeASkill_AreNoFactsFromElsewhere) {
  constexpr std::string_view kGo = "(Go () :action ({go}))\n";
  const auto with = [&](std::string_view rest) {
    return Codes(std::string(kGo) + std::string(rest));
  };
  const List found{"2:15 I016"};
  EXPECT_EQ(with("(A () :means ((GoForwrdNow) (Go)))"), found);
  EXPECT_EQ(with("(A () :means ((GoForwrdNow) (Go)))\n(top (A))"), found);
  EXPECT_EQ(with("(A () :means ((at home) (Go)))\n(top (A))"), List());
  EXPECT_EQ(with("(A () :requires ((Arrived)) :means ((Go)))\n(top (A))"), List());
  EXPECT_EQ(with("(A () :means ((Arrived) (go_on)))\n(go_on () :action ({go}))"), List());
  EXPECT_EQ(with("(A () :means ((Arrived) (Go)))\n(N () :sensor ({store (Arrived)}))"), List());
  CheckOptions options;
  options.facts = {"arrived"};
  EXPECT_EQ(Codes("(top (A))\n(A () :means ((Arrived) (Go)))\n" + std::string(kGo), options),
            List());
}

TEST(IcarusProgramTest, FactsFromElsewhere_AreNoSlips) {
  constexpr std::string_view kText =
      "(A () :requires ((hour ?)) :means ((pour)))\n"
      "(pour () :action ({go}))";
  EXPECT_EQ(Codes(kText), List{"1:18 I015"});
  CheckOptions options;
  options.facts = {"hour"};
  EXPECT_EQ(Codes(kText, options), List());
}

TEST(IcarusProgramTest, UnboundActArgument_IsFound) {
  EXPECT_EQ(Codes("(A () :means ((B ?_x)))\n(B (?x) :action ({go ?x}))"), List{"1:18 I020"});
  EXPECT_EQ(Codes("(A () :requires ((bind ?x 1)) :means ((B ?x)))\n(B (?x) :action ({go ?x}))"),
            List());
  EXPECT_EQ(Codes("(A () :requires ((C ?x)) :means ((B ?x)))\n(B (?x) :action ({go ?x}))\n"
                  "(C (?x) :means ((D ?x)))\n(D (?x) :objective ((car ?x)))"),
            List());
}

TEST(IcarusProgramTest, UnboundArgument_IsFollowedThroughCalls) {
  constexpr std::string_view kRest = "(Mid (?y) :means ((Do ?y)))\n(Do (?z) :action ({go ?z}))";
  EXPECT_EQ(Codes("(Top () :means ((Mid ?_x)))\n" + std::string(kRest)), List{"2:23 I020"});
  EXPECT_EQ(Codes("(Top () :means ((Mid 1)))\n" + std::string(kRest)), List());
  EXPECT_EQ(Codes("(top (Mid ?))\n" + std::string(kRest)), List{"2:23 I020"});
  EXPECT_EQ(Codes("(top (Mid 1))\n" + std::string(kRest)), List());
  EXPECT_EQ(Codes("(A () :means ((B 1 ?_x)))\n(B (?x ?y) :objective ({f ?x} {f ?y} {f ?y}))"),
            List{"2:34 I021"});
}

TEST(IcarusProgramTest, UnboundParameter_NamesTheCall) {
  const ProgramFile file =
      ReadProgram("(A () :means ((B ?_x)))\n(B (?y) :objective ({f ?y}))", "p.icarus");
  ASSERT_EQ(file.findings.size(), 1U);
  EXPECT_EQ(file.findings[0].diagnostic.message,
            "'B' may be called with ?y unbound, which {f} needs");
  ASSERT_TRUE(file.findings[0].note);
  EXPECT_EQ(file.findings[0].note->place.line, 1U);
  EXPECT_EQ(file.findings[0].note->place.column, 15U);
}

TEST(IcarusProgramTest, Anonymous_IsUnbound) {
  EXPECT_EQ(Codes("(A () :requires ({f ?}))"), List{"1:21 I021"});
  EXPECT_EQ(Codes("(A () :requires ((bind ?x {f (1 ?)}) {f ?x}))"), List{"1:33 I021"});
  EXPECT_EQ(Codes("(A () :action ({go ? 1}))"), List{"1:20 I021"});
  EXPECT_EQ(Codes("(A () :means ((B ?)))\n(B (?x) :action ({go ?x}))"), List{"1:18 I020"});
  EXPECT_EQ(Codes("(A () :means ((S ?)))\n(S (?x) :sequence ({f ?x}))"), List{"1:18 I024"});
  EXPECT_EQ(Codes("(A () :sensor ({forget (a ?)} {update (a ?) (a 1)}))"), List());
  EXPECT_EQ(Codes("(A () :sensor ({store (a ?)}))"), List{"1:26 I021"});
}

TEST(IcarusProgramTest, Variable_IsBoundWhenEachWayToBeTrueBindsIt) {
  const auto with = [](std::string_view second) {
    return Codes(
        "(A () :requires ((Pick ?x)) :means ((Do ?x)))\n"
        "(Pick (?x) :objective ((car ?x)) :means (" +
        std::string(second) + "))\n(Do (?x) :action ({go ?x}))\n(Rule () :objective ({f}))");
  };
  EXPECT_EQ(with("(Rule)"), List{"1:41 I020"});
  EXPECT_EQ(with("(bind ?x 1)"), List());
  EXPECT_EQ(with("(Do 1)"), List()) << "an act is no way to be True";
  EXPECT_EQ(with("(Pick ?x)"), List{"2:42 I023"}) << "recursion is no way of its own";
}

TEST(IcarusProgramTest, Modes_AreOfEachCall) {
  EXPECT_EQ(Codes("(A () :requires ((Same 1 ?x) (Same ?y ?x) {f ?x ?y}))\n"
                  "(Same (?a ?b) :objective ((bind ?a ?b)))"),
            List());
  EXPECT_EQ(Codes("(A () :requires ((Same ?x ?y) {f ?x ?y}))\n"
                  "(Same (?a ?b) :objective ((bind ?a ?b)))"),
            (List{"1:34 I021", "1:37 I021"}));
}

TEST(IcarusProgramTest, Unreachable_DependsOnTheTop) {
  constexpr std::string_view kText =
      "(A () :means ((B)))\n(B () :action ({go}))\n(C () :means ((B)))";
  EXPECT_EQ(Codes(kText), List());
  CheckOptions options;
  options.top = "a";
  EXPECT_EQ(Codes(kText, options), List{"3:2 I018"});
}

TEST(IcarusProgramTest, ParameterTypes_ComeThroughCallsOfOtherSkills) {
  constexpr std::string_view kThrough =
      "(B (?y) :means ((C ?y)))\n(C (?z) :means ((D ?z)))\n(D (?u) :objective ({< ?u 1}))";
  EXPECT_EQ(Codes("(A () :means ((B slow)))\n" + std::string(kThrough)), List{"1:18 I035"});
  EXPECT_EQ(Codes("(A () :means ((B 2)))\n" + std::string(kThrough)), List());
  EXPECT_EQ(Codes("(top (A slow))\n(A (?x) :objective ({< ?x 1}))"), List{"1:9 I035"});
}

TEST(IcarusProgramTest, Facts_AreSpeltAlike) {
  EXPECT_EQ(Codes("(facts (Driver c1 Anna))\n(A () :requires ((driver ? anna) (Driver c1 ?)))"),
            (List{"2:19 I026", "2:28 I026"}));
  EXPECT_EQ(Codes("(A () :sensor ({update (seen ?) (Seen 1)} {store (seen (Red))} {f red}))"),
            (List{"1:34 I026", "1:67 I026"}));
  EXPECT_EQ(Codes("(facts (car red))\n(A () :requires ((car Car)))"), List())
      << "what facts begin with is no symbol";
}

TEST(IcarusFindingTest, UndefinedConstant_KeepsItsSpellingInTheHint) {
  const ProgramFile file = ReadProgram("(A () :action ({go *Undefined*}))", "p.icarus");
  ASSERT_EQ(file.findings.size(), 1U);
  EXPECT_EQ(file.findings[0].diagnostic.hint, "define it: (constant *Undefined* value)");
}

TEST(IcarusProgramTest, MeansBehindAnObjectiveThatIsNeverFalse_AreFound) {
  const auto with = [](std::string_view objective, std::string_view more = "") {
    return Codes("(A () :objective (" + std::string(objective) +
                 ") :means ((Go)))\n(Go () :action ({go}))\n" + std::string(more));
  };
  const List found{"1:7 I019"};
  EXPECT_EQ(with("(Go)"), found);
  EXPECT_EQ(with("(Go) {f}"), found) << "the act of the first is an act of both";
  EXPECT_EQ(with("{f} (Go)"), List());
  EXPECT_EQ(with("(*not* (Go))"), found);
  EXPECT_EQ(with("(*notA* (Go))"), List());
  EXPECT_EQ(with("(P)", "(P () :objective ({f}) :means ((Go)))"), found) << "True, or acts";
  EXPECT_EQ(with("(P)", "(P () :objective ({f}) :requires ({g}) :means ((Go)))"), List());
  EXPECT_EQ(with("(P) {f}", "(P () :objective ({f}) :means ((Go)))"), List());
  EXPECT_EQ(with("(S)", "(S () :sequence ((Go)))"), found);
  EXPECT_EQ(with("(S)", "(S () :sequence ((Go) ({f})))").size(), 1U) << "that is a match";
  EXPECT_EQ(Codes("(A () :objective ((Go)))\n(Go () :action ({go}))"), List());
  EXPECT_EQ(Codes("(A () :objective ((Go)) :requires ({f}))\n(Go () :action ({go}))"), found);
}

TEST(IcarusProgramTest, RecursionWithTheSameArguments_IsFound) {
  constexpr std::string_view kA = "(A (?x ?y) :objective ({f ?x ?y}) :means ((B ?x ?y)))\n";
  const auto with = [&](std::string_view b) { return Codes(std::string(kA) + std::string(b)); };
  const List found{"1:43 I023"};
  EXPECT_EQ(with("(B (?x ?y) :objective ({g ?x ?y}) :means ((A ?x ?y)))"), found);
  EXPECT_EQ(with("(B (?u ?v) :requires ({g ?u ?v} (A ?u ?v)))"), found);
  EXPECT_EQ(with("(B (?u ?v) :sequence ({g ?u ?v} (A ?u ?v)))"), found);
  EXPECT_EQ(with("(B (?x ?y) :objective ({g ?x ?y}) :means ((A ?y ?x)))"), List());
  EXPECT_EQ(with("(B (?x ?y) :requires ((car ?x) {g ?y}) :means ((A ?x ?y)))"), List());
  EXPECT_EQ(with("(B (?x ?y) :requires ((next ?x ?z) {g ?y}) :means ((A ?z ?y)))"), List());
  EXPECT_EQ(with("(B (?x ?y) :requires ({f ?x ?y}) :means ((A ?x ?y)))"), List())
      << "A asks B only where {f} is False";
  EXPECT_EQ(with("(B (?x ?y) :requires ((*not* {f ?x ?y})) :means ((A ?x ?y)))"), found);
  EXPECT_EQ(Codes("(A (?x) :sequence ({f ?x} (A ?x)))"), List{"1:27 I023"});
  EXPECT_EQ(Codes("(A (?x) :sequence ({f ?x} (A 1)))"), List());
}

TEST(IcarusProgramTest, Never_LeadsToSkillsAndMayStandManyTimes) {
  const ProgramFile file = ReadProgram(
      "(top (A))\n(A () :action ({go}))\n(never (B ?x) {< ?x 0})\n(never (B 1))\n"
      "(B (?x) :objective ((car ?x)))",
      "p.icarus");
  EXPECT_TRUE(file.findings.empty()) << Format(file.findings.front());
  ASSERT_EQ(file.program.nevers.size(), 2U);
  EXPECT_EQ(file.program.nevers[0].slot(Slot::kRequires)->size(), 2U);
}

TEST(IcarusProgramTest, Never_MayBeTheNameOfASkill) {
  EXPECT_EQ(Codes("(never () :action ({go}))\n(A () :means ((never)))"), List());
}

TEST(IcarusProgramTest, Top_IsACallOfASkill) {
  constexpr std::string_view kSkills = "(A (?x) :action ({f ?x}))\n(B () :action ({f 1}))\n";
  const auto with = [&](std::string_view top) {
    return Codes(std::string(kSkills) + std::string(top));
  };
  EXPECT_EQ(with(""), List());
  EXPECT_EQ(with("(top (A 1))"), List({"2:2 I018"}));
  EXPECT_EQ(with("(top (A 1 2))"), List({"2:2 I018", "3:6 I011"}));
  EXPECT_EQ(with("(top (A 1))(top (B))"), List({"3:12 I030"}));
  EXPECT_EQ(with("(top (C))"), List({"3:7 I030"}));
  EXPECT_EQ(with("(top (*not* (B)))"), List({"3:6 I030"}));
  EXPECT_EQ(with("(top {f})"), List({"3:1 I030"}));
  EXPECT_EQ(with("(top)"), List({"3:1 I030"}));
  EXPECT_EQ(with("(never)"), List({"3:1 I004"}));
}

/// The slips that are made most: brackets.
TEST(IcarusProgramTest, BracketsLeftOpen_AreGuessed) {
  const auto hint = [](std::string_view text) {
    const ProgramFile file = ReadProgram(std::string(text), "p.icarus");
    return file.findings.empty() ? "" : file.findings.front().diagnostic.hint;
  };
  EXPECT_EQ(hint("(A () :objective ({f} :means ((B))))\n(B () :action ({b}))"),
            "close that list with a ')' before :means");
  EXPECT_EQ(hint("(A () :objective ({f})\n(B () :action ({b})))"),
            "the '(' of A in line 1 is not closed before it");
}

TEST(IcarusProgramTest, Top_MayBeTheNameOfASkill) {
  EXPECT_EQ(Codes("(top (Top 1))\n(Top (?x) :action ({f ?x}))"), List());
}

TEST(IcarusProgramTest, Bind_TakesListsApart) {
  EXPECT_EQ(Codes("(A () :requires ((bind (?x (?y ?)) {f}) {g ?x ?y}))"), List());
  EXPECT_EQ(Codes("(A () :requires ((bind 1 {f})))"), List({"1:18 I010"}));
}

TEST(IcarusProgramTest, Strict_MakesFewArgumentsAnError) {
  CheckOptions options;
  options.strict = true;
  const ProgramFile file =
      ReadProgram("(A () :requires ((B)))\n(B (?x) :objective ((bind ?x 1)))", "p.icarus", options);
  ASSERT_EQ(file.findings.size(), 1U);
  EXPECT_TRUE(HasErrors(file.findings));
  EXPECT_EQ(ErrorsOf(file.findings).at(0).message,
            "[I014] 'B' has 1 parameter, but is called with 0");
}

TEST(IcarusProgramTest, Waiver_SilencesWarningsOfItsFormAndOfTheNextLine) {
  EXPECT_EQ(Codes("(A () :requires ((car ?c))) ; allow I017"), List());
  EXPECT_EQ(Codes("; allow I016 i017\n(A () :requires ((car ?c)))"), List());
  EXPECT_EQ(
      Codes(
          "(A ()\n  :requires ((car ?c))\n  :means    ((B)))  ; allow I017\n(B () :action ({b}))"),
      List());
  EXPECT_EQ(Codes("(B () :action ({b})) ; allow I017\n\n(A () :requires ((car ?c)) :means ((B)))"),
            List{"3:23 I017"});
  EXPECT_EQ(Codes("; allow I016\n(A () :requires ((car ?c)))"), List{"2:23 I017"});
  EXPECT_EQ(Codes("(A ()) ; allow I008"), List{"1:2 I008"});
}

TEST(IcarusProgramTest, AllErrors_AreReportedAtOnce) {
  EXPECT_EQ(Codes("(A (x) :means (y) :foo ())\n(B {)\n(C () :objective (()))"),
            (List{"1:5 I005", "1:16 I010", "1:19 I006", "2:5 I001", "3:19 I010"}));
}

TEST(IcarusFindingTest, Format_ShowsCodeCaretHintAndNote) {
  const ProgramFile file =
      ReadProgram("(A () :requires ((B 1)))\n(B () :action ({go}))", "p.icarus");
  ASSERT_EQ(file.findings.size(), 1U);
  EXPECT_EQ(Format(file.findings[0]),
            "p.icarus:1:18: error[I011]: 'B' has 0 parameters, but is called with 1\n"
            "  1 | (A () :requires ((B 1)))\n"
            "    |                  ^\n"
            "  hint: take out what is too much\n"
            "p.icarus:2:2: note: defined here\n"
            "  2 | (B () :action ({go}))\n"
            "    |  ^\n");
}

TEST(IcarusFindingTest, Codes_AreNumberedAndExplained) {
  std::set<std::string_view> names;
  for (const CodeInfo& info : AllCodes()) {
    EXPECT_FALSE(info.explanation.empty()) << info.name;
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
  }
  EXPECT_EQ(*names.begin(), "I001");
  EXPECT_EQ(names.size(), 36U);
  EXPECT_EQ(Info(Code::kUnknownFunction).name, "I028");
}

}  // namespace
}  // namespace latchwork::icarus
