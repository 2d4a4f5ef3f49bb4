#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Registry.h"
#include "sim2d/base/Result.h"
#include "sim2d/base/StopFlag.h"
#include "sim2d/base/TreeResults.h"
#include "sim2d/map/CostGrid.h"
#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

namespace sim2d {

/// Result of the navigation to a goal, for planners that decide themselves when a goal is over; the
/// result of a navigator action as Nav2 reports it to its client.
struct NavigationResult {
  bool hasSucceeded = false;
  /// Why it failed, by name: "planner NO_VALID_PATH (208)"; empty on success.
  std::string reason;
  std::string message;    // the same as a sentence; empty: none
  int errorCode = 0;      // Nav2 error code; 0: none
  std::size_t goals = 1;  // number of goals that this result ends, starting with the current one
};

/// Local planners of robots, and their registry.

/// A trajectory that a planner evaluated, for display.
struct Candidate {
  std::vector<Vec2> points;  // [m], starting at the robot
  double cost = 0.0;         // lower is better; infinite: collision
  bool isChosen = false;
  /// Cost by component, in the planner's own terms: "PathAlign", 3.2. The values add up to the
  /// cost; empty: not reported.
  std::vector<std::pair<std::string, double>> scores{};
};

/// Which debug data a planner collects, for display only: the planner's behaviour does not depend
/// on it, and data that is not displayed costs no time. May be set from any thread.
struct PlannerDebugFlags {
  std::atomic<bool> costs{false};  // costmaps and masks of `PlannerView`
  std::atomic<bool> ways{false};   // optional `candidates` and the rest
};

/// Planner state beside the path, for display. World frame [m].
struct PlannerView {
  CostGridPtr localCosts, globalCosts;  // null: none, or not watched
  std::vector<MaskGrid> masks;          // of costmap filters, if costs are watched
  std::string controller;               // "FollowPath"; empty: the planner itself
  std::vector<Vec2> lookahead;          // points that it aims at; the first is the current one
  std::vector<Vec2> predicted;          // predicted trajectory
};

/// Behaviour tree state for the recording: paths of nodes, and their status after the last step.
struct TreeStatus {
  std::shared_ptr<const std::vector<std::string>> paths;
  std::vector<base::NodeStatus> statuses;  // same order
};

/// An event of a planner for the recording of a run.
struct PlannerEvent {
  enum class Kind : std::uint8_t { Dock, Photo };
  Kind kind = Kind::Dock;
  std::string text;  // "docked dock1", "1.00 2.00 0.50"
};

constexpr const char* kNav2Planner = "nav2";
/// Planners that run external code.
constexpr const char* kExternalPlanner = "external";
constexpr const char* kLibraryPlanner = "library";
constexpr const char* kOnnxPlanner = "onnx";  // reads a file that is data, not code

/// How programs and libraries that a scenario names are handled. A scenario file alone never runs
/// code: the user must allow it (--allow-code, or a prompt in the window).
enum class ExternalCodePolicy {
  Refused,  // an error
  Skipped,  // nothing is started and the robot stands still, for validation only
  Allowed
};

/// Files and values of the planner `nav2`; empty: Nav2 defaults.
struct Nav2Config {
  std::vector<std::string> params;                          // files and `name:=value`, in order
  std::string tree;                                         // path of a tree file
  std::optional<nav2::Distro> distro;                       // none: as given by the file
  std::vector<std::pair<std::string, std::string>> values;  // "FollowPath.temperature", YAML
  /// "12 controller_selector FollowPath2; 20 /pause": topics published at a time [s].
  std::string topics{};
};

/// Local planner of one robot. Not thread-safe. Equal observations in the same order give
/// bit-identical commands.
class Planner {
 public:
  virtual ~Planner() = default;
  Planner() = default;
  Planner(const Planner&) = delete;
  Planner& operator=(const Planner&) = delete;
  Planner(Planner&&) = delete;
  Planner& operator=(Planner&&) = delete;

