#include <QtTest>

#include "CanvasTester.h"
#include "editor/canvas/Tool.h"
#include "editor/look/Fields.h"
#include "editor/tools/CrowdTool.h"
#include "editor/tools/ToolManager.h"
#include "sim2d/map/Outlines.h"

using namespace editor;

/// Brush, fill, eraser and measure by real mouse and key events.
class CrowdToolsTest : public QObject, private CanvasTester {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    start({});
    fill().setCount(20);
    fill().setRecipe({});
    brush().setRecipe({});
    brush().setSpacing(1.0);
    brush().setWidth(0.0);
  }

  void brush_drag_laysPeopleAlongIt() {
    use("Brush");
    drag(Vec2(7.0, 2.0), Vec2(11.05, 2.0));
    QCOMPARE(undoCount(), 1);
    const std::vector<sim2d::Human>& people = scenario().humans;
    QCOMPARE(people.size(), std::size_t{5});
    for (std::size_t i = 0; i < people.size(); ++i) {
      QVERIFY(isNear(people[i].initPose.position, Vec2(7.0 + double(i), 2.0), 0.05));
      QVERIFY(std::abs(people[i].initPose.heading) < 0.02);
      QVERIFY(people[i].maxVel && *people[i].maxVel > 0.2);
    }
    QCOMPARE(document_.selection().size(), std::size_t{5});
    checkUndoAndRedo(sim2d::Scenario());
  }

  void brush_click_placesOne() {
    use("Brush");
    click(Vec2(8.0, 2.0));
    QCOMPARE(scenario().humans.size(), std::size_t{1});
    doubleClick(Vec2(10.0, 2.0));  // the second one has no room
    QCOMPARE(scenario().humans.size(), std::size_t{2});
  }

  void brush_overWalls_leavesThemOut() {
    use("Brush");
    drag(Vec2(4.0, 2.0), Vec2(8.0, 2.0));  // through the wall at x = 6
    for (const sim2d::Human& human : scenario().humans) {
      QVERIFY(std::abs(human.initPose.position.x() - 6.0) > 0.1 + *human.radius - 0.01);
    }
    QVERIFY(scenario().humans.size() >= 3);
    QVERIFY(brush().statusText().startsWith(
        QStringLiteral("Space for only %1 of").arg(scenario().humans.size())));
    click(Vec2(6.0, 2.0));  // in the wall
    QCOMPARE(brush().statusText(), QStringLiteral("No space for people here"));
  }

  void brush_escapeOrRightButton_leavesNothing() {
    use("Brush");
    press(Vec2(7.0, 2.0));
    move(Vec2(10.0, 2.0));
    key(Qt::Key_Escape);
    release(Vec2(10.0, 2.0));
    press(Vec2(7.0, 2.0));
    move(Vec2(10.0, 2.0));
    rightClick(Vec2(10.0, 2.0));
    release(Vec2(10.0, 2.0));
    rightClick(Vec2(9.0, 2.0));
    checkUnchanged(sim2d::Scenario());
  }

  void fill_rectangle_holdsTheNumberApartFromEachOther() {
    use("Fill");
    drag(Vec2(6.5, 0.5), Vec2(11.5, 8.5));
    QCOMPARE(undoCount(), 1);
    const std::vector<sim2d::Human>& people = scenario().humans;
    QCOMPARE(people.size(), std::size_t{20});
    for (std::size_t i = 0; i < people.size(); ++i) {
      const bool reacts = *people[i].behavior.type > sim2d::BehaviorType::Impassive;
      QCOMPARE(people[i].behavior.dist.has_value(),
               reacts);  // what HuNavSim wants of them is there
      const Vec2& at = people[i].initPose.position;
      QVERIFY(at.x() > 6.4 && at.x() < 11.6 && at.y() > 0.4 && at.y() < 8.6);
      for (std::size_t k = 0; k < i; ++k) {
        const double apart = (people[k].initPose.position - at).norm();
        QVERIFY(apart > *people[i].radius + *people[k].radius);
      }
    }
    undo();
    QVERIFY(scenario() == sim2d::Scenario());
  }

  void fill_mix_isKept() {
    CrowdRecipe recipe;
    recipe.mix = {0, 0, 0, 100, 0, 0};
    recipe.kind = sim2d::PersonKind::Child;
    fill().setRecipe(recipe);
    use("Fill");
    drag(Vec2(6.5, 0.5), Vec2(11.5, 8.5));
    for (const sim2d::Human& human : scenario().humans) {
      QVERIFY(human.behavior.type == sim2d::BehaviorType::Scared);
      QVERIFY(human.ours.kind == sim2d::PersonKind::Child);
    }
    start({});
    recipe.mix = {50, 50, 0, 0, 0, 0};
    recipe.kind.reset();
    fill().setRecipe(recipe);
    fill().setCount(40);
    use("Fill");
    drag(Vec2(6.5, 0.5), Vec2(11.5, 8.5));
    const std::vector<sim2d::Human>& people = scenario().humans;
    const auto regular = std::count_if(people.begin(), people.end(), [](const sim2d::Human& human) {
      return human.behavior.type == sim2d::BehaviorType::Regular;
    });
    QVERIFY(regular > 10 && regular < 30);  // binomial: outside once in a thousand
  }

  void fill_sameSeed_givesTheSamePeople() {
    use("Fill");
    drag(Vec2(6.5, 0.5), Vec2(11.5, 8.5));
    const sim2d::Scenario first = scenario();
    start({});
    use("Fill");
    drag(Vec2(6.5, 0.5), Vec2(11.5, 8.5));
    QVERIFY(scenario() == first);
    start({});
    CrowdRecipe other;
    other.seed = 2;
    fill().setRecipe(other);
    use("Fill");
    drag(Vec2(6.5, 0.5), Vec2(11.5, 8.5));
    QVERIFY(!(scenario() == first));
  }

  void fill_withoutGoals_addsSomeInTheArea() {
    use("Fill");
    QVERIFY(fill().statusText().contains(QStringLiteral("20 people and 3 goals")));
    drag(Vec2(6.5, 0.5), Vec2(11.5, 8.5));
    QCOMPARE(undoCount(), 1);
    const std::vector<sim2d::GlobalGoal>& goals = scenario().goals;
    QCOMPARE(goals.size(), std::size_t{3});
    for (const sim2d::GlobalGoal& goal : goals) {
      const Vec2& at = goal.position;
      QVERIFY(at.x() > 6.5 && at.x() < 11.5 && at.y() > 0.5 && at.y() < 8.5);
      for (const sim2d::GlobalGoal& other : goals) {
        QVERIFY(other.id == goal.id || (other.position - at).norm() > 2.0);
      }
    }
    for (const sim2d::Human& human : scenario().humans) {
      QCOMPARE(human.goals.size(), std::size_t{3});
    }
    QCOMPARE(document_.selection().size(), std::size_t{20});
    undo();
    QVERIFY(scenario() == sim2d::Scenario());
    CrowdRecipe standing;
    standing.walks = false;
    fill().setRecipe(standing);
    use("Select");
    use("Fill");
    drag(Vec2(6.5, 0.5), Vec2(11.5, 8.5));
    QVERIFY(scenario().goals.empty());
  }

  void fill_tenPeople_haveFiveBehaviours() {
    fill().setCount(10);
    use("Fill");
    drag(Vec2(6.5, 0.5), Vec2(11.5, 8.5));
    std::map<sim2d::BehaviorType, int> counts;
    for (const sim2d::Human& human : scenario().humans) {
      ++counts[*human.behavior.type];
    }
    QCOMPARE(counts.size(), std::size_t{5});
    QCOMPARE(counts[sim2d::BehaviorType::Regular], 6);  // 60 of 100 parts
  }

  void fill_peopleFieldAfterwards_fillsTheSameAreaAgain() {
    ToolOptionsBar bar(tools_, view_);
    use("Fill");
    drag(Vec2(6.5, 0.5), Vec2(11.5, 8.5));
    QCOMPARE(scenario().humans.size(), std::size_t{20});
    typeCount(bar, QStringLiteral("7"));
    QCOMPARE(scenario().humans.size(), std::size_t{7});
    QCOMPARE(scenario().goals.size(), std::size_t{3});
    QCOMPARE(undoCount(), 1);
    typeCount(bar, QStringLiteral("12"));
    QCOMPARE(scenario().humans.size(), std::size_t{12});
    QCOMPARE(document_.selection().size(), std::size_t{12});
    undo();
    QVERIFY(scenario() == sim2d::Scenario());
    typeCount(bar, QStringLiteral("5"));  // the undo was another action
    QVERIFY(scenario() == sim2d::Scenario());
    redo();
    QCOMPARE(scenario().humans.size(), std::size_t{12});
    typeCount(bar, QStringLiteral("6"));
    QCOMPARE(scenario().humans.size(), std::size_t{12});
  }

  void fill_peopleFieldWhileDrawing_changesThePreview() {
    ToolOptionsBar bar(tools_, view_);
    use("Fill");
    for (const Vec2& corner : {Vec2(6.5, 0.5), Vec2(11.5, 0.5), Vec2(11.5, 8.5)}) {
      click(corner);
    }
    QCOMPARE(scene_.marks().dots.size(), std::size_t{20});
    typeCount(bar, QStringLiteral("8"));
    QCOMPARE(scene_.marks().dots.size(), std::size_t{8});
    QVERIFY(scenario() == sim2d::Scenario());
  }

  void fill_goals_becomeRoutes() {
    sim2d::Scenario withGoals;
    withGoals.goals = small::scenario().goals;
    start(withGoals);
    use("Fill");
    drag(Vec2(6.5, 0.5), Vec2(11.5, 8.5));
    for (const sim2d::Human& human : scenario().humans) {
      QCOMPARE(human.goals.size(), std::size_t{3});
      QVERIFY(std::is_permutation(human.goals.begin(), human.goals.end(),
                                  std::vector<int>{1, 2, 3}.begin()));
    }
  }

  void fill_tooLittleRoom_saysHowMany() {
    fill().setCount(50);
    use("Fill");
    drag(Vec2(7.0, 1.0), Vec2(9.0, 2.5));
    const std::size_t made = scenario().humans.size();
    QVERIFY(made > 1 && made < 12);
    QVERIFY(fill().statusText().contains(QString::number(made)));
    QVERIFY(fill().statusText().contains(QStringLiteral("50")));
  }

  void fill_manyMoreThanFit_areToldToo() {
    fill().setCount(std::size_t{editor::kLargestCrowd});
    use("Fill");
    drag(Vec2(7.0, 1.0), Vec2(9.0, 2.5));
    const std::size_t made = scenario().humans.size();
    QVERIFY(made > 1 && made < 30);
    QCOMPARE(fill().statusText(), QStringLiteral("Space for only %1 of 2000 people").arg(made));
  }

  void fill_escapeOrNoSize_leavesNothing() {
    use("Fill");
    press(Vec2(7.0, 1.0));
    move(Vec2(9.0, 3.0));
    key(Qt::Key_Escape);
    release(Vec2(9.0, 3.0));
    click(Vec2(7.0, 1.0));
    click(Vec2(9.0, 1.0));
    key(Qt::Key_Escape);
    doubleClick(Vec2(8.0, 2.0));
    rightClick(Vec2(8.0, 2.0));
    checkUnchanged(sim2d::Scenario());
  }

  void eraser_click_removesTheTopmost() {
    start(small::scenario());
    use("Eraser");
    click(Vec2(2.0, 2.0));  // Ana
    QVERIFY(scenario().human("Ana") == nullptr);
    click(Vec2(1.4, 5.2));  // the area
    QVERIFY(scenario().areas.empty());
    click(Vec2(9.5, 7.5));  // goal 1: routes follow
    QVERIFY(scenario().goal(1) == nullptr);
    for (const sim2d::Human& human : scenario().humans) {
      QVERIFY(std::find(human.goals.begin(), human.goals.end(), 1) == human.goals.end());
    }
    QCOMPARE(undoCount(), 3);
    undo();
    undo();
    undo();
    QVERIFY(scenario() == small::scenario());
  }

  void eraser_sweep_isOneCommandAndSparesAreas() {
    start(small::scenario());
    use("Eraser");
    press(Vec2(1.0, 5.2));  // on the area
    move(Vec2(2.0, 2.0));   // over Ana
    move(Vec2(4.2, 1.4));   // over the table
    release(Vec2(5.4, 1.4));
    QCOMPARE(undoCount(), 1);
    QVERIFY(scenario().human("Ana") == nullptr);
    QCOMPARE(scenario().obstacles.size(), std::size_t{1});
    QCOMPARE(scenario().areas.size(), std::size_t{1});
    checkUndoAndRedo(small::scenario());
  }

  void eraser_escape_keepsAll() {
    start(small::scenario());
    use("Eraser");
    press(Vec2(2.0, 2.0));
    move(Vec2(4.2, 1.4));
    key(Qt::Key_Escape);
    release(Vec2(4.2, 1.4));
    checkUnchanged(small::scenario());
  }

  void eraser_emptyGroundRightButtonDoubleClick_changeNothing() {
    start(small::scenario());
    use("Eraser");
    click(Vec2(11.0, 8.3));
    rightClick(Vec2(2.0, 2.0));
    drag(Vec2(11.0, 8.3), Vec2(11.3, 8.3));
    QVERIFY(scenario() == small::scenario());
    doubleClick(Vec2(2.0, 2.0));  // the first click has removed it already
    QCOMPARE(undoCount(), 1);
  }

  void measure_drag_tellsDistanceAndAngle() {
    start(small::scenario());
    use("Measure");
    drag(Vec2(7.0, 4.0), Vec2(10.0, 8.0));
    QCOMPARE(span().size(), std::size_t{2});
    const Vec2 way = span().back() - span().front();
    QVERIFY(std::abs(way.norm() - 5.0) < 0.05);
    QVERIFY(measureText().contains(QString::number(way.norm(), 'f', 3)));
    QVERIFY(measureText().contains(QString::fromUtf8("53.")));  // atan(4 / 3)
    checkUnchanged(small::scenario());
  }

  void measure_shift_runsInStepsOf15Degrees() {
    use("Measure");
    drag(Vec2(7.0, 4.0), Vec2(10.0, 7.3), Qt::ShiftModifier);
    QCOMPARE(span().size(), std::size_t{2});
    const Vec2 way = span().back() - span().front();
    QVERIFY(std::abs(way.x() - way.y()) < 1e-9);
  }

  void measure_clickOrEscape_showsNothing() {
    use("Measure");
    click(Vec2(7.0, 4.0));
    QVERIFY(span().empty());
    drag(Vec2(7.0, 4.0), Vec2(8.0, 4.0));
    key(Qt::Key_Escape);
    QVERIFY(span().empty());
    doubleClick(Vec2(7.0, 4.0));
    rightClick(Vec2(7.0, 4.0));
    QVERIFY(span().empty());
  }

  void optionsBar_fields_changeTheTool() {
    ToolOptionsBar bar(tools_, view_);
    use("Fill");
    auto* count = bar.findChild<NumberField*>();
    QVERIFY(count != nullptr);
    count->setFocus();
    count->selectAll();
    QTest::keyClicks(count, QStringLiteral("7"));
    QTest::keyClick(count, Qt::Key_Return);
    QCOMPARE(fill().count(), std::size_t{7});
    drag(Vec2(6.5, 0.8), Vec2(11.5, 8.5));
    QCOMPARE(scenario().humans.size(), std::size_t{7});
  }

  /// A drag may start below the bar, except at its fields.
  void optionsBar_dragFromIt_drawsOnTheMap() {
    ToolOptionsBar bar(tools_, view_);
    use("Fill");
    view_.zoomBy(1.4);  // The corner of the map is below the bar.
    const auto* label = bar.findChild<QLabel*>();
    QVERIFY(bar.isVisible() && label != nullptr && label->isVisible());
    for (const QPoint& start :
         {QPoint(3, bar.height() / 2), label->mapTo(&bar, label->rect().center())}) {
      const QPoint from = bar.mapTo(view_.window(), start);
      const QWidget* hit = view_.window()->childAt(from);
      QVERIFY(hit == label || hit == &bar);
      QTest::mouseMove(window(), from);
      QTest::mousePress(window(), Qt::LeftButton, {}, from);
      move(Vec2(4.0, 4.0));
      move(Vec2(5.0, 2.0));
      release(Vec2(5.0, 2.0));
      QVERIFY(!scenario().humans.empty());
      undo();
      QVERIFY(scenario().humans.empty());
    }
    view_.fitAll(false);
  }

 private:
  FillTool& fill() { return *static_cast<FillTool*>(tool("Fill")); }
  BrushTool& brush() { return *static_cast<BrushTool*>(tool("Brush")); }
  void typeCount(ToolOptionsBar& bar, const QString& number) {
    auto* count = bar.findChild<NumberField*>();
    QVERIFY(count != nullptr);
    count->setFocus();
    count->selectAll();
    QTest::keyClicks(count, number);
    QTest::keyClick(count, Qt::Key_Return);
  }
  /// What is measured: from where to where; empty before the first drag.
  const std::vector<Vec2>& span() { return scene_.marks().outline.points; }
  QString measureText() { return tool("Measure")->statusText(); }
};
QTEST_MAIN(CrowdToolsTest)
#include "tst_CrowdTools.moc"
