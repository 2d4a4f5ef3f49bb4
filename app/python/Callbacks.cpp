#include "app/python/Callbacks.h"

#include <algorithm>
#include <exception>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <utility>
#include <vector>

#include "app/run/Nav2Robots.h"
#include "sim2d/map/NavigationMap.h"

namespace python {

namespace {

/// The first exception of a callable; simulations never run in parallel.
std::exception_ptr pendingException;  // NOLINT

py::tuple tupleOf(const base::Vec2& point) {
  return py::make_tuple(point.x(), point.y());
}
py::tuple tupleOf(const base::Pose2& pose) {
  return py::make_tuple(pose.position.x(), pose.position.y(), pose.heading);
}

py::list pointsOf(const std::vector<base::Vec2>& points) {
  py::list list;
  for (const base::Vec2& point : points) {
    list.append(tupleOf(point));
  }
  return list;
}

/// A body as an element of a structured array.
struct BodyRow {
  std::int32_t id;
  bool isRobot;
  double x, y, vx, vy, heading, radius;
};

py::array_t<BodyRow> rowsOf(const std::vector<sim2d::TrackedBody>& bodies) {
  py::array_t<BodyRow> rows(static_cast<py::ssize_t>(bodies.size()));
  BodyRow* row = rows.mutable_data();
  for (const sim2d::TrackedBody& body : bodies) {
    *row++ = {body.id,           body.kind == sim2d::BodyKind::Robot,
              body.position.x(), body.position.y(),
              body.velocity.x(), body.velocity.y(),
              body.heading,      body.radius};
  }
  return rows;
}

/// Valid during a call only, like the observation of the planner.
struct ObservationView {
  const sim2d::Observation* of;
  double radius;  // of the robot [m]
  const sim2d::Observation& get() const {
    if (of == nullptr) {
      throw py::value_error("an observation is valid during the call of the planner only");
    }
    return *of;
  }
};

py::object scanOf(const ObservationView& view) {
  const sim2d::LaserScan* const scan = view.get().scan;
  if (scan == nullptr) {
    return py::none();
  }
  py::array_t<double> ranges(static_cast<py::ssize_t>(scan->distances.size()),
                             scan->distances.data());
  py::dict result;
  result["ranges"] = ranges;
  result["angle_min"] = scan->angleMin;
  result["angle_increment"] = scan->angleIncrement;
  result["range_max"] = scan->range;
  result["time"] = scan->time;
  return result;
}

sim2d::BodyTwist twistOf(const py::object& command) {
  const py::sequence values = command.cast<py::sequence>();
  if (values.size() == 2) {
    return {values[0].cast<double>(), values[1].cast<double>()};
  }
  if (values.size() == 3) {
    return {values[0].cast<double>(), values[2].cast<double>(), values[1].cast<double>()};
  }
  throw py::value_error("a planner must return (v, omega) or (vx, vy, omega)");
}

class PythonPlanner : public sim2d::Planner {
 public:
  PythonPlanner(py::handle command, double radius) : command_(command), radius_(radius) {}

  base::Result<sim2d::BodyTwist> command(const sim2d::Observation& observation) override {
    const py::gil_scoped_acquire lock;
    if (pendingException) {
      return sim2d::BodyTwist{};
    }
    try {
      const py::object view = py::cast(ObservationView{&observation, radius_});
      const py::object result = command_(view);
      view.cast<ObservationView&>().of = nullptr;
      return twistOf(result);
    } catch (...) {
      pendingException = std::current_exception();
      return sim2d::BodyTwist{};
    }
  }

 private:
  const py::handle command_;  // of a callable that outlives the world
  const double radius_;
};

/// Valid during a call only.
struct PersonView {
  const sim2d::WorldView* world;
  sim2d::Intents* intents;
  int human;
};

py::list neighboursOf(const PersonView& person, double range) {
  std::vector<int> found;
  person.world->near(person.human, range, found);
  py::list list;
  for (const int other : found) {
    list.append(py::make_tuple(person.world->constants(other).id,
                               tupleOf(person.world->pose(other)),
                               tupleOf(person.world->velocity(other))));
  }
  return list;
}

py::list robotsOf(const PersonView& person) {
  py::list list;
  for (int robot = 0; robot < person.world->robotCount(); ++robot) {
    list.append(py::make_tuple(tupleOf(person.world->robotPose(robot)),
                               tupleOf(person.world->robotVelocity(robot))));
  }
  return list;
}

py::list goalsOf(const PersonView& person) {
  py::list list;
  for (const sim2d::GoalItem& goal : person.intents->control(person.human).goals) {
    list.append(tupleOf(goal.position));
  }
  return list;
}

/// Applies ("stand",), ("turn", heading) or ("walk", (x, y)[, speed]) to the intent.
void applyDecision(const py::object& decision, const PersonView& person, sim2d::Intent& intent) {
  if (decision.is_none()) {
    return;
  }
  const py::sequence words = decision.cast<py::sequence>();
  const auto kind = words[0].cast<std::string>();
  intent = {};
  if (kind == "walk") {
    const py::sequence point = words[1].cast<py::sequence>();
    intent.motion = sim2d::Motion::Walk;
    intent.target = {0, {point[0].cast<double>(), point[1].cast<double>()}};
    intent.speed = words.size() > 2 ? words[2].cast<double>()
                                    : person.world->constants(person.human).desiredSpeed;
  } else if (kind == "turn") {
    intent.motion = sim2d::Motion::Turn;
    intent.heading = words[1].cast<double>();
  } else if (kind != "stand") {
    throw py::value_error(
        "a behaviour must return None, ('stand',), ('turn', heading) or "
        "('walk', (x, y), speed), not '" +
        kind + "'");
  }
}

/// Behaviour trees for all people, then the callables for theirs.
class PythonBehavior : public sim2d::HumanBehavior {
 public:
  PythonBehavior(std::unique_ptr<sim2d::HumanBehavior> trees, std::map<int, py::handle> callables)
      : trees_(std::move(trees)), callables_(std::move(callables)) {}

