// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reasoners/circumscription/evaluation/evaluator.h"

namespace latchwork::circumscription {
namespace {

using Mode = sdk::Attachment::Mode;

bool Fits(sdk::ArgumentType type, const Value& value) {
  switch (type) {
    case sdk::ArgumentType::kInteger:
      return value.kind == Value::Kind::kInteger;
    case sdk::ArgumentType::kReal:
      return value.is_number();
    case sdk::ArgumentType::kSymbol:
      return value.kind == Value::Kind::kConstant;
    case sdk::ArgumentType::kAny:
      break;
  }
  return true;
}

/// Collects the outputs of an attachment as values.
class OutputSink final : public sdk::AnswerSink {
 public:
  OutputSink(const sdk::Attachment::Signature& signature, ValueBank& bank,
             std::vector<Value>& outputs)
      : signature_(signature), bank_(bank), outputs_(outputs) {
    for (const auto& argument : signature.arguments) count_ += argument.mode == Mode::kOut ? 1 : 0;
  }

  void Answer(std::span<const logic::Term> terms) override {
    if (terms.size() != count_) Refuse("gave the wrong number of outputs");
    for (const logic::Term& term : terms) {
      if (!term.is_ground()) Refuse("gave an output that is not ground");
      if (term.is_number() && !std::isfinite(term.number())) {
        Refuse("gave a number that is not finite");
      }
      outputs_.push_back(bank_.Of(term));
    }
    ++answers;
  }
  std::size_t answers = 0;

 private:
  [[noreturn]] void Refuse(std::string_view what) const {
    throw std::runtime_error(fmt::format("attachment {} {}", signature_.predicate, what));
  }

  const sdk::Attachment::Signature& signature_;
  ValueBank& bank_;
  std::vector<Value>& outputs_;
  std::size_t count_ = 0;
};

}  // namespace

/// What an attachment asks is answered from the strata below it.
class Evaluator::Context final : public sdk::AttachmentContext {
 public:
  explicit Context(Evaluator& evaluator) : evaluator_(evaluator) {}
  void ForEachProvable(std::span<const logic::Literal> query, std::size_t variables,
                       sdk::AnswerSink& sink) override {
    evaluator_.Query(query, variables, sink);
  }

 private:
  Evaluator& evaluator_;
};

void Evaluator::CallAttachment(const Frame& frame, std::size_t step) {
  const Step& call = frame.rule->steps[step];
  if (calling_ == invocations_.size()) invocations_.push_back(std::make_unique<Invocation>());
  Invocation& invocation = *invocations_[calling_];
  if (TakeInputs(call, frame.base, invocation)) Invoke(invocation);
  if (!stops()) Join(frame, step);
}

/// Whether the attachment is to be called: its inputs fit and are new.
bool Evaluator::TakeInputs(const Step& step, std::size_t base, Invocation& invocation) {
  invocation.relation = step.relation;
  invocation.inputs.clear();
  invocation.outputs.clear();
  invocation.seen.clear();
  const std::size_t attachment = program_.relations()[step.relation].attachment;
  const auto& arguments = program_.relations().attachment(attachment).signature().arguments;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].mode != Mode::kIn) continue;
    Value value;
    if (!Build(step.arguments[i], base, value) || !Fits(arguments[i].spec.type, value)) {
      return false;
    }
    invocation.inputs.push_back(value);
  }
  auto& called = called_[step.relation];
  if (!called) {
    called = std::make_unique<FactTable>(invocation.inputs.size(), std::span<const std::size_t>());
  }
  const std::uint32_t known = called->size();
  return called->Insert(invocation.inputs, {}) == known;
}

void Evaluator::Invoke(Invocation& invocation) {
  const std::size_t number = program_.relations()[invocation.relation].attachment;
  sdk::Attachment& attachment = program_.relations().attachment(number);
  invocation.terms.clear();
  for (const Value& input : invocation.inputs) invocation.terms.push_back(bank_.ToTerm(input));
  OutputSink outputs(attachment.signature(), bank_, invocation.outputs);
  Context context(*this);
  ++spending_.attachment_calls;
  ++calling_;
  attachment.Call(invocation.terms, context, outputs);
  --calling_;
  if (stops()) return;
  if (invocation.outputs.empty() && outputs.answers > 0) invocation.outputs.emplace_back();
  KeepOutputs(invocation);
}

