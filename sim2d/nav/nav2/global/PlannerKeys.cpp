#include "sim2d/nav/nav2/global/PlannerParameters.h"

/// The keys of the global planners and of planner_server.
namespace sim2d::nav2 {
namespace {

template <class Parameters>
void addSmacKeys(std::vector<Nav2Key<Parameters>>& keys) {
  using P = Parameters;
  const std::vector<Nav2Key<P>> common = {
      {"downsample_costmap", &P::downsampleCostmap, "", "plan on a coarser map"},
      {"downsampling_factor", &P::downsamplingFactor, "", "cells of the map along one of that"},
      {"allow_unknown", &P::allowUnknown, "", "through unknown cells"},
      {"max_iterations", &P::maxIterations, "", "nodes expanded at most; none from 0 down"},
      {"max_on_approach_iterations", &P::maxOnApproachIterations, "",
       "nodes expanded at most once the goal is within the tolerance"},
      {"terminal_checking_interval", &P::terminalCheckingInterval, "",
       "nodes between two looks whether to stop", kSinceJazzy},
      {"smoother.tolerance", &P::smootherTolerance, "m", "changes of a sweep that end smoothing"},
      {"smoother.max_iterations", &P::smootherMaxIterations, "", "sweeps of the smoother at most"},
      {"smoother.w_data", &P::smootherWData, "", "pull to the path as it was"},
      {"smoother.w_smooth", &P::smootherWSmooth, "", "pull to the middle of the neighbours"},
      {"smoother.do_refinement", &P::smootherDoRefinement, "", "smooth the result again"},
      {"smoother.refinement_num", &P::smootherRefinementNum, "", "how often", kSinceJazzy},
  };
  keys.insert(keys.end(), common.begin(), common.end());
}

}  // namespace

const std::vector<Nav2Key<NavfnParameters>>& keysOf(const NavfnParameters&) {
  using P = NavfnParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"tolerance", &P::tolerance, "m", "how far from the goal the path may end"},
      {"use_astar", &P::useAstar, "", "A* instead of Dijkstra"},
      {"allow_unknown", &P::allowUnknown, "", "through unknown cells"},
      {"use_final_approach_orientation", &P::useFinalApproachOrientation, "",
       "last heading along the path, not the goal's"},
      {"max_cycles_factor", &P::maxCyclesFactor, "",
       "steps of the descent per cell of the map's longer side", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<Nav2Key<ThetaStarParameters>>& keysOf(const ThetaStarParameters&) {
  using P = ThetaStarParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"how_many_corners", &P::howManyCorners, "", "neighbours of a cell, 4 or 8"},
      {"allow_unknown", &P::allowUnknown, "", "through unknown cells"},
      {"w_euc_cost", &P::eucCost, "", "weight of a path's length"},
      {"w_traversal_cost", &P::traversalCost, "", "weight of the costs under it"},
      {"use_final_approach_orientation", &P::useFinalApproachOrientation, "",
       "last heading along the path, not the goal's"},
      {"terminal_checking_interval", &P::terminalCheckingInterval, "",
       "nodes between two looks whether to stop", kSinceJazzy},
  };
  return kKeys;
}

const std::vector<Nav2Key<Smac2DParameters>>& keysOf(const Smac2DParameters&) {
  using P = Smac2DParameters;
  static const std::vector<Nav2Key<P>> kKeys = [] {
    std::vector<Nav2Key<P>> keys = {
        {"tolerance", &P::tolerance, "m", "how far from the goal the path may end"},
        {"max_planning_time", &P::maxPlanningTime, "s", "a limit of a million nodes a second here"},
        {"cost_travel_multiplier", &P::costTravelMultiplier, "",
         "weight of a cell's cost against its length"},
        {"use_final_approach_orientation", &P::useFinalApproachOrientation, "",
         "last heading along the path, not the goal's"},
    };
    addSmacKeys(keys);
    return keys;
  }();
  return kKeys;
}

