// A planner's library for tst_SearchProgram: drives straight to the goal and waits for people ahead
// and on its right, but ignores those on its left.
#include <algorithm>
#include <cmath>

#include "sim2d/nav/external/hunavsim_planner.h"

struct hunavsim_planner {
  hunavsim_robot robot;
};

namespace {

constexpr double kStopGap = 1.5;  // [m]
constexpr double kPi = 3.14159265358979323846;

bool mustWait(const hunavsim_robot& robot, const hunavsim_observation& seen) {
  for (std::size_t i = 0; i < seen.body_count; ++i) {
    const hunavsim_body& body = seen.bodies[i];
    const double x = body.position.x - seen.pose.x, y = body.position.y - seen.pose.y;
    const double angle = std::remainder(std::atan2(y, x) - seen.pose.heading, 2.0 * kPi);
    const double gap = std::hypot(x, y) - body.radius - robot.radius;
    if (angle < 0.0 && angle > -1.6 && gap < kStopGap) {
      return true;
    }
  }
  return false;
}

}  // namespace

extern "C" {

int32_t hunavsim_planner_abi(void) {
  return HUNAVSIM_PLANNER_ABI;
}

hunavsim_planner* hunavsim_planner_create(const hunavsim_robot* robot, uint64_t /*seed*/) {
  auto* const planner = new hunavsim_planner{*robot};
  planner->robot.name = nullptr;  // valid during this call only, as are the corners
  planner->robot.corners = nullptr;
  return planner;
}

int32_t hunavsim_planner_command(hunavsim_planner* planner, const hunavsim_observation* seen,
                                 hunavsim_twist* command) {
  const double x = seen->goal.x - seen->pose.x, y = seen->goal.y - seen->pose.y;
  const double turn = std::remainder(std::atan2(y, x) - seen->pose.heading, 2.0 * kPi);
  command->linear = mustWait(planner->robot, *seen) ? 0.0 : planner->robot.max_vel;
  command->angular = 2.0 * turn;
  return 0;
}

const char* hunavsim_planner_error(const hunavsim_planner* /*planner*/) {
  return nullptr;
}

void hunavsim_planner_destroy(hunavsim_planner* planner) {
  delete planner;
}

}  // extern "C"
