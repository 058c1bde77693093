// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/theory/theory.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "latchwork/logic/arithmetic.h"
#include "latchwork/logic/clausify.h"
#include "reasoners/pttp/theory/equality_axioms.h"

namespace latchwork::pttp {
namespace {

using logic::Clause;
using logic::Diagnostics;
using logic::PredicateName;

/// What could make a literal of each predicate true.
class Definitions {
 public:
  Definitions(const sdk::Body& body, const std::vector<Clause>& clauses,
              logic::SymbolTable& symbols)
      : arithmetic_(symbols), equality_(symbols.Intern("=")) {
    for (const auto& name : body.inputs) defined_.insert(name);
    for (const auto& fact : body.facts) defined_.insert(NameOf(fact));
    for (const auto& minimized : body.minimized) defined_.insert(minimized.predicate);
    for (const auto& attachment : body.attachments) {
      const auto& signature = attachment->signature();
      const PredicateName name{symbols.Intern(signature.predicate), signature.arguments.size()};
      defined_.insert(name);
      attachments_.insert(name);
    }
    for (const Clause& clause : clauses) {
      for (const auto& literal : clause.literals) {
        if (literal.positive) defined_.insert(NameOf(literal.atom));
      }
    }
  }

  bool Contains(const PredicateName& name) const {
    return defined_.contains(name) || name.symbol == equality_ ||
           arithmetic_.FindPredicate(name.symbol, name.arity).has_value();
  }
  /// The arity of the attachment that this name must mean, when its arity is another.
  const PredicateName* AttachmentOfOtherArity(const PredicateName& name) const {
    for (const auto& attachment : attachments_) {
      if (attachment.symbol == name.symbol && attachment.arity != name.arity) return &attachment;
    }
    return nullptr;
  }
  std::string Hint(const PredicateName& name) const {
    std::vector<std::string> names;
    for (const auto& known : defined_) {
      if (known.symbol == name.symbol) {
        return fmt::format("there is {} of another arity: {}", known.symbol.name(),
                           ToString(known));
      }
      names.emplace_back(known.symbol.name());
    }
    const auto nearest = logic::NearestName(name.symbol.name(), names);
    return nearest.empty()
               ? std::string("declare it as an input, or add a clause or fact that states it")
               : fmt::format("did you mean '{}'?", nearest);
  }

 private:
  logic::Arithmetic arithmetic_;
  logic::Symbol equality_;
  std::set<PredicateName> defined_;
  std::set<PredicateName> attachments_;
};

}  // namespace

void Theory::CheckUses(const std::vector<Clause>& clauses, Diagnostics& diagnostics) const {
  const Definitions definitions(*body_, clauses, *symbols_);
  std::set<PredicateName> reported;
  const auto check = [&](const logic::Atom& atom, bool used, const logic::SourcePlace& place,
                         std::string_view where) {
    const PredicateName name = NameOf(atom);
    if (const auto* attachment = definitions.AttachmentOfOtherArity(name)) {
      if (!reported.insert(name).second) return;
      diagnostics.push_back({place,
                             fmt::format("{} {} is used, but the attachment is {}", where,
                                         ToString(name), ToString(*attachment)),
                             "", ""});
    } else if (used && !definitions.Contains(name) && reported.insert(name).second) {
      diagnostics.push_back(
          {place,
           fmt::format("{} {} can never be proved: nothing states it", where, ToString(name)),
           definitions.Hint(name), ""});
    }
  };
  for (const Clause& clause : clauses) {
    for (const auto& literal : clause.literals) {
      check(literal.atom, !literal.positive, clause.place, fmt::format("in '{}':", clause.name));
    }
  }
  for (const sdk::Goal& goal : body_->goals) check(goal.pattern, true, {}, "the goal");
}

Diagnostics Theory::Add(const std::vector<logic::TptpFile>& files) {
  Diagnostics diagnostics;
  std::vector<Clause> clauses = clauses_;
  for (const logic::TptpFile& file : files) {
    diagnostics.insert(diagnostics.end(), file.diagnostics.begin(), file.diagnostics.end());
    for (const auto& formula : file.formulas) {
      if (formula.role == logic::Role::kAxiom) continue;
      diagnostics.push_back({formula.place, fmt::format("'{}' is a conjecture", formula.name),
                             "goals are named in the agent file; a body has axioms only", ""});
    }
    if (!diagnostics.empty()) continue;
    auto added = logic::Clausify(file.formulas, *symbols_);
    clauses.insert(clauses.end(), std::make_move_iterator(added.begin()),
                   std::make_move_iterator(added.end()));
  }
  if (diagnostics.empty()) CheckUses(clauses, diagnostics);
  if (diagnostics.empty()) clauses_ = std::move(clauses);
  return diagnostics;
}

Diagnostics Theory::ReadFiles() {
  std::vector<logic::TptpFile> files;
  for (const auto& path : body_->files) files.push_back(logic::ReadTptpFile(path, *symbols_));
  return Add(files);
}

Diagnostics Theory::Tell(std::string_view text) {
  return Add({logic::ReadTptp(text, "told", *symbols_)});
}

Diagnostics Theory::Retract(std::string_view name) {
  if (std::erase_if(clauses_, [&](const Clause& clause) { return clause.name == name; }) > 0) {
    return {};
  }
  std::vector<std::string> names;
  for (const Clause& clause : clauses_) names.push_back(clause.name);
  const auto nearest = logic::NearestName(name, names);
  return {{{},
           fmt::format("there is no clause named '{}'", name),
           nearest.empty() ? std::string() : fmt::format("did you mean '{}'?", nearest),
           ""}};
}

std::vector<Clause> Theory::Clauses(bool equality_axioms) const {
  std::vector<Clause> clauses = clauses_;
  if (!equality_axioms) return clauses;
  auto axioms = EqualityAxioms(clauses, body_->facts, *symbols_);
  clauses.insert(clauses.end(), std::make_move_iterator(axioms.begin()),
                 std::make_move_iterator(axioms.end()));
  return clauses;
}

}  // namespace latchwork::pttp
