#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "bt/tree/TreeSpec.h"
#include "sim2d/base/Result.h"
#include "sim2d/base/Types.h"
#include "sim2d/world/World.h"

namespace groot {

/// A tree in the form that Groot2 expects: each SubTree instance is a separate tree, and every node
/// has a number `_uid`, counted from 1 in the order of `bt::Program`.
struct GrootTree {
  struct SubTree {
    std::string fullPath;  // "": main tree; "walk", "walk/Greet::7": SubTree names
    std::string prefix;    // of its blackboard entries: "" or "Main/walk/"
    std::string treeId;
  };
  std::string xml;
  std::vector<SubTree> parts;  // main tree first
  /// SubTree keys remapped to entries of the caller, with those entries: {"Main/walk/x", "y"}.
  std::vector<std::pair<std::string, std::string>> aliases;
  int nodes = 0;
};

/// `table` must compile (`bt::compile`).
GrootTree grootTree(const bt::TreeTable& table);

/// Encoding of Groot2 requests and responses, little-endian. Source: groot2_protocol.h of
/// BehaviorTree.CPP 4, protocol version 2. A message has several parts. The first part of a request
/// has 6 bytes (protocol, kind, request number); that of a response repeats them and adds a 16-byte
/// run identifier.

using Message = std::vector<std::string>;  // the parts of a message
using RunName = std::array<char, 16>;

/// The state of a run that Groot2 can query. Not thread-safe.
class GrootProtocol {
 public:
  using Entries = std::vector<std::pair<std::string, std::string>>;  // key, value

  GrootProtocol(GrootTree tree, const RunName& name);

  /// Sets the status of a node; unknown nodes are ignored. `time`: since the start of the run [s].
  void set(int node, base::NodeStatus status, double time);
  void setBlackboard(Entries entries) { entries_ = std::move(entries); }
  /// Returns the response to any message, including invalid ones.
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

  GrootTree tree_;
  RunName name_;
  std::vector<base::NodeStatus> statuses_;
  std::vector<std::uint8_t> encodedStatuses_;  // in Groot2's encoding: Idle is 10 + previous status
  Entries entries_;
  bool isRecording_ = false;
  std::vector<Transition> transitions_;
};

/// Serves Groot2 on a local port (ZeroMQ, REP) in its own thread. The next port is also bound:
/// Groot2 connects to it for breakpoints, which are not supported.
class GrootServer {
 public:
  /// Errors: the ports are not available. `port` 0: two free ports.
  static base::Result<std::unique_ptr<GrootServer>> listen(std::uint16_t port, GrootProtocol run);
  ~GrootServer();
  GrootServer(const GrootServer&) = delete;
  GrootServer& operator=(const GrootServer&) = delete;
  GrootServer(GrootServer&&) = delete;
  GrootServer& operator=(GrootServer&&) = delete;

  std::uint16_t port() const { return port_; }
  /// Calls `change` with exclusive access to the run. Thread-safe.
  template <class Change>
  void change(Change change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    change(run_);
  }
  bool hadClient() const { return hadRequest_; }  // a request has ever arrived

 private:
  struct Sockets;
  GrootServer(std::unique_ptr<Sockets> sockets, std::uint16_t port, GrootProtocol run);
  void serve();

  std::unique_ptr<Sockets> sockets_;  // used by the thread
  std::uint16_t port_ = 0;
  std::mutex mutex_;
  GrootProtocol run_;
  std::atomic<bool> hadRequest_{false};
  std::atomic<bool> isStopping_{false};
  std::thread thread_;
};

/// Publishes the behavior tree of one person of a run to Groot2. Does not affect the run. Used in
/// the thread of the run; the world must outlive it.
class GrootPublisher {
 public:
  /// `human`: index in the world; `tree`: the tree of that person. Errors: those of GrootServer,
  /// and a tree with more nodes than Groot2 supports.
  static base::Result<std::unique_ptr<GrootPublisher>> open(std::uint16_t port, sim2d::World& world,
                                                            int human, const bt::TreeTable& tree);

  std::uint16_t port() const { return server_->port(); }
  bool hadClient() const { return server_->hadClient(); }
  /// Call for each state once, in order.
  void show(const sim2d::Frame& frame);

 private:
  GrootPublisher(sim2d::World& world, int human, std::unique_ptr<GrootServer> server);

  sim2d::World& world_;
  int human_ = 0;
  int id_ = 0;
  std::optional<std::chrono::steady_clock::time_point> lastBlackboard_;  // last blackboard update
  std::unique_ptr<GrootServer> server_;
};

}  // namespace groot
