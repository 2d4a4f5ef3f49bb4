#include "sim2d/nav/nav2/params/ParameterNodes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string_view>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/RepeatedKeys.h"
#include "sim2d/nav/nav2/params/BtNavigator.h"
#include "sim2d/nav/nav2/params/RosValue.h"

namespace sim2d::nav2 {
namespace {

using base::YamlNode;

constexpr const char* kParameters = "ros__parameters";
constexpr std::size_t kDeepest = 64;           // maps within each other
constexpr std::size_t kMostParameters = 5000;  // of all nodes; files of Nav2 have some 300
constexpr std::size_t kMostNodes = 500;        // with parameters
constexpr std::size_t kLongestValue = 100000;  // characters; a footprint has some 60
constexpr std::size_t kMostValues = 1000;      // of a list

bool isForAllNodes(const std::string& node) {
  return node == "**" || node == "*";
}

/// Values below a map, no further than one beyond the limit.
std::size_t countValues(const YamlNode& map, std::size_t depth) {
  std::size_t count = 0;
  for (const YamlNode& item : map.items) {
    count += item.isMap() && depth < kDeepest ? countValues(item, depth + 1) : 1;
    if (count > kMostParameters) {
      break;
    }
  }
  return count;
}

bool isTooLong(const YamlNode& value) {
  const auto isLong = [](const YamlNode& item) { return item.text.size() > kLongestValue; };
  return isLong(value) || value.items.size() > kMostValues ||
         std::any_of(value.items.begin(), value.items.end(), isLong);
}

/// `ros__parameters` as people misspell it. Words that may also be a name count below a node only.
bool isMisspeltKey(const std::string& key, const std::string& parent) {
  static constexpr std::array<std::string_view, 10> kWrong = {
      "ros_parameters", "ros__parameter", "ros_parameter", "ros___parameters", "ros__params",
      "ros_params",     "ros__param",     "rosparameters", "ros__paramters",   "ros__paremeters"};
  const bool isName = key == "params" || key == "parameters";
  return std::find(kWrong.begin(), kWrong.end(), key) != kWrong.end() ||
         (isName && isNav2Node(parent));
}

bool hasParameters(const YamlNode& map, std::size_t depth) {
  return std::any_of(map.items.begin(), map.items.end(), [&](const YamlNode& item) {
    return item.key == kParameters || isMisspeltKey(item.key, map.key) ||
           (item.isMap() && depth < kDeepest && hasParameters(item, depth + 1));
  });
}

/// The block of a node of Nav2 whose values stand right below its name.
bool lacksParameters(const YamlNode& item) {
  const bool isNode = item.isMap() && !item.items.empty() && isNav2Node(item.key);
  const YamlNode* const inner = isNode ? item.find(item.key) : nullptr;
  return isNode && (inner == nullptr || !inner->isMap()) && !hasParameters(item, 0);
}

/// `a.b: 1` and `a: {b: 2}` are the same parameter, as is a key that is repeated.
class Flattening {
 public:
  Flattening(std::vector<GivenParameter>& to, const std::string& file, base::Diagnostics& problems)
      : to_(to), file_(file), problems_(problems) {}

  void add(const YamlNode& map, const std::string& prefix, std::size_t depth) {
    for (const YamlNode& item : map.items) {
      const std::string name = prefix + item.key;
      if (item.isMap() && depth < kDeepest) {
        add(item, name + ".", depth + 1);
        continue;
      }
      const auto [before, isNew] = values_.emplace(name, &item);
      if (!isNew) {
        problems_.push_back(base::repeatedKey(name, item, *before->second, file_));
        before->second = &item;
      }
      putParameter(to_, {name, &item, false, file_});
    }
  }

 private:
  std::vector<GivenParameter>& to_;
  const std::string& file_;
  base::Diagnostics& problems_;
  std::map<std::string, const YamlNode*> values_;
};

/// Finds the nodes below a map; `path` is the way to it, with '/' between.
class NodeSearch {
 public:
  NodeSearch(std::vector<NodeParameters>& nodes, base::Diagnostics& problems,
             const std::string& file)
      : nodes_(nodes), problems_(problems), file_(file) {}

