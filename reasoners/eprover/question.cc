// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/eprover/question.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <utility>

#include "core/process/child_process.h"
#include "latchwork/logic/tptp.h"
#include "reasoners/eprover/disguise.h"

namespace latchwork::eprover {
namespace {

using End = Reply::End;

void AddVariables(const logic::Term& term, std::set<logic::Variable>& variables) {
  if (term.is_variable()) variables.insert(term.variable());
  for (const logic::Term& argument : term.arguments()) AddVariables(argument, variables);
}

/// `fof(q, question, ? [X0] : p(X0)).`; its variables in the order of an answer.
std::string QuestionFor(const logic::Atom& pattern, std::vector<logic::Variable>& order,
                        logic::SymbolTable& symbols) {
  std::set<logic::Variable> variables;
  for (const logic::Term& argument : pattern.arguments()) AddVariables(argument, variables);
  order.assign(variables.begin(), variables.end());
  const std::string text = ToString(Disguise(pattern, symbols));
  if (order.empty()) return fmt::format("fof(q, conjecture, {}).\n", text);
  std::string list;
  for (const logic::Variable variable : order) {
    list += fmt::format("{}X{}", list.empty() ? "" : ", ", variable);
  }
  return fmt::format("fof(q, question, ? [{}] : {}).\n", list, text);
}

logic::Term Substitute(const logic::Term& term, const std::vector<logic::Variable>& order,
                       std::span<const logic::Term> values) {
  if (term.is_variable()) {
    const auto place = std::ranges::find(order, term.variable()) - order.begin();
    return values[static_cast<std::size_t>(place)];
  }
  if (term.arguments().empty()) return term;
  std::vector<logic::Term> arguments;
  for (const logic::Term& argument : term.arguments()) {
    arguments.push_back(Substitute(argument, order, values));
  }
  return logic::Term::Compound(term.symbol(), std::move(arguments));
}

/// `[[a, f(b)]|_]` to an instance of the pattern; nothing for `[([a]|[b])|_]`.
std::optional<logic::Atom> InstanceOf(std::string_view tuple, const logic::Atom& pattern,
                                      const std::vector<logic::Variable>& order,
                                      logic::SymbolTable& symbols) {
  if (!tuple.starts_with("[[") || !tuple.ends_with("]|_]")) return std::nullopt;
  tuple.remove_prefix(2);
  tuple.remove_suffix(4);
  const auto read = logic::ReadTptpAtom(fmt::format("answer({})", tuple), "E", symbols);
  if (!read.atom || read.atom->arity() != order.size()) return std::nullopt;
  std::vector<logic::Term> arguments;
  for (const logic::Term& argument : pattern.arguments()) {
    arguments.push_back(Undisguise(Substitute(argument, order, read.atom->arguments())));
  }
  return logic::Atom(pattern.predicate(), arguments);
}

/// What stands after `before` in its line, if anything does.
std::optional<std::string_view> After(std::string_view text, std::string_view before) {
  const std::size_t found = text.find(before);
  if (found == std::string_view::npos) return std::nullopt;
  text.remove_prefix(found + before.size());
  return text.substr(0, text.find('\n'));
}

std::uint64_t Processed(std::string_view output) {
  auto text = After(output, "# Processed clauses").value_or("");
  text.remove_prefix(std::min(text.size(), text.find_last_of(' ') + 1));
  std::uint64_t count = 0;
  std::from_chars(text.data(), text.data() + text.size(), count);
  return count;
}

void ReadAnswers(std::string_view output, const logic::Atom& pattern,
                 const std::vector<logic::Variable>& order, logic::SymbolTable& symbols,
                 Reply& reply) {
  constexpr std::string_view kTuple = "# SZS answers Tuple ";
  for (auto line = After(output, kTuple); line; line = After(output, kTuple)) {
    if (auto instance = InstanceOf(*line, pattern, order, symbols)) {
      reply.answers.push_back(*std::move(instance));
    }
    output.remove_prefix(static_cast<std::size_t>(line->data() - output.data()));
  }
}

void ReadEnd(std::string_view output, std::size_t wanted, const QuestionLimits& limits,
             Reply& reply) {
  const std::string_view status = After(output, "# SZS status ").value_or("");
  reply.processed = Processed(output);
  if (status == "ContradictoryAxioms" || status == "Unsatisfiable") {
    reply.end = End::kContradiction;
  } else if (reply.answers.size() >= wanted) {
    reply.end = End::kFound;
  } else if (status == "ResourceOut" || reply.processed >= limits.clauses) {
    reply.end = After(output, "User resource limit").has_value() || status.empty() ||
                        reply.processed >= limits.clauses
                    ? End::kClauses
                    : End::kTime;
  } else if (status == "CounterSatisfiable" || status == "Satisfiable" || status == "Theorem") {
    reply.end = End::kSaturated;
  } else {
    reply.problem = fmt::format("E said: {}", status.empty() ? "nothing" : status);
  }
}

}  // namespace

Reply Ask(const std::filesystem::path& program, std::string_view axioms, const logic::Atom* pattern,
          std::size_t answers, const QuestionLimits& limits, logic::SymbolTable& symbols) {
  std::string problem(axioms);
  std::vector<logic::Variable> order;
  if (pattern != nullptr) problem += QuestionFor(*pattern, order, symbols);
  const bool is_open = !order.empty();
  process::Limits outer{limits.seconds, limits.memory_mb};
  if (limits.deadline) {
    const std::chrono::duration<double> left = *limits.deadline - std::chrono::steady_clock::now();
    outer.wall_seconds = std::clamp(left.count(), 0.0, outer.wall_seconds);
  }
  static const std::atomic<bool> kNever = false;
  std::vector<std::string> arguments = {"--silent",
                                        "--satauto",
                                        "--tstp-in",
                                        "--print-statistics",
                                        fmt::format("--processed-clauses-limit={}", limits.clauses),
                                        fmt::format("--answers={}", is_open ? answers : 1),
                                        "-"};
  const process::ChildResult child = process::RunChild(
      program, arguments, outer, limits.cancelled == nullptr ? kNever : *limits.cancelled, problem);
  Reply reply;
  using ChildEnd = process::ChildResult::End;
  if (child.end == ChildEnd::kTimedOut || child.end == ChildEnd::kStopped) {
    reply.end = child.end == ChildEnd::kTimedOut ? End::kTime : End::kCancelled;
    return reply;
  }
  if (is_open) ReadAnswers(child.output, *pattern, order, symbols, reply);
  const bool is_proved = After(child.output, "# SZS status ").value_or("") == "Theorem";
  if (pattern != nullptr && !is_open && is_proved) reply.answers.push_back(*pattern);
  ReadEnd(child.output, pattern == nullptr ? 1 : answers, limits, reply);
  if (reply.end == End::kFailed) reply.problem += "; " + child.errors.substr(0, 200);
  return reply;
}

}  // namespace latchwork::eprover
