#include "app/run/Session.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "sim2d/base/Stop.h"

namespace app {

namespace {

using Seconds = std::chrono::duration<double>;

constexpr double kMostLag = 0.1;  // [s] of wall time that are caught up with
constexpr double kMeasureSeconds = 0.5;
constexpr std::size_t kMostPastEntries = 20000;  // changes that nobody has taken
constexpr std::size_t kMostRefused = 1000;       // inputs that nobody has asked about

}  // namespace

/// Hands the states on. The history gets each as soon as it is there, for whoever watches; the
/// runner tells them later, when it knows which is the last.
class Session::Feed : public sim2d::FrameSink {
 public:
  Feed(Session& session, const sim2d::World& world, sim2d::FrameSink* sink)
      : session_(session), world_(world), sink_(sink) {
    if (session_.history_) {
      session_.history_->setHeader(world.header());
      const std::lock_guard<std::mutex> lock(session_.mutex_);
      session_.news_.history = session_.history_;
    }
  }

  void publish(const sim2d::Frame& frame) {
    if (!session_.history_) {
      return;
    }
    if (frame.humans.id != present_) {
      present_ = frame.humans.id;
      meet();
    }
    session_.history_->append(frame);
    newest_ = frame.step;
    auto copy = std::make_shared<const sim2d::Frame>(frame);
    const std::lock_guard<std::mutex> lock(session_.mutex_);
    session_.news_.newest = std::move(copy);
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
    session_.history_->setHeader(std::move(header));
  }

  Session& session_;
  const sim2d::World& world_;
  sim2d::FrameSink* const sink_;
  std::vector<int> present_;
  std::set<int> known_;  // people of the header
  std::int64_t newest_ = -1;
};

sim2d::RunResult Session::run(sim2d::World& world, sim2d::FrameSink* sink, const Watcher& watch) {
  Feed feed(*this, world, sink);
  const auto wantsStop = [&](const sim2d::Frame& frame) {
    feed.publish(frame);
    if (change_) {
      change_(frame, world);
    }
    if (watch) {
      watch(frame);
    }
    return waitForTurn(world);
  };
  return sim2d::run(world, rule_, feed, wantsStop,
                    [this, &world] { return takeInputs(world.frame()); });
}

sim2d::StepInputs Session::takeInputs(const sim2d::Frame& frame) {
  if (frame.step < repeatUntil_) {
    return sim2d::inputsOf(repeated_, frame.step + 1);
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
  for (const Guest& guest : guests_) {
    add(guest.steer);
  }
  return inputs;
}

void Session::run(const WorldMaker& makeWorld, const GuestMaker& makeGuests) {
  try {
    runMade(makeWorld(), makeGuests);
  } catch (const base::Stopped&) {
    const std::lock_guard<std::mutex> lock(mutex_);
    news_.isStopped = true;
  }
}

void Session::runMade(const base::Result<std::unique_ptr<sim2d::World>>& made,
                      const GuestMaker& makeGuests) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    news_.remarks = made.diagnostics();
  }
  if (made) {
    const sim2d::RunResult result =
        runWith(**made, makeGuests ? makeGuests(**made) : std::vector<Guest>());
    const std::lock_guard<std::mutex> lock(mutex_);
    news_.result = result;
  }
}

/// Guests have gone when it returns or throws.
sim2d::RunResult Session::runWith(sim2d::World& world, std::vector<Guest> guests) {
  struct Leave {
    std::vector<Guest>& guests;
    explicit Leave(std::vector<Guest>& all) : guests(all) {}
    ~Leave() { guests.clear(); }
    Leave(const Leave&) = delete;
    Leave& operator=(const Leave&) = delete;
    Leave(Leave&&) = delete;
    Leave& operator=(Leave&&) = delete;
  };
  guests_ = std::move(guests);
  const Leave leave(guests_);
  const auto show = [this](const sim2d::Frame& frame) {
    for (const Guest& guest : guests_) {
      guest.watch(frame);
    }
  };
  sim2d::RunResult result = run(world, nullptr, show);
  show(world.frame());
  return result;
}

