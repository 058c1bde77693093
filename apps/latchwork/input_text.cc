// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork/input_text.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace latchwork::app {
namespace {

constexpr std::size_t kMostBytes = 256U << 20U;

std::string ReadStream(std::istream& stream, std::size_t most) {
  std::string text;
  std::array<char, 1U << 16U> buffer{};
  while (text.size() <= most) {
    stream.read(buffer.data(), buffer.size());
    if (stream.gcount() == 0) break;
    text.append(buffer.data(), static_cast<std::size_t>(stream.gcount()));
  }
  return text;
}

/// Why a file cannot be opened; empty: `stream` has it.
std::string Open(const std::string& name, std::ifstream& stream) {
  std::error_code error;
  const auto status = std::filesystem::status(name, error);
  if (status.type() == std::filesystem::file_type::not_found) return "there is no such file";
  if (std::filesystem::is_directory(status)) return "this is a directory, not a file";
  stream.open(name, std::ios::binary);
  return stream ? "" : fmt::format("the file cannot be read: {}", std::strerror(errno));
}

}  // namespace

std::optional<std::string> ReadStandardInput(std::size_t most) {
  std::string text = ReadStream(std::cin, most);
  if (std::ferror(stdin) != 0) return std::nullopt;
  return text;
}

std::optional<std::string> ReadInputText(const std::string& name, logic::Diagnostics& diagnostics) {
  std::ifstream stream;
  const std::string problem = name == "-" ? "" : Open(name, stream);
  if (!problem.empty()) {
    diagnostics.push_back({{name, 0, 0}, problem, "", ""});
    return std::nullopt;
  }
  const auto text = name == "-" ? ReadStandardInput(kMostBytes) : ReadStream(stream, kMostBytes);
  if (!text) {
    diagnostics.push_back({{name, 0, 0}, std::string(kInputUnreadable), "", ""});
    return std::nullopt;
  }
  if (text->size() <= kMostBytes) return text;
  diagnostics.push_back({{name, 0, 0}, "the file is larger than 256 MiB", "", ""});
  return std::nullopt;
}

}  // namespace latchwork::app
