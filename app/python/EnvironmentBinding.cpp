#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <stdexcept>

#include "app/python/Bindings.h"
#include "app/python/CrowdEnvironment.h"
#include "app/python/Problems.h"
#include "app/python/RunBinding.h"
#include "app/python/ScenarioBinding.h"

namespace python {

namespace {

using Shape = std::vector<py::ssize_t>;

py::ssize_t size(std::size_t count) {
  return static_cast<py::ssize_t>(count);
}

/// A view of the values that the environment overwrites in each step.
py::array viewOf(const std::vector<float>& values, const Shape& shape, const py::object& owner) {
  return py::array_t<float>(shape, values.data(), owner);
}

py::dict observationsOf(const py::object& self) {
  const auto& environment = self.cast<const CrowdEnvironment&>();
  const EnvironmentOptions& options = environment.options();
  const Observations& all = environment.observations();
  const py::ssize_t rows = size(environment.count() * environment.robots());
  py::dict result;
  result["state"] = viewOf(all.state, {rows, size(kStateColumns)}, self);
  if (options.people > 0) {
    result["people"] = viewOf(all.people, {rows, size(options.people), size(kPersonColumns)}, self);
  }
  if (options.beams > 0) {
    result["lidar"] = viewOf(all.lidar, {rows, options.beams}, self);
  }
  if (options.gridCells > 0) {
    result["grid"] =
        viewOf(all.grid, {rows, size(options.gridCells), size(options.gridCells)}, self);
  }
  return result;
}

void step(CrowdEnvironment& environment,
          const py::array_t<float, py::array::c_style | py::array::forcecast>& actions) {
  const py::ssize_t rows = size(environment.count() * environment.robots());
  if (actions.ndim() != 2 || actions.shape(0) != rows ||
      (actions.shape(1) != 2 && actions.shape(1) != 3)) {
    throw py::value_error("actions must have the shape (" + std::to_string(rows) + ", 2 or 3)");
  }
  const float* const values = actions.data();
  const auto columns = static_cast<std::size_t>(actions.shape(1));
  const SimulationLock lock;
  environment.step(values, columns);
}

double& weightOf(RewardWeights& weights, const std::string& name) {
  static const std::pair<const char*, double RewardWeights::*> kWeights[] = {
      {"arrival", &RewardWeights::arrival},   {"collision", &RewardWeights::collision},
      {"progress", &RewardWeights::progress}, {"closeness", &RewardWeights::closeness},
      {"time", &RewardWeights::time},         {"jerk", &RewardWeights::jerk}};
  for (const auto& [key, member] : kWeights) {
    if (name == key) {
      return weights.*member;
    }
  }
  throw py::value_error("unknown reward term '" + name + "'");
}

std::unique_ptr<CrowdEnvironment> makeEnvironment(
    const Scenario& scenario, std::size_t count, const std::vector<std::string>& robots,
    std::size_t people, int beams, std::size_t gridCells, double gridResolution, double duration,
    int repeat, const py::dict& weights, const py::kwargs& options) {
  if (count < 1 || beams < 0 || repeat < 1 || !(duration > 0.0) || !(gridResolution > 0.0)) {
    throw py::value_error("count, repeat, duration and grid_resolution must be positive");
  }
  EnvironmentOptions all;
  all.count = count;
  all.robots = robots;
  all.people = people;
  all.beams = beams;
  all.gridCells = gridCells;
  all.gridResolution = gridResolution;
  all.duration = duration;
  all.repeat = repeat;
  for (const auto& [name, weight] : weights) {
    weightOf(all.weights, name.cast<std::string>()) = weight.cast<double>();
  }
  app::Bundle bundle = scenario.bundle(options);
  std::unique_ptr<CrowdEnvironment> environment;
  {
    const SimulationLock lock;
    environment = std::make_unique<CrowdEnvironment>(std::move(bundle), std::move(all));
  }
  requireNoErrors(environment->problems());
  return environment;
}

py::tuple limitsOf(const CrowdEnvironment& environment, std::size_t robot) {
  const sim2d::RobotBody& body = environment.body(robot);
  return py::make_tuple(body.limits.maxVel, body.limits.maxReverse, body.limits.maxOmega,
                        body.kinematics == sim2d::Kinematics::Omnidirectional);
}

py::dict policyOptionsOf(const CrowdEnvironment& environment) {
  const EnvironmentOptions& options = environment.options();
  py::dict result;
  result["people"] = options.people;
  result["beams"] = options.beams;
  result["grid_cells"] = options.gridCells;
  result["grid_resolution"] = options.gridResolution;
  result["repeat"] = options.repeat;
  result["dt"] = environment.dt();
  return result;
}

}  // namespace

void addEnvironment(py::module_& module) {
  py::class_<CrowdEnvironment>(
      module, "CrowdEnvironment",
      "Copies of a scenario for reinforcement learning; the classes of hunavsim.env build on "
      "it.\n\n"
      "Arrays of observations are overwritten by each call of reset() and step().")
      .def(py::init(&makeEnvironment), py::arg("scenario"), py::kw_only(), py::arg("count") = 1,
           py::arg("robots") = std::vector<std::string>(), py::arg("people") = 16,
           py::arg("beams") = 180, py::arg("grid_cells") = 0, py::arg("grid_resolution") = 0.1,
           py::arg("duration") = 60.0, py::arg("repeat") = 1, py::arg("weights") = py::dict())
      .def(
          "reset",
          [](CrowdEnvironment& environment, std::uint64_t seed) {
            const SimulationLock lock;
            environment.reset(seed);
          },
          py::arg("seed") = 1)
      .def("step", &step, py::arg("actions"),
           "actions: array (rows, 2 or 3) of v [m/s], omega [rad/s] and lateral v [m/s].")
      .def_property_readonly("observations", observationsOf)
      .def_property_readonly("rewards",
                             [](const CrowdEnvironment& environment) {
                               return py::array_t<double>(size(environment.rewards().size()),
                                                          environment.rewards().data());
                             })
      .def_property_readonly(
          "ends",
          [](const CrowdEnvironment& environment) {
            return py::array_t<std::uint8_t>(
                size(environment.ends().size()),
                reinterpret_cast<const std::uint8_t*>(environment.ends().data()));
          },
          "Per row: 0 continues, 1 arrived, 2 collided, 3 out of time.")
      .def_property_readonly(
          "episodes",
          [](const CrowdEnvironment& environment) {
            return py::array_t<std::int64_t>(size(environment.episodes().size()),
                                             environment.episodes().data());
          },
          "Number of the current episode of each copy, from 0.")
      .def_property_readonly("count", &CrowdEnvironment::count)
      .def_property_readonly(
          "robots",
          [](const CrowdEnvironment& environment) { return environment.options().robots; })
      .def_property_readonly("dt", &CrowdEnvironment::dt, "Time step [s].")
      .def_property_readonly("options", &policyOptionsOf,
                             "Options that a trained policy depends on: people, beams, grid_cells, "
                             "grid_resolution [m], repeat and dt [s].")
      .def("limits", &limitsOf, py::arg("robot") = 0,
           "(max v, max reverse v [m/s], max omega [rad/s], is omnidirectional) of a robot.");
}

}  // namespace python
