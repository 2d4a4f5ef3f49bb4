#include "editor/panels/EventsPanel.h"

#include <array>

#include "editor/look/FigurePainter.h"
#include "editor/look/Form.h"
#include "editor/look/TableExport.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/RowDelegate.h"
#include "editor/panels/runs/Playback.h"

namespace editor {

namespace {

/// The events of a run, newest last; a click seeks to the time of an event.
class EventsPanel : public QWidget {
  Q_DECLARE_TR_FUNCTIONS(editor::EventsPanel)
 public:
  explicit EventsPanel(PanelContext& context)
      : context_(context), stack_(new QStackedLayout(this)), table_(new QTableWidget(0, 2, this)) {
    setProperty(kManualPageProperty, QStringLiteral("recordings"));
    styleTable(*table_, tr("Events"));
    makeTableSavable(*table_, tr("Events"));
    table_->setHorizontalHeaderLabels({tr("Time"), tr("Event")});  // in saved tables
    QHeaderView* header = table_->horizontalHeader();
    header->hide();
    header->setSectionResizeMode(0, QHeaderView::Fixed);
    header->resizeSection(0, 72);
    header->setStretchLastSection(true);
    stack_->addWidget(emptyState(tr("No events yet: press Space to run."), this));
    stack_->addWidget(table_);
    const auto seek = [this](const QModelIndex& at) {
      context_.runner.seek(eventAt(at.row()).step);
    };
    connect(table_, &QTableView::clicked, this, seek);
    connect(table_, &QTableView::activated, this, seek);
    connect(&context.runEvents, &RunEvents::cleared, this, [this] { setCount(0); });
    connect(&context.runEvents, &RunEvents::added, this, [this](int, int last) {
      const QScrollBar* bar = table_->verticalScrollBar();
      const bool atEnd = bar->value() == bar->maximum();
      setCount(last + 1);
      if (atEnd) {
        table_->scrollToBottom();
      }
    });
    connect(&context, &PanelContext::themeChanged, this, &EventsPanel::setTheme);
    setTheme(context.theme());
  }

 private:
  const RunEvent& eventAt(int row) const {
    return context_.runEvents.events()[static_cast<std::size_t>(row)];
  }
  void setTheme(const Theme& theme) {
    for (std::size_t mark = 0; mark < icons_.size(); ++mark) {
      icons_[mark] = eventIcon(static_cast<EventMark>(mark), theme);
    }
    pale_ = theme.color(Role::TextSecondary);
    for (int row = 0; row < table_->rowCount(); ++row) {
      paintRow(row);
    }
  }
  void paintRow(int row) {
    const EventMark mark = markOfEvent(eventAt(row).event.kind);
    table_->item(row, 0)->setForeground(pale_);
    table_->item(row, 1)->setIcon(icons_[static_cast<std::size_t>(mark)]);
  }
  void setCount(int count) {
    int row = table_->rowCount();
    table_->setRowCount(count);
    for (; row < count; ++row) {
      auto* time = new QTableWidgetItem(clockText(eventAt(row).time));
      time->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      time->setData(kExactValueRole, eventAt(row).time);
      table_->setItem(row, 0, time);
      table_->setItem(row, 1, new QTableWidgetItem(eventAt(row).text));
      paintRow(row);
    }
    stack_->setCurrentIndex(count > 0 ? 1 : 0);
    Q_EMIT context_.counted(this, count);
  }

