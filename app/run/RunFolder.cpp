#include "app/run/RunFolder.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <type_traits>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "app/run/DataPaths.h"
#include "app/run/ManifestFiles.h"
#include "app/run/PlannerFiles.h"
#include "bt/tree/TreeXml.h"
#include "metrics/Report.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/SystemError.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/onnx/PolicyNetwork.h"
#include "sim2d/scenario/Fields.h"
#include "sim2d/trace/Trace.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kStatusNames[] = {"finished", "failed", "interrupted"};  // of RunStatus

Json programJson() {
  return {{"version", programVersion()}, {"commit", programCommit()}};
}

Json humanJson(const sim2d::TraceHuman& human) {
  Json json = {{"id", human.id}, {"name", human.name}, {"model", human.model}};
  for (const auto& [key, value] : human.parameters) {
    json[key] = value;
  }
  return json;
}

/// The values in effect, by the keys of the scenario file.
template <class T>
Json valuesInEffect(const sim2d::ResolvedRobot& robot) {
  Json json = Json::object();
  for (const sim2d::Field<T>& field : sim2d::fieldsOf<T>()) {
    std::visit(
        [&](const auto& value) {
          using Value = std::decay_t<decltype(value)>;
          if constexpr (!std::is_same_v<Value, std::monostate>) {
            json[field.spec.key] = value;
          }
        },
        field.resolved(robot, field.spec));
  }
  return json;
}

/// The sensors: without a lidar only its beam count, with ground truth only its kind.
void addSensors(Json& json, const sim2d::ResolvedRobot& robot) {
  json["lidar"] = valuesInEffect<sim2d::LidarSettings>(robot);
  if (robot.lidar.beams == 0) {
    json["lidar"] = Json::object();
    json["lidar"]["beams"] = 0;
  }
  json["detector"] = valuesInEffect<sim2d::DetectorSettings>(robot);
  if (robot.detectorKind == sim2d::DetectorKind::GroundTruth) {
    json["detector"] = Json::object();
    json["detector"]["kind"] = "ground_truth";
  }
  json["odometry_noise"] = valuesInEffect<sim2d::OdometrySettings>(robot);
  json["localization"] = valuesInEffect<sim2d::LocalizationSettings>(robot);
}

/// The string and number members by name.
Json robotJson(const sim2d::TraceRobot& robot) {
  Json json;
  sim2d::forEachMember(robot, [&json](const char* name, const auto& member) {
    using Member = std::decay_t<decltype(member)>;
    if constexpr (std::is_arithmetic_v<Member> || std::is_same_v<Member, std::string>) {
      json[name] = member;
    }
  });
  if (robot.planner == sim2d::kOnnxPlanner) {
    const base::Result<std::string> runtime = sim2d::policyModuleVersion();
    json["onnx_runtime"] = runtime ? Json(*runtime) : Json();
  }
  return json;
}

/// Whether external programs and libraries may start, and which ones do.
Json codeJson(const Bundle& bundle, base::Diagnostics& warnings) {
  Json started = Json::array();
  for (const ExternalCode& code : externalCodeOf(*bundle.scenario)) {
    started.push_back({{"robot", code.robot},
                       {code.key, code.words},
                       {"files", inputHashes<Json>(filesOf(code, bundle.path), warnings)}});
  }
  return {{"allowed", bundle.settings.code == sim2d::ExternalCodePolicy::Allowed},
          {"started", started}};
}

Json goalEndJson(const sim2d::GoalResult& end) {
  const sim2d::NavigationResult& result = end.result;
  Json json = {{"goal", end.goal > 0 ? Json(end.goal) : Json()},
               {"result", result.hasSucceeded ? "succeeded" : "failed"},
               {"reached", end.isReached},
               {"time", end.time},
               {"distance_left", end.distance}};
  if (end.isExternal) {
    json["order"] = true;
  }
  if (!result.hasSucceeded) {
    json["reason"] = result.reason;
    json["error_code"] = result.errorCode != 0 ? Json(result.errorCode) : Json();
    json["error_message"] = result.message;
  }
  return json;
}

/// Adds the result of a robot; for planners that end goals themselves, also their report per goal.
void addRobotResult(const sim2d::RunResult& run, int robot, Json& to) {
  const sim2d::RobotResult* const result = base::findBy(run.robots, &sim2d::RobotResult::id, robot);
  if (result == nullptr) {
    return;
  }
  to["result"] = result->result ? Json(sim2d::navigationOutcomeName(*result->result)) : Json();
  to["time"] = result->result ? Json(result->time) : Json();
  if (result->decidesGoalEnd) {
    to["navigation"] = Json::array();
    for (const sim2d::GoalResult& end : result->goalResults) {
      to["navigation"].push_back(goalEndJson(end));
    }
  }
}

