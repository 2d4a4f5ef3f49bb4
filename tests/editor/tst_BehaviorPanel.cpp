#include <QtTest>

#include "SmallScenario.h"
#include "bt/human/BehaviorBlocks.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PersonTree.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/RowDelegate.h"
#include "editor/panels/behavior/BehaviorDialogs.h"
#include "editor/panels/behavior/BehaviorPanel.h"
#include "editor/run/SimulationRunner.h"
#include "sim2d/base/Text.h"
#include "tests/support/Widgets.h"

using editor::BehaviorPanel;
using editor::EntityId;
using editor::ScenarioDocument;

class BehaviorPanelTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<ScenarioDocument> document_;
  std::unique_ptr<editor::SimulationRunner> runner_;
  std::unique_ptr<BehaviorPanel> panel_;

  const sim2d::Human& human(int index) const {
    return document_->scenario().humans[static_cast<std::size_t>(index)];
  }
  void select(int index) { document_->setSelection({human(index).key}); }
  int nodeCalled(const QString& title) const {
    const std::vector<editor::OutlineNode>& nodes = panel_->outline().nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (editor::nodeTitle(*nodes[i].node) == title) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }
  void clickNode(const QString& title) {
    const int node = nodeCalled(title);
    QVERIFY2(node >= 0, qPrintable(title));
    editor::TreeOutline& tree = panel_->outline();
    QTreeWidgetItemIterator each(&tree);
    for (int i = 0; i < node; ++i) {
      ++each;
    }
    tree.scrollToItem(*each);
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, tree.visualItemRect(*each).center());
  }
  template <class Widget>
  Widget* named(const QString& name) const {
    return widgets::findIf<Widget>(*panel_, [&](const Widget* each) {
      return each->accessibleName() == name && each->isVisible();
    });
  }
  void type(QWidget* field, const QString& text) {
    QVERIFY(field != nullptr);
    field->setFocus();
    static_cast<QAbstractSpinBox*>(field)->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
  }
  bt::TreeFile fileOf(int index) const {
    return editor::personTree(*document_, human(index).key).file;
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    document_ = std::make_unique<ScenarioDocument>();
    document_->load(small::scenario());
    document_->setMap(small::room());
    runner_ = std::make_unique<editor::SimulationRunner>();
    runner_->setRequest([this] { return editor::runRequestOf(*document_); });
    panel_ = std::make_unique<BehaviorPanel>(*document_, *runner_, editor::Theme::light(),
                                             [] { return QString(); });
    panel_->resize(320, 640);
    panel_->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
  }
  void cleanup() {
    panel_.reset();
    runner_.reset();
    document_.reset();
  }

  /// As in the palette, in problems and in the XML.
  void title_isTheNameOrTheType() {
    bt::NodeSpec node;
    node.id = "RunOnce";
    QCOMPARE(editor::nodeTitle(node), QStringLiteral("RunOnce"));
    QCOMPARE(editor::nodeKindText(node), QString());
    node.name = "Greet";
    QCOMPARE(editor::nodeTitle(node), QStringLiteral("Greet"));
    QCOMPARE(editor::nodeKindText(node), QStringLiteral("RunOnce"));
  }

  /// Between the change and the panel's own.
  void links_personIsGone_doNothing() {
    select(0);
    const EntityId person = human(0).key;
    const std::string before = document_->treeToRun(human(1).key).value_or("");
    const int steps = document_->undoStack().count();
    QStringList clicked;
    const ScenarioDocument::Step step(*document_);
    document_->exchange(person, {});
    QVERIFY(document_->human(person) == nullptr);
    for (auto* link : panel_->findChildren<QToolButton*>()) {
      if (link->isVisible() && link->isEnabled() && !link->accessibleName().isEmpty()) {
        link->click();
        clicked << link->accessibleName();
      }
    }
    QVERIFY2(clicked.contains(QStringLiteral("Save the tree to a file")),
             qPrintable(clicked.join(QLatin1Char(';'))));
    QCOMPARE(document_->undoStack().count(), steps);
    QVERIFY(QApplication::activeModalWidget() == nullptr);
    QCOMPARE(document_->treeToRun(human(0).key).value_or(""), before);
  }

  void outline_namedControls_showTheirType() {
    select(2);  // a curious one, whose tree has a control with a name
    QStringList kinds;
    QTreeWidgetItemIterator each(&panel_->outline());
    for (; *each != nullptr; ++each) {
      kinds << (*each)->data(0, editor::kSideTextRole).toString();
    }
    QVERIFY2(kinds.contains(QStringLiteral("Sequence")), qPrintable(kinds.join(QLatin1Char(';'))));
  }

  void outline_anyHeight_showsWholeRows() {
    select(0);
    for (const int height : {640, 647, 661}) {
      panel_->resize(320, height);
      const QRect row = panel_->outline().visualItemRect(panel_->outline().topLevelItem(0));
      QCOMPARE(panel_->outline().viewport()->height() % row.height(), 0);
    }
  }

  void person_selected_showsTheMadeTree() {
    select(2);  // Chloe, curious
    QCOMPARE(panel_->outline().topLevelItemCount(), 1);
    QCOMPARE(panel_->outline().topLevelItem(0)->text(0), QStringLiteral("CuriousFallback"));
    QVERIFY(nodeCalled(QStringLiteral("ApproachRobot")) > 0);
    QVERIFY(nodeCalled(QStringLiteral("UpdateGoal")) > 0);  // of the included tree
    QVERIFY(!document_->tree(human(2).key));
    select(4);  // Farid, scared: another person, another tree
    QCOMPARE(panel_->person(), human(4).key);
    QVERIFY(panel_->outline().topLevelItem(0)->text(0) != QStringLiteral("CuriousFallback"));
    document_->setSelection({});
    QVERIFY(!panel_->person());
  }

  void port_typed_makesAnOwnTreeAndUndoes() {
    select(2);
    clickNode(QStringLiteral("IsRobotVisible"));
    type(named<editor::NumberField>(QStringLiteral("distance")), QStringLiteral("7.5"));
    QVERIFY(document_->tree(human(2).key));
    const bt::TreeFile file = fileOf(2);
    const bt::NodeSpec& reaction = file.trees[0].root.children[1];
    QCOMPARE(*bt::findAttribute(reaction.children[0].ports, "distance"), std::string("7.5"));
    document_->undoStack().undo();
    QVERIFY(!document_->tree(human(2).key));
  }

  void port_constantAndEntry_becomeEachOther() {
    select(2);
    clickNode(QStringLiteral("IsRobotVisible"));
    const auto distance = [this] {
      const bt::TreeFile file = fileOf(2);
      const auto& ports = file.trees[0].root.children[1].children[0].ports;
      return *bt::findAttribute(ports, "distance");
    };
    const std::string before = distance();
    QVERIFY(named<editor::TextField>(QStringLiteral("distance")) == nullptr);
    QStringList words;
    const auto press = [&](const QString& tip) {
      auto* button = widgets::findIf<QToolButton>(*panel_, [&](const QToolButton* each) {
        return each->isVisible() && each->toolTip().startsWith(tip);
      });
      if (button != nullptr) {
        words << button->text();
        QTest::mouseClick(button, Qt::LeftButton);
      }
      return button != nullptr;
    };
    QVERIFY(press(QStringLiteral("Read distance from a blackboard entry")));
    QCOMPARE(distance(), std::string("{distance}"));
    QTRY_VERIFY(named<editor::TextField>(QStringLiteral("distance")) != nullptr);
    QVERIFY(press(QStringLiteral("Enter distance as a number")));
    QCOMPARE(words, QStringList({QStringLiteral("Use entry"), QStringLiteral("Use number")}));
    QVERIFY(base::parseDouble(distance()).has_value());
    document_->undoStack().undo();
    document_->undoStack().undo();
    QCOMPARE(distance(), before);
  }

  void port_ofAnIncludedTree_cannotBeEdited() {
    select(2);
    clickNode(QStringLiteral("UpdateGoal"));
    const auto* field = named<editor::TextField>(QStringLiteral("agent_id"));
    QVERIFY(field != nullptr);
    QVERIFY(!field->isEnabled());
  }

  void blockDialog_addsToSeveralPeopleInOneStep() {
    document_->setSelection({human(0).key, human(2).key});
    editor::BlockDialog dialog(*document_, editor::Theme::light());
    dialog.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog));
    QListWidget& kinds = dialog.kinds();
    QTest::mouseClick(kinds.viewport(), Qt::LeftButton, {},
                      kinds.visualItemRect(kinds.item(8)).center());
    dialog.accept();
    for (const int person : {0, 2}) {
      const bt::TreeFile file = fileOf(person);
      const std::vector<bt::Block> blocks = bt::blocksOf(file.trees[0]);
      QCOMPARE(blocks.size(), std::size_t(1));
      QCOMPARE(blocks[0].id, std::string("GreetingInitiator"));
    }
    QVERIFY(!document_->tree(human(1).key));
    QCOMPARE(document_->undoStack().count(), 1);
    document_->undoStack().undo();
    QVERIFY(!document_->tree(human(0).key));
    QVERIFY(!document_->tree(human(2).key));
  }

  void block_chosen_isEditedOrderedAndRemoved() {
    select(2);
    editor::pushAddBlock(*document_, {human(2).key}, {"GreetingInitiator", {}});
    editor::pushAddBlock(*document_, {human(2).key}, {"RobotAvoidance", {}});
    clickNode(QStringLiteral("RobotAvoidanceBlock"));
    type(named<editor::NumberField>(QStringLiteral("Stops within")), QStringLiteral("3.25"));
    const auto blocks = [this] {
      const bt::TreeFile file = fileOf(2);
      return bt::blocksOf(file.trees[0]);
    };
    QCOMPARE(blocks()[1].value("stop"), std::string("3.25"));
    QTest::mouseClick(named<QToolButton>(QStringLiteral("Move before the block above")),
                      Qt::LeftButton);
    QCOMPARE(blocks()[0].id, std::string("RobotAvoidance"));
    QTest::mouseClick(named<QToolButton>(QStringLiteral("Remove the block")), Qt::LeftButton);
    QCOMPARE(blocks().size(), std::size_t(1));
    clickNode(QStringLiteral("GreetingInitiatorBlock"));
    QTest::mouseClick(named<QToolButton>(QStringLiteral("Remove the block")), Qt::LeftButton);
    QVERIFY(!document_->tree(human(2).key));  // it is what behaviour and goals make again
  }

  void treeWithBlocks_followsBehaviourAndGoals() {
    editor::pushAddBlock(*document_, {human(2).key}, {"GreetingInitiator", {}});
    editor::pushRoute(*document_, {human(2).key}, {3});
    QVERIFY(editor::personTree(*document_, human(2).key).isGeneratedWithBlocks);
    editor::pushChange<sim2d::Human>(
        *document_, human(2).key, QStringLiteral("Scared"),
        [](sim2d::Human& person) { person.behavior.type = sim2d::BehaviorType::Scared; });
    const bt::TreeFile file = fileOf(2);
    QCOMPARE(file.mainTree, std::string("ScaredNavTree"));
    QCOMPARE(bt::blocksOf(file.trees[0]).size(), std::size_t(1));
    document_->undoStack().undo();
    document_->undoStack().undo();
    QCOMPARE(human(2).goals, (std::vector<int>{2, 1, 3}));
    QCOMPARE(fileOf(2).mainTree, std::string("CuriousNavTree"));
    QVERIFY(editor::personTree(*document_, human(2).key).isGeneratedWithBlocks);
  }

  void ownTree_withOtherGoals_takesTheRoute() {
    select(2);
    clickNode(QStringLiteral("IsRobotVisible"));
    type(named<editor::NumberField>(QStringLiteral("distance")), QStringLiteral("7.5"));
    editor::pushRoute(*document_, {human(2).key}, {3});
    QVERIFY(editor::personTree(*document_, human(2).key).hasDifferentGoals);
    QTest::mouseClick(named<QToolButton>(QStringLiteral("Copy route to tree")), Qt::LeftButton);
    QVERIFY(!editor::personTree(*document_, human(2).key).hasDifferentGoals);
  }

  void template_taken_isOneStep() {
    select(2);
    clickNode(QStringLiteral("IsRobotVisible"));
    type(named<editor::NumberField>(QStringLiteral("distance")), QStringLiteral("7.5"));
    const int steps = document_->undoStack().count();
    panel_->applyTemplate(sim2d::BehaviorType::Threatening);
    QVERIFY(!document_->tree(human(2).key));
    QCOMPARE(fileOf(2).mainTree, std::string("ThreateningNavTree"));
    QCOMPARE(document_->undoStack().count(), steps + 1);
    document_->undoStack().undo();
    QVERIFY(document_->tree(human(2).key));
    QCOMPARE(human(2).behavior.type, std::optional(sim2d::BehaviorType::Curious));
  }

  void tree_savedAndTaken_isTheSame() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("own.xml"));
    select(2);
    QVERIFY(panel_->saveTreeTo(path, panel_->person()).empty());
    QVERIFY(QFile::exists(folder.filePath(QStringLiteral("BTRegularNav.xml"))));
    select(0);
    QVERIFY(!base::hasErrors(panel_->loadTreeFrom(path, panel_->person())));
    QCOMPARE(fileOf(0).mainTree, std::string("CuriousNavTree"));
    QFile broken(path);
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("<root");
    broken.close();
    QVERIFY(base::hasErrors(panel_->loadTreeFrom(path, panel_->person())));
    QCOMPARE(fileOf(0).mainTree, std::string("CuriousNavTree"));
  }

  void blackboard_afterAnotherTheme_hasItsColours() {
    select(0);
    runner_->stepOnce();
    const QTableWidget& entries = panel_->entries();
    QTRY_VERIFY(entries.rowCount() > 0 && !entries.isHidden());
    for (const bool isDark : {true, false}) {
      const editor::Theme theme(isDark);
      panel_->setTheme(theme);
      for (int row = 0; row < entries.rowCount(); ++row) {
        QCOMPARE(entries.item(row, 0)->foreground().color(),
                 theme.color(editor::Role::TextSecondary));
      }
    }
  }

  void run_marksWhatEachNodeReturned() {
    select(0);  // Ana walks to goal 1
    QCOMPARE(panel_->outline().statusOf(0), base::NodeStatus::Idle);
    for (int i = 0; i < 10; ++i) {
      runner_->stepOnce();
    }
    QTRY_VERIFY(runner_->newestFrame() && runner_->newestFrame()->step >= 10);
    QTRY_VERIFY(panel_->outline().statusOf(nodeCalled(QStringLiteral("RegularNav"))) ==
                base::NodeStatus::Success);
    QCOMPARE(panel_->outline().statusOf(nodeCalled(QStringLiteral("IsGoalReached"))),
             base::NodeStatus::Failure);
    runner_->seek(0);
    QTRY_VERIFY(runner_->shownFrame()->step == 0);
    QCOMPARE(panel_->outline().statusOf(nodeCalled(QStringLiteral("RegularNav"))),
             base::NodeStatus::Idle);
    runner_->reset();
    QCOMPARE(panel_->outline().statusOf(nodeCalled(QStringLiteral("RegularNav"))),
             base::NodeStatus::Idle);
  }
};

QTEST_MAIN(BehaviorPanelTest)
#include "tst_BehaviorPanel.moc"
