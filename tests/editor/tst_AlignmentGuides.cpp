#include <QtTest>

#include "CanvasTester.h"
#include "editor/canvas/AlignmentGuides.h"
#include "editor/document/EditCommands.h"

using namespace editor;

/// Alignment of dragged entities: numbers by hand, and real drags.
class AlignmentGuidesTest : public QObject, private CanvasTester {
  Q_OBJECT

 private:
  static Extent box(double left, double bottom, double width, double height) {
    return {Vec2(left, bottom), Vec2(left + width, bottom + height)};
  }
  static Extent point(double x, double y) { return {Vec2(x, y), Vec2(x, y)}; }
  const Vec2& placeOf(int key) { return document_.human(person(key))->initPose.position; }
  /// People at these positions, in this order.
  void startWith(const std::vector<Vec2>& places) {
    sim2d::Scenario scenario;
    for (const Vec2& at : places) {
      const int key = static_cast<int>(scenario.humans.size()) + 1;
      scenario.humans.push_back(small::person(key, qPrintable(QStringLiteral("p%1").arg(key)), at,
                                              0.0, sim2d::BehaviorType::Regular, {}));
    }
    start(scenario);
  }
  Vec2 pixels(double x, double y) { return Vec2(x, y) / view_.pixelsPerMetre(); }

 private Q_SLOTS:
  void edges_withinReach_areAligned() {
    // The left edge is 0.04 m beside that of the other box, which has another width.
    const Alignment aligned = alignmentOf(box(1.04, 5.0, 2.5, 1.0), {box(1.0, 0.0, 1.0, 1.0)}, 0.1);
    QVERIFY(aligned.isAligned[0] && !aligned.isAligned[1]);
    QVERIFY(isNear(aligned.offset, Vec2(-0.04, 0.0), 1e-9));
    QCOMPARE(aligned.lines.size(), std::size_t{1});
    QVERIFY(isNear(aligned.lines[0].first, Vec2(1.0, 0.0), 1e-9));
    QVERIFY(isNear(aligned.lines[0].second, Vec2(1.0, 6.0), 1e-9));
    QCOMPARE(aligned.gaps.size(), std::size_t{1});  // 4 m of free space between them
    QVERIFY(std::abs((aligned.gaps[0].to - aligned.gaps[0].from).norm() - 4.0) < 1e-9);
  }

  void edges_beyondReach_areFree() {
    const Alignment aligned = alignmentOf(box(1.2, 5.0, 2.5, 1.0), {box(1.0, 0.0, 1.0, 1.0)}, 0.1);
    QVERIFY(!aligned.isAligned[0] && !aligned.isAligned[1]);
    QVERIFY(aligned.lines.empty() && aligned.gaps.empty());
    QVERIFY(aligned.offset == Vec2(0.0, 0.0));
  }

  void centreAndEdge_smallestCorrectionWins() {
    // Centre of the moving box at 2.03, edge of the other one at 2.0, its centre at 2.5.
    const Alignment aligned = alignmentOf(box(1.43, 5.0, 1.2, 1.0), {box(2.0, 0.0, 1.0, 1.0)}, 0.1);
    QVERIFY(isNear(aligned.offset, Vec2(-0.03, 0.0), 1e-9));
  }

  void between_twoNeighbours_distancesBecomeEqual() {
    // 1 m wide, between boxes that end at 1 and begin at 6: the gaps become 2 m.
    const Alignment aligned = alignmentOf(box(3.06, 0.3, 1.0, 0.2),
                                          {box(0.0, 0.0, 1.0, 1.0), box(6.0, 0.0, 1.0, 1.0)}, 0.1);
    QVERIFY(aligned.isAligned[0]);
    QVERIFY(std::abs(aligned.offset.x() + 0.06) < 1e-9);
    int equal = 0;
    for (const AlignmentGap& gap : aligned.gaps) {
      equal += std::abs((gap.to - gap.from).norm() - 2.0) < 1e-9 ? 1 : 0;
    }
    QCOMPARE(equal, 2);
  }

  void chain_points_continueTheirDistance() {
    // People at 1 and 2.5 in a row: the next one at 4.
    const Alignment aligned =
        alignmentOf(point(4.05, 2.02), {point(1.0, 2.0), point(2.5, 2.0)}, 0.1);
    QVERIFY(isNear(aligned.offset, Vec2(-0.05, -0.02), 1e-9));
    const Alignment before =
        alignmentOf(point(-0.47, 2.0), {point(1.0, 2.0), point(2.5, 2.0)}, 0.1);
    QVERIFY(isNear(before.offset, Vec2(-0.03, 0.0), 1e-9));
  }

