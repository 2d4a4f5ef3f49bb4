#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "bt/engine/Program.h"
#include "bt/robot/NavigatorTopics.h"
#include "bt/robot/SubNavigation.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/params/Nav2Parameters.h"
#include "sim2d/nav/nav2/route/RouteGraph.h"

namespace bt {

/// Where the program's own parameter files and trees lie; empty: there are none.
struct Nav2Folders {
  std::string params;  // NAME.yaml
  std::string trees;   // humble/NAME.xml …
};

/// What drives when a robot names no parameter file: a shipped one.
constexpr const char* kUsualNav2Params = "generic";
constexpr const char* kUsualNav2Tree = "navigate_to_pose_w_replanning_and_recovery";
constexpr const char* kUsualThroughTree = "navigate_through_poses_w_replanning_and_recovery";

/// Which file counts: a path relative to `folder`, else the name of a shipped one ("turtlebot3").
/// Empty: there is none.
std::string nav2ParamsFile(const std::string& named, const std::string& folder,
                           const Nav2Folders& shipped);
/// The error where there is none.
base::Diagnostic noNav2ParamsFile(const std::string& named, const std::string& folder,
                                  const Nav2Folders& shipped);
/// The same of a tree that the user names; a path that is not there is looked for by its last part
/// among those shipped. Trees of the own branch come first.
std::string nav2TreeFile(const std::string& named, const std::string& folder,
                         sim2d::nav2::Distro distro, const Nav2Folders& shipped);

/// A navigator tree by itself: its nodes in that branch, ports, references.
struct NavigatorTree {
  std::shared_ptr<const Program> program;  // null: with errors
  bool isThroughPoses = false;             // it plans through several goals
  bool asksRoutes = false;                 // of the route server
  /// Trees that its nodes NavigateToPose and NavigateThroughPoses ask for, by the port
  /// behavior_tree; empty: the default one.
  std::set<std::string> toPose, throughPoses;
  base::Diagnostics problems;
};

/// Masks that filters of both costmaps name in `mask_file`, beside the parameter file. PGM alone.
struct Nav2Masks {
  sim2d::nav2::FilterMasks local, global;
  std::vector<std::string> files;  // that were read: YAML and images
  base::Diagnostics problems;
};
Nav2Masks loadNav2Masks(const sim2d::nav2::Nav2Parameters& parameters);

/// The graph that the route server names in graph_filepath.
struct Nav2Graph {
  sim2d::nav2::RouteGraph graph;  // empty: none is named, or it has errors
  std::string file;
  base::Diagnostics problems;
};
Nav2Graph loadNav2Graph(const sim2d::nav2::Nav2Parameters& parameters);

/// Motion primitives of planners (nav2_smac_planner::SmacPlannerLattice), whose file lies at
/// `lattice_filepath` or beside the parameter file. A planner without its file becomes Smac Hybrid,
/// with a warning.
struct Nav2Lattices {
  std::vector<std::string> files;  // that were read
  base::Diagnostics problems;
};
Nav2Lattices loadNav2Lattices(sim2d::nav2::Nav2Parameters& parameters);
/// A file of nav2_smac_planner's generator; error: values are missing or out of range.
base::Result<std::shared_ptr<const sim2d::nav2::Lattice>> readLattice(const std::string& file);

/// All that a robot's choice comes to.
struct Nav2Loaded {
  std::vector<std::string> paramsFiles;  // in the order in which they are read
  std::vector<std::string> overrides;    // single values over them: `name:=value`
  std::string treeFile;
  sim2d::nav2::Nav2Parameters parameters;
  std::shared_ptr<const Program> program;
  bool isThroughPoses = false;  // the tree plans through several goals
  std::string throughFile;      // drives several goals where no tree is chosen
  NavigatorTree through;
  NavigatorTrees subTrees;                // that nodes of the tree ask for
  std::vector<std::string> subTreeFiles;  // and their files
  NavigatorTopics topics;                 // what is published to the robot in the run
  Nav2Masks masks;
  Nav2Graph graph;
  std::vector<std::string> lattices;  // files of motion primitives that were read
  base::Diagnostics problems;         // of both files
  base::Diagnostics wrongValues;      // of the choice's values that no parameter fits
  bool ok() const {
    return !base::hasErrors(problems) && !base::hasErrors(wrongValues) && program != nullptr;
  }
};
/// The parameter files of `choice.params` read as one, with its single values; without a file the
/// shipped one. `robot`: its name, whose namespace counts first in the files.
Nav2Loaded loadNav2Parameters(const sim2d::Nav2Choice& choice, const std::string& folder,
                              const std::string& robot, const Nav2Folders& shipped);
/// With the tree.
Nav2Loaded loadNav2(const sim2d::Nav2Choice& choice, const std::string& folder,
                    const std::string& robot, const Nav2Folders& shipped);

/// A parameter of bt_navigator that names a tree, its value, and the shipped tree used without one.
struct TreeParameter {
  std::string name, value, usual;
};
/// The tree that a parameter of bt_navigator names, beside the parameter files (`findNamedFile`),
/// in `folder`, or among those shipped by its name; else the usual one, with a warning in
/// `problems`.
std::string nav2TreeOfParameter(const sim2d::nav2::Nav2Parameters& parameters,
                                const TreeParameter& parameter, const std::string& folder,
                                const Nav2Folders& shipped, base::Diagnostics& problems);

NavigatorTree loadNavigatorTree(const std::string& file,
                                const sim2d::nav2::Nav2Parameters& parameters);
/// Whether nodes of Nav2 are in the text of a tree.
bool looksLikeNavigatorTree(const std::string& xml);

}  // namespace bt
