// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_EVALUATION_EVALUATOR_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_EVALUATION_EVALUATOR_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "latchwork/sdk/reasoner.h"
#include "reasoners/circumscription/evaluation/fact_table.h"
#include "reasoners/circumscription/evaluation/instance_sink.h"
#include "reasoners/circumscription/evaluation/spending.h"
#include "reasoners/circumscription/rules/program.h"
#include "reasoners/circumscription/values/value.h"

namespace latchwork::circumscription {

/// A default that was asked for.
struct AskedDefault {
  std::uint32_t relation = 0;
  std::uint32_t row = 0;                      ///< In the table of what was asked.
  std::uint32_t contrary = FactTable::kNone;  ///< The fact that retracts it.
};

/// Evaluates the rules of a program stratum by stratum, recursive ones semi-naively, from the facts
/// of body and latches upward. The program is one for a certificate: what is found are the true
/// atoms of a model whose minimized atoms are those of every minimal model, whenever the end is
/// kModel. Keeps its memory from cycle to cycle. Not thread-safe.
class Evaluator {
 public:
  enum class End : std::uint8_t {
    kModel,
    kInconsistent,  ///< Facts and clauses alone contradict each other.
    kOpen,          ///< There may be other minimal worlds, or none: this needs a search.
    kSpent,         ///< The budget ran out.
    kRefused,       ///< An attachment cannot be evaluated: see refusal().
  };

  /// With a sink the program is one for grounding: what is found are the atoms that may be true,
  /// and the sink gets the instances of clauses over them.
  explicit Evaluator(Program& program, InstanceSink* sink = nullptr)
      : program_(program), sink_(sink) {}
  ~Evaluator() = default;
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  End Run(std::span<const logic::Fact> body, std::span<const sdk::Latch> latches,
          const sdk::Budget& budget);

  /// Fills the table of the query's relation with what the query gives in the model.
  void Answer(const Rule& query) { Start(query, 0); }

  const FactTable& table(std::size_t relation) const { return *tables_[relation]; }
  std::span<const FactRef> Premises(const FactInfo& info) const {
    return {premises_.data() + info.first_premise, info.premises};
  }
  std::span<const AskedDefault> defaults() const { return defaults_; }
  logic::Fact DefaultAtom(const AskedDefault& asked) const;
  logic::Fact FactOf(FactRef fact) const;
  const FactInfo& InfoOf(FactRef fact) const { return tables_[fact.relation]->info(fact.row); }
  const std::string& refusal() const { return refusal_; }
  const Spending& spending() const { return spending_; }
  /// For what is done besides, such as a search among the instances found.
  Spending& spending() { return spending_; }
  const Program& program() const { return program_; }
  const ValueBank& bank() const { return bank_; }
  /// Compound terms that it keeps.
  std::size_t terms() const { return bank_.size(); }
  void ForgetTerms() { bank_.Clear(); }

 private:
  class Context;
  struct Frame {
    const Rule* rule = nullptr;
    std::size_t base = 0;    ///< Of its variables in bindings_.
    std::size_t trail = 0;   ///< Of its premises in trail_.
    std::size_t newest = 0;  ///< The step, by ordinal, that takes what is new.
  };
  struct Window {
    std::uint32_t old = 0;
    std::uint32_t end = 0;
  };

  /// A call of an attachment in progress; kept for its memory.
  struct Invocation {
    std::size_t relation = 0;
    std::vector<Value> inputs;
    std::vector<logic::Term> terms;
    std::vector<Value> outputs;  ///< Tuples, one after the other.
    std::vector<FactRef> seen;   ///< What its queries found.
    std::vector<logic::Term> answer;
  };
  struct CompiledQuery {
    std::vector<logic::Literal> literals;
    std::size_t attachment = 0;
    Rule rule;
  };

  void Reset();
  void Grow();
  void AddFacts(std::span<const logic::Fact> facts, const FactInfo& info);
  bool Restratify();
  void EvaluateStrata();
  void EvaluateStratum(const Stratum& stratum, std::size_t number);
  void Close(const Stratum& stratum, std::size_t number);
  bool Advance(std::size_t stratum);
  End EndOfRun() const;

  void Start(const Rule& rule, std::size_t newest);
  void Continue(const Frame& frame, std::size_t step);
  void Join(const Frame& frame, std::size_t step);
  void Visit(const Frame& frame, std::size_t step, std::uint32_t row);
  void CheckAbsent(const Frame& frame, std::size_t step);
  void CallAttachment(const Frame& frame, std::size_t step);
  void Fire(const Frame& frame);
  void FireInstance(const Frame& frame);
  bool AddHeads(const Frame& frame);
  bool IsCertain(std::span<const FactRef> premises);
  FactInfo InfoOfInstance(const Frame& frame) const;
  void Violate(const Frame& frame);
  std::uint32_t AskDefault(std::size_t relation, std::uint32_t contrary);
  int RankOf(std::size_t relation) const;

  bool Match(const Pattern& pattern, const Value& value, std::size_t base);
  bool Build(const Pattern& pattern, std::size_t base, Value& value);
  bool Compute(const Pattern& pattern, std::size_t base, Value& value);
  bool Holds(const Step& step, std::size_t base);
  bool BuildCells(std::span<const Pattern> patterns, std::size_t base);

  bool TakeInputs(const Step& step, std::size_t base, Invocation& invocation);
  void Invoke(Invocation& invocation);
  void KeepOutputs(Invocation& invocation);
  void Query(std::span<const logic::Literal> query, std::size_t variables, sdk::AnswerSink& sink);
  const CompiledQuery* FindQuery(std::span<const logic::Literal> query, std::size_t variables);
  bool IsReady(const CompiledQuery& query);
  bool stops() const { return restart_ || !refusal_.empty() || spending_.is_spent(); }

  Program& program_;
  InstanceSink* sink_;
  ValueBank bank_;
  std::vector<std::unique_ptr<FactTable>> tables_;  ///< By relation.
  std::vector<std::unique_ptr<FactTable>> asked_;   ///< By relation: defaults.
  std::vector<std::unique_ptr<FactTable>> called_;  ///< By relation: inputs of attachments.
  std::vector<Window> windows_;                     ///< By relation.
  std::vector<Value> bindings_;
  std::vector<Value> cells_;      ///< Of the fact at hand.
  std::vector<Value> arguments_;  ///< Of compound terms being built.
  std::vector<FactRef> premises_;
  std::vector<FactRef> trail_;  ///< Premises of the instance at hand.
  std::vector<AskedDefault> defaults_;
  std::vector<Literal> literals_;  ///< Of the instance at hand, for the sink.
  std::vector<std::unique_ptr<CompiledQuery>> queries_;
  std::vector<std::unique_ptr<Invocation>> invocations_;
  std::size_t calling_ = 0;  ///< Of invocations_, how many are in progress.
  bool is_open_ = false;
  bool is_inconsistent_ = false;
  bool restart_ = false;  ///< The strata have changed.
  std::string refusal_;
  Spending spending_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_EVALUATION_EVALUATOR_H_
