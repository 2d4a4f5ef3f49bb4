#include "editor/panels/runs/Playback.h"

#include <cmath>
#include <iterator>
#include <limits>

#include "editor/canvas/ComparedRunLayers.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"
#include "sim2d/world/Runner.h"

namespace editor {

namespace {

constexpr int kLeft = 152;  // Left end of the timeline groove [px].
constexpr int kRight = 24;
constexpr double kGrooveY = 17.0;
constexpr double kMarkY = 6.0;
constexpr int kLabelPx = 90;            // Minimum distance of labelled ticks.
constexpr double kMarkFont = 8.0;       // [pt]
constexpr double kMarkNumberGap = 8.0;  // Distance from the centre of a mark to its number [px].

struct Speed {
  const char* text;
  double factor;
};
constexpr Speed kSpeeds[] = {{"0.25 ×", 0.25}, {"0.5 ×", 0.5},
                             {"1.0 ×", 1.0},   {"2.0 ×", 2.0},
                             {"4.0 ×", 4.0},   {"8.0 ×", 8.0},
                             {"16 ×", 16.0},   {"max", std::numeric_limits<double>::infinity()}};

/// Appends a factor that is not in the list.
void showRequestedSpeed(QComboBox& box, double factor) {
  const QSignalBlocker blocked(box);
  const int count = static_cast<int>(std::size(kSpeeds));
  int at = box.findData(factor);
  if (at < 0 || at >= count) {
    box.removeItem(count);
    box.addItem(QObject::tr("%1 ×").arg(factor, 0, 'g', 3), factor);
    at = count;
  }
  box.setCurrentIndex(at);
}

double tickStep(double length, double width) {
  for (const double step : {1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0}) {
    if (width * step / length >= kLabelPx) {
      return step;
    }
  }
  return 3600.0;
}

/// Priority of a mark: rarer events are higher; 0: not shown.
int priorityOf(EventMark mark) {
  return mark == EventMark::Cross                              ? 3
         : mark == EventMark::Triangle                         ? 2
         : mark == EventMark::Pin || mark == EventMark::Bubble ? 1
                                                               : 0;
}

}  // namespace

QString tenthsText(double seconds) {
  return QString::number(std::floor(seconds * 10.0 + 1e-6) / 10.0, 'f', 1);
}

QString clockText(double seconds) {
  const auto tenths = static_cast<long long>(std::floor(seconds * 10.0 + 1e-6));
  return QStringLiteral("%1:%2.%3")
      .arg(tenths / 600)
      .arg((tenths / 10) % 60, 2, 10, QLatin1Char('0'))
      .arg(tenths % 10);
}

PlaybackActions::PlaybackActions(SimulationRunner& runner, const Theme& theme)
    : reset(makeAction(tr("Return to editing"), QKeySequence(int{Qt::CTRL} | Qt::Key_R),
                       tr("End the run; the scenario can be edited again"), this)),
      stepBack(makeAction(tr("Step back"), QKeySequence(Qt::Key_Comma),
                          tr("Go back one recorded step"), this)),
      playPause(makeAction(tr("Play"), QKeySequence(Qt::Key_Space),
                           tr("Run or pause the simulation"), this)),
      step(makeAction(tr("Step"), QKeySequence(Qt::Key_Period), tr("One step forward, then pause"),
                      this)),
      newest(makeAction(tr("Go to newest step"), QKeySequence(Qt::Key_End),
                        tr("Show the newest step of the run"), this)),
      branchHere(
          makeAction(tr("&Branch here…"), QKeySequence(int{Qt::CTRL} | Qt::Key_B), {}, this)),
      runner_(runner),
      theme_(theme) {
  playPause->setShortcuts({Qt::Key_Space, int{Qt::CTRL} | Qt::Key_Space});  // Ctrl while typing.
  connect(reset, &QAction::triggered, this, [this] {
    if (confirmDiscardOfBranches(runner_, QApplication::activeWindow())) {
      runner_.reset();
    }
  });
  connect(stepBack, &QAction::triggered, &runner_, &SimulationRunner::stepBack);
  connect(step, &QAction::triggered, &runner_, &SimulationRunner::stepOnce);
  connect(newest, &QAction::triggered, &runner_, &SimulationRunner::seekNewest);
  connect(playPause, &QAction::triggered, this, [this] {
    runner_.state() == SimulationRunner::State::Running ? runner_.pause() : runner_.play();
  });
  connect(&runner_, &SimulationRunner::stateChanged, this, &PlaybackActions::follow);
  connect(&runner_, &SimulationRunner::lookingBackChanged, this, &PlaybackActions::follow);
  setTheme(theme);
}

void PlaybackActions::setTheme(const Theme& theme) {
  theme_ = theme;
  reset->setIcon(themedIcon(QStringLiteral("run-reset"), theme));
  stepBack->setIcon(themedIcon(QStringLiteral("run-step-back"), theme));
  step->setIcon(themedIcon(QStringLiteral("run-step"), theme));
  follow();
}

void PlaybackActions::follow() {
  const auto state = runner_.state();
  const bool running = state == SimulationRunner::State::Running;
  const bool editing = state == SimulationRunner::State::Editing;
  playPause->setText(running ? tr("Pause") : tr("Play"));
  describe(*playPause, tr("Run or pause the simulation"));
  playPause->setCheckable(true);
  playPause->setChecked(running);
  playPause->setIcon(
      themedIcon(running ? QStringLiteral("run-pause") : QStringLiteral("run-play"), theme_));
  const QString noRun = tr("Start a run first: Space");
  setEnabled(*reset, !editing, noRun);
  setEnabled(*stepBack, !editing, noRun);
  setEnabled(*newest, runner_.isLookingBack(),
             editing ? noRun : tr("The newest step is already shown"));
}

QComboBox* PlaybackActions::makeSpeedBox(QWidget* parent) {
  auto* box = new QComboBox(parent);
  for (const Speed& speed : kSpeeds) {
    box->addItem(QString::fromUtf8(speed.text), speed.factor);
  }
  box->setCurrentIndex(box->findText(QStringLiteral("1.0 ×")));
  box->setFixedWidth(76);
  box->setFocusPolicy(Qt::TabFocus);
  box->setToolTip(tr("Speed\nSimulated seconds per real second"));
  box->setAccessibleName(tr("Speed"));
  connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this,
          [this, box](int index) { runner_.setSpeed(box->itemData(index).toDouble()); });
  connect(&runner_, &SimulationRunner::speedRequested, box,
          [box](double factor) { showRequestedSpeed(*box, factor); });
  return box;
}

