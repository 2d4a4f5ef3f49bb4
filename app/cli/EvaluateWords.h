#pragma once

#include <optional>
#include <string>

#include "app/bridge/bag/BagTrace.h"
#include "app/cli/Ros2Words.h"
#include "app/run/MetricsSetup.h"
#include "sim2d/trace/ForeignFiles.h"
#include "sim2d/trace/Tracks.h"

namespace app {

/// What is heard of a running system, in the folder of its results.
constexpr const char* kRecording = "recording.mcap";

/// Of `evaluate`, as given.
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
  Ros2Words ros2;  // a running system instead of a source
  std::string space = "/";
  bool byServices = false;         // recordings begin and end with the evaluator's services
  std::optional<double> duration;  // of one recording [s]
  std::string layoutFolder;        // for its files; empty: the output
  bool force = false;              // files of others in the output folder may be replaced
};

/// How the source is read.
struct EvaluateWords {
  sim2d::ForeignOptions reading;
  sim2d::TrackOptions tracks;
  bridge::BagUse use;
};

bool isRunFolder(const std::string& source);
/// A bag, or what will be one.
bool isBagSource(const EvaluateOptions& options);

/// Returns what is wrong with the words.
base::Diagnostics readWords(const EvaluateOptions& options, EvaluateWords& words);

}  // namespace app
