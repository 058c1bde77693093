// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/swipl/answer_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace latchwork::swipl {
namespace {

constexpr int kDeepest = 5000;

bool IsWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::optional<Answer> ReadAll() {
    Answer answer;
    if (!Read(answer, 0) || !text_.empty()) return std::nullopt;
    return answer;
  }

 private:
  bool Read(Answer& answer, int depth) {
    if (text_.empty() || depth > kDeepest) return false;
    const char first = text_.front();
    if (Skip('[')) {
      answer.kind = Answer::Kind::kList;
      return Skip(']') || ReadArguments(answer, ']', depth);
    }
    if (first == '-' || (first >= '0' && first <= '9')) return ReadNumber(answer);
    const auto* const end = std::ranges::find_if_not(text_, IsWordCharacter);
    answer.name.assign(text_.begin(), end);
    text_.remove_prefix(answer.name.size());
    if (answer.name.empty()) return false;
    if (first == '_' || (first >= 'A' && first <= 'Z')) answer.kind = Answer::Kind::kVariable;
    return !Skip('(') || ReadArguments(answer, ')', depth);
  }

  bool ReadArguments(Answer& answer, char end, int depth) {
    do {
      if (!Read(answer.arguments.emplace_back(), depth + 1)) return false;
    } while (Skip(','));
    return Skip(end);
  }

  bool ReadNumber(Answer& answer) {
    const char* const begin = text_.data();
    const char* const end = begin + text_.size();
    auto read = std::from_chars(begin, end, answer.integer);
    answer.kind = Answer::Kind::kInteger;
    if (read.ec != std::errc() || (read.ptr != end && (*read.ptr == '.' || *read.ptr == 'e'))) {
      read = std::from_chars(begin, end, answer.real);
      answer.kind = Answer::Kind::kReal;
    }
    text_.remove_prefix(static_cast<std::size_t>(read.ptr - begin));
    return read.ec == std::errc() &&
           (answer.kind == Answer::Kind::kInteger || std::isfinite(answer.real));
  }

  bool Skip(char c) {
    if (text_.empty() || text_.front() != c) return false;
    text_.remove_prefix(1);
    return true;
  }

  std::string_view text_;
};

std::optional<std::size_t> NumberAfter(std::string_view name, char prefix) {
  std::size_t number = 0;
  if (name.empty() || name.front() != prefix) return std::nullopt;
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + 1, end, number);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return number;
}

std::optional<std::vector<logic::Term>> ToTerms(const std::vector<Answer>& answers,
                                                const Names& names) {
  std::vector<logic::Term> terms;
  for (const Answer& answer : answers) {
    auto term = ToTerm(answer, names);
    if (!term) return std::nullopt;
    terms.push_back(*std::move(term));
  }
  return terms;
}

std::optional<logic::Term> NamedTerm(const Answer& answer, const Names& names) {
  if (answer.name == "d" && answer.arguments.size() == 1) {
    const auto object = names.symbol(static_cast<std::size_t>(answer.arguments[0].integer));
    if (!object) return std::nullopt;
    return logic::Term::Constant(*object);
  }
  const auto number = NumberAfter(answer.name, answer.arguments.empty() ? 'c' : 'g');
  const auto symbol = number ? names.symbol(*number) : std::nullopt;
  auto arguments = ToTerms(answer.arguments, names);
  if (!symbol || !arguments) return std::nullopt;
  if (arguments->empty()) return logic::Term::Constant(*symbol);
  return logic::Term::Compound(*symbol, *std::move(arguments));
}

}  // namespace

std::optional<Answer> ReadAnswer(std::string_view line) { return Reader(line).ReadAll(); }

std::optional<logic::Term> ToTerm(const Answer& answer, const Names& names) {
  switch (answer.kind) {
    case Answer::Kind::kInteger:
      return logic::Term::Integer(answer.integer);
    case Answer::Kind::kReal:
      return logic::Term::Real(answer.real);
    case Answer::Kind::kName:
      return NamedTerm(answer, names);
    default:
      return std::nullopt;
  }
}

std::optional<logic::Fact> ToFact(const Answer& answer, const Names& names) {
  const auto number = NumberAfter(answer.name, 'p');
  const auto arguments = ToTerms(answer.arguments, names);
  if (answer.kind != Answer::Kind::kName || !number || *number >= names.size() || !arguments) {
    return std::nullopt;
  }
  return logic::Fact(names.predicate(*number).symbol, *arguments);
}

}  // namespace latchwork::swipl
