// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_INTEGRATION_TOWERS_H_
#define LATCHWORK_TESTS_INTEGRATION_TOWERS_H_

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "tests/integration/run_command.h"
#include "tests/temporary_folder.h"

namespace latchwork::testing {

/// Experiments whose runs are short: the tower of Hanoi, as it is, once more, and with a hand that
/// slips. The experiment's file is towers.xml.
class TowersTest : public ::testing::Test {
 protected:
  static std::string Experiment(const std::string& attributes) {
    return "<experiment format=\"1\" name=\"towers\" " + attributes +
           ">\n"
           "  <scenario name=\"tower\" file=\"" LATCHWORK_SOURCE_DIR
           "/examples/icarus/hanoi.xml\"/>\n"
           "  <agent name=\"steady\"/>\n"
           "  <agent name=\"same\"/>\n"
           "  <agent name=\"slipping\"><set name=\"world.slip\" value=\"0.8\"/></agent>\n"
           "</experiment>\n";
  }
  void WriteExperiment(const std::string& attributes) const {
    WriteText(scratch_.path() / "towers.xml", Experiment(attributes));
  }
  CommandResult Compare(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"compare", "towers.xml", "--quiet"});
    return RunLatchwork(arguments, scratch_.path());
  }
  std::string Bytes(const std::string& folder) const {
    return ReadText(scratch_.path() / folder / "results.sqlite");
  }
  std::size_t CountLines(const std::string& file) const {
    const std::string text = ReadText(scratch_.path() / file);
    return static_cast<std::size_t>(std::ranges::count(text, '\n'));
  }

  test::TemporaryFolder scratch_;
};

}  // namespace latchwork::testing

#endif  // LATCHWORK_TESTS_INTEGRATION_TOWERS_H_
