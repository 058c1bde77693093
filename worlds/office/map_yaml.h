// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_OFFICE_MAP_YAML_H_
#define LATCHWORK_OFFICE_MAP_YAML_H_

#include <filesystem>
#include <string>

#include "worlds/office/geometry.h"

namespace latchwork::office {

/// What a ROS map_server file says.
struct MapYaml {
  std::filesystem::path image;  ///< Resolved against the folder of the file.
  double resolution = 0.0;      ///< m per pixel
  Point origin;                 ///< Of the lower left pixel, m.
  bool negate = false;
  double occupied_threshold = 0.65;
  double free_threshold = 0.196;
  std::string mode = "trinary";  ///< trinary, scale or raw
};

struct LoadedYaml {
  MapYaml yaml;
  std::string error;  ///< Begins with file:line:column.
};

/// Reads the flat keys of a map_server file: image, resolution, origin (its yaw must be 0), negate,
/// occupied_thresh, free_thresh, mode. Unknown keys are ignored, as map_server does.
LoadedYaml LoadMapYaml(const std::filesystem::path& file);

}  // namespace latchwork::office

#endif  // LATCHWORK_OFFICE_MAP_YAML_H_
