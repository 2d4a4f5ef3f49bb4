#include "app/run/Session.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/run/MetricsSetup.h"
#include "app/run/Nav2Robots.h"
#include "app/run/RunFolder.h"
#include "sim2d/base/StopFlag.h"
#include "sim2d/trace/Trace.h"
#include "sim2d/world/Registries.h"

namespace app {

namespace {

using Seconds = std::chrono::duration<double>;

constexpr double kMaxLag = 0.1;  // [s] maximum wall-clock lag that is caught up
constexpr double kMeasureSeconds = 0.5;
constexpr std::size_t kMaxBlackboardHistory =
    20000;                                  // maximum number of changes until takeUpdate()
constexpr std::size_t kMaxRejected = 1000;  // maximum number of rejected inputs until
                                            // takeUpdate()

}  // namespace

/// Forwards the states. The history receives each state immediately; the runner calls append()
/// later, when it knows which state is the last.
class Session::FrameDistributor : public sim2d::FrameSink {
 public:
  FrameDistributor(Session& session, const sim2d::World& world, sim2d::FrameSink* sink)
      : session_(session), world_(world), sink_(sink), known_(world.header()) {
    if (session_.history_) {
      session_.history_->setHeader(world.header());
      const std::lock_guard<std::mutex> lock(session_.mutex_);
      session_.update_.history = session_.history_;
    }
  }

  void publish(const sim2d::Frame& frame) {
    if (!session_.history_) {
      return;
    }
    if (frame.humans.id != present_) {
      present_ = frame.humans.id;
      if (known_.addNew(frame)) {  // spawned by a source
        session_.history_->setHeader(world_.header());
      }
    }
    session_.history_->append(frame);
    newest_ = frame.step;
    auto copy = std::make_shared<const sim2d::Frame>(frame);
    const std::lock_guard<std::mutex> lock(session_.mutex_);
    session_.update_.newest = std::move(copy);
  }

  void append(const sim2d::Frame& frame) override {
    if (frame.step > newest_) {
      publish(frame);
    } else if (!frame.events.empty() && frame.events.back().kind == sim2d::EventKind::Stop) {
      session_.history_->addEvent(frame.step, frame.events.back());
    }
    if (sink_ != nullptr) {
      sink_->append(frame);
    }
  }

 private:
  Session& session_;
  const sim2d::World& world_;
  sim2d::FrameSink* const sink_;
  std::vector<int> present_;
  sim2d::KnownPeople known_;  // in the header
  std::int64_t newest_ = -1;
};

sim2d::RunResult Session::run(sim2d::World& world, sim2d::FrameSink* sink,
                              const FrameCallback& watch) {
  FrameDistributor feed(*this, world, sink);
  const auto wantsStop = [&](const sim2d::Frame& frame) {
    feed.publish(frame);
    if (stepHook_) {
      stepHook_(frame, world);
    }
    if (watch) {
      watch(frame);
    }
    return waitForNextStep(world);
  };
  return sim2d::run(world, rule_, feed, wantsStop,
                    [this, &world] { return takeInputs(world.frame()); });
}

sim2d::StepInputs Session::takeInputs(const sim2d::Frame& frame) {
  if (frame.step < replayUntil_) {
    return sim2d::inputsOf(replayedInputs_, frame.step + 1);
  }
  sim2d::StepInputs inputs;
  Steering steering;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    inputs = std::exchange(inputs_, {});
    steering = steering_;
  }
  const auto add = [&](const Steering& more) {
    const sim2d::StepInputs its = more ? more(frame) : sim2d::StepInputs();
    inputs.insert(inputs.end(), its.begin(), its.end());
  };
  add(steering);
  for (const Observer& guest : observers_) {
    add(guest.steer);
  }
  return inputs;
}

void Session::run(const WorldFactory& makeWorld, const ObserverFactory& makeObservers) {
  try {
    runCreatedWorld(makeWorld(), makeObservers);
  } catch (const base::Stopped&) {
    const std::lock_guard<std::mutex> lock(mutex_);
    update_.isStopped = true;
  }
}

void Session::runCreatedWorld(const base::Result<std::unique_ptr<sim2d::World>>& made,
                              const ObserverFactory& makeObservers) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    update_.remarks = made.diagnostics();
  }
  if (made) {
    const sim2d::RunResult result =
        runWithObservers(**made, makeObservers ? makeObservers(**made) : std::vector<Observer>());
    const std::lock_guard<std::mutex> lock(mutex_);
    update_.result = result;
  }
}