/// The manifest: inputs, settings and result.
std::string runManifest(const Bundle& bundle, const FinishedRun& run,
                        const std::vector<std::string>& commandLine, base::Diagnostics& warnings) {
  const sim2d::TraceHeader& header = run.header;
  const sim2d::RunResult& result = run.result;
  const double simulated = static_cast<double>(result.steps) * header.dt;
  const sim2d::DesktopSettings& desktop = bundle.scenario->desktop;
  Json json;
  json["program"] = programJson();
  json["command_line"] = commandLine;
  json["status"] = kStatusNames[static_cast<int>(result.status)];
  json["reason"] = result.reason;
  json["inputs"] = inputHashes<Json>(inputsOf(bundle), warnings);
  if (run.origin) {
    json["from"] = {{"run", run.origin->folder},
                    {"time", run.origin->time},
                    {"step", run.origin->step},
                    {"seed", run.origin->seed}};
  }
  json["code"] = codeJson(bundle, warnings);
  json["seed"] = header.seed;
  json["dt"] = header.dt;
  json["model"] = desktop.model.value_or("sfm");
  json["compat"] = bundle.settings.compatibility.names();
  json["record_every"] = header.recordEvery;
  json["steps"] = result.steps;
  json["simulated_seconds"] = simulated;
  json["wall_seconds"] = result.stepSeconds;
  json["real_time_factor"] =
      result.stepSeconds > 0.0 ? Json(simulated / result.stepSeconds) : Json();
  for (const metrics::MetricResult& time : run.planning.results()) {
    json[time.info.key] = time.value.value ? Json(*time.value.value) : Json();
  }
  json["humans"] = Json::array();
  for (const sim2d::TraceHuman& human : header.humans) {
    json["humans"].push_back(humanJson(human));
  }
  json["robots"] = Json::array();
  for (const sim2d::TraceRobot& robot : header.robots) {
    json["robots"].push_back(robotJson(robot));
    addRobotResult(result, robot.id, json["robots"].back());
  }
  int id = -1;
  sim2d::forEachListed(bundle.scenario->robots, [&](const sim2d::Robot& robot) {
    addSensors(json["robots"].at(static_cast<std::size_t>(-1 - id)),
               sim2d::resolveRobot(*bundle.scenario, robot, id));
    --id;
  });
  for (std::size_t robot = 0; robot < run.plannerReports.size(); ++robot) {
    const std::string& report = run.plannerReports[robot];
    if (!report.empty() && robot < json["robots"].size()) {
      json["robots"][robot]["nav2"] = Json::parse(report);
    }
  }
  return base::jsonText(json) + "\n";
}

/// `metrics_robot2.csv`, `steps_robot2.csv`.
bool isFileOfOtherRobot(const std::string& name) {
  const bool isTable = base::startsWith(name, "metrics_") || base::startsWith(name, "steps_");
  return isTable && fs::path(name).extension() == ".csv";
}

/// The files of the recording first, those of RunWriter::File in its order.
constexpr const char* kRunFiles[] = {"trajectory.csv", "events.csv",        "trees.csv",
                                     "inputs.csv",     "scans.csv",         "trace.json",
                                     "metrics.json",   "metrics.csv",       "steps.csv",
                                     "manifest.json",  "counterfactual.csv"};
constexpr std::size_t kRecordingFiles = 6;

/// Whether an entry is a file of a run or a temporary file for one.
bool isRunFile(const fs::directory_entry& entry, bool ofEarlierBatch = true) {
  std::error_code error;
  const fs::file_status status = entry.symlink_status(error);
  const std::string full = entry.path().filename().string();
  if (isInternalEntry(full)) {
    return fs::is_directory(status) || fs::is_regular_file(status);
  }
  const std::optional<std::string> target = targetOfTemporary(full);
  const std::string name = target.value_or(full);  // final name
  const bool isKnown =
      isFileOfOtherRobot(name) ||
      std::find(std::begin(kRunFiles), std::end(kRunFiles), name) != std::end(kRunFiles);
  return fs::is_regular_file(status) && isKnown && (ofEarlierBatch || target);
}

}  // namespace

std::vector<std::string> inputsOf(const Bundle& bundle) {
  std::vector<std::string> inputs;
  std::set<fs::path> seen;
  const auto add = [&](const std::string& path) {
    std::error_code ignored;  // a missing file keeps the given name
    const fs::path real = fs::weakly_canonical(path, ignored);
    if (seen.insert(real.empty() ? fs::path(path) : real).second) {
      inputs.push_back(path);
    }
  };
  for (const std::string& path : bundle.inputs) {
    add(path);
  }
  for (const auto& [person, tree] : bundle.trees) {
    const base::Result<bt::TreeTable> trees =
        tree.path.empty() ? base::Result<bt::TreeTable>(bt::TreeTable()) : bt::loadTrees(tree.path);
    if (!trees) {
      continue;  // reported when the run was loaded
    }
    for (const auto& [id, entry] : trees->entries) {
      add(fs::path(entry.file).lexically_normal().string());
    }
  }
  return inputs;
}

