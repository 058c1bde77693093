// SPDX-License-Identifier: BSD-3-Clause
// The searches inside a search: closing a minimized predicate, computing an attachment.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "reasoners/pttp/search/engine.h"
#include "reasoners/pttp/terms/row_set.h"

namespace latchwork::pttp {

/// Leaves the nest at the end of a scope, whatever ends it.
class Engine::NestGuard {
 public:
  explicit NestGuard(Engine& engine) : engine_(engine), depth_(engine.depth_) {}
  NestGuard(const NestGuard&) = delete;
  NestGuard& operator=(const NestGuard&) = delete;
  ~NestGuard() { engine_.depth_ = depth_; }

 private:
  Engine& engine_;
  std::size_t depth_;
};

class Engine::ProvedSink final : public ProofSink {
 public:
  bool Accept(const Proof& /*proof*/) override { return true; }
};

/// Keeps each distinct answer of a query that an attachment asks.
class Engine::AnswerKeeper final : public ProofSink {
 public:
  AnswerKeeper(Engine& engine, RowSet& known, AskedQuery& asked)
      : engine_(engine), known_(known), asked_(asked) {}

  bool Accept(const Proof& proof) override {
    const std::size_t variables = asked_.variables;
    const std::uint64_t hash = Export(proof);
    const bool ground = engine_.variables_.empty();
    engine_.bound_hit_ = engine_.bound_hit_ || !ground;
    const auto fresh = static_cast<std::uint32_t>(asked_.count);
    const auto is_same = [&](std::uint32_t number) {
      const logic::Term* known = asked_.answers.data() + number * variables;
      return std::equal(known, known + variables, asked_.answers.data() + fresh * variables);
    };
    if (!ground || known_.Enter(hash, fresh, is_same) != fresh) {
      asked_.answers.resize(fresh * variables);
      return false;
    }
    ++asked_.count;
    for (const Resting* resting = proof.resting; resting != nullptr; resting = resting->previous) {
      asked_.assumptions.push_back(resting->assumption);
    }
    return false;
  }

 private:
  /// Adds the values behind the answers; their hash.
  std::uint64_t Export(const Proof& proof) {
    std::uint64_t hash = 0;
    engine_.variables_.clear();
    for (std::size_t i = 0; i < asked_.variables; ++i) {
      const Word value = Dereference(proof.slots[i]);
      hash = MixHash(hash, ShallowHash(value));
      asked_.answers.push_back(engine_.Value(value, engine_.variables_));
    }
    return hash;
  }

  Engine& engine_;
  RowSet& known_;
  AskedQuery& asked_;
};

/// Turns the outputs of an attachment into rows.
class Engine::OutputCollector final : public sdk::AnswerSink {
 public:
  OutputCollector(Engine& engine, const sdk::Attachment::Signature& signature, Computed& computed,
                  std::span<const Word> arguments)
      : engine_(engine), signature_(signature), computed_(computed), arguments_(arguments) {}

  void Answer(std::span<const logic::Term> terms) override {
    Word* row = computed_.rows.AddRow();
    std::size_t output = 0;
    for (std::size_t i = 0; i < arguments_.size(); ++i) {
      if (signature_.arguments[i].mode == sdk::Attachment::Mode::kIn) {
        row[i] = Dereference(arguments_[i]);
      } else {
        if (output == terms.size()) Refuse("gave too few outputs");
        Check(terms[output]);
        row[i] = engine_.functors_.Import(terms[output++], engine_.results_);
      }
    }
    if (output != terms.size()) Refuse("gave too many outputs");
  }

 private:
  [[noreturn]] void Refuse(std::string_view what) const {
    throw std::runtime_error(fmt::format("attachment {} {}", signature_.predicate, what));
  }
  void Check(const logic::Term& term) const {
    if (!term.is_ground()) Refuse("gave an output that is not ground");
    if (term.is_number() && !std::isfinite(term.number())) {
      Refuse("gave a number that is not finite");
    }
  }

