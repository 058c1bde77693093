// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/formats/statement_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace latchwork::circumscription {
namespace {

constexpr int kMaxLevel = 1'000'000;

bool IsNumber(std::string_view text) {
  return !text.empty() && (text[0] == '-' || (text[0] >= '0' && text[0] <= '9'));
}

}  // namespace

Words SplitWords(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r\v\f";
  Words words;
  std::size_t at = line.find_first_not_of(kBlanks);
  while (at != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    words.push_back({line.substr(at, end - at), static_cast<std::uint32_t>(at + 1)});
    at = line.find_first_not_of(kBlanks, end);
  }
  return words;
}

std::optional<int> ToInteger(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

void StatementReader::ReadLines() {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
  std::size_t at = 0;
  while (at < text_.size() && !ended_) {
    const std::size_t end = std::min(text_.find('\n', at), text_.size());
    line_ = text_.substr(at, end - at);
    ++line_number_;
    const Words words = SplitWords(line_);
    if (!words.empty()) ReadLine(words);
    at = end + 1;
  }
  line_ = {};
  line_number_ = 0;
  if (!has_header_ && diagnostics_.empty()) {
    Error(0, "there is no header", std::string(HeaderForm()));
  }
}

void StatementReader::ErrorAt(std::uint32_t number, std::string_view line, std::uint32_t column,
                              std::string message, std::string hint) {
  if (diagnostics_.size() >= max_diagnostics_) return;
  diagnostics_.push_back({{std::string(name_), number, column},
                          std::move(message),
                          std::move(hint),
                          std::string(line)});
}

void StatementReader::ReadLine(const Words& words) {
  const std::string_view key = words[0].text;
  if (key == "c") return;
  if (IsAnswer(key)) {
    ended_ = true;
  } else if (key == "p") {
    if (has_header_) return Error(words[0].column, "there is a second header");
    has_header_ = true;
    ReadHeader(words);
  } else if (!has_header_) {
    Error(words[0].column, "the header does not come first",
          fmt::format("start with: {}", HeaderForm()));
    ended_ = true;
  } else if (key == "n") {
    ReadName(words);
  } else if (key == "P" || key == "Z" || key == "Q") {
    ReadRole(words);
  } else if (key == "F") {
    TakeFacts(Literals(words, 1));
  } else if (key == "?") {
    ReadQuery(words);
  } else if (IsNumber(key)) {
    TakeClause(Literals(words, 0));
  } else if (!ReadOther(words)) {
    Error(words[0].column, fmt::format("there is no statement '{}'", key),
          std::string(StatementForms()));
  }
}

std::optional<std::vector<int>> StatementReader::HeaderNumbers(const Words& words,
                                                               std::string_view kind,
                                                               std::size_t count) {
  std::vector<int> numbers;
  for (std::size_t i = 2; i < words.size(); ++i) {
    const std::optional<int> number = ToInteger(words[i].text);
    if (number && *number >= 0) numbers.push_back(*number);
  }
  if (words.size() == count + 2 && words[1].text == kind && numbers.size() == count) return numbers;
  ended_ = true;
  Error(words[0].column, fmt::format("the header is not of the form: {}", HeaderForm()));
  return std::nullopt;
}

bool StatementReader::SetAtoms(const Word& word, int atoms) {
  // Each atom is named by a role line, so the text bounds the memory.
  if (static_cast<std::size_t>(atoms) > text_.size()) {
    ended_ = true;
    Error(word.column, fmt::format("there cannot be {} atoms: each needs a place in a P, Z or Q "
                                   "line of this file",
                                   atoms));
    return false;
  }
  theory_.atoms.resize(static_cast<std::size_t>(atoms));
  has_role_.resize(theory_.atoms.size(), false);
  return true;
}

void StatementReader::ReadName(const Words& words) {
  if (words.size() != 3) return Error(words[0].column, "not of the form: n ATOM NAME");
  const std::optional<Literal> atom = ToLiteral(words[1]);
  if (!atom) return;
  if (*atom < 0) return Error(words[1].column, "a negated atom has no name");
  theory_.atoms[static_cast<std::size_t>(*atom) - 1].name = words[2].text;
}

void StatementReader::ReadRole(const Words& words) {
  const char key = words[0].text[0];
  Role role = key == 'Z' ? Role::kVarying : Role::kFixed;
  std::size_t first = 1;
  int level = 1;
  if (key == 'P') {
    role = Role::kMinimized;
    const std::optional<int> given = words.size() > 1 ? ToInteger(words[1].text) : std::nullopt;
    if (!given || *given < 1 || *given > kMaxLevel) {
      return Error(words[words.size() > 1 ? 1 : 0].column,
                   fmt::format("the priority level is not a number from 1 to {}", kMaxLevel),
                   "for parallel circumscription: P 1 atoms 0");
    }
    level = *given;
    first = 2;
  }
  const std::vector<Literal> atoms = Literals(words, first);
  if (atoms.size() + first + 1 != words.size()) return;
  for (std::size_t i = 0; i < atoms.size(); ++i) SetRole(words[first + i], atoms[i], role, level);
}

void StatementReader::SetRole(const Word& word, Literal atom, Role role, int level) {
  if (atom < 0) return Error(word.column, "an atom is meant here, not its negation");
  const auto index = static_cast<std::size_t>(atom) - 1;
  if (has_role_[index]) {
    return Error(word.column, fmt::format("atom {} already has its place", atom),
                 "each atom stands in exactly one of P, Z and Q");
  }
  has_role_[index] = true;
  theory_.atoms[index].role = role;
  theory_.atoms[index].level = level;
  TakeRole(atom);
}

void StatementReader::ReadQuery(const Words& words) {
  if (words.size() < 4) {
    return Error(words[0].column, "not of the form: ? ID c|b literals 0");
  }
  if (words[2].text != "c" && words[2].text != "b") {
    return Error(words[2].column, fmt::format("'{}' is no kind of query", words[2].text),
                 "c: every minimal model satisfies the disjunction; b: some the conjunction");
  }
  if (!ids_.insert(std::string(words[1].text)).second) {
    return Error(words[1].column, fmt::format("there is a query '{}' already", words[1].text));
  }
  TakeQuery({std::string(words[1].text), words[2].text == "b", Literals(words, 3)}, words);
}

std::vector<Literal> StatementReader::Literals(const Words& words, std::size_t first) {
  std::vector<Literal> literals;
  if (words.size() <= first || words.back().text != "0") {
    Error(words.back().column, "the line does not end with 0");
    return literals;
  }
  for (std::size_t i = first; i + 1 < words.size(); ++i) {
    if (const std::optional<Literal> literal = ToLiteral(words[i])) literals.push_back(*literal);
  }
  return literals;
}

std::optional<Literal> StatementReader::ToLiteral(const Word& word) {
  const std::optional<int> value = ToInteger(word.text);
  const auto atoms = static_cast<int>(theory_.atoms.size());
  if (value && *value != 0 && *value >= -atoms && *value <= atoms) return *value;
  if (!value) {
    Error(word.column, fmt::format("'{}' is not a number", word.text));
  } else if (*value == 0) {
    Error(word.column, "0 stands before the end of the line");
  } else {
    Error(word.column, fmt::format("there is no atom {}", word.text),
          fmt::format("the header announces the atoms 1 to {}", atoms));
  }
  return std::nullopt;
}

void StatementReader::CheckRoles() {
  const auto first = std::find(has_role_.begin(), has_role_.end(), false);
  if (first == has_role_.end()) return;
  Error(0,
        fmt::format("{} atoms have no place in P, Z or Q, the first of them {}",
                    std::count(has_role_.begin(), has_role_.end(), false),
                    first - has_role_.begin() + 1),
        "each atom stands in exactly one of P, Z and Q");
}

}  // namespace latchwork::circumscription
