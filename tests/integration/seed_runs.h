// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_INTEGRATION_SEED_RUNS_H_
#define LATCHWORK_TESTS_INTEGRATION_SEED_RUNS_H_

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace latchwork::testing {

/// Runs an agent of examples/ once for each seed of `seeds`, "1-20", with further options of the
/// command. Returns what it says as JSON, one object for each seed; a failure of the test when the
/// command says no such thing.
std::vector<nlohmann::json> RunSeeds(const std::string& example, const std::string& seeds,
                                     const std::vector<std::string>& options = {});

/// Expects that every run has reached its goal without a fault.
void ExpectAllReached(const std::vector<nlohmann::json>& runs);

}  // namespace latchwork::testing

#endif  // LATCHWORK_TESTS_INTEGRATION_SEED_RUNS_H_
