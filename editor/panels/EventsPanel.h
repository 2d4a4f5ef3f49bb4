#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <QtWidgets>

#include "editor/document/ScenarioDocument.h"
#include "editor/look/Theme.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// An event of the run with its description.
struct RunEvent {
  std::int64_t step = 0;
  double time = 0.0;  // [s]
  sim2d::Event event;
  QString text;  // "Ana reached Goal 3"
};

/// A remark on a time of a recorded run, from an analysis of it.
struct RunNote {
  double time = 0.0;  // [s]
  QString text;
};

/// The events of the run so far; common source for the list, the timeline and the bubbles. A person
/// who stays at the only goal of a repeated route reaches it in each step, as in HuNavSim: of such
/// a stay only the first event is kept.
class RunEvents : public QObject {
  Q_OBJECT
 public:
  RunEvents(const ScenarioDocument& document, SimulationRunner& runner);
  const std::vector<RunEvent>& events() const { return events_; }
  /// Sets the notes of the displayed recording; another one has none.
  void setNotes(std::vector<RunNote> notes);
  const std::vector<RunNote>& notes() const;

 Q_SIGNALS:
  void cleared();
  void notesChanged();
  void added(int first, int last);

 private:
  void follow();
  QString textOf(const sim2d::Event& event) const;
  QString nameOfAgent(int id) const;
  bool continuesStay(std::int64_t step, const sim2d::Event& event);
  RunEvent* lastGoal(std::size_t from, std::int64_t step, int id);
  static QString goalText(const sim2d::Event& event);

  const ScenarioDocument& document_;
  SimulationRunner& runner_;
  std::vector<RunEvent> events_;
  std::vector<RunNote> notes_;
  RecordingPtr notedRecording_;  // that the notes belong to
  RecordingPtr recording_;
  struct ReachedGoal {
    std::int64_t step = 0;
    std::string goal;
  };
  std::map<int, ReachedGoal> reached_;  // The last goal of each agent.
  std::size_t read_ = 0;                // Number of events of the recording that have been read.
};

/// Event marks, distinguished by shape as well as colour.
enum class EventMark { Pin, Bubble, Diamond, Triangle, Cross, Ring, None };
constexpr std::size_t kEventMarks = 7;
EventMark markOfEvent(sim2d::EventKind kind);

/// Draws the mark around `centre`, about 10 px wide.
void paintEventMark(QPainter& painter, EventMark mark, const QPointF& centre, const Theme& theme);
QIcon eventIcon(EventMark mark, const Theme& theme);

}  // namespace editor
