#pragma once

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

#include "sim2d/trace/Recording.h"
#include "sim2d/world/Runner.h"
#include "sim2d/world/TreeBreakpoint.h"

namespace app {

using WorldMaker = std::function<base::Result<std::unique_ptr<sim2d::World>>()>;
using RecordingPtr = std::shared_ptr<const sim2d::Recording>;

/// Keys and values of a blackboard, as texts.
using Entries = std::vector<std::pair<std::string, std::string>>;

/// Of one person after a step.
struct StepEntries {
  std::int64_t step = 0;
  Entries entries;
};

/// What a session has to tell, collected until somebody looks.
struct SessionNews {
  std::optional<base::Diagnostics> remarks;  // of making the world; errors: it could not be made
  RecordingPtr history;                      // of this run, once there is a world; it grows
  sim2d::FramePtr newest;
  std::optional<double> measuredSpeed;     // [simulated s / wall s]
  std::optional<sim2d::RunResult> result;  // the run is over
  bool isStopped = false;                  // the world was not made: its map is another one now
  std::optional<bool> isPaused;            // as somebody ordered since the last news
  std::optional<double> speed;             // idem
  std::optional<sim2d::TreeBreak> broke;   // at a breakpoint: it waits since then
  std::optional<Entries> entries;          // of the person who is watched, after the newest step
  std::vector<StepEntries> pastEntries;    // of the same, each change since the last news
  base::Diagnostics refused;               // inputs that were not possible
};

/// One run of a world, the same for the commands and the window: it is stepped until its rule is
/// fulfilled, at the pace that is asked for, with inputs from outside, and remembered if wanted.
/// One thread runs it; others give orders and inputs, which are heeded between two steps.
class Session {
 public:
  using Watcher = std::function<void(const sim2d::Frame&)>;

  explicit Session(const sim2d::StopRule& rule) : rule_(rule) {}
  const sim2d::StopRule& rule() const { return rule_; }

  // the thread that runs
  /// From now on the past can be looked at: each state is recorded as soon as it is there, and the
  /// newest one is news.
  /// `mostInMemory`, `folder`: as of the Recording.
  void keepHistory(int recordEvery, std::size_t mostInMemory = sim2d::Recording::kUsualMemory,
                   const std::string& folder = {}) {
    history_ = std::make_shared<sim2d::Recording>(recordEvery, mostInMemory, folder);
  }
  /// Null without; complete when the run is over.
  RecordingPtr history() const { return history_; }
  /// Up to that step the inputs are these, whatever pace and pauses are asked for;
  /// then it is as if it began there.
  void repeat(sim2d::RecordedInputs inputs, std::int64_t until) {
    repeated_ = std::move(inputs);
    repeatUntil_ = until;
  }
  /// Sees each state before the next step, in the thread that runs, and may change the world.
  using Changer = std::function<void(const sim2d::Frame&, sim2d::World&)>;
  void changeWith(Changer change) { change_ = std::move(change); }
  /// Receives the newest state again whenever `refresh` is called and each time the run begins to
  /// wait in a pause; between two steps, in the thread of the run, not while a part is repeated.
  void refreshWith(Watcher watch) { refresh_ = std::move(watch); }
  /// Once. `watch` sees each state before the next step and may give orders; `sink` gets all of
  /// them, the last with the event `stop`.
  sim2d::RunResult run(sim2d::World& world, sim2d::FrameSink* sink = nullptr,
                       const Watcher& watch = {});
  /// The same with a world that is made first; all that comes of it is news. A guest comes for the
  /// world and goes before it: it sees each state, the last one too, and is asked for inputs just
  /// before each step that is not repeated.
  struct Guest {
    Watcher watch;
    std::function<sim2d::StepInputs(const sim2d::Frame&)> steer;  // null: it gives none
  };
  using GuestMaker = std::function<std::vector<Guest>(sim2d::World&)>;
  void run(const WorldMaker& makeWorld, const GuestMaker& makeGuests = {});

  // any thread
  void setPaused(bool paused);
  bool isPaused();
  void allowStep();              // one step although paused
  void setSpeed(double factor);  // > 0; infinity = as fast as possible, which it is at first
  double speed();
  void stop();
  void refresh();                // also while paused
  void add(sim2d::Input input);  // acts in the next step
  /// Asked before each step, in the thread that runs, for inputs of that step beside those added.
  using Steering = std::function<sim2d::StepInputs(const sim2d::Frame&)>;
  void steer(Steering steering);
  /// It pauses after a step in which one of these is met; not while something is repeated.
  void setBreakpoints(std::vector<sim2d::TreeBreakpoint> points);
  void watchEntries(std::optional<int> person);  // by id
  SessionNews takeNews();

 private:
  class Feed;
  void runMade(const base::Result<std::unique_ptr<sim2d::World>>& made,
               const GuestMaker& makeGuests);
  sim2d::RunResult runWith(sim2d::World& world, std::vector<Guest> guests);
  using Clock = std::chrono::steady_clock;
  template <class Change>
  void order(Change change);
  bool waitForTurn(sim2d::World& world);
  void refresh(const sim2d::World& world, std::unique_lock<std::mutex>& lock);
  void serve(sim2d::HumanBehavior& behavior, const sim2d::WorldView& view);
  sim2d::StepInputs takeInputs(const sim2d::Frame& frame);
  void measure(double time);
  bool isDue(double time, double dt);
  Clock::time_point dueTime(double time, double dt) const;
  void restartClock(double time);

  const sim2d::StopRule rule_;
  std::shared_ptr<sim2d::Recording> history_;
  sim2d::RecordedInputs repeated_;
  std::int64_t repeatUntil_ = 0;
  Changer change_;
  Watcher refresh_;
  std::mutex mutex_;
  std::condition_variable changed_;
  // guarded by the mutex
  bool paused_ = false, stop_ = false, restartClock_ = true;
  bool wantsRefresh_ = false;
  int stepsAllowed_ = 0;
  double speed_ = std::numeric_limits<double>::infinity();
  sim2d::StepInputs inputs_;
  Steering steering_;
  std::optional<std::vector<sim2d::TreeBreakpoint>> breakpoints_;  // that the world has not got yet
  std::optional<int> watched_;
  bool wantsEntries_ = false;
  std::optional<Entries> lastEntries_;  // of the watched person that were told
  SessionNews news_;
  // of the thread that runs alone
  std::vector<Guest> guests_;
  Clock::time_point wallStart_;
  double simulatedStart_ = 0.0;
  Clock::time_point measureStart_;
  double measuredFrom_ = 0.0;
};

}  // namespace app