bool confirmDiscardOfBranches(const SimulationRunner& runner, QWidget* parent) {
  const std::vector<RunnerBranch>& runs = runner.branches();
  if (runs.size() < 2) {
    return true;  // The same run can be started again.
  }
  return QMessageBox::question(
             parent, QObject::tr("Discard the branches?"),
             QObject::tr("The run and its branches (%1 runs in total) will be discarded.")
                 .arg(runs.size()),
             QMessageBox::Discard | QMessageBox::Cancel,
             QMessageBox::Cancel) == QMessageBox::Discard;
}

TimelineBar::TimelineBar(const ScenarioDocument& document, RunEvents& events,
                         SimulationRunner& runner, const Theme& theme)
    : document_(document),
      events_(events),
      runner_(runner),
      theme_(theme),
      loop_(runner, {[this](double time) { return xOf(time); },
                     [this](double x) { return std::min(timeAt(x), newestTime()); }}) {
  setFixedHeight(44);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setFocusPolicy(Qt::TabFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Timeline"));
  const auto repaint = [this] { update(); };
  connect(&runner_, &SimulationRunner::frameShown, this, [this] {
    afterEnd_ = 0.0;
    update();
  });
  connect(&runner_, &SimulationRunner::stateChanged, this, repaint);
  connect(&runner_, &SimulationRunner::loopChanged, this, repaint);
  connect(&events_, &RunEvents::cleared, this, repaint);
  connect(&events_, &RunEvents::notesChanged, this, repaint);
  connect(&document_, &ScenarioDocument::stepFinished, this, repaint);
}

void TimelineBar::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

void TimelineBar::setCompared(const std::vector<TimelineRun>& runs) {
  compared_ = runs;
  if (afterEnd_ > comparedEnd()) {
    afterEnd_ = comparedEnd() > newestTime() ? comparedEnd() : 0.0;
    Q_EMIT timeAfterEndChosen(afterEnd_);
  }
  update();
}

double TimelineBar::comparedEnd() const {
  double end = 0.0;
  for (const TimelineRun& run : compared_) {
    end = std::max(end, run.end);
  }
  return end;
}

double TimelineBar::length() const {
  if (runner_.isFinished()) {
    return std::max({newestTime(), comparedEnd(), 1.0});
  }
  const sim2d::Scenario& scenario = document_.scenario();
  const double planned = static_cast<double>(sim2d::stopRuleOf(scenario).maximumSteps) *
                         scenario.desktop.dt.value_or(0.05);
  return std::max({planned, newestTime(), 1.0});
}

double TimelineBar::xOf(double time) const {
  return kLeft + time / length() * (width() - kLeft - kRight);
}

double TimelineBar::timeAt(double x) const {
  const double part = (x - kLeft) / (width() - kLeft - kRight);
  return std::clamp(part, 0.0, 1.0) * length();
}

void TimelineBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme_.color(Role::Panel));
  painter.fillRect(QRect(0, 0, width(), 1), theme_.color(Role::Line));
  painter.setRenderHint(QPainter::Antialiasing);
  paintClock(painter);
  paintTicks(painter);
  loop_.paint(painter, theme_);
  paintGroove(painter);
  paintCompared(painter);
  paintNotes(painter);
  paintMarks(painter);
}

