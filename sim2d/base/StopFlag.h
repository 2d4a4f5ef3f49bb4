#pragma once

#include <atomic>
#include <memory>
#include <utility>

namespace base {

/// Exception that ends cancelled work; partial results are discarded. Caught where background work
/// starts.
struct Stopped {};

/// Cancels long-running work, permanently. The request is ignored while a `StopInhibitor` exists.
/// Thread-safe.
class StopFlag {
 public:
  void stop() { isStopped_ = true; }
  /// Throws `Stopped` if cancelled. Long loops call it about once per map row.
  void check() const {
    if (isStopRequested()) {
      throw Stopped();
    }
  }
  bool isStopRequested() const { return isStopped_ && inhibitors_ == 0; }

 private:
  friend class StopInhibitor;
  std::atomic<bool> isStopped_{false};
  mutable std::atomic<int> inhibitors_{0};
};
using StopFlagPtr = std::shared_ptr<const StopFlag>;  // never null where it is checked

/// While an object of this class exists, cancellation is ignored: a run that has started must not
/// change when its map is edited.
class StopInhibitor {
 public:
  /// Throws `Stopped` if already cancelled.
  explicit StopInhibitor(StopFlagPtr flag) : flag_(std::move(flag)) {
    flag_->check();
    ++flag_->inhibitors_;
  }
  ~StopInhibitor() { --flag_->inhibitors_; }
  StopInhibitor(const StopInhibitor&) = delete;
  StopInhibitor& operator=(const StopInhibitor&) = delete;
  StopInhibitor(StopInhibitor&&) = delete;
  StopInhibitor& operator=(StopInhibitor&&) = delete;

 private:
  const StopFlagPtr flag_;
};

}  // namespace base
