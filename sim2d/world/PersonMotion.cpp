#include "sim2d/world/PersonMotion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "sim2d/base/Text.h"
#include "sim2d/world/SpeedZones.h"
#include "sim2d/world/StepBuffers.h"

namespace sim2d {
namespace {

constexpr double kTurnRate = base::kPi;       // [rad/s]
constexpr std::size_t kMoveSlice = 16;        // people per work slice
constexpr std::size_t kPrefetchDistance = 4;  // prefetch distance in people
constexpr double kWallMargin = 1.0;           // [m]; walls nearer to the body can be run into

constexpr double kStanding = 0.1;       // [m/s]; slower bodies count as standing
constexpr double kStandingReach = 3.0;  // [m]

constexpr double kCrowdReach = 2.0;                  // [m]
constexpr double kSpreadPerPerson = 0.35;            // [m]
constexpr double kWidestSpread = 4.0;                // [m]
constexpr double kGoldenSection = 0.61803398874989;  // its multiples are equidistributed

double turned(double heading, double towards, double most) {
  const double turn = base::angleDiff(towards, heading);
  return base::wrapToPi(heading + std::clamp(turn, -most, most));
}

/// Distance from the shortest path at which the person passes corners: each person has its own
/// lane, and the total width grows with the number of neighbours.
double cornerSpread(const FrozenWorld& world, std::size_t human) {
  if (!world.model.people[human].model->spreadsAtCorners()) {
    return 0.0;
  }
  int near = 0;
  const Vec2 place = world.state.position(human);
  world.grid.forEachNear(place, kCrowdReach, [&near](int /*other*/) { ++near; });
  const double width = std::min(kWidestSpread, kSpreadPerPerson * (near - 1));
  const double turns = kGoldenSection * static_cast<double>(human);
  return width * (turns - std::floor(turns));
}

/// People and robots that stand; planned paths consider walls only.
std::vector<StandingBody> standingBodiesNear(const FrozenWorld& world, std::size_t human) {
  std::vector<StandingBody> standing;
  const WorldState& state = world.state;
  world.grid.forEachNear(state.position(human), kStandingReach, [&](int other) {
    const auto at = static_cast<std::size_t>(other);
    if (at != human && state.velocity(at).norm() < kStanding) {
      standing.push_back({state.position(at), world.model.people[at].constants.radius});
    }
  });
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    if (state.robots[i].velocity.norm() < kStanding) {
      standing.push_back(
          {state.robots[i].pose.position, circumscribedRadius(world.model.robots[i])});
    }
  }
  return standing;
}

}  // namespace

void PersonMotion::resize(std::size_t count) {
  routes_.resize(count);
  plans_.steps.resize(count);
  plans_.directions.resize(count, Vec2::Zero());
  wanted_.resize(count, Vec2::Zero());
}

void PersonMotion::forget(std::size_t human) {
  if (RouteFollower* const route = routes_[human].get()) {
    route->reset();
  }
}

void PersonMotion::enter(std::size_t human) {
  forget(human);
  plans_.directions[human] = Vec2::Zero();
}

std::vector<Vec2> PersonMotion::remainingPath(std::size_t human) const {
  const RouteFollower* const route = routes_[human].get();
  const bool isOnTheWay = !plans_.directions[human].isZero(0.0);
  return route != nullptr && isOnTheWay ? route->rest() : std::vector<Vec2>();
}

