// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_FINDING_H_
#define LATCHWORK_ICARUS_FINDING_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/diagnostic.h"
#include "reasoners/icarus/language/source_tree.h"

namespace latchwork::icarus {

/// What can be wrong with a program. The names that people see (`I001`, …) are stable.
enum class Code : std::uint8_t {
  kBracket,
  kToken,
  kDepth,
  kTopLevel,
  kHead,
  kUnknownSlot,
  kSlot,
  kSkillType,
  kRepeatedSkill,
  kClause,
  kTooManyArguments,
  kConstant,
  kFact,
  kTooFewArguments,
  kMisspeltSkill,
  kUnknownFact,
  kVariableOnce,
  kUnreachable,
  kAlwaysTrue,
  kUnboundAct,
  kUnboundCall,
  kHidingMeans,
  kEndless,
  kUnboundSequence,
  kEffect,
  kSpelling,
  kFunctionArguments,
  kUnknownFunction,
  kScript,
  kTop,
  kFactArguments,
  kNoSuchFact,
  kReactivePlan,
  kValues,
  kParameterType,
  kActIsNotTrue,
};

enum class Severity : std::uint8_t { kError, kWarning };

/// One row of the table of codes.
struct CodeInfo {
  std::string_view name;
  Severity severity;
  std::string_view explanation;  ///< A paragraph for people: what it means and how to mend it.
};

const CodeInfo& Info(Code code);
/// All rows, in the order of their names.
std::span<const CodeInfo> AllCodes();

/// One thing that a person should look at.
struct Finding {
  Code code = Code::kBracket;
  Severity severity = Severity::kError;
  logic::Diagnostic diagnostic;
  std::optional<logic::Diagnostic> note;  ///< Another place that has to do with it.
};

using Findings = std::vector<Finding>;

/// `file:line:column: error[I004]: message`, the line with a caret, the hint, and the note.
std::string Format(const Finding& finding);
bool HasErrors(const Findings& findings);
/// The errors alone, as the rest of the framework takes them; the code leads the message.
logic::Diagnostics ErrorsOf(const Findings& findings);

/// Collects the findings of one file, up to a limit that keeps senseless input cheap.
class Reporter {
 public:
  Reporter(const SourceTree& tree, Findings& findings) : tree_(tree), findings_(findings) {}

  void Add(Code code, FormId form, std::string message, std::string hint = {});
  void AddAt(Code code, std::uint32_t offset, std::uint32_t line, std::uint32_t column,
             std::string message, std::string hint = {});
  /// Adds a second place to the last finding.
  void Note(FormId form, std::string message);
  bool full() const { return findings_.size() >= kMost; }

 private:
  static constexpr std::size_t kMost = 200;

  const SourceTree& tree_;
  Findings& findings_;
  bool dropped_ = false;
};

/// Moves findings about a text that stands within a file, from its first line and column, to where
/// they are in the file.
void MoveTo(const logic::SourcePlace& place, Findings& findings);

/// Takes out the warnings that a comment `; allow I023 …` in their form of the top level, or on the
/// line before theirs, waives, and puts the rest in the order of their places.
void Settle(const SourceTree& tree, Findings& findings);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_FINDING_H_
