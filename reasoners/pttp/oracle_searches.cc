// SPDX-License-Identifier: BSD-3-Clause
// The searches inside a search: closing a minimized predicate, computing an attachment.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "reasoners/pttp/engine.h"

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

/// Hands each distinct answer of a query on.
class Engine::AnswerForwarder final : public ProofSink {
 public:
  AnswerForwarder(Engine& engine, Nest& nest, std::size_t variables, sdk::AnswerSink& sink)
      : engine_(engine), nest_(nest), variables_(variables), sink_(sink) {}

  bool Accept(const Proof& proof) override {
    const auto found = nest_.answers.Enter(0, {proof.slots, variables_});
    if (!found.ground) {
      engine_.bound_hit_ = true;
      return false;
    }
    if (!found.added) return false;
    nest_.terms.clear();
    for (std::size_t i = 0; i < variables_; ++i) {
      nest_.terms.push_back(engine_.Value(proof.slots[i], engine_.variables_));
    }
    if (engine_.computing_ != nullptr) {
      for (const Resting* resting = proof.resting; resting != nullptr;
           resting = resting->previous) {
        engine_.computing_->assumptions.push_back(resting->assumption);
      }
    }
    sink_.Answer(nest_.terms);
    return false;
  }

 private:
  Engine& engine_;
  Nest& nest_;
  std::size_t variables_;
  sdk::AnswerSink& sink_;
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
  return closings_[found.entry].closing;
}

Closing Engine::CloseAnew(PredicateId predicate, std::span<const Word> arguments) {
  const NestGuard guard(*this);
  Nest* nest = EnterNest();
  if (nest == nullptr) return {};
  nest->query.has_head = false;
  nest->query.slots = 0;
  nest->query.body.assign(
      1, CompiledLiteral{predicate, true, static_cast<std::uint32_t>(arguments.size()),
                         arguments.data(), 0, 0});
  nest->request.starts.assign(1, &nest->query);
  nest->request.reach = &ReachFor(nest->request.starts, true);
  const std::uint32_t bound = predicates_[predicate].minimized.value_or(0);
  nest->request.depth = bound == 0 ? meter_.budget().depth : bound;
  ProvedSink sink;
  const std::string obstacle = obstacle_;
  const SearchEnd end = nest->request.reach->viable ? nest->machine.Search(nest->request, sink)
                                                    : SearchEnd::kExhausted;
  if (nest->machine.floundered() && end != SearchEnd::kAccepted) {
    NoteEnd(SearchEnd::kUndetermined, nest->machine);
  }
  if (end == SearchEnd::kStopped || end == SearchEnd::kUndetermined) return {};
  if (end == SearchEnd::kAccepted) obstacle_ = obstacle;
  Closing closing;
  closing.result =
      end == SearchEnd::kAccepted ? Closing::Result::kProved : Closing::Result::kAssumedFalse;
  closing.assumption = assumptions_.size();
  sdk::Assumption assumption;
  assumption.state = StateOf(end);
  assumption.atom = Instance(nest->query.body.front(), nullptr);
  assumptions_.push_back(std::move(assumption));
  return closing;
}

void Engine::ForEachProvable(std::span<const logic::Literal> query, std::size_t variables,
                             sdk::AnswerSink& sink) {
  const NestGuard guard(*this);
  Nest* nest = EnterNest();
  if (nest == nullptr) return;
  compiler_.CompileQuery(query, variables, heap_, nest->query);
  nest->request.starts.assign(1, &nest->query);
  nest->request.reach = &ReachFor(nest->request.starts, true);
  nest->request.depth = meter_.budget().depth;
  nest->answers.Clear();
  AnswerForwarder forwarder(*this, *nest, variables, sink);
  if (!nest->request.reach->viable) return;
  NoteEnd(nest->machine.Search(nest->request, forwarder), nest->machine);
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
