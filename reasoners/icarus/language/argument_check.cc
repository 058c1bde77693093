// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/language/argument_check.h"

#include <string>

namespace latchwork::icarus {

namespace {

std::string Count(std::size_t count, std::string_view noun) {
  return std::to_string(count) + ' ' + std::string(noun) + (count == 1 ? "" : "s");
}

std::string Wanted(const Signature& signature) {
  if (signature.most == kAnyNumber) return "at least " + Count(signature.least, "argument");
  if (signature.least == signature.most) return Count(signature.least, "argument");
  return std::to_string(signature.least) + " to " + Count(signature.most, "argument");
}

/// Of all that it answers.
ArgumentType AnswerType(const Signature& signature) {
  if (!signature.answers) return ArgumentType::kAny;
  if (signature.answers->empty()) return ArgumentType::kSymbol;
  return signature.answers->size() == 1 ? signature.answers->front() : ArgumentType::kList;
}

/// Whether no value of the one type is of the other.
bool Excludes(ArgumentType given, ArgumentType wanted) {
  const auto is_number = [](ArgumentType type) {
    return type == ArgumentType::kInteger || type == ArgumentType::kNumber;
  };
  if (given == ArgumentType::kAny || wanted == ArgumentType::kAny) return false;
  return given != wanted && !(is_number(given) && is_number(wanted));
}

std::string Answers(const Term& call, const Signature& signature) {
  const std::string name = "{" + call.text + "} answers ";
  if (signature.answers->size() > 1) {
    return name + "a list of " + std::to_string(signature.answers->size());
  }
  return name + (signature.answers->empty() ? "t" : std::string(NameOf(AnswerType(signature))));
}

}  // namespace

bool Offends(const Program& program, const Term& term, ArgumentType type) {
  if (type == ArgumentType::kAny) return false;
  switch (term.kind) {
    case TermKind::kInteger:
      return type == ArgumentType::kSymbol || type == ArgumentType::kList;
    case TermKind::kReal:
      return type != ArgumentType::kNumber;
    case TermKind::kSymbol:
    case TermKind::kString:
      return type != ArgumentType::kSymbol;
    case TermKind::kList:
      return type != ArgumentType::kList;
    case TermKind::kConstant:
      return term.index != kCycleConstant &&
             Offends(program, program.constants[term.index].value, type);
    default:
      return false;
  }
}

const Signature* FindSignature(std::span<const Signature> signatures, std::string_view name,
                               std::size_t arguments) {
  const Signature* found = nullptr;
  for (const Signature& signature : signatures) {
    if (signature.name != name) continue;
    if (arguments >= signature.least && arguments <= signature.most) return &signature;
    if (found == nullptr) found = &signature;
  }
  return found;
}

void CheckArguments(const Program& program, const Term& call, const Signature& signature,
                    Reporter& reporter) {
  if (call.items.size() < signature.least || call.items.size() > signature.most) {
    reporter.Add(Code::kFunctionArguments, call.form,
                 "{" + call.text + "} takes " + Wanted(signature) + ", but is called with " +
                     std::to_string(call.items.size()));
    return;
  }
  for (std::size_t i = 0; i < call.items.size(); ++i) {
    const ArgumentType type = signature.TypeOf(i);
    if (!Offends(program, call.items[i], type)) continue;
    reporter.Add(Code::kFunctionArguments, call.items[i].form,
                 "{" + call.text + "} takes " + std::string(NameOf(type)) + " here");
  }
}

void CheckNested(const Term& call, const Signature& signature, std::span<const Signature> functions,
                 Reporter& reporter) {
  for (std::size_t i = 0; i < call.items.size(); ++i) {
    const Term& inner = call.items[i];
    if (inner.kind != TermKind::kCall || FindBuiltin(inner.text) != nullptr) continue;
    const Signature* const asked = FindSignature(functions, inner.text, inner.items.size());
    if (asked == nullptr || !Excludes(AnswerType(*asked), signature.TypeOf(i))) continue;
    reporter.Add(Code::kFunctionArguments, inner.form,
                 "{" + call.text + "} takes " + std::string(NameOf(signature.TypeOf(i))) +
                     " here, but " + Answers(inner, *asked));
  }
}

void CheckTarget(const Program& program, const Term& target, const Term& call,
                 const Signature& signature, Reporter& reporter) {
  if (!signature.answers || target.kind != TermKind::kList) return;
  const std::span<const ArgumentType> answers = *signature.answers;
  const bool is_value = answers.size() < 2;
  if (is_value ? Excludes(AnswerType(signature), ArgumentType::kList)
               : answers.size() != target.items.size()) {
    reporter.Add(Code::kFunctionArguments, target.form,
                 Answers(call, signature) + ", and here is a list of " +
                     std::to_string(target.items.size()));
    return;
  }
  for (std::size_t i = 0; !is_value && i < answers.size(); ++i) {
    if (!Offends(program, target.items[i], answers[i])) continue;
    reporter.Add(Code::kFunctionArguments, target.items[i].form,
                 "{" + call.text + "} answers " + std::string(NameOf(answers[i])) + " here");
  }
}

void CheckPattern(const Program& program, const Clause& match, const Signature& signature,
                  Reporter& reporter) {
  const std::string& name = match.terms.front().text;
  const std::size_t given = match.terms.size() - 1;
  if (given != signature.least) {
    reporter.Add(Code::kFactArguments, match.form,
                 "facts (" + name + " ...) have " + Count(signature.least, "argument") +
                     ", but here are " + std::to_string(given),
                 "write ? for what is of no interest");
    return;
  }
  for (std::size_t i = 0; i < given; ++i) {
    const ArgumentType type = signature.TypeOf(i);
    if (!Offends(program, match.terms[i + 1], type)) continue;
    reporter.Add(Code::kFactArguments, match.terms[i + 1].form,
                 "facts (" + name + " ...) have " + std::string(NameOf(type)) + " here");
  }
}

}  // namespace latchwork::icarus
