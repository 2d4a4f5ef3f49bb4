#include "sim2d/nav/nav2/route/RouteParameters.h"

#include <array>
#include <optional>

namespace sim2d::nav2 {

const std::vector<Nav2Key<RouteServerParameters>>& routeServerKeys() {
  using P = RouteServerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"graph_filepath", &P::graphFilepath, "", "GeoJSON file of the graph"},
      {"edge_cost_functions", &P::edgeCostFunctions, "", "Plugins that compute the costs of edges"},
      {"operations", &P::operations, "", "Plugins that are executed while a route is followed"},
      {"max_iterations", &P::maxIterations, "",
       "Maximum number of iterations of the search; 0: no limit"},
      {"tracker_update_rate", &P::trackerUpdateRate, "Hz", "Rate at which progress is checked"},
      {"radius_to_achieve_node", &P::radiusToAchieveNode, "m",
       "Distance within which a node is reached"},
      {"boundary_radius_to_achieve_node", &P::boundaryRadiusToAchieveNode, "m",
       "Distance within which the first or last node is reached"},
      {"aggregate_blocked_ids", &P::aggregateBlockedIds, "",
       "Blocked edges stay blocked for later routes"},
      {"prune_goal", &P::pruneGoal, "", "Removes a last edge that leads past the goal"},
      {"min_prune_dist_from_start", &P::minPruneDistFromStart, "m",
       "An edge is removed if the start is farther than this from its first node"},
      {"min_prune_dist_from_goal", &P::minPruneDistFromGoal, "m",
       "An edge is removed if the goal is farther than this from its last node"},
      {"max_prune_dist_from_edge", &P::maxPruneDistFromEdge, "m",
       "An edge is removed if the pose is within this distance of it"},
      {"enable_nn_search", &P::enableNnSearch, "",
       "Uses the nearest reachable node instead of the nearest one"},
      {"max_nn_search_iterations", &P::maxNnSearchIterations, "",
       "Maximum number of cells of that search"},
      {"num_nearest_nodes", &P::numNearestNodes, "", "Number of candidate nodes of that search"},
      {"smooth_corners", &P::smoothCorners, "", "Rounds the corners of the path"},
      {"smoothing_radius", &P::smoothingRadius, "m", "Radius of the rounded corners"},
      {"path_density", &P::pathDensity, "m", "Distance between poses of the path"}};
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredRouteServerKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"base_frame", "the robot's pose is that of its centre"},
      {"route_frame", "graphs are in the frame of the map"},
      {"global_frame", "graphs are in the frame of the map"},
      {"costmap_topic", "the global costmap is used"},
      {"max_planning_time",
       "runs are independent of the computer: max_iterations limits the "
       "search"},
      {"action_server_result_timeout", "results cannot be lost"},
      {"graph_file_loader", "graphs are read by GeoJsonGraphFileLoader"},
      {"GeoJsonGraphFileLoader.", "graphs are read by GeoJsonGraphFileLoader"},
      {"graph_file_saver", "graphs are not saved"},
      {"GeoJsonGraphFileSaver.", "graphs are not saved"}};
  return kKeys;
}

const std::vector<Nav2Key<DistanceScorerParameters>>& keysOf(const DistanceScorerParameters&) {
  using P = DistanceScorerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"speed_tag", &P::speedTag, "", "Metadata key of an edge: share of the speed on the edge"},
      {"weight", &P::weight, "", "Weight of this cost"}};
  return kKeys;
}

const std::vector<Nav2Key<TimeScorerParameters>>& keysOf(const TimeScorerParameters&) {
  using P = TimeScorerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"speed_tag", &P::speedTag, "", "Metadata key of an edge: speed on the edge in m/s"},
      {"time_tag", &P::timeTag, "", "Metadata key of an edge: measured time in s"},
      {"max_vel", &P::maxVel, "m/s", "Speed on edges without a speed"},
      {"weight", &P::weight, "", "Weight of this cost"}};
  return kKeys;
}

const std::vector<Nav2Key<PenaltyScorerParameters>>& keysOf(const PenaltyScorerParameters&) {
  using P = PenaltyScorerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"penalty_tag", &P::penaltyTag, "", "Metadata key of an edge: penalty"},
      {"weight", &P::weight, "", "Weight of this cost"}};
  return kKeys;
}

const std::vector<Nav2Key<CostmapScorerParameters>>& keysOf(const CostmapScorerParameters&) {
  using P = CostmapScorerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"use_maximum", &P::useMaximum, "", "Uses the maximum cost on the edge, else the mean"},
      {"invalid_on_collision", &P::invalidOnCollision, "", "Edges with a collision are not used"},
      {"invalid_off_map", &P::invalidOffMap, "", "Edges outside the map are not used"},
      {"max_cost", &P::maxCost, "", "Cost from which a cell is in collision"},
      {"check_resolution", &P::checkResolution, "", "Step between checked cells"},
      {"costmap_topic", &P::costmapTopic, "", "Local or global costmap"},
      {"weight", &P::weight, "", "Weight of this cost"}};
  return kKeys;
}

const std::vector<Nav2Key<SemanticScorerParameters>>& keysOf(const SemanticScorerParameters&) {
  using P = SemanticScorerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"semantic_key", &P::semanticKey, "",
       "Metadata key whose text is the class; empty: the keys are the classes"},
      {"semantic_classes", &P::semanticClasses, "",
       "Names of the classes, whose costs are keys of the same block"},
      {"weight", &P::weight, "", "Weight of this cost"}};
  return kKeys;
}

