// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>
#include <string>

#include "apps/latchwork/semantics_report.h"
#include "reasoners/circumscription/formats/lay_file.h"

namespace latchwork::app {
namespace {

namespace circ = latchwork::circumscription;
using Json = nlohmann::ordered_json;

Json LayersOf(const SemanticsProblem& problem, const circ::Conditions& conditions) {
  Json layers = Json::array();
  for (std::size_t i = 0; i < problem.theory.layers.size(); ++i) {
    const circ::TheoryLayer& layer = problem.theory.layers[i];
    layers.push_back({{"layer", i + 1},
                      {"name", layer.name},
                      {"atoms", layer.theory.atoms.size()},
                      {"clauses", layer.theory.clauses.size()},
                      {"facts", layer.facts.size()},
                      {"bridges", layer.bridges.size()},
                      {"has_model", Name(conditions.layers_have_models[i])}});
  }
  return layers;
}

Json Objections(const circ::LayeredTheory& theory, const circ::GivenUp& given_up) {
  const circ::BridgedTheory bridged = WithBridges(theory, given_up.layer);
  Json core = Json::array();
  for (const circ::Literal fact : given_up.core.latches) {
    core.push_back(ToString(bridged.theory, fact));
  }
  for (const std::size_t index : given_up.core.clauses) {
    core.push_back(ToString(bridged.theory, bridged.theory.clauses[index]));
  }
  return core;
}

Json BridgesOf(const circ::LayeredTheory& theory, const circ::Conditions& conditions) {
  Json bridges = Json::array();
  for (const circ::GivenUp& given_up : conditions.given_up) {
    const circ::Bridge& bridge = theory.layers[given_up.layer].bridges[given_up.bridge];
    bridges.push_back({{"layer", given_up.layer + 1},
                       {"bridge", BridgeName(theory, given_up.layer, bridge)},
                       {"rejected_by", Objections(theory, given_up)}});
  }
  return bridges;
}

Json GoalsOf(const circ::LayeredTheory& theory, const circ::Conditions& conditions) {
  Json goals = Json::array();
  for (const circ::LayerGoal& state : conditions.goals) {
    goals.push_back({{"layer", state.layer + 1},
                     {"goal", ToString(theory.layers[state.layer].theory, state.goal)},
                     {"status", Name(state.status)}});
  }
  return goals;
}

Json AnswersOf(const SemanticsProblem& problem, const SemanticsFindings& findings) {
  Json answers = Json::array();
  for (std::size_t i = 0; i < problem.queries.size(); ++i) {
    Json answer = {
        {"id", problem.queries[i].id},
        {"query", ToString(problem.theory.layers.front().theory, problem.queries[i].literals)},
        {"definition", Name(findings.definition[i])}};
    for (const TransferFindings& transfer : findings.transfers) {
      answer[std::string(Name(transfer.transfer))] = Name(transfer.verdicts[i]);
    }
    answers.push_back(std::move(answer));
  }
  return answers;
}

Json DifferenceOf(const SemanticsProblem& problem, const SmallestDifference& difference) {
  const circ::Query query{problem.queries[difference.query].id, false, difference.example.clause};
  Json json = {{"transfer", Name(difference.transfer)},
               {"fault", Name(difference.fault)},
               {"id", query.id},
               {"theory", WriteLay(difference.example.theory, {&query, 1})}};
  if (difference.model) json["model"] = *difference.model;
  return json;
}

}  // namespace

nlohmann::ordered_json ToJson(const SemanticsProblem& problem, const SemanticsFindings& findings) {
  const circ::Conditions& conditions = findings.conditions;
  Json json = {{"layers", LayersOf(problem, conditions)},
               {"has_model", Name(conditions.has_model)},
               {"consistent_with_transfers", Name(conditions.consistent_with_transfers)},
               {"smooth_preference", "yes"},
               {"goals_decided", conditions.GoalsDecided()},
               {"goals", GoalsOf(problem.theory, conditions)},
               {"bridges_given_up", BridgesOf(problem.theory, conditions)},
               {"answers", AnswersOf(problem, findings)}};
  if (findings.difference) json["counterexample"] = DifferenceOf(problem, *findings.difference);
  return json;
}

}  // namespace latchwork::app
