#include "sim2d/nav/nav2/global/PathSmoother.h"

#include <cassert>

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

const std::vector<KnownElsewhere>& smoothersElsewhere() {
  static const std::vector<KnownElsewhere> kSmoothers = {
      {"nav2_constrained_smoother::ConstrainedSmoother", kSimple,
       "it needs a solver of least squares (Ceres), which is not here"},
  };
  return kSmoothers;
}

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
  return {kSimple, kSavitzkyGolay};
}

PluginAnswer<PathSmootherParameters> pathSmootherPlugin(const std::string& className,
                                                        Distro distro) {
  const PluginMatch match = matchPlugin(className, pathSmootherPluginNames(), smoothersElsewhere());
  PluginAnswer<PathSmootherParameters> answer{std::nullopt, match.name, match.why};
  if (match.isOffered && match.name == kSimple) {
    SimpleSmootherParameters parameters;
    parameters.refinementNum = distro == Distro::Humble ? 4 : parameters.refinementNum;
    answer.parameters = parameters;
  } else if (match.isOffered) {
    answer.parameters = SavitzkyGolayParameters();
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
  return std::make_unique<SavitzkyGolaySmoother>(std::get<SavitzkyGolayParameters>(parameters),
                                                 distro);
}

}  // namespace sim2d::nav2
