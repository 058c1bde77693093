// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_THEORY_H_
#define LATCHWORK_PTTP_THEORY_H_

#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/logic/tptp.h"
#include "latchwork/sdk/reasoner.h"

namespace latchwork::pttp {

/// The clauses of a body as they are read, told and retracted.
class Theory {
 public:
  Theory(const sdk::Body& body, logic::SymbolTable& symbols) : body_(&body), symbols_(&symbols) {}

  /// Reads the files of the body. On diagnostics nothing was kept.
  logic::Diagnostics ReadFiles();
  logic::Diagnostics Tell(std::string_view text);
  logic::Diagnostics Retract(std::string_view name);

  /// What was read and told; with equality axioms when asked for and a clause can conclude an
  /// equation.
  std::vector<logic::Clause> Clauses(bool equality_axioms) const;

 private:
  logic::Diagnostics Add(const std::vector<logic::TptpFile>& files);
  void CheckUses(const std::vector<logic::Clause>& clauses, logic::Diagnostics& diagnostics) const;

  const sdk::Body* body_;
  logic::SymbolTable* symbols_;
  std::vector<logic::Clause> clauses_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_THEORY_H_
