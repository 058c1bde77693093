// SPDX-License-Identifier: BSD-3-Clause
//
// `latchwork entail` as it is used: exit codes, and what goes to which stream.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {
namespace {

using test::TemporaryFolder;
constexpr const char* kBirds =
    "fof(birds, axiom, ![X]: ((bird(X) & ~abnormal(X)) => flies(X))).\n"
    "fof(penguins, axiom, ![X]: (penguin(X) => (bird(X) & ~flies(X)))).\n"
    "fof(tweety, axiom, bird(tweety)).\n"
    "fof(opus, axiom, penguin(opus)).\n";

class EntailCommandTest : public ::testing::Test {
 protected:
  CommandResult Entail(const std::string& name, const std::string& text,
                       std::vector<std::string> options = {}) {
    WriteText(scratch_.path() / name, text);
    options.insert(options.begin(), {"entail", name});
    return RunLatchwork(options, scratch_.path());
  }

  TemporaryFolder scratch_;
};

TEST_F(EntailCommandTest, CircFile_PrintsALineForEachQuery) {
  const CommandResult result = Entail(
      "a.circ", "p circ 2 1\nP 1 1 2 0\n1 2 0\n? one c -1 -2 0\n? some b 1 0\n? all c 1 0\n");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "one yes\nsome yes\nall no\n");
  EXPECT_EQ(result.err, "");
}

TEST_F(EntailCommandTest, CircFile_Bad_ShowsAllErrors) {
  const CommandResult result = Entail("a.circ", "p circ 2 1\nP 1 1 2 0\n1 3 0\n? q x 1 0\n");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("a.circ:3:3: error: there is no atom 3"), std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("a.circ:4:5: error: 'x' is no kind of query"), std::string::npos)
      << result.err;
  EXPECT_EQ(result.out, "");
}

TEST_F(EntailCommandTest, Inconsistent_NamesTheCore) {
  const CommandResult result = Entail("a.circ",
                                      "p circ 4 4\nn 1 halt\nn 2 near\nP 1 1 3 0\nQ 2 4 0\n"
                                      "-2 1 0\n-2 -1 0\n3 1 0\n-4 3 0\nF 2 4 0\n? q c 3 0\n");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.out, "q yes\n");
  EXPECT_NE(result.err.find("    fact    near\n    clause  ~ near | halt\n"
                            "    clause  ~ near | ~ halt\n"),
            std::string::npos)
      << result.err;
}

TEST_F(EntailCommandTest, Tptp_AssumesOnlyWhatIsMinimized) {
  const CommandResult result =
      Entail("birds.p", kBirds,
             {"--minimize", "abnormal/1", "--query", "flies(tweety)", "--query",
              "?[X]: abnormal(X)", "--query", "penguin(tweety)"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "q1 yes\nq2 yes\nq3 no\n");
}

TEST_F(EntailCommandTest, Tptp_FixedPredicates_StayOpen) {
  const CommandResult result =
      Entail("birds.p", kBirds,
             {"--minimize", "abnormal/1", "--fix", "penguin/1", "--query", "flies(tweety)",
              "--query", "penguin(tweety) | flies(tweety)"});
  EXPECT_EQ(result.out, "q1 no\nq2 yes\n") << result.err;
}

TEST_F(EntailCommandTest, Tptp_Functions_AreRefusedWithThePlace) {
  const CommandResult result =
      Entail("next.p", "fof(a, axiom, p(zero)).\nfof(b, axiom, p(s(zero))).\n",
             {"--minimize", "p/1", "--query", "p(zero)"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("next.p:2:"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("'s/1' is a function"), std::string::npos) << result.err;
}

TEST_F(EntailCommandTest, Tptp_UnknownPredicate_SuggestsOne) {
  const CommandResult result =
      Entail("birds.p", kBirds, {"--minimize", "abnormall/1", "--query", "flies(tweety)"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("did you mean 'abnormal/1'?"), std::string::npos) << result.err;
}

TEST_F(EntailCommandTest, Tptp_BadQuery_IsShownAsWritten) {
  const CommandResult result =
      Entail("birds.p", kBirds, {"--minimize", "abnormal/1", "--query", "flies(tweety"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("--query 1:1:13: error"), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find("))"), std::string::npos) << result.err;
}

TEST_F(EntailCommandTest, Tptp_QueryOfAnUnknownPredicate_SuggestsOne) {
  const CommandResult result =
      Entail("birds.p", kBirds, {"--minimize", "abnormal/1", "--query", "flis(tweety)"});
  EXPECT_EQ(result.exit_code, 3) << result.out;
  EXPECT_NE(result.err.find("did you mean 'flies/1'?"), std::string::npos) << result.err;
}

TEST_F(EntailCommandTest, WithoutAnExtension_TheTextSaysWhatItIs) {
  const std::string asked = kBirds + std::string("fof(q, conjecture, bird(opus)).\n");
  EXPECT_EQ(Entail("birds", asked).out, "q yes\n");
  EXPECT_EQ(Entail("a", "p circ 1 0\nP 1 1 0\n? q c -1 0\n").out, "q yes\n");
  const CommandResult empty = Entail("empty", "");
  EXPECT_EQ(empty.exit_code, 3);
  EXPECT_NE(empty.err.find("there is no formula"), std::string::npos) << empty.err;
}

TEST_F(EntailCommandTest, ByteOrderMark_IsSkipped) {
  EXPECT_EQ(Entail("a.circ", "\xef\xbb\xbfp circ 1 0\nP 1 1 0\n? q c -1 0\n").out, "q yes\n");
}

TEST_F(EntailCommandTest, Pipe_IsRead) {
  WriteText(scratch_.path() / "birds.p", kBirds);
  const CommandResult result =
      RunShell("mkfifo pipe; cat birds.p > pipe & latchwork entail pipe --query 'bird(opus)'",
               scratch_.path());
  EXPECT_EQ(result.out, "q1 yes\n") << result.err;
}

TEST_F(EntailCommandTest, MissingFile_SaysWhy) {
  const CommandResult missing = RunLatchwork({"entail", "none"}, scratch_.path());
  EXPECT_NE(missing.err.find("none: error: there is no such file"), std::string::npos)
      << missing.err;
  const CommandResult folder = RunLatchwork({"entail", "."}, scratch_.path());
  EXPECT_NE(folder.err.find("this is a directory"), std::string::npos) << folder.err;
}

}  // namespace
}  // namespace latchwork::testing
