#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/yaml/YamlTree.h"

/// A parameter file of ROS 2 as its nodes read it: flat names with their positions in the file.
namespace sim2d::nav2 {

/// A parameter of a node. Its name contains the enclosing maps: "FollowPath.max_vel_x".
struct GivenParameter {
  std::string name;
  const base::YamlNode* value = nullptr;  // owned by the file; has its position
  bool isWildcard = false;                // given below "/**"
  std::string file = {};                  // empty: given outside of files
  bool isPlaceholder = false;             // replaced by launch files: counts as absent
};

/// The parameters of one node. As in ROS 2 the last value of a name wins; earlier ones are removed.
struct NodeParameters {
  std::string node;       // "controller_server"; "/**": for all
  std::string nameSpace;  // "/robot1"; empty: none. For costmaps without their own
  int line = 0;           // line of the node's name
  std::vector<GivenParameter> given;
  std::string file = {};  // empty: none
  int order = 0;          // index of its file among those read together

  const GivenParameter* find(std::string_view name) const;  // null: not given
  GivenParameter* find(std::string_view name);
};

/// A value for a parameter of a node, in the syntax of `ros2 run … --ros-args -p`.
struct ParameterOverride {
  std::string node;  // "controller_server"; empty: all nodes with the parameter
  std::string name;  // "FollowPath.max_vel_x", may contain "/" instead of "."
  std::string yaml;  // "0.3"
};
/// Parses `name:=value` or `node:name:=value`; nullopt for other texts.
std::optional<ParameterOverride> parameterOverride(const std::string& text);

/// Reads `node`, `/ns/node`, `ns: {node: …}` and `local_costmap: {local_costmap: …}`. Parameters
/// below `/**` come first.
///
/// Several files are read as one, as ROS 2 does: `append` them in order. A later file wins for each
/// parameter that it contains (lists are replaced), also with a value below `/**` over a node's
/// value in an earlier file.
class ParameterFile {
 public:
  /// Errors: invalid YAML, an unresolved template, no parameters. A block of a Nav2 node without
  /// `ros__parameters`, or with a misspelling of it, is read with a warning.
  static base::Result<ParameterFile> parse(std::string_view text, const std::string& file);
  static base::Result<ParameterFile> read(const std::string& path);
  /// Identifies the content: equal for files that share it, such as a file that is read twice.
  const std::vector<std::shared_ptr<const base::YamlNode>>& trees() const { return trees_; }

  /// The first file, or empty; all files in order.
  std::string file() const { return files_.empty() ? std::string() : files_.front(); }
  const std::vector<std::string>& files() const { return files_; }
  /// Adds a file after the existing ones.
  void append(const ParameterFile& later);
  const std::vector<NodeParameters>& nodes() const { return nodes_; }  // in the file's order
  bool hasNode(std::string_view name) const;
  /// All parameters of the node of this name, beginning with those for all nodes. Nodes in the
  /// namespace `robot` win over nodes in other namespaces, which are skipped if such a node exists.
  NodeParameters parametersOf(std::string_view node, const std::string& robot = {}) const;
  /// The nodes of this name that parametersOf merges, without those for all nodes.
  std::vector<const NodeParameters*> nodesOf(std::string_view node, const std::string& robot) const;

  /// Sets a parameter of a node over existing values; creates the node when it is absent. Integers
  /// are accepted for doubles.
  void set(const std::string& node, const std::string& name, base::YamlNode value);
  /// The same with the typing of ROS 2, as a further file would do it.
  void override(const std::string& node, const std::string& name, base::YamlNode value);

 private:
  void appendOverride(const std::string& node, const std::string& name, base::YamlNode value);

  std::vector<std::string> files_;
  std::vector<std::shared_ptr<const base::YamlNode>> trees_;  // of files and of single values
  std::vector<NodeParameters> nodes_;
  int lastOrder_ = 0;  // highest order in `nodes_`
};

/// Whether a text is meant for Nav2: it contains a block of one of its nodes.
bool looksLikeNav2(std::string_view text);

/// Finds the nodes of a parameter file in its YAML. Private to this folder.

constexpr const char* kWildcardNode = "/**";

/// Appends a parameter; removes an earlier one of the same name.
void setParameter(std::vector<GivenParameter>& to, GivenParameter parameter);

/// Whether Nav2 has a node of this name ("controller_server"), re-implemented or not.
bool isNav2Node(const std::string& name);

/// The nodes of a file with their parameters, which point into `tree`. Appends problems: values
/// outside of nodes, blocks without `ros__parameters`, exceeded limits.
std::vector<NodeParameters> findNodes(const base::YamlNode& tree, const std::string& file,
                                      base::Diagnostics& problems);

/// The TF frames that a parameter file names, without a leading '/'.
struct FrameNames {
  std::string map = "map";    // global_frame of the global costmap
  std::string odom = "odom";  // of the local costmap; of the behaviors if both costmaps agree
  /// Whether the local costmap has another global_frame than the global one: it moves with the
  /// odometry.
  bool isLocalInOdom = false;
  std::vector<std::string> onRobot;  // base frames and sensor frames, sorted

  /// Whether a transform between two frames exists: both are known, and a transform to or from the
  /// map requires that the robot is localized. Names may have a leading '/'.
  bool canTransform(std::string_view parent, std::string_view child, bool isLocalized) const;
};

/// Reads `global_frame` and `local_frame` of costmaps and behaviours, and `robot_base_frame`,
/// `base_frame_id`, `base_frame` and `sensor_frame` of all nodes. base_link and base_footprint are
/// always known.
FrameNames frameNamesOf(const ParameterFile& file, const std::string& robot);

}  // namespace sim2d::nav2
