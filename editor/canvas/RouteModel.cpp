#include "editor/canvas/RouteModel.h"

#include <cmath>
#include <set>

#include "app/run/Bundle.h"
#include "sim2d/map/NavigationMap.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace editor {

namespace {

std::vector<Vec2> placesOf(const sim2d::Scenario& scenario) {
  std::vector<Vec2> places;
  for (const sim2d::GlobalGoal& goal : scenario.goals) {
    places.push_back(goal.position);
  }
  for (const sim2d::Human& human : scenario.humans) {
    places.push_back(human.initPose.position);
  }
  for (const sim2d::Robot& robot : scenario.robots) {
    places.push_back(robot.start.position);
    if (robot.goal.point) {
      places.push_back(*robot.goal.point);
    }
  }
  return places;
}

constexpr int kPauseMs = 15;
constexpr std::chrono::milliseconds kMaxTime(100);  // Maximum time until new results are shown.

/// Identifies a leg, which all agents with the same ends share. The order groups legs by goal, so
/// that the planner searches from each goal once.
struct LegKey {
  int radiusCm = 35;  // -1: straight.
  double toX = 0.0, toY = 0.0, fromX = 0.0, fromY = 0.0;

  friend bool operator<(const LegKey& a, const LegKey& b) {
    return std::tie(a.radiusCm, a.toX, a.toY, a.fromX, a.fromY) <
           std::tie(b.radiusCm, b.toX, b.toY, b.fromX, b.fromY);
  }
};

using Legs = std::map<EntityId, std::vector<LegKey>>;

/// The legs of all agents in walking order.
Legs legsOf(const sim2d::Scenario& scenario) {
  Legs legs;
  const auto add = [&legs](EntityId id, Vec2 at, const std::vector<Vec2>& goals, int radiusCm) {
    std::vector<LegKey>& own = legs[id];
    if (!base::isWithinCoordinateRange(at) ||
        !std::all_of(goals.begin(), goals.end(), base::isWithinCoordinateRange)) {
      return;  // The problem list reports it.
    }
    for (const Vec2& goal : goals) {
      own.push_back({radiusCm, goal.x(), goal.y(), at.x(), at.y()});
      at = goal;
    }
  };
  const auto centimetres = [](double metres) {
    return static_cast<int>(std::lround(100.0 * metres));
  };
  const long long seed = scenario.desktop.seed.value_or(1);
  for (const sim2d::Human& human : scenario.humans) {
    const sim2d::ResolvedHuman resolved = sim2d::resolveHuman(scenario, human, seed);
    std::vector<Vec2> goals;
    for (const int id : human.goals) {
      if (const sim2d::GlobalGoal* goal = scenario.goal(id)) {
        goals.push_back(goal->position);
      }
    }
    if (resolved.cyclicGoals && goals.size() > 1) {
      goals.push_back(goals.front());
    }
    const bool isDirect = resolved.route == sim2d::Route::Direct;
    add(human.key, human.initPose.position, goals, isDirect ? -1 : centimetres(resolved.radius));
  }
  for (const sim2d::Robot& robot : scenario.robots) {
    const sim2d::ResolvedRobot resolved = sim2d::resolveRobot(scenario, robot, -1);
    add(robot.key, resolved.start.position, resolved.goals, centimetres(resolved.radius));
  }
  return legs;
}

}  // namespace

/// The planner, and the known legs while the walls stay the same.
struct RouteModel::Planning {
  std::shared_ptr<const sim2d::Surroundings> surroundings;
  std::vector<Vec2> places;
  std::optional<sim2d::NavigationMap> navigation;
  std::map<LegKey, RouteLeg> legs;  // Legs of the previous request.

