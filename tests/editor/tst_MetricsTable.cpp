#include <QtTest>

#include "editor/look/TableExport.h"
#include "editor/panels/MetricsDock.h"

using editor::MetricsTable;

namespace {

void setChosen(const MetricsTable& panel, const QString& key, bool chosen) {
  for (QTreeWidgetItemIterator each(&panel.tree()); *each != nullptr; ++each) {
    if ((*each)->data(0, editor::kSavedKeyRole) == key) {
      (*each)->setCheckState(0, chosen ? Qt::Checked : Qt::Unchecked);
    }
  }
}

}  // namespace

class MetricsTableTest : public QObject {
  Q_OBJECT

 private:
  struct Subject {
    editor::ScenarioDocument document;
    editor::SimulationRunner runner;
    editor::MetricsFeed feed{document, runner};
    editor::PersonMetrics people{feed, runner};
    MetricsTable panel{document, feed, people, editor::Theme::light()};
  };
  std::unique_ptr<Subject> subject_;

 private Q_SLOTS:
  void init() { subject_ = std::make_unique<Subject>(); }
  void cleanup() { subject_.reset(); }

  void all_atFirst_nothingIsWritten() {
    MetricsTable& panel = subject_->panel;
    QVERIFY(!panel.selection().keys.has_value());
    QVERIFY(base::hasErrors(panel.save()));  // there is no file yet to lie beside
  }

  void unchecked_isLeftOut() {
    MetricsTable& panel = subject_->panel;
    setChosen(panel, QStringLiteral("path_length"), false);
    const metrics::Selection selection = subject_->feed.selection();
    QVERIFY(selection.keys.has_value());
    QCOMPARE(selection.keys->off.count("path_length"), std::size_t(1));
    panel.chooseAll(true);
    QVERIFY(!subject_->feed.selection().keys.has_value());
  }

  void names_inANarrowDock_areNotCut() {
    MetricsTable& panel = subject_->panel;
    panel.setFont(QFont(QStringLiteral("DejaVu Sans"), 9));
    panel.resize(260, 400);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    QTreeWidget& tree = panel.tree();
    tree.expandAll();
    int tall = 0;
    for (int i = 0; i < tree.topLevelItemCount(); ++i) {
      for (int row = 0; row < tree.topLevelItem(i)->childCount(); ++row) {
        const QTreeWidgetItem* item = tree.topLevelItem(i)->child(row);
        QStyleOptionViewItem option;
        option.initFrom(&tree);
        option.widget = &tree;
        option.features =
            QStyleOptionViewItem::HasDisplay | QStyleOptionViewItem::HasCheckIndicator;
        option.text = QString(200, QLatin1Char('m'));  // takes all the room
        option.rect = tree.visualItemRect(item);
        option.rect.setWidth(tree.columnWidth(0) - 2 * tree.indentation());
        const QRect room =
            tree.style()->subElementRect(QStyle::SE_ItemViewItemText, &option, &tree);
        const QRect needed = option.fontMetrics.boundingRect(QRect(0, 0, room.width() - 6, 1000),
                                                             Qt::TextWordWrap, item->text(0));
        const QString sizes = QStringLiteral("%1: %2 of %3 px at a width of %4")
                                  .arg(item->text(0))
                                  .arg(needed.height())
                                  .arg(option.rect.height())
                                  .arg(room.width());
        QVERIFY2(needed.height() <= option.rect.height(), qPrintable(sizes));
        tall += option.rect.height() > 30 ? 1 : 0;
      }
    }
    QVERIFY(tall > 0);  // some are that long
  }

  void search_hidesTheOthers() {
    MetricsTable& panel = subject_->panel;
    panel.search().setText(QStringLiteral("path_length"));
    int shown = 0;
    for (int i = 0; i < panel.tree().topLevelItemCount(); ++i) {
      const QTreeWidgetItem* group = panel.tree().topLevelItem(i);
      for (int row = 0; row < group->childCount(); ++row) {
        shown += group->child(row)->isHidden() ? 0 : 1;
      }
    }
    QVERIFY(shown >= 1 && shown < 5);
    const auto* nothing = panel.findChild<editor::NoMatchesPlaceholder*>();
    QVERIFY(!nothing->isVisibleTo(&panel));
    panel.search().setText(QStringLiteral("zzz"));
    QVERIFY(nothing->isVisibleTo(&panel) && !panel.tree().isVisibleTo(&panel));
    nothing->findChild<QToolButton*>()->click();
    QVERIFY(!nothing->isVisibleTo(&panel) && panel.tree().isVisibleTo(&panel));
  }

