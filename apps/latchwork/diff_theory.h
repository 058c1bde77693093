// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_DIFF_THEORY_H_
#define LATCHWORK_APPS_LATCHWORK_DIFF_THEORY_H_

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/parameters.h"
#include "latchwork/sdk/reasoner.h"

namespace latchwork::app {

/// What reasoners are compared on: all that a decision depends on.
struct DiffTheory {
  std::vector<logic::Clause> clauses;
  std::vector<sdk::Latch> latches;
  sdk::Body
      body;  ///< Goals, minimized predicates, parameters, attachments; its files do not count.
  sdk::Budget budget;
};

/// One of those that are compared: `pttp` or `circumscription:mode=bounded`.
struct Contender {
  std::string name;
  std::function<std::shared_ptr<sdk::Reasoner>()> make;
  std::vector<sdk::Parameters::Given> given;
};

/// What a contender says to a theory.
struct Verdict {
  enum class Kind : std::uint8_t {
    kDecided,
    kExhausted,  ///< A budget ran out, or something stayed undecided.
    kRefused,    ///< The body is not of its kind, or it could not work.
  };
  Kind kind = Kind::kRefused;
  std::set<std::string> conclusions;  ///< "inconsistent" stands for a contradiction.
  std::string remark;                 ///< Why it is not decided.
};

/// What a decision says of the goals of a body.
Verdict Understand(const sdk::Decision& decision, const sdk::Body& body);

/// Loads the theory from a file in `folder`, and decides once.
Verdict Judge(const Contender& contender, const DiffTheory& theory, logic::SymbolTable& symbols,
              const std::filesystem::path& folder);

/// Both decided, and not the same. Of goals whose first answer is wanted, only whether there is one
/// counts.
bool Disagree(const Verdict& a, const Verdict& b);

/// Clauses and facts of latches as `latchwork prove` reads them; then, as a conjecture, what one
/// verdict has and the other has not.
std::string TheoryText(const DiffTheory& theory, const Verdict& a, const Verdict& b);

/// Takes away all that the disagreement of two contenders does not need: clauses, facts, goals and
/// minimized predicates, then literals. Source: Zeller and Hildebrandt 2002 (delta debugging).
DiffTheory Shrink(const DiffTheory& theory, const Contender& a, const Contender& b,
                  logic::SymbolTable& symbols, const std::filesystem::path& folder);

/// A small theory, the same for the same seed and number: up to eight clauses over three constants,
/// mostly without functions, whose variables are all bound by premises.
DiffTheory MakeRandomTheory(std::uint64_t seed, std::uint64_t number, logic::SymbolTable& symbols);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_DIFF_THEORY_H_
