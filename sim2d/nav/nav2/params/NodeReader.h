#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim2d/base/Find.h"
#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"

/// Reads the parameters of one node by tables of keys and records how each of them was used.
namespace sim2d::nav2 {

constexpr std::size_t kMaxNames = 100;  // in a list of plugins, critics, sources or polygons

enum class KeyUse : std::uint8_t {
  Used,
  Ignored,      // known, without effect in this program
  OtherDistro,  // known only to other branches of Nav2
  Unknown
};
const char* keyUseName(KeyUse use);  // "used", "ignored", "ignored", "unknown"

/// A key of the file and its use.
struct KeyUsage {
  std::string path;   // "controller_server.FollowPath.max_vel_x"
  std::string value;  // as written
  int line = 0, column = 0;
  KeyUse use = KeyUse::Used;
  std::string why;        // why it has no effect
  std::string file = {};  // empty: given outside of files
};
/// Position of a node in the file.
struct NodeLocation {
  std::string node;
  int line = 0;
  std::string file = {};
};
/// A key absent from the file: the default of Nav2's code applies, not that of its example files.
struct DefaultedKey {
  std::string path, value;
};
/// A key that has an effect, in the file or not.
struct EffectiveKey {
  std::string path;      // "controller_server.FollowPath.max_vel_x"
  std::string node;      // "controller_server"
  std::string value;     // effective value
  std::string fallback;  // default of Nav2's code
  std::string type;      // ROS 2's type name: "double" …
  std::string unit, meaning;
  bool isGiven = false;
};
struct ParameterNotes {
  bool onlyKeys = false;  // unknown keys are not searched
  std::vector<NodeLocation> nodes;
  std::vector<KeyUsage> keys;
  std::vector<EffectiveKey> known;
  std::vector<DefaultedKey> defaults;
  base::Diagnostics problems;
};

/// Reads one node. Parameters that no table requests are unknown.
class NodeReader {
 public:
  NodeReader(NodeParameters parameters, Distro distro, ParameterNotes& notes);

  const std::string& node() const { return parameters_.node; }
  Distro distro() const { return distro_; }
  const NodeParameters& parameters() const { return parameters_; }
  int line() const { return parameters_.line; }

  /// All values below `prefix` ("FollowPath."), each with its own type. Does not mark them as read.
  Nav2ParameterBlock given(const std::string& prefix) const;
  /// The values of these keys. A value of a wrong type is an error and is skipped.
  Nav2ParameterBlock read(const std::string& prefix, const Nav2KeyTable& keys);
  /// The same into a struct.
  template <class Parameters>
  Parameters read(const std::string& prefix, const std::vector<Nav2Key<Parameters>>& table,
                  const std::vector<IgnoredKey>& ignored, Parameters parameters) {
    base::Diagnostics none;  // wrong types are reported here
    const Nav2ParameterBlock block = read(prefix, keyTableOf(table, parameters, ignored));
    return applyBlock(std::move(parameters), table, block, distro_, none);
  }
  /// One string, list of strings or number; nullopt when it is absent or has a wrong type
  /// (reported). `fallback`: the default that is reported.
  template <class T>
  std::optional<T> value(const std::string& name, const T& fallback = T()) {
    Nav2KeyTable keys;
    keys.rows.push_back({name, Nav2Value(fallback), {}, {}, kAllDistros});
    const Nav2ParameterBlock block = read({}, keys);
    const auto found = block.find(name);
    return found == block.end() ? std::nullopt : std::optional<T>(std::get<T>(found->second));
  }

  /// Sets a parameter that may be absent from the file, such as one read under an older name or
  /// required by the replacement of a plugin. Values set from outside are kept. Problems are
  /// reported at the position of `value` in `file`.
  void supply(const std::string& name, base::YamlNode value, std::string file);
  /// Removes a parameter as if the file did not contain it.
  void drop(const std::string& name);
  /// Marks a key of the file as used.
  void markUsed(const std::string& name);
  /// Keeps below `prefix` only those `keys` whose values have the right type; marks the others as
  /// ignored for the reason `why`.
  void keepOnly(const std::string& prefix, const Nav2KeyTable& keys, const std::string& why);

  /// Marks keys as ignored: `name` itself, or all keys below it if it ends with '.'.
  void markIgnored(const std::string& name, const std::string& why, unsigned distros = kAllDistros);
  /// Reports a problem at the position of the parameter, or of the node when the parameter is
  /// absent.
  void report(const std::string& name, base::Diagnostic problem);
  /// Whether the parameter is given and is not a placeholder.
  bool has(const std::string& name) const {
    return parameters_.find(name) != nullptr && !isPlaceholder(name);
  }
  /// Whether the value is a launch placeholder ("KEEPOUT_ZONE_ENABLED"), which counts as absent.
  bool isPlaceholder(const std::string& name) const {
    const GivenParameter* const given = parameters_.find(name);
    return given != nullptr && given->isPlaceholder;
  }

