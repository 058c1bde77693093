// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_PTTP_AGENT_MIND_H_
#define LATCHWORK_TESTS_REASONERS_PTTP_AGENT_MIND_H_

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/tptp.h"
#include "reasoners/pttp/pttp_reasoner.h"

namespace latchwork::pttp {

/// A reasoner with a theory, for tests: everything is given as text.
template <typename Reasoner>
class MindOf {
 public:
  explicit MindOf(std::string_view theory = "") : MindOf(TestName(), theory) {}
  /// `name` keeps the files of different programs apart.
  MindOf(std::string_view name, std::string_view theory)
      : file_(std::filesystem::path(::testing::TempDir()) / ("pttp_" + std::string(name) + ".p")) {
    Write(theory);
    body.language = "tptp";
    body.files.push_back(file_);
  }
  MindOf(const MindOf&) = delete;
  MindOf& operator=(const MindOf&) = delete;
  ~MindOf() { std::filesystem::remove(file_); }

  void Write(std::string_view theory) const { std::ofstream(file_, std::ios::binary) << theory; }

  logic::Atom Atom(std::string_view text, std::size_t* variables = nullptr) {
    auto read = logic::ReadTptpAtom(text, "test", symbols);
    EXPECT_TRUE(read.atom.has_value()) << text << "\n" << Format(read.diagnostics);
    if (variables != nullptr) *variables = read.variable_names.size();
    return read.atom.value_or(logic::Atom());
  }
  logic::PredicateName Name(std::string_view predicate, std::size_t arity) {
    return {symbols.Intern(predicate), arity};
  }
  void Input(std::string_view predicate, std::size_t arity) {
    body.inputs.push_back(Name(predicate, arity));
  }
  void Minimize(std::string_view predicate, std::size_t arity, std::uint32_t depth = 0) {
    body.minimized.push_back({Name(predicate, arity), depth});
  }
  void Goal(std::string_view pattern, sdk::Goal::Answers answers = sdk::Goal::Answers::kFirst) {
    sdk::Goal goal;
    goal.pattern = Atom(pattern, &goal.variables);
    goal.answers = answers;
    body.goals.push_back(std::move(goal));
  }
  void Parameter(std::string name, std::string value) {
    given_.push_back({std::move(name), std::move(value), {}});
  }

  logic::Diagnostics TryLoad() {
    logic::Diagnostics diagnostics;
    const auto parameters =
        sdk::Parameters::Check(reasoner.parameters(), given_, "pttp", {}, diagnostics);
    EXPECT_TRUE(diagnostics.empty()) << Format(diagnostics);
    return reasoner.Load(body, parameters, symbols);
  }
  void Load() {
    const auto diagnostics = TryLoad();
    ASSERT_TRUE(diagnostics.empty()) << Format(diagnostics);
  }

  /// Fills a latch, adding it when it is new.
  void Latch(std::size_t index, const std::vector<std::string>& facts) {
    while (latches.size() <= index) {
      latches.push_back({"latch" + std::to_string(latches.size()), {}, 0});
    }
    latches[index].facts.clear();
    for (const std::string& fact : facts) latches[index].facts.push_back(Atom(fact));
    latches[index].version = ++version_;
  }
  const sdk::Decision& Decide() {
    reasoner.Decide(latches, budget, decision);
    return decision;
  }
  std::vector<std::string> Conclusions() const {
    std::vector<std::string> result;
    for (const auto& conclusion : decision.conclusions) result.push_back(ToString(conclusion.fact));
    return result;
  }

  logic::SymbolTable symbols;
  sdk::Body body;
  std::vector<sdk::Latch> latches;
  sdk::Budget budget;
  sdk::Decision decision;
  Reasoner reasoner;

 private:
  static std::string TestName() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test->test_suite_name()) + "_" + test->name();
    std::ranges::replace(name, '/', '_');
    return name;
  }

  std::filesystem::path file_;
  std::vector<sdk::Parameters::Given> given_;
  std::uint64_t version_ = 0;
};

using AgentMind = MindOf<PttpReasoner>;

}  // namespace latchwork::pttp

#endif  // LATCHWORK_TESTS_REASONERS_PTTP_AGENT_MIND_H_
