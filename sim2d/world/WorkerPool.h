#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace sim2d {

/// Threads that share out work. Used by one thread at a time; the work may not throw.
class WorkerPool {
 public:
  /// `threadCount` includes the caller; 1: no threads at all.
  explicit WorkerPool(int threadCount);
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;
  WorkerPool(WorkerPool&&) = delete;
  WorkerPool& operator=(WorkerPool&&) = delete;

  /// Shares of the work, one per thread.
  std::size_t shareCount() const { return threads_.size() + 1; }
  /// Calls work(share) once for each share, at the same time, and returns when all are done.
  void forShares(const std::function<void(std::size_t)>& work);
  /// Calls work(i) once for each i below `count`, in any order, and returns when all are done.
  void forEach(std::size_t count, const std::function<void(std::size_t)>& work);

 private:
  void serve(std::size_t share);

  std::mutex mutex_;
  std::condition_variable begin_, done_;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::size_t round_ = 0;    // of the current work
  std::size_t running_ = 0;  // threads that have not finished it
  bool stops_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace sim2d
