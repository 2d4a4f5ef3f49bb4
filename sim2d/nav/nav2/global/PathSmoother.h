#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/global/GlobalPlannerFactory.h"

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

/// nav2_constrained_smoother::ConstrainedSmoother; see ConstrainedSmoother.h.
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

const std::vector<Nav2Key<SimpleSmootherParameters>>& keysOf(const SimpleSmootherParameters&);
const std::vector<Nav2Key<SavitzkyGolayParameters>>& keysOf(const SavitzkyGolayParameters&);
const std::vector<Nav2Key<ConstrainedSmootherParameters>>& keysOf(
    const ConstrainedSmootherParameters&);
const std::vector<Nav2Key<SmootherServerParameters>>& keysOf(const SmootherServerParameters&);
const std::vector<IgnoredKey>& ignoredKeysOf(const SimpleSmootherParameters&);
const std::vector<IgnoredKey>& ignoredKeysOf(const SavitzkyGolayParameters&);
const std::vector<IgnoredKey>& ignoredKeysOf(const ConstrainedSmootherParameters&);
const std::vector<IgnoredKey>& ignoredKeysOf(const SmootherServerParameters&);

struct SmoothResult {
  SmoothError error = SmoothError::None;
  Path path;                 // with Timeout the original path; empty with other errors
  bool wasCompleted = true;  // false: some segments are not smoothed
};

class PathSmoother {
 public:
  PathSmoother() = default;
  virtual ~PathSmoother() = default;
  PathSmoother(const PathSmoother&) = delete;
  PathSmoother& operator=(const PathSmoother&) = delete;
  PathSmoother(PathSmoother&&) = delete;
  PathSmoother& operator=(PathSmoother&&) = delete;

  /// `maxDuration` [s] of SmoothPath limits the sweeps: `kSweptPosesPerSecond` poses.
  virtual SmoothResult smooth(const Path& path, const Costmap& costmap,
                              double maxDuration) const = 0;
};
constexpr double kSweptPosesPerSecond = 2e7;

using PathSmootherParameters =
    std::variant<SimpleSmootherParameters, SavitzkyGolayParameters, ConstrainedSmootherParameters>;
PluginLookup<PathSmootherParameters> pathSmootherPlugin(const std::string& className,
                                                        Distro distro);
std::vector<std::string> pathSmootherPluginNames();
std::vector<std::string> parameterErrors(const PathSmootherParameters& parameters);
std::unique_ptr<PathSmoother> makePathSmoother(const PathSmootherParameters& parameters,
                                               Distro distro);

}  // namespace sim2d::nav2
