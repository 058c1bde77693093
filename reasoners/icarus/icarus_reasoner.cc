// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/icarus_reasoner.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "reasoners/icarus/body/explanation.h"
#include "reasoners/icarus/icarus_options.h"
#include "reasoners/icarus/language/walk.h"
#include "reasoners/icarus/read_program_file.h"

namespace latchwork::icarus {

namespace {

constexpr std::string_view kTold = "told";
constexpr std::size_t kNoGoal = static_cast<std::size_t>(-1);

logic::Diagnostic Problem(std::string file, std::string message, std::string hint) {
  return {{std::move(file), 0, 0}, std::move(message), std::move(hint), {}};
}

}  // namespace

std::span<const sdk::ParameterSpec> IcarusReasoner::parameters() const { return LayerOptions(); }

logic::Diagnostics IcarusReasoner::Load(const sdk::Body& body, const sdk::Parameters& parameters,
                                        logic::SymbolTable& symbols) {
  body_ = body;
  options_ = OptionsFrom(parameters);
  learning_ = std::make_unique<LayerLearning>(parameters);
  bridge_ = std::make_unique<TermBridge>(symbols, names_);
  for (const logic::Fact& fact : body_.facts) bridge_->Import(fact.predicate());
  goal_names_.clear();
  for (const sdk::Goal& goal : body_.goals) {
    goal_names_.push_back(bridge_->Import(goal.pattern.predicate()));
  }
  host_ = std::make_unique<AttachmentHost>(body_, *bridge_);
  ProgramText text;
  logic::Diagnostics diagnostics;
  for (const auto& file : body_.files) ReadProgramFile(file, text, diagnostics);
  if (!diagnostics.empty()) return diagnostics;
  Loaded loaded;
  diagnostics = Compile(std::move(text), loaded);
  if (!diagnostics.empty()) return diagnostics;
  loaded_ = std::move(loaded);
  host_->Serve(*loaded_.interpreter, loaded_.file->program);
  latch_facts_.clear();
  versions_.clear();
  latch_facts_.emplace_back(loaded_.interpreter->memory());
  if (!latch_facts_[0].Set(body_.facts, *bridge_, loaded_.interpreter->memory())) {
    diagnostics.push_back(Problem(body_.files.empty() ? "" : body_.files[0].string(),
                                  "the parameters do not get into memory", ""));
  }
  const logic::Diagnostics values =
      learning_->Serve(loaded_.file->program, names_, *loaded_.interpreter);
  diagnostics.insert(diagnostics.end(), values.begin(), values.end());
  return diagnostics;
}

logic::Diagnostics IcarusReasoner::Compile(ProgramText text, Loaded& loaded) {
  loaded.text = std::move(text);
  loaded.file = std::make_unique<ProgramFile>(loaded.text.Read());
  if (HasErrors(loaded.file->findings)) return ErrorsOf(loaded.file->findings);
  const Program& program = loaded.file->program;
  if (!program.top) {
    return {Problem(program.source.file,
                    "the program does not say which call its cycles begin with",
                    "add (top (Skill argument ...))")};
  }
  SpellNames(program);
  loaded.interpreter = std::make_unique<Interpreter>(program, *host_, names_, options_);
  Findings findings = loaded.interpreter->findings();
  loaded.top = loaded.interpreter->AddTop(findings);
  if (!program.nevers.empty() && !HasErrors(findings)) {
    loaded.admission = std::make_unique<Admission>(body_, *bridge_, names_, program, options_);
    findings.insert(findings.end(), loaded.admission->findings().begin(),
                    loaded.admission->findings().end());
  }
  Settle(program.source, findings);
  return ErrorsOf(findings);
}

void IcarusReasoner::SpellNames(const Program& program) {
  const auto spell = [&](const Term& term) {
    if (term.kind != TermKind::kSymbol || term.form == kNoForm) return;
    bridge_->Spell(names_.Intern(term.text), program.source.Text(term.form));
  };
  for (const Term& fact : program.facts) WalkTerm(fact, spell);
  for (const Constant& constant : program.constants) WalkTerm(constant.value, spell);
  for (const Skill& skill : program.skills) {
    WalkTerms(skill, [&](const Term& term, Slot) { spell(term); });
  }
  WalkNameless(program, [&](const Skill& skill) {
    WalkTerms(skill, [&](const Term& term, Slot) { spell(term); });
  });
}

void IcarusReasoner::Adopt(Loaded loaded, std::size_t first_fact) {
  loaded.interpreter->TakeOver(*loaded_.interpreter, first_fact);
  Loaded before = std::move(loaded_);
  loaded_ = std::move(loaded);
  host_->Serve(*loaded_.interpreter, loaded_.file->program);
  learning_->Serve(loaded_.file->program, names_, *loaded_.interpreter);
  loaded_.interpreter->SetSink(watch_);
  stopped_.clear();
  conclusions_ = 0;
  last_ = nullptr;
}

logic::Diagnostics IcarusReasoner::Tell(std::string_view text) {
  ProgramText whole = loaded_.text;
  Findings findings;
  whole.Tell(std::string(text), std::string(kTold), findings);
  if (HasErrors(findings)) return ErrorsOf(findings);
  const std::uint32_t begin = whole.last_begin();
  Loaded loaded;
  logic::Diagnostics diagnostics = Compile(std::move(whole), loaded);
  if (!diagnostics.empty()) return diagnostics;
  const Program& program = loaded.file->program;
  const auto first =
      std::find_if(program.facts.begin(), program.facts.end(),
                   [&](const Term& fact) { return program.source.at(fact.form).begin >= begin; });
  const auto index = static_cast<std::size_t>(first - program.facts.begin());
  Adopt(std::move(loaded), index);
  return {};
}

logic::Diagnostics IcarusReasoner::Retract(std::string_view name) {
  const Program& program = loaded_.file->program;
  const std::uint32_t skill = program.Find(name);
  logic::Diagnostics diagnostics;
  const auto refuse = [&](const Clause& clause, Slot) {
    if (skill == kNoSkill || clause.kind != ClauseKind::kSkill || clause.skill != skill) return;
    diagnostics.push_back(
        {program.source.Place(clause.form),
         "the skill '" + program.skills[skill].spelling + "' is called here",
         "retract what calls it before",
         std::string(program.source.LineAt(program.source.at(clause.form).begin))});
  };
  for (std::uint32_t i = 0; i < program.skills.size(); ++i) {
    if (i != skill) WalkClauses(program.skills[i], refuse);
  }
  WalkNameless(program, [&](const Skill& nameless) { WalkClauses(nameless, refuse); });
  if (!diagnostics.empty()) return diagnostics;
  ProgramText rest = loaded_.text;
  if (!rest.Remove(name)) {
    std::vector<std::string> known;
    for (const Skill& each : program.skills) known.push_back(each.spelling);
    const std::string_view nearest = logic::NearestName(name, known);
    return {Problem(std::string(kTold), "there is no skill or constant '" + std::string(name) + "'",
                    nearest.empty() ? "" : "did you mean '" + std::string(nearest) + "'?")};
  }
  Loaded loaded;
  diagnostics = Compile(std::move(rest), loaded);
  if (diagnostics.empty()) {
    const std::size_t facts = loaded.file->program.facts.size();
    Adopt(std::move(loaded), facts);
  }
  return diagnostics;
}

bool IcarusReasoner::SetLatches(std::span<const sdk::Latch> latches) {
  FactStore& memory = loaded_.interpreter->memory();
  memory.Tidy();
  while (versions_.size() < latches.size()) {
    versions_.push_back(latches[versions_.size()].version + 1);
    latch_facts_.emplace_back(memory);
  }
  bool whole = true;
  for (std::size_t i = 0; i < latches.size(); ++i) {
    if (versions_[i] == latches[i].version) continue;
    versions_[i] = latches[i].version;
    whole = latch_facts_[i + 1].Set(latches[i].facts, *bridge_, memory) && whole;
  }
  return whole;
}

void IcarusReasoner::Decide(std::span<const sdk::Latch> latches, const sdk::Budget& budget,
                            sdk::Decision& decision) {
  decision.limit = sdk::Limit::kNone;
  decision.assumptions.clear();
  decision.message.clear();
  problem_.clear();
  if (!SetLatches(latches)) problem_ = "not all facts of the latches get into memory";
  host_->ResetCalls();
  limits_.depth = budget.depth;
  limits_.clauses = budget.inferences;
  limits_.cancelled = budget.cancelled;
  limits_.deadline = budget.deadline;
  learning_->Before(latches);
  if (watch_ != nullptr) watch_->OnBegin(loaded_.interpreter->memory());
  const CycleResult& result = loaded_.interpreter->Cycle(loaded_.top, limits_);
  if (watch_ != nullptr) watch_->OnEnd(result, loaded_.interpreter->memory());
  learning_->After(result);
  limits_.cancelled = nullptr;
  limits_.deadline.reset();
  last_ = &result;
  Conclude(result, decision);
  Judge(result, decision);
  decision.statistics.inferences = result.clauses;
  decision.statistics.depth = result.depth;
  decision.statistics.attachment_calls = host_->calls();
}

void IcarusReasoner::Conclude(const CycleResult& result, sdk::Decision& decision) {
  conclusions_ = 0;
  origins_.clear();
  for (std::size_t i = 0; i < result.acts.size(); ++i) {
    for (std::size_t j = 0; j < result.acts[i].calls.size(); ++j) {
      ConcludeCall(result.acts[i].calls[j], {i, j}, decision);
    }
  }
  decision.conclusions.resize(conclusions_);
}

std::size_t IcarusReasoner::GoalOf(const ActCall& call) const {
  for (std::size_t i = 0; i < goal_names_.size(); ++i) {
    if (goal_names_[i] == call.function &&
        body_.goals[i].pattern.arity() == call.arguments.size()) {
      return i;
    }
  }
  return kNoGoal;
}

void IcarusReasoner::ConcludeCall(const ActCall& call, Origin origin, sdk::Decision& decision) {
  const std::size_t goal = GoalOf(call);
  if (goal == kNoGoal) return;  // It changed memory.
  terms_.resize(call.arguments.size());
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    if (bridge_->Export(call.arguments[i], terms_[i])) continue;
    if (problem_.empty()) {
      problem_ = "argument " + std::to_string(i + 1) + " of {" +
                 std::string(names_.Name(call.function)) + "}, " +
                 ToString(call.arguments[i], names_) + ", cannot stand in a fact";
    }
    return;
  }
  fact_ = logic::Fact(body_.goals[goal].pattern.predicate(), terms_);
  AddConclusion(goal, origin, decision);
}

