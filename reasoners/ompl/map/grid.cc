// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/ompl/map/grid.h"

#include <png.h>

#include <algorithm>
#include <cmath>

namespace latchwork::planning {
namespace {

constexpr unsigned kMaxSide = 8192;
constexpr std::uint64_t kMaxCells = 16'000'000;

ReadGrid Fail(const std::filesystem::path& file, const std::string& why) {
  return {std::nullopt, file.string() + ": " + why};
}

/// libpng keeps memory of its own from the first call on.
class Picture {
 public:
  Picture() { image_.version = PNG_IMAGE_VERSION; }
  ~Picture() { png_image_free(&image_); }
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;

  bool Open(const std::filesystem::path& file) {
    if (png_image_begin_read_from_file(&image_, file.c_str()) == 0) return false;
    image_.format = PNG_FORMAT_GRAY;
    return true;
  }
  /// From the north row down.
  bool Read(std::vector<std::uint8_t>& grey) {
    grey.resize(PNG_IMAGE_SIZE(image_));
    const png_color white{255, 255, 255};
    return png_image_finish_read(&image_, &white, grey.data(), 0, nullptr) != 0;
  }
  const png_image& image() const { return image_; }

 private:
  png_image image_{};
};

}  // namespace

double Distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }

Point Between(Point a, Point b, double t) { return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; }

ReadGrid ReadPng(const std::filesystem::path& file, double resolution) {
  Picture picture;
  if (!picture.Open(file)) return Fail(file, picture.image().message);
  const unsigned width = picture.image().width;
  const unsigned height = picture.image().height;
  if (width < 2 || height < 2 || width > kMaxSide || height > kMaxSide ||
      std::uint64_t{width} * height > kMaxCells) {
    return Fail(file, "a floor has 2 to 8192 cells a side and at most 16 million in all");
  }
  std::vector<std::uint8_t> grey;
  if (!picture.Read(grey)) return Fail(file, picture.image().message);
  Grid grid{static_cast<int>(width), static_cast<int>(height), resolution, {}};
  grid.occupied.reserve(grey.size());
  for (std::size_t row = height; row-- > 0;) {
    const auto first = grey.begin() + static_cast<std::ptrdiff_t>(row * width);
    std::transform(
        first, first + static_cast<std::ptrdiff_t>(width), std::back_inserter(grid.occupied),
        [](std::uint8_t value) { return value < 128 ? std::uint8_t{1} : std::uint8_t{0}; });
  }
  return {std::move(grid), {}};
}

}  // namespace latchwork::planning