  /// Called once per step while the robot has a goal. The world limits the command to what the
  /// drive can do. An error ends the run.
  virtual base::Result<BodyTwist> command(const Observation& observation) = 0;
  /// False: `Observation::scan` is never read, and no scans need to be computed for it.
  virtual bool readsScan() const { return true; }
  /// False: `command` is also called without a goal and after the last one; the goal is then the
  /// robot's position.
  virtual bool needsGoal() const { return true; }
  /// The path that it follows now, for display, starting at the robot.
  virtual std::vector<Vec2> path() const { return {}; }
  /// Trajectories that it evaluated in the last call, for display; a sample if there are many.
  virtual std::vector<Candidate> candidates() const { return {}; }
  /// Selects the debug data to collect from the next call on.
  virtual void watch(bool /*costs*/, bool /*ways*/) {}
  virtual PlannerView view() const { return {}; }
  /// Sets the seed for further draws. No effect for planners without random draws and for external
  /// ones.
  virtual void reseed(std::uint64_t /*seed*/) {}
  /// True if it replanned, or was stuck, since the last call.
  virtual bool takeReplanned() { return false; }
  /// Number of goals that it passed without being inside their `goalRadius`, since the last call;
  /// they count as reached. The last goal is never included.
  virtual std::size_t takePassedGoals() { return 0; }
  /// True: a goal is over when `takeNavigationResult` reports it. False: when the robot's true
  /// position is within `goalRadius` of it.
  virtual bool decidesGoalEnd() const { return false; }
  /// Result of the navigation to the current goal, if the last call of `command` ended it. The next
  /// call of `command` is then for another goal.
  virtual std::optional<NavigationResult> takeNavigationResult() { return std::nullopt; }
  /// True if it requested a global localisation since the last call.
  virtual bool takeRelocalizationRequest() { return false; }
  /// True: `takeMap` is called before the first step.
  virtual bool needsMap() const { return false; }
  /// Sets the known map: the map file with the drawn obstacles, doors open. Returns its problems.
  virtual base::Diagnostics takeMap(const OccupancyGrid& /*map*/) { return {}; }
  /// True: `Observation::teleop` (the command of a user) is an input of the planner instead of
  /// replacing its command.
  virtual bool usesTeleop() const { return false; }
  /// Events since the last call, for the recording; see EventKind::Photo and Dock.
  virtual std::vector<PlannerEvent> takeEvents() { return {}; }
  /// Behaviour tree that drives the robot; null: none.
  virtual const TreeStatus* tree() const { return nullptr; }
  /// What the nodes of its trees have returned since the beginning, also of trees that are not
  /// recorded; the owner is left empty.
  virtual std::vector<base::TreeResults> treeResults() const { return {}; }
  /// Additional content of the run manifest, as JSON; empty: none.
  virtual std::string manifestJson() const { return {}; }
};

/// Stands still; replaces a planner that must not be started.
class IdlePlanner : public Planner {
 public:
  base::Result<BodyTwist> command(const Observation&) override { return BodyTwist{}; }
};

/// Arguments for constructing a planner.
struct PlannerSetup {
  std::string robot;  // name of the robot, for error messages
  RobotBody body;
  std::vector<std::pair<std::string, double>> parameters;  // given values, already checked
  std::vector<std::pair<std::string, std::string>> texts;  // same, for specs of type Text
  Nav2Config nav2;
  double goalRadius = 0.2;  // [m]
  double dt = 0.05;         // [s], time step of the world
  std::uint64_t seed = 1;
  int robotId = -1;  // random draws depend on this and the seed
  bool hasLidar = false;
  std::string command;  // program of an external planner; see `splitCommandLine`
  std::string folder;   // base of relative paths; empty: current directory
  ExternalCodePolicy code = ExternalCodePolicy::Refused;
  std::vector<DockPose> docks;                     // of the scenario, in order
  std::vector<std::pair<std::string, int>> names;  // names and ids of people and robots
  base::StopFlagPtr stop =
      std::make_shared<const base::StopFlag>();  // interrupts waits, with base::Stopped
};

constexpr const char* kFileParameter = "file";
/// The parameter `file`: a text, empty by default.
base::ParameterSpec fileSpec(std::string help);
/// Path of the file given by a text parameter, resolved against the folder of the setup; empty if
/// not given.
std::string fileParameter(const PlannerSetup& setup, const std::string& key);

/// The problems with the robot's name as context.
base::Diagnostics withRobotName(const std::string& robot, base::Diagnostics problems);

/// Each file in planners/ registers its planner in `add<File>`; errors contain the robot's name.
using PlannerFactory = std::function<base::Result<std::shared_ptr<Planner>>(const PlannerSetup&)>;
using PlannerRegistry = base::Registry<PlannerFactory>;

}  // namespace sim2d
