/* A robot's planner in a shared library. C99 and C++.
 *
 * The library defines the functions below; HuNavSim Desktop loads it, creates one planner for each
 * robot that names it, and calls it once per step while the robot has a goal. World frame, SI,
 * radians: x right, y up, headings counter-clockwise from +x in (-pi, pi].
 *
 * Two planners of one library may be called from two threads at the same time; calls of one planner
 * never overlap. Pointer arguments are valid during the call only. The same observations in the
 * same order must give the same commands: otherwise a run cannot be repeated. The library runs
 * inside the simulator: no exception may leave it, and a crash of the library ends the simulator.
 */
#ifndef HUNAVSIM_PLANNER_H
#define HUNAVSIM_PLANNER_H

#include <stddef.h>
#include <stdint.h>

/* NOLINTBEGIN(readability-identifier-naming): C names */

/* Incremented by incompatible changes. */
#define HUNAVSIM_PLANNER_ABI 1

#if defined(_WIN32)
#define HUNAVSIM_PLANNER_EXPORT __declspec(dllexport)
#else
#define HUNAVSIM_PLANNER_EXPORT __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

enum { HUNAVSIM_DIFFERENTIAL = 0, HUNAVSIM_OMNIDIRECTIONAL = 1, HUNAVSIM_ACKERMANN = 2 };
enum { HUNAVSIM_PERSON = 0, HUNAVSIM_ROBOT = 1 };

typedef struct hunavsim_point {
  double x, y; /* [m] or [m/s] */
} hunavsim_point;

typedef struct hunavsim_pose {
  double x, y;    /* [m] */
  double heading; /* [rad] */
} hunavsim_pose;

/* Velocity in the robot's own frame, or a commanded one. */
typedef struct hunavsim_twist {
  double linear;  /* [m/s], forward */
  double angular; /* [rad/s], counter-clockwise */
  double lateral; /* [m/s], to the left; omnidirectional robots only */
} hunavsim_twist;

typedef struct hunavsim_robot {
  const char* name;              /* UTF-8 */
  int32_t id;                    /* unique per run; random draws depend on it and the seed */
  int32_t kinematics;            /* HUNAVSIM_DIFFERENTIAL ... */
  double radius;                 /* [m], smallest circle about the origin that encloses the robot */
  const hunavsim_point* corners; /* [m], robot frame, counter-clockwise; NULL: a disc */
  size_t corner_count;
  double mass;           /* [kg] */
  double max_vel;        /* [m/s], forward */
  double max_reverse;    /* [m/s], backward, >= 0 */
  double max_acc;        /* [m/s^2], acceleration and deceleration */
  double max_omega;      /* [rad/s] */
  double max_alpha;      /* [rad/s^2] */
  double turning_radius; /* [m], Ackermann: the minimum */
} hunavsim_robot;

/* A body that the robot perceives. */
typedef struct hunavsim_body {
  int32_t id;              /* track id; a detector may swap ids */
  int32_t kind;            /* HUNAVSIM_PERSON or HUNAVSIM_ROBOT */
  hunavsim_point position; /* [m] */
  hunavsim_point velocity; /* [m/s] */
  double heading;          /* [rad] */
  double radius;           /* [m] */
} hunavsim_body;

/* One lidar scan: distances counter-clockwise from angle_min, in the sensor frame. */
typedef struct hunavsim_scan {
  hunavsim_pose sensor;    /* pose as estimated by the robot */
  double time;             /* [s] */
  double angle_min;        /* [rad], of the first beam */
  double per_beam;         /* [rad], between neighbours */
  double range;            /* [m]; the distance of beams without a hit */
  const double* distances; /* [m] */
  size_t count;
} hunavsim_scan;

/* A closed boundary of a solid, which lies on the left of each edge; the last point joins the
 * first. */
typedef struct hunavsim_outline {
  const hunavsim_point* points; /* [m] */
  size_t count;
} hunavsim_outline;

/* Perception of the robot at the start of the step. */
typedef struct hunavsim_observation {
  double time, dt;             /* [s] */
  hunavsim_pose pose;          /* in the map, as estimated by the robot */
  hunavsim_twist motion;       /* own velocity, from odometry */
  hunavsim_point goal;         /* [m] */
  double goal_radius;          /* [m]; reached when the robot's centre is inside */
  const hunavsim_body* bodies; /* people, then other robots, sorted by id */
  size_t body_count;
  const hunavsim_scan* scan;     /* the last one; NULL: no lidar, or no scan yet */
  const hunavsim_outline* walls; /* current walls of the known map */
  size_t wall_count;
  int32_t walls_changed; /* nonzero: changed since the previous call (doors), or first call */
} hunavsim_observation;

/* Defined by the library; opaque to the simulator. */
typedef struct hunavsim_planner hunavsim_planner;

/* Returns HUNAVSIM_PLANNER_ABI. */
HUNAVSIM_PLANNER_EXPORT int32_t hunavsim_planner_abi(void);

/* Creates a planner for this robot; NULL on failure, described by hunavsim_planner_error(NULL). */
HUNAVSIM_PLANNER_EXPORT hunavsim_planner* hunavsim_planner_create(const hunavsim_robot* robot,
                                                                  uint64_t seed);

/* Sets the command, initially zero. Returns 0, or a library-specific error code, which ends the
 * run. The simulator limits the command to what the drive can do. */
HUNAVSIM_PLANNER_EXPORT int32_t hunavsim_planner_command(hunavsim_planner* planner,
                                                         const hunavsim_observation* observation,
                                                         hunavsim_twist* command);

/* Message of the last failure, UTF-8; may be NULL. Valid until the next call. */
HUNAVSIM_PLANNER_EXPORT const char* hunavsim_planner_error(const hunavsim_planner* planner);

/* Destroys a planner. */
HUNAVSIM_PLANNER_EXPORT void hunavsim_planner_destroy(hunavsim_planner* planner);

/* Optional. The path that the planner follows, for display: writes up to `most` points [m] and
 * returns their total number. */
HUNAVSIM_PLANNER_EXPORT size_t hunavsim_planner_path(const hunavsim_planner* planner,
                                                     hunavsim_point* points, size_t most);

#ifdef __cplusplus
}
#endif

/* NOLINTEND(readability-identifier-naming) */

#endif
