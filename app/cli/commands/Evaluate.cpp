#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/BagTrace.h"
#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/MapImages.h"
#include "app/run/Bundle.h"
#include "app/run/DataPaths.h"
#include "app/run/ListedFiles.h"
#include "app/run/MetricsSetup.h"
#include "app/run/RunFolder.h"
#include "metrics/ReportFiles.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/ForeignFiles.h"

namespace app {

namespace {

struct EvaluateOptions {
  std::string source;  // folder of a run, or a file of another program
  std::string output;
  std::string map;  // instead of the record's; "none" = open plane
  MetricsWords metrics;
  std::optional<std::string> tag;
  std::optional<int> runId;
  std::string layout;     // hunav2 (v2), hunav1 (v1): the evaluator's own files too
  std::string reference;  // run to compare the robot's way with: folder, or a file with one body
  // of files of other programs
  std::string format, columns;
  std::string unit, timeUnit;
  bool degrees = false;
  std::optional<double> framesPerSecond, step, radius;
  std::string topics;  // of a bag
  std::string robot;   // of a run: its robot; of a file: the id of who is the robot
  std::optional<std::string> robotGoal;
  bool force = false;  // files of others in the output folder may be replaced
};

namespace fs = std::filesystem;

bool isRunFolder(const std::string& source) {
  std::error_code ignored;
  return fs::is_directory(source, ignored) && !bridge::isBag(source);
}

/// Words that only mean something for bags, or nothing for them.
base::Diagnostics bagWords(const EvaluateOptions& options, bridge::BagUse& use) {
  base::Diagnostics wrong;
  if (!options.topics.empty() && !bridge::isBag(options.source)) {
    wrong.push_back(base::error("option.only-bags", {"--topics"}));
  }
  const std::pair<const char*, bool> given[] = {
      {"--format", !options.format.empty()},          {"--columns", !options.columns.empty()},
      {"--fps", options.framesPerSecond.has_value()}, {"--unit", !options.unit.empty()},
      {"--time-unit", !options.timeUnit.empty()},     {"--degrees", options.degrees},
      {"--radius", options.radius.has_value()}};
  for (const auto& [word, isGiven] : given) {
    if (isGiven && bridge::isBag(options.source)) {
      wrong.push_back(base::error("option.not-for-bags", {word}));
    }
  }
  const base::Result<bridge::BagUse> read = bridge::parseBagUse(options.topics);
  base::append(wrong, read.diagnostics());
  use = read ? *read : use;
  return wrong;
}

/// Words that only mean something for files of other programs.
base::Diagnostics foreignWords(const EvaluateOptions& options) {
  const std::pair<const char*, bool> given[] = {
      {"--format", !options.format.empty()},          {"--columns", !options.columns.empty()},
      {"--fps", options.framesPerSecond.has_value()}, {"--unit", !options.unit.empty()},
      {"--time-unit", !options.timeUnit.empty()},     {"--degrees", options.degrees},
      {"--radius", options.radius.has_value()},       {"--dt", options.step.has_value()},
      {"--robot-goal", options.robotGoal.has_value()}};
  base::Diagnostics wrong;
  for (const auto& [word, isGiven] : given) {
    if (isGiven) {
      wrong.push_back(base::error("option.only-foreign", {word}));
    }
  }
  return wrong;
}

/// Who is the robot in a file of another program: a word of it, or an id.
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

/// How a file of another program is read, and made to a run. Returns what is wrong with the words.
base::Diagnostics readForeignWords(const EvaluateOptions& options, sim2d::ForeignOptions& reading,
                                   sim2d::TrackOptions& tracks) {
  base::Diagnostics wrong;
  reading.format = options.format;  // checked by the parser
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

base::Result<sim2d::Trace> readSource(const std::string& source,
                                      const sim2d::ForeignOptions& reading,
                                      const sim2d::TrackOptions& tracks,
                                      const bridge::BagUse& use = {}) {
  if (isRunFolder(source)) {
    return readRun(source);
  }
  if (bridge::isBag(source)) {
    return bridge::readBagTrace(source, use, tracks);
  }
  const base::Result<sim2d::TrackFile> file = sim2d::readForeign(source, reading);
  if (!file) {
    return file.diagnostics();
  }
  base::Result<sim2d::Trace> trace = sim2d::traceOfTracks(*file, tracks);
  base::Diagnostics told = file.diagnostics();
  base::append(told, trace.diagnostics());
  return trace ? base::Result<sim2d::Trace>(*std::move(trace), std::move(told))
               : base::Result<sim2d::Trace>(std::move(told));
}

/// Which robot of a run is measured: the one of the word, else every one.
void chooseRobot(const EvaluateOptions& options, const sim2d::TraceHeader& header,
                 metrics::Selection& selection, base::Diagnostics& wrong) {
  selection.everyRobot = options.robot.empty();
  if (!options.robot.empty() && isRunFolder(options.source)) {
    const base::Result<int> robot = robotOfWord(header, options.robot);
    base::append(wrong, robot.diagnostics());
    selection.robotId = robot ? *robot : selection.robotId;
  }
}

base::Diagnostics replaceMap(const EvaluateOptions& options, sim2d::Trace& trace) {
  if (options.map.empty()) {
    return {};
  }
  if (options.map == "none") {
    sim2d::setMap(trace, {});
    return {};
  }
  base::Result<sim2d::MapFile> file = readMapFile(options.map, "humble", loadMapImage);
  if (file) {
    sim2d::setMap(trace, std::move(file->grid));
  }
  return file.diagnostics();
}

/// Of a file whose only body is taken for a robot, with the goal and the step of the source.
base::Result<sim2d::Trace> readReferenceRun(const std::string& source,
                                            const sim2d::ForeignOptions& reading,
                                            sim2d::TrackOptions tracks) {
  base::Result<sim2d::Trace> trace = readSource(source, reading, {});
  const bool hasRobot = trace && !trace->header.robots.empty();
  const bool isAlone = trace && !hasRobot && trace->header.humans.size() == 1;
  if (isRunFolder(source) || (!hasRobot && !isAlone)) {
    return trace;
  }
  tracks.robotId = isAlone ? std::optional(trace->header.humans.front().id) : std::nullopt;
  return readSource(source, reading, tracks);
}

/// The way of a lone person, from the first instant; nothing when there are others.
std::optional<metrics::TimedWay> wayOfLonePerson(const sim2d::Trace& trace) {
  metrics::TimedWay way;
  double begin = 0.0;
  for (const sim2d::Frame& frame : trace.frames) {
    const sim2d::HumanColumns& humans = frame.humans;
    if (humans.size() > 1) {
      return std::nullopt;
    }
    begin = way.empty() ? frame.time : begin;
    if (humans.size() == 1) {
      way.emplace_back(frame.time - begin, base::Vec2(humans.x[0], humans.y[0]));
    }
  }
  return way;
}

/// The way of the robot in another run, measured as that of the source is.
base::Result<metrics::TimedWay> readReference(const std::string& source,
                                              const sim2d::ForeignOptions& reading,
                                              const sim2d::TrackOptions& tracks,
                                              const MetricsSetup& setup) {
  const base::Result<sim2d::Trace> trace = readReferenceRun(source, reading, tracks);
  if (!trace) {
    return trace.diagnostics();
  }
  const std::optional<metrics::TimedWay> way =
      trace->header.robots.empty() ? wayOfLonePerson(*trace)
                                   : metrics::wayOf(*trace, setup.selection, setup.parameters);
  if (!way || way->empty()) {
    return base::error(way ? "option.reference-empty" : "option.reference-people", {}, source);
  }
  return {*way, trace.diagnostics()};
}

constexpr const char* kWay[] = {"trajectory.csv", "events.csv", "trace.json"};

/// All that may be written.
std::vector<std::string> namesOfResults(const EvaluateOptions& options,
                                        const sim2d::TraceHeader& header) {
  std::vector<std::string> names = {"metrics.json", "steps.csv"};
  if (options.layout != "hunav2") {  // else rows are added to the table of this name
    names.emplace_back("metrics.csv");
  }
  const std::vector<std::string> robots = metrics::robotNames(header.robots);
  for (std::size_t k = 1; k < robots.size(); ++k) {
    names.push_back(metrics::robotFile("metrics", robots[k]));
    names.push_back(metrics::robotFile("steps", robots[k]));
  }
  if (!isRunFolder(options.source)) {
    names.insert(names.end(), std::begin(kWay), std::end(kWay));
  }
  return names;
}

/// Into the folder of the run itself, whose other files stay.
bool isIntoSource(const EvaluateOptions& options) {
  std::error_code ignored;
  return isRunFolder(options.source) && fs::equivalent(options.source, options.output, ignored);
}

/// The files that were read, but for that of the map's image.
std::vector<std::string> inputsOf(const EvaluateOptions& options) {
  std::vector<std::string> inputs;
  for (const std::string& read :
       {options.source, options.reference, options.map, options.metrics.metrics}) {
    if (isRunFolder(read)) {
      for (const char* name : kWay) {
        inputs.push_back((fs::path(read) / name).string());
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

std::string manifestOf(const EvaluateOptions& options, const Invocation& given,
                       base::Diagnostics& warnings) {
  const nlohmann::ordered_json json = {
      {"program", {{"version", programVersion()}, {"commit", programCommit()}}},
      {"kind", "evaluation"},
      {"command_line", given.words()},
      {"source", options.source},
      {"inputs", inputHashes<nlohmann::ordered_json>(inputsOf(options), warnings)}};
  return base::jsonText(json);
}

base::Diagnostics writeResults(const EvaluateOptions& options, const sim2d::Trace& trace,
                               const metrics::Evaluation& evaluation, OutputFolder& output,
                               const Invocation& given) {
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
  if (!isRunFolder(options.source)) {  // as a run, so that it can be drawn and measured again
    write("trajectory.csv", sim2d::trajectoryCsv(trace));
    write("events.csv", sim2d::eventsCsv(trace));
    write("trace.json", sim2d::traceJson(trace.header));
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  output.drop(namesOfResults(options, trace.header));
  const std::string manifest = manifestOf(options, given, problems);
  base::append(problems,
               output.commit(manifest, isIntoSource(options) ? OutputFolder::Earlier::Kept
                                                             : OutputFolder::Earlier::Removed));
  if (!options.layout.empty() && !base::hasErrors(problems)) {
    const auto files =
        metrics::writeEvaluatorFiles(evaluation, (fs::path(options.output) / "metrics").string(),
                                     isSecond ? metrics::Layout::Hunav2 : metrics::Layout::Hunav1);
    base::append(problems, files.diagnostics());
  }
  return problems;
}

/// Results of a run or a batch that `evaluate` would take away.
base::Diagnostics otherRun(const EvaluateOptions& options) {
  const std::string manifest = (fs::path(options.output) / "manifest.json").string();
  std::error_code ignored;  // what is not there is not lost
  if (!fs::exists(manifest, ignored) || isIntoSource(options) || options.force) {
    return {};
  }
  const base::Result<std::string> text = base::readTextFile(manifest);
  const auto json = nlohmann::json::parse(text ? *text : "", nullptr, false);
  return json.is_object() && json.value("kind", nlohmann::json()) == "evaluation"
             ? base::Diagnostics()
             : base::Diagnostics{base::error("file.other-run", {}, options.output)};
}

/// Files that are read and would be replaced by results of the same name.
base::Diagnostics lostInputs(const EvaluateOptions& options,
                             const std::vector<std::string>& written) {
  base::Diagnostics problems;
  for (const std::string& read :
       {options.source, options.reference, options.map, options.metrics.metrics}) {
    for (const std::string& name : written) {
      std::error_code ignored;  // what is not there is not lost
      const fs::path place = fs::path(options.output) / name;
      if (fs::is_regular_file(read, ignored) && fs::equivalent(read, place, ignored)) {
        problems.push_back(base::error("file.is-read", {}, read));
      }
    }
  }
  return problems;
}

/// Null when it cannot be written to, or would lose something: told.
std::unique_ptr<OutputFolder> openResults(const EvaluateOptions& options,
                                          const sim2d::TraceHeader& header,
                                          base::Diagnostics& problems) {
  std::vector<std::string> names = namesOfResults(options, header);
  if (options.layout == "hunav1") {
    names.emplace_back("metrics.yaml");
  }
  base::Diagnostics lost = otherRun(options);
  base::append(lost, lostInputs(options, names));
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
  lost = (*opened)->inTheWay(namesOfResults(options, header));
  base::append(problems, lost);
  return lost.empty() ? *std::move(opened) : nullptr;
}

int evaluateCommand(const EvaluateOptions& options, const Invocation& given) {
  base::Diagnostics wrong =
      isRunFolder(options.source) ? foreignWords(options) : base::Diagnostics();
  sim2d::ForeignOptions reading;
  sim2d::TrackOptions tracks;
  base::append(wrong, readForeignWords(options, reading, tracks));
  bridge::BagUse use;
  base::append(wrong, bagWords(options, use));
  requireFine(wrong, ExitWrongCommandLine);
  base::Result<sim2d::Trace> trace = readSource(options.source, reading, tracks, use);
  base::Diagnostics problems = trace.diagnostics();
  MetricsSetup setup;
  if (trace) {
    base::append(problems, replaceMap(options, *trace));
    base::append(problems, readMetricsSetup(trace->header, setup));
    chooseRobot(options, trace->header, setup.selection, wrong);
  }
  base::append(problems, chooseMetrics(options.metrics, setup, wrong));
  requireFine(wrong, ExitWrongCommandLine);
  if (!options.reference.empty()) {
    const auto reference = readReference(options.reference, reading, tracks, setup);
    base::append(problems, reference.diagnostics());
    if (reference) {
      setup.selection.reference = *reference;
    }
  }
  const std::unique_ptr<OutputFolder> output =
      openResults(options, trace ? trace->header : sim2d::TraceHeader(), problems);
  requireFine(problems, ExitBadInput, base::Severity::Warning);
  setup.selection.tag = options.tag.value_or(setup.selection.tag);
  setup.selection.runId = options.runId.value_or(setup.selection.runId);
  const base::Result<metrics::Evaluation> evaluation =
      metrics::evaluate(*trace, setup.selection, setup.parameters);
  requireFine(evaluation.diagnostics());
  requireFine(writeResults(options, *trace, *evaluation, *output, given));
  if (given.json) {
    print(metrics::toJson(*evaluation));
  } else if (!given.quiet) {
    print(base::visible(metrics::tableText(*evaluation), "\n"));
  }
  return ExitFine;
}

void addForeignOptions(CLI::App& command, EvaluateOptions& options) {
  command.add_option("--format", options.format, "Of a file of another program (by its name)")
      ->check(oneOf(sim2d::trackFormatNames()));
  command.add_option("--columns", options.columns, "Names of its columns: time=t,id=ped,x=px");
  command.add_option("--fps", options.framesPerSecond, "Frames per second of its frame numbers");
  command.add_option("--unit", options.unit, "Of its lengths: mm, cm, m, or metres per pixel");
  command.add_option("--time-unit", options.timeUnit, "Of its times: s, ms, us, ns")
      ->check(oneOf({"s", "ms", "us", "ns"}));
  command.add_flag("--degrees", options.degrees, "Its headings are in degrees (csv)");
  command.add_option("--radius", options.radius, "Of everybody in it [m]");
  command.add_option("--dt", options.step, "Step of the samples made of it [s]");
  command.add_option(
      "--robot", options.robot,
      "Of a run: name or number of the only robot to measure; else the id or word of "
      "the person who is the robot");
  command.add_option("--robot-goal", options.robotGoal, "\"X Y\" (m)");
  command.add_option("--topics", options.topics,
                     "Of a bag (MCAP, rosbag2): people=NAME,robot=NAME,map=NAME");
}

}  // namespace

void addEvaluate(CommandRegistry& commands) {
  const auto [command, options] =
      commands.add("evaluate", "Metrics of a recorded run, of a file or of a bag", evaluateCommand);
  command
      .add_option("source", options.source,
                  "Folder of a run, a trajectory file (-: standard input), or a bag: an "
                  "MCAP file, a .db3, a folder of rosbag2")
      ->required();
  addOutputFolder(command, options.output, "Folder for the results").required();
  command.add_option("--map", options.map, "Map instead of the recorded; none = open plane");
  addMetricsOptions(command, options.metrics);
  command.add_option("--tag", options.tag, "Tag in the result files");
  command.add_option("--run-id", options.runId, "Number of the run in the result files");
  command.add_option("--layout", options.layout, "Also the files of HuNavSim's evaluator")
      ->check(oneOf({"hunav2", "hunav1"}));
  command.add_option("--reference", options.reference,
                     "Run to compare the robot's way with: a folder, or a file with one body");
  addForeignOptions(command, options);
  addForce(command, options.force);
}

}  // namespace app
