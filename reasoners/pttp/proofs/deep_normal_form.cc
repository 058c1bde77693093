// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/proofs/deep_normal_form.h"

#include <optional>
#include <utility>

namespace latchwork::pttp {
namespace {

using logic::Formula;

/// Of formulas that are shown in steps.
constexpr std::size_t kLeastDepth = 5;
constexpr std::size_t kLeastSize = 60;
/// Of parts that have a lemma, and of conjunctions that have a name.
constexpr std::size_t kLeastLemma = 10;
constexpr std::size_t kLeastConjunction = 40;

}  // namespace

bool DeepNormalForm::IsDeep(const std::vector<FormulaPair>& pairs) {
  return pairs.back().depth >= kLeastDepth && pairs.back().size >= kLeastSize;
}

std::string DeepNormalForm::Write(const std::string& formula) {
  const FormulaPair& whole = pairs_.back();
  std::vector<std::size_t> found;
  FindConjunctions(pairs_.size() - 1, found);
  if (found.empty()) {
    return lines_.normalize(*whole.normal, {formula, Lemma(pairs_.size() - 1)});
  }
  Replacements said;
  Replacements normal;
  std::string line = formula;
  std::vector<std::string> unfolded;
  for (const std::size_t index : found) {
    const FormulaPair& pair = pairs_[index];
    const auto [name, definition] = lines_.define(Said(pair));
    const Formula atom = Formula::Of(name);
    said.insert_or_assign(pair.said, pair.positive ? atom : Formula::Not(atom));
    normal.insert_or_assign(pair.normal, atom);
    const Formula folded = Replaced(*whole.said, said);
    line = lines_.normalize(whole.positive ? folded : Formula::Not(folded), {line, definition});
    unfolded.push_back(Unfold(pair, name, definition));
  }
  const Formula folded = Replaced(*whole.said, said);
  const Formula folded_normal = Replaced(*whole.normal, normal);
  const auto pairs = PairFormulas(folded, whole.positive, folded_normal, body_of_);
  if (!pairs) return {};
  std::vector<std::string> parents{DeepNormalForm(*pairs, body_of_, lines_).Write(line)};
  parents.insert(parents.end(), unfolded.begin(), unfolded.end());
  return lines_.normalize(*whole.normal, parents);
}

std::string DeepNormalForm::Lemma(std::size_t index) {
  std::string& line = lemmas_[index];
  if (!line.empty()) return line;
  const FormulaPair& pair = pairs_[index];
  std::vector<std::string> parents = Lemmas(pair.parts);
  if (pair.is_name) parents.push_back(lines_.definition(pair.normal->atom()));
  line = lines_.normalize(Closed(Formula::Implies(Said(pair), *pair.normal)), parents);
  return line;
}

std::vector<std::string> DeepNormalForm::Lemmas(const std::vector<std::size_t>& parts) {
  std::vector<std::string> lines;
  for (const std::size_t part : parts) {
    if (pairs_[part].size >= kLeastLemma) lines.push_back(Lemma(part));
  }
  return lines;
}

void DeepNormalForm::FindConjunctions(std::size_t index, std::vector<std::size_t>& found) const {
  const FormulaPair& pair = pairs_[index];
  const bool is_inner = pair.depth < pairs_.back().depth && !pair.is_name;
  if (is_inner && pair.normal->kind() == Formula::Kind::kAnd && pair.size >= kLeastConjunction) {
    found.push_back(index);
    return;
  }
  if (pair.is_name) return;
  for (const std::size_t part : pair.parts) FindConjunctions(part, found);
}

std::string DeepNormalForm::Unfold(const FormulaPair& pair, const logic::Atom& name,
                                   const std::string& definition) {
  const Formula denied = Formula::Not(Formula::Of(name));
  std::vector<std::string> conjuncts;
  for (const std::size_t index : pair.parts) {
    const FormulaPair& part = pairs_[index];
    std::string line = lines_.normalize(Closed(Formula::Or({denied, Said(part)})), {definition});
    conjuncts.push_back(part.size >= kLeastLemma ? UnfoldPart(index, denied, line) : line);
  }
  return lines_.normalize(Closed(Formula::Or({denied, *pair.normal})), conjuncts);
}

std::string DeepNormalForm::UnfoldPart(std::size_t index, const Formula& denied,
                                       const std::string& line) {
  const FormulaPair& part = pairs_[index];
  const Formula said = Closed(Formula::Or({denied, Said(part)}));
  const Formula normal = Closed(Formula::Or({denied, *part.normal}));
  const auto pairs = PairFormulas(said, true, normal, body_of_);
  if (pairs) {
    DeepNormalForm inner(*pairs, body_of_, lines_);
    std::vector<std::size_t> found;
    inner.FindConjunctions(pairs->size() - 1, found);
    if (!found.empty()) return inner.Write(line);
  }
  return lines_.normalize(normal, {line, Lemma(index)});
}

}  // namespace latchwork::pttp
