#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"

/// Which planners there are, by the names of Nav2's plugin classes.
namespace sim2d::nav2 {

using GlobalPlannerParameters = std::variant<NavfnParameters, ThetaStarParameters, Smac2DParameters,
                                             SmacHybridParameters, SmacLatticeParameters>;

/// Answer to a class name: what is there, or why not and what comes nearest.
template <class Parameters>
struct PluginAnswer {
  std::optional<Parameters> parameters;  // with the defaults of that distribution
  std::string name;                      // as Nav2 writes it now, or what comes nearest; may be ""
  std::string why;                       // of a class that is known and not offered; else ""
};

/// "nav2_navfn_planner::NavfnPlanner", "nav2_navfn_planner/NavfnPlanner"; white space does not
/// belong to it. The reader goes over the keys with
/// `std::visit([](auto& p) { … keysOf(p) … idleKeysOf(p) … }, *answer.parameters)`.
PluginAnswer<GlobalPlannerParameters> globalPlannerPlugin(const std::string& className,
                                                          Distro distro);
std::vector<std::string> globalPlannerPluginNames();

/// What is wrong with the values, a sentence each that begins with the key; empty when nothing is.
std::vector<std::string> complaintsAbout(const GlobalPlannerParameters& parameters);

/// Values with complaints are an assert; a lattice without its file is Smac Hybrid.
/// Of a lattice whose file is not there: what both planners have. A lattice that may turn back is
/// a car of Reeds and Shepp.
SmacHybridParameters hybridInsteadOf(const SmacLatticeParameters& lattice, Distro distro);

std::unique_ptr<GlobalPlanner> makeGlobalPlanner(const GlobalPlannerParameters& parameters,
                                                 Distro distro);

}  // namespace sim2d::nav2
