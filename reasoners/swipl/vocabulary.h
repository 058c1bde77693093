// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SWIPL_VOCABULARY_H_
#define LATCHWORK_SWIPL_VOCABULARY_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "latchwork/logic/arithmetic.h"
#include "latchwork/sdk/reasoner.h"
#include "reasoners/swipl/names.h"

namespace latchwork::swipl {

/// What is special about the predicates of a body.
class Vocabulary {
 public:
  enum class Kind : std::uint8_t { kOrdinary, kEquality, kArithmetic, kAttachment };
  struct Info {
    Kind kind = Kind::kOrdinary;
    std::optional<std::uint32_t> minimized;  ///< Bound of its closing; 0: the budget's.
    std::size_t attachment = 0;
    bool is_input = false;
  };

  Vocabulary(const sdk::Body& body, Names& names, logic::SymbolTable& symbols);

  /// By number of the predicate.
  const Info& operator[](std::size_t predicate);
  const Info& Of(const logic::Atom& atom) { return (*this)[names_.Predicate(NameOf(atom))]; }
  bool HasArithmetic(const logic::Term& term) const;
  const logic::Arithmetic& arithmetic() const { return arithmetic_; }
  logic::PredicateName equality() const { return equality_; }
  const sdk::Attachment& attachment(std::size_t number) const { return *body_.attachments[number]; }

 private:
  Info MakeInfo(const logic::PredicateName& name) const;

  const sdk::Body& body_;
  Names& names_;
  logic::SymbolTable& symbols_;
  logic::Arithmetic arithmetic_;
  logic::PredicateName equality_;
  std::vector<Info> infos_;
};

std::string_view NameIn(logic::Arithmetic::Predicate predicate);
std::string_view NameIn(logic::Arithmetic::Function function);

}  // namespace latchwork::swipl

#endif  // LATCHWORK_SWIPL_VOCABULARY_H_
