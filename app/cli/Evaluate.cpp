#include <filesystem>

#include "app/cli/CommandLine.h"
#include "app/cli/Commands.h"
#include "app/cli/Console.h"
#include "app/run/Manifest.h"
#include "app/run/MetricsChoice.h"
#include "app/run/Preparation.h"
#include "editor/document/QtImageLoader.h"
#include "metrics/ReportFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/ForeignFiles.h"

namespace app {

namespace {

namespace fs = std::filesystem;

bool isRunFolder(const std::string& source) {
  std::error_code ignored;
  return fs::is_directory(source, ignored);
}

/// Words that only mean something for files of other programs.
base::Diagnostics foreignWords(const EvaluateOptions& options) {
  base::Diagnostics wrong;
  const auto refuse = [&](bool given, const char* word) {
    if (given) {
      wrong.push_back(base::makeError(std::string(word) +
                                      " is for files of other programs, not for the folder of a "
                                      "run"));
    }
  };
  refuse(!options.format.empty(), "--format");
  refuse(!options.columns.empty(), "--columns");
  refuse(options.framesPerSecond.has_value(), "--fps");
  refuse(options.step.has_value(), "--dt");
  refuse(options.robot.has_value(), "--robot");
  refuse(options.robotGoal.has_value(), "--robot-goal");
  return wrong;
}

struct ForeignWords {
  sim2d::ForeignOptions reading;
  sim2d::TrackOptions tracks;
};

base::Result<ForeignWords> foreignOptionsOf(const EvaluateOptions& options) {
  ForeignWords words;
  base::Diagnostics wrong;
  if (!options.format.empty()) {
    words.reading.format = sim2d::foreignFormatOf(options.format);  // checked by the parser
  }
  if (!options.columns.empty()) {
    const auto columns = sim2d::parseColumns(options.columns);
    base::append(wrong, columns.diagnostics());
    if (columns) {
      words.reading.columns = *columns;
    }
  }
  const auto positive = [&wrong](const std::optional<double>& value, const char* word) {
    if (value && !(*value > 0.0 && *value <= 1e6)) {
      wrong.push_back(base::makeError(std::string(word) + " takes a number above 0"));
    }
    return value.value_or(0.0);
  };
  words.reading.framesPerSecond = positive(options.framesPerSecond, "--fps");
  words.tracks.step = positive(options.step, "--dt");
  words.tracks.robotId = options.robot;
  if (options.robotGoal) {
    const std::optional<std::vector<double>> goal = parseNumbers(*options.robotGoal, 2);
    if (goal) {
      words.tracks.robotGoal = base::Vec2((*goal)[0], (*goal)[1]);
    } else {
      wrong.push_back(base::makeError("--robot-goal takes two numbers: \"X Y\" (m), not \"" +
                                      *options.robotGoal + "\""));
    }
  }
  if (!wrong.empty()) {
    return wrong;
  }
  return words;
}

base::Result<sim2d::Trace> readSource(const std::string& source,
                                      const sim2d::ForeignOptions& reading,
                                      const sim2d::TrackOptions& tracks) {
  if (isRunFolder(source)) {
    std::error_code ignored;
    if (fs::exists(fs::path(source) / "trajectory.csv", ignored) &&
        !fs::exists(fs::path(source) / "trace.json", ignored)) {
      return base::makeError("a run was not written to its end here: trace.json is missing",
                             source);
    }
    return sim2d::readTrace(source);
  }
  const base::Result<sim2d::TrackFile> file = sim2d::readForeign(source, reading);
  return file ? sim2d::traceOfTracks(*file, tracks)
              : base::Result<sim2d::Trace>(file.diagnostics());
}

base::Diagnostics replaceMap(const EvaluateOptions& options, sim2d::Trace& trace) {
  if (options.map.empty()) {
    return {};
  }
  if (options.map == "none") {
    sim2d::setMap(trace, {});
    return {};
  }
  base::Result<sim2d::MapFile> file = readMapFile(options.map, "humble", editor::loadMapImage);
  if (file) {
    sim2d::setMap(trace, std::move(file->grid));
  }
  return file.diagnostics();
}

/// The way of the robot in a recorded run, from its first instant.
base::Result<std::vector<std::pair<double, base::Vec2>>> readReference(
    const std::string& source, const sim2d::ForeignOptions& reading) {
  const base::Result<sim2d::Trace> trace = readSource(source, reading, {});
  if (!trace) {
    return trace.diagnostics();
  }
  std::vector<std::pair<double, base::Vec2>> way;
  for (const sim2d::Frame& frame : trace->frames) {
    const sim2d::RobotColumns& robots = frame.robots;
    const sim2d::HumanColumns& humans = frame.humans;
    if (robots.size() > 0) {
      way.emplace_back(frame.time, base::Vec2(robots.x[0], robots.y[0]));
    } else if (humans.size() == 1) {
      way.emplace_back(frame.time, base::Vec2(humans.x[0], humans.y[0]));
    } else if (humans.size() > 1) {
      return base::makeError("a reference has a robot or one body, not several people", source);
    }
  }
  if (way.empty()) {
    return base::makeError("there is no robot in the reference", source);
  }
  for (std::size_t k = way.size(); k > 0; --k) {
    way[k - 1].first -= way.front().first;
  }
  return way;
}

bool isSecondLayout(const EvaluateOptions& options) {
  return options.layout == "hunav2";
}

class ResultFolder {
 public:
  explicit ResultFolder(std::string folder) : folder_(std::move(folder)) {}

