#include "app/cli/EvaluateResults.h"

#include <filesystem>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/bridge/bag/Bag.h"
#include "app/run/DataPaths.h"
#include "app/run/ManifestFiles.h"
#include "metrics/IncrementalEvaluation.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace fs = std::filesystem;

namespace {

constexpr const char* kRunFiles[] = {"trajectory.csv", "events.csv", "trace.json"};

/// All files that may be written.
std::vector<std::string> resultFileNames(const EvaluateOptions& options,
                                         const sim2d::TraceHeader& header) {
  std::vector<std::string> names = {"metrics.json", "steps.csv"};
  if (options.layout != "hunav2") {  // otherwise rows are appended to the table of this name
    names.emplace_back("metrics.csv");
  }
  const std::vector<std::string> robots = metrics::robotNames(header.robots);
  for (std::size_t k = 1; k < robots.size(); ++k) {
    names.push_back(metrics::robotFile("metrics", robots[k]));
    names.push_back(metrics::robotFile("steps", robots[k]));
  }
  if (options.ros2.ros2) {
    names.emplace_back(kRecording);
  }
  if (!isRunFolder(options.source)) {
    names.insert(names.end(), std::begin(kRunFiles), std::end(kRunFiles));
    names.emplace_back(sim2d::kPointsFile);
  }
  return names;
}

/// Whether the output is the folder of the run itself, whose other files stay.
bool writesIntoSource(const EvaluateOptions& options) {
  std::error_code ignored;
  return isRunFolder(options.source) && fs::equivalent(options.source, options.output, ignored);
}

/// The files that were read, except the map image.
std::vector<std::string> inputsOf(const EvaluateOptions& options) {
  std::vector<std::string> inputs;
  const std::string source = options.ros2.ros2 ? std::string() : options.source;  // else an output
  for (const std::string& read :
       {source, options.reference, options.map, options.metrics.metrics}) {
    if (isRunFolder(read)) {
      for (const char* name : kRunFiles) {
        inputs.push_back((fs::path(read) / name).string());
      }
      const fs::path points = fs::path(read) / sim2d::kPointsFile;
      if (std::error_code none; fs::exists(points, none)) {
        inputs.push_back(points.string());
      }
    } else if (bridge::isBag(read)) {
      const std::vector<std::string> files = bridge::filesOfBag(read);
      inputs.insert(inputs.end(), files.begin(), files.end());
    } else if (std::error_code ignored; read == "-" || fs::is_regular_file(read, ignored)) {
      inputs.push_back(read);
    }
  }
  return inputs;
}

/// Error if `evaluate` would remove the results of a run or a batch.
base::Diagnostics checkNotOtherRun(const EvaluateOptions& options) {
  std::error_code ignored;  // a missing file is not lost
  if (!fs::exists(pathIn(options.output, Manifest::kName), ignored) || writesIntoSource(options) ||
      options.force) {
    return {};
  }
  const base::Result<Manifest> manifest = readManifest(options.output);
  return manifest && manifest->kind == "evaluation"
             ? base::Diagnostics()
             : base::Diagnostics{base::error("file.other-run", {}, options.output)};
}

/// Errors for input files that results of the same name would overwrite.
base::Diagnostics overwrittenInputs(const EvaluateOptions& options,
                                    const std::vector<std::string>& written) {
  base::Diagnostics problems;
  for (const std::string& read :
       {options.source, options.reference, options.map, options.metrics.metrics}) {
    for (const std::string& name : written) {
      std::error_code ignored;  // a missing file is not lost
      const fs::path place = fs::path(options.output) / name;
      if (fs::is_regular_file(read, ignored) && fs::equivalent(read, place, ignored)) {
        problems.push_back(base::error("file.is-read", {}, read));
      }
    }
  }
  return problems;
}

}  // namespace

std::unique_ptr<OutputFolder> openEvaluation(const EvaluateOptions& options,
                                             const sim2d::TraceHeader& header,
                                             base::Diagnostics& problems) {
  std::vector<std::string> names = resultFileNames(options, header);
  if (options.layout == "hunav1") {
    names.emplace_back("metrics.yaml");
  }
  base::Diagnostics lost = checkNotOtherRun(options);
  base::append(lost, overwrittenInputs(options, names));
  if (base::hasErrors(lost)) {
    base::append(problems, lost);
    return nullptr;
  }
  base::Result<std::unique_ptr<OutputFolder>> opened =
      OutputFolder::open(options.output, options.force);
  base::append(problems, opened.diagnostics());
  if (!opened) {
    return nullptr;
  }
  lost = (*opened)->conflictingFiles(resultFileNames(options, header));
  base::append(problems, lost);
  return lost.empty() ? *std::move(opened) : nullptr;
}

std::string manifestOf(const EvaluateOptions& options, const Invocation& given,
                       base::Diagnostics& warnings) {
  const nlohmann::ordered_json json = {
      {"program", {{"version", programVersion()}, {"commit", programCommit()}}},
      {"kind", "evaluation"},
      {"command_line", given.words()},
      {"source", options.ros2.ros2 ? kRecording : options.source},
      {"inputs", inputHashes<nlohmann::ordered_json>(inputsOf(options), warnings)}};
  return base::jsonText(json);
}

base::Diagnostics writeEvaluation(const EvaluateOptions& options, const Measured& measured,
                                  const metrics::Evaluation& evaluation, OutputFolder& output,
                                  const Invocation& given) {
  const sim2d::Trace& trace = measured.trace;
  base::Diagnostics problems;
  const auto write = [&](const std::string& name, const std::string& content) {
    base::append(problems, output.write(name, content));
  };
  const bool isSecond = options.layout == "hunav2";
  write("metrics.json", metrics::toJson(evaluation));
  if (!isSecond) {
    write("metrics.csv", metrics::metricsCsv(evaluation));
  }
  write("steps.csv", metrics::stepsCsv(evaluation));
  for (const metrics::Evaluation& other : evaluation.others) {
    write(metrics::robotFile("metrics", other.robot), metrics::metricsCsv(other));
    write(metrics::robotFile("steps", other.robot), metrics::stepsCsv(other));
  }
  if (!isRunFolder(options.source)) {  // as a run, so that it can be rendered and evaluated again
    write("trajectory.csv", sim2d::trajectoryCsv(trace));
    write("events.csv", sim2d::eventsCsv(trace));
    write("trace.json", sim2d::traceJson(trace.header));
    if (!measured.points.isEmpty()) {
      write(sim2d::kPointsFile, measured.points.csv());
    }
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  output.removeOnCommit(resultFileNames(options, trace.header));
  const std::string manifest = manifestOf(options, given, problems);
  base::append(problems, output.commit(manifest, writesIntoSource(options)
                                                     ? OutputFolder::EarlierFiles::Kept
                                                     : OutputFolder::EarlierFiles::Removed));
  if (!options.layout.empty() && !base::hasErrors(problems)) {
    const fs::path folder = options.layoutFolder.empty() ? options.output : options.layoutFolder;
    const auto files =
        metrics::writeEvaluatorFiles(evaluation, (folder / "metrics").string(),
                                     isSecond ? metrics::Layout::Hunav2 : metrics::Layout::Hunav1);
    base::append(problems, files.diagnostics());
  }
  return problems;
}

}  // namespace app
