#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include <nlohmann/json.hpp>

#include "app/cli/BatchRunner.h"
#include "app/cli/CommandLine.h"
#include "app/cli/Commands.h"
#include "app/cli/Console.h"
#include "app/run/DataPaths.h"
#include "app/run/Manifest.h"
#include "app/run/Preparation.h"
#include "app/run/Sha256.h"
#include "editor/document/QtImageLoader.h"
#include "metrics/MetricRegistry.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char letter : text) {
    quoted += letter;
    quoted += letter == '"' ? "\"" : "";
  }
  return quoted + "\"";
}

/// Keys of the selection, in the order of the registry; every finished run has the same.
std::vector<std::string> metricColumns(const BatchRunner& runner) {
  std::vector<std::string> columns;
  for (const std::string& key : metrics::standardRegistry().keys()) {
    for (const std::optional<BatchRow>& row : runner.rows()) {
      if (row && row->metrics.count(key) != 0) {
        columns.push_back(key);
        break;
      }
    }
  }
  return columns;
}

std::string resultsCsv(const Experiment& experiment, const BatchRunner& runner) {
  const std::vector<std::string> keys = metricColumns(runner);
  std::string text = "run,scenario,seed";
  for (const auto& [path, texts] : experiment.values) {
    text += "," + csvField(path);
  }
  text += ",status,reason,simulated";
  for (const std::string& key : keys) {
    text += "," + key;
  }
  text += '\n';
  for (std::size_t index = 0; index < runner.rows().size(); ++index) {
    const std::optional<BatchRow>& row = runner.rows()[index];
    if (!row) {
      continue;  // not run: interrupted before
    }
    const Experiment::Run run = experiment.run(index);
    text += std::to_string(index) + "," + csvField(experiment.scenarios[run.scenario]) + "," +
            std::to_string(run.seed);
    for (const std::string& value : run.values) {
      text += "," + csvField(value);
    }
    text +=
        std::string(row->ok ? ",ok," : ",failed,") + csvField(row->reason) + "," + row->simulated;
    for (const std::string& key : keys) {
      const auto found = row->metrics.find(key);
      text += "," + (found == row->metrics.end() ? std::string() : csvField(found->second));
    }
    text += '\n';
  }
  return text;
}

Json inputJson(const std::string& path) {
  const std::optional<std::string> hash = sha256OfFile(path);
  return {{"path", path}, {"sha256", hash ? Json(*hash) : Json()}};
}

/// Nothing of this depends on the number of jobs or the clock.
std::string batchManifest(const Experiment& experiment, const BatchRunner& runner, bool complete) {
  std::size_t finished = 0, failed = 0;
  for (const std::optional<BatchRow>& row : runner.rows()) {
    finished += row ? 1 : 0;
    failed += row && !row->ok ? 1 : 0;
  }
  Json json;
  json["program"] = {{"version", programVersion()}, {"commit", programCommit()}};
  json["inputs"] = Json::array();
  json["inputs"].push_back(inputJson(experiment.path));
  for (const std::string& path : experiment.scenarioPaths) {
    json["inputs"].push_back(inputJson(path));
  }
  json["status"] = complete ? "finished" : "interrupted";
  json["runs"] = runner.rows().size();
  json["finished"] = finished;
  json["failed"] = failed;
  return json.dump(2) + "\n";
}

/// Scenarios that cannot be read, and values that no scenario takes, stop a batch before it starts.
base::Diagnostics checkInputs(const Experiment& experiment) {
  base::Diagnostics problems;
  for (std::size_t scenario = 0; scenario < experiment.scenarios.size(); ++scenario) {
    RunOptions options;
    options.scenario = experiment.scenarioPaths[scenario];
    for (const auto& [path, texts] : experiment.values) {
      options.set.push_back(path + "=" + texts.front());
    }
    options.model = experiment.model;
    options.planner = experiment.planner;
    options.robot = experiment.robot;
    const Preparation preparation = prepare(options, {}, editor::loadMapImage);
    for (base::Diagnostic diagnostic : preparation.wrongWords) {
      diagnostic.file = diagnostic.file.empty() ? experiment.path : diagnostic.file;
      problems.push_back(std::move(diagnostic));
    }
    for (const base::Diagnostic& diagnostic : preparation.diagnostics) {
      if (diagnostic.severity == base::Severity::Error) {
        problems.push_back(diagnostic);
      }
    }
  }
  return problems;
}

std::string progressText(std::size_t finished, std::size_t total, double seconds) {
  std::string text = std::to_string(finished) + " / " + std::to_string(total) + " runs";
  if (finished > 0 && seconds > 0.0) {
    const double rate = static_cast<double>(finished) / seconds;
    text += ", " + base::formatDecimals(std::round(rate * 10.0) / 10.0, 1) + " runs/s, " +
            durationText(static_cast<double>(total - finished) / rate) + " left";
  }
  return text;
}

int report(const Experiment& experiment, const BatchRunner& runner, const BatchOptions& options,
           const OutputOptions& output) {
  std::size_t finished = 0, failed = 0;
  for (const std::optional<BatchRow>& row : runner.rows()) {
    finished += row ? 1 : 0;
    failed += row && !row->ok ? 1 : 0;
  }
  const bool complete = finished == runner.rows().size();
  const fs::path folder = options.output;
  base::Diagnostics problems =
      base::writeFileAtomically((folder / "results.csv").string(), resultsCsv(experiment, runner));
  base::append(problems, base::writeFileAtomically((folder / "manifest.json").string(),
                                                   batchManifest(experiment, runner, complete)));
  printDiagnostics(problems);
  if (base::hasErrors(problems)) {
    return kBadInput;
  }
  if (output.json) {
    print(batchManifest(experiment, runner, complete));
  } else if (!output.quiet) {
    printLine(std::to_string(finished) + " of " + std::to_string(runner.rows().size()) +
              " runs finished, " + std::to_string(failed) +
              " failed: " + (folder / "results.csv").string());
  }
  if (!complete) {
    printError("interrupted: the finished runs are kept");
  }
  return complete && failed == 0 ? kFine : kRunFailed;
}

}  // namespace

int batchCommand(const BatchOptions& options, const OutputOptions& output) {
  const base::Result<Experiment> experiment = readExperiment(options.experiment);
  printDiagnostics(experiment.diagnostics());
  if (!experiment) {
    return kBadInput;
  }
  base::Diagnostics problems = checkInputs(*experiment);
  if (!base::hasErrors(problems)) {  // else nothing will be written
    base::append(problems, checkWritableFolder(options.output));
  }
  printDiagnostics(problems);
  if (base::hasErrors(problems)) {
    return kBadInput;
  }
  catchInterrupts();
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  const std::string runs = (fs::path(options.output) / "runs").string();
  BatchRunner runner(*experiment, runs, options.jobs > 0 ? options.jobs : static_cast<int>(cores));
  const auto start = std::chrono::steady_clock::now();
  {
    Progress progress(output.quiet);
    const std::size_t total = experiment->runCount();
    progress.show(progressText(0, total, 0.0), true);
    runner.execute(wasInterrupted, [&](std::size_t finished) {
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
      progress.show(progressText(finished, total, elapsed.count()));
    });
  }
  std::error_code ignored;  // the folder stays when runs are kept in it
  fs::remove(runs, ignored);
  return report(*experiment, runner, options, output);
}

}  // namespace app
