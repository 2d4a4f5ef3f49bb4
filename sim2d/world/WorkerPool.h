#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace sim2d {

/// Thread pool for data-parallel loops. Used by one thread at a time; the work must not throw.
/// Between two calls threads busy-wait for a moment, if each has its own processor, and then sleep.
class WorkerPool {
 public:
  /// Loops with fewer items run in the calling thread.
  static constexpr std::size_t kMinParallelItems = 200;

  /// `threadCount` includes the caller; 1: no threads.
  explicit WorkerPool(int threadCount);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;
  WorkerPool(WorkerPool&&) = delete;
  WorkerPool& operator=(WorkerPool&&) = delete;

  std::size_t threadCount() const { return threads_.size() + 1; }

  /// Calls work(thread, begin, end) for slices of `slice` items that together cover 0 to `count`,
  /// and returns when all are done. Each thread starts with the share of the previous call, for
  /// cache locality, and then takes slices of other threads. `thread` (0 … threadCount() - 1, the
  /// caller is 0) may select work memory only; results must not depend on it.
  template <class Work>
  void parallelFor(std::size_t count, std::size_t slice, const Work& work) {
    if (threads_.empty() || count < kMinParallelItems || count <= slice) {
      if (count > 0) {
        work(std::size_t{0}, std::size_t{0}, count);
      }
      return;
    }
    run(count, slice, std::cref(work));  // a copy would allocate
  }

  /// Wakes the threads ahead of work.
  void wakeThreads();

 private:
  using Work = std::function<void(std::size_t, std::size_t, std::size_t)>;
  struct alignas(64) Share {
    std::atomic<std::size_t> next{0};  // first slice not taken
    std::size_t end = 0;
  };

  void run(std::size_t count, std::size_t slice, const Work& work);
  void serve(std::size_t thread);
  /// Waits for a call and joins it; returns false at shutdown.
  bool join(std::uint64_t& served);
  void takeSlices(std::size_t thread);
  void leave();
  void wake();

  bool canSpin_ = false;  // each thread has its own processor
  const Work* work_ = nullptr;
  std::size_t count_ = 0, slice_ = 1;
  std::vector<Share> shares_;  // per thread
  /// Number of the call, whether it can be joined, number of joined threads.
  alignas(64) std::atomic<std::uint64_t> gate_{0};
  std::atomic<std::uint64_t> signals_{0};  // incremented by each wake-up
  std::atomic<int> sleepers_{0};
  std::atomic<bool> callerSleeps_{false};
  std::atomic<bool> stops_{false};
  std::mutex mutex_;
  std::condition_variable begin_, done_;
  std::vector<std::thread> threads_;
};

}  // namespace sim2d
