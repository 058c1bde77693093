// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_PARAMETER_OPTIONS_H_
#define LATCHWORK_APPS_LATCHWORK_PARAMETER_OPTIONS_H_

#include <CLI/CLI.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "latchwork/sdk/contract.h"
#include "latchwork/sdk/parameters.h"

namespace latchwork::app {

/// Adds an option for each parameter of the table: `max_depth` is `--max-depth VALUE`, a boolean
/// `--cache` and `--no-cache`. What the command line says is checked and put into `given`, which
/// outlives `command`; the table does as well. `aliases`: by parameter, another name for the
/// option.
void AddParameterOptions(CLI::App& command, std::span<const sdk::ParameterSpec> table,
                         std::vector<sdk::Parameters::Given>& given,
                         const std::map<std::string, std::string>& aliases = {});

/// The values that the command line gave, and the defaults of the others.
sdk::Parameters Values(std::span<const sdk::ParameterSpec> table,
                       std::span<const sdk::Parameters::Given> given);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_PARAMETER_OPTIONS_H_
