// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/search/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace latchwork::pttp {

Engine::Engine(logic::SymbolTable& symbols, const EngineOptions& options)
    : options_(options),
      arithmetic_(symbols),
      functors_(arithmetic_, options.reals),
      predicates_(arithmetic_, symbols.Intern("=")),
      facts_(predicates_, functors_),
      compiler_(predicates_, functors_, symbols.Intern("=")),
      builder_(heap_),
      tables_(MakeWorkshop()) {
  facts_.AddSource("body");
  program_ = std::make_unique<Program>();
}

Workshop Engine::MakeWorkshop() {
  Workshop workshop;
  workshop.predicates = &predicates_;
  workshop.facts = &facts_;
  workshop.functors = &functors_;
  workshop.heap = &heap_;
  workshop.meter = &meter_;
  workshop.failures = &failures_;
  workshop.oracles = this;
  workshop.unique_names = options_.unique_names;
  workshop.reorder = options_.reorder;
  return workshop;
}

void Engine::DeclareInput(const logic::PredicateName& name) {
  predicates_[predicates_.Number(name)].has_facts = true;
}

void Engine::DeclareMinimized(const sdk::Minimized& minimized) {
  predicates_[predicates_.Number(minimized.predicate)].minimized = minimized.depth;
}

void Engine::DeclareAttachment(std::shared_ptr<sdk::Attachment> attachment,
                               logic::SymbolTable& symbols) {
  const auto& signature = attachment->signature();
  const std::size_t arity = signature.arguments.size();
  auto& info = predicates_[predicates_.Number({symbols.Intern(signature.predicate), arity})];
  info.kind = PredicateKind::kAttachment;
  info.attachment = static_cast<std::uint32_t>(attachments_.size());
  for (std::size_t i = 0; i < std::min<std::size_t>(arity, 64); ++i) {
    if (signature.arguments[i].mode == sdk::Attachment::Mode::kIn) {
      info.inputs |= std::uint64_t{1} << i;
    }
  }
  attachments_.push_back({std::move(attachment), {}, 0});
}

void Engine::SetTheory(std::vector<logic::Clause> clauses, std::span<const logic::Fact> facts) {
  FactSource& body = facts_.source(kBodySource);
  facts_.Clear(body);
  for (const logic::Fact& fact : facts) facts_.Add(body, fact);
  for (const logic::Clause& clause : clauses) {
    if (compiler_.IsFact(clause)) facts_.Add(body, clause.literals.front().atom);
  }
  program_ = compiler_.Compile(std::move(clauses));
  ForgetReaches();
}

void Engine::ForgetReaches() {
  reaches_.clear();
  ++reach_version_;
}

std::size_t Engine::AddSource(std::string name) {
  facts_.AddSource(std::move(name));
  return facts_.sources() - 1;
}

void Engine::SetFacts(std::size_t source, std::span<const logic::Fact> facts) {
  if (facts_.Replace(facts_.source(source), facts)) ForgetReaches();
}

void Engine::AddFact(std::size_t source, const logic::Fact& fact) {
  if (facts_.Add(facts_.source(source), fact)) ForgetReaches();
}

void Engine::Begin(const sdk::Budget& budget) {
  constexpr std::size_t kMostAsked = 256;
  if (asked_.size() > kMostAsked) asked_.clear();
  heap_.Clear();
  results_.Clear();
  meter_.Start(budget);
  failures_.Clear();
  tables_.Begin();
  depth_ = 0;
  ++decision_;
  seen_.Clear();
  nested_seen_.Clear();
  asks_ = false;
  asked_assumptions_.clear();
  adopted_ = 0;
  closed_.Clear();
  closings_.clear();
  computed_.Clear();
  computations_.clear();
  computing_ = nullptr;
  grounding_ = false;
  for (AttachmentEntry& entry : attachments_) entry.used = 0;
  assumptions_.clear();
  attachment_calls_ = 0;
  bound_hit_ = false;
  obstacle_.clear();
}

void Engine::CompileQuery(std::span<const logic::Literal> query, std::size_t variables,
                          Arena& arena, Contrapositive& target) {
  compiler_.CompileQuery(query, variables, arena, target);
}

