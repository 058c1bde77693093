// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SCHEDULE_PORT_CONTRACT_H_
#define LATCHWORK_SCHEDULE_PORT_CONTRACT_H_

#include <string>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/contract.h"

namespace latchwork::schedule {

/// The predicates of a port, ready for checking facts. Thread rule: const and safe.
class PortContract {
 public:
  PortContract(const sdk::PortSpec& port, logic::SymbolTable& symbols);

  bool Declares(const logic::Atom& atom) const;
  /// Why a fact may not pass; empty when it may. A passing fact is declared, ground, of the
  /// declared types, and all its numbers are finite.
  std::string Offence(const logic::Fact& fact) const;

 private:
  struct Predicate {
    logic::PredicateName name;
    std::vector<sdk::ArgumentType> types;
  };
  const Predicate* Find(const logic::Atom& atom) const;

  std::string port_;
  std::vector<Predicate> predicates_;
};

}  // namespace latchwork::schedule

#endif  // LATCHWORK_SCHEDULE_PORT_CONTRACT_H_
