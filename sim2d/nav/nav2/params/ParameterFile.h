#pragma once

#include <memory>
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
};

/// What a file says to one node. Later ones of a name win, as in ROS 2; those before are not there.
struct NodeParameters {
  std::string node;       // "controller_server"; "/**": for all
  std::string nameSpace;  // "/robot1"; empty: none. Costmaps: without their own
  int line = 0;           // of the node's name
  std::vector<GivenParameter> given;

  const GivenParameter* find(std::string_view name) const;  // null: not given
};

/// `node`, `/ns/node`, `ns: {node: …}` and `local_costmap: {local_costmap: …}` are all read; what
/// stands below `/**` comes first.
class ParameterFile {
 public:
  /// Of a text; errors: no YAML, no `ros__parameters` in it.
  static base::Result<ParameterFile> parse(std::string_view text, const std::string& file);
  static base::Result<ParameterFile> read(const std::string& path);

  const std::string& file() const { return file_; }
  const std::vector<NodeParameters>& nodes() const { return nodes_; }  // in the file's order
  /// All that is said to the node of this name, what is for all nodes first; those in the namespace
  /// `robot` win over those of others, and those of others are left out if there are some of it.
  NodeParameters parametersOf(std::string_view node, const std::string& robot = {}) const;
  /// The nodes of this name of which that is made, without what is for all.
  std::vector<const NodeParameters*> nodesOf(std::string_view node, const std::string& robot) const;

  /// Puts a value at a parameter of a node, over what is there; the node is made when it is not
  /// there.
  void set(const std::string& node, const std::string& name, base::YamlNode value);

 private:
  std::string file_;
  std::shared_ptr<const base::YamlNode> tree_;
  std::vector<std::shared_ptr<const base::YamlNode>> set_;
  std::vector<NodeParameters> nodes_;
};

/// Whether a text is meant for Nav2: it has parameters of one of its nodes.
bool looksLikeNav2(std::string_view text);

}  // namespace sim2d::nav2
