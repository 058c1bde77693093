// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/tools/script_recorder.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "reasoners/icarus/language/walk.h"
#include "reasoners/icarus/tools/clause_text.h"
#include "reasoners/icarus/tools/world_script.h"

namespace latchwork::icarus {

namespace {

constexpr std::size_t kWidth = 100;
constexpr std::string_view kIndent = "       ";  // Of the items of (cycle ...).

using Facts = std::vector<FactText>;

std::string ToString(const FactText& fact) {
  std::string text = "(";
  for (const std::string& item : fact) text += (text.size() == 1 ? "" : " ") + item;
  return text + ')';
}

std::string Item(std::string_view head, const std::string& text) {
  return '(' + std::string(head) + ' ' + text + ')';
}

/// The facts of one head and length, or all.
struct Group {
  Facts before;
  Facts after;
};

/// Whether facts only gave way to new ones, each at its place.
bool AreReplaced(const Group& group) {
  if (group.before.size() != group.after.size()) return false;
  const std::set<FactText> old(group.before.begin(), group.before.end());
  const std::set<FactText> present(group.after.begin(), group.after.end());
  for (std::size_t i = 0; i < group.before.size(); ++i) {
    if (group.before[i] == group.after[i]) continue;
    if (present.contains(group.before[i]) || old.contains(group.after[i])) return false;
  }
  return true;
}

/// A pattern that of all facts fits those at `index` alone: ? for what is new, where that is
/// enough.
FactText PatternFor(const Group& group, std::size_t index) {
  const FactText& now = group.after[index];
  FactText pattern = group.before[index];
  if (pattern.size() != now.size()) return pattern;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] != now[i]) pattern[i] = "?";
  }
  const auto fits = [&](const FactText& fact) {
    return std::equal(fact.begin(), fact.end(), pattern.begin(), pattern.end(),
                      [](const auto& item, const auto& any) { return any == "?" || item == any; });
  };
  const auto count = [&](const Facts& facts) { return std::ranges::count_if(facts, fits); };
  return count(group.before) + count(group.after) == 2 ? pattern : group.before[index];
}

/// In a script, what is forgotten comes first, and what is stored last.
void AddChanges(const Group& group, std::vector<std::string>& items) {
  if (AreReplaced(group)) {
    for (std::size_t i = 0; i < group.before.size(); ++i) {
      if (group.before[i] == group.after[i]) continue;
      items.push_back(
          Item("update", ToString(PatternFor(group, i)) + ' ' + ToString(group.after[i])));
    }
    return;
  }
  const std::set<FactText> present(group.after.begin(), group.after.end());
  Facts rest;
  for (const FactText& fact : group.before) {
    if (present.contains(fact)) {
      rest.push_back(fact);
    } else {
      items.push_back(Item("forget", ToString(fact)));
    }
  }
  const auto [left, stays] = std::ranges::mismatch(rest, group.after);
  for (auto at = left; at != rest.end(); ++at) items.push_back(Item("forget", ToString(*at)));
  for (auto at = stays; at != group.after.end(); ++at) {
    items.push_back(Item("store", ToString(*at)));
  }
}

}  // namespace

std::vector<std::string> MemoryChanges(const Facts& before, const Facts& after, FactOrder order) {
  std::vector<Group> groups;
  std::map<std::pair<std::string, std::size_t>, std::size_t> known;
  const auto group_of = [&](const FactText& fact) -> Group& {
    const bool all = order == FactOrder::kOfAll || fact.empty();
    const auto key = all ? std::pair<std::string, std::size_t>() : std::pair(fact[0], fact.size());
    const auto [at, is_new] = known.emplace(key, groups.size());
    if (is_new) groups.emplace_back();
    return groups[at->second];
  };
  for (const FactText& fact : before) group_of(fact).before.push_back(fact);
  for (const FactText& fact : after) group_of(fact).after.push_back(fact);
  std::vector<std::string> items;
  for (const Group& group : groups) AddChanges(group, items);
  return items;
}

FactOrder OrderSeenBy(const Program& program) {
  FactOrder order = FactOrder::kOfHead;
  const auto visit = [&](const Clause& clause, Slot /*slot*/) {
    const bool any_head = clause.kind == ClauseKind::kMatch && !clause.terms.empty() &&
                          clause.terms[0].kind == TermKind::kVariable;
    if (any_head) order = FactOrder::kOfAll;
  };
  for (const Skill& skill : program.skills) WalkClauses(skill, visit);
  WalkNameless(program, [&](const Skill& skill) { WalkClauses(skill, visit); });
  return order;
}

std::vector<FactText> ScriptRecorder::FactsOf(const FactStore& memory) const {
  Facts facts;
  for (const FactStore::Fact* fact = memory.First(); fact != nullptr; fact = fact->next) {
    if (fact->died != 0) continue;
    FactText& text = facts.emplace_back();
    for (const Value& item : fact->value.list->items()) {
      text.push_back(icarus::ToString(item, names_));
    }
  }
  return facts;
}

void ScriptRecorder::Add(const std::string& item) {
  if (width_ > kIndent.size() && width_ + 1 + item.size() > kWidth) {
    text_ += '\n';
    text_ += kIndent;
    width_ = kIndent.size();
  } else {
    text_ += ' ';
    ++width_;
  }
  text_ += item;
  width_ += item.size();
}

void ScriptRecorder::OnBegin(const FactStore& memory) {
  text_ = "(cycle";
  width_ = text_.size();
  for (const std::string& item : MemoryChanges(facts_, FactsOf(memory), order_)) Add(item);
}

void ScriptRecorder::OnEvent(const Event& event) {
  if (event.kind != EventKind::kHost) return;
  const std::string call = CallText(names_.Name(event.name), event.values, names_);
  const std::string answer =
      event.answer.is_none() ? "nil" : icarus::ToString(event.answer, names_);
  const std::string item = event.text.empty() ? Item("answer", call + ' ' + answer)
                                              : FailureItem(call, std::string(event.text));
  std::string& said = said_[call];
  if (said == item) return;
  said = item;
  Add(item);
}

void ScriptRecorder::OnEnd(const CycleResult& result, const FactStore& memory) {
  std::string words;
  for (const std::string& word : Outcome(result, names_)) {
    words += (words.empty() ? "" : " ") + word;
  }
  Add(Item("expect", words));
  text_ += ')';
  facts_ = FactsOf(memory);
}

}  // namespace latchwork::icarus
