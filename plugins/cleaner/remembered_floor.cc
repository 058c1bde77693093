// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/cleaner/remembered_floor.h"

#include <algorithm>
#include <string_view>

namespace latchwork::cleaner {

namespace {

using logic::Term;

class TermSink final : public sdk::AnswerSink {
 public:
  explicit TermSink(std::vector<Term>& terms) : terms_(&terms) {}
  void Answer(std::span<const Term> answer) override {
    terms_->insert(terms_->end(), answer.begin(), answer.end());
  }

 private:
  std::vector<Term>* terms_;
};

std::vector<logic::Literal> Query(logic::SymbolTable& symbols, std::string_view predicate) {
  return {{true, {symbols.Intern(predicate), {Term::Var(0), Term::Var(1)}}}};
}

}  // namespace

void Collect(sdk::AttachmentContext& context, std::span<const logic::Literal> query,
             std::size_t variables, std::vector<Term>& answers) {
  TermSink sink(answers);
  context.ForEachProvable(query, variables, sink);
}

std::optional<Tile> TileOf(const Term& i, const Term& j) {
  if (i.kind() != Term::Kind::kInteger || j.kind() != Term::Kind::kInteger) return std::nullopt;
  if (i.integer() < 0 || i.integer() >= kMostTiles) return std::nullopt;
  if (j.integer() < 0 || j.integer() >= kMostTiles) return std::nullopt;
  return Tile{static_cast<int>(i.integer()), static_cast<int>(j.integer())};
}

RememberedFloor::RememberedFloor(logic::SymbolTable& symbols)
    : clean_query_(Query(symbols, "clean_row")),
      dirty_query_(Query(symbols, "dirty_row")),
      tried_query_(Query(symbols, "tried")) {}

void RememberedFloor::Recall(sdk::AttachmentContext& context) {
  clean_.clear();
  dirty_.clear();
  Collect(context, clean_query_, 2, clean_);
  Collect(context, dirty_query_, 2, dirty_);
  Resize();
  Fill(clean_, Memory::kClean);
  Fill(dirty_, Memory::kDirty);
  std::vector<Term>& tried = clean_;
  tried.clear();
  Collect(context, tried_query_, 2, tried);
  tried_.clear();
  for (std::size_t n = 0; n < tried.size(); n += 2) {
    if (const auto tile = TileOf(tried[n], tried[n + 1])) tried_.push_back(*tile);
  }
}

void RememberedFloor::Resize() {
  width_ = height_ = 0;
  for (const auto* rows : {&clean_, &dirty_}) {
    for (std::size_t n = 0; n < rows->size(); n += 2) {
      const auto row = TileOf(Term::Integer(0), (*rows)[n]);
      if (!row) continue;
      height_ = std::max(height_, row->j + 1);
      ForRuns((*rows)[n + 1], [&](int, int last) { width_ = std::max(width_, last + 1); });
    }
  }
  tiles_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
                Memory::kUnknown);
}

void RememberedFloor::Fill(std::span<const Term> rows, Memory memory) {
  for (std::size_t n = 0; n < rows.size(); n += 2) {
    const auto row = TileOf(Term::Integer(0), rows[n]);
    if (!row) continue;
    ForRuns(rows[n + 1], [&](int first, int last) {
      for (int i = first; i <= last; ++i) tiles_[IndexOf({i, row->j})] = memory;
    });
  }
}

Memory RememberedFloor::At(Tile tile) const {
  if (tile.i < 0 || tile.j < 0 || tile.i >= width_ || tile.j >= height_) return Memory::kUnknown;
  return tiles_[IndexOf(tile)];
}

bool RememberedFloor::WasTried(Tile tile) const {
  return std::find(tried_.begin(), tried_.end(), tile) != tried_.end();
}

bool RememberedFloor::IsOpen(Tile tile) const {
  for (int j = tile.j - 1; j <= tile.j + 1; ++j) {
    for (int i = tile.i - 1; i <= tile.i + 1; ++i) {
      if (At({i, j}) == Memory::kUnknown) return false;
    }
  }
  return true;
}

bool RememberedFloor::HasDirtAround(Tile tile) const {
  for (int j = tile.j - 1; j <= tile.j + 1; ++j) {
    for (int i = tile.i - 1; i <= tile.i + 1; ++i) {
      if (At({i, j}) == Memory::kDirty) return true;
    }
  }
  return false;
}

}  // namespace latchwork::cleaner