  void enter(int human, const sim2d::WorldView& view) override { trees_->enter(human, view); }
  void decide(const sim2d::WorldView& view, sim2d::Intents& intents) override {
    trees_->decide(view, intents);
    const py::gil_scoped_acquire lock;
    for (const auto& [id, callable] : callables_) {
      const int human = view.indexOf(id);
      if (human >= 0 && view.isPresent(human) && view.decides(human) && !pendingException) {
        call(callable, {&view, &intents, human}, intents.of(human));
      }
    }
  }
  void takeTreeChanges(sim2d::TreeChanges& changes) override { trees_->takeTreeChanges(changes); }
  bool hasCustomTree(int human, const sim2d::WorldView& view) const override {
    return trees_->hasCustomTree(human, view);
  }
  std::vector<base::TreeResults> treeResults() const override { return trees_->treeResults(); }
  void takeDiagnostics(base::Diagnostics& found) override { trees_->takeDiagnostics(found); }
  std::vector<std::pair<std::string, std::string>> blackboard(int human) const override {
    return trees_->blackboard(human);
  }
  std::string setBlackboardEntry(int human, const std::string& key,
                                 const std::string& text) override {
    return trees_->setBlackboardEntry(human, key, text);
  }
  void setBreakpoints(const std::vector<sim2d::TreeBreakpoint>& points) override {
    trees_->setBreakpoints(points);
  }
  std::optional<sim2d::TreeBreakpointHit> takeBreakpointHit() override {
    return trees_->takeBreakpointHit();
  }

 private:
  static void call(const py::handle& callable, const PersonView& person, sim2d::Intent& intent) {
    try {
      applyDecision(callable(py::cast(person)), person, intent);
    } catch (...) {
      pendingException = std::current_exception();
    }
  }

  std::unique_ptr<sim2d::HumanBehavior> trees_;
  std::map<int, py::handle> callables_;  // by id of the person; they outlive the world
};

void requireNames(const Callables& callables, const std::vector<std::string>& names,
                  const char* what) {
  for (const auto& [name, unused] : callables) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw py::value_error(std::string("the scenario has no ") + what + " '" + name + "'");
    }
  }
}

template <class Entity>
std::vector<std::string> namesOf(const std::vector<Entity>& entities) {
  std::vector<std::string> names;
  sim2d::forEachListed(entities, [&names](const Entity& each) { names.push_back(each.name); });
  return names;
}

/// All planners of the program; those of the named robots are replaced.
std::shared_ptr<const sim2d::Registries> registriesWith(const Callables& planners) {
  const sim2d::Registries known = app::builtinRegistries();
  auto all = std::make_shared<sim2d::Registries>(known);
  all->planners = {};
  std::map<std::string, py::handle> handles(planners.begin(), planners.end());
  for (const auto& entry : known.planners.entries()) {
    all->planners.add(
        entry.name, entry.parameters,
        [make = entry.make, handles](
            const sim2d::PlannerSetup& setup) -> base::Result<std::shared_ptr<sim2d::Planner>> {
          const auto found = handles.find(setup.robot);
          if (found == handles.end()) {
            return make(setup);
          }
          return std::shared_ptr<sim2d::Planner>(std::make_shared<PythonPlanner>(
              found->second, sim2d::circumscribedRadius(setup.body.footprint)));
        },
        entry.help);
  }
  return all;
}

}  // namespace

