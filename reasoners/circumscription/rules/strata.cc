// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/rules/strata.h"

#include <algorithm>
#include <cstdint>

namespace latchwork::circumscription {
namespace {

constexpr std::size_t kUnseen = SIZE_MAX;

/// Follows edges from needing to needed relations, so that components come out needed first.
class Components {
 public:
  Components(std::size_t relations, const Dependencies& dependencies)
      : needs_(relations), low_(relations, kUnseen), open_(relations, false) {
    result_.stratum.assign(relations, kUnseen);
    for (const auto& [needed, needing] : dependencies) needs_[needing].push_back(needed);
  }

  StrataOf Find() {
    for (std::size_t relation = 0; relation < needs_.size(); ++relation) {
      if (low_[relation] == kUnseen) Visit(relation);
    }
    return std::move(result_);
  }

 private:
  void Visit(std::size_t relation) {
    const std::size_t number = next_++;
    low_[relation] = number;
    open_[relation] = true;
    stack_.push_back(relation);
    bool loops = false;
    for (const std::size_t needed : needs_[relation]) {
      loops = loops || needed == relation;
      if (low_[needed] == kUnseen) Visit(needed);
      if (open_[needed]) low_[relation] = std::min(low_[relation], low_[needed]);
    }
    if (low_[relation] == number) Close(relation, loops);
  }

  void Close(std::size_t relation, bool loops) {
    const std::size_t stratum = result_.is_recursive.size();
    result_.is_recursive.push_back(loops || stack_.back() != relation);
    while (result_.stratum[relation] == kUnseen) {
      result_.stratum[stack_.back()] = stratum;
      open_[stack_.back()] = false;
      stack_.pop_back();
    }
  }

  std::vector<std::vector<std::size_t>> needs_;
  std::vector<std::size_t> low_;
  std::vector<bool> open_;
  std::vector<std::size_t> stack_;
  std::size_t next_ = 0;
  StrataOf result_;
};

}  // namespace

StrataOf FindStrata(std::size_t relations, const Dependencies& dependencies) {
  return Components(relations, dependencies).Find();
}

}  // namespace latchwork::circumscription
