#include <algorithm>
#include <cmath>
#include <random>

#include <QtTest>

#include "sim2d/map/Obstacles.h"
#include "sim2d/map/PathPlanner.h"

using namespace sim2d;

namespace {

Obstacles blocks(const std::vector<std::vector<Vec2>>& outlines) {
  Obstacles obstacles;
  for (const std::vector<Vec2>& points : outlines) {
    Outline outline;
    outline.points = points;
    obstacles.add({outline});
  }
  obstacles.build();
  return obstacles;
}

std::vector<Vec2> box(double left, double bottom, double right, double top) {
  return {Vec2(left, bottom), Vec2(right, bottom), Vec2(right, top), Vec2(left, top)};
}

}  // namespace

class TautWayTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void way_onFreeGround_isStraight() {
    const std::vector<Vec2> way = tightened({Vec2(0, 0), Vec2(1, 3), Vec2(4, 1), Vec2(5, 0)},
                                            blocks({box(20, 20, 21, 21)}), 0.3);
    QCOMPARE(way.size(), std::size_t{2});
  }

  /// Two tangents and an arc round the corner at the origin.
  void way_roundACorner_isTangentArcTangent() {
    const double radius = 0.5;
    const Vec2 from(-1, -3);
    const Vec2 to(4, 1);
    const std::vector<Vec2> way =
        tightened({from, Vec2(-1, 1), to}, blocks({box(0, -10, 10, 0)}), radius);
    const double round = std::atan2(-3, -1) + 2.0 * base::kPi - std::atan2(1, 4);
    const double arc = round - std::acos(radius / from.norm()) - std::acos(radius / to.norm());
    const double expected = std::sqrt(from.squaredNorm() - radius * radius) + radius * arc +
                            std::sqrt(to.squaredNorm() - radius * radius);
    const double length = polylineLength(way);
    QVERIFY2(std::fabs(length - expected) < 2e-4 * expected,
             qPrintable(QStringLiteral("%1 instead of %2").arg(length).arg(expected)));
    for (std::size_t k = 1; k < way.size(); ++k) {
      for (const auto& [a, b] : {std::pair(Vec2(0, -10), Vec2(0, 0)), {Vec2(0, 0), Vec2(10, 0)}}) {
        QVERIFY(distanceBetween({way[k - 1], way[k]}, {a, b}) >= radius - 1e-5);
      }
    }
  }

  /// Between two posts, a zigzag becomes as short as a point search over a fine grid of headings
  /// cannot beat: the line touches both.
  void way_betweenPosts_touchesBoth() {
    const Obstacles posts = blocks({box(2, -5, 2.2, 0.5), box(4, -0.5, 4.2, 5)});
    const std::vector<Vec2> way = tightened(
        {Vec2(0, 0), Vec2(1, 1.5), Vec2(3, 1.5), Vec2(3.2, -1.5), Vec2(5, -1.5), Vec2(6, 0)}, posts,
        0.0);
    const double expected = Vec2(2, 0.5).norm() + 0.2 + (Vec2(4, -0.5) - Vec2(2.2, 0.5)).norm() +
                            0.2 + (Vec2(6, 0) - Vec2(4.2, -0.5)).norm();
    QVERIFY2(std::fabs(polylineLength(way) - expected) < 2e-4 * expected,
             qPrintable(QString::number(polylineLength(way)) + QLatin1Char(' ') +
                        QString::number(expected)));
  }

  /// Beside a look at every wall, one after the other: slanted blocks, long ones, a door that is
  /// open; ways of no length up to far more than a look's pieces.
  void isWayClear_anyWay_isThatOfAllWalls() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(0.0, 40.0);
    std::uniform_real_distribution<double> turn(-base::kPi, base::kPi);
    std::vector<std::vector<Vec2>> outlines;
    for (int k = 0; k < 60; ++k) {
      const double length = k % 10 == 0 ? 9.0 : 0.7;
      outlines.push_back(
          boxOutline({{place(random), place(random)}, turn(random)}, length, 0.4).points);
    }
    Obstacles obstacles = blocks(outlines);
    obstacles.setEnabled(10, false);
    std::vector<Segment> walls;
    obstacles.segmentsNear(Vec2(20, 20), 1000.0, walls);
    int clear = 0;
    constexpr int kWays = 6000;
    const double reaches[] = {0.0, 0.6, 1.7, 6.0, 30.0, 400.0};
    for (int k = 0; k < kWays; ++k) {
      const Vec2 from(place(random), place(random));
      const Vec2 to = from + reaches[k % 6] * base::directionOf(turn(random));
      const double clearance = k % 3 == 0 ? 0.0 : 0.35;
      const double room = std::max(clearance, 5e-4) - 1e-6;
      const bool expected = std::none_of(walls.begin(), walls.end(), [&](const Segment& wall) {
        return distanceBetween({from, to}, wall) < room;
      });
      QCOMPARE(isSegmentFree(from, to, obstacles, clearance), expected);
      clear += expected ? 1 : 0;
    }
    QVERIFY(clear > kWays / 4 && clear < 3 * kWays / 4);
  }

  void distanceBetween_segments_handCases() {
    QCOMPARE(distanceBetween({Vec2(0, 0), Vec2(2, 0)}, {Vec2(1, -1), Vec2(1, 1)}), 0.0);
    QCOMPARE(distanceBetween({Vec2(0, 0), Vec2(2, 0)}, {Vec2(0, 3), Vec2(2, 3)}), 3.0);
    QCOMPARE(distanceBetween({Vec2(0, 0), Vec2(2, 0)}, {Vec2(5, 4), Vec2(9, 9)}), 5.0);
  }
};

QTEST_APPLESS_MAIN(TautWayTest)
#include "tst_StringPulling.moc"
