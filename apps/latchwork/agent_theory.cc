// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/agent_theory.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "latchwork/config/agent.h"
#include "latchwork/logic/tptp.h"
#include "latchwork/plugin/plugin_search.h"
#include "latchwork/plugin/registry.h"
#include "latchwork/schedule/agent.h"
#include "reasoners/circumscription/grounding/tptp_problem.h"

namespace latchwork::app {
namespace {

namespace circ = latchwork::circumscription;
using logic::AnnotatedFormula;
using logic::Formula;

/// A goal instance on its way down.
struct Handed {
  circ::Atom goal = 0;  ///< In its layer.
  logic::Fact fact;
};

AnnotatedFormula Axiom(std::string name, Formula formula, logic::SourcePlace place) {
  return {std::move(name), logic::Role::kAxiom, std::move(formula), {}, false, std::move(place)};
}

class AgentTheory {
 public:
  AgentTheory(schedule::Agent& agent, logic::SymbolTable& symbols, SemanticsProblem& problem)
      : agent_(agent), symbols_(symbols), problem_(problem) {
    given_.resize(agent.layers.size());
  }

  void Give(const std::string& text);
  void Build();

 private:
  void Refuse(std::size_t layer, logic::SourcePlace place, std::string reason,
              std::string hint = "") {
    problem_.diagnostics.push_back(
        {std::move(place),
         fmt::format("layer '{}' is no finite theory: {}", description(layer).name, reason),
         std::move(hint), ""});
  }
  const config::LayerDescription& description(std::size_t layer) const {
    return agent_.description.layers[layer];
  }
  std::vector<AnnotatedFormula> ReadBody(std::size_t layer);
  void CheckAttachments(std::size_t layer, const std::vector<AnnotatedFormula>& formulas);
  void CheckWires();
  circ::PredicateRoles RolesOf(const sdk::Body& body) const;
  /// Grounds one layer, what is handed down to it on premises of its own.
  void BuildLayer(std::size_t layer);
  void TakeBridges(const std::vector<std::string>& premises, circ::TheoryLayer& layer);
  bool IsHandedDown(std::size_t layer, const logic::Fact& fact) const;
  void CollectGoals(std::size_t layer, const circ::GroundTheory& theory);

