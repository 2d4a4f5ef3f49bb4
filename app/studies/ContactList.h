#pragma once

#include <vector>

#include "app/studies/AvoidableContact.h"

namespace app {

/// The contacts of robots with people in a recording, by time, without what an analysis adds.
/// Touches of a pair within kSameContact of the last one are the same contact.
std::vector<AvoidableContact> contactsIn(const sim2d::Recording& recording);

/// Mutual sight of a robot and a person, updated once per step.
class MutualSight {
 public:
  /// `run`: for the robot's detector. `robot`, `person`: ids.
  MutualSight(const Bundle& run, int robot, int person);

  /// True if the robot's sight of the person begins in this state.
  bool update(const sim2d::Frame& frame, const sim2d::Obstacles& obstacles);
  /// Start of the sight that lasts until the last state [s]; none: out of sight.
  std::optional<double> robotSight() const { return robot_.begin; }
  std::optional<double> personSight() const { return person_.begin; }

 private:
  struct Sight {
    std::optional<double> begin;
    double last = 0.0;  // last time in sight [s]
    bool update(bool isInSight, double time, double gap);
  };

  int robotId_, personId_;
  double range_, field_;  // of the robot's detector [m], [rad]
  bool isOccluded_;       // by walls
  Sight robot_, person_;
};

}  // namespace app
