// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/swipl/rule_writer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace latchwork::swipl {
namespace {

using Kind = Vocabulary::Kind;

bool IsNegative(const logic::Clause& clause) {
  return std::ranges::none_of(clause.literals,
                              [](const logic::Literal& literal) { return literal.positive; });
}

std::vector<logic::Literal> Complements(const std::vector<logic::Literal>& literals) {
  std::vector<logic::Literal> complements = literals;
  for (logic::Literal& literal : complements) literal.positive = !literal.positive;
  return complements;
}

}  // namespace

RuleWriter::RuleWriter(const sdk::Body& body, const std::vector<logic::Clause>& clauses,
                       Names& names, logic::SymbolTable& symbols, bool unique_names)
    : body_(body),
      clauses_(clauses),
      names_(names),
      vocabulary_(body, names, symbols),
      rules_(RulesOf(clauses, names, vocabulary_, facts_)),
      graph_(MakeGraph(clauses)),
      writer_(names, vocabulary_, graph_, unique_names),
      tabled_(FindTabled()),
      unique_names_(unique_names) {
  writer_.SetTabled(tabled_);
}

std::vector<RuleWriter::Rule> RuleWriter::RulesOf(
    const std::vector<logic::Clause>& clauses, Names& names, Vocabulary& vocabulary,
    std::map<std::size_t, std::vector<logic::Fact>>& facts) {
  std::vector<Rule> rules;
  for (const logic::Clause& clause : clauses) {
    for (std::size_t head = 0; head < clause.literals.size(); ++head) {
      const logic::Literal& literal = clause.literals[head];
      const Kind kind = vocabulary.Of(literal.atom).kind;
      const std::size_t predicate = names.Predicate(NameOf(literal.atom));
      if (kind != Kind::kOrdinary && kind != Kind::kEquality) continue;
      Rule rule{SignedOf(predicate, literal.positive), literal.atom, {}, clause.name};
      for (std::size_t i = 0; i < clause.literals.size(); ++i) {
        if (i == head) continue;
        rule.body.push_back(clause.literals[i]);
        rule.body.back().positive = !clause.literals[i].positive;
      }
      auto next = static_cast<logic::Variable>(clause.variable_names.size());
      std::vector<logic::Term> arguments(literal.atom.arguments().begin(),
                                         literal.atom.arguments().end());
      for (logic::Term& argument : arguments) {
        if (!vocabulary.HasArithmetic(argument)) continue;
        const logic::Term variable = logic::Term::Var(next++);
        rule.body.push_back(
            {true, {vocabulary.equality().symbol, {variable, std::exchange(argument, variable)}}});
      }
      rule.pattern = logic::Atom(literal.atom.predicate(), arguments);
      const bool is_fact = rule.body.empty() && literal.positive && kind == Kind::kOrdinary &&
                           rule.pattern.is_ground();
      if (is_fact) {
        facts[predicate].push_back(rule.pattern);
      } else {
        rules.push_back(std::move(rule));
      }
    }
  }
  std::ranges::stable_partition(rules, [](const Rule& rule) { return rule.body.empty(); });
  return rules;
}

SignedGraph RuleWriter::MakeGraph(const std::vector<logic::Clause>& clauses) {
  const std::size_t equality = names_.Predicate(vocabulary_.equality());
  for (const auto& goal : body_.goals) names_.Predicate(NameOf(goal.pattern));
  for (const auto& input : body_.inputs) names_.Predicate(input);
  for (const auto& fact : body_.facts) facts_[names_.Predicate(NameOf(fact))].push_back(fact);
  for (const auto& clause : clauses) {
    for (const auto& literal : clause.literals) names_.Predicate(NameOf(literal.atom));
  }
  std::vector<SignedGraph::Rule> rules;
  for (const Rule& rule : rules_) {
    SignedGraph::Rule& edge = rules.emplace_back();
    edge.head = rule.head;
    for (const auto& literal : rule.body) {
      edge.body.push_back(SignedOf(names_.Predicate(NameOf(literal.atom)), literal.positive));
    }
  }
  std::vector<SignedGraph::Predicate> predicates(2 * names_.size());
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const Vocabulary::Info& info = vocabulary_[i];
    const bool is_computed = info.kind != Kind::kOrdinary;
    SignedGraph::Predicate& denial = predicates[SignedOf(i, false)];
    SignedGraph::Predicate& atom = predicates[SignedOf(i, true)];
    atom.is_root = info.kind != Kind::kArithmetic;
    denial.is_root = info.is_input;
    denial.is_given = is_computed || info.minimized;
    atom.is_given = is_computed || info.is_input || facts_.contains(i) || i == equality;
  }
  return {std::move(rules), std::move(predicates)};
}

