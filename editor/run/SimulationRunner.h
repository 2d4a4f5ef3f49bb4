#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "app/run/RunOptions.h"
#include "app/run/Session.h"
#include "editor/document/ScenarioDocument.h"
#include "editor/run/RunBranches.h"

namespace editor {

using app::RunSettings;

/// A run of the document as it is now: copies of scenario, map and trees. GUI thread. What a check
/// refuses does not run.
RunRequest runRequestOf(const ScenarioDocument& document, const RunSettings& settings = {});

/// What ends a run when the scenario gives no duration and a robot has a goal, which makes the run
/// longer; else nothing. "until the robot arrives, at most 120 s"
QString runEndText(const sim2d::Scenario& scenario);

/// A simulation beside the window. Lives in the GUI thread and owns one worker thread with
/// the session. States come out through its history, which is there to be read while it grows and
/// equals that of a headless run. A run that is over, or was recorded before, is played from its
/// recording; nothing is computed twice.
class SimulationRunner : public QObject {
  Q_OBJECT
 public:
  enum class State { Editing, Running, Paused };
  Q_ENUM(State)

  explicit SimulationRunner(QObject* parent = nullptr);
  ~SimulationRunner() override;  // stops and waits
  Q_DISABLE_COPY_MOVE(SimulationRunner)

  /// Called in the GUI thread when a run starts from Editing: takes a snapshot of the document.
  void setRequest(std::function<RunRequest()> request) { request_ = std::move(request); }

  /// Asked in the GUI thread before a run starts from Editing, `paused` or not; false: it does not.
  void setGate(std::function<bool(bool paused)> mayStart) { mayStart_ = std::move(mayStart); }

  State state() const { return state_; }
  bool isFinished() const { return finished_; }  // nothing more is computed; it is played or paused
  /// How it ended; none: it has not, or was recorded before.
  const std::optional<sim2d::RunResult>& result() const { return result_; }
  double speed() const { return speed_; }
  double measuredSpeed() const { return measuredSpeed_; }  // simulated seconds per wall second

  void play();  // from Editing: makes the world first; after the end: plays the recording
  void pause();
  void stepOnce();  // one step, then paused; from the past: one recorded frame forward
  /// Ends the run, back to Editing. Does not wait for a world that is still being made, or in a
  /// step that takes long.
  void reset();
  void setSpeed(double factor);  // > 0; infinity = as fast as possible
  /// Memory of the states of runs that begin from now on, as of `sim2d::Recording`: most of it [B],
  /// and the folder of the temporary file (empty: the system's).
  void setHistory(std::size_t mostInMemory, std::string folder = {});
  std::size_t historyMemory() const { return historyMemory_; }  // [B]
  /// Who comes to the runs that begin from now on, in their threads, and may give orders; as of the
  /// session. Null: nobody.
  using Guests = std::function<std::vector<app::Session::Guest>(
      app::Session&, sim2d::World&, const std::shared_ptr<const app::Bundle>&)>;
  void setGuests(Guests guests) { guests_ = std::move(guests); }
  /// Inputs of each step from now on, of the run that goes on.
  void steer(app::Session::Steering steering);

  /// Of this run and those that follow: it pauses where one is met.
  void setBreakpoints(std::vector<sim2d::TreeBreakpoint> points);
  const std::vector<sim2d::TreeBreakpoint>& breakpoints() const { return breakpoints_; }
  /// Where it stands; none: it did not stop at a breakpoint, or has gone on.
  const std::optional<sim2d::TreeBreak>& brokeAt() const { return brokeAt_; }
  /// Whose blackboard is told from now on, by id.
  void watchEntries(std::optional<int> person);
  /// Of this run and those that follow: whether their newest states have costmaps of planners, and
  /// ways that planners weigh and gather for display only. It costs time, and changes nothing.
  void watchPlanners(bool costs, bool ways) {
    watch_->costs = costs;
    watch_->ways = ways;
  }
  std::optional<int> watched() const { return watched_; }
  /// Of that person in the newest state of a run that goes on; none: nothing is known.
  const std::optional<app::Entries>& entries() const { return entries_; }
  /// The same in the state that is shown, which may lie in the past; none: nobody watched then.
  /// Null too for recorded runs: their files hold none.
  const app::Entries* shownEntries() const;

  /// A run goes on, and its newest state is shown: inputs act in its next step.
  bool isLive() const;
  /// Acts in the next step and is recorded. Nothing without a run that goes on.
  void give(sim2d::Input input);

  /// Shows a recorded run from its beginning; it holds states. reset() leaves it. `again`: the same
  /// run made here; null: what it was made of is not known.
  void openRecorded(RecordingPtr recording, std::function<RunRequest()> again = {});
  bool isRecorded() const { return isRecorded_; }

  // the past
  /// Of the run, growing while it goes on; null: there is none.
  RecordingPtr recording() const { return recording_; }
  FramePtr newestFrame() const { return newest_; }
  FramePtr shownFrame() const { return shown_; }
  bool isLookingBack() const { return lookingBack_; }
  /// Of the oldest state that can still be shown [s]; 0 unless the disk took no more of the run.
  double oldestTime() const;
  void seek(
      std::int64_t step);  // shows the nearest kept frame at or before, else the oldest; pauses
  void stepBack();
  void seekNewest();
  /// Plays this part again and again, once there is a state of it; none: plays on.
  struct Part {
    double from = 0.0, to = 0.0;  // [s], from < to
    friend bool operator==(const Part& a, const Part& b) {
      return a.from == b.from && a.to == b.to;
    }
  };
  void setLoop(std::optional<Part> loop);
  const std::optional<Part>& loop() const { return loop_; }

