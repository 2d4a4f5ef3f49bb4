#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/Teleop.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/trace/Recording.h"
#include "sim2d/world/HumanBehavior.h"
#include "sim2d/world/Runner.h"

namespace app {

class RunWriter;
struct FinishedRun;
struct MetricsSetup;

using WorldFactory = std::function<base::Result<std::unique_ptr<sim2d::World>>()>;
using RecordingPtr = std::shared_ptr<const sim2d::Recording>;

/// Keys and values of a blackboard as text.
using BlackboardEntries = std::vector<std::pair<std::string, std::string>>;

/// The blackboard of one agent after a step.
struct BlackboardStep {
  std::int64_t step = 0;
  BlackboardEntries entries;
};

/// Changes of a session since the last takeUpdate().
struct SessionUpdate {
  std::optional<base::Diagnostics> remarks;  // of creating the world; with errors it does not exist
  RecordingPtr history;  // of this run, once the world exists; still being written
  sim2d::FramePtr newest;
  std::optional<double> measuredSpeed;                    // [simulated s / wall s]
  std::optional<sim2d::RunResult> result;                 // the run has ended
  bool isStopped = false;                                 // creation cancelled: the map has changed
  std::optional<bool> isPaused;                           // set if changed since then
  std::optional<double> speed;                            // set if changed since then
  std::optional<sim2d::TreeBreakpointHit> breakpointHit;  // the breakpoint at which the run pauses
  std::optional<BlackboardEntries> entries;       // of the watched agent after the newest step
  std::vector<BlackboardStep> blackboardHistory;  // its changes since then
  base::Diagnostics refused;                      // inputs that could not be applied
};

/// One run of a world, for the commands and the window: steps until its stop rule holds, at a set
/// speed, with external inputs and optional history. One thread calls run(); other threads send
/// commands and inputs, which take effect between two steps.
class Session {
 public:
  using FrameCallback = std::function<void(const sim2d::Frame&)>;

  explicit Session(const sim2d::StopRule& rule) : rule_(rule) {}
  const sim2d::StopRule& rule() const { return rule_; }

  // Run thread only.
  /// Enables the history: each state is recorded immediately, and takeUpdate() reports the newest
  /// one. `mostInMemory`, `folder`: see Recording.
  void enableHistory(int recordEvery, std::size_t mostInMemory = sim2d::Recording::kDefaultMemory,
                     const std::string& folder = {}) {
    history_ = std::make_shared<sim2d::Recording>(recordEvery, mostInMemory, folder);
  }
  /// Null if disabled; complete when the run has ended.
  RecordingPtr history() const { return history_; }
  /// Replays these inputs up to step `until`, regardless of speed and pauses; afterwards the run
  /// behaves as if it started there.
  void replayInputs(sim2d::RecordedInputs inputs, std::int64_t until) {
    replayedInputs_ = std::move(inputs);
    replayUntil_ = until;
  }
  /// Receives each state before the next step, in the run thread, and may change the world.
  using StepHook = std::function<void(const sim2d::Frame&, sim2d::World&)>;
  void setStepHook(StepHook change) { stepHook_ = std::move(change); }
  /// Receives the newest state again whenever `refresh` is called and whenever a pause begins;
  /// between two steps, in the run thread, not during a replay.
  void setRefreshCallback(FrameCallback watch) { refreshCallback_ = std::move(watch); }
  /// Call once. `watch` receives each state before the next step and may send commands; `sink`
  /// receives all states, the last one with the event `stop`.
  sim2d::RunResult run(sim2d::World& world, sim2d::FrameSink* sink = nullptr,
                       const FrameCallback& watch = {});
  /// Like the above, but creates the world first; takeUpdate() reports the results. Observers are
  /// created with the world and destroyed before it; each receives every state, including the last,
  /// and supplies inputs before each step that is not replayed.
  struct Observer {
    FrameCallback watch;
    std::function<sim2d::StepInputs(const sim2d::Frame&)> steer;  // null: no inputs
  };
  using ObserverFactory = std::function<std::vector<Observer>(sim2d::World&)>;
  void run(const WorldFactory& makeWorld, const ObserverFactory& makeObservers = {});

