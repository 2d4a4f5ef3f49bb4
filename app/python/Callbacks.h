#pragma once

#include <map>
#include <memory>
#include <pybind11/pybind11.h>
#include <string>

#include "sim2d/world/World.h"

/// Robot planners and behaviours of people that are Python objects.
namespace python {

namespace py = pybind11;

/// Python callables by the name of a robot or person. Destroy with the interpreter lock.
using Callables = std::map<std::string, py::object>;

/// The callables of a dict; None: none. For an object with a method `command` (planner) or `decide`
/// (behaviour), that method is used. Throws TypeError for anything else.
Callables callablesOf(const py::object& dict, const char* method);

/// Replaces planners and behaviours of the setup by the callables. They are called while the world
/// steps and take the interpreter lock for that time. Throws ValueError for a name that the
/// scenario does not have.
void useCallables(sim2d::WorldSetup& setup, const Callables& planners, const Callables& behaviors);

/// Adds the classes `Observation` and `PersonView` to the module.
void addCallbacks(py::module_& module);

/// Whether a callable has thrown since the last rethrowPending(). Any thread.
bool hasPending();
/// The Python exception that ended a run or step, if any: it is thrown and forgotten.
void rethrowPending();

}  // namespace python
