// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_ICARUS_RANDOM_PROGRAM_H_
#define LATCHWORK_TESTS_REASONERS_ICARUS_RANDOM_PROGRAM_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace latchwork::icarus::testing {

/// What a random program may hold.
struct RandomProgramOptions {
  bool sequences = true;
  bool memory_changes = true;
  bool acts_change_memory = true;
};

/// Programs of a few small skills that mostly call later ones, so that most of them end.
class RandomProgram {
 public:
  RandomProgram(std::uint64_t seed, RandomProgramOptions options)
      : state_(seed * 2 + 1), options_(options) {}

  /// The first skill, `s0`, has two parameters at most.
  std::string Text() {
    std::string text = "(facts (p a) (p b) (q a 1) (q b 2) (q c 2) (r (a 1) x) (r (b 2) y))\n";
    const std::size_t skills = 4 + Roll(5);
    for (std::size_t i = 0; i < skills; ++i) arity_.push_back(Roll(3));
    for (std::size_t i = 0; i < skills; ++i) text += SkillText(i);
    return text;
  }

 private:
  std::size_t Roll(std::size_t sides) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>(state_ >> 33U) % sides;
  }

  std::string SkillText(std::size_t index) {
    std::string text = "(s" + std::to_string(index) + " (";
    constexpr std::string_view kParameters[] = {"", "?x", "?x ?y"};
    text += kParameters[arity_[index]];
    text += ") ";
    const bool last = index + 2 >= arity_.size();
    const std::size_t kind = index == 0 ? 0 : Roll(last ? 5 : 7);
    if (kind == 1 || kind > 4 || (last && kind > 2)) {
      text += ":action ({act" + std::to_string(index) + Arguments(index) + "}" + Change() + ")";
    } else if (kind == 2) {
      text += ":sensor (" + SensorClause() + (Roll(2) == 0 ? " " + SensorClause() : "") + ")";
    } else if (kind == 3 && options_.sequences) {
      text += ":sequence (" + Clauses(index, 1 + Roll(3)) + ")";
    } else {
      text += Plan(index);
    }
    if (Roll(4) == 0) text += " :value " + std::to_string(Roll(9));
    return text + ")\n";
  }

  /// What an act may do to memory.
  std::string Change() {
    if (!options_.memory_changes || !options_.acts_change_memory) return "";
    switch (Roll(9)) {
      case 0:
        return " {store (p " + Atom() + ")}";
      case 1:
        return " {forget (q ? " + Atom() + ")}";
      case 2:
        return " {update (r ? " + Bound() + ") (r (" + Atom() + " 1) y)}";
      default:
        return "";
    }
  }

  std::string Arguments(std::size_t index) const {
    constexpr std::string_view kArguments[] = {"", " ?x", " ?x ?y"};
    return std::string(kArguments[arity_[index]]);
  }

  std::string Plan(std::size_t index) {
    std::string text;
    if (Roll(3) != 0) text += ":objective (" + Clauses(index, 1 + Roll(2)) + ") ";
    if (Roll(3) != 0) text += ":requires (" + Clauses(index, Roll(4)) + ") ";
    if (text.empty() || Roll(3) != 0) text += ":means (" + Clauses(index, 1 + Roll(3)) + ")";
    return text;
  }

  std::string Clauses(std::size_t index, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : " ") + Clause(index);
    return text;
  }

  std::string Clause(std::size_t index) {
    switch (Roll(18)) {
      case 0:
        return "(*not* " + Clause(index) + ")";
      case 1:
        return "(*notA* " + Clause(index) + ")";
      case 2:
        return "{f" + std::to_string(Roll(3)) + " " + Bound() + "}";
      case 3:
        return "(bind " + Variable() + " " + (Roll(2) == 0 ? TermText() : "{v " + Atom() + "}") +
               ")";
      case 4:
        return "(p " + TermText() + ")";
      case 5:
        return "(q " + TermText() + " " + TermText() + ")";
      case 6:
        return "(r (" + TermText() + " " + TermText() + ") " + TermText() + ")";
      case 7:
        return "(?h " + TermText() + ")";
      default:
        return SkillCall(index);
    }
  }

  std::string SkillCall(std::size_t index) {
    const std::size_t later = arity_.size() - index - 1;
    const std::size_t callee = later == 0 || Roll(16) == 0 ? index : index + 1 + Roll(later);
    std::string text = "(s" + std::to_string(callee);
    for (std::size_t i = 0; i < arity_[callee]; ++i) text += " " + TermText();
    return text + ")";
  }

  std::string SensorClause() {
    switch (Roll(options_.memory_changes ? 5 : 2)) {
      case 0:
        return "(bind ?x {v " + Atom() + "})";
      case 1:
        return "{f0 " + Atom() + "}";
      case 2:
        return "{store (p " + Atom() + ")}";
      case 3:
        return "{forget (q " + Atom() + " ?)}";
      default:
        return "{update (p " + Atom() + ") (p " + Atom() + ")}";
    }
  }

  std::string Variable() {
    constexpr std::string_view kVariables[] = {"?x", "?y", "?z", "?u"};
    return std::string(kVariables[Roll(4)]);
  }
  std::string Atom() {
    constexpr std::string_view kAtoms[] = {"a", "b", "c", "1", "2", "x"};
    return std::string(kAtoms[Roll(6)]);
  }
  std::string Bound() { return Roll(2) == 0 ? Variable() : Atom(); }
  std::string TermText() {
    switch (Roll(6)) {
      case 0:
        return Atom();
      case 1:
        return Roll(2) == 0 ? "?" : "(" + Bound() + " " + Bound() + ")";
      default:
        return Variable();
    }
  }

  std::uint64_t state_;
  RandomProgramOptions options_;
  std::vector<std::size_t> arity_;
};

}  // namespace latchwork::icarus::testing

#endif  // LATCHWORK_TESTS_REASONERS_ICARUS_RANDOM_PROGRAM_H_
