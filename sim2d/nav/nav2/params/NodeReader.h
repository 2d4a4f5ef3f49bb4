#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Nav2Block.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"

/// Parameters of one node read by tables of keys, and what became of every one of them.
namespace sim2d::nav2 {

constexpr std::size_t kMostNames = 100;  // of plugins, critics, sources, polygons in a list

enum class KeyUse : std::uint8_t {
  Used,
  Idle,         // known, and without effect here
  OtherDistro,  // known to another branch of Nav2 alone
  Unknown
};
const char* keyUseName(KeyUse use);  // "used", "ignored", "ignored", "unknown"

/// A key of the file.
struct KeyNote {
  std::string path;   // "controller_server.FollowPath.max_vel_x"
  std::string value;  // as written
  int line = 0, column = 0;
  KeyUse use = KeyUse::Used;
  std::string why;        // of those without effect
  std::string file = {};  // that has it; empty: it is given outside of files
};
/// Where a node stands in the file.
struct NodeNote {
  std::string node;
  int line = 0;
  std::string file = {};
};
/// A key that the file does not have: Nav2's code has this default, whatever its examples say.
struct DefaultNote {
  std::string path, value;
};
/// A key that has an effect here, in the file or not.
struct KnownKey {
  std::string path;      // "controller_server.FollowPath.max_vel_x"
  std::string node;      // "controller_server"
  std::string value;     // that counts
  std::string fallback;  // of Nav2's code
  std::string type;      // "double" …, as ROS 2 says it
  std::string unit, meaning;
  bool isGiven = false;
};
struct ReadingNotes {
  bool onlyKeys = false;  // unknown keys are not looked for
  std::vector<NodeNote> nodes;
  std::vector<KeyNote> keys;
  std::vector<KnownKey> known;
  std::vector<DefaultNote> defaults;
  base::Diagnostics problems;
};

/// One node while it is read. What nobody asked for is unknown.
class NodeReader {
 public:
  NodeReader(NodeParameters parameters, Distro distro, ReadingNotes& notes);

  const std::string& node() const { return parameters_.node; }
  Distro distro() const { return distro_; }
  const NodeParameters& parameters() const { return parameters_; }
  int line() const { return parameters_.line; }

  /// All that is given below `prefix` ("FollowPath."), each by its own type; nothing counts as
  /// asked for.
  Nav2Block given(const std::string& prefix) const;
  /// What is given for these keys, of the right types: an error for others, which are left out.
  Nav2Block read(const std::string& prefix, const Nav2Keys& keys);
  /// The same into a struct.
  template <class Parameters>
  Parameters read(const std::string& prefix, const std::vector<Nav2Key<Parameters>>& table,
                  const std::vector<IdleKey>& idle, Parameters parameters) {
    Nav2Keys keys;
    addIdle(keys, idle);
    for (const Nav2Key<Parameters>& key : table) {
      forMember(parameters, key, [&](const auto& value) {
        keys.rows.push_back({key.name, Nav2Value(value), key.unit, key.meaning, key.distros});
      });
    }
    const Nav2Block block = read(prefix, keys);
    for (const Nav2Key<Parameters>& key : table) {
      const auto given = block.find(key.name);
      if (given != block.end() && isIn(key.distros, distro_)) {
        forMember(parameters, key, [&](auto& value) {
          value = std::get<std::decay_t<decltype(value)>>(given->second);
        });
      }
    }
    return parameters;
  }
  /// One text, list of texts or number; nothing when it is absent, or of another type (told).
  template <class T>
  std::optional<T> value(const std::string& name) {
    Nav2Keys keys;
    keys.rows.push_back({name, Nav2Value(T()), {}, {}, kEveryDistro});
    const Nav2Block block = read({}, keys);
    const auto found = block.find(name);
    return found == block.end() ? std::nullopt : std::optional<T>(std::get<T>(found->second));
  }

  /// The value of a parameter, also of one that is not in the file: under an older name, or because
  /// the replacement of a plugin needs it. What was set from outside stays. Problems are reported
  /// at the place of `value`.
  void supply(const std::string& name, base::YamlNode value);
  /// Removes a parameter as if the file did not have it.
  void drop(const std::string& name);
  /// The key of the file counts as used.
  void markUsed(const std::string& name);
  /// Below `prefix` only those of `keys` remain whose values are of the right type; the others have
  /// no effect, for the reason `why`.
  void keepOnly(const std::string& prefix, const Nav2Keys& keys, const std::string& why);

  /// Keys without effect: `name` itself, or with a '.' at the end all below it.
  void know(const std::string& name, const std::string& why, unsigned distros = kEveryDistro);
  /// The problem, at the place of the parameter; at that of the node when it is absent.
  void tell(const std::string& name, base::Diagnostic problem);
  /// Given, and no placeholder.
  bool has(const std::string& name) const {
    return parameters_.find(name) != nullptr && !isPlaceholder(name);
  }
  /// Given, but launch files replace the value ("KEEPOUT_ZONE_ENABLED"): it counts as absent.
  bool isPlaceholder(const std::string& name) const {
    const GivenParameter* const given = parameters_.find(name);
    return given != nullptr && given->isPlaceholder;
  }

  /// Keys that were not read are unknown; the problem has the nearest name of the same block. A
  /// block without known keys is one problem, not one per key.
  void finish();

 private:
  /// Calls `visit` with the member of a key. What the struct is too small to hold it does not: GCC
  /// warns of code that would.
  template <class Parameters, class Visit>
  static void forMember(Parameters& parameters, const Nav2Key<Parameters>& key, Visit visit) {
    std::visit(
        [&](auto member) {
          if constexpr (sizeof(parameters.*member) <= sizeof(Parameters)) {
            visit(parameters.*member);
          }
        },
        key.member);
  }
  void note(const GivenParameter& parameter, KeyUse use, std::string why);
  /// A warning with the default that counts instead.
  void tellPlaceholder(GivenParameter& given, const Nav2Value& fallback);
  void noteKnown(const Nav2Keys::Row& row, const std::string& name, const GivenParameter* given);
  void noteUnlisted();
  void noteUnknown();
  /// The outermost block around a key that has no known keys, with a '.' at its end; or empty.
  std::string unknownBlock(const std::string& name) const;
  std::vector<std::string> namesBeside(const std::string& name) const;
  std::vector<std::string> blocksBeside(const std::string& block) const;
  /// The value as the kind of the fallback; what does not fit is told.
  std::optional<Nav2Value> soundValue(GivenParameter& given, const Nav2Value& fallback);
  std::string pathOf(const std::string& name) const { return parameters_.node + "." + name; }

  NodeParameters parameters_;
  std::vector<std::shared_ptr<const base::YamlNode>> supplied_;  // of parameters_
  Distro distro_;
  ReadingNotes& notes_;
  std::set<std::string> asked_;     // given ones
  std::vector<std::string> known_;  // names that there are, given or not
};

}  // namespace sim2d::nav2
