#include "editor/run/RunWorker.h"

#include <cmath>

namespace editor {

namespace {

using Seconds = std::chrono::duration<double>;

constexpr double kMostLag = 0.1;  // [s] of wall time that are caught up with
constexpr double kMeasureSeconds = 0.5;

}  // namespace

RunWorker::RunWorker(RunRequest request, bool paused, double speed)
    : request_(std::move(request)), paused_(paused), speed_(speed) {}

void RunWorker::setPaused(bool paused) {
  const std::lock_guard<std::mutex> lock(mutex_);
  paused_ = paused;
  stepsAllowed_ = 0;
  restartClock_ = true;
  changed_.notify_all();
}

void RunWorker::allowStep() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++stepsAllowed_;
  changed_.notify_all();
}

void RunWorker::setSpeed(double factor) {
  const std::lock_guard<std::mutex> lock(mutex_);
  speed_ = factor;
  restartClock_ = true;
  changed_.notify_all();
}

void RunWorker::requestTrace() {
  const std::lock_guard<std::mutex> lock(mutex_);
  wantsTrace_ = true;
  changed_.notify_all();
}

void RunWorker::stop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  stop_ = true;
  changed_.notify_all();
}

RunNews RunWorker::takeNews() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(news_, RunNews());
}

void RunWorker::work() {
  base::Result<std::unique_ptr<sim2d::World>> made = request_.makeWorld();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    news_.remarks = made.diagnostics();
    if (!made) {
      return;
    }
  }
  sim2d::World& world = **made;
  sim2d::Recorder recorder(request_.recordEvery);
  const sim2d::RunResult result =
      sim2d::run(world, request_.rule, recorder, [&](const sim2d::Frame& frame) {
        publish(frame);
        return waitForTurn(world, recorder);
      });
  publish(world.frame());
  auto trace = std::make_shared<const sim2d::Trace>(recorder.finish(world.header()));
  const std::lock_guard<std::mutex> lock(mutex_);
  news_.trace = std::move(trace);
  news_.result = result;
}

void RunWorker::publish(const sim2d::Frame& frame) {
  auto copy = std::make_shared<sim2d::Frame>(frame);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (news_.newest != nullptr && news_.newest->step == frame.step) {
    return;  // the last state of an interrupted run
  }
  skippedChanges_.append(frame.treeChanges);
  if (frame.step % request_.recordEvery == 0) {
    copy->treeChanges = std::exchange(skippedChanges_, {});  // also of steps that are not recorded
    news_.recorded.push_back(copy);
  }
  if (!frame.events.empty()) {
    news_.events.push_back({frame.time, frame.events});
  }
  news_.newest = std::move(copy);
}

bool RunWorker::waitForTurn(const sim2d::World& world, const sim2d::Recorder& recorder) {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!stop_) {
    if (std::exchange(wantsTrace_, false)) {
      lock.unlock();
      answerTrace(world, recorder);
      lock.lock();
    } else if (stepsAllowed_ > 0) {
      --stepsAllowed_;
      return false;
    } else if (paused_) {
      changed_.wait(lock);
    } else {
      if (std::exchange(restartClock_, false)) {
        restartClock(world.time());
      }
      measure(world.time());
      if (isDue(world.time(), world.dt())) {
        return false;
      }
      changed_.wait_until(lock, dueTime(world.time(), world.dt()));
    }
  }
  return true;
}

void RunWorker::answerTrace(const sim2d::World& world, const sim2d::Recorder& recorder) {
  sim2d::Recorder soFar = recorder;  // it has not got the present state yet
  soFar.append(world.frame());
  auto trace = std::make_shared<const sim2d::Trace>(soFar.finish(world.header()));
  const std::lock_guard<std::mutex> lock(mutex_);
  news_.trace = std::move(trace);
}

void RunWorker::restartClock(double time) {
  wallStart_ = Clock::now();
  simulatedStart_ = time;
  measureStart_ = wallStart_;
  measuredFrom_ = time;
}

RunWorker::Clock::time_point RunWorker::dueTime(double time, double dt) const {
  const Seconds wall((time + dt - simulatedStart_) / speed_);
  return wallStart_ + std::chrono::duration_cast<Clock::duration>(wall);
}

bool RunWorker::isDue(double time, double dt) {
  if (std::isinf(speed_)) {
    return true;
  }
  const double late = Seconds(Clock::now() - dueTime(time, dt)).count();
  if (late > kMostLag) {  // too slow for this speed: do not hurry for ever to catch up
    wallStart_ = Clock::now();
    simulatedStart_ = time;
  }
  return late >= 0.0;
}

void RunWorker::measure(double time) {
  const double wall = Seconds(Clock::now() - measureStart_).count();
  if (wall >= kMeasureSeconds) {
    news_.measuredSpeed = (time - measuredFrom_) / wall;
    measureStart_ = Clock::now();
    measuredFrom_ = time;
  }
}

}  // namespace editor