  // branches
  static constexpr std::size_t kMostBranches = 9;  // with the first
  /// The run is made again up to the state that is shown, as a branch beside it, and waits there:
  /// it may take another way. False: it was told why not, and nothing has changed.
  bool goOnFromShown(const app::RunOptions& changes = {}, const QString& name = {});
  /// It is in the past of a run that can be made again, and there is room for one more.
  bool canGoOnFromShown() const;
  /// All runs that began as this one, in the order of their making; none while editing.
  const std::vector<RunBranch>& branches() const { return branches_; }
  int branch() const { return branch_; }  // number of the one that is shown; -1: none
  /// What is known of a run, that of the branch shown too; null: nothing yet.
  RecordingPtr recordingOf(int branch) const;
  /// Shows another one at the same time of the run, paused. One that has not come to its end is
  /// made again to where it was.
  void showBranch(int number);
  void renameBranch(int number, const QString& name);
  void removeBranch(int number);  // not the one that is shown
  /// The run that is shown, from its beginning; null: it cannot be made again.
  const std::function<RunRequest()>& again() const { return again_; }

 Q_SIGNALS:
  void stateChanged(editor::SimulationRunner::State state);
  void frameShown(std::shared_ptr<const sim2d::Frame> frame);  // at display rate; null: cleared
  void lookingBackChanged(bool lookingBack);
  void loopChanged();
  void branchesChanged();
  void breakpointsChanged();
  void broke(const sim2d::TreeBreak& at);  // paused there
  void entriesChanged();
  void inputsRefused(const base::Diagnostics& problems);
  void speedMeasured(double factor);
  void speedOrdered(double factor);  // by a guest
  void finished(const sim2d::RunResult& result);
  void failed(const QString& reason);                     // the world stopped; last state stays
  void notStarted(const base::Diagnostics& diagnostics);  // the world could not be made
  void warned(const base::Diagnostics& diagnostics);      // it could, with remarks
  /// The disk takes no more of the run: its oldest states go. Once.
  void historyCut(const base::Diagnostics& diagnostics);

 private:
  bool start(bool paused);
  void begin(RunRequest request, bool paused, sim2d::RecordedInputs inputs = {},
             std::int64_t until = 0, sim2d::StepInputs then = {});
  void poll();
  void takeEnd(const sim2d::RunResult& result);
  void takeTrees(app::SessionNews& news);
  void takeOrders(const app::SessionNews& news);
  void setEntries(std::optional<app::Entries> entries);
  void setState(State state);
  void show(FramePtr frame, bool lookingBack);
  bool stopSession();
  void playOn();
  void startClock();
  FramePtr stateAt(std::size_t index) const;
  void showState(std::size_t index);
  void watchHistory();
  bool canLoop() const;
  void leaveRun();
  void keepShown();
  RunBranch* branchOf(int number);
  void showKept(const RunBranch& kept, double time);
  std::size_t historyOfNext() const;
  void watchRepeated();

  std::function<RunRequest()> request_;
  std::function<bool(bool)> mayStart_;
  Guests guests_;
  std::function<RunRequest()> again_;  // of the session
  std::unique_ptr<app::Session> session_;
  std::future<void> thread_;  // of the session
  struct Ending {
    std::unique_ptr<app::Session> session;
    std::future<void> thread;
  };
  void forgetEndings();
  std::shared_ptr<base::StopFlag> left_;  // of the session
  std::vector<Ending> endings_;           // runs that were left and are not over yet
  QTimer timer_, endingTimer_;
  State state_ = State::Editing;
  bool finished_ = false, lookingBack_ = false;
  double speed_ = 1.0, measuredSpeed_ = 0.0;
  FramePtr newest_, shown_;
  RecordingPtr recording_;
  bool isRecorded_ = false;
  bool isCut_ = false;                                          // the history, and it was told
  std::size_t historyMemory_ = sim2d::Recording::kUsualMemory;  // [B]
  std::string historyFolder_;
  std::optional<sim2d::RunResult> result_;
  std::vector<sim2d::TreeBreakpoint> breakpoints_;
  std::optional<sim2d::TreeBreak> brokeAt_;
  std::optional<int> watched_;
  std::shared_ptr<sim2d::PlannerWatch> watch_ = std::make_shared<sim2d::PlannerWatch>();
  std::optional<app::Entries> entries_;
  std::optional<Part> loop_;
  bool isLooping_ = false;  // in the past of a run that has not come to its end
  std::vector<RunBranch> branches_;
  struct Expected {
    std::int64_t step = 0;
    std::string rows;  // of the trajectory
  };
  std::optional<Expected> expected_;  // of a run that is made again
  int branch_ = -1, nextBranch_ = 0;
  QElapsedTimer playing_;                      // a recording
  double playedFrom_ = 0.0;                    // [s], when `playing_` began
  std::vector<app::StepEntries> pastEntries_;  // of the person who is watched, by step
};

}  // namespace editor

Q_DECLARE_METATYPE(std::shared_ptr<const sim2d::Frame>)
Q_DECLARE_METATYPE(base::Diagnostics)
Q_DECLARE_METATYPE(sim2d::RunResult)
