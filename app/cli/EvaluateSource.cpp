#include "app/cli/EvaluateSource.h"

#include "app/bridge/bag/Bag.h"
#include "app/cli/Console.h"
#include "app/cli/EvaluateResults.h"
#include "app/cli/MapImages.h"
#include "app/cli/MissingInputs.h"
#include "app/run/Bundle.h"
#include "app/run/MetricsSetup.h"
#include "app/run/RunFolder.h"
#include "metrics/RecordedObstacles.h"
#include "metrics/ReportFiles.h"
#include "metrics/RobotPlaces.h"
#include "sim2d/base/Text.h"

namespace app {
namespace {

base::Result<sim2d::Trace> readRunWithPoints(const std::string& folder,
                                             sim2d::RecordedPoints& points) {
  base::Result<sim2d::RecordedPoints> read = sim2d::readRecordedPoints(folder);
  if (!read) {
    return read.diagnostics();
  }
  points = *std::move(read);
  return readRun(folder);
}

/// `points`: takes the obstacle points that the source gives.
base::Result<sim2d::Trace> readSource(const std::string& source,
                                      const sim2d::ForeignOptions& reading,
                                      const sim2d::TrackOptions& tracks,
                                      const bridge::BagUse& use = {},
                                      sim2d::RecordedPoints* points = nullptr) {
  if (isRunFolder(source)) {
    return points == nullptr ? readRun(source) : readRunWithPoints(source, *points);
  }
  if (bridge::isBag(source)) {
    return bridge::readBagTrace(source, use, tracks, points);
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

/// All that is measured, and how.
struct Prepared {
  base::Result<sim2d::Trace> trace = base::error("bag.no-bag");  // until it is read
  sim2d::RecordedPoints points;                                  // that the source gives
  MetricsSetup setup;
  base::Diagnostics problems;
};

Prepared prepare(const EvaluateOptions& options) {
  EvaluateWords words;
  base::Diagnostics wrong = readWords(options, words);
  requireFine(wrong, ExitWrongCommandLine);
  Prepared made;
  made.trace = readSource(options.source, words.reading, words.tracks, words.use, &made.points);
  made.problems = made.trace.diagnostics();
  if (made.trace) {
    base::append(made.problems, replaceMap(options, *made.trace));
    base::append(made.problems, readMetricsSetup(made.trace->header, made.setup));
    chooseRobot(options, made.trace->header, made.setup.selection, wrong);
  }
  base::append(made.problems, chooseMetrics(options.metrics, made.setup, wrong));
  requireFine(wrong, ExitWrongCommandLine);
  if (made.trace && isBagSource(options)) {
    base::append(made.problems,
                 missingInputs(*made.trace, made.points, made.setup, options.source));
  }
  if (!options.reference.empty()) {
    const auto reference =
        readReference(options.reference, words.reading, words.tracks, made.setup);
    base::append(made.problems, reference.diagnostics());
    if (reference) {
      made.setup.selection.reference = *reference;
    }
  }
  made.setup.selection.tag = options.tag.value_or(made.setup.selection.tag);
  made.setup.selection.runId = options.runId.value_or(made.setup.selection.runId);
  return made;
}

void measure(const EvaluateOptions& options, const Prepared& prepared, OutputFolder& output,
             const Invocation& given) {
  const base::Result<metrics::Evaluation> evaluation = metrics::evaluate(
      *prepared.trace, prepared.points, prepared.setup.selection, prepared.setup.parameters);
  requireFine(evaluation.diagnostics());
  requireFine(
      writeEvaluation(options, {*prepared.trace, prepared.points}, *evaluation, output, given));
  if (given.json) {
    print(metrics::toJson(*evaluation));
  } else if (!given.quiet) {
    print(base::visible(metrics::tableText(*evaluation), "\n"));
  }
}

}  // namespace

void evaluateSource(const EvaluateOptions& options, const Invocation& given) {
  Prepared prepared = prepare(options);
  const std::unique_ptr<OutputFolder> output = openEvaluation(
      options, prepared.trace ? prepared.trace->header : sim2d::TraceHeader(), prepared.problems);
  requireFine(prepared.problems, ExitBadInput, base::Severity::Warning);
  measure(options, prepared, *output, given);
}

void evaluateRecording(const EvaluateOptions& options, OutputFolder& output,
                       const Invocation& given) {
  const Prepared prepared = prepare(options);
  requireFine(output.atTheirPlaces(prepared.problems), ExitBadInput, base::Severity::Warning);
  measure(options, prepared, output, given);
}

}  // namespace app
