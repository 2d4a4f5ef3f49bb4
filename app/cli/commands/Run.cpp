#include <cmath>
#include <filesystem>
#include <memory>
#include <system_error>

#include <CLI/CLI.hpp>

#include "app/bridge/bag/RunBagWriter.h"
#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/RunObservers.h"
#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "app/run/MetricsSetup.h"
#include "app/run/RunFolder.h"
#include "app/run/RunReplay.h"
#include "app/run/Session.h"
#include "metrics/Report.h"
#include "metrics/RunResults.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

std::string oneDecimal(double value) {
  return base::formatDecimals(std::round(value * 10.0) / 10.0, 1);
}

struct RunCommandOptions : RunSpec {
  std::string output;   // folder; empty: nothing is written
  bool force = false;   // files not created by hunavsim may be overwritten
  std::string record;   // "mcap": also a rosbag2 folder; empty: none
  bool totals = false;  // manifest.json and metrics.json alone, nothing per step or behaviour type
  LiveOptions live;
  RunOnRos2Options onRos2;
};

FinishedRun simulateShown(Session& session, const MetricsSetup& setup, sim2d::World& world,
                          RunWriter& writer, const std::vector<ShowFrame>& show,
                          const Invocation& given) {
  const double end = static_cast<double>(session.rule().maximumSteps) * world.dt();
  Progress progress(given.quiet);
  return simulate(session, world, setup, writer, [&](const sim2d::Frame& frame) {
    if (progress.isDue()) {
      progress.show(oneDecimal(frame.time) + " / " + oneDecimal(end) + " s simulated");
    }
    for (const ShowFrame& each : show) {
      each(frame);
    }
    return wasInterrupted();
  });
}

/// Two runs are compared as a whole, or not at all.
base::Diagnostics lostStates(const Session& session, const std::string& scenario) {
  return session.history()->first() == 0
             ? base::Diagnostics()
             : base::Diagnostics{base::error("run.states-lost", {}, scenario)};
}

/// The same people with the same draws, alone; as many steps as the run had.
base::Result<sim2d::Trace> simulateWithoutRobots(Bundle bundle, std::int64_t steps) {
  auto scenario = std::make_shared<sim2d::Scenario>(*bundle.scenario);
  for (sim2d::Robot& robot : scenario->robots) {
    robot.listed = false;
  }
  bundle.scenario = scenario;
  bundle.stopOfRun = std::make_shared<const base::StopFlag>();  // Ctrl-C: between steps
  const Verdict verdict = check(bundle);
  if (!verdict.world) {
    return verdict.problems;
  }
  Session session({steps, false});
  session.enableHistory(scenario->desktop.recordEvery.value_or(1));
  const sim2d::RunResult result = session.run(*verdict.world, nullptr, [&](const sim2d::Frame&) {
    if (wasInterrupted()) {
      session.stop();
    }
  });
  if (result.status != sim2d::RunStatus::Finished) {
    return base::error("run.ended-without-robots", {result.reason}, bundle.path);
  }
  base::Diagnostics lost = lostStates(session, bundle.path);
  return lost.empty()
             ? base::Result<sim2d::Trace>(session.history()->trace(verdict.world->header()))
             : base::Result<sim2d::Trace>(std::move(lost));
}

/// Adds the sums to the metrics and makes the table of people.
base::Diagnostics compareWithoutRobots(const Bundle& bundle, const Session& session,
                                       FinishedRun& run) {
  if (run.header.robots.empty()) {
    return {base::warning("run.nothing-to-compare", {}, bundle.path)};
  }
  const base::Result<sim2d::Trace> alone = simulateWithoutRobots(bundle, run.result.steps);
  if (!alone) {
    return alone.diagnostics();
  }
  base::Diagnostics lost = lostStates(session, bundle.path);
  if (!lost.empty()) {
    return lost;
  }
  const std::vector<metrics::PersonEffect> effects =
      metrics::personEffects(session.history()->trace(run.header), *alone);
  run.effectsCsv = metrics::effectsCsv(effects);
  if (run.evaluation) {
    const std::vector<metrics::MetricResult> sums = metrics::effectSums(effects);
    run.evaluation->results.insert(run.evaluation->results.end(), sums.begin(), sums.end());
  }
  return alone.diagnostics();
}

/// " (0.213 m from the goal)", "(goal 1: 0.2 m from the goal; goal 2: planner NO_VALID_PATH
/// (208), 3.4 m from the goal)".
std::string goalEndsText(const sim2d::RobotResult& robot) {
  std::string text;
  for (const sim2d::GoalResult& end : robot.goalResults) {
    text += (text.empty() ? " (" : "; ") + sim2d::goalResultText(end);
  }
  return text.empty() ? text : text + ")";
}

