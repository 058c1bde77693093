// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "core/sdk/parameter_value.h"

namespace latchwork::sdk {
namespace {

using Entries = std::map<std::string, Parameters::Entry, std::less<>>;

[[noreturn]] void Abort(std::string_view name, std::string_view what) {
  fmt::print(stderr, "latchwork: parameter '{}' {}\n", name, what);
  std::abort();
}

const Parameters::Entry& EntryOf(const Entries& entries, std::string_view name) {
  const auto found = entries.find(name);
  if (found == entries.end()) Abort(name, "is not declared by its plugin");
  return found->second;
}

template <typename Type>
const Type& ValueOf(const Entries& entries, std::string_view name) {
  const auto* value = std::get_if<Type>(&EntryOf(entries, name).value);
  if (value == nullptr) Abort(name, "is declared with another type");
  return *value;
}

logic::Diagnostic UnknownParameter(std::span<const ParameterSpec> table,
                                   const Parameters::Given& given, std::string_view owner) {
  std::vector<std::string> names;
  for (const ParameterSpec& spec : table) names.push_back(spec.name);
  std::string hint;
  if (names.empty()) {
    hint = "it takes no parameters";
  } else if (const auto nearest = logic::NearestName(given.name, names); !nearest.empty()) {
    hint = fmt::format("did you mean '{}'?", nearest);
  } else {
    hint = fmt::format("it takes {}", fmt::join(names, ", "));
  }
  return {given.place, fmt::format("{} has no parameter '{}'", owner, given.name), hint, ""};
}

logic::Diagnostic BadValue(const ParameterSpec& spec, const Parameters::Given& given,
                           std::string_view owner) {
  std::string hint;
  if (const auto nearest = logic::NearestName(given.value, spec.choices); !nearest.empty()) {
    hint = fmt::format("did you mean '{}'?", nearest);
  } else if (spec.default_value) {
    hint = fmt::format("the default is '{}'", *spec.default_value);
  }
  return {given.place,
          fmt::format("parameter '{}' of {} must be {}, not '{}'", spec.name, owner, Allowed(spec),
                      given.value),
          hint, ""};
}

/// Relative paths are relative to the file that gave them.
Parameters::Value Resolved(const ParameterSpec& spec, Parameters::Value value,
                           const std::string& file) {
  if (spec.type != ParameterType::kFile) return value;
  const std::filesystem::path path = std::get<std::string>(value);
  if (path.empty() || path.is_absolute()) return value;
  return (std::filesystem::path(file).parent_path() / path).lexically_normal().string();
}

/// A default that its own declaration forbids is the plugin's fault, and no default.
std::optional<Parameters::Value> DefaultOf(const ParameterSpec& spec) {
  return spec.default_value ? ParseParameter(spec, *spec.default_value) : std::nullopt;
}

logic::Diagnostic MissingValue(const ParameterSpec& spec, std::string_view owner,
                               const logic::SourcePlace& owner_place) {
  if (spec.default_value) {
    return {owner_place,
            fmt::format("the default '{}' of parameter '{}' of {} is not {}", *spec.default_value,
                        spec.name, owner, Allowed(spec)),
            "the plugin is at fault; give the parameter a value", ""};
  }
  return {owner_place, fmt::format("parameter '{}' of {} is missing", spec.name, owner),
          fmt::format("add <param name=\"{}\" value=\"…\"/>: {}", spec.name, Allowed(spec)), ""};
}

}  // namespace

Parameters Parameters::Check(std::span<const ParameterSpec> table, std::span<const Given> given,
                             std::string_view owner, const logic::SourcePlace& owner_place,
                             logic::Diagnostics& diagnostics) {
  Parameters result;
  std::vector<bool> has_value;
  for (const ParameterSpec& spec : table) {
    std::optional<Value> value = DefaultOf(spec);
    has_value.push_back(value.has_value());
    if (!value) value = NoValue(spec.type);
    result.entries_.insert_or_assign(spec.name, Entry{*std::move(value), owner_place});
  }
  for (const Given& one : given) {
    const auto spec =
        std::ranges::find(table, one.name, [](const ParameterSpec& s) { return s.name; });
    if (spec == table.end()) {
      diagnostics.push_back(UnknownParameter(table, one, owner));
      continue;
    }
    has_value[static_cast<std::size_t>(spec - table.begin())] = true;
    if (auto value = ParseParameter(*spec, one.value)) {
      Value resolved = Resolved(*spec, *std::move(value), one.place.file);
      result.entries_[spec->name] = {std::move(resolved), one.place};
    } else {
      diagnostics.push_back(BadValue(*spec, one, owner));
    }
  }
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (!has_value[i]) diagnostics.push_back(MissingValue(table[i], owner, owner_place));
  }
  return result;
}

Parameters Parameters::Defaults(std::span<const ParameterSpec> table) {
  Parameters result;
  for (const ParameterSpec& spec : table) {
    std::optional<Value> value = DefaultOf(spec);
    if (!value) Abort(spec.name, "has no default");
    result.entries_.insert_or_assign(spec.name, Entry{*std::move(value), {}});
  }
  return result;
}

std::int64_t Parameters::Integer(std::string_view name) const {
  return ValueOf<std::int64_t>(entries_, name);
}

double Parameters::Real(std::string_view name) const { return ValueOf<double>(entries_, name); }

bool Parameters::Boolean(std::string_view name) const { return ValueOf<bool>(entries_, name); }

const std::string& Parameters::Text(std::string_view name) const {
  return ValueOf<std::string>(entries_, name);
}

std::filesystem::path Parameters::File(std::string_view name) const { return Text(name); }

const logic::SourcePlace& Parameters::PlaceOf(std::string_view name) const {
  return EntryOf(entries_, name).place;
}

}  // namespace latchwork::sdk
