#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/trace/Trace.h"
#include "sim2d/world/Compatibility.h"
#include "sim2d/world/GoalEnd.h"
#include "sim2d/world/HumanBehavior.h"
#include "sim2d/world/Registries.h"
#include "sim2d/world/StepTimes.h"

namespace sim2d {

/// All that a run depends on. Options of the command line that have a key in the scenario (seed,
/// dt, model …) are written into `scenario` before.
struct WorldSetup {
  std::shared_ptr<const Scenario> scenario;
  OccupancyGrid map;  // without `surroundings`
  /// Of this scenario on its map. Worlds that share them share what is worked out for routes.
  std::shared_ptr<const Surroundings> surroundings;
  std::shared_ptr<const Registries> registries;  // null: the program's
  Compatibility compatibility;
  int threads = 1;
  bool exact = false;
  std::unique_ptr<HumanBehavior> behavior;
  CodeUse code = CodeUse::Refused;  // programs and libraries that robots name
  std::string folder;               // where relative files of planners begin
  /// Ends the waiting for a planner in another program, by `base::Stopped`.
  base::StopFlagPtr stop = std::make_shared<const base::StopFlag>();
};

/// How far a robot has come on the way to its last goal.
struct RobotOnWay {
  int id = -1;
  std::string name;
  bool hasGoal = false;
  double setsOff = 0.0;           // [s]
  std::optional<double> arrived;  // [s]
  std::optional<double> stuck;    // [s]; not any more: none
  /// When the last goal was over without an arrival: a goal was given up, or missed [s].
  std::optional<double> ended{};
  bool endsGoals = false;           // its planner decides when a goal is over
  std::vector<GoalEnd> goalEnds{};  // results of that planner, oldest first
};

/// The running world. One step (fixed dt):
///  1 inputs from outside; then those of the scenario whose time has come (doors that toggle,
///    people who start, sources), which are seen in the frame of that very time already
///  2 neighbour grid from the frozen state
///  3 HumanBehavior::decide in id order -> intents
///  4 robots: observation -> controller -> Twist2
///  5 forces: read the frozen state, write the own column only
///  6 desired velocities
///  7 Box2D step, read poses back
///  8 way points, goals, events
///  9 ++stepIndex; time = stepIndex * dt
/// No global state; two worlds may live in one process, each used by one thread at a time.
class World {
 public:
  /// Errors: what makes a run impossible (place for a start, model, planner …); warnings otherwise
  /// (moved starts, keys without effect).
  static base::Result<std::unique_ptr<World>> create(WorldSetup setup);
  virtual ~World() = default;

  /// `inputs` act before anybody decides, in their order; they are in the frame of the step.
  /// False when the run has failed (diverged): `failure` says who and why; the last good state
  /// stays.
  virtual bool step(const StepInputs& inputs = {}) = 0;
  virtual const std::string& failure() const = 0;
  /// Inputs of the last step that could not be (nobody has that id, no such door …), left out.
  virtual const base::Diagnostics& refused() const = 0;
  /// From now on every step adds its times to `times`; nullptr: no more.
  virtual void measure(StepTimes* times) = 0;

  /// From the next step on robots have the planners, limits, goals and patience of those of
  /// `other`: a world of the same scenario but for these, not stepped yet, and of no use
  /// afterwards. A planner that is the same goes on as it is; a robot with other goals sets off for
  /// the first. `seed`: of what is drawn from here on; people stay as their own seed drew them.
  virtual void goOnAs(World& other, std::uint64_t seed) = 0;

  /// From the next step on frames have the senses of robots and the ways of people, or no more.
  virtual void tellSenses(bool wanted) = 0;
  /// The same of what robots believe and scan alone: senses without bodies and ways, unless those
  /// are wanted too. Scans that neither planner nor record looks at are `laterScan`.
  virtual void tellScans(bool wanted) = 0;
  /// With them, of planners, what is switched on there at each step; null: no costs, no ways of
  /// planners that gather them for display only.
  virtual void watchPlanners(std::shared_ptr<const PlannerWatch> watch) = 0;

  virtual const Frame& frame() const = 0;  // after the last step; valid until the next
  std::int64_t stepIndex() const { return frame().step; }
  double time() const { return frame().time; }
  double dt() const { return view().dt(); }
  /// All robots have arrived (false without a moving robot), and since when [s].
  virtual std::optional<double> arrivedAt() const = 0;
  /// The same, but robots whose planners have ended their last goals without an arrival count too.
  virtual std::optional<double> finishedAt() const = 0;
  virtual std::vector<RobotOnWay> robotsOnWay() const = 0;  // -1, -2 …
  /// What their planners want a manifest to tell, as JSON; empty: nothing.
  virtual std::vector<std::string> robotReports() const { return {}; }  // -1, -2 …
  virtual TraceHeader header() const = 0;                               // as of now
  virtual const Obstacles& obstacles() const = 0;  // now; parts as in the header
  virtual const WorldView& view() const = 0;
  virtual HumanBehavior& behavior() = 0;
};

}  // namespace sim2d
