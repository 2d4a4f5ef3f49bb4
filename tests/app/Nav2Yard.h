#pragma once

#include "tests/app/RunFiles.h"

namespace outside {

/// A walled yard of 5 by 4 m with a wall in it, a person, and a robot of Nav2 that sets out at
/// once: yard.yaml, which names params_jazzy.yaml and tree.xml; other parameters lie beside them.
inline void writeNav2Yard(const QString& folder) {
  constexpr int kWidth = 110, kHeight = 90;
  QByteArray pixels = "P5\n110 90\n255\n";
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const bool isBorder = row < 2 || row >= kHeight - 2 || column < 2 || column >= kWidth - 2;
      const bool isWall = column >= 50 && column < 53 && row >= 30 && row < 60;
      pixels += isBorder || isWall ? '\0' : '\xfe';
    }
  }
  writeText(folder + text("/yard.pgm"), pixels);
  writeText(folder + text("/yard_map.yaml"),
            "image: yard.pgm\nresolution: 0.05\norigin: [-0.5, -0.5, 0.0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.25\n");
  writeText(folder + text("/yard.yaml"),
            "hunav_loader:\n  ros__parameters:\n    yaml_base_name: yard\n    agents: [anna]\n"
            "    anna:\n      id: 1\n      skin: 0\n      group_id: -1\n      max_vel: 1.2\n"
            "      radius: 0.3\n      init_pose: {x: 3.0, y: 1.0, z: 1.0, h: 3.0}\n"
            "      behavior: {type: Regular, configuration: 2}\n"
            "      goal_radius: 0.3\n      cyclic_goals: true\n      goals: [1, 2]\n"
            "    global_goals:\n      1: {x: 0.5, y: 1.0, h: 0.0}\n"
            "      2: {x: 4.0, y: 0.3, h: 0.0}\n"
            "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n"
            "    map_file: yard_map.yaml\n    robots: [robot1]\n    robot1:\n"
            "      start: {x: 0.5, y: 2.0, h: 0.0}\n      goal: {x: 3.5, y: 2.0}\n"
            "      planner: nav2\n      nav2_params: params_jazzy.yaml\n"
            "      nav2_tree: tree.xml\n");
  for (const char* file : {"params_humble.yaml", "params_jazzy.yaml", "params_main.yaml"}) {
    writeText(folder + QLatin1Char('/') + text(file),
              bytesOf(text(TEST_DATA_DIR "/nav2/") + text(file)));
  }
  writeText(folder + text("/tree.xml"),
            bytesOf(text(SOURCE_DIR "/resources/nav2_trees/humble/"
                                    "navigate_to_pose_w_replanning_and_recovery"
                                    ".xml")));
}

}  // namespace outside
