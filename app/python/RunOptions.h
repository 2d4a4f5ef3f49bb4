#pragma once

#include <pybind11/pybind11.h>
#include <string>
#include <vector>

#include "app/run/RunSpec.h"
#include "sim2d/base/yaml/YamlTree.h"

/// Keyword arguments of `run`, `Simulation` and `check`: the options of the command `run`.
namespace python {

namespace py = pybind11;

/// The run of this scenario with these keyword arguments: `stop_on_collision="any"` is
/// `--stop-on-collision any`, True is a flag, a list repeats the option, and `set` takes a dict of
/// paths and values. Throws TypeError for an unknown name and ScenarioError for a wrong value.
app::RunSpec runSpecOf(const std::string& scenario, const py::kwargs& options);

/// The Python value as YAML, as `--set` takes it: True, 1.5, [1, 2], 'text'.
std::string yamlOf(const py::handle& value);

/// The YAML scalar, list or map as a Python value.
py::object valueOfYaml(const base::YamlNode& node);

}  // namespace python
