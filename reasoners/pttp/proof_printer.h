// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PROOF_PRINTER_H_
#define LATCHWORK_PTTP_PROOF_PRINTER_H_

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/formula.h"
#include "reasoners/pttp/engine.h"
#include "reasoners/pttp/machine.h"

namespace latchwork::pttp {

/// Writes a recorded proof as a TSTP derivation: the formulas used, their clauses, one instance of
/// a clause for each step, and $false, which follows from the instances by propositional logic
/// alone.
class ProofPrinter {
 public:
  ProofPrinter(Engine& engine, const std::vector<logic::AnnotatedFormula>& formulas,
               std::string_view file)
      : engine_(engine), formulas_(formulas), file_(file) {}

  void Print(const Proof& proof);

  std::vector<std::string> lines;
  std::vector<std::vector<std::string>> answers;

 private:
  std::string Leaf(const logic::AnnotatedFormula& formula);
  std::string NegatedConjecture(const logic::AnnotatedFormula* formula);
  std::string Parent(const logic::Clause& clause);
  std::string ClauseLine(std::uint32_t index);
  void Instance(std::uint32_t index, const Contrapositive& rule, const Word* slots);
  void AddInstance(std::string_view literals, std::string_view source);
  void AddFact(const logic::Atom& fact);
  void AddStep(const Step& step);
  void AddAnswer(const logic::Clause& clause, const Word* slots);

  Engine& engine_;
  const std::vector<logic::AnnotatedFormula>& formulas_;
  std::string_view file_;
  std::map<std::string, std::string, std::less<>> leaves_;
  std::map<std::uint32_t, std::string> clauses_;
  std::set<std::string> known_instances_;
  std::vector<std::string> instances_;
  std::vector<Word> variables_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PROOF_PRINTER_H_