template <class Change>
void Session::order(Change change) {
  const std::lock_guard<std::mutex> lock(mutex_);
  change();
  changed_.notify_all();
}

void Session::setPaused(bool paused) {
  order([&] {
    paused_ = paused;
    stepsAllowed_ = 0;
    restartClock_ = true;
    news_.isPaused = paused;
  });
}

bool Session::isPaused() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return paused_;
}

void Session::allowStep() {
  order([&] { ++stepsAllowed_; });
}

void Session::setSpeed(double factor) {
  order([&] {
    speed_ = factor;
    restartClock_ = true;
    news_.speed = factor;
  });
}

double Session::speed() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return speed_;
}

void Session::stop() {
  order([&] { stop_ = true; });
}

void Session::refresh() {
  order([&] { wantsRefresh_ = true; });
}

void Session::add(sim2d::Input input) {
  order([&] { inputs_.push_back(std::move(input)); });
}

void Session::steer(Steering steering) {
  order([&] { steering_ = std::move(steering); });
}

void Session::setBreakpoints(std::vector<sim2d::TreeBreakpoint> points) {
  order([&] { breakpoints_ = std::move(points); });
}

void Session::watchEntries(std::optional<int> person) {
  order([&] {
    watched_ = person;
    wantsEntries_ = true;
    lastEntries_.reset();
    news_.pastEntries.clear();
  });
}

SessionNews Session::takeNews() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(news_, SessionNews());
}

/// What was asked of the trees between two steps. Under the lock.
void Session::serve(sim2d::HumanBehavior& behavior, const sim2d::WorldView& view) {
  if (breakpoints_) {
    behavior.setBreakpoints(*std::exchange(breakpoints_, std::nullopt));
  }
  if (watched_ && std::exchange(wantsEntries_, false)) {
    const int human = view.indexOf(*watched_);
    Entries now = human < 0 ? Entries() : behavior.blackboard(human);
    if (lastEntries_ != now && news_.pastEntries.size() < kMostPastEntries) {
      news_.pastEntries.push_back({view.step() - 1, now});
      lastEntries_ = now;
    }
    news_.entries = std::move(now);
  }
}

/// Called without the lock: the callback may send commands, or take locks of threads that do.
void Session::refresh(const sim2d::World& world, std::unique_lock<std::mutex>& lock) {
  wantsRefresh_ = false;
  if (refresh_) {
    lock.unlock();
    refresh_(world.frame());
    lock.lock();
  }
}

/// True: the run is to end instead.
bool Session::waitForTurn(sim2d::World& world) {
  std::unique_lock<std::mutex> lock(mutex_);
  const std::optional<sim2d::TreeBreak> broke = world.behavior().takeBreak();
  if (broke && world.stepIndex() > repeatUntil_) {
    paused_ = true;
    stepsAllowed_ = 0;
    restartClock_ = true;
    news_.isPaused.reset();  // what was ordered before
    news_.broke = broke;
  }
  wantsEntries_ = true;
  if (news_.refused.size() < kMostRefused) {
    base::append(news_.refused, world.refused());
  }
  bool isWaiting = false;  // in a pause
  while (!stop_) {
    serve(world.behavior(), world.view());
    if (world.stepIndex() < repeatUntil_) {
      return false;
    } else if (stepsAllowed_ > 0) {
      --stepsAllowed_;
      return false;
    } else if (wantsRefresh_ || (paused_ && !isWaiting)) {
      isWaiting = paused_;
      refresh(world, lock);  // and checks again: there may be other commands
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
  if (late > kMostLag) {  // too slow for this speed: do not hurry for ever to catch up
    wallStart_ = Clock::now();
    simulatedStart_ = time;
  }
  return late >= 0.0;
}

void Session::measure(double time) {
  const double wall = Seconds(Clock::now() - measureStart_).count();
  if (wall >= kMeasureSeconds) {
    news_.measuredSpeed = (time - measuredFrom_) / wall;
    measureStart_ = Clock::now();
    measuredFrom_ = time;
  }
}

}  // namespace app
