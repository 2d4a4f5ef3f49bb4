#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <sys/resource.h>
#include <unistd.h>
#include <utility>

#include <QTimer>

#include "sim2d/base/Stop.h"

namespace editor {

/// Work beside the GUI thread where only the newest request counts: requests that come while one is
/// being worked on replace each other. The work runs in a thread of its own, behind the window's,
/// and holds copies of all that it needs; the result is handed over in the GUI thread. Destruction
/// waits for the work and delivers nothing. What ends by `base::Stopped` delivers nothing.
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
      // The thread gives way to the window's; where that is not allowed it goes on as it was.
      constexpr int kPatience = 10;  // as of `nice`, which Linux weighs thread by thread
      ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kPatience);
      return work();
    });
    poll_.start();
  }

  bool isBusy() const { return running_.valid(); }

  /// Discards the results of all earlier requests. Does not wait.
  void forget() {
    waiting_ = nullptr;
    isForgotten_ = running_.valid();
  }

  /// Waits for all that was requested and delivers it.
  void finish() {
    while (running_.valid()) {
      take();
    }
  }
  /// Waits for what is being worked on; neither that nor what waits is delivered. For destructors
  /// of owners, whose receivers may be half gone.
  void abandon() {
    poll_.stop();
    waiting_ = nullptr;
    if (running_.valid()) {
      running_.wait();
      running_ = {};
    }
  }
  /// The same as `finish`, but no longer than this; what is not done by then is delivered later.
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
    if (waiting_) {  // the result is out of date already; still better than an older one
      start(std::exchange(waiting_, nullptr));
    }
    if (result && isWanted) {
      deliver_(*std::move(result));
    }
  }

  std::function<void(T)> deliver_;
  std::future<T> running_;
  std::function<T()> waiting_;
  bool isForgotten_ = false;  // the work that is running
  QTimer poll_;
};

}  // namespace editor
