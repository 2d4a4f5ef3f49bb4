#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "sim2d/trace/Recorder.h"
#include "sim2d/world/Runner.h"

namespace editor {

using WorldMaker = std::function<base::Result<std::unique_ptr<sim2d::World>>()>;
using FramePtr = std::shared_ptr<const sim2d::Frame>;
using TracePtr = std::shared_ptr<const sim2d::Trace>;

struct RunRequest {
  WorldMaker makeWorld;  // called in the worker thread, so it holds copies of all it needs
  sim2d::StopRule rule;
  int recordEvery = 1;
};

/// What happened in one step, also in one that is not recorded or shown.
struct StepEvents {
  double time = 0.0;  // [s]
  std::vector<sim2d::Event> events;
};

/// What the worker has to tell, collected until the GUI thread looks.
struct RunNews {
  std::optional<base::Diagnostics> remarks;  // of making the world; errors: it could not be made
  FramePtr newest;
  std::vector<FramePtr> recorded;
  std::vector<StepEvents> events;
  std::optional<double> measuredSpeed;
  TracePtr trace;
  std::optional<sim2d::RunResult> result;  // the run is over
};

/// The part of a simulation that runs in its own thread, without Qt. Orders are heeded between two
/// steps. All public functions but `work` are for other threads.
class RunWorker {
 public:
  using Clock = std::chrono::steady_clock;

  RunWorker(RunRequest request, bool paused, double speed);
  void work();  // the thread's function; returns when the run is over

  void setPaused(bool paused);
  void allowStep();  // one step although paused
  void setSpeed(double factor);
  void requestTrace();
  void stop();
  RunNews takeNews();

 private:
  bool waitForTurn(const sim2d::World& world, const sim2d::Recorder& recorder);
  void answerTrace(const sim2d::World& world, const sim2d::Recorder& recorder);
  void publish(const sim2d::Frame& frame);
  void measure(double time);
  bool isDue(double time, double dt);
  Clock::time_point dueTime(double time, double dt) const;
  void restartClock(double time);

  const RunRequest request_;
  std::mutex mutex_;
  std::condition_variable changed_;
  // guarded by the mutex
  bool paused_, stop_ = false, wantsTrace_ = false, restartClock_ = true;
  int stepsAllowed_ = 0;
  double speed_;
  RunNews news_;
  sim2d::TreeChanges skippedChanges_;  // since the last recorded frame
  // of the worker alone
  Clock::time_point wallStart_;
  double simulatedStart_ = 0.0;
  Clock::time_point measureStart_;
  double measuredFrom_ = 0.0;
};

}  // namespace editor
