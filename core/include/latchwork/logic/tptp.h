// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_TPTP_H_
#define LATCHWORK_LOGIC_TPTP_H_

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/formula.h"
#include "latchwork/logic/symbol.h"

namespace latchwork::logic {

/// What a TPTP file says, or what is wrong with it. When `diagnostics` is not empty, `formulas`
/// must not be used.
struct TptpFile {
  std::vector<AnnotatedFormula>
      formulas;  ///< In the order of the file, includes expanded in place.
  /// With TptpOptions::keep_sources: of each formula what stands behind it, such as
  /// `file('a.p', n), [useful]`; may be empty.
  std::vector<std::string> sources;
  /// With TptpOptions::keep_texts: of each formula its own text in the file, with the spaces and
  /// comments in it; empty for tff, whose formulas may hold types.
  std::vector<std::string> texts;
  bool asks = false;  ///< A formula has the role `question`: a conjecture whose answers are wanted.
  Diagnostics diagnostics;
};

struct TptpOptions {
  /// Where `include('Axioms/X.ax')` is looked for after the folder of the including file (the TPTP
  /// environment variable, by custom). Empty: only beside the file.
  std::filesystem::path include_root;
  std::size_t max_bytes = 256U << 20U;  ///< Per file; a larger one is refused with a diagnostic.
  std::size_t max_tokens = 50'000'000;  ///< Per file; bounds the memory that formulas take.
  std::size_t max_diagnostics = 100;
  bool keep_sources = false;
  bool keep_texts = false;
};

/// Reads CNF, FOF and TFF of TPTP, with `include`. Types of TFF ($i, $int, $real) are checked,
/// those not declared inferred; conditions then keep apart what only types keep apart. Recovers at
/// the end of each annotated formula, so all errors of a file are reported at once. Recursive
/// inclusion is refused. Source: TPTP SyntaxBNF 9.
TptpFile ReadTptpFile(const std::filesystem::path& file, SymbolTable& symbols,
                      const TptpOptions& options = {});
/// The same for a text in memory; `name` is used in diagnostics, relative includes start at the
/// current folder.
TptpFile ReadTptp(std::string_view text, std::string_view name, SymbolTable& symbols,
                  const TptpOptions& options = {});

/// Reads one atom ("turn(A)", "~" not allowed), for XML attributes and command lines. The
/// diagnostic's place is relative to `text`.
struct TptpAtom {
  std::optional<Atom> atom;
  std::vector<std::string> variable_names;
  Diagnostics diagnostics;
};
TptpAtom ReadTptpAtom(std::string_view text, std::string_view name, SymbolTable& symbols);

/// The role as TPTP writes it.
std::string_view RoleName(Role role);
/// The name of a formula as TPTP writes it, in quotes where it needs them.
std::string QuoteName(std::string_view name);
/// Writes annotated formulas that read back to the same values: `fof(name, role, formula).`, one
/// per line.
std::string WriteTptp(const std::vector<AnnotatedFormula>& formulas);
std::string WriteTptp(const Clause& clause);

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_TPTP_H_
