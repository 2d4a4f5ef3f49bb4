#include "editor/run/RunWorker.h"

#include <algorithm>
#include <cmath>
#include <set>

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

void RunWorker::stop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  stop_ = true;
  changed_.notify_all();
}

RunNews RunWorker::takeNews() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(news_, RunNews());
}

/// Records each state as soon as it is there, for whoever watches; the runner hands them on later,
/// when it knows which is the last.
class RunWorker::Publisher : public sim2d::FrameSink {
 public:
  Publisher(RunWorker& worker, const sim2d::World& world)
      : worker_(worker),
        world_(world),
        recording_(std::make_shared<sim2d::Recording>(worker.request_.recordEvery)) {
    recording_->setHeader(world.header());
    const std::lock_guard<std::mutex> lock(worker_.mutex_);
    worker_.news_.recording = recording_;
  }

  void publish(const sim2d::Frame& frame) {
    if (frame.humans.id != present_) {
      present_ = frame.humans.id;
      meet();
    }
    recording_->append(frame);
    newest_ = frame.step;
    auto copy = std::make_shared<const sim2d::Frame>(frame);
    const std::lock_guard<std::mutex> lock(worker_.mutex_);
    worker_.news_.newest = std::move(copy);
  }

  void append(const sim2d::Frame& frame) override {
    if (frame.step > newest_) {
      publish(frame);
    } else if (!frame.events.empty() && frame.events.back().kind == sim2d::EventKind::Stop) {
      recording_->addEvent(frame.step, frame.events.back());
    }
  }

 private:
  /// People from sources are in the header as well.
  void meet() {
    const auto isKnown = [this](int id) { return known_.count(id) > 0; };
    if (std::all_of(present_.begin(), present_.end(), isKnown)) {
      return;
    }
    sim2d::TraceHeader header = world_.header();
    for (const sim2d::TraceHuman& human : header.humans) {
      known_.insert(human.id);
    }
    recording_->setHeader(std::move(header));
  }

  RunWorker& worker_;
  const sim2d::World& world_;
  std::shared_ptr<sim2d::Recording> recording_;
  std::vector<int> present_;
  std::set<int> known_;  // people of the header
  std::int64_t newest_ = -1;
};

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
  Publisher publisher(*this, world);
  const sim2d::RunResult result =
      sim2d::run(world, request_.rule, publisher, [&](const sim2d::Frame& frame) {
        publisher.publish(frame);
        return waitForTurn(world);
      });
  const std::lock_guard<std::mutex> lock(mutex_);
  news_.result = result;
}

bool RunWorker::waitForTurn(const sim2d::World& world) {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!stop_) {
    if (stepsAllowed_ > 0) {
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