  /// Reports keys that were not read as unknown, each with the nearest name of the same block. A
  /// block without known keys is one problem.
  void finish();

 private:
  void recordUse(const GivenParameter& parameter, KeyUse use, std::string why);
  /// A warning with the default that is used instead.
  void reportPlaceholder(GivenParameter& given, const Nav2Value& fallback);
  void recordKnownKey(const Nav2KeyTable::Row& row, const std::string& name,
                      const GivenParameter* given);
  void ignoreUnlistedBlocks();
  void reportUnknownKeys();
  /// The outermost block around a key that contains no known keys, with a trailing '.'; or empty.
  std::string unknownBlock(const std::string& name) const;
  std::vector<std::string> siblingKeys(const std::string& name) const;
  std::vector<std::string> siblingBlocks(const std::string& block) const;
  /// The value converted to the type of `fallback`; reports a value that does not fit.
  std::optional<Nav2Value> checkedValue(GivenParameter& given, const Nav2Value& fallback);
  std::string pathOf(const std::string& name) const { return parameters_.node + "." + name; }

  NodeParameters parameters_;
  std::vector<std::shared_ptr<const base::YamlNode>> supplied_;  // keeps nodes of parameters_ alive
  Distro distro_;
  ParameterNotes& notes_;
  std::set<std::string> readNames_;  // names of given parameters that were read
  std::vector<std::string> known_;   // names that a table has, given or not
};

/// Reads the plugins that a server lists. Private to this folder.

/// Names of a list of plugins without duplicates, for which it reports a warning.
std::vector<std::string> uniquePluginNames(NodeReader& node, const std::string& list,
                                           const std::vector<std::string>& names);

/// The class of a plugin. Without one: `fallback`, or an error if that is empty.
std::string pluginClass(NodeReader& node, const std::string& name, const std::string& fallback);

/// The class of a plugin that Nav2 loads under this name when the server's list is absent.
struct DefaultPlugin {
  const char* name;
  const char* type;
};
/// The class in `defaults` if the node has no `list`; empty: none.
template <class Defaults>
std::string defaultClass(const NodeReader& node, const std::string& list, const std::string& name,
                         const Defaults& defaults) {
  const DefaultPlugin* const found = base::findBy(defaults, &DefaultPlugin::name, name);
  return found == nullptr || node.has(list) ? std::string() : found->type;
}

/// Reports an unknown class at its position with the nearest known one.
void reportUnknownPlugin(NodeReader& node, const std::string& name, const std::string& found,
                         const std::vector<std::string>& known);

/// Reports problems of a server at the positions of the keys that they name, else at the plugin's
/// class.
void reportProblems(NodeReader& node, const base::Diagnostics& problems);

/// Reports the substitute of a class that is not re-implemented, and the reason.
void reportSubstitute(NodeReader& node, const std::string& name, const std::string& found,
                      const std::string& substitute, const std::string& why);
/// Reports that a class is left out because it is not re-implemented.
void reportOmittedPlugin(NodeReader& node, const std::string& name, const std::string& found,
                         const std::string& why);

/// Reads the keys of a plugin of class `type`; `find(type)` returns a struct like PluginLookup. A
/// class of Nav2 that is not re-implemented is replaced by the nearest one, with a warning.
template <class Find, class Variant>
void readPluginBlock(NodeReader& node, const std::string& name, const std::string& type,
                     const Find& find, const std::vector<std::string>& known,
                     std::vector<std::pair<std::string, Variant>>& to) {
  auto lookup = find(type);
  const std::string prefix = name + ".";
  const bool isReplaced = !lookup.parameters && !lookup.why.empty() && !lookup.name.empty();
  if (isReplaced) {
    reportSubstitute(node, name, type, lookup.name, lookup.why);
    lookup = find(lookup.name);
  }
  if (!lookup.parameters) {
    reportUnknownPlugin(node, name, type, known);
    node.markIgnored(prefix, "its class is not implemented");
    return;
  }
  Variant parameters = *std::move(lookup.parameters);
  std::visit([&](auto& held) { held = node.read(prefix, keysOf(held), ignoredKeysOf(held), held); },
             parameters);
  if (isReplaced) {
    node.markIgnored(prefix, "a key of " + type);
  }
  for (const std::string& message : parameterErrors(parameters)) {
    const std::string key = message.substr(0, message.find(' '));
    node.report(prefix + key, base::error("nav2.bad-value", {prefix + message}));
  }
  to.emplace_back(name, std::move(parameters));
}

}  // namespace sim2d::nav2
