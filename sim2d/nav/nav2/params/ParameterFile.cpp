#include "sim2d/nav/nav2/params/ParameterFile.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/RepeatedKeys.h"
#include "sim2d/nav/nav2/params/ParameterNodes.h"
#include "sim2d/nav/nav2/params/RosValue.h"

namespace sim2d::nav2 {
namespace {

using base::YamlNode;

constexpr const char* kAssigns = ":=";  // in what ROS 2 takes for one parameter

/// Braces of Jinja, xacro or Helm, which are no YAML; those in quotes are a value like others.
std::optional<base::Diagnostic> unfilledTemplate(std::string_view text, const std::string& file) {
  int line = 0;
  for (const std::string& content : base::split(text, '\n')) {
    ++line;
    for (const std::string_view braces : {"{{", "{%"}) {
      const std::size_t at = content.find(braces);
      if (at != std::string::npos && content.find_first_of("#\"'") >= at) {
        return base::error("nav2.template", {braces}, file, line, static_cast<int>(at) + 1);
      }
    }
  }
  return std::nullopt;
}

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

GivenParameter* NodeParameters::find(std::string_view name) {
  return const_cast<GivenParameter*>(std::as_const(*this).find(name));
}

base::Result<ParameterFile> ParameterFile::parse(std::string_view text, const std::string& file) {
  base::Diagnostics problems;
  auto tree = std::make_shared<YamlNode>(
      base::parseYaml(text, file, base::RepeatedKeys::LastCounts, problems));
  if (base::hasErrors(problems)) {
    const std::optional<base::Diagnostic> unfilled = unfilledTemplate(text, file);
    return unfilled ? base::Diagnostics{*unfilled} : problems;
  }
  ParameterFile result;
  result.files_ = {file};
  if (!tree->isMap()) {
    problems.push_back(base::error("nav2.no-parameters", {}, file));
    return problems;
  }
  result.nodes_ = findNodes(*tree, file, problems);
  result.trees_.push_back(std::move(tree));
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
  std::vector<const NodeParameters*> parts = nodesOf(kForAllNodes, robot);
  const std::vector<const NodeParameters*> own = nodesOf(node, robot);
  parts.insert(parts.end(), own.begin(), own.end());
  std::stable_sort(parts.begin(), parts.end(),
                   [](const NodeParameters* a, const NodeParameters* b) {
                     return a->order < b->order;  // in a file, what is for all nodes stays first
                   });
  NodeParameters all;
  all.node = node;
  all.file = file();
  for (const NodeParameters* const part : parts) {
    if (part->node == node && part->line > 0) {
      all.line = part->line;
      all.nameSpace = part->nameSpace;
      all.file = part->file;
    }
    for (const GivenParameter& parameter : part->given) {
      putParameter(all.given, parameter);
    }
  }
  return all;
}

void ParameterFile::append(const ParameterFile& later) {
  const int first = lastOrder_ + 1;
  files_.insert(files_.end(), later.files_.begin(), later.files_.end());
  trees_.insert(trees_.end(), later.trees_.begin(), later.trees_.end());
  nodes_.reserve(nodes_.size() + later.nodes_.size());
  for (NodeParameters node : later.nodes_) {
    node.order += first;
    nodes_.push_back(std::move(node));
  }
  lastOrder_ = first + later.lastOrder_;
}

void ParameterFile::putLast(const std::string& node, const std::string& name, YamlNode value) {
  value.key = name;
  trees_.push_back(std::make_shared<const YamlNode>(std::move(value)));
  nodes_.push_back({node, {}, 0, {{name, trees_.back().get()}}, {}, ++lastOrder_});
}

void ParameterFile::set(const std::string& node, const std::string& name, YamlNode value) {
  value.tag = kSetTag;
  putLast(node, name, std::move(value));
}

void ParameterFile::override(const std::string& node, const std::string& name, YamlNode value) {
  value.line = value.column = value.keyLine = value.keyColumn = 0;  // it stands in no file
  putLast(node, name, std::move(value));
}

std::optional<ParameterOverride> parameterOverride(const std::string& text) {
  const std::size_t assigns = text.find(kAssigns);
  if (assigns == std::string::npos) {
    return std::nullopt;
  }
  std::string node, name = text.substr(0, assigns);
  if (const std::size_t colon = name.rfind(':'); colon != std::string::npos) {
    node = name.substr(0, colon);
    node = node.substr(node.rfind('/') + 1);  // of whichever namespace
    name = name.substr(colon + 1);
  }
  if (node == "**" || node == "*") {
    node.clear();
  }
  return ParameterOverride{node, name, text.substr(assigns + std::string_view(kAssigns).size())};
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
  if (text.find("hunav_loader") != std::string_view::npos) {
    return false;
  }
  const bool hasParameters = text.find("ros__parameters") != std::string_view::npos;
  return std::any_of(kNodes.begin(), kNodes.end(), [&](std::string_view node) {
    const std::string block = std::string(node) + ":";  // without ros__parameters: a mistake in it
    return hasParameters ? text.find(node) != std::string_view::npos
                         : text.substr(0, block.size()) == block ||
                               text.find("\n" + block) != std::string_view::npos;
  });
}

}  // namespace sim2d::nav2
