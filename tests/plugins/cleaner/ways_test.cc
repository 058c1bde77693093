// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/cleaner/ways.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "latchwork/logic/tptp.h"
#include "plugins/cleaner/attachments.h"

namespace latchwork::cleaner {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Short-term memory that answers queries for all facts of a predicate.
class FactsContext final : public sdk::AttachmentContext {
 public:
  explicit FactsContext(std::vector<logic::Fact> facts) : facts_(std::move(facts)) {}

  void ForEachProvable(std::span<const logic::Literal> query, std::size_t /*variables*/,
                       sdk::AnswerSink& sink) override {
    const logic::Atom& pattern = query.front().atom;
    for (const logic::Fact& fact : facts_) {
      if (logic::NameOf(fact) == logic::NameOf(pattern)) sink.Answer(fact.arguments());
    }
  }

 private:
  std::vector<logic::Fact> facts_;
};

class Answers final : public sdk::AnswerSink {
 public:
  void Answer(std::span<const logic::Term> terms) override {
    for (const logic::Term& term : terms) texts.push_back(logic::ToString(term));
  }
  std::vector<std::string> texts;
};

class CleanerAttachmentsTest : public ::testing::Test {
 protected:
  /// A room of tiles 0 to 11 in rows 0 to 6, clean but for what `more` says.
  std::vector<std::string> Room(std::vector<std::string> more = {}) const {
    for (int j = 0; j < 7; ++j) {
      more.push_back("clean_row(" + std::to_string(j) + ", runs(0, 11))");
    }
    return more;
  }

  std::vector<std::string> Ask(const std::vector<std::string>& memory, std::string_view name,
                               std::vector<logic::Term> inputs) {
    std::vector<logic::Fact> facts;
    for (const std::string& text : memory) {
      const auto read = logic::ReadTptpAtom(text, "test", symbols_);
      EXPECT_TRUE(read.atom) << text;
      if (read.atom) facts.push_back(*read.atom);
    }
    FactsContext context(std::move(facts));
    Answers answers;
    for (const auto& attachment : MakeAttachments(symbols_)) {
      if (attachment->signature().predicate == name) attachment->Call(inputs, context, answers);
    }
    return answers.texts;
  }

  static std::vector<logic::Term> Numbers(const std::vector<int>& numbers) {
    std::vector<logic::Term> terms;
    for (const int number : numbers) terms.push_back(logic::Term::Integer(number));
    return terms;
  }

  logic::SymbolTable symbols_;
};

TEST_F(CleanerAttachmentsTest, Way_EndsWhereItFirstBends) {
  EXPECT_THAT(Ask(Room(), "way", Numbers({1, 1, 10, 1})), ElementsAre("10", "1", "9.0"));
  EXPECT_THAT(Ask(Room(), "way", Numbers({1, 1, 4, 4})), ElementsAre("4", "4", "4.2"));
  EXPECT_THAT(Ask(Room(), "way", Numbers({5, 5, 5, 5})), ElementsAre("5", "5", "0.0"));
}

TEST_F(CleanerAttachmentsTest, Way_KeepsATileAwayFromWhatIsNoFloor) {
  std::vector<std::string> memory;
  for (int j = 0; j < 7; ++j) {
    const bool wall = j < 4;
    memory.push_back("clean_row(" + std::to_string(j) +
                     (wall ? ", runs(0, 4, 7, 11))" : ", runs(0, 11))"));
  }
  EXPECT_THAT(Ask(memory, "way", Numbers({1, 1, 10, 1})), ElementsAre("3", "3", "14.6"))
      << "over row 5, the only one with floor on both sides";
  EXPECT_THAT(Ask(memory, "way", Numbers({1, 1, 5, 1})), IsEmpty()) << "into the wall";
}

TEST_F(CleanerAttachmentsTest, Way_FromATileAtTheWall_LeavesItFirst) {
  EXPECT_THAT(Ask(Room(), "way", Numbers({0, 3, 8, 3})), ElementsAre("1", "3", "7.0"));
}

TEST_F(CleanerAttachmentsTest, NearestDirt_IsAPlaceToStandBesideIt) {
  EXPECT_THAT(Ask(Room(), "nearest_dirt", Numbers({2, 3})), IsEmpty());
  const auto memory = Room({"dirty_row(0, runs(5, 5))"});
  EXPECT_THAT(Ask(memory, "nearest_dirt", Numbers({5, 4})), ElementsAre("5", "1"));
  EXPECT_THAT(
      Ask(Room({"dirty_row(0, runs(5, 5))", "tried(5, 1)"}), "nearest_dirt", Numbers({5, 4})),
      ElementsAre("4", "1"));
}

TEST_F(CleanerAttachmentsTest, RowAfter_TakesOverWhatIsSeen) {
  const std::vector<std::string> memory = {"clean_row(3, runs(0, 4))", "dirty_row(3, runs(5, 9))",
                                           "tile(4, 3, blocked)",      "tile(5, 3, clean)",
                                           "tile(12, 3, dirty)",       "tile(1, 2, dirty)"};
  EXPECT_THAT(Ask(memory, "row_after", Numbers({3})),
              ElementsAre("runs(0, 3, 5, 5)", "runs(6, 9, 12, 12)"));
  EXPECT_THAT(Ask(memory, "row_after", Numbers({2})), ElementsAre("none", "runs(1, 1)"));
  EXPECT_THAT(Ask(memory, "row_after", Numbers({7})), ElementsAre("none", "none"));
}

TEST_F(CleanerAttachmentsTest, BadRows_AreNoFloor) {
  EXPECT_THAT(Ask({"clean_row(-1, runs(0, 3))", "clean_row(0, runs(9, 3))",
                   "clean_row(1, runs(0, 99999999))", "clean_row(2, runs(a, b))"},
                  "way", Numbers({1, 1, 1, 1})),
              IsEmpty());
}

TEST_F(CleanerAttachmentsTest, PlacesAndTiles) {
  const auto real = [](double value) { return logic::Term::Real(value); };
  EXPECT_THAT(Ask({}, "tile_at", {real(0.6), real(1.3), real(0.25)}), ElementsAre("2", "5"));
  EXPECT_THAT(Ask({}, "tile_at", {real(1e300), real(1.3), real(0.25)}), IsEmpty());
  const auto seen = Ask({}, "bearing",
                        {real(0.625), real(0.375), real(0.0), logic::Term::Integer(2),
                         logic::Term::Integer(5), real(0.25)});
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[0], "1.0");
  EXPECT_THAT(seen[1], ::testing::StartsWith("1.5707"));
}

}  // namespace
}  // namespace latchwork::cleaner
