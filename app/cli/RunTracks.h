#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

#include <QString>

#include "sim2d/trace/Trace.h"

namespace app {

/// The way of somebody through a run, and how they are drawn.
struct Track {
  int id = 0;                           // of robots: below 0
  std::vector<sim2d::Vec2> points;      // [m]
  std::vector<double> times;            // [s], of each point
  std::vector<double> headings;         // [rad], idem
  std::vector<sim2d::Vec2> velocities;  // [m/s], idem
  QString name;
  double radius = 0.35;  // [m]

  /// How many points lie no later.
  std::size_t until(double time) const {
    const auto end = std::upper_bound(times.begin(), times.end(), time);
    return static_cast<std::size_t>(end - times.begin());
  }
};

/// Of everybody, by id.
std::map<int, Track> tracksOf(const sim2d::Trace& trace);

}  // namespace app
