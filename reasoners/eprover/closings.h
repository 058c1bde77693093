// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_EPROVER_CLOSINGS_H_
#define LATCHWORK_EPROVER_CLOSINGS_H_

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/sdk/reasoner.h"

namespace latchwork::eprover {

/// Which minimized predicates a body needs closed, in which order, and over which terms. A term can
/// be an argument where it stands in a fact or clause, and wherever a variable carries it.
class Closings {
 public:
  struct Closing {
    logic::PredicateName predicate;
    bool has_rules = false;  ///< Otherwise only facts state it.
  };

  Closings() = default;
  Closings(const sdk::Body& body, std::span<const logic::Clause> clauses,
           logic::SymbolTable& symbols);

  /// What rests on other closings comes after them.
  const std::vector<Closing>& order() const { return order_; }
  /// Why the closings cannot be ordered, or a predicate not be enumerated; empty: they can.
  const std::string& obstacle() const { return obstacle_; }
  logic::SourcePlace place() const { return place_; }

  /// Every instance of a predicate over the terms of clauses and facts; nothing when these are
  /// more than `most`.
  std::optional<std::vector<logic::Fact>> Instances(const logic::PredicateName& predicate,
                                                    std::span<const logic::Fact> facts,
                                                    std::size_t most);

 private:
  using Position = std::pair<logic::PredicateName, std::size_t>;

  void FindNeeds(const sdk::Body& body, std::span<const logic::Clause> clauses,
                 logic::SymbolTable& symbols);
  void Join(std::span<const logic::Clause> clauses);
  void CheckCarried(const logic::Clause& clause);
  void CheckFinite(std::span<const logic::Clause> clauses);
  std::size_t ClassOf(const Position& position);
  void Unite(std::size_t a, std::size_t b);

  std::vector<Closing> order_;
  std::string obstacle_;
  logic::SourcePlace place_;
  std::map<Position, std::size_t> positions_;
  std::vector<std::size_t> parents_;
  std::map<std::size_t, std::set<logic::Term>> terms_;  ///< Of clauses, by class.
};

}  // namespace latchwork::eprover

#endif  // LATCHWORK_EPROVER_CLOSINGS_H_
