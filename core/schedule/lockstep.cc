// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/schedule/lockstep.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "core/schedule/arbitration.h"
#include "core/schedule/contain.h"
#include "core/schedule/fork_join.h"
#include "core/schedule/layer_runner.h"
#include "core/schedule/watchdog.h"

namespace latchwork::schedule {
namespace {

using config::PortAddress;

constexpr int kInternalError = 5;

[[noreturn]] void EndProcess(std::string_view plugin, std::uint64_t tick) {
  std::fprintf(stderr,
               "error: plugin %.*s does not return from tick %llu and ignores its cancellation; "
               "the run cannot go on\n",
               static_cast<int>(plugin.size()), plugin.data(),
               static_cast<unsigned long long>(tick));
  std::_Exit(kInternalError);
}

std::vector<std::string> ReasonerNames(const Agent& agent) {
  std::vector<std::string> names;
  for (const config::LayerDescription& layer : agent.description.layers) {
    names.push_back(layer.reasoner.plugin + " (layer " + layer.name + ")");
  }
  return names;
}

}  // namespace

class Lockstep::Implementation {
 public:
  Implementation(Agent agent, LockstepOptions options);

  bool Tick();
  RunResult Run();
  RunResult Result() const;
  const Agent& agent() const { return agent_; }

 private:
  bool AskWorld(void (Implementation::*phase)());
  void HandleEvents();
  void Observe();
  void Deliver();
  void Decide();
  void CollectCycles();
  void Arbitrate();
  void Act();
  void Conclude();
  void TellObservers();
  void End(RunResult::State state, std::string message);

  Agent agent_;
  LockstepOptions options_;
  std::uint64_t max_ticks_;
  Watchdog watchdog_;
  std::vector<std::unique_ptr<LayerRunner>> runners_;
  Arbitration arbitration_;
  ForkJoin pool_;
  std::function<void(std::size_t)> cycle_;
  Arbitration::Deliver deliver_;

