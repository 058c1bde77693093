// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_PARAMETERS_H_
#define LATCHWORK_SDK_PARAMETERS_H_

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "latchwork/logic/diagnostic.h"
#include "latchwork/sdk/contract.h"

namespace latchwork::sdk {

/// Checked values of a plugin's parameters, defaults filled in: every name of the plugin's table is
/// present with its declared type, so the getters cannot fail for a declared name (they abort for
/// an undeclared one: a programming error).
class Parameters {
 public:
  struct Given {
    std::string name;
    std::string value;
    logic::SourcePlace place;
  };

  /// Checks what was given against the table. Unknown names, bad values, values out of range and
  /// missing ones are diagnostics; `owner` names the plugin in them, `owner_place` is where a
  /// missing parameter is reported. Files are resolved against the folder of the file in which they
  /// were given. Later entries of the same name override earlier ones.
  static Parameters Check(std::span<const ParameterSpec> table, std::span<const Given> given,
                          std::string_view owner, const logic::SourcePlace& owner_place,
                          logic::Diagnostics& diagnostics);
  /// All defaults; for tests and tools. Aborts when a parameter has no default.
  static Parameters Defaults(std::span<const ParameterSpec> table);

  std::int64_t Integer(std::string_view name) const;
  double Real(std::string_view name) const;
  bool Boolean(std::string_view name) const;
  const std::string& Text(std::string_view name) const;
  /// Empty when the parameter is an empty text.
  std::filesystem::path File(std::string_view name) const;
  /// Where the value was given; the owner's place for a default.
  const logic::SourcePlace& PlaceOf(std::string_view name) const;

  using Value = std::variant<std::int64_t, double, bool, std::string>;
  struct Entry {
    Value value;
    logic::SourcePlace place;
  };
  const std::map<std::string, Entry, std::less<>>& entries() const { return entries_; }

 private:
  std::map<std::string, Entry, std::less<>> entries_;
};

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_PARAMETERS_H_
