// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/swipl/body_writer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace latchwork::swipl {
namespace {

using Kind = Vocabulary::Kind;

std::string ListOf(const Variables& variables) {
  std::vector<std::string> names;
  for (const logic::Variable variable : variables) names.push_back(fmt::format("X{}", variable));
  return fmt::format("[{}]", fmt::join(names, ","));
}

bool Covers(const Variables& bound, const Variables& needs) {
  return std::ranges::includes(bound, needs);
}

}  // namespace

void AddVariables(const logic::Term& term, Variables& variables) {
  std::vector<const logic::Term*> open = {&term};
  while (!open.empty()) {
    const logic::Term& current = *open.back();
    open.pop_back();
    if (current.is_variable()) variables.insert(current.variable());
    for (const logic::Term& argument : current.arguments()) open.push_back(&argument);
  }
}

bool BodyWriter::HasRules(const logic::Literal& goal) const {
  const Signed key = SignedOf(names_.Predicate(NameOf(goal.atom)), goal.positive);
  return graph_.HasRules(key) || graph_.Meets(key);
}

bool BodyWriter::IsComputed(const logic::Literal& goal) {
  const Kind kind = vocabulary_.Of(goal.atom).kind;
  return kind == Kind::kArithmetic || (kind == Kind::kEquality && !HasRules(goal));
}

Variables BodyWriter::Needs(const logic::Literal& goal) {
  const Vocabulary::Info& info = vocabulary_.Of(goal.atom);
  bool all = info.kind == Kind::kArithmetic;
  if (!goal.positive) {
    all = all || info.minimized || info.kind == Kind::kAttachment ||
          (info.kind == Kind::kEquality && !HasRules(goal));
  }
  Variables needs;
  for (std::size_t i = 0; i < goal.atom.arity(); ++i) {
    const bool is_input = info.kind == Kind::kAttachment &&
                          vocabulary_.attachment(info.attachment).signature().arguments[i].mode ==
                              sdk::Attachment::Mode::kIn;
    const logic::Term& argument = goal.atom.argument(i);
    if (all || is_input || vocabulary_.HasArithmetic(argument)) AddVariables(argument, needs);
  }
  return needs;
}

bool BodyWriter::IsExtensional(const logic::Literal& goal, const Variables& bound) {
  if (!goal.positive || HasRules(goal) || vocabulary_.Of(goal.atom).kind != Kind::kOrdinary) {
    return false;
  }
  return std::ranges::any_of(goal.atom.arguments(), [&](const logic::Term& argument) {
    return !argument.is_variable() || bound.contains(argument.variable());
  });
}

bool BodyWriter::IsPlain(const logic::Literal& goal) {
  const Vocabulary::Info& info = vocabulary_.Of(goal.atom);
  return Needs(goal).empty() && info.kind == Kind::kOrdinary &&
         (goal.positive || !info.minimized) &&
         std::ranges::none_of(goal.atom.arguments(), [](const logic::Term& argument) {
           return argument.kind() == logic::Term::Kind::kCompound;
         });
}

std::size_t BodyWriter::Choose(const std::vector<logic::Literal>& goals, const Variables& bound) {
  const auto first = [&](auto&& fits) {
    return static_cast<std::size_t>(std::ranges::find_if(goals, fits) - goals.begin());
  };
  const auto is_ready = [&](const logic::Literal& goal) { return Covers(bound, Needs(goal)); };
  const std::size_t computed =
      first([&](const auto& goal) { return IsComputed(goal) && is_ready(goal); });
  if (computed < goals.size()) return computed;
  const std::size_t ready = first(is_ready);
  if (ready == goals.size()) return 0;
  if (!HasRules(goals[ready])) return ready;
  const std::size_t facts =
      first([&](const auto& goal) { return Needs(goal).empty() && IsExtensional(goal, bound); });
  return facts < goals.size() ? facts : ready;
}

std::string BodyWriter::Write(std::vector<logic::Literal> goals, Variables bound,
                              std::string_view more) {
  std::string text;
  while (!goals.empty()) {
    const auto chosen = goals.begin() + static_cast<std::ptrdiff_t>(Choose(goals, bound));
    if (!text.empty()) text += ',';
    WriteGoal(*chosen, more, text);
    for (const logic::Term& argument : chosen->atom.arguments()) AddVariables(argument, bound);
    goals.erase(chosen);
  }
  return text.empty() ? "true" : text;
}

