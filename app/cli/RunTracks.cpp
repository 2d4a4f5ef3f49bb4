#include "app/cli/RunTracks.h"

namespace app {

std::map<int, Track> tracksOf(const sim2d::Trace& trace) {
  std::map<int, Track> tracks;
  const auto add = [&tracks](const auto& columns, double time) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      Track& track = tracks[columns.id[k]];
      track.id = columns.id[k];
      track.points.emplace_back(columns.x[k], columns.y[k]);
      track.headings.push_back(columns.heading[k]);
      track.velocities.emplace_back(columns.vx[k], columns.vy[k]);
      track.times.push_back(time);
    }
  };
  for (const sim2d::Frame& frame : trace.frames) {
    add(frame.humans, frame.time);
    add(frame.robots, frame.time);
  }
  const auto describe = [&tracks](const auto& bodies) {
    for (const auto& body : bodies) {
      if (const auto found = tracks.find(body.id); found != tracks.end()) {
        found->second.name = QString::fromStdString(body.name);
        found->second.radius = body.radius;
      }
    }
  };
  describe(trace.header.humans);
  describe(trace.header.robots);
  return tracks;
}

}  // namespace app
