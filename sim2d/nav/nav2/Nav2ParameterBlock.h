#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/Result.h"

/// Parameters of Nav2 as tables: each component is a plain struct with the defaults of Nav2's code
/// (not those of its bringup files), and one row per key. File readers, checkers, forms and
/// generated pages iterate over the rows.
namespace sim2d::nav2 {

/// A branch of Nav2, which determines defaults, formulas and names. In release order, so that
/// `distro >= Distro::Lyrical` means Lyrical and main.
enum class Distro : std::uint8_t { Humble, Jazzy, Kilted, Lyrical, Main };
constexpr Distro kDistros[] = {Distro::Humble, Distro::Jazzy, Distro::Kilted, Distro::Lyrical,
                               Distro::Main};

/// Bit mask of the branches that have a key.
constexpr unsigned kHumble = 1, kJazzy = 2, kKilted = 4, kLyrical = 8, kMain = 16;
constexpr unsigned kSinceLyrical = kLyrical | kMain, kSinceKilted = kKilted | kSinceLyrical,
                   kSinceJazzy = kJazzy | kSinceKilted;
constexpr unsigned kUntilJazzy = kHumble | kJazzy, kUntilKilted = kUntilJazzy | kKilted;
constexpr unsigned kAllDistros = kHumble | kSinceJazzy;

inline bool includesDistro(unsigned distros, Distro distro) {
  return (distros >> static_cast<unsigned>(distro) & 1U) != 0;
}

/// A key that has an effect in this program. As in ROS 2 the type must match exactly: 1 is not a
/// double.
template <class Parameters>
struct Nav2Key {
  using Member = std::variant<double Parameters::*, int Parameters::*, bool Parameters::*,
                              std::string Parameters::*, std::vector<double> Parameters::*,
                              std::vector<std::string> Parameters::*>;
  const char* name;  // relative to the component: "desired_linear_vel", "smoother.w_data"
  Member member;
  const char* unit;     // "m", "rad/s", "" for none
  const char* meaning;  // a sentence
  unsigned distros = kAllDistros;
};

template <class Parameters>
using Nav2Keys = std::vector<Nav2Key<Parameters>>;

/// Appends the keys of the same struct or of one of its bases.
template <class Parameters, class Base>
void appendKeys(Nav2Keys<Parameters>& keys, const Nav2Keys<Base>& more) {
  for (const Nav2Key<Base>& key : more) {
    std::visit(
        [&](auto member) {
          keys.push_back({key.name, member, key.unit, key.meaning, key.distros});
        },
        key.member);
  }
}
/// All keys of several tables, in this order.
template <class Parameters, class... Tables>
Nav2Keys<Parameters> joinedKeys(const Tables&... tables) {
  Nav2Keys<Parameters> keys;
  (appendKeys(keys, tables), ...);
  return keys;
}

/// A known key without effect in this program, and the reason: "TF is not used".
struct IgnoredKey {
  const char* name;
  const char* why;
  unsigned distros = kAllDistros;
};
using IgnoredKeys = std::vector<IgnoredKey>;

/// The keys, restricted to these branches.
template <class Key>
std::vector<Key> onlyIn(unsigned distros, std::vector<Key> keys) {
  for (Key& key : keys) {
    key.distros &= distros;
  }
  return keys;
}

/// The alternatives are in the order of `Nav2Key::Member`.
using Nav2Value =
    std::variant<double, int, bool, std::string, std::vector<double>, std::vector<std::string>>;
const char* nav2TypeName(const Nav2Value& value);  // ROS 2's type name: "double", "integer" …

/// The given values of a component by key: "desired_linear_vel", "BaseObstacle.scale". Keys are
/// relative to the component's name.
using Nav2ParameterBlock = std::map<std::string, Nav2Value>;

/// The keys of a component.
struct Nav2KeyTable {
  struct Row {
    std::string name;
    Nav2Value fallback;  // default of Nav2's code
    std::string unit, meaning;
    unsigned distros = kAllDistros;
  };
  struct Ignored {
    std::string name, why;
    unsigned distros = kAllDistros;
  };
  std::vector<Row> rows;
  std::vector<Ignored> ignored;

