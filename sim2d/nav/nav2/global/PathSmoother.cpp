#include "sim2d/nav/nav2/global/PathSmoother.h"

#include <cassert>

#include "sim2d/nav/nav2/global/ConstrainedSmoother.h"
#include "sim2d/nav/nav2/global/GlobalPlannerFactory.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"
#include "sim2d/nav/nav2/global/SavitzkyGolaySmoother.h"
#include "sim2d/nav/nav2/global/SmoothingSweeps.h"

namespace sim2d::nav2 {
namespace {

struct SmoothErrorText {
  SmoothError error;
  const char* name;
  const char* message;
};

constexpr SmoothErrorText kSmoothErrors[] = {
    {SmoothError::None, "NONE", ""},
    {SmoothError::Unknown, "UNKNOWN", "smoothing failed"},
    {SmoothError::InvalidSmoother, "INVALID_SMOOTHER", "there is no such smoother"},
    {SmoothError::Timeout, "TIMEOUT", "smoothing took too long"},
    {SmoothError::SmoothedPathInCollision, "SMOOTHED_PATH_IN_COLLISION",
     "the smoothed path collides"},
    {SmoothError::FailedToSmoothPath, "FAILED_TO_SMOOTH_PATH", "the path could not be smoothed"},
    {SmoothError::InvalidPath, "INVALID_PATH", "there is no path to smooth"},
};

const SmoothErrorText& textOf(SmoothError error) {
  for (const SmoothErrorText& text : kSmoothErrors) {
    if (text.error == error) {
      return text;
    }
  }
  return kSmoothErrors[1];
}

constexpr char kSimple[] = "nav2_smoother::SimpleSmoother";
constexpr char kSavitzkyGolay[] = "nav2_smoother::SavitzkyGolaySmoother";

constexpr char kConstrained[] = "nav2_constrained_smoother::ConstrainedSmoother";

}  // namespace

const char* smoothErrorName(SmoothError error) {
  return textOf(error).name;
}

const char* smoothErrorMessage(SmoothError error) {
  return textOf(error).message;
}

const std::vector<Nav2Key<SimpleSmootherParameters>>& keysOf(const SimpleSmootherParameters&) {
  using P = SimpleSmootherParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"tolerance", &P::tolerance, "m", "total change in an iteration below which smoothing ends"},
      {"max_its", &P::maxIts, "", "maximum number of iterations"},
      {"w_data", &P::wData, "", "weight of the attraction to the original path"},
      {"w_smooth", &P::wSmooth, "",
       "weight of the attraction to the midpoint of the neighbouring "
       "poses"},
      {"do_refinement", &P::doRefinement, "", "smooths the result again"},
      {"refinement_num", &P::refinementNum, "", "number of repetitions of the refinement",
       kSinceJazzy},
      {"enforce_path_inversion", &P::enforcePathInversion, "",
       "smooths separately between the cusps of the path", kSinceKilted},
  };
  return kKeys;
}

const std::vector<Nav2Key<SavitzkyGolayParameters>>& keysOf(const SavitzkyGolayParameters&) {
  using P = SavitzkyGolayParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"do_refinement", &P::doRefinement, "", "smooths the result again"},
      {"refinement_num", &P::refinementNum, "", "number of repetitions of the refinement"},
      {"enforce_path_inversion", &P::enforcePathInversion, "",
       "smooths separately between the cusps of the path", kSinceKilted},
      {"window_size", &P::windowSize, "", "number of poses per polynomial", kSinceLyrical},
      {"poly_order", &P::polyOrder, "", "order of the polynomial", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<Nav2Key<ConstrainedSmootherParameters>>& keysOf(
    const ConstrainedSmootherParameters&) {
  using P = ConstrainedSmootherParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"reversing_enabled", &P::reversingEnabled, "",
       "poses whose heading opposes the motion are driven backwards"},
      {"path_downsampling_factor", &P::pathDownsamplingFactor, "",
       "one of this number of poses is optimized"},
      {"path_upsampling_factor", &P::pathUpsamplingFactor, "",
       "number of poses in the result per optimized pose"},
      {"keep_goal_orientation", &P::keepGoalOrientation, "", "keeps the heading of the last pose"},
      {"keep_start_orientation", &P::keepStartOrientation, "",
       "keeps the heading of the first pose"},
      {"minimum_turning_radius", &P::minimumTurningRadius, "m",
       "arcs with a smaller radius have a cost"},
      {"w_curve", &P::wCurve, "", "weight of arcs whose radius is too small"},
      {"w_dist", &P::wDist, "", "weight of the distance from the original path"},
      {"w_smooth", &P::wSmooth, "", "weight of the differences between neighbouring segments"},
      {"w_cost", &P::wCost, "", "weight of the costs in the costmap"},
      {"w_cost_cusp_multiplier", &P::wCostCuspMultiplier, "",
       "factor of the costmap's weight at a cusp"},
      {"cusp_zone_length", &P::cuspZoneLength, "m",
       "length around a cusp in which that factor applies"},
      {"cost_check_points", &P::costCheckPoints, "",
       "points of the robot at which costs are evaluated: x, y, weight of each; none: its centre"},
      {"optimizer.max_iterations", &P::maxIterations, "", "maximum number of iterations"},
      {"optimizer.fn_tol", &P::fnTol, "",
       "relative change of the cost below which the optimization ends"},
      {"optimizer.gradient_tol", &P::gradientTol, "", "gradient below which the optimization ends"},
      {"optimizer.param_tol", &P::paramTol, "",
       "relative change of the path below which the optimization ends"},
  };
  return kKeys;
}

