#pragma once

#include <vector>

#include "sim2d/base/Registry.h"
#include "sim2d/map/Obstacles.h"

/// Social force model as pure functions. Forces are accelerations [m/s²], world frame. Sources:
/// Helbing & Molnár 1995 (goal, walls), Moussaïd et al. 2009 (between people) and 2010 (groups), in
/// the form of the library lightsfm. Thread-safe.
namespace sim2d {

struct ForceParameters {
  double goalFactor = 2.0;       // k_g
  double relaxationTime = 0.5;   // tau [s]
  double obstacleFactor = 10.0;  // k_o [m/s²]
  double obstacleRange = 0.2;    // sigma [m]
  double socialFactor = 5.0;     // k_s [m/s²]
  double lambda = 2.0;           // weight of the relative velocity [s/m]
  double gamma = 0.35;           // [m]
  double n = 2.0;                // [1/m]
  double nPrime = 3.0;           // [1/m]
  double epsilon = 0.005;        // side preference [rad/m]; 0 = none
  double turnWidth = 0.0;        // |theta| at which the turning part reaches full strength [rad]
  double gazeFactor = 3.0;       // k_gz
  double coherenceFactor = 2.0;  // k_gc
  double repulsionFactor = 1.0;  // k_gr
};

/// Without the factors that are keys of a person in the scenario.
base::ParameterTable<ForceParameters> forceTable();

/// How one person reacts to the others in a crowd. Without parameters, the person exerts forces but
/// feels none.
struct CrowdForceModel {
  const ForceParameters* parameters = nullptr;
  bool goesThroughWalls = false;

  friend bool operator==(const CrowdForceModel& a, const CrowdForceModel& b) {
    return a.parameters == b.parameters && a.goesThroughWalls == b.goesThroughWalls;
  }
};

/// A body that exerts or feels social forces.
struct Walker {
  Vec2 position = Vec2::Zero();  // [m]
  Vec2 velocity = Vec2::Zero();  // [m/s]
  double radius = 0.35;          // [m]
  int id = 0;

  Walker() = default;
  Walker(int number, const Vec2& place, const Vec2& speed, double size)
      : position(place), velocity(speed), radius(size), id(number) {}
};

/// Force towards `direction` (unit vector) at `desiredSpeed` [m/s]. Zero direction: deceleration at
/// the rate 1 / tau.
Vec2 goalForce(const ForceParameters& parameters, const Vec2& velocity, const Vec2& direction,
               double desiredSpeed);

/// Goal force averaged over `time` [s] with constant `otherTerms`, in sub-steps short enough that
/// the relaxation of the velocity does not depend on the step size; equals the force itself while
/// one sub-step is enough (up to 0.05 s with the default parameters).
Vec2 meanGoalForce(const ForceParameters& parameters, const Vec2& velocity, const Vec2& direction,
                   double desiredSpeed, const Vec2& otherTerms, double time);

/// Force of `other` on `self`. Bodies at the same position are distinguished by their ids; where
/// the interaction vector vanishes, the force is its limit, zero.
Vec2 socialForce(const ForceParameters& parameters, const Walker& self, const Walker& other);

/// Cut-off for `isWeaker`: forces [m/s²] below `force`.
double cutOffOfForce(const ForceParameters& parameters, double force);
/// Whether `socialForce` is certainly below the force of `cutOff`; much cheaper than the force.
bool isWeaker(const ForceParameters& parameters, const Walker& self, const Walker& other,
              double cutOff);

/// Exponent of a cut-off that ignores forces below `share` of k_s: -ln(share).
double cutOff(double share);
/// True if both components of the force are below the share of k_s given by `cutOff`, by a bound
/// without exponentials (exact for epsilon = 0).
bool isNegligible(const ForceParameters& parameters, const Walker& self, const Walker& other,
                  double cutOff);
/// Distance beyond which `isNegligible` holds, for bodies of at most these speeds [m].
double socialRange(const ForceParameters& parameters, double speed, double otherSpeed,
                   double cutOff);

/// Force of one boundary point; inside an obstacle it points towards the point instead of away from
/// it.
Vec2 obstacleForce(const ForceParameters& parameters, const Walker& self,
                   const Obstacles::Point& point);
/// Sum over all points.
Vec2 obstacleForce(const ForceParameters& parameters, const Walker& self,
                   const std::vector<Obstacles::Point>& points);

struct GroupForce {
  Vec2 gaze = Vec2::Zero(), coherence = Vec2::Zero(), repulsion = Vec2::Zero();
  Vec2 sum() const { return gaze + coherence + repulsion; }
};
/// `direction`: walking direction of `self` (unit vector, or zero: no gaze). `others`: the other
/// members.
GroupForce groupForce(const ForceParameters& parameters, const Walker& self, const Vec2& direction,
                      const std::vector<Walker>& others);

/// `obstacleForce` [m/s^2] of each point of a wall separately, in order and bit-identical; replaces
/// the contents of `forces`. Defined in SocialForce.cpp. Thread-safe.
void obstacleForces(const ForceParameters& parameters, const Walker& self,
                    const std::vector<Obstacles::Point>& points, std::vector<Vec2>& forces);

}  // namespace sim2d