/// Draws a line across the groove with a head above it for each note.
void TimelineBar::paintNotes(QPainter& painter) const {
  constexpr double kHalfLength = 6.0, kHead = 3.0;  // [px]
  painter.setPen(QPen(theme_.color(Role::Accent), 2.0));
  painter.setBrush(theme_.color(Role::Accent));
  for (const RunNote& note : events_.notes()) {
    const double x = xOf(note.time);
    painter.drawLine(QPointF(x, kGrooveY - kHalfLength), QPointF(x, kGrooveY + kHalfLength));
    painter.drawPolygon(QPolygonF({QPointF(x - kHead, kGrooveY - kHalfLength),
                                   QPointF(x + kHead, kGrooveY - kHalfLength),
                                   QPointF(x, kGrooveY - kHalfLength + kHead)}));
  }
}

/// Draws a line below the groove for each of the first two runs, as long as the run, with ticks at
/// contacts.
void TimelineBar::paintCompared(QPainter& painter) const {
  constexpr std::size_t kMaxLines = 2;
  constexpr double kFirstY = 21.5, kLineGap = 3.0;
  for (std::size_t k = 0; k < std::min(kMaxLines, compared_.size()); ++k) {
    const GhostStyle style = ghostStyle(compared_[k].style, theme_);
    const double y = kFirstY + kLineGap * static_cast<double>(k);
    QPen pen(style.color, 1.6);
    if (!style.dashes.isEmpty()) {
      pen.setDashPattern(style.dashes);
    }
    painter.setPen(pen);
    painter.drawLine(QPointF(xOf(0.0), y), QPointF(xOf(compared_[k].end), y));
    painter.setPen(QPen(style.color, 2.0));
    for (const double time : compared_[k].contacts) {
      painter.drawLine(QPointF(xOf(time), y - 3.0), QPointF(xOf(time), y + 3.0));
    }
  }
}

void TimelineBar::paintClock(QPainter& painter) const {
  const QString now = clockText(pointedTime());
  painter.setFont(theme_.font(10.5, QFont::DemiBold));
  painter.setPen(theme_.color(Role::Text));
  const QRect place(12, 0, 72, height());
  painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, now);
  const int used = painter.fontMetrics().horizontalAdvance(now);
  painter.setFont(theme_.font(9.0));
  painter.setPen(theme_.color(Role::TextSecondary));
  painter.drawText(QRect(12 + used + 8, 0, 90, height()), Qt::AlignLeft | Qt::AlignVCenter,
                   QStringLiteral("/ ") + clockText(length()));
}

