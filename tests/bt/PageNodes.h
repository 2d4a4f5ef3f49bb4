#pragma once

#include "tests/bt/PageTree.h"

/// The decorators and leaves of PageTree.h, in the order of the description.
namespace page {

inline Status Node::tick() {
  if (children.empty()) {
    return tickLeaf();
  }
  return isDecorator() ? tickDecorator() : tickControl();
}

inline Status Node::tickDecorator() {
  const std::string& id = spec_.id;
  Node& child = *children[0];
  if (id == "Repeat") {
    return repeat(S::Success, "num_cycles");
  }
  if (id == "RetryUntilSuccessful") {
    return repeat(S::Failure, "num_attempts");
  }
  if (id == "RunOnce") {
    return runOnce();
  }
  if (id == "Delay" || id == "Timeout") {
    return timed();
  }
  if (id.compare(0, 4, "Loop") == 0) {
    return loop();
  }
  if (id == "SkipUnlessUpdated" || id == "WaitValueUpdate") {
    return ifUpdated(id == "WaitValueUpdate" ? S::Running : S::Skipped);
  }
  if (id == "Precondition") {
    if (!isOn_ && !truth(*spec_.find("if"))) {
      const std::string* const otherwise = spec_.find("else");
      return !otherwise || *otherwise == "FAILURE" ? S::Failure
             : *otherwise == "SUCCESS"             ? S::Success
             : *otherwise == "RUNNING"             ? S::Running
                                                   : S::Skipped;
    }
    const Status now = child.executeTick();
    isOn_ = now == S::Running;
    return now;
  }
  if (id != "SubTree" || status == S::Idle) {
    status = S::Running;
  }
  const Status now = child.executeTick();
  if (id == "Inverter") {
    return now == S::Success ? S::Failure : now == S::Failure ? S::Success : now;
  }
  if (id == "KeepRunningUntilFailure") {
    return now == S::Failure ? now : S::Running;
  }
  const bool isForced = (id == "ForceSuccess" || id == "ForceFailure") && isDone(now);
  return isForced ? (id == "ForceSuccess" ? S::Success : S::Failure) : now;
}

inline Status Node::repeat(Status again, const char* port) {
  int limit = wholeInput(port);
  status = S::Running;
  Node& child = *children[0];
  while (limit == -1 || count_ < limit) {
    const bool wasIdle = child.status == S::Idle;
    const Status now = child.executeTick();
    if (now == S::Running) {
      return now;
    }
    if (now == S::Skipped) {
      child.haltAndReset();
      return now;
    }
    if (now != again) {
      count_ = 0;
      return now;
    }
    child.haltAndReset();
    ++count_;
    limit = again == S::Failure ? wholeInput(port) : limit;
    if (wasIdle && (limit == -1 || count_ < limit)) {
      return S::Running;
    }
  }
  count_ = 0;
  return again;
}

inline Status Node::runOnce() {
  if (result_ != S::Idle) {
    const std::string* const skips = spec_.find("then_skip");
    return skips && *skips == "false" ? result_ : S::Skipped;
  }
  status = S::Running;
  const Status now = children[0]->executeTick();
  result_ = isDone(now) ? now : S::Idle;
  return now;
}

/// Delay and Timeout, in simulated time.
inline Status Node::timed() {
  const bool isTimeout = spec_.id == "Timeout";
  const double limit = wholeInput(isTimeout ? "msec" : "delay_msec") / 1000.0;
  if (!isOn_) {
    isOn_ = true;
    start_ = stage_.now;
  }
  status = S::Running;
  const bool isOver = stage_.now - start_ >= limit - 1e-9;
  Node& child = *children[0];
  if (!isTimeout && !isOver) {
    return S::Running;
  }
  if (isTimeout && limit > 0.0 && isOver && child.status == S::Running) {
    child.haltAndReset();
    isOn_ = false;
    return S::Failure;
  }
  const Status now = child.executeTick();
  isOn_ = !isDone(now);
  return now;
}

inline Status Node::loop() {
  const std::string& list = *spec_.find("queue");
  if (isPointer(list)) {
    throw Unsaid{"a queue in an entry"};
  }
  if (status == S::Idle) {
    isOn_ = false;
    queue_.clear();
    std::string rest = list;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(';'), rest.size());
      queue_.push_back(rest.substr(0, end));
      rest.erase(0, end + 1);
    }
  }
  if (!isOn_) {
    if (queue_.empty()) {
      const std::string* const atEnd = spec_.find("if_empty");
      return atEnd && *atEnd == "FAILURE"   ? S::Failure
             : atEnd && *atEnd == "SKIPPED" ? S::Skipped
                                            : S::Success;
    }
    const std::string first = queue_.front();
    queue_.erase(queue_.begin());
    const bool isText = spec_.id == "LoopString";
    const bool isWhole = spec_.id == "LoopInt";
    output("value", isText ? Value::of(first) : Value::of(numberIn(first), isWhole),
           isText    ? "string"
           : isWhole ? "int"
                     : "double");
  }
  if (status == S::Idle) {
    status = S::Running;
  }
  const Status now = children[0]->executeTick();
  isOn_ = now == S::Running;
  return now == S::Failure ? now : S::Running;
}

