#include "app/python/RunBinding.h"

#include <chrono>
#include <cmath>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <utility>

#include "app/python/Callbacks.h"
#include "app/python/Problems.h"
#include "app/python/RunOptions.h"
#include "app/python/ScenarioBinding.h"
#include "metrics/Report.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace python {

namespace {

std::mutex simulationMutex;  // NOLINT

/// A finished or recorded run.
struct Run {
  app::RecordingPtr recording;
  sim2d::TraceHeader header;
  std::string status, reason;  // of its end; empty: read from a folder
  std::optional<metrics::Evaluation> evaluation;
  base::Diagnostics problems;  // warnings
};

py::object valueOf(const metrics::MetricResult& result) {
  if (!result.value.value) {
    return py::none();
  }
  const double value = *result.value.value;
  if (result.info.kind == metrics::Kind::Boolean) {
    return py::bool_(value != 0.0);
  }
  if (result.info.kind == metrics::Kind::Count && std::isfinite(value)) {
    return py::int_(static_cast<long long>(value));
  }
  return py::float_(value);
}

const metrics::Evaluation& evaluationOf(const Run& run) {
  if (!run.evaluation) {
    throw py::value_error("the run has no metrics: call evaluate()");
  }
  return *run.evaluation;
}

py::dict metricsOf(const Run& run) {
  py::dict values;
  for (const metrics::MetricResult& result : evaluationOf(run).results) {
    values[py::str(result.info.key)] = valueOf(result);
  }
  return values;
}

py::array_t<double> arrayOf(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::dict seriesOf(const Run& run) {
  py::dict series;
  series["time"] = arrayOf(evaluationOf(run).times);
  for (const metrics::MetricResult& result : evaluationOf(run).results) {
    if (result.value.series) {
      series[py::str(result.info.key)] = arrayOf(result.value.series->values);
    }
  }
  return series;
}

py::array trajectoryOf(const Run& run) {
  std::vector<StateRow> rows;
  {
    const py::gil_scoped_release released;
    for (std::size_t i = run.recording->first(); i < run.recording->size(); ++i) {
      appendRows(rows, *run.recording->frame(i));
    }
  }
  return arrayOf(std::move(rows));
}

py::list eventsOf(const Run& run) {
  py::list list;
  const auto& events = run.recording->events();
  for (std::size_t i = 0; i < events.size(); ++i) {
    const auto& [step, event] = events[i];
    py::dict entry;
    entry["time"] = static_cast<double>(step) * run.header.dt;
    entry["kind"] = sim2d::eventKindName(event.kind);
    entry["id"] = event.hasId ? py::object(py::int_(event.id)) : py::none();
    entry["other"] = event.hasOther ? py::object(py::int_(event.other)) : py::none();
    entry["text"] = event.text;
    list.append(entry);
  }
  return list;
}

py::dict namesOf(const Run& run) {
  py::dict names;
  for (const sim2d::TraceRobot& robot : run.header.robots) {
    names[py::int_(robot.id)] = robot.name;
  }
  for (const sim2d::TraceHuman& human : run.header.humans) {
    names[py::int_(human.id)] = human.name;
  }
  return names;
}

py::dict mapOf(const Run& run) {
  const sim2d::OccupancyGrid& map = run.header.map;
  py::dict result;
  if (map.isEmpty()) {
    return result;
  }
  result["cells"] = py::array_t<std::int8_t>({map.height(), map.width()}, map.cells().data());
  result["resolution"] = map.resolution();
  result["origin"] =
      py::make_tuple(map.origin().position.x(), map.origin().position.y(), map.origin().heading);
  return result;
}

/// Computes metrics of the run: all those of its scenario, or these keys.
void evaluate(Run& run, const std::vector<std::string>& keys, const std::string& profile) {
  app::MetricsSetup setup;
  base::Diagnostics problems = app::readMetricsSetup(run.header, setup);
  app::MetricsOptions options;
  options.metricsProfile = profile;
  for (const std::string& key : keys) {
    options.metrics += (options.metrics.empty() ? "" : ",") + key;
  }
  base::Diagnostics wrong;
  base::append(problems, app::applyMetricsOptions(options, setup, wrong));
  base::append(problems, wrong);
  requireNoErrors(problems);
  const base::Result<metrics::Evaluation> evaluation = [&] {
    const py::gil_scoped_release released;
    return metrics::evaluate(run.recording->trace(run.header), setup.selection, setup.parameters);
  }();
  if (!evaluation) {
    throwProblems(evaluation.diagnostics());
  }
  run.evaluation = *evaluation;
}

/// Calls `progress(time, end)` about ten times per second, and handles Ctrl-C. True: stop.
class ProgressCaller {
 public:
  ProgressCaller(py::object progress, double end) : progress_(std::move(progress)), end_(end) {}

  /// Without the interpreter lock.
  bool wantsStop(const sim2d::Frame& frame) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) {
      return false;
    }
    last_ = now;
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) {
      isInterrupted_ = true;
      return true;
    }
    if (progress_.is_none()) {
      return false;
    }
    try {
      const py::object answer = progress_(frame.time, end_);
      return !answer.is_none() && !answer.cast<bool>();
    } catch (...) {
      error_ = std::current_exception();
      return true;
    }
  }
  /// Throws what ended the run.
  void rethrow() const {
    if (error_) {
      std::rethrow_exception(error_);
    }
    if (isInterrupted_) {
      throw py::error_already_set();
    }
  }

 private:
  const py::object progress_;
  const double end_;  // [s]
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::exception_ptr error_;
  bool isInterrupted_ = false;
};

