#pragma once

#include <cstdint>
#include <mutex>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <vector>

#include "app/run/RunFolder.h"
#include "app/run/Session.h"

/// Runs as Python objects. With the interpreter lock unless stated otherwise.
namespace python {

namespace py = pybind11;

/// One body in one state, as an element of a structured array. World frame, SI, radians.
struct StateRow {
  std::int64_t step = 0;
  double time = 0.0;
  std::int32_t id = 0;  // people >= 0, robots -1, -2 …
  std::int32_t group = -1;
  std::int32_t goal = -1;  // id of the current global goal; -1: none
  bool isActive = false;   // during a reaction or social action
  double x = 0.0, y = 0.0, heading = 0.0, vx = 0.0, vy = 0.0, omega = 0.0;
};
/// Registers the type with numpy; call once, before the first array of it.
void registerStateRow();

/// Appends the bodies of a frame: people, then robots, as in trajectory.csv. Any thread.
void appendRows(std::vector<StateRow>& rows, const sim2d::Frame& frame);

/// The rows as an array that owns them, without a copy.
py::array arrayOf(std::vector<StateRow> rows);

/// Box2D has static variables, so only one world steps at a time, in any thread. Holds the lock of
/// all simulations of the process and has released the interpreter lock.
class SimulationLock {
 public:
  SimulationLock();

 private:
  py::gil_scoped_release released_;
  std::unique_lock<std::mutex> lock_;
};

/// Adds `run`, `load_run` and the classes `Run` and `Event` to the module.
void addRuns(py::module_& module);

}  // namespace python