inline bool Node::wasUpdated() {
  const std::string& text = *spec_.find("entry");
  const Entry* const entry = board_.find(isPointer(text) ? keyIn(text, "entry") : text);
  if (!entry) {
    return false;
  }
  if (!hasLooked_ && entry->writes == 0) {
    throw Unsaid{"an entry that was never written is looked at for the first time"};
  }
  const bool isNew = !hasLooked_ || seen_ != entry->writes;
  hasLooked_ = true;
  seen_ = entry->writes;
  return isNew;
}

inline Status Node::ifUpdated(Status otherwise) {
  if (!isOn_ && !wasUpdated()) {
    return otherwise;
  }
  const Status now = children[0]->executeTick();
  isOn_ = now == S::Running;
  return now;
}

inline Status Node::setBlackboard() {
  const std::string& key = *spec_.find("output_key");
  const std::string& given = *spec_.find("value");
  Value value = Value::of(given);
  if (isPointer(given)) {
    const Entry* const from = board_.find(keyIn(given, "value"));
    if (!from) {
      throw Fault{"no entry to copy"};
    }
    if (from->value.kind == Value::None) {
      return S::Failure;
    }
    value = from->value;
  }
  Entry* to = board_.find(key);
  if (!to) {
    to = &board_.make(key);
    to->type = isPointer(given) ? board_.find(keyIn(given, "value"))->type : "string";
    const bool isNumberAsText = to->type == "string" && value.kind == Value::Number;
    if (isPointer(given) && !to->type.empty() && (value.whole || isNumberAsText)) {
      throw Unsaid{"the type of a script's number in an entry of another type"};
    }
  } else if (isPointer(given) || to->type != "string") {
    throw Unsaid{"SetBlackboard into an entry of another making"};
  }
  to->value = value;
  ++to->writes;
  return S::Success;
}

/// A leaf whose results the test defines.
inline Status Node::scripted(bool isStateful) {
  if (isStateful && isDone(status)) {
    return status;
  }
  const std::string& name = *spec_.find("name");
  const Status now = stage_.answer(name);
  stage_.calls.push_back(name + (now == S::Running ? ":R" : now == S::Success ? ":S" : ":F"));
  return now;
}

/// The leaves of the test with typed ports.
inline Status Node::portLeaf() {
  const std::string& id = spec_.id;
  if (id == "NeedInt" || id == "NeedReal" || id == "NeedText") {
    const Value value = input("in");
    if (value.kind == Value::None) {
      throw Fault{"input missing"};
    }
    if (id == "NeedInt") {
      stage_.calls.push_back("int " + std::to_string(wholeInput("in")));
    } else if (id == "NeedReal") {
      const double number = value.kind == Value::Text ? numberIn(value.text) : value.number;
      stage_.calls.push_back("real " + std::to_string(number));
    } else if (value.kind != Value::Text) {
      throw Unsaid{"how a number is written as text"};
    } else {
      stage_.calls.push_back("text " + value.text);
    }
    return S::Success;
  }
  // PutInt, PutReal, PutText
  const std::string& from = *spec_.find("from");
  output("out", id == "PutText" ? Value::of(from) : Value::of(numberIn(from), id == "PutInt"),
         id == "PutText"  ? "string"
         : id == "PutInt" ? "int"
                          : "double");
  return S::Success;
}

