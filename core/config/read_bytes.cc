// SPDX-License-Identifier: BSD-3-Clause
#include "core/config/read_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>

namespace latchwork::config {
namespace {

/// Length of the well-formed UTF-8 sequence at `offset`; 0 when there is none.
std::size_t SequenceLength(std::string_view text, std::size_t offset) {
  const auto byte = [&](std::size_t i) {
    return offset + i < text.size() ? static_cast<unsigned char>(text[offset + i]) : 0U;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80U) return 1;
  const std::size_t length = lead >= 0xf0U ? 4 : lead >= 0xe0U ? 3 : 2;
  if (lead < 0xc2U || lead > 0xf4U) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0U) != 0x80U) return 0;
  }
  const bool overlong = (lead == 0xe0U && byte(1) < 0xa0U) || (lead == 0xf0U && byte(1) < 0x90U);
  const bool surrogate = lead == 0xedU && byte(1) >= 0xa0U;
  const bool too_large = lead == 0xf4U && byte(1) >= 0x90U;
  return overlong || surrogate || too_large ? 0 : length;
}

logic::SourcePlace PlaceAt(std::string_view text, std::size_t offset, std::string_view name) {
  const std::string_view before = text.substr(0, offset);
  const auto lines = static_cast<std::uint32_t>(std::ranges::count(before, '\n'));
  const std::size_t start = before.rfind('\n') + 1;
  return {std::string(name), lines + 1, static_cast<std::uint32_t>(offset - start + 1)};
}

logic::Diagnostic Whole(std::string_view name, std::string message, std::string hint = "") {
  return {{std::string(name), 0, 0}, std::move(message), std::move(hint), ""};
}

bool LooksLikeUtf16(std::string_view bytes) {
  using namespace std::string_view_literals;
  return bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff") ||
         bytes.starts_with("<\0"sv) || bytes.starts_with("\0<"sv);
}

}  // namespace

std::optional<std::string> ReadBytes(const std::filesystem::path& file, std::size_t limit,
                                     logic::Diagnostics& diagnostics) {
  const std::string name = file.string();
  const auto fail = [&](std::string message) {
    diagnostics.push_back(Whole(name, std::move(message)));
    return std::nullopt;
  };
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) return fail("there is no such file");
  if (error) return fail(fmt::format("the file cannot be read: {}", error.message()));
  if (std::filesystem::is_directory(status)) return fail("this is a directory, not a file");
  if (!std::filesystem::is_regular_file(status)) return fail("this is not a regular file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return fail("the file cannot be opened for reading");
  std::string bytes;
  std::array<char, 65536> chunk{};
  while (bytes.size() <= limit && stream) {
    stream.read(chunk.data(), chunk.size());
    bytes.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return fail("the file cannot be read to its end");
  return bytes;
}

std::optional<logic::Diagnostic> CheckText(std::string_view bytes, std::string_view name,
                                           std::size_t limit) {
  if (bytes.empty()) return Whole(name, "the file is empty");
  if (bytes.size() > limit) {
    return Whole(name, fmt::format("the file is larger than {} MiB", limit >> 20U));
  }
  if (LooksLikeUtf16(bytes)) return Whole(name, "the file is UTF-16", "save it as UTF-8");
  std::size_t offset = 0;
  while (offset < bytes.size()) {
    if (bytes[offset] == '\0') {
      return logic::Diagnostic{PlaceAt(bytes, offset, name),
                               "a zero byte: this is a binary file, not text", "", ""};
    }
    const std::size_t length = SequenceLength(bytes, offset);
    if (length == 0) {
      return logic::Diagnostic{
          PlaceAt(bytes, offset, name),
          fmt::format("byte 0x{:02x} is not UTF-8", static_cast<unsigned char>(bytes[offset])),
          "save the file as UTF-8", ""};
    }
    offset += length;
  }
  return std::nullopt;
}

}  // namespace latchwork::config
