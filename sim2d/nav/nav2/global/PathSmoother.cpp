#include "sim2d/nav/nav2/global/PathSmoother.h"

#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"

namespace sim2d::nav2 {
namespace {

constexpr ErrorText<SmoothError> kSmoothErrors[] = {
    {SmoothError::None, "NONE", ""},
    {SmoothError::Unknown, "UNKNOWN", "smoothing failed"},
    {SmoothError::InvalidSmoother, "INVALID_SMOOTHER", "there is no such smoother"},
    {SmoothError::Timeout, "TIMEOUT", "smoothing took too long"},
    {SmoothError::SmoothedPathInCollision, "SMOOTHED_PATH_IN_COLLISION",
     "the smoothed path collides"},
    {SmoothError::FailedToSmoothPath, "FAILED_TO_SMOOTH_PATH", "the path could not be smoothed"},
    {SmoothError::InvalidPath, "INVALID_PATH", "there is no path to smooth"},
};

PluginClasses<PathSmootherParameters> smootherClasses(Distro distro) {
  SimpleSmootherParameters simple;
  simple.refinementNum = distro == Distro::Humble ? 4 : simple.refinementNum;
  return {{"nav2_smoother::SimpleSmoother", simple},
          {"nav2_smoother::SavitzkyGolaySmoother", SavitzkyGolayParameters()},
          {"nav2_constrained_smoother::ConstrainedSmoother", ConstrainedSmootherParameters()}};
}

}  // namespace

const char* smoothErrorName(SmoothError error) {
  return textOf(kSmoothErrors, error).name;
}

const char* smoothErrorMessage(SmoothError error) {
  return textOf(kSmoothErrors, error).message;
}

Nav2Keys<SimpleSmootherParameters> keysOf(const SimpleSmootherParameters&) {
  using P = SimpleSmootherParameters;
  return {
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
}

Nav2Keys<SavitzkyGolayParameters> keysOf(const SavitzkyGolayParameters&) {
  using P = SavitzkyGolayParameters;
  return {
      {"do_refinement", &P::doRefinement, "", "smooths the result again"},
      {"refinement_num", &P::refinementNum, "", "number of repetitions of the refinement"},
      {"enforce_path_inversion", &P::enforcePathInversion, "",
       "smooths separately between the cusps of the path", kSinceKilted},
      {"window_size", &P::windowSize, "", "number of poses per polynomial", kSinceLyrical},
      {"poly_order", &P::polyOrder, "", "order of the polynomial", kSinceLyrical},
  };
}

Nav2Keys<ConstrainedSmootherParameters> keysOf(const ConstrainedSmootherParameters&) {
  using P = ConstrainedSmootherParameters;
  return {
      {"reversing_enabled", &P::reversingEnabled, "",
       "poses whose heading opposes the motion are driven backwards"},
      {"path_downsampling_factor", &P::pathDownsamplingFactor, "",
       "one in this many poses is optimized"},
      {"path_upsampling_factor", &P::pathUpsamplingFactor, "",
       "number of poses in the result per optimized pose"},
      {"keep_goal_orientation", &P::keepGoalOrientation, "", "keeps the heading of the last pose"},
      {"keep_start_orientation", &P::keepStartOrientation, "",
       "keeps the heading of the first pose"},
      {"minimum_turning_radius", &P::minimumTurningRadius, "m",
       "arcs with a smaller radius have a cost; 0: none has"},
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
}

Nav2Keys<SmootherServerParameters> keysOf(const SmootherServerParameters&) {
  using P = SmootherServerParameters;
  return {
      {"smoother_plugins", &P::smootherPlugins, "", "names of the smoothers"},
  };
}

IgnoredKeys ignoredKeysOf(const SimpleSmootherParameters&) {
  return {};
}

IgnoredKeys ignoredKeysOf(const SavitzkyGolayParameters&) {
  return {};
}

IgnoredKeys ignoredKeysOf(const ConstrainedSmootherParameters&) {
  return {
      {"optimizer.debug_optimizer", "the log is not used"},
      {"optimizer.linear_solver_type", "the equations are always solved by Cholesky decomposition"},
  };
}

IgnoredKeys ignoredKeysOf(const SmootherServerParameters&) {
  return {
      {"costmap_topic", "the global costmap is passed directly"},
      {"footprint_topic", "the footprint is passed directly"},
      {"robot_base_frame", "TF is not used"},
      {"transform_tolerance", "TF is not used"},
  };
}

std::vector<std::string> pathSmootherPluginNames() {
  return namesOf(smootherClasses(Distro::Main));
}

PluginLookup<PathSmootherParameters> pathSmootherPlugin(const std::string& className,
                                                        Distro distro) {
  return findPlugin(className, smootherClasses(distro));
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
        .require(constrained->minimumTurningRadius >= 0.0, "minimum_turning_radius is below 0")
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

SmoothResult smoothPath(const PathSmootherParameters& parameters, Distro distro, const Path& path,
                        const Costmap& costmap, double maxDuration) {
  assert(parameterErrors(parameters).empty());
  return std::visit(
      [&](const auto& given) { return smoothPath(given, distro, path, costmap, maxDuration); },
      parameters);
}

namespace {

constexpr double kSamePlace = 1e-4;             // [m]
constexpr double kSameHeading = 1e-4;           // [rad]
constexpr double kMaxSmoothingDuration = 60.0;  // [s], upper limit of maxDuration
constexpr int kDefaultWindow = 7, kDefaultOrder = 3;
constexpr std::size_t kMostUnfilteredPoses = 10;

bool isSamePlace(const Vec2& step) {
  return std::fabs(step.x()) < kSamePlace && std::fabs(step.y()) < kSamePlace;
}

bool isBlocked(const Costmap& costmap, const Vec2& place) {
  const auto cell = costmap.worldToCell(place);
  return !cell || costmap.at(*cell) == kInscribed || costmap.at(*cell) == kLethal;
}

/// Performs one sweep over `moved`; returns the sum of changes, or nullopt at an obstacle.
std::optional<double> sweepOnce(const Path& anchors, const SweepSettings& settings,
                                const Costmap& costmap, Path& moved) {
  double change = 0.0;
  for (std::size_t i = 1; i + 1 < moved.size(); ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      const double before = moved[i].position[axis];
      const double neighbours = moved[i + 1].position[axis] + moved[i - 1].position[axis];
      const double after = before + (settings.wData * (anchors[i].position[axis] - before) +
                                     settings.wSmooth * (neighbours - 2.0 * before));
      moved[i].position[axis] = after;
      change += std::fabs(after - before);
    }
    if (isBlocked(costmap, moved[i].position)) {
      return std::nullopt;
    }
  }
  return change;
}

SweepResult sweepUntilDone(Path& segment, const SweepSettings& settings, const Costmap& costmap,
                           long long& budget) {
  const Path anchors = segment;
  Path moved = segment;
  for (int sweep = 1; sweep < settings.maxSweeps; ++sweep) {
    budget -= static_cast<long long>(segment.size());
    if (budget < 0) {
      return SweepResult::OutOfBudget;
    }
    const auto change = sweepOnce(anchors, settings, costmap, moved);
    if (!change) {
      return SweepResult::Obstacle;
    }
    segment = moved;
    if (*change < settings.tolerance) {
      return SweepResult::Converged;
    }
  }
  return SweepResult::MaxSweeps;
}

double dotOf(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Filters all poses except the ends, which are repeated beyond the segment.
void filterSegment(const std::vector<double>& weights, Path& segment) {
  const Path before = segment;
  const int half = static_cast<int>(weights.size() / 2), last = static_cast<int>(before.size()) - 1;
  for (int i = 1; i < last; ++i) {
    Vec2 sum = Vec2::Zero();
    int at = i - half;
    for (const double weight : weights) {
      sum += weight * before[static_cast<std::size_t>(std::clamp(at++, 0, last))].position;
    }
    segment[static_cast<std::size_t>(i)].position = sum;
  }
}

}  // namespace

std::vector<PathSegment> directionalSegments(const Path& path) {
  std::vector<PathSegment> segments;
  PathSegment segment;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Vec2 here = path[i].position - path[i - 1].position;
    const Vec2 next = path[i + 1].position - path[i].position;
    const bool turnsOnTheSpot =
        isSamePlace(next) &&
        std::fabs(base::angleDiff(path[i + 1].heading, path[i].heading)) > kSameHeading;
    if (here.dot(next) < 0.0 || turnsOnTheSpot) {
      segment.last = i;
      segments.push_back(segment);
      segment.first = i;
    }
  }
  segment.last = path.empty() ? 0 : path.size() - 1;
  segments.push_back(segment);
  return segments;
}

bool orientSegment(Path& segment, bool isHolonomic) {
  const Vec2 ahead = segment[2].position - segment[1].position;
  const double turn = base::angleDiff(base::atan2(ahead.y(), ahead.x()), segment[1].heading);
  const bool isBackward = !isHolonomic && std::fabs(turn) > 0.5 * base::kPi;
  for (std::size_t i = 0; i + 1 < segment.size(); ++i) {
    const Vec2 step = segment[i + 1].position - segment[i].position;
    if (!isSamePlace(step)) {
      const double heading = base::atan2(step.y(), step.x());
      segment[i].heading = isBackward ? base::wrapToPi(heading + base::kPi) : heading;
    }
  }
  return isBackward;
}

SweepResult smoothBySweeps(Path& segment, const SweepSettings& settings, const Costmap& costmap,
                           long long& budget) {
  const SweepResult first = sweepUntilDone(segment, settings, costmap, budget);
  SweepResult last = first;
  for (int i = 0; i < settings.refinements && last == SweepResult::Converged; ++i) {
    last = sweepUntilDone(segment, settings, costmap, budget);
  }
  orientSegment(segment, settings.isHolonomic);
  return last == SweepResult::OutOfBudget ? last : first;
}

SmoothResult smoothPath(const SimpleSmootherParameters& parameters, Distro distro, const Path& path,
                        const Costmap& costmap, double maxDuration) {
  SmoothResult result;
  if (path.empty()) {
    result.error = SmoothError::InvalidPath;
    return result;
  }
  SweepSettings settings;
  settings.tolerance = parameters.tolerance;
  settings.maxSweeps = parameters.maxIts;
  settings.wData = parameters.wData;
  settings.wSmooth = parameters.wSmooth;
  settings.refinements = parameters.doRefinement ? parameters.refinementNum : 0;
  const bool isSplit = distro < Distro::Kilted || parameters.enforcePathInversion;
  auto budget = static_cast<long long>(std::clamp(maxDuration, 0.0, kMaxSmoothingDuration) *
                                       kSweptPosesPerSecond);
  bool isTimeout = false;
  result.path = path;
  smoothSegments(result.path, isSplit, distro == Distro::Humble ? 10 : 4, [&](Path& segment) {
    const SweepResult end = smoothBySweeps(segment, settings, costmap, budget);
    isTimeout = isTimeout || (end == SweepResult::OutOfBudget && distro != Distro::Humble);
    result.wasCompleted = result.wasCompleted && end == SweepResult::Converged;
  });
  return isTimeout ? SmoothResult{SmoothError::Timeout, {}, false} : result;
}

std::vector<double> savitzkyGolayWeights(int window, int order) {
  const int half = window / 2;
  const auto count = static_cast<std::size_t>(window), middle = static_cast<std::size_t>(half);
  std::vector<double> weights(count, 0.0);
  std::vector<std::vector<double>> basis;  // orthonormal polynomials at -half … half
  for (int degree = 0; degree <= order; ++degree) {
    std::vector<double> next(count, 1.0);
    for (std::size_t i = 0; i < count && degree > 0; ++i) {
      next[i] = basis.back()[i] * (static_cast<double>(i) - half);
    }
    for (int round = 0; round < 2; ++round) {  // orthogonalizes twice because of rounding errors
      for (const std::vector<double>& before : basis) {
        const double share = dotOf(next, before);
        for (std::size_t i = 0; i < count; ++i) {
          next[i] -= share * before[i];
        }
      }
    }
    const double length = std::sqrt(dotOf(next, next));
    for (double& value : next) {
      value /= length;
    }
    for (std::size_t i = 0; i < count; ++i) {
      weights[i] += next[middle] * next[i];
    }
    basis.push_back(next);
  }
  return weights;
}

SmoothResult smoothPath(const SavitzkyGolayParameters& parameters, Distro distro, const Path& path,
                        const Costmap& /*costmap*/, double /*maxDuration*/) {
  SmoothResult result;
  if (path.empty()) {
    result.error = SmoothError::InvalidPath;
    return result;
  }
  const std::vector<double> weights =
      distro >= Distro::Lyrical ? savitzkyGolayWeights(parameters.windowSize, parameters.polyOrder)
                                : savitzkyGolayWeights(kDefaultWindow, kDefaultOrder);
  const bool isSplit = distro < Distro::Kilted || parameters.enforcePathInversion;
  const int rounds = 1 + (parameters.doRefinement ? parameters.refinementNum : 0);
  result.path = path;
  smoothSegments(result.path, isSplit, kMostUnfilteredPoses, [&](Path& segment) {
    for (int i = 0; i < rounds; ++i) {
      filterSegment(weights, segment);
    }
    orientSegment(segment, false);
  });
  return result;
}

}  // namespace sim2d::nav2
