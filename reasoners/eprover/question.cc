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
std::string QuestionFor(const logic::Atom& pattern, std::vector<logic::Variable>& order) {
  std::set<logic::Variable> variables;
  for (const logic::Term& argument : pattern.arguments()) AddVariables(argument, variables);
  order.assign(variables.begin(), variables.end());
  const std::string text = Disguise(ToString(pattern));
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
  const auto read = logic::ReadTptpAtom(fmt::format("answer({})", Undisguise(tuple)), "E", symbols);
  if (!read.atom || read.atom->arity() != order.size()) return std::nullopt;
  std::vector<logic::Term> arguments;
  for (const logic::Term& argument : pattern.arguments()) {
    arguments.push_back(Substitute(argument, order, read.atom->arguments()));
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

/// Returns how many there were, with those that are none of ours.
std::size_t ReadAnswers(std::string_view output, const logic::Atom& pattern,
                        const std::vector<logic::Variable>& order, logic::SymbolTable& symbols,
                        Reply& reply) {
  constexpr std::string_view kTuple = "# SZS answers Tuple ";
  std::size_t count = 0;
  for (auto line = After(output, kTuple); line; line = After(output, kTuple)) {
    if (auto instance = InstanceOf(*line, pattern, order, symbols)) {
      reply.answers.push_back(*std::move(instance));
    }
    output.remove_prefix(static_cast<std::size_t>(line->data() - output.data()));
    ++count;
  }
  return count;
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

/// What goes on the command line, without how many answers there are to be.
std::vector<std::string> ArgumentsFor(const QuestionLimits& limits) {
  std::vector<std::string> arguments = {
      "--silent", "--tstp-in", "--print-statistics",
      fmt::format("--processed-clauses-limit={}", limits.clauses)};
  if (limits.heuristic == kAutomatic) {
    arguments.emplace_back("--satauto");
  } else {
    // What --satauto stands for, with the other heuristic.
    arguments.insert(arguments.end(), {"-x", limits.heuristic, "-tAuto"});
  }
  return arguments;
}

/// A question in E's words.
struct Question {
  const std::filesystem::path& program;
  std::string problem;
  const logic::Atom* pattern;
  std::vector<logic::Variable> order;
};

/// One run of E. `is_cut_short`: it gave as many answers as it was to, and fewer were definite.
Reply Run(const Question& question, std::size_t wanted, std::size_t asked,
          const QuestionLimits& limits, logic::SymbolTable& symbols, bool& is_cut_short) {
  process::Limits outer{limits.seconds, limits.memory_mb};
  const std::chrono::duration<double> left = *limits.deadline - std::chrono::steady_clock::now();
  outer.wall_seconds = std::clamp(left.count(), 0.0, outer.wall_seconds);
  static const std::atomic<bool> never = false;
  std::vector<std::string> arguments = ArgumentsFor(limits);
  arguments.insert(arguments.end(), {fmt::format("--answers={}", asked), "-"});
  const process::ChildResult child =
      process::RunChild(question.program, arguments, outer,
                        limits.cancelled == nullptr ? never : *limits.cancelled, question.problem);
  Reply reply;
  is_cut_short = false;
  using ChildEnd = process::ChildResult::End;
  if (child.end == ChildEnd::kTimedOut || child.end == ChildEnd::kStopped) {
    reply.end = child.end == ChildEnd::kTimedOut ? End::kTime : End::kCancelled;
    return reply;
  }
  const bool is_proved = After(child.output, "# SZS status ").value_or("") == "Theorem";
  if (!question.order.empty()) {
    const std::size_t count =
        ReadAnswers(child.output, *question.pattern, question.order, symbols, reply);
    is_cut_short = count >= asked && reply.answers.size() < wanted;
  } else if (question.pattern != nullptr && is_proved) {
    reply.answers.push_back(*question.pattern);
  }
  ReadEnd(child.output, wanted, limits, reply);
  if (reply.end == End::kFailed) reply.problem += "; " + child.errors.substr(0, 200);
  is_cut_short = is_cut_short && reply.end == End::kSaturated;
  return reply;
}

}  // namespace

Reply Ask(const std::filesystem::path& program, std::string_view axioms, const logic::Atom* pattern,
          std::size_t answers, const QuestionLimits& limits, logic::SymbolTable& symbols) {
  constexpr std::size_t kMostAsked = 4096;
  Question question{program, std::string(axioms), pattern, {}};
  if (pattern != nullptr) question.problem += QuestionFor(*pattern, question.order);
  QuestionLimits together = limits;
  using Clock = std::chrono::steady_clock;
  const auto own = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(limits.seconds));
  together.deadline = std::min(own, limits.deadline.value_or(own));
  const std::size_t wanted = question.order.empty() ? 1 : answers;
  std::uint64_t processed = 0;
  for (std::size_t asked = wanted;; asked *= 2) {
    bool is_cut_short = false;
    Reply reply = Run(question, wanted, asked, together, symbols, is_cut_short);
    processed += reply.processed;
    reply.processed = processed;
    if (!is_cut_short) return reply;
    if (asked >= kMostAsked) {
      reply.end = End::kClauses;
      return reply;
    }
  }
}

}  // namespace latchwork::eprover
