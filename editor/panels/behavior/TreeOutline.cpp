#include "editor/panels/behavior/TreeOutline.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <QHeaderView>
#include <QInputDialog>
#include <QKeyEvent>
#include <QPainter>

#include "bt/human/TreeBehavior.h"
#include "editor/look/CoreText.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/FigurePainter.h"
#include "editor/panels/RowDelegate.h"
#include "sim2d/base/Find.h"

namespace editor {

namespace {

using base::NodeStatus;

constexpr int kNodeRole = Qt::UserRole + 1;
constexpr int kMarkSize = 16;

/// Drawn at the corner of the mark.
void paintBreakpoint(QPainter& painter, const Theme& theme) {
  painter.setPen(QPen(theme.color(Role::Panel), 1.0));
  painter.setBrush(theme.color(Role::Error));
  painter.drawEllipse(QPointF(3.5, 12.5), 3.0, 3.0);
}

/// Null status: no run is shown.
QIcon markOf(const NodeStatus* status, bool isBreakpoint, const Theme& theme) {
  const auto draw = [&](QPainter& painter) {
    if (status != nullptr) {
      paintStatusMark(painter, *status, theme);
    }
    if (isBreakpoint) {
      painter.translate(-kMarkSize / 2.0, -kMarkSize / 2.0);
      paintBreakpoint(painter, theme);
    }
  };
  return status == nullptr && !isBreakpoint ? QIcon() : drawnIcon(kMarkSize, draw, {3});
}

QString unitOf(const bt::PortSpec& port) {
  return port.unit.empty() ? QString() : QLatin1Char(' ') + QString::fromStdString(port.unit);
}

}  // namespace

void paintStatusMark(QPainter& painter, NodeStatus status, const Theme& theme) {
  constexpr QPointF kCentre(kMarkSize / 2.0, kMarkSize / 2.0);
  painter.save();
  painter.translate(-kCentre);
  QPen sign(theme.color(Role::Panel), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  painter.setPen(Qt::NoPen);
  switch (status) {
    case NodeStatus::Running:
      painter.setBrush(theme.color(Role::Accent));
      painter.drawPolygon(QPolygonF({{4.0, 2.5}, {13.5, 8.0}, {4.0, 13.5}}));
      break;
    case NodeStatus::Success:
      painter.setBrush(theme.color(Role::Ok));
      painter.drawEllipse(kCentre, 5.5, 5.5);
      painter.setPen(sign);
      painter.setBrush(Qt::NoBrush);
      painter.drawPolyline(QPolygonF({{5.5, 8.2}, {7.3, 10.0}, {10.6, 6.2}}));
      break;
    case NodeStatus::Failure:
      painter.setBrush(theme.color(Role::ErrorSoft));
      painter.drawRoundedRect(QRectF(3.0, 3.0, 10.0, 10.0), 2.0, 2.0);
      painter.setPen(sign);
      painter.drawLine(QPointF(6.0, 6.0), QPointF(10.0, 10.0));
      painter.drawLine(QPointF(10.0, 6.0), QPointF(6.0, 10.0));
      break;
    case NodeStatus::Idle:
    case NodeStatus::Skipped:
      painter.setPen(QPen(theme.color(Role::TextSecondary), 1.3));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(kCentre, 4.0, 4.0);
      break;
  }
  painter.restore();
}

QString nodeKindText(const bt::NodeSpec& node) {
  if (node.isSubTree()) {
    return QObject::tr("subtree");
  }
  return node.name.empty() ? QString() : QString::fromStdString(node.id);
}

QString nodeValues(const bt::NodeSpec& node) {
  QStringList values;
  const bt::NodeManifest* manifest = treeCatalogue().find(node.id);
  for (const bt::Attribute& attribute : node.ports) {
    if (attribute.text.empty() || bt::referencedKey(attribute.text, attribute.name)) {
      continue;
    }
    const bt::PortSpec* port = manifest == nullptr ? nullptr : manifest->port(attribute.name);
    if (port != nullptr && port->portType == bt::PortType::Bool) {
      continue;  // Meaningless without its name.
    }
    const QString text = QString::fromStdString(attribute.text);
    const bool words = port != nullptr && port->portType == bt::PortType::String;
    values << (words ? QStringLiteral("“%1”").arg(text)
                     : text + (port == nullptr ? QString() : unitOf(*port)));
  }
  return values.join(QStringLiteral(", "));
}

std::vector<NodeStatus> statusesByNode(const sim2d::TreeStatuses& state,
                                       const std::vector<std::string>& names) {
  if (state.paths == nullptr || *state.paths == names) {
    return state.statuses;
  }
  std::map<std::string_view, std::size_t> places;
  for (std::size_t node = 0; node < names.size(); ++node) {
    places.emplace(names[node], node);
  }
  std::vector<NodeStatus> statuses(names.size(), NodeStatus::Idle);
  for (std::size_t k = 0; k < state.statuses.size(); ++k) {
    const auto place = places.find((*state.paths)[k]);
    if (place == places.end()) {
      return {};
    }
    statuses[place->second] = state.statuses[k];
  }
  return statuses;
}

QString nodeTitle(const bt::NodeSpec& node) {
  return QString::fromStdString(node.label());
}

TreeOutline::TreeOutline(const Theme& theme) : theme_(theme) {
  setColumnCount(1);
  styleList(*this, tr("Behaviour tree"));
  header()->hide();
  setIndentation(14);
  setUniformRowHeights(true);
  setItemDelegate(new RowDelegate(this));
}

void TreeOutline::setTheme(const Theme& theme) {
  theme_ = theme;
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    paintRow(node);
  }
}

void TreeOutline::showTree(const PersonTree& tree) {
  const int current = currentNode();
  const QSignalBlocker quiet(this);
  clear();
  tree_ = tree;
  nodes_ = outlineOf(tree_);
  names_ = recordedNames(nodes_);
  rows_.clear();
  statuses_.clear();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const OutlineNode& node = nodes_[i];
    auto* row = node.parent < 0 ? new QTreeWidgetItem(this)
                                : new QTreeWidgetItem(rows_[static_cast<std::size_t>(node.parent)]);
    row->setText(0, nodeTitle(*node.node));
    row->setData(0, kNodeRole, static_cast<int>(i));
    const QString values = nodeValues(*node.node);
    row->setData(0, kSideTextRole, values.isEmpty() ? nodeKindText(*node.node) : values);
    const bt::NodeManifest* manifest = treeCatalogue().find(node.node->id);
    row->setToolTip(0, manifest == nullptr
                           ? QString::fromStdString(node.node->id)
                           : QStringLiteral("%1\n%2").arg(QString::fromStdString(node.node->id),
                                                          coreText(manifest->description)));
    rows_.push_back(row);
    paintRow(i);
  }
  expandAll();
  selectNode(current);
}

