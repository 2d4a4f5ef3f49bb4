// A planner's library for tst_LibraryPlanner: what it does goes by the robot's name.
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

#include "sim2d/nav/external/hunavsim_planner.h"

struct hunavsim_planner {
  std::string robot;
  int calls = 0;
};

namespace {

std::string& lastSeen() {
  static std::string text;
  return text;
}

int& alive() {
  static int count = 0;
  return count;
}

std::string listOf(const hunavsim_point* points, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    char line[80];
    std::snprintf(line, sizeof line, " (%g %g)", points[i].x, points[i].y);
    text += line;
  }
  return text;
}

void note(const hunavsim_robot& robot, unsigned long long seed) {
  char line[400];
  std::snprintf(line, sizeof line, "%s %d %d r%g m%g v%g -%g a%g w%g b%g t%g seed %llu corners",
                robot.name, robot.id, robot.kinematics, robot.radius, robot.mass, robot.max_vel,
                robot.max_reverse, robot.max_acc, robot.max_omega, robot.max_alpha,
                robot.turning_radius, seed);
  lastSeen() = line + listOf(robot.corners, robot.corner_count);
}

void note(const hunavsim_observation& seen) {
  char line[400];
  std::snprintf(line, sizeof line, "t%g dt%g pose %g %g %g motion %g %g %g goal %g %g r%g",
                seen.time, seen.dt, seen.pose.x, seen.pose.y, seen.pose.heading, seen.motion.linear,
                seen.motion.angular, seen.motion.lateral, seen.goal.x, seen.goal.y,
                seen.goal_radius);
  lastSeen() = line;
  for (std::size_t i = 0; i < seen.body_count; ++i) {
    const hunavsim_body& body = seen.bodies[i];
    std::snprintf(line, sizeof line, " body %d %d %g %g %g %g %g %g", body.id, body.kind,
                  body.position.x, body.position.y, body.velocity.x, body.velocity.y, body.heading,
                  body.radius);
    lastSeen() += line;
  }
  if (seen.scan != nullptr) {
    const hunavsim_scan& scan = *seen.scan;
    std::snprintf(line, sizeof line, " scan %g %g %g t%g %g %g %g", scan.sensor.x, scan.sensor.y,
                  scan.sensor.heading, scan.time, scan.angle_min, scan.per_beam, scan.range);
    lastSeen() += line;
    for (std::size_t i = 0; i < scan.count; ++i) {
      std::snprintf(line, sizeof line, " %g", scan.distances[i]);
      lastSeen() += line;
    }
  }
  lastSeen() += " walls" + std::to_string(seen.walls_changed);
  for (std::size_t i = 0; i < seen.wall_count; ++i) {
    lastSeen() += listOf(seen.walls[i].points, seen.walls[i].count) + ";";
  }
}

}  // namespace

extern "C" {

HUNAVSIM_PLANNER_EXPORT const char* faulty_last_seen();
HUNAVSIM_PLANNER_EXPORT int faulty_alive();

const char* faulty_last_seen() {
  return lastSeen().c_str();
}

int faulty_alive() {
  return alive();
}

int32_t hunavsim_planner_abi(void) {
  const char* other = std::getenv("FAULTY_PLANNER_ABI");
  return other == nullptr ? HUNAVSIM_PLANNER_ABI : std::atoi(other);
}

hunavsim_planner* hunavsim_planner_create(const hunavsim_robot* robot, uint64_t seed) {
  note(*robot, seed);
  const std::string name = robot->name;
  if (name == "refused" || name == "refused_silently") {
    lastSeen() = name;
    return nullptr;
  }
  ++alive();
  return new hunavsim_planner{name};
}

int32_t hunavsim_planner_command(hunavsim_planner* planner, const hunavsim_observation* seen,
                                 hunavsim_twist* command) {
  note(*seen);
  ++planner->calls;
  command->linear = planner->calls;
  if (planner->robot == "nan") {
    command->angular = std::numeric_limits<double>::quiet_NaN();
  }
  return planner->robot == "fails" && planner->calls == 2 ? 42 : 0;
}

const char* hunavsim_planner_error(const hunavsim_planner* planner) {
  if (planner == nullptr) {
    return lastSeen() == "refused" ? "no\nlicence" : nullptr;
  }
  return "stuck";
}

void hunavsim_planner_destroy(hunavsim_planner* planner) {
  --alive();
  delete planner;
}

}  // extern "C"
