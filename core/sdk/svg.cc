// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "latchwork/sdk/markup.h"

namespace latchwork::sdk {
namespace {

using Keyframes = std::vector<SvgKeyframe>;
using Member = double SvgKeyframe::*;

/// At most `digits` behind the point, none that says nothing.
std::string Number(double value, int digits = 2) {
  if (!std::isfinite(value)) return "0";
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

bool SameLook(const SvgKeyframe& a, const SvgKeyframe& b) {
  return a.x == b.x && a.y == b.y && a.angle == b.angle && a.scale == b.scale &&
         a.opacity == b.opacity;
}

/// Without those in the midst of a rest; turns take the shorter way.
Keyframes Smoothed(const Keyframes& keyframes) {
  Keyframes smoothed;
  for (SvgKeyframe next : keyframes) {
    if (!smoothed.empty()) {
      const double before = smoothed.back().angle;
      next.angle = before + std::remainder(next.angle - before, 2 * std::numbers::pi);
    }
    const std::size_t size = smoothed.size();
    if (size >= 2 && SameLook(smoothed[size - 2], smoothed.back()) &&
        SameLook(smoothed.back(), next)) {
      smoothed.pop_back();
    }
    smoothed.push_back(next);
  }
  return smoothed;
}

std::string_view AnchorName(SvgTextStyle::Anchor anchor) {
  switch (anchor) {
    case SvgTextStyle::Anchor::kMiddle:
      return "middle";
    case SvgTextStyle::Anchor::kEnd:
      return "end";
    default:
      return "start";
  }
}

bool Varies(const Keyframes& keyframes, std::span<const Member> values) {
  return std::any_of(values.begin(), values.end(), [&](Member value) {
    return std::any_of(keyframes.begin(), keyframes.end(), [&](const SvgKeyframe& keyframe) {
      return keyframe.*value != keyframes.front().*value;
    });
  });
}

constexpr std::array<Member, 2> kPlace{&SvgKeyframe::x, &SvgKeyframe::y};
constexpr std::array<Member, 1> kAngle{&SvgKeyframe::angle};
constexpr std::array<Member, 1> kScale{&SvgKeyframe::scale};
constexpr std::array<Member, 1> kOpacity{&SvgKeyframe::opacity};

}  // namespace

Svg::Svg(const Area& area, double pixels_per_unit, double seconds, double speed)
    : area_(area), scale_(pixels_per_unit), seconds_(seconds), speed_(speed) {}

void Svg::Style(const SvgStyle& style) {
  auto out = std::back_inserter(body_);
  fmt::format_to(out, " fill=\"{}\"", Escaped(style.fill));
  if (style.stroke != "none") {
    fmt::format_to(out, R"( stroke="{}" stroke-width="{}")", Escaped(style.stroke),
                   Number(style.width * scale_));
  }
  if (style.opacity != 1) fmt::format_to(out, " opacity=\"{}\"", Number(style.opacity));
  if (style.dash > 0) {
    fmt::format_to(out, " stroke-dasharray=\"{}\"", Number(style.dash * scale_));
  }
  body_ += "/>\n";
}

void Svg::Line(SvgPoint from, SvgPoint to, const SvgStyle& style) {
  const std::array<SvgPoint, 2> points{from, to};
  Polyline(points, style);
}

void Svg::Points(std::string_view element, std::span<const SvgPoint> points,
                 const SvgStyle& style) {
  body_ += fmt::format("<{} points=\"", element);
  for (std::size_t i = 0; i < points.size(); ++i) {
    body_ +=
        fmt::format("{}{},{}", i == 0 ? "" : " ", Number(X(points[i].x)), Number(Y(points[i].y)));
  }
  body_ += '"';
  Style(style);
}

void Svg::Polyline(std::span<const SvgPoint> points, const SvgStyle& style) {
  Points("polyline", points, style);
}

void Svg::Polygon(std::span<const SvgPoint> points, const SvgStyle& style) {
  Points("polygon", points, style);
}

void Svg::Circle(SvgPoint centre, double radius, const SvgStyle& style) {
  body_ += fmt::format(R"(<circle cx="{}" cy="{}" r="{}")", Number(X(centre.x)),
                       Number(Y(centre.y)), Number(radius * scale_));
  Style(style);
}

void Svg::Rectangle(SvgPoint corner, SvgPoint opposite, const SvgStyle& style) {
  body_ += fmt::format(
      R"(<rect x="{}" y="{}" width="{}" height="{}")", Number(X(std::min(corner.x, opposite.x))),
      Number(Y(std::max(corner.y, opposite.y))), Number(std::abs(corner.x - opposite.x) * scale_),
      Number(std::abs(corner.y - opposite.y) * scale_));
  Style(style);
}

void Svg::Text(SvgPoint place, std::string_view text, const SvgTextStyle& style) {
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n",
      Number(X(place.x)), Number(Y(place.y)), Number(style.size * scale_), AnchorName(style.anchor),
      Escaped(style.fill), Escaped(text));
}

SvgKeyframe Svg::OnPage(const SvgKeyframe& keyframe) const {
  SvgKeyframe page = keyframe;
  page.seconds = seconds_ > 0 ? std::clamp(keyframe.seconds / seconds_, 0.0, 1.0) : 0;
  page.x = X(keyframe.x);
  page.y = Y(keyframe.y);
  page.angle = -keyframe.angle * 180 / std::numbers::pi;
  return page;
}

void Svg::Animation(std::string_view element, const Keyframes& keyframes,
                    std::span<const Member> values) {
  std::string times;
  std::string path;
  const auto add = [&](double time, const SvgKeyframe& keyframe) {
    times += (times.empty() ? "" : ";") + Number(time, 5);
    path += path.empty() ? "" : ";";
    for (std::size_t i = 0; i < values.size(); ++i) {
      path += (i == 0 ? "" : " ") + Number(keyframe.*values[i], 3);
    }
  };
  if (keyframes.front().seconds > 0) add(0, keyframes.front());
  if (Varies(keyframes, values)) {
    for (const SvgKeyframe& keyframe : keyframes) add(keyframe.seconds, keyframe);
  } else if (times.empty()) {
    add(0, keyframes.front());
  }
  if (keyframes.back().seconds < 1 || !Varies(keyframes, values)) add(1, keyframes.back());
  fmt::format_to(std::back_inserter(body_),
                 "<{} dur=\"{}s\" repeatCount=\"indefinite\" keyTimes=\"{}\" values=\"{}\"/>\n",
                 element, Number(seconds_ / speed_, 3), times, path);
}

/// The first replaces the transform of the group, the others add to it: all or none.
void Svg::Movement(const Keyframes& keyframes) {
  if (seconds_ <= 0) return;
  if (Varies(keyframes, kPlace) || Varies(keyframes, kAngle) || Varies(keyframes, kScale)) {
    constexpr std::string_view kName = "animateTransform attributeName=\"transform\"";
    Animation(fmt::format("{} type=\"translate\"", kName), keyframes, kPlace);
    Animation(fmt::format(R"({} type="rotate" additive="sum")", kName), keyframes, kAngle);
    Animation(fmt::format(R"({} type="scale" additive="sum")", kName), keyframes, kScale);
  }
  if (Varies(keyframes, kOpacity)) {
    Animation("animate attributeName=\"opacity\"", keyframes, kOpacity);
  }
}

void Svg::Group(const Keyframes& keyframes, const std::function<void()>& draw) {
  Keyframes page = Smoothed(keyframes);
  if (page.empty()) page.emplace_back();
  for (SvgKeyframe& keyframe : page) keyframe = OnPage(keyframe);
  const SvgKeyframe& first = page.front();
  fmt::format_to(std::back_inserter(body_),
                 "<g transform=\"translate({} {}) rotate({}) scale({})\" opacity=\"{}\">\n",
                 Number(first.x), Number(first.y), Number(first.angle), Number(first.scale, 3),
                 Number(first.opacity, 3));
  Movement(page);
  ++depth_;
  draw();
  --depth_;
  body_ += "</g>\n";
}

void Svg::Shown(double from_seconds, double to_seconds, const std::function<void()>& draw) {
  const bool first = from_seconds <= 0;
  fmt::format_to(std::back_inserter(body_), "<g visibility=\"{}\">\n",
                 first ? "visible" : "hidden");
  if (seconds_ > 0) {
    const auto time = [&](double seconds) {
      return Number(std::clamp(seconds / seconds_, 0.0, 1.0), 5);
    };
    fmt::format_to(std::back_inserter(body_),
                   "<animate attributeName=\"visibility\" calcMode=\"discrete\" dur=\"{}s\" "
                   "repeatCount=\"indefinite\" keyTimes=\"0;{}{}\" values=\"{}visible;hidden\"/>\n",
                   Number(seconds_ / speed_, 3), first ? "" : time(from_seconds) + ";",
                   time(to_seconds), first ? "" : "hidden;");
  }
  draw();
  body_ += "</g>\n";
}

std::string Svg::ToString() const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" data-area=\"{} {} {} {}\" "
      "font-family=\"sans-serif\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n{}</svg>\n",
      Number((area_.x2 - area_.x1) * scale_), Number((area_.y2 - area_.y1) * scale_),
      Number(area_.x1, 4), Number(area_.y1, 4), Number(area_.x2, 4), Number(area_.y2, 4), body_);
}

bool Svg::Save(const std::filesystem::path& file) const {
  std::ofstream out(file, std::ios::binary);
  out << ToString();
  out.close();
  return static_cast<bool>(out);
}

}  // namespace latchwork::sdk
