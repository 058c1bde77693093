// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_LOGIC_TPTP_PARSER_H_
#define LATCHWORK_LOGIC_TPTP_PARSER_H_

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/logic/tptp_cursor.h"
#include "core/logic/tptp_formula_parser.h"
#include "core/logic/tptp_types.h"
#include "latchwork/logic/tptp.h"

namespace latchwork::logic {

/// include('Axioms/X.ax', [name, ...]).
struct TptpInclude {
  std::string file;
  std::optional<std::vector<std::string>> selection;  ///< Nothing: all formulas.
};

/// What keeps a file from being included.
struct TptpIncludeFault {
  std::string message;
  std::string hint;
};

/// Reads the annotated formulas of one text and recovers at the end of each that is faulty.
class TptpParser {
 public:
  using IncludeHandler = std::function<std::optional<TptpIncludeFault>(const TptpInclude&)>;

  TptpParser(std::string_view text, std::string_view name, SymbolTable& symbols,
             const TptpOptions& options, TptpFile& result, TptpTypes& types,
             IncludeHandler include);

  void Read();

 private:
  bool ReadInput();
  bool FailLanguage();
  bool ReadAnnotated(TptpLanguage language);
  bool ReadName(std::string& name);
  bool ReadRole(TptpLanguage language, std::optional<Role>& role);
  bool ReadFormula(TptpLanguage language, AnnotatedFormula& annotated);
  /// Gives the text between the formula's comma and the closing parenthesis.
  bool ReadAnnotations(std::string_view& source);
  bool SkipAnnotations();
  bool ReadTypeDeclaration(TptpDeclaration declaration);
  /// The parts of a type, `(a * b) > c`, without parentheses around the whole.
  bool ReadFunctionType(TptpDeclaration& declaration);
  bool ReadResultType(TptpDeclaration& declaration);
  /// To the end of a list, which is not consumed: `)`, or also `,`.
  bool SkipBalanced(bool to_comma);
  bool ReadEnd();
  bool ReadInclude();
  bool ReadSelection(TptpInclude& include);
  void Recover();

  TptpCursor cursor_;
  TptpFormulaParser formulas_;
  const TptpOptions& options_;
  TptpFile& result_;
  TptpTypes& types_;
  SymbolTable& symbols_;
  IncludeHandler include_;
};

}  // namespace latchwork::logic

#endif  // LATCHWORK_LOGIC_TPTP_PARSER_H_
