#include "editor/run/SimulationRunner.h"

#include <iterator>

#include "editor/document/RunValues.h"

namespace editor {

namespace {

constexpr int kDisplayMs = 16;
constexpr int kStoppingPollMs = 1000;
constexpr std::size_t kMaxEntryChanges = 40000;      // For the watched person.
constexpr double kFastest = 64.0;                    // Maximum playback speed of a recorded run.
constexpr std::chrono::milliseconds kPatience(100);  // Time limit for a run to end.

bool isOver(const std::future<void>& thread, std::chrono::milliseconds patience) {
  return !thread.valid() || thread.wait_for(patience) == std::future_status::ready;
}

}  // namespace

SimulationRunner::SimulationRunner(QObject* parent) : QObject(parent) {
  timer_.setInterval(kDisplayMs);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &SimulationRunner::poll);
  stoppingTimer_.setInterval(kStoppingPollMs);
  connect(&stoppingTimer_, &QTimer::timeout, this, &SimulationRunner::removeStoppedSessions);
}

SimulationRunner::~SimulationRunner() {
  stopSession();
  for (StoppingSession& ending : stoppingSessions_) {
    ending.thread.wait();
  }
}

void SimulationRunner::setState(State state) {
  if (state_ != state) {
    state_ = state;
    Q_EMIT stateChanged(state);
  }
}

void SimulationRunner::setFirstBranch(const QString& name) {
  branches_ = {{}};
  branches_.front().name = name;
  branch_ = 0;
  nextBranch_ = 1;
}

/// Returns true if a run exists afterwards.
bool SimulationRunner::start(bool paused) {
  Q_ASSERT(request_);
  if (startCondition_ && !startCondition_(paused)) {
    return false;
  }
  setFirstBranch(tr("Run"));
  begin(request_(), paused);
  Q_EMIT branchesChanged();
  return true;
}

void SimulationRunner::begin(RunRequest request, bool paused, sim2d::RecordedInputs inputs,
                             std::int64_t until, sim2d::StepInputs then) {
  measuredSpeed_ = 0.0;
  session_ = std::make_unique<app::Session>(request.rule);
  stopFlag_ = request.left;
  recreate_ = std::move(request.again);
  setScenarios(std::move(request.scenarios));
  session_->enableHistory(request.recordEvery, memoryForNextRun(), historyFolder_);
  session_->setStepHook(std::move(request.change));
  session_->replayInputs(std::move(inputs), until);
  for (sim2d::Input& input : then) {  // They act in the following step.
    session_->add(std::move(input));
  }
  session_->setBreakpoints(breakpoints_);
  session_->watchBlackboard(watched_);
  session_->setPaused(paused);
  session_->setSpeed(speed_);
  const auto run = [session = session_.get(), makeWorld = std::move(request.makeWorld),
                    watch = watch_, guests = observerFactory_, bundle = request.bundle] {
    const auto make = [&] {
      auto world = makeWorld();
      if (world) {
        (*world)->setPlannerDebug(watch);
      }
      return world;
    };
    session->run(make, [&](sim2d::World& world) {
      return guests ? guests(*session, world, bundle) : std::vector<app::Session::Observer>();
    });
  };
  thread_ = std::async(std::launch::async, run);
  timer_.start();
  setState(paused ? State::Paused : State::Running);
}

void SimulationRunner::removeStoppedSessions() {
  stoppingSessions_.erase(
      std::remove_if(stoppingSessions_.begin(), stoppingSessions_.end(),
                     [](const StoppingSession& each) { return isOver(each.thread, {}); }),
      stoppingSessions_.end());
  if (stoppingSessions_.empty()) {
    stoppingTimer_.stop();
  }
}

/// Returns true if the session has ended. Creating a world for a large map, or a step, may take
/// seconds; the session is kept until then and its remaining messages are dropped.
bool SimulationRunner::stopSession() {
  timer_.stop();
  if (session_ != nullptr) {
    session_->stop();
    stopFlag_->stop();
  }
  if (isOver(thread_, kPatience)) {
    thread_ = {};
    return true;
  }
  stoppingSessions_.push_back({std::move(session_), std::move(thread_)});
  stoppingTimer_.start();
  return false;
}

void SimulationRunner::play() {
  if (state_ == State::Running) {
    return;
  }
  if (finished_ || canLoop()) {
    isLooping_ = !finished_;
    const bool isOutside = canLoop() && (shown_->time < loop_->from || shown_->time >= loop_->to);
    if (isOutside) {
      showState(recording_->indexAtTime(loop_->from));
    } else if (shown_->step == newest_->step) {
      showState(0);
    }
    startClock();
    timer_.start();
    setState(State::Running);
    return;
  }
  if (state_ == State::Editing) {
    start(false);
    return;
  }
  seekNewest();
  currentBreak_.reset();
  session_->setPaused(false);
  setState(State::Running);
}