/// By goal, then in the order of the acts; each once.
void IcarusReasoner::AddConclusion(std::size_t goal, Origin origin, sdk::Decision& decision) {
  std::size_t at = conclusions_;
  for (; at > 0 && decision.conclusions[at - 1].goal >= goal; --at) {
    const sdk::Conclusion& known = decision.conclusions[at - 1];
    if (known.goal == goal && known.fact == fact_) return;
  }
  while (at < conclusions_ && decision.conclusions[at].goal == goal) ++at;
  if (conclusions_ == decision.conclusions.size()) decision.conclusions.emplace_back();
  sdk::Conclusion& made = decision.conclusions[conclusions_];
  made.goal = goal;
  made.fact = fact_;
  made.assumptions.clear();
  origins_.push_back(origin);
  const auto shift = [&](auto& list) {
    const auto begin = list.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = list.begin() + static_cast<std::ptrdiff_t>(conclusions_) + 1;
    std::rotate(begin, end - 1, end);
  };
  shift(decision.conclusions);
  shift(origins_);
  facts_.resize(conclusions_ + 1);
  for (std::size_t i = at; i <= conclusions_; ++i) facts_[i] = decision.conclusions[i].fact;
  ++conclusions_;
}

void IcarusReasoner::Judge(const CycleResult& result, sdk::Decision& decision) {
  const std::string fault = result.faults.empty() ? problem_ : Text(result.faults.front());
  switch (result.limit) {
    case LimitHit::kNone:
      decision.status = conclusions_ > 0 ? sdk::Status::kProved : sdk::Status::kRefuted;
      break;
    case LimitHit::kDepth:
      decision.limit = sdk::Limit::kDepth;
      break;
    case LimitHit::kClauses:
      decision.limit = sdk::Limit::kInferences;
      break;
    case LimitHit::kTime:
      decision.limit = sdk::Limit::kTime;
      break;
    case LimitHit::kCancelled:
      decision.limit = sdk::Limit::kCancelled;
  }
  if (decision.limit != sdk::Limit::kNone) decision.status = sdk::Status::kUnknown;
  decision.message = fault;
  const bool offended = options_.faults != FaultMode::kFalse && !problem_.empty();
  if (!offended && !(result.is_aborted && decision.limit == sdk::Limit::kNone)) return;
  if (options_.faults == FaultMode::kStop && stopped_.empty()) stopped_ = fault;
  if (decision.message.empty()) decision.message = stopped_;
  decision.status = sdk::Status::kFailed;
  decision.conclusions.clear();
  conclusions_ = 0;
}