  PanelContext& context_;
  std::array<QIcon, kEventMarks> icons_;
  QColor pale_;
  QStackedLayout* stack_;
  QTableWidget* table_;
};

}  // namespace

void addEventsPanel(PanelRegistry& to) {
  to.add(closedBottomPanel(70, QObject::tr("Events"), true),
         [](PanelContext& context) { return new EventsPanel(context); });
}

using sim2d::EventKind;

namespace {

/// Presentation of an event kind: %1 = agent, %2 = the other agent or the event text.
struct EventPresentation {
  EventMark mark;
  const char* words;
};

const EventPresentation& presentationOf(EventKind kind) {
  static const std::map<EventKind, EventPresentation> kPresentations = {
      {EventKind::Enter, {EventMark::Ring, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1 enters")}},
      {EventKind::Leave, {EventMark::Ring, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1 leaves")}},
      {EventKind::Goal,
       {EventMark::Pin, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1 reached %2")}},
      {EventKind::Arrived,
       {EventMark::Pin, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1 has arrived")}},
      {EventKind::Contact,
       {EventMark::Cross, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1 touches %2")}},
      {EventKind::Say, {EventMark::Bubble, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1: “%2”")}},
      {EventKind::Heard,
       {EventMark::Bubble, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1 hears %2")}},
      {EventKind::Action,
       {EventMark::Diamond, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1 starts %2")}},
      {EventKind::ActionEnd,
       {EventMark::Diamond, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1 ends %2")}},
      {EventKind::Group,
       {EventMark::Ring, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1 joins group %2")}},
      {EventKind::Replan,
       {EventMark::None, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1 plans a new path")}},
      {EventKind::Stuck,
       {EventMark::Triangle, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1 is stuck")}},
      {EventKind::NavigationSucceeded,
       {EventMark::Pin, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1: navigation succeeded, %2")}},
      {EventKind::NavigationFailed,
       {EventMark::Cross, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1: navigation failed, %2")}},
      {EventKind::Door, {EventMark::Ring, QT_TRANSLATE_NOOP("editor::EventsPanel", "Door %2")}},
      {EventKind::Stop,
       {EventMark::None, QT_TRANSLATE_NOOP("editor::EventsPanel", "The run ends: %2")}},
      {EventKind::Dock, {EventMark::Diamond, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1: %2")}},
      {EventKind::Photo,
       {EventMark::Diamond, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1 takes a photo at %2")}},
      {EventKind::Battery,
       {EventMark::Diamond, QT_TRANSLATE_NOOP("editor::EventsPanel", "%1: battery %2")}}};
  return kPresentations.at(kind);
}

QPainterPath pinPath() {
  QPainterPath path(QPointF(0.0, 6.0));
  path.cubicTo(-1.5, 3.0, -4.0, 1.5, -4.0, -1.0);
  path.arcTo(QRectF(-4.0, -5.0, 8.0, 8.0), 180.0, -180.0);
  path.cubicTo(4.0, 1.5, 1.5, 3.0, 0.0, 6.0);
  return path;
}

QPainterPath bubblePath() {
  QPainterPath path;
  path.addRoundedRect(QRectF(-5.0, -4.5, 10.0, 7.5), 2.0, 2.0);
  QPainterPath tail(QPointF(-2.5, 2.0));
  tail.lineTo(-2.5, 5.5);
  tail.lineTo(1.0, 2.0);
  return path.united(tail);
}

}  // namespace

RunEvents::RunEvents(const ScenarioDocument& document, SimulationRunner& runner)
    : document_(document), runner_(runner) {
  connect(&runner_, &SimulationRunner::frameShown, this, &RunEvents::follow);
  connect(&runner_, &SimulationRunner::stateChanged, this, &RunEvents::follow);
}

void RunEvents::setNotes(std::vector<RunNote> notes) {
  notes_ = std::move(notes);
  notedRecording_ = runner_.recording();
  Q_EMIT notesChanged();
}

const std::vector<RunNote>& RunEvents::notes() const {
  static const std::vector<RunNote> kNone;
  return notedRecording_ != nullptr && notedRecording_ == runner_.recording() ? notes_ : kNone;
}

void RunEvents::follow() {
  if (runner_.recording() != recording_) {
    recording_ = runner_.recording();
    read_ = 0;
    reached_.clear();
    events_.clear();
    Q_EMIT cleared();
  }
  const std::size_t before = events_.size();
  const std::size_t there = recording_ == nullptr ? 0 : recording_->events().size();
  for (; read_ < there; ++read_) {
    const auto& [step, event] = recording_->events()[read_];
    const bool isShownElsewhere = event.kind == EventKind::Stop;  // by the state of the run
    if (isShownElsewhere || continuesStay(step, event)) {
      continue;
    }
    const double time = static_cast<double>(step) * recording_->header()->dt;
    RunEvent* const goal =
        event.kind == EventKind::Arrived ? lastGoal(before, step, event.id) : nullptr;
    if (goal != nullptr) {  // One thing that happens is one event.
      goal->text = tr("%1 has arrived at %2").arg(nameOfAgent(event.id), goalText(goal->event));
      goal->event.kind = EventKind::Arrived;
    } else {
      events_.push_back({step, time, event, textOf(event)});
    }
  }
  if (events_.size() > before) {
    Q_EMIT added(static_cast<int>(before), static_cast<int>(events_.size()) - 1);
  }
}

/// Whether the agent reached the same goal in the step before.
bool RunEvents::continuesStay(std::int64_t step, const sim2d::Event& event) {
  if (event.kind != EventKind::Goal) {
    return false;
  }
  const auto [last, isFirst] = reached_.try_emplace(event.id, ReachedGoal{step, event.text});
  const bool isSame = !isFirst && last->second.goal == event.text && step <= last->second.step + 1;
  last->second = {step, event.text};
  return isSame;
}

/// The goal that an agent reached in this step, from that index on; null: none.
RunEvent* RunEvents::lastGoal(std::size_t from, std::int64_t step, int id) {
  for (std::size_t k = events_.size(); k-- > from && events_[k].step == step;) {
    if (events_[k].event.kind == EventKind::Goal && events_[k].event.id == id) {
      return &events_[k];
    }
  }
  return nullptr;
}

/// A robot's own goal point has no number.
QString RunEvents::goalText(const sim2d::Event& event) {
  return event.text.empty() ? tr("the goal") : goalName(QString::fromStdString(event.text).toInt());
}

QString RunEvents::nameOfAgent(int id) const {
  const sim2d::Scenario& scenario = document_.scenario();
  if (id < 0) {
    const auto robot = static_cast<std::size_t>(-id - 1);
    const bool known = robot < scenario.robots.size() && scenario.robots[robot].listed;
    return known ? QString::fromStdString(scenario.robots[robot].name) : tr("Robot %1").arg(-id);
  }
  if (const sim2d::Human* human = scenario.humanById(id)) {
    return QString::fromStdString(human->name);
  }
  const std::shared_ptr<const sim2d::TraceHeader> header = recording_->header();
  const sim2d::TraceHuman* guest = header->human(id);
  return guest != nullptr ? QString::fromStdString(guest->name) : tr("Person %1").arg(id);
}

QString RunEvents::textOf(const sim2d::Event& event) const {
  const QString who = event.hasId ? nameOfAgent(event.id) : QString();
  const QString other = event.hasOther ? nameOfAgent(event.other) : QString();
  const QString text = QString::fromStdString(event.text);
  if (event.kind == EventKind::Contact && !event.hasOther) {
    return tr("%1 touches a wall").arg(who);
  }
  const bool isOfTwo = event.kind == EventKind::Contact || event.kind == EventKind::Heard;
  const bool isGoal = event.kind == EventKind::Goal;
  const QString what = isOfTwo ? other : isGoal ? goalText(event) : text;
  const QString words = tr(presentationOf(event.kind).words);
  return !words.contains(QLatin1String("%1"))   ? words.arg(what)
         : !words.contains(QLatin1String("%2")) ? words.arg(who)
                                                : words.arg(who, what);
}

EventMark markOfEvent(EventKind kind) {
  return presentationOf(kind).mark;
}

void paintEventMark(QPainter& painter, EventMark mark, const QPointF& centre, const Theme& theme) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(centre);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.color(Role::TextSecondary));
  QPainterPath path;
  switch (mark) {
    case EventMark::Pin:
      painter.setBrush(theme.color(Role::Ok));
      painter.drawPath(pinPath());
      break;
    case EventMark::Bubble:
      painter.drawPath(bubblePath());
      break;
    case EventMark::Diamond:
      path.addPolygon(QPolygonF({{0.0, -5.0}, {5.0, 0.0}, {0.0, 5.0}, {-5.0, 0.0}}));
      painter.setBrush(theme.line(Look::Curious));
      painter.drawPath(path);
      break;
    case EventMark::Triangle:
      path.addPolygon(QPolygonF({{0.0, -5.0}, {5.0, 4.0}, {-5.0, 4.0}}));
      painter.setBrush(theme.color(Role::WarningMark));
      painter.drawPath(path);
      break;
    case EventMark::Cross:
      painter.setPen(QPen(theme.color(Role::Error), 2.4, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(QPointF(-3.5, -3.5), QPointF(3.5, 3.5));
      painter.drawLine(QPointF(-3.5, 3.5), QPointF(3.5, -3.5));
      break;
    case EventMark::Ring:
      painter.setPen(QPen(theme.color(Role::TextSecondary), 1.6));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(QPointF(), 3.5, 3.5);
      break;
    case EventMark::None:
      painter.drawEllipse(QPointF(), 1.8, 1.8);
      break;
  }
  painter.restore();
}

QIcon eventIcon(EventMark mark, const Theme& theme) {
  return drawnIcon(16, [&](QPainter& painter) { paintEventMark(painter, mark, {}, theme); });
}

}  // namespace editor