const char* statusName(sim2d::RunStatus status) {
  switch (status) {
    case sim2d::RunStatus::Finished:
      return "finished";
    case sim2d::RunStatus::Failed:
      return "failed";
    case sim2d::RunStatus::Interrupted:
      break;
  }
  return "interrupted";
}

/// The output folder of a run, if one is wanted. Throws ScenarioError.
std::unique_ptr<app::OutputFolder> openOutput(const py::object& output, const Scenario& scenario,
                                              const sim2d::World& world) {
  if (output.is_none()) {
    return nullptr;
  }
  if (sim2d::writeScenario(sim2d::readScenario(scenario.path()).scenario) != scenario.text()) {
    throw py::value_error("the scenario differs from its file: save it before a run with output");
  }
  base::Result<std::unique_ptr<app::OutputFolder>> folder =
      app::OutputFolder::open(py::str(output).cast<std::string>(), false);
  if (!folder) {
    throwProblems(folder.diagnostics());
  }
  requireNoErrors((*folder)->conflictingFiles(
      app::runFileNames(metrics::robotNames(world.header().robots), false)));
  return *std::move(folder);
}

/// The world of the bundle with its callables; problems go to the run.
std::unique_ptr<sim2d::World> makeWorld(const app::Bundle& bundle, const Callables& planners,
                                        const Callables& behaviors, app::Verdict& verdict) {
  {
    const py::gil_scoped_release released;
    verdict = app::check(bundle, app::CheckDepth::Setup);
  }
  requireNoErrors(verdict.wrongOptions);
  requireNoErrors(verdict.problems);
  useCallables(*verdict.setup, planners, behaviors);
  base::Result<std::unique_ptr<sim2d::World>> world = [&] {
    const SimulationLock lock;
    return sim2d::World::create(*std::move(verdict.setup));
  }();
  if (!world) {
    throwProblems(world.diagnostics());
  }
  base::append(verdict.problems, world.diagnostics());
  return *std::move(world);
}

Run runScenario(const Scenario& scenario, const py::object& output, const py::object& progress,
                const py::object& planners, const py::object& behaviors,
                const py::kwargs& options) {
  const app::Bundle bundle = scenario.bundle(options);
  const Callables robots = callablesOf(planners, "command");
  const Callables people = callablesOf(behaviors, "decide");
  app::Verdict verdict;
  const std::unique_ptr<sim2d::World> world = makeWorld(bundle, robots, people, verdict);
  const std::unique_ptr<app::OutputFolder> folder = openOutput(output, scenario, *world);
  app::Session session(sim2d::stopRuleOf(*bundle.scenario));
  session.enableHistory(bundle.scenario->desktop.recordEvery.value_or(1));
  app::RunWriter writer(folder ? folder->staging() : std::string(), *world, world->header(),
                        verdict.metrics.selection, verdict.metrics.parameters);
  ProgressCaller caller(progress, static_cast<double>(session.rule().maximumSteps) * world->dt());
  const app::FinishedRun finished = [&] {
    const SimulationLock lock;
    return app::simulate(
        session, *world, verdict.scenarioMetrics, writer,
        [&caller](const sim2d::Frame& frame) { return hasPending() || caller.wantsStop(frame); },
        app::PlanningClock::Off);
  }();
  rethrowPending();
  caller.rethrow();
  Run run{session.history(),
          finished.header,
          statusName(finished.result.status),
          finished.result.reason,
          {},
          verdict.problems};
  if (finished.evaluation) {
    run.evaluation = *finished.evaluation;
  }
  base::append(run.problems, finished.evaluation.diagnostics());
  if (folder != nullptr) {
    std::vector<std::string> words = app::commandLineOf(runSpecOf(scenario.path(), options));
    requireNoErrors(app::writeRunFolder(*folder, finished, writer, bundle, words));
  }
  return run;
}

