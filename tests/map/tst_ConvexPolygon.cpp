#include <cmath>

#include <QtTest>

#include "sim2d/map/Outlines.h"
#include "sim2d/map/PathPlanner.h"

using namespace sim2d;

namespace {

const std::vector<Vec2> kSquare = {Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(1.0, 1.0), Vec2(0.0, 1.0)};

/// A wall across x = 5 with doors of 1 m about y = 0 and y = `second`, in a room.
std::shared_ptr<const DistanceField> twoDoors(double second) {
  Obstacles obstacles;
  for (const std::vector<Vec2>& line : std::vector<std::vector<Vec2>>{
           {Vec2(5.0, -3.0), Vec2(5.0, -0.5)},
           {Vec2(5.0, 0.5), Vec2(5.0, second - 0.5)},
           {Vec2(5.0, second + 0.5), Vec2(5.0, 9.0)},
           {Vec2(0.0, -3.0), Vec2(10.0, -3.0), Vec2(10.0, 9.0), Vec2(0.0, 9.0), Vec2(0.0, -3.0)}}) {
    obstacles.add(wallOutlines(line, 0.1));
  }
  obstacles.build();
  const OccupancyGrid grid(220, 280, 0.05, base::Pose2{Vec2(-0.5, -4.0), 0.0},
                           std::vector<std::int8_t>(std::size_t{220} * 280, 0));
  return std::make_shared<const DistanceField>(grid, obstacles);
}

const std::vector<Vec2> kInFirstDoor = {Vec2(4.4, -0.6), Vec2(5.6, -0.6), Vec2(5.6, 0.6),
                                        Vec2(4.4, 0.6)};

}  // namespace

class ConvexPolygonTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void hull_leavesOutWhatIsInside() {
    const std::vector<Vec2> hull =
        convexHull({Vec2(0.5, 0.5), Vec2(1.0, 1.0), Vec2(0.0, 0.0), Vec2(0.5, 0.0), Vec2(1.0, 0.0),
                    Vec2(0.0, 1.0), Vec2(1.0, 1.0)});
    QCOMPARE(hull, kSquare);
  }

  void entry_isWhereTheLineMeetsTheBorder() {
    const std::optional<PolygonEntry> left = entryPoint(kSquare, Vec2(-1.0, 0.5), Vec2(3.0, 0.5));
    QVERIFY(left && left->edge == 3 && std::fabs(left->share - 0.25) < 1e-12);
    const std::optional<PolygonEntry> top = entryPoint(kSquare, Vec2(0.5, 2.0), Vec2(0.5, 0.5));
    QVERIFY(top && top->edge == 2 && std::fabs(top->share - 2.0 / 3.0) < 1e-12);
  }

  void entry_besideOrTouching_isNone() {
    QVERIFY(!entryPoint(kSquare, Vec2(-1.0, 1.5), Vec2(3.0, 1.5)));
    QVERIFY(!entryPoint(kSquare, Vec2(-1.0, 1.0), Vec2(3.0, 1.0)));   // along an edge
    QVERIFY(!entryPoint(kSquare, Vec2(-1.0, 0.0), Vec2(1.0, 2.0)));   // through a corner
    QVERIFY(!entryPoint(kSquare, Vec2(-1.0, 0.5), Vec2(-0.5, 0.5)));  // ends before
    QVERIFY(!entryPoint(kSquare, Vec2(2.0, 0.5), Vec2(3.0, 0.5)));    // leaves
  }

  void entry_fromInside_isTheNearestEdge() {
    const std::optional<PolygonEntry> entry = entryPoint(kSquare, Vec2(0.5, 0.9), Vec2(3.0, 0.5));
    QVERIFY(entry && entry->share == 0.0);
    QCOMPARE(entry->edge, std::size_t{2});
  }

  void waysRound_areTautOnBothSides() {
    const Vec2 from(-1.0, 0.25);
    const Vec2 to(2.0, 0.5);
    const PathsAround ways = pathsAround(kSquare, from, to);
    QCOMPARE(ways.left, (std::vector<Vec2>{from, Vec2(0.0, 1.0), Vec2(1.0, 1.0), to}));
    QCOMPARE(ways.right, (std::vector<Vec2>{from, Vec2(0.0, 0.0), Vec2(1.0, 0.0), to}));
    QVERIFY(std::fabs(polylineLength(ways.left) - (1.25 + 1.0 + std::sqrt(1.25))) < 1e-12);
  }

  void waysRound_nothingBetween_areEmpty() {
    const PathsAround beside = pathsAround(kSquare, Vec2(-1.0, 2.0), Vec2(2.0, 2.0));
    QVERIFY(beside.left.empty() && beside.right.empty());
    const PathsAround inside = pathsAround(kSquare, Vec2(0.5, 0.5), Vec2(2.0, 0.5));
    QVERIFY(inside.left.empty() && inside.right.empty());
  }

  void planAround_keepsOutOfWhatIsClosed() {
    PathPlanner planner(twoDoors(5.0), 0.3);
    const Vec2 from(1.0, 0.0);
    const Vec2 to(9.0, 0.0);
    QVERIFY(polylineLength(planner.plan(from, to)) < 8.01);
    const std::vector<Vec2> way = planner.planAround(from, to, {kInFirstDoor});
    QVERIFY(way.size() > 2);
    QVERIFY(way.front() == from && way.back() == to);
    for (std::size_t i = 1; i < way.size(); ++i) {
      QVERIFY(!entryPoint(kInFirstDoor, way[i - 1], way[i]));
      QVERIFY(planner.isClear(way[i - 1], way[i]));
    }
    // Straight lines by the inner corners of the other door, for a body of 0.3 m, and up to 1 m
    // more for the room that is wanted.
    const double shortest = 2.0 * Vec2(3.65, 4.8).norm() + 0.7;
    const double length = polylineLength(way);
    QVERIFY2(length > shortest - 0.1 && length < shortest + 1.0, QByteArray::number(length));
  }

  void planAround_onlyWayClosed_isNone() {
    PathPlanner planner(twoDoors(5.0), 0.3);
    const std::vector<Vec2> second = {Vec2(4.4, 4.4), Vec2(5.6, 4.4), Vec2(5.6, 5.6),
                                      Vec2(4.4, 5.6)};
    QVERIFY(planner.planAround(Vec2(1.0, 0.0), Vec2(9.0, 0.0), {kInFirstDoor, second}).empty());
    QVERIFY(planner.planAround(Vec2(1.0, 0.0), Vec2(5.2, 0.0), {kInFirstDoor}).empty());
    QVERIFY(planner.planAround(Vec2(4.8, 0.0), Vec2(9.0, 0.0), {kInFirstDoor}).empty());
  }
};

QTEST_APPLESS_MAIN(ConvexPolygonTest)
#include "tst_ConvexPolygon.moc"
