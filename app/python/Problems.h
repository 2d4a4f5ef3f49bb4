#pragma once

#include <pybind11/pybind11.h>
#include <string>

#include "sim2d/base/Result.h"

/// Problems of scenarios and options as Python objects and exceptions. With the interpreter lock.
namespace python {

namespace py = pybind11;

/// Adds the classes `Problem` and `ScenarioError` to the module.
void addProblems(py::module_& module);

/// The problems as a list of `Problem`.
py::list toList(const base::Diagnostics& problems);

/// Throws `ScenarioError` with these problems if one of them is an error.
void requireNoErrors(const base::Diagnostics& problems);

/// Throws `ScenarioError` with these problems.
[[noreturn]] void throwProblems(const base::Diagnostics& problems);

}  // namespace python