void TimelineBar::paintTicks(QPainter& painter) const {
  painter.setFont(theme_.font(8.0));
  const double step = tickStep(length(), width() - kLeft - kRight);
  const int last = static_cast<int>((length() + 1e-9) / step);
  for (int tick = 0; tick <= last; ++tick) {
    const double time = tick * step;
    const double x = xOf(time);
    painter.fillRect(QRectF(std::floor(x), 25.0, 1.0, 4.0), theme_.color(Role::FieldEdge));
    painter.setPen(theme_.color(Role::TextSecondary));
    painter.drawText(QRectF(x - 40.0, 28.0, 80.0, 14.0), Qt::AlignHCenter | Qt::AlignTop,
                     QStringLiteral("%1 s").arg(time));
    const double half = xOf(time + step / 2.0);
    if (time + step / 2.0 <= length()) {
      painter.fillRect(QRectF(std::floor(half), 25.0, 1.0, 2.0), theme_.color(Role::FieldEdge));
    }
  }
}

void TimelineBar::paintGroove(QPainter& painter) const {
  const auto line = [&](double from, double to, const QColor& color) {
    painter.setPen(QPen(color, 4.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(xOf(from), kGrooveY), QPointF(xOf(to), kGrooveY));
  };
  line(0.0, length(), theme_.color(Role::Line));
  const bool running = runner_.state() != SimulationRunner::State::Editing;
  if (running) {
    const double oldest = runner_.oldestTime();
    line(oldest, newestTime(), theme_.color(Role::Accent, 0.45));
    line(oldest, std::max(oldest, shownTime()), theme_.color(Role::Accent));
    if (oldest > 0.0) {
      paintDroppedRange(painter, xOf(oldest));
    }
  }
  const double x = xOf(pointedTime());
  painter.setPen(QPen(theme_.color(running ? Role::Accent : Role::ObstacleEdge), 2.0));
  painter.setBrush(theme_.color(Role::Panel));
  painter.drawEllipse(QPointF(x, kGrooveY), 6.0, 6.0);
}

/// Marks the dropped part to the left of x.
void TimelineBar::paintDroppedRange(QPainter& painter, double x) const {
  painter.fillRect(QRectF(kLeft, kGrooveY - 3.0, x - kLeft, 6.0), theme_.color(Role::Panel));
  painter.setPen(QPen(theme_.color(Role::FieldEdge), 2.0, Qt::DotLine));
  painter.drawLine(QPointF(kLeft, kGrooveY), QPointF(x, kGrooveY));
  painter.setPen(QPen(theme_.color(Role::WarningMark), 2.0));
  painter.drawLine(QPointF(x, kGrooveY - 6.0), QPointF(x, kGrooveY + 6.0));
}

std::vector<TimelineBar::Cluster> TimelineBar::clusters() const {
  constexpr double kApart = 13.0;  // Minimum distance between two marks [px].
  constexpr double kWidest = 48.0;
  const QFontMetrics metrics(theme_.font(kMarkFont));
  const auto numberOf = [&metrics](const Cluster& last) {
    const QString number = QString::number(last.count);
    return last.count > 1 ? kMarkNumberGap + metrics.horizontalAdvance(number) : 0.0;
  };
  std::vector<Cluster> all;
  for (const RunEvent& event : events_.events()) {
    const EventMark mark = markOfEvent(event.event.kind);
    const int loudness = priorityOf(mark);
    const double x = xOf(event.time);
    if (loudness == 0) {
      continue;
    }
    if (all.empty() || x - all.back().last >= kApart + numberOf(all.back()) ||
        x - all.back().first >= kWidest) {
      all.push_back({mark, x, x, 1});
      continue;
    }
    Cluster& last = all.back();
    last.last = x;
    if (loudness > priorityOf(last.mark)) {
      last.mark = mark;
      last.count = 1;
    } else if (loudness == priorityOf(last.mark)) {
      ++last.count;
    }
  }
  return all;
}

/// Draws several events of one kind at a place as one mark with their number.
void TimelineBar::paintMarks(QPainter& painter) const {
  painter.setFont(theme_.font(kMarkFont));
  for (const Cluster& cluster : clusters()) {
    const QPointF at(0.5 * (cluster.first + cluster.last), kMarkY);
    paintEventMark(painter, cluster.mark, at, theme_);
    if (cluster.count > 1) {
      painter.setPen(theme_.color(Role::TextSecondary));
      painter.drawText(QRectF(at.x() + 6.0, kMarkY - 7.0, 30.0, 14.0),
                       Qt::AlignLeft | Qt::AlignVCenter, QString::number(cluster.count));
    }
  }
}

void TimelineBar::seekTo(double x) {
  const RecordingPtr recording = runner_.recording();
  if (recording != nullptr && recording->size() > 0) {
    seekTime(timeAt(x));
  }
}

/// A finished run stays at its last state while longer compared runs continue.
void TimelineBar::seekTime(double time) {
  const RecordingPtr recording = runner_.recording();
  const double end = newestTime();
  runner_.seek(recording->stepOf(recording->indexAtTime(std::min(time, end))));
  const double chosen = std::min(time, comparedEnd());
  if (runner_.isFinished() && chosen > end) {
    afterEnd_ = chosen;
    Q_EMIT timeAfterEndChosen(chosen);
    update();
  }
}

/// Steps back or forward through the recorded states, and beyond the end of the shown run.
void TimelineBar::seekBy(int steps) {
  const bool isAtEnd = runner_.isFinished() && shownTime() >= newestTime();
  if (afterEnd_ > 0.0 || (steps > 0 && isAtEnd && comparedEnd() > newestTime())) {
    seekTime(pointedTime() + steps * runner_.recording()->header()->dt);
  } else if (steps < 0) {
    runner_.stepBack();
  } else if (runner_.isLookingBack() || runner_.isRecorded()) {
    runner_.stepOnce();
  }
}

void TimelineBar::mousePressEvent(QMouseEvent* event) {
  const bool isRun = runner_.state() != SimulationRunner::State::Editing;
  const bool isFresh = isRun && event->modifiers().testFlag(Qt::ShiftModifier);
  if (event->button() == Qt::LeftButton && !loop_.press(event->localPos(), isFresh)) {
    seekTo(event->localPos().x());
  }
}

/// The commands at this time of the run.
void TimelineBar::contextMenuEvent(QContextMenuEvent* event) {
  if (menuActions_.isEmpty() || runner_.state() == SimulationRunner::State::Editing) {
    return;
  }
  if (event->reason() == QContextMenuEvent::Mouse && event->x() >= kLeft) {
    seekTo(event->x());
  }
  if (menu_ == nullptr) {  // Kept, because a command may open a dialog.
    menu_ = new QMenu(this);
    menu_->setToolTipsVisible(true);
    menu_->addActions(menuActions_);
  }
  menu_->popup(event->globalPos());
}

void TimelineBar::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) {
    if (!loop_.drag(event->localPos().x())) {
      seekTo(event->localPos().x());
    }
    return;
  }
  setCursor(loop_.isOver(event->localPos()) ? Qt::SizeHorCursor : Qt::ArrowCursor);
}

