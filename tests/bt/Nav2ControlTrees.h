#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// Nav2's control nodes a second time, from their description alone and without the engine: what
/// the program's are compared with. Ticks and halts follow BehaviorTree.CPP: a child is halted only
/// while it runs.
namespace controltrees {

enum class Status { Idle, Running, Success, Failure };

class Node {
 public:
  Node() = default;
  virtual ~Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  Node(Node&&) = delete;
  Node& operator=(Node&&) = delete;

  Status execute() {
    status_ = tick();
    return status_;
  }
  /// What a parent does with a child that it does not tick any more.
  void stop() {
    if (status_ == Status::Running) {
      halt();
    }
    status_ = Status::Idle;
  }
  void setIdle() { status_ = Status::Idle; }

 protected:
  Status status() const { return status_; }
  virtual Status tick() = 0;
  virtual void halt() = 0;

 private:
  Status status_ = Status::Idle;
};

/// Answers by a script; a halt is written down. One that `keeps` its result, as a
/// StatefulActionNode does, is not asked again until its parent resets it; a condition is.
class Leaf final : public Node {
 public:
  Leaf(std::string name, bool keeps, std::function<char(const std::string&)> answer,
       std::vector<std::string>& log)
      : name_(std::move(name)), keeps_(keeps), answer_(std::move(answer)), log_(log) {}

 private:
  Status tick() override {
    if (keeps_ && (status() == Status::Success || status() == Status::Failure)) {
      return status();
    }
    const char letter = answer_(name_);
    log_.push_back(name_ + ":" + letter);
    return letter == 'R' ? Status::Running : letter == 'S' ? Status::Success : Status::Failure;
  }
  void halt() override { log_.push_back(name_ + ":H"); }

  std::string name_;
  bool keeps_;
  std::function<char(const std::string&)> answer_;
  std::vector<std::string>& log_;
};

class Control : public Node {
 public:
  void add(std::unique_ptr<Node> child) { children_.push_back(std::move(child)); }

 protected:
  std::size_t count() const { return children_.size(); }
  Node& child(std::size_t i) { return *children_[i]; }
  void stopChildren() {
    for (const auto& each : children_) {
      each->stop();
    }
  }
  void halt() override {
    forget();
    stopChildren();
  }
  virtual void forget() {}
  Status end(Status status) {
    halt();
    return status;
  }

 private:
  std::vector<std::unique_ptr<Node>> children_;
};

class Pipeline final : public Control {
  std::size_t farthest_ = 0;
  void forget() override { farthest_ = 0; }
  Status tick() override {
    for (std::size_t i = 0; i < count(); ++i) {
      const Status status = child(i).execute();
      if (status == Status::Failure) {
        return end(status);
      }
      if (status == Status::Running && i >= farthest_) {
        farthest_ = i;
        return status;
      }
    }
    return end(Status::Success);
  }
};

class Recovery final : public Control {
 public:
  explicit Recovery(int retries) : retries_(retries) {}

 private:
  int retries_, used_ = 0;
  bool isRecovering_ = false;
  void forget() override {
    used_ = 0;
    isRecovering_ = false;
  }
  Status tick() override {
    for (;;) {
      const Status status = child(isRecovering_ ? 1 : 0).execute();
      const bool isGood = status == Status::Success;
      if (status == Status::Running) {
        return status;
      }
      if (isRecovering_ ? !isGood : (isGood || used_ == retries_)) {
        return end(status);
      }
      child(isRecovering_ ? 1 : 0).stop();
      used_ += isRecovering_ ? 1 : 0;
      isRecovering_ = !isRecovering_;
    }
  }
};

class RoundRobin final : public Control {
 public:
  explicit RoundRobin(bool wraps) : wraps_(wraps) {}

 private:
  bool wraps_;
  std::size_t current_ = 0, failed_ = 0;
  void forget() override { current_ = failed_ = 0; }
  Status tick() override {
    while (failed_ < count()) {
      const Status status = child(current_).execute();
      if (status == Status::Running) {
        return status;
      }
      if (++current_ == count()) {
        if (!wraps_) {
          break;
        }
        current_ = 0;
      }
      if (status == Status::Success) {
        failed_ = 0;
        stopChildren();
        return status;
      }
      ++failed_;
    }
    return end(Status::Failure);
  }
};

class Nonblocking final : public Control {
  Status tick() override {
    bool isRunning = false;
    for (std::size_t i = 0; i < count(); ++i) {
      const Status status = child(i).execute();
      if (status == Status::Failure) {
        return end(status);
      }
      isRunning = isRunning || status == Status::Running;
    }
    return isRunning ? Status::Running : end(Status::Success);
  }
};

}  // namespace controltrees
