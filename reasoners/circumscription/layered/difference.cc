// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/layered/difference.h"

#include <algorithm>
#include <utility>

namespace latchwork::circumscription {
namespace {

/// The parts of an example that can be left out, one after the other in a fixed order.
template <typename Visit>
void ForEachPart(CounterExample& example, const Visit& visit) {
  for (std::size_t i = example.theory.layers.size(); i-- > 0;) {
    TheoryLayer& layer = example.theory.layers[i];
    visit(layer.bridges);
    visit(layer.theory.clauses);
    visit(layer.facts);
  }
  visit(example.clause);
}

std::size_t CountParts(CounterExample& example) {
  std::size_t count = 0;
  ForEachPart(example, [&](const auto& parts) { count += parts.size(); });
  return count;
}

/// Without the parts from `begin` on, up to `end`.
CounterExample Without(CounterExample example, std::size_t begin, std::size_t end) {
  std::size_t at = 0;
  ForEachPart(example, [&](auto& parts) {
    const std::size_t size = parts.size();
    const std::size_t first = std::clamp(begin, at, at + size) - at;
    const std::size_t last = std::clamp(end, at, at + size) - at;
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(first),
                parts.begin() + static_cast<std::ptrdiff_t>(last));
    at += size;
  });
  return example;
}

class Shrinker {
 public:
  Shrinker(Transfer transfer, Fault fault, const ProcedureOptions& options)
      : transfer_(transfer), fault_(fault), options_(options) {}

  bool Errs(const CounterExample& example) const {
    Procedure procedure(example.theory, transfer_, options_);
    LayeredModels models(example.theory, options_.engine);
    return Compare(procedure.Entails(example.clause).verdict,
                   models.Entails(example.clause).verdict) == fault_;
  }

  /// Leaves out all runs of `size` parts that can be; whether there was one.
  bool DropRuns(CounterExample& example, std::size_t size) const {
    bool dropped = false;
    for (std::size_t begin = 0; begin < CountParts(example);) {
      CounterExample smaller = Without(example, begin, begin + size);
      if (Errs(smaller)) {
        example = std::move(smaller);
        dropped = true;
      } else {
        begin += size;
      }
    }
    return dropped;
  }

 private:
  Transfer transfer_;
  Fault fault_;
  const ProcedureOptions& options_;
};

std::vector<bool> UsedAtoms(const CounterExample& example, std::size_t index) {
  const std::vector<TheoryLayer>& layers = example.theory.layers;
  std::vector<bool> used(layers[index].theory.atoms.size() + 1, false);
  const auto use = [&](Literal literal) { used[static_cast<std::size_t>(AtomOf(literal))] = true; };
  for (const Clause& clause : layers[index].theory.clauses) {
    std::for_each(clause.begin(), clause.end(), use);
  }
  std::for_each(layers[index].facts.begin(), layers[index].facts.end(), use);
  for (const Bridge& bridge : layers[index].bridges) use(bridge.latch);
  if (index > 0) {
    for (const Bridge& bridge : layers[index - 1].bridges) use(bridge.goal);
  } else {
    std::for_each(example.clause.begin(), example.clause.end(), use);
  }
  return used;
}

void DropAtoms(CounterExample& example, std::size_t index) {
  TheoryLayer& layer = example.theory.layers[index];
  const std::vector<bool> used = UsedAtoms(example, index);
  std::vector<Atom> renumbered(used.size(), 0);
  std::vector<AtomInfo> atoms;
  for (std::size_t i = 1; i < used.size(); ++i) {
    if (!used[i]) continue;
    atoms.push_back(std::move(layer.theory.atoms[i - 1]));
    renumbered[i] = static_cast<Atom>(atoms.size());
  }
  layer.theory.atoms = std::move(atoms);
  const auto renumber = [&](Literal& literal) {
    const Atom atom = renumbered[static_cast<std::size_t>(AtomOf(literal))];
    literal = literal > 0 ? atom : -atom;
  };
  for (Clause& clause : layer.theory.clauses) {
    std::for_each(clause.begin(), clause.end(), renumber);
  }
  std::for_each(layer.facts.begin(), layer.facts.end(), renumber);
  for (Bridge& bridge : layer.bridges) renumber(bridge.latch);
  if (index > 0) {
    for (Bridge& bridge : example.theory.layers[index - 1].bridges) renumber(bridge.goal);
  } else {
    std::for_each(example.clause.begin(), example.clause.end(), renumber);
  }
}

/// Layers from which nothing leads down say nothing, unless they have no model.
void DropLayers(CounterExample& example, const Shrinker& shrinker) {
  std::vector<TheoryLayer>& layers = example.theory.layers;
  while (layers.size() > 1 && layers[layers.size() - 2].bridges.empty()) {
    CounterExample smaller = example;
    smaller.theory.layers.pop_back();
    if (!shrinker.Errs(smaller)) return;
    example = std::move(smaller);
  }
}

}  // namespace

std::string_view Name(Fault fault) { return fault == Fault::kUnsound ? "unsound" : "incomplete"; }

std::optional<Fault> Compare(Verdict procedure, Verdict definition) {
  if (procedure == Verdict::kYes && definition == Verdict::kNo) return Fault::kUnsound;
  if (procedure == Verdict::kNo && definition == Verdict::kYes) return Fault::kIncomplete;
  return std::nullopt;
}

CounterExample Shrink(CounterExample example, Transfer transfer, Fault fault,
                      const ProcedureOptions& options) {
  const Shrinker shrinker(transfer, fault, options);
  for (std::size_t size = CountParts(example) / 2; size > 1; size /= 2) {
    shrinker.DropRuns(example, size);
  }
  while (shrinker.DropRuns(example, 1)) {
  }
  DropLayers(example, shrinker);
  for (std::size_t i = 0; i < example.theory.layers.size(); ++i) DropAtoms(example, i);
  return example;
}

}  // namespace latchwork::circumscription
