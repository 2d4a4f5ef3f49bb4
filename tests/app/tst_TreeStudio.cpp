#include <algorithm>
#include <cmath>

#include <QFileDialog>

#include "app/cli/TreePictureFile.h"
#include "bt/tree/TreeXml.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PersonTree.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/behavior/BehaviorPanel.h"
#include "tests/app/QuietWindow.h"
#include "tests/support/TreeEditorHands.h"

using editor::EntityId;
using State = editor::SimulationRunner::State;

/// Ports edited in the node, refused edits and runs, search, and new trees, by mouse and keys.
class TreeStudioTest : public QObject, private TreeEditorHands {
  Q_OBJECT

 private:
  std::unique_ptr<app::MainWindow> window_;

  editor::ScenarioDocument& document() override { return window_->workspace().document(); }
  editor::SimulationRunner& runner() { return window_->workspace().runner(); }
  editor::TreeEditor& studio() override { return window_->docks().panel<editor::TreeEditor>(); }
  editor::BehaviorPanel& panel() { return window_->docks().panel<editor::BehaviorPanel>(); }
  editor::NodeFields& fields() { return studio().fields(); }
  editor::NodePalette& palette() { return studio().palette(); }

  static QString text(const char* words) { return QString::fromUtf8(words); }
  void openLarge() {
    QTest::keyClick(window_.get(), Qt::Key_F8);
    QTRY_VERIFY(canvas().isVisible());
    QCoreApplication::processEvents();
    canvas().fit();
  }
  void open(const char* name) {
    document().setSelection({person(name)});
    openLarge();
  }
  void giveTree(const char* name, const char* body) {
    editor::pushTreeText(document(), person(name),
                         std::string("<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">") + body +
                             "</BehaviorTree></root>",
                         text("Tree"));
  }
  void doubleClick(int node) {
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, canvas().centreOf(node));
    QTest::mouseDClick(&canvas(), Qt::LeftButton, {}, canvas().centreOf(node));
  }
  QString portOf(int node, const char* port) {
    const std::string* value = bt::findAttribute(graph().node(node).node->ports, port);
    return value == nullptr ? text("(none)") : QString::fromStdString(*value);
  }
  static void type(QWidget& field, const char* words) {
    static_cast<QLineEdit&>(field).selectAll();
    QTest::keyClicks(&field, text(words));
  }
  QString firstRow() {
    const QTreeWidgetItem* row = palette().list().currentItem();
    return row == nullptr ? QString() : row->text(0);
  }
  /// Types a name into the search and presses Enter: keys only.
  void addByKeys(const char* words) {
    QTest::keyClicks(&palette().search(), text(words));
    QTest::keyClick(&palette().search(), Qt::Key_Return);
  }

 private Q_SLOTS:
  void init() {
    window_ = quiet::shownWindow();
    QVERIFY(window_->open(quiet::demoPath()));
  }
  void cleanup() { quiet::leave(window_); }

  void inset_showsThePersonWhereNoPartOfTheTreeIs() {
    giveTree("Chloe", "<Sequence><AlwaysSuccess/><AlwaysSuccess/><AlwaysSuccess/></Sequence>");
    open("Chloe");
    const QWidget& inset = studio().inset();
    QTRY_VERIFY(inset.isVisible());
    QCOMPARE(studio().inset().title(), text("Map around Chloe"));
    for (const int node : graph().shown()) {
      QVERIFY(!inset.geometry().intersects(canvas().placeOf(node)));
    }
    const QPointF line = 0.5 * (graph().outlet(0) + graph().inlet(graph().childrenOf(0).front()));
    QVERIFY(!canvas().isFree(QRect(canvas().fromGraph(line).toPoint(), QSize(3, 3))));
    std::string column = "<AlwaysSuccess/>";
    for (int k = 0; k < 8; ++k) {
      column = "<Inverter>" + column + "</Inverter>";
    }
    std::string many;
    for (int k = 0; k < 12; ++k) {
      many += column;
    }
    giveTree("Chloe", ("<Sequence>" + many + "</Sequence>").c_str());
    canvas().fit();
    canvas().zoomBy(1.5 / canvas().zoom(), canvas().fromGraph(graph().bounds().center()));
    QVERIFY(inset.isHidden());  // The tree is in all corners.
  }

