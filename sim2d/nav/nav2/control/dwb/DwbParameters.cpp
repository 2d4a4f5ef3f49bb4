#include "sim2d/nav/nav2/control/dwb/DwbParameters.h"

#include <vector>

namespace sim2d::nav2 {

const std::vector<Nav2Key<DwbParameters>>& dwbKeys() {
  using P = DwbParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"min_vel_x", &P::minVelX, "m/s", "least velocity ahead, negative: backwards"},
      {"max_vel_x", &P::maxVelX, "m/s", "greatest velocity ahead"},
      {"min_vel_y", &P::minVelY, "m/s", "least velocity to the left"},
      {"max_vel_y", &P::maxVelY, "m/s", "greatest velocity to the left"},
      {"max_vel_theta", &P::maxVelTheta, "rad/s", "greatest angular velocity, either way"},
      {"min_speed_xy", &P::minSpeedXy, "m/s", "slower it must at least turn; negative: no matter"},
      {"max_speed_xy", &P::maxSpeedXy, "m/s", "greatest speed; negative: no matter"},
      {"min_speed_theta", &P::minSpeedTheta, "rad/s",
       "slower it must at least drive; negative: no matter"},
      {"acc_lim_x", &P::accLimX, "m/s^2", "acceleration ahead"},
      {"acc_lim_y", &P::accLimY, "m/s^2", "acceleration to the left"},
      {"acc_lim_theta", &P::accLimTheta, "rad/s^2", "angular acceleration"},
      {"decel_lim_x", &P::decelLimX, "m/s^2", "braking, negative"},
      {"decel_lim_y", &P::decelLimY, "m/s^2", "braking sideways, negative"},
      {"decel_lim_theta", &P::decelLimTheta, "rad/s^2", "angular braking, negative"},
      {"trajectory_generator_name", &P::generator, "",
       "dwb_plugins::StandardTrajectoryGenerator or dwb_plugins::LimitedAccelGenerator"},
      {"sim_time", &P::simTime, "s", "how long a trajectory is looked ahead"},
      {"sim_period", &P::simPeriod, "s",
       "velocities that can be reached within this time (LimitedAccelGenerator); 0: a cycle"},
      {"vx_samples", &P::vxSamples, "", "velocities ahead that are tried"},
      {"vy_samples", &P::vySamples, "", "velocities to the left that are tried"},
      {"vtheta_samples", &P::vthetaSamples, "", "angular velocities that are tried"},
      {"discretize_by_time", &P::discretizesByTime, "",
       "poses of a trajectory by time, not by way"},
      {"time_granularity", &P::timeGranularity, "s", "time between poses"},
      {"linear_granularity", &P::linearGranularity, "m", "way between poses"},
      {"angular_granularity", &P::angularGranularity, "rad", "turn between poses"},
      {"include_last_point", &P::includesLastPoint, "", "the last pose counts twice"},
      {"limit_vel_cmd_in_traj", &P::limitsCommand, "",
       "the command is what can be reached in the first step"},
      {"critics", &P::critics, "", "what prices trajectories, in this order"},
      {"default_critic_namespaces", &P::criticNamespaces, "",
       "where critics without namespace are looked for; none: dwb_critics"},
      {"short_circuit_trajectory_evaluation", &P::shortCircuits, "",
       "who is dearer than the best is priced no further"},
      {"trans_stopped_velocity", &P::transStoppedVelocity, "m/s",
       "slower counts as standing (RotateToGoal)"},
      {"xy_goal_tolerance", &P::xyGoalTolerance, "m",
       "so near the goal it brakes and turns (RotateToGoal)"},
      {"prune_plan", &P::prunesPlan, "", "passed poses are erased", kUntilKilted},
      {"prune_distance", &P::pruneDistance, "m", "the path begins this near to the robot",
       kUntilKilted},
      {"forward_prune_distance", &P::forwardPruneDistance, "m", "and ends this far ahead of it",
       kUntilKilted},
      {"shorten_transformed_plan", &P::shortensPlan, "", "it counts no farther than that",
       kUntilKilted},
  };
  return kKeys;
}

const std::vector<IdleKey>& dwbIdleKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"debug_trajectory_details", "no log here: trajectories are shown"},
      {"transform_tolerance", "no TF here", kUntilKilted},
      {"publish_evaluation", "no topics here"},
      {"publish_global_plan", "no topics here", kUntilKilted},
      {"publish_transformed_plan", "no topics here", kUntilKilted},
      {"publish_local_plan", "no topics here"},
      {"publish_trajectories", "no topics here"},
      {"publish_cost_grid_pc", "no topics here"},
      {"marker_lifetime", "no topics here"},
      {"odom_topic", "no topics here", kUntilKilted},
      {"controller_frequency", "that of the server counts", kSinceLyrical},
  };
  return kKeys;
}

}  // namespace sim2d::nav2
