#include "app/cli/CommandLine.h"

#include <clocale>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>

#include <QApplication>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>

#include "app/cli/Commands.h"
#include "app/cli/Console.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/Export.h"

namespace app {

namespace {

/// All words of the command line, by command.
struct Words {
  OutputOptions output;
  RunOptions run;
  WindowOptions window;
  CheckOptions check;
  ListOptions list;
  RenderOptions render;
  EvaluateOptions evaluate;
  BatchOptions batch;
  ValidateOptions validate;
  TreesOptions trees;
  ConvertOptions convert;
  BenchOptions bench;
};

void addOutputOptions(CLI::App& command, OutputOptions& options) {
  command.add_flag("--quiet", options.quiet, "No progress and no table");
  command.add_flag("--json", options.json, "Machine-readable standard output");
}

void addMetricsOptions(CLI::App& command, std::string& metrics, std::string& profile) {
  command.add_option("--metrics", metrics, "Selection: a metrics.yaml, or keys with commas");
  command.add_option("--metrics-profile", profile, "corrected or hunav2")
      ->check(CLI::IsMember({"corrected", "hunav2"}));
}

void addRunOptions(CLI::App& command, RunOptions& options) {
  command.add_option("--map", options.map,
                     "Map to use instead of the scenario's; none = open plane");
  command.add_option("--trees", options.trees, "Folder with the behaviour trees");
  command.add_option("--seed", options.seed, "Seed of all random numbers")
      ->check([](const std::string& text) {
        return base::parseInt(text) ? std::string() : "'" + text + "' is no whole number that fits";
      });
  command.add_option("--duration", options.duration, "Length of the run [s]");
  command.add_option("--dt", options.dt, "Time step [s]");
  command.add_option("--model", options.model, "How people walk: see list models");
  command.add_option("--robot", options.robot, "Type of the robot: see list robots");
  command.add_option("--robot-start", options.robotStart, "\"X Y HEADING\" (m, m, rad)");
  command.add_option("--robot-goal", options.robotGoal, "\"X Y\" (m)");
  command.add_option("--planner", options.planner, "How the robot plans: see list planners");
  command.add_option("--threads", options.threads, "Number of threads; results stay the same");
  addMetricsOptions(command, options.metrics, options.metricsProfile);
  command.add_option("--record-every", options.recordEvery, "Record every N-th step");
  command.add_option("--set", options.set, "PATH=VALUE: any value of the scenario")
      ->allow_extra_args(false);
  command.add_flag("--exact", options.exact, "Full double sum of forces");
  command.add_option("--compat", options.compat, "hunav2, or quirks of the original: Q-13,Q-20");
}

void addWindow(CLI::App& root, Words& words) {
  root.add_option("scenario", words.run.scenario, "Scenario to open in the window")
      ->transform(scenarioFile);
  addRunOptions(root, words.run);
  WindowOptions& window = words.window;
  root.add_option("--screenshot", window.screenshot, "Save a picture of the window and leave");
  root.add_option("--at", window.at, "Simulated time of the picture [s]");
  root.add_option("--size", window.size, "Size of the window, WxH");
  root.add_option("--scale", window.scale, "Pixels per point");
  root.add_option("--theme", window.theme, "light or dark")
      ->check(CLI::IsMember({"light", "dark"}));
  root.add_option("--dock", window.docks, "Docks to show, by their names in the View menu");
}

/// `--dock issues events FILE`: all words behind the option are names of docks to it. The last is
/// the scenario when there is none yet, and it names one.
void takeScenarioFromDocks(Words& words) {
  std::vector<std::string>& docks = words.window.docks;
  if (docks.size() < 2 || !words.run.scenario.empty()) {
    return;
  }
  const std::string file = scenarioFile(docks.back());
  if (QFileInfo(QString::fromStdString(file)).isFile()) {
    docks.pop_back();
    words.run.scenario = file;
  }
}

void addRun(CLI::App& root, Words& words) {
  CLI::App* command = root.add_subcommand("run", "Simulate one scenario without a window");
  command
      ->add_option("scenario", words.run.scenario, "Scenario: a file, or a name of list scenarios")
      ->required()
      ->transform(scenarioFile);
  command->add_option("-o,--output", words.run.output, "Folder for the files of the run");
  addRunOptions(*command, words.run);
  command->add_flag("--counterfactual", words.run.counterfactual,
                    "The same seed again without robots: what they did to people");
  command->add_flag("--totals", words.run.totals,
                    "Only manifest.json and the totals of metrics.json, for many long runs");
  addOutputOptions(*command, words.output);
}

void addCheck(CLI::App& root, Words& words) {
  CLI::App* command = root.add_subcommand("check", "Validate scenarios, trees, maps, experiments");
  command->add_option("files", words.check.files, "Files")->required();
  command->add_option("--map", words.check.map, "Map of the scenarios");
  command->add_option("--trees", words.check.trees, "Folder with their trees");
  addOutputOptions(*command, words.output);
}

void addList(CLI::App& root, Words& words) {
  CLI::App* command = root.add_subcommand("list", "What there is to use");
  command
      ->add_option("what", words.list.what, "nodes, metrics, models, robots, planners, scenarios")
      ->required()
      ->check(CLI::IsMember({"nodes", "metrics", "models", "robots", "planners", "scenarios"}));
  command
      ->add_option("--format", words.list.format,
                   "text or json; xml for nodes, markdown for metrics")
      ->check(CLI::IsMember({"text", "json", "xml", "markdown"}));
  addOutputOptions(*command, words.output);
}

void addForeignOptions(CLI::App& command, EvaluateOptions& options) {
  command.add_option("--format", options.format, "Of a file of another program (by its name)")
      ->check(CLI::IsMember({"csv", "eth", "vsp", "trajnet", "socnavbench"}));
  command.add_option("--columns", options.columns, "Names of its columns: time=t,id=ped,x=px");
  command.add_option("--fps", options.framesPerSecond, "Frames per second of its frame numbers");
  command.add_option("--dt", options.step, "Step of the samples made of it [s]");
  command.add_option("--robot", options.robot, "The person with this id is the robot");
  command.add_option("--robot-goal", options.robotGoal, "\"X Y\" (m)");
}

void addEvaluate(CLI::App& root, Words& words) {
  CLI::App* command = root.add_subcommand("evaluate", "Metrics of a recorded run or of a file");
  EvaluateOptions& options = words.evaluate;
  command->add_option("source", options.source, "Folder of a run, or a trajectory file")
      ->required();
  command->add_option("-o,--output", options.output, "Folder for the results")->required();
  command->add_option("--map", options.map, "Map instead of the recorded; none = open plane");
  addMetricsOptions(*command, options.metrics, options.metricsProfile);
  command->add_option("--tag", options.tag, "Tag in the result files");
  command->add_option("--run-id", options.runId, "Number of the run in the result files");
  command->add_option("--layout", options.layout, "Also the files of HuNavSim's evaluator")
      ->check(CLI::IsMember({"hunav2", "hunav1"}));
  command->add_option("--reference", options.reference,
                      "Run to compare the robot's way with: a folder, or a file with one body");
  addForeignOptions(*command, options);
  addOutputOptions(*command, words.output);
}

void addRender(CLI::App& root, Words& words) {
  CLI::App* command = root.add_subcommand("render", "Draw a recorded run");
  command->add_option("run", words.render.run, "Folder of the run")->required();
  command->add_option("-o,--output", words.render.output, "Picture (.png)")->required();
  addOutputOptions(*command, words.output);
}

void addBatch(CLI::App& root, Words& words) {
  CLI::App* command = root.add_subcommand("batch", "Many runs: scenarios x values x seeds");
  command->add_option("experiment", words.batch.experiment, "Experiment file")->required();
  command->add_option("-o,--output", words.batch.output, "Folder for the results")->required();
  command->add_option("--jobs", words.batch.jobs, "Processes at a time (number of cores)")
      ->check(CLI::Range(1, 1024));
  addOutputOptions(*command, words.output);
}

void addTrees(CLI::App& root, Words& words) {
  CLI::App* command = root.add_subcommand("trees", "Make people's behaviour trees, or play one");
  TreesOptions& trees = words.trees;
  CLI::Option* scenario =
      command->add_option("scenario", trees.scenario, "Scenario file")->transform(scenarioFile);
  CLI::Option* output =
      command->add_option("-o,--output", trees.output, "Folder for the trees; none: print them");
  CLI::Option* style = command->add_option("--style", trees.style, "corrected or hunav2");
  style->check(CLI::IsMember({"corrected", "hunav2"}));
  CLI::Option* play = command->add_option("--play", trees.play, "Tree file to tick by itself");
  play->excludes(scenario)->excludes(output)->excludes(style);
  command->add_option("--script", trees.script, "YAML: leaf -> statuses of its calls")->needs(play);
  command->add_option("--ticks", trees.ticks, "Number of ticks (10)")
      ->needs(play)
      ->check(CLI::Range(1, 1000000));
  command->add_option("--dt", trees.dt, "Time step [s] (0.05)")->needs(play);
  command->add_option("--seed", trees.seed, "Seed of the tree's draws (1)")
      ->needs(play)
      ->check(CLI::NonNegativeNumber);
  command->add_option("--compat", trees.compat, "hunav2, or quirks of the original: Q-20")
      ->needs(play);
  addOutputOptions(*command, words.output);
}

void addConvert(CLI::App& root, Words& words) {
  CLI::App* command =
      root.add_subcommand("convert", "Write scenario, trees and map for another simulator");
  ConvertOptions& convert = words.convert;
  std::vector<std::string> targets;
  for (const sim2d::TargetInfo& target : sim2d::exportTargets()) {
    targets.push_back(target.name);
  }
  command->add_option("scenario", convert.scenario, "Scenario file, of any dialect")
      ->required()
      ->transform(scenarioFile);
  command->add_option("-o,--output", convert.output, "Folder for scenarios, behavior_trees, maps")
      ->required();
  command->add_option("--target", convert.target, "Simulator that is to read it")
      ->required()
      ->check(CLI::IsMember(targets));
  command->add_option("--dialect", convert.dialect, "B or C instead of what the target reads")
      ->check(CLI::IsMember({"B", "C"}));
  command->add_option("--style", convert.style, "Of trees that are missing: corrected or hunav2")
      ->check(CLI::IsMember({"corrected", "hunav2"}));
  command->add_option("--map", convert.map, "Map to use instead of the scenario's");
  command->add_option("--trees", convert.trees, "Folder with the behaviour trees");
  addOutputOptions(*command, words.output);
}

/// Nothing = fine; otherwise what is wrong.
std::string isPictureFile(const std::string& path) {
  const QFileInfo file(QString::fromStdString(path));
  const QStringList endings = {QStringLiteral("png"), QStringLiteral("svg"), QStringLiteral("pdf")};
  if (!endings.contains(file.suffix())) {
    return "'" + path + "' ends neither in .png nor in .svg nor in .pdf";
  }
  return file.absoluteDir().exists() ? std::string() : "there is no folder for '" + path + "'";
}

void addBench(CLI::App& root, Words& words) {
  CLI::App* command = root.add_subcommand("bench", "How fast this machine steps crowds");
  command->add_flag("--quick", words.bench.quick, "Up to 1000 people, in a few seconds");
  command->add_option("--threads", words.bench.threads, "Number of threads")
      ->check(CLI::Range(1, 256));
  command->add_option("--format", words.bench.format, "text or csv")
      ->check(CLI::IsMember({"text", "csv"}));
  command->add_option("--picture", words.bench.picture, "Draws the table: FILE.png, .svg or .pdf")
      ->check(isPictureFile);
  addOutputOptions(*command, words.output);
}

void addValidate(CLI::App& root, Words& words) {
  CLI::App* command =
      root.add_subcommand("validate", "Realism tests: people of the models against real ones");
  command->add_option("names", words.validate.names, "Realism tests (all)");
  command->add_option("-o,--output", words.validate.output, "Folder for the results");
  command->add_option("--seeds", words.validate.seeds, "Runs with seeds 1 to N (10)")
      ->check(CLI::Range(1, 10000));
  command->add_option("--model", words.validate.models, "Models to test (sfm and das)")
      ->allow_extra_args(false);
  addOutputOptions(*command, words.output);
}

/// Numbers are read without a locale, whatever the user's is.
template <class Application>
int within(int argc, char** argv, const std::function<int()>& action) {
  Application application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  return action();
}

template <class Application>
int drawOffscreen(int argc, char** argv, const std::function<int()>& action) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
  return within<Application>(argc, argv, action);
}

/// The command that was given; the window without one.
int start(CLI::App& root, int argc, char** argv, Words& given, OpenWindow openWindow) {
  const std::vector<std::string> words(argv, argv + argc);
  const OutputOptions& output = given.output;
  const std::map<std::string, std::function<int()>> plain = {
      {"run", [&] { return runCommand(given.run, output, words); }},
      {"check", [&] { return checkCommand(given.check, output); }},
      {"list", [&] { return listCommand(given.list, output); }},
      {"batch", [&] { return batchCommand(given.batch, output); }},
      {"trees", [&] { return treesCommand(given.trees, output); }},
      {"convert", [&] { return convertCommand(given.convert, output); }},
      {"validate", [&] { return validateCommand(given.validate, output); }},
      {"evaluate", [&] { return evaluateCommand(given.evaluate, output); }},
  };
  for (const auto& [name, action] : plain) {
    if (root.got_subcommand(name)) {
      return within<QCoreApplication>(argc, argv, action);
    }
  }
  if (root.got_subcommand("bench")) {
    const auto action = [&] { return benchCommand(given.bench, output); };
    return given.bench.picture.empty() ? within<QCoreApplication>(argc, argv, action)
                                       : drawOffscreen<QApplication>(argc, argv, action);
  }
  if (root.got_subcommand("render")) {
    return drawOffscreen<QGuiApplication>(argc, argv,
                                          [&] { return renderCommand(given.render, output); });
  }
  return openWindow(argc, argv, given.run, given.window);
}

/// Words that no option takes; the library tells them last first.
int tellExtras(const CLI::App& root, const std::string& firstWord) {
  const std::vector<CLI::App*> given = root.get_subcommands();
  std::string text = "not expected: " + base::join(root.remaining(true), " ");
  std::vector<std::string> commands;
  for (const CLI::App* command : root.get_subcommands(nullptr)) {
    commands.push_back(command->get_name());
  }
  const std::optional<std::string> meant = base::nearestName(firstWord, commands);
  if (given.empty() && meant) {
    text += " (did you mean the command '" + *meant + "'?)";
  }
  printError(text);
  printError("see hunavsim" + (given.empty() ? "" : " " + given.front()->get_name()) + " --help");
  return kWrongCommandLine;
}

}  // namespace