  std::uint64_t tick_ = 0;
  std::size_t next_event_ = 0;
  std::vector<sdk::Batch> sensors_;
  std::vector<std::size_t> due_;
  TickRecord record_;
  bool over_ = false;
  RunResult::State state_ = RunResult::State::kNotReached;
  std::string message_;
  double wall_seconds_ = 0;
};

Lockstep::Implementation::Implementation(Agent agent, LockstepOptions options)
    : agent_(std::move(agent)),
      options_(std::move(options)),
      max_ticks_(options_.max_ticks.value_or(agent_.description.max_ticks)),
      watchdog_(ReasonerNames(agent_), options_.wall_limit, options_.grace,
                options_.on_hang ? options_.on_hang : EndProcess),
      arbitration_(agent_),
      pool_(options_.threads),
      cycle_([this](std::size_t i) { runners_[due_[i]]->Cycle(tick_); }),
      deliver_([this](const PortAddress& to, const sdk::Batch& batch, std::uint64_t arrival) {
        runners_[to.part]->latches().Offer(to.port, batch, arrival);
      }),
      sensors_(agent_.world->contract().outputs.size()),
      over_(max_ticks_ == 0) {
  for (std::size_t i = 0; i < agent_.layers.size(); ++i) {
    runners_.push_back(std::make_unique<LayerRunner>(agent_, i, watchdog_));
  }
}

bool Lockstep::Implementation::Tick() {
  if (over_) return false;
  record_.tick = tick_;
  record_.events.clear();
  record_.latched.clear();
  record_.refused.clear();
  record_.decisions.clear();
  record_.inhibited.clear();
  record_.faults.clear();
  for (sdk::Batch& batch : sensors_) batch.updated = false;
  record_.sensors = sensors_;
  record_.commands = {};
  if (AskWorld(&Implementation::HandleEvents) && AskWorld(&Implementation::Observe)) {
    Deliver();
    Decide();
    Arbitrate();
    if (AskWorld(&Implementation::Act)) AskWorld(&Implementation::Conclude);
  }
  TellObservers();
  ++tick_;
  if (!over_ && tick_ >= max_ticks_) {
    End(RunResult::State::kNotReached, "the ticks of the run are used up");
  }
  return !over_;
}

/// A world that throws is in a state that nobody knows, so the run ends there.
bool Lockstep::Implementation::AskWorld(void (Implementation::*phase)()) {
  const auto thrown = Contain([&] { (this->*phase)(); });
  if (!thrown) return true;
  const std::string& plugin = agent_.description.world.plugin;
  record_.faults.push_back({tick_, Fault::kWorld, plugin, FaultKind::kException, *thrown});
  End(RunResult::State::kFailed, "world " + plugin + ": " + *thrown);
  return false;
}

void Lockstep::Implementation::HandleEvents() {
  const std::vector<config::Event>& events = agent_.description.events;
  for (; next_event_ < events.size() && events[next_event_].tick <= tick_; ++next_event_) {
    const logic::Fact& fact = events[next_event_].fact;
    record_.events.push_back({fact, {}});
    for (const logic::Diagnostic& diagnostic : agent_.world->HandleEvent(tick_, fact)) {
      std::string& problem = record_.events.back().problem;
      problem += (problem.empty() ? "" : "; ") + diagnostic.message;
    }
  }
}

void Lockstep::Implementation::Observe() { agent_.world->Observe(tick_, sensors_); }

void Lockstep::Implementation::Deliver() {
  for (std::size_t port = 0; port < sensors_.size(); ++port) {
    if (sensors_[port].updated) {
      arbitration_.NoteSensor(port, tick_, !sensors_[port].facts.empty());
    }
  }
  for (const config::Wire& wire : agent_.description.wires) {
    if (wire.from.part != PortAddress::kWorld || wire.to.part == PortAddress::kWorld) continue;
    const sdk::Batch& batch = sensors_[wire.from.port];
    if (batch.updated) runners_[wire.to.part]->latches().Offer(wire.to.port, batch, tick_);
  }
}

void Lockstep::Implementation::Decide() {
  due_.clear();
  for (std::size_t i = 0; i < runners_.size(); ++i) {
    if (runners_[i]->IsDue(tick_)) due_.push_back(i);
  }
  pool_.Run(due_.size(), cycle_);
  CollectCycles();
}

/// In declared order, whichever thread was first.
void Lockstep::Implementation::CollectCycles() {
  for (const std::size_t layer : due_) {
    LayerRunner& runner = *runners_[layer];
    const auto latches = runner.latches().latches();
    for (const Settlement::Change& change : runner.settlement().changes) {
      const sdk::Latch& latch = latches[change.port];
      record_.latched.push_back(
          {layer, change.port, latch.version, change.stale, latch.facts, &latch.undecided});
    }
    for (const Settlement::Refused& refused : runner.settlement().refused) {
      record_.refused.push_back({{layer, refused.port}, refused.fact, refused.reason});
    }
    const bool fallback = !runner.faults().empty();
    record_.decisions.push_back(
        {layer, &runner.decision(), fallback, runner.said(), runner.wall()});
    record_.faults.insert(record_.faults.end(), runner.faults().begin(), runner.faults().end());
  }
}

void Lockstep::Implementation::Arbitrate() {
  for (const std::size_t layer : due_) arbitration_.Accept(layer, tick_, runners_[layer]->said());
  arbitration_.Release(tick_, deliver_, record_);
  record_.commands = arbitration_.commands();
}

void Lockstep::Implementation::Act() {
  agent_.world->Apply(tick_, arbitration_.commands());
  agent_.world->Step(tick_);
}

void Lockstep::Implementation::Conclude() {
  const sdk::Outcome outcome = agent_.world->outcome();
  if (outcome.state == sdk::Outcome::State::kReached) {
    End(RunResult::State::kReached, outcome.message);
  } else if (outcome.state == sdk::Outcome::State::kFailed) {
    End(RunResult::State::kFailed, outcome.message);
  }
}

void Lockstep::Implementation::TellObservers() {
  bool go_on = true;
  for (RunObserver* observer : options_.observers) go_on = observer->OnTick(record_) && go_on;
  if (!go_on && !over_) End(RunResult::State::kStopped, "stopped");
}

void Lockstep::Implementation::End(RunResult::State state, std::string message) {
  over_ = true;
  state_ = state;
  message_ = std::move(message);
}

RunResult Lockstep::Implementation::Run() {
  const auto begin = std::chrono::steady_clock::now();
  while (Tick()) {
  }
  wall_seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  RunResult result = Result();
  for (RunObserver* observer : options_.observers) observer->OnEnd(result);
  return result;
}

RunResult Lockstep::Implementation::Result() const {
  RunResult result;
  result.state = state_;
  result.message = message_;
  result.ticks = tick_;
  result.seed = agent_.seed;
  result.wall_seconds = wall_seconds_;
  const auto thrown = Contain([&] { result.measures = agent_.world->Measures(); });
  if (thrown) result.message += "; its measures cannot be had: " + *thrown;
  for (const auto& runner : runners_) result.layers.push_back(runner->Statistics());
  return result;
}

Lockstep::Lockstep(Agent agent, LockstepOptions options)
    : implementation_(std::make_unique<Implementation>(std::move(agent), std::move(options))) {}
Lockstep::~Lockstep() = default;

bool Lockstep::Tick() { return implementation_->Tick(); }
RunResult Lockstep::Run() { return implementation_->Run(); }
RunResult Lockstep::Result() const { return implementation_->Result(); }
const Agent& Lockstep::agent() const { return implementation_->agent(); }

}  // namespace latchwork::schedule
