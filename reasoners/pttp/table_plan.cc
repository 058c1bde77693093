// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/table_plan.h"

#include <algorithm>
#include <utility>

namespace latchwork::pttp {
namespace {

constexpr std::size_t kMostBody = 64;
constexpr std::uint32_t kMostArguments = 32;
constexpr std::uint32_t kMostHeight = 64;
constexpr int kDeepestTemplate = 16;

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

template <typename Visit>
void ForEachSlot(Word word, Visit&& visit) {
  if (TagOf(word) == Tag::kSlot) visit(NumberOf(word));
  if (TagOf(word) != Tag::kTemplate) return;
  const Word* block = AddressOf(word);
  for (std::size_t i = 1; i <= ArityOf(block[0]); ++i) ForEachSlot(block[i], visit);
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

TableProgram::TableProgram(const Predicates& predicates, const Reach& reach, bool reorder)
    : predicates_(&predicates), reach_(&reach), reorder_(reorder) {
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

/// Puts the literals of a body in the order in which the machine would select them.
class TableProgram::BodyPlanner {
 public:
  BodyPlanner(const TableProgram& program, const Contrapositive& rule)
      : program_(program), rule_(rule), bound_(rule.slots, false) {}

  void Bind(Word word) {
    ForEachSlot(word, [&](std::uint32_t slot) { bound_[slot] = true; });
  }
  bool IsBound(Word word) const {
    bool bound = true;
    ForEachSlot(word, [&](std::uint32_t slot) { bound = bound && bound_[slot]; });
    return bound;
  }

  bool Plan(std::uint32_t component, std::vector<TableStep>& steps) {
    left_.clear();
    for (std::size_t i = 0; i < rule_.body.size(); ++i) left_.push_back(i);
    while (!left_.empty()) {
      const auto chosen = Choose();
      if (chosen == left_.end()) return false;
      steps.push_back(MakeStep(rule_.body[*chosen], component));
      left_.erase(chosen);
    }
    return true;
  }

 private:
  using Place = std::vector<std::size_t>::iterator;

  bool HasRules(const CompiledLiteral& literal) const {
    return !program_.reach_->RulesFor(KeyOf(literal)).empty();
  }
  PredicateKind KindOf(const CompiledLiteral& literal) const {
    return (*program_.predicates_)[literal.predicate].kind;
  }

  bool IsReady(const CompiledLiteral& literal) const {
    const bool whole = !literal.positive &&
                       (program_.IsClosing(literal) || KindOf(literal) == PredicateKind::kEquality);
    for (std::uint32_t i = 0; i < literal.arity; ++i) {
      const bool needed = whole || ((literal.needs_ground >> i) & 1U) != 0;
      if (needed && !IsBound(literal.arguments[i])) return false;
    }
    if (KindOf(literal) != PredicateKind::kEquality) return true;
    return IsBound(literal.arguments[0]) || IsBound(literal.arguments[1]);
  }

  template <typename Wanted>
  Place First(Wanted&& wanted) {
    return std::find_if(left_.begin(), left_.end(), [&](std::size_t index) {
      const CompiledLiteral& literal = rule_.body[index];
      return IsReady(literal) && wanted(literal);
    });
  }

  Place Choose() {
    const Place computed = First([&](const CompiledLiteral& literal) {
      const PredicateKind kind = KindOf(literal);
      return kind == PredicateKind::kArithmetic || kind == PredicateKind::kEquality;
    });
    if (computed != left_.end()) return computed;
    const Place first = First([](const CompiledLiteral&) { return true; });
    if (first == left_.end() || !program_.reorder_ || !HasRules(rule_.body[*first])) return first;
    const Place extensional = First([&](const CompiledLiteral& literal) {
      if (!literal.positive || literal.needs_ground != 0 || HasRules(literal) ||
          KindOf(literal) != PredicateKind::kOrdinary) {
        return false;
      }
      const auto arguments = ArgumentsOf(literal);
      return std::any_of(arguments.begin(), arguments.end(),
                         [&](Word word) { return IsBound(word); });
    });
    return extensional != left_.end() ? extensional : first;
  }

  TableStep::Kind StepKind(const CompiledLiteral& literal) const {
    switch (KindOf(literal)) {
      case PredicateKind::kArithmetic:
        return TableStep::Kind::kArithmetic;
      case PredicateKind::kEquality:
        return literal.positive ? TableStep::Kind::kUnify : TableStep::Kind::kDiffer;
      case PredicateKind::kAttachment:
        return TableStep::Kind::kAttachment;
      case PredicateKind::kOrdinary:
        break;
    }
    if (program_.IsClosing(literal)) return TableStep::Kind::kClosing;
    return HasRules(literal) ? TableStep::Kind::kCall : TableStep::Kind::kFacts;
  }

  TableStep MakeStep(const CompiledLiteral& literal, std::uint32_t component) {
    TableStep step;
    step.kind = StepKind(literal);
    step.key = KeyOf(literal);
    step.literal = &literal;
    step.recursive = program_.components_[step.key].recursive &&
                     program_.components_[step.key].number == component;
    for (std::uint32_t i = 0; i < literal.arity; ++i) {
      if (IsBound(literal.arguments[i])) step.ground |= std::uint64_t{1} << i;
    }
    for (const Word word : ArgumentsOf(literal)) {
      ForEachSlot(word, [&](std::uint32_t slot) {
        if (!bound_[slot]) step.binds.push_back(slot);
        bound_[slot] = true;
      });
    }
    return step;
  }

  const TableProgram& program_;
  const Contrapositive& rule_;
  std::vector<bool> bound_;
  std::vector<std::size_t> left_;
};

const std::vector<TablePlan>* TableProgram::PlansFor(std::uint32_t key, std::uint64_t ground) {
  const auto [entry, added] = plans_.try_emplace((std::uint64_t{key} << 32U) | ground);
  Plans& plans = entry->second;
  if (added) {
    for (const Contrapositive* rule : reach_->rules[key]) {
      BodyPlanner planner(*this, *rule);
      for (std::uint32_t i = 0; i < rule->head.arity; ++i) {
        if (((ground >> i) & 1U) != 0) planner.Bind(rule->head.arguments[i]);
      }
      TablePlan plan{rule, {}};
      plans.fits = plans.fits && planner.Plan(components_[key].number, plan.steps);
      for (const Word word : ArgumentsOf(rule->head)) {
        plans.fits = plans.fits && planner.IsBound(word);
      }
      plans.plans.push_back(std::move(plan));
    }
  }
  return plans.fits ? &plans.plans : nullptr;
}

bool TableProgram::PlanQuery(const Contrapositive& query, bool given, TablePlan& plan) const {
  plan.rule = &query;
  plan.steps.clear();
  if (query.body.size() > kMostBody ||
      !std::all_of(query.body.begin(), query.body.end(), AreShallow)) {
    return false;
  }
  BodyPlanner planner(*this, query);
  for (std::uint32_t slot = 0; given && slot < query.slots; ++slot) planner.Bind(SlotWord(slot));
  if (!planner.Plan(0, plan.steps)) return false;
  for (std::uint32_t slot = 0; slot < query.slots; ++slot) {
    if (!planner.IsBound(SlotWord(slot))) return false;
  }
  return true;
}

}  // namespace latchwork::pttp
