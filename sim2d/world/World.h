#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/trace/Trace.h"
#include "sim2d/world/Compatibility.h"
#include "sim2d/world/GoalResult.h"
#include "sim2d/world/HumanBehavior.h"
#include "sim2d/world/Registries.h"

namespace sim2d {

/// Phases of a step, in order.
enum class StepPhase : std::uint8_t {
  Trees,     // decisions of people
  Robots,    // observation and planner
  Ways,      // walking directions
  Forces,    // of people and walls on people, desired velocities
  Bodies,    // collision avoidance, Box2D
  Contacts,  // contact events
  Goals,     // reached goals, entering and leaving people, doors
  Grid,      // neighbour search
  Frame,     // output of the step
};
constexpr std::size_t kStepPhaseCount = 9;
inline const char* stepPhaseName(StepPhase phase) {
  constexpr std::array<const char*, kStepPhaseCount> kNames = {
      "trees", "robots", "ways", "forces", "bodies", "contacts", "goals", "grid", "frame"};
  return kNames[static_cast<std::size_t>(phase)];
}

enum class StepClock : std::uint8_t {
  Wall,
  Thread  // CPU time of the calling thread, less affected by other load
};
/// Seconds since an arbitrary fixed time.
inline double clockSeconds(StepClock clock) {
  if (clock == StepClock::Thread) {
    timespec time = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Time per phase, summed over the steps [s].
struct StepTimes {
  StepClock clock = StepClock::Wall;
  std::array<double, kStepPhaseCount> seconds = {};
  std::int64_t steps = 0;
  double sum() const { return std::accumulate(seconds.begin(), seconds.end(), 0.0); }
};

/// Measures the phases of a step. Without `times` it does nothing.
class StepTimer {
 public:
  explicit StepTimer(StepTimes* times) : times_(times) {
    if (times_ != nullptr) {
      last_ = clockSeconds(times_->clock);
    }
  }
  /// Adds the time since the last call, or construction, to `phase`.
  void lap(StepPhase phase) {
    if (times_ != nullptr) {
      const double now = clockSeconds(times_->clock);
      times_->seconds[static_cast<std::size_t>(phase)] += now - last_;
      last_ = now;
    }
  }

 private:
  StepTimes* times_;
  double last_ = 0.0;
};

/// Arguments of a run. Command-line options that correspond to a scenario key (seed, dt, model …)
/// are written into `scenario` beforehand.
struct WorldSetup {
  std::shared_ptr<const Scenario> scenario;
  OccupancyGrid map;  // used if `surroundings` is null
  /// Of this scenario on its map. Worlds with the same surroundings share routing data.
  std::shared_ptr<const Surroundings> surroundings;
  std::shared_ptr<const Registries> registries;  // null: those of the program
  Compatibility compatibility;
  int threads = 1;
  bool exact = false;
  std::unique_ptr<HumanBehavior> behavior;
  ExternalCodePolicy code =
      ExternalCodePolicy::Refused;  // permission for programs and libraries of robots
  std::string folder;               // base of relative paths of planners
  /// Interrupts waits for external planners, with `base::Stopped`.
  base::StopFlagPtr stop = std::make_shared<const base::StopFlag>();
};

/// Progress of a robot towards its last goal.
struct RobotStatus {
  int id = -1;
  std::string name;
  bool hasGoal = false;
  double startTime = 0.0;         // [s]
  std::optional<double> arrived;  // [s]
  std::optional<double> stuck;    // [s]; none when it progresses again
  /// Time at which the last goal ended without an arrival: a goal was abandoned or missed [s].
  std::optional<double> ended{};
  bool decidesGoalEnd = false;            // the planner decides when a goal is over
  std::vector<GoalResult> goalResults{};  // results of that planner, oldest first
};

/// The running world. One step (fixed dt):
///  1 external inputs; then scenario events whose time has come (door toggles, starting people,
/// sources), which are part of the frame of that time
///  2 neighbour grid from the frozen state
///  3 HumanBehavior::decide in id order -> intents
///  4 robots: observation -> controller -> Twist2
///  5 forces: read the frozen state, write the own column only
///  6 desired velocities
///  7 Box2D step, read poses back
///  8 way points, goals, events
///  9 ++stepIndex; time = stepIndex * dt
/// No global state; several worlds may exist in one process, each used by one thread at a time.
class World {
 public:
  /// Errors: conditions that make a run impossible (start place, model, planner …); warnings
  /// otherwise (moved starts, keys without effect).
  static base::Result<std::unique_ptr<World>> create(WorldSetup setup);
  virtual ~World() = default;

  /// `inputs` are applied in order before all decisions; they are part of the frame of the step.
  /// Returns false if the run has failed (diverged): `failure` contains the agent and the reason;
  /// the last good state is kept.
  virtual bool step(const StepInputs& inputs = {}) = 0;
  virtual const std::string& failure() const = 0;
  /// Inputs of the last step that were rejected (unknown id, unknown door …).
  virtual const base::Diagnostics& refused() const = 0;
  /// Adds the times of each following step to `times`; nullptr: stops this.
  virtual void measure(StepTimes* times) = 0;

  /// From the next step on the robots take planners, limits, goals and patience from those of
  /// `other`: a world of the same scenario except for these, not stepped yet, and unusable
  /// afterwards. An unchanged planner continues as it is; a robot with other goals starts with the
  /// first. `seed`: for all draws from now on; properties of people drawn earlier are kept.
  virtual void continueWith(World& other, std::uint64_t seed) = 0;

  /// Enables or disables robot perception and paths of people in frames, from the next step on.
  virtual void publishSensors(bool wanted) = 0;
  /// Same for estimated poses and scans only: perception without bodies and candidate trajectories,
  /// unless those are enabled too. Scans that neither planner nor recording reads are
  /// `deferredScan`.
  virtual void enableScans(bool wanted) = 0;
  /// Debug data of planners to include, read at each step; null: no cost grids and no optional
  /// candidate trajectories.
  virtual void setPlannerDebug(std::shared_ptr<const PlannerDebugFlags> watch) = 0;

  virtual const Frame& frame() const = 0;  // after the last step; valid until the next
  std::int64_t stepIndex() const { return frame().step; }
  double time() const { return frame().time; }
  double dt() const { return view().dt(); }
  /// Time at which all robots had arrived [s]; none without a moving robot.
  virtual std::optional<double> arrivedAt() const = 0;
  /// Same, but robots whose planners ended the last goals without an arrival count too.
  virtual std::optional<double> finishedAt() const = 0;
  virtual std::vector<RobotStatus> robotStatuses() const = 0;  // -1, -2 …
  /// Additional manifest content of the planners, as JSON; empty: none.
  virtual std::vector<std::string> plannerReports() const { return {}; }  // -1, -2 …
  virtual TraceHeader header() const = 0;                                 // current
  virtual const Obstacles& obstacles() const = 0;  // current; parts as in the header
  virtual const WorldView& view() const = 0;
  virtual HumanBehavior& behavior() = 0;
};

}  // namespace sim2d
