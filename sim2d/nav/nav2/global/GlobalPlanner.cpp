#include "sim2d/nav/nav2/global/GlobalPlanner.h"

#include <cassert>

#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

namespace sim2d::nav2 {
namespace {

constexpr ErrorText<PlanError> kPlanErrors[] = {
    {PlanError::None, "NONE", ""},
    {PlanError::Unknown, "UNKNOWN", "planning failed"},
    {PlanError::InvalidPlanner, "INVALID_PLANNER", "there is no such planner"},
    {PlanError::TfError, "TF_ERROR", "the frames are not connected"},
    {PlanError::StartOutsideMap, "START_OUTSIDE_MAP", "the start lies outside the map"},
    {PlanError::GoalOutsideMap, "GOAL_OUTSIDE_MAP", "the goal lies outside the map"},
    {PlanError::StartOccupied, "START_OCCUPIED", "the start is occupied"},
    {PlanError::GoalOccupied, "GOAL_OCCUPIED", "the goal is occupied"},
    {PlanError::Timeout, "TIMEOUT", "the search took too long"},
    {PlanError::NoValidPath, "NO_VALID_PATH", "there is no path to the goal"},
};

constexpr char kNavfn[] = "nav2_navfn_planner::NavfnPlanner";
constexpr char kThetaStar[] = "nav2_theta_star_planner::ThetaStarPlanner";
constexpr char kSmac2D[] = "nav2_smac_planner::SmacPlanner2D";
constexpr char kSmacHybrid[] = "nav2_smac_planner::SmacPlannerHybrid";
constexpr char kSmacLattice[] = "nav2_smac_planner::SmacPlannerLattice";

/// Humble always refines four times.
template <class Smac>
Smac smacDefaults(Distro distro) {
  Smac parameters;
  if (distro == Distro::Humble) {
    parameters.smootherRefinementNum = 4;
  }
  return parameters;
}

SmacHybridParameters hybridDefaults(Distro distro) {
  auto parameters = smacDefaults<SmacHybridParameters>(distro);
  parameters.allowPrimitiveInterpolation = distro >= Distro::Lyrical;
  return parameters;
}

PluginClasses<GlobalPlannerParameters> plannerClasses(Distro distro) {
  return {{kNavfn, NavfnParameters()},
          {kThetaStar, ThetaStarParameters()},
          {kSmac2D, smacDefaults<Smac2DParameters>(distro)},
          {kSmacHybrid, hybridDefaults(distro)},
          {kSmacLattice, smacDefaults<SmacLatticeParameters>(distro)}};
}

}  // namespace

const char* planErrorName(PlanError error) {
  return textOf(kPlanErrors, error).name;
}

const char* planErrorMessage(PlanError error) {
  return textOf(kPlanErrors, error).message;
}

void setFinalApproachHeading(Path& path, double startHeading) {
  if (path.empty()) {
    return;
  }
  if (path.size() == 1) {
    path.back().heading = startHeading;
    return;
  }
  constexpr double kSame = 1e-4;  // [m]
  const Vec2 last = path.back().position;
  Vec2 before = path[path.size() - 2].position;
  if ((last - before).cwiseAbs().maxCoeff() < kSame && path.size() > 2) {
    before = path[path.size() - 3].position;
  }
  path.back().heading = base::atan2(last.y() - before.y(), last.x() - before.x());
}

Pose2 singlePose(const Pose2& start, const Pose2& goal, bool useFinalApproachOrientation) {
  return {start.position, useFinalApproachOrientation ? start.heading : goal.heading};
}

std::optional<PlanResult> planWithoutSearch(const PlanRequest& request, const Costmap& costmap,
                                            bool useFinalApproachOrientation) {
  const auto start = costmap.worldToCell(request.start.position);
  const auto goal = costmap.worldToCell(request.goal.position);
  if (!start || !goal) {
    return PlanResult{start ? PlanError::GoalOutsideMap : PlanError::StartOutsideMap, {}, 0};
  }
  if (!(*start == *goal)) {
    return std::nullopt;
  }
  if (costmap.at(*start) == kLethal) {
    return PlanResult{PlanError::StartOccupied, {}, 0};
  }
  return PlanResult{
      PlanError::None, {singlePose(request.start, request.goal, useFinalApproachOrientation)}, 0};
}

std::vector<std::string> globalPlannerPluginNames() {
  return namesOf(plannerClasses(Distro::Main));
}

PluginLookup<GlobalPlannerParameters> globalPlannerPlugin(const std::string& className,
                                                          Distro distro) {
  if (normalizedPluginClass(className) == "nav2_smac_planner::SmacPlanner") {
    return {std::nullopt, kSmacHybrid, "its name before Humble"};
  }
  return findPlugin(className, plannerClasses(distro));
}

SmacHybridParameters hybridFallback(const SmacLatticeParameters& lattice, Distro distro) {
  SmacHybridParameters hybrid = hybridDefaults(distro);
  static_cast<SmacPoseParameters&>(hybrid) = static_cast<const SmacPoseParameters&>(lattice);
  hybrid.motionModelForSearch = lattice.allowReverseExpansion ? "REEDS_SHEPP" : "DUBIN";
  return hybrid;
}

std::vector<std::string> parameterErrors(const GlobalPlannerParameters& parameters) {
  return std::visit([](const auto& given) { return plannerErrors(given); }, parameters);
}

PlannerPointer makeGlobalPlanner(const GlobalPlannerParameters& parameters, Distro distro) {
  assert(parameterErrors(parameters).empty());
  return std::visit([distro](const auto& given) { return makeGlobalPlanner(given, distro); },
                    parameters);
}

ThroughPosesResult planThroughPoses(GlobalPlanner& planner, PlanRequest request,
                                    const std::vector<Pose2>& goals, bool allowPartial) {
  ThroughPosesResult result;
  if (goals.empty()) {
    result.error = PlanError::NoValidPath;
    return result;
  }
  for (const Pose2& goal : goals) {
    if (!result.path.empty()) {
      request.start = result.path.back();
    }
    request.goal = goal;
    const PlanResult leg = planner.plan(request);
    if (leg.error != PlanError::None) {
      const bool isPart = allowPartial && !result.path.empty();
      result.error = isPart ? PlanError::None : leg.error;
      if (!isPart) {
        result.path.clear();
        result.reached = -1;
      }
      return result;
    }
    result.path.insert(result.path.end(), leg.path.begin(), leg.path.end());
    ++result.reached;
  }
  result.isComplete = true;
  return result;
}

std::string nearestPlugin(const std::string& name, const std::vector<std::string>& available) {
  const auto bareName = [](const std::string& whole) {  // "nav2::Planner" -> "Planner"
    const std::size_t colons = whole.rfind("::");
    return colons == std::string::npos ? whole : whole.substr(colons + 2);
  };
  const auto found = std::find_if(available.begin(), available.end(), [&](const std::string& each) {
    return bareName(each) == bareName(name);
  });
  return found != available.end() ? *found : base::nearestName(name, available).value_or("");
}

}  // namespace sim2d::nav2