  void nobodySelected_shownPersonFeedsThePanel() {
    document().setSelection({});
    openLarge();
    QVERIFY(document().selection().empty());
    QCOMPARE(panel().person(), studio().person());
    QVERIFY(panel().person());
    const int node = graph().childrenOf(0).front();
    click(node);
    QCOMPARE(panel().outline().currentNode(), node);
    document().setSelection({document().scenario().goals.front().key});  // Not a person.
    QCOMPARE(panel().person(), studio().person());
    QTest::keyClick(window_.get(), Qt::Key_F8);  // Without the studio, the panel asks for a person.
    QTRY_VERIFY(!studio().isVisible());
    QVERIFY(!panel().person());
  }

  void runRefused_staysAtTheFaultyNodeAndTellsTheNumber() {
    open("Chloe");
    giveTree("Chloe", "<Sequence><AlwaysSuccess/><ReactiveFallback name='Choose'/></Sequence>");
    document().setSelection({});
    click(0);
    QTest::keyClick(window_.get(), Qt::Key_Space);
    QTRY_VERIFY(studio().problem().contains(text("Cannot run: 1 error")));
    QVERIFY(studio().isVisible() && window_->docks().treeMaximized()->isChecked());
    QVERIFY(!window_->docks().dock(text("issues"))->isVisible());
    QCOMPARE(studio().person(), person("Chloe"));
    QCOMPARE(canvas().chosen(), called("Choose"));
    QVERIFY2(!studio().problem().contains(text("Main/")), qPrintable(studio().problem()));
    QVERIFY2(studio().problem().contains(text("Choose: 'ReactiveFallback' has 0 children")),
             qPrintable(studio().problem()));
    QVERIFY(window_->statusBar()->currentMessage().contains(text("Cannot run: 1 error")));
    quiet::shoot(*window_, "studio_refused");
    window_->setTheme(editor::Theme::dark());
    quiet::shoot(*window_, "studio_refused_dark");
    window_->setTheme(editor::Theme::light());
    addByKeysAt(called("Choose"), "AlwaysSuccess");
    QVERIFY(!studio().problem().contains(text("Cannot run")));                // Fixed.
    QTRY_VERIFY(!window_->docks().panel<editor::IssuesPanel>().hasErrors());  // checked in a thread
    QTest::keyClick(window_.get(), Qt::Key_Space);
    QTRY_VERIFY(runner().state() != State::Editing);
    runner().reset();
  }

  /// Beside the map, an error that is in no tree still leads to the list of issues.
  void runRefused_besideTheMap_treeStaysInFront() {
    window_->docks().toggleOf(*window_->docks().dock(text("tree")))->trigger();
    QTRY_VERIFY(studio().isVisible());
    giveTree("Chloe", "<ReactiveFallback/>");
    document().setSelection({person("Ana")});
    runner().play();
    QTRY_COMPARE(studio().person(), person("Chloe"));
    QVERIFY(studio().isVisible());
    QCOMPARE(canvas().chosen(), 0);
  }

  void issue_clicked_showsItsNode() {
    window_->docks().toggleOf(*window_->docks().dock(text("tree")))->trigger();
    QTRY_VERIFY(studio().isVisible());
    giveTree("Chloe", "<Sequence><AlwaysSuccess/><Inverter name='Not'/></Sequence>");
    document().setSelection({person("Ana")});
    base::Diagnostic found;
    for (const base::Diagnostic& each : editor::personTree(document(), person("Chloe")).problems) {
      found = each.severity == base::Severity::Error ? each : found;
    }
    QVERIFY(!found.message.empty());
    found.entity = person("Chloe");
    auto& issues = window_->docks().panel<editor::IssuesPanel>();
    issues.setActionIssues({found});
    auto* table = issues.findChild<QTableWidget*>();
    QTRY_VERIFY(table->rowCount() > 0 && table->item(0, 0) != nullptr);
    QCOMPARE(table->item(0, 0)->text(), text("Not: 'Inverter' has 0 children (needs 1)"));
    Q_EMIT table->clicked(table->model()->index(0, 0));
    QCOMPARE(studio().person(), person("Chloe"));
    QCOMPARE(canvas().chosen(), called("Not"));
  }