void SimulationRunner::pause() {
  if (state_ == State::Running) {
    if (finished_) {
      timer_.stop();
    } else if (!std::exchange(isLooping_, false)) {
      session_->setPaused(true);
    }
    setState(State::Paused);
  }
}

void SimulationRunner::stepOnce() {
  if (state_ == State::Running) {
    pause();
    return;
  }
  if (state_ == State::Editing && !start(true)) {
    return;
  }
  if (lookingBack_ || isRecorded_) {
    const std::size_t next = recording_->indexAt(shown_->step) + 1;
    if (next + 1 >= recording_->size()) {
      seekNewest();
    } else {
      showState(next);
    }
  } else if (!finished_) {
    currentBreak_.reset();
    session_->stepOnce();
  }
}

void SimulationRunner::reset() {
  if (state_ == State::Editing) {
    return;
  }
  if (stopSession() && session_ != nullptr && !finished_) {
    poll();  // Handles the last messages of the session.
  }
  clearRun();
  branches_.clear();
  branch_ = -1;
  loop_.reset();
  Q_EMIT loopChanged();
  Q_EMIT branchesChanged();
  setState(State::Editing);
}

/// Clears everything that is shown.
void SimulationRunner::clearRun() {
  stopSession();
  session_.reset();
  recreate_ = {};
  setScenarios({});
  finished_ = isRecorded_ = isCut_ = isLooping_ = false;
  result_.reset();
  currentBreak_.reset();
  setEntries(std::nullopt);
  pastEntries_.clear();
  recording_.reset();
  newest_.reset();
  expected_.reset();
  show(nullptr, false);
}

void SimulationRunner::setScenarios(RunScenarios scenarios) {
  scenarios_ = std::move(scenarios);
  Q_EMIT scenariosChanged();
}

void SimulationRunner::setSpeed(double factor) {
  Q_ASSERT(factor > 0.0);
  speed_ = factor;
  if ((finished_ || isLooping_) && state_ == State::Running) {
    startClock();
  }
  if (!finished_ && session_ != nullptr) {
    session_->setSpeed(factor);
  }
}

void SimulationRunner::setHistory(std::size_t mostInMemory, std::string folder) {
  historyMemory_ = mostInMemory;
  historyFolder_ = std::move(folder);
}

/// A state of the recording; for dropped states the oldest one that is kept. Null: the file cannot
/// be read.
FramePtr SimulationRunner::stateAt(std::size_t index) const {
  std::size_t first = recording_->first();
  FramePtr kept = recording_->frameIfKept(std::max(index, first));
  while (kept == nullptr && first != recording_->first()) {  // Dropped in the meantime.
    first = recording_->first();
    kept = recording_->frameIfKept(std::max(index, first));
  }
  return kept;
}

/// Shows a state. A read error is reported and the shown state stays.
void SimulationRunner::showState(std::size_t index) {
  if (FramePtr state = stateAt(index)) {
    show(std::move(state), !isRecorded_);
    return;
  }
  pause();
  Q_EMIT warned({base::warning("run.history-unreadable", {recording_->timeOf(index)})});
}

void SimulationRunner::checkHistoryLimit() {
  const auto problem = recording_ == nullptr ? std::nullopt : recording_->history().problem();
  if (problem && !std::exchange(isCut_, true)) {
    Q_EMIT historyTruncated({base::warning("run.history-cut", {problem->message()})});
  }
}

void SimulationRunner::openRecorded(RecordingPtr recording, std::function<RunRequest()> again) {
  Q_ASSERT(recording != nullptr && recording->size() > 0);
  reset();
  recording_ = std::move(recording);
  newest_ = recording_->frame(recording_->size() - 1);
  isRecorded_ = finished_ = true;
  recreate_ = std::move(again);
  setFirstBranch(tr("Recorded run"));
  setScenarios({nullptr, nullptr, customTreesOf(*recording_->header())});
  const FramePtr first = stateAt(0);
  show(first != nullptr ? first : newest_, false);
  setState(State::Paused);
  checkHistoryLimit();
  Q_EMIT branchesChanged();
}

void SimulationRunner::startClock() {
  playing_.start();
  playedFrom_ = shown_->time;
  measuredSpeed_ = std::min(speed_, kFastest);
  Q_EMIT speedMeasured(measuredSpeed_);
}

void SimulationRunner::advancePlayback() {
  const double passed = 0.001 * static_cast<double>(playing_.elapsed());
  const double time = playedFrom_ + passed * measuredSpeed_;
  const std::size_t index = recording_->indexAtTime(time);
  if (canLoop() && (time > loop_->to || index + 1 == recording_->size())) {
    showState(recording_->indexAtTime(loop_->from));
    startClock();
    return;
  }
  if (recording_->stepOf(index) > shown_->step) {
    showState(index);
  }
  if (index + 1 == recording_->size()) {  // The last step may not be recorded.
    show(newest_, false);
    pause();
  }
}

