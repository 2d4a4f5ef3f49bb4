#include "sim2d/nav/nav2/global/PlannerParameters.h"

#include <algorithm>

#include "sim2d/base/Text.h"

/// The keys of the global planners and of planner_server.
namespace sim2d::nav2 {
namespace {

Nav2Keys<SmacParameters> downsamplingKeys() {
  using P = SmacParameters;
  return {{"downsample_costmap", &P::downsampleCostmap, "", "plans on a coarser map"},
          {"downsampling_factor", &P::downsamplingFactor, "",
           "number of map cells along the side of a coarser cell"}};
}

Nav2Keys<SmacParameters> searchAndSmootherKeys() {
  using P = SmacParameters;
  return {
      {"allow_unknown", &P::allowUnknown, "", "allows paths through unknown cells"},
      {"max_iterations", &P::maxIterations, "",
       "maximum number of expanded nodes; 0 or less: no limit"},
      {"max_on_approach_iterations", &P::maxOnApproachIterations, "",
       "maximum number of expanded nodes after the goal is within the tolerance"},
      {"terminal_checking_interval", &P::terminalCheckingInterval, "",
       "number of nodes between two checks for cancellation", kSinceJazzy},
      {"smoother.tolerance", &P::smootherTolerance, "m",
       "total change in an iteration below which smoothing ends"},
      {"smoother.max_iterations", &P::smootherMaxIterations, "",
       "maximum number of iterations of the smoother"},
      {"smoother.w_data", &P::smootherWData, "", "weight of the attraction to the original path"},
      {"smoother.w_smooth", &P::smootherWSmooth, "",
       "weight of the attraction to the midpoint of the neighbouring poses"},
      {"smoother.do_refinement", &P::smootherDoRefinement, "", "smooths the result again"},
      {"smoother.refinement_num", &P::smootherRefinementNum, "",
       "number of repetitions of the refinement", kSinceJazzy},
  };
}

Nav2Keys<SmacPoseParameters> poseLimitKeys() {
  using P = SmacPoseParameters;
  return {
      {"tolerance", &P::tolerance, "m", "maximum distance from the goal to the end of the path"},
      {"max_planning_time", &P::maxPlanningTime, "s",
       "time limit, replaced by a limit of 100 000 nodes per second"}};
}

Nav2Keys<SmacPoseParameters> motionPenaltyKeys() {
  using P = SmacPoseParameters;
  return {
      {"smooth_path", &P::smoothPath, "", "smooths the path"},
      {"reverse_penalty", &P::reversePenalty, "", "cost factor of backward primitives"},
      {"change_penalty", &P::changePenalty, "", "cost of a change of the turning direction"},
      {"non_straight_penalty", &P::nonStraightPenalty, "", "cost factor of primitives that turn"}};
}

/// `later`: the branches that have the newer two of these keys.
Nav2Keys<SmacPoseParameters> costKeys(unsigned later) {
  using P = SmacPoseParameters;
  return {
      {"cost_penalty", &P::costPenalty, "", "weight of the cells' costs"},
      {"retrospective_penalty", &P::retrospectivePenalty, "",
       "share by which the length of early primitives is reduced"},
      {"use_quadratic_cost_penalty", &P::useQuadraticCostPenalty, "", "uses squared costs", later},
      {"cache_obstacle_heuristic", &P::cacheObstacleHeuristic, "",
       "keeps the obstacle heuristic of a goal when the map changes"},
      {"downsample_obstacle_heuristic", &P::downsampleObstacleHeuristic, "",
       "computes the obstacle heuristic on a coarser map", later}};
}

Nav2Keys<SmacPoseParameters> expansionKeys() {
  using P = SmacPoseParameters;
  return {{"analytic_expansion_ratio", &P::analyticExpansionRatio, "",
           "larger values try the analytic expansion to the goal less often"},
          {"analytic_expansion_max_length", &P::analyticExpansionMaxLength, "m",
           "maximum length of the analytic expansion"},
          {"analytic_expansion_max_cost", &P::analyticExpansionMaxCost, "",
           "maximum cost in the analytic expansion, which may exceed it only in its last part",
           kSinceJazzy},
          {"analytic_expansion_max_cost_override", &P::analyticExpansionMaxCostOverride, "",
           "ignores that maximum cost if the expansion is shorter than a full circle", kSinceJazzy},
          {"goal_heading_mode", &P::goalHeadingMode, "", "DEFAULT, BIDIRECTIONAL or ALL_DIRECTION",
           kSinceKilted}};
}

}  // namespace

Nav2Keys<NavfnParameters> keysOf(const NavfnParameters&) {
  using P = NavfnParameters;
  return {
      {"tolerance", &P::tolerance, "m", "maximum distance from the goal to the end of the path"},
      {"use_astar", &P::useAstar, "", "A* instead of Dijkstra"},
      {"allow_unknown", &P::allowUnknown, "", "allows paths through unknown cells"},
      {"use_final_approach_orientation", &P::useFinalApproachOrientation, "",
       "the last heading is that of the path, not of the goal"},
      {"max_cycles_factor", &P::maxCyclesFactor, "",
       "steps of the descent per cell of the map's longer side", kSinceLyrical},
  };
}

Nav2Keys<ThetaStarParameters> keysOf(const ThetaStarParameters&) {
  using P = ThetaStarParameters;
  return {
      {"how_many_corners", &P::howManyCorners, "", "number of neighbours of a cell, 4 or 8"},
      {"allow_unknown", &P::allowUnknown, "", "allows paths through unknown cells"},
      {"w_euc_cost", &P::eucCost, "", "weight of the path length"},
      {"w_traversal_cost", &P::traversalCost, "", "weight of the costs of its cells"},
      {"use_final_approach_orientation", &P::useFinalApproachOrientation, "",
       "the last heading is that of the path, not of the goal"},
      {"terminal_checking_interval", &P::terminalCheckingInterval, "",
       "number of nodes between two checks for cancellation", kSinceJazzy},
  };
}

Nav2Keys<Smac2DParameters> keysOf(const Smac2DParameters&) {
  using P = Smac2DParameters;
  return joinedKeys<P>(
      Nav2Keys<P>{{"tolerance", &P::tolerance, "m",
                   "maximum distance from the goal to the end of the path"},
                  {"max_planning_time", &P::maxPlanningTime, "s",
                   "time limit, replaced by a limit of 1 000 000 nodes per second"},
                  {"cost_travel_multiplier", &P::costTravelMultiplier, "",
                   "weight of a cell's cost relative to its length"},
                  {"use_final_approach_orientation", &P::useFinalApproachOrientation, "",
                   "the last heading is that of the path, not of the goal"}},
      downsamplingKeys(), searchAndSmootherKeys());
}

Nav2Keys<SmacHybridParameters> keysOf(const SmacHybridParameters&) {
  using P = SmacHybridParameters;
  return joinedKeys<P>(
      poseLimitKeys(),
      Nav2Keys<P>{{"motion_model_for_search", &P::motionModelForSearch, "", "DUBIN or REEDS_SHEPP"},
                  {"minimum_turning_radius", &P::minimumTurningRadius, "m",
                   "minimum turning radius of the robot"},
                  {"angle_quantization_bins", &P::angleQuantizationBins, "",
                   "number of headings in the search"},
                  {"allow_primitive_interpolation", &P::allowPrimitiveInterpolation, "",
                   "adds primitives for all angles up to the sharpest one", kSinceJazzy}},
      motionPenaltyKeys(), costKeys(kSinceJazzy),
      Nav2Keys<P>{
          {"lookup_table_size", &P::lookupTableSize, "m",
           "side length of the square around the goal in which the distance heuristic uses curve "
           "lengths"}},
      expansionKeys(),
      Nav2Keys<P>{{"coarse_search_resolution", &P::coarseSearchResolution, "",
                   "step between the goal headings that are tried first", kSinceKilted}},
      downsamplingKeys(), searchAndSmootherKeys());
}

Nav2Keys<SmacLatticeParameters> keysOf(const SmacLatticeParameters&) {
  using P = SmacLatticeParameters;
  return joinedKeys<P>(
      poseLimitKeys(),
      Nav2Keys<P>{
          {"lattice_filepath", &P::latticeFilepath, "", "file of the motion primitives (JSON)"},
          {"allow_reverse_expansion", &P::allowReverseExpansion, "",
           "also uses backward primitives"}},
      motionPenaltyKeys(),
      Nav2Keys<P>{{"rotation_penalty", &P::rotationPenalty, "", "cost of rotation in place"}},
      costKeys(kSinceLyrical), expansionKeys(), searchAndSmootherKeys());
}

Nav2Keys<PlannerServerParameters> keysOf(const PlannerServerParameters&) {
  using P = PlannerServerParameters;
  return {
      {"planner_plugins", &P::plannerPlugins, "", "names of the planners"},
      {"allow_partial_planning", &P::allowPartialPlanning, "",
       "plans through several goals as far as a path exists", kSinceLyrical},
      {"costmap_update_timeout", &P::costmapUpdateTimeout, "s",
       "maximum wait for the costmap after it was cleared", kSinceJazzy},
  };
}

IgnoredKeys ignoredKeysOf(const NavfnParameters&) {
  return {{"terminal_checking_interval", "cancellation is checked every 256 blocks"}};
}

IgnoredKeys ignoredKeysOf(const ThetaStarParameters&) {
  return {{"w_heuristic_cost", "Nav2 uses the minimum of 1 and w_euc_cost"}};
}

IgnoredKeys ignoredKeysOf(const Smac2DParameters&) {
  return {
      {"motion_model_for_search", "cells have eight neighbours"},
      {"debug_visualizations", "nothing is published"},
  };
}

IgnoredKeys ignoredKeysOf(const SmacHybridParameters&) {
  return {
      {"viz_expansions", "nothing is published"},
      {"debug_visualizations", "nothing is published", kSinceJazzy},
  };
}

IgnoredKeys ignoredKeysOf(const SmacLatticeParameters&) {
  return {
      {"debug_visualizations", "nothing is published", kSinceJazzy},
      {"lookup_table_size", "curve lengths are computed on demand"},
      {"coarse_search_resolution", "every heading of the goal is tried", kSinceKilted},
  };
}

IgnoredKeys ignoredKeysOf(const PlannerServerParameters&) {
  return {
      {"expected_planner_frequency", "it only affects a warning on slow computers"},
  };
}

namespace {

constexpr double kFarTolerance = 100.0;  // [m]
constexpr double kMaxWeight = 1e6;       // of a cost
constexpr double kMaxCount = 2147483647.0;

void addSmacErrors(const SmacParameters& given, ValueErrors& errors) {
  errors.range("downsampling_factor", given.downsamplingFactor, 1.0, 1000.0)
      .range("terminal_checking_interval", given.terminalCheckingInterval, 1.0, kMaxCount)
      .range("smoother.max_iterations", given.smootherMaxIterations, 0.0, 1e6)
      .range("smoother.w_data", given.smootherWData, 0.0, 1.0)
      .range("smoother.w_smooth", given.smootherWSmooth, 0.0, 0.5)
      .range("smoother.tolerance", given.smootherTolerance, 0.0, kFarTolerance)
      .range("smoother.refinement_num", given.smootherRefinementNum, 0.0, 1000.0);
}

}  // namespace

ValueErrors& ValueErrors::range(const char* key, double value, double low, double high) {
  return require(value >= low && value <= high,
                 std::string(key) + " is " + base::formatDecimals(value, 0) + ", not " +
                     base::formatDecimals(low, 0) + " to " + base::formatDecimals(high, 0));
}

ValueErrors& ValueErrors::oneOf(const char* key, const std::string& value,
                                const std::vector<std::string>& allowed) {
  std::string names;
  for (const std::string& each : allowed) {
    names += (names.empty() ? "" : ", ") + each;
  }
  return require(std::find(allowed.begin(), allowed.end(), value) != allowed.end(),
                 std::string(key) + " is '" + value + "', not one of " + names);
}

ValueErrors& ValueErrors::require(bool isGood, std::string sentence) {
  if (!isGood) {
    messages_.push_back(std::move(sentence));
  }
  return *this;
}

std::vector<std::string> plannerErrors(const NavfnParameters& parameters) {
  return ValueErrors()
      .range("tolerance", parameters.tolerance, 0.0, kFarTolerance)
      .range("max_cycles_factor", parameters.maxCyclesFactor, 1.0, 10000.0)
      .take();
}

std::vector<std::string> plannerErrors(const ThetaStarParameters& parameters) {
  const int corners = parameters.howManyCorners;
  return ValueErrors()
      .require(corners == 4 || corners == 8,
               "how_many_corners is " + std::to_string(corners) + ", not 4 or 8")
      .range("w_euc_cost", parameters.eucCost, 0.0, kMaxWeight)
      .range("w_traversal_cost", parameters.traversalCost, 0.0, kMaxWeight)
      .range("terminal_checking_interval", parameters.terminalCheckingInterval, 1.0, kMaxCount)
      .take();
}

std::vector<std::string> plannerErrors(const Smac2DParameters& parameters) {
  ValueErrors errors;
  errors.range("tolerance", parameters.tolerance, 0.0, kFarTolerance)
      .range("max_planning_time", parameters.maxPlanningTime, 0.0, kMaxWeight)
      .range("cost_travel_multiplier", parameters.costTravelMultiplier, 0.0, kMaxWeight);
  addSmacErrors(parameters, errors);
  return errors.take();
}

namespace {

/// One of `hybrid` and `lattice` is null.
std::vector<std::string> poseErrors(const SmacPoseParameters& given,
                                    const SmacHybridParameters* hybrid,
                                    const SmacLatticeParameters* lattice) {
  ValueErrors errors;
  errors.range("tolerance", given.tolerance, 0.0, kFarTolerance)
      .range("max_planning_time", given.maxPlanningTime, 0.0, kMaxWeight);
  if (hybrid != nullptr) {
    errors.oneOf("motion_model_for_search", hybrid->motionModelForSearch, {"DUBIN", "REEDS_SHEPP"});
  }
  errors.oneOf("goal_heading_mode", given.goalHeadingMode,
               {"DEFAULT", "BIDIRECTIONAL", "ALL_DIRECTION"});
  if (hybrid != nullptr) {
    errors.range("minimum_turning_radius", hybrid->minimumTurningRadius, 0.0, kFarTolerance)
        .range("angle_quantization_bins", hybrid->angleQuantizationBins, 4.0, 720.0);
  }
  errors.range("reverse_penalty", given.reversePenalty, 0.0, kMaxWeight)
      .range("change_penalty", given.changePenalty, 0.0, kMaxWeight)
      .range("non_straight_penalty", given.nonStraightPenalty, 0.0, kMaxWeight);
  if (lattice != nullptr) {
    errors.range("rotation_penalty", lattice->rotationPenalty, 0.0, kMaxWeight);
  }
  errors.range("cost_penalty", given.costPenalty, 0.0, kMaxWeight)
      .range("retrospective_penalty", given.retrospectivePenalty, 0.0, 1.0);
  if (hybrid != nullptr) {
    errors.range("lookup_table_size", hybrid->lookupTableSize, 0.0, kMaxWeight);
  }
  errors.range("analytic_expansion_ratio", given.analyticExpansionRatio, 1e-3, kMaxWeight)
      .range("analytic_expansion_max_length", given.analyticExpansionMaxLength, 0.0, kMaxWeight)
      .range("analytic_expansion_max_cost", given.analyticExpansionMaxCost, 0.0, 255.0);
  if (hybrid != nullptr) {
    errors.range("coarse_search_resolution", hybrid->coarseSearchResolution, 1.0, 720.0);
  }
  addSmacErrors(given, errors);
  return errors.take();
}

}  // namespace

std::vector<std::string> plannerErrors(const SmacHybridParameters& parameters) {
  return poseErrors(parameters, &parameters, nullptr);
}

std::vector<std::string> plannerErrors(const SmacLatticeParameters& parameters) {
  return poseErrors(parameters, nullptr, &parameters);
}

}  // namespace sim2d::nav2