  schedule::Agent& agent_;
  logic::SymbolTable& symbols_;
  SemanticsProblem& problem_;
  std::vector<std::vector<logic::Fact>> given_;  ///< Per layer.
  std::vector<Handed> handed_;                   ///< To the layer that is next.
};

/// "LAYER: atom".
void AgentTheory::Give(const std::string& text) {
  const auto refuse = [&](std::string message, std::string hint) {
    problem_.diagnostics.push_back(
        {{fmt::format("--fact '{}'", text), 0, 0}, std::move(message), std::move(hint), ""});
  };
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return refuse("not of the form LAYER: ATOM", "");
  std::vector<std::string> names;
  for (const config::LayerDescription& layer : agent_.description.layers) {
    names.push_back(layer.name);
  }
  const std::string name = text.substr(0, colon);
  const auto place = std::find(names.begin(), names.end(), name);
  if (place == names.end()) {
    const std::string_view nearest = logic::NearestName(name, names);
    return refuse(fmt::format("there is no layer '{}'", name),
                  nearest.empty() ? "" : fmt::format("did you mean '{}'?", nearest));
  }
  logic::TptpAtom atom = logic::ReadTptpAtom(text.substr(colon + 1), "--fact", symbols_);
  if (!atom.diagnostics.empty() || !atom.atom || !atom.atom->is_ground()) {
    return refuse("what follows the layer is no ground atom", "for example 'seek: move_cmd(p1)'");
  }
  given_[static_cast<std::size_t>(place - names.begin())].push_back(*atom.atom);
}

std::vector<AnnotatedFormula> AgentTheory::ReadBody(std::size_t layer) {
  const sdk::Body& body = agent_.layers[layer].body;
  std::vector<AnnotatedFormula> formulas;
  for (const std::filesystem::path& path : body.files) {
    logic::TptpFile file = logic::ReadTptpFile(path, symbols_);
    std::move(file.formulas.begin(), file.formulas.end(), std::back_inserter(formulas));
    std::move(file.diagnostics.begin(), file.diagnostics.end(),
              std::back_inserter(problem_.diagnostics));
  }
  for (const logic::Fact& fact : body.facts) {
    formulas.push_back(Axiom("parameter", Formula::Of(fact), description(layer).place));
  }
  for (const logic::Fact& fact : given_[layer]) {
    formulas.push_back(Axiom("given", Formula::Of(fact), description(layer).place));
  }
  return formulas;
}

void AgentTheory::CheckAttachments(std::size_t layer,
                                   const std::vector<AnnotatedFormula>& formulas) {
  std::set<std::string_view> attached;
  for (const auto& attachment : agent_.layers[layer].body.attachments) {
    attached.insert(attachment->signature().predicate);
  }
  for (const AnnotatedFormula& formula : formulas) {
    for (const logic::PredicateName& name : circ::PredicatesOf({formula})) {
      if (!attached.contains(name.symbol.name())) continue;
      Refuse(layer, formula.place,
             fmt::format("'{}' calls the attachment {}", formula.name, ToString(name)));
    }
  }
}

void AgentTheory::CheckWires() {
  for (const config::Wire& wire : agent_.description.wires) {
    const std::size_t from = wire.from.part;
    const std::size_t to = wire.to.part;
    const bool outside = from == config::PortAddress::kWorld || to == config::PortAddress::kWorld;
    if (outside || from == to + 1) continue;
    problem_.diagnostics.push_back(
        {wire.place,
         fmt::format("the wire leads from layer '{}' to '{}', which is not the next below",
                     description(from).name, description(to).name),
         "a layered theory has bridges between neighbours only", ""});
  }
}

circ::PredicateRoles AgentTheory::RolesOf(const sdk::Body& body) const {
  circ::PredicateRoles roles;
  for (const sdk::Minimized& minimized : body.minimized) {
    roles.minimized[minimized.predicate] = static_cast<int>(minimized.priority);
  }
  for (const logic::PredicateName& fixed : body.fixed) roles.fixed[fixed] = 1;
  return roles;
}

void AgentTheory::BuildLayer(std::size_t layer) {
  const sdk::Body& body = agent_.layers[layer].body;
  if (body.language != "tptp") {
    Refuse(layer, description(layer).place,
           fmt::format("its body is in the language '{}'", body.language));
    handed_.clear();
    return;
  }
  std::vector<AnnotatedFormula> formulas = ReadBody(layer);
  CheckAttachments(layer, formulas);
  circ::PredicateRoles roles = RolesOf(body);
  std::vector<std::string> premises;
  for (const Handed& handed : handed_) {
    const logic::Atom premise(symbols_.Fresh("premise"));
    roles.fixed[NameOf(premise)] = 1;
    premises.push_back(ToString(premise));
    formulas.push_back(Axiom("bridge",
                             Formula::Implies(Formula::Of(premise), Formula::Of(handed.fact)),
                             description(layer).place));
  }
  circ::TptpProblem ground = circ::GroundTptp(formulas, roles, symbols_);
  for (const logic::Diagnostic& diagnostic : ground.diagnostics) {
    Refuse(layer, diagnostic.place, diagnostic.message, diagnostic.hint);
  }
  circ::TheoryLayer& made = problem_.theory.layers[layer];
  made.theory = std::move(ground.theory);
  TakeBridges(premises, made);
  handed_.clear();
  CollectGoals(layer, made.theory);
}

/// Bridges in place of the clauses that hold their premises.
void AgentTheory::TakeBridges(const std::vector<std::string>& premises, circ::TheoryLayer& layer) {
  std::erase_if(layer.theory.clauses, [&](const circ::Clause& clause) {
    for (const circ::Literal literal : clause) {
      const std::string& name = layer.theory.at(circ::AtomOf(literal)).name;
      const auto place = std::find(premises.begin(), premises.end(), name);
      if (place == premises.end()) continue;
      const circ::Literal latch = clause[0] == literal ? clause[1] : clause[0];
      const Handed& handed = handed_[static_cast<std::size_t>(place - premises.begin())];
      layer.bridges.push_back({handed.goal, latch});
      return true;
    }
    return false;
  });
}

bool AgentTheory::IsHandedDown(std::size_t layer, const logic::Fact& fact) const {
  return std::ranges::any_of(agent_.description.wires, [&](const config::Wire& wire) {
    if (wire.from.part != layer || wire.to.part + 1 != layer) return false;
    const bool leaves =
        std::ranges::any_of(agent_.layers[layer].body.goals, [&](const sdk::Goal& goal) {
          return goal.port == wire.from.port && NameOf(goal.pattern) == NameOf(fact);
        });
    const auto& ports = agent_.layers[layer - 1].layer->contract().inputs;
    return leaves && std::ranges::any_of(ports[wire.to.port].predicates,
                                         [&](const sdk::PredicateSpec& predicate) {
                                           return predicate.name == fact.predicate().name() &&
                                                  predicate.arguments.size() == fact.arity();
                                         });
  });
}

/// What the layer hands down, or, of the lowest, what is asked.
void AgentTheory::CollectGoals(std::size_t layer, const circ::GroundTheory& theory) {
  const std::vector<sdk::Goal>& goals = agent_.layers[layer].body.goals;
  for (circ::Atom atom = 1; atom <= static_cast<circ::Atom>(theory.atoms.size()); ++atom) {
    const std::string& name = theory.at(atom).name;
    const logic::TptpAtom read = logic::ReadTptpAtom(name, "goal", symbols_);
    if (!read.atom) continue;
    if (layer > 0) {
      if (IsHandedDown(layer, *read.atom)) handed_.push_back({atom, *read.atom});
    } else if (std::ranges::any_of(goals, [&](const sdk::Goal& goal) {
                 return NameOf(goal.pattern) == NameOf(*read.atom);
               })) {
      problem_.queries.push_back({name, false, {atom}});
      problem_.queries.push_back({"~" + name, false, {-atom}});
    }
  }
}

void AgentTheory::Build() {
  CheckWires();
  problem_.theory.layers.resize(agent_.layers.size());
  for (std::size_t layer = agent_.layers.size(); layer-- > 0;) {
    problem_.theory.layers[layer].name = description(layer).name;
    BuildLayer(layer);
  }
}

void MoveDiagnostics(logic::Diagnostics& from, SemanticsProblem& problem, bool plugin_failure) {
  std::move(from.begin(), from.end(), std::back_inserter(problem.diagnostics));
  problem.plugin_failure = problem.plugin_failure || plugin_failure;
}

}  // namespace

SemanticsProblem ReadAgentProblem(const std::string& file, const std::vector<std::string>& facts,
                                  const Context& context) {
  SemanticsProblem problem;
  const plugin::Registry registry(
      plugin::MakeSearchPath(context.plugin_folders, context.executable));
  logic::SymbolTable symbols;
  config::AgentFile read =
      config::ReadAgentFile(file, schedule::MakeCatalog(registry), {}, symbols);
  MoveDiagnostics(read.diagnostics, problem, read.plugin_failure);
  if (!read.agent) return problem;
  schedule::AssembledAgent assembled = schedule::AssembleAgent(
      *std::move(read.agent), schedule::MakePartFactory(registry), symbols, 1);
  MoveDiagnostics(assembled.diagnostics, problem, assembled.plugin_failure);
  if (!assembled.agent) return problem;
  AgentTheory theory(*assembled.agent, symbols, problem);
  for (const std::string& fact : facts) theory.Give(fact);
  theory.Build();
  return problem;
}

}  // namespace latchwork::app
