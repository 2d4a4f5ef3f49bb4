#include "editor/panels/BreakpointMenu.h"

#include <algorithm>
#include <utility>

#include <QInputDialog>

#include "bt/human/Breakpoints.h"
#include "editor/look/DeleteWhenClosed.h"

namespace editor {

namespace {

using base::NodeStatus;
using sim2d::TreeBreakpoint;

struct StopWay {
  const char* words;
  std::optional<NodeStatus> status;
};
constexpr StopWay kStopWays[] = {{QT_TRANSLATE_NOOP("editor", "is ticked"), std::nullopt},
                                 {QT_TRANSLATE_NOOP("editor", "runs"), NodeStatus::Running},
                                 {QT_TRANSLATE_NOOP("editor", "succeeds"), NodeStatus::Success},
                                 {QT_TRANSLATE_NOOP("editor", "fails"), NodeStatus::Failure}};

void addBreakpoint(SimulationRunner& runner, const TreeBreakpoint& point) {
  std::vector<TreeBreakpoint> points = runner.breakpoints();
  points.push_back(point);
  runner.setBreakpoints(std::move(points));
}

/// Asked again until it can be read, or is given up.
void askForCondition(SimulationRunner& runner, const TreeBreakpoint& point, QWidget& window,
                     const QString& problem = {}) {
  auto* dialog = new QInputDialog(&window);
  deleteWhenClosed(*dialog);
  dialog->setWindowTitle(QObject::tr("Stop on a condition"));
  dialog->setLabelText(problem.isEmpty()
                           ? QObject::tr("Stop when it is ticked and this holds on the blackboard, "
                                         "for example  id == 2:")
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

QString breakpointWords(const TreeBreakpoint& point) {
  const auto* const way =
      std::find_if(std::begin(kStopWays), std::end(kStopWays),
                   [&point](const StopWay& each) { return each.status == point.status; });
  QString words = QObject::tr("when it %1")
                      .arg(QObject::tr(way == std::end(kStopWays) ? "is skipped" : way->words));
  if (!point.person) {
    words += QObject::tr(", of anybody");
  }
  if (!point.condition.empty()) {
    words += QObject::tr(", if %1").arg(QString::fromStdString(point.condition));
  }
  return words;
}

void fillBreakpointMenu(QMenu& menu, SimulationRunner& runner, const std::string& path, int person,
                        QWidget& window) {
  const auto offer = [&](QMenu& to, std::optional<int> whose) {
    for (const StopWay& way : kStopWays) {
      const TreeBreakpoint point{whose, path, way.status, {}};
      QAction* action = to.addAction(QObject::tr("It %1").arg(QObject::tr(way.words)), &menu,
                                     [&runner, point] { addBreakpoint(runner, point); });
      const auto& all = runner.breakpoints();
      action->setEnabled(std::find(all.begin(), all.end(), point) == all.end());
    }
    const TreeBreakpoint asked{whose, path, std::nullopt, {}};
    to.addAction(QObject::tr("A condition holds…"), &menu,
                 [&runner, asked, &window] { askForCondition(runner, asked, window); });
  };
  offer(*menu.addMenu(QObject::tr("Stop the run when")), person);
  offer(*menu.addMenu(QObject::tr("Stop the run for anybody when")), std::nullopt);
  menu.addSeparator();
  for (const TreeBreakpoint& point : runner.breakpoints()) {
    if (point.path == path && point.person.value_or(person) == person) {
      menu.addAction(QObject::tr("Do not stop %1").arg(breakpointWords(point)), &menu,
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
