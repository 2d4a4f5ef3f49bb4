#include "sim2d/world/WorkerPool.h"

#include <algorithm>
#include <chrono>
#include <emmintrin.h>

namespace sim2d {
namespace {

using Clock = std::chrono::steady_clock;

constexpr Clock::duration kSpinTime = std::chrono::microseconds(50);  // about one wake-up
constexpr Clock::duration kSpinTimeAfterWake = std::chrono::milliseconds(1);

// Bit fields of the gate.
constexpr std::uint64_t kJoined = 0xFFFF;
constexpr std::uint64_t kOpen = 0x10000;
constexpr unsigned kCallBits = 17;

/// Busy-waits; returns false on timeout.
template <class IsDone>
bool spinUntil(IsDone isDone, Clock::duration patience) {
  constexpr int kLooks = 32;  // between reads of the clock
  const Clock::time_point end = Clock::now() + patience;
  do {
    for (int i = 0; i < kLooks; ++i) {
      if (isDone()) {
        return true;
      }
      _mm_pause();
    }
  } while (Clock::now() < end);
  return false;
}

}  // namespace

WorkerPool::WorkerPool(int threadCount)
    : canSpin_(threadCount <= static_cast<int>(std::thread::hardware_concurrency())),
      shares_(static_cast<std::size_t>(std::max(threadCount, 1))) {
  for (int i = 1; i < threadCount; ++i) {
    threads_.emplace_back([this, i] { serve(static_cast<std::size_t>(i)); });
  }
}

WorkerPool::~WorkerPool() {
  stops_ = true;
  wake();
  for (std::thread& thread : threads_) {
    thread.join();
  }
}

void WorkerPool::wakeThreads() {
  if (canSpin_ && !threads_.empty()) {
    wake();
  }
}

/// A thread counts itself as sleeping before it checks for signals a last time, so either it sees
/// this signal or the caller sees the sleeper.
void WorkerPool::wake() {
  ++signals_;
  if (sleepers_ > 0) {
    { const std::lock_guard<std::mutex> lock(mutex_); }
    begin_.notify_all();
  }
}

/// Threads that have not joined when all slices are done are not awaited.
void WorkerPool::run(std::size_t count, std::size_t slice, const Work& work) {
  work_ = &work;
  count_ = count;
  slice_ = std::max<std::size_t>(slice, 1);
  const std::size_t slices = (count + slice_ - 1) / slice_;
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    shares_[i].next = slices * i / shares_.size();
    shares_[i].end = slices * (i + 1) / shares_.size();
  }
  const std::uint64_t call = (gate_ >> kCallBits) + 1;
  gate_ = (call << kCallBits) | kOpen;
  wake();
  takeSlices(0);
  gate_ &= ~kOpen;
  const auto isIdle = [this] { return (gate_ & kJoined) == 0; };
  if (!spinUntil(isIdle, canSpin_ ? kSpinTime : Clock::duration::zero())) {
    std::unique_lock<std::mutex> lock(mutex_);
    callerSleeps_ = true;
    done_.wait(lock, isIdle);
    callerSleeps_ = false;
  }
}

void WorkerPool::takeSlices(std::size_t thread) {
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    Share& share = shares_[(thread + i) % shares_.size()];
    for (std::size_t slice = share.next++; slice < share.end; slice = share.next++) {
      (*work_)(thread, slice * slice_, std::min((slice + 1) * slice_, count_));
    }
  }
}

void WorkerPool::serve(std::size_t thread) {
  std::uint64_t served = 0;
  while (join(served)) {
    takeSlices(thread);
    leave();
  }
}

bool WorkerPool::join(std::uint64_t& served) {
  Clock::duration patience = kSpinTime;
  while (true) {
    const std::uint64_t seenSignals = signals_;
    std::uint64_t gate = 0;
    const auto isNeeded = [&] {
      gate = gate_;
      return stops_ || ((gate & kOpen) != 0 && gate >> kCallBits != served);
    };
    if (spinUntil(isNeeded, canSpin_ ? patience : Clock::duration::zero())) {
      if (stops_) {
        return false;
      }
      if (gate_.compare_exchange_strong(gate, gate + 1)) {
        served = gate >> kCallBits;
        return true;
      }
      continue;
    }
    std::unique_lock<std::mutex> lock(mutex_);
    ++sleepers_;
    begin_.wait(lock, [&] { return signals_ != seenSignals; });
    --sleepers_;
    patience = kSpinTimeAfterWake;
  }
}

void WorkerPool::leave() {
  const std::uint64_t before = gate_.fetch_sub(1);
  if ((before & kJoined) == 1 && callerSleeps_) {
    { const std::lock_guard<std::mutex> lock(mutex_); }
    done_.notify_one();
  }
}

}  // namespace sim2d