std::optional<std::string> foreignEntryIn(const std::string& runFolder, bool ofEarlierBatch) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(runFolder, error);
  if (!fs::exists(status)) {
    return std::nullopt;
  }
  if (!fs::is_directory(status)) {
    return runFolder;
  }
  for (fs::directory_iterator at(runFolder, error), end; !error && at != end; at.increment(error)) {
    if (!isRunFile(*at, ofEarlierBatch)) {
      return at->path().string();
    }
  }
  return error ? std::optional(runFolder) : std::nullopt;  // unreadable content counts as foreign
}

base::Diagnostics removeRunFolder(const std::string& runFolder) {
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(runFolder, error))) {
    return {};
  }
  error.clear();
  std::vector<std::string> names;
  for (fs::directory_iterator at(runFolder, error), end; !error && at != end; at.increment(error)) {
    if (isRunFile(*at)) {
      names.push_back(at->path().filename().string());
    }
  }
  if (error) {
    return {base::error("file.cannot-read", {base::systemErrorMessage(error)}, runFolder)};
  }
  // without trace.json no reader accepts the rest as a run
  std::stable_partition(names.begin(), names.end(),
                        [](const std::string& name) { return name == "trace.json"; });
  for (const std::string& name : names) {
    fs::remove_all(pathIn(runFolder, name), error);
    if (error) {
      return {base::error("file.cannot-remove", {base::systemErrorMessage(error)},
                          pathIn(runFolder, name))};
    }
  }
  fs::remove(runFolder, error);  // only if empty
  return {};
}

void RunWriter::begin(File file) {
  const std::string heads[] = {
      sim2d::headerLine(sim2d::kTrajectoryColumns), sim2d::headerLine(sim2d::kEventColumns),
      sim2d::headerLine(sim2d::kTreeColumns), sim2d::inputsHeader(), sim2d::scansHeader()};
  files_[file].emplace(pathIn(folder_, kRunFiles[file])).append(heads[file]);
}

RunWriter::RunWriter(const std::string& folder, const sim2d::World& world,
                     const sim2d::TraceHeader& header, const metrics::Selection& selection,
                     const metrics::MetricParameters& parameters,
                     const std::shared_ptr<metrics::ShortestPathCache>& known)
    : world_(world),
      dt_(world.dt()),
      folder_(folder),
      evaluation_(header, selection, parameters, {known, &world.obstacles()}),
      known_(header) {
  recordEvery_ = header.recordEvery;
  if (!folder_.empty()) {
    for (const File file : {Trajectory, Events, Trees}) {
      begin(file);
    }
    // Allows a killed run to be displayed; finish() reports write errors.
    base::writeFileAtomically(pathIn(folder_, "trace.json"), sim2d::traceJson(header));
  }
}

void RunWriter::write(const sim2d::Frame& frame, bool isRecorded) {
  std::array<std::string, FileCount> rows;
  if (isRecorded) {
    sim2d::appendTrajectoryRows(rows[Trajectory], frame);
  }
  for (const sim2d::Event& event : frame.events) {
    sim2d::appendEventRow(rows[Events], frame.step, dt_, event);
  }
  sim2d::appendTreeRows(rows[Trees], frame.step, frame.treeChanges);
  for (const sim2d::Input& input : frame.inputs) {
    sim2d::appendInputRow(rows[Inputs], frame.step, input);
  }
  for (const sim2d::RecordedScan& scan : frame.scans) {
    sim2d::appendScanRow(rows[Scans], scan);
  }
  for (const File file : {Trajectory, Events, Trees, Inputs, Scans}) {
    if (!rows[file].empty() && !files_[file]) {
      begin(file);
    }
    if (!rows[file].empty()) {
      files_[file]->append(rows[file]);
    }
  }
}

void RunWriter::append(const sim2d::Frame& frame) {
  const bool isRecorded = frame.step % recordEvery_ == 0;
  for (const sim2d::Event& event : frame.events) {
    evaluation_.note(static_cast<double>(frame.step) * dt_, event);
  }
  if (isRecorded) {
    if (known_.addNew(frame)) {  // spawned by a source
      evaluation_.addHumans(world_.header().humans);
    }
    evaluation_.append(frame);
  }
  if (files_[Trajectory]) {
    write(frame, isRecorded);
  }
  if (additionalWriter_ != nullptr) {
    additionalWriter_->append(frame);
  }
}

