// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/recognition/recogniser.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "reasoners/icarus/language/walk.h"
#include "reasoners/icarus/machine/interpreter.h"
#include "reasoners/icarus/tools/world_script.h"

namespace latchwork::icarus {

namespace {

/// Share of what is done that no plan accounts for.
constexpr double kSlip = 0.05;

using Acts = std::vector<std::string>;

Acts ActsOf(const std::vector<std::string>& words) {
  Acts acts;
  std::copy_if(words.begin(), words.end(), std::back_inserter(acts), IsAct);
  return acts;
}

/// What was done as the acts of a plan, which may be of several calls each; a recording tells calls
/// only. Calls that are of no such act stand for themselves.
Acts Grouped(const std::vector<std::string>& recorded, Acts offered) {
  Acts done = ActsOf(recorded);
  std::stable_sort(offered.begin(), offered.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  Acts grouped;
  for (auto at = done.begin(); at != done.end();) {
    auto end = at + 1;
    for (const std::string& act : offered) {
      std::string calls;
      auto last = at;
      while (last != done.end() && calls.size() < act.size()) calls += *last++;
      if (calls != act) continue;
      end = last;
      break;
    }
    grouped.push_back(CallsOf({at, end}));
    at = end;
  }
  return grouped;
}

/// Lets the script know the sensors of the program that it does not answer.
std::vector<std::string> AddUnanswered(const Program& program, WorldScript& script) {
  std::vector<std::string> unanswered;
  for (const Skill& skill : program.skills) {
    WalkTerms(skill, [&](const Term& term, Slot slot) {
      if (term.kind != TermKind::kCall || slot == Slot::kAction || FindBuiltin(term.text)) return;
      const bool known =
          std::any_of(script.functions.begin(), script.functions.end(),
                      [&](const Signature& signature) { return signature.name == term.text; });
      if (known) return;
      script.names.push_back(term.text);
      Signature signature;
      signature.name = script.names.back();
      script.functions.push_back(signature);
      unanswered.push_back(term.text);
    });
  }
  return unanswered;
}

/// How many different acts were seen.
std::size_t CountActs(const WorldScript& script) {
  std::set<std::string> seen;
  for (const ScriptCycle& cycle : script.cycles) {
    if (!cycle.expected) continue;
    for (const std::string& act : ActsOf(*cycle.expected)) seen.insert(act);
  }
  return seen.size();
}

/// Adds what one cycle says of a plan.
void Add(const Acts& done, const Acts& offered, std::size_t kinds, Evidence& evidence) {
  const auto is_offered = [&](const std::string& act) {
    return std::find(offered.begin(), offered.end(), act) != offered.end();
  };
  const double slip = kSlip / static_cast<double>(kinds + 1);
  const bool idle = done.empty() && offered.empty();
  const bool explained =
      idle || (!done.empty() && std::all_of(done.begin(), done.end(), is_offered));
  const double share = idle ? 1 : 1 / static_cast<double>(std::max<std::size_t>(offered.size(), 1));
  ++evidence.cycles;
  if (explained) {
    ++evidence.explained;
    evidence.precision += share;
  }
  if (done.empty()) evidence.log_likelihood += std::log(slip + (idle ? 1 - kSlip : 0));
  for (const std::string& act : done) {
    evidence.log_likelihood += std::log(slip + (is_offered(act) ? (1 - kSlip) * share : 0));
  }
}

}  // namespace

Evidence WeighPlan(const Program& program, const std::string& top, const std::string& recording,
                   const std::string& file, Findings& findings) {
  Evidence evidence;
  NamePool names;
  WorldScript script = ReadScript(recording, file, names, findings);
  if (HasErrors(findings)) return evidence;
  evidence.unanswered = AddUnanswered(program, script);
  ScriptedWorld world(script);
  RunOptions options;
  options.acts = ActMode::kAll;
  Interpreter interpreter(program, world, names, options);
  findings.insert(findings.end(), interpreter.findings().begin(), interpreter.findings().end());
  if (HasErrors(findings)) return evidence;
  const std::size_t call = interpreter.AddTop(top, findings);
  if (HasErrors(findings)) return evidence;
  const std::size_t kinds = CountActs(script);
  for (const ScriptCycle& cycle : script.cycles) {
    for (std::int64_t i = 0; i < cycle.repeat; ++i) {
      world.Begin(cycle, interpreter.memory());
      const CycleResult& result = interpreter.Cycle(cycle.idle ? Interpreter::kNoTop : call);
      if (!cycle.expected || cycle.idle) continue;
      const Acts offered = ActsOf(Outcome(result, names));
      Add(Grouped(*cycle.expected, offered), offered, kinds, evidence);
    }
  }
  if (evidence.cycles > 0) evidence.precision /= static_cast<double>(evidence.cycles);
  return evidence;
}

std::vector<double> Posterior(const std::vector<Evidence>& evidence) {
  double best = -std::numeric_limits<double>::infinity();
  for (const Evidence& of : evidence) best = std::max(best, of.log_likelihood);
  std::vector<double> shares;
  double sum = 0;
  for (const Evidence& of : evidence) {
    shares.push_back(std::exp(of.log_likelihood - best));
    sum += shares.back();
  }
  for (double& share : shares) share /= sum;
  return shares;
}

}  // namespace latchwork::icarus