Callables callablesOf(const py::object& dict, const char* method) {
  Callables callables;
  if (dict.is_none()) {
    return callables;
  }
  for (const auto& [name, object] : dict.cast<py::dict>()) {
    py::object callable = py::hasattr(object, method) ? object.attr(method)
                                                      : py::reinterpret_borrow<py::object>(object);
    if (PyCallable_Check(callable.ptr()) == 0) {
      throw py::type_error(std::string("expected a callable or an object with a method '") +
                           method + "'");
    }
    callables[name.cast<std::string>()] = std::move(callable);
  }
  return callables;
}

void useCallables(sim2d::WorldSetup& setup, const Callables& planners, const Callables& behaviors) {
  requireNames(planners, namesOf(setup.scenario->robots), "robot");
  requireNames(behaviors, namesOf(setup.scenario->humans), "person");
  if (!planners.empty()) {
    setup.registries = registriesWith(planners);
  }
  if (!behaviors.empty()) {
    std::map<int, py::handle> byId;
    for (const auto& [name, callable] : behaviors) {
      byId[setup.scenario->human(name)->id] = callable;
    }
    setup.behavior = std::make_unique<PythonBehavior>(std::move(setup.behavior), std::move(byId));
  }
}

bool hasPending() {
  return pendingException != nullptr;
}

void rethrowPending() {
  if (pendingException) {
    std::rethrow_exception(std::exchange(pendingException, nullptr));
  }
}

namespace {

void addObservation(py::module_& module) {
  py::class_<ObservationView>(module, "Observation",
                              "What a robot knows when its planner is called; world frame, metres, "
                              "radians, seconds. Valid during the call only.")
      .def_property_readonly("time", [](const ObservationView& v) { return v.get().time; })
      .def_property_readonly("dt", [](const ObservationView& v) { return v.get().dt; })
      .def_property_readonly(
          "pose", [](const ObservationView& v) { return tupleOf(v.get().pose); },
          "Estimated pose (x, y, heading).")
      .def_property_readonly(
          "motion",
          [](const ObservationView& v) {
            const sim2d::BodyTwist& motion = v.get().motion;
            return py::make_tuple(motion.linear, motion.lateral, motion.angular);
          },
          "Velocity (vx ahead, vy left, omega), from odometry.")
      .def_property_readonly(
          "goal", [](const ObservationView& v) { return tupleOf(v.get().goal); },
          "Current goal (x, y).")
      .def_property_readonly(
          "remaining_goals",
          [](const ObservationView& v) { return pointsOf(v.get().remainingGoals); },
          "The goals after the current one.")
      .def_property_readonly("goal_radius",
                             [](const ObservationView& v) { return v.get().goalRadius; })
      .def_property_readonly(
          "bodies", [](const ObservationView& v) { return rowsOf(v.get().bodies); },
          "Perceived people and robots: structured array with id, is_robot, x, "
          "y, vx, vy, heading, radius.")
      .def_property_readonly("scan", scanOf,
                             "Last lidar scan: dict with ranges [m], angle_min, angle_increment, "
                             "range_max, time; None without a lidar.")
      .def(
          "path",
          [](const ObservationView& v) {
            const sim2d::Observation& of = v.get();
            return pointsOf(of.navigation->plan(v.radius, of.pose.position, of.goal));
          },
          "Shortest path around walls to the goal, as a list of points; empty: none.");
}

void addPersonView(py::module_& module) {
  py::class_<PersonView>(module, "PersonView",
                         "What a behaviour of a person sees; world frame, metres, radians, "
                         "seconds. Valid during the call only.")
      .def_property_readonly("time", [](const PersonView& p) { return p.world->time(); })
      .def_property_readonly("dt", [](const PersonView& p) { return p.world->dt(); })
      .def_property_readonly("id",
                             [](const PersonView& p) { return p.world->constants(p.human).id; })
      .def_property_readonly("pose",
                             [](const PersonView& p) { return tupleOf(p.world->pose(p.human)); })
      .def_property_readonly(
          "velocity", [](const PersonView& p) { return tupleOf(p.world->velocity(p.human)); })
      .def_property_readonly(
          "desired_speed",
          [](const PersonView& p) { return p.world->constants(p.human).desiredSpeed; })
      .def_property_readonly("goals", goalsOf, "Remaining goals, the current one first.")
      .def_property_readonly("robots", robotsOf, "List of (pose, velocity).")
      .def("neighbours", neighboursOf, py::arg("range"),
           "People within `range`, nearest first: list of (id, pose, velocity).")
      .def(
          "sees",
          [](const PersonView& p, double x, double y) {
            return p.world->isVisible(p.world->pose(p.human).position, {x, y});
          },
          py::arg("x"), py::arg("y"), "Whether no wall or closed door lies in between.");
}

}  // namespace

void addCallbacks(py::module_& module) {
  PYBIND11_NUMPY_DTYPE_EX(BodyRow, id, "id", isRobot, "is_robot", x, "x", y, "y", vx, "vx", vy,
                          "vy", heading, "heading", radius, "radius");
  addObservation(module);
  addPersonView(module);
}

}  // namespace python
