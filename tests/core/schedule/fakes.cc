// SPDX-License-Identifier: BSD-3-Clause
#include "tests/core/schedule/fakes.h"

#include <fmt/format.h>

#include <cstdlib>

namespace latchwork::schedule::testing {

sdk::PortSpec Port(std::string name,
                   std::vector<std::pair<std::string, std::vector<sdk::ArgumentType>>> predicates) {
  sdk::PortSpec port;
  port.name = std::move(name);
  for (auto& [predicate, types] : predicates) {
    sdk::PredicateSpec spec;
    spec.name = predicate;
    for (const sdk::ArgumentType type : types) spec.arguments.push_back({"a", type, ""});
    port.predicates.push_back(std::move(spec));
  }
  return port;
}

std::string Join(std::span<const logic::Fact> facts) {
  std::string text;
  for (const logic::Fact& fact : facts) text += (text.empty() ? "" : " ") + logic::ToString(fact);
  return text;
}

logic::Diagnostics FakeWorld::Load(const sdk::WorldSetup& given, const sdk::Parameters&) {
  setup = given;
  return load_diagnostics;
}

void FakeWorld::Observe(std::uint64_t tick, std::span<sdk::Batch> sensors) {
  calls.push_back(fmt::format("observe {}", tick));
  if (observe) observe(tick, sensors);
}

void FakeWorld::Apply(std::uint64_t tick, std::span<const sdk::Batch> effectors) {
  calls.push_back(fmt::format("apply {}", tick));
  auto& now = told.emplace_back();
  updated.emplace_back();
  for (const sdk::Batch& batch : effectors) {
    updated.back().push_back(batch.updated);
    auto& facts = now.emplace_back();
    for (const logic::Fact& fact : batch.facts) facts.push_back(logic::ToString(fact));
  }
}

void FakeWorld::Step(std::uint64_t tick) {
  calls.push_back(fmt::format("step {}", tick));
  if (step) step(tick);
}

logic::Diagnostics FakeWorld::HandleEvent(std::uint64_t tick, const logic::Fact& event) {
  calls.push_back(fmt::format("event {} {}", tick, logic::ToString(event)));
  if (event.predicate().name() == "impossible") return {{{}, "no such door", "", ""}};
  return {};
}

sdk::Outcome FakeWorld::outcome() const { return say_outcome ? say_outcome() : sdk::Outcome{}; }

sdk::Body FakeLayer::MakeBody(std::string_view, const sdk::Parameters&,
                              const std::filesystem::path&, logic::SymbolTable& symbols) const {
  sdk::Body body;
  for (std::size_t port = 0; port < shape.outputs.size(); ++port) {
    for (const sdk::PredicateSpec& predicate : shape.outputs[port].predicates) {
      std::vector<logic::Term> variables;
      for (std::size_t i = 0; i < predicate.arguments.size(); ++i) {
        variables.push_back(logic::Term::Var(static_cast<logic::Variable>(i)));
      }
      sdk::Goal goal;
      goal.pattern = logic::Atom(symbols.Intern(predicate.name), variables);
      goal.variables = variables.size();
      goal.port = port;
      body.goals.push_back(std::move(goal));
    }
  }
  return body;
}

logic::Diagnostics FakeReasoner::Load(const sdk::Body& given, const sdk::Parameters&,
                                      logic::SymbolTable&) {
  body = given;
  return load_diagnostics;
}

void FakeReasoner::Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
                          sdk::Decision& decision) {
  ++decide_calls;
  decision.Clear();
  decision.status = sdk::Status::kRefuted;
  if (decide) decide(latches, budget, decision);
}

void FakeReasoner::Admit(std::span<const sdk::Latch> latches, std::size_t port,
                         std::span<const logic::Fact> batch, const sdk::Budget&,
                         std::vector<sdk::Refusal>& refused) {
  ++admit_calls;
  if (admit) admit(latches, port, batch, refused);
}

FakeAgent::FakeAgent() : world(std::make_shared<FakeWorld>()) {
  agent.name = "fake";
  agent.max_ticks = 10;
  agent.world.plugin = "world";
}

