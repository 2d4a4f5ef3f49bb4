#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Registry.h"
#include "sim2d/base/Result.h"
#include "sim2d/base/Stop.h"
#include "sim2d/map/CostGrid.h"
#include "sim2d/nav/NavigationEnd.h"
#include "sim2d/nav/Observation.h"
#include "sim2d/nav/external/CodePermission.h"
#include "sim2d/nav/nav2/Nav2Key.h"

/// Local planners of robots, and how they are chosen by name.
namespace sim2d {

/// A way that a planner has weighed, for display.
struct Candidate {
  std::vector<Vec2> points;  // [m], the robot's place first
  double cost = 0.0;         // the less the better; infinite: would hit something
  bool isChosen = false;
  /// What each part of the cost came to, in the planner's own words: "PathAlign", 3.2. They add up
  /// to the cost; none: the planner does not tell.
  std::vector<std::pair<std::string, double>> scores{};
};

/// What of a planner is looked at, for display alone: nothing that it does depends on it, what
/// nobody looks at costs no time. Switched in any thread.
struct PlannerWatch {
  std::atomic<bool> costs{false};  // `PlannerView::localCosts`, `globalCosts`
  std::atomic<bool> ways{false};   // `candidates` of planners that gather them only then; the rest
};

/// What a planner knows beside its path, for display. World frame [m].
struct PlannerView {
  CostGridPtr localCosts, globalCosts;  // while watched; null: it has none
  std::string controller;               // which part of it drives: "FollowPath"; empty: itself
  std::vector<Vec2> lookahead;          // what it aims at, the first is followed
  std::vector<Vec2> predicted;          // where it means to go
};

/// A behaviour tree as a record wants it: paths of nodes, and what each returned in the last step.
struct DrivingTree {
  std::shared_ptr<const std::vector<std::string>> paths;
  std::vector<base::NodeStatus> statuses;  // beside them
};

/// Something that a planner did and that belongs into the record of a run.
struct PlannerEvent {
  enum class Kind : std::uint8_t { Dock, Photo };
  Kind kind = Kind::Dock;
  std::string text;  // "docked dock1", "1.00 2.00 0.50"
};

constexpr const char* kNav2Planner = "nav2";

/// Files and values of the planner `nav2`; empty: Nav2's own.
struct Nav2Choice {
  std::vector<std::string> params;                          // files and `name:=value`, in order
  std::string tree;                                         // a file
  std::optional<nav2::Distro> distro;                       // none: as the file tells
  std::vector<std::pair<std::string, std::string>> values;  // "FollowPath.temperature", YAML
  /// "12 controller_selector FollowPath2; 20 /pause": what is published, when [s].
  std::string topics{};
};

/// A local planner of one robot. Thread: one at a time. Equal observations in the same order give
/// equal commands, to the bit.
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
  /// False: it never looks at `Observation::scan`, and no turns need be made for it.
  virtual bool readsScan() const { return true; }
  /// False: it is asked without a goal too, and after the last one; the goal is the robot's place.
  virtual bool needsGoal() const { return true; }
  /// What it follows now, for display; the robot's place first.
  virtual std::vector<Vec2> path() const { return {}; }
  /// What it weighed in the last call, for display; a sample of it when there is much.
  virtual std::vector<Candidate> candidates() const { return {}; }
  /// From the next call on these are told.
  virtual void watch(bool /*costs*/, bool /*ways*/) {}
  virtual PlannerView view() const { return {}; }
  /// Draws by another seed from now on. Planners that draw nothing, and those outside, stay as they
  /// are.
  virtual void reseed(std::uint64_t /*seed*/) {}
  /// It planned anew, or does not get on, since the last call.
  virtual bool takeReplanned() { return false; }
  /// Goals that it has driven through without being inside `goalRadius` of them, since the last
  /// call; they count as reached. The last goal never does.
  virtual std::size_t takePassedGoals() { return 0; }
  /// True: a goal is over when `takeEnd` reports it. False: when the robot's true position is
  /// within `goalRadius` of it.
  virtual bool endsGoals() const { return false; }
  /// The result of the navigation to the current goal, if the last call of `command` ended it.
  /// Afterwards the goal is over: the next call of `command` is for another one.
  virtual std::optional<NavigationEnd> takeEnd() { return std::nullopt; }
  /// It has asked for a global localisation since the last call.
  virtual bool takeRelocalization() { return false; }
  /// It drives by a map of its own: `takeMap` is called before the first step.
  virtual bool wantsMap() const { return false; }
  /// The known map: that of the file with the obstacles that are drawn, doors open. Problems of it.
  virtual base::Diagnostics takeMap(const OccupancyGrid& /*map*/) { return {}; }
  /// It wants `Observation::teleop`: commands of a person are its input instead of replacing its
  /// own.
  virtual bool wantsTeleop() const { return false; }
  /// Events since the last call, for the record: what was done, see EventKind::Photo and Dock.
  virtual std::vector<PlannerEvent> takeEvents() { return {}; }
  /// The behaviour tree that drives it, where one does; null: none does.
  virtual const DrivingTree* tree() const { return nullptr; }
  /// What a manifest should tell beside the parameters, as JSON; empty: nothing.
  virtual std::string reportJson() const { return {}; }
};

/// All that a planner is made of.
struct PlannerSetup {
  std::string robot;  // its name, for errors
  RobotBody body;
  std::vector<std::pair<std::string, double>> parameters;  // given ones, checked against the specs
  std::vector<std::pair<std::string, std::string>> texts;  // idem, of specs of type Text
  Nav2Choice nav2;
  double goalRadius = 0.2;  // [m]
  double dt = 0.05;         // [s], step of the world
  std::uint64_t seed = 1;
  int robotId = -1;     // with the seed: whose draws
  std::string command;  // the program of an external planner, see `commandWords`
  std::string folder;   // where relative files begin; empty: the current one
  CodeUse code = CodeUse::Refused;
  std::vector<DockPlace> docks;                    // of the scenario, in its order
  std::vector<std::pair<std::string, int>> names;  // of people and robots, with their ids
  base::StopFlagPtr stop =
      std::make_shared<const base::StopFlag>();  // ends waits, by base::Stopped
};

/// The file that a text names, empty: none does. Relative ones begin in the folder of the setup.
std::string fileOf(const PlannerSetup& setup, const std::string& key);

/// A file in planners/ registers its own in `add<File>`; errors name the robot.
using PlannerMaker = std::function<base::Result<std::shared_ptr<Planner>>(const PlannerSetup&)>;
using PlannerRegistry = base::Registry<PlannerMaker>;

}  // namespace sim2d
