#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/bt/PageScript.h"

/// A second implementation of behaviour trees, made from the written description of
/// BehaviorTree.CPP's semantics alone: it interprets the description of the nodes, word for word,
/// and shares nothing with bt/engine.
namespace page {

enum class Status { Idle, Running, Success, Failure, Skipped };

inline bool isDone(Status status) {
  return status == Status::Success || status == Status::Failure;
}

/// A node as written in a file.
struct Spec {
  std::string id;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<Spec> children;

  const std::string* find(const std::string& name) const {
    for (const auto& [key, text] : attributes) {
      if (key == name) {
        return &text;
      }
    }
    return nullptr;
  }
};
using Trees = std::map<std::string, Spec>;  // by tree ID

struct Entry {
  Value value;
  std::string type;  // "int", "double", "string"; empty: any
  std::uint64_t writes = 0;
};

/// A blackboard. Keys that are mapped stand for a key of the parent.
class Board {
 public:
  explicit Board(Board* parent = nullptr) : parent_(parent) {}
  std::map<std::string, std::string> mapped;
  bool isAutomatic = false;

  /// Where the key is kept, and under which name.
  std::pair<Board*, std::string> place(const std::string& key) {
    if (key[0] == '@') {
      return root().place(key.substr(1));
    }
    const auto found = mapped.find(key);
    if (found != mapped.end()) {
      return parent_->place(found->second);
    }
    const bool isParents = isAutomatic && key[0] != '_' && entries_.count(key) == 0;
    return isParents ? parent_->place(key) : std::make_pair(this, key);
  }
  Entry* find(const std::string& key) {
    const auto [board, name] = place(key);
    const auto found = board->entries_.find(name);
    return found == board->entries_.end() ? nullptr : &found->second;
  }
  Entry& make(const std::string& key) {
    const auto [board, name] = place(key);
    return board->entries_[name];
  }
  Entry& makeOwn(const std::string& key) { return entries_[key]; }
  void removeOwn(const std::string& key) {
    if (mapped.count(key) == 0) {
      entries_.erase(key);
    }
  }

 private:
  Board& root() { return parent_ ? parent_->root() : *this; }
  Board* parent_;
  std::map<std::string, Entry> entries_;
};

inline bool isPointer(const std::string& text) {
  return text.size() >= 3 && text.front() == '{' && text.back() == '}';
}
inline std::string keyIn(const std::string& text, const std::string& port) {
  return text == "{=}" ? port : text.substr(1, text.size() - 2);
}

class BoardVariables : public Variables {
 public:
  explicit BoardVariables(Board& board) : board_(board) {}
  Value read(const std::string& key) override {
    const Entry* const entry = board_.find(key);
    if (!entry || entry->value.kind == Value::None) {
      throw Fault{"unknown variable " + key};
    }
    return entry->value;
  }
  Value assign(const std::string& key, const Value& value, bool creates) override {
    Entry* entry = board_.find(key);
    if (!entry && !creates) {
      throw Fault{"no entry " + key};
    }
    entry = entry ? entry : &board_.make(key);
    const Value& before = entry->value;
    if (before.kind != Value::None && before.kind != value.kind) {
      throw Unsaid{"an entry changes between number and text"};
    }
    if (value.kind == Value::Text && !entry->type.empty() && entry->type != "string") {
      throw Unsaid{"text for an entry of a typed port"};
    }
    constexpr double kLargest = 9e18;  // of a whole number
    const bool isReal = value.kind == Value::Number && (value.number != std::floor(value.number) ||
                                                        std::fabs(value.number) > kLargest);
    if (before.whole && isReal) {
      throw Unsaid{"a real number for an entry that was made by a whole one"};
    }
    const bool whole = before.kind == Value::None ? value.whole : before.whole;
    entry->value = value;
    entry->value.whole = whole;
    ++entry->writes;
    return entry->value;
  }

 private:
  Board& board_;
};

/// The results of the leaves and the order of calls, as text.
struct Stage {
  std::function<Status(const std::string& leaf)> answer;  // of the scripted leaves
  std::vector<std::string> calls;
  double now = 0.0;  // [s]
};

class Node {
 public:
  Node(const Spec& spec, Board& board, Stage& stage) : spec_(spec), board_(board), stage_(stage) {}

  Status status = Status::Idle;
  std::set<Status> returned;  // by all ticks
  std::vector<std::unique_ptr<Node>> children;
  std::unique_ptr<Board> below;  // of a SubTree

  const Spec& spec() const { return spec_; }

  Status executeTick() {
    Status result = Status::Idle;
    if (!preCondition(result)) {
      result = tick();
    }
    if (isDone(result)) {
      run(result == Status::Success ? "_onSuccess" : "_onFailure");
      run("_post");
    }
    if (result == Status::Idle) {
      throw Fault{"IDLE"};
    }
    if (result != Status::Skipped) {
      status = result;
    }
    if (isDecorator() && isDone(children[0]->status)) {
      children[0]->status = Status::Idle;
    }
    returned.insert(result);
    return result;
  }
  /// "Halt if RUNNING, then reset."
  void haltAndReset() {
    if (status == Status::Running) {
      halt();
      run("_onHalted");
    }
    status = Status::Idle;
  }