std::size_t FakeAgent::AddLayer(std::vector<sdk::PortSpec> inputs,
                                std::vector<sdk::PortSpec> outputs) {
  const std::size_t index = layers.size();
  layers.push_back(std::make_shared<FakeLayer>());
  layers.back()->shape = {std::move(inputs), std::move(outputs)};
  reasoners.push_back(std::make_shared<FakeReasoner>());
  config::LayerDescription description;
  description.name = fmt::format("l{}", index);
  description.plugin = fmt::format("layer{}", index);
  description.reasoner.plugin = fmt::format("reasoner{}", index);
  description.reasoner.inferences = 1000;
  description.reasoner.depth = 10;
  description.language = "fake";
  agent.layers.push_back(std::move(description));
  return index;
}

void FakeAgent::Wire(config::PortAddress from, config::PortAddress to,
                     std::optional<std::uint64_t> stale_after, config::Transfer transfer) {
  agent.wires.push_back({from, to, stale_after, transfer, {}});
}

logic::Fact FakeAgent::Fact(std::string_view predicate, std::initializer_list<logic::Term> terms) {
  return {symbols.Intern(predicate), terms};
}

logic::Term FakeAgent::Name(std::string_view name) {
  return logic::Term::Constant(symbols.Intern(name));
}

void FakeAgent::Conclude(sdk::Decision& decision, std::size_t goal, logic::Fact fact) {
  decision.status = sdk::Status::kProved;
  decision.conclusions.push_back({goal, std::move(fact), {}});
}

PartFactory FakeAgent::Factory() const {
  const auto find = [](const auto& parts, std::string_view name, std::string_view stem) {
    using Part = typename std::decay_t<decltype(parts)>::value_type::element_type;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (name == fmt::format("{}{}", stem, i)) return std::shared_ptr<Part>(parts[i]);
    }
    return std::shared_ptr<Part>();
  };
  const auto made = []<typename Base>(std::shared_ptr<Base> object, std::string_view name) {
    if (object != nullptr) return plugin::Made<Base>{object, plugin::MakeFailure::kNone, ""};
    return plugin::Made<Base>{nullptr, plugin::MakeFailure::kUnknownName,
                              fmt::format("there is no plugin {}", name)};
  };
  return {
      [this, find, made](std::string_view name) {
        return made(std::shared_ptr<sdk::Layer>(find(layers, name, "layer")), name);
      },
      [this, find, made](std::string_view name) {
        return made(std::shared_ptr<sdk::Reasoner>(find(reasoners, name, "reasoner")), name);
      },
      [this, made](std::string_view name) {
        return made(name == "world" ? std::shared_ptr<sdk::World>(world) : nullptr, name);
      },
      [](sdk::PluginKind, std::string_view name) { return std::filesystem::path("data") / name; },
  };
}

AssembledAgent FakeAgent::Assemble(std::uint64_t seed) {
  return AssembleAgent(agent, Factory(), symbols, seed);
}

std::unique_ptr<Lockstep> FakeAgent::Start(LockstepOptions options, std::uint64_t seed) {
  AssembledAgent assembled = Assemble(seed);
  if (!assembled.agent) {
    fmt::print(stderr, "{}", logic::Format(assembled.diagnostics));
    std::abort();
  }
  return std::make_unique<Lockstep>(std::move(*assembled.agent), std::move(options));
}

bool Recorder::OnTick(const TickRecord& record) {
  for (const LatchRecord& each : record.latched) {
    latched.push_back(fmt::format("{} l{}.{}@{}{}: {}", record.tick, each.layer, each.port,
                                  each.version, each.stale ? "!" : "", Join(each.facts)));
  }
  for (const RefusalRecord& each : record.refused) {
    const std::string part = each.to.part == kWorld ? "world" : fmt::format("l{}", each.to.part);
    refused.push_back(fmt::format("{} {}.{} {}: {}", record.tick, part, each.to.port,
                                  logic::ToString(each.fact), each.reason));
  }
  for (const DecisionRecord& each : record.decisions) {
    std::string said;
    for (const sdk::Batch& batch : each.said) said += "[" + Join(batch.facts) + "]";
    decided.push_back(fmt::format("{} l{} {}{}: {}", record.tick, each.layer,
                                  sdk::Name(each.decision->status), each.fallback ? "!" : "",
                                  said));
  }
  for (const config::PortAddress& each : record.inhibited) {
    inhibited.push_back(fmt::format("{} l{}.{}", record.tick, each.part, each.port));
  }
  for (const EventRecord& each : record.events) {
    events.push_back(
        fmt::format("{} {} {}", record.tick, logic::ToString(each.fact), each.problem));
  }
  faults.insert(faults.end(), record.faults.begin(), record.faults.end());
  return record.tick != stop_at;
}

}  // namespace latchwork::schedule::testing
