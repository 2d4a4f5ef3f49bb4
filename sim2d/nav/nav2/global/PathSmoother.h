#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"

/// Path smoothers of Nav2 (nav2_core::Smoother), which keep the ends of a path.
namespace sim2d::nav2 {

/// With the codes of nav2_msgs/action/SmoothPath.
enum class SmoothError : std::uint16_t {
  None = 0,
  Unknown = 500,
  InvalidSmoother = 501,
  Timeout = 502,
  SmoothedPathInCollision = 503,
  FailedToSmoothPath = 504,
  InvalidPath = 505,  // an empty path
};
const char* smoothErrorName(SmoothError error);
const char* smoothErrorMessage(SmoothError error);

/// nav2_smoother::SimpleSmoother.
struct SimpleSmootherParameters {
  double tolerance = 1e-10;  // sum of changes of a sweep at convergence [m]
  int maxIts = 1000;         // maximum number of sweeps
  double wData = 0.2;        // weight of the original path
  double wSmooth = 0.3;      // weight of the midpoint of the neighbours
  bool doRefinement = true;
  int refinementNum = 2;  // how often the result is smoothed again; Humble: 4
  bool enforcePathInversion = true;
};

/// nav2_smoother::SavitzkyGolaySmoother: polynomials through a window.
struct SavitzkyGolayParameters {
  bool doRefinement = true;
  int refinementNum = 2;
  bool enforcePathInversion = true;
  int windowSize = 7;  // poses, odd
  int polyOrder = 3;
};

/// nav2_constrained_smoother::ConstrainedSmoother; see `smoothPath`.
struct ConstrainedSmootherParameters {
  bool reversingEnabled = true;    // poses whose heading opposes the movement are driven in reverse
  int pathDownsamplingFactor = 1;  // one of this many poses is optimized
  int pathUpsamplingFactor = 1;    // output poses per pose of the path
  bool keepGoalOrientation = true, keepStartOrientation = true;
  double minimumTurningRadius = 0.4;  // [m]
  double wCurve = 30.0, wDist = 0.0, wSmooth = 2e6, wCost = 0.015;
  double wCostCuspMultiplier = 3.0;
  double cuspZoneLength = 2.5;          // [m]
  std::vector<double> costCheckPoints;  // triples x, y [m] in the robot's frame, weight
  int maxIterations = 100;
  double fnTol = 1e-7, gradientTol = 1e-10, paramTol = 1e-15;
};

/// Parameters of smoother_server itself.
struct SmootherServerParameters {
  std::vector<std::string> smootherPlugins = {"simple_smoother"};
};

Nav2Keys<SimpleSmootherParameters> keysOf(const SimpleSmootherParameters&);
Nav2Keys<SavitzkyGolayParameters> keysOf(const SavitzkyGolayParameters&);
Nav2Keys<ConstrainedSmootherParameters> keysOf(const ConstrainedSmootherParameters&);
Nav2Keys<SmootherServerParameters> keysOf(const SmootherServerParameters&);
IgnoredKeys ignoredKeysOf(const SimpleSmootherParameters&);
IgnoredKeys ignoredKeysOf(const SavitzkyGolayParameters&);
IgnoredKeys ignoredKeysOf(const ConstrainedSmootherParameters&);
IgnoredKeys ignoredKeysOf(const SmootherServerParameters&);

struct SmoothResult {
  SmoothError error = SmoothError::None;
  Path path;                 // with Timeout the original path; empty with other errors
  bool wasCompleted = true;  // false: some segments are not smoothed
};

using PathSmootherParameters =
    std::variant<SimpleSmootherParameters, SavitzkyGolayParameters, ConstrainedSmootherParameters>;
PluginLookup<PathSmootherParameters> pathSmootherPlugin(const std::string& className,
                                                        Distro distro);
std::vector<std::string> pathSmootherPluginNames();
std::vector<std::string> parameterErrors(const PathSmootherParameters& parameters);

/// Smooths a path. Precondition: parameterErrors(parameters) is empty. `maxDuration` [s] of
/// SmoothPath limits the sweeps: `kSweptPosesPerSecond` poses.
SmoothResult smoothPath(const PathSmootherParameters& parameters, Distro distro, const Path& path,
                        const Costmap& costmap, double maxDuration);
constexpr double kSweptPosesPerSecond = 2e7;

/// nav2_smoother::SimpleSmoother: sweeps over each segment that is driven in one direction, if it
/// is long enough. When the limit is reached, Humble keeps the current state, later branches return
/// Timeout.
SmoothResult smoothPath(const SimpleSmootherParameters& parameters, Distro distro, const Path& path,
                        const Costmap& costmap, double maxDuration);

/// nav2_smoother::SavitzkyGolaySmoother: replaces each pose by the centre value of a polynomial
/// through its neighbours. Before Lyrical: window 7, order 3, (-2, 3, 6, 7, 6, 3, -2) / 21. Ignores
/// the costmap and the duration.
SmoothResult smoothPath(const SavitzkyGolayParameters& parameters, Distro distro, const Path& path,
                        const Costmap& costmap, double maxDuration);
/// Weights of the poses of a window of 2 m + 1 for the value of the least-squares polynomial at its
/// centre (Savitzky and Golay, Anal. Chem. 36, 1964). 0 <= order <= 2 m.
std::vector<double> savitzkyGolayWeights(int window, int order);

/// Least squares over all poses except the ends (nav2_constrained_smoother::ConstrainedSmoother).
/// Each inner pose p between its neighbours a and b has four residuals, whose squares are summed:
///   w_smooth |ratio (b - p) - (p - a)|²        ratio = |p - a| / |b - p| of the given path;
///                                              negative at a cusp
///   w_curve (1/r - 1/minimum_turning_radius)²  for arcs with a radius r below the minimum
///   w_dist |p - p_given|²
///   weight cost(p)²                            costmap, interpolated with cubic splines; or
///                                              at points of the robot (cost_check_points)
/// The weight is w_cost, and near a cusp up to w_cost_cusp_multiplier times w_cost. The minimum is
/// found by Levenberg-Marquardt with the rules of Ceres Solver 2 (Agarwal, Mierle and others),
/// which Nav2 uses, in a fixed order of operations. FailedToSmoothPath for a path of one pose.
/// `maxDuration` limits the iterations: 1000 poses in a million per second.
SmoothResult smoothPath(const ConstrainedSmootherParameters& parameters, Distro distro,
                        const Path& path, const Costmap& costmap, double maxDuration);

/// Functions shared by the smoothers (nav2_smoother/simple_smoother.cpp, smoother_utils.hpp and the
/// smoother of nav2_smac_planner).

/// Poses of a path that are driven in one direction, including both ends.
struct PathSegment {
  std::size_t first = 0, last = 0;
};

/// Splits a path at cusps and turns in place.
std::vector<PathSegment> directionalSegments(const Path& path);

/// Smooths each segment of a path, or the whole path, if it has more than `least` poses:
/// `smooth(Path&)` must keep their number.
template <class Smooth>
void smoothSegments(Path& path, bool isSplit, std::size_t least, const Smooth& smooth) {
  const std::vector<PathSegment> segments =
      isSplit ? directionalSegments(path) : std::vector<PathSegment>{{0, path.size() - 1}};
  for (const PathSegment& part : segments) {
    if (part.last - part.first < least) {
      continue;
    }
    const auto first = path.begin() + static_cast<std::ptrdiff_t>(part.first);
    Path segment(first, path.begin() + static_cast<std::ptrdiff_t>(part.last) + 1);
    smooth(segment);
    std::copy(segment.begin(), segment.end(), first);
  }
}

/// Sets all headings but the last to the direction to the next pose, reversed where the segment is
/// driven in reverse. Returns whether it is driven in reverse; false if `isHolonomic`.
/// Precondition: at least three poses.
bool orientSegment(Path& segment, bool isHolonomic);

struct SweepSettings {
  double tolerance = 1e-10;  // sum of changes of a sweep at convergence [m]
  int maxSweeps = 1000;
  double wData = 0.2, wSmooth = 0.3;
  int refinements = 0;  // how often the result is smoothed again
  bool isHolonomic = false;
};

enum class SweepResult { Converged, MaxSweeps, Obstacle, OutOfBudget };

/// Gauss-Seidel sweeps over all poses except the first and the last: y_i += w_data (x_i - y_i) +
/// w_smooth (y_(i+1) + y_(i-1) - 2 y_i). A sweep that enters a cell above 252 (except 255) or
/// leaves the map is undone and ends the smoothing. `budget`: number of poses that may still be
/// moved; reduced by the moved ones. Returns the result of the first round; refinements that end
/// early keep their current state.
SweepResult smoothBySweeps(Path& segment, const SweepSettings& settings, const Costmap& costmap,
                           long long& budget);

}  // namespace sim2d::nav2
