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

void WorkerPool::forEach(std::size_t count, const std::function<void(std::size_t)>& work) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    work_ = &work;
    count_ = count;
    running_ = threads_.size();
    ++round_;
  }
  begin_.notify_all();
  doShare(0);
  std::unique_lock<std::mutex> lock(mutex_);
  done_.wait(lock, [this] { return running_ == 0; });
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
    doShare(share);
    const std::lock_guard<std::mutex> lock(mutex_);
    if (--running_ == 0) {
      done_.notify_one();
    }
  }
}

void WorkerPool::doShare(std::size_t share) {
  for (std::size_t i = share; i < count_; i += threads_.size() + 1) {
    (*work_)(i);
  }
}

}  // namespace sim2d
