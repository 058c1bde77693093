// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/map_image.h"

#include <mrpt/img/CImage.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>

namespace latchwork::office {

namespace {

constexpr std::uintmax_t kMaxFileBytes = 256U << 20U;

LoadedImage Fail(const std::filesystem::path& file, std::string_view what) {
  LoadedImage image;
  image.error = file.string() + ": " + std::string(what);
  return image;
}

std::uint32_t BigEndian(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8U | bytes[at + i];
  return value;
}

/// ISO 3309, as PNG asks for it.
std::uint32_t Checksum(std::span<const std::uint8_t> bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

/// Empty when every chunk up to IEND is whole. The decoder below would draw a cut picture as far as
/// it goes, or print.
std::string_view CheckPng(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  if (bytes.size() < 33 || !std::equal(kSignature.begin(), kSignature.end(), bytes.begin())) {
    return "not a PNG picture";
  }
  std::size_t at = 8;
  while (bytes.size() - at >= 12) {
    const std::size_t length = BigEndian(bytes, at);
    if (length > bytes.size() - at - 12) return "the PNG picture is cut short";
    if (Checksum(bytes.subspan(at + 4, length + 4)) != BigEndian(bytes, at + 8 + length)) {
      return "the PNG picture is damaged: a checksum does not match";
    }
    if (BigEndian(bytes, at + 4) == 0x49454e44U) return {};
    at += length + 12;
  }
  return "the PNG picture is cut short";
}

LoadedImage LoadPng(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
  if (const auto wrong = CheckPng(bytes); !wrong.empty()) return Fail(file, wrong);
  LoadedImage image;
  image.error = CheckMapSize(BigEndian(bytes, 16), BigEndian(bytes, 20), file.string());
  if (!image.error.empty()) return image;
  mrpt::img::CImage picture;
  if (!picture.loadFromFile(file.string(), 0) || picture.isEmpty()) {
    return Fail(file, "the PNG picture cannot be decoded");
  }
  image.width = static_cast<int>(picture.getWidth());
  image.height = static_cast<int>(picture.getHeight());
  for (int row = image.height - 1; row >= 0; --row) {
    const auto* line = picture.ptrLine<std::uint8_t>(static_cast<unsigned>(row));
    image.grey.insert(image.grey.end(), line, line + image.width);
  }
  return image;
}

/// Numbers of a PGM, separated by blanks and comments.
class PgmReader {
 public:
  explicit PgmReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::optional<std::uint32_t> Number() {
    SkipBlanks();
    const auto* first = reinterpret_cast<const char*>(bytes_.data()) + at_;
    const auto* last = reinterpret_cast<const char*>(bytes_.data()) + bytes_.size();
    std::uint32_t value = 0;
    const auto [end, code] = std::from_chars(first, last, value);
    if (code != std::errc()) return std::nullopt;
    at_ += static_cast<std::size_t>(end - first);
    return value;
  }
  void Skip(std::size_t count) { at_ += count; }
  std::span<const std::uint8_t> rest() const {
    return at_ < bytes_.size() ? bytes_.subspan(at_) : std::span<const std::uint8_t>();
  }

 private:
  void SkipBlanks() {
    while (at_ < bytes_.size()) {
      const std::uint8_t c = bytes_[at_];
      if (c == '#') {
        while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
      } else if (c == ' ' || (c >= '\t' && c <= '\r')) {
        ++at_;
      } else {
        return;
      }
    }
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

/// The samples from the top row down, scaled to 0..255, or too few of them.
std::vector<std::uint8_t> PgmSamples(PgmReader& reader, bool plain, std::size_t count,
                                     std::uint32_t maximum) {
  std::vector<std::uint8_t> samples;
  const std::size_t width = maximum > 255 ? 2 : 1;
  if (!plain) reader.Skip(1);
  // Even a plain sample takes a byte and a blank, so a lying header is found before memory is asked
  // for.
  if (reader.rest().size() / width < (plain ? count / 2 : count)) return samples;
  samples.reserve(count);
  const auto bytes = reader.rest();
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t value = 0;
    if (plain) {
      const auto number = reader.Number();
      if (!number) return samples;
      value = *number;
    } else {
      value = width == 1 ? bytes[i] : bytes[2 * i] * 256U + bytes[2 * i + 1];
    }
    samples.push_back(static_cast<std::uint8_t>(std::min(value, maximum) * 255U / maximum));
  }
  return samples;
}

LoadedImage LoadPgm(const std::filesystem::path& file, std::span<const std::uint8_t> bytes) {
  const bool plain = bytes.size() > 2 && bytes[0] == 'P' && bytes[1] == '2';
  const bool binary = bytes.size() > 2 && bytes[0] == 'P' && bytes[1] == '5';
  if (!plain && !binary) return Fail(file, "not a PGM picture (P2 or P5)");
  PgmReader reader(bytes);
  reader.Skip(2);
  const auto width = reader.Number();
  const auto height = reader.Number();
  const auto maximum = reader.Number();
  if (!width || !height || !maximum || *maximum == 0 || *maximum > 65535) {
    return Fail(file, "the PGM header is damaged");
  }
  LoadedImage image;
  image.error = CheckMapSize(*width, *height, file.string());
  if (!image.error.empty()) return image;
  const std::size_t count = std::size_t{*width} * *height;
  const auto samples = PgmSamples(reader, plain, count, *maximum);
  if (samples.size() < count) return Fail(file, "the PGM picture is cut short");
  image.width = static_cast<int>(*width);
  image.height = static_cast<int>(*height);
  image.grey.reserve(count);
  for (std::size_t row = *height; row-- > 0;) {
    const auto first = samples.begin() + static_cast<std::ptrdiff_t>(row * *width);
    image.grey.insert(image.grey.end(), first, first + static_cast<std::ptrdiff_t>(*width));
  }
  return image;
}

}  // namespace

std::string CheckMapSize(std::uint64_t width, std::uint64_t height, const std::string& name) {
  if (width < 2 || height < 2) return name + ": the map is empty";
  if (width > kMaxSide || height > kMaxSide || width * height > kMaxCells) {
    return name + ": the map has " + std::to_string(width) + " x " + std::to_string(height) +
           " cells; at most " + std::to_string(kMaxSide) + " a side and " +
           std::to_string(kMaxCells) + " in all are taken";
  }
  return {};
}

LoadedImage LoadImage(const std::filesystem::path& file) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code) return Fail(file, "no such file");
  if (size > kMaxFileBytes) return Fail(file, "larger than 256 MB");
  std::ifstream in(file, std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in),
                                        std::istreambuf_iterator<char>()};
  if (!in) return Fail(file, "cannot be read");
  return file.extension() == ".png" ? LoadPng(file, bytes) : LoadPgm(file, bytes);
}

}  // namespace latchwork::office