  Engine& engine_;
  const sdk::Attachment::Signature& signature_;
  Computed& computed_;
  std::span<const Word> arguments_;
};

sdk::Assumption::State Engine::StateOf(SearchEnd end) const {
  switch (end) {
    case SearchEnd::kAccepted:
      return sdk::Assumption::State::kRetracted;
    case SearchEnd::kDepth:
      return sdk::Assumption::State::kMadeByBound;
    default:
      return sdk::Assumption::State::kMade;
  }
}

Closing Engine::Close(PredicateId predicate, std::span<const Word> arguments) {
  const auto found = closed_.Enter(predicate, arguments);
  if (found.entry == kNoEntry) return {};
  if (found.added) {
    closings_.emplace_back();
    const Closing closing = CloseAnew(predicate, arguments);
    closings_[found.entry] = {closing, false};
  } else if (closings_[found.entry].open) {
    NoteObstacle("a default rests on itself: closing needs the closing of", predicate);
  }
  const Closing& closing = closings_[found.entry].closing;
  if (closing.result != Closing::Result::kUndetermined) {
    asked_assumptions_.push_back(closing.assumption);
  }
  return closing;
}

Query& Engine::ClosingQuery(PredicateId predicate) {
  if (predicate >= closing_queries_.size()) closing_queries_.resize(predicate + 1);
  auto& query = closing_queries_[predicate];
  if (query != nullptr) return *query;
  query = std::make_unique<Query>();
  query->is_given = true;
  const auto arity = static_cast<std::uint32_t>(predicates_[predicate].name.arity);
  Word* arguments = query->terms.Allocate(arity);
  for (std::uint32_t i = 0; i < arity; ++i) arguments[i] = SlotWord(i);
  query->clause.slots = arity;
  query->clause.body.push_back({predicate, true, arity, arguments, 0, 0});
  return *query;
}

SearchEnd Engine::CloseBySearch(PredicateId predicate, Query& query,
                                std::span<const Word> arguments, std::uint32_t depth) {
  const NestGuard guard(*this);
  Nest* nest = EnterNest();
  if (nest == nullptr) return SearchEnd::kUndetermined;
  Contrapositive& start = nest->start;
  start.body.assign(1,
                    CompiledLiteral{predicate, true, static_cast<std::uint32_t>(arguments.size()),
                                    arguments.data(), 0, 0});
  nest->request.starts.assign(1, &start);
  nest->request.reach = query.reach;
  nest->request.depth = depth;
  ProvedSink sink;
  const std::string& obstacle = obstacle_;
  const bool was_clear = obstacle.empty();
  const SearchEnd end = nest->machine.Search(nest->request, sink);
  if (end == SearchEnd::kAccepted) {
    if (was_clear) obstacle_.clear();
  } else if (nest->machine.floundered()) {
    NoteEnd(SearchEnd::kUndetermined, nest->machine);
  }
  return end;
}

Closing Engine::CloseAnew(PredicateId predicate, std::span<const Word> arguments) {
  Query& query = ClosingQuery(predicate);
  const std::uint32_t bound = predicates_[predicate].minimized.value_or(0);
  SearchEnd end = SearchEnd::kExhausted;
  if (Prepare(query)) {
    const std::uint32_t depth = bound == 0 ? meter_.budget().depth : bound;
    const bool unbounded = bound == 0 || (!query.reach->recursive && query.reach->height < bound);
    ProvedSink sink;
    const auto tabled = unbounded ? SolveByTables(query, arguments, sink) : std::nullopt;
    end = tabled ? *tabled : CloseBySearch(predicate, query, arguments, depth);
  }
  nested_seen_.AddAll(query.reach->sees);
  if (end == SearchEnd::kStopped || end == SearchEnd::kUndetermined) return {};
  const CompiledLiteral atom{predicate,        true, static_cast<std::uint32_t>(arguments.size()),
                             arguments.data(), 0,    0};
  sdk::Assumption assumption;
  assumption.state = StateOf(end);
  assumption.atom = Instance(atom, nullptr);
  Closing closing;
  closing.result =
      end == SearchEnd::kAccepted ? Closing::Result::kProved : Closing::Result::kAssumedFalse;
  closing.assumption = assumptions_.size();
  for (std::size_t i = 0; i < adopted_; ++i) {
    if (assumptions_[i].atom == assumption.atom) closing.assumption = i;
  }
  if (closing.assumption == assumptions_.size()) assumptions_.push_back(std::move(assumption));
  return closing;
}

namespace {

std::uint64_t HashOf(std::span<const logic::Literal> literals) {
  std::uint64_t hash = literals.size();
  for (const logic::Literal& literal : literals) {
    hash = MixHash(hash, literal.atom.predicate().index());
    for (const logic::Term& argument : literal.atom.arguments()) {
      using Kind = logic::Term::Kind;
      hash = MixHash(hash, static_cast<std::uint64_t>(argument.kind()));
      if (argument.kind() == Kind::kConstant) hash = MixHash(hash, argument.symbol().index());
      if (argument.is_number()) hash = MixHash(hash, std::bit_cast<Word>(argument.number()));
    }
  }
  return hash;
}

}  // namespace

AskedQuery& Engine::FindAsked(std::span<const logic::Literal> literals, std::size_t variables) {
  const std::uint64_t hash = HashOf(literals);
  const auto [first, last] = asked_.equal_range(hash);
  for (auto known = first; known != last; ++known) {
    AskedQuery& asked = *known->second;
    if (asked.variables == variables && std::equal(literals.begin(), literals.end(),
                                                   asked.literals.begin(), asked.literals.end())) {
      return asked;
    }
  }
  auto asked = std::make_unique<AskedQuery>();
  asked->literals.assign(literals.begin(), literals.end());
  asked->variables = variables;
  CompileQuery(literals, variables, asked->query.terms, asked->query.clause);
  return *asked_.emplace(hash, std::move(asked))->second;
}

void Engine::AskAnew(AskedQuery& asked) {
  const NestGuard guard(*this);
  asked.answers.clear();
  asked.assumptions.clear();
  asked.count = 0;
  asked.answered = false;
  asked.decision = decision_;
  Nest* nest = EnterNest();
  if (nest == nullptr) return;
  nest->answers.Clear();
  AnswerKeeper keeper(*this, nest->answers, asked);
  const SearchEnd end = Solve(asked.query, Wanted::kAll, meter_.budget().depth, keeper);
  nested_seen_.AddAll(asked.query.reach->sees);
  if (end == SearchEnd::kDepth) bound_hit_ = true;
  asked.answered = end == SearchEnd::kExhausted;
}

void Engine::ForEachProvable(std::span<const logic::Literal> query, std::size_t variables,
                             sdk::AnswerSink& sink) {
  AskedQuery& asked = FindAsked(query, variables);
  if (asked.decision != decision_ || !asked.answered) AskAnew(asked);
  if (computing_ != nullptr) {
    computing_->assumptions.insert(computing_->assumptions.end(), asked.assumptions.begin(),
                                   asked.assumptions.end());
  }
  for (std::size_t i = 0; i < asked.count; ++i) {
    sink.Answer({asked.answers.data() + i * variables, variables});
  }
}

bool Engine::InputsFit(const sdk::Attachment::Signature& signature,
                       std::span<const Word> arguments) const {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const auto& argument = signature.arguments[i];
    if (argument.mode != sdk::Attachment::Mode::kIn) continue;
    const Tag tag = TagOf(Dereference(arguments[i]));
    using Type = sdk::ArgumentType;
    const Type type = argument.spec.type;
    if (type == Type::kInteger && tag != Tag::kInteger) return false;
    if (type == Type::kReal && tag != Tag::kReal && tag != Tag::kInteger) return false;
    if (type == Type::kSymbol && tag != Tag::kConstant) return false;
  }
  return true;
}

