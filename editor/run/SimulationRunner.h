#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include <QObject>
#include <QTimer>

#include "sim2d/trace/Frame.h"
#include "sim2d/trace/Trace.h"
#include "sim2d/world/Runner.h"

namespace editor {

/// Makes the world of a run; called in the worker thread, so it holds copies of all it needs.
using WorldMaker = std::function<base::Result<std::unique_ptr<sim2d::World>>()>;
struct RunRequest {
  WorldMaker makeWorld;
  sim2d::StopRule rule;
  int recordEvery = 1;
};

using FramePtr = std::shared_ptr<const sim2d::Frame>;
using TracePtr = std::shared_ptr<const sim2d::Trace>;

/// A simulation beside the window. Lives in the GUI thread and owns one worker thread with the
/// world; commands go in through a locked queue and are used between steps, frames come out through
/// a mailbox that keeps the newest. What is recorded equals a headless run byte for byte.
class SimulationRunner : public QObject {
  Q_OBJECT
 public:
  enum class State { Editing, Running, Paused };

  explicit SimulationRunner(QObject* parent = nullptr);
  ~SimulationRunner() override;  // stops and waits

  /// Called in the GUI thread when a run starts from Editing: takes a snapshot of the document.
  void setRequest(std::function<RunRequest()> request) { request_ = std::move(request); }

  State state() const { return state_; }
  bool isFinished() const { return finished_; }  // the rule has ended the run; state is Paused
  double speed() const { return speed_; }
  double measuredSpeed() const { return measuredSpeed_; }  // simulated seconds per wall second

  void play();  // from Editing: makes the world first; after the end: starts again
  void pause();
  void stepOnce();               // one step, then paused; from the past: one recorded frame forward
  void reset();                  // ends the run, back to Editing
  void setSpeed(double factor);  // > 0; infinity = as fast as possible

  // the past
  FramePtr newestFrame() const { return newest_; }
  FramePtr shownFrame() const { return shown_; }
  const std::vector<FramePtr>& history() const { return history_; }  // every recorded step so far
  bool isLookingBack() const { return lookingBack_; }
  void seek(std::int64_t step);  // shows the nearest recorded frame at or before; pauses
  void stepBack();
  void seekNewest();

  /// The run so far, or the whole of it after the end; comes by `traceReady`.
  void requestTrace();
  TracePtr trace() const { return trace_; }  // of the last run that ended; may be null

 Q_SIGNALS:
  void stateChanged(editor::SimulationRunner::State state);
  void frameShown(std::shared_ptr<const sim2d::Frame> frame);  // at display rate; null: cleared
  void lookingBackChanged(bool lookingBack);
  void speedMeasured(double factor);
  void traceReady(std::shared_ptr<const sim2d::Trace> trace);
  void finished(const sim2d::RunResult& result);
  void failed(const QString& reason);                     // the world stopped; last state stays
  void notStarted(const base::Diagnostics& diagnostics);  // the world could not be made
  void warned(const base::Diagnostics& diagnostics);      // it could, with remarks

 private:
  struct Shared;
  void start(bool paused);
  void poll();
  void setState(State state);
  void show(FramePtr frame, bool lookingBack);
  void stopWorker();
  void noteEnd();

  std::function<RunRequest()> request_;
  std::shared_ptr<Shared> shared_;
  std::thread worker_;
  QTimer timer_;
  State state_ = State::Editing;
  bool finished_ = false, lookingBack_ = false;
  double speed_ = 1.0, measuredSpeed_ = 0.0;
  FramePtr newest_, shown_;
  std::vector<FramePtr> history_;
  TracePtr trace_;
};

}  // namespace editor

Q_DECLARE_METATYPE(std::shared_ptr<const sim2d::Frame>)
Q_DECLARE_METATYPE(std::shared_ptr<const sim2d::Trace>)
Q_DECLARE_METATYPE(base::Diagnostics)
