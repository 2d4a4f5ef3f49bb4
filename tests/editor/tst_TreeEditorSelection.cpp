#include "CanvasTester.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PersonTree.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/EventsPanel.h"
#include "editor/panels/MetricsFeed.h"
#include "tests/support/TreeEditorHands.h"

using editor::TreeCanvas;
using editor::TreeGraph;

/// Several nodes of a tree at once, places of the file and the blackboard, by mouse and keys in the
/// studio without the rest of the window.
class TreeEditorSelectionTest : public QObject, private CanvasTester, private TreeEditorHands {
  Q_OBJECT

 private:
  using TreeEditorHands::click;
  using TreeEditorHands::drag;
  using TreeEditorHands::EntityId;
  using TreeEditorHands::entry;
  using TreeEditorHands::person;

  std::unique_ptr<editor::SimulationRunner> runner_;
  std::unique_ptr<editor::RunEvents> events_;
  std::unique_ptr<editor::MetricsFeed> feed_;
  std::unique_ptr<editor::PanelContext> context_;
  std::unique_ptr<editor::TreeEditor> studio_;

  editor::ScenarioDocument& document() override { return document_; }
  editor::SimulationRunner& runner() { return *runner_; }
  editor::TreeEditor& studio() override { return *studio_; }
  void open(const char* name) {
    document().setSelection({person(name)});
    studio().resize(1100, 760);
    studio().show();
    QVERIFY(QTest::qWaitForWindowExposed(&studio()));
    canvas().fit();
  }
  void clickWith(Qt::KeyboardModifiers modifiers, int node) {
    QTest::mouseClick(&canvas(), Qt::LeftButton, modifiers, canvas().centreOf(node));
  }
  void stepTo(std::int64_t wanted) {
    while (runner().newestFrame() == nullptr || runner().newestFrame()->step < wanted) {
      const std::int64_t next =
          runner().newestFrame() == nullptr ? 1 : runner().newestFrame()->step + 1;
      runner().stepOnce();
      QTRY_VERIFY_WITH_TIMEOUT(
          runner().newestFrame() != nullptr && runner().newestFrame()->step >= next, 60000);
    }
  }
  int entryRow(const char* key) {
    const QTableWidget& table = studio().entries().table();
    for (int row = 0; row < table.rowCount(); ++row) {
      if (table.item(row, 0)->text() == QString::fromUtf8(key)) {
        return row;
      }
    }
    return -1;
  }
  /// A tree whose first step sets the entry "mood" to 1.
  void giveMoodTree(const char* name) {
    editor::pushTreeText(document(), person(name),
                         "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\"><Sequence>"
                         "<RunOnce><Script code=\"mood := 1\"/></RunOnce>"
                         "<AlwaysSuccess/></Sequence></BehaviorTree></root>",
                         QStringLiteral("Tree"));
  }
  /// Types 7 into the value of "mood", without leaving the field.
  void typeMood() {
    const QTableWidget& table = studio().entries().table();
    const QRect place = table.visualItemRect(table.item(entryRow("mood"), 1));
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, place.center());
    QTest::mouseDClick(table.viewport(), Qt::LeftButton, {}, place.center());
    auto* field = table.findChild<QLineEdit*>();
    QVERIFY(field != nullptr);
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("7"));
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    start(small::scenario());
    runner_ = std::make_unique<editor::SimulationRunner>();
    runner_->setRequest([this] { return editor::runRequestOf(document_); });
    events_ = std::make_unique<editor::RunEvents>(document_, *runner_);
    feed_ = std::make_unique<editor::MetricsFeed>(document_, *runner_);
    context_ = std::make_unique<editor::PanelContext>(view_, document_, *runner_, *events_, *feed_);
    studio_ = std::make_unique<editor::TreeEditor>(*context_);
  }
  void cleanup() {
    runner_->reset();
    studio_.reset();
    context_.reset();
    feed_.reset();
    events_.reset();
    runner_.reset();
    document_.stopMapTasks();
  }

  void several_clickedWithShift_areMovedCopiedAndDeletedAsOne() {
    open("Chloe");
    const QStringList before = rootChildren();
    QVERIFY(before.size() >= 3);
    const std::vector<int> children = graph().childrenOf(0);
    click(children[0]);
    clickWith(Qt::ShiftModifier, children[1]);
    QCOMPARE(canvas().selected(), (std::vector<int>{children[0], children[1]}));
    QCOMPARE(canvas().chosen(), children[1]);
    clickWith(Qt::ControlModifier, children[1]);
    QCOMPARE(canvas().selected(), std::vector<int>{children[0]});
    clickWith(Qt::ControlModifier, children[1]);
    QTest::keyClick(&canvas(), Qt::Key_C, Qt::ControlModifier);
    const QString xml = QGuiApplication::clipboard()->text();
    const int steps = undoSteps();
    QTest::keyClick(&canvas(), Qt::Key_Delete);
    QCOMPARE(undoSteps(), steps + 1);
    QCOMPARE(rootChildren(), before.mid(2));
    document().undoStack().undo();
    QCOMPARE(rootChildren(), before);
    click(0);
    QTest::keyClick(&canvas(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(undoSteps(), steps + 1);
    QCOMPARE(rootChildren(), before + before.mid(0, 2));
    QCOMPARE(canvas().selected().size(), std::size_t{2});
    QCOMPARE(QGuiApplication::clipboard()->text(), xml);
    QTest::keyClick(&canvas(), Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(rootChildren(), before + before.mid(0, 2) + before.mid(0, 2));
    document().undoStack().undo();
    document().undoStack().undo();
    QCOMPARE(rootChildren(), before);
  }

  void several_dragged_moveTogether() {
    open("Chloe");
    const QStringList before = rootChildren();
    const std::vector<int> children = graph().childrenOf(0);
    click(children[0]);
    clickWith(Qt::ShiftModifier, children[1]);
    const int steps = undoSteps();
    const QRectF last = graph().box(children.back());
    const QPointF end = canvas().fromGraph({last.right() + 12.0, last.center().y()});
    drag(canvas().centreOf(children[1]), end.toPoint());
    QCOMPARE(undoSteps(), steps + 1);
    QCOMPARE(rootChildren(), before.mid(2) + before.mid(0, 2));
    QCOMPARE(canvas().selected().size(), std::size_t{2});
    document().undoStack().undo();
    QCOMPARE(rootChildren(), before);
  }

  void band_withShift_selectsWhatItTouches() {
    open("Chloe");
    const std::vector<int> children = graph().childrenOf(0);
    QRectF around;
    for (const int child : {children[0], children[1]}) {
      around = around.isNull() ? graph().box(child) : around.united(graph().box(child));
    }
    const QPoint from = canvas().fromGraph(around.topLeft() - QPointF(3.0, 10.0)).toPoint();
    const QPoint to =
        canvas().fromGraph({around.right() - 0.25 * around.width(), around.center().y()}).toPoint();
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, QPoint(3, canvas().height() - 3));
    QVERIFY(canvas().selected().empty());
    QTest::mousePress(&canvas(), Qt::LeftButton, Qt::ShiftModifier, from);
    QMouseEvent move(QEvent::MouseMove, to, canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                     Qt::ShiftModifier);
    QCoreApplication::sendEvent(&canvas(), &move);
    QVERIFY(canvas().shown().band.has_value());
    QTest::mouseRelease(&canvas(), Qt::LeftButton, Qt::ShiftModifier, to);
    QVERIFY(!canvas().shown().band.has_value());
    QVERIFY(canvas().shown().isSelected(children[0]) && canvas().shown().isSelected(children[1]));
    QVERIFY(!canvas().shown().isSelected(0));
    QTest::keyClick(&canvas(), Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(canvas().selected().size(), graph().shown().size());
  }

  void several_fromTheMenu_arePutIntoOneParent() {
    open("Chloe");
    const QStringList before = rootChildren();
    const std::vector<int> children = graph().childrenOf(0);
    click(children[0]);
    clickWith(Qt::ShiftModifier, children[1]);
    const int steps = undoSteps();
    choosefromMenu(children[0], "Sequence");
    QCOMPARE(undoSteps(), steps + 1);
    QCOMPARE(rootChildren(), QStringList(QStringLiteral("Sequence")) + before.mid(2));
    document().undoStack().undo();
    click(graph().childrenOf(0)[0]);
    clickWith(Qt::ShiftModifier, graph().childrenOf(0)[1]);
    QMenu menu;
    studio().fillMenu(menu, graph().childrenOf(0)[0]);
    const QAction* inverter = entry(menu, QStringLiteral("Inverter"));
    QVERIFY(!inverter->isEnabled());
    QCOMPARE(inverter->toolTip(), QStringLiteral("An Inverter takes one child only"));
    studio().wrapIn("Inverter");
    QCOMPARE(undoSteps(), steps);
    QCOMPARE(studio().hint(), QStringLiteral("An Inverter takes one child only"));
  }

  /// Places as an editor of others has left them, kept when the tree is edited and saved.
  void layout_ofTheFile_isAnOption() {
    open("Chloe");
    QVERIFY(studio().positionSource().isHidden());
    const std::string xml =
        "<root BTCPP_format=\"4\">\n  <BehaviorTree ID=\"Main\">\n"
        "    <Fallback name=\"Top\" _x=\"300\" _y=\"50\">\n"
        "      <AlwaysSuccess name=\"Left\" _x=\"0\" _y=\"250\"/>\n"
        "      <AlwaysFailure name=\"Right\" _pos=\"700;450\"/>\n"
        "    </Fallback>\n  </BehaviorTree>\n</root>\n";
    editor::pushTreeText(document(), person("Chloe"), xml, QStringLiteral("Tree"));
    QTRY_VERIFY(called("Left") >= 0);
    QVERIFY(!studio().positionSource().isHidden());
    QTest::mouseClick(&studio().positionSource(), Qt::LeftButton);
    const QPointF top = graph().box(called("Top")).topLeft();
    QCOMPARE(graph().box(called("Left")).topLeft() - top, QPointF(-300.0, 200.0));
    QCOMPARE(graph().box(called("Right")).topLeft() - top, QPointF(400.0, 400.0));
    QVERIFY(studio().positionSource().text().contains(QStringLiteral("from file")));
    click(called("Left"));
    QTest::keyClick(&canvas(), Qt::Key_D, Qt::ControlModifier);  // an edit keeps the others
    const QString saved = QString::fromStdString(*document().tree(person("Chloe")));
    QVERIFY2(saved.contains(QStringLiteral("name=\"Right\" _pos=\"700;450\"")), qPrintable(saved));
    QTest::mouseClick(&studio().positionSource(), Qt::LeftButton);
    QVERIFY(graph().box(called("Left")).topLeft() - graph().box(called("Top")).topLeft() !=
            QPointF(-300.0, 200.0));
  }

  void blackboard_editedInARun_isAnInputAndKeptOfThePast() {
    open("Chloe");
    giveMoodTree("Chloe");
    studio().lower().setCurrentWidget(&studio().entries());
    QVERIFY(studio().entries().table().isHidden());
    QVERIFY(studio().entries().words().contains(QStringLiteral("Space")));
    stepTo(5);
    QTRY_VERIFY(entryRow("mood") >= 0);
    QTableWidget& table = studio().entries().table();
    const auto value = [&] { return table.item(entryRow("mood"), 1)->text(); };
    QTRY_COMPARE(value(), QStringLiteral("1"));
    QVERIFY((table.item(entryRow("dt"), 1)->flags() & Qt::ItemIsEditable) == 0);
    typeMood();
    QTest::keyClick(table.findChild<QLineEdit*>(), Qt::Key_Return);
    QTRY_COMPARE(value(), QStringLiteral("7"));  // waits for the next step
    stepTo(8);
    QTRY_COMPARE(value(), QStringLiteral("7"));
    const auto& inputs = runner().recording()->inputs();
    QCOMPARE(inputs.size(), std::size_t{1});
    QCOMPARE(inputs[0].first, std::int64_t{6});
    QCOMPARE(inputs[0].second.kind, sim2d::InputKind::Entry);
    QCOMPARE(inputs[0].second.name, std::string("mood=7"));
    runner().seek(3);  // as it was then
    QVERIFY(runner().isLookingBack());
    QTRY_COMPARE(value(), QStringLiteral("1"));
    QVERIFY((table.item(entryRow("mood"), 1)->flags() & Qt::ItemIsEditable) == 0);
    runner().seek(7);
    QTRY_COMPARE(value(), QStringLiteral("7"));
    shoot("studio_blackboard");
    studio().setTheme(editor::Theme::dark());
    shoot("studio_blackboard_dark");
    studio().setTheme(editor::Theme::light());
    document().setSelection({person("Ana")});  // nobody has looked at her then
    QTRY_VERIFY(table.isHidden());
    QVERIFY(studio().entries().words().contains(QStringLiteral("selected")));
    runner().reset();
  }

  /// A breakpoint selects the other person.
  void blackboard_anotherIsSelectedWhileTyping_isOfThePersonItWasTypedFor() {
    open("Chloe");
    giveMoodTree("Chloe");
    giveMoodTree("Ana");
    const int chloe = document().human(person("Chloe"))->id;
    studio().lower().setCurrentWidget(&studio().entries());
    stepTo(5);
    QTRY_VERIFY(entryRow("mood") >= 0);
    typeMood();
    document().setSelection({person("Ana")});
    stepTo(8);
    const auto& inputs = runner().recording()->inputs();
    QCOMPARE(inputs.size(), std::size_t{1});
    QCOMPARE(inputs[0].second.id, chloe);
    QCOMPARE(inputs[0].second.name, std::string("mood=7"));
    runner().reset();
  }

 private:
  /// With HUNAV_PICTURES, for people to look at.
  void shoot(const QByteArray& name) {
    const QByteArray folder = qgetenv("HUNAV_PICTURES");
    QCoreApplication::processEvents();
    if (!folder.isEmpty()) {
      QVERIFY(studio().grab().save(QString::fromLocal8Bit(folder + '/' + name + ".png")));
    }
  }
};

QTEST_MAIN(TreeEditorSelectionTest)
#include "tst_TreeEditorSelection.moc"