const std::vector<Nav2Key<SmootherServerParameters>>& keysOf(const SmootherServerParameters&) {
  using P = SmootherServerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"smoother_plugins", &P::smootherPlugins, "", "names of the smoothers"},
  };
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredKeysOf(const SimpleSmootherParameters&) {
  static const std::vector<IgnoredKey> kKeys;
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredKeysOf(const SavitzkyGolayParameters&) {
  static const std::vector<IgnoredKey> kKeys;
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredKeysOf(const ConstrainedSmootherParameters&) {
  static const std::vector<IgnoredKey> kKeys = {
      {"optimizer.debug_optimizer", "the log is not used"},
      {"optimizer.linear_solver_type", "the equations are always solved by Cholesky decomposition"},
  };
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredKeysOf(const SmootherServerParameters&) {
  static const std::vector<IgnoredKey> kKeys = {
      {"costmap_topic", "the global costmap is passed directly"},
      {"footprint_topic", "the footprint is passed directly"},
      {"robot_base_frame", "TF is not used"},
      {"transform_tolerance", "TF is not used"},
      {"action_server_result_timeout", "ROS actions are not used", kJazzy},
      {"bond_heartbeat_period", "there are no separate processes to monitor"},
      {"introspection_mode", "ROS services are not used"},
  };
  return kKeys;
}

std::vector<std::string> pathSmootherPluginNames() {
  return {kSimple, kSavitzkyGolay, kConstrained};
}

PluginLookup<PathSmootherParameters> pathSmootherPlugin(const std::string& className,
                                                        Distro distro) {
  const PluginMatch match = matchPlugin(className, pathSmootherPluginNames(), {});
  PluginLookup<PathSmootherParameters> lookup{std::nullopt, match.name, match.why};
  if (match.isAvailable && match.name == kSimple) {
    SimpleSmootherParameters parameters;
    parameters.refinementNum = distro == Distro::Humble ? 4 : parameters.refinementNum;
    lookup.parameters = parameters;
  } else if (match.isAvailable && match.name == kSavitzkyGolay) {
    lookup.parameters = SavitzkyGolayParameters();
  } else if (match.isAvailable) {
    lookup.parameters = ConstrainedSmootherParameters();
  }
  return lookup;
}

std::vector<std::string> parameterErrors(const PathSmootherParameters& parameters) {
  if (const auto* simple = std::get_if<SimpleSmootherParameters>(&parameters)) {
    return ValueErrors()
        .range("tolerance", simple->tolerance, 0.0, 1000.0)
        .range("max_its", simple->maxIts, 1.0, 1e6)
        .range("w_data", simple->wData, 0.0, 1.0)
        .range("w_smooth", simple->wSmooth, 0.0, 0.5)
        .range("refinement_num", simple->refinementNum, 0.0, 1000.0)
        .take();
  }
  if (const auto* constrained = std::get_if<ConstrainedSmootherParameters>(&parameters)) {
    return ValueErrors()
        .range("path_downsampling_factor", constrained->pathDownsamplingFactor, 1.0, 1000.0)
        .range("path_upsampling_factor", constrained->pathUpsamplingFactor, 1.0, 100.0)
        .require(constrained->minimumTurningRadius > 0.0, "minimum_turning_radius is not above 0")
        .require(constrained->cuspZoneLength > 0.0, "cusp_zone_length is not above 0")
        .require(constrained->costCheckPoints.size() % 3 == 0,
                 "cost_check_points is not a list of x, y, weight")
        .range("optimizer.max_iterations", constrained->maxIterations, 1.0, 10000.0)
        .take();
  }
  const auto& given = std::get<SavitzkyGolayParameters>(parameters);
  return ValueErrors()
      .range("refinement_num", given.refinementNum, 0.0, 1000.0)
      .range("window_size", given.windowSize, 3.0, 201.0)
      .require(given.windowSize % 2 == 1, "window_size is even")
      .range("poly_order", given.polyOrder, 0.0, given.windowSize - 1.0)
      .take();
}

std::unique_ptr<PathSmoother> makePathSmoother(const PathSmootherParameters& parameters,
                                               Distro distro) {
  assert(parameterErrors(parameters).empty());
  if (const auto* simple = std::get_if<SimpleSmootherParameters>(&parameters)) {
    return std::make_unique<SimpleSmoother>(*simple, distro);
  }
  if (const auto* constrained = std::get_if<ConstrainedSmootherParameters>(&parameters)) {
    return std::make_unique<ConstrainedSmoother>(*constrained);
  }
  return std::make_unique<SavitzkyGolaySmoother>(std::get<SavitzkyGolayParameters>(parameters),
                                                 distro);
}

}  // namespace sim2d::nav2
