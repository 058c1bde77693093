// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_ICARUS_LAYERS_H_
#define LATCHWORK_APPS_LATCHWORK_ICARUS_LAYERS_H_

#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/latchwork/command.h"
#include "latchwork/config/agent.h"
#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/plugin/registry.h"
#include "latchwork/sdk/layer.h"
#include "latchwork/sdk/parameters.h"
#include "latchwork/sdk/reasoner.h"
#include "reasoners/icarus/body/layer_check.h"
#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/program.h"

namespace latchwork::app {

/// A layer whose body programs are to be. The symbols outlive it.
class LayerToFulfil {
 public:
  LayerToFulfil(std::string name, std::shared_ptr<sdk::Layer> layer,
                const sdk::Parameters& parameters, const std::filesystem::path& data_folder,
                logic::SymbolTable& symbols);

  const std::string& name() const { return name_; }
  /// The programs that it has of its own.
  const std::vector<std::filesystem::path>& files() const { return body_.files; }
  const std::vector<std::string>& facts() const { return facts_; }
  icarus::Findings Check(const icarus::Program& program) {
    return icarus::CheckInLayer(program, body_, *symbols_);
  }

 private:
  std::string name_;
  std::shared_ptr<sdk::Layer> layer_;
  logic::SymbolTable* symbols_;
  sdk::Body body_;
  std::vector<std::string> facts_;
};

/// A layer plugin, with its parameters as they are by default.
class NamedLayer {
 public:
  NamedLayer(const std::string& plugin, const Context& context);

  /// Why there is no such layer; empty: there is.
  const std::string& error() const { return error_; }
  LayerToFulfil& layer() { return *layer_; }

 private:
  logic::SymbolTable symbols_;
  plugin::Registry registry_;
  std::optional<LayerToFulfil> layer_;
  std::string error_;
};

/// The layers of an agent whose bodies are programs, with the parameters that the agent gives them.
class ProgramsOfAgent {
 public:
  /// `scenario` comes on top of the agent, where it is not empty.
  ProgramsOfAgent(const std::string& agent, const std::string& scenario, const Context& context);

  /// Why the agent cannot be used; then it has no layers.
  const logic::Diagnostics& diagnostics() const { return diagnostics_; }
  bool plugin_failure() const { return plugin_failure_; }
  std::deque<LayerToFulfil>& layers() { return layers_; }

 private:
  logic::SymbolTable symbols_;
  plugin::Registry registry_;
  std::deque<LayerToFulfil> layers_;
  logic::Diagnostics diagnostics_;
  bool plugin_failure_ = false;
};

/// What is wrong with naming this layer for something that only the reasoner icarus `does`; an
/// empty message: nothing.
logic::Diagnostic WrongIcarusLayer(const config::AgentDescription& agent, const std::string& wanted,
                                   std::string_view does);

/// Whether the agent has this layer and the reasoner icarus drives it: kDone, or an exit code with
/// messages on standard error.
int CheckIcarusLayer(const std::filesystem::path& agent, const std::string& layer,
                     const Context& context);

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_ICARUS_LAYERS_H_
