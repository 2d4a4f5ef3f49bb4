#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bt/engine/Program.h"
#include "bt/engine/TreeState.h"
#include "sim2d/base/Result.h"
#include "sim2d/world/Compatibility.h"

/// Ticks one behaviour tree with scripted leaves, to inspect its behaviour.
namespace app {

struct PlaySetup {
  std::string tree;  // tree file of an agent, or of a robot (Nav2) if its nodes indicate it
  /// YAML file with the results of leaves, `IsRobotVisible: [FAILURE, SUCCESS]`. A key is the name
  /// or ID of leaves; the statuses are those of successive calls, the last one repeats. A single
  /// status needs no list. Empty: every leaf succeeds.
  std::string script;
  double dt = 0.05;  // [s]
  std::uint64_t seed = 1;
  sim2d::Compatibility compatibility;
};

/// A leaf was called, or halted while RUNNING.
struct LeafCall {
  int node = 0;
  base::NodeStatus status = base::NodeStatus::Idle;
  bool isHalt = false;
};

class TreePlay {
 public:
  virtual ~TreePlay() = default;
  /// Loads and compiles the tree; reports every problem of tree and script, also names that match
  /// no leaf (warnings).
  static base::Result<std::unique_ptr<TreePlay>> create(const PlaySetup& setup);

  /// Ticks once; the first step is number 1.
  virtual base::NodeStatus tick() = 0;
  virtual const std::vector<LeafCall>& calls() const = 0;  // of the last tick, in order
  /// The error that stopped the tree permanently (a failing script in the tree …); empty if there
  /// is none.
  virtual base::Diagnostics fault() const = 0;
  virtual const bt::Program& program() const = 0;
};

/// The scripted results of leaves while a tree is played.
struct LeafScript {
  struct Entry {
    std::string leaf;
    std::vector<base::NodeStatus> statuses;  // never empty; SUCCESS, FAILURE or RUNNING
    int line = 0, column = 0;
  };
  std::string path;
  std::vector<Entry> entries;  // in file order

  const Entry* find(const std::string& leaf) const {  // nullptr: not in the script
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&leaf](const Entry& entry) { return entry.leaf == leaf; });
    return found == entries.end() ? nullptr : &*found;
  }
};

/// Reports every problem of the file with line and column.
base::Result<LeafScript> readLeafScript(const std::string& path);

/// Warnings for names in the script that match no leaf, most likely typing errors.
base::Diagnostics unusedNames(const bt::Program& program, const LeafScript& script);

}  // namespace app
