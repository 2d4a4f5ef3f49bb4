#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim2d/nav/nav2/Nav2Key.h"
#include "sim2d/nav/nav2/global/Lattice.h"

/// Parameters of the global planners; the defaults are those of Nav2's code in Jazzy
/// (`planner_server/…`, GlobalPlanners.h gives those of another distribution).
///
/// Wall-clock limits would make results depend on the computer. `max_planning_time` is a limit of
/// iterations here: so many as a present-day computer does in that time, `k…PerSecond` below.
namespace sim2d::nav2 {

/// nav2_navfn_planner::NavfnPlanner: wave front over cells, then descent.
struct NavfnParameters {
  double tolerance = 0.5;                    // [m] how far from the goal the path may end
  bool useAstar = false;                     // A* instead of Dijkstra
  bool allowUnknown = true;                  // through cells of 255
  bool useFinalApproachOrientation = false;  // last heading along the path, not the goal's
  int maxCyclesFactor = 4;                   // steps of the descent per cell of the longer side
};

/// nav2_theta_star_planner::ThetaStarPlanner: any-angle A*.
struct ThetaStarParameters {
  int howManyCorners = 8;  // neighbours: 4 or 8
  bool allowUnknown = true;
  double eucCost = 1.0;        // w_euc, per cell of length
  double traversalCost = 2.0;  // w_traversal, per square of a cell's cost
  bool useFinalApproachOrientation = false;
  int terminalCheckingInterval = 5000;  // expansions between two looks at the stop flag
};

/// What both Smac planners have: the search's limits and the smoother inside.
struct SmacParameters {
  bool downsampleCostmap = false;
  int downsamplingFactor = 1;
  bool allowUnknown = true;
  int maxIterations = 1000000;          // <= 0: no limit
  int maxOnApproachIterations = 1000;   // <= 0: no limit
  int terminalCheckingInterval = 5000;  // iterations between two looks at the stop flag
  double smootherTolerance = 1e-10;     // sum of changes of a sweep that ends it [m]
  int smootherMaxIterations = 1000;     // sweeps; 0: no smoothing
  double smootherWData = 0.2;           // pull to the path as it was
  double smootherWSmooth = 0.3;         // pull to the middle of the neighbours
  bool smootherDoRefinement = true;
  int smootherRefinementNum = 2;  // how often the result is smoothed again; Humble: 4
};

/// nav2_smac_planner::SmacPlanner2D: A* over cells.
struct Smac2DParameters : SmacParameters {
  double tolerance = 0.125;           // [m]
  double maxPlanningTime = 2.0;       // [s], see above
  double costTravelMultiplier = 1.0;  // weight of a cell's cost against its length
  bool useFinalApproachOrientation = false;
};
constexpr double kSmac2DPerSecond = 1e6;  // iterations

/// nav2_smac_planner::SmacPlannerHybrid: A* over poses that a car can drive.
struct SmacHybridParameters : SmacParameters {
  double tolerance = 0.25;                     // [m]
  double maxPlanningTime = 5.0;                // [s], see above
  std::string motionModelForSearch = "DUBIN";  // or "REEDS_SHEPP"
  double minimumTurningRadius = 0.4;           // R [m]
  int angleQuantizationBins = 72;
  bool allowPrimitiveInterpolation = false;  // steps of every angle up to the sharpest
  bool smoothPath = true;
  double reversePenalty = 2.0, changePenalty = 0.0, nonStraightPenalty = 1.2;  // factors
  double costPenalty = 2.0, retrospectivePenalty = 0.015;
  bool useQuadraticCostPenalty = false;
  bool cacheObstacleHeuristic = false;
  bool downsampleObstacleHeuristic = true;
  double lookupTableSize = 20.0;  // [m] side of the square of known lengths round the goal
  double analyticExpansionRatio = 3.5;
  double analyticExpansionMaxLength = 3.0;  // [m]
  double analyticExpansionMaxCost = 200.0;
  bool analyticExpansionMaxCostOverride = false;
  std::string goalHeadingMode = "DEFAULT";  // or "BIDIRECTIONAL", "ALL_DIRECTION"
  int coarseSearchResolution = 1;
};
constexpr double kSmacHybridPerSecond = 1e5;  // iterations

/// nav2_smac_planner::SmacPlannerLattice: A* over motion primitives of a file.
struct SmacLatticeParameters : SmacParameters {
  double tolerance = 0.25;       // [m]
  double maxPlanningTime = 5.0;  // [s], see above
  std::string latticeFilepath;
  std::shared_ptr<const Lattice> lattice;  // no key: what is in that file; null: not read
  bool allowReverseExpansion = false;
  bool smoothPath = true;
  double reversePenalty = 2.0, changePenalty = 0.05, nonStraightPenalty = 1.05;  // factors
  double rotationPenalty = 5.0;  // of a turn on the spot
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

/// planner_server itself.
struct PlannerServerParameters {
  std::vector<std::string> plannerPlugins = {"GridBased"};  // names; `<name>.plugin` is the class
  bool allowPartialPlanning = false;  // several goals: a path as far as it could be planned
  double costmapUpdateTimeout = 1.0;  // [s] after a clear, since Jazzy; Humble waits for ever
};

/// The tables. The argument only chooses which.
const std::vector<Nav2Key<NavfnParameters>>& keysOf(const NavfnParameters&);
const std::vector<Nav2Key<ThetaStarParameters>>& keysOf(const ThetaStarParameters&);
const std::vector<Nav2Key<Smac2DParameters>>& keysOf(const Smac2DParameters&);
const std::vector<Nav2Key<SmacHybridParameters>>& keysOf(const SmacHybridParameters&);
const std::vector<Nav2Key<SmacLatticeParameters>>& keysOf(const SmacLatticeParameters&);
const std::vector<Nav2Key<PlannerServerParameters>>& keysOf(const PlannerServerParameters&);
const std::vector<IdleKey>& idleKeysOf(const NavfnParameters&);
const std::vector<IdleKey>& idleKeysOf(const ThetaStarParameters&);
const std::vector<IdleKey>& idleKeysOf(const Smac2DParameters&);
const std::vector<IdleKey>& idleKeysOf(const SmacHybridParameters&);
const std::vector<IdleKey>& idleKeysOf(const SmacLatticeParameters&);
const std::vector<IdleKey>& idleKeysOf(const PlannerServerParameters&);

}  // namespace sim2d::nav2
