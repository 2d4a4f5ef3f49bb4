#pragma once

#include <memory>
#include <pybind11/pybind11.h>
#include <string>

#include "app/run/Bundle.h"

/// The Python class `Scenario`. With the interpreter lock unless stated otherwise.
namespace python {

namespace py = pybind11;

/// A scenario in memory and the files that it uses.
class Scenario {
 public:
  /// Reads a file, or the shipped scenario of this name. Throws ScenarioError.
  explicit Scenario(const std::string& fileOrName);
  /// Reads a text; relative files are looked for beside `path`, which need not exist.
  static Scenario ofText(const std::string& text, const std::string& path);

  /// The run of this scenario with these options. Reads the map and the trees on first use.
  app::Bundle bundle(const py::kwargs& options) const;
  /// The same with given options. Does not need the interpreter lock.
  app::Bundle bundle(app::RunSpec spec, const app::RunSettings& settings) const;

  const sim2d::Scenario& data() const { return reading_.scenario; }
  const std::string& path() const { return path_; }
  std::string text() const;
  void save(const std::string& path);
  void set(const std::string& path, const py::object& value);
  py::object get(const std::string& path, const py::object& fallback) const;
  py::list check(const py::kwargs& options) const;

 private:
  Scenario(sim2d::ScenarioReading reading, std::string path);

  sim2d::ScenarioReading reading_;
  std::string path_;
  std::shared_ptr<app::FileCache> files_;  // shared by copies
};

void addScenario(py::module_& module);

}  // namespace python