  void saved_choice_isReadAgain() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("room.yaml"));
    editor::ScenarioDocument document;
    document.clear();
    QVERIFY(!base::hasErrors(document.save(path)));
    editor::SimulationRunner runner;
    editor::MetricsFeed feed(document, runner);
    editor::PersonMetrics people(feed, runner);
    MetricsTable panel(document, feed, people, editor::Theme::light());
    panel.chooseAll(false);
    setChosen(panel, QStringLiteral("path_length"), true);
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

  void groupsAndKeys_areThoseOfTheRegistry() {
    MetricsTable& panel = subject_->panel;
    QCOMPARE(panel.tree().topLevelItemCount(), metrics::kCategories);
    int rows = 0;
    for (int i = 0; i < panel.tree().topLevelItemCount(); ++i) {
      rows += panel.tree().topLevelItem(i)->childCount();
    }
    int expected = 0;
    int theirs = 0;
    for (const metrics::MetricEntry& entry : metrics::standardRegistry().entries()) {
      expected += entry.info.partOf.empty() ? 1 : 0;
      theirs += entry.info.hunav > 0 ? 1 : 0;
    }
    QCOMPARE(rows, expected);
    QCOMPARE(theirs, 34);
    panel.chooseAll(false);
    QCOMPARE(panel.selection().keys->off.size(), std::size_t(34));
    QVERIFY(panel.selection().keys->on.empty());
  }

  /// The metrics.yaml of HuNavSim 1 (28 keys) and of 2.0 (33): every other key is off.
  void fileOfHuNavSim_isReadChangedAndWritten_data() {
    QTest::addColumn<int>("count");
    QTest::newRow("28 keys") << 28;
    QTest::newRow("33 keys") << 33;
  }
  void fileOfHuNavSim_isReadChangedAndWritten() {
    QFETCH(int, count);
    std::vector<std::string> keys;
    for (const metrics::MetricEntry& entry : metrics::standardRegistry().entries()) {
      const std::string& key = entry.info.key;
      const bool known = entry.info.hunav > 0 && key != "maximum_distance_to_people";
      if (known && static_cast<int>(keys.size()) < count) {
        keys.push_back(key);
      }
    }
    QCOMPARE(static_cast<int>(keys.size()), count);
    QTemporaryDir folder;
    QByteArray text =
        "hunav_evaluator_node:\n  ros__parameters:\n    frequency: 2.5\n"
        "    result_file: \"metrics\"\n    metrics:\n";
    for (std::size_t i = 0; i < keys.size(); ++i) {
      text += "      " + QByteArray::fromStdString(keys[i]) + (i % 2 == 0 ? ": true" : ": false") +
              "\n";
    }
    QFile file(folder.filePath(QStringLiteral("metrics.yaml")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
    file.close();
    editor::ScenarioDocument document;
    sim2d::Scenario scenario;
    scenario.desktop.metrics.file = "metrics.yaml";
    document.load(scenario);
    QVERIFY(!base::hasErrors(document.save(folder.filePath(QStringLiteral("room.yaml")))));
    editor::SimulationRunner runner;
    editor::MetricsFeed feed(document, runner);
    editor::PersonMetrics people(feed, runner);
    MetricsTable panel(document, feed, people, editor::Theme::light());
    QCOMPARE(static_cast<int>(panel.selection().keys->off.size()), count / 2);
    setChosen(panel, QString::fromStdString(keys[1]), true);
    QVERIFY(!base::hasErrors(panel.save()));
    const base::Result<metrics::MetricsFile> again =
        metrics::readMetricsFile(folder.filePath(QStringLiteral("metrics.yaml")).toStdString());
    QVERIFY(again);
    QCOMPARE(static_cast<int>(again->selection.keys->off.size()), count / 2 - 1);
    QCOMPARE(again->selection.keys->off.count(keys[1]), std::size_t(0));
    QCOMPARE(again->selection.keys->off.count(keys[3]), std::size_t(1));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().contains("frequency: 2.5"));
  }
};

QTEST_MAIN(MetricsTableTest)
#include "tst_MetricsTable.moc"