const std::vector<Nav2Key<SmacHybridParameters>>& keysOf(const SmacHybridParameters&) {
  using P = SmacHybridParameters;
  static const std::vector<Nav2Key<P>> kKeys = [] {
    std::vector<Nav2Key<P>> keys = {
        {"tolerance", &P::tolerance, "m", "how far from the goal the path may end"},
        {"max_planning_time", &P::maxPlanningTime, "s", "a limit of 100 000 nodes a second here"},
        {"motion_model_for_search", &P::motionModelForSearch, "", "DUBIN or REEDS_SHEPP"},
        {"minimum_turning_radius", &P::minimumTurningRadius, "m", "of the car"},
        {"angle_quantization_bins", &P::angleQuantizationBins, "", "headings of the search"},
        {"allow_primitive_interpolation", &P::allowPrimitiveInterpolation, "",
         "steps of every angle up to the sharpest", kSinceJazzy},
        {"smooth_path", &P::smoothPath, "", "smooth the path that was found"},
        {"reverse_penalty", &P::reversePenalty, "", "factor for steps backward"},
        {"change_penalty", &P::changePenalty, "", "added to the next where the turn changes"},
        {"non_straight_penalty", &P::nonStraightPenalty, "", "factor for turning"},
        {"cost_penalty", &P::costPenalty, "", "weight of the cells' costs"},
        {"retrospective_penalty", &P::retrospectivePenalty, "",
         "share of length that early steps seem shorter"},
        {"use_quadratic_cost_penalty", &P::useQuadraticCostPenalty, "", "costs count squared",
         kSinceJazzy},
        {"cache_obstacle_heuristic", &P::cacheObstacleHeuristic, "",
         "keep the distances to a goal although the map changes"},
        {"downsample_obstacle_heuristic", &P::downsampleObstacleHeuristic, "",
         "those distances on a coarser map", kSinceJazzy},
        {"lookup_table_size", &P::lookupTableSize, "m",
         "side of the square about the goal where lengths of curves count"},
        {"analytic_expansion_ratio", &P::analyticExpansionRatio, "",
         "how seldom a curve to the goal is tried"},
        {"analytic_expansion_max_length", &P::analyticExpansionMaxLength, "m", "of such a curve"},
        {"analytic_expansion_max_cost", &P::analyticExpansionMaxCost, "",
         "cost that it may enter only for good", kSinceJazzy},
        {"analytic_expansion_max_cost_override", &P::analyticExpansionMaxCostOverride, "",
         "but not when it is shorter than a circle", kSinceJazzy},
        {"goal_heading_mode", &P::goalHeadingMode, "", "DEFAULT, BIDIRECTIONAL or ALL_DIRECTION",
         kSinceKilted},
        {"coarse_search_resolution", &P::coarseSearchResolution, "",
         "of the goal's headings only every so many are tried first", kSinceKilted},
    };
    addSmacKeys(keys);
    return keys;
  }();
  return kKeys;
}

