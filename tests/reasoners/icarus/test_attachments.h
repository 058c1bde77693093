// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_ICARUS_TEST_ATTACHMENTS_H_
#define LATCHWORK_TESTS_REASONERS_ICARUS_TEST_ATTACHMENTS_H_

#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "latchwork/sdk/attachment.h"

namespace latchwork::icarus::testing {

/// halves(N, Half, Rest), of an integer that is not negative; throws for 13.
class Halves final : public sdk::Attachment {
 public:
  const Signature& signature() const override {
    using sdk::ArgumentType;
    static const Signature signature{"halves",
                                     {{{"n", ArgumentType::kInteger, ""}, Mode::kIn},
                                      {{"half", ArgumentType::kInteger, ""}, Mode::kOut},
                                      {{"rest", ArgumentType::kInteger, ""}, Mode::kOut}},
                                     ""};
    return signature;
  }
  void Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& /*context*/,
            sdk::AnswerSink& outputs) override {
    const std::int64_t n = inputs[0].integer();
    if (n == 13) throw std::runtime_error("thirteen");
    if (n < 0) return;
    const std::array<logic::Term, 2> answer{logic::Term::Integer(n / 2),
                                            logic::Term::Integer(n % 2)};
    outputs.Answer(answer);
  }
};

/// name(Sum): the sum over the last variable of all provable instances of a query.
class Total final : public sdk::Attachment {
 public:
  Total(std::string name, std::vector<logic::Literal> query, std::size_t variables)
      : signature_{std::move(name), {{{"sum", sdk::ArgumentType::kInteger, ""}, Mode::kOut}}, ""},
        query_(std::move(query)),
        variables_(variables) {}

  const Signature& signature() const override { return signature_; }
  void Call(std::span<const logic::Term> /*inputs*/, sdk::AttachmentContext& context,
            sdk::AnswerSink& outputs) override {
    Sum sum;
    context.ForEachProvable(query_, variables_, sum);
    const std::array<logic::Term, 1> answer{logic::Term::Integer(sum.value)};
    outputs.Answer(answer);
  }

 private:
  class Sum final : public sdk::AnswerSink {
   public:
    void Answer(std::span<const logic::Term> terms) override { value += terms.back().integer(); }
    std::int64_t value = 0;
  };

  Signature signature_;
  std::vector<logic::Literal> query_;
  std::size_t variables_;
};

}  // namespace latchwork::icarus::testing

#endif  // LATCHWORK_TESTS_REASONERS_ICARUS_TEST_ATTACHMENTS_H_
