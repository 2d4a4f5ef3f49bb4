#include <limits>

#include "bt/tree/TreeXml.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PersonTree.h"
#include "editor/panels/behavior/BehaviorPanel.h"
#include "tests/app/QuietWindow.h"
#include "tests/support/TreeEditorHands.h"

using editor::EntityId;
using editor::TreeCanvas;
using editor::TreeGraph;
using State = editor::SimulationRunner::State;

/// The studio of behaviour trees in the window, by mouse and keys.
class TreeEditorTest : public QObject, private TreeEditorHands {
  Q_OBJECT

 private:
  std::unique_ptr<app::MainWindow> window_;

  editor::ScenarioDocument& document() override { return window_->workspace().document(); }
  editor::SimulationRunner& runner() { return window_->workspace().runner(); }
  editor::TreeEditor& studio() override { return window_->docks().panel<editor::TreeEditor>(); }
  editor::BehaviorPanel& panel() { return window_->docks().panel<editor::BehaviorPanel>(); }

  void open(const char* name) {
    document().setSelection({person(name)});
    window_->docks().treeMaximized()->setChecked(true);
    QTRY_VERIFY(canvas().isVisible());
    QCoreApplication::processEvents();
    canvas().fit();
  }
  /// As a drag from the palette ends.
  void drop(const QString& xml, const QPoint& at) {
    QMimeData data;
    data.setData(QString::fromLatin1(TreeCanvas::kMime), xml.toUtf8());
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&canvas(), &enter);
    QVERIFY(enter.isAccepted());
    QDragMoveEvent move(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&canvas(), &move);
    QVERIFY(canvas().shown().drop.has_value());
    QDropEvent end(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&canvas(), &end);
  }
  QTreeWidgetItem* paletteRow(const char* title) {
    for (QTreeWidgetItemIterator row(&studio().palette().list()); *row != nullptr; ++row) {
      if ((*row)->text(0) == QString::fromUtf8(title)) {
        return *row;
      }
    }
    return nullptr;
  }

 private Q_SLOTS:
  void init() {
    window_ = quiet::shownWindow();
    QVERIFY(window_->open(quiet::demoPath()));
  }
  void cleanup() { quiet::leave(window_); }

  void key_opensAndClosesTheTree() {
    const QDockWidget& dock = *window_->docks().dock(QStringLiteral("tree"));
    const bool before = dock.isVisible();
    const QKeySequence keys = window_->docks().toggleOf(dock)->shortcut();
    QCOMPARE(keys.count(), 1);
    QTest::keyClick(window_->windowHandle(), Qt::Key(keys[0] & ~int{Qt::ALT}), Qt::AltModifier);
    QTRY_COMPARE(dock.isVisible(), !before);
  }

  void large_takesThePlaceOfTheMapAndGivesItBack() {
    const QRect before = window_->workspace().view().geometry();
    const auto openDocks = [this] {
      QStringList names;
      for (const QDockWidget* dock : window_->docks().all()) {
        names << (dock->isHidden() ? QString() : dock->objectName());
      }
      return names;
    };
    const QStringList docks = openDocks();
    QTest::keyClick(window_.get(), Qt::Key_F8);
    QTRY_VERIFY(studio().isVisible());
    QVERIFY(!window_->workspace().view().isVisible());
    QTRY_VERIFY(panel().isVisible());  // the values of a node
    QTRY_VERIFY(canvas().width() > 500);
    QTRY_VERIFY(canvas().height() > 250);
    QTRY_VERIFY(panel().width() <= 320);
    QTest::keyClick(window_.get(), Qt::Key_F8);
    QTRY_VERIFY(window_->workspace().view().isVisible());
    QVERIFY(!studio().isVisible());
    QCOMPARE(openDocks(), docks);
    QTRY_COMPARE(window_->workspace().view().geometry(), before);
    QCOMPARE(window_->focusWidget(), &window_->workspace().view());
    QTest::keyClick(window_->focusWidget(), Qt::Key_Space);
    QTRY_COMPARE(runner().state(), State::Running);  // Space does not press a button.
    runner().reset();
    window_->docks().treeMaximized()->setChecked(true);
    window_->docks().mapOnly()->setChecked(true);  // the other one ends it
    QVERIFY(!window_->docks().treeMaximized()->isChecked());
    QVERIFY(window_->workspace().view().isVisible());
    window_->docks().mapOnly()->setChecked(false);
  }

  void beside_mapAndTreeAreSeenTogether() {
    QDockWidget* dock = window_->docks().dock(QStringLiteral("tree"));
    window_->docks().toggleOf(*dock)->trigger();
    QTRY_VERIFY(studio().isVisible());
    QVERIFY(window_->workspace().view().isVisible());
    QTRY_VERIFY(canvas().height() >= 150);
    QVERIFY(window_->workspace().view().height() >= 150);
    QCOMPARE(studio().person(), document().scenario().humans.front().key);  // nobody is selected
    document().setSelection({person("Chloe")});
    QCOMPARE(studio().person(), person("Chloe"));
    document().setSelection({document().scenario().goals.front().key});
    QCOMPARE(studio().person(), person("Chloe"));  // she was the last
  }

  void node_clicked_isChosenInOutlineFormAndHistory() {
    open("Chloe");
    const int node = called("IsRobotVisible");
    click(node);
    QCOMPARE(canvas().chosen(), node);
    QVERIFY(panel().outline().current() != nullptr);
    QCOMPARE(panel().outline().currentNode(), node);
    panel().outline().selectNode(called("ApproachRobot"));
    QCOMPARE(canvas().chosen(), called("ApproachRobot"));
    QTest::keyClick(&canvas(), Qt::Key_Up);
    QCOMPARE(canvas().chosen(), graph().node(called("ApproachRobot")).parent);
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, QPoint(3, canvas().height() - 3));
    QCOMPARE(canvas().chosen(), -1);
  }

  void subtree_doubleClicked_opensInPlace() {
    open("Chloe");
    const int tree = called("RegularNavTree");
    QVERIFY(tree > 0);
    QVERIFY(graph().isFolded(tree));
    const int inner = called("UpdateGoal");
    QVERIFY(!graph().isShown(inner));
    QTest::mouseDClick(&canvas(), Qt::LeftButton, {}, canvas().centreOf(tree));
    QVERIFY(!graph().isFolded(tree));
    QVERIFY(graph().isShown(inner));
    canvas().fit();
    click(inner);
    QTest::keyClick(&canvas(), Qt::Key_Delete);  // of an included file
    QVERIFY(studio().hint().contains(QStringLiteral("included")));
    QCOMPARE(undoSteps(), 0);
    click(tree);
    QTest::keyClick(&canvas(), Qt::Key_Minus);
    QVERIFY(graph().isFolded(tree));
    const QPointF knob = editor::TreePainter::foldHandleRect(graph(), tree).center();
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, canvas().fromGraph(knob).toPoint());
    QVERIFY(!graph().isFolded(tree));
  }

  void keys_editTheTreeAndLeaveThePersonAlone() {
    open("Chloe");
    const std::size_t people = document().scenario().humans.size();
    const QStringList before = rootChildren();
    click(graph().childrenOf(0).front());
    QTest::keyClick(&canvas(), Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(rootChildren().size(), before.size() + 1);
    QCOMPARE(canvas().chosen(), graph().childrenOf(0)[1]);
    QTest::keyClick(&canvas(), Qt::Key_Right, Qt::AltModifier);
    QCOMPARE(canvas().chosen(), graph().childrenOf(0)[2]);
    QTest::keyClick(&canvas(), Qt::Key_Delete);
    QCOMPARE(rootChildren(), before);
    QCOMPARE(document().scenario().humans.size(), people);
    QVERIFY(!document().tree(person("Chloe")));  // what behaviour and goals make, again
    QCOMPARE(undoSteps(), 3);
    for (int k = 0; k < 3; ++k) {
      document().undoStack().undo();
    }
    QCOMPARE(rootChildren(), before);
    document().undoStack().redo();
    QCOMPARE(rootChildren().size(), before.size() + 1);
  }

  void root_cannotBeDeleted_andItIsSaid() {
    open("Chloe");
    click(0);
    QTest::keyClick(&canvas(), Qt::Key_Delete);
    QVERIFY(!studio().hint().isEmpty());
    QCOMPARE(undoSteps(), 0);
  }

  void nodeDragged_goesWhereTheMarkIs() {
    open("Chloe");
    const QStringList before = rootChildren();
    const std::vector<int> children = graph().childrenOf(0);
    const QRectF last = graph().box(children.back());
    drag(canvas().centreOf(children.front()),
         canvas().fromGraph(QPointF(last.right() + 10, last.center().y())).toPoint());
    QStringList expected = before.mid(1);
    expected << before.front();
    QCOMPARE(rootChildren(), expected);
    QCOMPARE(canvas().chosen(), graph().childrenOf(0).back());
    QCOMPARE(undoSteps(), 1);
    // given up by Escape
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, canvas().centreOf(canvas().chosen()));
    const QPoint away(40, 40);
    QMouseEvent move(QEvent::MouseMove, away, canvas().mapToGlobal(away), Qt::NoButton,
                     Qt::LeftButton, {});
    QCoreApplication::sendEvent(&canvas(), &move);
    QCOMPARE(canvas().shown().dragged.size(), std::size_t{1});
    QTest::keyClick(&canvas(), Qt::Key_Escape);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, away);
    QCOMPARE(rootChildren(), expected);
  }

  void notices_areSeenWhileTheTreeIsLarge() {
    open("Chloe");
    window_->notices().warn(QStringLiteral("test"), QStringLiteral("Look here"));
    QVERIFY(window_->notices().isVisible());
    const QRect notice(window_->notices().mapTo(window_.get(), QPoint()),
                       window_->notices().size());
    QTRY_VERIFY(window_->notices().height() > 20);
    QVERIFY(window_->rect().intersects(notice));
    window_->docks().treeMaximized()->setChecked(false);
    QTRY_VERIFY(window_->workspace().view().isVisible());
    QVERIFY(window_->notices().isVisible());
    QVERIFY(!studio().isAncestorOf(&window_->notices()));
    editor::pushTreeText(document(), person("Chloe"),
                         "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\"><Juggle/>"
                         "</BehaviorTree></root>",
                         QStringLiteral("Tree"));
    window_->docks().treeMaximized()->setChecked(true);
    QTRY_VERIFY2(studio().problem().contains(QStringLiteral("Juggle")),
                 qPrintable(studio().problem()));
  }

  void ground_dragged_movesThePicture() {
    open("Chloe");
    const QPoint before = canvas().centreOf(0);
    const QPoint ground(5, canvas().height() - 10);
    drag(ground, ground + QPoint(60, -30));
    QCOMPARE(canvas().centreOf(0), before + QPoint(60, -30));
    QCOMPARE(undoSteps(), 0);
    const double zoom = canvas().zoom();
    QWheelEvent wheel(canvas().rect().center(), canvas().mapToGlobal(canvas().rect().center()), {},
                      QPoint(0, -240), Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&canvas(), &wheel);
    QVERIFY(canvas().zoom() < zoom);
    QTest::keyClick(&canvas(), Qt::Key_F);
    QCOMPARE(canvas().zoom(), zoom);
  }

  void palette_searchedAndDragged_addsTheNode() {
    open("Chloe");
    QTest::keyClicks(&studio().palette().search(), QStringLiteral("stopmov"));
    QTreeWidgetItem* row = paletteRow("StopMovement");
    QVERIFY(row != nullptr);
    QVERIFY(!row->isHidden());
    QVERIFY(paletteRow("GoTo")->isHidden());
    const QRectF first = graph().box(graph().childrenOf(0).front());
    const QStringList before = rootChildren();
    drop(editor::NodePalette::xmlOf(row),
         canvas().fromGraph(QPointF(first.left() - 10, first.center().y())).toPoint());
    QCOMPARE(rootChildren().first(), QStringLiteral("StopMovement"));
    QCOMPARE(rootChildren().mid(1), before);
    QCOMPARE(canvas().chosen(), graph().childrenOf(0).front());
    const bt::NodeSpec& added = *graph().node(canvas().chosen()).node;
    QCOMPARE(*bt::findAttribute(added.ports, "agent_id"), std::string("{id}"));
    QVERIFY(graph().problemsOf(canvas().chosen()).empty());
    QCOMPARE(undoSteps(), 1);
  }

  void palette_enterInTheSearch_addsBelowTheChosenNode() {
    open("Chloe");
    click(0);
    const int before = rootChildren().size();
    QTest::keyClick(&canvas(), Qt::Key_Insert);
    QTRY_VERIFY(studio().palette().search().hasFocus());
    // in a list by name it stands behind ResumeMovement, whose explanation names it
    QTest::keyClicks(&studio().palette().search(), QStringLiteral("StopMovement"));
    QVERIFY(!paletteRow("ResumeMovement")->isHidden());
    QTest::keyClick(&studio().palette().search(), Qt::Key_Return);
    QCOMPARE(rootChildren().size(), before + 1);
    QCOMPARE(rootChildren().last(), QStringLiteral("StopMovement"));
    QTest::keyClicks(&studio().palette().search(), QStringLiteral("xyzzy"));
    QVERIFY(!studio().palette().list().isVisible());  // nothing matches
  }

  void decorator_droppedOnALeaf_isPutAroundIt() {
    open("Chloe");
    const int leaf = called("IsRobotVisible");
    const int above = graph().node(leaf).parent;
    drop(editor::NodePalette::xmlOf(paletteRow("KeepRunningUntilFailure")),
         canvas().centreOf(leaf));
    const int around = called("KeepRunningUntilFailure");
    QVERIFY(around > 0);
    QCOMPARE(graph().node(around).parent, above);
    QCOMPARE(graph().node(called("IsRobotVisible")).parent, around);
    choosefromMenu(around, "Remove, keep children");
    QCOMPARE(called("KeepRunningUntilFailure"), -1);
    QCOMPARE(undoSteps(), 2);
  }

  void menu_wrapsReplacesAndExtracts() {
    open("Chloe");
    click(called("IsRobotVisible"));
    choosefromMenu(canvas().chosen(), "ForceSuccess");
    QVERIFY(called("ForceSuccess") > 0);
    click(called("IsRobotVisible"));
    choosefromMenu(canvas().chosen(), "IsRobotClose");
    QVERIFY(called("IsRobotClose") > 0);
    QCOMPARE(called("IsRobotVisible"), -1);
    const int part = graph().childrenOf(0)[1];
    const std::string name = graph().node(part).node->label();
    click(part);
    choosefromMenu(part, "Extract as subtree");
    const int tree = graph().childrenOf(0)[1];
    QVERIFY(graph().node(tree).node->isSubTree());
    QVERIFY(graph().isEditable(graph().childrenOf(tree).front()));
    QVERIFY(!graph().isFolded(tree));  // its own: edited in place
    QCOMPARE(graph().node(graph().childrenOf(tree).front()).node->label(), name);
    QVERIFY(paletteRow(graph().node(tree).node->subTree.c_str()) != nullptr);
    click(tree);
    choosefromMenu(tree, "Inline subtree");
    QVERIFY(!graph().node(graph().childrenOf(0)[1]).node->isSubTree());
  }

  void rename_byKey_isOneCommandAndEscapeGivesUp() {
    open("Chloe");
    click(0);
    QTest::keyClick(&canvas(), Qt::Key_F2);
    QVERIFY(studio().nameField().isVisible());
    QTest::keyClicks(&studio().nameField(), QStringLiteral("Cafe"));
    QTest::keyClick(&studio().nameField(), Qt::Key_Return);
    QCOMPARE(editor::nodeTitle(*graph().node(0).node), QStringLiteral("Cafe"));
    QCOMPARE(undoSteps(), 1);
    QVERIFY(canvas().hasFocus());
    QTest::keyClick(&canvas(), Qt::Key_F2);
    QTest::keyClicks(&studio().nameField(), QStringLiteral("Other"));
    QTest::keyClick(&studio().nameField(), Qt::Key_Escape);
    QVERIFY(!studio().nameField().isVisible());
    QCOMPARE(editor::nodeTitle(*graph().node(0).node), QStringLiteral("Cafe"));
    QCOMPARE(undoSteps(), 1);
  }

  void copyAndPaste_isXmlBothWays() {
    open("Chloe");
    click(called("IsRobotVisible"));
    QTest::keyClick(&canvas(), Qt::Key_C, Qt::ControlModifier);
    const QString xml = QGuiApplication::clipboard()->text();
    QVERIFY2(xml.startsWith(QStringLiteral("<IsRobotVisible ")), qPrintable(xml));
    document().setSelection({person("Farid")});
    canvas().fit();
    click(0);
    const int before = rootChildren().size();
    QTest::keyClick(&canvas(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(rootChildren().size(), before + 1);
    QCOMPARE(rootChildren().last(), QStringLiteral("IsRobotVisible"));
    QGuiApplication::clipboard()->setText(QStringLiteral("<Nonsense a='1'>"));
    QTest::keyClick(&canvas(), Qt::Key_V, Qt::ControlModifier);
    QVERIFY(!studio().hint().isEmpty());
    QCOMPARE(undoSteps(), 1);
    QGuiApplication::clipboard()->setText(QStringLiteral("<Juggle balls='3'/>"));
    QTest::keyClick(&canvas(), Qt::Key_V, Qt::ControlModifier);
    const int unknown = called("Juggle");
    QVERIFY(graph().isUnknown(unknown));
    QVERIFY(!graph().problemsOf(unknown).empty());  // told at the node
  }

  void cut_putsItOnTheClipboard() {
    open("Chloe");
    const QStringList before = rootChildren();
    click(graph().childrenOf(0).front());
    QTest::keyClick(&canvas(), Qt::Key_X, Qt::ControlModifier);
    QCOMPARE(rootChildren(), before.mid(1));
    click(0);
    QTest::keyClick(&canvas(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(rootChildren().last(), before.first());
  }

  void tree_givenToOthers_isEditedForAll() {
    open("Chloe");
    studio().assignTreeTo(person("Ana"));
    QCOMPARE(document().tree(person("Ana")), document().tree(person("Chloe")));
    QVERIFY(studio().sharing().isVisible());
    QCOMPARE(studio().edited().size(), std::size_t{2});
    const int steps = undoSteps();
    click(0);
    studio().add(QStringLiteral("<StopMovement agent_id=\"{id}\"/>"));
    QCOMPARE(undoSteps(), steps + 1);  // one for both
    QCOMPARE(document().tree(person("Ana")), document().tree(person("Chloe")));
    studio().sharing().setChecked(false);
    QTest::keyClick(&canvas(), Qt::Key_Delete);
    QVERIFY(document().tree(person("Ana")) != document().tree(person("Chloe")));
    document().undoStack().undo();
    document().undoStack().undo();
    document().undoStack().undo();
    QVERIFY(!document().tree(person("Ana")));
    QVERIFY(!document().tree(person("Chloe")));
  }

  void goal_pickedOnTheMap_becomesTheValue() {
    open("Chloe");
    click(0);
    studio().add(QStringLiteral("<GoTo agent_id=\"{id}\" goal_id=\"1\" time_step=\"{dt}\"/>"));
    const int node = canvas().chosen();
    choosefromMenu(node, "Pick goal_id on the map");
    QVERIFY(studio().isPicking());
    const sim2d::GlobalGoal goal = document().scenario().goals[3];
    document().setSelection({goal.key});  // as a click on it does
    QVERIFY(!studio().isPicking());
    QCOMPARE(document().selection(), std::vector<EntityId>{person("Chloe")});
    QCOMPARE(canvas().chosen(), node);
    QCOMPARE(*bt::findAttribute(graph().node(node).node->ports, "goal_id"),
             std::to_string(goal.id));
  }

  void xml_typed_isTakenWhenItCanBeRead() {
    open("Chloe");
    studio().lower().setCurrentWidget(&studio().text());
    QPlainTextEdit& text = studio().text().text();
    QTRY_VERIFY(text.isVisible());
    const QString before = text.toPlainText();
    QVERIFY(before.contains(QStringLiteral("<IsRobotVisible ")));
    click(called("IsRobotVisible"));
    QVERIFY(text.textCursor().block().text().contains(QStringLiteral("<IsRobotVisible ")));
    text.setFocus();
    QTextCursor cursor = text.document()->find(QStringLiteral("</Fallback>"));
    cursor.setPosition(cursor.selectionStart());
    text.setTextCursor(cursor);
    QTest::keyClicks(&text, QStringLiteral("<AlwaysFailure>"));
    QTRY_VERIFY(!studio().text().problem().isEmpty());  // not closed: said, nothing is changed
    QCOMPARE(undoSteps(), 0);
    QTest::keyClick(&text, Qt::Key_Backspace);
    QTest::keyClicks(&text, QStringLiteral("/>"));
    QTRY_COMPARE(undoSteps(), 1);
    QVERIFY(studio().text().problem().isEmpty());
    QVERIFY(called("AlwaysFailure") > 0);
    document().undoStack().undo();
    QCOMPARE(text.toPlainText(), before);
    QCOMPARE(called("AlwaysFailure"), -1);
    // and what is edited in the graph is in the text
    click(called("IsRobotVisible"));
    QTest::keyClick(&canvas(), Qt::Key_Delete);
    QVERIFY(!text.toPlainText().contains(QStringLiteral("<IsRobotVisible ")));
  }

  void direction_isSwitchedAndAllStaysInView() {
    open("Chloe");
    canvas().setDirection(editor::TreeDirection::Right);
    QVERIFY(graph().box(graph().childrenOf(0).front()).left() > graph().box(0).right());
    for (const int node : graph().shown()) {
      QVERIFY(canvas().rect().contains(canvas().centreOf(node)));
    }
  }

  void run_colorsNodesAndKeepsTheirHistory() {
    open("Chloe");
    QVERIFY(canvas().shown().statuses.empty());
    runner().setSpeed(std::numeric_limits<double>::infinity());
    runner().play();
    QTRY_VERIFY(runner().newestFrame() != nullptr && runner().newestFrame()->step > 200);
    runner().pause();
    QTRY_VERIFY(runner().state() == State::Paused);
    const auto expected = [this] {
      const sim2d::Human& human = *document().human(person("Chloe"));
      return editor::statusesByNode(
          runner().recording()->treeAt(human.id, runner().shownFrame()->step), graph().names());
    };
    QTRY_VERIFY(canvas().shown().statuses == expected());
    QVERIFY(!canvas().shown().statuses.empty());
    // a click into the strip looks back, and the graph follows
    editor::TreeHistory& strip = studio().history();
    const int node = graph().childrenOf(0).front();
    const QRect band = strip.bandOf(node);
    QTest::mouseClick(strip.viewport(), Qt::LeftButton, {}, band.center());
    QCOMPARE(canvas().chosen(), node);
    QVERIFY(runner().isLookingBack());
    QCOMPARE(runner().shownFrame()->step, strip.stepAt(band.center().x()));
    QTRY_VERIFY(canvas().shown().statuses == expected());
    // the strip says for each step what the recording says
    const sim2d::Human& human = *document().human(person("Chloe"));
    for (std::int64_t step = 1; step <= 200; step += 13) {
      const auto all =
          editor::statusesByNode(runner().recording()->treeAt(human.id, step), graph().names());
      for (std::size_t k = 0; k < all.size(); ++k) {
        base::NodeStatus told = base::NodeStatus::Idle;
        for (const auto& each : strip.intervalsOf(static_cast<int>(k))) {
          told = each.from <= step ? each.status : told;
        }
        QCOMPARE(told, all[k]);
      }
    }
    document().setSelection({person("Ana")});  // another person, at the same moment
    QVERIFY(!canvas().shown().statuses.empty());
    runner().reset();
    QTRY_VERIFY(canvas().shown().statuses.empty());
  }

  void history_atTheFirstStep_hasOneLabelPerPlace() {
    open("Chloe");
    runner().stepOnce();
    QTRY_VERIFY(runner().newestFrame() != nullptr && runner().newestFrame()->step == 1 &&
                runner().state() == State::Paused);
    const editor::TreeHistory& strip = studio().history();
    const double dt = runner().recording()->header()->dt;
    QTRY_COMPARE(strip.labelledTimes(), (std::vector<double>{0.0, dt}));
    QVERIFY(strip.xOf(1) - strip.xOf(0) > 60);
    runner().reset();
  }

  void breakpoint_fromTheMenu_isShownAtTheNode() {
    open("Chloe");
    QVERIFY(canvas().shown().breakpoints.empty());
    choosefromMenu(called("IsRobotVisible"), "It starts to fail");
    QCOMPARE(runner().breakpoints().size(), std::size_t{1});
    QCOMPARE(canvas().shown().breakpoints.size(), std::size_t{1});
    document().setSelection({person("Ana")});
    QVERIFY(canvas().shown().breakpoints.empty());
  }

  void tooltipAndTexts_ofTheStudio_areThere() {
    open("Chloe");
    for (const QToolButton* button : studio().findChildren<QToolButton*>()) {
      QVERIFY2(button->text().isEmpty() || !button->toolTip().isEmpty(),
               qPrintable(button->text()));
    }
    QVERIFY(!canvas().accessibleName().isEmpty());
  }
};

QTEST_MAIN(TreeEditorTest)
#include "tst_TreeEditor.moc"
