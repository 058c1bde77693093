// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PROOF_PRINTER_H_
#define LATCHWORK_PTTP_PROOF_PRINTER_H_

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latchwork/logic/formula.h"
#include "reasoners/pttp/engine.h"
#include "reasoners/pttp/machine.h"
#include "reasoners/pttp/tstp_printer.h"

namespace latchwork::pttp {

/// Writes a recorded proof as a TSTP derivation: the formulas used, their clauses, one instance of
/// a clause for each step, and $false, which follows from the instances by propositional logic
/// alone.
class ProofPrinter {
 public:
  ProofPrinter(Engine& engine, const ProofSources& sources)
      : engine_(engine), sources_(sources), tstp_(sources) {}

  void Print(const Proof& proof);
  bool uses_conjecture() const { return tstp_.uses_conjecture(); }

  std::vector<std::string> lines;
  std::vector<std::vector<std::string>> answers;

 private:
  void Instance(std::uint32_t index, const Contrapositive& rule, const Word* slots);
  void AddInstance(std::string literals, std::uint32_t clause);
  void AddTheoryFact(const logic::Literal& literal, std::string_view theory);
  void AddFact(const logic::Atom& fact);
  void AddStep(const Step& step);
  void AddAnswer(const logic::Clause& clause, const Word* slots);

  Engine& engine_;
  ProofSources sources_;
  TstpPrinter tstp_;
  std::set<std::string> known_instances_;
  std::vector<std::pair<std::string, std::string>> instances_;  ///< Text, and name of the clause.
  std::vector<std::string> facts_;                              ///< Names.
  std::vector<Word> variables_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PROOF_PRINTER_H_
