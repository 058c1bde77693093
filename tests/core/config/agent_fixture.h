// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_CORE_CONFIG_AGENT_FIXTURE_H_
#define LATCHWORK_TESTS_CORE_CONFIG_AGENT_FIXTURE_H_

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "latchwork/config/agent.h"
#include "tests/temporary_folder.h"

namespace latchwork::config {

/// Plugins that exist nowhere: the world `hall` (sensors sonar, robot; effector drive), the layers
/// `avoid` and `seek`, the reasoners `pttp` and `icarus`, and a layer `torn` that cannot be loaded.
Catalog FakeCatalog();

/// Reads agent files of a folder that goes away with the test.
class AgentTest : public ::testing::Test {
 protected:
  void Write(const std::string& name, std::string_view text) const;
  AgentFile Read(std::string_view text, const std::vector<Override>& overrides = {});
  /// "line:column: message [hint]" of every diagnostic; files other than the agent's come first:
  /// "file:line:column: ...".
  std::vector<std::string> Errors(std::string_view text,
                                  const std::vector<Override>& overrides = {});

  test::TemporaryFolder folder_;
  logic::SymbolTable symbols_;
};

/// A good agent file. Lines: 1 <agent>, 2 world, 3-5 avoid, 6-8 seek, 9-13 wires, 14 </agent>.
std::string GoodAgent();
/// GoodAgent with the first occurrence of a piece of text replaced; the piece must occur.
std::string GoodAgentWith(std::string_view piece, std::string_view replacement);

}  // namespace latchwork::config

#endif  // LATCHWORK_TESTS_CORE_CONFIG_AGENT_FIXTURE_H_
