#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim2d/world/Physics.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// A body of the physics: a person (index) or a robot (index).
struct BodyOwner {
  bool isRobot = false;
  int index = 0;
};

/// Tells when two bodies, or a body and an obstacle, begin to touch: one event per pair until they
/// have parted.
class Contacts {
 public:
  /// `partNames`: of the parts of the surroundings; empty for the map.
  explicit Contacts(std::vector<std::string> partNames) : partNames_(std::move(partNames)) {}

  /// After a step. `wanted`: velocities of the bodies before contacts slowed them [m/s].
  void update(Physics& physics, const std::vector<BodyOwner>& owners,
              const std::function<Vec2(int)>& wanted, const WorldModel& model, WorldState& state);

 private:
  std::vector<std::string> partNames_;
  std::vector<Touch> touches_, before_;
};

}  // namespace sim2d
