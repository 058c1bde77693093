// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CONTRAPOSITIVES_SIGNED_GRAPH_H_
#define LATCHWORK_CONTRAPOSITIVES_SIGNED_GRAPH_H_

#include <cstddef>
#include <vector>

namespace latchwork::contrapositives {

/// A predicate with a sign, as an index: the complement of 2n is 2n + 1, which is positive.
using Signed = std::size_t;
inline Signed SignedOf(std::size_t predicate, bool positive) {
  return 2 * predicate + (positive ? 1U : 0U);
}
inline Signed ComplementOf(Signed key) { return key ^ 1U; }

/// Which goals can lead to which, through rules that can be of use.
class SignedGraph {
 public:
  struct Rule {
    Signed head = 0;
    std::vector<Signed> body;
    bool is_alive = true;
  };
  struct Predicate {
    bool is_root = false;   ///< May be asked from outside.
    bool is_given = false;  ///< May hold without a rule: facts, closing, attachments, arithmetic.
  };

  SignedGraph(std::vector<Rule> rules, std::vector<Predicate> predicates);

  bool is_alive(std::size_t rule) const { return rules_[rule].is_alive; }
  /// Predicates that came later have none.
  bool HasRules(Signed key) const { return key < successors_.size() && !successors_[key].empty(); }
  /// The complement of such a goal can be among its ancestors.
  bool Meets(Signed key) const { return key < meets_.size() && meets_[key]; }
  /// Such a goal may have one like itself, or one that does, below it.
  bool IsDeep(Signed key) const { return deep_[key]; }
  /// Whether such a goal fails does not depend on its ancestors.
  bool IsIndependent(Signed key) const { return independent_[key]; }
  /// All that a goal can have below it; itself only on a cycle.
  std::vector<bool> Below(Signed key) const;

 private:
  void Connect();
  void MarkReachable();
  void MarkMeeting();
  bool DropDeadRules();

  std::vector<Rule> rules_;
  std::vector<Predicate> predicates_;
  std::vector<std::vector<const Rule*>> successors_;
  std::vector<bool> reachable_;
  std::vector<bool> meets_;
  std::vector<bool> deep_;
  std::vector<bool> independent_;
};

}  // namespace latchwork::contrapositives

#endif  // LATCHWORK_CONTRAPOSITIVES_SIGNED_GRAPH_H_
