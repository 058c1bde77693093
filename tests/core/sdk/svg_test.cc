// SPDX-License-Identifier: BSD-3-Clause
#include "latchwork/sdk/svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>

#include "tests/temporary_folder.h"

namespace latchwork::sdk {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

Svg Room(double seconds = 0) { return Svg({.x1 = -1, .y1 = -2, .x2 = 9, .y2 = 4}, 50, seconds); }

TEST(SvgTest, HasTheSizeOfTheAreaInPixels) {
  EXPECT_THAT(Room().ToString(), StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\" "
                                            "viewBox=\"0 0 500 300\""));
  EXPECT_THAT(Room().ToString(), EndsWith("</svg>\n"));
}

TEST(SvgTest, ShapesAreDrawnWithYUpwards) {
  Svg svg = Room();
  svg.Circle({0, 3}, 0.5, {.fill = "red"});
  svg.Rectangle({2, 1}, {1, 0}, {.fill = "white", .stroke = "black", .width = 0.1});
  svg.Line({-1, -2}, {9, 4}, {.stroke = "#343a46", .width = 0.02, .dash = 0.2});
  const std::string text = svg.ToString();
  EXPECT_THAT(text, HasSubstr("<circle cx=\"50\" cy=\"50\" r=\"25\" fill=\"red\"/>"));
  EXPECT_THAT(text, HasSubstr("<rect x=\"100\" y=\"150\" width=\"50\" height=\"50\" fill=\"white\" "
                              "stroke=\"black\" stroke-width=\"5\"/>"));
  EXPECT_THAT(text, HasSubstr("<polyline points=\"0,300 500,0\" fill=\"none\" stroke=\"#343a46\" "
                              "stroke-width=\"1\" stroke-dasharray=\"10\"/>"));
}

TEST(SvgTest, PolygonKeepsItsPoints) {
  Svg svg = Room();
  const std::array<SvgPoint, 3> points{{{-1, 4}, {0, 4}, {0, 3.123}}};
  svg.Polygon(points, {.fill = "blue", .opacity = 0.25});
  EXPECT_THAT(svg.ToString(), HasSubstr("<polygon points=\"0,0 50,0 50,43.85\" fill=\"blue\" "
                                        "opacity=\"0.25\"/>"));
}

TEST(SvgTest, TextsAndColoursAreEscaped) {
  Svg svg = Room();
  svg.Text({0, 0}, "a<b & \"c\"\n>", {.size = 0.4, .anchor = SvgTextStyle::Anchor::kEnd});
  svg.Circle({0, 0}, 1, {.fill = "\"/><script>"});
  EXPECT_THAT(svg.ToString(), HasSubstr("<text x=\"50\" y=\"200\" font-size=\"20\" "
                                        "text-anchor=\"end\" fill=\"black\">a&lt;b &amp; "
                                        "&quot;c&quot; &gt;</text>"));
  EXPECT_THAT(svg.ToString(), Not(HasSubstr("<script>")));
}

TEST(SvgTest, ValueThatIsNoNumberDoesNotBreakTheFile) {
  Svg svg = Room();
  svg.Circle({std::numeric_limits<double>::quiet_NaN(), -0.00001}, 1, {.fill = "red"});
  EXPECT_THAT(svg.ToString(), HasSubstr("<circle cx=\"0\" cy=\"200\" r=\"50\""));
}

TEST(SvgTest, GroupWithOneKeyframeIsPlacedAndStands) {
  Svg svg = Room(10);
  svg.Group({{.x = 1, .y = 2, .angle = std::numbers::pi / 2}}, [&] {
    svg.Circle({1, 1}, 1, {.fill = "red"});
  });
  EXPECT_THAT(svg.ToString(), HasSubstr("<g transform=\"translate(100 100) rotate(-90) scale(1)\" "
                                        "opacity=\"1\">\n<circle cx=\"50\" cy=\"-50\""));
  EXPECT_THAT(svg.ToString(), Not(HasSubstr("animate")));
}