const std::vector<Nav2Key<OrientationScorerParameters>>& keysOf(
    const OrientationScorerParameters&) {
  using P = OrientationScorerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"orientation_tolerance", &P::orientationTolerance, "rad", "Maximum heading difference"},
      {"orientation_weight", &P::orientationWeight, "", "Cost per radian"},
      {"use_orientation_threshold", &P::useOrientationThreshold, "",
       "Edges beyond the tolerance are not used"}};
  return kKeys;
}

const std::vector<Nav2Key<DynamicEdgesParameters>>& keysOf(const DynamicEdgesParameters&) {
  static const std::vector<Nav2Key<DynamicEdgesParameters>> kKeys;
  return kKeys;
}

const std::vector<Nav2Key<AdjustSpeedLimitParameters>>& keysOf(const AdjustSpeedLimitParameters&) {
  using P = AdjustSpeedLimitParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"speed_tag", &P::speedTag, "", "Metadata key of an edge: percentage of the speed"}};
  return kKeys;
}

const std::vector<Nav2Key<RouteCollisionParameters>>& keysOf(const RouteCollisionParameters&) {
  using P = RouteCollisionParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"rate", &P::rate, "Hz", "Rate of the checks"},
      {"max_cost", &P::maxCost, "", "Cost from which a cell is in collision"},
      {"check_resolution", &P::checkResolution, "", "Step between checked cells"},
      {"max_collision_dist", &P::maxCollisionDist, "m",
       "Length of the route ahead that is checked"},
      {"reroute_on_collision", &P::rerouteOnCollision, "",
       "Computes another route, else the operation fails"},
      {"costmap_topic", &P::costmapTopic, "", "Local or global costmap"}};
  return kKeys;
}

const std::vector<Nav2Key<TimeMarkerParameters>>& keysOf(const TimeMarkerParameters&) {
  using P = TimeMarkerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"time_tag", &P::timeTag, "", "Metadata key of an edge in which the time in s is stored"}};
  return kKeys;
}

const std::vector<Nav2Key<ReroutingServiceParameters>>& keysOf(const ReroutingServiceParameters&) {
  static const std::vector<Nav2Key<ReroutingServiceParameters>> kKeys;
  return kKeys;
}

const std::vector<Nav2Key<TriggerEventParameters>>& keysOf(const TriggerEventParameters&) {
  using P = TriggerEventParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"service_name", &P::serviceName, "",
       "Event for nodes and edges whose graph file names none"}};
  return kKeys;
}

const std::vector<std::string>& edgeScorerPlugins() {
  static const std::vector<std::string> kPlugins = {
      "nav2_route::DistanceScorer",        "nav2_route::TimeScorer",
      "nav2_route::PenaltyScorer",         "nav2_route::CostmapScorer",
      "nav2_route::SemanticScorer",        "nav2_route::StartPoseOrientationScorer",
      "nav2_route::GoalOrientationScorer", "nav2_route::GoalPoseOrientationScorer",
      "nav2_route::DynamicEdgesScorer"};
  return kPlugins;
}

const std::vector<std::string>& routeOperationPlugins() {
  static const std::vector<std::string> kPlugins = {
      "nav2_route::AdjustSpeedLimit", "nav2_route::CollisionMonitor", "nav2_route::TimeMarker",
      "nav2_route::ReroutingService", "nav2_route::TriggerEvent"};
  return kPlugins;
}

std::optional<EdgeScorerSettings> edgeScorerOf(const std::string& plugin) {
  OrientationScorerParameters ofGoal;
  ofGoal.isOfGoal = true;
  const std::array<EdgeScorerSettings, 9> kSettings = {DistanceScorerParameters(),
                                                       TimeScorerParameters(),
                                                       PenaltyScorerParameters(),
                                                       CostmapScorerParameters(),
                                                       SemanticScorerParameters(),
                                                       OrientationScorerParameters(),
                                                       ofGoal,
                                                       ofGoal,
                                                       DynamicEdgesParameters()};
  for (std::size_t i = 0; i < kSettings.size(); ++i) {
    if (edgeScorerPlugins()[i] == plugin) {
      return kSettings.at(i);
    }
  }
  return std::nullopt;
}

std::optional<RouteOperationSettings> routeOperationOf(const std::string& plugin) {
  const std::array<RouteOperationSettings, 5> kSettings = {
      AdjustSpeedLimitParameters(), RouteCollisionParameters(), TimeMarkerParameters(),
      ReroutingServiceParameters(), TriggerEventParameters()};
  for (std::size_t i = 0; i < kSettings.size(); ++i) {
    if (routeOperationPlugins()[i] == plugin) {
      return kSettings.at(i);
    }
  }
  return std::nullopt;
}

base::Diagnostics problemsOf(const RouteServerParameters& parameters) {
  base::Diagnostics problems;
  ParameterChecks checks(problems);
  constexpr double kMinDensity = 1e-3;  // [m], smaller steps make paths too large
  checks.require(parameters.pathDensity >= kMinDensity, "path_density", "at least 0.001 m");
  checks.require(parameters.smoothingRadius > 0.0, "smoothing_radius", "above 0 m");
  checks.require(parameters.trackerUpdateRate > 0.0, "tracker_update_rate", "above 0 Hz");
  checks.require(parameters.numNearestNodes > 0, "num_nearest_nodes", "above 0");
  return problems;
}

}  // namespace sim2d::nav2
