// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_FINGERPRINTER_H_
#define LATCHWORK_PTTP_TABLEAU_FINGERPRINTER_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoners/pttp/tableau/fingerprint.h"
#include "reasoners/pttp/tableau/matrix_terms.h"

namespace latchwork::pttp {

struct MatrixLiteral;

/// Chooses the places of a predicate's fingerprint: where most of its literals have a functor,
/// each below another or an argument itself.
class Fingerprinter {
 public:
  /// `literals` are all those of one predicate.
  Fingerprinter(const std::vector<Cell>& cells, std::span<MatrixLiteral* const> literals);

  /// What is known of a literal before the search; `probes` gets the rest.
  Fingerprint Take(const MatrixLiteral& literal, std::vector<Probe>& probes) const;

 private:
  static constexpr std::uint8_t kArgument = 0xff;
  static constexpr std::uint32_t kMostBelow = 8;  ///< Arguments of a term that are looked at.
  struct Place {
    std::uint8_t above = kArgument;  ///< The place of the term around it.
    std::uint32_t index = 0;
  };
  struct Candidate {
    Place place;
    std::size_t functors = 0;  ///< How many literals have one there.
    std::uint32_t arity = 0;   ///< The greatest of them.
  };

  void AddCandidate(Place place);
  /// The term of a literal at a place; 0: none, or it depends on a variable.
  Cell At(const MatrixLiteral& literal, Place place) const;

  const std::vector<Cell>& cells_;
  std::span<MatrixLiteral* const> literals_;
  std::vector<Candidate> candidates_;
  std::vector<Place> places_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_FINGERPRINTER_H_
