#include <QMenu>
#include <QtTest>

#include "QuietWindow.h"

/// The menu of the right button on the map.
class CanvasMenuTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    window_ = quiet::shownWindow();
    QVERIFY(window_->open(quiet::demoPath()));
  }
  void cleanup() { window_.reset(); }

  void menu_onAPerson_selectsAndOffersTheirCommands() {
    const base::EntityId person = document().entities(base::EntityKind::Human).front();
    QMenu* menu = menuAt(document().human(person)->initPose.position);
    QVERIFY(menu != nullptr);
    QCOMPARE(document().selection(), std::vector<base::EntityId>{person});
    const QStringList words = wordsOf(*menu);
    for (const char* word : {"Rename", "Switch off", "Assign goals…", "Arrange", "Delete"}) {
      QVERIFY2(words.contains(QString::fromUtf8(word)), word);
    }
    for (QAction* action : menu->actions()) {
      if (action->text() == QStringLiteral("Switch off")) {
        action->trigger();
      }
    }
    QVERIFY(!document().human(person)->listed);
    menu->close();
  }

  void menu_onOneOfSeveral_keepsTheSelection() {
    const std::vector<base::EntityId> people = document().entities(base::EntityKind::Human);
    document().setSelection(people);
    QMenu* menu = menuAt(document().human(people[2])->initPose.position);
    QVERIFY(menu != nullptr);
    QCOMPARE(document().selection(), people);
    menu->close();
  }

  void menu_onTheGround_keepsTheSelectionAndPastes() {
    QMenu* menu = menuAt(base::Vec2(-2.0, -2.0));
    QVERIFY(menu != nullptr);
    QVERIFY(wordsOf(*menu).contains(QStringLiteral("Select all")));
    QVERIFY(!wordsOf(*menu).contains(QStringLiteral("Delete")));
    menu->close();
  }

  /// In a run it is about the people and robots of the run.
  void menu_ofARun_offersHands() {
    editor::SimulationRunner& runner = window_->workspace().runner();
    runner.stepOnce();
    QTRY_VERIFY_WITH_TIMEOUT(runner.newestFrame() != nullptr && runner.newestFrame()->step == 1,
                             60000);
    const sim2d::HumanColumns& people = runner.newestFrame()->humans;
    QMenu* menu = menuAt(base::Vec2(people.x[0], people.y[0]));
    QVERIFY(menu != nullptr);
    QVERIFY(wordsOf(*menu).join(QLatin1Char(' ')).contains(QStringLiteral("Push ")));
    QVERIFY(wordsOf(*menu).join(QLatin1Char(' ')).contains(QStringLiteral("Stop ")));
    menu->close();
    const sim2d::RobotColumns& robots = runner.newestFrame()->robots;
    menu = menuAt(base::Vec2(robots.x[0], robots.y[0]));
    QVERIFY(menu != nullptr);
    const QStringList offers = {QStringLiteral("Drive manually"), QString(),
                                QStringLiteral("Branch here…")};
    QCOMPARE(wordsOf(*menu), offers);
    menu->actions().front()->trigger();
    menu->close();
    QCOMPARE(document().selection(), document().entities(base::EntityKind::Robot));
    const QAction& drive = *window_->workspace().drive().toggle();
    QVERIFY(drive.isChecked());
    menu = menuAt(base::Vec2(robots.x[0], robots.y[0]));
    QCOMPARE(menu->actions().front(), &drive);  // lets go again
    menu->close();
    runner.reset();
  }

  void menu_withAnotherTool_doesNotOpen() {
    editor::ToolManager& tools = window_->workspace().tools();
    tools.entries()[3].action->trigger();
    QVERIFY(menuAt(base::Vec2(-2.0, -2.0)) == nullptr);
  }

 private:
  editor::ScenarioDocument& document() { return window_->workspace().document(); }
  QMenu* menuAt(const base::Vec2& world) {
    editor::MapView& view = window_->workspace().view();
    const QPoint at = view.viewportFrom(world);
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, view.viewport()->mapToGlobal(at));
    QCoreApplication::sendEvent(view.viewport(), &event);
    const QList<QMenu*> menus = view.findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly);
    return menus.isEmpty() ? nullptr : menus.back();
  }
  static QStringList wordsOf(const QMenu& menu) {
    QStringList words;
    for (const QAction* action : menu.actions()) {
      words << action->text().remove(QLatin1Char('&'));
    }
    return words;
  }

  std::unique_ptr<app::MainWindow> window_;
};

QTEST_MAIN(CanvasMenuTest)
#include "tst_CanvasMenu.moc"