Computed* Engine::Compute(PredicateId predicate, std::span<const Word> arguments) {
  AttachmentEntry& entry = attachments_[predicates_[predicate].attachment];
  const NestGuard guard(*this);
  Nest* nest = EnterNest();
  if (nest == nullptr) return nullptr;
  if (!options_.cache_attachments) return ComputeAnew(entry, arguments, *nest);
  // Outputs may be bound already; they are compared with what is computed, so they are no part of
  // the key.
  Word* inputs = heap_.Allocate(arguments.size());
  std::size_t count = 0;
  const auto& signature = entry.attachment->signature();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (signature.arguments[i].mode == sdk::Attachment::Mode::kIn) inputs[count++] = arguments[i];
  }
  const auto found = computed_.Enter(predicate, {inputs, count});
  if (found.entry == kNoEntry) return ComputeAnew(entry, arguments, *nest);
  if (found.added) {
    computations_.push_back(nullptr);
    computations_[found.entry] = ComputeAnew(entry, arguments, *nest);
  } else if (computations_[found.entry] == nullptr) {
    NoteObstacle("an attachment needs its own result:", predicate);
  }
  return computations_[found.entry];
}

Computed* Engine::ComputeAnew(AttachmentEntry& entry, std::span<const Word> arguments, Nest& nest) {
  if (entry.used == entry.pool.size()) {
    entry.pool.push_back(std::make_unique<Computed>(Computed{FactTable(arguments.size()), {}}));
  }
  Computed* computed = entry.pool[entry.used++].get();
  computed->rows.Clear();
  computed->assumptions.clear();
  const auto& signature = entry.attachment->signature();
  if (!InputsFit(signature, arguments)) return computed;
  nest.terms.clear();
  Word* kept = results_.Allocate(arguments.size());
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    kept[i] = Dereference(arguments[i]);
    if (signature.arguments[i].mode != sdk::Attachment::Mode::kIn) continue;
    nest.terms.push_back(Value(arguments[i], variables_));
    kept[i] = functors_.Import(nest.terms.back(), results_);
  }
  ++attachment_calls_;
  OutputCollector collector(*this, signature, *computed, {kept, arguments.size()});
  Computed* const outer = std::exchange(computing_, computed);
  entry.attachment->Call(nest.terms, *this, collector);
  computing_ = outer;
  return meter_.stopped() ? nullptr : computed;
}

}  // namespace latchwork::pttp
