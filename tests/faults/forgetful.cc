// SPDX-License-Identifier: BSD-3-Clause
//
// The prover, but for the last literal of every clause that has three or more: it forgets that.
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "latchwork/logic/clausify.h"
#include "latchwork/logic/tptp.h"
#include "latchwork/sdk/plugin.h"
#include "reasoners/pttp/pttp_reasoner.h"

namespace latchwork::faults {

class Forgetful final : public sdk::Reasoner {
 public:
  std::string_view language() const override { return "tptp"; }
  std::span<const sdk::ParameterSpec> parameters() const override { return prover_.parameters(); }

  logic::Diagnostics Load(const sdk::Body& body, const sdk::Parameters& parameters,
                          logic::SymbolTable& symbols) override {
    sdk::Body wrong = body;
    for (auto& file : wrong.files) {
      const auto read = logic::ReadTptpFile(file, symbols);
      if (!read.diagnostics.empty()) return read.diagnostics;
      file += ".forgotten";
      std::ofstream stream(file);
      for (logic::Clause& clause : logic::Clausify(read.formulas, symbols)) {
        if (clause.literals.size() >= 3) clause.literals.pop_back();
        stream << logic::WriteTptp(clause) << '\n';
      }
    }
    return prover_.Load(wrong, parameters, symbols);
  }
  void Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
              sdk::Decision& decision) override {
    prover_.Decide(latches, budget, decision);
  }
  void Admit(std::span<const sdk::Latch> latches, std::size_t port,
             std::span<const logic::Fact> batch, const sdk::Budget& budget,
             std::vector<sdk::Refusal>& refused) override {
    prover_.Admit(latches, port, batch, budget, refused);
  }
  logic::Diagnostics Tell(std::string_view text) override { return prover_.Tell(text); }
  logic::Diagnostics Retract(std::string_view name) override { return prover_.Retract(name); }
  sdk::Derivation Explain(std::size_t conclusion) override { return prover_.Explain(conclusion); }

 private:
  pttp::PttpReasoner prover_;
};

}  // namespace latchwork::faults

LATCHWORK_PLUGIN(latchwork::faults::Forgetful, "forgetful", "1.0", "forgets a literal of a clause")
