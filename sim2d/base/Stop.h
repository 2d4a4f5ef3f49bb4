#pragma once

#include <atomic>
#include <memory>

namespace base {

/// Thrown by long work that has been told to stop: what is half done goes, nothing of it is kept.
/// Caught where work beside the window begins.
struct Stopped {};

/// Tells long work, once and for good, that nobody waits for it any more. Thread: any.
class StopFlag {
 public:
  void stop() { isStopped_ = true; }
  /// Throws `Stopped` if so. Work asks once per row of a map or as often.
  void check() const {
    if (isStopped_) {
      throw Stopped();
    }
  }

 private:
  std::atomic<bool> isStopped_{false};
};
using StopFlagPtr = std::shared_ptr<const StopFlag>;  // never null where it is asked

}  // namespace base
