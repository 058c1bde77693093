// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/tools/formatter.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoners/icarus/language/reader.h"
#include "tests/reasoners/icarus/programs.h"

namespace latchwork::icarus {
namespace {

SourceTree Read(std::string text) {
  Findings findings;
  SourceTree tree = ReadForms(std::move(text), "p.icarus", findings);
  EXPECT_TRUE(findings.empty());
  return tree;
}

std::string Formatted(std::string_view text) { return FormatProgram(Read(std::string(text))); }

/// What a layout may not change: brackets, atoms and comments, each kind in its order.
std::vector<std::string> Content(const SourceTree& tree) {
  std::vector<std::string> content;
  for (FormId id = 0; id < tree.forms.size(); ++id) {
    const FormKind kind = tree.kind(id);
    const bool list = kind == FormKind::kList || kind == FormKind::kCall;
    content.push_back(list ? std::to_string(tree.Children(id).size()) : std::string(tree.Text(id)));
  }
  for (const Comment& comment : tree.comments) content.emplace_back(tree.Text(comment));
  return content;
}

TEST(IcarusFormatterTest, CanonicalText_StaysAsItIs) {
  EXPECT_EQ(Formatted(testing::kCollide), testing::kCollide);
  EXPECT_EQ(Formatted(testing::kFastest), testing::kFastest);
}

TEST(IcarusFormatterTest, Top_StandsOnItsLine) {
  EXPECT_EQ(Formatted("(top\n  (Go 1\n 2))\n(top (?x) :objective ({f ?x})\n:means ((Go)))"),
            "(top (Go 1 2))\n(top (?x)\n  :objective ({f ?x})\n  :means     ((Go)))\n");
}

TEST(IcarusFormatterTest, Comments_StayWithWhatTheyAreAbout) {
  constexpr std::string_view kText =
      ";; A program\n\n\n\n(CollideWithCar (?car) ; top\n :objective ; goal\n  ({InContact ?car})"
      " :requires ((Face ?car) ; first\n(Near ?car)) ; both\n :means ((Accelerate 1)\n;; dangling\n"
      ")) ; after\n(facts)\n; the end";
  constexpr std::string_view kExpected =
      ";; A program\n\n(CollideWithCar (?car)  ; top\n  ; goal\n  :objective ({InContact ?car})\n"
      "  :requires  ((Face ?car)  ; first\n              (Near ?car))  ; both\n"
      "  :means     ((Accelerate 1)\n              ;; dangling\n              ))  ; after\n"
      "(facts)\n; the end\n";
  EXPECT_EQ(Formatted(kText), kExpected);
  EXPECT_EQ(Formatted(kExpected), kExpected);
}

TEST(IcarusFormatterTest, LongSlots_AreBrokenBetweenClauses) {
  const std::string clause = "{a-rather-long-name-of-a-function ?x}";
  const std::string text = "(A (?x) :objective (" + clause + " " + clause + " " + clause + "))\n";
  const std::string margin(20, ' ');
  EXPECT_EQ(Formatted(text), "(A (?x)\n  :objective (" + clause + "\n" + margin.substr(6) + clause +
                                 "\n" + margin.substr(6) + clause + "))\n");
}

/// A small generator of its own: the same texts on every machine.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed * 2 + 1) {}
  std::size_t Roll(std::size_t sides) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>(state_ >> 33U) % sides;
  }

 private:
  std::uint64_t state_;
};

void AppendBlank(Dice& dice, std::string& text) {
  constexpr std::string_view kBlanks[] = {" ", "\n", "  ", "\n\n\n", " ; c\n", "\n;; d \n  ", "\t"};
  text += kBlanks[dice.Roll(std::size(kBlanks))];
}

void AppendForm(Dice& dice, std::string& text, int depth) {
  constexpr std::string_view kAtoms[] = {
      "a",   "?x",        ":means", "12.5",
      "*C*", "\"s ; t\"", "facts",  "a-name-that-takes-room-in-its-line"};
  if (depth == 0 || dice.Roll(3) == 0) {
    text += kAtoms[dice.Roll(std::size(kAtoms))];
    return;
  }
  const bool list = dice.Roll(4) != 0;
  text += list ? '(' : '{';
  for (std::size_t n = dice.Roll(6); n > 0; --n) {
    AppendForm(dice, text, depth - 1);
    AppendBlank(dice, text);
  }
  text += list ? ')' : '}';
}

TEST(IcarusFormatterTest, RandomTexts_KeepTheirContentAndFormatOnce) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Dice dice(seed);
    std::string text;
    for (std::size_t n = dice.Roll(4); n > 0; --n) {
      AppendForm(dice, text, 5);
      AppendBlank(dice, text);
    }
    const SourceTree tree = Read(text);
    const std::string once = FormatProgram(tree);
    const SourceTree again = Read(once);
    ASSERT_EQ(Content(tree), Content(again)) << text << "\n----\n" << once;
    ASSERT_EQ(FormatProgram(again), once) << text;
  }
}

}  // namespace
}  // namespace latchwork::icarus
