#include "sim2d/nav/nav2/params/NodeReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/RosValue.h"

namespace sim2d::nav2 {
namespace {

bool beginsWith(const std::string& text, const std::string& with) {
  return text.compare(0, with.size(), with) == 0;
}

std::string distroWords(unsigned distros) {
  std::vector<std::string> names;
  for (const auto& [bit, name] :
       {std::pair<unsigned, const char*>{kHumble, "Humble"}, {kJazzy, "Jazzy"}, {kMain, "Main"}}) {
    if ((distros & bit) != 0) {
      names.emplace_back(name);
    }
  }
  return base::join(names, " and ");
}

/// Every node has these, and nothing here looks at them.
constexpr std::array<IdleKey, 8> kOfEveryNode = {{
    {"use_sim_time", "time is always simulated"},
    {"yaml_filename", "the scenario says which map"},
    {"bond_heartbeat_period", "nodes do not watch each other here"},
    {"bond_timeout", "nodes do not watch each other here"},
    {"autostart", "everything runs from the start"},
    {"enable_stamped_cmd_vel", "no messages here"},
    {"use_realtime_priority", "time is simulated"},
    {"transform_tolerance", "no frames here"},
}};

constexpr double kMostNumber = 1e9;     // of any unit
constexpr std::size_t kMostHints = 50;  // of unknown keys that get the nearest name

/// What no key of Nav2 can mean: no number, an infinite one, more names than anything has.
std::optional<base::Diagnostic> excessOf(const std::string& path, const Nav2Value& value) {
  if (const auto* const names = std::get_if<std::vector<std::string>>(&value)) {
    return names->size() > kMostNames
               ? std::optional(
                     base::error("nav2.too-many-names", {path, names->size(), kMostNames}))
               : std::nullopt;
  }
  std::vector<double> numbers;
  if (const auto* const list = std::get_if<std::vector<double>>(&value)) {
    numbers = *list;
  } else if (const auto* const number = std::get_if<double>(&value)) {
    numbers = {*number};
  }
  for (const double number : numbers) {
    if (!(std::abs(number) <= kMostNumber)) {  // nor NaN
      return base::error("nav2.number-out-of-range", {path, number, kMostNumber});
    }
  }
  return std::nullopt;
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

NodeReader::NodeReader(NodeParameters parameters, Distro distro, std::string file,
                       ReadingNotes& notes)
    : parameters_(std::move(parameters)), distro_(distro), file_(std::move(file)), notes_(notes) {}

Nav2Block NodeReader::given(const std::string& prefix) const {
  Nav2Block block;
  for (const GivenParameter& parameter : parameters_.given) {
    if (beginsWith(parameter.name, prefix)) {
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
  notes_.keys.push_back({pathOf(parameter.name), valueText(*parameter.value), parameter.value->line,
                         parameter.value->column, use, std::move(why)});
}

std::optional<Nav2Value> NodeReader::soundValue(const GivenParameter& given,
                                                const std::string& name,
                                                const Nav2Value& fallback) {
  std::optional<Nav2Value> value = rosValue(*given.value, fallback);
  if (!value) {
    tell(name, misfitOf(pathOf(name), fallback, *given.value));
  } else if (auto excess = excessOf(pathOf(name), *value)) {
    tell(name, *std::move(excess));
    value.reset();
  }
  return value;
}

Nav2Block NodeReader::read(const std::string& prefix, const Nav2Keys& keys) {
  Nav2Block block;
  for (const Nav2Keys::Row& row : keys.rows) {
    const std::string name = prefix + row.name;
    const GivenParameter* const given = parameters_.find(name);
    const bool isHere = isIn(row.distros, distro_);
    if (isHere) {
      known_.push_back(name);
      const std::string fallback = valueText(row.fallback);
      notes_.known.push_back({pathOf(name), parameters_.node,
                              given != nullptr ? valueText(*given->value) : fallback, fallback,
                              nav2TypeName(row.fallback), row.unit, row.meaning, given != nullptr});
    }
    if (given == nullptr) {
      if (isHere) {
        notes_.defaults.push_back({pathOf(name), valueText(row.fallback)});
      }
      continue;
    }
    if (!isHere) {
      if (keys.find(row.name, distro_) == nullptr) {  // not under another row
        note(*given, KeyUse::OtherDistro, "a key of " + distroWords(row.distros));
      }
      continue;
    }
    note(*given, KeyUse::Used, {});
    if (auto value = soundValue(*given, name, row.fallback)) {
      block[row.name] = *std::move(value);
    }
  }
  for (const Nav2Keys::Idle& idle : keys.idle) {
    know(prefix + idle.name, idle.why);
  }
  return block;
}

void NodeReader::know(const std::string& name, const std::string& why) {
  const bool isBlock = !name.empty() && name.back() == '.';
  if (!isBlock) {
    known_.push_back(name);
  }
  for (const GivenParameter& given : parameters_.given) {
    if (given.name == name || (isBlock && beginsWith(given.name, name))) {
      note(given, KeyUse::Idle, why);
    }
  }
}

void NodeReader::tell(const std::string& name, base::Diagnostic problem) {
  const GivenParameter* const given = parameters_.find(name);
  problem.file = file_;
  problem.line = given != nullptr ? given->value->line : parameters_.line;
  problem.column = given != nullptr ? given->value->column : 0;
  if (given != nullptr && given->value->tag == kSetTag) {
    problem.line = problem.column = 0;
  }
  notes_.problems.push_back(std::move(problem));
}

void NodeReader::finish() {
  for (const IdleKey& idle : kOfEveryNode) {
    know(idle.name, idle.why);
  }
  std::set<std::string> unlisted;  // plugins whose class nobody asked for
  for (const GivenParameter& given : parameters_.given) {
    const std::size_t dot = given.name.find('.');
    if (dot != std::string::npos && given.name.substr(dot) == ".plugin" &&
        asked_.count(given.name) == 0) {
      unlisted.insert(given.name.substr(0, dot));
    }
  }
  std::size_t hints = 0;
  for (const GivenParameter& given : parameters_.given) {
    if (asked_.count(given.name) != 0) {
      continue;
    }
    const std::string plugin = given.name.substr(0, given.name.find('.'));
    if (unlisted.count(plugin) != 0) {
      note(given, KeyUse::Idle, "no list of plugins names " + plugin);
      continue;
    }
    note(given, KeyUse::Unknown, {});
    if (!given.isForAll) {  // what is for all nodes need not be for this one
      const auto nearest =
          ++hints > kMostHints ? std::nullopt : base::nearestName(given.name, known_);
      tell(given.name, base::warning("nav2.unknown-key", {pathOf(given.name), nearest}));
    }
  }
}

}  // namespace sim2d::nav2