void BodyWriter::WriteGoal(const logic::Literal& goal, std::string_view more, std::string& text) {
  const Variables needs = Needs(goal);
  const std::string core = Core(goal, more);
  if (needs.empty()) {
    text += core;
    return;
  }
  const std::string list = ListOf(needs);
  const Vocabulary::Info& info = vocabulary_.Of(goal.atom);
  const bool by_closing = !goal.positive && info.minimized && info.kind == Kind::kOrdinary;
  text += fmt::format("({} -> {} ; delay({},({})))",
                      by_closing ? fmt::format("(ground({});b_getval(closing,false))", list)
                                 : fmt::format("ground({})", list),
                      core, list, core);
}

std::string BodyWriter::Evaluate(const logic::Term& term, std::string& before) {
  std::string text;
  if (!vocabulary_.HasArithmetic(term)) {
    names_.Write(term, text);
    return text;
  }
  std::vector<std::string> arguments;
  for (const logic::Term& argument : term.arguments()) {
    arguments.push_back(Evaluate(argument, before));
  }
  const auto function =
      vocabulary_.arithmetic().FindFunction(term.symbol(), term.arguments().size());
  if (!function) {
    const std::string name = [&] {
      std::string shape;
      const std::vector<logic::Term> blanks(arguments.size(), logic::Term::Integer(0));
      names_.Write(logic::Term::Compound(term.symbol(), blanks), shape);
      return shape.substr(0, shape.find('('));
    }();
    return fmt::format("{}({})", name, fmt::join(arguments, ","));
  }
  std::string result = fmt::format("V{}", values_++);
  before += fmt::format("value({},{},{}),", NameIn(*function), fmt::join(arguments, ","), result);
  return result;
}

std::string BodyWriter::Core(const logic::Literal& goal, std::string_view more) {
  std::string before;
  std::vector<std::string> arguments;
  for (const logic::Term& argument : goal.atom.arguments()) {
    arguments.push_back(Evaluate(argument, before));
  }
  return before + CallOf(goal, arguments, more);
}

std::string BodyWriter::CallOf(const logic::Literal& goal,
                               const std::vector<std::string>& arguments, std::string_view more) {
  const std::string list = fmt::format("{}", fmt::join(arguments, ","));
  switch (vocabulary_.Of(goal.atom).kind) {
    case Kind::kArithmetic: {
      const auto predicate =
          vocabulary_.arithmetic().FindPredicate(goal.atom.predicate(), goal.atom.arity());
      const std::string_view name = NameIn(*predicate);
      if (arguments.size() == 2) {
        return fmt::format("{}({},{})", goal.positive ? "compares" : "not_compare", name, list);
      }
      if (!goal.positive && name == "is_real") return "fail";
      return fmt::format("{}{}({})", goal.positive ? "" : "not_", name, list);
    }
    case Kind::kAttachment:
      return CallAttachment(goal, arguments);
    case Kind::kEquality:
      if (HasRules(goal)) break;
      if (goal.positive) return fmt::format("{}={}", arguments[0], arguments[1]);
      return fmt::format("differ({},{})", unique_names_, list);
    default:
      break;
  }
  const std::size_t predicate = names_.Predicate(NameOf(goal.atom));
  const Signed key = SignedOf(predicate, goal.positive);
  if (more.empty() && tabled_.contains(key)) {
    return arguments.empty() ? fmt::format("t{}", key) : fmt::format("t{}({})", key, list);
  }
  return fmt::format("{}{}({}{}{})", goal.positive ? 'p' : 'n', predicate, list,
                     arguments.empty() ? "" : ",", more.empty() ? "0,[]" : more);
}

std::string BodyWriter::CallAttachment(const logic::Literal& goal,
                                       const std::vector<std::string>& arguments) {
  const std::size_t number = vocabulary_.Of(goal.atom).attachment;
  std::vector<std::string> inputs;
  std::vector<std::string> outputs;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool is_input =
        vocabulary_.attachment(number).signature().arguments[i].mode == sdk::Attachment::Mode::kIn;
    (is_input ? inputs : outputs).push_back(arguments[i]);
  }
  return fmt::format("{}({},[{}],[{}])", goal.positive ? "attached" : "unattached", number,
                     fmt::join(inputs, ","), fmt::join(outputs, ","));
}

}  // namespace latchwork::swipl
