#pragma once

#include <vector>

#include "sim2d/nav/SocialForce.h"

/// The density-dependent social force model as pure functions: the forces of SocialForce.h for
/// isolated pairs, groups and walls, plus crowd effects. The headway limits the speed (after
/// Tordeux, Chraibi & Seyfried 2016); in counter-flow a lateral force forms lanes; a contact guard
/// keeps bodies apart. Forces are accelerations [m/s²], world frame. Thread-safe.
namespace sim2d {

struct DensityParameters {
  ForceParameters social;
  double timeGap = 0.9;         // T [s] to a person straight ahead
  double capWidth = 0.31;       // t, tangent of the angle that counts as ahead
  double coMovingWeight = 0.1;  // w0, weight of the force between people of equal velocity
  double fullWeightAt = 1.0;    // v_c [m/s], relative speed at which the force reaches full weight
  double intentShare = 0.3;     // beta, fraction of the desired velocity in what people react to
  double laneFactor = 7.0;      // k_l [m/s²]
  double fileShare = 0.7;       // kappa, weight of people walking the same way in the lane force
  double crowdScale = 0.5;      // K
  double brakingShare = 0.3;    // k_o, remaining fraction of braking for oncoming people in a crowd
  double yieldSpeed = 0.15;     // v_y [m/s]
  double yieldGap = 0.03;       // g0 [m]
  double pushBackLimit = 0.7;   // chi, relative to the goal force
  double crowdWallShare = 0.1;  // k_w, remaining wall push in a crowd beside narrow paths
  double groupTurnWidth = 0.1;  // [rad]; prevents members side by side from circling
};

base::ParameterTable<DensityParameters> densityTable();

/// Desired motion, which `sfm` does not use.
struct DesiredMotion {
  Vec2 direction = Vec2::Zero();  // unit vector of the walking direction; zero: no goal
  Vec2 heading = Vec2(1.0, 0.0);  // unit vector
  double desiredSpeed = 0.0;      // v0 [m/s]
  int group = -1;
  bool isRobot = false;  // its velocity is its desired velocity
};

struct Pedestrian {
  Walker body;
  DesiredMotion desired;
};

constexpr double kDensityRange = 5.0;  // [m]; interaction range

struct DensityForce {
  double speedCap = 0.0;    // V_cap [m/s]
  double activation = 0.0;  // activation of the crowd effects, 0 to 1
  Vec2 goal = Vec2::Zero(), social = Vec2::Zero(), lane = Vec2::Zero();
};
/// Sums are computed in the order of `others`.
DensityForce densityForce(const DensityParameters& parameters, const Pedestrian& self,
                          const std::vector<Pedestrian>& others);

/// Obstacle force. In a crowd (`activation`) on a narrow path, walls beside push less, so that
/// people walk close to them. Its component against the walking direction is limited to a fraction
/// of the goal force.
Vec2 limitedObstacleForce(const DensityParameters& parameters, const Pedestrian& self,
                          const std::vector<Obstacles::Point>& points, double activation = 0.0);

/// Limits `velocity` so that the body does not run into people or walls; touching neighbours
/// separate, and of two who touch the one behind gives way.
Vec2 avoidContacts(const DensityParameters& parameters, const Pedestrian& self,
                   const std::vector<Pedestrian>& others,
                   const std::vector<Obstacles::Point>& points, const Vec2& velocity, double dt);

}  // namespace sim2d