std::set<Signed> RuleWriter::FindTabled() {
  const Signed count = 2 * names_.size();
  std::vector<bool> is_plain(count);
  for (Signed key = 0; key < count; ++key) {
    const Vocabulary::Info& info = vocabulary_[key / 2];
    is_plain[key] = info.kind == Kind::kOrdinary && (key % 2 == 1 || !info.minimized);
  }
  for (std::size_t i = 0; i < rules_.size(); ++i) {
    const Rule& rule = rules_[i];
    if (!graph_.is_alive(i)) continue;
    bool plain = writer_.IsPlain({rule.head % 2 == 1, rule.pattern});
    for (const auto& goal : rule.body) plain = plain && writer_.IsPlain(goal);
    is_plain[rule.head] = is_plain[rule.head] && plain;
  }
  std::set<Signed> tabled;
  for (Signed key = 0; key < count; ++key) {
    bool plain = graph_.IsDeep(key) && graph_.IsIndependent(key) && is_plain[key];
    const std::vector<bool> below = graph_.Below(key);
    for (Signed other = 0; other < count; ++other) {
      plain = plain && (!below[other] || is_plain[other]);
    }
    if (plain) tabled.insert(key);
  }
  return tabled;
}

RuleWriter::Wrap RuleWriter::WrapOf(Signed key) const {
  if (tabled_.contains(key)) return Wrap::kTable;
  if (graph_.IsDeep(key) && graph_.IsIndependent(key)) return Wrap::kMemo;
  return graph_.IsDeep(key) || graph_.Meets(ComplementOf(key)) ? Wrap::kAncestors : Wrap::kNone;
}

std::string RuleWriter::NameOfClauses(Signed key) const {
  if (WrapOf(key) == Wrap::kTable) return fmt::format("t{}", key);
  return fmt::format("{}{}{}", key % 2 == 0 ? 'n' : 'p', key / 2,
                     WrapOf(key) == Wrap::kNone ? "" : "s");
}

std::string RuleWriter::Blanks(Signed key) const {
  std::vector<std::string> blanks;
  for (std::size_t i = 0; i < names_.predicate(key / 2).arity; ++i) {
    blanks.push_back(fmt::format("X{}", i));
  }
  return fmt::format("{}", fmt::join(blanks, ","));
}

void RuleWriter::WriteWrapper(Signed key, Wrap wrap) {
  if (wrap == Wrap::kNone) return;
  const std::string blanks = Blanks(key);
  const std::string comma = blanks.empty() ? "" : ",";
  const std::string name = fmt::format("{}{}", key % 2 == 0 ? 'n' : 'p', key / 2);
  const std::string atom = blanks.empty() ? name : fmt::format("{}({})", name, blanks);
  rendering_.program += fmt::format("{}({}{}D,Up):-", name, blanks, comma);
  rendering_.program +=
      wrap == Wrap::kMemo
          ? fmt::format("memo({},{}({}{}D,{}),D).\n", atom, NameOfClauses(key), blanks, comma, atom)
          : fmt::format("regular({},Up),{}({}{}D,[{}|Up]).\n", atom, NameOfClauses(key), blanks,
                        comma, atom);
}

void RuleWriter::WriteClause(Signed key, std::string_view arguments, std::string_view body,
                             std::string source) {
  Rendering::Clauses& clauses = rendering_.clauses[key];
  clauses.name = NameOfClauses(key);
  clauses.sources.push_back(std::move(source));
  rendering_.program += fmt::format("{}({}) :- {}.\n", clauses.name, arguments, body);
}

void RuleWriter::WriteRule(const Rule& rule, Wrap wrap) {
  std::string arguments;
  Variables bound;
  for (const logic::Term& argument : rule.pattern.arguments()) {
    names_.Write(argument, arguments);
    arguments += ',';
    AddVariables(argument, bound);
  }
  if (rule.body.empty()) return WriteClause(rule.head, arguments + "_,_", "true", rule.source);
  const bool deepens = graph_.IsDeep(rule.head);
  const std::string more =
      fmt::format("{},{}", deepens ? "E" : "D", wrap == Wrap::kMemo ? "[]" : "Up");
  const std::string body = writer_.Write(rule.body, bound, more);
  WriteClause(rule.head, arguments + "D,Up", (deepens ? "D>0,E is D-1," : "") + body, rule.source);
}

/// Where a rule could be used if there were more depth.
void RuleWriter::WriteCut(Signed key, Wrap wrap) {
  if (!graph_.IsDeep(key)) return;
  const std::string blanks = Blanks(key);
  const std::string comma = blanks.empty() ? "" : ",";
  const std::string heads = fmt::format("h{}", NameOfClauses(key));
  for (std::size_t i = 0; i < rules_.size(); ++i) {
    if (rules_[i].head != key || rules_[i].body.empty() || !graph_.is_alive(i)) continue;
    std::string arguments;
    for (const logic::Term& argument : rules_[i].pattern.arguments()) {
      if (!arguments.empty()) arguments += ',';
      names_.Write(argument, arguments);
    }
    rendering_.program += heads + (arguments.empty() ? "" : fmt::format("({})", arguments)) + ".\n";
  }
  WriteClause(
      key, fmt::format("{}{}0,Up", blanks, comma),
      fmt::format("\\+ \\+ {}{},{},fail", heads, blanks.empty() ? "" : fmt::format("({})", blanks),
                  wrap == Wrap::kMemo ? "cut_off(Up)" : "cut_off"),
      "");
}