  const Row* find(std::string_view name, Distro distro) const;  // null: the distro has no such key
  bool isKnown(std::string_view name, Distro distro) const;     // in `rows` or in `ignored`
};

/// Returns "plugin::Name" for both spellings; Humble's files also write "plugin/Name".
std::string normalizedPluginClass(std::string_view spelling);

/// Classes of plugins with their default parameters.
template <class Parameters>
using PluginClasses = std::vector<std::pair<std::string, Parameters>>;
template <class Parameters>
std::vector<std::string> namesOf(const PluginClasses<Parameters>& classes) {
  std::vector<std::string> names;
  for (const auto& [name, parameters] : classes) {
    names.push_back(name);
  }
  return names;
}
/// The default parameters of a class; nullopt: no such class.
template <class Parameters>
std::optional<Parameters> defaultsOf(const PluginClasses<Parameters>& classes,
                                     std::string_view wanted) {
  for (const auto& [name, parameters] : classes) {
    if (name == wanted) {
      return parameters;
    }
  }
  return std::nullopt;
}

/// Whether a class that is not in `known` ("package::Class", or bare names) is a misspelling of one
/// of them: its package is that of a known class, or at most two letters differ. Otherwise the
/// class belongs to a package that is not re-implemented.
bool isMisspelt(const std::string& found, const std::vector<std::string>& known);

/// The error for a value whose type is not the key's; ROS 2 rejects such a value at start.
base::Diagnostic wrongType(const std::string& key, const Nav2Value& wanted, const Nav2Value& found);

/// Numbers that a parameter may have, and the text that says so: "0 to 100 s".
struct NumberRange {
  base::Range range;
  const char* wanted;
};

/// Checks the values of parameters. Each check returns whether the value is right; otherwise it
/// adds an error at the key.
class ParameterChecks {
 public:
  /// `prefix` ("FollowPath.") precedes the keys of errors.
  explicit ParameterChecks(base::Diagnostics& problems, std::string prefix = {})
      : problems_(problems), prefix_(std::move(prefix)) {}

  /// The error names what is wanted.
  bool require(bool isRight, const std::string& key, const char* wanted);
  bool require(const std::string& key, double value, const NumberRange& allowed) {
    return require(allowed.range.contains(value), key, allowed.wanted);
  }
  /// The error also names the value.
  bool within(const std::string& key, double value, const NumberRange& allowed) {
    return within(key, value, allowed.range, allowed.wanted);
  }
  bool within(const std::string& key, double value, const base::Range& range,
              const std::string& wanted);

 private:
  base::Diagnostics& problems_;
  std::string prefix_;
};

/// Inverts positive decelerations, with a warning, as Nav2 does.
void invertPositiveDecelerations(
    std::initializer_list<std::pair<const char*, double*>> decelerations,
    base::Diagnostics& problems);

// Not inlined: when inlined, GCC 12 reports false array-bounds warnings for small structs.
template <class Parameters, class Value>
[[gnu::noinline]] Nav2Value memberValue(const Parameters& from, Value Parameters::*member) {
  return Nav2Value(from.*member);
}
template <class Parameters, class Value>
[[gnu::noinline]] void assignMember(Parameters& into, Value Parameters::*member,
                                    const std::string& key, const Nav2Value& given,
                                    base::Diagnostics& problems) {
  if (const Value* const value = std::get_if<Value>(&given)) {
    into.*member = *value;
  } else {
    problems.push_back(wrongType(key, Nav2Value(into.*member), given));
  }
}

/// Appends the rows of a table with the values of `defaults`; `prefix` ("BaseObstacle.") precedes
/// each name.
template <class Parameters>
void addKeyRows(Nav2KeyTable& keys, const Nav2Keys<Parameters>& table, const Parameters& defaults,
                const std::string& prefix = {}) {
  for (const Nav2Key<Parameters>& key : table) {
    const Nav2Value fallback =
        std::visit([&](auto member) { return memberValue(defaults, member); }, key.member);
    keys.rows.push_back({prefix + key.name, fallback, key.unit, key.meaning, key.distros});
  }
}

inline void addIgnoredKeys(Nav2KeyTable& keys, const IgnoredKeys& table) {
  for (const IgnoredKey& key : table) {
    keys.ignored.push_back({key.name, key.why, key.distros});
  }
}

/// The keys of a component with a single struct.
template <class Parameters>
Nav2KeyTable keyTableOf(const std::vector<Nav2Key<Parameters>>& table, const Parameters& defaults,
                        const std::vector<IgnoredKey>& ignored = {}) {
  Nav2KeyTable keys;
  addKeyRows(keys, table, defaults);
  addIgnoredKeys(keys, ignored);
  return keys;
}

/// Returns `defaults` with the values of the block. Keys that `distro` lacks are skipped; each
/// value of another type is a problem.
template <class Parameters>
Parameters applyBlock(Parameters defaults, const Nav2Keys<Parameters>& table,
                      const Nav2ParameterBlock& block, Distro distro, base::Diagnostics& problems,
                      const std::string& prefix = {}) {
  for (const Nav2Key<Parameters>& key : table) {
    const auto given = block.find(prefix + key.name);
    if (given == block.end() || !includesDistro(key.distros, distro)) {
      continue;
    }
    std::visit(
        [&](auto member) { assignMember(defaults, member, given->first, given->second, problems); },
        key.member);
  }
  return defaults;
}

}  // namespace sim2d::nav2
