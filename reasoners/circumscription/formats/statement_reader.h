// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_FORMATS_STATEMENT_READER_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_FORMATS_STATEMENT_READER_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/diagnostic.h"
#include "reasoners/circumscription/theory/ground_theory.h"

namespace latchwork::circumscription {

struct Query {
  std::string id;
  bool brave = false;  ///< The literals are a conjunction; else a disjunction.
  std::vector<Literal> literals;
};

/// A word of a line; columns count from 1.
struct Word {
  std::string_view text;
  std::uint32_t column = 0;
};
using Words = std::vector<Word>;

Words SplitWords(std::string_view line);
std::optional<int> ToInteger(std::string_view text);

/// What the text forms of ground theories have in common: one statement a line, atoms numbered as
/// the header announces, their names and roles, clauses, facts and queries.
class StatementReader {
 protected:
  StatementReader(std::string_view text, std::string_view name, std::size_t max_diagnostics)
      : text_(text), name_(name), max_diagnostics_(max_diagnostics) {}
  ~StatementReader() = default;
  StatementReader(const StatementReader&) = delete;
  StatementReader& operator=(const StatementReader&) = delete;

  void ReadLines();

  /// True: the line is an answer, and ends what is read.
  virtual bool IsAnswer(std::string_view key) const = 0;
  virtual void ReadHeader(const Words& words) = 0;
  /// False: the format has no statement that starts so.
  virtual bool ReadOther(const Words& words) = 0;
  virtual std::string_view HeaderForm() const = 0;
  virtual std::string_view StatementForms() const = 0;
  virtual void TakeRole(Atom atom) = 0;
  virtual void TakeClause(Clause clause) = 0;
  virtual void TakeFacts(std::vector<Literal> facts) = 0;
  virtual void TakeQuery(Query query, const Words& words) = 0;

  /// The numbers after `p KIND`, `count` of them; nothing, and no more is read: there is an error.
  std::optional<std::vector<int>> HeaderNumbers(const Words& words, std::string_view kind,
                                                std::size_t count);
  /// False: more atoms than the text has room for; no more is read.
  bool SetAtoms(const Word& word, int atoms);
  /// The literals from words[first] to the 0 at the end, those that are right.
  std::vector<Literal> Literals(const Words& words, std::size_t first);
  std::optional<Literal> ToLiteral(const Word& word);
  /// Reports atoms without a role.
  void CheckRoles();

  void Error(std::uint32_t column, std::string message, std::string hint = "") {
    ErrorAt(line_number_, line_, column, std::move(message), std::move(hint));
  }
  void ErrorAt(std::uint32_t number, std::string_view line, std::uint32_t column,
               std::string message, std::string hint = "");
  void End() { ended_ = true; }

  std::string_view text() const { return text_; }
  std::string_view line() const { return line_; }
  std::uint32_t line_number() const { return line_number_; }

  GroundTheory theory_;
  logic::Diagnostics diagnostics_;
  bool has_header_ = false;

 private:
  void ReadLine(const Words& words);
  void ReadName(const Words& words);
  void ReadRole(const Words& words);
  void ReadQuery(const Words& words);
  void SetRole(const Word& word, Literal atom, Role role, int level);

  std::string_view text_;
  std::string_view name_;
  std::size_t max_diagnostics_;
  std::string_view line_;
  std::uint32_t line_number_ = 0;
  bool ended_ = false;
  std::vector<bool> has_role_;
  std::set<std::string> ids_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_FORMATS_STATEMENT_READER_H_