  void error_isRed_andAWarningAmber() {
    open("Chloe");
    giveTree("Chloe", "<Sequence/>");
    const auto* banner = studio().findChild<QLabel*>(text("problem"));
    QVERIFY(banner != nullptr);
    const editor::Theme theme = editor::Theme::light();
    QCOMPARE(banner->palette().color(QPalette::WindowText), theme.color(editor::Role::Error));
    giveTree("Chloe", "<Sequence><IsRobotVisible agent_id='{id}' distance='-5'/></Sequence>");
    QVERIFY(!studio().problem().isEmpty());
    QCOMPARE(banner->palette().color(QPalette::WindowText), theme.color(editor::Role::Warning));
  }

  /// It is shown over the lower edge of the tree: nothing moves under the pointer.
  void error_appears_nothingMoves() {
    open("Chloe");
    giveTree("Chloe", "<Sequence><AlwaysSuccess/></Sequence>");
    QTest::qWait(50);
    const QRect before(canvas().mapTo(&studio(), QPoint()), canvas().size());
    giveTree("Chloe", "<Sequence/>");
    QTest::qWait(50);
    QVERIFY(!studio().problem().isEmpty());
    QCOMPARE(QRect(canvas().mapTo(&studio(), QPoint()), canvas().size()), before);
    const auto* banner = studio().findChild<QLabel*>(text("problem"));
    QVERIFY(banner->isVisible());
    QCOMPARE(banner->geometry().bottom(), canvas().rect().bottom());
    QCOMPARE(banner->width(), canvas().width());
  }

  void menu_ofAnOnlyChild_offersWhatWorks() {
    open("Chloe");
    giveTree("Chloe", "<Inverter><AlwaysSuccess/></Inverter>");
    QTRY_VERIFY(called("AlwaysSuccess") == 1);
    QMenu menu;
    click(1);
    studio().fillMenu(menu, 1);
    for (const char* words : {"Earlier", "Later", "Duplicate", "Remove, keep children"}) {
      QVERIFY2(!entry(menu, text(words))->isEnabled(), words);
    }
    QCOMPARE(entry(menu, text("Duplicate"))->toolTip(), text("An Inverter takes one child only"));
    for (const char* words : {"Delete", "Rename", "Extract as subtree", "Edit ports", "Wrap in",
                              "Replace with", "Break when"}) {
      QVERIFY2(entry(menu, text(words))->isEnabled(), words);
    }
    QVERIFY(menu.toolTipsVisible());
    QTest::keyClick(&canvas(), Qt::Key_D, Qt::ControlModifier);  // By key it tells the reason.
    QCOMPARE(studio().hint(), text("An Inverter takes one child only"));
    QMenu root;
    click(0);
    studio().fillMenu(root, 0);
    QVERIFY(!entry(root, text("Delete"))->isEnabled());
    QVERIFY(entry(root, text("Remove, keep children"))->isEnabled());
    QVERIFY(entry(root, text("ForceSuccess"))->isEnabled());
  }

  void search_highlightsTheBestAndEnterTakesIt() {
    open("Chloe");
    giveTree("Chloe", "<Sequence><AlwaysSuccess/></Sequence>");
    click(0);
    QTest::keyClick(&canvas(), Qt::Key_Insert);
    QTRY_VERIFY(palette().search().hasFocus());
    QTest::keyClicks(&palette().search(), text("reac"));
    QVERIFY2(firstRow().startsWith(text("Reactive")), qPrintable(firstRow()));
    const QTreeWidgetItem* first = palette().list().currentItem();
    QCOMPARE(palette().list().itemAbove(first), first->parent());  // The first row of the list.
    QCOMPARE(palette().list().itemAbove(first->parent()), nullptr);
    QVERIFY(palette().list().itemBelow(first)->text(0).startsWith(text("Reactive")));
    quiet::shoot(*window_, "studio_search");
    QTest::keyClick(&palette().search(), Qt::Key_Down);
    const QString second = firstRow();
    QVERIFY(second != first->text(0));
    QTest::keyClick(&palette().search(), Qt::Key_Return);
    QCOMPARE(QString::fromStdString(graph().node(canvas().chosen()).node->id), second);
    QTest::keyClicks(&palette().search(), text("stopmov"));  // Replaces the text.
    QCOMPARE(firstRow(), text("StopMovement"));
    QTest::keyClick(&palette().search(), Qt::Key_Escape);
    QVERIFY(canvas().hasFocus());
    palette().search().clear();
    QCOMPARE(palette().list().topLevelItem(0)->text(0), text("Control"));  // The usual order.
    QVERIFY(palette().list().currentItem() == nullptr);
  }

