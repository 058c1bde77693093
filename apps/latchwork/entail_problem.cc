// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/entail_problem.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "apps/latchwork/input_text.h"
#include "reasoners/circumscription/grounding/tptp_problem.h"

namespace latchwork::app {
namespace {

namespace circ = latchwork::circumscription;

EntailProblem Refused(const std::string& file, std::string message, std::string hint = "") {
  EntailProblem problem;
  problem.diagnostics.push_back({{file, 0, 0}, std::move(message), std::move(hint), ""});
  return problem;
}

EntailProblem ReadCircProblem(const std::string& text, const std::string& name) {
  EntailProblem problem;
  circ::CircFile file = circ::ReadCirc(text, name);
  problem.theory = std::move(file.theory);
  problem.queries = std::move(file.queries);
  problem.diagnostics = std::move(file.diagnostics);
  if (problem.diagnostics.empty()) problem.latches = circ::MoveFacts(file.facts, problem.theory);
  return problem;
}

/// Whether a line begins with `p circ`, as no TPTP formula does.
bool IsCirc(const std::string& text) {
  return text.starts_with("p circ") || text.find("\np circ") != std::string::npos;
}

std::vector<std::string_view> SplitList(std::string_view list) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    if (end > at) parts.push_back(list.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

/// Gives predicates their roles; every name must occur in the problem, once in all options.
class RoleReader {
 public:
  explicit RoleReader(const std::vector<logic::PredicateName>& predicates) {
    for (const logic::PredicateName& name : predicates) {
      names_.push_back(ToString(name));
      predicates_.push_back(name);
    }
    taken_.resize(names_.size(), false);
  }

  void Add(std::string_view option, const std::string& list,
           std::map<logic::PredicateName, int>* roles, int level) {
    for (const std::string_view part : SplitList(list)) {
      const auto place = std::find(names_.begin(), names_.end(), part);
      const auto index = static_cast<std::size_t>(place - names_.begin());
      if (place == names_.end()) {
        const std::string_view nearest = logic::NearestName(part, names_);
        Refuse(option, fmt::format("there is no predicate '{}'", part),
               nearest.empty() ? "predicates are written NAME/ARITY"
                               : fmt::format("did you mean '{}'?", nearest));
      } else if (taken_[index]) {
        Refuse(option, fmt::format("'{}' is named twice", part),
               "a predicate is minimized, fixed, or varies");
      } else {
        taken_[index] = true;
        if (roles != nullptr) (*roles)[predicates_[index]] = level;
      }
    }
  }
  logic::Diagnostics& diagnostics() { return diagnostics_; }

 private:
  void Refuse(std::string_view option, std::string message, std::string hint) {
    diagnostics_.push_back({{std::string(option), 0, 0}, std::move(message), std::move(hint), ""});
  }

  std::vector<std::string> names_;
  std::vector<logic::PredicateName> predicates_;
  std::vector<bool> taken_;
  logic::Diagnostics diagnostics_;
};

/// A place in a query as it was written: what wraps the query is nothing that a person knows.
void MoveInto(const std::string& query, logic::Diagnostic& diagnostic) {
  const auto lines = static_cast<std::uint32_t>(std::count(query.begin(), query.end(), '\n') + 1);
  logic::SourcePlace& place = diagnostic.place;
  if (place.line <= 1) return;
  if (--place.line <= lines) return;
  const std::string last = query.substr(query.rfind('\n') + 1);
  place.line = lines;
  place.column = static_cast<std::uint32_t>(last.size() + 1);
  diagnostic.excerpt = last;
  diagnostic.message = "the formula ends too early, or has a bracket too many";
}

/// Says which predicates of a query the theory does not have.
void CheckPredicates(const logic::TptpFile& query, const std::vector<logic::PredicateName>& known,
                     const std::string& option, logic::Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const logic::PredicateName& name : known) names.push_back(ToString(name));
  for (const logic::PredicateName& asked : circ::PredicatesOf(query.formulas)) {
    const std::string name = ToString(asked);
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string_view nearest = logic::NearestName(name, names);
    diagnostics.push_back({{option, 0, 0},
                           fmt::format("there is no predicate '{}' in the theory", name),
                           nearest.empty() ? fmt::format("it has {}", fmt::join(names, ", "))
                                           : fmt::format("did you mean '{}'?", nearest),
                           ""});
  }
}

/// Adds the formulas of --query as conjectures q1, q2, ...
void AddQueries(const EntailInput& input, logic::SymbolTable& symbols, logic::TptpFile& file) {
  const std::vector<logic::PredicateName> known = circ::PredicatesOf(file.formulas);
  for (std::size_t i = 0; i < input.queries.size(); ++i) {
    // The formula has a line of its own, so that its columns are the ones that were written.
    const std::string text = fmt::format("fof(q{},conjecture,(\n{}\n)).", i + 1, input.queries[i]);
    const std::string option = fmt::format("--query {}", i + 1);
    logic::TptpFile query = logic::ReadTptp(text, option, symbols);
    CheckPredicates(query, known, option, file.diagnostics);
    for (logic::Diagnostic& diagnostic : query.diagnostics) {
      MoveInto(input.queries[i], diagnostic);
      file.diagnostics.push_back(std::move(diagnostic));
    }
    for (logic::AnnotatedFormula& formula : query.formulas) {
      file.formulas.push_back(std::move(formula));
    }
  }
}

EntailProblem ReadTptpProblem(const EntailInput& input, const std::string* text) {
  logic::SymbolTable symbols;
  logic::TptpFile file = Read(input.input, symbols, Keep::kNothing, text);
  if (file.diagnostics.empty() && file.formulas.empty()) {
    return Refused(input.input.file, "there is no formula to reason from",
                   "a TPTP problem reads fof(name, axiom, ...).; a .circ file begins with 'p circ "
                   "ATOMS CLAUSES'");
  }
  AddQueries(input, symbols, file);
  EntailProblem problem;
  problem.diagnostics = std::move(file.diagnostics);
  if (!problem.diagnostics.empty()) return problem;
  circ::PredicateRoles roles;
  RoleReader reader(circ::PredicatesOf(file.formulas));
  for (std::size_t i = 0; i < input.minimize.size(); ++i) {
    reader.Add("--minimize", input.minimize[i], &roles.minimized, static_cast<int>(i) + 1);
  }
  for (const std::string& list : input.vary) reader.Add("--vary", list, nullptr, 0);
  for (const std::string& list : input.fix) reader.Add("--fix", list, &roles.fixed, 0);
  problem.diagnostics = std::move(reader.diagnostics());
  if (!problem.diagnostics.empty()) return problem;
  circ::TptpProblem ground = circ::GroundTptp(file.formulas, roles, symbols);
  problem.theory = std::move(ground.theory);
  problem.queries = std::move(ground.queries);
  problem.diagnostics = std::move(ground.diagnostics);
  for (circ::Query& query : problem.queries) query.brave = input.brave;
  return problem;
}

}  // namespace

EntailProblem ReadEntailProblem(const EntailInput& input) {
  const std::string extension = std::filesystem::path(input.input.file).extension().string();
  const bool tptp = extension == ".p" || extension == ".ax" || extension == ".tptp";
  const bool has_options = !input.minimize.empty() || !input.vary.empty() || !input.fix.empty() ||
                           !input.queries.empty() || input.brave;
  if (extension == ".circ" && has_options) {
    return Refused(input.input.file, "a .circ file says itself what is minimized and asked",
                   "leave out --minimize, --vary, --fix, --query and --brave");
  }
  if (tptp || has_options) return ReadTptpProblem(input, nullptr);
  EntailProblem problem;
  const auto text = ReadInputText(input.input.file, problem.diagnostics);
  if (!text) return problem;
  if (extension == ".circ" || IsCirc(*text)) return ReadCircProblem(*text, input.input.file);
  // What a file includes is looked for in its folder.
  const bool is_file = std::filesystem::is_regular_file(input.input.file);
  return ReadTptpProblem(input, is_file ? nullptr : &*text);
}

}  // namespace latchwork::app
