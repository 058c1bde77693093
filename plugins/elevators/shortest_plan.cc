// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/elevators/shortest_plan.h"

#include <array>

namespace latchwork::elevators {
namespace {

class FoundSink final : public sdk::AnswerSink {
 public:
  void Answer(std::span<const logic::Term> /*terms*/) override { found = true; }

  bool found = false;
};

}  // namespace

ShortestPlan::ShortestPlan(std::int64_t longest, logic::SymbolTable& symbols) {
  const logic::Symbol reach_in = symbols.Intern("reach_in");
  for (std::int64_t n = 0; n <= longest; ++n) {
    queries_.push_back({{true, {reach_in, {logic::Term::Integer(n)}}}});
  }
}

const sdk::Attachment::Signature& ShortestPlan::signature() const {
  static const Signature signature{"shortest_plan",
                                   {{{"actions", sdk::ArgumentType::kInteger, ""}, Mode::kOut}},
                                   "how many actions lead to the target at least"};
  return signature;
}

void ShortestPlan::Call(std::span<const logic::Term> /*inputs*/, sdk::AttachmentContext& context,
                        sdk::AnswerSink& outputs) {
  for (std::size_t n = 0; n < queries_.size(); ++n) {
    FoundSink sink;
    context.ForEachProvable(queries_[n], 0, sink);
    if (!sink.found) continue;
    const std::array<logic::Term, 1> answer{logic::Term::Integer(static_cast<std::int64_t>(n))};
    outputs.Answer(answer);
    return;
  }
}

}  // namespace latchwork::elevators
