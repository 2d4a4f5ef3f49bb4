#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include <QObject>
#include <QTimer>

#include "editor/run/RunWorker.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/trace/Trace.h"

namespace editor {

/// A simulation beside the window. Lives in the GUI thread and owns one worker thread with the
/// world; commands go in through a locked queue and are used between steps, frames come out through
/// a mailbox that keeps the newest. What is recorded equals a headless run byte for byte.
class SimulationRunner : public QObject {
  Q_OBJECT
 public:
  enum class State { Editing, Running, Paused };
  Q_ENUM(State)

  explicit SimulationRunner(QObject* parent = nullptr);
  ~SimulationRunner() override;  // stops and waits
  Q_DISABLE_COPY_MOVE(SimulationRunner)

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
  TracePtr trace() const { return trace_; }  // the last one that came; may be null

 Q_SIGNALS:
  void stateChanged(editor::SimulationRunner::State state);
  void frameShown(std::shared_ptr<const sim2d::Frame> frame);  // at display rate; null: cleared
  void eventsHappened(const editor::StepEvents& events);       // of every step that had some
  void lookingBackChanged(bool lookingBack);
  void speedMeasured(double factor);
  void traceReady(std::shared_ptr<const sim2d::Trace> trace);
  void finished(const sim2d::RunResult& result);
  void failed(const QString& reason);                     // the world stopped; last state stays
  void notStarted(const base::Diagnostics& diagnostics);  // the world could not be made
  void warned(const base::Diagnostics& diagnostics);      // it could, with remarks

 private:
  void start(bool paused);
  void poll();
  void takeFrames(RunNews& news);
  void takeEnd(const RunNews& news);
  void setState(State state);
  void show(FramePtr frame, bool lookingBack);
  void stopWorker();
  std::size_t shownIndex() const;  // in the history

  std::function<RunRequest()> request_;
  std::unique_ptr<RunWorker> worker_;
  std::thread thread_;
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
Q_DECLARE_METATYPE(sim2d::RunResult)