  void search_besideTheMap_keepsTheKeyboard() {
    window_->docks().toggleOf(*window_->docks().dock(text("tree")))->trigger();
    QTRY_VERIFY(studio().isVisible());
    document().setSelection({person("Chloe")});
    click(0);
    const int before = rootChildren().size();
    QTest::keyClick(&canvas(), Qt::Key_Insert);
    addByKeys("stopmov");
    QVERIFY(palette().search().hasFocus());
    addByKeys("alwayss");
    QCOMPARE(rootChildren().size(), before + 2);
  }

  void ports_doubleClicked_areEditedInTheNode() {
    open("Chloe");
    const int node = called("IsRobotVisible");
    const QString before = portOf(node, "distance");
    const int steps = undoSteps();
    doubleClick(node);
    QVERIFY(fields().isVisible());
    const QRect there(fields().mapTo(window_.get(), QPoint()), fields().size());
    QVERIFY(there.contains(canvas().mapTo(window_.get(), canvas().centreOf(node))));
    quiet::shoot(*window_, "studio_ports");
    auto* first = fields().field("agent_id");
    QVERIFY(first->hasFocus());
    QTest::keyClick(first, Qt::Key_Tab);
    auto* distance = fields().field("distance");
    QVERIFY(!first->hasFocus());
    distance->setFocus();
    type(*distance, "7.5");
    QCOMPARE(undoSteps(), steps);  // Nothing yet.
    QTest::keyClick(distance, Qt::Key_Return);
    QVERIFY(!fields().isVisible());
    QVERIFY(canvas().hasFocus());
    QCOMPARE(undoSteps(), steps + 1);
    QCOMPARE(portOf(node, "distance"), text("7.5"));
    document().undoStack().undo();
    QCOMPARE(portOf(node, "distance"), before);
  }

  void ports_enterAndTabAndEscape_byKeysOnly() {
    open("Chloe");
    const int node = called("IsRobotVisible");
    click(node);
    const int steps = undoSteps();
    QTest::keyClick(&canvas(), Qt::Key_Return);
    QVERIFY(fields().isVisible());
    auto* name = fields().field({});
    QTest::keyClick(fields().field("agent_id"), Qt::Key_Backtab);
    QVERIFY(name->hasFocus());
    QTest::keyClicks(name, text("See it"));
    QTest::keyClick(name, Qt::Key_Backtab);  // To the last one.
    QVERIFY(!name->hasFocus() && !fields().field("agent_id")->hasFocus());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QVERIFY(name->hasFocus());
    QTest::keyClick(name, Qt::Key_Escape);  // Gives up all of it.
    QVERIFY(!fields().isVisible());
    QCOMPARE(undoSteps(), steps);
    QTest::keyClick(&canvas(), Qt::Key_Return);
    QCOMPARE(fields().field({})->text(), QString());
    type(*fields().field({}), "See it");
    type(*fields().field("distance"), "abc");
    QTest::keyClick(fields().field("distance"), Qt::Key_Return);  // Not a number: stays open.
    QVERIFY(fields().isVisible());
    QCOMPARE(undoSteps(), steps);
    type(*fields().field("distance"), "{reach}");  // A blackboard entry.
    QTest::keyClick(fields().field("distance"), Qt::Key_Return);
    QCOMPARE(undoSteps(), steps + 1);  // Name and port together.
    QCOMPARE(called("See it"), node);
    QCOMPARE(portOf(node, "distance"), text("{reach}"));
    QVERIFY(editor::nodeDetail(*graph().node(node).node).startsWith(text("IsRobotVisible")));
  }