inline Status Node::tickLeaf() {
  const std::string& id = spec_.id;
  if (id == "AlwaysSuccess" || id == "AlwaysFailure") {
    return id == "AlwaysSuccess" ? S::Success : S::Failure;
  }
  if (id == "Act" || id == "Ask") {
    return scripted(id == "Act");
  }
  if (id == "Script") {
    run("code");
    return S::Success;
  }
  if (id == "ScriptCondition") {
    return truth(*spec_.find("code")) ? S::Success : S::Failure;
  }
  if (id == "SetBlackboard") {
    return setBlackboard();
  }
  if (id == "UnsetBlackboard") {
    board_.removeOwn(*spec_.find("key"));
    return S::Success;
  }
  if (id == "WasEntryUpdated") {
    return wasUpdated() ? S::Success : S::Failure;
  }
  if (id == "Sleep") {
    const double limit = wholeInput("msec") / 1000.0;
    start_ = status == S::Idle ? stage_.now : start_;
    return stage_.now - start_ >= limit - 1e-9 ? S::Success : S::Running;
  }
  return portLeaf();
}

/// Resets what a halted node forgets besides its children.
inline void Node::halt() {
  const std::string& id = spec_.id;
  if (id == "Act") {
    stage_.calls.push_back(*spec_.find("name") + ":H");
  }
  const bool runsCatch = id == "TryCatch" && !isOn_ && spec_.find("catch_on_halt") &&
                         *spec_.find("catch_on_halt") == "true";
  resetAll();
  ended_.clear();
  const bool keepsIndex = id == "SequenceWithMemory";
  const bool keepsRest = id == "RunOnce" || id.compare(0, 4, "Loop") == 0;
  if (!keepsIndex) {
    index_ = 0;
    skipped_ = 0;
  }
  if (!keepsRest) {
    count_ = 0;
  }
  isOn_ = false;
  if (runsCatch) {
    children.back()->executeTick();
    children.back()->haltAndReset();
  }
}

/// Typed ports create the entry that they name, if it does not exist; the generator of trees must
/// avoid what the file then may not do (another type later).
inline void declarePorts(const Spec& spec, Board& board) {
  static const std::map<std::pair<std::string, std::string>, std::string> kTypes = {
      {{"NeedInt", "in"}, "int"},          {{"NeedReal", "in"}, "double"},
      {{"NeedText", "in"}, "string"},      {{"PutInt", "out"}, "int"},
      {{"PutReal", "out"}, "double"},      {{"PutText", "out"}, "string"},
      {{"Repeat", "num_cycles"}, "int"},   {{"RetryUntilSuccessful", "num_attempts"}, "int"},
      {{"LoopInt", "value"}, "int"},       {{"LoopDouble", "value"}, "double"},
      {{"LoopString", "value"}, "string"}, {{"Switch2", "variable"}, "string"},
      {{"Switch3", "variable"}, "string"}, {{"SetBlackboard", "value"}, ""},
      {{"WasEntryUpdated", "entry"}, ""},  {{"SkipUnlessUpdated", "entry"}, ""},
      {{"WaitValueUpdate", "entry"}, ""}};
  for (const auto& [port, text] : spec.attributes) {
    const auto type = kTypes.find({spec.id, port});
    if (type != kTypes.end() && isPointer(text) && !board.find(keyIn(text, port))) {
      board.make(keyIn(text, port)).type = type->second;
    }
  }
}

/// A constant of a SubTree: a whole number, a real or text.
inline Entry literalEntry(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const bool isNumber = !text.empty() && *end == '\0';
  const bool isWhole = isNumber && text.find_first_of(".e") == std::string::npos;
  return {isNumber ? Value::of(number, isWhole) : Value::of(text),
          isWhole    ? "int"
          : isNumber ? "double"
                     : "",
          1};
}

inline std::unique_ptr<Node> makeNode(const Spec& spec, Board& board, Stage& stage,
                                      const Trees& trees) {
  auto node = std::make_unique<Node>(spec, board, stage);
  declarePorts(spec, board);
  if (spec.id != "SubTree") {
    for (const Spec& child : spec.children) {
      node->children.push_back(makeNode(child, board, stage, trees));
    }
    return node;
  }
  node->below = std::make_unique<Board>(&board);
  for (const auto& [name, text] : spec.attributes) {
    if (name == "_autoremap") {
      node->below->isAutomatic = text == "true";
    } else if (name != "ID" && name[0] != '_') {
      if (isPointer(text)) {
        node->below->mapped[name] = keyIn(text, name);
      } else {
        node->below->makeOwn(name) = literalEntry(text);
      }
    }
  }
  node->children.push_back(makeNode(trees.at(*spec.find("ID")), *node->below, stage, trees));
  return node;
}

}  // namespace page
