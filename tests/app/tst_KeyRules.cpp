#include "app/window/MainWindow.h"
#include "editor/document/PersonTree.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/MetricsDock.h"
#include "editor/panels/ScenarioPanel.h"
#include "editor/panels/behavior/BehaviorPanel.h"
#include "editor/panels/properties/PageWidgets.h"
#include "editor/panels/properties/PropertyPanel.h"
#include "editor/tools/ToolManager.h"
#include "tests/app/QuietWindow.h"

using base::EntityKind;
using editor::SimulationRunner;

/// The rule for keys of app/window/KeyRules.h, from every kind of focus.
class KeyRulesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    window_ = quiet::shownWindow();
    QVERIFY(window_->open(quiet::demoPath()));
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    person_ = document().entities(EntityKind::Human).front();
    document().setSelection({person_});
  }
  void cleanup() { quiet::leave(window_); }

  void space_fromEveryList_runsAndPauses_data() {
    everyFocus();
    QTest::newRow("number") << "number" << false;
  }
  void space_fromEveryList_runsAndPauses() {
    QFETCH(QString, where);
    focus(where);
    key(Qt::Key_Space);
    QCOMPARE(window_->workspace().runner().state(), SimulationRunner::State::Running);
    key(Qt::Key_Space);
    QCOMPARE(window_->workspace().runner().state(), SimulationRunner::State::Paused);
    window_->workspace().runner().reset();
  }

  void tools_fromEveryList_haveTheirLetters_data() { everyFocus(); }
  void tools_fromEveryList_haveTheirLetters() {
    QFETCH(QString, where);
    focus(where);
    key(Qt::Key_A);
    const auto& tools = window_->workspace().tools();
    const auto area = std::find_if(
        tools.entries().begin(), tools.entries().end(),
        [](const auto& entry) { return entry.info.icon == QLatin1String("tool-area"); });
    QVERIFY(tools.current() == area->tool);
    const QString before = area->tool->statusText();
    const QVariant kind = areaKind();
    key(Qt::Key_3);
    QVERIFY(areaKind() != kind);
    QCOMPARE(areaKind().toInt(), 2);
  }

  void delete_inOtherLists_keepsThePerson_data() { everyFocus(); }
  void delete_inOtherLists_keepsThePerson() {
    QFETCH(QString, where);
    QFETCH(bool, isSelection);
    focus(where);
    key(Qt::Key_Delete);
    QCOMPARE(document().contains(person_), !isSelection);
  }

  void arrows_moveThePersonFromTheMapOnly_data() { everyFocus(); }
  void arrows_moveThePersonFromTheMapOnly() {
    QFETCH(QString, where);
    for (const Qt::Key arrow : {Qt::Key_Up, Qt::Key_Down, Qt::Key_Left, Qt::Key_Right}) {
      document().setSelection({person_});
      focus(where);
      for (int k = 0; k < 3; ++k) {  // to the end of short lists, and on
        key(arrow);
      }
      QCOMPARE(document().undoStack().canUndo(), where == QLatin1String("canvas"));
      document().undoStack().undo();
    }
  }

  void space_onARowWithABox_ticksIt() {
    QTreeWidget& list = metrics();
    focus(QStringLiteral("metrics"));
    QTreeWidgetItem* row = list.topLevelItem(0)->child(0);
    list.setCurrentItem(row);
    const Qt::CheckState before = row->checkState(0);
    key(Qt::Key_Space);
    QVERIFY(row->checkState(0) != before);
    QCOMPARE(window_->workspace().runner().state(), SimulationRunner::State::Editing);
  }

  void escape_inANumber_leavesItAsItWas() {
    document().setSelection({person_});
    QDoubleSpinBox* number = someNumber();
    const double before = number->value();
    number->setFocus();
    number->selectAll();
    QTest::keyClicks(number, QStringLiteral("7"));
    key(Qt::Key_Escape);
    QVERIFY(window_->workspace().view().hasFocus());
    QCOMPARE(number->value(), before);
    QVERIFY(!document().undoStack().canUndo());
  }

  void startPage_hasNothingToRun() {
    const editor::PlaybackActions& playback = window_->workspace().playback();
    QVERIFY(playback.playPause->isEnabled() && playback.step->isEnabled());
    document().undoStack().setClean();
    window_->actions().close->trigger();
    QVERIFY(window_->isOnStartPage());
    QVERIFY(!playback.playPause->isEnabled() && !playback.step->isEnabled());
  }

  void delete_inAPanelThatFloats_keepsThePerson() {
    QDockWidget* dock = window_->docks().dock(QStringLiteral("issues"));
    dock->setFloating(true);
    auto* list = window_->docks().panel<editor::IssuesPanel>().findChild<QAbstractItemView*>();
    list->setFocus();
    QKeyEvent remove(QEvent::ShortcutOverride, Qt::Key_Delete, Qt::NoModifier);
    remove.ignore();
    QCoreApplication::sendEvent(list, &remove);
    QVERIFY(remove.isAccepted());  // so the command of the window does not have it
  }

  void delete_ofABlock_removesIt() {
    bt::Block engage;
    engage.id = "EngageRobot";
    editor::pushAddBlock(document(), {person_}, engage);
    editor::TreeOutline& outline = window_->docks().panel<editor::BehaviorPanel>().outline();
    const int block = firstBlock(outline);
    QVERIFY(block >= 0);
    focus(QStringLiteral("tree"));
    outline.selectNode(block);
    const std::size_t before = outline.nodes().size();
    key(Qt::Key_Delete);
    QVERIFY(outline.nodes().size() < before);
    QVERIFY(document().contains(person_));
  }

  void delete_onAGoalOfTheRoute_takesItOut() {
    auto* route = window_->docks()
                      .panel<editor::PropertyPanel>()
                      .currentPage()
                      ->findChild<editor::RouteEditor*>();
    QVERIFY(route != nullptr);
    const std::vector<int> goals = route->goals();
    QVERIFY(!goals.empty());
    auto* chip = widgets::shown<QToolButton>(*route);
    chip->setFocus();
    QVERIFY(chip->hasFocus());
    key(Qt::Key_Delete);
    QVERIFY(document().contains(person_));
    QCOMPARE(route->goals(), std::vector<int>(goals.begin() + 1, goals.end()));
    QVERIFY(route->isAncestorOf(QApplication::focusWidget()));
  }

  void undo_afterEnterInAField_undoesTheChange() {
    auto* field = someNumber();
    QVERIFY(field != nullptr);
    const double before = field->value();
    field->setFocus();
    field->selectAll();
    key(Qt::Key_1);
    key(Qt::Key_Return);
    QVERIFY(document().undoStack().canUndo());
    QVERIFY(QApplication::focusWidget() == &window_->workspace().view());
    key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!document().undoStack().canUndo());
    field = someNumber();
    QCOMPARE(field->value(), before);
    field->setFocus();  // back in the field, where nothing has been typed since
    key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(document().undoStack().canUndo());
    key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!document().undoStack().canUndo());
  }

  void undo_whileTyping_isOfTheText() {
    document().undoStack().push(new QUndoCommand(QStringLiteral("something")));
    auto* field = someNumber();
    field->setFocus();
    field->selectAll();
    key(Qt::Key_7);
    key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document().undoStack().canUndo());
    document().undoStack().undo();
  }

  void letters_inAText_areTyped() {
    QLineEdit& filter = window_->docks().panel<editor::ScenarioPanel>().filter();
    filter.setFocus();
    key(Qt::Key_A);
    key(Qt::Key_Space);
    key(Qt::Key_1);
    QCOMPARE(filter.text(), QStringLiteral("a 1"));
    QVERIFY(window_->workspace().tools().isSelecting());
    QCOMPARE(window_->workspace().runner().state(), SimulationRunner::State::Editing);
  }

  void buttons_clicked_leaveTheKeyboardWhereItWas() {
    window_->workspace().view().setFocus();
    int boxes = 0;
    for (QWidget* each : window_->findChildren<QWidget*>()) {
      auto* box = qobject_cast<QComboBox*>(each);
      const bool isButton = qobject_cast<QAbstractButton*>(each) != nullptr;
      if (each->isVisible() && (isButton || (box != nullptr && !box->isEditable()))) {
        QVERIFY2(!(each->focusPolicy() & Qt::ClickFocus), each->metaObject()->className());
        ++boxes;
      }
    }
    QVERIFY(boxes > 10);
  }

  void checkBox_reachedByTab_hasItsSpace() {
    auto* box = new QCheckBox(QStringLiteral("a box"));
    window_->statusBar()->addWidget(box);
    box->setFocus(Qt::TabFocusReason);
    QVERIFY(box->hasFocus());
    key(Qt::Key_Space);
    QVERIFY(box->isChecked());
    QCOMPARE(window_->workspace().runner().state(), SimulationRunner::State::Editing);
  }

 private:
  editor::ScenarioDocument& document() { return window_->workspace().document(); }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(window_->windowHandle(), key, modifiers);
  }
  static void everyFocus() {
    QTest::addColumn<QString>("where");
    QTest::addColumn<bool>("isSelection");
    QTest::newRow("canvas") << "canvas" << true;
    QTest::newRow("scenario") << "scenario" << true;
    QTest::newRow("behaviour tree") << "tree" << false;
    QTest::newRow("issues") << "issues" << false;
    QTest::newRow("time line") << "time line" << true;
    QTest::newRow("metrics") << "metrics" << false;
  }
  void focus(const QString& where) {
    QWidget* wanted = &window_->workspace().view();
    if (where == QLatin1String("scenario")) {
      wanted = &window_->docks().panel<editor::ScenarioPanel>().tree();
    } else if (where == QLatin1String("tree")) {
      raise(QStringLiteral("behaviour"));
      wanted = &window_->docks().panel<editor::BehaviorPanel>().outline();
    } else if (where == QLatin1String("issues")) {
      raise(where);
      document().checkNow();
      wanted = window_->docks().panel<editor::IssuesPanel>().findChild<QAbstractItemView*>();
    } else if (where == QLatin1String("metrics")) {
      wanted = &metrics();
    } else if (where == QLatin1String("number")) {
      wanted = someNumber();
    } else if (where == QLatin1String("time line")) {
      wanted = window_->findChild<editor::TimelineBar*>();
    } else {
      QCOMPARE(where, QStringLiteral("canvas"));
    }
    QVERIFY(wanted != nullptr);
    wanted->setFocus();
    QVERIFY2(wanted->hasFocus(), qPrintable(where));
  }
  QTreeWidget& metrics() {
    raise(QStringLiteral("metrics"));
    return window_->docks().panel<editor::MetricsDock>().table().tree();
  }
  void raise(const QString& dock) {
    window_->docks().dock(dock)->show();
    window_->docks().dock(dock)->raise();
    QCoreApplication::processEvents();
  }
  QDoubleSpinBox* someNumber() {
    for (QDoubleSpinBox* field :
         window_->docks().panel<editor::PropertyPanel>().findChildren<QDoubleSpinBox*>()) {
      if (field->isVisible() && field->isEnabled() && field->value() != 1.0 &&
          field->maximum() >= 1.0) {
        return field;
      }
    }
    return nullptr;
  }
  QVariant areaKind() {
    const auto* box = widgets::findIf<QComboBox>(*window_, [](const QComboBox* each) {
      return each->isVisible() && each->accessibleName() == QLatin1String("Kind");
    });
    return box == nullptr ? QVariant() : QVariant(box->currentIndex());
  }
  static int firstBlock(const editor::TreeOutline& outline) {
    for (std::size_t i = 0; i < outline.nodes().size(); ++i) {
      const editor::OutlineNode& node = outline.nodes()[i];
      if (node.path.size() == 1 && bt::readBlock(*node.node)) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

  std::unique_ptr<app::MainWindow> window_;
  editor::EntityId person_;
};

QTEST_MAIN(KeyRulesTest)
#include "tst_KeyRules.moc"