  void write(const char* name, const std::string& content) {
    base::append(problems_,
                 base::writeFileAtomically((fs::path(folder_) / name).string(), content));
  }
  base::Diagnostics writeAll(const EvaluateOptions& options, const sim2d::Trace& trace,
                             const metrics::Evaluation& evaluation) {
    write("metrics.json", metrics::toJson(evaluation));
    if (!isSecondLayout(options)) {  // else rows are added to the table of this name
      write("metrics.csv", metrics::metricsCsv(evaluation));
    }
    write("steps.csv", metrics::stepsCsv(evaluation));
    if (!isRunFolder(options.source)) {  // as a run, so that it can be drawn and measured again
      write("trajectory.csv", sim2d::trajectoryCsv(trace));
      write("events.csv", sim2d::eventsCsv(trace));
      write("trace.json", sim2d::traceJson(trace.header));
    }
    if (!options.layout.empty() && problems_.empty()) {
      const metrics::Layout layout =
          isSecondLayout(options) ? metrics::Layout::Hunav2 : metrics::Layout::Hunav1;
      const auto files = metrics::writeEvaluatorFiles(
          evaluation, (fs::path(folder_) / "metrics").string(), layout);
      base::append(problems_, files.diagnostics());
    }
    return problems_;
  }

 private:
  std::string folder_;
  base::Diagnostics problems_;
};

}  // namespace

int evaluateCommand(const EvaluateOptions& options, const OutputOptions& output) {
  base::Diagnostics wrong =
      isRunFolder(options.source) ? foreignWords(options) : base::Diagnostics();
  const base::Result<ForeignWords> words = foreignOptionsOf(options);
  base::append(wrong, words.diagnostics());
  if (base::hasErrors(wrong)) {
    printDiagnostics(wrong);
    return kWrongCommandLine;
  }
  base::Result<sim2d::Trace> trace = readSource(options.source, words->reading, words->tracks);
  base::Diagnostics problems = trace.diagnostics();
  if (trace) {
    base::append(problems, replaceMap(options, *trace));
  }
  MetricsSetup setup;
  if (trace) {
    base::append(problems, readMetricsSetup(trace->header, setup));
  }
  base::append(problems, chooseMetrics({options.metrics, options.metricsProfile}, setup, wrong));
  if (base::hasErrors(wrong)) {
    printDiagnostics(wrong);
    return kWrongCommandLine;
  }
  if (!options.reference.empty()) {
    const auto reference = readReference(options.reference, words->reading);
    base::append(problems, reference.diagnostics());
    if (reference) {
      setup.selection.reference = *reference;
    }
  }
  base::append(problems, checkWritableFolder(options.output));
  printDiagnostics(problems, base::Severity::Warning);
  if (base::hasErrors(problems)) {
    return kBadInput;
  }
  setup.selection.tag = options.tag.value_or(setup.selection.tag);
  setup.selection.runId = options.runId.value_or(setup.selection.runId);
  const base::Result<metrics::Evaluation> evaluation =
      metrics::evaluate(*trace, setup.selection, setup.parameters);
  printDiagnostics(evaluation.diagnostics());
  if (!evaluation) {
    return kBadInput;
  }
  const base::Diagnostics unwritten =
      ResultFolder(options.output).writeAll(options, *trace, *evaluation);
  printDiagnostics(unwritten);
  if (base::hasErrors(unwritten)) {
    return kBadInput;
  }
  if (output.json) {
    print(metrics::toJson(*evaluation));
  } else if (!output.quiet) {
    print(metrics::tableText(*evaluation));
  }
  return kFine;
}

}  // namespace app
