// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <exception>
#include <string_view>
#include <utility>

#include "worlds/office/floor_map.h"
#include "worlds/office/map_image.h"
#include "worlds/office/map_yaml.h"

namespace latchwork::office {

namespace {

constexpr double kFreeAbove = 0.6;
constexpr std::size_t kMaxBytes = 512U << 20U;

LoadedCells Fail(std::string message) { return {std::nullopt, std::move(message)}; }

LoadedCells FromImage(const std::filesystem::path& file, double resolution) {
  LoadedImage image = LoadImage(file);
  if (!image.error.empty()) return Fail(std::move(image.error));
  Cells cells{image.width, image.height, resolution, {0.0, 0.0}, std::move(image.grey)};
  for (std::uint8_t& value : cells.occupied) value = value < 128 ? 1 : 0;
  return {std::move(cells), {}};
}

bool IsUnknownOrOccupied(double p_occupied, const MapYaml& yaml, int grey) {
  // As map_server does it: trinary marks everything between the thresholds unknown; in the scale
  // mode those values are graded, and only what is surely free may be driven on.
  return p_occupied >= yaml.free_threshold || (yaml.mode == "raw" && grey > 100);
}

LoadedCells FromYaml(const std::filesystem::path& file) {
  LoadedYaml loaded = LoadMapYaml(file);
  if (!loaded.error.empty()) return Fail(std::move(loaded.error));
  const MapYaml& yaml = loaded.yaml;
  LoadedImage image = LoadImage(yaml.image);
  if (!image.error.empty()) return Fail(std::move(image.error));
  Cells cells{image.width, image.height, yaml.resolution, yaml.origin, std::move(image.grey)};
  for (std::uint8_t& value : cells.occupied) {
    const double p = yaml.negate ? value / 255.0 : (255 - value) / 255.0;
    value = IsUnknownOrOccupied(p, yaml, value) ? 1 : 0;
  }
  return {std::move(cells), {}};
}

LoadedCells FromGrid(const mrpt::maps::COccupancyGridMap2D& grid, const std::string& name) {
  const std::string error = CheckMapSize(grid.getSizeX(), grid.getSizeY(), name);
  if (!error.empty()) return Fail(error);
  Cells cells{static_cast<int>(grid.getSizeX()),
              static_cast<int>(grid.getSizeY()),
              std::round(static_cast<double>(grid.getResolution()) * 1e6) / 1e6,
              {static_cast<double>(grid.getXMin()), static_cast<double>(grid.getYMin())},
              {}};
  if (!(cells.resolution > 0.0) || !std::isfinite(cells.origin.x + cells.origin.y)) {
    return Fail(name + ": not a usable grid: resolution or origin is not a number above zero");
  }
  cells.occupied.reserve(static_cast<std::size_t>(cells.width) *
                         static_cast<std::size_t>(cells.height));
  for (int y = 0; y < cells.height; ++y) {
    for (int x = 0; x < cells.width; ++x) {
      const bool is_free = static_cast<double>(grid.getCell(x, y)) >= kFreeAbove;
      cells.occupied.push_back(is_free ? 0 : 1);
    }
  }
  return {std::move(cells), {}};
}

/// The unpacked bytes of a file, or nothing when it is larger than any map should be.
std::optional<std::vector<std::uint8_t>> Unpack(const std::filesystem::path& file) {
  mrpt::io::CFileGZInputStream in;
  if (!in.open(file.string())) return std::nullopt;
  std::vector<std::uint8_t> bytes;
  std::array<std::uint8_t, 65536> block{};
  while (const std::size_t got = in.Read(block.data(), block.size())) {
    bytes.insert(bytes.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(got));
    if (bytes.size() > kMaxBytes) return std::nullopt;
  }
  return bytes;
}

/// MRPT writes: length of the class name with the top bit set, name, version, bits of a cell,
/// width, height, cells. It believes the sizes, so they are compared with the bytes that are there
/// before it reads them.
bool HoldsItsGrid(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view kName = "COccupancyGridMap2D";
  constexpr std::size_t kHeader = 1 + kName.size() + 1 + 1 + 8;
  if (bytes.size() < kHeader || bytes[0] != (0x80U | kName.size())) return false;
  if (std::memcmp(bytes.data() + 1, kName.data(), kName.size()) != 0) return false;
  std::array<std::uint32_t, 2> size{};
  std::memcpy(size.data(), bytes.data() + kHeader - 8, 8);
  const std::uint64_t cells = std::uint64_t{size[0]} * size[1];
  return size[0] <= kMaxSide && size[1] <= kMaxSide && cells <= bytes.size() - kHeader;
}

LoadedCells FromGridmap(const std::filesystem::path& file) {
  const std::string name = file.string();
  auto bytes = Unpack(file);
  if (!bytes) return Fail(name + ": cannot be read, or holds more than 512 MB");
  if (!HoldsItsGrid(*bytes)) return Fail(name + ": not an MRPT occupancy grid, or cut short");
  mrpt::io::CMemoryStream stream;
  stream.assignMemoryNotOwn(bytes->data(), bytes->size());
  auto archive = mrpt::serialization::archiveFrom(stream);
  mrpt::maps::COccupancyGridMap2D grid(0.0F, 1.0F, 0.0F, 1.0F, 0.5F);
  archive >> grid;
  return FromGrid(grid, name);
}

/// The class was called CSensFrameProbSequence once; files of that time are still shipped.
bool IsSimplemap(const std::vector<std::uint8_t>& bytes) {
  constexpr std::array<std::string_view, 2> kNames{"CSimpleMap", "CSensFrameProbSequence"};
  return std::any_of(kNames.begin(), kNames.end(), [&](std::string_view name) {
    return bytes.size() >= name.size() + 6 &&
           (std::memcmp(bytes.data() + 1, name.data(), name.size()) == 0 ||
            std::memcmp(bytes.data() + 4, name.data(), name.size()) == 0);
  });
}

LoadedCells FromSimplemap(const std::filesystem::path& file) {
  const std::string name = file.string();
  auto bytes = Unpack(file);
  if (!bytes) return Fail(name + ": cannot be read, or holds more than 512 MB");
  if (!IsSimplemap(*bytes)) return Fail(name + ": not an MRPT simplemap");
  mrpt::io::CMemoryStream stream;
  stream.assignMemoryNotOwn(bytes->data(), bytes->size());
  auto archive = mrpt::serialization::archiveFrom(stream);
  mrpt::maps::CSimpleMap poses;
  archive >> poses;
  if (poses.empty()) return Fail(name + ": the simplemap holds no observation");
  mrpt::maps::COccupancyGridMap2D grid(-5.0F, 5.0F, -5.0F, 5.0F, 0.05F);
  grid.insertionOptions.maxDistanceInsertion = 20.0F;
  grid.insertionOptions.maxOccupancyUpdateCertainty = 0.7F;
  grid.loadFromSimpleMap(poses);
  return FromGrid(grid, name);
}

std::string SuffixOf(const std::filesystem::path& file) {
  const std::filesystem::path suffix = file.extension();
  return suffix == ".gz" ? file.stem().extension().string() : suffix.string();
}

LoadedCells LoadBySuffix(const std::filesystem::path& file, double resolution) {
  const std::string suffix = SuffixOf(file);
  if (suffix == ".png" || suffix == ".pgm") return FromImage(file, resolution);
  if (suffix == ".yaml" || suffix == ".yml") return FromYaml(file);
  if (suffix == ".gridmap") return FromGridmap(file);
  if (suffix == ".simplemap") return FromSimplemap(file);
  return Fail(file.string() +
              ": not a known kind of map: the name must end in .png, .pgm, .yaml, .gridmap[.gz] or "
              ".simplemap[.gz]");
}

}  // namespace

LoadedCells LoadCells(const std::filesystem::path& file, double resolution) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(file, code)) {
    return Fail(file.string() + ": no such file");
  }
  if (!(resolution >= 0.005 && resolution <= 1.0)) {
    return Fail(file.string() + ": the resolution must lie between 0.005 and 1 m per cell");
  }
  try {
    return LoadBySuffix(file, resolution);
  } catch (const std::exception&) {
    // MRPT's texts carry back-traces; the reason is always the same: the bytes are not what the
    // name says.
    return Fail(file.string() + ": damaged or not a map of the kind that its name says");
  }
}

}  // namespace latchwork::office
