// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_CHECK_PROOF_SOURCE_TERM_H_
#define LATCHWORK_APPS_CHECK_PROOF_SOURCE_TERM_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace latchwork::check_proof {

/// A general term of TPTP, in which sources are written: `inference(r, [status(thm)], [a, b])`. A
/// list has the name `[]`; quotes are taken off names. `a:b` is `a`: what follows is a comment on
/// it.
struct SourceTerm {
  std::string name;
  std::vector<SourceTerm> arguments;

  bool is_list() const { return name == "[]"; }
  /// The argument of that index if it is a list, else nothing.
  const SourceTerm* List(std::size_t index) const;
};

/// The first of the terms in the text, which commas separate; nothing when there is none, or when
/// it is nested too deeply to be meant.
std::optional<SourceTerm> ReadSource(std::string_view text);

}  // namespace latchwork::check_proof

#endif  // LATCHWORK_APPS_CHECK_PROOF_SOURCE_TERM_H_
