#pragma once

#include <optional>
#include <string>

#include "app/bridge/bag/BagTrace.h"
#include "app/cli/Ros2Options.h"
#include "app/run/MetricsSetup.h"
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
  std::optional<double> framesPerSecond, step, radius;
  std::string topics;  // of a bag
  std::string robot;   // of a run: its robot; of a file: the id of the body that is the robot
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

}  // namespace app
