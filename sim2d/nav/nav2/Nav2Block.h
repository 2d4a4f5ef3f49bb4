#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Nav2Key.h"

/// Parameters of a component whose struct the caller does not know: a plugin's block of a file.
namespace sim2d::nav2 {

/// In the order of `Nav2Key::Member`.
using Nav2Value =
    std::variant<double, int, bool, std::string, std::vector<double>, std::vector<std::string>>;
const char* nav2TypeName(const Nav2Value& value);  // "double", "integer" … as ROS 2 says it

/// What is given for a component, by key: "desired_linear_vel", "BaseObstacle.scale". Keys lie
/// below the component's own name.
using Nav2Block = std::map<std::string, Nav2Value>;

/// Keys of a component.
struct Nav2Keys {
  struct Row {
    std::string name;
    Nav2Value fallback;  // Nav2's own
    std::string unit, meaning;
    unsigned distros = kEveryDistro;
  };
  struct Idle {
    std::string name, why;
    unsigned distros = kEveryDistro;
  };
  std::vector<Row> rows;
  std::vector<Idle> idle;

  const Row* find(std::string_view name, Distro distro) const;  // null: not there in that distro
  bool isKnown(std::string_view name, Distro distro) const;     // in a row, or without effect
};

/// "plugin::Name" of either spelling: Humble's files also write "plugin/Name".
std::string pluginName(std::string_view spelling);

/// Whether a class that is none of `known` ("package::Class", or bare names) is one of them with a
/// spelling mistake: its package is that of a known class, or at most two letters differ. Any other
/// class belongs to a package that is not re-implemented.
bool isMisspelt(const std::string& found, const std::vector<std::string>& known);

/// A value of another type than the key's, as ROS 2 refuses it at start.
base::Diagnostic wrongType(const std::string& key, const Nav2Value& wanted, const Nav2Value& found);

// Not inlined: GCC 12 looks at types that a small struct has no member of, and sees them beyond it.
template <class Parameters, class Value>
[[gnu::noinline]] Nav2Value valueIn(const Parameters& from, Value Parameters::*member) {
  return Nav2Value(from.*member);
}
template <class Parameters, class Value>
[[gnu::noinline]] void take(Parameters& into, Value Parameters::*member, const std::string& key,
                            const Nav2Value& given, base::Diagnostics& problems) {
  if (const Value* const value = std::get_if<Value>(&given)) {
    into.*member = *value;
  } else {
    problems.push_back(wrongType(key, Nav2Value(into.*member), given));
  }
}

/// The rows of a table with the values of `defaults`, each below `prefix` ("BaseObstacle.").
template <class Parameters>
void addRows(Nav2Keys& keys, const std::vector<Nav2Key<Parameters>>& table,
             const Parameters& defaults, const std::string& prefix = {}) {
  for (const Nav2Key<Parameters>& key : table) {
    const Nav2Value fallback =
        std::visit([&](auto member) { return valueIn(defaults, member); }, key.member);
    keys.rows.push_back({prefix + key.name, fallback, key.unit, key.meaning, key.distros});
  }
}

inline void addIdle(Nav2Keys& keys, const std::vector<IdleKey>& table) {
  for (const IdleKey& key : table) {
    keys.idle.push_back({key.name, key.why, key.distros});
  }
}

/// `defaults` with what the block gives. Keys that `distro` lacks are left out; each value of
/// another type is a problem.
template <class Parameters>
Parameters filled(Parameters defaults, const std::vector<Nav2Key<Parameters>>& table,
                  const Nav2Block& block, Distro distro, base::Diagnostics& problems,
                  const std::string& prefix = {}) {
  for (const Nav2Key<Parameters>& key : table) {
    const auto given = block.find(prefix + key.name);
    if (given == block.end() || !isIn(key.distros, distro)) {
      continue;
    }
    std::visit([&](auto member) { take(defaults, member, given->first, given->second, problems); },
               key.member);
  }
  return defaults;
}

}  // namespace sim2d::nav2