void SimulationRunner::seek(std::int64_t step) {
  if (recording_ == nullptr || recording_->size() == 0 || newest_ == nullptr) {
    return;  // The run has just started and no frame has been shown yet.
  }
  pause();
  if (step >= newest_->step) {
    seekNewest();
    return;
  }
  showState(recording_->indexAt(step));
}

void SimulationRunner::show(FramePtr frame, bool lookingBack) {
  shown_ = std::move(frame);
  if (lookingBack_ != lookingBack) {
    lookingBack_ = lookingBack;
    Q_EMIT lookingBackChanged(lookingBack);
  }
  Q_EMIT frameShown(shown_);
}

void SimulationRunner::poll() {
  if (finished_ || isLooping_) {
    advancePlayback();
    return;
  }
  app::SessionUpdate news = session_->takeUpdate();
  if (news.isStopped) {
    reset();
    return;
  }
  if (news.remarks && base::hasErrors(*news.remarks)) {
    const base::Diagnostics errors = *news.remarks;
    stopSession();
    session_.reset();
    setScenarios({});
    branches_.clear();
    branch_ = -1;
    Q_EMIT branchesChanged();
    setState(State::Editing);
    Q_EMIT notStarted(errors);
    return;
  }
  if (news.remarks && !news.remarks->empty()) {
    Q_EMIT warned(*news.remarks);
  }
  if (news.history != nullptr) {
    recording_ = news.history;
  }
  checkHistoryLimit();
  if (news.newest != nullptr) {
    newest_ = std::move(news.newest);
    if (!lookingBack_) {
      show(newest_, false);
    }
    checkReplayDivergence();
  }
  handleTreeNews(news);
  applyGuestRequests(news);
  if (news.measuredSpeed) {
    measuredSpeed_ = *news.measuredSpeed;
    Q_EMIT speedMeasured(measuredSpeed_);
  }
  if (news.result) {
    handleRunEnd(*news.result);
  }
}

/// Applies the requests of guests.
void SimulationRunner::applyGuestRequests(const app::SessionUpdate& news) {
  if (news.isPaused) {
    if (!*news.isPaused) {
      seekNewest();
      currentBreak_.reset();
    }
    if (!news.result) {
      setState(*news.isPaused ? State::Paused : State::Running);
    }
  }
  if (news.speed && *news.speed != speed_) {
    speed_ = *news.speed;
    Q_EMIT speedRequested(speed_);
  }
}

const app::BlackboardEntries* SimulationRunner::shownEntries() const {
  if (!lookingBack_ && !finished_) {
    return entries_ ? &*entries_ : nullptr;
  }
  if (shown_ == nullptr || isRecorded_) {
    return nullptr;
  }
  const auto isLater = [](std::int64_t step, const app::BlackboardStep& each) {
    return step < each.step;
  };
  const auto next =
      std::upper_bound(pastEntries_.begin(), pastEntries_.end(), shown_->step, isLater);
  return next == pastEntries_.begin() ? nullptr : &std::prev(next)->entries;
}

void SimulationRunner::handleTreeNews(app::SessionUpdate& news) {
  std::move(news.blackboardHistory.begin(), news.blackboardHistory.end(),
            std::back_inserter(pastEntries_));
  if (pastEntries_.size() > kMaxEntryChanges) {
    pastEntries_.erase(pastEntries_.begin(), pastEntries_.end() - kMaxEntryChanges / 2);
  }
  if (!news.refused.empty()) {
    Q_EMIT inputsRefused(news.refused);
  }
  if (news.entries) {
    setEntries(std::move(news.entries));
  }
  if (news.breakpointHit) {
    currentBreak_ = std::move(news.breakpointHit);
    setState(State::Paused);
    Q_EMIT breakpointHit(*currentBreak_);
  }
}

void SimulationRunner::setBreakpoints(std::vector<sim2d::TreeBreakpoint> points) {
  breakpoints_ = std::move(points);
  if (session_ != nullptr) {
    session_->setBreakpoints(breakpoints_);
  }
  Q_EMIT breakpointsChanged();
}

void SimulationRunner::watchBlackboard(std::optional<int> person) {
  watched_ = person;
  if (session_ != nullptr) {
    session_->watchBlackboard(person);
  }
  pastEntries_.clear();
  setEntries(std::nullopt);
}

void SimulationRunner::setEntries(std::optional<app::BlackboardEntries> entries) {
  if (entries != entries_) {
    entries_ = std::move(entries);
    Q_EMIT entriesChanged();
  }
}

void SimulationRunner::handleRunEnd(const sim2d::RunResult& result) {
  timer_.stop();
  if (thread_.valid()) {
    thread_.wait();
    thread_ = {};
  }
  finished_ = true;
  result_ = result;
  setState(State::Paused);
  if (result.status == sim2d::RunStatus::Failed) {
    Q_EMIT failed(QString::fromStdString(result.reason));
  }
  Q_EMIT finished(result);
}

}  // namespace editor
