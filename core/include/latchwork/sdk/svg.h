// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_SVG_H_
#define LATCHWORK_SDK_SVG_H_

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace latchwork::sdk {

struct SvgPoint {
  double x = 0;
  double y = 0;
};

/// How a shape looks. Colours as SVG writes them ("#343a46", "white", "none"); lengths in the units
/// of the drawing.
struct SvgStyle {
  std::string_view fill = "none";
  std::string_view stroke = "none";
  double width = 0;    ///< Of the stroke.
  double opacity = 1;  ///< 0 to 1.
  double dash = 0;     ///< Length of the dashes and of the gaps between them; 0: a whole line.
};

/// How a text looks; its place is the left end, the middle or the right end of its base line.
struct SvgTextStyle {
  enum class Anchor : unsigned char { kStart, kMiddle, kEnd };
  double size = 1;  ///< Height of the letters, in the units of the drawing.
  Anchor anchor = Anchor::kStart;
  std::string_view fill = "black";
};

/// Where the origin of a group is at some moment, and how the group looks then. Between two of them
/// everything changes linearly; two at the same moment make a jump.
struct SvgKeyframe {
  double seconds = 0;
  double x = 0;
  double y = 0;
  double angle = 0;  ///< rad, counter-clockwise; from one keyframe to the next the shorter way.
  double scale = 1;
  double opacity = 1;
};

/// A drawing in the units of a world, y upwards, that plays in a browser by itself, over and over:
///
///     Svg svg({.x2 = 10, .y2 = 6}, 50, 60);               // 10 m x 6 m, 50 pixels a metre, 60 s
///     svg.Rectangle({0, 0}, {10, 6}, {.fill = "white"});
///     svg.Group(keyframes, [&] { svg.Circle({0, 0}, 0.4, {.fill = "red"}); });
///     svg.Save(folder / "run.svg");
///
/// Without a player it shows the first moment. Shapes lie over those drawn before them. The same
/// calls give the same bytes, whatever the locale. Thread rule: used by one thread.
class Svg {
 public:
  struct Area {
    double x1 = 0;
    double y1 = 0;
    double x2 = 1;
    double y2 = 1;
  };

  /// `seconds` is how long the animation takes; 0 is a still picture: of every group the first
  /// keyframe counts. `speed` is how many of these seconds pass in one of the watcher's.
  Svg(const Area& area, double pixels_per_unit, double seconds = 0, double speed = 1);

  void Line(SvgPoint from, SvgPoint to, const SvgStyle& style);
  void Polyline(std::span<const SvgPoint> points, const SvgStyle& style);
  void Polygon(std::span<const SvgPoint> points, const SvgStyle& style);
  void Circle(SvgPoint centre, double radius, const SvgStyle& style);
  /// From any corner to the opposite one.
  void Rectangle(SvgPoint corner, SvgPoint opposite, const SvgStyle& style);
  void Text(SvgPoint place, std::string_view text, const SvgTextStyle& style = {});

  /// What `draw` draws into this drawing is placed, and moved, as the keyframes say; the
  /// coordinates in it are the group's own. Keyframes come in the order of time; one alone places a
  /// group that does not move, none leaves it at the origin. Groups nest.
  void Group(const std::vector<SvgKeyframe>& keyframes, const std::function<void()>& draw);
  /// What `draw` draws is seen from one moment to another only.
  void Shown(double from_seconds, double to_seconds, const std::function<void()>& draw);

  /// The whole file.
  std::string ToString() const;
  /// False when the file cannot be written.
  bool Save(const std::filesystem::path& file) const;

 private:
  double X(double x) const { return depth_ == 0 ? (x - area_.x1) * scale_ : x * scale_; }
  double Y(double y) const { return depth_ == 0 ? (area_.y2 - y) * scale_ : -y * scale_; }
  SvgKeyframe OnPage(const SvgKeyframe& keyframe) const;
  void Points(std::string_view element, std::span<const SvgPoint> points, const SvgStyle& style);
  void Style(const SvgStyle& style);
  void Animation(std::string_view element, const std::vector<SvgKeyframe>& keyframes,
                 std::span<double SvgKeyframe::*const> values);
  void Movement(const std::vector<SvgKeyframe>& keyframes);

  Area area_;
  double scale_ = 1;
  double seconds_ = 0;
  double speed_ = 1;
  int depth_ = 0;
  std::string body_;
};

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_SVG_H_
