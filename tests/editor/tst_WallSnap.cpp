#include <QtTest>

#include "CanvasTester.h"
#include "editor/canvas/Tool.h"

using namespace editor;

namespace {

/// Free above the diagonal, wall below: an edge in steps of one cell.
sim2d::OccupancyGrid stairs(const Pose2& origin) {
  constexpr int kSide = 40;
  std::vector<std::int8_t> cells(static_cast<std::size_t>(kSide) * kSide, 0);
  for (int row = 0; row < kSide; ++row) {
    for (int column = row + 1; column < kSide; ++column) {
      const int cell = row * kSide + column;
      cells[static_cast<std::size_t>(cell)] = 100;
    }
  }
  return {kSide, kSide, 0.1, origin, std::move(cells)};
}

}  // namespace

/// What is drawn lies on the walls of the map.
class WallSnapTest : public QObject, private CanvasTester {
  Q_OBJECT

 private Q_SLOTS:
  void init() { start(small::scenario()); }

  void nearestOnWalls_ofTheRoom_data() {
    QTest::addColumn<QPointF>("from");
    QTest::addColumn<bool>("isFound");
    QTest::addColumn<QPointF>("expected");
    QTest::newRow("edge from the free side") << QPointF(5.83, 2.0) << true << QPointF(5.9, 2.0);
    QTest::newRow("edge from within") << QPointF(5.95, 2.0) << true << QPointF(5.9, 2.0);
    QTest::newRow("corner") << QPointF(5.86, 3.55) << true << QPointF(5.9, 3.5);
    QTest::newRow("corner before a nearer edge")
        << QPointF(5.89, 3.42) << true << QPointF(5.9, 3.5);
    QTest::newRow("corner of the room") << QPointF(0.25, 0.25) << true << QPointF(0.2, 0.2);
    QTest::newRow("nothing near") << QPointF(3.0, 3.0) << false << QPointF();
    QTest::newRow("too far") << QPointF(5.75, 2.0) << false << QPointF();
    QTest::newRow("off the map") << QPointF(-40.0, 90.0) << false << QPointF();
  }
  void nearestOnWalls_ofTheRoom() {
    QFETCH(QPointF, from);
    QFETCH(bool, isFound);
    QFETCH(QPointF, expected);
    const auto found = nearestOnWalls(*small::room(), {from.x(), from.y()}, 0.1);
    QCOMPARE(found.has_value(), isFound);
    QVERIFY(!isFound || isNear(*found, {expected.x(), expected.y()}, 1e-9));
  }

  void nearestOnWalls_slantedWall_hasNoCorners() {
    const Pose2 origin{Vec2(3.0, -2.0), 0.5};
    const sim2d::OccupancyGrid grid = stairs(origin);
    const auto found = nearestOnWalls(grid, grid.cornerToWorld(10.9, 10.5), 0.3);
    QVERIFY(found && isNear(*found, grid.cornerToWorld(11.0, 10.5), 1e-9));
  }

  void nearestOnWalls_openPlane_isNone() {
    QVERIFY(!nearestOnWalls(sim2d::OccupancyGrid(), {0.0, 0.0}, 5.0));
  }

  void door_drawnNearTheGap_liesOnItsCorners() {
    use("Door");
    drag({5.84, 3.46}, {5.86, 5.54});
    QCOMPARE(document_.undoStack().count(), 1);
    const sim2d::Door& door = document_.scenario().doors.back();
    QVERIFY(isNear(door.from, {5.9, 3.5}, 1e-9));
    QVERIFY(isNear(door.to, {5.9, 5.5}, 1e-9));
  }

  void door_withAltOrSwitchedOff_liesWhereTheMouseIs() {
    use("Door");
    press({5.84, 3.46}, Qt::AltModifier);
    move({5.84, 4.5});
    release({5.84, 5.54}, Qt::AltModifier);
    CanvasOptions options;
    options.snapToWalls = false;
    scene_.setOptions(options);
    drag({5.84, 3.46}, {5.84, 5.54});
    QCOMPARE(document_.undoStack().count(), 2);
    const std::vector<sim2d::Door>& doors = document_.scenario().doors;
    for (std::size_t i = doors.size() - 2; i < doors.size(); ++i) {
      QVERIFY(isNear(doors[i].from, {5.84, 3.46}));
      QVERIFY(std::abs(doors[i].from.x() - 5.9) > 0.03);
    }
  }

  void personAndGoal_nearAWall_areNotPulledOntoIt() {
    use("Goal");
    click({5.80, 2.0});
    use("Select");
    drag({2.0, 2.0}, {5.82, 1.0});
    const double goal = document_.scenario().goals.back().position.x();
    const double person = document_.scenario().humans.front().initPose.position.x();
    QVERIFY2(std::abs(goal - 5.80) < 0.03, qPrintable(QString::number(goal)));
    QVERIFY2(std::abs(person - 5.82) < 0.03, qPrintable(QString::number(person)));
  }
};

QTEST_MAIN(WallSnapTest)
#include "tst_WallSnap.moc"