void TimelineBar::mouseReleaseEvent(QMouseEvent*) {
  loop_.release();
}

void TimelineBar::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      seekBy(-1);
      break;
    case Qt::Key_Right:
      seekBy(1);
      break;
    case Qt::Key_Home:
      seekTo(kLeft);
      break;
    case Qt::Key_End:
      runner_.seekNewest();
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

bool TimelineBar::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) {
    return QWidget::event(event);
  }
  const auto* help = static_cast<QHelpEvent*>(event);
  QStringList near;
  for (const RunEvent& runEvents : events_.events()) {
    if (std::fabs(xOf(runEvents.time) - help->x()) < 6.0 && near.size() < 6) {
      near.push_back(clockText(runEvents.time) + QStringLiteral("  ") + runEvents.text);
    }
  }
  for (const RunNote& note : events_.notes()) {
    if (std::fabs(xOf(note.time) - help->x()) < 6.0) {
      near.push_back(clockText(note.time) + QStringLiteral("  ") + note.text);
    }
  }
  const double time = timeAt(help->x());
  if (near.isEmpty() && help->x() >= kLeft) {
    near.push_back(clockText(time));
  }
  if (help->x() >= kLeft && time < runner_.oldestTime()) {
    near.push_back(tr("No longer stored: the disk is full"));
  }
  QToolTip::showText(help->globalPos(), near.join(QLatin1Char('\n')), this);
  return true;
}

}  // namespace editor
