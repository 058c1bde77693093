// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/learning/value_learner.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "reasoners/icarus/language/reader.h"
#include "reasoners/icarus/learning/feature.h"

namespace latchwork::icarus {

namespace {

std::string NumberText(double number) {
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  return {buffer.data(), end};
}

}  // namespace

ValueLearner::ValueLearner(const Program& program, NamePool& names, const LearningOptions& options)
    : program_(program), names_(names), options_(options), stream_(options.seed, "icarus.values") {
  if (options_.skills.empty()) return;
  learns_.resize(program.skills.size());
  for (const std::string& name : options_.skills) {
    const std::uint32_t skill = program.Find(name);
    if (skill != kNoSkill) learns_[skill] = true;
  }
}

void ValueLearner::SetSeed(std::uint64_t seed) {
  stream_ = sdk::RandomStream(seed, "icarus.values");
  cycle_ = 0;
}

std::uint64_t ValueLearner::HashOf(std::uint32_t skill, std::span<const Value> arguments) {
  std::uint64_t hash = skill + 1;
  for (const Value& argument : arguments) {
    hash = (hash ^ HashOfFeature(argument)) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 31U;
  }
  return hash;
}

std::size_t ValueLearner::Find(std::uint32_t skill, std::span<const Value> arguments,
                               std::uint64_t hash) const {
  const auto [first, last] = places_.equal_range(hash);
  for (auto at = first; at != last; ++at) {
    const Estimate& known = estimates_[at->second];
    const bool same =
        known.skill == skill && std::equal(known.arguments.begin(), known.arguments.end(),
                                           arguments.begin(), arguments.end(), IsFeatureOf);
    if (same) return at->second;
  }
  return estimates_.size();
}

std::size_t ValueLearner::FindOrMake(std::uint32_t skill, std::span<const Value> arguments) {
  const std::uint64_t hash = HashOf(skill, arguments);
  const std::size_t known = Find(skill, arguments, hash);
  if (known < estimates_.size()) return known;
  Estimate estimate;
  estimate.skill = skill;
  for (const Value& argument : arguments) {
    estimate.arguments.push_back(MakeFeature(argument, arena_));
  }
  estimate.hash = hash;
  estimate.value = options_.initial;
  places_.emplace(hash, estimates_.size());
  estimates_.push_back(std::move(estimate));
  return estimates_.size() - 1;
}

std::optional<double> ValueLearner::ValueOf(std::uint32_t skill, std::span<const Value> arguments) {
  if (!Learns(skill)) return std::nullopt;
  const std::uint64_t hash = HashOf(skill, arguments);
  if (exploring_) return stream_.Uniform(cycle_ / options_.hold, hash);
  const std::size_t known = Find(skill, arguments, hash);
  return known < estimates_.size() ? estimates_[known].value : options_.initial;
}

void ValueLearner::BeginCycle() {
  ++cycle_;
  exploring_ = learning_ && stream_.Uniform(cycle_ / options_.hold, 0) < options_.exploration;
}

void ValueLearner::Choose(const Act* act) {
  if (!learning_) return;
  Step step;
  for (const PathSkill* at = act == nullptr ? nullptr : act->path; at != nullptr; at = at->caller) {
    if (Learns(at->skill)) step.path.push_back(FindOrMake(at->skill, at->arguments));
  }
  steps_.push_back(std::move(step));
  if (steps_.size() > std::max<std::size_t>(options_.window, 1)) Learn(false);
}

void ValueLearner::Reward(double reward) {
  if (!steps_.empty() && std::isfinite(reward)) steps_.back().reward += reward;
}

void ValueLearner::EndEpisode() { Learn(true); }

/// What stands for the situation of a step: of the skills on the path the one that was entered
/// least often, whose parameters say most; no estimate where nothing was chosen.
std::size_t ValueLearner::Rarest(const Path& path) const {
  const auto rarest = std::min_element(path.begin(), path.end(), [&](std::size_t a, std::size_t b) {
    return estimates_[a].times < estimates_[b].times;
  });
  return rarest == path.end() ? estimates_.size() : *rarest;
}

double ValueLearner::EstimateOf(std::size_t estimate) const {
  return estimate < estimates_.size() ? estimates_[estimate].value : options_.initial;
}

/// What follows each skill of `step`. Within a stay in a skill rewards add up; where the stay ends,
/// what follows is mixed from the estimate for the next step and from what followed that.
std::vector<double> ValueLearner::Returns(const Step& step, const Path& next_path,
                                          const std::vector<double>& next_returns,
                                          double beyond) const {
  std::vector<double> returns(step.path.size());
  for (std::size_t i = 0; i < step.path.size(); ++i) {
    const auto stays = std::find(next_path.begin(), next_path.end(), step.path[i]);
    const double after = stays == next_path.end()
                             ? beyond
                             : next_returns[static_cast<std::size_t>(stays - next_path.begin())];
    returns[i] = step.reward + options_.discount * after;
  }
  return returns;
}

/// Backwards, so that what came late is credited to what came first; unless the episode has ended
/// the last step has no reward yet, and stays.
void ValueLearner::Learn(bool ended) {
  if (steps_.empty()) return;
  const std::size_t count = ended ? steps_.size() : steps_.size() - 1;
  Path next;
  std::vector<double> returns;
  double beyond = 0;
  if (!ended) {
    next = steps_.back().path;
    beyond = EstimateOf(Rarest(next));
    for (const std::size_t estimate : next) returns.push_back(EstimateOf(estimate));
  }
  for (std::size_t i = count; i-- > 0;) {
    const Step& step = steps_[i];
    returns = Returns(step, next, returns, beyond);
    next = step.path;
    const std::size_t rarest = Rarest(next);
    const double estimate = EstimateOf(rarest);
    const auto at = std::find(next.begin(), next.end(), rarest) - next.begin();
    const double followed = next.empty() ? step.reward + options_.discount * beyond
                                         : returns[static_cast<std::size_t>(at)];
    beyond = (1 - options_.trace) * estimate + options_.trace * followed;
    CreditEntered(i == 0 ? before_ : steps_[i - 1].path, next, returns);
  }
  before_ = ended || count == 0 ? Path() : std::move(steps_[count - 1].path);
  steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(count));
}

