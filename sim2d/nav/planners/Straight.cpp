#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/nav/Planner.h"

namespace sim2d {
namespace {

constexpr double kStraightTurnInPlaceAngle = 0.5;  // [rad]; above this the robot turns first
constexpr double kHeadingGain = 2.0;               // [1/s]

/// Drives straight to the goal and avoids nothing. A scenario that this planner solves tests
/// nothing; scenarios are certified against it.
class Straight : public Planner {
 public:
  explicit Straight(const RobotBody& body) : limits_(body.limits), kinematics_(body.kinematics) {}

  bool readsScan() const override { return false; }
  base::Result<BodyTwist> command(const Observation& observation) override {
    const Vec2 local = observation.pose.toLocal(observation.goal);
    const double distance = local.norm();
    if (distance < 1e-6) {
      return BodyTwist{};
    }
    const double bearing = base::headingOf(local);
    const double omega = std::clamp(kHeadingGain * bearing, -limits_.maxOmega, limits_.maxOmega);
    const bool mustTurn =
        std::fabs(bearing) > kStraightTurnInPlaceAngle && kinematics_ != Kinematics::Ackermann;
    const double brake = std::sqrt(1.6 * limits_.maxAcc * distance);
    return BodyTwist{mustTurn ? 0.0 : std::min(limits_.maxVel, brake), omega};
  }

 private:
  DriveLimits limits_;
  Kinematics kinematics_;
};

base::Result<std::shared_ptr<Planner>> makeStraight(const PlannerSetup& setup) {
  return std::shared_ptr<Planner>(std::make_shared<Straight>(setup.body));
}

}  // namespace

void addStraight(PlannerRegistry& to);
void addStraight(PlannerRegistry& to) {
  to.add("straight", {}, makeStraight,
         "Drives straight to the goal and avoids nothing: a baseline that no test should accept.");
}

}  // namespace sim2d
