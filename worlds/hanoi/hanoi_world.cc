// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/hanoi/hanoi_world.h"

#include <fmt/format.h>

#include <algorithm>

namespace latchwork::hanoi {
namespace {

using logic::Fact;
using logic::Term;

constexpr std::string_view kLetters = "lmr";

/// The peg of every disk, as the parameter 'start' says; empty: it cannot be read.
std::vector<int> StartPosition(const std::string& start, int disks, std::uint64_t seed) {
  const auto count = static_cast<std::size_t>(disks);
  if (start == "tower") return std::vector<int>(count, 0);
  std::vector<int> peg_of;
  const sdk::RandomStream random(seed, "start");
  for (std::size_t i = 0; i < count; ++i) {
    if (start == "random") {
      peg_of.push_back(static_cast<int>(random.Index(kPegs, i)));
    } else if (start.size() == count && kLetters.find(start[i]) != std::string_view::npos) {
      peg_of.push_back(static_cast<int>(kLetters.find(start[i])));
    } else {
      return {};
    }
  }
  return peg_of;
}

}  // namespace

HanoiWorld::Words::Words(logic::SymbolTable& symbols)
    : disks(symbols.Intern("disks")),
      peg(symbols.Intern("peg")),
      target(symbols.Intern("target")),
      on_peg(symbols.Intern("on_peg")),
      topmost(symbols.Intern("topmost")),
      above(symbols.Intern("above")),
      raised(symbols.Intern("raised")),
      down(symbols.Intern("down")),
      holds(symbols.Intern("holds")),
      move_to(symbols.Intern("move_to")),
      lower(symbols.Intern("lower")),
      raise(symbols.Intern("raise")),
      grasp(symbols.Intern("grasp")),
      release(symbols.Intern("release")) {
  for (int i = 0; i < kPegs; ++i) pegs.push_back(Term::Constant(symbols.Intern(PegName(i))));
}

HanoiWorld::HanoiWorld()
    : contract_(HanoiContract()), parameters_(HanoiParameters()), events_(HanoiEvents()) {}

logic::Diagnostics HanoiWorld::Load(const sdk::WorldSetup& setup,
                                    const sdk::Parameters& parameters) {
  const int disks = static_cast<int>(parameters.Integer("disks"));
  std::vector<int> start = StartPosition(parameters.Text("start"), disks, setup.seed);
  if (start.empty()) {
    return {{parameters.PlaceOf("start"),
             fmt::format("'start' is neither 'tower' nor 'random' nor {} letters l, m, r", disks),
             {},
             {}}};
  }
  words_.emplace(*setup.symbols);
  pegs_.emplace(std::move(start));
  gripper_.emplace(GripperLimits{parameters.Real("travel_speed"), parameters.Real("lift_speed"),
                                 parameters.Real("grip_time")},
                   disks);
  hand_.emplace(setup.seed, parameters.Real("hand_every"));
  fingers_.emplace(setup.seed, "fingers");
  slip_ = parameters.Real("slip");
  tick_seconds_ = setup.tick_seconds;
  target_ = FindPeg(parameters.Text("target")).value_or(0);
  least_moves_ = LeastMoves(*pegs_, target_);
  command_ = {};
  refused_ = false;
  position_said_ = false;
  counts_ = {};
  film_ = {};
  film_.Add(0, *pegs_, *gripper_);
  outcome_ = {};
  return {};
}

void HanoiWorld::SayTask(std::vector<Fact>& facts) const {
  facts.assign(1, Fact(words_->disks, {Term::Integer(pegs_->disks())}));
  for (const Term& peg : words_->pegs) facts.emplace_back(words_->peg, std::initializer_list{peg});
  facts.emplace_back(words_->target,
                     std::initializer_list{words_->pegs[static_cast<std::size_t>(target_)]});
}

void HanoiWorld::SayPosition(std::vector<Fact>& facts) const {
  facts.clear();
  for (int disk = 1; disk <= pegs_->disks(); ++disk) {
    const int peg = pegs_->peg_of(disk);
    if (peg == Pegs::kAir) continue;
    const Term& name = words_->pegs[static_cast<std::size_t>(peg)];
    facts.emplace_back(words_->on_peg, std::initializer_list{Term::Integer(disk), name});
  }
  for (int peg = 0; peg < kPegs; ++peg) {
    if (pegs_->Top(peg) == 0) continue;
    const Term& name = words_->pegs[static_cast<std::size_t>(peg)];
    facts.emplace_back(words_->topmost,
                       std::initializer_list{name, Term::Integer(pegs_->Top(peg))});
  }
}

void HanoiWorld::SayGripper(std::vector<Fact>& facts) const {
  facts.clear();
  if (const auto peg = gripper_->above()) {
    facts.emplace_back(words_->above,
                       std::initializer_list{words_->pegs[static_cast<std::size_t>(*peg)]});
  }
  if (gripper_->raised()) facts.emplace_back(words_->raised);
  if (gripper_->Down(*pegs_)) facts.emplace_back(words_->down);
  if (gripper_->held() != 0) {
    facts.emplace_back(words_->holds, std::initializer_list{Term::Integer(gripper_->held())});
  }
}

void HanoiWorld::Observe(std::uint64_t tick, std::span<sdk::Batch> sensors) {
  sensors[kTask].updated = tick == 0;
  if (tick == 0) SayTask(sensors[kTask].facts);
  sensors[kCamera].updated = !position_said_;
  if (!position_said_) SayPosition(sensors[kCamera].facts);
  position_said_ = true;
  sensors[kGripper].updated = true;
  SayGripper(sensors[kGripper].facts);
}

Command HanoiWorld::Read(const Fact& fact) const {
  const logic::Symbol name = fact.predicate();
  if (name == words_->lower) return {Command::Kind::kLower};
  if (name == words_->raise) return {Command::Kind::kRaise};
  if (name == words_->grasp) return {Command::Kind::kGrasp};
  if (name == words_->release) return {Command::Kind::kRelease};
  if (name != words_->move_to || fact.arity() != 1) return {};
  const auto peg = std::find(words_->pegs.begin(), words_->pegs.end(), fact.argument(0));
  if (peg == words_->pegs.end()) return {};
  return {Command::Kind::kMoveTo, static_cast<int>(peg - words_->pegs.begin())};
}

void HanoiWorld::Apply(std::uint64_t /*tick*/, std::span<const sdk::Batch> effectors) {
  const std::vector<Fact>& facts = effectors[0].facts;
  command_ = facts.empty() ? Command{} : Read(facts.front());
}

void HanoiWorld::MoveByHand(const HandMove& move) {
  film_.Add(Seconds(), *pegs_, *gripper_);
  pegs_->Put(move.disk, move.peg);
  position_said_ = false;
  ++counts_.hand_moves;
  film_.remarks.push_back(
      {Seconds(), fmt::format("a hand puts disk {} to the {}", move.disk, PegName(move.peg))});
}

void HanoiWorld::MoveGripper(std::uint64_t tick) {
  const int held = gripper_->held();
  const bool slips = fingers_->Uniform(tick) < slip_;
  switch (gripper_->Step(command_, tick_seconds_, slips, *pegs_)) {
    case Gripper::Event::kGrasped:
      position_said_ = false;
      break;
    case Gripper::Event::kReleased:
      position_said_ = false;
      ++counts_.moves;
      break;
    case Gripper::Event::kSlipped:
      ++counts_.slips;
      break;
    case Gripper::Event::kPutOnSmaller:
      outcome_ = {sdk::Outcome::State::kFailed,
                  fmt::format("disk {} was put on disk {}", held, pegs_->Top(*gripper_->above()))};
      break;
    case Gripper::Event::kNone:
      break;
  }
  const bool refused = !gripper_->refusal().empty();
  if (refused && !refused_) ++counts_.refusals;
  refused_ = refused;
}

void HanoiWorld::Step(std::uint64_t tick) {
  if (outcome_.state != sdk::Outcome::State::kRunning) return;
  ++counts_.ticks;
  MoveGripper(tick);
  if (const auto move = hand_->Step(Seconds(), *pegs_, *gripper_)) MoveByHand(*move);
  film_.Add(Seconds(), *pegs_, *gripper_);
  if (outcome_.state == sdk::Outcome::State::kRunning && pegs_->AllOn(target_)) {
    outcome_ = {sdk::Outcome::State::kReached,
                fmt::format("all disks are on the {} peg", PegName(target_))};
  }
}

logic::Diagnostics HanoiWorld::HandleEvent(std::uint64_t /*tick*/, const Fact& event) {
  const auto refuse = [](std::string why) {
    return logic::Diagnostics{{{}, std::move(why), {}, {}}};
  };
  const bool known = event.predicate().name() == "hand_moves" && event.arity() == 2 &&
                     event.argument(0).kind() == Term::Kind::kInteger &&
                     event.argument(1).kind() == Term::Kind::kConstant;
  if (!known) return refuse("the world knows hand_moves(disk, peg) only");
  const auto peg = FindPeg(event.argument(1).symbol().name());
  if (!peg) return refuse("the pegs are left, middle and right");
  const auto disk = std::clamp<std::int64_t>(event.argument(0).integer(), 0, pegs_->disks() + 1);
  const HandMove move{static_cast<int>(disk), *peg};
  if (std::string why = Objection(move, *pegs_, *gripper_); !why.empty()) return refuse(why);
  MoveByHand(move);
  return {};
}

std::vector<std::pair<std::string, double>> HanoiWorld::Measures() const {
  return {{"time_s", Seconds()},
          {"moves", static_cast<double>(counts_.moves)},
          {"least_moves", static_cast<double>(least_moves_)},
          {"hand_moves", static_cast<double>(counts_.hand_moves)},
          {"slips", static_cast<double>(counts_.slips)},
          {"refusals", static_cast<double>(counts_.refusals)}};
}

std::vector<std::filesystem::path> HanoiWorld::Draw(const std::filesystem::path& folder) const {
  const auto file = folder / "hanoi.svg";
  if (!DrawFilm(film_, target_, file)) return {};
  return {file};
}

}  // namespace latchwork::hanoi
