// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/tables/table_plan.h"

#include <algorithm>
#include <span>

#include "reasoners/pttp/tables/body_planner.h"

namespace latchwork::pttp {
namespace {

constexpr std::size_t kMostBody = 64;
constexpr std::uint32_t kMostHeight = 64;

std::uint32_t KeyOf(const CompiledLiteral& literal) {
  return Signed(literal.predicate, literal.positive);
}

bool IsShallow(Word word, int depth = 0) {
  if (TagOf(word) != Tag::kTemplate) return true;
  if (depth == kDeepestTemplate) return false;
  const Word* block = AddressOf(word);
  return std::all_of(block + 1, block + 1 + ArityOf(block[0]),
                     [&](Word argument) { return IsShallow(argument, depth + 1); });
}

std::span<const Word> ArgumentsOf(const CompiledLiteral& literal) {
  return {literal.arguments, literal.arity};
}

bool HasTemplate(const CompiledLiteral& literal) {
  const auto arguments = ArgumentsOf(literal);
  return std::any_of(arguments.begin(), arguments.end(),
                     [](Word word) { return TagOf(word) == Tag::kTemplate; });
}

bool AreShallow(const CompiledLiteral& literal) {
  const auto arguments = ArgumentsOf(literal);
  return literal.arity <= kMostArguments &&
         std::all_of(arguments.begin(), arguments.end(), [](Word word) { return IsShallow(word); });
}

}  // namespace

bool TableProgram::IsClosing(const CompiledLiteral& literal) const {
  return !literal.positive && reach_->closing &&
         (*predicates_)[literal.predicate].minimized.has_value();
}

/// Strongly connected components of the call graph (Tarjan 1972), without recursion.
class TableProgram::ComponentFinder {
 public:
  explicit ComponentFinder(TableProgram& program)
      : program_(program),
        next_(program.reach_->rules.size()),
        index_(next_.size(), 0),
        low_(next_.size(), 0),
        height_(next_.size(), 0) {
    for (std::uint32_t key = 0; key < next_.size(); ++key) {
      for (const Contrapositive* rule : program.reach_->rules[key]) {
        for (const CompiledLiteral& literal : rule->body) next_[key].push_back(Target(literal));
      }
    }
  }

  void Find() {
    program_.components_.resize(next_.size());
    for (std::uint32_t key = 0; key < next_.size(); ++key) {
      if (index_[key] == 0) Visit(key);
    }
  }
  /// Of the tallest tower of components.
  std::uint32_t height() const { return tallest_; }

 private:
  struct Frame {
    std::uint32_t key;
    std::size_t edge;
  };

  std::uint32_t Target(const CompiledLiteral& literal) const {
    return Signed(literal.predicate, literal.positive || program_.IsClosing(literal));
  }

  void Open(std::uint32_t key) {
    index_[key] = low_[key] = ++count_;
    stack_.push_back(key);
    frames_.push_back({key, 0});
  }

  void Visit(std::uint32_t root) {
    Open(root);
    while (!frames_.empty()) {
      Frame& frame = frames_.back();
      const std::uint32_t key = frame.key;
      if (frame.edge == next_[key].size()) {
        frames_.pop_back();
        if (low_[key] == index_[key]) Close(key);
        if (!frames_.empty()) Inherit(frames_.back().key, key);
        continue;
      }
      const std::uint32_t target = next_[key][frame.edge++];
      if (target == key) program_.components_[key].recursive = true;
      if (index_[target] == 0) {
        Open(target);
      } else {
        Inherit(key, target);
      }
    }
  }

  void Inherit(std::uint32_t key, std::uint32_t target) {
    if (height_[target] == 0) low_[key] = std::min(low_[key], low_[target]);
  }

  void Close(std::uint32_t root) {
    const auto first = std::find(stack_.begin(), stack_.end(), root);
    const bool several = stack_.end() - first > 1;
    std::uint32_t height = 1;
    for (auto member = first; member != stack_.end(); ++member) {
      for (const std::uint32_t target : next_[*member]) {
        height = std::max(height, height_[target] + 1);
      }
    }
    for (auto member = first; member != stack_.end(); ++member) {
      height_[*member] = height;
      Component& component = program_.components_[*member];
      component.number = components_ + 1;
      component.recursive = component.recursive || several;
    }
    ++components_;
    tallest_ = std::max(tallest_, height);
    stack_.erase(first, stack_.end());
  }