  void prepare(const Input& input) {
    const auto newSurroundings = input.known->of(input.scenario, input.map, input.stop);
    const std::vector<Vec2> newPlaces = placesOf(input.scenario);
    // The positions matter only on an open plane, where the planner's grid must cover them.
    if (surroundings == newSurroundings && (!input.map->isEmpty() || places == newPlaces)) {
      return;
    }
    surroundings.reset();  // Reset until the rest is done, because it may be stopped.
    legs.clear();
    // On an open plane layers depend on positions, which change during a drag.
    navigation.emplace(newSurroundings->grid, newSurroundings->obstacles, newPlaces,
                       input.map->isEmpty() ? nullptr : newSurroundings->layers);
    surroundings = newSurroundings;
    places = newPlaces;
  }

  RouteLeg planned(const LegKey& key) {
    const Vec2 from(key.fromX, key.fromY);
    const Vec2 to(key.toX, key.toY);
    if (key.radiusCm < 0) {
      return {{from, to}, true};
    }
    std::vector<Vec2> way = navigation->plan(0.01 * key.radiusCm, from, to);
    const bool isThere = !way.empty();
    return {isThere ? std::move(way) : std::vector<Vec2>{from, to}, isThere};
  }

  /// Plans the unknown legs within the time limit and removes unused ones. Returns true if all are
  /// known.
  bool plan(const std::set<LegKey>& wanted) {
    for (auto leg = legs.begin(); leg != legs.end();) {
      leg = wanted.count(leg->first) == 0 ? legs.erase(leg) : std::next(leg);
    }
    const auto end = std::chrono::steady_clock::now() + kMaxTime;
    for (const LegKey& key : wanted) {
      if (legs.count(key) > 0) {
        continue;
      }
      if (std::chrono::steady_clock::now() > end) {
        return false;
      }
      legs.emplace(key, planned(key));
    }
    return true;
  }

  /// The routes whose legs are all known.
  Planned routesOf(const Legs& walked) {
    std::set<LegKey> wanted;
    for (const auto& [id, keys] : walked) {
      wanted.insert(keys.begin(), keys.end());
    }
    Planned result;
    result.isComplete = plan(wanted);
    for (const auto& [id, keys] : walked) {
      EntityRoute route;
      for (const LegKey& key : keys) {
        const auto found = legs.find(key);
        if (found != legs.end()) {
          route.push_back(found->second);
        }
      }
      if (route.size() == keys.size()) {
        result.routes[id] = std::move(route);
      }
    }
    return result;
  }
};

RouteModel::RouteModel(QObject* parent)
    : QObject(parent),
      planning_(std::make_shared<Planning>()),
      task_([this](Planned planned) { take(std::move(planned)); }) {
  timer_.setSingleShot(true);
  timer_.setInterval(kPauseMs);
  connect(&timer_, &QTimer::timeout, this, &RouteModel::start);
}

RouteModel::~RouteModel() = default;

void RouteModel::request(std::function<Input()> input) {
  input_ = std::move(input);
  if (!timer_.isActive()) {
    timer_.start();
  }
}

void RouteModel::start() {
  if (task_.isBusy()) {
    timer_.start();
    return;
  }
  auto input = std::make_shared<const Input>(input_());
  task_.start([input, planning = planning_] {
    planning->prepare(*input);
    Planned planned = planning->routesOf(legsOf(input->scenario));
    input->stop->check();
    return planned;
  });
}

void RouteModel::take(Planned planned) {
  Routes& routes = planned.routes;
  if (!planned.isComplete) {
    routes.insert(routes_.begin(), routes_.end());  // Keeps previous routes without a new one.
    timer_.start();
  }
  changed_.clear();
  for (const auto& [id, newRoute] : routes) {
    const EntityRoute* old = route(id);
    if (old == nullptr || !(*old == newRoute)) {
      changed_.push_back(id);
    }
  }
  for (const auto& [id, oldRoute] : routes_) {
    if (routes.count(id) == 0) {
      changed_.push_back(id);
    }
  }
  routes_ = std::move(routes);
  Q_EMIT routesChanged();
}

void RouteModel::finish() {
  task_.finish();
  while (timer_.isActive()) {
    timer_.stop();
    start();
    task_.finish();
  }
}

}  // namespace editor
