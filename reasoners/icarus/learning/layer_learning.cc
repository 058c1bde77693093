// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/learning/layer_learning.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include "latchwork/sdk/specs.h"

namespace latchwork::icarus {

namespace {

std::filesystem::path FreshOf(const std::filesystem::path& file) { return file.string() + ".new"; }

/// Whether the file has the new text; else it has the old one.
bool Replace(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path fresh = FreshOf(file);
  std::ofstream stream(fresh, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code error;
  if (stream) {
    std::filesystem::rename(fresh, file, error);
    if (!error) return true;
  }
  std::filesystem::remove(fresh, error);
  return false;
}

bool IsWritable(const std::filesystem::path& file) {
  const std::filesystem::path fresh = FreshOf(file);
  const bool is_writable = std::ofstream(fresh, std::ios::binary).is_open();
  std::error_code error;
  std::filesystem::remove(fresh, error);
  return is_writable;
}

/// The rewards among the facts of the latches.
double RewardOf(std::span<const sdk::Latch> latches) {
  double sum = 0;
  for (const sdk::Latch& latch : latches) {
    for (const logic::Fact& fact : latch.facts) {
      if (fact.predicate().name() != "reward" || fact.arity() != 1) continue;
      const logic::Term& reward = fact.arguments()[0];
      if (reward.is_number()) sum += reward.number();
    }
  }
  return sum;
}

logic::Diagnostics UnknownSkills(const std::vector<std::string>& names, const Program& program) {
  std::vector<std::string> known;
  for (const Skill& skill : program.skills) known.push_back(skill.spelling);
  logic::Diagnostics diagnostics;
  for (const std::string& name : names) {
    if (program.Find(name) != kNoSkill) continue;
    const std::string_view nearest = logic::NearestName(name, known);
    diagnostics.push_back({{},
                           "learned_skills: the program has no skill '" + name + "'",
                           nearest.empty() ? "" : "did you mean '" + std::string(nearest) + "'?",
                           {}});
  }
  return diagnostics;
}

}  // namespace

std::vector<sdk::ParameterSpec> LayerLearning::Parameters() {
  return {
      {.name = "values",
       .type = sdk::ParameterType::kFile,
       .default_value = "",
       .unit = "",
       .help = "learned values of skills, to begin with; with learn they are written there",
       .choices = {}},
      sdk::BooleanParameter("learn", false,
                            "values of skills are learned from the facts reward(R) of the latches"),
      sdk::RealParameter("exploration", "0.1", 0, 1, "",
                         "share of the choices made at random while learning"),
      sdk::IntegerParameter("hold", "1", 1, 1e9, "cycles for which a random choice stays the same"),
      sdk::RealParameter("rate", "0.1", 0, 1, "", "of what is new in a value, at least"),
      sdk::RealParameter("discount", "0.99", 0, 1, "", "of rewards, per cycle"),
      sdk::RealParameter("trace", "0.95", 0, 1, "",
                         "0: a value rests on the next one; 1: on rewards alone"),
      {.name = "learned_skills",
       .type = sdk::ParameterType::kText,
       .default_value = "",
       .unit = "",
       .help = "names of the skills that have learned values, with blanks between; empty: all",
       .choices = {}},
      sdk::IntegerParameter("exploration_seed", "1", 1, 1e9, "of the random choices")};
}

LayerLearning::LayerLearning(const sdk::Parameters& parameters)
    : file_(parameters.File("values")), learning_(parameters.Boolean("learn")) {
  options_.exploration = parameters.Real("exploration");
  options_.hold = static_cast<std::size_t>(parameters.Integer("hold"));
  options_.rate = parameters.Real("rate");
  options_.discount = parameters.Real("discount");
  options_.trace = parameters.Real("trace");
  std::istringstream names(parameters.Text("learned_skills"));
  for (std::string name; names >> name;) options_.skills.push_back(name);
  options_.seed = static_cast<std::uint64_t>(parameters.Integer("exploration_seed"));
}

LayerLearning::~LayerLearning() {
  if (!learning_ || learner_ == nullptr || file_.empty()) return;
  try {
    learner_->EndEpisode();
    if (Replace(file_, learner_->Write())) return;
  } catch (...) {
    // As when they cannot be written.
  }
  std::fprintf(stderr, "latchwork: the learned values cannot be written; %s keeps those it had\n",
               file_.c_str());
}

logic::Diagnostics LayerLearning::Serve(const Program& program, NamePool& names,
                                        Interpreter& interpreter) {
  if (file_.empty() && !learning_) return {};
  if (logic::Diagnostics unknown = UnknownSkills(options_.skills, program); !unknown.empty()) {
    return unknown;
  }
  if (learning_ && learner_ == nullptr && !file_.empty() && !IsWritable(file_)) {
    return {{{file_.string(), 0, 0},
             "learned values cannot be written here",
             "name a file in a folder that exists and may be written to",
             {}}};
  }
  std::string known;
  std::error_code error;
  if (learner_ != nullptr) {
    learner_->EndEpisode();
    known = learner_->Write();
  } else if (!file_.empty() && std::filesystem::exists(file_, error)) {
    std::ifstream stream(file_, std::ios::binary);
    known.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  } else if (!learning_) {
    return {{{file_.string(), 0, 0}, "there is no such file of values", "learn them first", {}}};
  }
  Findings findings;
  const bool first = learner_ == nullptr;
  learner_ = std::make_unique<ValueLearner>(program, names, options_);
  learner_->SetLearning(learning_);
  learner_->Read(std::move(known), file_.string(), findings);
  interpreter.SetValues(learner_.get());
  return first ? ErrorsOf(findings) : logic::Diagnostics();
}

void LayerLearning::Before(std::span<const sdk::Latch> latches) {
  if (learner_ == nullptr) return;
  if (learning_) learner_->Reward(RewardOf(latches));
  learner_->BeginCycle();
}

void LayerLearning::After(const CycleResult& result) {
  if (learner_ != nullptr) learner_->Choose(result.acts.empty() ? nullptr : result.acts.data());
}

}  // namespace latchwork::icarus