/// What image libraries grumble is told by our own messages, with the file's name.
void withoutLibraryWords(QtMsgType type, const QMessageLogContext& context, const QString& text) {
  if (!text.startsWith(QLatin1String("libpng"))) {
    std::fputs(qPrintable(qFormatLogMessage(type, context, text) + QLatin1Char('\n')), stderr);
  }
}

int runProgram(int argc, char** argv, OpenWindow openWindow) {
  qInstallMessageHandler(withoutLibraryWords);
  keepAliveWhenFilesAreFull();
  Words given;
  CLI::App root{"HuNavSim Desktop: people and a robot on a map, drawn, simulated, measured"};
  root.name("hunavsim");
  root.set_version_flag("--version", "hunavsim " + programVersion() + " (" + programCommit() + ")");
  root.set_help_flag("--help", "Show this text");
  addWindow(root, given);
  addRun(root, given);
  addCheck(root, given);
  addList(root, given);
  addRender(root, given);
  addEvaluate(root, given);
  addBatch(root, given);
  addBench(root, given);
  addValidate(root, given);
  addTrees(root, given);
  addConvert(root, given);
  try {
    root.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    return tellExtras(root, argv[1]);
  } catch (const CLI::ParseError& problem) {
    return root.exit(problem) == 0 ? kFine : kWrongCommandLine;
  }
  takeScenarioFromDocks(given);
  return start(root, argc, argv, given, openWindow);
}

}  // namespace app
