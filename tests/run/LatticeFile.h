#pragma once

#include <cmath>
#include <string>

#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/Types.h"

namespace nav2set {

/// A file of nav2_smac_planner's generator. Primitives of four headings: straight on, quarter
/// circles of 0.4 m, turns on the spot.
inline std::string latticeText() {
  std::string primitives;
  const auto add = [&](int start, int turn, double length, double arc) {
    std::string poses;
    for (int i = 0; i <= 10; ++i) {
      const double from = start * base::kPi / 2.0, angle = turn * base::kPi / 2.0 * i / 10.0;
      base::Vec2 place(length * i / 10.0, 0.0);
      if (arc > 0.0) {
        place = {0.4 * std::abs(std::sin(angle)), turn * 0.4 * (1.0 - std::cos(angle))};
      }
      place = base::Pose2{{0.0, 0.0}, from}.toWorld(place);
      poses += std::string(i > 0 ? ", [" : "[") + base::formatDouble(place.x()) + ", " +
               base::formatDouble(place.y()) + ", " + base::formatDouble(from + angle) + "]";
    }
    primitives += (primitives.empty() ? "" : ",\n") + std::string("{\"start_angle_index\": ") +
                  std::to_string(start) +
                  ", \"end_angle_index\": " + std::to_string((start + turn + 4) % 4) +
                  ", \"left_turn\": " + (turn >= 0 ? "true" : "false") +
                  ", \"trajectory_length\": " + base::formatDouble(length) +
                  ", \"arc_length\": " + base::formatDouble(arc) + ", \"poses\": [" + poses + "]}";
  };
  for (int start = 0; start < 4; ++start) {
    add(start, 0, 0.1, 0.0);
    for (const int turn : {1, -1}) {
      add(start, turn, 0.2 * base::kPi, 0.2 * base::kPi);
      add(start, turn, 0.0, 0.0);
    }
  }
  return "{\"lattice_metadata\": {\"motion_model\": \"diff\", \"turning_radius\": 0.4, "
         "\"grid_resolution\": 0.05, \"num_of_headings\": 4, \"heading_angles\": [0.0, 1.5708, "
         "3.14159, -1.5708]},\n\"primitives\": [\n" +
         primitives + "\n]}\n";
}

}  // namespace nav2set
