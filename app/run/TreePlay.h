#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bt/engine/TreeState.h"
#include "sim2d/world/Compatibility.h"

/// One behaviour tree by itself, ticked against scripted leaves: for looking at what it does.
namespace app {

struct PlaySetup {
  std::string tree;  // file; of a person, or of a robot (Nav2's) when its nodes say so
  /// YAML file of what leaves answer, `IsRobotVisible: [FAILURE, SUCCESS]`. A key is the name of a
  /// leaf or the ID of leaves; the statuses are those of its calls in order, the last one repeats.
  /// One status alone needs no list. Empty: every leaf succeeds.
  std::string script;
  double dt = 0.05;  // [s]
  std::uint64_t seed = 1;
  sim2d::Compatibility compatibility;
};

/// A leaf of people's or robots' trees was called, or halted while it was RUNNING.
struct LeafCall {
  int node = 0;
  base::NodeStatus status = base::NodeStatus::Idle;
  bool isHalt = false;
};

class TreePlay {
 public:
  virtual ~TreePlay() = default;
  /// Loads and compiles; every problem of tree and script, also names that no leaf has (warnings).
  static base::Result<std::unique_ptr<TreePlay>> create(const PlaySetup& setup);

  /// One step, the first one is number 1.
  virtual base::NodeStatus tick() = 0;
  virtual const std::vector<LeafCall>& calls() const = 0;  // of the last tick, in order
  /// What stopped the tree for good (a failing script of the tree …); none = it goes on.
  virtual base::Diagnostics fault() const = 0;
  virtual const bt::Program& program() const = 0;
};

}  // namespace app
