#include "sim2d/nav/nav2/global/GlobalPlannerFactory.h"

#include <algorithm>
#include <cassert>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/global/NavfnPlanner.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"
#include "sim2d/nav/nav2/global/Smac2DPlanner.h"
#include "sim2d/nav/nav2/global/SmacHybridPlanner.h"
#include "sim2d/nav/nav2/global/SmacLatticePlanner.h"
#include "sim2d/nav/nav2/global/ThetaStarPlanner.h"

namespace sim2d::nav2 {
namespace {

constexpr char kNavfn[] = "nav2_navfn_planner::NavfnPlanner";
constexpr char kThetaStar[] = "nav2_theta_star_planner::ThetaStarPlanner";
constexpr char kSmac2D[] = "nav2_smac_planner::SmacPlanner2D";
constexpr char kSmacHybrid[] = "nav2_smac_planner::SmacPlannerHybrid";
constexpr char kSmacLattice[] = "nav2_smac_planner::SmacPlannerLattice";

const std::vector<UnavailablePlugin>& unavailablePlanners() {
  static const std::vector<UnavailablePlugin> kPlanners = {
      {"nav2_smac_planner::SmacPlanner", kSmacHybrid, "its name before Humble"},
  };
  return kPlanners;
}

/// Humble always refines four times.
template <class Smac>
Smac smacDefaults(Distro distro) {
  Smac parameters;
  if (distro == Distro::Humble) {
    parameters.smootherRefinementNum = 4;
  }
  return parameters;
}

GlobalPlannerParameters plannerDefaults(const std::string& name, Distro distro) {
  if (name == kNavfn) {
    return NavfnParameters();
  }
  if (name == kThetaStar) {
    return ThetaStarParameters();
  }
  if (name == kSmac2D) {
    return smacDefaults<Smac2DParameters>(distro);
  }
  if (name == kSmacLattice) {
    return smacDefaults<SmacLatticeParameters>(distro);
  }
  auto parameters = smacDefaults<SmacHybridParameters>(distro);
  parameters.allowPrimitiveInterpolation = distro >= Distro::Lyrical;
  return parameters;
}

struct PlannerFactory {
  Distro distro;

  std::unique_ptr<GlobalPlanner> operator()(const NavfnParameters& parameters) const {
    return std::make_unique<NavfnPlanner>(parameters, distro);
  }
  std::unique_ptr<GlobalPlanner> operator()(const ThetaStarParameters& parameters) const {
    return std::make_unique<ThetaStarPlanner>(parameters, distro);
  }
  std::unique_ptr<GlobalPlanner> operator()(const Smac2DParameters& parameters) const {
    return std::make_unique<Smac2DPlanner>(parameters, distro);
  }
  std::unique_ptr<GlobalPlanner> operator()(const SmacHybridParameters& parameters) const {
    return std::make_unique<SmacHybridPlanner>(parameters, distro);
  }
  std::unique_ptr<GlobalPlanner> operator()(const SmacLatticeParameters& parameters) const {
    if (parameters.lattice == nullptr) {
      return (*this)(hybridFallback(parameters, distro));
    }
    return std::make_unique<SmacLatticePlanner>(parameters, distro);
  }
};

}  // namespace

std::vector<std::string> globalPlannerPluginNames() {
  return {kNavfn, kThetaStar, kSmac2D, kSmacHybrid, kSmacLattice};
}

PluginLookup<GlobalPlannerParameters> globalPlannerPlugin(const std::string& className,
                                                          Distro distro) {
  const PluginMatch match =
      matchPlugin(className, globalPlannerPluginNames(), unavailablePlanners());
  PluginLookup<GlobalPlannerParameters> lookup{std::nullopt, match.name, match.why};
  if (match.isAvailable) {
    lookup.parameters = plannerDefaults(match.name, distro);
  }
  return lookup;
}

SmacHybridParameters hybridFallback(const SmacLatticeParameters& lattice, Distro distro) {
  SmacHybridParameters hybrid =
      std::get<SmacHybridParameters>(plannerDefaults(kSmacHybrid, distro));
  static_cast<SmacPoseParameters&>(hybrid) = lattice;
  hybrid.motionModelForSearch = lattice.allowReverseExpansion ? "REEDS_SHEPP" : "DUBIN";
  return hybrid;
}

std::vector<std::string> parameterErrors(const GlobalPlannerParameters& parameters) {
  return std::visit([](const auto& given) { return plannerErrors(given); }, parameters);
}

std::unique_ptr<GlobalPlanner> makeGlobalPlanner(const GlobalPlannerParameters& parameters,
                                                 Distro distro) {
  assert(parameterErrors(parameters).empty());
  return std::visit(PlannerFactory{distro}, parameters);
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

namespace {

/// "nav2_navfn_planner::NavfnPlanner" -> "NavfnPlanner".
std::string bareClassName(const std::string& name) {
  const std::size_t colons = name.rfind("::");
  return colons == std::string::npos ? name : name.substr(colons + 2);
}

}  // namespace

PluginMatch matchPlugin(const std::string& className, const std::vector<std::string>& available,
                        const std::vector<UnavailablePlugin>& unavailable) {
  const std::string name = normalizedPluginClass(className);
  if (std::find(available.begin(), available.end(), name) != available.end()) {
    return {true, name, ""};
  }
  for (const UnavailablePlugin& known : unavailable) {
    if (known.name == name) {
      return {false, known.nearest, known.why};
    }
  }
  for (const std::string& each : available) {  // the same class name in another package
    if (bareClassName(each) == bareClassName(name)) {
      return {false, each, ""};
    }
  }
  return {false, base::nearestName(name, available).value_or(""), ""};
}

}  // namespace sim2d::nav2
