// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_COMPILER_H_
#define LATCHWORK_PTTP_COMPILER_H_

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "latchwork/logic/clause.h"
#include "reasoners/pttp/terms/functors.h"
#include "reasoners/pttp/theory/predicates.h"
#include "reasoners/pttp/theory/program.h"

namespace latchwork::pttp {

/// Turns clauses into contrapositives (Stickel 1988). Ground positive units are left to the fact
/// store. An interpreted function in a head becomes an equation of the body, since heads are
/// matched and not computed.
class Compiler {
 public:
  Compiler(Predicates& predicates, Functors& functors, logic::Symbol equality)
      : predicates_(&predicates), functors_(&functors), equality_(equality) {}

  std::unique_ptr<Program> Compile(std::vector<logic::Clause> clauses);
  /// A start clause for a conjunction of literals, its terms in `arena`. `target` is reused.
  void CompileQuery(std::span<const logic::Literal> query, std::size_t variables, Arena& arena,
                    Contrapositive& target);
  /// Whether this clause belongs to the fact store.
  bool IsFact(const logic::Clause& clause) const;

 private:
  void AddClause(Program& program, std::uint32_t index);
  Contrapositive MakeContrapositive(Program& program, std::uint32_t index, std::size_t head);
  CompiledLiteral MakeLiteral(const logic::Literal& literal, bool complement, Arena& arena);
  bool ContainsArithmetic(Word word) const;
  void FlattenHead(Contrapositive& rule, Arena& arena);
  void Finish(Contrapositive& rule) const;

  Predicates* predicates_;
  Functors* functors_;
  logic::Symbol equality_;
  mutable std::vector<Word> visits_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_COMPILER_H_
