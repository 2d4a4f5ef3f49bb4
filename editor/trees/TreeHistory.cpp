#include "editor/trees/TreeHistory.h"

#include <cmath>
#include <string_view>

#include "editor/panels/RowDelegate.h"
#include "editor/panels/behavior/TreeOutline.h"
#include "editor/panels/runs/Playback.h"

namespace editor {

namespace {

using base::NodeStatus;

constexpr int kRow = 20;        // [px]
constexpr int kAxis = 18;       // Height below the rows.
constexpr int kNames = 160;     // Width to the left of the bands.
constexpr int kRightRoom = 16;  // Margin to the right of the bands.
constexpr double kTickRoom = 80.0;

QString nodeStatusText(NodeStatus status) {
  return status == NodeStatus::Running   ? QObject::tr("Running")
         : status == NodeStatus::Success ? QObject::tr("Success")
         : status == NodeStatus::Failure ? QObject::tr("Failure")
                                         : QObject::tr("not ticked");
}

Role roleOfStatus(NodeStatus status) {
  return status == NodeStatus::Running   ? Role::Accent
         : status == NodeStatus::Success ? Role::Ok
                                         : Role::ErrorSoft;
}

/// 1, 2 or 5 times a power of ten, at least `least` [s].
double roundStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(least, 1e-3))));
  for (const double each : {1.0, 2.0, 5.0}) {
    if (each * power >= least) {
      return each * power;
    }
  }
  return 10.0 * power;
}

}  // namespace

TreeHistory::TreeHistory(const TreeGraph& graph, SimulationRunner& runner, const Theme& theme)
    : graph_(graph), runner_(runner), theme_(theme) {
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setAccessibleName(tr("What the nodes returned over time"));
  setMinimumHeight(3 * kRow + kAxis);
  viewport()->setMouseTracking(true);
  more_.setSingleShot(true);
  more_.setInterval(0);
  connect(&more_, &QTimer::timeout, this, &TreeHistory::follow);
  connect(&runner_, &SimulationRunner::frameShown, this, &TreeHistory::follow);
  connect(&runner_, &SimulationRunner::stateChanged, this, &TreeHistory::follow);
}

void TreeHistory::setTheme(const Theme& theme) {
  theme_ = theme;
  viewport()->update();
}

void TreeHistory::showPerson(int id) {
  person_ = id;
  recording_ = nullptr;  // Reads the recording again.
  isOtherTree_ = false;
  bands_.assign(graph_.nodes().size(), {});
  follow();
  updateScrollBars();
}

void TreeHistory::choose(int node) {
  chosen_ = node;
  const int row = rowOf(node);
  if (row >= 0) {
    const int top = row * kRow, room = viewport()->height() - kAxis;
    const int value = verticalScrollBar()->value();
    verticalScrollBar()->setValue(top < value                 ? top
                                  : top + kRow > value + room ? top + kRow - room
                                                              : value);
  }
  viewport()->update();
}

/// Reads a part of the new states at a time, because a recorded run may be long.
void TreeHistory::follow() {
  constexpr std::int64_t kStepsAtOnce = 2000;
  const RecordingPtr now = runner_.recording();
  if (now != recording_) {
    recording_ = now;
    read_ = 0;
    isOtherTree_ = false;
    paths_ = nullptr;
    bands_.assign(graph_.nodes().size(), {});
    updateScrollBars();
  }
  if (recording_ != nullptr) {
    const std::int64_t end = std::min(newestStep(), read_ + kStepsAtOnce);
    while (read_ < end && !isOtherTree_) {
      readStep(++read_);
    }
    if (end < newestStep()) {
      more_.start();
    }
  }
  viewport()->update();
}

void TreeHistory::readStep(std::int64_t step) {
  const sim2d::TreeStatuses state = recording_->treeAt(person_, step);
  if (state.paths == nullptr) {
    return;
  }
  if (state.paths != paths_) {
    paths_ = state.paths;
    findNodes();
  }
  for (std::size_t k = 0; k < state.statuses.size() && k < nodesOfPaths_.size(); ++k) {
    std::vector<StatusInterval>& band = bands_[static_cast<std::size_t>(nodesOfPaths_[k])];
    const NodeStatus before = band.empty() ? NodeStatus::Idle : band.back().status;
    if (state.statuses[k] != before) {
      band.push_back({step, state.statuses[k]});
    }
  }
}

