// SPDX-License-Identifier: BSD-3-Clause
#include "worlds/office/making.h"

namespace latchwork::office {

namespace {

void PutDeclaredBox(Making& making, std::string_view text) {
  std::vector<double> numbers;
  for (const auto word : Words(text)) {
    if (const auto number = Number(word)) numbers.push_back(*number);
  }
  if (numbers.size() != 5 || Words(text).size() != 5 || numbers[3] <= 0 || numbers[4] <= 0) {
    return making.Fail("box", "'" + std::string(text) + "' is not 'floor x y width depth'");
  }
  const auto floor = making.building().FindFloor(static_cast<int>(numbers[0]));
  if (!floor) return making.Fail("box", "a box stands on a floor that does not exist");
  const Box box{*floor, {numbers[1], numbers[2], numbers[1] + numbers[3], numbers[2] + numbers[4]}};
  const bool on_robot =
      *floor == making.state.floor &&
      Distance(PointOf(making.state.vehicle->pose()), box.area) < making.state.radius;
  if (on_robot) return making.Fail("box", "a box stands where the robot starts");
  making.state.PutBox(box);
}

}  // namespace

void PutBoxes(Making& making) {
  for (const auto text : Words(making.parameters.Text("box"), ";")) PutDeclaredBox(making, text);
  const Point place = PointOf(making.state.vehicle->pose());
  const auto count = static_cast<int>(making.parameters.Integer("boxes"));
  for (const Box& box :
       PlaceBoxes(making.building(), count, making.setup.seed, making.state.floor, place)) {
    making.state.PutBox(box);
  }
}

}  // namespace latchwork::office
