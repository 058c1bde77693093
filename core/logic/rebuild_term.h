// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_REBUILD_TERM_H_
#define LATCHWORK_LOGIC_REBUILD_TERM_H_

#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "latchwork/logic/term.h"

namespace latchwork::logic {

/// Builds a term anew from its leaves, without recursion. `replace(const Term&)` gives what stands
/// for a term as a whole, or nothing when its arguments are to be rebuilt first (asked of compound
/// terms only in that case; of all others an answer is needed). `join(Symbol, std::vector<Term>)`
/// makes a compound term of rebuilt arguments; nothing from it ends the work with nothing.
template <typename Replace, typename Join>
std::optional<Term> RebuildTerm(const Term& term, const Replace& replace, const Join& join) {
  struct Frame {
    const Term* term;
    std::size_t next;
  };
  std::vector<Frame> open;
  std::vector<Term> values;
  const auto begin = [&](const Term& next) {
    if (std::optional<Term> whole = replace(next)) {
      values.push_back(*std::move(whole));
    } else {
      open.push_back({&next, 0});
    }
  };
  begin(term);
  while (!open.empty()) {
    Frame& frame = open.back();
    const auto arguments = frame.term->arguments();
    if (frame.next < arguments.size()) {
      begin(arguments[frame.next++]);
      continue;
    }
    const auto first = values.end() - static_cast<std::ptrdiff_t>(arguments.size());
    std::vector<Term> rebuilt(std::make_move_iterator(first),
                              std::make_move_iterator(values.end()));
    values.erase(first, values.end());
    std::optional<Term> joined = join(frame.term->symbol(), std::move(rebuilt));
    if (!joined) return std::nullopt;
    values.push_back(*std::move(joined));
    open.pop_back();
  }
  return std::move(values.back());
}

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_REBUILD_TERM_H_
