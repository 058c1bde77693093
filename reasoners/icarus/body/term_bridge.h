// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_TERM_BRIDGE_H_
#define LATCHWORK_ICARUS_TERM_BRIDGE_H_

#include <cstddef>
#include <string_view>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/logic/term.h"
#include "reasoners/icarus/machine/value.h"

namespace latchwork::icarus {

/// Facts and terms as values, and back: p(a, 1) is (p a 1), f(x) within it (f x), a distinct object
/// a string. Names are folded on their way in; on their way out they are spelt as in the first fact
/// that brought them, else as in the program. Allocates only for names and lists not met before.
class TermBridge {
 public:
  TermBridge(logic::SymbolTable& symbols, NamePool& names) : symbols_(symbols), names_(names) {}

  NameId Import(logic::Symbol symbol);
  /// None when the term is too deep or has a variable or a number that is not finite.
  Value Import(const logic::Term& term, Arena& arena);
  Value Import(const logic::Fact& fact, Arena& arena);

  /// False: no term stands for the value: it is none, or a list that does not begin with a name or
  /// has nothing else in it.
  bool Export(const Value& value, logic::Term& term);
  /// The word for a name.
  logic::Symbol Export(NameId name);

  /// How a name is spelt in the program.
  void Spell(NameId name, std::string_view spelling);

 private:
  struct Spelling {
    logic::Symbol word;
    logic::Symbol object;    ///< For strings.
    bool from_fact = false;  ///< `word` came in with a fact.
  };
  struct Kept {
    Value list;
    logic::Term term;
  };

  Value ImportList(NameId head, std::span<const logic::Term> arguments, Arena& arena,
                   std::uint32_t depth);
  Value Import(const logic::Term& term, Arena& arena, std::uint32_t depth);
  bool ExportList(const Value& list, logic::Term& term);
  Spelling& SpellingOf(NameId name);

  logic::SymbolTable& symbols_;
  NamePool& names_;
  std::vector<NameId> name_of_;  ///< By index of the symbol.
  std::vector<Spelling> spellings_;
  std::vector<Value> stack_;
  std::vector<Kept> kept_;  ///< Lists that went out, by hash; a place is used again.
  Arena kept_lists_;
  std::size_t kept_count_ = 0;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_TERM_BRIDGE_H_
