// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PTTP_ENGINE_H_
#define LATCHWORK_PTTP_ENGINE_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "latchwork/logic/arithmetic.h"
#include "latchwork/logic/clause.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/attachment.h"
#include "latchwork/sdk/decision.h"
#include "latchwork/sdk/reasoner.h"
#include "reasoners/pttp/plans/plan_space.h"
#include "reasoners/pttp/search/failure_cache.h"
#include "reasoners/pttp/search/machine.h"
#include "reasoners/pttp/search/meter.h"
#include "reasoners/pttp/search/oracles.h"
#include "reasoners/pttp/search/query.h"
#include "reasoners/pttp/tables/table_plan.h"
#include "reasoners/pttp/tables/tables.h"
#include "reasoners/pttp/terms/row_set.h"
#include "reasoners/pttp/terms/term_cache.h"
#include "reasoners/pttp/theory/compiler.h"
#include "reasoners/pttp/theory/facts.h"
#include "reasoners/pttp/theory/predicate_set.h"
#include "reasoners/pttp/theory/predicates.h"
#include "reasoners/pttp/theory/program.h"
#include "reasoners/pttp/theory/reach.h"

namespace latchwork::pttp {

struct EngineOptions {
  bool unique_names = false;
  bool reorder = true;
  bool cache_attachments = true;
  bool tables = true;
  bool states = true;
  /// Other than kRounded goes without `tables` and `states`, which compute with doubles.
  Reals reals = Reals::kRounded;
};

/// How many proofs of a query are wanted.
enum class Wanted : std::uint8_t { kFirst, kAll };

/// A compiled theory with its facts, and the searches in it. Everything that lasts for one decision
/// only lies in memory that the next one reuses.
class Engine final : public Oracles, private sdk::AttachmentContext {
 public:
  Engine(logic::SymbolTable& symbols, const EngineOptions& options);

  // What the theory consists of. Declarations come before the clauses.
  void DeclareInput(const logic::PredicateName& name);
  void DeclareMinimized(const sdk::Minimized& minimized);
  void DeclareAttachment(std::shared_ptr<sdk::Attachment> attachment, logic::SymbolTable& symbols);
  /// Replaces all clauses and the facts among them. `facts` come first.
  void SetTheory(std::vector<logic::Clause> clauses, std::span<const logic::Fact> facts);
  /// A source of facts beside the theory's own, and its content.
  std::size_t AddSource(std::string name);
  void SetFacts(std::size_t source, std::span<const logic::Fact> facts);
  void AddFact(std::size_t source, const logic::Fact& fact);
  const logic::Arithmetic& arithmetic() const { return arithmetic_; }
  FactSource& source(std::size_t index) { return facts_.source(index); }
  static constexpr std::size_t kBodySource = 0;

  /// Forgets what the last decision found out. The meter starts.
  void Begin(const sdk::Budget& budget);
  /// Compiles a conjunction to be proved; `target` is reused, its terms live as long as `arena`'s.
  void CompileQuery(std::span<const logic::Literal> query, std::size_t variables, Arena& arena,
                    Contrapositive& target);
  SearchEnd Search(const SearchRequest& request, ProofSink& sink);
  /// Valid until clauses change or a predicate has facts for the first time.
  const Reach& ReachFor(std::span<const Contrapositive* const> starts, bool closing);

  /// Finds out what can be known before the query is asked. False: it is beyond proof.
  bool Prepare(Query& query);
  /// With tables where they fit, else by search.
  SearchEnd Solve(Query& query, Wanted wanted, std::uint32_t depth, ProofSink& sink);
  /// By search, with the steps of its proof.
  SearchEnd SolveWithSteps(Query& query, std::uint32_t depth, ProofSink& sink);

  /// Whose facts a result rests on: those that queries have seen since the last call of Watch.
  void Watch();
  PredicateSet& Seen();
  /// What Solve was asked to assume since then: indices into the assumptions, with repetitions.
  const std::vector<std::size_t>& asked_assumptions() const { return asked_assumptions_; }
  /// A time for ChangedSince.
  std::uint64_t now() const { return facts_.now(); }
  bool HasChanged(const PredicateSet& seen, std::uint64_t since) const;
  /// Changes when what was found out about reaches is void.
  std::uint64_t reach_version() const { return reach_version_; }
  /// Takes over an assumption that still stands from an earlier decision.
  std::size_t Adopt(const sdk::Assumption& assumption);

  const Program& program() const { return *program_; }
  const Predicates& predicates() const { return predicates_; }
  PredicateId NumberOf(const logic::PredicateName& name) { return predicates_.Number(name); }
  Meter& meter() { return meter_; }
  const std::vector<sdk::Assumption>& assumptions() const { return assumptions_; }
  std::uint64_t attachment_calls() const { return attachment_calls_; }
  /// A nested search met its depth bound.
  bool bound_hit() const { return bound_hit_; }
  /// Why something could not be determined; "" when nothing was.
  const std::string& obstacle() const { return obstacle_; }

