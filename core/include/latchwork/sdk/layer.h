// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_LAYER_H_
#define LATCHWORK_SDK_LAYER_H_

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/contract.h"
#include "latchwork/sdk/parameters.h"
#include "latchwork/sdk/reasoner.h"

namespace latchwork::sdk {

/// What a layer says through one of its outputs when its reasoner has a fault.
struct Fallback {
  std::size_t port = 0;  ///< Index into the contract's outputs.
  std::vector<logic::Fact> facts;
};

/// A contract and the bodies that fulfil it, one for each language. The scheduler gives the body to
/// a reasoner and never asks the layer again, so a layer needs no state.
class Layer {
 public:
  virtual ~Layer() = default;

  virtual const Contract& contract() const = 0;
  virtual std::span<const ParameterSpec> parameters() const = 0;
  /// Languages in which it has a body.
  virtual std::vector<std::string> languages() const = 0;

  /// The body in one of its languages. `data` is the folder with the plugin's files.
  virtual Body MakeBody(std::string_view language, const Parameters& parameters,
                        const std::filesystem::path& data, logic::SymbolTable& symbols) const = 0;

  /// Said on a fault where the agent file declares nothing else. Ports not named fall silent.
  virtual std::vector<Fallback> fallbacks(logic::SymbolTable& symbols) const {
    static_cast<void>(symbols);
    return {};
  }
};

/// The parameters of a layer as facts named like them, for its body: halt_distance(0.45). Texts
/// become constants, booleans the constants true and false.
std::vector<logic::Fact> ParameterFacts(const Parameters& parameters, logic::SymbolTable& symbols);

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_LAYER_H_
