#include <QTemporaryDir>
#include <QtTest>

#include "editor/panels/MetricsChoicePanel.h"

using editor::MetricsChoicePanel;

class MetricsChoicePanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void all_atFirst_nothingIsWritten() {
    editor::ScenarioDocument document;
    editor::SimulationRunner runner;
    editor::MetricsFeed feed(document, runner);
    MetricsChoicePanel panel(document, feed, editor::Theme::light());
    QVERIFY(!panel.selection().keys.has_value());
    QVERIFY(base::hasErrors(panel.save()));  // there is no file yet to lie beside
  }

  void unchecked_isLeftOut() {
    editor::ScenarioDocument document;
    editor::SimulationRunner runner;
    editor::MetricsFeed feed(document, runner);
    MetricsChoicePanel panel(document, feed, editor::Theme::light());
    panel.setChosen(QStringLiteral("path_length"), false);
    const metrics::Selection selection = feed.selection();
    QVERIFY(selection.keys.has_value());
    QCOMPARE(selection.keys->off.count("path_length"), std::size_t(1));
    panel.chooseAll(true);
    QVERIFY(!feed.selection().keys.has_value());
  }

  void search_hidesTheOthers() {
    editor::ScenarioDocument document;
    editor::SimulationRunner runner;
    editor::MetricsFeed feed(document, runner);
    MetricsChoicePanel panel(document, feed, editor::Theme::light());
    panel.search().setText(QStringLiteral("path_length"));
    int shown = 0;
    for (int i = 0; i < panel.tree().topLevelItemCount(); ++i) {
      const QTreeWidgetItem* group = panel.tree().topLevelItem(i);
      for (int row = 0; row < group->childCount(); ++row) {
        shown += group->child(row)->isHidden() ? 0 : 1;
      }
    }
    QVERIFY(shown >= 1 && shown < 5);
  }

  void saved_choice_isReadAgain() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("room.yaml"));
    editor::ScenarioDocument document;
    document.clear();
    QVERIFY(!base::hasErrors(document.save(path)));
    editor::SimulationRunner runner;
    editor::MetricsFeed feed(document, runner);
    MetricsChoicePanel panel(document, feed, editor::Theme::light());
    panel.chooseAll(false);
    panel.setChosen(QStringLiteral("path_length"), true);
    QVERIFY(!base::hasErrors(panel.save()));
    QCOMPARE(*document.scenario().desktop.metrics.file, std::string("room_metrics.yaml"));
    feed.setSelection(std::nullopt);
    const metrics::Selection selection = feed.selection();
    int chosen = 0;
    for (const metrics::MetricEntry& entry : metrics::standardRegistry().entries()) {
      chosen += entry.info.partOf.empty() && selection.selects(entry.info) ? 1 : 0;
    }
    QCOMPARE(chosen, 1);
    document.undoStack().undo();
    QVERIFY(!document.scenario().desktop.metrics.file.has_value());
  }
};

QTEST_MAIN(MetricsChoicePanelTest)
#include "tst_MetricsChoicePanel.moc"