  // Any thread.
  void setPaused(bool paused);
  bool isPaused();
  void stepOnce();               // one step while paused
  void setSpeed(double factor);  // > 0; infinity = as fast as possible (default)
  double speed();
  void stop();
  void refresh();                // also while paused
  void add(sim2d::Input input);  // takes effect in the next step
  /// Called before each step in the run thread for inputs in addition to those of add().
  using Steering = std::function<sim2d::StepInputs(const sim2d::Frame&)>;
  void steer(Steering steering);
  /// Pauses after a step in which one of these is hit; not during a replay.
  void setBreakpoints(std::vector<sim2d::TreeBreakpoint> points);
  void watchBlackboard(std::optional<int> person);  // agent id
  SessionUpdate takeUpdate();

 private:
  class FrameDistributor;
  void runCreatedWorld(const base::Result<std::unique_ptr<sim2d::World>>& made,
                       const ObserverFactory& makeObservers);
  sim2d::RunResult runWithObservers(sim2d::World& world, std::vector<Observer> guests);
  using Clock = std::chrono::steady_clock;
  template <class Change>
  void applyCommand(Change change);
  bool waitForNextStep(sim2d::World& world);
  void refresh(const sim2d::World& world, std::unique_lock<std::mutex>& lock);
  void applyTreeRequests(sim2d::HumanBehavior& behavior, const sim2d::WorldView& view);
  sim2d::StepInputs takeInputs(const sim2d::Frame& frame);
  void updateMeasuredSpeed(double time);
  bool isDue(double time, double dt);
  Clock::time_point dueTime(double time, double dt) const;
  void restartClock(double time);

  const sim2d::StopRule rule_;
  std::shared_ptr<sim2d::Recording> history_;
  sim2d::RecordedInputs replayedInputs_;
  std::int64_t replayUntil_ = 0;
  StepHook stepHook_;
  FrameCallback refreshCallback_;
  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by mutex_.
  bool paused_ = false, stop_ = false, restartClock_ = true;
  bool wantsRefresh_ = false;
  int pendingSteps_ = 0;
  double speed_ = std::numeric_limits<double>::infinity();
  sim2d::StepInputs inputs_;
  Steering steering_;
  std::optional<std::vector<sim2d::TreeBreakpoint>> breakpoints_;  // not yet passed to the world
  std::optional<int> watchedAgent_;
  bool wantsBlackboard_ = false;
  std::optional<BlackboardEntries> lastBlackboard_;  // of the watched agent, as last reported
  SessionUpdate update_;
  // Run thread only.
  std::vector<Observer> observers_;
  Clock::time_point wallStart_;
  double simulatedStart_ = 0.0;
  Clock::time_point measureStart_;
  double measuredFrom_ = 0.0;
};

/// Manual control of a robot in a running world. Commands become an input of each step, which
/// overrides the planner and is recorded. The limits of the robot apply. Commands: any thread;
/// `inputs`: the run thread.
class ManualDrive {
 public:
  /// `robot`: id as in frames (-1, -2 …).
  ManualDrive(int robot, const sim2d::RobotBody& body);

  int robot() const { return robot_; }
  void drive(const sim2d::BodyTwist& twist);  // until the next command; zero brakes
  void driveTo(const base::Vec2& point);      // drives there and stops
  void releaseControl();                      // returns control to the planner

  /// The inputs for the step after this frame; empty after releaseControl() or when the frame does
  /// not contain the robot.
  sim2d::StepInputs inputs(const sim2d::Frame& frame);

 private:
  const int robot_;
  std::shared_ptr<sim2d::TeleopPlanner> planner_;
  std::atomic<bool> isActive_{false};
};

enum class PlanningClock : bool { Off, On };

/// Runs a world to its end, for `run` and `batch`: feeds the writer, measures planning time if
/// `clock` is On, and computes the metrics. `wantsStop` receives each state; the run also stops
/// when the writer fails. `setup`: metrics of the scenario, for the header of the recording.
FinishedRun simulate(Session& session, sim2d::World& world, const MetricsSetup& setup,
                     RunWriter& writer, const std::function<bool(const sim2d::Frame&)>& wantsStop,
                     PlanningClock clock = PlanningClock::On);

}  // namespace app
