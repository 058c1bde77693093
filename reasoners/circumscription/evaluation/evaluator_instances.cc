// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/evaluation/evaluator.h"

namespace latchwork::circumscription {

/// Gives the sink an instance of a clause, without what the body decides; what is certain by the
/// body makes the instance true.
void Evaluator::FireInstance(const Frame& frame) {
  literals_.clear();
  if (!AddHeads(frame)) return;
  for (std::size_t i = frame.trail; i < trail_.size(); ++i) {
    const FactRef premise = trail_[i];
    const FactTable& table = *tables_[premise.relation];
    if (table.info(premise.row).origin == FactInfo::Origin::kBody) continue;
    literals_.push_back(-sink_->AtomOf(premise.relation, table.Row(premise.row)));
  }
  const logic::Clause& clause = program_.clauses()[frame.rule->clause];
  for (const Head& open : frame.rule->open) {
    if (!BuildCells(open.arguments, frame.base)) return;
    const Atom atom = sink_->AtomOf(open.relation, cells_);
    literals_.push_back(clause.literals[open.literal].positive ? atom : -atom);
  }
  sink_->Instance(frame.rule->clause, literals_);
}

/// False: the instance says nothing.
bool Evaluator::AddHeads(const Frame& frame) {
  FactInfo info = InfoOfInstance(frame);
  info.source = static_cast<std::uint32_t>(frame.rule->clause);
  for (const Head& head : frame.rule->heads) {
    if (!BuildCells(head.arguments, frame.base)) return false;
    const std::uint32_t known = tables_[head.relation]->Find(cells_);
    const bool is_known = known != FactTable::kNone;
    if (is_known && tables_[head.relation]->info(known).origin == FactInfo::Origin::kBody) {
      return false;
    }
  }
  for (const Head& head : frame.rule->heads) {
    BuildCells(head.arguments, frame.base);
    tables_[head.relation]->Insert(cells_, info);
    literals_.push_back(sink_->AtomOf(head.relation, cells_));
  }
  return true;
}

bool Evaluator::IsCertain(std::span<const FactRef> premises) {
  literals_.clear();
  for (const FactRef premise : premises) {
    if (premise.relation == FactRef::kAssumption) {
      const AskedDefault& asked = defaults_[premise.row];
      if (asked.contrary == FactTable::kNone) continue;
      const auto cells = tables_[asked.relation]->Row(asked.contrary);
      literals_.push_back(-sink_->AtomOf(asked.relation, cells));
    } else if (InfoOf(premise).origin == FactInfo::Origin::kRule) {
      const auto cells = tables_[premise.relation]->Row(premise.row);
      literals_.push_back(sink_->AtomOf(premise.relation, cells));
    }
  }
  return sink_->IsCertain(literals_);
}

}  // namespace latchwork::circumscription
