// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_FORMATS_LAY_FILE_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_FORMATS_LAY_FILE_H_

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/diagnostic.h"
#include "reasoners/circumscription/formats/statement_reader.h"
#include "reasoners/circumscription/layered/layered_theory.h"

namespace latchwork::circumscription {

/// A layered theory in text: `p lay LAYERS ATOMS`, then, layer by layer, `L LAYER [NAME]` (1 is the
/// lowest) and the statements of a .circ file, of which those between two `L` lines belong to one
/// layer, and bridges `B GOAL LATCH` from an atom of the layer above to one of this. Queries are
/// cautious, of the form `? ID c literals 0`, over atoms of layer 1. Expected answers (`=`, `s`,
/// `o`, `r` and `x` lines) end what is read.
struct LayFile {
  LayeredTheory theory;            ///< Atoms without a name are called by their number in the file.
  std::vector<Query> queries;      ///< Over the atoms of the lowest layer.
  logic::Diagnostics diagnostics;  ///< Where there are any, the rest must not be used.
};

/// Reads any bytes; all errors are reported, `max_diagnostics` at most.
LayFile ReadLay(std::string_view text, std::string_view name, std::size_t max_diagnostics = 100);

/// As text that ReadLay reads.
std::string WriteLay(const LayeredTheory& theory, std::span<const Query> queries);

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_FORMATS_LAY_FILE_H_