  void drag_nearTheLineOfAnother_alignsAndShowsGuides() {
    startWith({{2.0, 2.0}, {4.0, 6.0}});
    const Vec2 to = Vec2(9.0, 2.0) + pixels(0.0, 4.0);
    press({4.0, 6.0});
    move(0.5 * (Vec2(4.0, 6.0) + to));
    move(to);
    QVERIFY(!scene_.marks().guides.lines.empty());
    QVERIFY(!scene_.marks().guides.gaps.empty());  // the distance of 7 m
    release(to);
    QCOMPARE(placeOf(2).y(), 2.0);
    QVERIFY(isNear(placeOf(2), Vec2(9.0, 2.0), 0.05));
    QVERIFY(scene_.marks().guides.lines.empty());
    QCOMPARE(undoCount(), 1);
  }

  void drag_inARow_keepsEqualDistances() {
    startWith({{1.5, 2.0}, {3.0, 2.0}, {4.5, 6.0}});
    const Vec2 to = Vec2(4.5, 2.0) + pixels(3.0, -4.0);
    drag({4.5, 6.0}, to);
    QVERIFY(isNear(placeOf(3), Vec2(4.5, 2.0), 1e-6));
  }

  void drag_withAlt_isFree() {
    startWith({{2.0, 2.0}, {4.0, 6.0}});
    const Vec2 to = Vec2(9.0, 2.0) + pixels(0.0, 4.0);
    press({4.0, 6.0});
    move(0.5 * (Vec2(4.0, 6.0) + to));
    QMouseEvent event(QEvent::MouseMove, view_.viewportFrom(to), Qt::NoButton, Qt::LeftButton,
                      Qt::AltModifier);
    QCoreApplication::sendEvent(view_.viewport(), &event);
    QVERIFY(scene_.marks().guides.lines.empty());
    release(to, Qt::AltModifier);
    QVERIFY(placeOf(2).y() > 2.01);
  }

  void drag_switchedOff_isFree() {
    startWith({{2.0, 2.0}, {4.0, 6.0}});
    CanvasOptions options = scene_.options();
    QVERIFY(options.guides);  // on by default
    options.guides = false;
    scene_.setOptions(options);
    const Vec2 to = Vec2(9.0, 2.0) + pixels(0.0, 4.0);
    drag({4.0, 6.0}, to);
    QVERIFY(placeOf(2).y() > 2.01);
  }

  void drag_ofASelection_ignoresItsMembers() {
    startWith({{2.0, 2.0}, {4.0, 6.0}, {5.0, 6.0}});
    document_.setSelection({person(2), person(3)});
    const Vec2 to = Vec2(8.0, 3.6);
    drag({4.0, 6.0}, to);
    QVERIFY(isNear(placeOf(2), to, 0.05));
    QVERIFY(isNear(placeOf(3) - placeOf(2), Vec2(1.0, 0.0), 1e-6));
  }

  void goal_dragged_alignsToo() {
    sim2d::Scenario scenario;
    scenario.goals = {small::goal(11, 1, {2.0, 7.0}), small::goal(12, 2, {9.0, 3.0})};
    start(scenario);
    use("Goal");
    const Vec2 tip(9.0, 3.0);
    const Vec2 to = Vec2(9.0, 7.0) + pixels(0.0, 4.0);
    drag(tip, to);
    QCOMPARE(document_.scenario().goal(2)->position.y(), 7.0);
  }

  void boxCorner_dragged_alignsWithTheEdgeOfAnother() {
    sim2d::Scenario scenario = small::scenario();
    scenario.humans.clear();
    scenario.areas.clear();
    start(scenario);
    CanvasOptions options = scene_.options();
    options.snapToPoints = options.snapToWalls = false;
    scene_.setOptions(options);
    sim2d::Area area;
    area.name = "a";
    area.points = {{7.0, 5.0}, {8.0, 5.0}, {8.0, 6.0}, {7.0, 6.0}};
    const EntityId id = pushAdd(document_, area);
    document_.setSelection({id});
    const Vec2 to = Vec2(8.6, 6.5) + pixels(4.0, 0.0);  // the centre of the column is at x = 8.6
    drag({8.0, 6.0}, to);
    const auto points = std::get<sim2d::Area>(*document_.entity(id)).points;
    QCOMPARE(points[2].x(), 8.6);
  }
};

QTEST_MAIN(AlignmentGuidesTest)
#include "tst_AlignmentGuides.moc"
