// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/formats/lay_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace latchwork::circumscription {
namespace {

constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

class LayReader final : public StatementReader {
 public:
  LayReader(std::string_view text, std::string_view name, std::size_t max_diagnostics)
      : StatementReader(text, name, max_diagnostics) {}

  LayFile Read() {
    ReadLines();
    for (const Placed& placed : placed_) CheckLayer(placed);
    if (has_header_ && diagnostics_.empty()) CheckRoles();
    if (diagnostics_.empty()) Renumber();
    return {std::move(file_.theory), std::move(file_.queries), std::move(diagnostics_)};
  }

 private:
  /// A line whose atoms must be of one layer: what it says is checked when all roles are known.
  struct Placed {
    std::size_t layer = 0;
    std::uint32_t number = 0;
    std::string_view line;
    std::size_t first = 0;  ///< The word of the first literal.
    std::size_t last = 0;   ///< And the one behind the last.
  };

  bool IsAnswer(std::string_view key) const override {
    return key == "=" || key == "s" || key == "o" || key == "r" || key == "x";
  }
  std::string_view HeaderForm() const override { return "p lay LAYERS ATOMS"; }
  std::string_view StatementForms() const override {
    return "statements start with c, p, L, n, P, Z, Q, F, B, ?, =, s, o, r or x; clauses with a "
           "number";
  }
  void ReadHeader(const Words& words) override;
  bool ReadOther(const Words& words) override;
  void ReadLayer(const Words& words);
  void ReadBridge(const Words& words);
  void TakeRole(Atom atom) override {
    if (IsInLayer()) owners_[static_cast<std::size_t>(atom) - 1] = layer_;
  }
  void TakeClause(Clause clause) override {
    if (!IsInLayer()) return;
    Place(layer_, 0);
    file_.theory.layers[layer_].theory.clauses.push_back(std::move(clause));
  }
  void TakeFacts(std::vector<Literal> facts) override {
    if (!IsInLayer()) return;
    Place(layer_, 1);
    std::vector<Literal>& all = file_.theory.layers[layer_].facts;
    all.insert(all.end(), facts.begin(), facts.end());
  }
  void TakeQuery(Query query, const Words& words) override {
    if (query.brave) {
      return Error(words[2].column, "a layered theory is asked cautiously",
                   "c: every model of the layered theory satisfies the disjunction");
    }
    Place(0, 3);
    file_.queries.push_back(std::move(query));
  }

  bool IsInLayer() {
    if (layer_ == kNowhere) {
      Error(1, "this belongs to no layer", "a line 'L LAYER' comes before what the layer holds");
    }
    return layer_ != kNowhere;
  }
  void Place(std::size_t layer, std::size_t first) {
    placed_.push_back({layer, line_number(), line(), first, kNowhere});
  }
  void CheckLayer(const Placed& placed);
  void Renumber();
  Literal Local(Literal literal) const {
    const Atom local = locals_[static_cast<std::size_t>(AtomOf(literal)) - 1];
    return literal > 0 ? local : -local;
  }
  void Localize(std::vector<Literal>& literals) const {
    for (Literal& literal : literals) literal = Local(literal);
  }

