// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_BUMPER_CARS_BUMPER_PICTURE_H_
#define LATCHWORK_BUMPER_CARS_BUMPER_PICTURE_H_

#include <filesystem>
#include <string>
#include <vector>

#include "latchwork/sdk/svg.h"
#include "worlds/bumper_cars/arena.h"

namespace latchwork::bumper_cars {

/// What a run looked like.
struct Film {
  struct Remark {
    double seconds = 0;
    Vector place;
    std::string text;
  };
  struct Flash {
    double seconds = 0;
    Vector place;
    double closing = 0;  // m/s
  };
  std::vector<std::vector<sdk::SvgKeyframe>> cars;
  std::vector<Remark> remarks;
  std::vector<Flash> flashes;
  double seconds = 0;

  void Add(double seconds_now, const Arena& arena);
};

/// An animation, "bumper_cars.svg". False when the file cannot be written.
bool DrawFilm(const Film& film, const Arena& arena, const std::filesystem::path& file);

}  // namespace latchwork::bumper_cars

#endif  // LATCHWORK_BUMPER_CARS_BUMPER_PICTURE_H_