void PersonMotion::compute(const FrozenWorld& world, const Intents& intents, WorldState& state,
                           ForceColumns& forces) {
  crowd_.update(world, plans_, workers_);
  crowd_.computeForces(workers_);
  workspaces_.resize(workers_.threadCount());
  walls_.resize(world.navigation.isOpenPlane() || externalWalls_ != nullptr ? 0 : wanted_.size());
  forEachColumn(forces, [this](std::vector<Vec2>& column) { column.resize(wanted_.size()); });
  for (Workspace& workspace : workspaces_) {
    workspace.isSound = true;
  }
  const auto moveSlice = [&](std::size_t thread, std::size_t begin, std::size_t end) {
    Workspace& workspace = workspaces_[thread];
    for (std::size_t human = begin; human < end; ++human) {
      crowd_.prefetch(human + kPrefetchDistance);
      ForceTerms terms;
      if (state.present[human] != 0) {
        terms = move(human, world, intents, workspace.situation);
        if (plans_.steps[human].motion == Motion::Turn) {
          const Intent& intent = intents.of(static_cast<int>(human));
          const double most = std::max(0.0, intent.turnRate) * world.model.dt;
          state.heading[human] = turned(state.heading[human], intent.heading, most);
        }
      }
      workspace.isSound = workspace.isSound &&
                          (state.present[human] == 0 ||
                           (sim2d::isSound(wanted_[human]) && std::isfinite(state.heading[human])));
      forces.goal[human] = terms.goal;
      forces.social[human] = terms.social;
      forces.obstacle[human] = terms.obstacle;
      forces.group[human] = terms.group;
    }
  };
  workers_.parallelFor(wanted_.size(), kMoveSlice, moveSlice);
  for (const std::size_t human : yieldModel_.people()) {
    if (isWalking(plans_.steps[human].motion) && sim2d::isSound(wanted_[human])) {
      wanted_[human] = yieldModel_.limited(world, human, wanted_[human], wallsNear(human));
    }
  }
}

bool PersonMotion::isSound() const {
  return std::all_of(workspaces_.begin(), workspaces_.end(),
                     [](const Workspace& workspace) { return workspace.isSound; });
}

void PersonMotion::wakeWorkers() {
  if (wanted_.size() >= WorkerPool::kMinParallelItems) {
    workers_.wakeThreads();
  }
}

void PersonMotion::chooseDirections(const FrozenWorld& world, const Intents& intents,
                                    WorldState& state) {
  yieldModel_.update(world);
  for (std::size_t human = 0; human < wanted_.size(); ++human) {
    chooseDirection(human, intents.of(static_cast<int>(human)), world, state);
  }
}

void PersonMotion::chooseDirection(std::size_t human, const Intent& intent,
                                   const FrozenWorld& world, WorldState& state) {
  const HumanControl& control = state.controls[human];
  const ResolvedHuman& person = world.model.people[human].constants;
  const double factor = speedFactorAt(world.model, state.position(human));
  const double walkingSpeed = factor * intent.speed;
  const double speed = intent.motion == Motion::Walk ? walkingSpeed : factor * person.desiredSpeed;
  const bool wasOnTheWay = !plans_.directions[human].isZero(0.0);
  StepPlan plan{control.frozen || speed < 0.0 ? 0.0 : speed,
                control.group,
                intent.motion,
                intent.robot,
                wasOnTheWay,
                !intent.extraForce.isZero(0.0)};
  if (state.present[human] == 0 || intent.motion != Motion::Walk) {
    plans_.directions[human] = Vec2::Zero();
    assignIfChanged(plans_.steps[human], plan);
    return;
  }
  const RouteFollower::Request request{state.position(human),
                                       intent.target,
                                       person.radius,
                                       control.frozen ? 0.0 : walkingSpeed,
                                       state.time,
                                       cornerSpread(world, human)};
  RouteFollower::Guidance leg = person.route == Route::Direct
                                    ? RouteFollower::straight(request)
                                    : plannedGuidance(human, request, world);
  // A reaction to the robot has its own target: in its way, behind it, far from it.
  const bool isReaction = intent.active && reactsToRobot(person.behavior);
  const bool walks = !leg.direction.isZero(0.0) && request.speed > 0.0;
  if (yieldModel_.isNearRobot(human) && walks && !isReaction) {
    yieldToRobots(human, request, world, leg);
  }
  plans_.directions[human] = leg.direction;
  plan.startsOrStops = wasOnTheWay == leg.direction.isZero(0.0);
  assignIfChanged(plans_.steps[human], plan);
  if (leg.replanned) {
    state.emit(EventKind::Replan, person.id);
  }
  if (leg.stuck) {
    state.emit(EventKind::Stuck, person.id);
    routes_[human]->insertDetour(request, standingBodiesNear(world, human), world.navigation);
  }
}