 private:
  using S = Status;

  bool isDecorator() const {
    static const std::set<std::string> kIds = {"Inverter",
                                               "ForceSuccess",
                                               "ForceFailure",
                                               "Repeat",
                                               "RetryUntilSuccessful",
                                               "KeepRunningUntilFailure",
                                               "Delay",
                                               "Timeout",
                                               "RunOnce",
                                               "Precondition",
                                               "LoopInt",
                                               "LoopDouble",
                                               "LoopString",
                                               "LoopBool",
                                               "SkipUnlessUpdated",
                                               "WaitValueUpdate",
                                               "SubTree"};
    return kIds.count(spec_.id) > 0;
  }
  void run(const char* attribute) {
    if (const std::string* const script = spec_.find(attribute)) {
      BoardVariables variables(board_);
      ScriptMachine(variables).run(*script);
    }
  }
  bool truth(const std::string& script) {
    BoardVariables variables(board_);
    return ScriptMachine(variables).truth(script);
  }
  bool preCondition(Status& result) {
    if (status == S::Idle) {
      const std::pair<const char*, Status> atStart[] = {
          {"_failureIf", S::Failure}, {"_successIf", S::Success}, {"_skipIf", S::Skipped}};
      for (const auto& [name, fired] : atStart) {
        const std::string* const script = spec_.find(name);
        if (script && truth(*script)) {
          result = fired;
          return true;
        }
      }
    }
    const std::string* const lasting = spec_.find("_while");
    if (!lasting || isDone(status) || truth(*lasting)) {
      return false;
    }
    haltAndReset();
    result = S::Skipped;
    return true;
  }

  // Ports.
  Value input(const std::string& port, const char* fallback = nullptr) {
    const std::string* const given = spec_.find(port);
    if (!given) {
      return fallback ? Value::of(std::string(fallback)) : Value();
    }
    if (!isPointer(*given)) {
      return Value::of(*given);
    }
    const Entry* const entry = board_.find(keyIn(*given, port));
    return entry ? entry->value : Value();
  }
  int wholeInput(const std::string& port, const char* fallback = nullptr) {
    const Value value = input(port, fallback);
    if (value.kind == Value::None) {
      throw Fault{"input missing: " + port};
    }
    const double number = value.kind == Value::Text ? numberIn(value.text) : value.number;
    if (value.kind == Value::Number && number != std::floor(number)) {
      throw Fault{"no whole number: " + port};
    }
    return static_cast<int>(number);
  }
  void output(const std::string& port, const Value& value, const std::string& type) {
    const std::string* const given = spec_.find(port);
    if (!given || !isPointer(*given)) {
      return;
    }
    Entry& entry = board_.make(keyIn(*given, port));
    if (entry.type.empty()) {
      entry.type = type;
    }
    const bool isText = value.kind == Value::Text;
    if (isText != (entry.type == "string")) {
      throw Unsaid{"an output of another type than its entry"};
    }
    if (entry.value.kind != Value::None && entry.value.kind != value.kind) {
      throw Unsaid{"an output of another kind than the value"};
    }
    const bool isReal = !isText && value.number != std::floor(value.number);
    if (isReal && (entry.type == "int" || entry.value.whole)) {
      throw Unsaid{"a real output for an entry with a whole number"};
    }
    const bool whole = entry.value.kind == Value::None ? value.whole : entry.value.whole;
    entry.value = value;
    entry.value.whole = whole;
    ++entry.writes;
  }

  // The nodes.
  Status tick();
  Status tickControl();
  Status tickDecorator();
  Status tickLeaf();
  void halt();
  void resetAll() {
    for (const auto& child : children) {
      child->haltAndReset();
    }
  }
  Status sequence(Status stop, bool yields, bool remembers);
  Status reactive(Status stop);
  Status parallel();
  Status parallelAll();
  Status ifThenElse();
  Status whileDoElse();
  Status switchCase();
  Status tryCatch();
  Status repeat(Status again, const char* port);
  Status runOnce();
  Status timed();
  Status loop();
  Status ifUpdated(Status otherwise);
  bool wasUpdated();
  Status setBlackboard();
  Status scripted(bool isStateful);
  Status portLeaf();
  int threshold(const std::string& port, const char* fallback) {
    const int given = wholeInput(port, fallback);
    const int count = static_cast<int>(children.size());
    const int value = given < 0 ? std::max(count + given + 1, 0) : given;
    if (value > count) {
      throw Fault{"threshold"};
    }
    return value;
  }

  const Spec& spec_;
  Board& board_;
  Stage& stage_;
  // What a node remembers; each kind uses its own.
  std::size_t index_ = 0;
  std::size_t skipped_ = 0;
  int count_ = 0;
  bool isOn_ = false;
  Status result_ = Status::Idle;
  double start_ = 0.0;
  std::uint64_t seen_ = 0;
  bool hasLooked_ = false;
  std::map<std::size_t, Status> ended_;
  std::vector<std::string> queue_;
};

std::unique_ptr<Node> makeNode(const Spec& spec, Board& board, Stage& stage, const Trees& trees);

}  // namespace page

#include "tests/bt/PageControls.h"
#include "tests/bt/PageNodes.h"
