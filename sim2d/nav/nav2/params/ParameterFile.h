#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/yaml/YamlTree.h"

/// A parameter file of ROS 2 as its nodes see it: flat names with their places.
namespace sim2d::nav2 {

/// A parameter of a node: its name has all maps in it, "FollowPath.max_vel_x".
struct GivenParameter {
  std::string name;
  const base::YamlNode* value = nullptr;  // lies in the file; keyLine, line, column are its place
  bool isForAll = false;                  // stands below "/**"
  std::string file = {};                  // that has it; empty: it is given outside of files
  bool isPlaceholder = false;             // launch files replace it: counts as absent
};

/// What a file says to one node. Later ones of a name win, as in ROS 2; those before are not there.
struct NodeParameters {
  std::string node;       // "controller_server"; "/**": for all
  std::string nameSpace;  // "/robot1"; empty: none. Costmaps: without their own
  int line = 0;           // of the node's name
  std::vector<GivenParameter> given;
  std::string file = {};  // that has it; empty: none
  int order = 0;          // of its file among those that are read together, from 0

  const GivenParameter* find(std::string_view name) const;  // null: not given
  GivenParameter* find(std::string_view name);
};

/// A value for a parameter of a node, as `ros2 run … --ros-args -p` takes it.
struct ParameterOverride {
  std::string node;  // "controller_server"; empty: of every node that has the parameter
  std::string name;  // "FollowPath.max_vel_x", with "/" for "." where it is so written
  std::string yaml;  // "0.3"
};
/// `name:=value`, `node:name:=value`; none: the text is not of this form.
std::optional<ParameterOverride> parameterOverride(const std::string& text);

/// `node`, `/ns/node`, `ns: {node: …}` and `local_costmap: {local_costmap: …}` are all read; what
/// stands below `/**` comes first.
///
/// Several files are read as one, as ROS 2 reads several files of parameters: `append` in their
/// order. A later file wins for each parameter that it has (lists are replaced), also with a value
/// below `/**` over one that an earlier file has for the node.
class ParameterFile {
 public:
  /// Of a text; errors: no YAML, a template that is not filled in, no parameters in it. A block of
  /// a node of Nav2 without `ros__parameters`, or with another spelling of it, is read with a
  /// warning.
  static base::Result<ParameterFile> parse(std::string_view text, const std::string& file);
  static base::Result<ParameterFile> read(const std::string& path);

  /// The first one, empty: there is none; all of them in their order.
  std::string file() const { return files_.empty() ? std::string() : files_.front(); }
  const std::vector<std::string>& files() const { return files_; }
  /// Puts a file after those that are here.
  void append(const ParameterFile& later);
  const std::vector<NodeParameters>& nodes() const { return nodes_; }  // in the file's order
  /// All that is said to the node of this name, what is for all nodes first; those in the namespace
  /// `robot` win over those of others, and those of others are left out if there are some of it.
  NodeParameters parametersOf(std::string_view node, const std::string& robot = {}) const;
  /// The nodes of this name of which that is made, without what is for all.
  std::vector<const NodeParameters*> nodesOf(std::string_view node, const std::string& robot) const;

  /// Puts a value at a parameter of a node, over what is there; the node is made when it is not
  /// there. Whole numbers pass for doubles.
  void set(const std::string& node, const std::string& name, base::YamlNode value);
  /// The same as a file after those that are here would do it; the types are those of ROS 2.
  void override(const std::string& node, const std::string& name, base::YamlNode value);

 private:
  void putLast(const std::string& node, const std::string& name, base::YamlNode value);

  std::vector<std::string> files_;
  std::vector<std::shared_ptr<const base::YamlNode>> trees_;  // of files, and single values
  std::vector<NodeParameters> nodes_;
  int lastOrder_ = 0;  // of `nodes_`
};

/// Whether a text is meant for Nav2: it has a block of one of its nodes.
bool looksLikeNav2(std::string_view text);

}  // namespace sim2d::nav2
