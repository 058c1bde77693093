// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_PREDICATES_H_
#define LATCHWORK_PTTP_PREDICATES_H_

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "latchwork/logic/arithmetic.h"
#include "latchwork/logic/atom.h"

namespace latchwork::pttp {

using PredicateId = std::uint32_t;

/// How a predicate is decided.
enum class PredicateKind : std::uint8_t { kOrdinary, kEquality, kArithmetic, kAttachment };

/// Numbers predicates and keeps what is special about each. Numbers stay valid when clauses are
/// told or retracted.
class Predicates {
 public:
  Predicates(const logic::Arithmetic& arithmetic, logic::Symbol equality)
      : arithmetic_(&arithmetic), equality_(equality) {}

  struct Info {
    logic::PredicateName name;
    PredicateKind kind = PredicateKind::kOrdinary;
    logic::Arithmetic::Predicate arithmetic{};
    std::uint32_t attachment = 0;
    std::uint64_t inputs = 0;                ///< Attachments: a bit for each input argument.
    std::optional<std::uint32_t> minimized;  ///< Bound of the closing proof; 0: the budget's.
    bool has_facts = false;                  ///< Facts may state it.
  };

  PredicateId Number(const logic::PredicateName& name);
  /// A predicate of facts that no clause can speak of, whatever its name.
  PredicateId AddHidden(const logic::PredicateName& name);
  Info& operator[](PredicateId id) { return infos_[id]; }
  const Info& operator[](PredicateId id) const { return infos_[id]; }
  std::size_t size() const { return infos_.size(); }

 private:
  const logic::Arithmetic* arithmetic_;
  logic::Symbol equality_;
  std::vector<Info> infos_;
  std::unordered_map<std::uint64_t, PredicateId> numbers_;
};

/// A predicate with a sign, as an array index.
inline std::uint32_t Signed(PredicateId predicate, bool positive) {
  return 2 * predicate + (positive ? 1U : 0U);
}
inline std::uint32_t Complement(std::uint32_t signed_predicate) { return signed_predicate ^ 1U; }

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_PREDICATES_H_
