#include "editor/run/SimulationRunner.h"

#include <algorithm>
#include <utility>

namespace editor {

namespace {

constexpr int kDisplayMs = 16;

}  // namespace

SimulationRunner::SimulationRunner(QObject* parent) : QObject(parent) {
  timer_.setInterval(kDisplayMs);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &SimulationRunner::poll);
}

SimulationRunner::~SimulationRunner() {
  stopWorker();
}

void SimulationRunner::setState(State state) {
  if (state_ != state) {
    state_ = state;
    Q_EMIT stateChanged(state);
  }
}

void SimulationRunner::start(bool paused) {
  Q_ASSERT(request_);
  trace_.reset();
  measuredSpeed_ = 0.0;
  worker_ = std::make_unique<RunWorker>(request_(), paused, speed_);
  thread_ = std::thread([worker = worker_.get()] { worker->work(); });
  timer_.start();
  setState(paused ? State::Paused : State::Running);
}

void SimulationRunner::stopWorker() {
  timer_.stop();
  if (thread_.joinable()) {
    worker_->stop();
    thread_.join();
  }
}

void SimulationRunner::play() {
  if (state_ == State::Running) {
    return;
  }
  if (finished_) {
    reset();
  }
  if (state_ == State::Editing) {
    start(false);
    return;
  }
  seekNewest();
  worker_->setPaused(false);
  setState(State::Running);
}

void SimulationRunner::pause() {
  if (state_ == State::Running) {
    worker_->setPaused(true);
    setState(State::Paused);
  }
}

void SimulationRunner::stepOnce() {
  if (state_ == State::Editing) {
    start(true);
  } else if (state_ == State::Running) {
    pause();
    return;
  }
  if (lookingBack_) {
    const std::size_t next = shownIndex() + 1;
    if (next + 1 >= history_.size()) {
      seekNewest();
    } else {
      show(history_[next], true);
    }
  } else if (!finished_) {
    worker_->allowStep();
  }
}

void SimulationRunner::reset() {
  if (state_ == State::Editing) {
    return;
  }
  stopWorker();
  poll();  // the last words of the worker
  worker_.reset();
  finished_ = false;
  history_.clear();
  newest_.reset();
  show(nullptr, false);
  setState(State::Editing);
}

void SimulationRunner::setSpeed(double factor) {
  Q_ASSERT(factor > 0.0);
  speed_ = factor;
  if (worker_ != nullptr) {
    worker_->setSpeed(factor);
  }
}

std::size_t SimulationRunner::shownIndex() const {
  const std::int64_t step = shown_ == nullptr ? 0 : shown_->step;
  const auto after = std::upper_bound(
      history_.begin(), history_.end(), step,
      [](std::int64_t wanted, const FramePtr& frame) { return wanted < frame->step; });
  return after == history_.begin() ? 0 : static_cast<std::size_t>(after - history_.begin()) - 1;
}

void SimulationRunner::seek(std::int64_t step) {
  if (history_.empty()) {
    return;
  }
  pause();
  if (newest_ != nullptr && step >= newest_->step) {
    seekNewest();
    return;
  }
  const auto after = std::upper_bound(
      history_.begin(), history_.end(), step,
      [](std::int64_t wanted, const FramePtr& frame) { return wanted < frame->step; });
  show(after == history_.begin() ? history_.front() : *std::prev(after), true);
}

void SimulationRunner::stepBack() {
  if (shown_ != nullptr && shown_->step > 0) {
    seek(shown_->step - 1);
  }
}

void SimulationRunner::seekNewest() {
  if (lookingBack_) {
    show(newest_, false);
  }
}

void SimulationRunner::show(FramePtr frame, bool lookingBack) {
  shown_ = std::move(frame);
  if (lookingBack_ != lookingBack) {
    lookingBack_ = lookingBack;
    Q_EMIT lookingBackChanged(lookingBack);
  }
  Q_EMIT frameShown(shown_);
}

void SimulationRunner::requestTrace() {
  if (finished_ && trace_ != nullptr) {
    Q_EMIT traceReady(trace_);
  } else if (worker_ != nullptr) {
    worker_->requestTrace();
  }
}

void SimulationRunner::poll() {
  RunNews news = worker_->takeNews();
  if (news.remarks && base::hasErrors(*news.remarks)) {
    const base::Diagnostics errors = *news.remarks;
    stopWorker();
    worker_.reset();
    setState(State::Editing);
    Q_EMIT notStarted(errors);
    return;
  }
  if (news.remarks && !news.remarks->empty()) {
    Q_EMIT warned(*news.remarks);
  }
  takeFrames(news);
  if (news.measuredSpeed) {
    measuredSpeed_ = *news.measuredSpeed;
    Q_EMIT speedMeasured(measuredSpeed_);
  }
  if (news.trace != nullptr) {
    trace_ = news.trace;
  }
  if (news.result) {
    takeEnd(news);
  }
  if (news.trace != nullptr) {
    Q_EMIT traceReady(trace_);
  }
}

void SimulationRunner::takeFrames(RunNews& news) {
  history_.insert(history_.end(), news.recorded.begin(), news.recorded.end());
  for (const StepEvents& events : news.events) {
    Q_EMIT eventsHappened(events);
  }
  if (news.newest != nullptr) {
    newest_ = std::move(news.newest);
    if (!lookingBack_) {
      show(newest_, false);
    }
  }
}

void SimulationRunner::takeEnd(const RunNews& news) {
  timer_.stop();
  if (thread_.joinable()) {
    thread_.join();
  }
  finished_ = true;
  setState(State::Paused);
  if (news.result->status == sim2d::RunStatus::Failed) {
    Q_EMIT failed(QString::fromStdString(news.result->reason));
  }
  Q_EMIT finished(*news.result);
}

}  // namespace editor
