// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/hanoi/hanoi_picture.h"

#include <fmt/format.h>

namespace latchwork::hanoi {
namespace {

constexpr double kPixels = 800;   // a metre
constexpr double kRemarkFor = 3;  // s
constexpr double kFastest = 60;   // s; a longer run is played faster

double HalfWidth(int disk, int disks) {
  return kPegDistance * (0.12 + 0.33 * static_cast<double>(disk) / static_cast<double>(disks));
}

/// By its size, from yellow to blue.
std::string Colour(int disk, int disks) {
  const double part = static_cast<double>(disk) / static_cast<double>(disks);
  return fmt::format("#{:02x}{:02x}{:02x}", static_cast<int>(250 - 190 * part),
                     static_cast<int>(190 - 80 * part), static_cast<int>(50 + 140 * part));
}

void DrawTable(sdk::Svg& svg, int target, double height) {
  svg.Rectangle({0, -0.02}, {kPegs * kPegDistance, 0}, {.fill = "#6b4f3a"});
  for (int peg = 0; peg < kPegs; ++peg) {
    const double x = PegX(peg);
    svg.Rectangle({x - 0.006, 0}, {x + 0.006, height - 0.05}, {.fill = "#b08d6e"});
    svg.Text({x, -0.055}, fmt::format("{}{}", PegName(peg), peg == target ? " (target)" : ""),
             {.size = 0.028, .anchor = sdk::SvgTextStyle::Anchor::kMiddle});
  }
}

void DrawGripper(sdk::Svg& svg, const Film& film) {
  svg.Group(film.gripper, [&] {
    svg.Rectangle({-0.008, kThickness + 0.012}, {0.008, 1}, {.fill = "#343a46"});
    svg.Rectangle({-0.05, kThickness}, {0.05, kThickness + 0.014}, {.fill = "#343a46"});
    svg.Rectangle({-0.05, 0.005}, {-0.04, kThickness}, {.fill = "#343a46"});
    svg.Rectangle({0.04, 0.005}, {0.05, kThickness}, {.fill = "#343a46"});
  });
}

}  // namespace

void Film::Add(double seconds_now, const Pegs& pegs, const Gripper& gripper_now) {
  seconds = seconds_now;
  gripper.push_back({.seconds = seconds, .x = gripper_now.x(), .y = gripper_now.z()});
  disks.resize(static_cast<std::size_t>(pegs.disks()));
  std::vector<int> lying(kPegs, 0);
  for (int disk = pegs.disks(); disk > 0; --disk) {
    const int peg = pegs.peg_of(disk);
    sdk::SvgKeyframe keyframe = gripper.back();
    if (peg != Pegs::kAir) {
      keyframe.x = PegX(peg);
      keyframe.y = kThickness * lying[static_cast<std::size_t>(peg)]++;
    }
    disks[static_cast<std::size_t>(disk) - 1].push_back(keyframe);
  }
}

bool DrawFilm(const Film& film, int target, const std::filesystem::path& file) {
  const int disks = static_cast<int>(film.disks.size());
  const double height = RaisedHeight(disks);
  const double top = height + 0.14;
  sdk::Svg svg({.y1 = -0.08, .x2 = kPegs * kPegDistance, .y2 = top}, kPixels, film.seconds,
               std::max(1.0, film.seconds / kFastest));
  svg.Rectangle({0, -0.08}, {kPegs * kPegDistance, top}, {.fill = "white"});
  DrawTable(svg, target, height);
  for (int disk = disks; disk > 0; --disk) {
    svg.Group(film.disks[static_cast<std::size_t>(disk) - 1], [&] {
      const double half = HalfWidth(disk, disks);
      svg.Rectangle({-half, 0.002}, {half, kThickness - 0.002},
                    {.fill = Colour(disk, disks), .stroke = "#343a46", .width = 0.002});
    });
  }
  DrawGripper(svg, film);
  for (const Film::Remark& remark : film.remarks) {
    svg.Shown(remark.seconds, remark.seconds + kRemarkFor, [&] {
      svg.Text({0.01, top - 0.035}, fmt::format("{:.1f} s: {}", remark.seconds, remark.text),
               {.size = 0.028, .fill = "#b3261e"});
    });
  }
  return svg.Save(file);
}

}  // namespace latchwork::hanoi