void TreeOutline::showStatus(const sim2d::TreeStatuses& state) {
  const std::vector<NodeStatus> before = std::exchange(statuses_, statusesByNode(state, names_));
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    if (before.size() != statuses_.size() || (!before.empty() && before[node] != statuses_[node])) {
      paintRow(node);
    }
  }
}

void TreeOutline::showBreakpoints(const std::vector<sim2d::TreeBreakpoint>& points) {
  if (points == breakpoints_) {
    return;
  }
  breakpoints_ = points;
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    paintRow(node);
  }
}

std::string TreeOutline::nameOf(int node) const {
  const auto index = static_cast<std::size_t>(node);
  return node < 0 || index >= names_.size() ? std::string() : names_[index];
}

int TreeOutline::nodeNamed(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  return found == names_.end() ? -1 : static_cast<int>(found - names_.begin());
}

int TreeOutline::nodeAt(const QPoint& place) const {
  const QTreeWidgetItem* row = itemAt(place);
  return row == nullptr ? -1 : row->data(0, kNodeRole).toInt();
}

NodeStatus TreeOutline::statusOf(int node) const {
  const auto index = static_cast<std::size_t>(node);
  return index < statuses_.size() ? statuses_[index] : NodeStatus::Idle;
}

void TreeOutline::paintRow(std::size_t node) {
  QTreeWidgetItem& row = *rows_[node];
  const bool shown = node < statuses_.size();
  const NodeStatus status = shown ? statuses_[node] : NodeStatus::Idle;
  const bool stops =
      std::any_of(breakpoints_.begin(), breakpoints_.end(),
                  [&](const sim2d::TreeBreakpoint& point) { return point.path == names_[node]; });
  row.setIcon(0, markOf(shown ? &status : nullptr, stops, theme_));
  const bool running = shown && status == NodeStatus::Running;
  QFont font = this->font();
  font.setWeight(running ? QFont::DemiBold : QFont::Normal);
  row.setFont(0, font);
  const bool pale = shown ? status == NodeStatus::Idle : !nodes_[node].isEditable;
  row.setForeground(0, theme_.color(running ? Role::AccentText
                                    : pale  ? Role::TextSecondary
                                            : Role::Text));
}

void TreeOutline::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace) {
    Q_EMIT removeRequested();
    return;
  }
  QTreeWidget::keyPressEvent(event);
}

int TreeOutline::currentNode() const {
  const QTreeWidgetItem* row = currentItem();
  return row == nullptr ? -1 : row->data(0, kNodeRole).toInt();
}

