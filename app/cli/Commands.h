#pragma once

#include <string>
#include <vector>

#include "app/run/RunOptions.h"

/// The commands without a window. Each returns the exit code of the program.
namespace app {

int runCommand(const RunOptions& options, const OutputOptions& output,
               const std::vector<std::string>& commandLine);

struct CheckOptions {
  std::vector<std::string> files;
  std::string map, trees;
};
int checkCommand(const CheckOptions& options, const OutputOptions& output);

struct ListOptions {
  std::string what;             // nodes, metrics, models, robots, planners, scenarios
  std::string format = "text";  // text, json; xml for nodes, markdown for metrics
};
int listCommand(const ListOptions& options, const OutputOptions& output);

struct EvaluateOptions {
  std::string source;  // folder of a run, or a file of another program
  std::string output;
  std::string map;  // instead of the record's; "none" = open plane
  std::string metrics, metricsProfile = "corrected";
  std::optional<std::string> tag;
  std::optional<int> runId;
  std::string layout;     // hunav2 (v2), hunav1 (v1): the evaluator's own files too
  std::string reference;  // run to compare the robot's way with: folder, or a file with one body
  // of files of other programs
  std::string format, columns;
  std::optional<double> framesPerSecond, step;
  std::optional<int> robot;
  std::optional<std::string> robotGoal;
};
int evaluateCommand(const EvaluateOptions& options, const OutputOptions& output);

struct RenderOptions {
  std::string run;     // folder of a run
  std::string output;  // picture
};
int renderCommand(const RenderOptions& options, const OutputOptions& output);

struct TreesOptions {
  std::string scenario;             // whose trees are made, or empty
  std::string output;               // -o; empty: printed
  std::string style = "corrected";  // corrected, hunav2
  std::string play;                 // tree file to play, or empty
  std::string script;               // what its leaves answer; empty: SUCCESS
  int ticks = 10;
  double dt = 0.05;  // [s]
  long long seed = 1;
  std::string compat;  // quirks of the original while playing
};
int treesCommand(const TreesOptions& options, const OutputOptions& output);

struct ConvertOptions {
  std::string scenario;
  std::string output;               // folder
  std::string target;               // name of exportTargets()
  std::string dialect;              // B, C; empty: the target's
  std::string style = "corrected";  // of trees that are made: corrected, hunav2
  std::string map, trees;
};
int convertCommand(const ConvertOptions& options, const OutputOptions& output);

struct BatchOptions {
  std::string experiment;
  std::string output;
  int jobs = 0;  // 0 = number of cores
};
int batchCommand(const BatchOptions& options, const OutputOptions& output);

struct BenchOptions {
  bool quick = false;  // small crowds, short
  int threads = 1;
  std::string format = "text";  // text, csv
  std::string picture;          // file to draw it into, or empty
};
int benchCommand(const BenchOptions& options, const OutputOptions& output);

struct ValidateOptions {
  std::vector<std::string> names;  // of realism tests; empty: all
  std::vector<std::string> models = {"sfm", "das"};
  std::string output;  // folder, or empty
  int seeds = 10;
};
/// Failed when a quantity is outside its limits.
int validateCommand(const ValidateOptions& options, const OutputOptions& output);

/// Options of the window beside those of `run`.
struct WindowOptions {
  std::string screenshot;          // picture to save; empty: stay open
  double at = 5.0;                 // simulated time of the picture [s]
  std::string size;                // "1280x800"; empty: as last used, 1280x800 for a picture
  double scale = 1.0;              // pixels per point of the picture
  std::string theme;               // "light", "dark"; empty: the system's
  std::vector<std::string> docks;  // shown; empty: as last used
};

}  // namespace app
