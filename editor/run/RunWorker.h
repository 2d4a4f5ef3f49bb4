#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "sim2d/trace/Recording.h"
#include "sim2d/world/Runner.h"

namespace editor {

using WorldMaker = std::function<base::Result<std::unique_ptr<sim2d::World>>()>;
using sim2d::FramePtr;
using RecordingPtr = std::shared_ptr<const sim2d::Recording>;

struct RunRequest {
  WorldMaker makeWorld;  // called in the worker thread, so it holds copies of all it needs
  sim2d::StopRule rule;
  int recordEvery = 1;
};

/// What the worker has to tell, collected until the GUI thread looks.
struct RunNews {
  std::optional<base::Diagnostics> remarks;  // of making the world; errors: it could not be made
  RecordingPtr recording;                    // of this run, once there is a world; it grows
  FramePtr newest;
  std::optional<double> measuredSpeed;
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
  void stop();
  RunNews takeNews();

 private:
  class Publisher;
  bool waitForTurn(const sim2d::World& world);
  void measure(double time);
  bool isDue(double time, double dt);
  Clock::time_point dueTime(double time, double dt) const;
  void restartClock(double time);

  const RunRequest request_;
  std::mutex mutex_;
  std::condition_variable changed_;
  // guarded by the mutex
  bool paused_, stop_ = false, restartClock_ = true;
  int stepsAllowed_ = 0;
  double speed_;
  RunNews news_;
  // of the worker alone
  Clock::time_point wallStart_;
  double simulatedStart_ = 0.0;
  Clock::time_point measureStart_;
  double measuredFrom_ = 0.0;
};

}  // namespace editor
