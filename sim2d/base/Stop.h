#pragma once

#include <atomic>
#include <memory>
#include <utility>

namespace base {

/// Thrown by long work that has been told to stop: what is half done goes, nothing of it is kept.
/// Caught where work beside the window begins.
struct Stopped {};

/// Tells long work, once and for good, that nobody waits for it any more; heeded as soon as nobody
/// needs it (`NeededWork`). Thread: any.
class StopFlag {
 public:
  void stop() { isStopped_ = true; }
  /// Throws `Stopped` if so. Work asks once per row of a map or as often.
  void check() const {
    if (isHeeded()) {
      throw Stopped();
    }
  }
  bool isHeeded() const { return isStopped_ && needs_ == 0; }

 private:
  friend class NeededWork;
  std::atomic<bool> isStopped_{false};
  mutable std::atomic<int> needs_{0};
};
using StopFlagPtr = std::shared_ptr<const StopFlag>;  // never null where it is asked

/// As long as one lives, work goes on although it was told to stop: a run that has begun must not
/// change when its map is edited.
class NeededWork {
 public:
  /// Throws `Stopped` when it is too late.
  explicit NeededWork(StopFlagPtr flag) : flag_(std::move(flag)) {
    flag_->check();
    ++flag_->needs_;
  }
  ~NeededWork() { --flag_->needs_; }
  NeededWork(const NeededWork&) = delete;
  NeededWork& operator=(const NeededWork&) = delete;
  NeededWork(NeededWork&&) = delete;
  NeededWork& operator=(NeededWork&&) = delete;

 private:
  const StopFlagPtr flag_;
};

}  // namespace base
