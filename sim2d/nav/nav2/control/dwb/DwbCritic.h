#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Nav2Block.h"
#include "sim2d/nav/nav2/control/Controller.h"
#include "sim2d/nav/nav2/control/dwb/DwbParameters.h"
#include "sim2d/nav/nav2/control/dwb/DwbTrajectory.h"
#include "sim2d/nav/nav2/control/dwb/MapGrid.h"

/// What prices trajectories (dwb_critics).
namespace sim2d::nav2 {

constexpr char kRefusalOffGrid[] = "Trajectory Goes Off Grid.";

/// What critics know of a cycle.
struct DwbScene {
  const ControlInput& input;
  const Path& plan;   // the local one, not empty
  Pose2 goal;         // end of the whole path
  MapGrid& pathGrid;  // from the path; grown once for all critics of a cycle
  MapGrid& goalGrid;  // from its end on the map
};

/// A price, or why the trajectory is illegal.
struct DwbPrice {
  double raw = 0.0;
  const char* refusal = nullptr;

  DwbPrice(double price) : raw(price) {}       // NOLINT: meant to convert
  DwbPrice(const char* why) : refusal(why) {}  // NOLINT
};

class DwbCritic {
 public:
  virtual ~DwbCritic() = default;
  /// A new path.
  virtual void reset() {}
  /// A cycle begins; the scene lives until its end.
  virtual void prepare(const DwbScene& /*scene*/) {}
  virtual DwbPrice price(const DwbTrajectory& trajectory) = 0;
  /// What was chosen; zero when nothing was legal.
  virtual void debrief(const BodyTwist& /*chosen*/) {}
  /// The weight in this cycle; 0: it is not asked. `resolution` of the costmap [m].
  virtual double scale(double resolution) const = 0;
};

/// All keys of critics; each kind has some of them.
struct DwbCriticParameters {
  double scale = 1.0;
  bool sumsScores = false;              // BaseObstacle, ObstacleFootprint
  std::string aggregation = "last";     // PathDist, GoalDist, PathAlign, GoalAlign
  double forwardPointDistance = 0.325;  // [m], PathAlign, GoalAlign
  double slowingFactor = 5.0;           // RotateToGoal
  double lookaheadTime = -1.0;          // [s], RotateToGoal; negative: the end
  double resetDistance = 0.05;          // [m], Oscillation; negative: no matter
  double resetAngle = 0.2;              // [rad]
  double resetTime = -1.0;              // [s]
  double xOnlyThreshold = 0.05;         // [m/s]
  double penalty = 1.0;                 // PreferForward
  double strafeX = 0.1;                 // [m/s]
  double strafeTheta = 0.2;             // [rad/s]
  double thetaScale = 10.0;             // [s/rad]
};

/// What a critic is made of.
struct DwbCriticSetup {
  DwbCriticParameters parameters;
  const DwbParameters& controller;
  Distro distro = Distro::Jazzy;
};

/// A class of critics.
struct DwbCriticType {
  const char* plugin;  // "dwb_critics::BaseObstacleCritic"
  std::vector<Nav2Key<DwbCriticParameters>> keys;
  std::unique_ptr<DwbCritic> (*make)(const DwbCriticSetup& setup);
};
const std::vector<DwbCriticType>& dwbCriticTypes();
/// As Nav2 looks for it: "PathDist" is dwb_critics::PathDistCritic. Null: unknown.
const DwbCriticType* dwbCriticType(const std::string& name,
                                   const std::vector<std::string>& namespaces);

// Parts of dwbCriticTypes().
std::vector<DwbCriticType> obstacleCriticTypes();
std::vector<DwbCriticType> mapGridCriticTypes();
std::vector<DwbCriticType> motionCriticTypes();

}  // namespace sim2d::nav2
