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
#include "sim2d/nav/nav2/params/Placeholders.h"
#include "sim2d/nav/nav2/params/RosValue.h"

namespace sim2d::nav2 {
namespace {

bool beginsWith(const std::string& text, const std::string& with) {
  return text.compare(0, with.size(), with) == 0;
}

/// Parameters of every node, or of every server of Nav2; they have no effect here.
constexpr std::array<IdleKey, 21> kOfEveryNode = {{
    {"use_sim_time", "time is always simulated"},
    {"qos_overrides.", "no topics here"},
    {"start_type_description_service", "no services here"},
    {"enable_logger_service", "no services here"},
    {"allow_parameter_qos_overrides", "no topics here"},
    {"introspection_mode", "no services here"},
    {"service_introspection_mode", "no services here"},
    {"action_server_result_timeout", "results do not get lost here", kJazzy},
    {"strict_param_loading", "this program checks parameters itself"},
    {"warn_on_missing_params", "this program checks parameters itself"},
    {"yaml_filename", "the scenario names the map"},
    {"bond_heartbeat_period", "nodes do not monitor each other here"},
    {"bond_timeout", "nodes do not monitor each other here"},
    {"bond_disable_heartbeat_timeout", "nodes do not monitor each other here"},
    {"disable_heartbeat_timeout", "nodes do not monitor each other here"},
    {"autostart", "all servers run from the start"},
    {"autostart_node", "all servers run from the start"},
    {"enable_stamped_cmd_vel", "no messages here"},
    {"stamp_smoothed_velocity_with_smoothing_time", "commands have no stamps here"},
    {"use_realtime_priority", "time is simulated"},
    {"transform_tolerance", "no frames here"},
}};

constexpr double kMostNumber = 1e9;     // of any unit
constexpr std::size_t kMostHints = 50;  // of unknown keys that get the nearest name

/// What no key of Nav2 can mean: no number, more names than anything has.
std::optional<base::Diagnostic> excessOf(const std::string& path, const Nav2Value& value) {
  if (const auto* const names = std::get_if<std::vector<std::string>>(&value)) {
    return names->size() > kMostNames
               ? std::optional(
                     base::error("nav2.too-many-names", {path, names->size(), kMostNames}))
               : std::nullopt;
  }
  const auto* const list = std::get_if<std::vector<double>>(&value);
  const auto* const number = std::get_if<double>(&value);
  const bool isNan = list != nullptr ? std::any_of(list->begin(), list->end(),
                                                   [](double each) { return std::isnan(each); })
                                     : number != nullptr && std::isnan(*number);
  return isNan ? std::optional(base::error("nav2.number-out-of-range", {path, "nan", kMostNumber}))
               : std::nullopt;
}

/// Infinite numbers, and those that no key of Nav2 has, end here; the first one before it was cut.
std::optional<double> cutNumbers(Nav2Value& value) {
  std::optional<double> first;
  const auto cut = [&first](double& number) {
    if (std::abs(number) > kMostNumber) {
      first = first ? first : number;
      number = std::copysign(kMostNumber, number);
    }
  };
  if (auto* const list = std::get_if<std::vector<double>>(&value)) {
    std::for_each(list->begin(), list->end(), cut);
  } else if (auto* const number = std::get_if<double>(&value)) {
    cut(*number);
  }
  return first;
}

/// Why a value is none of the key's: a whole number may also be too large.
base::Diagnostic misfitOf(const std::string& path, const Nav2Value& wanted,
                          const base::YamlNode& given) {
  const std::string type = nav2TypeName(wanted), found = rosTypeName(given);
  return type == found ? base::error("nav2.number-out-of-range", {path, given.text, kMostNumber})
                       : base::error("nav2.wrong-type", {path, type, found});
}

}  // namespace

const char* keyUseName(KeyUse use) {
  return use == KeyUse::Used ? "used" : use == KeyUse::Unknown ? "unknown" : "ignored";
}

NodeReader::NodeReader(NodeParameters parameters, Distro distro, ReadingNotes& notes)
    : parameters_(std::move(parameters)), distro_(distro), notes_(notes) {
  notes_.nodes.push_back({parameters_.node, parameters_.line, parameters_.file});
  for (GivenParameter& given : parameters_.given) {
    given.isPlaceholder = isLaunchPlaceholder(given.name, *given.value);
  }
}

Nav2Block NodeReader::given(const std::string& prefix) const {
  Nav2Block block;
  for (const GivenParameter& parameter : parameters_.given) {
    if (beginsWith(parameter.name, prefix) && !parameter.isPlaceholder) {
      if (auto value = rosValue(*parameter.value)) {
        block[parameter.name.substr(prefix.size())] = *std::move(value);
      }
    }
  }
  return block;
}

void NodeReader::note(const GivenParameter& parameter, KeyUse use, std::string why) {
  if (!asked_.insert(parameter.name).second) {
    return;
  }
  const bool isSet = parameter.value->tag == kSetTag;  // has no place in the file
  notes_.keys.push_back({pathOf(parameter.name), valueText(*parameter.value),
                         isSet ? 0 : parameter.value->line, isSet ? 0 : parameter.value->column,
                         use, std::move(why), isSet ? std::string() : parameter.file});
}

void NodeReader::tellPlaceholder(GivenParameter& given, const Nav2Value& fallback) {
  given.isPlaceholder = true;
  note(given, KeyUse::Idle, "a placeholder that launch files replace");
  tell(given.name, base::warning("nav2.placeholder", {pathOf(given.name), valueText(*given.value),
                                                      valueText(fallback)}));
}

std::optional<Nav2Value> NodeReader::soundValue(GivenParameter& given, const Nav2Value& fallback) {
  std::optional<Nav2Value> value = rosValue(*given.value, fallback);
  if (!value && mayBePlaceholder(*given.value)) {
    tellPlaceholder(given, fallback);
    return std::nullopt;
  }
  note(given, KeyUse::Used, {});
  const std::string path = pathOf(given.name);
  if (!value) {
    tell(given.name, misfitOf(path, fallback, *given.value));
  } else if (auto excess = excessOf(path, *value)) {
    tell(given.name, *std::move(excess));
    value.reset();
  } else if (const auto cut = cutNumbers(*value)) {
    tell(given.name,
         base::warning("nav2.number-cut", {path, *cut, std::copysign(kMostNumber, *cut)}));
  }
  return value;
}

Nav2Block NodeReader::read(const std::string& prefix, const Nav2Keys& keys) {
  Nav2Block block;
  for (const Nav2Keys::Row& row : keys.rows) {
    const std::string name = prefix + row.name;
    GivenParameter* const given = parameters_.find(name);
    if (!isIn(row.distros, distro_)) {
      if (given != nullptr && !keys.isKnown(row.name, distro_)) {  // nor by another row
        note(*given, KeyUse::OtherDistro, "a key of " + distroTitles(row.distros));
      }
      continue;
    }
    known_.push_back(name);
    if (given != nullptr && given->isPlaceholder && asked_.count(name) == 0) {
      tellPlaceholder(*given, row.fallback);
    } else if (given != nullptr && !given->isPlaceholder) {
      if (auto value = soundValue(*given, row.fallback)) {
        block[row.name] = *std::move(value);
      }
    }
    noteKnown(row, name, given != nullptr && !given->isPlaceholder ? given : nullptr);
  }
  for (const Nav2Keys::Idle& idle : keys.idle) {
    know(prefix + idle.name, idle.why, idle.distros);
  }
  return block;
}

void NodeReader::noteKnown(const Nav2Keys::Row& row, const std::string& name,
                           const GivenParameter* given) {
  const std::string fallback = valueText(row.fallback);
  notes_.known.push_back({pathOf(name), parameters_.node,
                          given != nullptr ? valueText(*given->value) : fallback, fallback,
                          nav2TypeName(row.fallback), row.unit, row.meaning, given != nullptr});
  if (given == nullptr) {
    notes_.defaults.push_back({pathOf(name), fallback});
  }
}

void NodeReader::know(const std::string& name, const std::string& why, unsigned distros) {
  const bool isBlock = !name.empty() && name.back() == '.';
  const bool isHere = isIn(distros, distro_);
  if (!isBlock && isHere) {
    known_.push_back(name);
  }
  for (const GivenParameter& given : parameters_.given) {
    if (given.name == name || (isBlock && beginsWith(given.name, name))) {
      note(given, isHere ? KeyUse::Idle : KeyUse::OtherDistro,
           isHere ? why : "a key of " + distroTitles(distros));
    }
  }
}

void NodeReader::supply(const std::string& name, base::YamlNode value) {
  const GivenParameter* const given = parameters_.find(name);
  if (given != nullptr && given->value->tag == kSetTag) {
    return;
  }
  drop(name);
  supplied_.push_back(std::make_shared<const base::YamlNode>(std::move(value)));
  parameters_.given.push_back({name, supplied_.back().get(), false});
}

void NodeReader::drop(const std::string& name) {
  auto& given = parameters_.given;
  given.erase(std::remove_if(given.begin(), given.end(),
                             [&](const GivenParameter& each) { return each.name == name; }),
              given.end());
}

void NodeReader::markUsed(const std::string& name) {
  if (const GivenParameter* const given = parameters_.find(name)) {
    note(*given, KeyUse::Used, {});
  }
}

void NodeReader::keepOnly(const std::string& prefix, const Nav2Keys& keys, const std::string& why) {
  std::vector<std::string> others;
  for (const GivenParameter& given : parameters_.given) {
    if (!beginsWith(given.name, prefix) || given.name == prefix + "plugin") {
      continue;
    }
    const std::string key = given.name.substr(prefix.size());
    const Nav2Keys::Row* const row = keys.find(key, distro_);
    const bool isKept = row != nullptr ? rosValue(*given.value, row->fallback).has_value()
                                       : keys.isKnown(key, distro_);
    if (!isKept) {
      note(given, KeyUse::Idle, why);
      others.push_back(given.name);
    }
  }
  for (const std::string& name : others) {
    drop(name);
  }
}

void NodeReader::tell(const std::string& name, base::Diagnostic problem) {
  const GivenParameter* const given = parameters_.find(name);
  problem.file = parameters_.file;
  problem.line = parameters_.line;
  problem.column = 0;
  if (given != nullptr && given->value->tag == kSetTag) {  // has no place in a file
    problem.line = 0;
  } else if (given != nullptr) {
    const bool isNull = given->value->isNull();  // its place is that of what follows
    problem.file = given->file;
    problem.line = isNull ? given->value->keyLine : given->value->line;
    problem.column = isNull ? given->value->keyColumn : given->value->column;
  }
  notes_.problems.push_back(std::move(problem));
}

void NodeReader::finish() {
  for (const IdleKey& idle : kOfEveryNode) {
    know(idle.name, idle.why, idle.distros);
  }
  noteUnlisted();
  if (!notes_.onlyKeys) {
    noteUnknown();
  }
}

/// Blocks of plugins that no list names.
void NodeReader::noteUnlisted() {
  constexpr std::string_view kEnd = ".plugin";
  for (const GivenParameter& given : parameters_.given) {
    const std::size_t end = given.name.size() - std::min(given.name.size(), kEnd.size());
    if (given.name.substr(end) == kEnd && end > 0 && asked_.count(given.name) == 0) {
      const std::string block = given.name.substr(0, end);
      know(block + ".", "no list of plugins names " + block);
    }
  }
}

void NodeReader::noteUnknown() {
  std::size_t hints = 0;
  for (const GivenParameter& given : parameters_.given) {
    if (asked_.count(given.name) != 0) {
      continue;
    }
    const bool isHinted = ++hints <= kMostHints;
    const std::string block = unknownBlock(given.name);
    std::size_t count = 0;
    for (const GivenParameter& other : parameters_.given) {
      if (!block.empty() && beginsWith(other.name, block) && asked_.count(other.name) == 0) {
        note(other, KeyUse::Unknown, {});
        ++count;
      }
    }
    note(given, KeyUse::Unknown, {});
    if (given.isForAll) {  // keys for all nodes need not exist in this one
      continue;
    }
    const char* const distro = distroTitle(distro_);
    if (block.empty()) {
      const auto nearest = isHinted ? base::nearestName(given.name, namesBeside(given.name))
                                    : std::optional<std::string>();
      tell(given.name, base::warning("nav2.unknown-key", {pathOf(given.name), distro, nearest}));
      continue;
    }
    const std::string name = block.substr(0, block.size() - 1);
    const auto nearest =
        isHinted ? base::nearestName(name, blocksBeside(name)) : std::optional<std::string>();
    const std::string keys = std::to_string(count) + (count == 1 ? " key" : " keys");
    tell(given.name, base::warning("nav2.unnamed-block", {pathOf(name), keys, distro, nearest}));
  }
}

std::string NodeReader::unknownBlock(const std::string& name) const {
  for (std::size_t dot = name.find('.'); dot != std::string::npos; dot = name.find('.', dot + 1)) {
    std::string block = name.substr(0, dot + 1);
    const auto isWithin = [&block](const std::string& other) { return beginsWith(other, block); };
    const auto asked = asked_.lower_bound(block);
    const bool isAsked = asked != asked_.end() && isWithin(*asked);
    if (!isAsked && std::none_of(known_.begin(), known_.end(), isWithin)) {
      return block;
    }
  }
  return {};
}

/// Known keys of the same block.
std::vector<std::string> NodeReader::namesBeside(const std::string& name) const {
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

/// Blocks of known keys that lie in the same block.
std::vector<std::string> NodeReader::blocksBeside(const std::string& block) const {
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

}  // namespace sim2d::nav2
