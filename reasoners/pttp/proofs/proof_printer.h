// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PROOF_PRINTER_H_
#define LATCHWORK_PTTP_PROOF_PRINTER_H_

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reasoners/pttp/proofs/proof_premise.h"
#include "reasoners/pttp/proofs/tstp_printer.h"
#include "reasoners/pttp/saturation/saturate.h"

namespace latchwork::pttp {

/// Writes a refutation as a TSTP derivation: the formulas used, their clauses, and either one
/// instance of a clause for each step of a tableau and $false, which follows from the instances by
/// propositional logic alone (of many instances: in steps with few parents), or each conclusion of
/// a saturation.
class ProofPrinter {
 public:
  /// `clauses`: what was searched, the clauses of the formulas among them.
  ProofPrinter(std::span<const logic::Clause> clauses, const ProofSources& sources)
      : clauses_(clauses), sources_(sources), tstp_(sources) {}

  // A tableau: everything that it consists of, then the end.
  void Add(const ClauseInstance& instance);
  /// A clause that a built-in theory makes true.
  void AddTheoryFact(const std::vector<logic::Literal>& literals, std::string_view theory);
  void Finish();

  void Print(std::span<const saturation::Step> steps);

  bool uses_conjecture() const { return tstp_.uses_conjecture(); }
  std::span<const logic::Clause> clauses() const { return clauses_; }

  std::vector<std::string> lines;
  std::vector<std::vector<std::string>> answers;
  std::vector<ProofPremise> premises;  ///< Of a tableau: all that was added.

 private:
  /// One of the clauses that contradict each other.
  struct Premise {
    std::string name;
    std::vector<logic::Literal> literals;
  };

  void AddAnswer(const ClauseInstance& instance);
  void PrintChain(const std::vector<Premise>& all);

  std::span<const logic::Clause> clauses_;
  ProofSources sources_;
  TstpPrinter tstp_;
  std::set<std::string> known_instances_;
  std::vector<Premise> instances_;  ///< With the names of the clauses.
  std::vector<Premise> facts_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PROOF_PRINTER_H_
