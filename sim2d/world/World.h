#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/world/PersonMotion.h"
#include "sim2d/world/Physics.h"
#include "sim2d/world/Placement.h"
#include "sim2d/world/RobotDrive.h"
#include "sim2d/world/WorldInternal.h"

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
  /// Permission for programs and libraries of robots.
  ExternalCodePolicy code = ExternalCodePolicy::Refused;
  std::string folder;  // base of relative paths of planners
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
///  4 robots: observation -> controller -> velocity command
///  5 forces: read the frozen state, write the own column only
///  6 desired velocities
///  7 Box2D step, read poses back
///  8 way points, goals, events
///  9 ++stepIndex; time = stepIndex * dt
/// No global state; several worlds may exist in one process, each used by one thread at a time.
class World : public WorldBase {
 public:
  /// Errors: conditions that make a run impossible (start place, model, planner …); warnings
  /// otherwise (moved starts, keys without effect).
  static base::Result<std::unique_ptr<World>> create(WorldSetup setup);
  /// For `create`.
  World(WorldParts parts, std::unique_ptr<HumanBehavior> humanBehavior);

  /// `inputs` are applied in order before all decisions; they are part of the frame of the step.
  /// Returns false if the run has failed (diverged): `failure` contains the agent and the reason;
  /// the last good state is kept.
  bool step(const StepInputs& inputs = {});
  const std::string& failure() const { return failure_; }
  /// Inputs of the last step that were rejected (unknown id, unknown door …).
  const base::Diagnostics& refused() const { return refused_; }
  /// Adds the times of each following step to `times`; nullptr: stops this.
  void measure(StepTimes* times) { times_ = times; }

  /// From the next step on the robots take planners, limits, goals and patience from those of
  /// `other`: a world of the same scenario except for these, not stepped yet, and unusable
  /// afterwards. An unchanged planner continues as it is; a robot with other goals starts with the
  /// first. `seed`: for all draws from now on; properties of people drawn earlier are kept.
  void continueWith(World& other, std::uint64_t seed);

  /// Enables or disables robot perception and paths of people in frames, from the next step on.
  void publishSensors(bool wanted) {
    robots_.publishSensors(wanted);
    publishesPaths_ = wanted;
  }
  /// Same for estimated poses and scans only: perception without bodies and candidate trajectories,
  /// unless those are enabled too. Scans that neither planner nor recording reads are
  /// `deferredScan`.
  void enableScans(bool wanted) { robots_.enableScans(wanted); }
  /// Debug data of planners to include, read at each step; null: no cost grids and no optional
  /// candidate trajectories.
  void setPlannerDebug(std::shared_ptr<const PlannerDebugFlags> watch) {
    robots_.setPlannerDebug(std::move(watch));
  }

  const Frame& frame() const { return frame_; }  // after the last step; valid until the next
  std::int64_t stepIndex() const { return frame().step; }
  double time() const { return frame().time; }
  double dt() const { return view().dt(); }
  /// Time at which all robots had arrived [s]; none without a moving robot.
  std::optional<double> arrivedAt() const;
  /// Same, but robots whose planners ended the last goals without an arrival count too.
  std::optional<double> finishedAt() const;
  std::vector<RobotStatus> robotStatuses() const;  // -1, -2 …
  /// What the nodes of all behaviour trees have returned since the beginning: of people by id, then
  /// of robots.
  std::vector<base::TreeResults> treeResults() const;
  /// Additional manifest content of the planners, as JSON; empty: none.
  std::vector<std::string> plannerReports() const;  // -1, -2 …
  TraceHeader header() const;                       // current
  /// Current; parts as in the header.
  const Obstacles& obstacles() const { return surroundings_.obstacles; }

 private:
  /// What a body may touch; the solver handles all bodies except `Nothing`.
  enum class Nearness : std::uint8_t { Nothing, Person, Solid };

