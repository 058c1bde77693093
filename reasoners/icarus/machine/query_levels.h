// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_QUERY_LEVELS_H_
#define LATCHWORK_ICARUS_QUERY_LEVELS_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "reasoners/icarus/machine/code.h"
#include "reasoners/icarus/machine/machine.h"

namespace latchwork::icarus {

/// Receives environments one by one.
class EnvironmentSink {
 public:
  virtual ~EnvironmentSink() = default;
  virtual void Accept(std::span<const Value> values) = 0;
};

/// Conjunctions that host functions ask while a cycle runs, in the same memory. What is asked may
/// lead to host functions that ask in turn, each level on a machine of its own.
class QueryLevels {
 public:
  QueryLevels(const CompiledProgram& code, const Program& program, Host& host,
              const RunOptions& options, NamePool& names, FactStore& memory);

  /// The :requires of `query`, without places, is what may be asked.
  std::size_t Add(Skill query);
  /// Gives each distinct environment once. What it takes counts in the cycle of `main`. Throws when
  /// the levels are too many.
  void Ask(std::size_t query, Machine& main, EnvironmentSink& sink);

 private:
  static constexpr std::size_t kMostLevels = 8;

  struct Level {
    explicit Level(const QueryLevels& own);
    bool IsNew(std::span<const Value> environment, std::size_t index, std::size_t variables);

    CompiledProgram code;
    Arena constants;
    Machine machine;
    std::vector<Address> entries;      ///< Of the queries compiled here.
    std::vector<std::uint32_t> table;  ///< Environments by hash: index + 1; 0: none.
  };

  void Compile(Level& level, std::size_t query);
  void Give(Level& level, std::size_t variables, EnvironmentSink& sink);

  const CompiledProgram& code_;
  const Program& program_;
  Host& host_;
  RunOptions options_;
  NamePool& names_;
  FactStore& memory_;
  std::vector<std::unique_ptr<Skill>> queries_;
  std::vector<std::unique_ptr<Level>> levels_;
  std::size_t level_ = 0;  ///< That would be asked next.
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_QUERY_LEVELS_H_
