#include "sim2d/nav/nav2/global/PathSmoother.h"

#include <cassert>

#include "sim2d/nav/nav2/global/ConstrainedSmoother.h"
#include "sim2d/nav/nav2/global/PlannerChecks.h"
#include "sim2d/nav/nav2/global/PluginNames.h"
#include "sim2d/nav/nav2/global/SavitzkyGolaySmoother.h"
#include "sim2d/nav/nav2/global/SimpleSmoother.h"

namespace sim2d::nav2 {
namespace {

struct SmoothErrorText {
  SmoothError error;
  const char* name;
  const char* words;
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

const char* smoothErrorWords(SmoothError error) {
  return textOf(error).words;
}

const std::vector<Nav2Key<SimpleSmootherParameters>>& keysOf(const SimpleSmootherParameters&) {
  using P = SimpleSmootherParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"tolerance", &P::tolerance, "m", "changes of a sweep that end smoothing"},
      {"max_its", &P::maxIts, "", "sweeps at most"},
      {"w_data", &P::wData, "", "pull to the path as it was"},
      {"w_smooth", &P::wSmooth, "", "pull to the middle of the neighbours"},
      {"do_refinement", &P::doRefinement, "", "smooth the result again"},
      {"refinement_num", &P::refinementNum, "", "how often", kSinceJazzy},
      {"enforce_path_inversion", &P::enforcePathInversion, "",
       "smooth between the places where the robot turns back", kSinceKilted},
  };
  return kKeys;
}

const std::vector<Nav2Key<SavitzkyGolayParameters>>& keysOf(const SavitzkyGolayParameters&) {
  using P = SavitzkyGolayParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"do_refinement", &P::doRefinement, "", "smooth the result again"},
      {"refinement_num", &P::refinementNum, "", "how often"},
      {"enforce_path_inversion", &P::enforcePathInversion, "",
       "smooth between the places where the robot turns back", kSinceKilted},
      {"window_size", &P::windowSize, "", "poses that a polynomial goes through", kSinceLyrical},
      {"poly_order", &P::polyOrder, "", "its order", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<Nav2Key<ConstrainedSmootherParameters>>& keysOf(
    const ConstrainedSmootherParameters&) {
  using P = ConstrainedSmootherParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"reversing_enabled", &P::reversingEnabled, "",
       "headings against the movement are driven backward"},
      {"path_downsampling_factor", &P::pathDownsamplingFactor, "", "of so many poses one is moved"},
      {"path_upsampling_factor", &P::pathUpsamplingFactor, "",
       "poses of the result for each of the path"},
      {"keep_goal_orientation", &P::keepGoalOrientation, "", "the last heading stays"},
      {"keep_start_orientation", &P::keepStartOrientation, "", "the first heading stays"},
      {"minimum_turning_radius", &P::minimumTurningRadius, "m", "smaller arcs have a cost"},
      {"w_curve", &P::wCurve, "", "weight of arcs that are too small"},
      {"w_dist", &P::wDist, "", "weight of the distance from the path as it was"},
      {"w_smooth", &P::wSmooth, "", "weight of differences between neighbouring stretches"},
      {"w_cost", &P::wCost, "", "weight of the costmap"},
      {"w_cost_cusp_multiplier", &P::wCostCuspMultiplier, "", "factor of that at a cusp"},
      {"cusp_zone_length", &P::cuspZoneLength, "m", "length around a cusp where it counts"},
      {"cost_check_points", &P::costCheckPoints, "",
       "points of the robot where costs count: x, y, weight, and so on; none: its centre"},
      {"optimizer.max_iterations", &P::maxIterations, "", "iterations at most"},
      {"optimizer.fn_tol", &P::fnTol, "", "relative change of the cost that ends it"},
      {"optimizer.gradient_tol", &P::gradientTol, "", "gradient that ends it"},
      {"optimizer.param_tol", &P::paramTol, "", "relative change of the path that ends it"},
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

const std::vector<IdleKey>& idleKeysOf(const SimpleSmootherParameters&) {
  static const std::vector<IdleKey> kKeys;
  return kKeys;
}

const std::vector<IdleKey>& idleKeysOf(const SavitzkyGolayParameters&) {
  static const std::vector<IdleKey> kKeys;
  return kKeys;
}

const std::vector<IdleKey>& idleKeysOf(const ConstrainedSmootherParameters&) {
  static const std::vector<IdleKey> kKeys = {
      {"optimizer.debug_optimizer", "no log here"},
      {"optimizer.linear_solver_type", "the equations are solved by Cholesky's method"},
  };
  return kKeys;
}

const std::vector<IdleKey>& idleKeysOf(const SmootherServerParameters&) {
  static const std::vector<IdleKey> kKeys = {
      {"costmap_topic", "the global costmap is handed over"},
      {"footprint_topic", "the footprint is handed over"},
      {"robot_base_frame", "no TF here"},
      {"transform_tolerance", "no TF here"},
      {"action_server_result_timeout", "no action servers here", kJazzy},
      {"bond_heartbeat_period", "no processes that could die"},
      {"introspection_mode", "no services here"},
  };
  return kKeys;
}

std::vector<std::string> pathSmootherPluginNames() {
  return {kSimple, kSavitzkyGolay, kConstrained};
}

PluginAnswer<PathSmootherParameters> pathSmootherPlugin(const std::string& className,
                                                        Distro distro) {
  const PluginMatch match = matchPlugin(className, pathSmootherPluginNames(), {});
  PluginAnswer<PathSmootherParameters> answer{std::nullopt, match.name, match.why};
  if (match.isOffered && match.name == kSimple) {
    SimpleSmootherParameters parameters;
    parameters.refinementNum = distro == Distro::Humble ? 4 : parameters.refinementNum;
    answer.parameters = parameters;
  } else if (match.isOffered && match.name == kSavitzkyGolay) {
    answer.parameters = SavitzkyGolayParameters();
  } else if (match.isOffered) {
    answer.parameters = ConstrainedSmootherParameters();
  }
  return answer;
}

std::vector<std::string> complaintsAbout(const PathSmootherParameters& parameters) {
  if (const auto* simple = std::get_if<SimpleSmootherParameters>(&parameters)) {
    return Complaints()
        .range("tolerance", simple->tolerance, 0.0, 1000.0)
        .range("max_its", simple->maxIts, 1.0, 1e6)
        .range("w_data", simple->wData, 0.0, 1.0)
        .range("w_smooth", simple->wSmooth, 0.0, 0.5)
        .range("refinement_num", simple->refinementNum, 0.0, 1000.0)
        .take();
  }
  if (const auto* constrained = std::get_if<ConstrainedSmootherParameters>(&parameters)) {
    return Complaints()
        .range("path_downsampling_factor", constrained->pathDownsamplingFactor, 1.0, 1000.0)
        .range("path_upsampling_factor", constrained->pathUpsamplingFactor, 1.0, 100.0)
        .unless(constrained->minimumTurningRadius > 0.0, "minimum_turning_radius is not above 0")
        .unless(constrained->cuspZoneLength > 0.0, "cusp_zone_length is not above 0")
        .unless(constrained->costCheckPoints.size() % 3 == 0,
                "cost_check_points is no list of x, y, weight")
        .range("optimizer.max_iterations", constrained->maxIterations, 1.0, 10000.0)
        .take();
  }
  const auto& given = std::get<SavitzkyGolayParameters>(parameters);
  return Complaints()
      .range("refinement_num", given.refinementNum, 0.0, 1000.0)
      .range("window_size", given.windowSize, 3.0, 201.0)
      .unless(given.windowSize % 2 == 1, "window_size is even")
      .range("poly_order", given.polyOrder, 0.0, given.windowSize - 1.0)
      .take();
}

std::unique_ptr<PathSmoother> makePathSmoother(const PathSmootherParameters& parameters,
                                               Distro distro) {
  assert(complaintsAbout(parameters).empty());
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
