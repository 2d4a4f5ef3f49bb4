#pragma once

#include <vector>

#include "sim2d/nav/SocialForce.h"

/// The density-aware social force model as pure functions: the forces of SocialForce.h for lone
/// pairs, groups and walls, and beyond them what crowds need. The distance to those ahead limits
/// the speed (after Tordeux, Chraibi & Seyfried 2016); in counter-flow a lateral force sorts people
/// into lanes; a guard keeps bodies apart. Forces are accelerations [m/s²], world frame. Thread:
/// any.
namespace sim2d {

struct DensityParameters {
  ForceParameters social;
  double timeGap = 0.9;         // T [s] to whoever is straight ahead
  double capWidth = 0.31;       // t, tangent of the angle that counts as ahead
  double coMovingWeight = 0.1;  // w0, of the force between people of one velocity
  double fullWeightAt = 1.0;    // v_c [m/s], relative speed from which the force counts fully
  double intentShare = 0.3;     // beta, of the wanted velocity in what people react to
  double laneFactor = 7.0;      // k_l [m/s²]
  double fileShare = 0.7;       // kappa, of those who walk the same way in the lane force
  double crowdScale = 0.5;      // K
  double brakingShare = 0.3;    // k_o, kept of the braking for oncoming people in a crowd
  double yieldSpeed = 0.15;     // v_y [m/s]
  double yieldGap = 0.03;       // g0 [m]
  double pushBackLimit = 0.7;   // chi, of the goal force
  double crowdWallShare = 0.1;  // k_w, of the push of walls beside narrow ways that a crowd keeps
  double mateTurnWidth = 0.1;   // [rad]; mates side by side do not circle round each other
};

base::ParameterTable<DensityParameters> densityTable();

/// What `sfm` has no use for: where somebody wants to go and how fast.
struct DesiredMotion {
  Vec2 direction = Vec2::Zero();  // unit vector of the way to go; zero: no goal
  Vec2 heading = Vec2(1.0, 0.0);  // unit vector
  double desiredSpeed = 0.0;      // v0 [m/s]
  int group = -1;
  bool isRobot = false;  // its velocity is what it wants
};

struct Pedestrian {
  Walker body;
  DesiredMotion desired;
};

constexpr double kDensityRange = 5.0;  // [m]; neighbours farther away do not count

struct DensityForce {
  double speedCap = 0.0;    // V_cap [m/s]
  double activation = 0.0;  // of what acts in crowds only, 0 to 1
  Vec2 goal = Vec2::Zero(), social = Vec2::Zero(), lane = Vec2::Zero();
};
/// The order of `others` is the order of the sums.
DensityForce densityForce(const DensityParameters& parameters, const Pedestrian& self,
                          const std::vector<Pedestrian>& others);

/// The force of obstacles. In a crowd (`activation`) on a narrow way those beside push less: people
/// then walk close to walls. Against the way to go it is not stronger than a share of the goal
/// force.
Vec2 limitedObstacleForce(const DensityParameters& parameters, const Pedestrian& self,
                          const std::vector<Obstacles::Point>& points, double activation = 0.0);

/// `velocity` without what would bring the body into people or walls; touching neighbours part, and
/// of two who touch the one behind gives way.
Vec2 guardContacts(const DensityParameters& parameters, const Pedestrian& self,
                   const std::vector<Pedestrian>& others,
                   const std::vector<Obstacles::Point>& points, const Vec2& velocity, double dt);

}  // namespace sim2d
