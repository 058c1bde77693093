// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/formats/circ_file.h"

#include <fmt/format.h>

#include <utility>

namespace latchwork::circumscription {
namespace {

class CircReader final : public StatementReader {
 public:
  CircReader(std::string_view text, std::string_view name, std::size_t max_diagnostics)
      : StatementReader(text, name, max_diagnostics) {}

  CircFile Read() {
    ReadLines();
    CheckWhole();
    return {std::move(theory_), std::move(facts_), std::move(queries_), std::move(diagnostics_)};
  }

 private:
  bool IsAnswer(std::string_view key) const override { return key == "=" || key == "x"; }
  void ReadHeader(const Words& words) override {
    const auto numbers = HeaderNumbers(words, "circ", 2);
    if (!numbers || !SetAtoms(words[2], (*numbers)[0])) return;
    announced_ = static_cast<std::size_t>((*numbers)[1]);
  }
  bool ReadOther(const Words& /*words*/) override { return false; }
  std::string_view HeaderForm() const override { return "p circ ATOMS CLAUSES"; }
  std::string_view StatementForms() const override {
    return "statements start with c, p, n, P, Z, Q, F, ?, = or x; clauses with a number";
  }
  void TakeRole(Atom /*atom*/) override {}
  void TakeClause(Clause clause) override { theory_.clauses.push_back(std::move(clause)); }
  void TakeFacts(std::vector<Literal> facts) override {
    facts_.insert(facts_.end(), facts.begin(), facts.end());
  }
  void TakeQuery(Query query, const Words& /*words*/) override {
    queries_.push_back(std::move(query));
  }

  void CheckWhole() {
    if (!diagnostics_.empty()) return;
    if (theory_.clauses.size() != announced_) {
      Error(0, fmt::format("the header announces {} clauses, but there are {}", announced_,
                           theory_.clauses.size()));
    }
    CheckRoles();
  }

  std::vector<Literal> facts_;
  std::vector<Query> queries_;
  std::size_t announced_ = 0;  ///< Clauses.
};

}  // namespace

CircFile ReadCirc(std::string_view text, std::string_view name, std::size_t max_diagnostics) {
  return CircReader(text, name, max_diagnostics).Read();
}

std::vector<Literal> MoveFacts(std::span<const Literal> facts, GroundTheory& theory) {
  std::vector<Literal> latches;
  for (const Literal fact : facts) {
    if (theory.at(AtomOf(fact)).role == Role::kFixed) {
      latches.push_back(fact);
    } else {
      theory.clauses.push_back({fact});
    }
  }
  return latches;
}

}  // namespace latchwork::circumscription
