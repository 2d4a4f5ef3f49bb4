#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <sys/resource.h>
#include <unistd.h>
#include <utility>

#include <QTimer>

#include "sim2d/base/StopFlag.h"

namespace editor {

/// Background work where only the newest request counts: a request that arrives during the work
/// replaces the waiting one. The work runs in a separate low-priority thread and holds copies of
/// all that it needs. The result is delivered in the GUI thread. The destructor waits for the work
/// and delivers nothing. Work that ends with `base::Stopped` delivers nothing.
template <class T>
class LatestTask {
 public:
  explicit LatestTask(std::function<void(T)> deliver) : deliver_(std::move(deliver)) {
    poll_.setInterval(kPollMs);
    QObject::connect(&poll_, &QTimer::timeout, &poll_,
                     [this] { finishWithin(std::chrono::milliseconds(0)); });
  }

  void start(std::function<T()> work) {
    if (running_.valid()) {
      waiting_ = std::move(work);
      return;
    }
    running_ = std::async(std::launch::async, [work = std::move(work)] {
      // Lowers the priority of this thread below that of the GUI thread; a failure is ignored.
      constexpr int kPatience = 10;  // Nice value, which Linux applies per thread.
      ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kPatience);
      return work();
    });
    poll_.start();
  }

  bool isBusy() const { return running_.valid(); }

  /// Discards the results of all earlier requests. Does not block.
  void forget() {
    waiting_ = nullptr;
    isForgotten_ = running_.valid();
  }

  /// Blocks until all requested work is done and delivers it.
  void finish() {
    while (running_.valid()) {
      take();
    }
  }
  /// Blocks until the current work is done. Neither its result nor that of waiting work is
  /// delivered. For destructors of owners whose receivers may be partly destroyed.
  void abandon() {
    poll_.stop();
    waiting_ = nullptr;
    if (running_.valid()) {
      running_.wait();
      running_ = {};
    }
  }
  /// Like `finish`, but with a time limit. Work that is not done by then is delivered later.
  void finishWithin(std::chrono::milliseconds patience) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (running_.valid() && running_.wait_until(end) == std::future_status::ready) {
      take();
    }
  }

 private:
  static constexpr int kPollMs = 8;

  void take() {
    std::optional<T> result;
    try {
      result.emplace(running_.get());
    } catch (const base::Stopped&) {
    }
    poll_.stop();
    const bool isWanted = !std::exchange(isForgotten_, false);
    if (waiting_) {  // The result is already outdated, but still better than an older one.
      start(std::exchange(waiting_, nullptr));
    }
    if (result && isWanted) {
      deliver_(*std::move(result));
    }
  }

  std::function<void(T)> deliver_;
  std::future<T> running_;
  std::function<T()> waiting_;
  bool isForgotten_ = false;  // Applies to the running work.
  QTimer poll_;
};

}  // namespace editor
