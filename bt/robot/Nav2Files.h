#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bt/engine/Program.h"
#include "bt/robot/NavigatorHost.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/params/Nav2Parameters.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"
#include "sim2d/nav/nav2/route/RouteGraph.h"

namespace bt {

struct Nav2Latencies;
struct Nav2Statistics;

/// Folders of the shipped parameter files and trees; empty: none.
struct Nav2Folders {
  std::string params;  // NAME.yaml
  std::string trees;   // humble/NAME.xml …
};

/// Shipped trees that are used for robots that name none.
constexpr const char* kDefaultNav2Tree = "navigate_to_pose_w_replanning_and_recovery";
constexpr const char* kDefaultThroughPosesTree = "navigate_through_poses_w_replanning_and_recovery";

/// The planner `nav2`: the user's nav2_params.yaml and navigator tree, without ROS. In each step
/// the costmaps process the scan, the tree is ticked once, then the servers run.
///
/// A new goal of the scenario halts the current run of the tree and starts a new one. A run ends
/// with SUCCESS or FAILURE of the tree (`Planner::takeNavigationResult`), regardless of the robot's
/// position; a route through several goals ends as a whole.
void addNav2(sim2d::PlannerRegistry& to, const Nav2Folders& shipped);

/// Compiled trees that the nodes NavigateToPose and NavigateThroughPoses of a robot's tree request.
struct NavigatorTrees {
  std::map<std::string, std::shared_ptr<const Program>>
      byName;                                           // by value of the port behavior_tree
  std::shared_ptr<const Program> toPose, throughPoses;  // for an empty port