base::Result<metrics::Evaluation> RunWriter::evaluation() {
  return evaluation_.finish([this](const std::string& robot, const metrics::MetricInfo& info,
                                   const metrics::Series& series) {
    Column& column = columns_.emplace_back();
    column.robot = robot;
    column.key = info.key;
    column.kind = series.kind;
    for (const double value : series.values) {
      column.values.add(value, &store_);
    }
  });
}

base::Diagnostics RunWriter::writeSteps(const std::string& path,
                                        const metrics::Evaluation& ofRobot) {
  const std::vector<double>& times = ofRobot.times;
  std::vector<metrics::StepColumn> columns;
  for (const Column& column : columns_) {
    if (column.robot == ofRobot.robot && column.values.size() == times.size()) {
      columns.push_back({column.key, column.kind,
                         [reader = metrics::StoredSeriesReader(column.values)]() mutable {
                           return reader.next();
                         }});
    }
  }
  base::AtomicFileWriter file(path);
  metrics::writeSteps(times, columns, [&file](std::string_view rows) { file.append(rows); });
  if (store_.hasFailed()) {
    return {base::error("metrics.series-lost", {}, path)};
  }
  return file.finish();
}

bool RunWriter::hasFailed() const {
  return (additionalWriter_ != nullptr && additionalWriter_->hasFailed()) ||
         std::any_of(files_.begin(), files_.end(),
                     [](const auto& file) { return file && file->hasFailed(); });
}

base::Diagnostics RunWriter::finish() {
  base::Diagnostics problems;
  for (std::optional<base::AtomicFileWriter>& file : files_) {
    base::append(problems, file ? file->finish() : base::Diagnostics());
    file.reset();
  }
  return problems;
}

std::vector<std::string> runFileNames(const std::vector<std::string>& robots, bool totalsOnly) {
  if (totalsOnly) {
    return {"metrics.json", "counterfactual.csv"};
  }
  std::vector<std::string> names(std::begin(kRunFiles), std::end(kRunFiles));
  for (std::size_t k = 1; k < robots.size(); ++k) {
    names.push_back(metrics::robotFile("metrics", robots[k]));
    names.push_back(metrics::robotFile("steps", robots[k]));
  }
  return names;
}

base::Diagnostics writeRunFolder(OutputFolder& output, const FinishedRun& run, RunWriter& writer,
                                 const Bundle& bundle,
                                 const std::vector<std::string>& commandLine) {
  base::Diagnostics problems = output.withFinalPaths(writer.finish());
  const auto write = [&](const std::string& name, const std::string& content) {
    base::append(problems, output.write(name, content));
  };
  const auto writeTables = [&](const metrics::Evaluation& evaluation, const std::string& table,
                               const std::string& steps) {
    write(table, metrics::metricsCsv(evaluation));
    const std::string place = pathIn(output.staging(), steps);
    base::append(problems, output.withFinalPaths(writer.writeSteps(place, evaluation)));
  };
  if (run.evaluation) {
    write("metrics.json", metrics::toJson(*run.evaluation));
  }
  if (run.evaluation && !run.totalsOnly) {
    writeTables(*run.evaluation, "metrics.csv", "steps.csv");
    for (const metrics::Evaluation& other : run.evaluation->others) {
      writeTables(other, metrics::robotFile("metrics", other.robot),
                  metrics::robotFile("steps", other.robot));
    }
  }
  if (!run.effectsCsv.empty()) {
    write("counterfactual.csv", run.effectsCsv);
  }
  if (writer.additionalWriter() != nullptr) {
    base::append(problems, output.withFinalPaths(writer.additionalWriter()->finish(output)));
  }
  if (!run.totalsOnly) {
    write("trace.json", sim2d::traceJson(run.header));
  }
  if (!base::hasErrors(problems)) {
    const std::string manifest = runManifest(bundle, run, commandLine, problems);
    base::append(problems, output.commit(manifest, OutputFolder::EarlierFiles::Removed));
  }
  return problems;
}

base::Diagnostics checkRunFiles(const std::string& runFolder) {
  const std::vector<std::string> names(kRunFiles, kRunFiles + kRecordingFiles);
  return checkManifestFiles(runFolder, names);
}

base::Result<sim2d::Trace> readRun(const std::string& runFolder) {
  base::Diagnostics problems = completeCommit(runFolder);
  std::error_code ignored;  // the reader reports missing files
  if (fs::exists(pathIn(runFolder, "trajectory.csv"), ignored) &&
      !fs::exists(pathIn(runFolder, "trace.json"), ignored)) {
    problems.push_back(base::error("trace.unfinished", {}, runFolder));
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  base::Result<sim2d::Trace> trace = sim2d::readTrace(runFolder);
  problems = trace ? checkRunFiles(runFolder) : base::Diagnostics();
  return problems.empty() ? std::move(trace) : problems;
}

}  // namespace app
