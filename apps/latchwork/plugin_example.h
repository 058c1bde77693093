// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_PLUGIN_EXAMPLE_H_
#define LATCHWORK_APPS_LATCHWORK_PLUGIN_EXAMPLE_H_

#include <span>
#include <string>
#include <string_view>

#include "latchwork/sdk/contract.h"

namespace latchwork::app {

/// Fragments of an agent file, valid against its schema, that show how a plugin is used.
std::string WorldExample(std::string_view plugin, std::span<const sdk::ParameterSpec> parameters);
/// `reasoner` is the plugin that drives the layer; the world is assumed to have ports of the same
/// names.
std::string LayerExample(std::string_view plugin, const sdk::Contract& contract,
                         std::span<const sdk::ParameterSpec> parameters, std::string_view reasoner);
std::string ReasonerExample(std::string_view plugin,
                            std::span<const sdk::ParameterSpec> parameters);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_PLUGIN_EXAMPLE_H_
