#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

/// Parameters of the global planners; the defaults are those of Nav2's code in Jazzy
/// (`planner_server/…`, GlobalPlanner.h provides those of other distributions).
///
/// Wall-clock limits would make results depend on the computer. `max_planning_time` is therefore a
/// limit of iterations: as many as a current computer performs in that time, `k…PerSecond` below.
namespace sim2d::nav2 {

/// nav2_navfn_planner::NavfnPlanner: wave front over cells, then descent.
struct NavfnParameters {
  double tolerance = 0.5;                    // [m] maximum distance of the path's end from the goal
  bool useAstar = false;                     // A* instead of Dijkstra
  bool allowUnknown = true;                  // through cells of 255
  bool useFinalApproachOrientation = false;  // last heading along the path, not the goal's
  int maxCyclesFactor = 4;                   // descent steps per cell of the longer side
};

/// nav2_theta_star_planner::ThetaStarPlanner: any-angle A*.
struct ThetaStarParameters {
  int howManyCorners = 8;  // neighbours: 4 or 8
  bool allowUnknown = true;
  double eucCost = 1.0;        // w_euc, per cell of length
  double traversalCost = 2.0;  // w_traversal, per squared cell cost
  bool useFinalApproachOrientation = false;
  int terminalCheckingInterval = 5000;  // expansions between checks of the stop flag
};

/// Common parameters of the Smac planners: search limits and the built-in smoother.
struct SmacParameters {
  bool downsampleCostmap = false;
  int downsamplingFactor = 1;
  bool allowUnknown = true;
  int maxIterations = 1000000;          // <= 0: no limit
  int maxOnApproachIterations = 1000;   // <= 0: no limit
  int terminalCheckingInterval = 5000;  // iterations between checks of the stop flag
  double smootherTolerance = 1e-10;     // sum of changes of a sweep at convergence [m]
  int smootherMaxIterations = 1000;     // sweeps; 0: no smoothing
  double smootherWData = 0.2;           // weight of the original path
  double smootherWSmooth = 0.3;         // weight of the midpoint of the neighbours
  bool smootherDoRefinement = true;
  int smootherRefinementNum = 2;  // how often the result is smoothed again; Humble: 4
};

/// nav2_smac_planner::SmacPlanner2D: A* over cells.
struct Smac2DParameters : SmacParameters {
  double tolerance = 0.125;           // [m]
  double maxPlanningTime = 2.0;       // [s], see above
  double costTravelMultiplier = 1.0;  // weight of a cell's cost relative to its length
  bool useFinalApproachOrientation = false;
};
constexpr double kSmac2DPerSecond = 1e6;  // iterations

/// Common parameters of the Smac planners that search over poses.
struct SmacPoseParameters : SmacParameters {
  double tolerance = 0.25;       // [m]
  double maxPlanningTime = 5.0;  // [s], see above
  bool smoothPath = true;
  double reversePenalty = 2.0, changePenalty = 0.0, nonStraightPenalty = 1.2;  // factors
  double costPenalty = 2.0, retrospectivePenalty = 0.015;
  bool useQuadraticCostPenalty = false;
  bool cacheObstacleHeuristic = false;
  bool downsampleObstacleHeuristic = true;
  double analyticExpansionRatio = 3.5;
  double analyticExpansionMaxLength = 3.0;  // [m]
  double analyticExpansionMaxCost = 200.0;
  bool analyticExpansionMaxCostOverride = false;
  std::string goalHeadingMode = "DEFAULT";  // or "BIDIRECTIONAL", "ALL_DIRECTION"
};
constexpr double kSmacHybridPerSecond = 1e5;  // iterations

/// nav2_smac_planner::SmacPlannerHybrid: A* over poses that a car can reach.
struct SmacHybridParameters : SmacPoseParameters {
  std::string motionModelForSearch = "DUBIN";  // or "REEDS_SHEPP"
  double minimumTurningRadius = 0.4;           // R [m]
  int angleQuantizationBins = 72;
  bool allowPrimitiveInterpolation = false;  // turns of every angle up to the sharpest
  double lookupTableSize = 20.0;  // [m] side of the square around the goal with cached lengths
  int coarseSearchResolution = 1;
};

/// A motion primitive from the origin.
struct LatticePrimitive {
  int startHeading = 0, endHeading = 0;  // indices of headings of the lattice
  bool isLeftTurn = true;
  double length = 0.0;       // [m]; 0: a turn in place
  double arcLength = 0.0;    // arc part [m]
  std::vector<Pose2> poses;  // along the primitive; the last is its end [m], [rad]
};

/// A file of motion primitives of nav2_smac_planner's generator (lattice_primitives).
struct Lattice {
  std::string file;
  std::string motionModel = "diff";  // "diff", "ackermann", "omni"
  double turningRadius = 0.5;        // [m]
  std::vector<double> headings;      // [rad], ascending from 0; with all opposite headings
  std::vector<std::vector<LatticePrimitive>> primitives;  // by the index of the start heading

