#pragma once

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

/// Keys of the route server (nav2_route), which exists since Kilted. Defaults are those of its
/// code.
namespace sim2d::nav2 {

struct RouteServerParameters {
  std::string graphFilepath;  // GeoJSON; empty: no graph
  std::vector<std::string> edgeCostFunctions = {"DistanceScorer", "DynamicEdgesScorer"};
  std::vector<std::string> operations = {"AdjustSpeedLimit", "ReroutingService"};
  int maxIterations = 0;                     // of the search; 0: unlimited
  double trackerUpdateRate = 50.0;           // [Hz]
  double radiusToAchieveNode = 2.0;          // [m]
  double boundaryRadiusToAchieveNode = 1.0;  // [m], for the first and the last node
  bool aggregateBlockedIds = false;          // blocked edges stay blocked when rerouting
  bool pruneGoal = true;
  double minPruneDistFromStart = 0.10;  // [m]
  double minPruneDistFromGoal = 0.15;   // [m]
  double maxPruneDistFromEdge = 8.0;    // [m]
  bool enableNnSearch = true;           // selects a reachable one of the nearest nodes
  int maxNnSearchIterations = 10000;
  int numNearestNodes = 5;
  bool smoothCorners = false;
  double smoothingRadius = 1.0;  // [m]
  double pathDensity = 0.05;     // [m] between poses
};

/// Values of keys that a plugin does not have are ignored.
struct DistanceScorerParameters {
  std::string speedTag = "speed_limit";  // metadata of an edge: fraction of the speed
  double weight = 1.0;
};
struct TimeScorerParameters {
  std::string speedTag = "abs_speed_limit";  // metadata of an edge [m/s]
  std::string timeTag = "abs_time_taken";    // measured by TimeMarker [s]
  double maxVel = 0.5;                       // [m/s], for edges without a speed
  double weight = 1.0;
};
struct PenaltyScorerParameters {
  std::string penaltyTag = "penalty";
  double weight = 1.0;
};
struct CostmapScorerParameters {
  bool useMaximum = true;  // maximum cost on the edge, else the mean
  bool invalidOnCollision = true, invalidOffMap = true;
  double maxCost = 253.0;
  int checkResolution = 2;  // samples one of this many cells of the line
  std::string costmapTopic = "global_costmap/costmap_raw";
  double weight = 1.0;
};
struct SemanticScorerParameters {
  std::string semanticKey = "class";  // metadata key of the class; empty: metadata keys are classes
  std::vector<std::string> semanticClasses;
  double weight = 1.0;
  std::map<std::string, double> costs;  // not a key: those named by `semanticClasses`
};
struct OrientationScorerParameters {                 // for the start and for the goal
  double orientationTolerance = 1.5707963267948966;  // [rad]
  double orientationWeight = 1.0;
  bool useOrientationThreshold = false;  // edges beyond the tolerance are not usable
  bool isOfGoal = false;                 // not a key
};
struct DynamicEdgesParameters {};

using EdgeScorerSettings =
    std::variant<DistanceScorerParameters, TimeScorerParameters, PenaltyScorerParameters,
                 CostmapScorerParameters, SemanticScorerParameters, OrientationScorerParameters,
                 DynamicEdgesParameters>;

struct AdjustSpeedLimitParameters {
  std::string speedTag = "speed_limit";  // metadata of an edge: percent of the speed
};
struct RouteCollisionParameters {  // nav2_route::CollisionMonitor
  double rate = 1.0;               // [Hz]
  double maxCost = 253.0;
  int checkResolution = 1;        // samples one of this many cells of the line
  double maxCollisionDist = 5.0;  // [m] ahead
  bool rerouteOnCollision = true;
  std::string costmapTopic = "local_costmap/costmap_raw";
};
struct TimeMarkerParameters {
  std::string timeTag = "abs_time_taken";  // metadata of an edge [s]
};
struct ReroutingServiceParameters {};
struct TriggerEventParameters {
  std::string serviceName;  // overridden by that of the graph file
};

using RouteOperationSettings =
    std::variant<AdjustSpeedLimitParameters, RouteCollisionParameters, TimeMarkerParameters,
                 ReroutingServiceParameters, TriggerEventParameters>;

/// The route server with its plugins by name, in the order of the lists.
struct RouteSettings {
  RouteServerParameters server;
  std::vector<std::pair<std::string, EdgeScorerSettings>> scorers;
  std::vector<std::pair<std::string, RouteOperationSettings>> operations;
};

Nav2Keys<RouteServerParameters> routeServerKeys();
IgnoredKeys ignoredRouteServerKeys();
Nav2Keys<DistanceScorerParameters> keysOf(const DistanceScorerParameters&);
Nav2Keys<TimeScorerParameters> keysOf(const TimeScorerParameters&);
Nav2Keys<PenaltyScorerParameters> keysOf(const PenaltyScorerParameters&);
Nav2Keys<CostmapScorerParameters> keysOf(const CostmapScorerParameters&);
Nav2Keys<SemanticScorerParameters> keysOf(const SemanticScorerParameters&);
Nav2Keys<OrientationScorerParameters> keysOf(const OrientationScorerParameters&);
Nav2Keys<DynamicEdgesParameters> keysOf(const DynamicEdgesParameters&);
Nav2Keys<AdjustSpeedLimitParameters> keysOf(const AdjustSpeedLimitParameters&);
Nav2Keys<RouteCollisionParameters> keysOf(const RouteCollisionParameters&);
Nav2Keys<TimeMarkerParameters> keysOf(const TimeMarkerParameters&);
Nav2Keys<ReroutingServiceParameters> keysOf(const ReroutingServiceParameters&);
Nav2Keys<TriggerEventParameters> keysOf(const TriggerEventParameters&);

/// The plugin classes of edge_cost_functions and operations.
PluginClasses<EdgeScorerSettings> edgeScorerClasses();
PluginClasses<RouteOperationSettings> routeOperationClasses();

/// Errors in values for which no route can be computed or followed.
base::Diagnostics problemsOf(const RouteServerParameters& parameters);

}  // namespace sim2d::nav2
