#include <algorithm>
#include <functional>
#include <string_view>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "app/cli/Console.h"
#include "app/cli/Evaluate.h"
#include "app/run/Bundle.h"
#include "app/run/MetricsSetup.h"
#include "app/run/RunFolder.h"
#include "metrics/MetricRegistry.h"
#include "metrics/Report.h"
#include "metrics/RunResults.h"
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

/// `points`: receives the obstacle points of the source.
base::Result<sim2d::Trace> readSource(const std::string& source,
                                      const sim2d::TrackImportOptions& reading,
                                      const sim2d::TrackOptions& tracks,
                                      const bridge::BagTopicOptions& use = {},
                                      sim2d::RecordedPoints* points = nullptr) {
  if (isRunFolder(source)) {
    return points == nullptr ? readRun(source) : readRunWithPoints(source, *points);
  }
  if (bridge::isBag(source)) {
    return bridge::readBagTrace(source, use, tracks, points);
  }
  const base::Result<sim2d::TrackFile> file = sim2d::importTracks(source, reading);
  if (!file) {
    return file.diagnostics();
  }
  base::Result<sim2d::Trace> trace = sim2d::traceOfTracks(*file, tracks);
  base::Diagnostics problems = file.diagnostics();
  base::append(problems, trace.diagnostics());
  return trace ? base::resultOf(*std::move(trace), std::move(problems)) : problems;
}

