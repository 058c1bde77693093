// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_PROGRAM_H_
#define LATCHWORK_ICARUS_PROGRAM_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/source_tree.h"

namespace latchwork::icarus {

/// What may stand for a value. kCall only where the grammar has a call: in braces, as what a
/// variable is bound to, and as a :value.
enum class TermKind : std::uint8_t {
  kVariable,
  kAnonymous,
  kConstant,
  kInteger,
  kReal,
  kString,
  kSymbol,
  kList,
  kCall,
};

struct Term {
  TermKind kind = TermKind::kSymbol;
  FormId form = kNoForm;
  std::uint32_t index = 0;   ///< kVariable: in Skill::variables. kConstant: in Program::constants.
  std::int64_t integer = 0;  ///< kInteger.
  double real = 0;           ///< kReal.
  std::string text;          ///< kSymbol, folded; kString; the function of kCall, folded.
  std::vector<Term> items;   ///< Of kList; the arguments of kCall.
};

enum class ClauseKind : std::uint8_t {
  kSkill,        ///< (name arguments)
  kCall,         ///< {function arguments}: one term of kind kCall.
  kBind,         ///< (bind ?v term): two terms, the first a variable or a list.
  kNot,          ///< (*not* inner)
  kNotOrActing,  ///< (*notA* inner)
  kMatch,        ///< (pattern ...): what has no other reading.
};

struct Clause {
  ClauseKind kind = ClauseKind::kMatch;
  FormId form = kNoForm;
  std::uint32_t skill = 0;  ///< kSkill: in Program::skills.
  std::vector<Term> terms;
  std::vector<Clause> inner;  ///< One, of the negations.
};

enum class Slot : std::uint8_t { kObjective, kRequires, kMeans, kSequence, kAction, kSensor };
inline constexpr std::size_t kSlots = 6;
std::string_view KeywordOf(Slot slot);

enum class SkillType : std::uint8_t { kPlan, kSequence, kAction, kSensor };

struct Skill {
  std::string name;      ///< Folded.
  std::string spelling;  ///< As written.
  FormId form = kNoForm;
  FormId name_form = kNoForm;
  SkillType type = SkillType::kPlan;
  std::size_t parameters = 0;
  std::vector<std::string> variables;      ///< Folded, with '?'; the parameters come first.
  std::vector<FormId> variable_forms;      ///< Where each stands first.
  std::vector<std::uint32_t> occurrences;  ///< Of each, the parameter list included.
  std::array<std::optional<std::vector<Clause>>, kSlots> slots;
  std::array<FormId, kSlots> slot_forms{};
  std::optional<Term> value;
  bool has_whole_head = true;  ///< Otherwise parameters are missing.
  bool is_whole = true;        ///< Otherwise clauses, and what they would do, are missing.

  const std::vector<Clause>* slot(Slot which) const {
    const auto& clauses = slots[static_cast<std::size_t>(which)];
    return clauses ? &*clauses : nullptr;
  }
};

struct Constant {
  std::string name;  ///< Folded, with stars.
  FormId form = kNoForm;
  Term value;
};

/// Index in Program::constants of *cycle*, the number of the present cycle.
inline constexpr std::uint32_t kCycleConstant = 0;
inline constexpr std::uint32_t kNoSkill = std::numeric_limits<std::uint32_t>::max();

/// A program as it was written, its clauses resolved: every name is known for what it is.
struct Program {
  SourceTree source;
  std::vector<Skill> skills;
  std::vector<Constant> constants;
  std::vector<Term> facts;
  std::optional<Skill> top;   ///< `(top call)`: a skill without a name whose :requires is the call.
  std::vector<Skill> nevers;  ///< `(never clause ...)`: the same, of the clauses.

  /// The index of the skill with this name, in any case; kNoSkill where there is none.
  std::uint32_t Find(std::string_view name) const;
};

/// Reads, resolves and checks a text: errors of syntax and of structure, and with them every
/// warning of the linter. The program is whole only when `findings` has no error.
struct ProgramFile {
  Program program;
  Findings findings;
};

/// What a program is checked against.
struct CheckOptions {
  bool strict = false;  ///< Fewer arguments than parameters are an error.
  std::string top;      ///< The skill the program is started with; empty: as the program says.
  std::vector<std::string> facts;  ///< How facts from elsewhere begin, folded.
};

ProgramFile ReadProgram(std::string text, std::string file, const CheckOptions& options = {});
/// Of a text that was put together from `parts`, none of which has errors of syntax.
ProgramFile ReadProgram(std::string text, std::vector<SourcePart> parts,
                        const CheckOptions& options = {});

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_PROGRAM_H_