  TableProgram& program_;
  std::vector<std::vector<std::uint32_t>> next_;
  std::vector<std::uint32_t> index_;
  std::vector<std::uint32_t> low_;
  std::vector<std::uint32_t> height_;  ///< 0: its component is still open.
  std::vector<std::uint32_t> stack_;
  std::vector<Frame> frames_;
  std::uint32_t count_ = 0;
  std::uint32_t components_ = 0;
  std::uint32_t tallest_ = 0;
};

TableProgram::TableProgram(const Predicates& predicates, const Functors& functors,
                           const Reach& reach, bool reorder)
    : predicates_(&predicates), functors_(&functors), reach_(&reach), reorder_(reorder) {
  if (!reach.reduction_free) return;
  ComponentFinder finder(*this);
  finder.Find();
  fits_ = finder.height() <= kMostHeight && Check();
}

bool TableProgram::Check() const {
  for (std::uint32_t key = 0; key < reach_->rules.size(); ++key) {
    const Predicates::Info& info = (*predicates_)[key / 2];
    const bool negative = (key & 1U) == 0;
    if (reach_->rules[key].empty()) continue;
    if (info.kind != PredicateKind::kOrdinary) return false;
    if (negative && reach_->closing && info.minimized) return false;
    for (const Contrapositive* rule : reach_->rules[key]) {
      if (!CheckRule(*rule, key)) return false;
    }
  }
  return true;
}

bool TableProgram::CheckRule(const Contrapositive& rule, std::uint32_t key) const {
  if (rule.body.size() > kMostBody || !AreShallow(rule.head)) return false;
  const Component& component = components_[key];
  bool makes_terms = HasTemplate(rule.head);
  bool recurs = false;
  for (const CompiledLiteral& literal : rule.body) {
    if (!AreShallow(literal)) return false;
    makes_terms = makes_terms || HasTemplate(literal) ||
                  (*predicates_)[literal.predicate].kind == PredicateKind::kAttachment;
    const Component& below = components_[Signed(literal.predicate, true)];
    if (IsClosing(literal) && below.number == component.number) return false;
    recurs = recurs || components_[KeyOf(literal)].number == component.number;
  }
  return !(recurs && makes_terms);
}

TableCall& TableProgram::CallOf(std::uint32_t key, std::uint32_t arity, std::uint64_t ground) {
  const auto [entry, added] = calls_.try_emplace((std::uint64_t{key} << 32U) | ground);
  TableCall& call = entry->second;
  if (added) {
    call.key = key;
    call.ground = ground;
    call.recursive = components_[key].recursive;
    call.label = 2 * std::size_t{key} + (reach_->closing && reach_->closes[key] ? 1 : 0);
    call.whole = ground == (std::uint64_t{1} << arity) - 1;
  }
  return call;
}

const std::vector<TablePlan>* TableProgram::PlansFor(TableCall& call) {
  if (!call.planned) {
    call.planned = true;
    for (const Contrapositive* rule : reach_->rules[call.key]) {
      TablePlan& plan = call.plans.emplace_back();
      plan.rule = rule;
      call.fits = PlanRule(call, plan) && call.fits;
    }
  }
  return call.fits ? &call.plans : nullptr;
}

bool TableProgram::PlanRule(const TableCall& call, TablePlan& plan) {
  const CompiledLiteral& head = plan.rule->head;
  BodyPlanner planner(*this, *plan.rule);
  for (std::uint32_t i = 0; i < head.arity; ++i) {
    if (((call.ground >> i) & 1U) != 0) planner.code().AddMatch(head.arguments[i], i, plan.call);
  }
  if (!planner.Plan(components_[call.key].number, plan.steps)) return false;
  for (std::uint32_t i = 0; i < head.arity; ++i) {
    if (((call.ground >> i) & 1U) != 0) continue;
    if (!planner.code().IsBound(head.arguments[i])) return false;
    plan.answer.push_back(planner.code().MakeOperand(head.arguments[i], i, false));
  }
  return true;
}

bool TableProgram::PlanQuery(const Contrapositive& query, bool given, TablePlan& plan) {
  plan = {};
  plan.rule = &query;
  if (query.body.size() > kMostBody ||
      !std::all_of(query.body.begin(), query.body.end(), AreShallow)) {
    return false;
  }
  BodyPlanner planner(*this, query);
  if (given) planner.code().BindAll();
  if (!planner.Plan(0, plan.steps)) return false;
  for (std::uint32_t slot = 0; slot < query.slots; ++slot) {
    if (!planner.code().IsBound(SlotWord(slot))) return false;
  }
  return true;
}

}  // namespace latchwork::pttp
