// SPDX-License-Identifier: BSD-3-Clause
#include "core/config/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace latchwork::config {
namespace {

std::string Choices(const std::vector<std::string>& names) {
  if (names.empty()) return "nothing is allowed there";
  return fmt::format("allowed: {}", fmt::join(names, ", "));
}

std::string HintFor(std::string_view name, const std::vector<std::string>& known) {
  const std::string_view nearest = logic::NearestName(name, known);
  return nearest.empty() ? Choices(known) : fmt::format("did you mean '{}'?", nearest);
}

class Explainer {
 public:
  Explainer(const SchemaIndex& schema, const Complaints& complaints)
      : schema_(schema), complaints_(complaints) {}

  logic::Diagnostics Run(const Element& root) {
    const auto type = schema_.roots.find(root.name);
    if (type == schema_.roots.end()) {
      Say(root.place, fmt::format("the root of the file is <{}>, which is not known", root.name),
          HintForElement(root, KeysOf(schema_.roots)));
    } else {
      Visit(root, schema_.elements.at(type->second));
    }
    return std::move(diagnostics_);
  }

 private:
  void Say(const logic::SourcePlace& place, std::string message, std::string hint) {
    diagnostics_.push_back({place, std::move(message), std::move(hint), ""});
  }

  static std::string HintForElement(const Element& element, const std::vector<std::string>& known) {
    const bool qualified = element.name.find_first_of("{:") != std::string::npos;
    return qualified ? "write it without a namespace" : HintFor(element.name, known);
  }

  const std::vector<std::string>* ComplaintsAbout(const Element& element) const {
    const auto found = complaints_.find({element.place.line, element.place.column});
    return found == complaints_.end() ? nullptr : &found->second;
  }

  void Visit(const Element& element, const ElementType& type) {
    const std::size_t before = diagnostics_.size();
    const auto* complaints = ComplaintsAbout(element);
    if (complaints != nullptr) {
      CheckAttributes(element, type, *complaints);
      if (MentionsText(*complaints)) {
        Say(element.place, fmt::format("text is not allowed in <{}>", element.name), "");
      }
    }
    const bool has_unknown = CheckChildren(element, type, complaints != nullptr);
    if (complaints != nullptr && !has_unknown && diagnostics_.size() == before) {
      for (const std::string& message : *complaints) Say(element.place, message, "");
    }
    for (const Element& child : element.children) {
      const auto child_type = type.children.find(child.name);
      if (child_type != type.children.end()) {
        Visit(child, schema_.elements.at(child_type->second));
      }
    }
  }

  static bool MentionsText(const std::vector<std::string>& messages) {
    return std::ranges::any_of(messages, [](const std::string& message) {
      return message.find("character data") != std::string::npos;
    });
  }

  bool CheckChildren(const Element& element, const ElementType& type, bool is_wrong) {
    bool has_unknown = false;
    for (const Element& child : element.children) {
      if (type.children.contains(child.name)) continue;
      has_unknown = true;
      if (!is_wrong && ComplaintsAbout(child) == nullptr) continue;
      Say(child.place, fmt::format("<{}> is not allowed in <{}>", child.name, element.name),
          HintForElement(child, KeysOf(type.children)));
    }
    return has_unknown;
  }

  void CheckAttributes(const Element& element, const ElementType& type,
                       const std::vector<std::string>& messages) {
    const std::vector<std::string> names = KeysOf(type.attributes);
    std::vector<std::string_view> meant;
    for (const Attribute& attribute : element.attributes) {
      const auto known = type.attributes.find(attribute.name);
      if (known == type.attributes.end()) {
        meant.push_back(logic::NearestName(attribute.name, names));
        Say(attribute.name_place,
            fmt::format("<{}> has no attribute '{}'", element.name, attribute.name),
            HintFor(attribute.name, names));
      } else {
        CheckValue(attribute, known->second.type, messages);
      }
    }
    for (const auto& [name, attribute] : type.attributes) {
      if (!attribute.required || element.Find(name) != nullptr) continue;
      if (std::ranges::find(meant, name) != meant.end()) continue;
      Say(element.place, fmt::format("<{}> lacks the attribute '{}'", element.name, name),
          Expectation(attribute.type));
    }
  }

  std::string Expectation(const std::string& type) const {
    const auto value = schema_.values.find(type);
    return value == schema_.values.end() ? "" : fmt::format("it is {}", value->second.help);
  }

  /// The validator does not name the attribute, but quotes the value and the pattern that it
  /// missed.
  void CheckValue(const Attribute& attribute, const std::string& type_name,
                  const std::vector<std::string>& messages) {
    const auto type = schema_.values.find(type_name);
    if (type == schema_.values.end()) return;
    const std::string quoted = "'" + attribute.value + "'";
    const bool is_wrong = std::ranges::any_of(messages, [&](const std::string& message) {
      const std::size_t value = message.find(quoted);
      return value != std::string::npos && message.find("'" + type->second.pattern + "'",
                                                        value + quoted.size()) != std::string::npos;
    });
    if (!is_wrong) return;
    Say(attribute.place, fmt::format("'{}' is not {}", attribute.value, type->second.help), "");
  }

  const SchemaIndex& schema_;
  const Complaints& complaints_;
  logic::Diagnostics diagnostics_;
};

}  // namespace

logic::Diagnostics Explain(const Element& root, const SchemaIndex& schema,
                           const Complaints& complaints) {
  return Explainer(schema, complaints).Run(root);
}

}  // namespace latchwork::config
