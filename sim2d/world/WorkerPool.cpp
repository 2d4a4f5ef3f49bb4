#include "sim2d/world/WorkerPool.h"

namespace sim2d {

WorkerPool::WorkerPool(int threadCount) {
  for (int i = 1; i < threadCount; ++i) {
    threads_.emplace_back([this, i] { serve(static_cast<std::size_t>(i)); });
  }
}

WorkerPool::~WorkerPool() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stops_ = true;
  }
  begin_.notify_all();
  for (std::thread& thread : threads_) {
    thread.join();
  }
}

void WorkerPool::forShares(const std::function<void(std::size_t)>& work) {
  if (threads_.empty()) {
    work(0);
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    work_ = &work;
    running_ = threads_.size();
    ++round_;
  }
  begin_.notify_all();
  work(0);
  std::unique_lock<std::mutex> lock(mutex_);
  done_.wait(lock, [this] { return running_ == 0; });
}

void WorkerPool::forEach(std::size_t count, const std::function<void(std::size_t)>& work) {
  forShares([&](std::size_t share) {
    const std::size_t end = count * (share + 1) / shareCount();
    for (std::size_t i = count * share / shareCount(); i < end; ++i) {
      work(i);
    }
  });
}

void WorkerPool::serve(std::size_t share) {
  std::size_t served = 0;
  while (true) {
    {
      std::unique_lock<std::mutex> lock(mutex_);
      begin_.wait(lock, [&] { return stops_ || round_ != served; });
      if (stops_) {
        return;
      }
      served = round_;
    }
    (*work_)(share);
    const std::lock_guard<std::mutex> lock(mutex_);
    if (--running_ == 0) {
      done_.notify_one();
    }
  }
}

}  // namespace sim2d
