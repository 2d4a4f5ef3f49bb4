#include "app/run/RunReplay.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "app/run/ManifestFiles.h"
#include "app/run/RecordedRun.h"
#include "app/run/RunFolder.h"
#include "app/run/RunSpec.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using ManifestJson = nlohmann::json;

constexpr std::size_t kMostRuns = 100;  // a folder that continues itself would have no end

/// What the manifest of a run says about its making.
struct ManifestOfRun {
  RunSpec spec;
  std::string folder;
  std::vector<std::string> inputs;  // SHA-256
  std::string version;
};

/// A path as recorded, looked for in the working directory, in the folder and beside it.
std::string findRecorded(const std::string& path, const fs::path& folder) {
  std::error_code none;
  for (const fs::path& candidate : {fs::path(path), folder / path, folder / ".." / path}) {
    if (!path.empty() && fs::exists(candidate, none)) {
      return candidate.string();
    }
  }
  return path;
}

base::Result<ManifestOfRun> readRunManifest(const std::string& folder) {
  const base::Result<Manifest> read = readManifest(folder);
  if (!read) {
    return read.diagnostics();
  }
  const ManifestJson manifest = ManifestJson::parse(base::shallowJson(read->text));
  ManifestOfRun run;
  std::vector<std::string> words, paths;
  try {
    words = manifest.at("command_line").get<std::vector<std::string>>();
    run.version = manifest.at("program").at("version").get<std::string>();
    for (const ManifestJson& input : manifest.at("inputs")) {
      paths.push_back(input.at("path").get<std::string>());
      run.inputs.push_back(input.at("sha256").get<std::string>());
    }
  } catch (const ManifestJson::exception&) {
    return base::error("again.not-told", {}, folder);
  }
  words.erase(words.begin(), words.begin() + (words.empty() ? 0 : 1));
  base::Result<RunSpec> spec = runSpecOfCommandLine(words);
  if (!spec) {
    return base::error("again.not-told", {}, folder);
  }
  run.spec = *std::move(spec);
  run.folder = folder;
  if (run.spec.scenario == kStandardInput) {
    return base::error("again.standard-input", {}, folder);
  }
  if (!run.spec.scenario.empty() && !paths.empty()) {
    run.spec.scenario =
        findInput(run.spec.scenario, folder, run.inputs.front()).value_or(paths.front());
  }
  for (std::string* path : {&run.spec.map, &run.spec.trees, &run.spec.metrics}) {
    *path = findRecorded(*path, folder);
  }
  return run;
}

/// Of the run in the folder and of those that it continues, the first one first.
base::Result<std::vector<ManifestOfRun>> readRunManifests(std::string folder) {
  std::vector<ManifestOfRun> runs;
  while (!folder.empty()) {
    const std::string child = runs.empty() ? "" : runs.front().folder;
    if (runs.size() >= kMostRuns) {
      return base::error("again.no-beginning", {}, child);
    }
    base::Result<ManifestOfRun> run = readRunManifest(folder);
    if (!run) {
      return run.diagnostics();
    }
    runs.insert(runs.begin(), *std::move(run));
    const std::string& from = runs.front().spec.from;
    const std::optional<RunMoment> moment = runMomentOf(from);
    if (!from.empty() && !moment) {
      return base::error("again.no-beginning", {}, runs.front().folder);
    }
    folder = moment ? findRecorded(moment->folder, runs.front().folder) : std::string();
  }
  return runs;
}

/// Errors of files of the bundle that have changed since a manifest listed these hashes.
base::Diagnostics changedInputs(const Bundle& bundle, const ManifestOfRun& run) {
  const std::vector<std::string> paths = inputsOf(bundle);
  base::Diagnostics problems;
  for (std::size_t k = 0; k < std::min(paths.size(), run.inputs.size()); ++k) {
    if (sha256OfFile(paths[k]) != run.inputs[k]) {
      problems.push_back(base::error("again.input-changed", {}, paths[k]));
    }
  }
  if (problems.empty() && paths.size() != run.inputs.size()) {
    problems.push_back(
        base::error("again.other-inputs", {run.inputs.size(), paths.size()}, run.folder));
  }
  return problems;
}

/// Reads the beginning of the first run.
base::Diagnostics readValidPart(const ManifestOfRun& run, const sim2d::ImageLoader& loader,
                                Bundle& bundle) {
  const base::Result<RunSettings> settings = runSettingsOf(run.spec);
  if (!settings) {
    return settings.diagnostics();
  }
  bundle = readBundle(run.spec, *settings, loader);
  bundle.settings.code = sim2d::ExternalCodePolicy::Refused;  // permission is required again
  base::Diagnostics problems = errorsOf(bundle.remarks);
  base::append(problems, errorsOf(bundle.wrongOptions));
  return problems;
}

}  // namespace

