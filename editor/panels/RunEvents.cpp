#include "editor/panels/RunEvents.h"

namespace editor {

using sim2d::EventKind;

RunEvents::RunEvents(const ScenarioDocument& document, SimulationRunner& runner, QObject* parent)
    : QObject(parent), document_(document), runner_(runner) {
  connect(&runner_, &SimulationRunner::frameShown, this, &RunEvents::follow);
  connect(&runner_, &SimulationRunner::stateChanged, this, &RunEvents::follow);
}

void RunEvents::follow() {
  if (runner_.recording() != recording_) {
    recording_ = runner_.recording();
    read_ = 0;
    events_.clear();
    Q_EMIT cleared();
  }
  const std::size_t before = events_.size();
  const std::size_t there = recording_ == nullptr ? 0 : recording_->events().size();
  for (; read_ < there; ++read_) {
    const auto& [step, event] = recording_->events()[read_];
    if (event.kind != EventKind::Stop) {  // the state of the run tells it
      const double time = static_cast<double>(step) * recording_->header()->dt;
      events_.push_back({step, time, event, textOf(event)});
    }
  }
  if (events_.size() > before) {
    Q_EMIT added(static_cast<int>(before), static_cast<int>(events_.size()) - 1);
  }
}

QString RunEvents::nameOfAgent(int id) const {
  const sim2d::Scenario& scenario = document_.scenario();
  if (id < 0) {
    int robotId = 0;
    for (const sim2d::Robot& robot : scenario.robots) {
      robotId -= robot.listed ? 1 : 0;
      if (robot.listed && robotId == id) {
        return QString::fromStdString(robot.name);
      }
    }
    return tr("Robot %1").arg(-id);
  }
  const sim2d::Human* human = scenario.humanById(id);
  return human != nullptr ? QString::fromStdString(human->name) : tr("Person %1").arg(id);
}

QString RunEvents::textOf(const sim2d::Event& event) const {
  const QString who = event.hasId ? nameOfAgent(event.id) : QString();
  const QString other = event.hasOther ? nameOfAgent(event.other) : QString();
  const QString text = QString::fromStdString(event.text);
  switch (event.kind) {
    case EventKind::Enter:
      return tr("%1 enters").arg(who);
    case EventKind::Leave:
      return tr("%1 leaves").arg(who);
    case EventKind::Goal:
      return tr("%1 reached goal %2").arg(who, text);
    case EventKind::Arrived:
      return tr("%1 has arrived").arg(who);
    case EventKind::Contact:
      return event.hasOther ? tr("%1 touches %2").arg(who, other)
                            : tr("%1 touches a wall").arg(who);
    case EventKind::Say:
      return tr("%1: “%2”").arg(who, text);
    case EventKind::Heard:
      return tr("%1 hears %2").arg(who, other);
    case EventKind::Action:
      return tr("%1 starts %2").arg(who, text);
    case EventKind::ActionEnd:
      return tr("%1 ends %2").arg(who, text);
    case EventKind::Group:
      return tr("%1 joins group %2").arg(who, text);
    case EventKind::Replan:
      return tr("%1 plans a new way").arg(who);
    case EventKind::Stuck:
      return tr("%1 is stuck").arg(who);
    case EventKind::Door:
      return tr("Door %1").arg(text);
    case EventKind::Stop:
      return tr("The run ends: %1").arg(text);
  }
  return text;
}

EventMark markOfEvent(EventKind kind) {
  switch (kind) {
    case EventKind::Goal:
    case EventKind::Arrived:
      return EventMark::Pin;
    case EventKind::Say:
    case EventKind::Heard:
      return EventMark::Bubble;
    case EventKind::Action:
    case EventKind::ActionEnd:
      return EventMark::Diamond;
    case EventKind::Stuck:
      return EventMark::Triangle;
    case EventKind::Contact:
      return EventMark::Cross;
    case EventKind::Door:
    case EventKind::Group:
    case EventKind::Enter:
    case EventKind::Leave:
      return EventMark::Ring;
    case EventKind::Replan:
    case EventKind::Stop:
      return EventMark::None;
  }
  return EventMark::None;
}

}  // namespace editor
