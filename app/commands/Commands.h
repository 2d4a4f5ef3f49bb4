#pragma once

#include <string>
#include <vector>

#include "app/RunOptions.h"

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
  std::string format = "text";  // text, json; xml for nodes
};
int listCommand(const ListOptions& options, const OutputOptions& output);

struct RenderOptions {
  std::string run;     // folder of a run
  std::string output;  // picture
};
int renderCommand(const RenderOptions& options, const OutputOptions& output);

struct BatchOptions {
  std::string experiment;
  std::string output;
  int jobs = 0;  // 0 = number of cores
};
int batchCommand(const BatchOptions& options, const OutputOptions& output);

}  // namespace app