  void ports_clickElsewhere_applies() {
    open("Chloe");
    const int node = called("IsRobotVisible");
    doubleClick(node);
    type(*fields().field("distance"), "3");
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, QPoint(3, canvas().height() - 3));
    QVERIFY(!fields().isVisible());
    QCOMPARE(portOf(node, "distance"), text("3"));
    doubleClick(node);
    type(*fields().field("distance"), "4");
    document().setSelection({person("Ana")});  // The value belongs to Chloe.
    QVERIFY(!fields().isVisible());
    document().setSelection({person("Chloe")});
    QCOMPARE(portOf(called("IsRobotVisible"), "distance"), text("4"));
  }

  void renamedNode_tellsItsType() {
    bt::NodeSpec node = editor::defaultNode("IsRobotVisible");
    node.ports = {{"agent_id", "{id}"}, {"distance", "5"}};
    QCOMPARE(editor::nodeDetail(node), text("5 m"));
    node.name = "See it";
    QCOMPARE(editor::nodeDetail(node), text("IsRobotVisible · 5 m"));
    node.ports.clear();
    QCOMPARE(editor::nodeDetail(node), text("IsRobotVisible"));
  }

  /// From nothing: 1 menu entry, then names and Enter, ports by Enter, all without the mouse.
  void newTree_isBuiltByKeysAlone() {
    open("Chloe");
    QMenu menu;
    studio().fillMenu(menu, -1);
    entry(menu, text("New tree"))->trigger();
    QCOMPARE(graph().nodes().size(), std::size_t{1});
    QTRY_VERIFY(palette().search().hasFocus());
    addByKeys("ReactiveF");  // Below the root.
    addByKeys("isrobotv");   // Below it.
    addByKeys("stopmov");    // After the condition.
    QTest::keyClick(&palette().search(), Qt::Key_Escape);
    QTest::keyClick(&canvas(), Qt::Key_Up);
    QTest::keyClick(&canvas(), Qt::Key_Up);
    QTest::keyClick(&canvas(), Qt::Key_Insert);
    addByKeys("regularnav");
    QTest::keyClick(&palette().search(), Qt::Key_Escape);
    QTest::keyClick(&canvas(), Qt::Key_Return);  // Its ports.
    QVERIFY(fields().isVisible());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QCOMPARE(rootChildren(), QStringList({text("ReactiveFallback"), text("RegularNav")}));
    const std::vector<int> below = graph().childrenOf(1);
    QCOMPARE(below.size(), std::size_t{2});
    QVERIFY2(studio().problem().isEmpty(), qPrintable(studio().problem()));
    runner().stepOnce();
    QTRY_VERIFY(runner().newestFrame() != nullptr);  // It runs.
    runner().reset();
  }

  void runningNodes_areListedWithTheirTimes() {
    open("Chloe");
    giveTree("Chloe",
             "<Sequence name='Top'><AlwaysSuccess/><Delay delay_msec='60000'><AlwaysSuccess/>"
             "</Delay></Sequence>");
    studio().lower().setCurrentWidget(&studio().running());
    QVERIFY(studio().running().table().isHidden());
    QVERIFY(studio().running().placeholder().contains(text("Space")));
    for (std::int64_t step = 1; step <= 41; ++step) {
      runner().stepOnce();
      QTRY_VERIFY(runner().newestFrame() != nullptr && runner().newestFrame()->step >= step);
    }
    QTableWidget& table = studio().running().table();
    QTRY_COMPARE(table.rowCount(), 2);
    QCOMPARE(runner().recording()->header()->dt, 0.05);
    QCOMPARE(table.item(0, 0)->text(), text("Top"));
    QCOMPARE(table.item(1, 0)->text(), text("Delay"));
    QVERIFY(!table.item(0, 0)->font().bold() && table.item(1, 0)->font().weight() > QFont::Normal);
    QTRY_COMPARE(table.item(1, 2)->text(), text("2.0 s"));  // Since step 1.
    quiet::shoot(*window_, "studio_running");
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                      table.visualItemRect(table.item(1, 0)).center());
    QCOMPARE(canvas().chosen(), called("Delay"));
    runner().reset();
    QTRY_VERIFY(table.isHidden());
  }

  void picture_fromTheMenu_isAVectorFileOfTheWholeTree() {
    QTemporaryDir folder;
    open("Chloe");
    QMenu menu;
    studio().fillMenu(menu, -1);
    const QString path = folder.filePath(text("tree.svg"));
    quiet::answerDialog<QFileDialog>([&path](QFileDialog& dialog) {
      dialog.selectFile(path);
      dialog.findChild<QLineEdit*>(text("fileNameEdit"))->setText(path);
      QMetaObject::invokeMethod(&dialog, "accept");
    });
    entry(menu, text("Save picture…"))->trigger();
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray svg = file.readAll();
    QVERIFY(svg.contains("<svg") && !svg.contains("<image"));
    QVERIFY(graph().isFolded(called("RegularNavTree")));  // Here, but not in the picture.
    QVERIFY(svg.contains("UpdateGoal"));
    QVERIFY(svg.contains("IsRobotVisible"));
  }

  void picture_withoutNodes_isAnError() {
    const base::Result<std::string> none = app::treePictureBytes(bt::TreeTable(), "a.svg");
    QVERIFY(!none);
    QCOMPARE(none.diagnostics().front().code, std::string_view("trees.nothing-to-draw"));
  }

  /// The second lines of nodes reach 4.5 : 1 as they are drawn, also in a small dock.
  void secondLines_areReadable_data() {
    QTest::addColumn<bool>("isDark");
    QTest::addColumn<double>("zoom");
    for (const double zoom : {1.0, 0.8, 0.6}) {
      QTest::addRow("light %.1f", zoom) << false << zoom;
      QTest::addRow("dark %.1f", zoom) << true << zoom;
    }
  }

  void secondLines_areReadable() {
    QFETCH(bool, isDark);
    QFETCH(double, zoom);
    open("Chloe");
    window_->setTheme(isDark ? editor::Theme::dark() : editor::Theme::light());
    canvas().zoomBy(zoom / canvas().zoom(), QPointF(canvas().rect().center()));
    QTest::mouseMove(&canvas(), QPoint(2, canvas().height() - 2));
    const QImage image = canvas().grab().toImage();
    int checked = 0;
    for (const int node : graph().shown()) {
      const QRect place = canvas().placeOf(node);
      const int sign = static_cast<int>(24 * zoom);  // At the right end.
      const QRect line(place.left() + static_cast<int>(8 * zoom), place.center().y() + 2,
                       place.width() - static_cast<int>(16 * zoom) - sign, place.height() / 2 - 5);
      if (canvas().rect().contains(line)) {
        const double contrast = bestContrast(image, line, graphColor(isDark));
        QVERIFY2(contrast >= 4.5,
                 qPrintable(QStringLiteral("node %1: %2").arg(node).arg(contrast)));
        ++checked;
      }
    }
    QVERIFY(checked > 3);
    window_->setTheme(editor::Theme::light());
  }

 private:
  static QColor graphColor(bool isDark) {
    return (isDark ? editor::Theme::dark() : editor::Theme::light()).color(editor::Role::Panel);
  }
  static double luminance(const QColor& color) {  // WCAG 2.1
    const auto linear = [](double channel) {
      return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
           0.0722 * linear(color.blueF());
  }
  /// Of the pixel that differs most from the ground: the core of a stroke.
  static double bestContrast(const QImage& image, const QRect& where, const QColor& ground) {
    double best = 1.0;
    for (int y = where.top(); y <= where.bottom(); ++y) {
      for (int x = where.left(); x <= where.right(); ++x) {
        const double a = luminance(image.pixelColor(x, y)), b = luminance(ground);
        best = std::max(best, (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05));
      }
    }
    return best;
  }
  void addByKeysAt(int node, const char* words) {
    click(node);
    QTest::keyClick(&canvas(), Qt::Key_Insert);
    addByKeys(words);
    QTest::keyClick(&palette().search(), Qt::Key_Escape);
  }
};

QTEST_MAIN(TreeStudioTest)
#include "tst_TreeStudio.moc"
