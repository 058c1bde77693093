// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_ICARUS_PROGRAM_MIND_H_
#define LATCHWORK_TESTS_REASONERS_ICARUS_PROGRAM_MIND_H_

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latchwork/logic/tptp.h"
#include "latchwork/sdk/contract_body.h"
#include "reasoners/icarus/icarus_reasoner.h"
#include "tests/temporary_folder.h"

namespace latchwork::icarus::testing {

/// A reasoner with a program and a contract, for tests: everything is given as text.
class ProgramMind {
 public:
  explicit ProgramMind(std::string_view program)
      : file_(folder_.Write("program.icarus", program)) {}

  const std::filesystem::path& file() const { return file_; }
  void Input(std::string name, std::vector<sdk::ArgumentType> types) {
    contract.inputs.push_back(Port(std::move(name), types));
  }
  void Output(std::string name, std::vector<sdk::ArgumentType> types) {
    contract.outputs.push_back(Port(std::move(name), types));
  }
  void Parameter(std::string name, std::string value) {
    given_.push_back({std::move(name), std::move(value), {}});
  }
  logic::Fact Fact(std::string_view text) {
    auto read = logic::ReadTptpAtom(text, "test", symbols);
    EXPECT_TRUE(read.atom.has_value()) << text << '\n' << Format(read.diagnostics);
    return read.atom.value_or(logic::Atom());
  }

  logic::Diagnostics TryLoad() {
    logic::Diagnostics diagnostics;
    const auto parameters =
        sdk::Parameters::Check(reasoner.parameters(), given_, "icarus", {}, diagnostics);
    EXPECT_TRUE(diagnostics.empty()) << Format(diagnostics);
    sdk::Body body = sdk::ContractBody(contract, "icarus", symbols);
    body.files = {file_};
    body.facts = facts;
    body.attachments = attachments;
    return reasoner.Load(body, parameters, symbols);
  }
  void Load() {
    const auto diagnostics = TryLoad();
    ASSERT_TRUE(diagnostics.empty()) << Format(diagnostics);
  }

  /// Fills a latch, adding it when it is new.
  void Latch(std::size_t index, const std::vector<std::string>& batch) {
    while (latches.size() <= index) {
      latches.push_back({"latch" + std::to_string(latches.size()), {}, 0});
    }
    latches[index].facts.clear();
    for (const std::string& fact : batch) latches[index].facts.push_back(Fact(fact));
    latches[index].version = ++version_;
  }
  /// The conclusions of a cycle.
  std::vector<std::string> Decide() {
    reasoner.Decide(latches, budget, decision);
    std::vector<std::string> facts_said;
    for (const auto& each : decision.conclusions) facts_said.push_back(ToString(each.fact));
    return facts_said;
  }

  logic::SymbolTable symbols;
  sdk::Contract contract;
  std::vector<logic::Fact> facts;
  std::vector<std::shared_ptr<sdk::Attachment>> attachments;
  IcarusReasoner reasoner;
  std::vector<sdk::Latch> latches;
  sdk::Budget budget;
  sdk::Decision decision;

 private:
  static sdk::PortSpec Port(std::string name, const std::vector<sdk::ArgumentType>& types) {
    sdk::PredicateSpec predicate{name, {}, ""};
    for (const sdk::ArgumentType type : types) predicate.arguments.push_back({"x", type, ""});
    sdk::PortSpec port;
    port.name = std::move(name);
    port.predicates.push_back(std::move(predicate));
    return port;
  }

  test::TemporaryFolder folder_;
  std::filesystem::path file_;
  std::vector<sdk::Parameters::Given> given_;
  std::uint64_t version_ = 0;
};

}  // namespace latchwork::icarus::testing

#endif  // LATCHWORK_TESTS_REASONERS_ICARUS_PROGRAM_MIND_H_