std::string IcarusReasoner::Text(const Fault& fault) const {
  std::string text;
  if (!fault.in_top && fault.form != kNoForm) {
    const logic::SourcePlace at = loaded_.file->program.source.Place(fault.form);
    text = at.file + ':' + std::to_string(at.line) + ':' + std::to_string(at.column) + ": ";
  }
  text += fault.message;
  for (std::size_t i = 0; i < fault.skills.size(); ++i) {
    text += (i == 0 ? " (in " : " < ") + fault.skills[i];
  }
  if (!fault.skills.empty()) text += ')';
  return text;
}

sdk::Derivation IcarusReasoner::Explain(std::size_t conclusion) {
  if (last_ == nullptr || conclusion >= conclusions_) return {};
  const ActCall& call = last_->acts[origins_[conclusion].act].calls[origins_[conclusion].call];
  Explanation explanation(loaded_.file->program, *bridge_, names_, call,
                          logic::ToString(facts_[conclusion]));
  loaded_.interpreter->Replay(loaded_.top, limits_, explanation);
  return explanation.Take();
}

void IcarusReasoner::SetWatch(CycleWatch* watch) {
  watch_ = watch;
  loaded_.interpreter->SetSink(watch);
}

void IcarusReasoner::Admit(std::span<const sdk::Latch> latches, std::size_t port,
                           std::span<const logic::Fact> batch, const sdk::Budget& budget,
                           std::vector<sdk::Refusal>& refused) {
  if (loaded_.admission == nullptr) return;
  loaded_.admission->Admit(latches, port, batch, budget, refused);
}

}  // namespace latchwork::icarus
