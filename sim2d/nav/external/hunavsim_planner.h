/* A robot's planner in a shared library. C99 and C++.
 *
 * The library defines the functions below; HuNavSim Desktop loads it, makes one planner for each
 * robot that names it, and asks it once per step while the robot has a goal. World frame, SI,
 * radians: x right, y up, headings counter-clockwise from +x in (-pi, pi].
 *
 * Two planners of one library may be asked from two threads at the same time, one planner never.
 * Pointers that are handed over are valid during the call only. The same observations in the same
 * order must give the same commands: otherwise a run cannot be repeated. The library runs inside of
 * the simulator: no exception may leave it, and when it crashes, all does.
 */
#ifndef HUNAVSIM_PLANNER_H
#define HUNAVSIM_PLANNER_H

#include <stddef.h>
#include <stdint.h>

/* NOLINTBEGIN(readability-identifier-naming): names of C */

/* Raised when libraries made before cannot be used any more. */
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

/* Motion in the robot's own frame, or the wish for one. */
typedef struct hunavsim_twist {
  double linear;  /* [m/s], ahead */
  double angular; /* [rad/s], counter-clockwise */
  double lateral; /* [m/s], to the left; omnidirectional robots only */
} hunavsim_twist;

typedef struct hunavsim_robot {
  const char* name;              /* UTF-8 */
  int32_t id;                    /* tells robots of one run apart; with the seed: whose draws */
  int32_t kinematics;            /* HUNAVSIM_DIFFERENTIAL ... */
  double radius;                 /* [m], of the smallest circle about the robot that holds it */
  const hunavsim_point* corners; /* [m], robot frame, counter-clockwise; NULL: a disc */
  size_t corner_count;
  double mass;           /* [kg] */
  double max_vel;        /* [m/s], ahead */
  double max_reverse;    /* [m/s], backwards, >= 0 */
  double max_acc;        /* [m/s^2], speeding up and slowing down */
  double max_omega;      /* [rad/s] */
  double max_alpha;      /* [rad/s^2] */
  double turning_radius; /* [m], Ackermann: the least */
} hunavsim_robot;

/* Somebody the robot knows of. */
typedef struct hunavsim_body {
  int32_t id;              /* of the track; a detector may swap them */
  int32_t kind;            /* HUNAVSIM_PERSON or HUNAVSIM_ROBOT */
  hunavsim_point position; /* [m] */
  hunavsim_point velocity; /* [m/s] */
  double heading;          /* [rad] */
  double radius;           /* [m] */
} hunavsim_body;

/* One turn of a lidar: distances counter-clockwise from angle_min, in the sensor's frame. */
typedef struct hunavsim_scan {
  hunavsim_pose sensor;    /* where the robot takes its sensor to be */
  double time;             /* [s] */
  double angle_min;        /* [rad], of the first beam */
  double per_beam;         /* [rad], between neighbours */
  double range;            /* [m]; beams without a hit have it */
  const double* distances; /* [m] */
  size_t count;
} hunavsim_scan;

/* A closed border of something solid, which lies on the left of each edge; the last point joins the
 * first. */
typedef struct hunavsim_outline {
  const hunavsim_point* points; /* [m] */
  size_t count;
} hunavsim_outline;

/* The world as the step began, as far as the robot's sensors tell. */
typedef struct hunavsim_observation {
  double time, dt;             /* [s] */
  hunavsim_pose pose;          /* in the map, as the robot estimates it */
  hunavsim_twist motion;       /* own, by odometry */
  hunavsim_point goal;         /* [m] */
  double goal_radius;          /* [m]; arrived: the robot's centre is inside */
  const hunavsim_body* bodies; /* people, then other robots, by id */
  size_t body_count;
  const hunavsim_scan* scan;     /* the last one; NULL: no lidar, or not turned yet */
  const hunavsim_outline* walls; /* of the known map, those that stand now */
  size_t wall_count;
  int32_t walls_changed; /* not 0: others than in the call before (doors), or this is the first */
} hunavsim_observation;

/* The library's own; the simulator only hands it back. */
typedef struct hunavsim_planner hunavsim_planner;

/* Returns HUNAVSIM_PLANNER_ABI. */
HUNAVSIM_PLANNER_EXPORT int32_t hunavsim_planner_abi(void);

/* A planner for this robot, or NULL; then hunavsim_planner_error(NULL) may tell why. */
HUNAVSIM_PLANNER_EXPORT hunavsim_planner* hunavsim_planner_create(const hunavsim_robot* robot,
                                                                  uint64_t seed);

/* Sets the command, which is all zeros before. Returns 0, or an error code of the library's own:
 * that ends the run. The simulator limits the command to what the drive can do. */
HUNAVSIM_PLANNER_EXPORT int32_t hunavsim_planner_command(hunavsim_planner* planner,
                                                         const hunavsim_observation* observation,
                                                         hunavsim_twist* command);

/* What went wrong in the last call, UTF-8, for people; may be NULL. Valid until the next call. */
HUNAVSIM_PLANNER_EXPORT const char* hunavsim_planner_error(const hunavsim_planner* planner);

/* The end of a planner that was made. */
HUNAVSIM_PLANNER_EXPORT void hunavsim_planner_destroy(hunavsim_planner* planner);

/* May be left out. What the planner follows now, for display: writes up to `most` points [m] and
 * returns how many there are. */
HUNAVSIM_PLANNER_EXPORT size_t hunavsim_planner_path(const hunavsim_planner* planner,
                                                     hunavsim_point* points, size_t most);

#ifdef __cplusplus
}
#endif

/* NOLINTEND(readability-identifier-naming) */

#endif