/// Selects the robot of a run: the one given, otherwise all.
void chooseRobot(const EvaluateOptions& options, const sim2d::TraceHeader& header,
                 metrics::Selection& selection, base::Diagnostics& wrong) {
  selection.everyRobot = options.robot.empty();
  if (!options.robot.empty() && isRunFolder(options.source)) {
    const base::Result<int> robot = robotIdOf(header, options.robot);
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

/// If the only body of a file is an agent, it is read as a robot, with the goal and step of the
/// source.
base::Result<sim2d::Trace> readReferenceRun(const std::string& source,
                                            const sim2d::TrackImportOptions& reading,
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

/// The trajectory of the only agent, with time from 0; nullopt if there are several.
std::optional<metrics::TimedPath> trajectoryOfOnlyAgent(const sim2d::Trace& trace) {
  metrics::TimedPath way;
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

/// The path of the robot in another run, measured as in the source.
base::Result<metrics::TimedPath> readReference(const std::string& source,
                                               const sim2d::TrackImportOptions& reading,
                                               const sim2d::TrackOptions& tracks,
                                               const MetricsSetup& setup) {
  const base::Result<sim2d::Trace> trace = readReferenceRun(source, reading, tracks);
  if (!trace) {
    return trace.diagnostics();
  }
  const std::optional<metrics::TimedPath> way =
      trace->header.robots.empty()
          ? trajectoryOfOnlyAgent(*trace)
          : metrics::robotPathOf(*trace, setup.selection, setup.parameters);
  if (!way || way->empty()) {
    return base::error(way ? "option.reference-empty" : "option.reference-people", {}, source);
  }
  return {*way, trace.diagnostics()};
}

/// The recording with the settings of its evaluation.
struct PreparedSource {
  base::Result<sim2d::Trace> trace = base::error("bag.no-bag");  // until it is read
  sim2d::RecordedPoints points;                                  // from the source
  MetricsSetup setup;
  base::Diagnostics problems;
};

PreparedSource prepare(const EvaluateOptions& options) {
  SourceOptions parsed;
  base::Diagnostics wrong = parseEvaluateOptions(options, parsed);
  requireFine(wrong, ExitWrongCommandLine);
  PreparedSource made;
  made.trace = readSource(options.source, parsed.reading, parsed.tracks, parsed.use, &made.points);
  made.problems = made.trace.diagnostics();
  if (made.trace) {
    base::append(made.problems, replaceMap(options, *made.trace));
    base::append(made.problems, readMetricsSetup(made.trace->header, made.setup));
    chooseRobot(options, made.trace->header, made.setup.selection, wrong);
  }
  base::append(made.problems, applyMetricsOptions(options.metrics, made.setup, wrong));
  requireFine(wrong, ExitWrongCommandLine);
  if (made.trace && isBagSource(options)) {
    base::append(made.problems,
                 missingInputs(*made.trace, made.points, made.setup, options.source));
  }
  if (!options.reference.empty()) {
    const auto reference =
        readReference(options.reference, parsed.reading, parsed.tracks, made.setup);
    base::append(made.problems, reference.diagnostics());
    if (reference) {
      made.setup.selection.reference = *reference;
    }
  }
  made.setup.selection.tag = options.tag.value_or(made.setup.selection.tag);
  made.setup.selection.runId = options.runId.value_or(made.setup.selection.runId);
  return made;
}

void measure(const EvaluateOptions& options, const PreparedSource& prepared, OutputFolder& output,
             const Invocation& given) {
  const base::Result<metrics::Evaluation> evaluation = metrics::evaluate(
      *prepared.trace, prepared.points, prepared.setup.selection, prepared.setup.parameters);
  requireFine(evaluation.diagnostics());
  requireFine(
      writeEvaluation(options, {*prepared.trace, prepared.points}, *evaluation, output, given));
  if (given.json) {
    print(metrics::toJson(*evaluation));
  } else if (!given.quiet) {
    print(base::escapedControls(metrics::tableText(*evaluation), "\n"));
  }
}

}  // namespace

void evaluateSource(const EvaluateOptions& options, const Invocation& given) {
  PreparedSource prepared = prepare(options);
  const std::unique_ptr<OutputFolder> output = openEvaluation(
      options, prepared.trace ? prepared.trace->header : sim2d::TraceHeader(), prepared.problems);
  requireFine(prepared.problems, ExitBadInput, base::Severity::Warning);
  measure(options, prepared, *output, given);
}

void evaluateRecording(const EvaluateOptions& options, OutputFolder& output,
                       const Invocation& given) {
  const PreparedSource prepared = prepare(options);
  requireFine(output.withFinalPaths(prepared.problems), ExitBadInput, base::Severity::Warning);
  measure(options, prepared, output, given);
}

namespace {

using metrics::MetricInfo;

constexpr char kRecorded[] = "recorded";  // model of pedestrians, type of the robot

bool isForeign(const sim2d::TraceHeader& header) {
  const bool hasPeople =
      std::any_of(header.humans.begin(), header.humans.end(),
                  [](const sim2d::TraceHuman& human) { return human.model == kRecorded; });
  return hasPeople || (!header.robots.empty() && header.robots.front().type == kRecorded);
}

bool hasOutlines(const sim2d::TraceHeader& header) {
  return !header.map.isEmpty() ||
         std::any_of(header.obstacles.begin(), header.obstacles.end(),
                     [](const sim2d::TraceObstacle& each) { return !each.outlines.empty(); });
}

/// Whether any pedestrian has a social force factor.
bool hasFactors(const std::vector<sim2d::TraceHuman>& humans) {
  return std::any_of(humans.begin(), humans.end(), [](const sim2d::TraceHuman& human) {
    return std::any_of(human.parameters.begin(), human.parameters.end(),
                       [](const auto& each) { return each.first == "social_force_factor"; });
  });
}

bool isKey(const MetricInfo& info, std::string_view key) {
  return info.key == key || info.partOf == key;
}

/// An input of metrics that a foreign recording may lack, and the warning that names the metrics.
struct MetricInput {
  bool isMissing;
  const char* code;
  std::function<bool(const MetricInfo&)> isNeeded;
};

std::vector<MetricInput> metricInputs(const sim2d::TraceHeader& header,
                                      const sim2d::RecordedPoints& points,
                                      metrics::Profile profile) {
  const bool hasRobot = !header.robots.empty(), hasPeople = !header.humans.empty();
  const bool hasWalls = hasOutlines(header);
  const bool usesFactors = profile == metrics::Profile::Corrected;
  return {{hasPeople && !points.hasPeople(),
           hasWalls ? "bag.points-of-walls" : "bag.no-obstacles-of-people",
           [](const MetricInfo& info) { return info.needs.obstacles && !info.needs.robot; }},
          // Where obstacle points are computed from walls, only the forces lack the recorded ones.
          {hasRobot && !points.hasRobot(),
           hasWalls ? "bag.points-of-walls" : "bag.no-obstacles-of-robot",
           [hasWalls](const MetricInfo& info) {
             const bool isForce =
                 isKey(info, "obstacle_force_on_robot") || isKey(info, "social_work");
             return info.needs.obstacles && info.needs.robot && (!hasWalls || isForce);
           }},
          {hasRobot && header.map.isEmpty(), "bag.no-map",
           [](const MetricInfo& info) { return info.needs.map; }},
          {hasRobot && header.robots.front().goals.empty(), "bag.no-goal",
           [](const MetricInfo& info) { return info.needs.goal; }},
          {usesFactors && hasRobot && hasPeople && !hasFactors(header.humans), "bag.no-factors",
           [](const MetricInfo& info) {
             return isKey(info, "social_force_on_agents") || isKey(info, "social_work");
           }},
          {hasRobot, "bag.no-replans",
           [](const MetricInfo& info) { return isKey(info, "replanning_count"); }}};
}

}  // namespace

base::Diagnostics missingInputs(const sim2d::Trace& trace, const sim2d::RecordedPoints& points,
                                const MetricsSetup& setup, const std::string& source) {
  if (!isForeign(trace.header)) {
    return {};
  }
  const std::vector<metrics::MetricEntry> entries =
      setup.selection.entries(metrics::standardRegistry());
  base::Diagnostics missing;
  for (const MetricInput& input : metricInputs(trace.header, points, setup.parameters.profile)) {
    std::vector<std::string> keys;
    for (const metrics::MetricEntry& entry : entries) {
      if (input.isMissing && input.isNeeded(entry.info)) {
        keys.push_back(entry.info.key);
      }
    }
    if (!keys.empty()) {
      missing.push_back(base::warning(input.code, {base::join(keys, ", ")}, source));
    }
  }
  return missing;
}

}  // namespace app