  /// The instance of a literal under the bindings of a proof. Variables left are numbered from 0.
  logic::Atom Instance(const CompiledLiteral& literal, const Word* slots);
  logic::Atom Instance(const Node& node) const;
  /// The same with variables numbered across several literals.
  logic::Atom Instance(const CompiledLiteral& literal, const Word* slots,
                       std::vector<Word>& variables);
  logic::Atom Instance(const Node& node, std::vector<Word>& variables) const;
  logic::Term Value(Word word, std::vector<Word>& variables) {
    return terms_.Export(word, variables);
  }

  // Oracles
  Closing Close(PredicateId predicate, std::span<const Word> arguments) override;
  Computed* Compute(PredicateId predicate, std::span<const Word> arguments) override;

 private:
  /// One search inside another has its own machine and buffers.
  struct Nest {
    explicit Nest(const Workshop& workshop) : machine(workshop) {}
    Machine machine;
    Contrapositive start;
    SearchRequest request;
    RowSet answers;
    std::vector<logic::Term> terms;
  };
  struct KnownReach {
    std::vector<std::uint32_t> key;
    Reach reach;
    std::unique_ptr<TableProgram> program;
    std::unique_ptr<PlanSpace> plan_space;
  };
  struct ClosingRecord {
    Closing closing;
    bool open = true;
  };
  struct AttachmentEntry {
    std::shared_ptr<sdk::Attachment> attachment;
    std::vector<std::unique_ptr<Computed>> pool;
    std::size_t used = 0;
  };
  class NestGuard;
  class ProvedSink;
  class AnswerKeeper;
  class OutputCollector;
  class Grounder;

  void ForEachProvable(std::span<const logic::Literal> query, std::size_t variables,
                       sdk::AnswerSink& sink) override;
  Closing CloseAnew(PredicateId predicate, std::span<const Word> arguments);
  SearchEnd CloseBySearch(PredicateId predicate, Query& query, std::span<const Word> arguments,
                          std::uint32_t depth);
  Query& ClosingQuery(PredicateId predicate);
  AskedQuery& FindAsked(std::span<const logic::Literal> literals, std::size_t variables);
  void AskAnew(AskedQuery& asked);
  std::optional<SearchEnd> SolveByTables(Query& query, std::span<const Word> given,
                                         ProofSink& sink);
  /// By situations that are told apart by what holds in them. Nothing: that cannot tell.
  std::optional<SearchEnd> SolveBySituations(Query& query, Wanted wanted, std::uint32_t depth,
                                             bool record, ProofSink& sink);
  bool MakeSituations(PlanSpace& space, std::uint32_t depth);
  const StandIns& StandInsFor(PredicateId fluent);
  SearchEnd SolveBySearch(Query& query, std::uint32_t depth, bool record, ProofSink& sink);
  KnownReach& FindReachFor(std::span<const Contrapositive* const> starts, bool closing);
  void ForgetReaches();
  Workshop MakeWorkshop();
  Computed* ComputeAnew(AttachmentEntry& entry, std::span<const Word> arguments, Nest& nest);
  bool InputsFit(const sdk::Attachment::Signature& signature,
                 std::span<const Word> arguments) const;
  Nest* EnterNest();
  void NoteEnd(SearchEnd end, const Machine& machine);
  void NoteObstacle(std::string_view what, PredicateId predicate);
  sdk::Assumption::State StateOf(SearchEnd end) const;

  EngineOptions options_;
  logic::Arithmetic arithmetic_;
  Functors functors_;
  TermCache terms_{functors_};
  Predicates predicates_;
  FactStore facts_;
  Compiler compiler_;
  std::unique_ptr<Program> program_;
  std::vector<std::unique_ptr<KnownReach>> reaches_;
  std::vector<std::uint32_t> reach_key_;
  std::uint64_t reach_version_ = 1;
  std::vector<std::unique_ptr<Query>> closing_queries_;                        ///< By predicate.
  std::unordered_multimap<std::uint64_t, std::unique_ptr<AskedQuery>> asked_;  ///< By hash.
  std::vector<AttachmentEntry> attachments_;

  Arena heap_;
  Unifier builder_;
  Arena results_;
  Meter meter_;
  FailureCache failures_;
  Tables tables_;
  FactSource* hidden_ = nullptr;     ///< Of the stand-ins.
  std::vector<StandIns> stand_ins_;  ///< By fluent.
  bool grounding_ = false;
  std::vector<std::unique_ptr<Nest>> nests_;
  std::size_t depth_ = 0;
  std::uint64_t decision_ = 0;
  PredicateSet seen_;
  PredicateSet nested_seen_;  ///< By closings and attachments of this decision.
  bool asks_ = false;
  std::vector<std::size_t> asked_assumptions_;
  std::size_t adopted_ = 0;  ///< How many of the assumptions were.
  VariantTable closed_;
  std::vector<ClosingRecord> closings_;
  VariantTable computed_;
  std::vector<Computed*> computations_;
  Computed* computing_ = nullptr;
  std::vector<sdk::Assumption> assumptions_;
  std::uint64_t attachment_calls_ = 0;
  bool bound_hit_ = false;
  std::string obstacle_;
  mutable std::vector<Word> variables_;
};

}  // namespace latchwork::pttp

#endif  // LATCHWORK_PTTP_ENGINE_H_
