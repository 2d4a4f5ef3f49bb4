#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "sim2d/trace/Trace.h"

/// Export of recorded runs to third-party formats. Errors mean that nothing can be written; other
/// diagnostics inform the user.
namespace sim2d {

/// JSON lines for TrajNet++: scenes, then tracks. `rate`: samples per second; 0: 2.5 as in its data
/// sets. Positions are interpolated linearly. A scene has 21 samples in which its pedestrian is
/// present throughout; robots are pedestrians with ids after those of the people.
base::Result<std::string> trajnetText(const Trace& trace, double rate = 0.0);

/// SocNav3 (SocNavData): the first robot with its goal, people, walls and the map's grid. `rate`:
/// samples per second; 0: all states. The robot's speeds are longitudinal, lateral and angular.
/// Other robots are people with ids after those of the people.
base::Result<std::string> socnav3Text(const Trace& trace, double rate = 0.0);

/// Resampling of a recorded run. Private to the folder.

struct BodySample {
  base::Pose2 pose;
  Vec2 velocity = Vec2::Zero();  // [m/s]
  double omega = 0.0;            // [rad/s]
  int goal = kNoGoal;
};

struct RecordSample {
  double time = 0.0;                 // [s] since the first state
  std::map<int, BodySample> people;  // by id
  std::map<int, BodySample> robots;  // by id, -1, -2 …
};

/// Samples from the first state to the last at intervals of 1 / `rate` [s]; rate 0: the states
/// themselves. Bodies present in both neighbouring states are interpolated linearly.
class RecordSamples {
 public:
  RecordSamples(const Trace& trace, double rate);

  std::size_t size() const { return size_; }
  RecordSample at(std::size_t index) const;

 private:
  const Trace& trace_;
  double rate_;
  std::size_t size_ = 0;
};

}  // namespace sim2d
