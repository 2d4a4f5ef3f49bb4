#include <cmath>
#include <filesystem>

#include "app/CommandLine.h"
#include "app/Console.h"
#include "app/Manifest.h"
#include "app/Preparation.h"
#include "app/RunFolder.h"
#include "app/commands/Commands.h"
#include "editor/document/MetricsSetup.h"
#include "metrics/ReportFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Recorder.h"
#include "sim2d/world/Runner.h"

namespace app {

namespace {

std::string oneDecimal(double value) {
  return base::formatDecimals(std::round(value * 10.0) / 10.0, 1);
}

/// `--metrics`: a file, or keys with commas; over what the scenario says. Unknown keys are wrong
/// words.
base::Diagnostics chooseMetrics(const RunOptions& options, editor::MetricsSetup& setup,
                                base::Diagnostics& wrongWords) {
  setup.parameters.profile = *metrics::profileOf(options.metricsProfile);
  if (options.metrics.empty()) {
    return {};
  }
  std::error_code ignored;
  if (std::filesystem::exists(options.metrics, ignored)) {
    const base::Result<metrics::MetricsFile> file = metrics::readMetricsFile(options.metrics);
    if (file) {
      setup.selection.keys = file->selection.keys;
    }
    return file.diagnostics();
  }
  const base::Result<metrics::Selection> chosen =
      metrics::selectionOfKeys(base::split(options.metrics, ','));
  if (chosen) {
    setup.selection.keys = chosen->keys;
  }
  base::append(wrongWords, chosen.diagnostics());
  return {};
}

FinishedRun simulate(sim2d::World& world, const sim2d::Scenario& scenario,
                     const editor::MetricsSetup& setup, const OutputOptions& output) {
  const sim2d::StopRule rule = sim2d::stopRuleOf(scenario);
  sim2d::Recorder recorder(scenario.desktop.recordEvery.value_or(1));
  const double end = static_cast<double>(rule.maximumSteps) * world.dt();
  sim2d::RunResult result;
  {
    Progress progress(output.quiet);
    result = sim2d::run(world, rule, recorder, [&](const sim2d::Frame& frame) {
      if (progress.isDue()) {
        progress.show(oneDecimal(frame.time) + " / " + oneDecimal(end) + " s simulated");
      }
      return wasInterrupted();
    });
  }
  std::string treesCsv = recorder.treesCsv();
  sim2d::Trace trace = recorder.finish(world.header());
  base::Result<metrics::Evaluation> evaluation =
      metrics::evaluate(trace, setup.selection, setup.parameters);
  return {std::move(trace), std::move(treesCsv), std::move(result), std::move(evaluation)};
}

std::string lastLine(const FinishedRun& run, double dt) {
  const double simulated = static_cast<double>(run.result.steps) * dt;
  const double wall = run.result.steppingSeconds;
  const std::string factor =
      wall > 0.0 ? base::formatDecimals(std::round(simulated / wall), 0) + "x real time" : "-";
  return factor + " (" + oneDecimal(simulated) + " s simulated in " +
         base::formatDecimals(std::round(wall * 1000.0) / 1000.0, 3) + " s)";
}

void show(const FinishedRun& run, double dt, const OutputOptions& output) {
  if (output.json && run.evaluation) {
    print(metrics::toJson(*run.evaluation));
  } else if (!output.quiet && !output.json) {
    if (run.evaluation) {
      print(metrics::tableText(*run.evaluation));
    }
    printLine(lastLine(run, dt));
  }
}

int exitCodeOf(const FinishedRun& run, const std::string& scenario) {
  switch (run.result.status) {
    case sim2d::RunStatus::Finished:
      return kFine;
    case sim2d::RunStatus::Failed:
      printDiagnostics({base::makeError("the run failed: " + run.result.reason, scenario)});
      return kRunFailed;
    case sim2d::RunStatus::Interrupted:
      printError("interrupted after " +
                 oneDecimal(static_cast<double>(run.result.steps) * run.trace.header.dt) +
                 " s: the part so far is kept");
      return kRunFailed;
  }
  return kRunFailed;
}

}  // namespace

int runCommand(const RunOptions& options, const OutputOptions& output,
               const std::vector<std::string>& commandLine) {
  const base::Diagnostics wrong = checkOptions(options);
  const base::Result<sim2d::Compatibility> compatibility =
      options.compat.empty() ? base::Result<sim2d::Compatibility>(sim2d::Compatibility())
                             : sim2d::Compatibility::parse(options.compat);
  printDiagnostics(wrong);
  printDiagnostics(compatibility.diagnostics());
  if (!wrong.empty() || !compatibility) {
    return kWrongCommandLine;
  }
  Preparation preparation = prepare(options, *compatibility);
  base::Result<editor::MetricsSetup> setup =
      editor::metricsSetupOf(*preparation.scenario, options.scenario);
  base::append(preparation.diagnostics, setup.diagnostics());
  if (setup) {
    base::append(preparation.diagnostics, chooseMetrics(options, *setup, preparation.wrongWords));
  }
  printDiagnostics(preparation.wrongWords);
  if (base::hasErrors(preparation.wrongWords)) {
    return kWrongCommandLine;
  }
  if (!options.output.empty()) {
    base::append(preparation.diagnostics, checkWritableFolder(options.output));
  }
  printDiagnostics(preparation.diagnostics, base::Severity::Warning);  // hints are for check
  if (!preparation.ok()) {
    return kBadInput;
  }
  const base::Result<std::unique_ptr<sim2d::World>> world = makeWorld(preparation, options);
  printDiagnostics(world.diagnostics());
  if (!world) {
    return kBadInput;
  }
  catchInterrupts();
  const FinishedRun run = simulate(**world, *preparation.scenario, *setup, output);
  base::Diagnostics troubles;
  (*world)->behavior().takeDiagnostics(troubles);
  printDiagnostics(troubles);
  if (!run.evaluation) {
    printDiagnostics(run.evaluation.diagnostics());
  }
  if (!options.output.empty()) {
    const base::Diagnostics problems =
        writeRunFolder(options.output, run, preparation, commandLine);
    printDiagnostics(problems);
    if (base::hasErrors(problems)) {
      return kBadInput;
    }
  }
  show(run, (*world)->dt(), output);
  return exitCodeOf(run, options.scenario);
}

}  // namespace app