/// Maps the nodes of the recording to those of the shown tree.
void TreeHistory::findNodes() {
  std::map<std::string_view, int> places;
  for (std::size_t k = 0; k < graph_.names().size(); ++k) {
    places.emplace(graph_.names()[k], static_cast<int>(k));
  }
  nodesOfPaths_.clear();
  for (const std::string& path : *paths_) {
    const auto place = places.find(path);
    if (place == places.end()) {
      isOtherTree_ = true;
      nodesOfPaths_.clear();
      return;
    }
    nodesOfPaths_.push_back(place->second);
  }
}

int TreeHistory::rowOf(int node) const {
  const auto place = std::find(graph_.shown().begin(), graph_.shown().end(), node);
  return place == graph_.shown().end() ? -1 : static_cast<int>(place - graph_.shown().begin());
}

int TreeHistory::nodeAtY(int y) const {
  const int row = (y + verticalScrollBar()->value()) / kRow;
  const bool isRow = y >= 0 && y < viewport()->height() - kAxis && row >= 0 &&
                     row < static_cast<int>(graph_.shown().size());
  return isRow ? graph_.shown()[static_cast<std::size_t>(row)] : -1;
}

QRect TreeHistory::bandOf(int node) const {
  const int row = rowOf(node);
  return row < 0 ? QRect()
                 : QRect(kNames, row * kRow - verticalScrollBar()->value() + 3,
                         viewport()->width() - kNames - kRightRoom, kRow - 6);
}

std::int64_t TreeHistory::newestStep() const {
  const FramePtr newest = runner_.newestFrame();
  return newest == nullptr ? 0 : newest->step;
}

double TreeHistory::stepLength() const {
  return recording_ == nullptr ? 0.05 : recording_->header()->dt;
}

int TreeHistory::xOf(std::int64_t step) const {
  const double share =
      static_cast<double>(step) / static_cast<double>(std::max<std::int64_t>(newestStep(), 1));
  return kNames +
         static_cast<int>(std::lround(share * (viewport()->width() - kNames - kRightRoom)));
}

std::int64_t TreeHistory::stepAt(int x) const {
  const double share =
      static_cast<double>(x - kNames) / std::max(1, viewport()->width() - kNames - kRightRoom);
  return std::llround(std::clamp(share, 0.0, 1.0) * static_cast<double>(newestStep()));
}

void TreeHistory::updateScrollBars() {
  const int all = recording_ == nullptr ? 0 : kRow * static_cast<int>(graph_.shown().size());
  const int room = std::max(1, viewport()->height() - kAxis);
  verticalScrollBar()->setRange(0, std::max(0, all - room));
  verticalScrollBar()->setPageStep(room);
  verticalScrollBar()->setSingleStep(kRow);
  viewport()->update();
}

void TreeHistory::resizeEvent(QResizeEvent* event) {
  QAbstractScrollArea::resizeEvent(event);
  updateScrollBars();
}

void TreeHistory::mousePressEvent(QMouseEvent* event) {
  const int node = nodeAtY(event->y());
  if (node >= 0) {
    choose(node);
    Q_EMIT choiceChanged(node);
  }
  if (event->x() >= kNames && runner_.recording() != nullptr) {
    runner_.seek(stepAt(event->x()));
  }
}

void TreeHistory::mouseMoveEvent(QMouseEvent* event) {
  const bool isDragged = (event->buttons() & Qt::LeftButton) != 0;
  if (isDragged && event->x() >= kNames && runner_.recording() != nullptr) {
    runner_.seek(stepAt(event->x()));
  }
}

bool TreeHistory::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto& help = static_cast<const QHelpEvent&>(*event);
    const int node = nodeAtY(help.y());
    if (node < 0) {
      QToolTip::hideText();
      return true;
    }
    const std::int64_t step = stepAt(help.x());
    NodeStatus status = NodeStatus::Idle;
    for (const StatusInterval& each : intervalsOf(node)) {
      status = each.from <= step ? each.status : status;
    }
    QString text = nodeTitle(*graph_.node(node).node);
    if (help.x() >= kNames) {
      text += QStringLiteral("\n%1 · %2")
                  .arg(clockText(static_cast<double>(step) * stepLength()), nodeStatusText(status));
    }
    QToolTip::showText(help.globalPos(), text, viewport());
    return true;
  }
  return QAbstractScrollArea::viewportEvent(event);
}

