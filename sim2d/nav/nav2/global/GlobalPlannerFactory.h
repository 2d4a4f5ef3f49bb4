#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"

/// The available planners by the names of Nav2's plugin classes.
namespace sim2d::nav2 {

using GlobalPlannerParameters = std::variant<NavfnParameters, ThetaStarParameters, Smac2DParameters,
                                             SmacHybridParameters, SmacLatticeParameters>;

/// Result of a class lookup: the parameters, or why the class is not available and its nearest
/// match.
template <class Parameters>
struct PluginLookup {
  std::optional<Parameters> parameters;  // with the defaults of the distribution
  std::string name;                      // current name, or the nearest class; may be ""
  std::string why;                       // why a known class is not available; else ""
};

/// Accepts "nav2_navfn_planner::NavfnPlanner" and "nav2_navfn_planner/NavfnPlanner"; does not trim
/// white space. Readers iterate over the keys with `std::visit([](auto& p) { … keysOf(p) …
/// ignoredKeysOf(p) … }, *answer.parameters)`.
PluginLookup<GlobalPlannerParameters> globalPlannerPlugin(const std::string& className,
                                                          Distro distro);
std::vector<std::string> globalPlannerPluginNames();

/// Errors in the values, one sentence each that begins with the key; empty when there are none.
std::vector<std::string> parameterErrors(const GlobalPlannerParameters& parameters);

/// Parameters for Smac Hybrid in place of a lattice whose file is missing: takes the common keys. A
/// lattice with reverse expansion becomes a Reeds-Shepp car.
SmacHybridParameters hybridFallback(const SmacLatticeParameters& lattice, Distro distro);

/// Precondition: parameterErrors(parameters) is empty. A lattice without its file gives Smac
/// Hybrid.
std::unique_ptr<GlobalPlanner> makeGlobalPlanner(const GlobalPlannerParameters& parameters,
                                                 Distro distro);

struct ThroughPosesResult {
  PlanError error = PlanError::None;
  Path path;                // concatenated legs, with both poses of a joint. Empty with an error
  int reached = -1;         // index of the last goal reached by a leg
  bool isComplete = false;  // false without an error: a partial path (`allow_partial_planning`)
};

/// ComputePathThroughPoses: each leg starts where the previous one ended, which may differ from its
/// goal. Ignores `request.goal`. No goals: NoValidPath.
ThroughPosesResult planThroughPoses(GlobalPlanner& planner, PlanRequest request,
                                    const std::vector<Pose2>& goals, bool allowPartial = false);

/// A class of Nav2 that is not re-implemented.
struct UnavailablePlugin {
  std::string name, nearest, why;
};

struct PluginMatch {
  bool isAvailable = false;
  std::string name;  // with "::"; the nearest class if there is no match, or ""
  std::string why;   // why a class in `unavailable` cannot be used
};

/// Looks up a class name in both spellings, "package::Class" and "package/Class".
PluginMatch matchPlugin(const std::string& className, const std::vector<std::string>& available,
                        const std::vector<UnavailablePlugin>& unavailable);

}  // namespace sim2d::nav2
