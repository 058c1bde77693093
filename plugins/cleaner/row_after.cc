// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/cleaner/row_after.h"

#include <algorithm>
#include <array>
#include <utility>

namespace latchwork::cleaner {

using logic::Term;

RowAfter::RowAfter(logic::SymbolTable& symbols)
    : dirty_(symbols.Intern("dirty")),
      clean_(symbols.Intern("clean")),
      runs_(symbols.Intern("runs")),
      none_(symbols.Intern("none")) {
  const std::initializer_list<Term> two{Term::Var(0), Term::Var(1)};
  clean_query_ = {{true, {symbols.Intern("clean_row"), two}}};
  dirty_query_ = {{true, {symbols.Intern("dirty_row"), two}}};
  tile_query_ = {{true, {symbols.Intern("tile"), {Term::Var(0), Term::Var(1), Term::Var(2)}}}};
}

const sdk::Attachment::Signature& RowAfter::signature() const {
  using sdk::ArgumentType;
  static const Signature signature{"row_after",
                                   {{{"j", ArgumentType::kInteger, ""}, Mode::kIn},
                                    {{"clean", ArgumentType::kAny, ""}, Mode::kOut},
                                    {{"dirty", ArgumentType::kAny, ""}, Mode::kOut}},
                                   "a row of the floor after the present picture"};
  return signature;
}

void RowAfter::Call(std::span<const Term> inputs, sdk::AttachmentContext& context,
                    sdk::AnswerSink& outputs) {
  tiles_.clear();
  Recall(context, clean_query_, inputs[0], Memory::kClean);
  Recall(context, dirty_query_, inputs[0], Memory::kDirty);
  Look(context, inputs[0]);
  const std::array<Term, 2> answer{RunsOf(Memory::kClean), RunsOf(Memory::kDirty)};
  outputs.Answer(answer);
}

void RowAfter::Recall(sdk::AttachmentContext& context, std::span<const logic::Literal> query,
                      const Term& row, Memory memory) {
  answers_.clear();
  Collect(context, query, 2, answers_);
  for (std::size_t n = 0; n < answers_.size(); n += 2) {
    if (answers_[n] != row) continue;
    ForRuns(answers_[n + 1], [&](int first, int last) {
      const auto end = static_cast<std::size_t>(last) + 1;
      if (tiles_.size() < end) tiles_.resize(end, Memory::kUnknown);
      std::fill(tiles_.begin() + first, tiles_.begin() + last + 1, memory);
    });
  }
}

void RowAfter::Look(sdk::AttachmentContext& context, const Term& row) {
  answers_.clear();
  Collect(context, tile_query_, 3, answers_);
  for (std::size_t n = 0; n < answers_.size(); n += 3) {
    const auto tile = TileOf(answers_[n], answers_[n + 1]);
    if (!tile || answers_[n + 1] != row) continue;
    if (answers_[n + 2].kind() != Term::Kind::kConstant) continue;
    const auto at = static_cast<std::size_t>(tile->i);
    if (tiles_.size() <= at) tiles_.resize(at + 1, Memory::kUnknown);
    const logic::Symbol state = answers_[n + 2].symbol();
    tiles_[at] = Memory::kUnknown;
    if (state == dirty_) tiles_[at] = Memory::kDirty;
    if (state == clean_) tiles_[at] = Memory::kClean;
  }
}

Term RowAfter::RunsOf(Memory memory) const {
  std::vector<Term> ends;
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    if (tiles_[i] != memory) continue;
    ends.push_back(Term::Integer(static_cast<std::int64_t>(i)));
    while (i + 1 < tiles_.size() && tiles_[i + 1] == memory) ++i;
    ends.push_back(Term::Integer(static_cast<std::int64_t>(i)));
  }
  if (ends.empty()) return Term::Constant(none_);
  return Term::Compound(runs_, std::move(ends));
}

}  // namespace latchwork::cleaner
