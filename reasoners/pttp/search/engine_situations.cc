// SPDX-License-Identifier: BSD-3-Clause
// Goals about situations: the ground rules of a decision, and the search that uses them.
#include <algorithm>

#include "reasoners/pttp/search/engine.h"

namespace latchwork::pttp {

/// Finds every fluent that can hold somewhere, actions and frame rules applied without regard to
/// what they undo, and with them the ground rules: semi-naive evaluation, the fluents found last
/// standing in for one literal at a time.
class Engine::Grounder final : public ProofSink {
 public:
  Grounder(Engine& engine, PlanSpace& space, std::uint32_t depth)
      : engine_(engine),
        space_(space),
        ground_(space.situations().ground()),
        depth_(depth),
        builder_(scratch_) {}

  bool Run() {
    MakeQueries();
    space_.situations().Clear();
    ForEachStandIn([&](PredicateId predicate) { TableOf(predicate).Clear(); });
    CollectFacts();
    for (const auto& queries : space_.queries()) {
      if (queries->body.empty() && !Solve(*queries, 0)) return false;
    }
    while (!found_.empty()) {
      if (!SolveForFound()) return false;
    }
    return !unfit_;
  }

  bool Accept(const Proof& proof) override {
    const Arena::Mark mark = scratch_.mark();
    AddInstance(proof);
    scratch_.Release(mark);
    unfit_ = unfit_ || ground_.too_many();
    space_.hopeless = space_.hopeless || ground_.too_many();
    return unfit_;
  }

 private:
  void MakeQueries() {
    if (!space_.queries().empty()) return;
    for (const PredicateId fluent : space_.rules().fluents()) engine_.StandInsFor(fluent);
    for (const FluentRule& rule : space_.rules().rules()) {
      space_.queries().push_back(MakeFluentQueries(space_.rules(), rule, engine_.stand_ins_));
    }
  }

  template <typename Visit>
  void ForEachStandIn(Visit&& visit) {
    for (const PredicateId fluent : space_.rules().fluents()) {
      visit(engine_.stand_ins_[fluent].all);
      visit(engine_.stand_ins_[fluent].fresh);
    }
  }
  FactTable& TableOf(PredicateId stand_in) {
    return *engine_.facts_.Tables(stand_in).front().table;
  }

  void CollectFacts() {
    for (const PredicateId fluent : space_.rules().fluents()) {
      for (const FactStore::Entry& entry : engine_.facts_.Tables(fluent)) {
        if (!entry.source->enabled) continue;
        for (std::uint32_t row = 0; row < entry.table->rows(); ++row) {
          AddFact(fluent, {entry.table->row(row), entry.table->arity()});
        }
      }
    }
  }

  void AddFact(PredicateId fluent, std::span<const Word> row) {
    const std::uint32_t position = space_.rules().PositionOf(fluent);
    if (TagOf(row[position]) == Tag::kCompound) {
      unfit_ = true;
      return;
    }
    arguments_.assign(row.begin(), row.end());
    arguments_.erase(arguments_.begin() + position);
    space_.situations().AddInitially(row[position], EnterAtom(fluent));
  }

  /// `arguments_`, without the situation.
  std::uint32_t EnterAtom(PredicateId fluent) {
    const auto entered = ground_.EnterAtom(fluent, arguments_);
    unfit_ = unfit_ || !entered.ground;
    if (entered.added) found_.push_back(entered.number);
    return entered.number;
  }

  bool SolveForFound() {
    for (const std::uint32_t atom : found_) {
      const StandIns& stand_ins = engine_.stand_ins_[ground_.atom(atom).predicate];
      for (const PredicateId predicate : {stand_ins.all, stand_ins.fresh}) {
        FactTable& table = TableOf(predicate);
        std::copy_n(ground_.atom(atom).arguments, table.arity(), table.AddRow());
      }
    }
    found_.clear();
    for (const auto& queries : space_.queries()) {
      for (std::size_t i = 0; i < queries->body.size(); ++i) {
        const PredicateId fresh = queries->queries[i]->clause.body.front().predicate;
        if (TableOf(fresh).rows() != 0 && !Solve(*queries, i)) return false;
      }
    }
    for (const PredicateId fluent : space_.rules().fluents()) {
      TableOf(engine_.stand_ins_[fluent].fresh).Clear();
    }
    return true;
  }

  bool Solve(FluentQueries& queries, std::size_t index) {
    queries_ = &queries;
    // Actions of frame rules keep slots that nothing binds.
    slots_ = ground_.terms().Allocate(queries.slots);
    for (std::uint32_t i = 0; i < queries.slots; ++i) slots_[i] = Reference(slots_ + i);
    const SearchEnd end = engine_.Solve(*queries.queries[index], Wanted::kAll, depth_, *this);
    return end == SearchEnd::kExhausted && !unfit_;
  }

