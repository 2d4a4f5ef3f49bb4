#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "app/run/Manifest.h"
#include "app/run/RunFolder.h"
#include "editor/document/QtImageLoader.h"
#include "metrics/Counterfactual.h"
#include "metrics/ReportFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/world/Runner.h"

namespace app {

namespace {

std::string oneDecimal(double value) {
  return base::formatDecimals(std::round(value * 10.0) / 10.0, 1);
}

FinishedRun simulate(sim2d::World& world, const sim2d::Scenario& scenario,
                     const MetricsSetup& scenarioSetup, RunWriter& writer,
                     const OutputOptions& output) {
  const sim2d::StopRule rule = sim2d::stopRuleOf(scenario);
  const double end = static_cast<double>(rule.maximumSteps) * world.dt();
  sim2d::StepTimes times;
  metrics::PlanningTime planning;
  double planned = 0.0;  // [s] up to the step before
  if (!world.frame().robots.id.empty()) {
    world.measure(&times);
  }
  sim2d::RunResult result;
  {
    Progress progress(output.quiet);
    result = sim2d::run(world, rule, writer, [&](const sim2d::Frame& frame) {
      const double now = times.seconds[static_cast<std::size_t>(sim2d::StepPhase::Robots)];
      if (times.steps > planning.steps()) {
        planning.add(now - planned);
        planned = now;
      }
      if (progress.isDue()) {
        progress.show(oneDecimal(frame.time) + " / " + oneDecimal(end) + " s simulated");
      }
      return wasInterrupted() || writer.hasFailed();
    });
  }
  world.measure(nullptr);
  sim2d::TraceHeader header = world.header();
  noteMetricsFile(scenarioSetup, header);
  return {std::move(header), std::move(result), planning, writer.evaluation(), {}, false};
}

/// The same people with the same draws, alone; as many steps as the run had.
base::Result<sim2d::Trace> simulateWithoutRobots(const Bundle& bundle, std::int64_t steps) {
  Bundle alone = bundle;
  auto scenario = std::make_shared<sim2d::Scenario>(*bundle.scenario);
  for (sim2d::Robot& robot : scenario->robots) {
    robot.listed = false;
  }
  alone.scenario = scenario;
  const Verdict verdict = check(alone);
  if (!verdict.world) {
    return verdict.problems;
  }
  sim2d::Recording recording(scenario->desktop.recordEvery.value_or(1));
  const sim2d::RunResult result = sim2d::run(*verdict.world, {steps, false}, recording,
                                             [](const sim2d::Frame&) { return wasInterrupted(); });
  if (result.status != sim2d::RunStatus::Finished) {
    return base::error("run.ended-without-robots", {result.reason}, bundle.path);
  }
  return recording.trace(verdict.world->header());
}

/// Adds the sums to the metrics and makes the table of people.
base::Diagnostics compareWithoutRobots(const Bundle& bundle, const RunWriter& writer,
                                       FinishedRun& run) {
  if (run.header.robots.empty()) {
    return {base::warning("run.nothing-to-compare", {}, bundle.path)};
  }
  const base::Result<sim2d::Trace> alone = simulateWithoutRobots(bundle, run.result.steps);
  if (!alone) {
    return alone.diagnostics();
  }
  const std::vector<metrics::PersonEffect> effects =
      metrics::personEffects(writer.recording()->trace(run.header), *alone);
  run.effectsCsv = metrics::effectsCsv(effects);
  if (run.evaluation) {
    const std::vector<metrics::MetricResult> sums = metrics::effectSums(effects);
    run.evaluation->results.insert(run.evaluation->results.end(), sums.begin(), sums.end());
  }
  return alone.diagnostics();
}

std::string lastLine(const FinishedRun& run, double dt) {
  const double simulated = static_cast<double>(run.result.steps) * dt;
  const double wall = run.result.steppingSeconds;
  const std::string factor =
      wall > 0.0 ? base::formatDecimals(std::round(simulated / wall), 0) + "x real time" : "-";
  return factor + " (" + oneDecimal(simulated) + " s simulated in " +
         base::formatDecimals(std::round(wall * 1000.0) / 1000.0, 3) + " s)";
}

/// The table may differ from run to run, the files may not. Not beside metrics chosen by key.
metrics::Evaluation withPlanningTime(const FinishedRun& run) {
  metrics::Evaluation evaluation = *run.evaluation;
  for (metrics::MetricResult& time : run.planning.results()) {
    if (!evaluation.isSelection) {
      evaluation.results.push_back(std::move(time));
    }
  }
  return evaluation;
}

void show(const FinishedRun& run, double dt, const OutputOptions& output) {
  if (output.json && run.evaluation) {
    print(metrics::toJson(*run.evaluation));
  } else if (!output.quiet && !output.json) {
    if (run.evaluation) {
      print(metrics::tableText(withPlanningTime(run)));
    }
    printLine(lastLine(run, dt));
  }
}

std::string simulatedText(const FinishedRun& run) {
  return oneDecimal(static_cast<double>(run.result.steps) * run.header.dt) + " s";
}

int exitCodeOf(const FinishedRun& run, const std::string& scenario) {
  switch (run.result.status) {
    case sim2d::RunStatus::Finished:
      return kFine;
    case sim2d::RunStatus::Failed:
      printDiagnostics({base::error("run.ended", {run.result.reason}, scenario)});
      return kRunFailed;
    case sim2d::RunStatus::Interrupted:
      printError("interrupted after " + simulatedText(run) + ": the part so far is kept");
      return kRunFailed;
  }
  return kRunFailed;
}

struct Outcome {
  RunWriter& writer;
  FinishedRun& run;
};

/// Comparison, files and table of a run; returns the exit code.
int conclude(const RunOptions& options, const OutputOptions& output, const Bundle& bundle,
             const std::vector<std::string>& commandLine, const Outcome& outcome) {
  FinishedRun& run = outcome.run;
  bool isCompared = true, isWritten = true;
  if (options.counterfactual && run.result.status == sim2d::RunStatus::Finished) {
    const base::Diagnostics told = compareWithoutRobots(bundle, outcome.writer, run);
    printDiagnostics(told);
    isCompared = !base::hasErrors(told);
  }
  if (!options.output.empty()) {
    const base::Diagnostics problems =
        writeRunFolder(options.output, run, outcome.writer, bundle, commandLine);
    printDiagnostics(problems);
    isWritten = !base::hasErrors(problems);
  }
  show(run, run.header.dt, output);
  if (!isWritten) {
    printError("after " + simulatedText(run) + " of the run: its files are not complete");
    return kBadInput;
  }
  const int code = exitCodeOf(run, options.scenario);
  return code == kFine && !isCompared ? kRunFailed : code;
}

/// Of the metrics what nobody will read is not worked out: per sample only for the files, per
/// behaviour type for them and for JSON.
void wantNoMore(const RunOptions& options, const OutputOptions& output,
                metrics::Selection& selection) {
  const bool hasFiles = !options.totals && !options.output.empty();
  selection.series = selection.seriesOnDisk = hasFiles;
  selection.behaviors = !options.totals && (hasFiles || output.json);
  selection.behaviorSeries = false;  // in none of the files
}

int runCommand(const RunOptions& options, const OutputOptions& output,
               const std::vector<std::string>& commandLine) {
  const base::Result<RunSettings> settings = runSettingsOf(options);
  printDiagnostics(settings.diagnostics());
  if (!settings) {
    return kWrongCommandLine;
  }
  const Bundle bundle = readBundle(options, *settings, editor::loadMapImage);
  Verdict verdict = check(bundle);
  printDiagnostics(verdict.wrongWords);
  if (base::hasErrors(verdict.wrongWords)) {
    return kWrongCommandLine;
  }
  if (!options.output.empty() && verdict.ok()) {  // else nothing will be written
    base::append(verdict.problems, checkWritableFolder(options.output));
  }
  printDiagnostics(verdict.problems, base::Severity::Warning);  // hints are for check
  printDiagnostics(verdict.worldRemarks);
  if (!verdict.ok()) {
    return kBadInput;
  }
  sim2d::World& world = *verdict.world;
  catchInterrupts();
  wantNoMore(options, output, verdict.metrics.selection);
  RunWriter writer(options.totals ? std::string() : options.output, world,
                   verdict.metrics.selection, verdict.metrics.parameters);
  if (options.counterfactual) {
    writer.keepRecording();
  }
  FinishedRun run = simulate(world, *bundle.scenario, verdict.scenarioMetrics, writer, output);
  run.totalsOnly = options.totals;
  base::Diagnostics troubles;
  world.behavior().takeDiagnostics(troubles);
  printDiagnostics(troubles);
  if (!run.evaluation) {
    printDiagnostics(run.evaluation.diagnostics());
  }
  return conclude(options, output, bundle, commandLine, {writer, run});
}

}  // namespace

void addRun(CommandRegistry& commands) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App& command = commands.add("run", "Simulate one scenario without a window",
                                   [options](const Invocation& given) {
                                     return runCommand(*options, given.output, given.words());
                                   });
  command
      .add_option("scenario", options->scenario, "Scenario: a file, or a name of list scenarios")
      ->required()
      ->transform(scenarioFile);
  command.add_option("-o,--output", options->output, "Folder for the files of the run");
  addRunOptions(command, *options);
  command.add_flag("--counterfactual", options->counterfactual,
                   "The same seed again without robots: what they did to people");
  command.add_flag("--totals", options->totals,
                   "Only manifest.json and the totals of metrics.json, for many long runs");
}

}  // namespace app
