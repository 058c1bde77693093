// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_DEEP_NORMAL_FORM_H_
#define LATCHWORK_PTTP_DEEP_NORMAL_FORM_H_

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reasoners/pttp/proofs/formula_pairs.h"

namespace latchwork::pttp {

/// Shows how a formula with many quantifiers within each other comes to its normal form, in steps
/// that a prover can follow: parts first, as lemmas `part => normal form of the part`, each with
/// those of its own parts for parents; a conjunction far inside gets a name, and what it says is
/// shown conjunct by conjunct.
class DeepNormalForm {
 public:
  /// How lines are written. Each gives the name of its line.
  struct Lines {
    std::function<std::string(const logic::Formula&, const std::vector<std::string>&)> normalize;
    /// A new name for a formula: the atom, and the line of its definition.
    std::function<std::pair<logic::Atom, std::string>(const logic::Formula&)> define;
    /// The line of a definition that the normal form uses.
    std::function<std::string(const logic::Atom&)> definition;
  };

  /// Whether the normal form, whose pair is the last one, is worth it.
  static bool IsDeep(const std::vector<FormulaPair>& pairs);

  DeepNormalForm(const std::vector<FormulaPair>& pairs, BodyOf body_of, const Lines& lines)
      : pairs_(pairs), body_of_(std::move(body_of)), lines_(lines) {}

  /// Writes the steps from a line with the formula to one with the normal form, whose name it
  /// gives.
  std::string Write(const std::string& formula);

 private:
  /// `part => its normal form`, after lemmas for its own parts.
  std::string Lemma(std::size_t index);
  /// Lemmas of the parts that are large enough.
  std::vector<std::string> Lemmas(const std::vector<std::size_t>& parts);
  /// Conjunctions below quantifiers that are worth a name, outermost ones.
  void FindConjunctions(std::size_t index, std::vector<std::size_t>& found) const;
  /// Gives the line `name => normal form of the conjunction`.
  std::string Unfold(const FormulaPair& pair, const logic::Atom& name,
                     const std::string& definition);
  /// The same of one conjunct, from the line `not the name, or the conjunct`.
  std::string UnfoldPart(std::size_t index, const logic::Formula& denied, const std::string& line);

  const std::vector<FormulaPair>& pairs_;
  BodyOf body_of_;
  const Lines& lines_;
  std::map<std::size_t, std::string> lemmas_;  ///< By the index of the pair.
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_DEEP_NORMAL_FORM_H_