const std::vector<Nav2Key<SmacLatticeParameters>>& keysOf(const SmacLatticeParameters&) {
  using P = SmacLatticeParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"tolerance", &P::tolerance, "m", "how far from the goal the path may end"},
      {"max_planning_time", &P::maxPlanningTime, "s", "a limit of 100 000 nodes a second here"},
      {"lattice_filepath", &P::latticeFilepath, "", "file of the motion primitives (JSON)"},
      {"allow_reverse_expansion", &P::allowReverseExpansion, "", "primitives also backward"},
      {"smooth_path", &P::smoothPath, "", "smooth the path that was found"},
      {"reverse_penalty", &P::reversePenalty, "", "factor for primitives backward"},
      {"change_penalty", &P::changePenalty, "", "added to the next where the turn changes"},
      {"non_straight_penalty", &P::nonStraightPenalty, "", "factor for turning"},
      {"rotation_penalty", &P::rotationPenalty, "", "cost of a turn on the spot"},
      {"cost_penalty", &P::costPenalty, "", "weight of the cells' costs"},
      {"retrospective_penalty", &P::retrospectivePenalty, "",
       "share of length that early primitives seem shorter"},
      {"use_quadratic_cost_penalty", &P::useQuadraticCostPenalty, "", "costs count squared",
       kSinceLyrical},
      {"cache_obstacle_heuristic", &P::cacheObstacleHeuristic, "",
       "keep the distances to a goal although the map changes"},
      {"downsample_obstacle_heuristic", &P::downsampleObstacleHeuristic, "",
       "those distances on a coarser map", kSinceLyrical},
      {"analytic_expansion_ratio", &P::analyticExpansionRatio, "",
       "how seldom a curve to the goal is tried"},
      {"analytic_expansion_max_length", &P::analyticExpansionMaxLength, "m", "of such a curve"},
      {"analytic_expansion_max_cost", &P::analyticExpansionMaxCost, "",
       "cost that it may enter only for good", kSinceJazzy},
      {"analytic_expansion_max_cost_override", &P::analyticExpansionMaxCostOverride, "",
       "but not when it is shorter than a circle", kSinceJazzy},
      {"goal_heading_mode", &P::goalHeadingMode, "", "DEFAULT, BIDIRECTIONAL or ALL_DIRECTION",
       kSinceKilted},
      {"allow_unknown", &P::allowUnknown, "", "through unknown cells"},
      {"max_iterations", &P::maxIterations, "", "nodes expanded at most; none from 0 down"},
      {"max_on_approach_iterations", &P::maxOnApproachIterations, "",
       "nodes expanded at most once the goal is within the tolerance"},
      {"terminal_checking_interval", &P::terminalCheckingInterval, "",
       "nodes between two looks whether to stop", kSinceJazzy},
      {"smoother.tolerance", &P::smootherTolerance, "m", "changes of a sweep that end smoothing"},
      {"smoother.max_iterations", &P::smootherMaxIterations, "", "sweeps of the smoother at most"},
      {"smoother.w_data", &P::smootherWData, "", "pull to the path as it was"},
      {"smoother.w_smooth", &P::smootherWSmooth, "", "pull to the middle of the neighbours"},
      {"smoother.do_refinement", &P::smootherDoRefinement, "", "smooth the result again"},
      {"smoother.refinement_num", &P::smootherRefinementNum, "", "how often", kSinceJazzy},
  };
  return kKeys;
}

const std::vector<Nav2Key<PlannerServerParameters>>& keysOf(const PlannerServerParameters&) {
  using P = PlannerServerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"planner_plugins", &P::plannerPlugins, "", "names of the planners"},
      {"allow_partial_planning", &P::allowPartialPlanning, "",
       "through several goals as far as there is a path", kSinceLyrical},
      {"costmap_update_timeout", &P::costmapUpdateTimeout, "s",
       "so long it waits for the costmap after a clear", kSinceJazzy},
  };
  return kKeys;
}

const std::vector<IdleKey>& idleKeysOf(const NavfnParameters&) {
  static const std::vector<IdleKey> kKeys = {
      {"terminal_checking_interval", "the wave looks every 256 blocks whether to stop"}};
  return kKeys;
}

const std::vector<IdleKey>& idleKeysOf(const ThetaStarParameters&) {
  static const std::vector<IdleKey> kKeys = {
      {"w_heuristic_cost", "Nav2 takes the lesser of 1 and w_euc_cost"}};
  return kKeys;
}

const std::vector<IdleKey>& idleKeysOf(const Smac2DParameters&) {
  static const std::vector<IdleKey> kKeys = {
      {"motion_model_for_search", "cells have eight neighbours"},
      {"debug_visualizations", "nothing is published"},
  };
  return kKeys;
}

const std::vector<IdleKey>& idleKeysOf(const SmacHybridParameters&) {
  static const std::vector<IdleKey> kKeys = {
      {"viz_expansions", "nothing is published"},
      {"debug_visualizations", "nothing is published"},
  };
  return kKeys;
}

const std::vector<IdleKey>& idleKeysOf(const SmacLatticeParameters&) {
  static const std::vector<IdleKey> kKeys = {
      {"debug_visualizations", "nothing is published", kSinceJazzy},
      {"lookup_table_size", "lengths of curves are computed when they are needed"},
      {"coarse_search_resolution", "each heading of the goal is tried", kSinceKilted},
  };
  return kKeys;
}

const std::vector<IdleKey>& idleKeysOf(const PlannerServerParameters&) {
  static const std::vector<IdleKey> kKeys = {
      {"expected_planner_frequency", "only a warning of slow computers hangs on it"},
      {"action_server_result_timeout", "no action servers here", kJazzy},
      {"bond_heartbeat_period", "no processes that could die"},
      {"service_introspection_mode", "no services here"},
      {"introspection_mode", "no services here"},
  };
  return kKeys;
}

}  // namespace sim2d::nav2