RouteFollower::Guidance PersonMotion::plannedGuidance(std::size_t human,
                                                      const RouteFollower::Request& request,
                                                      const FrozenWorld& world) {
  if (routes_[human] == nullptr) {
    routes_[human] = std::make_unique<RouteFollower>();
  }
  return routes_[human]->follow(request, world.navigation, world.obstacles);
}

void PersonMotion::yieldToRobots(std::size_t human, const RouteFollower::Request& request,
                                 const FrozenWorld& world, RouteFollower::Guidance& leg) {
  RouteFollower* const route =
      world.model.people[human].constants.route == Route::Direct ? nullptr : routes_[human].get();
  const YieldModel::Guidance lead = yieldModel_.lead(
      world,
      {human, request.position, request.radius, request.speed, leg.direction, request.target.radius,
       route != nullptr ? route->rest() : std::vector<Vec2>{request.target.position}});
  leg.direction = lead.direction;
  if (lead.waits && route != nullptr) {
    route->wait(request.time);
    leg.replanned =
        (!lead.closed.empty() &&
         route->tryAlternativePath(request, lead.closed, lead.stoodFor, world.navigation)) ||
        leg.replanned;
  }
}

void PersonMotion::updateWalls(std::size_t human, const FrozenWorld& world) {
  walls_[human].clear();
  const Walker& walker = crowd_.walker(human);
  const bool wallsAct = isWalking(plans_.steps[human].motion) &&
                        world.model.obstaclePoints == ObstaclePoints::Boundary;
  const double range = wallsAct ? kObstacleRange : walker.radius + kWallMargin;
  if (crowd_.room(human) < range) {
    world.obstacles.boundaryPoints(walker.position, walls_[human], range);
  }
}

ForceTerms PersonMotion::move(std::size_t human, const FrozenWorld& world, const Intents& intents,
                              Situation& situation) {
  const StepPlan& plan = plans_.steps[human];
  const Vec2 carried = carryingVelocityAt(world.model, crowd_.walker(human).position);
  wanted_[human] = carried;
  if (!walls_.empty()) {
    updateWalls(human, world);
  }
  if (!isWalking(plan.motion)) {
    return {};
  }
  crowd_.fill(human, wallsNear(human), situation);
  situation.self.velocity -= carried;  // people walk relative to the ground that carries them
  situation.forceTime = situation.dt * (plan.startsOrStops ? 0.5 : 1.0);
  const std::function<bool(const Vec2&, const Vec2&)> isVisible =
      [&](const Vec2& /*own*/, const Vec2& other) { return crowd_.isVisible(human, other); };
  situation.isVisible = &isVisible;
  const PedestrianModel& model = crowd_.modelOf(human);
  ForceTerms forces = model.forces(situation);
  if (plan.motion == Motion::Walk && plan.hasExtraForce) {
    forces.social += intents.of(static_cast<int>(human)).extraForce;
  }
  const Vec2 own = model.velocity(situation, forces);
  wanted_[human] = carried.isZero(0.0) ? own : Vec2(own + carried);
  return forces;
}

bool isSound(const Vec2& velocity) {
  return velocity.allFinite() && velocity.norm() <= kMaxPlausibleSpeed;
}

double turnedHeading(double heading, const Vec2& velocity, double dt) {
  if (velocity.norm() < kMinHeadingSpeed) {
    return heading;
  }
  return turned(heading, base::headingOf(velocity), kTurnRate * dt);
}

