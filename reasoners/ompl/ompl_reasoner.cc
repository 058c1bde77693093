// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/ompl_reasoner.h"

#include <algorithm>
#include <utility>

#include "reasoners/ompl/ompl_options.h"

namespace latchwork::planning {
namespace {

bool Concludes(const sdk::Body& body, std::string_view predicate) {
  return std::any_of(body.goals.begin(), body.goals.end(), [&](const sdk::Goal& goal) {
    return goal.pattern.predicate().name() == predicate;
  });
}

/// None for a contract that no job meets.
std::unique_ptr<Job> JobFor(const sdk::Body& body, const JobSetup& setup,
                            logic::SymbolTable& symbols) {
  if (Concludes(body, "target_landmark")) return MakeItineraryJob(setup, symbols);
  if (Concludes(body, "move_cmd")) return MakeElevatorsJob(setup, symbols);
  if (Concludes(body, "direction")) return MakeSeekJob(setup, body, symbols);
  return nullptr;
}

logic::Diagnostics Refuse(std::string message, std::string hint) {
  return {{{}, std::move(message), std::move(hint), {}}};
}

}  // namespace

std::span<const sdk::ParameterSpec> OmplReasoner::parameters() const { return OmplOptions(); }

logic::Diagnostics OmplReasoner::Load(const sdk::Body& body, const sdk::Parameters& parameters,
                                      logic::SymbolTable& symbols) {
  logic::Diagnostics diagnostics;
  JobSetup setup = SetupFrom(parameters, diagnostics);
  ReadBuildingMap read = ReadBuilding(parameters.File("map"), parameters.Real("resolution"),
                                      parameters.PlaceOf("map"), symbols);
  diagnostics.insert(diagnostics.end(), read.diagnostics.begin(), read.diagnostics.end());
  if (!diagnostics.empty()) return diagnostics;
  auto map = std::make_unique<BuildingMap>(std::move(read.map));
  setup.map = map.get();
  auto job = JobFor(body, setup, symbols);
  if (job == nullptr) {
    return Refuse("the planner does not know what this layer is for",
                  "it drives layers that conclude target_landmark, move_cmd or direction");
  }
  job_ = std::move(job);
  map_ = std::move(map);
  goals_ = body.goals;
  return {};
}

void OmplReasoner::Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
                          sdk::Decision& decision) {
  decision.Clear();
  Effort effort(budget);
  const Verdict verdict = job_->Decide(LatchFacts(latches), effort);
  decision.statistics.inferences = effort.spent();
  decision.message = verdict.message;
  if (!verdict.message.empty()) {
    decision.status = sdk::Status::kFailed;
    return;
  }
  switch (verdict.state) {
    case FoundPath::State::kFound:
      decision.status = sdk::Status::kProved;
      Conclude(verdict, decision);
      break;
    case FoundPath::State::kNone:
      decision.status = sdk::Status::kRefuted;
      break;
    case FoundPath::State::kUnknown: {
      const sdk::Limit limit = effort.limit();
      decision.status = sdk::Status::kUnknown;
      decision.limit = limit == sdk::Limit::kNone ? sdk::Limit::kInferences : limit;
    }
  }
}

void OmplReasoner::Conclude(const Verdict& verdict, sdk::Decision& decision) const {
  for (std::size_t goal = 0; goal < goals_.size(); ++goal) {
    for (const logic::Fact& fact : verdict.facts) {
      if (logic::NameOf(fact) == logic::NameOf(goals_[goal].pattern)) {
        decision.conclusions.push_back({goal, fact, {}});
      }
    }
  }
}

void OmplReasoner::Admit(std::span<const sdk::Latch> /*latches*/, std::size_t /*port*/,
                         std::span<const logic::Fact> /*batch*/, const sdk::Budget& /*budget*/,
                         std::vector<sdk::Refusal>& /*refused*/) {}

logic::Diagnostics OmplReasoner::Tell(std::string_view /*text*/) {
  return Refuse("a planner reads no text", "its parameters are set in the agent file");
}

logic::Diagnostics OmplReasoner::Retract(std::string_view /*name*/) {
  return Refuse("a planner has nothing to retract", "its parameters are set in the agent file");
}

sdk::Derivation OmplReasoner::Explain(std::size_t /*conclusion*/) { return {}; }

}  // namespace latchwork::planning
