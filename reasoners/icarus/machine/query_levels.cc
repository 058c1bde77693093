// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/icarus/machine/query_levels.h"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>

#include "reasoners/icarus/machine/compiler.h"

namespace latchwork::icarus {

namespace {

/// All environments are wanted, whatever the acts.
RunOptions ForQueries(RunOptions options) {
  options.acts = ActMode::kFirst;
  options.lazy = false;
  return options;
}

/// One level more, as long as it lives.
class Descent {
 public:
  explicit Descent(std::size_t& level) : level_(level) { ++level_; }
  Descent(const Descent&) = delete;
  Descent& operator=(const Descent&) = delete;
  ~Descent() { --level_; }

 private:
  std::size_t& level_;
};

}  // namespace

QueryLevels::QueryLevels(const CompiledProgram& code, const Program& program, Host& host,
                         const RunOptions& options, NamePool& names, FactStore& memory)
    : code_(code),
      program_(program),
      host_(host),
      options_(ForQueries(options)),
      names_(names),
      memory_(memory) {}

QueryLevels::Level::Level(const QueryLevels& own)
    : code(own.code_),
      machine(code, own.program_, own.host_, own.options_, own.names_, own.memory_) {}

std::size_t QueryLevels::Add(Skill query) {
  queries_.push_back(std::make_unique<Skill>(std::move(query)));
  return queries_.size() - 1;
}

/// Code grows only where nothing runs.
void QueryLevels::Compile(Level& level, std::size_t query) {
  Findings none;
  for (std::size_t i = level.entries.size(); i <= query; ++i) {
    level.entries.push_back(CompileTop(program_, *queries_[i], program_.source, host_, level.code,
                                       names_, level.constants, none));
  }
}

void QueryLevels::Ask(std::size_t query, Machine& main, EnvironmentSink& sink) {
  if (level_ == kMostLevels) throw std::runtime_error("host functions ask each other for ever");
  Machine& asker = level_ == 0 ? main : levels_[level_ - 1]->machine;
  if (level_ == levels_.size()) levels_.push_back(std::make_unique<Level>(*this));
  Level& level = *levels_[level_];
  Compile(level, query);
  const Descent descent(level_);
  const auto variables = static_cast<std::uint32_t>(queries_[query]->variables.size());
  level.machine.sequences().Clear();
  level.machine.Run(level.entries[query], variables, asker.cycle(), asker.RemainingLimits());
  asker.Charge(level.machine);
  Give(level, variables, sink);
}

void QueryLevels::Give(Level& level, std::size_t variables, EnvironmentSink& sink) {
  const std::size_t count = level.machine.environments();
  const std::span<const Value> values = level.machine.values();
  level.table.assign(std::bit_ceil(2 * count + 2), 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (level.IsNew(values, i, variables)) sink.Accept(values.subspan(i * variables, variables));
  }
}

bool QueryLevels::Level::IsNew(std::span<const Value> environments, std::size_t index,
                               std::size_t variables) {
  const std::span<const Value> own = environments.subspan(index * variables, variables);
  std::uint64_t hash = 0;
  for (const Value& value : own) hash = (hash ^ Hash(value)) * 0x9e3779b97f4a7c15ULL;
  const std::size_t mask = table.size() - 1;
  std::size_t at = (hash >> 32U) & mask;
  for (; table[at] != 0; at = (at + 1) & mask) {
    const auto other = environments.subspan((table[at] - 1) * variables, variables);
    if (std::equal(own.begin(), own.end(), other.begin(), Equal)) return false;
  }
  table[at] = static_cast<std::uint32_t>(index + 1);
  return true;
}

}  // namespace latchwork::icarus
