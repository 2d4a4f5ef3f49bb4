#pragma once

#include <future>

#include "app/run/RunBranch.h"
#include "app/run/RunSpec.h"
#include "app/run/Session.h"
#include "editor/document/ScenarioDocument.h"
#include "sim2d/world/Runner.h"

namespace editor {

using app::RecordingPtr;
using app::RunSettings;
using sim2d::FramePtr;

/// A run to be started.
struct RunRequest {
  app::WorldFactory makeWorld;    // Called in the worker thread, so it holds copies of all inputs.
  app::Session::StepHook change;  // Null: the run does not change.
  std::shared_ptr<base::StopFlag> left = std::make_shared<base::StopFlag>();  // Stops all waiting.
  sim2d::StopRule rule;
  int recordEvery = 1;
  std::function<RunRequest()> again;  // Creates the same run again; null: not possible.
  /// The inputs of the run; null: unknown, so that it cannot be branched.
  std::shared_ptr<const app::Bundle> bundle;
  std::vector<app::RunBranch> branches;
  RunScenarios scenarios;  // Null: unknown.
};

/// A run of the bundle with these branches.
RunRequest requestFor(app::Bundle bundle, std::vector<app::RunBranch> branches = {});

/// The first run or a branch, as stored by the runner.
struct RunnerBranch {
  int number = 0;  // 0: the first run.
  QString name;
  int from = -1;            // Number of the run from which it branched; -1: none.
  double branchTime = 0.0;  // Branch time [s].
  QString changed;          // Description of the changes; empty: none.
  // For branches that are not shown
  RecordingPtr recording;  // Null: not started yet.
  FramePtr newest;
  bool isFinished = false, isRecorded = false;
  std::optional<sim2d::RunResult> result;
  std::function<RunRequest()> again;
  RunScenarios scenarios;
};

/// A run of the document in its current state, with copies of scenario, map and trees. GUI thread.
/// A scenario with check errors does not run.
RunRequest runRequestOf(const ScenarioDocument& document, const RunSettings& settings = {});

/// Describes what ends a run if the scenario has no duration and a robot's goal makes the run
/// longer: "until the robot arrives, at most 120 s"; otherwise empty.
QString runEndText(const sim2d::Scenario& scenario);

/// A simulation that runs outside the GUI thread. The object lives in the GUI thread and owns one
/// worker thread with the session. States are read from its recording, which grows during the run
/// and equals that of a headless run. A finished or recorded run is played from its recording
/// without recomputation.
class SimulationRunner : public QObject {
  Q_OBJECT
 public:
  enum class State { Editing, Running, Paused };
  Q_ENUM(State)

  explicit SimulationRunner(QObject* parent = nullptr);
  ~SimulationRunner() override;  // Stops the run and waits for it.
  Q_DISABLE_COPY_MOVE(SimulationRunner)

  /// Called in the GUI thread when a run starts from Editing; takes a snapshot of the document.
  void setRequest(std::function<RunRequest()> request) { request_ = std::move(request); }

  /// Called in the GUI thread before a run starts from Editing, `paused` or not; false prevents the
  /// start.
  void setStartCondition(std::function<bool(bool paused)> mayStart) {
    startCondition_ = std::move(mayStart);
  }

  State state() const { return state_; }
  bool isFinished() const { return finished_; }  // Fully computed; played or paused.
  /// The result; none: still running, or recorded.
  const std::optional<sim2d::RunResult>& result() const { return result_; }
  double speed() const { return speed_; }
  double measuredSpeed() const { return measuredSpeed_; }  // Simulated s per wall-clock s.

  void play();  // From Editing: creates the world first; after the end: plays the recording.
  void pause();
  void stepOnce();  // One step, then paused; when looking back: one recorded frame forward.
  /// Ends the run and returns to Editing. Does not wait for a world that is still being created, or
  /// for a long step.
  void reset();
  void setSpeed(double factor);  // > 0; infinity = as fast as possible.
  /// The memory limit [B] for the states of future runs, as in `sim2d::Recording`, and the folder
  /// of the temporary file (empty: system default).
  void setHistory(std::size_t mostInMemory, std::string folder = {});
  std::size_t historyMemory() const { return historyMemory_; }  // [B]
  /// Creates the observers of future runs. They run in the session's thread and may control the
  /// run. Null: no observers.
  using ObserverFactory = std::function<std::vector<app::Session::Observer>(
      app::Session&, sim2d::World&, const std::shared_ptr<const app::Bundle>&)>;
  void setObserverFactory(ObserverFactory guests) { observerFactory_ = std::move(guests); }
  /// Sets the inputs of each step of the current run from now on.
  void steer(app::Session::Steering steering) {
    if (session_ != nullptr) {
      session_->steer(std::move(steering));
    }
  }