  int size() const { return static_cast<int>(headings.size()); }
  /// The index of the nearest heading.
  int nearestHeading(double heading) const;
  int oppositeOf(int heading) const { return (heading + size() / 2) % size(); }
};

/// nav2_smac_planner::SmacPlannerLattice: A* over the motion primitives of a file.
struct SmacLatticeParameters : SmacPoseParameters {
  SmacLatticeParameters() {
    changePenalty = 0.05;
    nonStraightPenalty = 1.05;
  }

  std::string latticeFilepath;
  std::shared_ptr<const Lattice> lattice;  // not a key: content of that file; null: not read
  bool allowReverseExpansion = false;
  double rotationPenalty = 5.0;  // for a turn in place
};

/// Parameters of planner_server itself.
struct PlannerServerParameters {
  std::vector<std::string> plannerPlugins = {"GridBased"};  // names; `<name>.plugin` is the class
  bool allowPartialPlanning = false;  // several goals: returns a partial path on failure
  double costmapUpdateTimeout = 1.0;  // [s] after a clear, since Jazzy; Humble waits indefinitely
};

/// Key tables, selected by the type of the argument.
Nav2Keys<NavfnParameters> keysOf(const NavfnParameters&);
Nav2Keys<ThetaStarParameters> keysOf(const ThetaStarParameters&);
Nav2Keys<Smac2DParameters> keysOf(const Smac2DParameters&);
Nav2Keys<SmacHybridParameters> keysOf(const SmacHybridParameters&);
Nav2Keys<SmacLatticeParameters> keysOf(const SmacLatticeParameters&);
Nav2Keys<PlannerServerParameters> keysOf(const PlannerServerParameters&);
IgnoredKeys ignoredKeysOf(const NavfnParameters&);
IgnoredKeys ignoredKeysOf(const ThetaStarParameters&);
IgnoredKeys ignoredKeysOf(const Smac2DParameters&);
IgnoredKeys ignoredKeysOf(const SmacHybridParameters&);
IgnoredKeys ignoredKeysOf(const SmacLatticeParameters&);
IgnoredKeys ignoredKeysOf(const PlannerServerParameters&);

/// Checks of parameter values. Each error is a sentence that begins with the key.

std::vector<std::string> plannerErrors(const NavfnParameters& parameters);
std::vector<std::string> plannerErrors(const ThetaStarParameters& parameters);
std::vector<std::string> plannerErrors(const Smac2DParameters& parameters);
std::vector<std::string> plannerErrors(const SmacHybridParameters& parameters);
std::vector<std::string> plannerErrors(const SmacLatticeParameters& parameters);

/// Collects the errors.
class ValueErrors {
 public:
  /// Adds an error if the value is outside [low, high].
  ValueErrors& range(const char* key, double value, double low, double high);
  ValueErrors& oneOf(const char* key, const std::string& value,
                     const std::vector<std::string>& allowed);
  ValueErrors& require(bool isGood, std::string sentence);
  std::vector<std::string> take() { return std::move(messages_); }

 private:
  std::vector<std::string> messages_;
};

}  // namespace sim2d::nav2