void TreeHistory::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(viewport());
  painter.fillRect(viewport()->rect(), theme_.color(Role::Panel));
  if (runner_.recording() == nullptr || isOtherTree_) {
    painter.setPen(theme_.color(Role::TextSecondary));
    painter.drawText(viewport()->rect(), Qt::AlignCenter | Qt::TextWordWrap,
                     isOtherTree_
                         ? tr("The run used another tree: run it again to see its nodes here.")
                         : tr("Run the scenario to see what each node returns over time."));
    return;
  }
  painter.setClipRect(0, 0, viewport()->width(), viewport()->height() - kAxis);
  for (std::size_t row = 0; row < graph_.shown().size(); ++row) {
    paintRow(painter, static_cast<int>(row), graph_.shown()[row]);
  }
  painter.setClipping(false);
  paintAxis(painter);
}

void TreeHistory::paintRow(QPainter& painter, int row, int node) const {
  const int top = row * kRow - verticalScrollBar()->value();
  if (top + kRow < 0 || top > viewport()->height()) {
    return;
  }
  if (node == chosen_) {
    painter.fillRect(QRect(0, top, viewport()->width(), kRow), theme_.color(Role::RowSelected));
  }
  int depth = 0;
  for (int above = graph_.node(node).parent; above >= 0; above = graph_.node(above).parent) {
    ++depth;
  }
  const int left = 12 + std::min(8 * depth, kNames / 2);
  painter.setFont(theme_.font(9.0, node == chosen_ ? QFont::DemiBold : QFont::Normal));
  painter.setPen(theme_.color(node == chosen_ ? Role::Text : Role::TextSecondary));
  const QRect room(left, top, kNames - left - 8, kRow);
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(nodeTitle(*graph_.node(node).node),
                                                    Qt::ElideRight, room.width()));
  paintBand(painter, bandOf(node), intervalsOf(node));
}

void TreeHistory::paintBand(QPainter& painter, const QRect& band,
                            const std::vector<StatusInterval>& its) const {
  painter.fillRect(QRect(band.left(), band.center().y(), band.width(), 1),
                   theme_.color(Role::Line));
  painter.setFont(theme_.font(8.0));
  for (std::size_t k = 0; k < its.size(); ++k) {
    const NodeStatus status = its[k].status;
    if (status == NodeStatus::Idle || status == NodeStatus::Skipped) {
      continue;
    }
    const int from = xOf(its[k].from);
    const int to = k + 1 < its.size() ? xOf(its[k + 1].from) : xOf(newestStep());
    const QRect part(from, band.top(), std::max(1, to - from), band.height());
    painter.fillRect(part, theme_.color(Role::Panel));
    painter.fillRect(part, theme_.color(roleOfStatus(status), 0.3));
    painter.fillRect(QRect(part.left(), part.top(), std::min(2, part.width()), part.height()),
                     theme_.color(roleOfStatus(status)));
    const QString words = nodeStatusText(status);
    if (painter.fontMetrics().horizontalAdvance(words) + 14 < part.width()) {
      painter.setPen(theme_.color(Role::Text));
      painter.drawText(part.adjusted(7, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, words);
    }
  }
}

std::vector<double> TreeHistory::labelledTimes() const {
  const double length = static_cast<double>(newestStep()) * stepLength();
  const double perPixel = length / std::max(1, viewport()->width() - kNames - kRightRoom);
  // Not finer than the steps: several labels would be at the same one.
  const double tick = std::max(roundStep(perPixel * kTickRoom), stepLength());
  std::vector<double> times;
  for (int k = 0; length > 0.0 && k * tick <= length + 1e-9; ++k) {
    times.push_back(k * tick);
  }
  return times;
}

void TreeHistory::paintAxis(QPainter& painter) const {
  const int y = viewport()->height() - kAxis;
  painter.fillRect(QRect(0, y, viewport()->width(), kAxis), theme_.color(Role::Panel));
  painter.setFont(theme_.font(8.0));
  painter.setPen(theme_.color(Role::TextSecondary));
  for (const double time : labelledTimes()) {
    const int x = xOf(std::llround(time / stepLength()));
    painter.drawText(QRect(x - 40, y, 80, kAxis), Qt::AlignCenter,
                     QStringLiteral("%1 s").arg(time));
  }
  if (const FramePtr shown = runner_.shownFrame()) {
    painter.fillRect(QRect(xOf(shown->step), 0, 2, y),
                     theme_.color(runner_.isLookingBack() ? Role::Past : Role::WarningMark));
  }
}

}  // namespace editor