const Reach& Engine::ReachFor(std::span<const Contrapositive* const> starts, bool closing) {
  return FindReachFor(starts, closing).reach;
}

Engine::KnownReach& Engine::FindReachFor(std::span<const Contrapositive* const> starts,
                                         bool closing) {
  reach_key_.assign(1, closing ? 1 : 0);
  for (const Contrapositive* start : starts) {
    for (const CompiledLiteral& literal : start->body) {
      reach_key_.push_back(Signed(literal.predicate, literal.positive));
    }
    reach_key_.push_back(kNoClause);
  }
  for (const auto& known : reaches_) {
    if (known->key == reach_key_) return *known;
  }
  reaches_.push_back(std::make_unique<KnownReach>(KnownReach{
      reach_key_, FindReach(*program_, predicates_, starts, closing), nullptr, nullptr}));
  KnownReach& made = *reaches_.back();
  made.program =
      std::make_unique<TableProgram>(predicates_, functors_, made.reach, options_.reorder);
  if (!options_.tables) made.program->GiveUp();
  if (options_.states && made.reach.recursive) {
    made.plan_space = std::make_unique<PlanSpace>(predicates_, made.reach);
    if (!made.plan_space->rules().fits()) made.plan_space.reset();
  }
  return made;
}

SearchEnd Engine::Search(const SearchRequest& request, ProofSink& sink) {
  Nest* nest = EnterNest();
  if (nest == nullptr) return SearchEnd::kUndetermined;
  const SearchEnd end = nest->machine.Search(request, sink);
  --depth_;
  NoteEnd(end, nest->machine);
  return end;
}

Engine::Nest* Engine::EnterNest() {
  constexpr std::size_t kDeepestNest = 64;
  if (depth_ == kDeepestNest) {
    obstacle_ = "closing and attachments ask each other too deeply";
    return nullptr;
  }
  if (depth_ == nests_.size()) {
    nests_.push_back(std::make_unique<Nest>(MakeWorkshop()));
  }
  return nests_[depth_++].get();
}

void Engine::NoteEnd(SearchEnd end, const Machine& machine) {
  if (end == SearchEnd::kDepth) bound_hit_ = true;
  if (machine.floundered()) {
    NoteObstacle("instantiation: an argument never became ground in a literal of",
                 machine.floundered_predicate());
  }
}

void Engine::NoteObstacle(std::string_view what, PredicateId predicate) {
  if (!obstacle_.empty()) return;
  obstacle_ = fmt::format("{} {}", what, ToString(predicates_[predicate].name));
}

logic::Atom Engine::Instance(const CompiledLiteral& literal, const Word* slots) {
  variables_.clear();
  return Instance(literal, slots, variables_);
}

logic::Atom Engine::Instance(const Node& node) const {
  variables_.clear();
  return Instance(node, variables_);
}

logic::Atom Engine::Instance(const CompiledLiteral& literal, const Word* slots,
                             std::vector<Word>& variables) {
  const logic::Symbol symbol = predicates_[literal.predicate].name.symbol;
  const auto instance = [&](std::uint32_t i) {
    return Value(builder_.Build(literal.arguments[i], slots), variables);
  };
  if (literal.arity > logic::Atom::kInlineArguments) {
    std::vector<logic::Term> terms;
    for (std::uint32_t i = 0; i < literal.arity; ++i) terms.push_back(instance(i));
    return {symbol, terms};
  }
  std::array<logic::Term, logic::Atom::kInlineArguments> terms;
  for (std::uint32_t i = 0; i < literal.arity; ++i) terms[i] = instance(i);
  return {symbol, std::span<const logic::Term>(terms.data(), literal.arity)};
}

logic::Atom Engine::Instance(const Node& node, std::vector<Word>& variables) const {
  std::vector<logic::Term> terms;
  for (std::uint32_t i = 0; i < node.literal->arity; ++i) {
    terms.push_back(functors_.Export(node.arguments[i], variables));
  }
  return {predicates_[node.literal->predicate].name.symbol, terms};
}

}  // namespace latchwork::pttp