TEST(SvgTest, GroupMovesAlongItsKeyframes) {
  Svg svg({.x2 = 10, .y2 = 10}, 10, 20, 2);
  svg.Group({{.seconds = 5, .x = 1}, {.seconds = 10, .x = 2}, {.seconds = 20, .x = 2}}, [] {});
  EXPECT_THAT(svg.ToString(),
              HasSubstr("<animateTransform attributeName=\"transform\" type=\"translate\" "
                        "dur=\"10s\" repeatCount=\"indefinite\" keyTimes=\"0;0.25;0.5;1\" "
                        "values=\"10 100;10 100;20 100;20 100\"/>"));
  EXPECT_THAT(svg.ToString(), HasSubstr("type=\"rotate\" additive=\"sum\" dur=\"10s\" "
                                        "repeatCount=\"indefinite\" keyTimes=\"0;1\" "
                                        "values=\"0;0\""));
}

TEST(SvgTest, TurnsGoTheShorterWay) {
  Svg svg({.x2 = 10, .y2 = 10}, 10, 1);
  const double degree = std::numbers::pi / 180;
  svg.Group({{.angle = 170 * degree}, {.seconds = 1, .angle = -170 * degree}}, [] {});
  EXPECT_THAT(svg.ToString(), HasSubstr("values=\"-170;-190\""));
}

TEST(SvgTest, RestsTakeTwoKeyframes) {
  Svg svg({.x2 = 10, .y2 = 10}, 10, 4);
  svg.Group({{}, {.seconds = 1}, {.seconds = 2}, {.seconds = 3}, {.seconds = 4, .opacity = 0}},
            [] {});
  EXPECT_THAT(svg.ToString(), HasSubstr("<animate attributeName=\"opacity\" dur=\"4s\" "
                                        "repeatCount=\"indefinite\" keyTimes=\"0;0.75;1\" "
                                        "values=\"1;1;0\"/>"));
}

TEST(SvgTest, StillPictureOfAGroupShowsItsFirstKeyframe) {
  Svg svg({.x2 = 10, .y2 = 10}, 10);
  svg.Group({{.x = 1}, {.seconds = 5, .x = 2}}, [] {});
  EXPECT_THAT(svg.ToString(), HasSubstr("translate(10 100)"));
  EXPECT_THAT(svg.ToString(), Not(HasSubstr("animate")));
}

TEST(SvgTest, ShownIsSeenForItsTimeOnly) {
  Svg svg({.x2 = 10, .y2 = 10}, 10, 10);
  svg.Shown(2, 4, [&] { svg.Circle({1, 1}, 1, {.fill = "red"}); });
  svg.Shown(0, 5, [&] { svg.Circle({1, 1}, 1, {.fill = "red"}); });
  const std::string text = svg.ToString();
  EXPECT_THAT(text, HasSubstr("<g visibility=\"hidden\">\n<animate attributeName=\"visibility\" "
                              "calcMode=\"discrete\" dur=\"10s\" repeatCount=\"indefinite\" "
                              "keyTimes=\"0;0.2;0.4\" values=\"hidden;visible;hidden\"/>\n"
                              "<circle cx=\"10\" cy=\"90\""));
  EXPECT_THAT(text, HasSubstr("keyTimes=\"0;0.5\" values=\"visible;hidden\""));
}

TEST(SvgTest, SavesWhatItSays) {
  const test::TemporaryFolder folder;
  Svg svg = Room();
  svg.Circle({0, 0}, 1, {.fill = "red"});
  ASSERT_TRUE(svg.Save(folder.path() / "a.svg"));
  std::ifstream in(folder.path() / "a.svg", std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), svg.ToString());
  EXPECT_FALSE(svg.Save(folder.path() / "none" / "a.svg"));
}

}  // namespace
}  // namespace latchwork::sdk