Run loadRun(const std::string& folder) {
  base::Result<std::shared_ptr<const sim2d::Recording>> recording = [&] {
    const py::gil_scoped_release released;
    return sim2d::readRecording(folder);
  }();
  if (!recording) {
    throwProblems(recording.diagnostics());
  }
  return {*recording, *(*recording)->header(), {}, {}, {}, recording.diagnostics()};
}

}  // namespace

SimulationLock::SimulationLock() : lock_(simulationMutex) {}

void registerStateRow() {
  PYBIND11_NUMPY_DTYPE_EX(StateRow, step, "step", time, "time", id, "id", group, "group", goal,
                          "goal", isActive, "active", x, "x", y, "y", heading, "heading", vx, "vx",
                          vy, "vy", omega, "omega");
}

void appendRows(std::vector<StateRow>& rows, const sim2d::Frame& frame) {
  const auto append = [&](const sim2d::BodyColumns& bodies, std::size_t i) {
    StateRow row;
    row.step = frame.step;
    row.time = frame.time;
    row.id = bodies.id[i];
    row.goal = bodies.goal[i];
    row.x = bodies.x[i];
    row.y = bodies.y[i];
    row.heading = bodies.heading[i];
    row.vx = bodies.vx[i];
    row.vy = bodies.vy[i];
    row.omega = bodies.omega[i];
    rows.push_back(row);
  };
  for (std::size_t i = 0; i < frame.humans.size(); ++i) {
    append(frame.humans, i);
    rows.back().group = frame.humans.group[i];
    rows.back().isActive = frame.humans.state[i] != 0;
  }
  for (std::size_t i = 0; i < frame.robots.size(); ++i) {
    append(frame.robots, i);
  }
}

py::array arrayOf(std::vector<StateRow> rows) {
  auto* const owned = new std::vector<StateRow>(std::move(rows));  // NOLINT: freed by the capsule
  const py::capsule owner(owned,
                          [](void* data) { delete static_cast<std::vector<StateRow>*>(data); });
  return py::array_t<StateRow>(static_cast<py::ssize_t>(owned->size()), owned->data(), owner);
}

void addRuns(py::module_& module) {
  registerStateRow();
  py::class_<Run>(module, "Run", "A finished or recorded run.")
      .def_property_readonly("trajectory", trajectoryOf,
                             "All states as a structured array: step, time [s], id (robots -1, -2 "
                             "…), group, goal, active, x, y [m], heading [rad], vx, vy [m/s], "
                             "omega [rad/s].")
      .def_property_readonly("events", eventsOf,
                             "Events in order, as dicts: time, kind, id, other, text.")
      .def_property_readonly("names", namesOf, "Names of robots and people by id.")
      .def_property_readonly("metrics", metricsOf, "Values by key; None: undefined.")
      .def_property_readonly("series", seriesOf,
                             "Values per sample by key, as arrays, with `time` [s].")
      .def_property_readonly("map", mapOf,
                             "The map: cells (rows from the lower left), resolution [m], origin.")
      .def_property_readonly(
          "dt", [](const Run& run) { return run.header.dt; }, "Time step [s].")
      .def_property_readonly("seed", [](const Run& run) { return run.header.seed; })
      .def_readonly("status", &Run::status, "'finished', 'failed' or 'interrupted'.")
      .def_readonly("reason", &Run::reason, "Why it ended, such as 'arrived' or 'duration'.")
      .def_property_readonly(
          "problems", [](const Run& run) { return toList(run.problems); }, "Warnings.")
      .def("evaluate", evaluate, py::arg("metrics") = std::vector<std::string>(),
           py::arg("profile") = "corrected",
           "Computes metrics of the recording: all, or these keys; profile 'corrected' or "
           "'hunav2'.");
  module.def(
      "run", runScenario, py::arg("scenario"), py::kw_only(), py::arg("output") = py::none(),
      py::arg("progress") = py::none(), py::arg("planners") = py::none(),
      py::arg("behaviors") = py::none(),
      "Simulates a scenario and returns the Run. Keyword arguments are the options of "
      "`hunavsim run` with underscores: seed=3, planner='dwa', duration=60.0, "
      "set={'robot1.max_vel': 0.8} …\n\n"
      "output: folder for the files of the run. progress: called as progress(time, end) [s]; "
      "returning False ends the run. planners: planners in Python by name of the robot, "
      "called with an Observation, returning (v, omega) or (vx, vy, omega). behaviors: "
      "behaviours in Python by name of the person, called with a PersonView, returning "
      "None, ('stand',), ('turn', heading) or ('walk', (x, y), speed).");
  module.def("load_run", loadRun, py::arg("folder"), "Reads the folder of a run.");
}

}  // namespace python