/// "; robot1 arrived at 7.3 s, robot2 timeout at 20.0 s".
std::string waysText(const sim2d::RunResult& result) {
  std::string text;
  for (const sim2d::RobotResult& robot : result.robots) {
    if (robot.result) {
      text += (text.empty() ? "; " : ", ") + robot.name + " " +
              sim2d::navigationOutcomeName(*robot.result) + " at " + oneDecimal(robot.time) + " s" +
              goalEndsText(robot);
    }
  }
  return text;
}

std::string lastLine(const FinishedRun& run) {
  const double simulated = static_cast<double>(run.result.steps) * run.header.dt;
  const double wall = run.result.stepSeconds;
  const std::string factor =
      wall > 0.0 ? base::formatDecimals(std::round(simulated / wall), 0) + "x real time" : "-";
  return factor + " (" + oneDecimal(simulated) + " s simulated in " +
         base::formatDecimals(std::round(wall * 1000.0) / 1000.0, 3) + " s)" + waysText(run.result);
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

void show(const FinishedRun& run, const Invocation& given) {
  if (given.json && run.evaluation) {
    print(metrics::toJson(*run.evaluation));
  } else if (!given.quiet && !given.json) {
    if (run.evaluation) {
      print(base::escapedControls(metrics::tableText(withPlanningTime(run)), "\n"));
    }
    printLine(lastLine(run));
  }
}

std::string simulatedText(const FinishedRun& run) {
  return oneDecimal(static_cast<double>(run.result.steps) * run.header.dt) + " s";
}

int exitCodeOf(const FinishedRun& run, const RunCommandOptions& options) {
  const std::string place = options.output.empty() ? std::string() : " in " + options.output;
  if (run.result.status == sim2d::RunStatus::Failed) {
    printDiagnostics({base::error("run.ended", {run.result.reason}, options.scenario)});
    if (!place.empty()) {
      printError("failed after " + simulatedText(run) + ": partial results are kept" + place);
    }
  } else if (run.result.status == sim2d::RunStatus::Interrupted) {
    printError("interrupted after " + simulatedText(run) + ": partial results are kept" + place);
  }
  return run.result.status == sim2d::RunStatus::Finished ? ExitFine : ExitRunFailed;
}

/// Files and table of a run; returns the exit code.
int conclude(const RunCommandOptions& options, const Invocation& given, const Bundle& bundle,
             RunWriter& writer, const FinishedRun& run, OutputFolder* output) {
  const bool isWritten = output == nullptr || printDiagnostics(writeRunFolder(
                                                  *output, run, writer, bundle, given.words()));
  show(run, given);
  if (!isWritten) {
    printError("after " + simulatedText(run) +
               " of simulation: the files of the run could not be written");
    return ExitBadInput;
  }
  return exitCodeOf(run, options);
}

/// Null if the folder cannot be written or files would be lost; the verdict contains the errors.
std::unique_ptr<OutputFolder> openOutput(const RunCommandOptions& options, Verdict& verdict) {
  base::Result<std::unique_ptr<OutputFolder>> opened =
      OutputFolder::open(options.output, options.force);
  if (!opened) {
    base::append(verdict.problems, opened.diagnostics());
    return nullptr;
  }
  const std::vector<std::string> robots = metrics::robotNames(verdict.world->header().robots);
  std::vector<std::string> names = runFileNames(robots, options.totals);
  if (!options.record.empty()) {
    names.insert(names.end(), std::begin(bridge::kBagFiles), std::end(bridge::kBagFiles));
  }
  const base::Diagnostics lost = (*opened)->conflictingFiles(names);
  base::append(verdict.problems, lost);
  return lost.empty() ? *std::move(opened) : nullptr;
}

/// The input of a run and its verdict.
struct Prepared {
  Bundle bundle;
  Verdict verdict;
  std::unique_ptr<RunReplay> replay;  // null: a run from the beginning
};

Prepared prepareReplay(const RunCommandOptions& options) {
  base::Result<std::unique_ptr<RunReplay>> replay =
      RunReplay::prepare(options, loadMapImage, interruptStop());
  requireFine(replay.diagnostics());
  for (const std::string& folder : (*replay)->folders()) {
    std::error_code none;
    if (!options.output.empty() && std::filesystem::equivalent(options.output, folder, none)) {
      requireFine({base::error("again.itself", {}, options.output)});
    }
  }
  return {(*replay)->bundle(), std::move((*replay)->verdict()), *std::move(replay)};
}

Prepared prepare(const RunCommandOptions& options) {
  const base::Result<RunSettings> settings = runSettingsOf(options);
  base::Diagnostics wrong = checkBranchOptions(options);
  if (!options.record.empty() && (options.output.empty() || options.totals)) {
    wrong.push_back(base::error(options.totals ? "option.record-totals" : "option.record-folder"));
  }
  base::append(wrong, settings.diagnostics());
  requireFine(wrong, ExitWrongCommandLine);
  if (!options.from.empty()) {
    return prepareReplay(options);
  }
  Prepared run;
  run.bundle = readBundle(options, *settings, loadMapImage);
  run.bundle.stopOfRun = interruptStop();
  run.verdict = check(run.bundle);
  return run;
}

void printDiagnosticsOfRun(sim2d::World& world, const FinishedRun& run) {
  base::Diagnostics troubles;
  world.behavior().takeDiagnostics(troubles);
  printDiagnostics(troubles);
  if (!run.evaluation) {
    printDiagnostics(run.evaluation.diagnostics());
  }
}

/// Null: not requested. Otherwise lidar scans are enabled.
std::unique_ptr<bridge::BagFolderWriter> bagOf(const RunCommandOptions& options,
                                               const Bundle& bundle, sim2d::World& world,
                                               const OutputFolder* output) {
  if (options.record.empty()) {
    return nullptr;
  }
  world.enableScans(true);
  return std::make_unique<bridge::BagFolderWriter>(output->staging(), *bundle.scenario, world);
}

int runCommand(const RunCommandOptions& options, const Invocation& given) {
  Prepared prepared = prepare(options);
  const Bundle& bundle = prepared.bundle;
  Verdict& verdict = prepared.verdict;
  requireFine(verdict.wrongOptions, ExitWrongCommandLine);
  std::unique_ptr<OutputFolder> output;
  if (!options.output.empty() && verdict.ok()) {  // else nothing will be written
    output = openOutput(options, verdict);
  }
  requireFine(verdict.problems, ExitBadInput, base::Severity::Warning);  // hints are for check
  printDiagnostics(verdict.worldRemarks);
  sim2d::World& world = *verdict.world;
  catchInterrupts();
  const bool hasFiles = !options.totals && !options.output.empty();
  skipUnwrittenMetrics(hasFiles, hasFiles || (given.json && !options.totals),
                       verdict.metrics.selection);
  RunWriter writer(hasFiles ? output->staging() : std::string(), world,
                   prepared.replay ? prepared.replay->header() : world.header(),
                   verdict.metrics.selection, verdict.metrics.parameters);
  const std::unique_ptr<bridge::BagFolderWriter> bag = bagOf(options, bundle, world, output.get());
  writer.setAdditionalWriter(bag.get());
  Session session(sim2d::stopRuleOf(*bundle.scenario));
  if (options.counterfactual) {
    session.enableHistory(bundle.scenario->desktop.recordEvery.value_or(1));
  }
  RunOutputs outputs = openRunOutputs(options.live, options.onRos2, bundle, verdict.metrics,
                                      prepared.replay != nullptr, {session, world});
  if (prepared.replay) {
    outputs.show.emplace_back(
        [&](const sim2d::Frame& frame) { prepared.replay->observe(frame, world, session); });
  }
  FinishedRun run =
      simulateShown(session, verdict.scenarioMetrics, world, writer, outputs.show, given);
  if (outputs.finish) {
    outputs.finish(world.frame(), run.result.reason);
  }
  run.totalsOnly = options.totals;
  if (prepared.replay) {
    requireFine(prepared.replay->problems(run.result));
    run.origin = prepared.replay->origin();
  }
  printDiagnosticsOfRun(world, run);
  bool isCompared = true;
  if (options.counterfactual && run.result.status == sim2d::RunStatus::Finished) {
    isCompared = printDiagnostics(compareWithoutRobots(bundle, session, run));
  }
  const int code = conclude(options, given, bundle, writer, run, output.get());
  return code == ExitFine && !isCompared ? ExitRunFailed : code;
}

}  // namespace

