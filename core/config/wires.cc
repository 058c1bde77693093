// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/config/agent_check.h"
#include "core/config/duration.h"

namespace latchwork::config {
namespace {

class WireCheck {
 public:
  explicit WireCheck(AgentCheck& check) : check_(check) {}

  void Run(const std::vector<Element>& elements) {
    for (const Element& element : elements) {
      if (element.name == "wire" && !check_.HasEnough()) CheckWire(element);
    }
    if (!is_uncertain_ && check_.is_whole) CheckUnwired();
  }

 private:
  void CheckWire(const Element& element) {
    const Attribute* from = element.Find("from");
    const Attribute* to = element.Find("to");
    const std::optional<FoundPort> source = FindPort(check_, from, PortSide::kOutput);
    const std::optional<FoundPort> target = FindPort(check_, to, PortSide::kInput);
    if (!target) NoteUnresolved(to);
    if (target && target->spec != nullptr) CheckTarget(*to, target->address, element.place);
    if (!source || !target) return;
    Wire wire{source->address, target->address, std::nullopt, ReadTransfer(element), element.place};
    if (CheckDirection(element, wire)) CheckFit(element, *source, *target);
    wire.stale_after = CheckStaleAfter(element, wire.from.part);
    check_.agent.wires.push_back(std::move(wire));
  }

  static Transfer ReadTransfer(const Element& element) {
    const Attribute* const attribute = element.Find("transfer");
    if (attribute == nullptr || attribute->value == "open") return Transfer::kOpen;
    return attribute->value == "single" ? Transfer::kSingle : Transfer::kRefined;
  }

  void CheckFit(const Element& element, const FoundPort& source, const FoundPort& target) {
    if (source.spec == nullptr || target.spec == nullptr) return;
    const auto mismatch = Compare(*source.spec, *target.spec);
    if (!mismatch) return;
    check_.Say(
        element.place,
        fmt::format("the wire from '{}' to '{}' does not fit: {}", element.Find("from")->value,
                    element.Find("to")->value, mismatch->message),
        mismatch->hint);
  }

  /// An input may seem unwired only because the wire to it is misspelt.
  void NoteUnresolved(const Attribute* to) {
    const std::string_view text = to == nullptr ? std::string_view() : to->value;
    const std::string name(text.substr(0, text.find('.')));
    if (const auto part = FindPart(check_, name)) {
      unresolved_.insert(*part);
    } else if (const auto nearest = FindPart(check_, logic::NearestName(name, PartNames(check_)))) {
      unresolved_.insert(*nearest);
    } else {
      is_uncertain_ = true;
    }
  }

  void CheckTarget(const Attribute& to, const PortAddress& address,
                   const logic::SourcePlace& place) {
    const auto first = std::ranges::find(targets_, address, &Target::address);
    if (first == targets_.end()) {
      targets_.push_back({address, place});
      return;
    }
    const bool is_world = address.part == PortAddress::kWorld;
    check_.Say(to.place,
               fmt::format("two wires lead {} '{}'",
                           is_world ? "to the effector" : "into the latch of", to.value),
               fmt::format("the first is at {}:{}; {} one source", first->place.file,
                           first->place.line, is_world ? "an effector obeys" : "a latch has"));
  }

  bool CheckDirection(const Element& element, const Wire& wire) {
    constexpr std::size_t kWorld = PortAddress::kWorld;
    const std::string name = check_.NameOf(wire.from.part);
    if (wire.from.part == wire.to.part) {
      check_.Say(element.place,
                 wire.from.part == kWorld
                     ? "this wire leads from the world to the world"
                     : fmt::format("this wire leads from '{}' back to itself", name),
                 "a wire connects two parts");
      return false;
    }
    if (wire.from.part == kWorld || wire.to.part == kWorld || wire.from.part > wire.to.part) {
      return true;
    }
    check_.Say(
        element.place,
        fmt::format("this wire leads up, from '{}' to the higher layer '{}'", name,
                    check_.NameOf(wire.to.part)),
        "a higher layer (later in the file) subsumes a lower one, never the other way round; "
        "let the higher layer read the sensors");
    return false;
  }

  std::optional<std::uint64_t> CheckStaleAfter(const Element& element, std::size_t from) {
    const Attribute* attribute = element.Find("stale-after");
    if (attribute == nullptr) return std::nullopt;
    const auto ticks = check_.Ticks(*attribute);
    if (!ticks) return std::nullopt;
    const std::uint64_t period = from == PortAddress::kWorld ? 1 : check_.agent.layers[from].period;
    if (*ticks < period) {
      check_.Say(
          attribute->place,
          fmt::format("stale-after '{}' is shorter than the period of '{}' ({})", attribute->value,
                      check_.NameOf(from), FormatDuration(period * check_.agent.tick_us)),
          "the latch would be emptied before every new batch; use two or three periods");
    }
    return ticks;
  }

  void CheckUnwired() {
    for (std::size_t i = 0; i < check_.agent.layers.size(); ++i) {
      if (!check_.layers[i] || unresolved_.contains(i)) continue;
      const auto& inputs = check_.layers[i]->contract.inputs;
      for (std::size_t port = 0; port < inputs.size(); ++port) {
        const PortAddress address{i, port};
        const bool is_wired =
            std::ranges::find(targets_, address, &Target::address) != targets_.end();
        if (inputs[port].optional || is_wired) continue;
        const std::string name = check_.NameOf(i) + "." + inputs[port].name;
        check_.Say(check_.agent.layers[i].place, fmt::format("the input '{}' is not wired", name),
                   SuggestWire(i, inputs[port], name));
      }
    }
  }

  std::string SuggestWire(std::size_t layer, const sdk::PortSpec& input,
                          const std::string& name) const {
    std::vector<std::size_t> parts = {PortAddress::kWorld};
    for (std::size_t i = layer + 1; i < check_.agent.layers.size(); ++i) parts.push_back(i);
    for (const std::size_t part : parts) {
      const PluginFacts* facts = check_.FactsOf(part);
      if (facts == nullptr) continue;
      for (const sdk::PortSpec& output : facts->contract.outputs) {
        if (Compare(output, input)) continue;
        return fmt::format(R"(add <wire from="{}.{}" to="{}"/>)", check_.NameOf(part), output.name,
                           name);
      }
    }
    return "";
  }

  struct Target {
    PortAddress address;
    logic::SourcePlace place;
  };

  AgentCheck& check_;
  std::vector<Target> targets_;
  std::set<std::size_t> unresolved_;
  bool is_uncertain_ = false;
};

}  // namespace

void CheckWires(AgentCheck& check, const std::vector<Element>& elements) {
  WireCheck(check).Run(elements);
}

}  // namespace latchwork::config
