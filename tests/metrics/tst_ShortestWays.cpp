#include <cmath>

#include <QtTest>

#include "metrics/Samples.h"
#include "sim2d/map/PathPlanner.h"
#include "tests/map/MapSketch.h"

using namespace sketch;

namespace {

/// Of a robot of that radius, with the walls of a map or a drawn obstacle.
metrics::RunContext contextOf(TraceHeader header, double radius) {
  header.robots.push_back({});
  header.robots.back().radius = radius;
  return metrics::SampleBuilder(header).context();
}

metrics::RunContext contextOf(const MapSketch& sketch, double radius) {
  TraceHeader header;
  header.map = sketch.grid();
  header.obstacles.push_back({"map", false, false, {}, traceOutlines(header.map)});
  return contextOf(std::move(header), radius);
}

metrics::RunContext contextOf(const std::vector<Vec2>& corners, double radius) {
  TraceHeader header;
  Outline outline;
  outline.points = corners;
  header.obstacles.push_back({"block", false, false, {}, {outline}});
  return contextOf(std::move(header), radius);
}

/// From a point beside a corner until the way runs level beyond it: straight to the circle round
/// the corner, then along it. How far the corner is off, along the level way and across.
double roundACorner(double along, double across, double radius) {
  const double distance = std::hypot(along, across);
  const double turn = std::atan2(across, along) + std::asin(radius / distance);
  return std::sqrt(distance * distance - radius * radius) + radius * turn;
}

/// The length between the points, if it is the same there and back; else NaN.
double lengthBetween(const metrics::RunContext& context, const Vec2& a, const Vec2& b) {
  const double there = polylineLength(metrics::shortestPath(context, a, b));
  const double back = polylineLength(metrics::shortestPath(context, b, a));
  return std::fabs(there - back) < 2e-4 * there ? 0.5 * (there + back) : NAN;
}

bool isAbout(double value, double expected) {
  return std::fabs(value - expected) < 5e-4 * expected;
}

/// Two blocks of 8 m with 0.9 m between them, open ground above and below.
MapSketch twoBlocks() {
  MapSketch sketch(12.0, 12.0);
  sketch.fill({2.0, 6.45}, {10.0, 8.5}).fill({2.0, 3.5}, {10.0, 5.55});
  return sketch;
}

constexpr double kRadius = 0.35;  // [m]

}  // namespace

/// The ways that metrics measure against; lengths by hand.
class ShortestWaysTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The narrow way costs the planner of a run more than the way round, which is longer by 15 %.
  void narrowPassage_isTakenWhereItIsShorter() {
    const metrics::RunContext context = contextOf(twoBlocks(), kRadius);
    const double narrow = 8.0 + 2.0 * roundACorner(1.0, 7.0 - 6.45, kRadius);
    const double wide = 8.0 + 2.0 * roundACorner(1.0, 8.5 - 7.0, kRadius);
    QVERIFY(wide > 1.15 * narrow);
    const double length = lengthBetween(context, {1.0, 7.0}, {11.0, 7.0});
    QVERIFY2(isAbout(length, narrow), qPrintable(QString::number(length)));
  }
  void wayRound_isTakenWhereItIsShorter() {
    const metrics::RunContext context = contextOf(twoBlocks(), kRadius);
    const double wide = 8.0 + 2.0 * roundACorner(1.0, 8.5 - 8.0, kRadius);
    const double length = lengthBetween(context, {1.0, 8.0}, {11.0, 8.0});
    QVERIFY2(isAbout(length, wide), qPrintable(QString::number(length)));
  }

  /// Over the top of a triangle askew to the cells, or below it along them: in eight directions the
  /// way over the top seems to be the longer one.
  void wayAskew_isTakenWhereItIsShorter() {
    const double radius = 0.1;
    const metrics::RunContext context =
        contextOf(std::vector<Vec2>{Vec2(0.2, -0.8), Vec2(9.8, -0.8), Vec2(5.0, 2.0)}, radius);
    const double above = 2.0 * roundACorner(5.0, 2.0, radius);
    const double below = 9.6 + 2.0 * roundACorner(0.2, 0.8, radius);
    QVERIFY(below > 1.06 * above);
    const double length = lengthBetween(context, {0.0, 0.0}, {10.0, 0.0});
    QVERIFY2(isAbout(length, above), qPrintable(QString::number(length)));
  }

  /// More cells than an ordinary map has; a wall from side to side with a gap at one end, and posts
  /// out of the way.
  void largeMap_isMeasuredByCells() {
    MapSketch sketch(105.0, 105.0);
    sketch.fill({20.0, 50.0}, {105.0, 52.0});
    for (int k = 0; k < 20; ++k) {
      sketch.fill({25.0 + 3.0 * k, 20.0}, {26.0 + 3.0 * k, 21.0});
    }
    const metrics::RunContext context = contextOf(sketch, kRadius);
    QVERIFY(context.map.width() * context.map.height() > DistanceField::kMaxCells);
    const double length = lengthBetween(context, {60.0, 48.0}, {60.0, 54.0});
    const double expected = 2.0 + 2.0 * roundACorner(2.0, 40.0, kRadius);
    QVERIFY2(isAbout(length, expected), qPrintable(QString::number(length)));
  }

  void straightWay_isTheDistance() {
    const metrics::RunContext context = contextOf(twoBlocks(), kRadius);
    QCOMPARE(lengthBetween(context, {1.0, 6.0}, {11.0, 6.0}), 10.0);
    QCOMPARE(lengthBetween(context, {1.0, 1.0}, {4.0, 2.0}), std::sqrt(10.0));
  }
};

QTEST_APPLESS_MAIN(ShortestWaysTest)
#include "tst_ShortestWays.moc"
