// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/swipl/conversation.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

namespace latchwork::swipl {
namespace {

using Reply = process::Companion::Reply;

bool Fits(const logic::Term& term, sdk::ArgumentType type) {
  using Type = sdk::ArgumentType;
  using TermKind = logic::Term::Kind;
  if (type == Type::kInteger) return term.kind() == TermKind::kInteger;
  if (type == Type::kReal) return term.is_number();
  return type != Type::kSymbol || term.kind() == TermKind::kConstant;
}

/// The inputs, when they are of the declared types.
std::optional<std::vector<logic::Term>> InputsOf(const sdk::Attachment::Signature& signature,
                                                 const Answer& list, const Names& names) {
  std::vector<logic::Term> inputs;
  for (const auto& argument : signature.arguments) {
    if (argument.mode != sdk::Attachment::Mode::kIn) continue;
    if (inputs.size() == list.arguments.size()) return std::nullopt;
    auto term = ToTerm(list.arguments[inputs.size()], names);
    if (!term || !Fits(*term, argument.spec.type)) return std::nullopt;
    inputs.push_back(*std::move(term));
  }
  return inputs;
}

std::size_t CountOutputs(const sdk::Attachment::Signature& signature) {
  std::size_t outputs = 0;
  for (const auto& argument : signature.arguments) {
    if (argument.mode == sdk::Attachment::Mode::kOut) ++outputs;
  }
  return outputs;
}

}  // namespace

/// Writes what an attachment gives as a list of rows.
class Conversation::Outputs final : public sdk::AnswerSink {
 public:
  Outputs(const sdk::Attachment::Signature& signature, Names& names)
      : signature_(signature), count_(CountOutputs(signature)), names_(names) {}

  void Answer(std::span<const logic::Term> terms) override {
    if (terms.size() != count_) Refuse("gave the wrong number of outputs");
    rows += rows.empty() ? "[" : ",[";
    for (std::size_t i = 0; i < terms.size(); ++i) {
      if (!terms[i].is_ground()) Refuse("gave an output that is not ground");
      if (terms[i].is_number() && !std::isfinite(terms[i].number())) {
        Refuse("gave a number that is not finite");
      }
      if (i > 0) rows += ',';
      names_.Write(terms[i], rows);
    }
    rows += ']';
  }

  std::string rows;

 private:
  [[noreturn]] void Refuse(std::string_view what) const {
    throw std::runtime_error(fmt::format("attachment {} {}", signature_.predicate, what));
  }

  const sdk::Attachment::Signature& signature_;
  std::size_t count_;
  Names& names_;
};

void Conversation::Stop(End end) {
  is_over_ = true;
  end_ = end;
}

Conversation::End Conversation::Hold(std::string_view command) {
  Say(command);
  ListenFor("done");
  return end_;
}

void Conversation::Say(std::string_view text) {
  if (is_over_ || setting_.companion.Send(text, setting_.patience)) return;
  Stop(setting_.companion.is_running() ? End::kLate : End::kGone);
}

void Conversation::ListenFor(std::string_view last) {
  while (!is_over_) {
    switch (setting_.companion.ReadLine(line_, setting_.patience)) {
      case Reply::kEnded:
        return Stop(End::kGone);
      case Reply::kLate:
        return Stop(End::kLate);
      case Reply::kCancelled:
        return Stop(End::kCancelled);
      case Reply::kLine:
        break;
    }
    const auto said = ReadAnswer(line_);
    if (!said || said->name == "failed") return Stop(End::kMisunderstood);
    if (said->name == "call" && said->arguments.size() == 3) {
      Call(*said);
    } else if (said->name == "answer" && said->arguments.size() == 1) {
      Take(said->arguments[0]);
    } else if (said->name != "answered") {
      listener_.Hear(*said);
    }
    if (said->name == "done") Stop(End::kDone);
    if (said->name == last) return;
  }
}

void Conversation::Call(const Answer& call) {
  const auto number = static_cast<std::size_t>(call.arguments[1].integer);
  if (number >= setting_.attachments.size()) return Stop(End::kMisunderstood);
  sdk::Attachment& attachment = *setting_.attachments[number];
  Outputs outputs(attachment.signature(), setting_.names);
  if (const auto inputs = InputsOf(attachment.signature(), call.arguments[2], setting_.names)) {
    ++attachment_calls_;
    const std::int64_t outer = std::exchange(call_, call.arguments[0].integer);
    attachment.Call(*inputs, *this, outputs);
    call_ = outer;
  }
  Say(fmt::format("rows({},[{}]).\n", call.arguments[0].integer, outputs.rows));
}

void Conversation::Take(const Answer& answer) {
  std::vector<logic::Term> terms;
  for (const Answer& value : answer.arguments) {
    const auto term = ToTerm(value, setting_.names);
    if (!term) return Stop(End::kMisunderstood);
    terms.push_back(*term);
  }
  if (answers_ != nullptr) answers_->push_back(std::move(terms));
}

void Conversation::ForEachProvable(std::span<const logic::Literal> query, std::size_t variables,
                                   sdk::AnswerSink& sink) {
  std::string values;
  for (std::size_t i = 0; i < variables; ++i) {
    fmt::format_to(std::back_inserter(values), "{}X{}", i == 0 ? "" : ",", i);
  }
  std::vector<std::vector<logic::Term>> answers;
  auto* const outer = std::exchange(answers_, &answers);
  Say(fmt::format("ask({},{},[{}],D,({})).\n", call_, setting_.depth, values,
                  setting_.writer.Query({query.begin(), query.end()})));
  ListenFor("answered");
  answers_ = outer;
  if (is_over_) return;
  for (const auto& answer : answers) sink.Answer(answer);
}

}  // namespace latchwork::swipl