  LayFile file_;
  std::size_t layer_ = kNowhere;
  std::vector<std::size_t> owners_;  ///< Per atom, its layer.
  std::vector<Atom> locals_;         ///< Per atom, its number there.
  std::vector<Placed> placed_;
};

void LayReader::ReadHeader(const Words& words) {
  const auto numbers = HeaderNumbers(words, "lay", 2);
  if (!numbers) return;
  const auto layers = static_cast<std::size_t>((*numbers)[0]);
  if (layers == 0 || layers > text().size()) {
    End();
    return Error(words[2].column, layers == 0 ? "there is no layer"
                                              : fmt::format("there cannot be {} layers: each has "
                                                            "an L line in this file",
                                                            layers));
  }
  if (!SetAtoms(words[3], (*numbers)[1])) return;
  file_.theory.layers.resize(layers);
  owners_.assign(theory_.atoms.size(), kNowhere);
}

bool LayReader::ReadOther(const Words& words) {
  if (words[0].text == "L") {
    ReadLayer(words);
  } else if (words[0].text == "B") {
    ReadBridge(words);
  } else {
    return false;
  }
  return true;
}

void LayReader::ReadLayer(const Words& words) {
  if (words.size() < 2 || words.size() > 3) {
    return Error(words[0].column, "not of the form: L LAYER [NAME]");
  }
  const std::optional<int> number = ToInteger(words[1].text);
  const std::size_t layers = file_.theory.layers.size();
  if (!number || *number < 1 || static_cast<std::size_t>(*number) > layers) {
    return Error(words[1].column, fmt::format("there is no layer {}", words[1].text),
                 fmt::format("the header announces the layers 1 to {}; 1 is the lowest", layers));
  }
  layer_ = static_cast<std::size_t>(*number) - 1;
  if (words.size() == 3) file_.theory.layers[layer_].name = words[2].text;
}

void LayReader::ReadBridge(const Words& words) {
  if (!IsInLayer()) return;
  if (words.size() != 3) return Error(words[0].column, "not of the form: B GOAL LATCH");
  if (layer_ + 1 == file_.theory.layers.size()) {
    return Error(words[0].column, "there is no layer above the highest",
                 "a bridge stands in the layer that it leads to");
  }
  const std::optional<Literal> goal = ToLiteral(words[1]);
  const std::optional<Literal> latch = ToLiteral(words[2]);
  if (!goal || !latch) return;
  if (*goal < 0 || *latch < 0) {
    return Error(words[*goal < 0 ? 1 : 2].column, "only atoms are handed down, not negations");
  }
  placed_.push_back({layer_ + 1, line_number(), line(), 1, 2});
  placed_.push_back({layer_, line_number(), line(), 2, 3});
  file_.theory.layers[layer_].bridges.push_back({*goal, *latch});
}

void LayReader::CheckLayer(const Placed& placed) {
  const Words words = SplitWords(placed.line);
  // Lists end with 0.
  const std::size_t last = placed.last == kNowhere ? words.size() - 1 : placed.last;
  for (std::size_t i = placed.first; i < last; ++i) {
    const std::optional<int> literal = ToInteger(words[i].text);
    const auto atoms = static_cast<int>(owners_.size());
    if (!literal || *literal == 0 || *literal < -atoms || *literal > atoms) continue;
    const Atom atom = AtomOf(*literal);
    const std::size_t owner = owners_[static_cast<std::size_t>(atom) - 1];
    if (owner == placed.layer || owner == kNowhere) continue;
    ErrorAt(
        placed.number, placed.line, words[i].column,
        fmt::format("atom {} is of layer {}, not of layer {}", atom, owner + 1, placed.layer + 1),
        "what a layer says reaches another by bridges only; queries are about layer 1");
  }
}

void LayReader::Renumber() {
  for (std::size_t i = 0; i < owners_.size(); ++i) {
    AtomInfo info = theory_.atoms[i];
    if (info.name.empty()) info.name = std::to_string(i + 1);
    locals_.push_back(file_.theory.layers[owners_[i]].theory.Add(std::move(info)));
  }
  for (TheoryLayer& layer : file_.theory.layers) {
    for (Clause& clause : layer.theory.clauses) Localize(clause);
    Localize(layer.facts);
    for (Bridge& bridge : layer.bridges) bridge = {Local(bridge.goal), Local(bridge.latch)};
  }
  for (Query& query : file_.queries) Localize(query.literals);
}

/// As one word.
std::string WithoutBlanks(std::string text) {
  text.erase(
      std::remove_if(
          text.begin(), text.end(),
          [](char c) { return std::string_view(" \t\r\n\v\f").find(c) != std::string_view::npos; }),
      text.end());
  return text;
}

/// Puts a layered theory into text; atoms are numbered layer by layer.
class LayWriter {
 public:
  explicit LayWriter(const LayeredTheory& theory) : theory_(theory) {
    for (const TheoryLayer& layer : theory.layers) {
      first_.push_back(atoms_);
      atoms_ += static_cast<Atom>(layer.theory.atoms.size());
    }
  }

  std::string Write(std::span<const Query> queries) {
    text_ = fmt::format("p lay {} {}\n", theory_.layers.size(), atoms_);
    for (std::size_t i = 0; i < theory_.layers.size(); ++i) WriteLayer(i);
    for (const Query& query : queries) {
      text_ += fmt::format("? {} c ", WithoutBlanks(query.id));
      WriteList(0, query.literals);
    }
    return std::move(text_);
  }

 private:
  void WriteLayer(std::size_t index) {
    const TheoryLayer& layer = theory_.layers[index];
    text_ += fmt::format("L {}{}{}\n", index + 1, layer.name.empty() ? "" : " ",
                         WithoutBlanks(layer.name));
    const auto atoms = static_cast<Atom>(layer.theory.atoms.size());
    for (Atom atom = 1; atom <= atoms; ++atom) {
      const AtomInfo& info = layer.theory.at(atom);
      const std::string number = std::to_string(first_[index] + atom);
      if (!info.name.empty() && info.name != number) {
        text_ += fmt::format("n {} {}\n", number, WithoutBlanks(info.name));
      }
      if (info.role == Role::kMinimized) text_ += fmt::format("P {} {} 0\n", info.level, number);
      if (info.role == Role::kVarying) text_ += fmt::format("Z {} 0\n", number);
      if (info.role == Role::kFixed) text_ += fmt::format("Q {} 0\n", number);
    }
    for (const Clause& clause : layer.theory.clauses) WriteList(index, clause);
    if (!layer.facts.empty()) {
      text_ += "F ";
      WriteList(index, layer.facts);
    }
    for (const Bridge& bridge : layer.bridges) {
      text_ +=
          fmt::format("B {} {}\n", first_[index + 1] + bridge.goal, first_[index] + bridge.latch);
    }
  }

  void WriteList(std::size_t layer, std::span<const Literal> literals) {
    for (const Literal literal : literals) {
      text_ += std::to_string(literal > 0 ? literal + first_[layer] : literal - first_[layer]);
      text_ += ' ';
    }
    text_ += "0\n";
  }

  const LayeredTheory& theory_;
  std::vector<Atom> first_;  ///< What an atom 0 of the layer would be.
  Atom atoms_ = 0;
  std::string text_;
};

}  // namespace

LayFile ReadLay(std::string_view text, std::string_view name, std::size_t max_diagnostics) {
  return LayReader(text, name, max_diagnostics).Read();
}

std::string WriteLay(const LayeredTheory& theory, std::span<const Query> queries) {
  return LayWriter(theory).Write(queries);
}

}  // namespace latchwork::circumscription
