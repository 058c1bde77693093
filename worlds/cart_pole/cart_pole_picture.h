// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CART_POLE_CART_POLE_PICTURE_H_
#define LATCHWORK_CART_POLE_CART_POLE_PICTURE_H_

#include <filesystem>
#include <vector>

#include "latchwork/sdk/svg.h"
#include "worlds/cart_pole/pole_dynamics.h"

namespace latchwork::cart_pole {

/// Remembers the first two minutes of a run, 12 times a second, and draws them: cart and pole as
/// they move, and below them angle and place over time.
class CartPolePicture {
 public:
  void Begin(double track_end, double pole_length, double fallen);
  void Remember(double seconds, const Motion& motion);
  void RememberPush(double seconds) { pushes_.push_back(seconds); }
  std::vector<std::filesystem::path> Draw(const std::filesystem::path& folder) const;

 private:
  struct Frame {
    double seconds = 0;
    double place = 0;
    double angle = 0;
  };

  void DrawScene(sdk::Svg& svg) const;
  void DrawChart(sdk::Svg& svg) const;
  double ChartX(double seconds) const;

  double track_end_ = 1;
  double pole_length_ = 1;
  double fallen_ = 1;
  double next_at_ = 0;
  std::vector<double> pushes_;
  std::vector<Frame> frames_;
};

}  // namespace latchwork::cart_pole

#endif  // LATCHWORK_CART_POLE_CART_POLE_PICTURE_H_