/// Destroys the observers when it returns or throws.
sim2d::RunResult Session::runWithObservers(sim2d::World& world, std::vector<Observer> guests) {
  observers_ = std::move(guests);
  const std::unique_ptr<std::vector<Observer>, void (*)(std::vector<Observer>*)> leave(
      &observers_, [](std::vector<Observer>* all) { all->clear(); });
  const auto show = [this](const sim2d::Frame& frame) {
    for (const Observer& guest : observers_) {
      guest.watch(frame);
    }
  };
  sim2d::RunResult result = run(world, nullptr, show);
  show(world.frame());
  return result;
}

template <class Change>
void Session::applyCommand(Change change) {
  const std::lock_guard<std::mutex> lock(mutex_);
  change();
  changed_.notify_all();
}

void Session::setPaused(bool paused) {
  applyCommand([&] {
    paused_ = paused;
    pendingSteps_ = 0;
    restartClock_ = true;
    update_.isPaused = paused;
  });
}

bool Session::isPaused() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return paused_;
}

void Session::stepOnce() {
  applyCommand([&] { ++pendingSteps_; });
}

void Session::setSpeed(double factor) {
  applyCommand([&] {
    speed_ = factor;
    restartClock_ = true;
    update_.speed = factor;
  });
}

double Session::speed() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return speed_;
}

void Session::stop() {
  applyCommand([&] { stop_ = true; });
}

void Session::refresh() {
  applyCommand([&] { wantsRefresh_ = true; });
}

void Session::add(sim2d::Input input) {
  applyCommand([&] { inputs_.push_back(std::move(input)); });
}

void Session::steer(Steering steering) {
  applyCommand([&] { steering_ = std::move(steering); });
}

void Session::setBreakpoints(std::vector<sim2d::TreeBreakpoint> points) {
  applyCommand([&] { breakpoints_ = std::move(points); });
}

void Session::watchBlackboard(std::optional<int> person) {
  applyCommand([&] {
    watchedAgent_ = person;
    wantsBlackboard_ = true;
    lastBlackboard_.reset();
    update_.blackboardHistory.clear();
  });
}

SessionUpdate Session::takeUpdate() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(update_, SessionUpdate());
}

/// Applies requests to the trees between two steps. Requires the lock.
void Session::applyTreeRequests(sim2d::HumanBehavior& behavior, const sim2d::WorldView& view) {
  if (breakpoints_) {
    behavior.setBreakpoints(*std::exchange(breakpoints_, std::nullopt));
  }
  if (watchedAgent_ && std::exchange(wantsBlackboard_, false)) {
    const int human = view.indexOf(*watchedAgent_);
    BlackboardEntries now = human < 0 ? BlackboardEntries() : behavior.blackboard(human);
    if (lastBlackboard_ != now && update_.blackboardHistory.size() < kMaxBlackboardHistory) {
      update_.blackboardHistory.push_back({view.step() - 1, now});
      lastBlackboard_ = now;
    }
    update_.entries = std::move(now);
  }
}

/// Calls the callback without the lock, because it may send commands or take locks of threads that
/// do.
void Session::refresh(const sim2d::World& world, std::unique_lock<std::mutex>& lock) {
  wantsRefresh_ = false;
  if (refreshCallback_) {
    lock.unlock();
    refreshCallback_(world.frame());
    lock.lock();
  }
}

/// Returns true if the run must stop.
bool Session::waitForNextStep(sim2d::World& world) {
  std::unique_lock<std::mutex> lock(mutex_);
  const std::optional<sim2d::TreeBreakpointHit> broke = world.behavior().takeBreakpointHit();
  if (broke && world.stepIndex() > replayUntil_) {
    paused_ = true;
    pendingSteps_ = 0;
    restartClock_ = true;
    update_.isPaused.reset();  // replaces the previous command
    update_.breakpointHit = broke;
  }
  wantsBlackboard_ = true;
  if (update_.refused.size() < kMaxRejected) {
    base::append(update_.refused, world.refused());
  }
  bool isWaiting = false;  // in a pause
  while (!stop_) {
    applyTreeRequests(world.behavior(), world.view());
    if (world.stepIndex() < replayUntil_) {
      return false;
    } else if (pendingSteps_ > 0) {
      --pendingSteps_;
      return false;
    } else if (wantsRefresh_ || (paused_ && !isWaiting)) {
      isWaiting = paused_;
      refresh(world, lock);  // and checks again, because other commands may have arrived
    } else if (paused_) {
      changed_.wait(lock);
    } else {
      if (std::exchange(restartClock_, false)) {
        restartClock(world.time());
      }
      updateMeasuredSpeed(world.time());
      if (isDue(world.time(), world.dt())) {
        return false;
      }
      changed_.wait_until(lock, dueTime(world.time(), world.dt()));
    }
  }
  return true;
}

