// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/evaluation/evaluator.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <climits>

namespace latchwork::circumscription {
namespace {

constexpr std::size_t kMaxCompounds = 1U << 16U;

}  // namespace

void Evaluator::Grow() {
  const Relations& relations = program_.relations();
  while (tables_.size() < relations.size()) {
    const std::size_t arity = relations[tables_.size()].name.arity;
    tables_.push_back(std::make_unique<FactTable>(arity, std::span<const std::size_t>()));
    asked_.push_back(std::make_unique<FactTable>(arity, std::span<const std::size_t>()));
    called_.push_back(nullptr);
  }
  windows_.resize(tables_.size());
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    for (const std::size_t column : relations[i].columns) tables_[i]->AddIndex(column);
  }
}

void Evaluator::Reset() {
  Grow();
  for (const auto& table : tables_) table->Clear();
  for (const auto& table : asked_) table->Clear();
  for (const auto& table : called_) {
    if (table) table->Clear();
  }
  if (sink_ == nullptr && bank_.size() > kMaxCompounds) bank_.Clear();
  premises_.clear();
  trail_.clear();
  bindings_.clear();
  arguments_.clear();
  defaults_.clear();
  calling_ = 0;
  is_open_ = is_inconsistent_ = restart_ = false;
}

void Evaluator::AddFacts(std::span<const logic::Fact> facts, const FactInfo& info) {
  for (const logic::Fact& fact : facts) {
    const std::size_t relation = program_.relations().Find(NameOf(fact));
    if (relation == kNoIndex) continue;
    cells_.clear();
    for (const logic::Term& term : fact.arguments()) cells_.push_back(bank_.Of(term));
    FactTable& table = *tables_[relation];
    const std::uint32_t row = table.Insert(cells_, info);
    const bool is_given = table.info(row).origin == FactInfo::Origin::kLatch;
    if (sink_ != nullptr && is_given) sink_->Give(relation, cells_);
  }
}

Evaluator::End Evaluator::Run(std::span<const logic::Fact> body,
                              std::span<const sdk::Latch> latches, const sdk::Budget& budget) {
  spending_.Begin(budget);
  refusal_.clear();
  do {
    Reset();
    AddFacts(body, {});
    for (std::size_t i = 0; i < latches.size(); ++i) {
      FactInfo info;
      info.origin = FactInfo::Origin::kLatch;
      info.source = static_cast<std::uint32_t>(i);
      AddFacts(latches[i].facts, info);
    }
    EvaluateStrata();
  } while (restart_ && Restratify());
  return EndOfRun();
}

bool Evaluator::Restratify() {
  program_.Stratify();
  const std::string name = program_.CircularAttachment();
  if (name.empty()) return true;
  refusal_ = fmt::format("attachment '{}' asks for what depends on its own answers", name);
  return false;
}

void Evaluator::EvaluateStrata() {
  const std::vector<Stratum>& strata = program_.strata();
  for (std::size_t i = 0; i < strata.size() && !stops(); ++i) EvaluateStratum(strata[i], i);
  for (const std::size_t rule : program_.constraints()) {
    if (stops() || is_inconsistent_) return;
    Start(program_.rules()[rule], 0);
  }
}

Evaluator::End Evaluator::EndOfRun() const {
  if (!refusal_.empty()) return End::kRefused;
  if (spending_.is_spent()) return End::kSpent;
  if (is_inconsistent_) return End::kInconsistent;
  return is_open_ ? End::kOpen : End::kModel;
}

void Evaluator::EvaluateStratum(const Stratum& stratum, std::size_t number) {
  for (const std::size_t rule : stratum.rules) {
    if (program_.rules()[rule].ordinals == 0) Start(program_.rules()[rule], 0);
  }
  if (stratum.is_recursive) Close(stratum, number);
  for (const std::size_t rule : stratum.checks) Start(program_.rules()[rule], 0);
}

/// Follows recursive rules from what is new, until nothing is.
void Evaluator::Close(const Stratum& stratum, std::size_t number) {
  for (std::size_t i = 0; i < tables_.size(); ++i) windows_[i] = {};
  while (!stops() && Advance(number)) {
    for (const std::size_t index : stratum.rules) {
      const Rule& rule = program_.rules()[index];
      for (std::size_t newest = 0; newest < rule.ordinals; ++newest) Start(rule, newest);
    }
  }
}

