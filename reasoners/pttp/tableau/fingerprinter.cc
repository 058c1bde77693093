// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tableau/fingerprinter.h"

#include <algorithm>
#include <array>

#include "reasoners/pttp/tableau/matrix.h"

namespace latchwork::pttp {

Fingerprinter::Fingerprinter(const std::vector<Cell>& cells,
                             std::span<MatrixLiteral* const> literals)
    : cells_(cells), literals_(literals) {
  for (std::uint32_t i = 0; i < literals.front()->arity; ++i) AddCandidate({kArgument, i});
  while (!candidates_.empty() && places_.size() < Fingerprint::kPlaces) {
    const auto best = std::max_element(
        candidates_.begin(), candidates_.end(),
        [](const Candidate& a, const Candidate& b) { return a.functors < b.functors; });
    const Candidate chosen = *best;
    candidates_.erase(best);
    const auto number = static_cast<std::uint8_t>(places_.size());
    places_.push_back(chosen.place);
    for (std::uint32_t i = 0; i < std::min(chosen.arity, kMostBelow); ++i) {
      AddCandidate({number, i});
    }
  }
}

void Fingerprinter::AddCandidate(Place place) {
  Candidate candidate{place, 0, 0};
  for (const MatrixLiteral* literal : literals_) {
    const Cell cell = At(*literal, place);
    if (IsVariable(cell)) continue;
    ++candidate.functors;
    candidate.arity = std::max(candidate.arity, BlockOfCell(cells_.data(), cell)[1]);
  }
  if (candidate.functors > 0 || place.above == kArgument) candidates_.push_back(candidate);
}

Cell Fingerprinter::At(const MatrixLiteral& literal, Place place) const {
  if (place.above == kArgument) return cells_[literal.arguments + place.index];
  const Cell above = At(literal, places_[place.above]);
  if (IsVariable(above)) return 0;
  const Cell* block = BlockOfCell(cells_.data(), above);
  return place.index < block[1] ? block[2 + place.index] : 0;
}

Fingerprint Fingerprinter::Take(const MatrixLiteral& literal, std::vector<Probe>& probes) const {
  Fingerprint print;
  std::array<bool, Fingerprint::kPlaces> open{};
  for (std::uint32_t i = 0; i < places_.size(); ++i) {
    const Place place = places_[i];
    const Cell cell = At(literal, place);
    if (!IsVariable(cell)) {
      print.Set(i, *BlockOfCell(cells_.data(), cell));
      continue;
    }
    const bool below_open = place.above != kArgument && open[place.above];
    open[i] = cell != 0 || below_open;
    if (!open[i]) continue;
    Probe probe;
    probe.place = static_cast<std::uint8_t>(i);
    probe.variable = cell >> 2U;
    if (place.above == kArgument) {
      probe.argument = place.index;
    } else if (below_open) {
      probe.above = place.above;
      probe.index = static_cast<std::uint8_t>(place.index);
    }
    probes.push_back(probe);
  }
  return print;
}

}  // namespace latchwork::pttp