  /// Null: not loaded.
  std::shared_ptr<const Program> find(RobotAction action, const std::string& name) const;
};

/// A navigator tree, checked for its distribution: nodes, ports, references.
struct NavigatorTree {
  std::shared_ptr<const Program> program;  // null: errors
  bool isThroughPoses = false;             // plans through several goals
  bool usesRouteServer = false;            // uses the route server
  /// Trees requested by its nodes NavigateToPose and NavigateThroughPoses in the port
  /// behavior_tree; empty: the default one.
  std::set<std::string> toPose, throughPoses;
  base::Diagnostics problems;
};

/// Filter masks of both costmaps, from `mask_file`, relative to the parameter file. PGM only.
struct Nav2Masks {
  sim2d::nav2::FilterMasks local, global;
  std::vector<std::string> files;  // files read: YAML and images
  base::Diagnostics problems;
};
Nav2Masks loadNav2Masks(const sim2d::nav2::Nav2Parameters& parameters);

/// The graph that the route server names in graph_filepath.
struct Nav2RouteGraph {
  sim2d::nav2::RouteGraph graph;  // empty: none named, or errors
  std::string file;
  base::Diagnostics problems;
};
Nav2RouteGraph loadNav2RouteGraph(const sim2d::nav2::Nav2Parameters& parameters);

/// Motion primitives of planners (nav2_smac_planner::SmacPlannerLattice), read from
/// `lattice_filepath` or relative to the parameter file. A planner whose file is missing is
/// replaced by Smac Hybrid, with a warning.
struct Nav2Lattices {
  std::vector<std::string> files;  // files read
  base::Diagnostics problems;
};
Nav2Lattices loadNav2Lattices(sim2d::nav2::Nav2Parameters& parameters);

/// All files and values of a robot's Nav2 choice.
struct Nav2Loaded {
  std::vector<std::string> paramsFiles;  // in reading order
  std::vector<std::string> overrides;    // single values applied on top: `name:=value`
  std::string treeFile;
  sim2d::nav2::Nav2Parameters parameters;
  std::shared_ptr<const Program> program;
  bool isThroughPoses = false;   // the tree plans through several goals
  std::string throughPosesFile;  // tree for several goals if no tree is chosen
  NavigatorTree through;
  NavigatorTrees subTrees;                // requested by nodes of the tree
  std::vector<std::string> subTreeFiles;  // their files
  NavigatorTopics topics;                 // messages published to the robot during the run
  Nav2Masks masks;
  Nav2RouteGraph graph;
  std::vector<std::string> lattices;  // motion primitive files read
  base::Diagnostics problems;         // of both files
  base::Diagnostics invalidValues;    // values of the choice that match no parameter
  bool ok() const {
    return !base::hasErrors(problems) && !base::hasErrors(invalidValues) && program != nullptr;
  }
};

/// Reads the parameter files of `choice.params` merged into one, with its single values; without a
/// file the shipped one. `robot`: name whose namespace takes precedence in the files.
Nav2Loaded loadNav2Parameters(const sim2d::Nav2Config& choice, const std::string& folder,
                              const std::string& robot, const Nav2Folders& shipped);
/// Parameters and tree.
Nav2Loaded loadNav2(const sim2d::Nav2Config& choice, const std::string& folder,
                    const std::string& robot, const Nav2Folders& shipped);

/// The manifest entry of a robot driven by Nav2, as a JSON object: emulated distribution and its
/// commit, plugins, every key of the file and how it was used, applied defaults, actual frequencies
/// and latencies, replaced layers, event counts.
std::string nav2Report(const Nav2Loaded& loaded, const Nav2Statistics& counts,
                       const Nav2Latencies& latencies, const sim2d::PlannerSetup& setup);

/// Values that are valid individually but inconsistent with each other. `setup`: the robot, null:
/// unknown.
base::Diagnostics nav2Inconsistencies(const sim2d::nav2::Nav2Parameters& parameters,
                                      const sim2d::PlannerSetup* setup);

/// Hints of a check: the distribution of the file and keys without effect, with positions.
base::Diagnostics nav2Hints(const sim2d::nav2::Nav2Parameters& parameters);

/// A parameter of bt_navigator that names a tree, its value, and the shipped tree used without one.
struct TreeParameter {
  std::string name, value, usual;
};
/// Resolves the tree named by a parameter of bt_navigator: relative to the parameter files
/// (`findReferencedFile`), in `folder`, or by name among the shipped trees; otherwise the usual
/// one, with a warning in `problems`.
std::string nav2TreeOfParameter(const sim2d::nav2::Nav2Parameters& parameters,
                                const TreeParameter& parameter, const std::string& folder,
                                const Nav2Folders& shipped, base::Diagnostics& problems);
bool isNav2sOwnTree(const std::string& file, const Nav2Folders& shipped);

NavigatorTree loadNavigatorTree(const std::string& file,
                                const sim2d::nav2::Nav2Parameters& parameters);

/// Merges parameter files and single values of Nav2.
///
/// `entries` are files and `name:=value` in the order of `--nav2-params`; later ones override
/// earlier ones. Files are relative to `folder`, otherwise names of shipped files. Without a file
/// in `entries` the default shipped file is used.
class Nav2ParamFiles {
 public:
  Nav2ParamFiles(const std::vector<std::string>& entries, const std::string& folder,
                 const Nav2Folders& shipped);

  /// Syntax problems of the files; with errors they cannot be merged.
  const base::Diagnostics& problems() const { return problems_; }
  const std::vector<std::string>& paths() const { return paths_; }  // of the files found
  const std::vector<std::string>& overrides() const { return overrides_; }

  /// Reads all entries with the scenario's `values` (see `setNav2Value`) applied on top. The
  /// distribution is that of `options`, otherwise guessed from the files only. Values that match no
  /// parameter are reported in `wrong`. Requires `problems()` without errors.
  sim2d::nav2::Nav2ReadResult read(const std::vector<std::pair<std::string, std::string>>& values,
                                   sim2d::nav2::Nav2ReadOptions options,
                                   base::Diagnostics& wrong) const;

 private:
  struct Entry {
    std::optional<sim2d::nav2::ParameterFile> file;  // empty: a single value
    sim2d::nav2::ParameterOverride single = {};
  };

  void addFile(const std::string& named, const std::string& folder, const Nav2Folders& shipped);
  sim2d::nav2::ParameterFile merged() const;
  sim2d::nav2::ParameterFile overridden(sim2d::nav2::Nav2ReadResult reading,
                                        const sim2d::nav2::Nav2ReadOptions& options,
                                        base::Diagnostics& wrong) const;

  std::vector<Entry> entries_;
  std::vector<std::string> paths_, overrides_;
  base::Diagnostics problems_;
};

}  // namespace bt
