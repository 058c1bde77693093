// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "core/config/agent_check.h"

namespace latchwork::config {
namespace {

/// Layers inhibit layers, higher ones lower ones, and never a reflex.
bool CheckEnds(AgentCheck& check, const Element& element, const FoundPort& by,
               const FoundPort& output) {
  constexpr std::size_t kWorld = PortAddress::kWorld;
  if (by.address.part == kWorld || output.address.part == kWorld) {
    const Attribute* end = element.Find(by.address.part == kWorld ? "by" : "output");
    check.Say(end->place, fmt::format("'{}' is a sensor", end->value),
              "a layer's output inhibits the output of a lower layer");
    return false;
  }
  if (by.address.part <= output.address.part) {
    check.Say(element.place,
              fmt::format("'{}' cannot inhibit '{}', which is not below it",
                          check.NameOf(by.address.part), check.NameOf(output.address.part)),
              "a higher layer (later in the file) inhibits a lower one");
    return false;
  }
  if (output.spec != nullptr && output.spec->uninhibitable) {
    const Attribute* end = element.Find("output");
    check.Say(end->place, fmt::format("'{}' must not be inhibited", end->value),
              "its layer declares it a safety reflex; subsume the layer's inputs instead");
    return false;
  }
  return true;
}

void CheckInhibition(AgentCheck& check, const Element& element) {
  const auto by = FindPort(check, element.Find("by"), PortSide::kOutput);
  const auto output = FindPort(check, element.Find("output"), PortSide::kOutput);
  if (!by || !output || !CheckEnds(check, element, *by, *output)) return;
  Inhibition inhibition{by->address, output->address, check.agent.layers[by->address.part].period,
                        element.place};
  if (const Attribute* hold = element.Find("hold")) {
    const auto ticks = check.Ticks(*hold);
    if (ticks == std::uint64_t{0}) {
      check.Say(hold->place, "an inhibition that holds for no time does nothing");
    }
    if (ticks) inhibition.hold = *ticks;
  }
  check.agent.inhibitions.push_back(std::move(inhibition));
}

}  // namespace

void CheckInhibitions(AgentCheck& check, const std::vector<Element>& elements) {
  for (const Element& element : elements) {
    if (element.name == "inhibit" && !check.HasEnough()) CheckInhibition(check, element);
  }
}

}  // namespace latchwork::config
