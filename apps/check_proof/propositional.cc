// SPDX-License-Identifier: BSD-3-Clause
#include "apps/check_proof/propositional.h"

#include <algorithm>
#include <map>

namespace latchwork::check_proof {
namespace {

constexpr std::size_t kMostDecisions = 200'000;

/// Davis, Logemann and Loveland 1962.
class Search {
 public:
  explicit Search(const std::vector<std::vector<logic::Literal>>& clauses) {
    std::map<logic::Atom, std::size_t> numbers;
    for (const auto& clause : clauses) {
      std::vector<std::size_t> literals;
      for (const logic::Literal& literal : clause) {
        const auto place = numbers.emplace(literal.atom, numbers.size()).first;
        literals.push_back(2 * place->second + (literal.positive ? 0 : 1));
      }
      std::sort(literals.begin(), literals.end());
      literals.erase(std::unique(literals.begin(), literals.end()), literals.end());
      clauses_.push_back(std::move(literals));
    }
    occurrences_.resize(2 * numbers.size());
    value_.assign(2 * numbers.size(), kOpen);
    for (std::size_t i = 0; i < clauses_.size(); ++i) {
      for (const std::size_t literal : clauses_[i]) occurrences_[literal].push_back(i);
    }
  }

  Verdict Run() {
    bool consistent = true;
    for (std::size_t i = 0; consistent && i < clauses_.size(); ++i) consistent = Examine(i);
    if (!consistent || !Propagate()) return Verdict::kYes;
    std::size_t decided = 0;
    for (std::size_t literal = Choose(); literal != value_.size(); literal = Choose()) {
      if (++decided > kMostDecisions) return Verdict::kTooHard;
      decisions_.push_back({trail_.size(), literal});
      Set(literal);
      while (!Propagate()) {
        if (!Backtrack()) return Verdict::kYes;
      }
    }
    return Verdict::kNo;
  }

 private:
  enum Value : unsigned char { kOpen, kTrue, kFalse };
  struct Decision {
    std::size_t mark;
    std::size_t literal;
  };

  void Set(std::size_t literal) {
    value_[literal] = kTrue;
    value_[literal ^ 1U] = kFalse;
    trail_.push_back(literal);
  }

  /// Sets what a clause forces; false when nothing is left of it.
  bool Examine(std::size_t clause) {
    std::size_t open = 0;
    std::size_t last = 0;
    for (const std::size_t literal : clauses_[clause]) {
      if (value_[literal] == kTrue) return true;
      if (value_[literal] == kFalse) continue;
      ++open;
      last = literal;
    }
    if (open == 1) Set(last);
    return open > 0;
  }

  bool Propagate() {
    for (; next_ < trail_.size(); ++next_) {
      for (const std::size_t clause : occurrences_[trail_[next_] ^ 1U]) {
        if (!Examine(clause)) return false;
      }
    }
    return true;
  }

  bool Backtrack() {
    if (decisions_.empty()) return false;
    const Decision last = decisions_.back();
    decisions_.pop_back();
    for (; trail_.size() > last.mark; trail_.pop_back()) {
      value_[trail_.back()] = value_[trail_.back() ^ 1U] = kOpen;
    }
    next_ = trail_.size();
    Set(last.literal ^ 1U);
    return true;
  }

  /// An open literal of the first clause that does not hold yet.
  std::size_t Choose() const {
    for (const auto& clause : clauses_) {
      std::size_t open = value_.size();
      bool holds = false;
      for (const std::size_t literal : clause) {
        holds = holds || value_[literal] == kTrue;
        if (value_[literal] == kOpen) open = literal;
      }
      if (!holds) return open;
    }
    return value_.size();
  }

  std::vector<std::vector<std::size_t>> clauses_;
  std::vector<std::vector<std::size_t>> occurrences_;  ///< By literal.
  std::vector<Value> value_;                           ///< By literal.
  std::vector<std::size_t> trail_;
  std::vector<Decision> decisions_;
  std::size_t next_ = 0;
};

}  // namespace

Verdict Contradict(const std::vector<std::vector<logic::Literal>>& clauses) {
  return Search(clauses).Run();
}

}  // namespace latchwork::check_proof