void Evaluator::KeepOutputs(Invocation& invocation) {
  const std::size_t number = program_.relations()[invocation.relation].attachment;
  const auto& arguments = program_.relations().attachment(number).signature().arguments;
  FactInfo info;
  info.origin = FactInfo::Origin::kAttachment;
  info.first_premise = premises_.size();
  info.premises = invocation.seen.size();
  for (const FactRef& seen : invocation.seen) {
    premises_.push_back(seen);
    const bool is_default = seen.relation == FactRef::kAssumption;
    const FactInfo* other = is_default ? nullptr : &InfoOf(seen);
    info.rank =
        std::max(info.rank, is_default ? RankOf(defaults_[seen.row].relation) : other->rank);
    if (other != nullptr) info.height = std::max(info.height, other->height + 1);
  }
  for (std::size_t next = 0; next < invocation.outputs.size();) {
    cells_.clear();
    std::size_t input = 0;
    for (const auto& argument : arguments) {
      cells_.push_back(argument.mode == Mode::kIn ? invocation.inputs[input++]
                                                  : invocation.outputs[next++]);
    }
    if (input == arguments.size()) ++next;
    tables_[invocation.relation]->Insert(cells_, info);
    if (sink_ != nullptr) sink_->Give(invocation.relation, cells_);
  }
}

const Evaluator::CompiledQuery* Evaluator::FindQuery(std::span<const logic::Literal> query,
                                                     std::size_t variables) {
  const std::size_t attachment = invocations_[calling_ - 1]->relation;
  for (const auto& known : queries_) {
    if (known->attachment == attachment &&
        std::equal(query.begin(), query.end(), known->literals.begin(), known->literals.end())) {
      return known.get();
    }
  }
  auto compiled = std::make_unique<CompiledQuery>();
  compiled->literals.assign(query.begin(), query.end());
  compiled->attachment = attachment;
  std::string problem;
  const std::size_t answers = program_.AddAnswers(variables);
  auto rule = program_.CompileQuery(query, variables, answers, problem);
  if (!rule) {
    refusal_ = fmt::format("what attachment '{}' asks for cannot be grounded: {}",
                           program_.relations()[attachment].name.symbol.name(), problem);
    return nullptr;
  }
  compiled->rule = *std::move(rule);
  queries_.push_back(std::move(compiled));
  return queries_.back().get();
}

/// Whether all that the query asks for is known to belong to earlier strata; where not, the
/// evaluation starts again with strata in which it does.
bool Evaluator::IsReady(const CompiledQuery& query) {
  for (const Step& step : query.rule.steps) {
    if (step.relation == kNoIndex) continue;
    if (program_.AddQuestion(query.attachment, step.relation)) restart_ = true;
  }
  return !restart_;
}

void Evaluator::Query(std::span<const logic::Literal> query, std::size_t variables,
                      sdk::AnswerSink& sink) {
  if (stops()) return;
  const CompiledQuery* compiled = FindQuery(query, variables);
  if (compiled == nullptr || !IsReady(*compiled)) return;
  Grow();
  const std::size_t relation = compiled->rule.heads.front().relation;
  FactTable& answers = *tables_[relation];
  answers.Clear();
  Start(compiled->rule, 0);
  Invocation& invocation = *invocations_[calling_ - 1];
  std::vector<logic::Term>& terms = invocation.answer;
  for (std::uint32_t row = 0; row < answers.size() && !stops(); ++row) {
    if (sink_ != nullptr && !IsCertain(Premises(answers.info(row)))) continue;
    for (const FactRef premise : Premises(answers.info(row))) invocation.seen.push_back(premise);
    terms.clear();
    for (const Value& value : answers.Row(row)) terms.push_back(bank_.ToTerm(value));
    sink.Answer(terms);
  }
}

}  // namespace latchwork::circumscription
