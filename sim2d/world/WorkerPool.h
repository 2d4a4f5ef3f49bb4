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

/// Threads that share out work. Used by one thread at a time; the work may not throw. Threads wait
/// awake for a moment between two calls, as long as each has a processor, and then sleep.
class WorkerPool {
 public:
  /// Fewer items are not worth a second thread.
  static constexpr std::size_t kWorthThreads = 200;

  /// `threadCount` includes the caller; 1: no threads at all.
  explicit WorkerPool(int threadCount);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;
  WorkerPool(WorkerPool&&) = delete;
  WorkerPool& operator=(WorkerPool&&) = delete;

  std::size_t threadCount() const { return threads_.size() + 1; }

  /// Calls work(thread, begin, end) for slices of `slice` items that together are all from 0 to
  /// `count`, and returns when all are done. Each thread begins with the share that it had in the
  /// last call, as that is near in its cache, and then takes slices of others: a result may not
  /// depend on `thread`, which is for memory to work in: 0 … threadCount() - 1, the caller is 0.
  template <class Work>
  void forSlices(std::size_t count, std::size_t slice, const Work& work) {
    if (threads_.empty() || count < kWorthThreads || count <= slice) {
      if (count > 0) {
        work(std::size_t{0}, std::size_t{0}, count);
      }
      return;
    }
    run(count, slice, std::cref(work));  // a copy would need memory
  }

  /// Work comes soon: wakes the threads, so that it need not wait for them.
  void rouse();

 private:
  using Work = std::function<void(std::size_t, std::size_t, std::size_t)>;
  struct alignas(64) Share {
    std::atomic<std::size_t> next{0};  // first slice that nobody took
    std::size_t end = 0;
  };

  void run(std::size_t count, std::size_t slice, const Work& work);
  void serve(std::size_t thread);
  /// Waits for a call and joins in; false: the end.
  bool join(std::uint64_t& served);
  void takeSlices(std::size_t thread);
  void leave();
  void wake();

  bool staysAwake_ = false;  // a thread that waits takes no processor from another
  const Work* work_ = nullptr;
  std::size_t count_ = 0, slice_ = 1;
  std::vector<Share> shares_;  // by thread
  /// Number of the call, whether it may still be joined, how many threads have joined.
  alignas(64) std::atomic<std::uint64_t> gate_{0};
  std::atomic<std::uint64_t> signals_{0};  // calls and what else wakes threads
  std::atomic<int> sleepers_{0};
  std::atomic<bool> callerSleeps_{false};
  std::atomic<bool> stops_{false};
  std::mutex mutex_;
  std::condition_variable begin_, done_;
  std::vector<std::thread> threads_;
};

}  // namespace sim2d
