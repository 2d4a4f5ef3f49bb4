#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

#include <algorithm>
#include <cstddef>

#include "sim2d/base/Text.h"

namespace sim2d::nav2 {

const char* nav2TypeName(const Nav2Value& value) {
  static constexpr const char* kNames[] = {"double", "integer",      "bool",
                                           "string", "double_array", "string_array"};
  return kNames[value.index()];
}

const Nav2KeyTable::Row* Nav2KeyTable::find(std::string_view name, Distro distro) const {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
    return row.name == name && includesDistro(row.distros, distro);
  });
  return found == rows.end() ? nullptr : &*found;
}

bool Nav2KeyTable::isKnown(std::string_view name, Distro distro) const {
  return find(name, distro) != nullptr ||
         std::any_of(ignored.begin(), ignored.end(), [&](const Ignored& each) {
           return each.name == name && includesDistro(each.distros, distro);
         });
}

std::string normalizedPluginClass(std::string_view spelling) {
  std::string name(spelling);
  for (std::size_t slash = name.find('/'); slash != std::string::npos; slash = name.find('/')) {
    name.replace(slash, 1, "::");
  }
  return name;
}

bool isMisspelt(const std::string& found, const std::vector<std::string>& known) {
  constexpr std::size_t kMaxWrongLetters = 2;
  const auto packageOf = [](const std::string& name) {
    const std::size_t colons = name.find("::");
    return colons == std::string::npos ? std::string() : name.substr(0, colons);
  };
  const std::string name = normalizedPluginClass(found), package = packageOf(name);
  return std::any_of(known.begin(), known.end(), [&](const std::string& each) {
    return (!package.empty() && packageOf(each) == package) ||
           base::editDistance(name, each) <= kMaxWrongLetters;
  });
}

base::Diagnostic wrongType(const std::string& key, const Nav2Value& wanted,
                           const Nav2Value& found) {
  return base::error("nav2.wrong-type", {key, nav2TypeName(wanted), nav2TypeName(found)});
}

bool ParameterChecks::require(bool isRight, const std::string& key, const char* wanted) {
  if (!isRight) {
    problems_.push_back(base::error("nav2.bad-parameter", {prefix_ + key, wanted}));
  }
  return isRight;
}

bool ParameterChecks::within(const std::string& key, double value, const base::Range& range,
                             const std::string& wanted) {
  if (!range.contains(value)) {
    problems_.push_back(base::error("nav2.wrong-value", {prefix_ + key, value, wanted}));
  }
  return range.contains(value);
}

void invertPositiveDecelerations(
    std::initializer_list<std::pair<const char*, double*>> decelerations,
    base::Diagnostics& problems) {
  for (const auto& [key, value] : decelerations) {
    if (*value > 0.0) {
      problems.push_back(base::warning("nav2.positive-deceleration", {key, *value}));
      *value = -*value;
    }
  }
}

}  // namespace sim2d::nav2