/// What was new is old now, what was found since is new; false: nothing was.
bool Evaluator::Advance(std::size_t stratum) {
  bool found = false;
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    if (program_.relations()[i].stratum != stratum) continue;
    windows_[i] = {windows_[i].end, tables_[i]->size()};
    found = found || windows_[i].end > windows_[i].old;
  }
  return found;
}

int Evaluator::RankOf(std::size_t relation) const {
  const int level = program_.relations()[relation].level;
  return level == 0 ? INT_MAX : level;
}

FactInfo Evaluator::InfoOfInstance(const Frame& frame) const {
  FactInfo info;
  info.origin = FactInfo::Origin::kRule;
  for (std::size_t i = frame.trail; i < trail_.size(); ++i) {
    const FactRef premise = trail_[i];
    if (premise.relation == FactRef::kAssumption) {
      info.rank = std::max(info.rank, RankOf(defaults_[premise.row].relation));
    } else {
      const FactInfo& other = tables_[premise.relation]->info(premise.row);
      info.rank = std::max(info.rank, other.rank);
      info.height = std::max(info.height, other.height + 1);
    }
  }
  return info;
}

void Evaluator::Fire(const Frame& frame) {
  const Rule& rule = *frame.rule;
  if (sink_ != nullptr && rule.clause != kNoIndex) return FireInstance(frame);
  if (rule.heads.empty()) return Violate(frame);
  const Head& head = rule.heads.front();
  if (!BuildCells(head.arguments, frame.base)) return;
  FactInfo info = InfoOfInstance(frame);
  const int level = program_.relations()[head.relation].level;
  FactTable& table = *tables_[head.relation];
  const std::uint32_t known = table.Find(cells_);
  if (known != FactTable::kNone && table.info(known).rank <= info.rank) return;
  info.source = rule.clause == kNoIndex ? 0 : static_cast<std::uint32_t>(rule.clause);
  info.first_premise = premises_.size();
  info.premises = trail_.size() - frame.trail;
  premises_.insert(premises_.end(), trail_.begin() + static_cast<std::ptrdiff_t>(frame.trail),
                   trail_.end());
  // A minimized atom is in every minimal model if only earlier defaults stand behind it.
  is_open_ = is_open_ || (level > 0 && info.rank >= level);
  if (known != FactTable::kNone) {
    table.info(known) = info;
  } else {
    table.Insert(cells_, info);
  }
}

void Evaluator::Violate(const Frame& frame) {
  (InfoOfInstance(frame).rank == 0 ? is_inconsistent_ : is_open_) = true;
}

std::uint32_t Evaluator::AskDefault(std::size_t relation, std::uint32_t contrary) {
  FactTable& table = *asked_[relation];
  const std::uint32_t known = table.Find(cells_);
  if (known != FactTable::kNone) return table.info(known).source;
  FactInfo info;
  info.source = static_cast<std::uint32_t>(defaults_.size());
  const std::uint32_t row = table.Insert(cells_, info);
  defaults_.push_back({static_cast<std::uint32_t>(relation), row, contrary});
  return info.source;
}

namespace {

logic::Fact ToFact(const logic::PredicateName& name, std::span<const Value> row,
                   const ValueBank& bank) {
  constexpr std::size_t kFew = logic::Atom::kInlineArguments;
  if (row.size() > kFew) {
    std::vector<logic::Term> terms;
    for (const Value& value : row) terms.push_back(bank.ToTerm(value));
    return {name.symbol, terms};
  }
  std::array<logic::Term, kFew> terms;
  for (std::size_t i = 0; i < row.size(); ++i) terms.at(i) = bank.ToTerm(row[i]);
  return {name.symbol, std::span<const logic::Term>(terms.data(), row.size())};
}

}  // namespace

logic::Fact Evaluator::DefaultAtom(const AskedDefault& asked) const {
  return ToFact(program_.relations()[asked.relation].name, asked_[asked.relation]->Row(asked.row),
                bank_);
}

logic::Fact Evaluator::FactOf(FactRef fact) const {
  return ToFact(program_.relations()[fact.relation].name, tables_[fact.relation]->Row(fact.row),
                bank_);
}

}  // namespace latchwork::circumscription
