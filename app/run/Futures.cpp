#include "app/run/Futures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "app/run/PlannerFiles.h"
#include "app/run/Session.h"
#include "app/run/WorkerTasks.h"
#include "sim2d/base/Rng.h"

namespace app {

namespace {

constexpr double kPushGap = 1.0;         // [s] between two pushes
constexpr double kStandingSpeed = 0.05;  // [m/s]; who is slower is not pushed
constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

/// Of one future: what is seen of it.
class FutureWatcher {
 public:
  FutureWatcher(Future& future, double gap, std::int64_t from)
      : future_(future), gap_(gap), from_(from) {}

  void look(const sim2d::Frame& frame, double dt) {
    meetContact(frame);
    const auto stride = std::max<std::int64_t>(1, std::llround(gap_ / dt));
    if ((frame.step - from_) % stride != 0) {
      return;
    }
    future_.times.push_back(frame.time);
    for (const sim2d::BodyColumns* columns :
         {static_cast<const sim2d::BodyColumns*>(&frame.humans), &frame.robots}) {
      for (std::size_t k = 0; k < columns->size(); ++k) {
        std::vector<base::Vec2>& way = future_.ways[columns->id[k]];
        way.resize(future_.times.size() - 1, {kNowhere, kNowhere});
        way.emplace_back(columns->x[k], columns->y[k]);
      }
    }
    for (auto& [id, way] : future_.ways) {
      way.resize(future_.times.size(), {kNowhere, kNowhere});
    }
  }

 private:
  void meetContact(const sim2d::Frame& frame) {
    if (future_.contact || frame.step == from_) {
      return;
    }
    const bool hasRobots = frame.robots.size() > 0;
    for (const sim2d::Event& event : frame.events) {
      const bool isOfTwo = event.kind == sim2d::EventKind::Contact && event.hasOther;
      const bool counts = hasRobots ? (event.id < 0) != (event.other < 0) : event.id != event.other;
      if (isOfTwo && counts) {
        future_.contact =
            FutureContact{frame.time, event.id, event.other, placeOf(frame, event.id)};
        return;
      }
    }
  }

  static base::Vec2 placeOf(const sim2d::Frame& frame, int id) {
    const sim2d::BodyColumns& columns =
        id < 0 ? frame.robots : static_cast<const sim2d::BodyColumns&>(frame.humans);
    const auto found = std::find(columns.id.begin(), columns.id.end(), id);
    if (found == columns.id.end()) {
      return {kNowhere, kNowhere};
    }
    const auto k = static_cast<std::size_t>(found - columns.id.begin());
    return {columns.x[k], columns.y[k]};
  }