  /// The run, and future runs, pause at these breakpoints.
  void setBreakpoints(std::vector<sim2d::TreeBreakpoint> points);
  const std::vector<sim2d::TreeBreakpoint>& breakpoints() const { return breakpoints_; }
  /// The breakpoint at which the run is paused; none: not at a breakpoint.
  const std::optional<sim2d::TreeBreakpointHit>& currentBreak() const { return currentBreak_; }
  /// The person whose blackboard is recorded from now on, by id.
  void watchBlackboard(std::optional<int> person);
  /// For this and future runs: whether the newest states include planner costmaps, and trajectories
  /// that planners collect for display only. This is slower and does not change results.
  void setPlannerDebug(bool costs, bool ways) {
    watch_->costs = costs;
    watch_->ways = ways;
  }
  std::optional<int> watched() const { return watched_; }
  /// The blackboard of that person in the newest state of the current run; none: unknown.
  const std::optional<app::BlackboardEntries>& entries() const { return entries_; }
  /// The same for the shown state, which may be in the past; null: not recorded then. Also null for
  /// recorded runs, whose files contain no blackboards.
  const app::BlackboardEntries* shownEntries() const;

  /// Returns true if a run is in progress and its newest state is shown, so that inputs act in the
  /// next step.
  bool isLive() const {
    return state_ != State::Editing && session_ != nullptr && !finished_ && !lookingBack_ &&
           !isLooping_;
  }
  /// Adds an input that acts in the next step and is recorded. Does nothing without a current run.
  void addInput(sim2d::Input input) {
    if (isLive()) {
      session_->add(std::move(input));
    }
  }

  /// Shows a recorded run, which must contain states, from its beginning. reset() closes it.
  /// `again`: creates the same run; null: its inputs are unknown.
  void openRecorded(RecordingPtr recording, std::function<RunRequest()> again = {});
  bool isRecorded() const { return isRecorded_; }

  // History
  /// The recording of the run, which grows during the run; null: no run.
  RecordingPtr recording() const { return recording_; }
  FramePtr newestFrame() const { return newest_; }
  FramePtr shownFrame() const { return shown_; }
  bool isLookingBack() const { return lookingBack_; }
  /// Time of the oldest state that can still be shown [s]; 0 unless the disk was full.
  double oldestTime() const {
    const std::size_t first = recording_ == nullptr ? 0 : recording_->first();
    return first == 0 ? 0.0 : recording_->timeOf(first);
  }
  void seek(
      std::int64_t step);  // Shows the last kept frame up to the step, else the oldest; pauses.
  void stepBack() {
    if (shown_ != nullptr && shown_->step > 0) {
      seek(shown_->step - 1);
    }
  }
  void seekNewest() {
    if (lookingBack_ || isRecorded_) {
      show(newest_, false);
    }
  }
  /// Repeats this section once it contains a state; none: normal playback.
  struct LoopRange {
    double from = 0.0, to = 0.0;  // [s], from < to
    friend bool operator==(const LoopRange& a, const LoopRange& b) {
      return a.from == b.from && a.to == b.to;
    }
  };
  void setLoop(std::optional<LoopRange> loop);
  const std::optional<LoopRange>& loop() const { return loop_; }

  // Branches
  static constexpr std::size_t kMaxBranches = 9;  // Includes the first run.
  /// Re-runs up to the shown state as a new branch and pauses there, where the branch may diverge.
  /// Returns false if that is impossible; the reason is reported and nothing changes.
  bool branchFromShown(const app::RunSpec& changes = {}, const QString& name = {});
  /// Returns true if the run is reproducible and continues after the shown state, and another
  /// branch is allowed.
  bool canBranchFromShown() const {
    return recreate_ && shown_ != nullptr && (lookingBack_ || isRecorded_ || !finished_) &&
           branches_.size() < kMaxBranches;
  }
  /// Errors of a branch from the shown state with these changes; none: it is possible.
  base::Diagnostics branchProblems(const app::RunSpec& changes) const;
  /// All runs with the same beginning, in order of creation; empty while editing.
  const std::vector<RunnerBranch>& branches() const { return branches_; }
  int branch() const { return branch_; }  // Number of the shown branch; -1: none.
  /// The scenario of the shown run, which does not follow the document. Null: no run, or a recorded
  /// run.
  const RunScenarios& scenarios() const { return scenarios_; }
  /// The recording of any branch, also the shown one; null: none yet.
  RecordingPtr recordingOf(int branch) const;
  /// Shows another branch at the same time, paused. An unfinished branch is re-run up to its
  /// previous state.
  void showBranch(int number);
  void renameBranch(int number, const QString& name);
  void removeBranch(int number);  // Not the shown one.
  /// Creates the shown run again from its beginning; null: not possible.
  const std::function<RunRequest()>& again() const { return recreate_; }

