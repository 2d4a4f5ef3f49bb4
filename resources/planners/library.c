/* Drives straight to the goal and gives way to people ahead. See hunavsim_planner.h. */
#include <math.h>
#include <stdlib.h>

#include "hunavsim_planner.h"

struct hunavsim_planner {
  hunavsim_robot robot;
  hunavsim_point path[2];
};

int32_t hunavsim_planner_abi(void) {
  return HUNAVSIM_PLANNER_ABI;
}

hunavsim_planner* hunavsim_planner_create(const hunavsim_robot* robot, uint64_t seed) {
  hunavsim_planner* planner = (hunavsim_planner*)calloc(1, sizeof(hunavsim_planner));
  (void)seed; /* nothing is drawn */
  if (planner != NULL) {
    planner->robot = *robot;
    planner->robot.name = NULL; /* valid during this call only, as are the corners */
    planner->robot.corners = NULL;
  }
  return planner;
}

static double angle_between(double to, double from) {
  return remainder(to - from, 2.0 * acos(-1.0));
}

static double free_speed(const hunavsim_robot* robot, const hunavsim_observation* seen) {
  double speed = robot->max_vel;
  size_t i;
  for (i = 0; i < seen->body_count; ++i) {
    const hunavsim_body* body = &seen->bodies[i];
    const double x = body->position.x - seen->pose.x, y = body->position.y - seen->pose.y;
    const double gap = hypot(x, y) - body->radius - robot->radius;
    if (fabs(angle_between(atan2(y, x), seen->pose.heading)) < 1.05 && gap < 1.5) {
      speed = fmin(speed, robot->max_vel * fmax(0.0, gap - 0.5));
    }
  }
  return speed;
}

int32_t hunavsim_planner_command(hunavsim_planner* planner, const hunavsim_observation* seen,
                                 hunavsim_twist* command) {
  const hunavsim_robot* robot = &planner->robot;
  const double x = seen->goal.x - seen->pose.x, y = seen->goal.y - seen->pose.y;
  const double turn = angle_between(atan2(y, x), seen->pose.heading);
  const double speed = fmin(free_speed(robot, seen), sqrt(robot->max_acc * hypot(x, y)));
  command->linear = fabs(turn) < 0.5 ? speed : 0.0;
  command->angular = fmax(-robot->max_omega, fmin(robot->max_omega, 2.0 * turn));
  planner->path[0].x = seen->pose.x;
  planner->path[0].y = seen->pose.y;
  planner->path[1] = seen->goal;
  return 0;
}

const char* hunavsim_planner_error(const hunavsim_planner* planner) {
  return planner == NULL ? "out of memory" : NULL;
}

void hunavsim_planner_destroy(hunavsim_planner* planner) {
  free(planner);
}

size_t hunavsim_planner_path(const hunavsim_planner* planner, hunavsim_point* points, size_t most) {
  size_t i;
  for (i = 0; i < most && i < 2; ++i) {
    points[i] = planner->path[i];
  }
  return 2;
}
