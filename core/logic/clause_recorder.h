// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_CLAUSE_RECORDER_H_
#define LATCHWORK_LOGIC_CLAUSE_RECORDER_H_

#include <cstddef>
#include <string>
#include <vector>

#include "core/logic/normal_tree.h"
#include "latchwork/logic/clause_origins.h"

namespace latchwork::logic {

/// Writes down what a ClauseMaker does: the formula that it reads and the Skolemized one, built
/// children first.
class ClauseRecorder {
 public:
  explicit ClauseRecorder(const std::vector<std::string>& variable_names)
      : variable_names_(variable_names) {}

  void Begin() {
    normal_.clear();
    skolemized_.clear();
    functions_.clear();
  }
  void Constant(bool value);
  void Literal(bool positive, const Atom& atom, const Atom& substituted);
  void Skolem(Symbol function) { functions_.push_back(function); }
  /// The last `count` formulas become one.
  void Junction(bool is_disjunction, std::size_t count);
  /// `fresh` replaces the variables where they are universal.
  void Quantifier(bool is_universal, const std::vector<Variable>& variables,
                  std::vector<Variable> fresh);

  /// What was built; `sources` gives the variable that each fresh one stands for.
  ClauseOrigins::NormalForm Take(const std::vector<Variable>& sources);

 private:
  const std::vector<std::string>& variable_names_;
  std::vector<Formula> normal_;
  std::vector<Formula> skolemized_;
  std::vector<Symbol> functions_;
};

/// What stands at a node of a tree.
Formula ToFormula(const NormalTree& tree, NormalTree::Id id);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_CLAUSE_RECORDER_H_
