// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SWIPL_ANSWER_READER_H_
#define LATCHWORK_SWIPL_ANSWER_READER_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/atom.h"
#include "reasoners/swipl/names.h"

namespace latchwork::swipl {

/// A term as Prolog wrote it.
struct Answer {
  enum class Kind : std::uint8_t { kName, kInteger, kReal, kList, kVariable };
  Kind kind = Kind::kName;
  std::string name;  ///< Of kName.
  std::int64_t integer = 0;
  double real = 0;
  std::vector<Answer> arguments;
};

/// Nothing for what is no such term, or is nested deeper than any theory makes them.
std::optional<Answer> ReadAnswer(std::string_view line);

/// The term or fact behind it; nothing when the names are none of ours, or there are variables.
std::optional<logic::Term> ToTerm(const Answer& answer, const Names& names);
std::optional<logic::Fact> ToFact(const Answer& answer, const Names& names);

}  // namespace latchwork::swipl

#endif  // LATCHWORK_SWIPL_ANSWER_READER_H_