namespace {

constexpr double kLeftDistance = 0.5;  // [m] outside the radius: the goal was left

/// Index of the next goal with this id after `last`, in the person's written goals.
std::optional<std::size_t> indexAfter(const std::vector<int>& goals, int id, std::size_t last,
                                      bool hasLast) {
  for (std::size_t i = 0; i < goals.size(); ++i) {
    const std::size_t index = (i + (hasLast ? last + 1 : 0)) % goals.size();
    if (goals[index] == id) {
      return index;
    }
  }
  return std::nullopt;
}

}  // namespace

void PersonGoals::afterDecide(const WorldModel& model, WorldState& state, Intents& intents,
                              const WorldView& view) {
  for (const Event& event : intents.events()) {
    const int index = event.hasId ? view.indexOf(event.id) : -1;
    const auto human = static_cast<std::size_t>(index);
    if (index >= 0 && event.kind == EventKind::Goal) {
      recordReached(model, state, human, static_cast<int>(base::parseInt(event.text).value_or(0)));
    }
    if (index >= 0 && event.kind == EventKind::Arrived) {
      arrived_.push_back(human);
    }
  }
  for (std::size_t human = 0; human < people_.size(); ++human) {
    Intent& intent = intents.of(static_cast<int>(human));
    const bool waits = state.time < people_[human].waitingUntil - kTimeTolerance;
    if (state.present[human] != 0 && waits && intent.motion == Motion::Walk &&
        intent.targetIsGoal) {
      intent.motion = Motion::Stand;
    }
  }
  std::move(intents.events().begin(), intents.events().end(), std::back_inserter(state.events));
  intents.events().clear();
}

void PersonGoals::afterMotion(const WorldModel& model, WorldState& state, const Intents& intents) {
  for (std::size_t human = 0; human < people_.size(); ++human) {
    const Intent& intent = intents.of(static_cast<int>(human));
    std::vector<GoalItem>& goals = state.controls[human].goals;
    if (state.present[human] == 0 || intent.motion != Motion::Walk || !intent.targetIsGoal ||
        goals.empty()) {
      continue;
    }
    Progress& progress = people_[human];
    const GoalItem front = goals.front();
    const double distance = (front.position - state.position(human)).norm();
    const bool stayed =
        progress.lastReached != nullptr && *progress.lastReached == front &&
        model.people[human].constants.cyclicGoals &&
        std::count(goals.begin(), goals.end(), front) == static_cast<std::ptrdiff_t>(goals.size());
    if (stayed) {  // a cyclic list with a single goal at the person's position
      if (distance > front.radius + kLeftDistance) {
        progress.lastReached = nullptr;
      }
      continue;
    }
    if (distance > front.radius) {
      continue;
    }
    goals.erase(goals.begin());
    if (model.people[human].constants.cyclicGoals) {
      goals.push_back(front);
    }
    reach(model, state, human, front);
  }
}

void PersonGoals::reach(const WorldModel& model, WorldState& state, std::size_t human,
                        const GoalItem& goal) {
  const int personId = model.people[human].constants.id;
  people_[human].lastReached = std::make_unique<GoalItem>(goal);
  state.emit(EventKind::Goal, personId, goal.id > 0 ? std::to_string(goal.id) : "");
  recordReached(model, state, human, goal.id);
  if (state.controls[human].goals.empty()) {
    state.emit(EventKind::Arrived, personId);
    arrived_.push_back(human);
  }
}

void PersonGoals::recordReached(const WorldModel& model, const WorldState& state, std::size_t human,
                                int goalId) {
  const Person& person = model.people[human];
  Progress& progress = people_[human];
  const std::optional<std::size_t> index =
      indexAfter(person.plan->written, goalId, progress.lastIndex, progress.hasReached);
  if (!index) {
    return;
  }
  progress.lastIndex = static_cast<std::uint32_t>(*index);
  progress.hasReached = true;
  if (*index < person.constants.wait.size()) {
    progress.waitingUntil = state.time + person.constants.wait[*index];
  }
}

}  // namespace sim2d