void addRun(CommandRegistry& commands) {
  const auto added = commands.add("run", "Simulate one scenario without a window", runCommand);
  RunCommandOptions& options = added.second;
  CLI::App& command = added.first;
  addOutputFolder(command, options.output, "Output folder (default: write no files)");
  addRunArguments(command, options);
  command
      .add_option("--record", options.record,
                  "mcap: also write a folder bag/ for ROS 2, Foxglove and PlotJuggler")
      ->check(oneOf({"mcap"}));
  addForce(command, options.force);
  addLiveOptions(command, options.live);
  command.add_flag("--totals", options.totals,
                   "Write only manifest.json and the totals of metrics.json, for many long runs");
  addRunOnRos2Options(command, options.onRos2);
  command.callback([&options] {
    if (options.scenario.empty() && options.from.empty()) {
      throw CLI::RequiredError("scenario");
    }
  });
  commands.addExamples(
      command,
      {{"hunavsim run corner_cafe_agents", "Run the café without a window and print the metrics"},
       {"hunavsim run corner_cafe_agents --planner dwa --seed 2 -o out",
        "Use another planner and seed, and write all files of the run"},
       {"hunavsim run --from out@4 --planner social_mppi -o other",
        "Repeat that run up to 4 s and continue it with another planner"},
       {"hunavsim run my_agents.yaml --robot-start \"-3.7 -3.1 0\" --robot-goal \"6.8 9.7\"",
        "Add a robot to a scenario of HuNavSim", "your scenario"}});
}

}  // namespace app
