#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Nav2Block.h"
#include "sim2d/nav/nav2/costmap/CostmapParameters.h"
#include "sim2d/nav/nav2/global/GlobalPlanners.h"
#include "sim2d/nav/nav2/global/PathSmoother.h"
#include "sim2d/nav/nav2/params/BtNavigator.h"
#include "sim2d/nav/nav2/params/NodeReader.h"

/// A `nav2_params.yaml` as a whole: every server with its plugins.
namespace sim2d::nav2 {

/// A plugin whose parameters the one who makes it knows.
struct NamedPlugin {
  std::string name;    // "FollowPath"
  std::string plugin;  // "dwb_core::DWBLocalPlanner"
  Nav2Block block;
};

struct Nav2Parameters {
  std::string file;
  Distro distro = Distro::Jazzy;
  bool isGuessed = false;                  // from the file
  std::vector<std::string> distroReasons;  // of the guess

  CostmapSettings localCostmap, globalCostmap;
  PlannerServerParameters plannerServer;
  std::vector<std::pair<std::string, GlobalPlannerParameters>> planners;  // by name
  SmootherServerParameters smootherServer;
  std::vector<std::pair<std::string, PathSmootherParameters>> smoothers;
  BtNavigatorParameters btNavigator;

  ReadingNotes notes;  // of every key of the file; its problems are those of the result
};

struct Nav2ReadOptions {
  std::optional<Distro> distro;  // none: guessed
  std::string robot;             // its namespace counts before others
};

/// Everything at once: problems with line and column. With errors there is nothing to drive with,
/// and the notes are in the problems alone.
struct Nav2Reading {
  Nav2Parameters parameters;
  base::Diagnostics problems;
  bool ok() const { return !base::hasErrors(problems); }
};
Nav2Reading readNav2Parameters(const ParameterFile& file, const Nav2ReadOptions& options = {});

}  // namespace sim2d::nav2
