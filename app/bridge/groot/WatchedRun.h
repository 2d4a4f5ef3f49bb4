#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/bridge/groot/WatchedTree.h"
#include "sim2d/base/Types.h"

/// The requests of Groot2 and their answers as bytes, little-endian. Source: groot2_protocol.h of
/// BehaviorTree.CPP 4, protocol 2. A message has parts; the first of a request has 6 bytes
/// (protocol, kind, a number by which the answer is known), that of an answer the same and 16 bytes
/// that name the run.
namespace groot {

using Message = std::vector<std::string>;  // its parts
using RunName = std::array<char, 16>;

/// A run as it is told of. One thread at a time.
class WatchedRun {
 public:
  using Entries = std::vector<std::pair<std::string, std::string>>;  // key, value

  WatchedRun(WatchedTree tree, const RunName& name);

  /// A node returned that; others than those of the tree do not count. `time` since the run began
  /// [s].
  void set(int node, base::NodeStatus status, double time);
  void setBlackboard(Entries entries) { entries_ = std::move(entries); }
  /// The answer to any message, also one that makes no sense.
  Message answer(const Message& request);

 private:
  struct Transition {
    std::uint64_t microseconds = 0;
    std::uint16_t node = 0;  // uid
    std::uint8_t status = 0;
  };

  std::string statuses() const;
  std::string blackboards(const std::string& names) const;
  Message record(const std::string& word);
  std::string takeTransitions();
  std::optional<Message> contentOf(char kind, const Message& request, std::string& problem);

  WatchedTree tree_;
  RunName name_;
  std::vector<base::NodeStatus> statuses_;
  std::vector<std::uint8_t> told_;  // as Groot2 has them: 10 and the one before for Idle
  Entries entries_;
  bool isRecording_ = false;
  std::vector<Transition> transitions_;
};

}  // namespace groot
