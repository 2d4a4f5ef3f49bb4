#include "app/window/study/OutputPage.h"
#include "app/window/study/StudyTable.h"
#include "editor/look/Form.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using report::CoverOutput;

/// Trees, nodes that no run has reached, and the runs that reached nodes first.
class CoverPage : public OutputPage {
  Q_DECLARE_TR_FUNCTIONS(app::CoverPage)
 public:
  explicit CoverPage(const CoverOutput& output) : output_(output) {
    addPage(tr("Trees"), makeTrees());
    addPage(tr("Never reached"), makeNeverReached());
    addPage(tr("Runs"), makeRuns());
  }

 private:
  QWidget* makeTrees() {
    QTableWidget* table = studyList(tr("Trees"),
                                    {tr("Tree"), tr("Used by"), tr("Scenarios"), tr("Runs"),
                                     tr("Reached nodes"), tr("Never reached"), tr("Unreachable")},
                                    {1, 2});
    table->setRowCount(static_cast<int>(output_.trees.size()));
    int row = 0;
    for (const CoverOutput::Tree& tree : output_.trees) {
      table->setItem(row, 0, studyCell(QString::number(tree.number), false));
      const QString owners = QString::fromStdString(tree.owners);
      table->setItem(row, 1, studyCell(owners, true));
      table->item(row, 1)->setToolTip(owners);
      const QString scenarios = QString::fromStdString(base::join(tree.scenarios, ", "));
      table->setItem(row, 2, studyCell(scenarios, true));
      table->item(row, 2)->setToolTip(scenarios);
      table->setItem(row, 3, studyCell(QString::number(tree.runs), false));
      table->setItem(row, 4, reachedCell(tree));
      table->setItem(row, 5, studyCell(QString::number(tree.neverReached.size()), false));
      table->setItem(row++, 6, studyCell(QString::number(tree.unreachable.size()), false));
    }
    widenColumns(*table);
    return pageWithNote(table, tr("Nodes of the behaviour trees of people and of Nav2 that at "
                                  "least one run has executed. Unreachable: the structure of the "
                                  "tree excludes them."));
  }

  static QTableWidgetItem* reachedCell(const CoverOutput::Tree& tree) {
    QTableWidgetItem* cell = studyCell(tr("%1 of %2").arg(tree.reached).arg(tree.nodes), false);
    const auto reached = static_cast<double>(tree.reached);
    cell->setData(kBarRole, QVariantList{reached, statistics::kUndefined, statistics::kUndefined,
                                         static_cast<double>(tree.nodes), 0.0});
    return cell;
  }

  QWidget* makeNeverReached() {
    QTableWidget* table =
        studyList(tr("Never reached"), {tr("Tree"), tr("Used by"), tr("Node")}, {1, 2});
    for (const CoverOutput::Tree& tree : output_.trees) {
      for (const std::string& node : tree.neverReached) {
        const int row = table->rowCount();
        table->insertRow(row);
        table->setItem(row, 0, studyCell(QString::number(tree.number), false));
        table->setItem(row, 1, studyCell(QString::fromStdString(tree.owners), true));
        table->setItem(row, 2, studyCell(QString::fromStdString(node), true));
        table->item(row, 2)->setToolTip(QString::fromStdString(node));
      }
    }
    if (table->rowCount() == 0) {
      delete table;
      return editor::emptyState(tr("All nodes that can be reached were reached."), this);
    }
    widenColumns(*table);
    table->horizontalHeader()->setStretchLastSection(true);
    return table;
  }

  QWidget* makeRuns() {
    if (output_.coveringRuns.empty()) {
      return editor::emptyState(tr("No run has executed a node of a behaviour tree."), this);
    }
    QTableWidget* table = studyList(
        tr("Runs"), {tr("Run"), tr("Scenario"), tr("Seed"), tr("Ended"), tr("New nodes")}, {1, 3});
    table->setRowCount(static_cast<int>(output_.coveringRuns.size()));
    int row = 0;
    for (const CoverOutput::Run& run : output_.coveringRuns) {
      table->setItem(row, 0, studyCell(QString::number(run.number), false));
      table->setItem(row, 1, studyCell(QString::fromStdString(run.scenario), true));
      table->setItem(row, 2, studyCell(QString::number(run.seed), false));
      table->setItem(row, 3, studyCell(QString::fromStdString(run.reason), true));
      table->setItem(row, 4, studyCell(QString::number(run.nodes.size()), false));
      table->item(row++, 4)->setToolTip(QString::fromStdString(base::join(run.nodes, "\n")));
    }
    widenColumns(*table);
    setPlayable(*table, tr("Double-click a run to play it"), [this](int each) {
      const CoverOutput::Run& run = output_.coveringRuns[static_cast<std::size_t>(each)];
      Q_EMIT playRequested({run.play, tr("run %1").arg(run.number)});
    });
    return pageWithNote(table, tr("Runs that executed nodes which no earlier run had executed. "
                                  "Double-click or Enter plays a run."));
  }

  const CoverOutput output_;
};

}  // namespace

OutputPage* makeCoverPage(const report::CoverOutput& output, const OutputPlace& /*place*/) {
  return new CoverPage(output);
}

QString coverHeadline(const report::CoverOutput& output) {
  QStringList parts = {
      OutputPage::tr("%1 of %2 nodes of behaviour trees were reached in %3")
          .arg(output.reached)
          .arg(output.nodes)
          .arg(editor::counted(output.runs, OutputPage::tr("run"), OutputPage::tr("runs")))};
  if (output.unreachable > 0) {
    parts.append(OutputPage::tr("Nodes that cannot be reached: %1").arg(output.unreachable));
  }
  if (output.notSimulated > 0) {
    parts.append(OutputPage::tr("Runs that could not start: %1").arg(output.notSimulated));
  }
  return parts.join(QStringLiteral(". "));
}

}  // namespace app
