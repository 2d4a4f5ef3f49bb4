#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim2d/base/StopFlag.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/global/PlannerParameters.h"

/// Global planners of Nav2 (nav2_core::GlobalPlanner), which plan a path through a costmap. They do
/// not read a clock: limits of wall-clock time are limits of iterations (PlannerParameters.h).
namespace sim2d::nav2 {

/// Why there is no path, with the codes of nav2_msgs/action/ComputePathToPose. Humble has no error
/// codes and distinguishes only None from failures.
enum class PlanError : std::uint16_t {
  None = 0,
  Unknown = 200,
  InvalidPlanner = 201,
  TfError = 202,  // the robot's pose in the map is unknown
  StartOutsideMap = 203,
  GoalOutsideMap = 204,
  StartOccupied = 205,
  GoalOccupied = 206,
  Timeout = 207,  // the iteration limit is reached
  NoValidPath = 208,
};
/// The name and the message of an error code.
template <class Error>
struct ErrorText {
  Error error;
  const char* name;     // "GOAL_OCCUPIED"
  const char* message;  // "the goal is occupied"
};
/// The texts of a code; those of the second entry for other codes.
template <class Error, std::size_t N>
const ErrorText<Error>& textOf(const ErrorText<Error> (&texts)[N], Error error) {
  const auto* const found = std::find_if(std::begin(texts), std::end(texts),
                                         [error](const auto& each) { return each.error == error; });
  return found == std::end(texts) ? texts[1] : *found;
}
const char* planErrorName(PlanError error);     // "GOAL_OCCUPIED"
const char* planErrorMessage(PlanError error);  // "the goal is occupied"; "" for None

struct PlanRequest {
  PlanRequest(const Costmap& where, const Pose2& from, const Pose2& to)
      : costmap(where), start(from), goal(to) {}

  const Costmap& costmap;  // global costmap after its last update; must outlive the call
  Pose2 start, goal;       // world frame [m], [rad]
  /// Padded corners in the robot's frame [m]. Empty: a round robot, for which the cost of the cell
  /// under its centre decides. Used only by Smac Hybrid and Smac Lattice.
  std::vector<Vec2> footprint;
  /// Inflation cost at the circumscribed radius: cells of lower cost need no footprint check. <= 0:
  /// always checks.
  double circumscribedCost = -1.0;
  const base::StopFlag* stop = nullptr;  // a stop request throws base::Stopped
};

struct PlanResult {
  PlanError error = PlanError::None;
  Path path;           // to the goal, or as near as the tolerance allows; empty with an error
  int iterations = 0;  // cells or poses expanded
};

/// Equal requests give bit-identical results, independent of earlier requests (except for
/// `cache_obstacle_heuristic`, whose cache is kept). Not thread-safe.
class GlobalPlanner {
 public:
  GlobalPlanner() = default;
  virtual ~GlobalPlanner() = default;
  GlobalPlanner(const GlobalPlanner&) = delete;
  GlobalPlanner& operator=(const GlobalPlanner&) = delete;
  GlobalPlanner(GlobalPlanner&&) = delete;
  GlobalPlanner& operator=(GlobalPlanner&&) = delete;

  virtual PlanResult plan(const PlanRequest& request) = 0;
};

/// `use_final_approach_orientation`: sets the last heading to the direction of the last segment, or
/// of the one before if it has no length; a single pose gets the start's heading.
void setFinalApproachHeading(Path& path, double startHeading);

/// The single pose of a path whose start and goal coincide.
Pose2 singlePose(const Pose2& start, const Pose2& goal, bool useFinalApproachOrientation);

/// The result if no search is needed: a pose is off the map, or both are in the same cell.
std::optional<PlanResult> planWithoutSearch(const PlanRequest& request, const Costmap& costmap,
                                            bool useFinalApproachOrientation);

/// The available planners by the names of Nav2's plugin classes.

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

/// The class of that name in another package, or the one with the nearest name; "" if there is
/// none.
std::string nearestPlugin(const std::string& name, const std::vector<std::string>& available);

/// Looks up a class name in both spellings, "package::Class" and "package/Class"; does not trim
/// white space.
template <class Parameters>
PluginLookup<Parameters> findPlugin(const std::string& className,
                                    const PluginClasses<Parameters>& available) {
  const std::string name = normalizedPluginClass(className);
  const auto parameters = defaultsOf(available, name);
  return {parameters, parameters ? name : nearestPlugin(name, namesOf(available)), ""};
}

/// Readers iterate over the keys with `std::visit([](auto& p) { … keysOf(p) … ignoredKeysOf(p) … },
/// *answer.parameters)`.
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
using PlannerPointer = std::unique_ptr<GlobalPlanner>;
PlannerPointer makeGlobalPlanner(const GlobalPlannerParameters& parameters, Distro distro);
PlannerPointer makeGlobalPlanner(const NavfnParameters& parameters, Distro distro);
PlannerPointer makeGlobalPlanner(const ThetaStarParameters& parameters, Distro distro);
PlannerPointer makeGlobalPlanner(const Smac2DParameters& parameters, Distro distro);
PlannerPointer makeGlobalPlanner(const SmacHybridParameters& parameters, Distro distro);
PlannerPointer makeGlobalPlanner(const SmacLatticeParameters& parameters, Distro distro);

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

}  // namespace sim2d::nav2
