#include <limits>

#include <QSignalSpy>

#include "app/window/StartPage.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PersonTree.h"
#include "editor/look/AppStyle.h"
#include "editor/look/Fields.h"
#include "editor/panels/ScenarioPanel.h"
#include "editor/panels/behavior/BehaviorPanel.h"
#include "editor/panels/properties/PropertyPanel.h"
#include "editor/panels/runs/RunsPanel.h"
#include "editor/trees/TreeEditor.h"
#include "tests/app/QuietWindow.h"

using base::EntityId;
using base::EntityKind;
using editor::SimulationRunner;

/// The subject of a menu, of a field in a list, of a dialog or of a drag is removed or replaced.
class TargetGoneTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    begin();
    QVERIFY(window_->open(quiet::demoPath()));
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  }
  void cleanup() {
    window_->workspace().runner().reset();
    end();
  }

  /// The new name makes the list of runs be refilled while Qt still uses the row.
  void runName_typedAndLeftByTheMenuBar_isTaken() {
    runner().stepOnce();
    QTRY_VERIFY_WITH_TIMEOUT(runner().newestFrame() != nullptr, 60000);
    window_->docks().show({QStringLiteral("runs")});
    QTreeWidget& list = window_->docks().panel<editor::RunsPanel>().list();
    QTRY_COMPARE(list.topLevelItemCount(), 1);
    const QRect row = list.visualItemRect(list.topLevelItem(0));
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, row.center());
    key(Qt::Key_F2);
    QTRY_VERIFY(list.viewport()->findChild<QLineEdit*>() != nullptr);
    key(Qt::Key_Y);
    key(Qt::Key_W);
    QAction* const file = window_->menuBar()->actions().front();
    QTest::mouseClick(window_->menuBar(), Qt::LeftButton, {},
                      window_->menuBar()->actionGeometry(file).center());
    key(Qt::Key_Escape);
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, QPoint(200, 200));
    QTRY_COMPARE(runner().branches().front().name, QStringLiteral("yw"));
    QTRY_COMPARE(list.topLevelItem(0)->text(0), QStringLiteral("yw"));
    QCOMPARE(list.topLevelItemCount(), 1);
  }

  void canvasMenu_anotherIsSelected_closes() {
    const QPointer<QMenu> menu = canvasMenuOn(people()[0]);
    QVERIFY(menu && menu->isVisible());
    document().setSelection({people()[1]});  // as a breakpoint does
    QVERIFY(!menu || !menu->isVisible());
    QTRY_VERIFY(menu.isNull());
  }

  void canvasMenu_aRunBegins_closes() {
    const QPointer<QMenu> menu = canvasMenuOn(people()[0]);
    QVERIFY(menu && menu->isVisible());
    runner().play();
    QVERIFY(!menu || !menu->isVisible());
    QTRY_VERIFY(menu.isNull());
  }

  /// The open menu gets all keys, so the person is removed by a command.
  void canvasMenu_itsPersonGoes_entriesDoNothing() {
    const EntityId person = people()[0];
    QMenu* const menu = canvasMenuOn(person);
    QVERIFY(menu != nullptr);
    QAction* rename = nullptr;
    for (QAction* action : menu->actions()) {
      rename = action->text() == QStringLiteral("Rename") ? action : rename;
    }
    QVERIFY(rename != nullptr);
    editor::pushRemove(document(), {person});
    rename->trigger();
    QVERIFY(!document().contains(person));
    QTRY_VERIFY(QApplication::activePopupWidget() == nullptr);
    QVERIFY(document().selection().empty());
    window_->actions().rename->trigger();  // nothing is selected
  }

  void listMenu_anotherIsSelected_closes() {
    auto& panel = window_->docks().panel<editor::ScenarioPanel>();
    QTreeView& tree = panel.tree();
    const QModelIndex person = tree.model()->index(0, 0, tree.model()->index(0, 0));
    const QPoint at = tree.visualRect(person).center();
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, at);
    const QPointer<QMenu> menu = menuAt(*tree.viewport(), at);
    QVERIFY(menu && menu->isVisible());
    document().setSelection({people()[1]});
    QTRY_VERIFY(menu.isNull());
  }

  void studioMenu_anotherIsSelected_closes() {
    document().setSelection({people()[0]});
    window_->docks().show({QStringLiteral("tree"), QStringLiteral("behaviour")});
    auto& studio = *window_->findChild<editor::TreeEditor*>();
    QTRY_VERIFY(studio.isVisible() && studio.person() == people()[0]);
    const QPointer<QMenu> menu = menuAt(studio.canvas(), studio.canvas().centreOf(0));
    QVERIFY(menu && menu->isVisible());
    document().setSelection({people()[1]});
    QTRY_VERIFY(menu.isNull());
  }

  /// A run that continues behind the dialog stops at a breakpoint and selects another person.
  void treeDialog_anotherIsSelectedMeanwhile_takesThatOfThePersonAskedFor() {
    document().setSelection({people()[0]});
    const std::string own = editor::treeText(document(), people()[0]);
    QVERIFY(own != editor::treeText(document(), people()[1]));
    window_->docks().show({QStringLiteral("behaviour")});
    auto& panel = window_->docks().panel<editor::BehaviorPanel>();
    const QString file = at("tree.xml");
    quiet::answerDialog<QFileDialog>([this, file](QFileDialog& dialog) {
      document().setSelection({people()[1]});
      auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
      name->setText(file);
      QTest::keyClick(name, Qt::Key_Return);
    });
    auto* save = widgets::withText<QToolButton>(panel, QStringLiteral("Save…"));
    QVERIFY(save != nullptr);
    QTest::mouseClick(save, Qt::LeftButton);
    QCOMPARE(panel.person(), people()[1]);
    const base::Result<std::string> saved = base::readTextFile(file.toStdString());
    QVERIFY(saved);
    QCOMPARE(*saved, own);
  }

  /// Typed XML is committed after a pause; another person may be selected by then.
  void treeText_anotherIsSelectedMeanwhile_isOfThePersonItWasTypedFor() {
    const EntityId first = people()[0];
    const EntityId second = people()[1];
    editor::pushTrees(document(), {{first, kTree}, {second, kTree}}, QStringLiteral("Trees"));
    document().setSelection({first});
    window_->docks().show({QStringLiteral("tree")});
    auto& studio = *window_->findChild<editor::TreeEditor*>();
    QTRY_VERIFY(studio.isVisible() && studio.person() == first);
    studio.sharing().setChecked(false);
    studio.lower().setCurrentWidget(&studio.text());
    QPlainTextEdit& text = studio.text().text();
    text.moveCursor(QTextCursor::Start);
    QTest::keyClicks(&text, QStringLiteral("<!-- typed -->"));
    document().setSelection({second});
    QTest::qWait(700);
    QVERIFY(document().tree(first) && document().tree(first)->find("typed") != std::string::npos);
    QCOMPARE(*document().tree(second), std::string(kTree));
  }

  void drag_itsPersonIsDeletedByKey_isOver() {
    const EntityId person = people()[0];
    const std::size_t before = people().size();
    const base::Vec2 from = document().human(person)->initPose.position;
    pressAt(from);
    moveTo(from + base::Vec2(0.6, 0.4));
    key(Qt::Key_Delete);
    QVERIFY(!document().contains(person));
    moveTo(from + base::Vec2(1.0, 1.0));
    releaseAt(from + base::Vec2(1.0, 1.0));
    QVERIFY(!document().contains(person));
    QCOMPARE(people().size(), before - 1);
    key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(document().human(person)->initPose.position, from);
  }

  void drag_undoneByKey_endsWhereItIs() {
    const EntityId person = people()[0];
    const base::Vec2 from = document().human(person)->initPose.position;
    document().setSelection({person});
    key(Qt::Key_D, Qt::ControlModifier);  // a copy, which is selected
    const EntityId copy = document().selection().front();
    const base::Vec2 at = document().human(copy)->initPose.position;
    pressAt(at);
    moveTo(at + base::Vec2(0.6, 0.4));
    key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!document().contains(copy));
    moveTo(at + base::Vec2(0.8, 0.4));
    key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    moveTo(at + base::Vec2(0.9, 0.4));
    releaseAt(at + base::Vec2(0.9, 0.4));
    QVERIFY(document().contains(copy));
    QCOMPARE(document().human(person)->initPose.position, from);
  }

  /// For every tool: the key of another tool, or the start of a run, in the middle of a drag.
  void drag_ofEachTool_anotherToolOrRun_leavesTheScenario() {
    const std::string before = sim2d::writeScenario(document().scenario());
    for (const Qt::Key other : {Qt::Key_Y, Qt::Key_W, Qt::Key_V, Qt::Key_Space}) {
      for (QAction* tool : window_->workspace().tools().actions().actions()) {
        tool->trigger();
        pressAt({-1.0, -1.0});
        moveTo({0.5, 0.4});
        key(other);
        moveTo({1.0, 0.5});
        releaseAt({1.0, 0.5});
        runner().reset();
        key(Qt::Key_Escape);
      }
    }
    while (document().undoStack().canUndo()) {
      document().undoStack().undo();
    }
    QCOMPARE(sim2d::writeScenario(document().scenario()), before);
  }

  /// Entities of the other file have the same ids.
  void sweepOfTheEraser_anotherFileIsOpened_removesNothing() {
    const QString file = quiet::copyOfDemo(at("demo.yaml"));
    QVERIFY(window_->open(file));
    const std::string before = sim2d::writeScenario(document().scenario());
    key(Qt::Key_E);
    const base::Vec2 from = document().human(people()[0])->initPose.position;
    pressAt(from);
    moveTo(from + base::Vec2(0.6, 0.4));
    QVERIFY(document().open(file).empty());
    moveTo(from + base::Vec2(0.8, 0.4));
    releaseAt(from + base::Vec2(0.8, 0.4));
    QCOMPARE(sim2d::writeScenario(document().scenario()), before);
    QVERIFY(!document().isDirty());
  }

  void field_typedAndSavedByKey_isInTheFile() {
    const QString file = quiet::copyOfDemo(at("demo.yaml"));
    QVERIFY(window_->open(file));
    editor::TextField& name = typeName("Zoe");
    QVERIFY(document().human(people()[0])->name != "Zoe");
    key(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(name.hasFocus());
    const sim2d::ScenarioReading saved = sim2d::readScenario(file.toStdString());
    QCOMPARE(saved.scenario.humans.front().name, std::string("Zoe"));
  }

  /// Ids count from 1 in every file: the name was typed for an entity of the old document.
  void field_typedWhenTheFileIsReadAgain_isNotOfTheNewOne() {
    const QString file = quiet::copyOfDemo(at("demo.yaml"));
    QVERIFY(window_->open(file));
    const std::string before = sim2d::writeScenario(document().scenario());
    typeName("Zoe");
    QVERIFY(document().open(file).empty());
    QCOMPARE(sim2d::writeScenario(document().scenario()), before);
    QVERIFY(!document().isDirty());
    QVERIFY(!document().undoStack().canUndo());
  }

  /// The command replaces the menu entry that it came from.
  void recentFile_chosenByKey_opensIt() {
    rememberingWindow();
    QVERIFY(window_->open(quiet::copyOfDemo(at("demo.yaml"))));
    QMenu* const recent = recentMenu();
    QVERIFY(recent != nullptr);
    for (int k = 0; k < 3; ++k) {
      recent->popup(window_->mapToGlobal(QPoint(40, 40)));
      const QPointer<QAction> entry = recent->actions().front();
      recent->setActiveAction(entry);
      QTest::keyClick(recent, Qt::Key_Return);
      QTRY_VERIFY(entry.isNull());
      QCOMPARE(recent->actions().size(), 1);
      QVERIFY(!window_->isOnStartPage());
    }
  }

  void recentFile_clickedOnTheStartPage_opensIt() {
    rememberingWindow();
    QVERIFY(window_->open(quiet::copyOfDemo(at("demo.yaml"))));
    window_->actions().close->trigger();
    QTRY_VERIFY(window_->isOnStartPage());
    QPointer<app::RecentRow> row;
    QTRY_VERIFY((row = recentRow()) != nullptr);
    QTest::mouseClick(row.data(), Qt::LeftButton);
    QVERIFY(!window_->isOnStartPage());
    QTRY_VERIFY(row.isNull());
  }

 private:
  SimulationRunner& runner() { return window_->workspace().runner(); }
  editor::MapView& view() { return window_->workspace().view(); }
  std::vector<EntityId> people() { return document().entities(EntityKind::Human); }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(window_->windowHandle(), key, modifiers);
    QCoreApplication::processEvents();
  }
  QPoint inWindow(const base::Vec2& world) {
    return view().viewport()->mapTo(window_.get(), view().viewportFrom(world));
  }
  void pressAt(const base::Vec2& world) {
    QTest::mouseMove(window_->windowHandle(), inWindow(world));
    QTest::mousePress(window_->windowHandle(), Qt::LeftButton, {}, inWindow(world));
  }
  void moveTo(const base::Vec2& world) {
    const QPoint at = view().viewportFrom(world);
    QMouseEvent event(QEvent::MouseMove, at, view().viewport()->mapToGlobal(at), Qt::NoButton,
                      Qt::LeftButton, {});
    QCoreApplication::sendEvent(view().viewport(), &event);
    QCoreApplication::processEvents();
  }
  void releaseAt(const base::Vec2& world) {
    QTest::mouseRelease(window_->windowHandle(), Qt::LeftButton, {}, inWindow(world));
    QCoreApplication::processEvents();
  }
  static QMenu* menuAt(QWidget& part, const QPoint& at) {
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, part.mapToGlobal(at));
    QApplication::sendEvent(&part, &event);
    return qobject_cast<QMenu*>(QApplication::activePopupWidget());
  }
  QMenu* canvasMenuOn(EntityId person) {
    return menuAt(*view().viewport(),
                  view().viewportFrom(document().human(person)->initPose.position));
  }
  void rememberingWindow() {
    end();
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_->path());
    app::WindowSetup setup = quiet::setup();
    setup.storesSettings = true;
    window_ = quiet::shownWindow(setup);
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  }
  /// Into the name of the first person, without leaving the field.
  editor::TextField& typeName(const char* text) {
    document().setSelection({people()[0]});
    const auto& panel = window_->docks().panel<editor::PropertyPanel>();
    const QString before = QString::fromStdString(document().human(people()[0])->name);
    editor::TextField* name = nullptr;
    for (auto* each : panel.findChildren<editor::TextField*>()) {
      name = each->isVisible() && each->text() == before ? each : name;
    }
    [&] { QVERIFY(name != nullptr); }();
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, QString::fromUtf8(text));
    return *name;
  }
  app::RecentRow* recentRow() const { return widgets::shown<app::RecentRow>(*window_); }
  QMenu* recentMenu() const {
    return widgets::findIf<QMenu>(*window_, [](const QMenu* menu) {
      return menu->title().contains(QStringLiteral("recen"));
    });
  }
};

QTEST_MAIN(TargetGoneTest)
#include "tst_TargetGone.moc"
