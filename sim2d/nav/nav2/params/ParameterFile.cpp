#include "sim2d/nav/nav2/params/ParameterFile.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/nav/nav2/params/BtNavigatorParameters.h"
#include "sim2d/nav/nav2/params/RosValue.h"

namespace sim2d::nav2 {
namespace {

using base::YamlNode;

constexpr const char* kAssignmentSeparator = ":=";  // separator in the argument of `-p`

/// Finds braces of Jinja, xacro or Helm, which are invalid YAML; quoted braces are ordinary values.
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
  return base::findBy(given, &GivenParameter::name, name);
}

GivenParameter* NodeParameters::find(std::string_view name) {
  return base::findBy(given, &GivenParameter::name, name);
}

base::Result<ParameterFile> ParameterFile::parse(std::string_view text, const std::string& file) {
  base::Diagnostics problems;
  auto tree = std::make_shared<YamlNode>(
      base::parseYaml(text, file, base::DuplicateKeys::LastWins, problems));
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
  if (!text) {
    return text.diagnostics();
  }
  // A batch reads the same files several times per run.
  constexpr std::size_t kKept = 16;
  thread_local std::map<std::pair<std::string, std::string>, base::Result<ParameterFile>> parsed;
  const auto key = std::make_pair(path, *text);
  if (const auto found = parsed.find(key); found != parsed.end()) {
    return found->second;
  }
  if (parsed.size() >= kKept) {
    parsed.clear();
  }
  return parsed.emplace(key, parse(*text, path)).first->second;
}

std::vector<const NodeParameters*> ParameterFile::nodesOf(std::string_view node,
                                                          const std::string& robot) const {
  const bool hasOwn = std::any_of(nodes_.begin(), nodes_.end(), [&](const NodeParameters& each) {
    return each.node == node && !robot.empty() && isNamespaceOf(each.nameSpace, robot);
  });
  std::string taken;  // the first namespace is used if none is the robot's
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

bool ParameterFile::hasNode(std::string_view name) const {
  return std::any_of(nodes_.begin(), nodes_.end(),
                     [name](const NodeParameters& node) { return node.node == name; });
}

NodeParameters ParameterFile::parametersOf(std::string_view node, const std::string& robot) const {
  std::vector<const NodeParameters*> parts = nodesOf(kWildcardNode, robot);
  const std::vector<const NodeParameters*> own = nodesOf(node, robot);
  parts.insert(parts.end(), own.begin(), own.end());
  std::stable_sort(parts.begin(), parts.end(),
                   [](const NodeParameters* a, const NodeParameters* b) {
                     return a->order < b->order;  // keeps "/**" first within a file
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
      setParameter(all.given, parameter);
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

void ParameterFile::appendOverride(const std::string& node, const std::string& name,
                                   YamlNode value) {
  value.key = name;
  trees_.push_back(std::make_shared<const YamlNode>(std::move(value)));
  nodes_.push_back({node, {}, 0, {{name, trees_.back().get()}}, {}, ++lastOrder_});
}

void ParameterFile::set(const std::string& node, const std::string& name, YamlNode value) {
  value.tag = kOverrideTag;
  appendOverride(node, name, std::move(value));
}

void ParameterFile::override(const std::string& node, const std::string& name, YamlNode value) {
  value.line = value.column = value.keyLine = value.keyColumn = 0;  // it has no position in a file
  appendOverride(node, name, std::move(value));
}

std::optional<ParameterOverride> parameterOverride(const std::string& text) {
  const std::size_t separator = text.find(kAssignmentSeparator);
  if (separator == std::string::npos) {
    return std::nullopt;
  }
  std::string node, name = text.substr(0, separator);
  if (const std::size_t colon = name.rfind(':'); colon != std::string::npos) {
    node = name.substr(0, colon);
    node = node.substr(node.rfind('/') + 1);  // drops the namespace
    name = name.substr(colon + 1);
  }
  if (node == "**" || node == "*") {
    node.clear();
  }
  return ParameterOverride{node, name,
                           text.substr(separator + std::string_view(kAssignmentSeparator).size())};
}

namespace {

constexpr std::string_view kWellKnownNodes[] = {
    "controller_server", "planner_server",    "bt_navigator",
    "local_costmap",     "global_costmap",    "behavior_server",
    "smoother_server",   "velocity_smoother", "collision_monitor",
    "docking_server",    "following_server",  "route_server",
    "waypoint_follower", "recoveries_server", "amcl"};

}  // namespace

bool looksLikeNav2(std::string_view text) {
  if (base::hasKeyLine(text, "hunav_loader")) {
    return false;
  }
  const bool hasParameters = base::hasKeyLine(text, "ros__parameters");
  return std::any_of(
      std::begin(kWellKnownNodes), std::end(kWellKnownNodes), [&](std::string_view node) {
        const std::string block = std::string(node) + ":";  // ros__parameters is missing
        return hasParameters ? base::hasKeyLine(text, node)
                             : text.substr(0, block.size()) == block ||
                                   text.find("\n" + block) != std::string_view::npos;
      });
}

namespace {

constexpr const char* kParameters = "ros__parameters";
constexpr std::size_t kMaxDepth = 64;            // nested maps
constexpr std::size_t kMaxParameters = 5000;     // of all nodes; files of Nav2 have about 300
constexpr std::size_t kMaxNodes = 500;           // with parameters
constexpr std::size_t kMaxValueLength = 100000;  // characters; a footprint has about 60
constexpr std::size_t kMaxListItems = 1000;      // items of a list

bool isWildcardNode(const std::string& node) {
  return node == "**" || node == "*";
}

/// Counts the values below a map, up to one beyond the limit.
std::size_t countValues(const YamlNode& map, std::size_t depth) {
  std::size_t count = 0;
  for (const YamlNode& item : map.items) {
    count += item.isMap() && depth < kMaxDepth ? countValues(item, depth + 1) : 1;
    if (count > kMaxParameters) {
      break;
    }
  }
  return count;
}

bool isTooLong(const YamlNode& value) {
  const auto isLong = [](const YamlNode& item) { return item.text.size() > kMaxValueLength; };
  return isLong(value) || value.items.size() > kMaxListItems ||
         std::any_of(value.items.begin(), value.items.end(), isLong);
}

/// Common misspellings of `ros__parameters`. Words that may also be names count only below a node.
bool isMisspeltKey(const std::string& key, const std::string& parent) {
  static constexpr std::array<std::string_view, 10> kMisspellings = {
      "ros_parameters", "ros__parameter", "ros_parameter", "ros___parameters", "ros__params",
      "ros_params",     "ros__param",     "rosparameters", "ros__paramters",   "ros__paremeters"};
  const bool isName = key == "params" || key == "parameters";
  return std::find(kMisspellings.begin(), kMisspellings.end(), key) != kMisspellings.end() ||
         (isName && isNav2Node(parent));
}

bool hasParameters(const YamlNode& map, std::size_t depth) {
  return std::any_of(map.items.begin(), map.items.end(), [&](const YamlNode& item) {
    return item.key == kParameters || isMisspeltKey(item.key, map.key) ||
           (item.isMap() && depth < kMaxDepth && hasParameters(item, depth + 1));
  });
}

/// Whether the block of a Nav2 node has its values directly below its name.
bool lacksParameters(const YamlNode& item) {
  const bool isNode = item.isMap() && !item.items.empty() && isNav2Node(item.key);
  const YamlNode* const inner = isNode ? item.find(item.key) : nullptr;
  return isNode && (inner == nullptr || !inner->isMap()) && !hasParameters(item, 0);
}

/// Finds the nodes below a map; `path` is its path with '/' as separator.
class NodeSearch {
 public:
  NodeSearch(std::vector<NodeParameters>& nodes, base::Diagnostics& problems,
             const std::string& file)
      : nodes_(nodes), problems_(problems), file_(file) {}

  void search(const YamlNode& map, const std::string& path, std::size_t depth) {
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
      } else if (item.isMap() && depth < kMaxDepth) {
        search(item, here, depth + 1);
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
    const bool isWildcard = isWildcardNode(node.node);
    if (isWildcard) {
      node.node = kWildcardNode;
    }
    removeOwnNamespace(node);
    count_ += countValues(parameters, 0);
    if (count_ > kMaxParameters || nodes_.size() >= kMaxNodes) {
      reportTooManyParameters(parameters);
      return;
    }
    std::map<std::string, const YamlNode*> values;
    addFlattened(parameters, {}, 0, node.given, values);
    for (GivenParameter& given : node.given) {
      given.isWildcard = isWildcard;
      if (isTooLong(*given.value)) {
        problems_.push_back(base::error("nav2.value-too-long",
                                        {given.name, kMaxValueLength, kMaxListItems}, file_,
                                        given.value->keyLine, given.value->keyColumn));
      }
    }
    nodes_.push_back(std::move(node));
  }

  /// Flattens maps: `a.b: 1` and `a: {b: 2}` are the same parameter, as is a repeated key.
  void addFlattened(const YamlNode& map, const std::string& prefix, std::size_t depth,
                    std::vector<GivenParameter>& to,
                    std::map<std::string, const YamlNode*>& values) {
    for (const YamlNode& item : map.items) {
      const std::string name = prefix + item.key;
      if (item.isMap() && depth < kMaxDepth) {
        addFlattened(item, name + ".", depth + 1, to, values);
        continue;
      }
      const auto [before, isNew] = values.emplace(name, &item);
      if (!isNew) {
        problems_.push_back(base::duplicateKeyWarning(name, item, *before->second, file_));
        before->second = &item;
      }
      setParameter(to, {name, &item, false, file_});
    }
  }

  /// A costmap's node is in a namespace of its own name; a namespace for all nodes is none.
  static void removeOwnNamespace(NodeParameters& node) {
    const std::string own = "/" + node.node;
    if (node.nameSpace == node.node || node.nameSpace == own) {
      node.nameSpace.clear();
    } else if (base::endsWith(node.nameSpace, own)) {
      node.nameSpace.resize(node.nameSpace.size() - own.size());
    }
    const std::size_t word = node.nameSpace.find_first_not_of('/');
    const std::string all = word == std::string::npos ? std::string() : node.nameSpace.substr(word);
    if (isWildcardNode(all)) {
      node.nameSpace.clear();
    }
  }

  void reportTooManyParameters(const YamlNode& parameters) {
    if (!std::exchange(isRefused_, true)) {
      problems_.push_back(base::error("nav2.too-many-parameters", {kMaxParameters, kMaxNodes},
                                      file_, parameters.keyLine, parameters.keyColumn));
    }
  }

  std::vector<NodeParameters>& nodes_;
  base::Diagnostics& problems_;
  const std::string& file_;
  std::size_t count_ = 0;  // parameters
  bool isRefused_ = false;
};

}  // namespace

void setParameter(std::vector<GivenParameter>& to, GivenParameter parameter) {
  to.erase(std::remove_if(to.begin(), to.end(),
                          [&](const GivenParameter& old) { return old.name == parameter.name; }),
           to.end());
  to.push_back(std::move(parameter));
}

bool isNav2Node(const std::string& name) {
  return std::find(std::begin(kWellKnownNodes), std::end(kWellKnownNodes), name) !=
             std::end(kWellKnownNodes) ||
         ignoredNodeReason(name) != nullptr;
}

std::vector<NodeParameters> findNodes(const YamlNode& tree, const std::string& file,
                                      base::Diagnostics& problems) {
  std::vector<NodeParameters> nodes;
  NodeSearch(nodes, problems, file).search(tree, {}, 0);
  return nodes;
}

namespace {

constexpr std::array<std::string_view, 4> kOnRobot = {"robot_base_frame", "base_frame_id",
                                                      "base_frame", "sensor_frame"};

std::string_view withoutSlash(std::string_view name) {
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

/// The frame that a parameter of a node names; nullopt when it is absent or empty.
std::optional<std::string> frameIn(const NodeParameters& node, std::string_view key) {
  const GivenParameter* const given = node.find(key);
  if (given == nullptr || !given->value->isScalar()) {
    return std::nullopt;
  }
  const std::string name(withoutSlash(given->value->text));
  return name.empty() ? std::nullopt : std::optional(name);
}

/// Whether the last part of a name is a key for a frame on the robot.
bool namesRobotFrame(std::string_view name) {
  const std::string_view last = name.substr(name.rfind('.') + 1);
  return std::find(kOnRobot.begin(), kOnRobot.end(), last) != kOnRobot.end();
}

void addRobotFrames(const ParameterFile& file, std::vector<std::string>& to) {
  for (const NodeParameters& node : file.nodes()) {
    for (const GivenParameter& given : node.given) {
      if (namesRobotFrame(given.name) && given.value->isScalar()) {
        to.emplace_back(withoutSlash(given.value->text));
      }
    }
  }
}

}  // namespace

bool FrameNames::canTransform(std::string_view parent, std::string_view child,
                              bool isLocalized) const {
  int inMap = 0;
  for (const std::string_view frame : {withoutSlash(parent), withoutSlash(child)}) {
    if (frame == map) {
      ++inMap;
    } else if (frame != odom && !std::binary_search(onRobot.begin(), onRobot.end(), frame)) {
      return false;
    }
  }
  return inMap != 1 || isLocalized;
}

FrameNames frameNamesOf(const ParameterFile& file, const std::string& robot) {
  FrameNames names;
  const NodeParameters local = file.parametersOf("local_costmap", robot);
  const NodeParameters behaviors = file.parametersOf("behavior_server", robot);
  names.map = frameIn(file.parametersOf("global_costmap", robot), "global_frame").value_or("map");
  const std::string localFrame = frameIn(local, "global_frame").value_or("map");
  names.isLocalInOdom = localFrame != names.map;
  if (names.isLocalInOdom) {
    names.odom = localFrame;
  } else {
    // Jazzy introduced `local_frame`; earlier, `global_frame` was the frame of the local costmap.
    const auto own = frameIn(behaviors, "local_frame");
    const auto humble = frameIn(behaviors, "global_frame");
    names.odom = own ? *own : humble && *humble != names.map ? *humble : "odom";
  }
  names.onRobot = {"base_footprint", "base_link"};
  addRobotFrames(file, names.onRobot);
  std::sort(names.onRobot.begin(), names.onRobot.end());
  names.onRobot.erase(std::unique(names.onRobot.begin(), names.onRobot.end()), names.onRobot.end());
  return names;
}

}  // namespace sim2d::nav2
