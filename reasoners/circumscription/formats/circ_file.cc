// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/formats/circ_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <utility>

namespace latchwork::circumscription {
namespace {

constexpr int kMaxLevel = 1'000'000;

/// A word of a line; columns count from 1.
struct Word {
  std::string_view text;
  std::uint32_t column = 0;
};

std::vector<Word> Split(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r\v\f";
  std::vector<Word> words;
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

bool IsNumber(std::string_view text) {
  return !text.empty() && (text[0] == '-' || (text[0] >= '0' && text[0] <= '9'));
}

class Reader {
 public:
  Reader(std::string_view text, std::string_view name, std::size_t max_diagnostics)
      : text_(text), name_(name), max_diagnostics_(max_diagnostics) {}

  CircFile Read() {
    std::size_t at = 0;
    while (at < text_.size() && !ended_) {
      const std::size_t end = std::min(text_.find('\n', at), text_.size());
      line_ = text_.substr(at, end - at);
      ++line_number_;
      const std::vector<Word> words = Split(line_);
      if (!words.empty()) ReadLine(words);
      at = end + 1;
    }
    CheckWhole();
    return std::move(file_);
  }

 private:
  void ReadLine(const std::vector<Word>& words);
  void ReadHeader(const std::vector<Word>& words);
  void ReadName(const std::vector<Word>& words);
  void ReadRole(const std::vector<Word>& words);
  void ReadQuery(const std::vector<Word>& words);
  void CheckWhole();

  /// The literals from words[first] to the 0 at the end, those that are right.
  std::vector<Literal> Literals(const std::vector<Word>& words, std::size_t first);
  std::optional<Literal> ToLiteral(const Word& word);
  void SetRole(const Word& word, Literal atom, Role role, int level);

  void Error(std::uint32_t column, std::string message, std::string hint = "") {
    if (file_.diagnostics.size() >= max_diagnostics_) return;
    logic::SourcePlace place{std::string(name_), line_number_, column};
    file_.diagnostics.push_back(
        {std::move(place), std::move(message), std::move(hint), std::string(line_)});
  }

  std::string_view text_;
  std::string_view name_;
  std::size_t max_diagnostics_;
  std::string_view line_;
  std::uint32_t line_number_ = 0;
  bool ended_ = false;
  bool has_header_ = false;
  std::size_t announced_ = 0;  ///< Clauses.
  std::vector<bool> has_role_;
  std::set<std::string, std::less<>> ids_;
  CircFile file_;
};

void Reader::ReadLine(const std::vector<Word>& words) {
  const std::string_view key = words[0].text;
  if (key == "c") return;
  if (key == "=" || key == "x") {
    ended_ = true;
  } else if (key == "p") {
    ReadHeader(words);
  } else if (!has_header_) {
    Error(words[0].column, "the header does not come first", "start with: p circ ATOMS CLAUSES");
    ended_ = true;
  } else if (key == "n") {
    ReadName(words);
  } else if (key == "P" || key == "Z" || key == "Q") {
    ReadRole(words);
  } else if (key == "F") {
    const std::vector<Literal> facts = Literals(words, 1);
    file_.facts.insert(file_.facts.end(), facts.begin(), facts.end());
  } else if (key == "?") {
    ReadQuery(words);
  } else if (IsNumber(key)) {
    file_.theory.clauses.push_back(Literals(words, 0));
  } else {
    Error(words[0].column, fmt::format("there is no statement '{}'", key),
          "statements start with c, p, n, P, Z, Q, F, ?, = or x; clauses with a number");
  }
}

void Reader::ReadHeader(const std::vector<Word>& words) {
  if (has_header_) return Error(words[0].column, "there is a second header");
  has_header_ = true;
  const std::optional<int> atoms = words.size() > 2 ? ToInteger(words[2].text) : std::nullopt;
  const std::optional<int> clauses = words.size() > 3 ? ToInteger(words[3].text) : std::nullopt;
  if (words.size() != 4 || words[1].text != "circ" || !atoms || !clauses || *atoms < 0 ||
      *clauses < 0) {
    ended_ = true;
    return Error(words[0].column, "the header is not of the form: p circ ATOMS CLAUSES");
  }
  // Each atom is named by a role line, so the text bounds the memory.
  if (static_cast<std::size_t>(*atoms) > text_.size()) {
    ended_ = true;
    return Error(words[2].column, fmt::format("there cannot be {} atoms: each needs a place in a "
                                              "P, Z or Q line of this file",
                                              *atoms));
  }
  announced_ = static_cast<std::size_t>(*clauses);
  file_.theory.atoms.resize(static_cast<std::size_t>(*atoms));
  has_role_.resize(file_.theory.atoms.size(), false);
}

void Reader::ReadName(const std::vector<Word>& words) {
  if (words.size() != 3) return Error(words[0].column, "not of the form: n ATOM NAME");
  const std::optional<Literal> atom = ToLiteral(words[1]);
  if (!atom) return;
  if (*atom < 0) return Error(words[1].column, "a negated atom has no name");
  file_.theory.atoms[static_cast<std::size_t>(*atom) - 1].name = words[2].text;
}

void Reader::ReadRole(const std::vector<Word>& words) {
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

void Reader::SetRole(const Word& word, Literal atom, Role role, int level) {
  if (atom < 0) return Error(word.column, "an atom is meant here, not its negation");
  const auto index = static_cast<std::size_t>(atom) - 1;
  if (has_role_[index]) {
    return Error(word.column, fmt::format("atom {} already has its place", atom),
                 "each atom stands in exactly one of P, Z and Q");
  }
  has_role_[index] = true;
  file_.theory.atoms[index].role = role;
  file_.theory.atoms[index].level = level;
}

void Reader::ReadQuery(const std::vector<Word>& words) {
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
  file_.queries.push_back({std::string(words[1].text), words[2].text == "b", Literals(words, 3)});
}

std::vector<Literal> Reader::Literals(const std::vector<Word>& words, std::size_t first) {
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

std::optional<Literal> Reader::ToLiteral(const Word& word) {
  const std::optional<int> value = ToInteger(word.text);
  const auto atoms = static_cast<int>(file_.theory.atoms.size());
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

void Reader::CheckWhole() {
  line_ = {};
  line_number_ = 0;
  if (!has_header_) {
    if (file_.diagnostics.empty()) Error(0, "there is no header", "p circ ATOMS CLAUSES");
    return;
  }
  if (!file_.diagnostics.empty()) return;
  if (file_.theory.clauses.size() != announced_) {
    Error(0, fmt::format("the header announces {} clauses, but there are {}", announced_,
                         file_.theory.clauses.size()));
  }
  const auto first = std::find(has_role_.begin(), has_role_.end(), false);
  if (first == has_role_.end()) return;
  Error(0,
        fmt::format("{} atoms have no place in P, Z or Q, the first of them {}",
                    std::count(has_role_.begin(), has_role_.end(), false),
                    first - has_role_.begin() + 1),
        "each atom stands in exactly one of P, Z and Q");
}

}  // namespace

CircFile ReadCirc(std::string_view text, std::string_view name, std::size_t max_diagnostics) {
  return Reader(text, name, max_diagnostics).Read();
}

std::vector<Literal> MoveFacts(std::span<const Literal> facts, GroundTheory& theory) {
  std::vector<Literal> latches;
  for (const Literal fact : facts) {
    if (theory.at(AtomOf(fact)).role == Role::kFixed) {
      latches.push_back(fact);
    } else {
      theory.clauses.push_back({fact});
    }
  }
  return latches;
}

}  // namespace latchwork::circumscription
