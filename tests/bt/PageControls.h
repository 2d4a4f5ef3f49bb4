#pragma once

#include "tests/bt/PageTree.h"

/// The controls of PageTree.h, in the order of the description.
namespace page {

inline Status Node::tickControl() {
  const std::string& id = spec_.id;
  if (id == "Sequence" || id == "AsyncSequence" || id == "SequenceWithMemory") {
    return sequence(S::Failure, id != "Sequence", id == "SequenceWithMemory");
  }
  if (id == "Fallback" || id == "AsyncFallback") {
    return sequence(S::Success, id != "Fallback", false);
  }
  if (id == "ReactiveSequence" || id == "ReactiveFallback") {
    return reactive(id == "ReactiveSequence" ? S::Failure : S::Success);
  }
  return id == "Parallel"      ? parallel()
         : id == "ParallelAll" ? parallelAll()
         : id == "IfThenElse"  ? ifThenElse()
         : id == "WhileDoElse" ? whileDoElse()
         : id == "TryCatch"    ? tryCatch()
                               : switchCase();
}

inline Status Node::sequence(Status stop, bool yields, bool remembers) {
  if (status == S::Idle) {
    skipped_ = 0;
  }
  status = S::Running;
  while (index_ < children.size()) {
    Node& child = *children[index_];
    const bool wasIdle = child.status == S::Idle;
    const Status now = child.executeTick();
    if (now == S::Running) {
      return now;
    }
    if (now == stop) {
      for (std::size_t k = remembers ? index_ : 0; k < children.size(); ++k) {
        children[k]->haltAndReset();
      }
      index_ = remembers ? index_ : 0;
      return now;
    }
    ++index_;
    skipped_ += now == S::Skipped ? 1 : 0;
    if (yields && now != S::Skipped && wasIdle && index_ < children.size()) {
      return S::Running;
    }
  }
  const bool allSkipped = skipped_ == children.size();
  resetAll();
  index_ = 0;
  skipped_ = 0;
  return allSkipped ? S::Skipped : stop == S::Failure ? S::Success : S::Failure;
}

inline Status Node::reactive(Status stop) {
  status = S::Running;
  bool allSkipped = true;
  for (const auto& child : children) {
    const Status now = child->executeTick();
    if (now == S::Running) {
      for (const auto& other : children) {
        if (other != child) {
          other->haltAndReset();
        }
      }
      return now;
    }
    if (now == stop) {
      resetAll();
      return now;
    }
    allSkipped = allSkipped && now == S::Skipped;
    if (now == S::Skipped) {
      child->haltAndReset();
    }
  }
  resetAll();
  return allSkipped ? S::Skipped : stop == S::Failure ? S::Success : S::Failure;
}

inline Status Node::parallel() {
  const int needed = threshold("success_count", "-1");
  const int allowed = threshold("failure_count", "1");
  const bool countsSkipped = wholeInput("success_count", "-1") < 0;
  status = S::Running;
  int skipped = 0;
  for (std::size_t k = 0; k < children.size(); ++k) {
    if (ended_.count(k) == 0) {
      const Status now = children[k]->executeTick();
      skipped += now == S::Skipped ? 1 : 0;
      if (isDone(now)) {
        ended_[k] = now;
      }
    }
    const auto count = [this](Status wanted) {
      return static_cast<int>(std::count_if(
          ended_.begin(), ended_.end(), [&](const auto& each) { return each.second == wanted; }));
    };
    const int successes = count(S::Success) + (countsSkipped ? skipped : 0);
    const int failures = count(S::Failure);
    const bool isLost =
        static_cast<int>(children.size()) - failures < needed || failures == allowed;
    if (successes >= needed || isLost) {
      ended_.clear();
      resetAll();
      return successes >= needed ? S::Success : S::Failure;
    }
  }
  return skipped == static_cast<int>(children.size()) ? S::Skipped : S::Running;
}

inline Status Node::parallelAll() {
  const int most = threshold("max_failures", "1");
  status = S::Running;
  std::size_t skipped = 0;
  for (std::size_t k = 0; k < children.size(); ++k) {
    if (ended_.count(k) == 0) {
      const Status now = children[k]->executeTick();
      skipped += now == S::Skipped ? 1 : 0;
      if (isDone(now)) {
        ended_[k] = now;
      }
    }
  }
  if (skipped == children.size()) {
    return S::Skipped;
  }
  if (skipped + ended_.size() < children.size()) {
    return S::Running;
  }
  const auto failures = std::count_if(ended_.begin(), ended_.end(), [](const auto& each) {
    return each.second == Status::Failure;
  });
  ended_.clear();
  resetAll();
  return failures >= most ? S::Failure : S::Success;
}

inline Status Node::ifThenElse() {
  status = S::Running;
  if (index_ == 0) {
    const Status now = children[0]->executeTick();
    if (now == S::Running) {
      return now;
    }
    if (now == S::Skipped) {
      throw Fault{"condition skipped"};
    }
    if (now == S::Failure && children.size() == 2) {
      children[0]->haltAndReset();  // ours: the description recommends it
      return now;
    }
    index_ = now == S::Success ? 1 : 2;
  }
  const Status now = children[index_]->executeTick();
  if (now != S::Running) {
    resetAll();
    index_ = 0;
  }
  return now;
}

inline Status Node::whileDoElse() {
  status = S::Running;
  const Status asked = children[0]->executeTick();
  if (asked == S::Running) {
    return asked;
  }
  if (asked == S::Skipped) {
    throw Fault{"condition skipped"};
  }
  const std::size_t chosen = asked == S::Success ? 1 : 2;
  const std::size_t other = 3 - chosen;
  if (other < children.size()) {
    children[other]->haltAndReset();
  }
  Status now = S::Failure;
  if (chosen < children.size()) {
    now = children[chosen]->executeTick();
  }
  if (now != S::Running) {
    resetAll();
  }
  return now;
}

inline Status Node::switchCase() {
  const Value variable = input("variable");
  std::size_t chosen = children.size() - 1;
  for (std::size_t k = 0; k + 1 < children.size() && variable.kind != Value::None; ++k) {
    const Value wanted = input("case_" + std::to_string(k + 1));
    bool isSame =
        wanted.kind == Value::Text && variable.kind == Value::Text && wanted.text == variable.text;
    if (!isSame && wanted.kind != Value::None) {
      const auto numberOf = [](const Value& value, double& number) {
        if (value.kind == Value::Number) {
          number = value.number;
          return true;
        }
        try {
          number = numberIn(value.text == "true" || value.text == "false" ? "x" : value.text);
          return true;
        } catch (const Fault&) {
          return false;
        }
      };
      double a = 0.0;
      double b = 0.0;
      const bool areNumbers = numberOf(variable, a) && numberOf(wanted, b);
      isSame = areNumbers && std::fabs(a - b) <= 1.2e-7;
    }
    if (isSame) {
      chosen = k;
      break;
    }
  }
  if (index_ != 0 && index_ != chosen + 1) {
    children[index_ - 1]->haltAndReset();
  }
  const Status now = children[chosen]->executeTick();
  index_ = now == S::Running ? chosen + 1 : 0;
  if (isDone(now)) {
    resetAll();
  }
  return now;
}

inline Status Node::tryCatch() {
  status = S::Running;
  const std::size_t last = children.size() - 1;
  while (!isOn_ && index_ < last) {
    const Status now = children[index_]->executeTick();
    if (now == S::Running) {
      return now;
    }
    if (now == S::Failure) {
      for (std::size_t k = 0; k < last; ++k) {
        children[k]->haltAndReset();
      }
      isOn_ = true;
      break;
    }
    skipped_ += now == S::Skipped ? 1 : 0;
    ++index_;
  }
  Status end = skipped_ == last ? S::Skipped : S::Success;
  if (isOn_) {
    const Status now = children[last]->executeTick();
    if (now == S::Running) {
      return now;
    }
    end = S::Failure;
  }
  resetAll();
  index_ = 0;
  skipped_ = 0;
  isOn_ = false;
  return end;
}

}  // namespace page
