// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_TABLEAU_LITERAL_CODER_H_
#define LATCHWORK_PTTP_TABLEAU_LITERAL_CODER_H_

#include <cstdint>
#include <map>
#include <vector>

#include "reasoners/pttp/tableau/matrix_terms.h"

namespace latchwork::pttp {

/// Blocks that the search writes one after the other, parts before wholes, to make an instance of a
/// term. Of each: functor, arity, how far from it the cell that refers to it is, and its arguments;
/// those with kOpenTag are in place already.
struct TermCode {
  std::uint32_t first = 0;
  std::uint32_t end = 0;
};

/// What unification does at an argument of a head, whose clause copy is new.
enum class HeadStep : std::uint8_t {
  kFirst,   ///< A variable that occurs here for the first time: it gets the goal's argument.
  kAgain,   ///< Another occurrence of a variable.
  kGround,  ///< A term without variables.
  kOpen,    ///< A compound term: made for a variable; else the steps of its arguments follow.
  kDeep,    ///< A compound term that is made and then unified.
  kUp,      ///< Back to where an argument's arguments were begun.
  kDone,
};

struct HeadOperation {
  HeadStep step = HeadStep::kDone;
  bool last = false;       ///< kOpen: nothing follows in the term around it.
  bool all_new = false;    ///< kOpen: all its variables occur here first, and once.
  Cell cell = 0;           ///< The term; of kOpen its functor.
  TermCode code;           ///< How to make the term.
  std::uint32_t skip = 0;  ///< kOpen: how many operations are about its arguments.
};

/// Compiles the arguments of a literal, both for goals and for heads.
class LiteralCoder {
 public:
  LiteralCoder(const std::vector<Cell>& cells, std::vector<Cell>& codes,
               std::vector<HeadOperation>& operations)
      : cells_(cells), codes_(codes), operations_(operations) {}

  /// The code of the compound arguments; the cells that refer to them are behind all blocks.
  /// `words` becomes the size of the blocks.
  TermCode Code(std::uint32_t arguments, std::uint32_t arity, std::uint32_t& words);
  /// The operations of the literal last coded, as a head of a clause with so many variables.
  void AddHead(std::uint32_t arguments, std::uint32_t arity, std::uint32_t slots);

 private:
  struct Block {
    Cell cell = 0;
    std::uint32_t parent = 0;    ///< Its number; kLiteral: none.
    std::uint32_t argument = 0;  ///< Which one of the parent.
    std::uint32_t start = 0;     ///< Where it will be, from the first one.
  };
  static constexpr std::uint32_t kLiteral = 0xffffffffU;

  void List(Cell argument, std::uint32_t number);
  void Emit(std::uint32_t words);
  bool AddOperations(const Cell* arguments, std::uint32_t count, std::uint32_t nested);
  bool AddOpen(Cell cell, bool last, std::uint32_t nested);
  bool Meet(Cell variable);
  void MeetAll(Cell term);

  const std::vector<Cell>& cells_;
  std::vector<Cell>& codes_;
  std::vector<HeadOperation>& operations_;
  std::vector<Block> blocks_;
  std::map<Cell, TermCode> code_of_;
  std::vector<bool> met_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_TABLEAU_LITERAL_CODER_H_
