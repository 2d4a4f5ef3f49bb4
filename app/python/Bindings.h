#pragma once

#include <pybind11/pybind11.h>

/// Each adds a part of the module.
namespace python {

namespace py = pybind11;

void addSimulation(py::module_& module);
void addStatistics(py::module_& module);
void addEnvironment(py::module_& module);

}  // namespace python
