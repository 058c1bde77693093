// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TSTP_PRINTER_H_
#define LATCHWORK_PTTP_TSTP_PRINTER_H_

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/clause_origins.h"
#include "latchwork/logic/formula.h"
#include "latchwork/logic/symbol.h"
#include "reasoners/pttp/proofs/formula_pairs.h"
#include "reasoners/pttp/proofs/naming_stages.h"

namespace latchwork::pttp {

/// What a derivation starts from. Everything outlives the printer.
struct ProofSources {
  const std::vector<logic::AnnotatedFormula>& formulas;
  const logic::ClauseOrigins& origins;  ///< Of the clauses that were made from the formulas.
  std::string_view file;
  /// Of each formula its text in the file, where that is to be kept; may be empty.
  std::span<const std::string> texts = {};
};

/// Writes a TSTP derivation line by line, each formula after those that it follows from. A clause
/// brings what stands above it along: the formula of the file, the negated conjecture, definitions,
/// the Skolemized normal form. Steps have names of their own, different from all names of the file.
class TstpPrinter {
 public:
  explicit TstpPrinter(const ProofSources& sources);

  /// A clause of the theory, whatever was done to it since clausification. Gives its name.
  std::string Input(const logic::Clause& clause);
  /// A clause that follows from the steps that are named. `stem` begins its name.
  std::string Derived(std::string_view stem, std::string_view clause, std::string_view rule,
                      std::span<const std::string> parents);
  /// A clause that is true in every model of a built-in theory; of equality alone: a tautology.
  std::string Tautology(std::string_view clause);
  std::string TheoryFact(std::string_view clause, std::string_view theory);

  /// Whether the negated conjecture is among the lines.
  bool uses_conjecture() const { return !negated_.empty(); }
  std::vector<std::string> Take() { return std::move(lines_); }

 private:
  using Symbols = std::set<logic::Symbol>;
  using Names = std::vector<std::string>;

  std::string NewName(std::string_view stem);
  std::string Line(std::string_view language, std::string_view stem, std::string_view role,
                   std::string_view formula, std::string_view source);
  /// As it is written in the file, on one line, where that is known. Clauses are not closed.
  std::string TextOf(std::size_t index) const;
  std::string ClosedText(std::size_t index) const;
  std::string Leaf(std::size_t index);
  std::string Conjectures();
  std::string NegatedConjecture(std::size_t index);
  std::string Definition(std::size_t index);
  std::string NormalForm(std::size_t index);
  /// Notes whether the form is to be shown in steps; it and its names then keep the names that
  /// variables have in the file, as parts that read alike are easier to recognise.
  void FindDeepForm(std::size_t index);
  std::string DeepForm(std::size_t index);
  std::pair<logic::Atom, std::string> NamePart(const logic::Formula& part, const Names& names);
  BodyOf Bodies() const;
  /// Parents of a normal form besides the formula. Where it has many names and it can be done,
  /// steps before it bring in a few of them at a time; the last one then replaces the formula.
  void AddNames(const logic::ClauseOrigins::NormalForm& form, std::vector<std::string>& parents);
  void AddDefinitionsOf(const Symbols& predicates, std::vector<std::string>& parents);
  std::optional<NamingStages> StagesOf(const logic::ClauseOrigins::NormalForm& form) const;
  std::string Skolemized(std::size_t index);
  std::string FormulaParent(std::size_t index);
  /// Of the names among the predicates and, in turn, in their definitions.
  std::set<std::size_t> DefinitionsOf(const Symbols& predicates) const;
  /// What a clause of a normal form follows from: the formula itself where no Skolem function is
  /// between them and that saves definitions.
  std::vector<std::string> ParentsOf(const logic::Clause& clause, std::size_t index);
  std::size_t FormulaOf(const logic::Clause& clause) const;

  ProofSources sources_;
  std::set<std::string, std::less<>> names_;
  std::map<std::string, std::size_t, std::less<>> next_number_;  ///< By stem.
  std::vector<std::string> lines_;

  std::map<std::string, std::size_t, std::less<>> form_of_;  ///< By the text of a clause.
  std::map<logic::Symbol, std::size_t> definition_of_;
  std::map<std::size_t, std::string> leaves_;
  std::set<std::string, std::less<>> leaf_names_;  ///< Formulas of one file may share a name.
  std::map<std::size_t, std::string> negated_;
  std::map<std::size_t, std::string> definitions_;
  std::map<std::size_t, std::string> normal_forms_;
  std::map<std::size_t, std::string> skolemized_;
  std::map<std::size_t, std::vector<FormulaPair>> deep_forms_;
  std::map<std::size_t, const Names*> kept_names_;  ///< By the index of the definition.
  logic::SymbolTable part_symbols_;                 ///< Of names that parts of deep forms have.
  std::map<std::string, std::string, std::less<>> inputs_;  ///< By the text of a clause.
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TSTP_PRINTER_H_