base::Result<RunProvenance> provenanceOf(const std::string& folder,
                                         const sim2d::ImageLoader& loader) {
  const base::Result<std::vector<ManifestOfRun>> runs = readRunManifests(folder);
  if (!runs) {
    return runs.diagnostics();
  }
  RunProvenance made;
  made.version = runs->back().version;
  Bundle last;
  for (const ManifestOfRun& run : *runs) {
    base::Diagnostics problems;
    if (made.folders.empty()) {
      problems = readValidPart(run, loader, made.bundle);
      last = made.bundle;
    } else {
      const double dt = made.bundle.scenario->desktop.dt.value_or(0.05);
      RunBranch& branch = made.branches.emplace_back();
      branch.step = std::llround(runMomentOf(run.spec.from)->time / dt);
      branch.changes = run.spec;
      base::Result<Bundle> next = continueWith(last, {branch});
      problems = next.diagnostics();
      last = next ? *std::move(next) : last;
    }
    if (!base::hasErrors(problems)) {
      base::append(problems, changedInputs(last, run));
    }
    if (base::hasErrors(problems)) {
      return problems;
    }
    made.folders.push_back(run.folder);
  }
  return made;
}

base::Diagnostics otherProgramWarning(const std::string& folder) {
  const std::string path = (fs::path(folder) / "manifest.json").string();
  const base::Result<std::string> text = base::readTextFile(path);
  const auto manifest = ManifestJson::parse(base::shallowJson(text ? *text : ""), nullptr, false);
  const ManifestJson::json_pointer at("/program/version");
  if (!manifest.is_object() || !manifest.contains(at) || !manifest[at].is_string()) {
    return {};
  }
  const auto version = manifest[at].get<std::string>();
  return version == programVersion()
             ? base::Diagnostics()
             : base::Diagnostics{
                   base::warning("trace.other-program", {version, programVersion()}, path)};
}

base::Result<std::unique_ptr<RunReplay>> RunReplay::prepare(const RunSpec& spec,
                                                            const sim2d::ImageLoader& loader,
                                                            const base::StopFlagPtr& stop) {
  std::unique_ptr<RunReplay> replay(new RunReplay());
  replay->moment_ = *runMomentOf(spec.from);
  const base::Diagnostics wrong = replay->readRecord();
  if (base::hasErrors(wrong)) {
    return wrong;
  }
  base::Result<RunProvenance> made = provenanceOf(replay->moment_.folder, loader);
  if (!made) {
    return made.diagnostics();
  }
  replay->version_ = made->version;
  replay->folders_ = made->folders;
  made->bundle.stopOfRun = stop;
  made->bundle.settings.threads = spec.threads;
  made->bundle.settings.code =
      spec.allowCode ? sim2d::ExternalCodePolicy::Allowed : sim2d::ExternalCodePolicy::Refused;
  made->branches.push_back({replay->from_, spec});
  replay->run_ = std::make_unique<BranchedRun>(std::move(made->bundle), made->branches);
  if (replay->verdict().ok()) {
    base::Result<sim2d::StepInputs> moves =
        inputsOfMoves(spec.moves, replay->header(), replay->moment_.folder);
    if (!moves) {
      return moves.diagnostics();
    }
    replay->moves_ = *std::move(moves);
  }
  return replay;
}

base::Diagnostics RunReplay::readRecord() {
  const base::Result<RecordedRun> run = readRecordedRun(moment_.folder);
  if (!run) {
    return run.diagnostics();
  }
  recording_ = run->recording;
  const double dt = recording_->header()->dt;
  const double end = recording_->timeOf(recording_->size() - 1);
  if (moment_.time > end + 0.5 * dt) {
    return {base::error("again.no-such-time", {end, moment_.time}, moment_.folder)};
  }
  from_ = std::llround(moment_.time / dt);
  inputs_ = recording_->inputsUntil(std::numeric_limits<std::int64_t>::max());
  return {};
}

/// Compares what the files of a run contain of a state.
bool RunReplay::isAsRecorded(const sim2d::Frame& frame) const {
  const std::size_t index = recording_->indexAt(frame.step);
  if (recording_->stepOf(index) != frame.step) {
    return true;  // not every step is recorded
  }
  std::string now, then;
  sim2d::appendTrajectoryRows(now, frame);
  sim2d::appendTrajectoryRows(then, *recording_->frame(index));
  return now == then;
}

void RunReplay::observe(const sim2d::Frame& frame, sim2d::World& world, Session& session) {
  if (frame.step <= from_ && !divergedAt_ && !isAsRecorded(frame)) {
    divergedAt_ = frame.time;
    session.stop();
    return;
  }
  run_->apply(frame, world);
  for (sim2d::Input& input : inputsOf(inputs_, frame.step + 1)) {
    session.add(std::move(input));
  }
  if (frame.step == from_) {
    for (const sim2d::Input& move : moves_) {
      session.add(move);
    }
  }
}

base::Diagnostics RunReplay::problems(const sim2d::RunResult& result) const {
  if (divergedAt_) {
    return {base::error("again.goes-elsewhere", {*divergedAt_, version_, programVersion()},
                        moment_.folder)};
  }
  if (result.steps < from_ && result.status != sim2d::RunStatus::Interrupted) {
    return {base::error("again.ends-before",
                        {static_cast<double>(result.steps) * run_->header().dt, moment_.time},
                        moment_.folder)};
  }
  return {};
}

}  // namespace app