  void look(const YamlNode& map, const std::string& path, std::size_t depth) {
    for (const YamlNode& item : map.items) {
      const std::string here = joined(path, item.key);
      if (item.key == kParameters) {
        add(item, path, map.keyLine);
      } else if (item.isMap() && map.find(kParameters) == nullptr &&
                 isMisspeltKey(item.key, map.key)) {
        warnAt(item, "nav2.parameters-misspelt", {here});
        add(item, path, map.keyLine);
      } else if (lacksParameters(item)) {
        warnAt(item, "nav2.parameters-missing", {here});
        add(item, here, item.keyLine);
      } else if (item.isMap() && depth < kDeepest) {
        look(item, here, depth + 1);
      } else if (!item.isNull()) {
        warnAt(item, "nav2.outside-node", {here});
      }
    }
  }

 private:
  static std::string joined(const std::string& path, const std::string& key) {
    const bool hasSlash = !key.empty() && key.front() == '/';
    return path + (hasSlash || path.empty() ? key : "/" + key);
  }

  void warnAt(const YamlNode& item, const char* code, base::ProblemValues values) {
    problems_.push_back(
        base::warning(code, std::move(values), file_, item.keyLine, item.keyColumn));
  }

  void add(const YamlNode& parameters, const std::string& path, int line) {
    if (!parameters.isMap()) {
      if (!parameters.isNull()) {
        problems_.push_back(base::error("yaml.no-map", {valueText(parameters)}, file_,
                                        parameters.line, parameters.column));
      }
      return;
    }
    NodeParameters node;
    const std::size_t slash = path.rfind('/');
    node.node = slash == std::string::npos ? path : path.substr(slash + 1);
    node.nameSpace = slash == std::string::npos ? "" : path.substr(0, slash);
    node.line = line;
    node.file = file_;
    const bool isForAll = isForAllNodes(node.node);
    if (isForAll) {
      node.node = kForAllNodes;
    }
    takeOwnNamespace(node);
    count_ += countValues(parameters, 0);
    if (count_ > kMostParameters || nodes_.size() >= kMostNodes) {
      refuseMasses(parameters);
      return;
    }
    Flattening(node.given, file_, problems_).add(parameters, {}, 0);
    for (GivenParameter& given : node.given) {
      given.isForAll = isForAll;
      if (isTooLong(*given.value)) {
        problems_.push_back(base::error("nav2.value-too-long",
                                        {given.name, kLongestValue, kMostValues}, file_,
                                        given.value->keyLine, given.value->keyColumn));
      }
    }
    nodes_.push_back(std::move(node));
  }

  /// A costmap's node lies in a namespace of its own name; one that stands for all is none.
  static void takeOwnNamespace(NodeParameters& node) {
    const std::string own = "/" + node.node;
    if (node.nameSpace == node.node || node.nameSpace == own) {
      node.nameSpace.clear();
    } else if (node.nameSpace.size() > own.size() &&
               node.nameSpace.compare(node.nameSpace.size() - own.size(), own.size(), own) == 0) {
      node.nameSpace.resize(node.nameSpace.size() - own.size());
    }
    const std::size_t word = node.nameSpace.find_first_not_of('/');
    const std::string all = word == std::string::npos ? std::string() : node.nameSpace.substr(word);
    if (isForAllNodes(all)) {
      node.nameSpace.clear();
    }
  }

  void refuseMasses(const YamlNode& parameters) {
    if (!std::exchange(isRefused_, true)) {
      problems_.push_back(base::error("nav2.too-many-parameters", {kMostParameters, kMostNodes},
                                      file_, parameters.keyLine, parameters.keyColumn));
    }
  }

  std::vector<NodeParameters>& nodes_;
  base::Diagnostics& problems_;
  const std::string& file_;
  std::size_t count_ = 0;  // of parameters
  bool isRefused_ = false;
};

}  // namespace

void putParameter(std::vector<GivenParameter>& to, GivenParameter parameter) {
  to.erase(std::remove_if(to.begin(), to.end(),
                          [&](const GivenParameter& old) { return old.name == parameter.name; }),
           to.end());
  to.push_back(std::move(parameter));
}

bool isNav2Node(const std::string& name) {
  static constexpr std::array<std::string_view, 10> kNodes = {
      "controller_server", "planner_server",   "bt_navigator",    "local_costmap",
      "global_costmap",    "behavior_server",  "smoother_server", "velocity_smoother",
      "collision_monitor", "recoveries_server"};
  return std::find(kNodes.begin(), kNodes.end(), name) != kNodes.end() || idleNode(name) != nullptr;
}

std::vector<NodeParameters> findNodes(const YamlNode& tree, const std::string& file,
                                      base::Diagnostics& problems) {
  std::vector<NodeParameters> nodes;
  NodeSearch(nodes, problems, file).look(tree, {}, 0);
  return nodes;
}

}  // namespace sim2d::nav2
