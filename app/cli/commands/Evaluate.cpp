#include "app/cli/Evaluate.h"

#include <filesystem>
#include <map>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/bridge/bag/Bag.h"
#include "app/run/DataPaths.h"
#include "app/run/ManifestFiles.h"
#include "app/run/RunSpec.h"
#include "metrics/IncrementalEvaluation.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace fs = std::filesystem;

namespace {

/// Errors for given options of trajectory files; `code` says where they do not apply. Bags take
/// some of them.
base::Diagnostics givenFileOptions(const EvaluateOptions& options, const char* code, bool isBag) {
  struct FileOption {
    const char* word;
    bool isGiven;
    bool isForBags = false;
  };
  const FileOption all[] = {{"--format", !options.format.empty()},
                            {"--columns", !options.columns.empty()},
                            {"--fps", options.framesPerSecond.has_value()},
                            {"--unit", !options.unit.empty()},
                            {"--time-unit", !options.timeUnit.empty()},
                            {"--degrees", options.degrees},
                            {"--radius", options.radius.has_value()},
                            {"--dt", options.step.has_value(), true},
                            {"--robot-goal", options.robotGoal.has_value(), true}};
  base::Diagnostics wrong;
  for (const FileOption& option : all) {
    if (option.isGiven && !(isBag && option.isForBags)) {
      wrong.push_back(base::error(code, {option.word}));
    }
  }
  return wrong;
}

/// Checks options that apply only to bags, or not to bags.
base::Diagnostics checkBagOptions(const EvaluateOptions& options, bridge::BagTopicOptions& use) {
  const bool isBag = isBagSource(options);
  base::Diagnostics wrong;
  if (!options.topics.empty() && !isBag) {
    wrong.push_back(base::error("option.only-bags", {"--topics"}));
  }
  if (isBag) {
    base::append(wrong, givenFileOptions(options, "option.not-for-bags", true));
  }
  const base::Result<bridge::BagTopicOptions> read = bridge::parseBagTopicOptions(options.topics);
  base::append(wrong, read.diagnostics());
  use = read ? *read : use;
  return wrong;
}

/// Which body is the robot in a third-party file: a name or an id.
void readRobot(const EvaluateOptions& options, sim2d::TrackOptions& tracks) {
  if (isRunFolder(options.source)) {
    return;
  }
  tracks.robotName = options.robot;
  const std::optional<long long> id = base::parseInt(options.robot);
  if (id && *id == static_cast<int>(*id)) {
    tracks.robotId = static_cast<int>(*id);
  }
}

/// Parses the options for reading and converting third-party files; returns the invalid ones.
base::Diagnostics parseForeignOptions(const EvaluateOptions& options,
                                      sim2d::TrackImportOptions& reading,
                                      sim2d::TrackOptions& tracks) {
  base::Diagnostics wrong;
  reading.format = options.format;  // checked by the command-line parser
  if (!options.columns.empty()) {
    const auto columns = sim2d::parseColumns(options.columns);
    base::append(wrong, columns.diagnostics());
    if (columns) {
      reading.columns = *columns;
    }
  }
  const auto positive = [&wrong](const std::optional<double>& value, const char* word) {
    if (value && !(*value > 0.0 && *value <= 1e6)) {
      wrong.push_back(base::error("option.not-positive", {word}));
    }
    return value.value_or(0.0);
  };
  reading.framesPerSecond = positive(options.framesPerSecond, "--fps");
  reading.radius = positive(options.radius, "--radius");
  reading.degrees = options.degrees;
  static const std::map<std::string, double> kTimes = {
      {"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}};
  reading.timeUnit = options.timeUnit.empty() ? 0.0 : kTimes.at(options.timeUnit);
  if (!options.unit.empty()) {
    static const std::map<std::string, double> kLengths = {{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}};
    const auto named = kLengths.find(options.unit);
    const std::optional<double> metres =
        named != kLengths.end() ? named->second : base::parseDouble(options.unit);
    reading.lengthUnit = positive(metres.value_or(0.0), "--unit");
  }
  tracks.step = positive(options.step, "--dt");
  readRobot(options, tracks);
  if (options.robotGoal) {
    const std::optional<std::vector<double>> goal = parseNumbers(*options.robotGoal, 2);
    if (goal) {
      tracks.robotGoal = base::Vec2((*goal)[0], (*goal)[1]);
    } else {
      wrong.push_back(base::error("option.evaluate-goal", {*options.robotGoal}));
    }
  }
  return wrong;
}

}  // namespace

bool isRunFolder(const std::string& source) {
  std::error_code ignored;
  return fs::is_directory(source, ignored) && !bridge::isBag(source);
}

bool isBagSource(const EvaluateOptions& options) {
  return options.ros2.ros2 || bridge::isBag(options.source);
}

base::Diagnostics parseEvaluateOptions(const EvaluateOptions& options, SourceOptions& parsed) {
  base::Diagnostics wrong = isRunFolder(options.source)
                                ? givenFileOptions(options, "option.only-foreign", false)
                                : base::Diagnostics();
  base::append(wrong, parseForeignOptions(options, parsed.reading, parsed.tracks));
  base::append(wrong, checkBagOptions(options, parsed.use));
  return wrong;
}

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

namespace {

int evaluateCommand(const EvaluateOptions& options, const Invocation& given) {
  if (options.ros2.ros2) {
    return evaluateLive(options, given);
  }
  evaluateSource(options, given);
  return ExitFine;
}

void addForeignOptions(CLI::App& command, EvaluateOptions& options) {
  command
      .add_option("--format", options.format,
                  "Format of the trajectory file (default: detected from its content)")
      ->check(oneOf(sim2d::trackFormatNames()));
  command.add_option("--columns", options.columns,
                     "Columns of the file, for example time=t,id=ped,x=px; column numbers from 1 "
                     "for formats without names (petrack, trajnet, socnavbench)");
  command.add_option("--fps", options.framesPerSecond,
                     "Frames per second, if the file has frame numbers and states no rate");
  command.add_option("--unit", options.unit,
                     "Length unit of the file: mm, cm, m, or metres per pixel");
  command.add_option("--time-unit", options.timeUnit, "Time unit of the file: s, ms, us or ns")
      ->check(oneOf({"s", "ms", "us", "ns"}));
  command.add_flag("--degrees", options.degrees, "Headings in the file are in degrees (csv)");
  command.add_option("--radius", options.radius, "Radius of all bodies in the file [m]");
  command.add_option("--dt", options.step, "Time step for resampling the file [s]");
  command.add_option(
      "--robot", options.robot,
      "For a run: name or number of the only robot to evaluate; for a file: id or label of the "
      "body that is the robot");
  command.add_option("--robot-goal", options.robotGoal, "Goal of the robot: \"X Y\" (m)");
  command.add_option("--topics", options.topics,
                     "Topics of a bag or a running system: people=NAME,robot=NAME,map=NAME");
}

void addLiveOptions(CLI::App& command, EvaluateOptions& options, CLI::Option* source) {
  addRos2Options(command, options.ros2,
                 "Record a running ROS 2 system instead of reading a source");
  CLI::Option* const ros2 = command.get_option("--ros2");
  source->required();  // otherwise a folder named like a command is parsed as that command
  ros2->excludes(source)->each([source](const std::string&) { source->required(false); });
  command.add_option("--namespace", options.space, "With --ros2: namespace of the evaluator node")
      ->check(namespaceName())
      ->needs(ros2);
  command.add_option("--duration", options.duration, "With --ros2: duration of a recording [s]")
      ->check(CLI::PositiveNumber)
      ->needs(ros2);
  command
      .add_flag("--by-services", options.byServices,
                "With --ros2: the services hunav_start_recording and hunav_stop_recording start "
                "and stop recordings, each in its own folder TAG_RUN")
      ->needs(ros2);
}

}  // namespace

void addEvaluate(CommandRegistry& commands) {
  const auto [command, options] = commands.add(
      "evaluate", "Compute metrics of a recorded run, a trajectory file or a bag", evaluateCommand);
  CLI::Option* const source =
      command.add_option("source", options.source,
                         "Folder of a run, trajectory file of an external program (-: standard "
                         "input), or bag: MCAP file, .db3 file or rosbag2 folder");
  addOutputFolder(command, options.output, "Output folder").required();
  command.add_option("--map", options.map,
                     "Map to use instead of the recorded one; none = open plane");
  addMetricsOptions(command, options.metrics);
  command.add_option("--tag", options.tag, "Tag in the result files");
  command.add_option("--run-id", options.runId, "Run number in the result files");
  command
      .add_option("--layout", options.layout,
                  "Also write the files of HuNavSim's evaluator in this layout")
      ->check(oneOf({"hunav2", "hunav1"}));
  command.add_option("--reference", options.reference,
                     "Reference for the path of the robot: folder of a run, or a file with one "
                     "body");
  addForeignOptions(command, options);
  addLiveOptions(command, options, source);
  addForce(command, options.force);
  commands.addExamples(
      command,
      {{"hunavsim evaluate out -o measured", "Compute the metrics of a recorded run again"},
       {"hunavsim evaluate obsmat.txt -o measured --robot 3",
        "Measure a recording of real people, with person 3 as the robot", "your recording"},
       {"hunavsim evaluate --ros2 -o trial --duration 60", "Record and measure a running system",
        "ROS 2"}});
}

}  // namespace app
