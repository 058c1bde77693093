// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/diff_theory.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include "latchwork/logic/tptp.h"

namespace latchwork::app {
namespace {

constexpr std::string_view kInconsistent = "inconsistent";

/// Every predicate may be a latch's, so that what was shrunk away is no error.
sdk::Body BodyOf(const DiffTheory& theory, const std::filesystem::path& file) {
  sdk::Body body = theory.body;
  body.language = "tptp";
  body.files = {file};
  std::set<logic::PredicateName> inputs(body.inputs.begin(), body.inputs.end());
  std::set<logic::PredicateName> computed;
  for (const auto& attachment : body.attachments) {
    for (const auto& clause : theory.clauses) {
      for (const auto& literal : clause.literals) {
        if (literal.atom.predicate().name() == attachment->signature().predicate) {
          computed.insert(NameOf(literal.atom));
        }
      }
    }
  }
  const auto add = [&](const logic::PredicateName& name) {
    const bool is_interpreted = name.symbol.name().starts_with('$') || name.symbol.name() == "=";
    if (!is_interpreted && !computed.contains(name)) inputs.insert(name);
  };
  for (const auto& clause : theory.clauses) {
    for (const auto& literal : clause.literals) add(NameOf(literal.atom));
  }
  for (const auto& latch : theory.latches) {
    for (const auto& fact : latch.facts) add(NameOf(fact));
  }
  for (const auto& goal : body.goals) add(NameOf(goal.pattern));
  body.inputs.assign(inputs.begin(), inputs.end());
  return body;
}

}  // namespace

Verdict Understand(const sdk::Decision& decision, const sdk::Body& body) {
  Verdict verdict;
  verdict.remark = decision.message;
  verdict.kind =
      decision.status == sdk::Status::kFailed ? Verdict::Kind::kRefused : Verdict::Kind::kDecided;
  if (decision.status == sdk::Status::kUnknown || decision.limit != sdk::Limit::kNone) {
    verdict.kind = Verdict::Kind::kExhausted;
    if (verdict.remark.empty()) verdict.remark = sdk::Name(decision.limit);
  }
  if (decision.status == sdk::Status::kInconsistent) {
    verdict.conclusions.insert(std::string(kInconsistent));
    return verdict;
  }
  for (const auto& conclusion : decision.conclusions) {
    const sdk::Goal& goal = body.goals.at(conclusion.goal);
    const bool all = goal.answers == sdk::Goal::Answers::kAll;
    verdict.conclusions.insert(ToString(all ? conclusion.fact : goal.pattern));
  }
  const bool by_bound = std::ranges::any_of(decision.assumptions, [](const auto& assumption) {
    return assumption.state == sdk::Assumption::State::kMadeByBound;
  });
  if (by_bound && verdict.kind == Verdict::Kind::kDecided) {
    verdict.kind = Verdict::Kind::kExhausted;
    verdict.remark = "a default was made by the bound";
  }
  return verdict;
}

Verdict Judge(const Contender& contender, const DiffTheory& theory, logic::SymbolTable& symbols,
              const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "theory.p";
  std::ofstream stream(file, std::ios::binary);
  for (const logic::Clause& clause : theory.clauses) stream << logic::WriteTptp(clause);
  stream.close();
  const auto reasoner = contender.make();
  logic::Diagnostics diagnostics;
  const auto parameters = sdk::Parameters::Check(reasoner->parameters(), contender.given,
                                                 contender.name, {}, diagnostics);
  if (diagnostics.empty()) diagnostics = reasoner->Load(BodyOf(theory, file), parameters, symbols);
  if (!diagnostics.empty()) {
    return {Verdict::Kind::kRefused, {}, Format(diagnostics)};
  }
  sdk::Decision decision;
  reasoner->Decide(theory.latches, theory.budget, decision);
  return Understand(decision, theory.body);
}

bool Disagree(const Verdict& a, const Verdict& b) {
  return a.kind == Verdict::Kind::kDecided && b.kind == Verdict::Kind::kDecided &&
         a.conclusions != b.conclusions;
}

std::string TheoryText(const DiffTheory& theory, const Verdict& a, const Verdict& b) {
  std::string text;
  for (const logic::Clause& clause : theory.clauses) text += logic::WriteTptp(clause);
  const auto add_facts = [&](std::span<const logic::Fact> facts) {
    for (const auto& fact : facts) text += fmt::format("cnf(given, axiom, {}).\n", ToString(fact));
  };
  add_facts(theory.body.facts);
  for (const auto& latch : theory.latches) add_facts(latch.facts);
  for (const auto& minimized : theory.body.minimized) {
    text += fmt::format("% minimized: {}\n", ToString(minimized.predicate));
  }
  std::vector<std::string> disputed;
  std::ranges::set_symmetric_difference(a.conclusions, b.conclusions, std::back_inserter(disputed));
  std::erase(disputed, kInconsistent);
  if (!disputed.empty()) {
    const std::string& first = disputed.front();
    std::string variables;
    for (const sdk::Goal& goal : theory.body.goals) {
      if (ToString(goal.pattern) != first) continue;
      for (std::size_t i = 0; i < goal.variables; ++i) {
        variables += fmt::format("{}X{}", i == 0 ? "" : ", ", i);
      }
    }
    text += variables.empty()
                ? fmt::format("fof(disputed, conjecture, {}).\n", first)
                : fmt::format("fof(disputed, conjecture, ? [{}] : {}).\n", variables, first);
  }
  return text;
}

}  // namespace latchwork::app