  Future& future_;
  const double gap_;
  const std::int64_t from_;
};

sim2d::StepInputs pushesOf(const sim2d::Frame& frame, double spread, long long seed) {
  sim2d::StepInputs pushes;
  for (std::size_t k = 0; k < frame.humans.size(); ++k) {
    if (std::hypot(frame.humans.vx[k], frame.humans.vy[k]) < kStandingSpeed) {
      continue;
    }
    const base::AgentRng rng(static_cast<std::uint64_t>(seed), frame.humans.id[k],
                             static_cast<std::uint64_t>(frame.step));
    const std::array<double, 2> drawn = rng.normalPair(base::DrawPurpose::Variation);
    sim2d::Input& push = pushes.emplace_back();
    push.kind = sim2d::InputKind::Push;
    push.id = frame.humans.id[k];
    push.velocity = spread * base::Vec2(drawn[0], drawn[1]);
  }
  return pushes;
}

Future brokenFuture(const FuturesOptions& options, int number, const std::string& why) {
  Future future;
  future.number = number;
  const std::uint64_t seed =
      static_cast<std::uint64_t>(options.seed) + static_cast<std::uint64_t>(number);
  future.seed = static_cast<long long>(seed);  // round the last one
  future.failure = why;
  return future;
}

}  // namespace

Future simulateFuture(sim2d::World& world, const Bundle& bundle, const FuturesOptions& options,
                      int number) {
  Future future = brokenFuture(options, number, {});
  const Verdict verdict = check(bundle);
  if (!verdict.world) {
    future.failure = verdict.problems.empty() ? "the simulation could not be created"
                                              : verdict.problems.front().message;
    return future;
  }
  world.continueWith(*verdict.world, static_cast<std::uint64_t>(future.seed));
  const std::int64_t from = world.stepIndex();
  const double dt = world.dt();
  const auto steps = std::max<std::int64_t>(1, std::llround(options.horizon / dt));
  const auto between = std::max<std::int64_t>(1, std::llround(kPushGap / dt));
  FutureWatcher watcher(future, options.sampleGap, from);
  watcher.look(world.frame(), dt);
  while (world.stepIndex() < from + steps) {
    const bool isPushed = options.spread > 0.0 && (world.stepIndex() - from) % between == 0;
    if (!world.step(isPushed ? pushesOf(world.frame(), options.spread, future.seed)
                             : sim2d::StepInputs())) {
      future.failure = world.failure();
      break;
    }
    watcher.look(world.frame(), dt);
  }
  return future;
}

base::Diagnostics simulateFutures(sim2d::World& world, const Bundle& bundle,
                                  const FuturesOptions& options,
                                  const std::function<void(const Future&)>& onFuture,
                                  const std::function<bool()>& wantsStop) {
  if (!externalCodeOf(*bundle.scenario).empty()) {
    return {base::error("futures.foreign-code", {}, bundle.path)};
  }
  WorkerTasks tasks;
  tasks.count = static_cast<std::size_t>(std::max(0, options.count));
  tasks.jobs = options.jobs;
  tasks.work = [&](std::size_t task) {
    return futureText(simulateFuture(world, bundle, options, static_cast<int>(task)));
  };
  tasks.take = [&](std::size_t task, const std::string& text) {
    const std::optional<Future> future = futureOf(text);
    onFuture(future
                 ? *future
                 : brokenFuture(options, static_cast<int>(task), "the process ended unexpectedly"));
  };
  tasks.wantsStop = wantsStop;
  return runTasks(tasks) ? base::Diagnostics()
                         : base::Diagnostics{base::error("futures.no-process", {}, bundle.path)};
}

std::vector<ContactChance> contactChances(const std::vector<Future>& futures, double from,
                                          double horizon, double gap) {
  std::vector<ContactChance> chances;
  const auto n = static_cast<int>(futures.size());
  const auto last = static_cast<int>(std::floor(horizon / gap + 1e-9));
  for (int k = 0; k <= last; ++k) {
    ContactChance chance;
    chance.time = from + k * gap;
    chance.futures = n;
    chance.contacts =
        static_cast<int>(std::count_if(futures.begin(), futures.end(), [&](const Future& each) {
          return each.contact && each.contact->time <= chance.time + 1e-9;
        }));
    chance.chance = n > 0 ? static_cast<double>(chance.contacts) / n : 0.0;
    chance.interval = statistics::wilsonInterval(chance.contacts, n);
    chances.push_back(chance);
  }
  return chances;
}

std::optional<double> medianContactTime(const std::vector<Future>& futures) {
  std::vector<double> times;
  for (const Future& each : futures) {
    if (each.contact) {
      times.push_back(each.contact->time);
    }
  }
  std::sort(times.begin(), times.end());
  return times.empty() ? std::nullopt : std::optional(times[(times.size() - 1) / 2]);
}

base::Diagnostics runFuturesRequest(const FuturesRequest& request,
                                    const std::function<void(const Future&)>& onFuture,
                                    const std::function<bool()>& wantsStop) {
  BranchedRun run(request.bundle, request.branches);
  if (run.verdict().world == nullptr) {
    base::Diagnostics problems = run.verdict().wrongOptions;
    base::append(problems, run.verdict().problems);
    return problems;
  }
  const std::unique_ptr<sim2d::World> world = std::move(run.verdict().world);
  base::Diagnostics problems;
  Session session({request.at + 1, false});
  session.replayInputs(request.inputs, request.at);
  session.setStepHook(
      [&](const sim2d::Frame& frame, sim2d::World& changing) { run.apply(frame, changing); });
  bool isThere = false;
  const sim2d::RunResult result = session.run(*world, nullptr, [&](const sim2d::Frame& frame) {
    if (wantsStop()) {
      session.stop();
      return;
    }
    if (frame.step != request.at) {
      return;
    }
    isThere = true;
    std::string rows;
    sim2d::appendTrajectoryRows(rows, frame);
    if (!request.state.empty() && rows != request.state) {
      problems.push_back(base::error("futures.goes-elsewhere", {frame.time}, request.bundle.path));
    } else {
      base::append(problems,
                   simulateFutures(*world, run.bundle(), request.options, onFuture, wantsStop));
    }
    session.stop();
  });
  if (!isThere && result.status == sim2d::RunStatus::Failed) {
    problems.push_back(base::error("run.ended", {result.reason}, request.bundle.path));
  }
  return problems;
}

}  // namespace app
