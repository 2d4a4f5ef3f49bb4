#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/bridge/bag/BagTrace.h"
#include "app/cli/CommandRegistry.h"
#include "app/run/MetricsSetup.h"
#include "app/run/OutputFolder.h"
#include "metrics/Report.h"
#include "sim2d/trace/RecordedPoints.h"
#include "sim2d/trace/Trace.h"
#include "sim2d/trace/TrackImport.h"
#include "sim2d/trace/Tracks.h"

namespace app {

/// The recording of a running system, in the folder of its results.
constexpr const char* kRecording = "recording.mcap";

/// The command-line options of `evaluate`.
struct EvaluateOptions {
  std::string source;  // run folder, or a third-party file
  std::string output;
  std::string map;  // overrides the recorded map; "none" = open plane
  MetricsOptions metrics;
  std::optional<std::string> tag;
  std::optional<int> runId;
  std::string layout;     // hunav2 (v2), hunav1 (v1): also write the evaluator's own files
  std::string reference;  // run to compare the robot's path with: folder, or a file with one body
  // For third-party files.
  std::string format, columns;
  std::string unit, timeUnit;
  bool degrees = false;
  std::optional<double> framesPerSecond, step, radius;  // [1/s], [s], [m]
  std::string topics;                                   // of a bag
  std::string robot;  // of a run: its robot; of a file: the id of the body that is the robot
  std::optional<std::string> robotGoal;
  Ros2Options ros2;  // a running system instead of a source
  std::string space = "/";
  bool byServices = false;         // the evaluator's services start and stop recordings
  std::optional<double> duration;  // of one recording [s]
  std::string layoutFolder;        // for the evaluator's files; empty: output
  bool force = false;              // overwrite files not created by hunavsim
};

/// How to read the source.
struct SourceOptions {
  sim2d::TrackImportOptions reading;
  sim2d::TrackOptions tracks;
  bridge::BagTopicOptions use;
};

bool isRunFolder(const std::string& source);
/// A bag, or a recording that becomes one.
bool isBagSource(const EvaluateOptions& options);

/// Parses the options; returns the invalid ones.
base::Diagnostics parseEvaluateOptions(const EvaluateOptions& options, SourceOptions& parsed);

/// Opens the output folder. Null if it is not writable or files would be lost; see `problems`.
std::unique_ptr<OutputFolder> openEvaluation(const EvaluateOptions& options,
                                             const sim2d::TraceHeader& header,
                                             base::Diagnostics& problems);

/// The manifest of the evaluation.
std::string manifestOf(const EvaluateOptions& options, const Invocation& given,
                       base::Diagnostics& warnings);

/// The evaluated recording.
struct Measured {
  const sim2d::Trace& trace;
  const sim2d::RecordedPoints& points;  // from the source of the recording
};

/// Writes all result files.
base::Diagnostics writeEvaluation(const EvaluateOptions& options, const Measured& measured,
                                  const metrics::Evaluation& evaluation, OutputFolder& output,
                                  const Invocation& given);

/// Reads the source with its additional inputs, evaluates it, writes and prints the results. Throws
/// CommandEnd on errors.
void evaluateSource(const EvaluateOptions& options, const Invocation& given);

/// Evaluates a bag that was recorded in the staging folder of `output`.
void evaluateRecording(const EvaluateOptions& options, OutputFolder& output,
                       const Invocation& given);

/// Inputs of the selected metrics that a third-party recording does not contain: one warning for
/// each missing input, with the keys of the metrics that need it. Empty for a run of hunavsim.
base::Diagnostics missingInputs(const sim2d::Trace& trace, const sim2d::RecordedPoints& points,
                                const MetricsSetup& setup, const std::string& source);

/// Records agents and a robot from a running ROS 2 system and evaluates them: one recording until
/// Ctrl-C, its time limit or hunav_stop_recording; or one per pair of service calls, each in its
/// own folder. A recording is kept even if it cannot be evaluated.
int evaluateLive(const EvaluateOptions& options, const Invocation& given);

}  // namespace app
