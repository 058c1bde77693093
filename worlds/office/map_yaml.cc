// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/map_yaml.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace latchwork::office {

namespace {

constexpr std::uintmax_t kMaxBytes = 1U << 20U;

std::string_view Trim(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string_view WithoutComment(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '#' && (i == 0 || text[i - 1] == ' ' || text[i - 1] == '\t')) {
      return text.substr(0, i);
    }
  }
  return text;
}

std::string_view Unquote(std::string_view text) {
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
      text.back() == text.front()) {
    return text.substr(1, text.size() - 2);
  }
  return text;
}

std::optional<double> Number(std::string_view text) {
  text = Trim(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = code == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<std::vector<double>> NumberList(std::string_view text) {
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') return std::nullopt;
  text = text.substr(1, text.size() - 2);
  std::vector<double> numbers;
  while (true) {
    const auto comma = text.find(',');
    const auto number = Number(text.substr(0, comma));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    if (comma == std::string_view::npos) return numbers;
    text.remove_prefix(comma + 1);
  }
}

class YamlReader {
 public:
  explicit YamlReader(std::filesystem::path file) : file_(std::move(file)) {}

  LoadedYaml Read(std::istream& in) {
    std::string line;
    while (result_.error.empty() && std::getline(in, line)) {
      ++line_;
      ReadLine(WithoutComment(line));
    }
    if (result_.error.empty() && result_.yaml.image.empty()) Missing("image");
    if (result_.error.empty() && !(result_.yaml.resolution > 0.0)) Missing("resolution");
    if (result_.error.empty() && !has_origin_) Missing("origin");
    return std::move(result_);
  }

 private:
  void Fail(const std::string& what) {
    result_.error =
        file_.string() + ":" + std::to_string(line_) + ":" + std::to_string(column_) + ": " + what;
  }
  void Missing(const std::string& key) {
    result_.error = file_.string() + ": the key '" + key + "' is missing";
  }

  void ReadLine(std::string_view line) {
    const auto colon = line.find(':');
    if (Trim(line).empty() || line.front() == '-' || line.front() == '%') return;
    column_ = 1;
    if (colon == std::string_view::npos) return Fail("expected 'key: value'");
    const auto value_at = line.find_first_not_of(" \t", colon + 1);
    column_ = (value_at == std::string_view::npos ? line.size() : value_at) + 1;
    Set(Trim(line.substr(0, colon)), Unquote(Trim(line.substr(colon + 1))));
  }

  void Set(std::string_view key, std::string_view value) {
    MapYaml& yaml = result_.yaml;
    if (key == "image") {
      if (value.empty()) return Fail("'image' names no file");
      yaml.image = file_.parent_path() / std::filesystem::path(value);
    } else if (key == "mode") {
      yaml.mode = std::string(value);
      if (value != "trinary" && value != "scale" && value != "raw") {
        Fail("'mode' must be trinary, scale or raw, not '" + yaml.mode + "'");
      }
    } else if (key == "origin") {
      SetOrigin(value);
    } else if (key == "negate") {
      yaml.negate = value == "1" || value == "true";
      if (!yaml.negate && value != "0" && value != "false") Fail("'negate' must be 0 or 1");
    } else if (key == "resolution") {
      SetNumber(key, value, 0.005, 1.0, yaml.resolution);
    } else if (key == "occupied_thresh") {
      SetNumber(key, value, 0.0, 1.0, yaml.occupied_threshold);
    } else if (key == "free_thresh") {
      SetNumber(key, value, 0.0, 1.0, yaml.free_threshold);
    }
  }

  void SetNumber(std::string_view key, std::string_view value, double low, double high,
                 double& target) {
    const auto number = Number(value);
    if (!number || *number < low || *number > high) {
      return Fail("'" + std::string(key) + "' must be a number between " +
                  (low > 0.0 ? "0.005" : "0") + " and 1, not '" + std::string(value) + "'");
    }
    target = *number;
  }

  void SetOrigin(std::string_view value) {
    const auto numbers = NumberList(value);
    if (!numbers || numbers->size() < 2 || numbers->size() > 3) {
      return Fail("'origin' must be [x, y, yaw] with finite numbers");
    }
    if (std::abs((*numbers)[0]) > 1e6 || std::abs((*numbers)[1]) > 1e6) {
      return Fail("'origin' must lie within a million metres");
    }
    if (numbers->size() == 3 && (*numbers)[2] != 0.0) {
      return Fail("the yaw of 'origin' must be 0: rotated maps are not taken; rotate the picture");
    }
    result_.yaml.origin = {(*numbers)[0], (*numbers)[1]};
    has_origin_ = true;
  }

  std::filesystem::path file_;
  LoadedYaml result_;
  std::size_t line_ = 0;
  std::size_t column_ = 1;
  bool has_origin_ = false;
};

}  // namespace

LoadedYaml LoadMapYaml(const std::filesystem::path& file) {
  std::error_code code;
  const auto size = std::filesystem::file_size(file, code);
  std::ifstream in(file, std::ios::binary);
  if (code || !in || size > kMaxBytes) {
    return {{}, file.string() + ": cannot be read, or larger than a map description can be"};
  }
  return YamlReader(file).Read(in);
}

}  // namespace latchwork::office
