#pragma once

#include <any>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "sim2d/base/Types.h"

/// A behaviour tree engine of the usual kind, to measure ours against, on the plan of
/// BehaviorTree.CPP: nodes on the heap with a virtual tick, ports as text that is looked at in
/// every tick, a blackboard of shared entries found by text, locks around entries and statuses,
/// conditions before and after each node. Reactive nodes and leaves alone.
namespace plain {

using base::NodeStatus;

class Blackboard {
 public:
  template <class T>
  void set(const std::string& key, T value) {
    const std::shared_ptr<Entry> entry = makeEntry(key);
    const std::lock_guard<std::mutex> guard(entry->mutex);
    entry->value = std::any(std::move(value));
    ++entry->version;
  }
  template <class T>
  std::optional<T> get(const std::string& key) const {
    const std::shared_ptr<Entry> entry = find(key);
    if (!entry) {
      return std::nullopt;
    }
    const std::lock_guard<std::mutex> guard(entry->mutex);
    const T* const value = std::any_cast<T>(&entry->value);
    return value ? std::optional<T>(*value) : std::nullopt;
  }

 private:
  struct Entry {
    std::mutex mutex;
    std::any value;
    std::uint64_t version = 0;
  };

  std::shared_ptr<Entry> find(const std::string& key) const {
    const std::lock_guard<std::mutex> guard(mutex_);
    const auto found = entries_.find(key);
    return found == entries_.end() ? nullptr : found->second;
  }
  std::shared_ptr<Entry> makeEntry(const std::string& key) {
    const std::lock_guard<std::mutex> guard(mutex_);
    std::shared_ptr<Entry>& entry = entries_[key];
    if (!entry) {
      entry = std::make_shared<Entry>();
    }
    return entry;
  }

  mutable std::mutex mutex_;
  std::unordered_map<std::string, std::shared_ptr<Entry>> entries_;
};

using Ports = std::unordered_map<std::string, std::string>;  // port -> "{key}"
using Condition = std::function<bool()>;

class Node {
 public:
  Node(std::string name, Ports ports, std::shared_ptr<Blackboard> blackboard)
      : name_(std::move(name)), ports_(std::move(ports)), blackboard_(std::move(blackboard)) {}
  virtual ~Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  NodeStatus execute() {
    for (const Condition& condition : before_) {
      if (condition && condition()) {
        return NodeStatus::Skipped;
      }
    }
    const NodeStatus result = tick();
    for (const Condition& script : after_) {
      if (script) {
        script();
      }
    }
    setStatus(result);
    return result;
  }
  void reset() {
    if (status() == NodeStatus::Running) {
      halt();
    }
    setStatus(NodeStatus::Idle);
  }
  NodeStatus status() const {
    const std::lock_guard<std::mutex> guard(mutex_);
    return status_;
  }

 protected:
  virtual NodeStatus tick() = 0;
  virtual void halt() {}

  template <class T>
  T input(const std::string& port) const {
    const auto text = ports_.find(port);
    if (text == ports_.end() || text->second.size() < 3 || text->second.front() != '{') {
      throw std::runtime_error(name_ + ": no input " + port);
    }
    const std::string key = text->second.substr(1, text->second.size() - 2);
    const std::optional<T> value = blackboard_->get<T>(key);
    if (!value) {
      throw std::runtime_error(name_ + ": nothing in " + key);
    }
    return *value;
  }

 private:
  void setStatus(NodeStatus status) {
    const std::lock_guard<std::mutex> guard(mutex_);
    status_ = status;
  }

  std::string name_;
  Ports ports_;
  std::shared_ptr<Blackboard> blackboard_;
  std::array<Condition, 4> before_;
  std::array<Condition, 4> after_;
  mutable std::mutex mutex_;
  NodeStatus status_ = NodeStatus::Idle;
};

class Control : public Node {
 public:
  using Node::Node;
  void add(std::unique_ptr<Node> child) { children_.push_back(std::move(child)); }

 protected:
  void halt() override { resetAll(nullptr); }
  void resetAll(const Node* kept) {
    for (const std::unique_ptr<Node>& child : children_) {
      if (child.get() != kept) {
        child->reset();
      }
    }
  }
  /// ReactiveSequence (`stop` = FAILURE) and ReactiveFallback (SUCCESS).
  NodeStatus tickUntil(NodeStatus stop, NodeStatus otherwise) {
    for (const std::unique_ptr<Node>& child : children_) {
      const NodeStatus status = child->execute();
      if (status == NodeStatus::Running) {
        resetAll(child.get());
        return status;
      }
      if (status == stop) {
        resetAll(nullptr);
        return status;
      }
    }
    resetAll(nullptr);
    return otherwise;
  }

 private:
  std::vector<std::unique_ptr<Node>> children_;
};

class ReactiveSequence : public Control {
 public:
  using Control::Control;

 protected:
  NodeStatus tick() override { return tickUntil(NodeStatus::Failure, NodeStatus::Success); }
};

class ReactiveFallback : public Control {
 public:
  using Control::Control;

 protected:
  NodeStatus tick() override { return tickUntil(NodeStatus::Success, NodeStatus::Failure); }
};

}  // namespace plain
