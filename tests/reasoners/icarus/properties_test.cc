// SPDX-License-Identifier: BSD-3-Clause
//
// What holds of every program, on thousands of random ones; and agreement with the reference.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/machine/interpreter.h"
#include "reasoners/icarus/tools/world_script.h"
#include "tests/reasoners/icarus/random_program.h"
#include "tests/reasoners/icarus/reference.h"

namespace latchwork::icarus::testing {
namespace {

constexpr std::size_t kCycles = 4;

/// The answer to a call in a world: a function of the call's text.
std::string AnswerTo(std::string_view call, std::uint64_t world) {
  std::uint64_t hash = world * 0x9e3779b97f4a7c15ULL + 1;
  for (const char c : call) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  hash ^= hash >> 29U;
  constexpr std::array<std::string_view, 4> kValues = {"a", "b", "1", ""};
  if (call.starts_with("v")) return std::string(kValues.at(hash % 4));
  return hash % 2 == 0 ? "t" : "";
}

class HashedWorld : public Host {
 public:
  std::span<const Signature> functions() const override {
    static constexpr std::array<Signature, 4> kFunctions = {{{"f0"}, {"f1"}, {"f2"}, {"v"}}};
    return kFunctions;
  }
  Value Call(std::size_t function, std::span<const Value> arguments, Arena& /*arena*/,
             NamePool& names) override {
    std::string text(functions()[function].name);
    for (const Value& argument : arguments) text += ' ' + ToString(argument, names);
    const std::string answer = AnswerTo(text, world);
    if (answer.empty()) return {};
    return answer == "1" ? Value::Integer(1) : Value::Symbol(names.Intern(answer));
  }
  std::uint64_t world = 0;
};

/// What the cycles of a program came to.
struct Trace {
  std::vector<std::vector<std::string>> acts;
  std::vector<std::vector<std::string>> environments;
  std::vector<std::string> memory;
  friend bool operator==(const Trace&, const Trace&) = default;
};

RunOptions Options(ActMode mode, bool lazy = false) {
  RunOptions options;
  options.acts = mode;
  options.lazy = lazy;
  options.max_depth = 9;
  options.max_clauses = 1U << 30U;
  return options;
}

/// (s0 ?x ?y), with as many variables as it has parameters.
std::string OpenTop(const Program& program) {
  constexpr std::array<std::string_view, 3> kTops = {"(s0)", "(s0 ?x)", "(s0 ?x ?y)"};
  return std::string(kTops.at(program.skills[0].parameters));
}

std::vector<std::string> Environments(const CycleResult& result, const NamePool& names) {
  std::vector<std::string> environments(result.environments);
  const std::size_t variables =
      environments.empty() ? 0 : result.values.size() / environments.size();
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    environments[i / variables] += ToString(result.values[i], names) + ' ';
  }
  return environments;
}

Trace Interpret(const Program& program, const RunOptions& options, std::uint64_t seed) {
  Trace run;
  NamePool names;
  HashedWorld world;
  Interpreter interpreter(program, world, names, options);
  Findings findings;
  const std::size_t top = interpreter.AddTop(OpenTop(program), findings);
  for (std::size_t i = 0; i < kCycles; ++i) {
    world.world = seed + i / 2;
    const CycleResult& result = interpreter.Cycle(top);
    std::vector<std::string>& acts = run.acts.emplace_back();
    for (const Act& act : result.acts) acts.push_back(ToString(act, names));
    run.environments.push_back(Environments(result, names));
    std::string& memory = run.memory.emplace_back();
    for (const auto* fact = interpreter.memory().First(); fact != nullptr; fact = fact->next) {
      if (fact->died == 0) memory += ToString(fact->value, names);
    }
  }
  return run;
}

/// False: too much work for a test.
bool Refer(const Program& program, const RunOptions& options, std::uint64_t seed, Trace& run) {
  std::uint64_t world = 0;
  Reference reference(
      program, [&](const std::string& call) { return AnswerTo(call, world); }, options);
  for (std::size_t i = 0; i < kCycles; ++i) {
    world = seed + i / 2;
    reference.Cycle(0);
    if (reference.too_much) return false;
    run.acts.push_back(reference.acts);
    run.environments.push_back(reference.environments);
    run.memory.push_back(reference.Memory());
  }
  return true;
}

/// Calls `check(text, program, seed, run of the reference in mode all)`.
template <typename Check>
void ForRandomPrograms(std::size_t count, RandomProgramOptions options, const Check& check) {
  std::size_t acting = 0;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const std::string text = RandomProgram(seed, options).Text();
    const ProgramFile file = ReadProgram(text, "p.icarus");
    ASSERT_FALSE(HasErrors(file.findings)) << Format(file.findings.front()) << text;
    Trace all;
    if (!Refer(file.program, Options(ActMode::kAll), seed, all)) continue;
    for (const auto& acts : all.acts) acting += acts.empty() ? 0 : 1;
    check(text, file.program, seed, all);
    if (::testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(acting, count / 2) << "the programs do too little to say anything";
}

TEST(IcarusPropertiesTest, Interpreter_AgreesWithTheReferenceInAllModes) {
  ForRandomPrograms(
      3000, {},
      [](const std::string& text, const Program& program, std::uint64_t seed, Trace& all) {
        ASSERT_EQ(Interpret(program, Options(ActMode::kAll), seed), all) << text;
        for (const ActMode mode : {ActMode::kFirst, ActMode::kValue}) {
          Trace other;
          ASSERT_TRUE(Refer(program, Options(mode), seed, other));
          ASSERT_EQ(Interpret(program, Options(mode), seed), other) << text;
        }
      });
}

TEST(IcarusPropertiesTest, Interpreter_AgreesWithTheReferenceOnMeansAndRestarts) {
  constexpr std::array<Expansion, 3> kExpansions = {Expansion::kAll, Expansion::kFirst,
                                                    Expansion::kBest};
  constexpr std::array<ActMode, 3> kModes = {ActMode::kAll, ActMode::kFirst, ActMode::kValue};
  ForRandomPrograms(
      3000, {}, [&](const std::string& text, const Program& program, std::uint64_t seed, Trace&) {
        RunOptions options = Options(kModes.at(seed / 3 % 3));
        options.expansion = kExpansions.at(seed % 3);
        options.means = 1 + seed / 9 % 2;
        options.restart = seed % 2 == 0;
        Trace other;
        if (!Refer(program, options, seed, other)) return;
        ASSERT_EQ(Interpret(program, options, seed), other) << text;
      });
}

TEST(IcarusPropertiesTest, First_IsTheHeadOfAllAndTruthIsTheSameInEveryMode) {
  ForRandomPrograms(
      2000, {true, true, false},
      [](const std::string& text, const Program& program, std::uint64_t seed, Trace& all) {
        const Trace first = Interpret(program, Options(ActMode::kFirst), seed);
        for (std::size_t i = 0; i < kCycles; ++i) {
          const bool acts = !all.acts[i].empty();
          ASSERT_EQ(first.acts[i].size(), acts ? 1U : 0U) << text;
          if (acts) {
            ASSERT_EQ(first.acts[i][0], all.acts[i][0]) << text;
          }
        }
        ASSERT_EQ(first.environments, all.environments) << text;
        const Trace value = Interpret(program, Options(ActMode::kValue), seed);
        ASSERT_EQ(value.environments, all.environments) << text;
      });
}

TEST(IcarusPropertiesTest, Lazy_GivesTheSameActAsFull) {
  ForRandomPrograms(
      2000, {false, false},
      [](const std::string& text, const Program& program, std::uint64_t seed, Trace& /*all*/) {
        const Trace full = Interpret(program, Options(ActMode::kFirst), seed);
        const Trace lazy = Interpret(program, Options(ActMode::kFirst, true), seed);
        ASSERT_EQ(lazy.acts, full.acts) << text;
      });
}

/// One cycle in words: acts, environments, faults and the memory after it.
std::string CycleText(Interpreter& interpreter, std::size_t top, const NamePool& names) {
  const CycleResult& result = interpreter.Cycle(top);
  std::string text;
  for (const Act& act : result.acts) text += (act.started ? "+" : "=") + ToString(act, names);
  for (const Act& act : result.stopped) text += "-" + ToString(act, names);
  text += ' ' + std::to_string(result.environments) + ' ' + std::to_string(result.fault_count) +
          ' ' + std::to_string(result.clauses) + ' ' +
          std::to_string(interpreter.sequence_states());
  for (const auto* fact = interpreter.memory().First(); fact != nullptr; fact = fact->next) {
    if (fact->died == 0) text += ToString(fact->value, names);
  }
  return text;
}

TEST(IcarusPropertiesTest, Cycle_DependsOnProgramMemorySequencesAndAnswersOnly) {
  ForRandomPrograms(
      2000, {},
      [](const std::string& text, const Program& program, std::uint64_t seed, Trace& /*all*/) {
        NamePool names;
        HashedWorld world;
        Findings findings;
        const RunOptions options = Options(seed % 2 == 0 ? ActMode::kFirst : ActMode::kAll);
        Interpreter one(program, world, names, options);
        Interpreter two(program, world, names, options);
        Interpreter other(program, world, names, options);
        const std::size_t top = one.AddTop("(s0)", findings);
        two.AddTop("(s0)", findings);
        other.AddTop("(s0)", findings);
        for (std::uint64_t cycle = 0; cycle < 2; ++cycle) {
          world.world = seed + cycle;
          ASSERT_EQ(CycleText(one, top, names), CycleText(two, top, names)) << text;
        }
        // No history, but now the same memory and the same states of sequences.
        other.TakeOver(two, std::numeric_limits<std::size_t>::max());
        for (std::uint64_t cycle = 2; cycle < kCycles; ++cycle) {
          world.world = seed + cycle;
          ASSERT_EQ(CycleText(one, top, names), CycleText(other, top, names)) << text;
        }
      });
}

}  // namespace
}  // namespace latchwork::icarus::testing
