#include "sim2d/nav/nav2/params/ParameterFile.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/RepeatedKeys.h"
#include "sim2d/nav/nav2/params/RosValue.h"

namespace sim2d::nav2 {
namespace {

using base::YamlNode;

constexpr const char* kParameters = "ros__parameters";
constexpr const char* kForAll = "/**";
constexpr std::size_t kDeepest = 64;           // maps within each other
constexpr std::size_t kMostParameters = 5000;  // of all nodes; files of Nav2 have some 300
constexpr std::size_t kMostNodes = 500;        // with parameters
constexpr std::size_t kLongestValue = 100000;  // characters; a footprint has some 60
constexpr std::size_t kMostValues = 1000;      // of a list

bool isForAllNodes(const std::string& node) {
  return node == "**" || node == "*";
}

void put(std::vector<GivenParameter>& to, GivenParameter parameter) {
  to.erase(std::remove_if(to.begin(), to.end(),
                          [&](const GivenParameter& old) { return old.name == parameter.name; }),
           to.end());
  to.push_back(std::move(parameter));
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
      put(to_, {name, &item, false});
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
      } else if (item.isMap() && depth < kDeepest) {
        look(item, here, depth + 1);
      } else if (!item.isNull()) {
        problems_.push_back(
            base::warning("nav2.outside-node", {here}, file_, item.keyLine, item.keyColumn));
      }
    }
  }

 private:
  static std::string joined(const std::string& path, const std::string& key) {
    const bool hasSlash = !key.empty() && key.front() == '/';
    return path + (hasSlash || path.empty() ? key : "/" + key);
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
    const bool isForAll = isForAllNodes(node.node);
    if (isForAll) {
      node.node = kForAll;
    }
    // A costmap's node lies in a namespace of its own name.
    const std::string own = "/" + node.node;
    if (node.nameSpace == node.node) {
      node.nameSpace.clear();
    } else if (node.nameSpace.size() > own.size() &&
               node.nameSpace.compare(node.nameSpace.size() - own.size(), own.size(), own) == 0) {
      node.nameSpace.resize(node.nameSpace.size() - own.size());
    }
    if (node.nameSpace == kForAll || node.nameSpace == "**") {
      node.nameSpace.clear();
    }
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

bool isNamespaceOf(const std::string& nameSpace, const std::string& robot) {
  return nameSpace == robot || nameSpace == "/" + robot;
}

}  // namespace

const GivenParameter* NodeParameters::find(std::string_view name) const {
  const auto found =
      std::find_if(given.begin(), given.end(),
                   [name](const GivenParameter& parameter) { return parameter.name == name; });
  return found == given.end() ? nullptr : &*found;
}

base::Result<ParameterFile> ParameterFile::parse(std::string_view text, const std::string& file) {
  base::Diagnostics problems;
  auto tree = std::make_shared<YamlNode>(
      base::parseYaml(text, file, base::RepeatedKeys::LastCounts, problems));
  if (base::hasErrors(problems)) {
    return problems;
  }
  ParameterFile result;
  result.file_ = file;
  if (!tree->isMap()) {
    problems.push_back(base::error("nav2.no-parameters", {}, file));
    return problems;
  }
  NodeSearch(result.nodes_, problems, file).look(*tree, {}, 0);
  result.tree_ = std::move(tree);
  if (result.nodes_.empty()) {
    problems.push_back(base::error("nav2.no-parameters", {}, file));
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::move(result), std::move(problems)};
}

base::Result<ParameterFile> ParameterFile::read(const std::string& path) {
  const base::Result<std::string> text = base::readTextFile(path);
  return text ? parse(*text, path) : base::Result<ParameterFile>(text.diagnostics());
}

std::vector<const NodeParameters*> ParameterFile::nodesOf(std::string_view node,
                                                          const std::string& robot) const {
  const bool hasOwn = std::any_of(nodes_.begin(), nodes_.end(), [&](const NodeParameters& each) {
    return each.node == node && !robot.empty() && isNamespaceOf(each.nameSpace, robot);
  });
  std::string taken;  // the first namespace counts when none is the robot's
  bool hasTaken = false;
  std::vector<const NodeParameters*> counting;
  for (const NodeParameters& each : nodes_) {
    const bool isOther = hasOwn ? !each.nameSpace.empty() && !isNamespaceOf(each.nameSpace, robot)
                                : hasTaken && !each.nameSpace.empty() && each.nameSpace != taken;
    if (each.node != node || isOther) {
      continue;
    }
    if (!each.nameSpace.empty() && !hasOwn) {
      taken = each.nameSpace;
      hasTaken = true;
    }
    counting.push_back(&each);
  }
  return counting;
}

NodeParameters ParameterFile::parametersOf(std::string_view node, const std::string& robot) const {
  NodeParameters all;
  all.node = node;
  const auto take = [&all](const NodeParameters& from) {
    for (const GivenParameter& parameter : from.given) {
      put(all.given, parameter);
    }
  };
  for (const NodeParameters& each : nodes_) {
    if (each.node == kForAll) {
      take(each);
    }
  }
  for (const NodeParameters* const each : nodesOf(node, robot)) {
    all.line = each->line;
    all.nameSpace = each->nameSpace;
    take(*each);
  }
  return all;
}

void ParameterFile::set(const std::string& node, const std::string& name, YamlNode value) {
  value.tag = kSetTag;
  value.key = name;
  set_.push_back(std::make_shared<const YamlNode>(std::move(value)));
  const GivenParameter parameter{name, set_.back().get(), false};
  bool isThere = false;
  for (NodeParameters& each : nodes_) {
    if (each.node == node) {
      put(each.given, parameter);
      isThere = true;
    }
  }
  if (!isThere) {
    nodes_.push_back({node, {}, 0, {parameter}});
  }
}

bool looksLikeNav2(std::string_view text) {
  static constexpr std::array<std::string_view, 11> kNodes = {"controller_server",
                                                              "planner_server",
                                                              "bt_navigator",
                                                              "local_costmap",
                                                              "global_costmap",
                                                              "behavior_server",
                                                              "smoother_server",
                                                              "velocity_smoother",
                                                              "collision_monitor",
                                                              "recoveries_server",
                                                              "amcl"};
  return text.find(kParameters) != std::string_view::npos &&
         text.find("hunav_loader") == std::string_view::npos &&
         std::any_of(kNodes.begin(), kNodes.end(), [text](std::string_view node) {
           return text.find(node) != std::string_view::npos;
         });
}

}  // namespace sim2d::nav2
