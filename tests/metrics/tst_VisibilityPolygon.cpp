#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <QtTest>

#include "metrics/MapFields.h"
#include "sim2d/map/Obstacles.h"
#include "sim2d/nav/Observation.h"

using base::Vec2;
using sim2d::Outline;
using sim2d::Segment;

namespace {

constexpr double kHalf = 1.7407963267948966;  // [rad] to each side

std::vector<Segment> edgesOf(const Outline& outline) {
  std::vector<Segment> edges;
  for (std::size_t k = 0; k < outline.points.size(); ++k) {
    edges.push_back({outline.points[k], outline.points[(k + 1) % outline.points.size()]});
  }
  return edges;
}

Outline box(double x, double y, double length, double width, double heading = 0.0) {
  return sim2d::boxOutline({{x, y}, heading}, length, width);
}

}  // namespace

class VisibilityPolygonTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// A regular polygon of n corners on a circle of radius r has n/2 r² sin(2 pi / n): 120 corners
  /// around, 60 in the half.
  void sight_openPlane_isASector() {
    const auto all = metrics::visibilityPolygon({{1.0, 2.0}, 0.3}, base::kPi, 5.0, {});
    QCOMPARE(all.size(), std::size_t{120});
    QVERIFY(std::abs(sim2d::signedArea(all) - 60.0 * 25.0 * std::sin(base::kPi / 60.0)) < 1e-9);
    const auto half = metrics::visibilityPolygon({{1.0, 2.0}, 0.3}, base::kPi / 2.0, 5.0, {});
    QVERIFY(std::abs(sim2d::signedArea(half) - 30.0 * 25.0 * std::sin(base::kPi / 60.0)) < 1e-9);
    QCOMPARE(half.front(), Vec2(1.0, 2.0));
  }

  void sight_insideARoom_isTheRoom() {
    const auto all =
        metrics::visibilityPolygon({{1.0, 0.5}, 2.0}, base::kPi, 50.0, edgesOf(box(0, 0, 6, 4)));
    QVERIFY(std::abs(sim2d::signedArea(all) - 24.0) < 1e-9);
    // The quarter around +x from the middle of a square of side 4: a triangle of 4 m².
    const auto quarter = metrics::visibilityPolygon({{0.0, 0.0}, 0.0}, base::kPi / 4.0, 50.0,
                                                    edgesOf(box(0, 0, 4, 4)));
    QVERIFY(std::abs(sim2d::signedArea(quarter) - 4.0) < 1e-9);
  }

  /// A wall from (1, -1) to (1, 1) hides a trapezoid of a room up to x = 3: the lines through its
  /// ends meet x = 3 at -3 and 3, so that (2 + 6) / 2 * 2 = 8 m² are out of sight.
  void sight_wallInTheMiddle_hidesWhatIsBehind() {
    std::vector<Segment> walls = edgesOf(box(0, 0, 6, 8));  // x to 3, y to 4
    walls.push_back({{1.0, -1.0}, {1.0, 1.0}});
    const auto seen = metrics::visibilityPolygon({{0.0, 0.0}, 0.0}, base::kPi, 50.0, walls);
    QVERIFY(std::abs(sim2d::signedArea(seen) - (48.0 - 8.0)) < 1e-9);
  }

  /// A chord at 3 of 5 m cuts the segment r² (a - sin a cos a), cos a = 3/5, off the circle.
  void sight_wallAcrossTheRange_isCutOff() {
    const auto seen = metrics::visibilityPolygon({{0.0, 0.0}, 0.0}, base::kPi, 5.0,
                                                 {{{3.0, -20.0}, {3.0, 20.0}}});
    const double cut = 25.0 * (std::acos(0.6) - 0.6 * 0.8);
    QVERIFY(std::abs(sim2d::signedArea(seen) - (25.0 * base::kPi - cut)) < 0.05);
    for (const Vec2& corner : seen) {
      QVERIFY(corner.x() < 3.0 + 1e-9 && corner.norm() < 5.0 + 1e-9);
    }
    QVERIFY(std::any_of(seen.begin(), seen.end(), [](const Vec2& corner) {
      return (corner - Vec2(3.0, 4.0)).norm() < 1e-9;
    }));
  }

  /// Lines of sight, one by one, tell the same.
  void sight_anyPlace_isWhatLinesOfSightSay() {
    std::vector<Outline> outlines = {box(0, 0, 20, 14), box(3, 2, 2, 1, 0.4), box(-4, 3, 0.3, 4),
                                     box(-3, -4, 3, 0.5, 1.1), box(5, -3, 1, 1, 0.7)};
    sim2d::Obstacles obstacles;
    std::vector<Segment> walls;
    for (std::size_t k = 0; k < outlines.size(); ++k) {
      for (const Segment& edge : edgesOf(outlines[k])) {
        walls.push_back(edge);
      }
      if (k == 0) {  // a room: solid outside
        std::reverse(outlines[k].points.begin(), outlines[k].points.end());
      }
      obstacles.add({outlines[k]});
    }
    obstacles.build();
    std::mt19937 random(7);
    const auto draw = [&random](double low, double high) {
      return low + (high - low) * double(random()) / double(std::mt19937::max());
    };
    const base::Pose2 eye{{-0.5, 0.2}, 0.9};
    const auto seen = metrics::visibilityPolygon(eye, kHalf, 8.0, walls);
    int inside = 0;
    for (int k = 0; k < 4000; ++k) {
      const Vec2 place(draw(-10.0, 10.0), draw(-7.0, 7.0));
      const bool isSeen = sim2d::isInView(eye, place, 8.0, kHalf, obstacles);
      const bool isIn = sim2d::isInside(seen, place);
      inside += isIn ? 1 : 0;
      if (isIn != isSeen) {  // only at the arc, whose chords leave 3 mm out
        QVERIFY2((place - eye.position).norm() > 7.99,
                 qPrintable(QStringLiteral("%1 %2").arg(place.x()).arg(place.y())));
      }
    }
    QVERIFY(inside > 500 && inside < 2500);
  }

  void walls_ofARun_areThoseNearAndClosed() {
    sim2d::TraceHeader header;
    header.obstacles.resize(3);
    header.obstacles[0].outlines = {box(0, 0, 2, 2), box(30, 0, 2, 2)};
    for (const std::size_t door : {1U, 2U}) {
      header.obstacles[door].isDoor = true;
      header.obstacles[door].open = door == 1;
      header.obstacles[door].outlines = {box(0, 3.0 * double(door), 1, 0.1)};
    }
    QCOMPARE(metrics::wallsAround(header, {}, {0.0, 0.0}, 10.0).size(), std::size_t{8});
    QCOMPARE(metrics::wallsAround(header, {0, 0}, {0.0, 0.0}, 10.0).size(), std::size_t{12});
    QCOMPARE(metrics::wallsAround(header, {1, 1}, {0.0, 0.0}, 10.0).size(), std::size_t{4});
    QCOMPARE(metrics::wallsAround(header, {1, 1}, {0.0, 0.0}, 40.0).size(), std::size_t{8});
    QCOMPARE(metrics::wallsAround(header, {1, 1}, {2.5, 2.5}, 2.0).size(), std::size_t{0});
  }
};

QTEST_APPLESS_MAIN(VisibilityPolygonTest)
#include "tst_VisibilityPolygon.moc"