  void addRobotBodies();
  /// Applies external inputs; `acceptedInputs_` contains the accepted ones.
  void take(const StepInputs& inputs);
  /// Returns the problem of the input; empty: accepted.
  std::string take(Input& input);
  std::string applyToPerson(const Input& input);
  std::string fitRobot(Input& input) const;
  std::string teleportRobot(Input& input);
  std::string setExternalGoal(Input& input);
  std::string setBlackboardEntry(int human, const std::string& words);
  void applyHolds();
  bool hadGoal(std::size_t robot) const;
  /// Latest of the times of all robots that had goals; none if one of them is negative.
  std::optional<double> latestTime(const std::function<double(const RobotState&)>& timeOf) const;
  std::string spawnCopy(Input& input);
  /// Door toggles and people whose time has come; then the grid.
  void applyInputs(StepTimer& watch);
  void toggleDoors();
  void setDoor(std::size_t door, bool open);
  void updateNavigation();
  void place(const std::vector<std::size_t>& newcomers);
  void teleportPerson(std::size_t human, const Pose2& pose, const Vec2& velocity);
  void enter(std::size_t human);
  void leave(std::size_t human);
  void handleArrivals();
  void afterMotion();
  bool willDoorToggle() const;

  void decide();
  /// Reason of a failed step; empty: all numbers are valid.
  std::string divergenceMessage(const std::vector<BodyTwist>& commands) const;
  /// Desired velocity of a body, before contacts.
  Vec2 wantedVelocity(std::size_t body, const std::vector<BodyTwist>& commands) const;
  void moveBodies(const std::vector<BodyTwist>& commands);
  void placeDiscs(const std::vector<BodyTwist>& commands);
  void findPairs();
  void findNearness();
  bool isNearWallOrRobot(const MovingDisc& person) const;
  int subSteps() const;
  bool mayTouchAnything(std::size_t robot) const;
  bool mayTouch(const DiscPair& pair) const;
  std::string contactDescription(const Contact& touch,
                                 const std::vector<BodyTwist>& commands) const;
  void emitContacts(const std::vector<BodyTwist>& commands);
  void readPeople();
  Vec2 wrapIntoCorridor(std::size_t human, const Pose2& pose);
  void readRobots(const std::vector<BodyTwist>& commands);
  void publish();
  void publishPaths();

  /// Bodies are numbered: robots, then people in the order of entry.
  bool isRobot(std::size_t body) const { return body < model_.robots.size(); }
  std::size_t humanOf(std::size_t body) const { return humans_[body - model_.robots.size()]; }
  int idOf(std::size_t body) const;
  int bodyOf(std::size_t human) const { return bodies_[human]; }

  struct VelocityOverride {  // of a person, by an input
    std::size_t human = 0;
    Vec2 velocity = Vec2::Zero();  // [m/s]
    bool isBeside = false;         // added to the person's own desired velocity
  };

  Physics physics_;
  Population population_;
  RobotDrive robots_;
  StuckRobots stuckRobots_;
  Frame frame_;
  base::Diagnostics refused_;                        // rejected inputs of the last step
  StepTimes* times_ = nullptr;                       // null: not measured
  std::vector<VelocityOverride> velocityOverrides_;  // in this step
  StepInputs acceptedInputs_;                        // accepted inputs of this step
  std::vector<std::size_t> newcomers_;               // added by inputs of this step
  std::vector<std::size_t> pastToggles_;             // number of past toggle times per door
  bool doorsChanged_ = false;                        // since the last update of the navigation map
  bool publishesPaths_ = false;                      // include paths of people in frames
  std::vector<int> bodies_;                          // body per person; -1: never present
  std::vector<std::size_t> humans_;                  // person per body, after those of robots
  std::vector<Contact> contacts_, contactsBefore_;
  std::vector<std::string> partNames_;
  std::vector<Nearness> nearness_;  // per body, in this step
  std::vector<Vec2> chords_;        // mean direction of each robot in the step
  std::vector<double> robotRadii_;  // circumscribed radius of each robot [m]
  std::vector<std::vector<Obstacles::Point>> robotWalls_;  // near each robot
};

}  // namespace sim2d
