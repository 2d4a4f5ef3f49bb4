#include <pybind11/stl.h>
#include <utility>

#include "app/python/Bindings.h"
#include "app/python/Callbacks.h"
#include "app/python/Problems.h"
#include "app/python/RunBinding.h"
#include "app/python/ScenarioBinding.h"
#include "sim2d/base/Find.h"

namespace python {

namespace {

/// A world that Python steps.
class Simulation {
 public:
  Simulation(const Scenario& scenario, const py::object& planners, const py::object& behaviors,
             const py::kwargs& options)
      : planners_(callablesOf(planners, "command")), behaviors_(callablesOf(behaviors, "decide")) {
    const app::Bundle bundle = scenario.bundle(options);
    app::Verdict verdict = app::check(bundle, app::CheckDepth::Setup);
    requireNoErrors(verdict.wrongOptions);
    requireNoErrors(verdict.problems);
    scenario_ = verdict.setup->scenario;
    useCallables(*verdict.setup, planners_, behaviors_);
    base::Result<std::unique_ptr<sim2d::World>> world = [&] {
      const SimulationLock lock;
      return sim2d::World::create(*std::move(verdict.setup));
    }();
    if (!world) {
      throwProblems(world.diagnostics());
    }
    world_ = *std::move(world);
  }

  /// Steps `count` times; the inputs apply to the first step.
  void step(std::int64_t count) {
    bool isAlive = true;
    base::Diagnostics refused;
    {
      const SimulationLock lock;
      for (std::int64_t i = 0; i < count && isAlive && !hasPending(); ++i) {
        isAlive = world_->step(std::exchange(inputs_, {}));
        base::append(refused, world_->refused());
        const auto& events = world_->frame().events;
        events_.insert(events_.end(), events.begin(), events.end());
      }
    }
    rethrowPending();
    if (!isAlive) {
      throw std::runtime_error(world_->failure());
    }
    if (!refused.empty()) {
      throwProblems(refused);
    }
  }

  py::array state() const {
    std::vector<StateRow> rows;
    appendRows(rows, world_->frame());
    return arrayOf(std::move(rows));
  }
  py::list takeEvents() {
    py::list list;
    for (const sim2d::Event& event : std::exchange(events_, {})) {
      py::dict entry;
      entry["kind"] = sim2d::eventKindName(event.kind);
      entry["id"] = event.hasId ? py::object(py::int_(event.id)) : py::none();
      entry["other"] = event.hasOther ? py::object(py::int_(event.other)) : py::none();
      entry["text"] = event.text;
      list.append(entry);
    }
    return list;
  }
  double time() const { return world_->time(); }
  double dt() const { return world_->dt(); }

  void drive(const std::string& robot, double v, double omega, double lateral) {
    sim2d::Input input = inputOf(sim2d::InputKind::Robot, robot);
    input.velocity = {v, lateral};
    input.omega = omega;
    inputs_.push_back(input);
  }
  void setGoal(const std::string& robot, double x, double y) {
    sim2d::Input input = inputOf(sim2d::InputKind::Goal, robot);
    input.pose.position = {x, y};
    inputs_.push_back(input);
  }
  void move(const std::string& name, double x, double y, double heading) {
    sim2d::Input input = inputOf(sim2d::InputKind::Move, name);
    input.pose = {{x, y}, heading};
    inputs_.push_back(input);
  }
  void setDoor(const std::string& door, bool isOpen) {
    sim2d::Input input;
    input.kind = isOpen ? sim2d::InputKind::Open : sim2d::InputKind::Close;
    input.name = door;
    inputs_.push_back(input);
  }
  void hold(const std::string& person, bool isHeld) {
    inputs_.push_back(inputOf(isHeld ? sim2d::InputKind::Stop : sim2d::InputKind::Resume, person));
  }

 private:
  sim2d::Input inputOf(sim2d::InputKind kind, const std::string& name) const {
    sim2d::Input input;
    input.kind = kind;
    int id = -1;
    for (const sim2d::Robot& robot : scenario_->robots) {
      if (robot.listed && robot.name == name) {
        input.id = id;
        return input;
      }
      id -= robot.listed ? 1 : 0;
    }
    const sim2d::Human* const human = scenario_->human(name);
    if (human == nullptr) {
      throw py::value_error("the scenario has no robot or person '" + name + "'");
    }
    input.id = human->id;
    return input;
  }

  const Callables planners_, behaviors_;
  std::shared_ptr<const sim2d::Scenario> scenario_;
  std::unique_ptr<sim2d::World> world_;
  sim2d::StepInputs inputs_;  // of the next step
  std::vector<sim2d::Event> events_;
};

}  // namespace

void addSimulation(py::module_& module) {
  py::class_<Simulation>(module, "Simulation",
                         "A running scenario that is stepped by the caller. Commands apply in the "
                         "next step. Options as for run().")
      .def(py::init<const Scenario&, const py::object&, const py::object&, const py::kwargs&>(),
           py::arg("scenario"), py::kw_only(), py::arg("planners") = py::none(),
           py::arg("behaviors") = py::none())
      .def("step", &Simulation::step, py::arg("count") = 1,
           "Simulates `count` steps. Raises RuntimeError if the simulation has failed, "
           "ScenarioError if a command was refused.")
      .def_property_readonly("state", &Simulation::state,
                             "Current state: structured array as Run.trajectory.")
      .def_property_readonly("time", &Simulation::time, "Simulated time [s].")
      .def_property_readonly("dt", &Simulation::dt, "Time step [s].")
      .def("take_events", &Simulation::takeEvents, "Events since the last call, as dicts.")
      .def(
          "drive", &Simulation::drive, py::arg("robot"), py::arg("v"), py::arg("omega"),
          py::arg("lateral") = 0.0,
          "Velocity command of a robot [m/s], [rad/s] for the next step, instead of its planner's.")
      .def("set_goal", &Simulation::setGoal, py::arg("robot"), py::arg("x"), py::arg("y"))
      .def("move", &Simulation::move, py::arg("name"), py::arg("x"), py::arg("y"),
           py::arg("heading"), "Places a person or robot at a pose.")
      .def("set_door", &Simulation::setDoor, py::arg("door"), py::arg("is_open"))
      .def("hold", &Simulation::hold, py::arg("person"), py::arg("is_held"),
           "Stops a person, or lets the person continue.");
}

}  // namespace python
