#include "sim2d/nav/nav2/route/RouteParameters.h"

namespace sim2d::nav2 {

Nav2Keys<RouteServerParameters> routeServerKeys() {
  using P = RouteServerParameters;
  return {
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
}

IgnoredKeys ignoredRouteServerKeys() {
  return {{"base_frame", "the robot's pose is that of its centre"},
          {"route_frame", "graphs are in the frame of the map"},
          {"global_frame", "graphs are in the frame of the map"},
          {"costmap_topic", "the global costmap is used"},
          {"max_planning_time",
           "runs are independent of the computer: max_iterations limits the "
           "search"},
          {"graph_file_loader", "graphs are read by GeoJsonGraphFileLoader"},
          {"GeoJsonGraphFileLoader.", "graphs are read by GeoJsonGraphFileLoader"},
          {"graph_file_saver", "graphs are not saved"},
          {"GeoJsonGraphFileSaver.", "graphs are not saved"}};
}

Nav2Keys<DistanceScorerParameters> keysOf(const DistanceScorerParameters&) {
  using P = DistanceScorerParameters;
  return {
      {"speed_tag", &P::speedTag, "", "Metadata key of an edge: share of the speed on the edge"},
      {"weight", &P::weight, "", "Weight of this cost"}};
}

Nav2Keys<TimeScorerParameters> keysOf(const TimeScorerParameters&) {
  using P = TimeScorerParameters;
  return {{"speed_tag", &P::speedTag, "", "Metadata key of an edge: speed on the edge in m/s"},
          {"time_tag", &P::timeTag, "", "Metadata key of an edge: measured time in s"},
          {"max_vel", &P::maxVel, "m/s", "Speed on edges without a speed"},
          {"weight", &P::weight, "", "Weight of this cost"}};
}

Nav2Keys<PenaltyScorerParameters> keysOf(const PenaltyScorerParameters&) {
  using P = PenaltyScorerParameters;
  return {{"penalty_tag", &P::penaltyTag, "", "Metadata key of an edge: penalty"},
          {"weight", &P::weight, "", "Weight of this cost"}};
}

Nav2Keys<CostmapScorerParameters> keysOf(const CostmapScorerParameters&) {
  using P = CostmapScorerParameters;
  return {
      {"use_maximum", &P::useMaximum, "", "Uses the maximum cost on the edge instead of the mean"},
      {"invalid_on_collision", &P::invalidOnCollision, "", "Edges with a collision are not used"},
      {"invalid_off_map", &P::invalidOffMap, "", "Edges outside the map are not used"},
      {"max_cost", &P::maxCost, "", "Minimum cost of a cell in collision"},
      {"check_resolution", &P::checkResolution, "", "Step between checked cells"},
      {"costmap_topic", &P::costmapTopic, "", "Local or global costmap"},
      {"weight", &P::weight, "", "Weight of this cost"}};
}

Nav2Keys<SemanticScorerParameters> keysOf(const SemanticScorerParameters&) {
  using P = SemanticScorerParameters;
  return {{"semantic_key", &P::semanticKey, "",
           "Metadata key whose text is the class; empty: the keys are the classes"},
          {"semantic_classes", &P::semanticClasses, "",
           "Names of the classes, whose costs are keys of the same block"},
          {"weight", &P::weight, "", "Weight of this cost"}};
}

Nav2Keys<OrientationScorerParameters> keysOf(const OrientationScorerParameters&) {
  using P = OrientationScorerParameters;
  return {{"orientation_tolerance", &P::orientationTolerance, "rad", "Maximum heading difference"},
          {"orientation_weight", &P::orientationWeight, "", "Cost per radian"},
          {"use_orientation_threshold", &P::useOrientationThreshold, "",
           "Edges beyond the tolerance are not used"}};
}

Nav2Keys<DynamicEdgesParameters> keysOf(const DynamicEdgesParameters&) {
  return {};
}

Nav2Keys<AdjustSpeedLimitParameters> keysOf(const AdjustSpeedLimitParameters&) {
  using P = AdjustSpeedLimitParameters;
  return {{"speed_tag", &P::speedTag, "", "Metadata key of an edge: percentage of the speed"}};
}

Nav2Keys<RouteCollisionParameters> keysOf(const RouteCollisionParameters&) {
  using P = RouteCollisionParameters;
  return {{"rate", &P::rate, "Hz", "Rate of the checks"},
          {"max_cost", &P::maxCost, "", "Minimum cost of a cell in collision"},
          {"check_resolution", &P::checkResolution, "", "Step between checked cells"},
          {"max_collision_dist", &P::maxCollisionDist, "m",
           "Length of the route ahead that is checked"},
          {"reroute_on_collision", &P::rerouteOnCollision, "",
           "Computes another route; otherwise the operation fails"},
          {"costmap_topic", &P::costmapTopic, "", "Local or global costmap"}};
}

Nav2Keys<TimeMarkerParameters> keysOf(const TimeMarkerParameters&) {
  using P = TimeMarkerParameters;
  return {
      {"time_tag", &P::timeTag, "", "Metadata key of an edge in which the time in s is stored"}};
}

Nav2Keys<ReroutingServiceParameters> keysOf(const ReroutingServiceParameters&) {
  return {};
}

Nav2Keys<TriggerEventParameters> keysOf(const TriggerEventParameters&) {
  using P = TriggerEventParameters;
  return {{"service_name", &P::serviceName, "",
           "Event for nodes and edges whose graph file names none"}};
}

PluginClasses<EdgeScorerSettings> edgeScorerClasses() {
  OrientationScorerParameters ofGoal;
  ofGoal.isOfGoal = true;
  return {{"nav2_route::DistanceScorer", DistanceScorerParameters()},
          {"nav2_route::TimeScorer", TimeScorerParameters()},
          {"nav2_route::PenaltyScorer", PenaltyScorerParameters()},
          {"nav2_route::CostmapScorer", CostmapScorerParameters()},
          {"nav2_route::SemanticScorer", SemanticScorerParameters()},
          {"nav2_route::StartPoseOrientationScorer", OrientationScorerParameters()},
          {"nav2_route::GoalOrientationScorer", ofGoal},
          {"nav2_route::GoalPoseOrientationScorer", ofGoal},
          {"nav2_route::DynamicEdgesScorer", DynamicEdgesParameters()}};
}

PluginClasses<RouteOperationSettings> routeOperationClasses() {
  return {{"nav2_route::AdjustSpeedLimit", AdjustSpeedLimitParameters()},
          {"nav2_route::CollisionMonitor", RouteCollisionParameters()},
          {"nav2_route::TimeMarker", TimeMarkerParameters()},
          {"nav2_route::ReroutingService", ReroutingServiceParameters()},
          {"nav2_route::TriggerEvent", TriggerEventParameters()}};
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
