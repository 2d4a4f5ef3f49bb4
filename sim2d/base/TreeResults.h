#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim2d/base/Types.h"

namespace base {

/// A set of node statuses. An enumeration instead of an unsigned char: compilers assume that
/// writing through a character type may change any object, which makes ticks slower.
enum class StatusSet : std::uint8_t {};

inline StatusSet with(StatusSet set, NodeStatus status) {
  return static_cast<StatusSet>(static_cast<unsigned>(set) | 1U << static_cast<unsigned>(status));
}
inline bool contains(StatusSet set, NodeStatus status) {
  return (static_cast<unsigned>(set) >> static_cast<unsigned>(status) & 1U) != 0;
}

/// Which statuses the nodes of a behaviour tree have returned since the beginning of a run, also
/// those of nodes that were ticked several times in a step. SKIPPED: the node was called, but a
/// condition of its own prevented its execution.
struct TreeResults {
  std::string owner;                                      // name of the person or robot
  std::shared_ptr<const std::vector<std::string>> paths;  // of the nodes, as in trees.csv
  std::vector<StatusSet> returned;                        // per node
  /// Per node: the structure of the tree proves that it is never executed. Null: unknown.
  std::shared_ptr<const std::vector<bool>> unreachable;
};

/// Adds the statuses to the entry of the same owner and tree, or a new entry. If trees have equal
/// paths and different marks of unreachable nodes, their entry has no marks.
void addTreeResults(const TreeResults& more, std::vector<TreeResults>& to);

}  // namespace base