void Session::restartClock(double time) {
  wallStart_ = measureStart_ = Clock::now();
  simulatedStart_ = measuredFrom_ = time;
}

Session::Clock::time_point Session::dueTime(double time, double dt) const {
  const Seconds wall((time + dt - simulatedStart_) / speed_);
  return wallStart_ + std::chrono::duration_cast<Clock::duration>(wall);
}

bool Session::isDue(double time, double dt) {
  if (std::isinf(speed_)) {
    return true;
  }
  const double late = Seconds(Clock::now() - dueTime(time, dt)).count();
  if (late > kMaxLag) {  // too slow for this speed: do not try to catch up indefinitely
    wallStart_ = Clock::now();
    simulatedStart_ = time;
  }
  return late >= 0.0;
}

void Session::updateMeasuredSpeed(double time) {
  const double wall = Seconds(Clock::now() - measureStart_).count();
  if (wall >= kMeasureSeconds) {
    update_.measuredSpeed = (time - measuredFrom_) / wall;
    measureStart_ = Clock::now();
    measuredFrom_ = time;
  }
}

ManualDrive::ManualDrive(int robot, const sim2d::RobotBody& body) : robot_(robot) {
  sim2d::PlannerSetup setup;
  setup.body = body;
  setup.parameters = {{"timeout", 0.0}};  // no timeout: releaseControl() ends the control
  const sim2d::Registries registries = builtinRegistries();
  if (const auto* const teleop = registries.planners.find("teleop")) {
    if (const auto made = teleop->make(setup)) {
      planner_ = std::dynamic_pointer_cast<sim2d::TeleopPlanner>(*made);
    }
  }
}

void ManualDrive::drive(const sim2d::BodyTwist& twist) {
  planner_->input()->drive(twist);
  isActive_ = true;
}

void ManualDrive::driveTo(const base::Vec2& point) {
  planner_->input()->driveTo(point);
  isActive_ = true;
}

void ManualDrive::releaseControl() {
  isActive_ = false;
}

sim2d::StepInputs ManualDrive::inputs(const sim2d::Frame& frame) {
  const sim2d::RobotColumns& robots = frame.robots;
  const auto found = std::find(robots.id.begin(), robots.id.end(), robot_);
  if (!isActive_ || found == robots.id.end()) {
    return {};
  }
  const auto i = static_cast<std::size_t>(found - robots.id.begin());
  sim2d::Observation seen;
  seen.pose = {{robots.x[i], robots.y[i]}, robots.heading[i]};
  seen.time = frame.time;
  const base::Result<sim2d::BodyTwist> command = planner_->command(seen);
  sim2d::Input input;
  input.kind = sim2d::InputKind::Robot;
  input.id = robot_;
  input.velocity = {command ? command->linear : 0.0, 0.0};
  input.omega = command ? command->angular : 0.0;
  return {input};
}

FinishedRun simulate(Session& session, sim2d::World& world, const MetricsSetup& setup,
                     RunWriter& writer, const std::function<bool(const sim2d::Frame&)>& wantsStop,
                     PlanningClock clock) {
  sim2d::StepTimes times;
  metrics::PlanningTime planning;
  double planned = 0.0;  // [s] up to the previous step
  if (clock == PlanningClock::On && !world.frame().robots.id.empty()) {
    world.measure(&times);
  }
  sim2d::RunResult result = session.run(world, &writer, [&](const sim2d::Frame& frame) {
    const double now = times.seconds[static_cast<std::size_t>(sim2d::StepPhase::Robots)];
    if (times.steps > planning.steps()) {
      planning.add(now - planned);
      planned = now;
    }
    if (wantsStop(frame) || writer.hasFailed()) {
      session.stop();
    }
  });
  world.measure(nullptr);
  sim2d::TraceHeader header = world.header();
  storeMetricsSelection(setup, header);
  if (writer.additionalWriter() != nullptr) {
    writer.additionalWriter()->conclude(header);
  }
  return {std::move(header),     std::move(result), planning, writer.evaluation(), {}, false, {},
          world.plannerReports()};
}

}  // namespace app
