#include <limits>

#include "editor/panels/behavior/BehaviorPanel.h"
#include "editor/panels/behavior/TreeOutline.h"
#include "tests/app/QuietWindow.h"

using State = editor::SimulationRunner::State;

/// Runs that stop at nodes of trees, in the window.
class BreakpointsTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<app::MainWindow> window_;

  editor::SimulationRunner& runner() { return window_->workspace().runner(); }
  editor::ScenarioDocument& document() { return window_->workspace().document(); }
  editor::BehaviorPanel& panel() { return window_->docks().panel<editor::BehaviorPanel>(); }
  const sim2d::Human& person(int place) const {
    return window_->workspace().document().scenario().humans[static_cast<std::size_t>(place)];
  }
  void select(int place) {
    document().setSelection({person(place).key});
    window_->docks().dock(QStringLiteral("behaviour"))->raise();
    QTRY_VERIFY(panel().isVisible());
  }
  /// The entry of the menu of a node, and of its menus.
  QAction* entry(int node, const QString& words) {
    QTreeWidgetItemIterator row(&panel().outline());
    for (int k = 0; k < node; ++k) {
      ++row;
    }
    const QPoint at = panel().outline().visualItemRect(*row).center();
    Q_EMIT panel().outline().customContextMenuRequested(at);
    for (QMenu* menu : panel().findChildren<QMenu*>()) {
      for (QAction* action : menu->actions()) {
        if (action->text() == words) {
          return action;
        }
      }
    }
    return nullptr;
  }

 private Q_SLOTS:
  void init() {
    window_ = quiet::shownWindow();
    QVERIFY(window_->open(quiet::demoPath()));
    runner().setSpeed(std::numeric_limits<double>::infinity());
  }
  void cleanup() { quiet::leave(window_); }

  void ofANode_stopsTheRunAndShowsThePerson() {
    select(2);
    QVERIFY(panel().outline().topLevelItem(0)->icon(0).isNull());
    QAction* stop = entry(0, QStringLiteral("It starts to be ticked"));
    QVERIFY(stop != nullptr);
    stop->trigger();
    QCOMPARE(runner().breakpoints().size(), std::size_t{1});
    QCOMPARE(runner().breakpoints().front().person, std::optional<int>(person(2).id));
    QVERIFY(!panel().outline().topLevelItem(0)->icon(0).isNull());  // the mark
    document().setSelection({person(0).key});
    QVERIFY(panel().outline().topLevelItem(0)->icon(0).isNull());  // it is not of this person
    runner().play();
    QTRY_VERIFY(runner().currentBreak().has_value());
    QCOMPARE(runner().state(), State::Paused);
    QCOMPARE(runner().newestFrame()->step, std::int64_t{1});
    QCOMPARE(document().selection(), std::vector<editor::EntityId>{person(2).key});
    QTRY_VERIFY(panel().entries().isVisible());
    QCOMPARE(panel().entries().item(0, 0)->text(), QStringLiteral("id"));
    QCOMPARE(panel().entries().item(0, 1)->text(), QString::number(person(2).id));
    const QString words = QStringLiteral("Stopped at");
    QVERIFY(widgets::findIf<QLabel>(*window_->statusBar(), [&words](const QLabel* label) {
              return label->toolTip().startsWith(words) || label->text().contains(words);
            }) != nullptr);
    QStatusTipEvent hover(QStringLiteral("Run one step"));
    QCoreApplication::sendEvent(window_.get(), &hover);
    QVERIFY(widgets::findIf<QLabel>(*window_->statusBar(), [&words](const QLabel* label) {
              return label->text().startsWith(words) &&
                     label->text().endsWith(QLatin1String("Run one step"));
            }) != nullptr);
    runner().stepOnce();
    QTRY_COMPARE(runner().newestFrame()->step, std::int64_t{2});
    QVERIFY(!runner().currentBreak());
    runner().play();  // it goes on being ticked: no reason to stop again
    QTRY_VERIFY(runner().newestFrame()->step > 100);
    QVERIFY(!runner().currentBreak());
  }

  void set_whileItWaits_countsForTheNextStep() {
    select(0);
    runner().stepOnce();
    QTRY_VERIFY(runner().newestFrame() != nullptr && runner().newestFrame()->step == 1);
    entry(0, QStringLiteral("It starts to be ticked"))->trigger();
    runner().play();
    QTRY_VERIFY(runner().currentBreak().has_value());
    QCOMPARE(runner().newestFrame()->step, std::int64_t{2});
    runner().reset();
    QVERIFY(!runner().currentBreak());
    QVERIFY(!panel().entries().isVisible());
    const sim2d::TreeBreakpoint point = runner().breakpoints().front();
    QAction* drop = entry(0, QStringLiteral("Remove breakpoint ") + editor::breakpointText(point));
    QVERIFY(drop != nullptr);
    drop->trigger();
    QVERIFY(runner().breakpoints().empty());
  }

  void condition_isAskedForUntilItCanBeRead() {
    select(0);
    entry(0, QStringLiteral("A condition becomes true…"))->trigger();
    auto* dialog = window_->findChild<QInputDialog*>();
    QVERIFY(dialog != nullptr);
    dialog->setTextValue(QStringLiteral("id := 7"));
    dialog->accept();
    QVERIFY(runner().breakpoints().empty());
    const auto open = [this] { return widgets::shown<QInputDialog>(*window_); };
    QTRY_VERIFY(open() != nullptr);
    QVERIFY(open()->labelText().contains(QStringLiteral("id := 7")));
    open()->setTextValue(QStringLiteral("dt > 1"));
    open()->accept();
    QTRY_COMPARE(runner().breakpoints().size(), std::size_t{1});
    QCOMPARE(runner().breakpoints().front().condition, std::string("dt > 1"));
    runner().play();
    QTRY_VERIFY(runner().newestFrame() != nullptr && runner().newestFrame()->step > 50);
    QVERIFY(!runner().currentBreak());  // steps are shorter
  }
};

QTEST_MAIN(BreakpointsTest)
#include "tst_Breakpoints.moc"