 Q_SIGNALS:
  void stateChanged(editor::SimulationRunner::State state);
  void frameShown(std::shared_ptr<const sim2d::Frame> frame);  // At display rate; null: cleared.
  void lookingBackChanged(bool lookingBack);
  void loopChanged();
  void branchesChanged();
  void scenariosChanged();
  void breakpointsChanged();
  void breakpointHit(const sim2d::TreeBreakpointHit& at);  // Paused there.
  void entriesChanged();
  void inputsRefused(const base::Diagnostics& problems);
  void speedMeasured(double factor);
  void speedRequested(double factor);  // By a client of the live view.
  void finished(const sim2d::RunResult& result);
  void failed(const QString& reason);                     // The last state stays.
  void notStarted(const base::Diagnostics& diagnostics);  // The world could not be created.
  void warned(const base::Diagnostics& diagnostics);      // The world was created with warnings.
  /// The disk is full, so that the oldest states are dropped. Emitted once.
  void historyTruncated(const base::Diagnostics& diagnostics);

 private:
  void setFirstBranch(const QString& name);
  bool start(bool paused);
  void begin(RunRequest request, bool paused, sim2d::RecordedInputs inputs = {},
             std::int64_t until = 0, sim2d::StepInputs then = {});
  void poll();
  void handleRunEnd(const sim2d::RunResult& result);
  void handleTreeNews(app::SessionUpdate& news);
  void applyGuestRequests(const app::SessionUpdate& news);
  void setEntries(std::optional<app::BlackboardEntries> entries);
  void setState(State state);
  void show(FramePtr frame, bool lookingBack);
  bool stopSession();
  void advancePlayback();
  void startClock();
  FramePtr stateAt(std::size_t index) const;
  void showState(std::size_t index);
  void checkHistoryLimit();
  bool canLoop() const {
    return loop_ && recording_ != nullptr && newest_ != nullptr && shown_ != nullptr &&
           loop_->from < newest_->time;
  }
  void clearRun();
  void setScenarios(RunScenarios scenarios);
  void storeShownBranch();
  RunnerBranch* branchOf(int number);
  void showStoredBranch(const RunnerBranch& kept, double time);
  /// Each branch gets an equal part of the memory limit; all branches together use as much as the
  /// first run.
  std::size_t memoryForNextRun() const {
    return branch_ <= 0 ? historyMemory_ : historyMemory_ / (kMaxBranches - 1);
  }
  void checkReplayDivergence();

  std::function<RunRequest()> request_;
  std::function<bool(bool)> startCondition_;
  ObserverFactory observerFactory_;
  std::function<RunRequest()> recreate_;  // For the current session.
  RunScenarios scenarios_;
  std::unique_ptr<app::Session> session_;
  std::future<void> thread_;  // Thread of the session.
  struct StoppingSession {
    std::unique_ptr<app::Session> session;
    std::future<void> thread;
  };
  void removeStoppedSessions();
  std::shared_ptr<base::StopFlag> stopFlag_;       // Stop flag of the session.
  std::vector<StoppingSession> stoppingSessions_;  // Runs that were left and have not ended yet.
  QTimer timer_, stoppingTimer_;
  State state_ = State::Editing;
  bool finished_ = false, lookingBack_ = false;
  double speed_ = 1.0, measuredSpeed_ = 0.0;
  FramePtr newest_, shown_;
  RecordingPtr recording_;
  bool isRecorded_ = false;
  bool isCut_ = false;                                            // The history was cut (reported).
  std::size_t historyMemory_ = sim2d::Recording::kDefaultMemory;  // [B]
  std::string historyFolder_;
  std::optional<sim2d::RunResult> result_;
  std::vector<sim2d::TreeBreakpoint> breakpoints_;
  std::optional<sim2d::TreeBreakpointHit> currentBreak_;
  std::optional<int> watched_;
  std::shared_ptr<sim2d::PlannerDebugFlags> watch_ = std::make_shared<sim2d::PlannerDebugFlags>();
  std::optional<app::BlackboardEntries> entries_;
  std::optional<LoopRange> loop_;
  bool isLooping_ = false;  // Looping within a run that has not finished.
  std::vector<RunnerBranch> branches_;
  struct Expected {
    std::int64_t step = 0;
    std::string rows;  // Rows of the trajectory.
  };
  std::optional<Expected> expected_;  // Expected state of a re-run.
  int branch_ = -1, nextBranch_ = 0;
  QElapsedTimer playing_;                         // Runs while a recording is played.
  double playedFrom_ = 0.0;                       // Simulated time when `playing_` started [s].
  std::vector<app::BlackboardStep> pastEntries_;  // Blackboards of the watched person, by step.
};

}  // namespace editor

Q_DECLARE_METATYPE(std::shared_ptr<const sim2d::Frame>)
Q_DECLARE_METATYPE(base::Diagnostics)
Q_DECLARE_METATYPE(sim2d::RunResult)
