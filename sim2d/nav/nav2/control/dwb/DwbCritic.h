#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/dwb/DwbParameters.h"
#include "sim2d/nav/nav2/control/dwb/DwbTrajectory.h"
#include "sim2d/nav/nav2/control/dwb/MapGrid.h"

/// Critics, which score trajectories (dwb_critics).
namespace sim2d::nav2 {

constexpr char kOffGridRejection[] = "Trajectory Goes Off Grid.";

/// Data of a cycle for the critics.
struct DwbScene {
  const ControlInput& input;
  const Path& plan;   // local plan, not empty
  Pose2 goal;         // end of the complete path
  MapGrid& pathGrid;  // distances from the path; shared by all critics of a cycle
  MapGrid& goalGrid;  // distances from its end on the map
};

/// A score, or why the trajectory is invalid.
struct DwbScore {
  double raw = 0.0;
  const char* rejection = nullptr;

  DwbScore(double score) : raw(score) {}         // NOLINT: meant to convert
  DwbScore(const char* why) : rejection(why) {}  // NOLINT
};

class DwbCritic {
 public:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  virtual ~DwbCritic() = default;
  /// Called for a new path.
  virtual void reset() {}
  /// Called at the start of a cycle; the scene must exist until its end.
  virtual void prepare(const DwbScene& /*scene*/) {}
  virtual DwbScore score(const DwbTrajectory& trajectory) = 0;
  /// A lower bound of the raw score; may be infinite if score() would reject the trajectory. Called
  /// before `cells` and `onMap` are filled: a critic that reads them overrides this.
  virtual double leastScore(const DwbTrajectory& trajectory) {
    const DwbScore exact = score(trajectory);
    if (exact.rejection != nullptr) {
      return kInfinity;
    }
    return exact.raw;
  }
  /// Called with the chosen command; zero if no trajectory was valid.
  virtual void debrief(const BodyTwist& /*chosen*/) {}
  /// The weight in this cycle; 0: the critic is skipped. `resolution` of the costmap [m].
  virtual double scale(double resolution) const = 0;
};

/// Keys of all critics; each critic uses some of them.
struct DwbCriticParameters {
  double scale = 1.0;
  bool sumsScores = false;              // BaseObstacle, ObstacleFootprint
  std::string aggregation = "last";     // PathDist, GoalDist, PathAlign, GoalAlign
  double forwardPointDistance = 0.325;  // [m], PathAlign, GoalAlign
  double slowingFactor = 5.0;           // RotateToGoal
  double lookaheadTime = -1.0;          // [s], RotateToGoal; negative: end of the trajectory
  double resetDistance = 0.05;          // [m], Oscillation; negative: off
  double resetAngle = 0.2;              // [rad]
  double resetTime = -1.0;              // [s]
  double xOnlyThreshold = 0.05;         // [m/s]
  double penalty = 1.0;                 // PreferForward
  double strafeX = 0.1;                 // [m/s]
  double strafeTheta = 0.2;             // [rad/s]
  double thetaScale = 10.0;             // [s/rad]
};

/// Data from which a critic is created.
struct DwbCriticSetup {
  DwbCriticParameters parameters;
  const DwbParameters& controller;
  Distro distro = Distro::Jazzy;
};

/// A critic class.
struct DwbCriticType {
  const char* plugin;  // "dwb_critics::BaseObstacleCritic"
  std::vector<Nav2Key<DwbCriticParameters>> keys;
  std::unique_ptr<DwbCritic> (*make)(const DwbCriticSetup& setup);
};
const std::vector<DwbCriticType>& dwbCriticTypes();
/// Resolves a name as Nav2 does: "PathDist" is dwb_critics::PathDistCritic. Null: unknown.
const DwbCriticType* dwbCriticType(const std::string& name,
                                   const std::vector<std::string>& namespaces);

// Parts of dwbCriticTypes().
std::vector<DwbCriticType> obstacleCriticTypes();
std::vector<DwbCriticType> mapGridCriticTypes();
std::vector<DwbCriticType> motionCriticTypes();

}  // namespace sim2d::nav2