const OutlineNode* TreeOutline::current() const {
  const int node = currentNode();
  return node < 0 ? nullptr : &nodes_[static_cast<std::size_t>(node)];
}

void TreeOutline::selectNode(int node) {
  if (node >= 0 && node < static_cast<int>(rows_.size())) {
    setCurrentItem(rows_[static_cast<std::size_t>(node)]);
  }
}

namespace {

using sim2d::TreeBreakpoint;

struct BreakCondition {
  const char* words;
  std::optional<NodeStatus> status;
};
constexpr BreakCondition kBreakConditions[] = {
    {QT_TRANSLATE_NOOP("Breakpoint", "starts to be ticked"), std::nullopt},
    {QT_TRANSLATE_NOOP("Breakpoint", "starts to run"), NodeStatus::Running},
    {QT_TRANSLATE_NOOP("Breakpoint", "starts to succeed"), NodeStatus::Success},
    {QT_TRANSLATE_NOOP("Breakpoint", "starts to fail"), NodeStatus::Failure}};

void addBreakpoint(SimulationRunner& runner, const TreeBreakpoint& point) {
  std::vector<TreeBreakpoint> points = runner.breakpoints();
  points.push_back(point);
  runner.setBreakpoints(std::move(points));
}

/// Repeats the dialog until the condition is valid or the user cancels.
void askForCondition(SimulationRunner& runner, const TreeBreakpoint& point, QWidget& window,
                     const QString& problem = {}) {
  auto* dialog = new QInputDialog(&window);
  deleteWhenClosed(*dialog);
  dialog->setWindowTitle(QObject::tr("Conditional breakpoint"));
  dialog->setLabelText(problem.isEmpty()
                           ? QObject::tr("Stop when the node starts to be ticked with this "
                                         "blackboard condition true, for example  id == 2:")
                           : problem);
  dialog->setTextValue(QString::fromStdString(point.condition));
  QObject::connect(dialog, &QInputDialog::textValueSelected, &window,
                   [&runner, &window, asked = point](const QString& text) mutable {
                     asked.condition = text.trimmed().toStdString();
                     const base::Diagnostics wrong = bt::checkBreakpoint(asked);
                     if (wrong.empty()) {
                       addBreakpoint(runner, asked);
                     } else {
                       askForCondition(runner, asked, window,
                                       QString::fromStdString(wrong.front().message));
                     }
                   });
  dialog->open();
}

}  // namespace

QString breakpointText(const TreeBreakpoint& point) {
  const auto* const way = base::findBy(kBreakConditions, &BreakCondition::status, point.status);
  QString words =
      QObject::tr("when it %1")
          .arg(way == nullptr ? QCoreApplication::translate("Breakpoint", "starts to be skipped")
                              : QCoreApplication::translate("Breakpoint", way->words));
  if (!point.person) {
    words += QObject::tr(", for any person");
  }
  if (!point.condition.empty()) {
    words += QObject::tr(", if %1").arg(QString::fromStdString(point.condition));
  }
  return words;
}

void fillBreakpointMenu(QMenu& menu, SimulationRunner& runner, const std::string& path, int person,
                        QWidget& window) {
  const auto offer = [&](QMenu& to, std::optional<int> whose) {
    for (const BreakCondition& way : kBreakConditions) {
      const TreeBreakpoint point{whose, path, way.status, {}};
      QAction* action = to.addAction(
          QObject::tr("It %1").arg(QCoreApplication::translate("Breakpoint", way.words)), &menu,
          [&runner, point] { addBreakpoint(runner, point); });
      const auto& all = runner.breakpoints();
      action->setEnabled(std::find(all.begin(), all.end(), point) == all.end());
    }
    const TreeBreakpoint asked{whose, path, std::nullopt, {}};
    to.addAction(QObject::tr("A condition becomes true…"), &menu,
                 [&runner, asked, &window] { askForCondition(runner, asked, window); });
  };
  offer(*menu.addMenu(QObject::tr("Break when")), person);
  offer(*menu.addMenu(QObject::tr("Break for any person when")), std::nullopt);
  menu.addSeparator();
  for (const TreeBreakpoint& point : runner.breakpoints()) {
    if (point.path == path && point.person.value_or(person) == person) {
      menu.addAction(QObject::tr("Remove breakpoint %1").arg(breakpointText(point)), &menu,
                     [&runner, point] {
                       std::vector<TreeBreakpoint> points = runner.breakpoints();
                       points.erase(std::remove(points.begin(), points.end(), point), points.end());
                       runner.setBreakpoints(std::move(points));
                     });
    }
  }
  QAction* none = menu.addAction(QObject::tr("Remove all breakpoints"), &menu,
                                 [&runner] { runner.setBreakpoints({}); });
  none->setEnabled(!runner.breakpoints().empty());
}

}  // namespace editor