/// A stay in a skill is one choice, however many cycles it lasts: long stays have no more weight
/// than short ones, and what one of them came to is not counted over and over.
void ValueLearner::CreditEntered(const Path& before, const Path& path,
                                 const std::vector<double>& returns) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (std::find(before.begin(), before.end(), path[i]) != before.end()) continue;
    MoveTowards(path[i], returns[i]);
  }
}

void ValueLearner::MoveTowards(std::size_t estimate, double target) {
  Estimate& at = estimates_[estimate];
  ++at.times;
  const double rate = std::max(options_.rate, 1.0 / static_cast<double>(at.times));
  at.value += rate * (target - at.value);
}

std::string ValueLearner::Write() const {
  std::vector<std::string> lines;
  for (const Estimate& at : estimates_) {
    std::string line = "(value (" + program_.skills[at.skill].spelling;
    for (const Value& argument : at.arguments) line += ' ' + ToString(argument, names_);
    lines.push_back(line + ") " + NumberText(at.value) + ' ' + std::to_string(at.times) + ")\n");
  }
  std::sort(lines.begin(), lines.end());
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

bool ValueLearner::ReadArgument(const SourceTree& tree, FormId form, Value& argument) {
  switch (tree.kind(form)) {
    case FormKind::kVariable:
      return true;
    case FormKind::kInteger:
      argument = Value::Integer(tree.at(form).integer);
      return true;
    case FormKind::kReal:
      argument = Value::Real(tree.at(form).real);
      return true;
    case FormKind::kString:
      argument = Value::String(names_.Intern(tree.Unquoted(form)));
      return true;
    case FormKind::kSymbol:
      argument = Value::Symbol(names_.Intern(tree.Folded(form)));
      return true;
    case FormKind::kList: {
      std::vector<Value> items;
      for (const FormId child : tree.Children(form)) {
        if (!ReadArgument(tree, child, items.emplace_back())) return false;
      }
      argument = arena_.MakeList(items);
      return !argument.is_none();
    }
    default:
      return false;
  }
}

bool ValueLearner::ReadLine(const SourceTree& tree, FormId form) {
  const std::vector<FormId> parts = tree.Children(form);
  const auto is_number = [&](FormId f) {
    return tree.kind(f) == FormKind::kInteger || tree.kind(f) == FormKind::kReal;
  };
  if (tree.kind(form) != FormKind::kList || parts.size() != 4 || tree.Folded(parts[0]) != "value" ||
      tree.kind(parts[1]) != FormKind::kList || tree.at(parts[1]).first_child == kNoForm ||
      !is_number(parts[2]) || tree.kind(parts[3]) != FormKind::kInteger ||
      tree.at(parts[3]).integer < 0) {
    return false;
  }
  const std::vector<FormId> call = tree.Children(parts[1]);
  const std::uint32_t skill = program_.Find(tree.Text(call[0]));
  if (skill == kNoSkill || program_.skills[skill].parameters != call.size() - 1) return false;
  std::vector<Value> arguments(call.size() - 1);
  for (std::size_t i = 1; i < call.size(); ++i) {
    if (!ReadArgument(tree, call[i], arguments[i - 1])) return false;
  }
  const Form& value = tree.at(parts[2]);
  Estimate& estimate = estimates_[FindOrMake(skill, arguments)];
  estimate.value = value.kind == FormKind::kReal ? value.real : static_cast<double>(value.integer);
  estimate.times = static_cast<std::uint64_t>(tree.at(parts[3]).integer);
  return true;
}

void ValueLearner::Read(std::string text, std::string file, Findings& findings) {
  const SourceTree tree = ReadForms(std::move(text), std::move(file), findings);
  Reporter reporter(tree, findings);
  for (const FormId root : tree.roots) {
    if (ReadLine(tree, root)) continue;
    reporter.Add(Code::kValues, root, "this is no value of a skill of the program",
                 "(value (Skill argument ...) estimate times)");
  }
}

}  // namespace latchwork::icarus
