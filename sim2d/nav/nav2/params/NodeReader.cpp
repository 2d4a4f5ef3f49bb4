#include "sim2d/nav/nav2/params/NodeReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "sim2d/nav/nav2/params/RosValue.h"

namespace sim2d::nav2 {
namespace {

/// Parameters of every node or of every server of Nav2, without effect in this program.
constexpr std::array<IgnoredKey, 21> kIgnoredInAllNodes = {{
    {"use_sim_time", "time is always simulated"},
    {"qos_overrides.", "ROS topics are not used"},
    {"start_type_description_service", "ROS services are not used"},
    {"enable_logger_service", "ROS services are not used"},
    {"allow_parameter_qos_overrides", "ROS topics are not used", kSinceLyrical},
    {"introspection_mode", "ROS services are not used", kSinceLyrical},
    {"service_introspection_mode", "ROS services are not used", kKilted},
    {"action_server_result_timeout", "results cannot be lost", kJazzy},
    {"strict_param_loading", "this program checks parameters itself", kSinceJazzy},
    {"warn_on_missing_params", "this program checks parameters itself", kSinceJazzy},
    {"yaml_filename", "the scenario names the map"},
    {"bond_heartbeat_period", "nodes do not monitor each other", kSinceJazzy},
    {"bond_timeout", "nodes do not monitor each other"},
    {"bond_disable_heartbeat_timeout", "nodes do not monitor each other"},
    {"disable_heartbeat_timeout", "nodes do not monitor each other"},
    {"autostart", "all servers run from the start"},
    {"autostart_node", "all servers run from the start", kSinceJazzy},
    {"enable_stamped_cmd_vel", "ROS messages are not used", kSinceJazzy},
    {"stamp_smoothed_velocity_with_smoothing_time", "commands have no time stamps", kJazzy},
    {"use_realtime_priority", "threads are not used", kSinceJazzy},
    {"transform_tolerance", "TF is not used"},
}};

constexpr double kMaxNumber = 1e9;     // for any unit
constexpr std::size_t kMaxHints = 50;  // unknown keys that get a suggestion

/// Values that no key of Nav2 accepts: NaN, too many names.
std::optional<base::Diagnostic> limitError(const std::string& path, const Nav2Value& value) {
  if (const auto* const names = std::get_if<std::vector<std::string>>(&value)) {
    return names->size() > kMaxNames
               ? std::optional(base::error("nav2.too-many-names", {path, names->size(), kMaxNames}))
               : std::nullopt;
  }
  const auto* const list = std::get_if<std::vector<double>>(&value);
  const auto* const number = std::get_if<double>(&value);
  const bool isNan = list != nullptr ? std::any_of(list->begin(), list->end(),
                                                   [](double each) { return std::isnan(each); })
                                     : number != nullptr && std::isnan(*number);
  return isNan ? std::optional(base::error("nav2.number-out-of-range", {path, "nan", kMaxNumber}))
               : std::nullopt;
}

/// Clamps numbers to ±kMaxNumber. Returns the first original number that was clamped.
std::optional<double> clampNumbers(Nav2Value& value) {
  std::optional<double> first;
  const auto cut = [&first](double& number) {
    if (std::abs(number) > kMaxNumber) {
      first = first ? first : number;
      number = std::copysign(kMaxNumber, number);
    }
  };
  if (auto* const list = std::get_if<std::vector<double>>(&value)) {
    std::for_each(list->begin(), list->end(), cut);
  } else if (auto* const number = std::get_if<double>(&value)) {
    cut(*number);
  }
  return first;
}

/// Why a value does not fit the key: wrong type, or an integer that is too large.
base::Diagnostic valueError(const std::string& path, const Nav2Value& wanted,
                            const base::YamlNode& given) {
  const std::string type = nav2TypeName(wanted), found = rosTypeName(given);
  return type == found ? base::error("nav2.number-out-of-range", {path, given.text, kMaxNumber})
                       : base::error("nav2.wrong-type", {path, type, found});
}

}  // namespace

const char* keyUseName(KeyUse use) {
  return use == KeyUse::Used ? "used" : use == KeyUse::Unknown ? "unknown" : "ignored";
}

NodeReader::NodeReader(NodeParameters parameters, Distro distro, ParameterNotes& notes)
    : parameters_(std::move(parameters)), distro_(distro), notes_(notes) {
  notes_.nodes.push_back({parameters_.node, parameters_.line, parameters_.file});
  for (GivenParameter& given : parameters_.given) {
    given.isPlaceholder = isLaunchPlaceholder(given.name, *given.value);
  }
}

Nav2ParameterBlock NodeReader::given(const std::string& prefix) const {
  Nav2ParameterBlock block;
  for (const GivenParameter& parameter : parameters_.given) {
    if (base::startsWith(parameter.name, prefix) && !parameter.isPlaceholder) {
      if (auto value = toRosValue(*parameter.value)) {
        block[parameter.name.substr(prefix.size())] = *std::move(value);
      }
    }
  }
  return block;
}

void NodeReader::recordUse(const GivenParameter& parameter, KeyUse use, std::string why) {
  if (!readNames_.insert(parameter.name).second) {
    return;
  }
  const bool isSet = parameter.value->tag == kOverrideTag;  // has no position in the file
  notes_.keys.push_back({pathOf(parameter.name), valueText(*parameter.value),
                         isSet ? 0 : parameter.value->line, isSet ? 0 : parameter.value->column,
                         use, std::move(why), isSet ? std::string() : parameter.file});
}

void NodeReader::reportPlaceholder(GivenParameter& given, const Nav2Value& fallback) {
  given.isPlaceholder = true;
  recordUse(given, KeyUse::Ignored, "a placeholder that launch files replace");
  report(given.name, base::warning("nav2.placeholder", {pathOf(given.name), valueText(*given.value),
                                                        valueText(fallback)}));
}

std::optional<Nav2Value> NodeReader::checkedValue(GivenParameter& given,
                                                  const Nav2Value& fallback) {
  std::optional<Nav2Value> value = toRosValue(*given.value, fallback);
  if (!value && mayBePlaceholder(*given.value)) {
    reportPlaceholder(given, fallback);
    return std::nullopt;
  }
  recordUse(given, KeyUse::Used, {});
  const std::string path = pathOf(given.name);
  if (!value) {
    report(given.name, valueError(path, fallback, *given.value));
  } else if (auto excess = limitError(path, *value)) {
    report(given.name, *std::move(excess));
    value.reset();
  } else if (const auto cut = clampNumbers(*value)) {
    report(given.name,
           base::warning("nav2.number-cut", {path, *cut, std::copysign(kMaxNumber, *cut)}));
  }
  return value;
}

Nav2ParameterBlock NodeReader::read(const std::string& prefix, const Nav2KeyTable& keys) {
  Nav2ParameterBlock block;
  for (const Nav2KeyTable::Row& row : keys.rows) {
    const std::string name = prefix + row.name;
    GivenParameter* const given = parameters_.find(name);
    if (!includesDistro(row.distros, distro_)) {
      if (given != nullptr && !keys.isKnown(row.name, distro_)) {  // and no other row has it
        recordUse(*given, KeyUse::OtherDistro, "a key of " + distroTitles(row.distros));
      }
      continue;
    }
    known_.push_back(name);
    if (given != nullptr && given->isPlaceholder && readNames_.count(name) == 0) {
      reportPlaceholder(*given, row.fallback);
    } else if (given != nullptr && !given->isPlaceholder) {
      if (auto value = checkedValue(*given, row.fallback)) {
        block[row.name] = *std::move(value);
      }
    }
    recordKnownKey(row, name, given != nullptr && !given->isPlaceholder ? given : nullptr);
  }
  for (const Nav2KeyTable::Ignored& ignored : keys.ignored) {
    markIgnored(prefix + ignored.name, ignored.why, ignored.distros);
  }
  return block;
}

void NodeReader::recordKnownKey(const Nav2KeyTable::Row& row, const std::string& name,
                                const GivenParameter* given) {
  const std::string fallback = valueText(row.fallback);
  notes_.known.push_back({pathOf(name), parameters_.node,
                          given != nullptr ? valueText(*given->value) : fallback, fallback,
                          nav2TypeName(row.fallback), row.unit, row.meaning, given != nullptr});
  if (given == nullptr) {
    notes_.defaults.push_back({pathOf(name), fallback});
  }
}

void NodeReader::markIgnored(const std::string& name, const std::string& why, unsigned distros) {
  const bool isBlock = !name.empty() && name.back() == '.';
  const bool isHere = includesDistro(distros, distro_);
  if (!isBlock && isHere) {
    known_.push_back(name);
  }
  for (const GivenParameter& given : parameters_.given) {
    if (given.name == name || (isBlock && base::startsWith(given.name, name))) {
      recordUse(given, isHere ? KeyUse::Ignored : KeyUse::OtherDistro,
                isHere ? why : "a key of " + distroTitles(distros));
    }
  }
}

void NodeReader::supply(const std::string& name, base::YamlNode value, std::string file) {
  const GivenParameter* const given = parameters_.find(name);
  if (given != nullptr && given->value->tag == kOverrideTag) {
    return;
  }
  drop(name);
  supplied_.push_back(std::make_shared<const base::YamlNode>(std::move(value)));
  parameters_.given.push_back({name, supplied_.back().get(), false, std::move(file)});
}

void NodeReader::drop(const std::string& name) {
  auto& given = parameters_.given;
  given.erase(std::remove_if(given.begin(), given.end(),
                             [&](const GivenParameter& each) { return each.name == name; }),
              given.end());
}

void NodeReader::markUsed(const std::string& name) {
  if (const GivenParameter* const given = parameters_.find(name)) {
    recordUse(*given, KeyUse::Used, {});
  }
}

void NodeReader::keepOnly(const std::string& prefix, const Nav2KeyTable& keys,
                          const std::string& why) {
  std::vector<std::string> others;
  for (const GivenParameter& given : parameters_.given) {
    if (!base::startsWith(given.name, prefix) || given.name == prefix + "plugin") {
      continue;
    }
    const std::string key = given.name.substr(prefix.size());
    const Nav2KeyTable::Row* const row = keys.find(key, distro_);
    const bool isKept = row != nullptr ? toRosValue(*given.value, row->fallback).has_value()
                                       : keys.isKnown(key, distro_);
    if (!isKept) {
      recordUse(given, KeyUse::Ignored, why);
      others.push_back(given.name);
    }
  }
  for (const std::string& name : others) {
    drop(name);
  }
}

void NodeReader::report(const std::string& name, base::Diagnostic problem) {
  const GivenParameter* const given = parameters_.find(name);
  problem.file = parameters_.file;
  problem.line = parameters_.line;
  problem.column = 0;
  if (given != nullptr && given->value->tag == kOverrideTag) {  // has no position in a file
    problem.file.clear();
    problem.line = 0;
  } else if (given != nullptr) {
    const bool isNull = given->value->isNull();  // null has the position of the next token
    problem.file = given->file;
    problem.line = isNull ? given->value->keyLine : given->value->line;
    problem.column = isNull ? given->value->keyColumn : given->value->column;
  }
  notes_.problems.push_back(std::move(problem));
}

void NodeReader::finish() {
  for (const IgnoredKey& ignored : kIgnoredInAllNodes) {
    markIgnored(ignored.name, ignored.why, ignored.distros);
  }
  ignoreUnlistedBlocks();
  if (!notes_.onlyKeys) {
    reportUnknownKeys();
  }
}

/// Marks the blocks of plugins that no list names.
void NodeReader::ignoreUnlistedBlocks() {
  constexpr std::string_view kEnd = ".plugin";
  for (const GivenParameter& given : parameters_.given) {
    const std::size_t end = given.name.size() - std::min(given.name.size(), kEnd.size());
    if (base::endsWith(given.name, kEnd) && end > 0 && readNames_.count(given.name) == 0) {
      const std::string block = given.name.substr(0, end);
      markIgnored(block + ".", "no list of plugins names " + block);
    }
  }
}

void NodeReader::reportUnknownKeys() {
  std::size_t hints = 0;
  for (const GivenParameter& given : parameters_.given) {
    if (readNames_.count(given.name) != 0) {
      continue;
    }
    const bool isHinted = ++hints <= kMaxHints;
    const std::string block = unknownBlock(given.name);
    std::size_t count = 0;
    for (const GivenParameter& other : parameters_.given) {
      if (!block.empty() && base::startsWith(other.name, block) &&
          readNames_.count(other.name) == 0) {
        recordUse(other, KeyUse::Unknown, {});
        ++count;
      }
    }
    recordUse(given, KeyUse::Unknown, {});
    if (given.isWildcard) {  // keys below "/**" need not exist in this node
      continue;
    }
    const char* const distro = distroTitle(distro_);
    if (block.empty()) {
      const auto nearest = isHinted ? base::nearestName(given.name, siblingKeys(given.name))
                                    : std::optional<std::string>();
      report(given.name, base::warning("nav2.unknown-key", {pathOf(given.name), distro, nearest}));
      continue;
    }
    const std::string name = block.substr(0, block.size() - 1);
    const auto nearest =
        isHinted ? base::nearestName(name, siblingBlocks(name)) : std::optional<std::string>();
    const std::string keys = std::to_string(count) + (count == 1 ? " key" : " keys");
    report(given.name, base::warning("nav2.unnamed-block", {pathOf(name), keys, distro, nearest}));
  }
}

std::string NodeReader::unknownBlock(const std::string& name) const {
  for (std::size_t dot = name.find('.'); dot != std::string::npos; dot = name.find('.', dot + 1)) {
    std::string block = name.substr(0, dot + 1);
    const auto isWithin = [&block](const std::string& other) {
      return base::startsWith(other, block);
    };
    const auto asked = readNames_.lower_bound(block);
    const bool isAsked = asked != readNames_.end() && isWithin(*asked);
    if (!isAsked && std::none_of(known_.begin(), known_.end(), isWithin)) {
      return block;
    }
  }
  return {};
}

/// Known keys in the same block.
std::vector<std::string> NodeReader::siblingKeys(const std::string& name) const {
  const std::size_t dot = name.rfind('.');
  std::vector<std::string> names;
  for (const std::string& known : known_) {
    const std::size_t knownDot = known.rfind('.');
    if (knownDot == dot && (dot == std::string::npos || known.compare(0, dot, name, 0, dot) == 0)) {
      names.push_back(known);
    }
  }
  return names;
}

/// Blocks with known keys in the same parent block.
std::vector<std::string> NodeReader::siblingBlocks(const std::string& block) const {
  const std::size_t dot = block.rfind('.');
  const std::size_t begin = dot == std::string::npos ? 0 : dot + 1;
  std::set<std::string> blocks;
  for (const std::string& known : known_) {
    const std::size_t end = known.find('.', begin);
    if (end != std::string::npos && known.compare(0, begin, block, 0, begin) == 0) {
      blocks.insert(known.substr(0, end));
    }
  }
  return {blocks.begin(), blocks.end()};
}

std::vector<std::string> uniquePluginNames(NodeReader& node, const std::string& list,
                                           const std::vector<std::string>& names) {
  if (names.size() > kMaxNames) {  // a single string; NodeReader checks lists
    node.report(list, base::error("nav2.too-many-names", {list, names.size(), kMaxNames}));
    return {};
  }
  std::vector<std::string> once;
  for (const std::string& name : names) {
    if (std::find(once.begin(), once.end(), name) != once.end()) {
      node.report(list, base::warning("nav2.plugin-twice", {list, name}));
    } else if (!name.empty()) {
      once.push_back(name);
    }
  }
  return once;
}

std::string pluginClass(NodeReader& node, const std::string& name, const std::string& fallback) {
  const std::string key = name + ".plugin";
  if (const auto given = node.value<std::string>(key, fallback)) {
    return *given;
  }
  if (!node.has(key) && fallback.empty() && !node.isPlaceholder(key)) {
    node.report(key, base::error("nav2.no-plugin", {node.node(), name}));
  }
  return fallback;
}

void reportUnknownPlugin(NodeReader& node, const std::string& name, const std::string& found,
                         const std::vector<std::string>& known) {
  node.report(name + ".plugin", unknownPlugin(found, known));
}

void reportSubstitute(NodeReader& node, const std::string& name, const std::string& found,
                      const std::string& substitute, const std::string& why) {
  node.report(name + ".plugin",
              base::warning("nav2.treated-as", {node.node() + "." + name, found, substitute, why}));
}

void reportOmittedPlugin(NodeReader& node, const std::string& name, const std::string& found,
                         const std::string& why) {
  node.report(name + ".plugin",
              base::warning("nav2.left-out", {node.node() + "." + name, found, why}));
}

void reportProblems(NodeReader& node, const base::Diagnostics& problems) {
  for (const base::Diagnostic& problem : problems) {
    const std::string where = problem.value("where");
    std::string place = where.empty() ? std::string() : where + ".plugin";
    for (const auto& [hole, value] : problem.values) {
      for (const std::string& key : {value, base::join({where, value}, ".")}) {
        place = node.has(key) ? key : place;
      }
    }
    node.report(place, base::withContext(node.node(), problem));
  }
}

}  // namespace sim2d::nav2