void RuleWriter::WriteEquality(Signed key) {
  if (key % 2 == 1) return WriteClause(key, "X0,X0,_,_", "true", "");
  WriteClause(key, "X0,X1,_,_",
              fmt::format("ground(X0),ground(X1),differ({},X0,X1)", unique_names_), "");
}

/// `t7(X0) :- ...` without depth and ancestors, and p3(X0,D,Up), which looks answers up.
void RuleWriter::WriteTable(Signed key) {
  const std::string blanks = Blanks(key);
  const auto with = [](std::string_view arguments) {
    return arguments.empty() ? std::string() : fmt::format("({})", arguments);
  };
  const std::string name = NameOfClauses(key);
  const char prefix = key % 2 == 0 ? 'n' : 'p';
  std::string& program = rendering_.program;
  program += fmt::format("tabled({}/{}).\n", name, names_.predicate(key / 2).arity);
  program += fmt::format("{}{}({}{}D,Up) :- answers({}{}).\n", prefix, key / 2, blanks,
                         blanks.empty() ? "" : ",", name, with(blanks));
  if (prefix == 'p')
    program += fmt::format("{}{} :- f{}{}.\n", name, with(blanks), key / 2, with(blanks));
  for (std::size_t i = 0; i < rules_.size(); ++i) {
    if (rules_[i].head != key || !graph_.is_alive(i)) continue;
    std::string arguments;
    Variables bound;
    for (const logic::Term& argument : rules_[i].pattern.arguments()) {
      if (!arguments.empty()) arguments += ',';
      names_.Write(argument, arguments);
      AddVariables(argument, bound);
    }
    program += fmt::format("{}{} :- {}.\n", name, with(arguments),
                           writer_.Write(rules_[i].body, bound, ""));
    rendering_.clauses[key].sources.push_back(rules_[i].source);
  }
  rendering_.clauses[key].name = name;
}

void RuleWriter::WritePredicate(Signed key) {
  const Vocabulary::Info& info = vocabulary_[key / 2];
  if (info.kind == Kind::kArithmetic || info.kind == Kind::kAttachment) return;
  const Wrap wrap = WrapOf(key);
  if (wrap == Wrap::kTable) return WriteTable(key);
  const std::string blanks = Blanks(key);
  const std::string comma = blanks.empty() ? "" : ",";
  const auto atom = [&](char prefix, std::string_view more = "") {
    const std::string arguments =
        blanks + (blanks.empty() || more.empty() ? "" : ",") + std::string(more);
    return fmt::format("{}{}", prefix, key / 2) +
           (arguments.empty() ? "" : fmt::format("({})", arguments));
  };
  WriteWrapper(key, wrap);
  if (info.kind == Kind::kEquality) WriteEquality(key);
  if (graph_.Meets(key)) {
    WriteClause(key, blanks + comma + "_,Up",
                fmt::format("member({},Up)", atom(key % 2 == 0 ? 'p' : 'n')), "");
  }
  const bool has_facts = info.kind == Kind::kOrdinary && key % 2 == 1;
  if (has_facts) WriteClause(key, blanks + comma + "_,_", atom('f'), "");
  for (std::size_t i = 0; i < rules_.size(); ++i) {
    if (rules_[i].head == key && graph_.is_alive(i)) WriteRule(rules_[i], wrap);
  }
  if (key % 2 == 0 && info.minimized) {
    WriteClause(key, blanks + comma + "_,_",
                fmt::format("close({},{},D,{})", atom('p'), *info.minimized, atom('p', "D,[]")),
                "");
  }
  WriteCut(key, wrap);
}

std::string RuleWriter::Query(const std::vector<logic::Literal>& goals) {
  return writer_.Write(goals, {}, "D,[]");
}

void RuleWriter::WriteStarts() {
  for (std::size_t i = 0; i < body_.goals.size(); ++i) {
    const sdk::Goal& goal = body_.goals[i];
    std::string atom;
    names_.Write("p", goal.pattern, atom);
    rendering_.program +=
        fmt::format("goal({},{},{},D,({})).\n", i, goal.answers == sdk::Goal::Answers::kAll, atom,
                    Query({{true, goal.pattern}}));
  }
  for (const logic::Clause& clause : clauses_) {
    if (!IsNegative(clause)) continue;
    rendering_.program += fmt::format("denial({},D,({})).\n", rendering_.denials.size(),
                                      Query(Complements(clause.literals)));
    rendering_.denials.push_back(clause.name);
  }
}

Rendering RuleWriter::Write() {
  for (Signed key = 0; key < 2 * names_.size(); ++key) WritePredicate(key);
  WriteStarts();
  rendering_.facts = facts_;
  return std::move(rendering_);
}

}  // namespace latchwork::swipl
