#include "app/python/ScenarioBinding.h"

#include <filesystem>
#include <pybind11/stl.h>
#include <utility>
#include <vector>

#include "app/python/Problems.h"
#include "app/python/RunOptions.h"
#include "app/run/DataPaths.h"
#include "editor/document/MapImageReader.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace python {

namespace {

std::string absolutePath(const std::string& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

/// The node at a dotted path below `ros__parameters` of one of the nodes; null: it is not written.
const base::YamlNode* nodeAt(const base::YamlNode& file, const std::string& path) {
  for (const char* const node : {"hunav_loader", "hunavsim_desktop"}) {
    const base::YamlNode* at = file.find(node);
    at = at != nullptr ? at->find("ros__parameters") : nullptr;
    for (const std::string& key : base::split(path, '.')) {
      at = at != nullptr ? at->find(key) : nullptr;
    }
    if (at != nullptr) {
      return at;
    }
  }
  return nullptr;
}

template <class Entity>
std::vector<std::string> namesOf(const std::vector<Entity>& entities) {
  std::vector<std::string> names;
  sim2d::forEachListed(entities, [&names](const Entity& each) { names.push_back(each.name); });
  return names;
}

py::dict goalsOf(const Scenario& scenario) {
  py::dict goals;
  for (const sim2d::GlobalGoal& goal : scenario.data().goals) {
    goals[py::int_(goal.id)] = py::make_tuple(goal.position.x(), goal.position.y());
  }
  return goals;
}

}  // namespace

Scenario::Scenario(sim2d::ScenarioReading reading, std::string path)
    : reading_(std::move(reading)),
      path_(std::move(path)),
      files_(std::make_shared<app::FileCache>(editor::loadMapImage)) {}

Scenario::Scenario(const std::string& fileOrName) : Scenario({}, app::scenarioFile(fileOrName)) {
  if (const auto unknown = app::unknownScenario(path_)) {
    throwProblems({*unknown});
  }
  reading_ = sim2d::readScenario(path_);
  requireNoErrors(reading_.diagnostics);
  path_ = absolutePath(path_);
}

Scenario Scenario::ofText(const std::string& text, const std::string& path) {
  Scenario scenario(sim2d::readScenarioText(text, path),
                    absolutePath(path.empty() ? "scenario.yaml" : path));
  requireNoErrors(scenario.reading_.diagnostics);
  return scenario;
}

app::Bundle Scenario::bundle(const py::kwargs& options) const {
  const app::RunSpec spec = runSpecOf(path_, options);
  const base::Result<app::RunSettings> settings = app::runSettingsOf(spec);
  if (!settings) {
    throwProblems(settings.diagnostics());
  }
  const py::gil_scoped_release released;
  return bundle(spec, *settings);
}

app::Bundle Scenario::bundle(app::RunSpec spec, const app::RunSettings& settings) const {
  spec.scenario = path_;
  files_->setScenario(path_, reading_);
  return app::readBundle(spec, settings, *files_);
}

std::string Scenario::text() const {
  return sim2d::writeScenario(reading_.scenario);
}

void Scenario::save(const std::string& path) {
  requireNoErrors(base::writeFilesAtomically({{path, text()}}));
  path_ = absolutePath(path);
}

void Scenario::set(const std::string& path, const py::object& value) {
  requireNoErrors(sim2d::setValue(reading_.scenario, path, yamlOf(value)));
}

py::object Scenario::get(const std::string& path, const py::object& fallback) const {
  base::Diagnostics problems;
  const base::YamlNode file = base::parseYaml(text(), {}, problems);
  requireNoErrors(problems);
  const base::YamlNode* const node = nodeAt(file, path);
  return node != nullptr ? valueOfYaml(*node) : fallback;
}

py::list Scenario::check(const py::kwargs& options) const {
  const app::Bundle bundle = this->bundle(options);
  app::Verdict verdict;
  {
    const py::gil_scoped_release released;
    verdict = app::check(bundle);
  }
  base::Diagnostics problems = verdict.wrongOptions;
  base::append(problems, verdict.problems);
  base::append(problems, verdict.worldRemarks);
  return toList(problems);
}

void addScenario(py::module_& module) {
  py::class_<Scenario>(module, "Scenario",
                       "A scenario: people, robots, goals, obstacles and settings.\n\n"
                       "Scenario(path) reads a file or a shipped scenario, by its name.")
      .def(py::init<const std::string&>(), py::arg("path"))
      .def_static(
          "from_text", &Scenario::ofText, py::arg("text"), py::arg("path") = "",
          "Reads a scenario from YAML text. Relative file names are resolved beside `path`.")
      .def_property_readonly("path", &Scenario::path, "Absolute path of the file.")
      .def_property_readonly("text", &Scenario::text, "The scenario as YAML, as it is saved.")
      .def("save", &Scenario::save, py::arg("path"),
           "Writes the file; relative file names are then resolved beside it.")
      .def("set", &Scenario::set, py::arg("path"), py::arg("value"),
           "Sets a value by its dotted path, as `hunavsim run --set`: set('robot1.max_vel', 0.8), "
           "set('*.behavior.type', 'Scared'). Raises ScenarioError for an unknown path or a wrong "
           "value.")
      .def("get", &Scenario::get, py::arg("path"), py::arg("default") = py::none(),
           "The value at a dotted path as the file has it; `default` if the file does not have it.")
      .def("check", &Scenario::check,
           "All problems of the scenario with these run options, as `hunavsim check` reports them.")
      .def("copy", [](const Scenario& scenario) { return Scenario(scenario); })
      .def_property_readonly(
          "people", [](const Scenario& s) { return namesOf(s.data().humans); },
          "Names of the listed people.")
      .def_property_readonly(
          "robots", [](const Scenario& s) { return namesOf(s.data().robots); },
          "Names of the listed robots.")
      .def_property_readonly("goals", goalsOf, "Positions (x, y) [m] of the goals by id.")
      .def("__repr__", [](const Scenario& s) { return "<Scenario '" + s.path() + "'>"; });
  module.def(
      "scenarios",
      [] {
        std::vector<std::string> names;
        for (const app::ShippedScenario& shipped : app::shippedScenarios()) {
          names.push_back(shipped.name);
        }
        return names;
      },
      "Names of the shipped scenarios.");
}

}  // namespace python