  void Build(const std::vector<Word>& words) {
    arguments_.clear();
    for (const Word word : words) arguments_.push_back(builder_.Build(word, slots_));
  }

  void AddInstance(const Proof& proof) {
    const FluentRule& fluent = *queries_->rule;
    for (std::uint32_t i = 0; i < queries_->bound; ++i) slots_[i] = Dereference(proof.slots[i]);
    GroundRule rule;
    rule.kind = fluent.kind;
    rule.frame = fluent.frame;
    body_.clear();
    for (std::size_t i = 0; i < queries_->body.size(); ++i) {
      Build(queries_->body[i]);
      const PredicateId fluent_of = fluent.rule->body[fluent.fluents[i]].predicate;
      body_.push_back(EnterAtom(fluent_of));
    }
    Build(queries_->head);
    rule.head = EnterAtom(fluent.rule->head.predicate);
    if (fluent.kind == FluentRule::Kind::kInitial) {
      space_.situations().AddInitially(queries_->about, rule.head);
      rule.action = space_.situations().NumberOfOrigin(queries_->about);
    } else if (fluent.kind == FluentRule::Kind::kSuccessor) {
      Build(queries_->action);
      const auto entered = ground_.EnterAction(queries_->about, arguments_);
      unfit_ = unfit_ || entered.number == kNoEntry || (!fluent.frame && !entered.ground);
      rule.action = entered.number;
    }
    assumptions_.clear();
    for (const Resting* rest = proof.resting; rest != nullptr; rest = rest->previous) {
      assumptions_.push_back(rest->assumption);
    }
    if (!unfit_) ground_.AddRule(rule, body_, assumptions_);
  }

  Engine& engine_;
  PlanSpace& space_;
  GroundRules& ground_;
  std::uint32_t depth_;
  Arena scratch_;
  Unifier builder_;
  const FluentQueries* queries_ = nullptr;
  Word* slots_ = nullptr;
  std::vector<std::uint32_t> found_;  ///< Atoms that the rules have not seen.
  std::vector<Word> arguments_;
  std::vector<std::uint32_t> body_;
  std::vector<std::size_t> assumptions_;
  bool unfit_ = false;
};

const StandIns& Engine::StandInsFor(PredicateId fluent) {
  if (hidden_ == nullptr) {
    hidden_ = &facts_.AddSource("fluents");
    hidden_->is_scratch = true;
  }
  if (fluent >= stand_ins_.size()) stand_ins_.resize(fluent + 1);
  StandIns& stand_ins = stand_ins_[fluent];
  if (stand_ins.all != stand_ins.fresh) return stand_ins;
  logic::PredicateName name = predicates_[fluent].name;
  --name.arity;
  stand_ins = {predicates_.AddHidden(name), predicates_.AddHidden(name)};
  facts_.AddHiddenTable(*hidden_, stand_ins.all);
  facts_.AddHiddenTable(*hidden_, stand_ins.fresh);
  return stand_ins;
}

bool Engine::MakeSituations(PlanSpace& space, std::uint32_t depth) {
  if (space.hopeless || grounding_) return false;
  if (space.decision == decision_) return space.made;
  space.decision = decision_;
  space.made = false;
  grounding_ = true;
  Grounder grounder(*this, space, depth);
  space.made = grounder.Run();
  grounding_ = false;
  if (space.made) space.situations().Begin();
  return space.made;
}

std::optional<SearchEnd> Engine::SolveBySituations(Query& query, Wanted wanted, std::uint32_t depth,
                                                   bool record, ProofSink& sink) {
  const SituationUse& use = query.use;
  if (query.plan_space == nullptr || !use.plans || use.blocked) return std::nullopt;
  if (wanted == Wanted::kFirst ? !use.joins : !use.clean) return std::nullopt;
  const bool was_clear = obstacle_.empty();
  if (MakeSituations(*query.plan_space, depth)) {
    query.request.reach = &query.plan_space->rules().reach();
    query.request.situations = &query.plan_space->situations();
    const SearchEnd end = SolveBySearch(query, depth, record, sink);
    query.request.reach = query.reach;
    query.request.situations = nullptr;
    if (end != SearchEnd::kDoubtful) return end;
  }
  if (was_clear) obstacle_.clear();
  if (meter_.stopped()) return SearchEnd::kStopped;
  return std::nullopt;
}

}  // namespace latchwork::pttp
