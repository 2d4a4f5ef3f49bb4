#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/control/dwb/DwbParameters.h"

/// Trajectories that result from commands (dwb_plugins: standard_traj_generator.cpp,
/// limited_accel_generator.cpp).
namespace sim2d::nav2 {

struct DwbTrajectory {
  BodyTwist velocity;                // the command of the trajectory
  std::vector<Pose2> poses;          // robot first; last one twice with include_last_point
  double step = 0.0;                 // time between poses [s]
  int endCell = -1;                  // index in the costmap of the last pose, -1 off it
  Vec2 endDirection = Vec2::Zero();  // of the last pose's heading
  // Of locate():
  std::vector<int> cells;  // index in the costmap of each pose, -1 off it
  std::size_t onMap = 0;   // number of poses before the first one off the map

  /// Linearly interpolated pose after `time` [s].
  Pose2 at(double time) const;
};

/// Number of steps from the robot's pose to the end of a trajectory.
int stepCount(const DwbParameters& parameters, const BodyTwist& command);

/// Generates the trajectories of one cycle; reuses its buffers.
class TrajectoryGenerator {
 public:
  enum class Kind { Standard, LimitedAccel };
  TrajectoryGenerator(Kind kind, double frequency);

  /// Starts a cycle. The costmap must outlive it.
  void start(const DwbParameters& parameters, const Pose2& robot, const BodyTwist& speed,
             const Costmap& costmap);
  const std::vector<BodyTwist>& commands() const { return commands_; }
  /// All but the cells of the poses before the last.
  void generate(const BodyTwist& command, DwbTrajectory& trajectory);
  /// Adds the cells of all poses.
  void locate(DwbTrajectory& trajectory) const;

 private:
  struct Step {
    double heading;  // [rad], after the step
    Vec2 direction;  // of the heading before the step
  };
  /// Headings depend only on the angular command and the number of steps, and are cached.
  struct HeadingProfile {
    double angular = 0.0;  // [rad/s]
    std::vector<Step> steps;
    Vec2 endDirection = Vec2::Zero();  // of the last heading
  };
  const HeadingProfile& headingProfile(double angular, int count);
  BodyTwist next(const BodyTwist& velocity, const BodyTwist& command, double dt) const;

  Kind kind_;
  double period_;  // controller period [s]
  const DwbParameters* parameters_ = nullptr;
  const Costmap* costmap_ = nullptr;
  Pose2 robot_;
  BodyTwist speed_;
  std::vector<BodyTwist> commands_;
  std::vector<double> headings_;  // [rad], before the steps of a profile
  std::vector<base::SinCos> directions_;
  std::vector<HeadingProfile> headingProfiles_;  // those of this cycle come first
  std::size_t headingProfileCount_ = 0;
  std::size_t lastHeadingProfile_ = 0;
};

/// Velocities that DWB samples (dwb_plugins: velocity_iterator.hpp, one_d_velocity_iterator.hpp).

/// The velocity nearest to a target that is reachable from v within `dt` [s]; acceleration > 0,
/// deceleration < 0.
double projectVelocity(double v, double acceleration, double deceleration, double dt,
                       double target);

/// Limits of one axis.
struct VelocityAxis {
  double least = 0.0, most = 0.0;  // [m/s] or [rad/s]
  double acceleration = 0.0;       // > 0
  double deceleration = 0.0;       // < 0
};
/// Samples in ascending order: about `count` velocities reachable within `time` [s] from v, plus 0
/// if the samples skip it.
std::vector<double> axisSamples(const VelocityAxis& axis, double v, double time, int count);

/// Limits from the parameters; theta's minimum is the negative of its maximum.
VelocityAxis axisX(const DwbParameters& parameters);
VelocityAxis axisY(const DwbParameters& parameters);
VelocityAxis axisTheta(const DwbParameters& parameters);

/// All valid combinations in Nav2's order: theta varies fastest, x slowest. Excludes standing
/// still. `time` [s] within which they must be reachable.
void velocitySamples(const DwbParameters& parameters, const BodyTwist& now, double time,
                     std::vector<BodyTwist>& samples);

}  // namespace sim2d::nav2
