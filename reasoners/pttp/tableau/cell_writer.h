// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_CELL_WRITER_H_
#define LATCHWORK_PTTP_TABLEAU_CELL_WRITER_H_

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "latchwork/logic/term.h"
#include "reasoners/pttp/tableau/matrix_terms.h"

namespace latchwork::pttp {

/// Writes terms into cells and numbers their functors; only needed while a matrix is made.
class CellWriter {
 public:
  CellWriter(std::vector<Cell>& cells, std::vector<logic::Term>& functors)
      : cells_(cells), functors_(functors) {}

  Cell Write(const logic::Term& term);

 private:
  struct Pending {
    const logic::Term* term;
    std::vector<Cell> block;  ///< Functor and arguments.
  };

  Pending Begin(const logic::Term& term);
  Cell WriteBlock(std::vector<Cell> block);

  std::vector<Cell>& cells_;
  std::vector<logic::Term>& functors_;
  std::map<std::pair<logic::Term, std::uint32_t>, std::uint32_t> numbers_;
  std::map<std::vector<Cell>, Cell> ground_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_CELL_WRITER_H_
