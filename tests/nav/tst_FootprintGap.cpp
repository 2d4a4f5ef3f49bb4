#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <QtTest>

#include "sim2d/map/Outlines.h"
#include "sim2d/nav/FootprintGap.h"
#include "tests/AllocationCount.h"

using namespace sim2d;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Footprint discOf(double radius) {
  Footprint footprint;
  footprint.radius = radius;
  return footprint;
}
Footprint polygonOf(std::vector<Vec2> corners) {
  Footprint footprint;
  footprint.corners = std::move(corners);
  return footprint;
}
/// A square of 1 m about the origin.
Footprint square() {
  return polygonOf({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
}
/// Two legs of 2 m, 1 m wide; the notch at the upper right.
Footprint angle() {
  return polygonOf({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
}

Obstacles obstaclesOf(const std::vector<Outline>& outlines) {
  Obstacles obstacles;
  for (const Outline& outline : outlines) {
    obstacles.add({outline});
  }
  obstacles.build();
  return obstacles;
}

bool isNear(double value, double expected, double tolerance = 1e-12) {
  return std::fabs(value - expected) <= tolerance;
}

// An independent way: samples of the border, and angles summed up round a point.

std::vector<Vec2> samplesOf(const std::vector<Vec2>& polygon, double step) {
  std::vector<Vec2> samples;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& from = polygon[i];
    const Vec2 along = polygon[(i + 1) % polygon.size()] - from;
    const int count = 1 + static_cast<int>(along.norm() / step);
    for (int n = 0; n < count; ++n) {
      samples.emplace_back(from + along * n / count);
    }
  }
  return samples;
}

bool isWoundRound(const std::vector<Vec2>& polygon, const Vec2& point) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - point;
    const Vec2 b = polygon[(i + 1) % polygon.size()] - point;
    sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
  }
  return std::fabs(sum) > 3.0;
}

/// A point and a segment, by the length of the normal or of the way to an end.
double plainDistance(const Vec2& point, const Vec2& a, const Vec2& b) {
  const double length = std::hypot(b.x() - a.x(), b.y() - a.y());
  const double ux = (b.x() - a.x()) / length;
  const double uy = (b.y() - a.y()) / length;
  const double along = (point.x() - a.x()) * ux + (point.y() - a.y()) * uy;
  if (along >= 0.0 && along <= length) {
    return std::fabs((point.y() - a.y()) * ux - (point.x() - a.x()) * uy);
  }
  const Vec2& end = along < 0.0 ? a : b;
  return std::hypot(point.x() - end.x(), point.y() - end.y());
}

/// The corners of the footprint in the world.
std::vector<Vec2> placed(const Footprint& footprint, const Pose2& pose) {
  std::vector<Vec2> corners;
  corners.reserve(footprint.corners.size());
  for (const Vec2& corner : footprint.corners) {
    const double c = std::cos(pose.heading);
    const double s = std::sin(pose.heading);
    corners.emplace_back(pose.position.x() + c * corner.x() - s * corner.y(),
                         pose.position.y() + s * corner.x() + c * corner.y());
  }
  return corners;
}

/// A star about `centre` with random spikes: simple, not convex.
Footprint randomStar(std::mt19937& random, const Vec2& centre) {
  std::uniform_real_distribution<double> radius(0.15, 0.9);
  std::uniform_int_distribution<int> corners(3, 11);
  const int count = corners(random);
  Footprint footprint;
  for (int i = 0; i < count; ++i) {
    const double direction = 2.0 * base::kPi * i / count;
    footprint.corners.emplace_back(centre +
                                   radius(random) * Vec2(std::cos(direction), std::sin(direction)));
  }
  return footprint;
}

/// Distance between samples of the footprint's border and the outlines; whether they overlap.
struct PlainGap {
  double distance = kInfinity;
  bool overlaps = false;
};
PlainGap plainGap(const std::vector<Vec2>& footprint, const std::vector<Outline>& outlines) {
  PlainGap gap;
  const std::vector<Vec2> samples = samplesOf(footprint, 0.002);
  for (const Outline& outline : outlines) {
    for (const Vec2& sample : samples) {
      gap.overlaps = gap.overlaps || isWoundRound(outline.points, sample);
      for (std::size_t i = 0; i < outline.points.size(); ++i) {
        const Vec2& next = outline.points[(i + 1) % outline.points.size()];
        gap.distance = std::min(gap.distance, plainDistance(sample, outline.points[i], next));
      }
    }
    for (const Vec2& corner : outline.points) {
      gap.overlaps = gap.overlaps || isWoundRound(footprint, corner);
    }
  }
  return gap;
}

}  // namespace

class FootprintGapTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void inscribedRadius_shapes_byHand() {
    QCOMPARE(inscribedRadius(discOf(0.35)), 0.35);
    QVERIFY(isNear(inscribedRadius(square()), 0.5));
    QVERIFY(isNear(inscribedRadius(polygonOf({{-0.1, -0.2}, {0.6, -0.2}, {0.6, 0.2}, {-0.1, 0.2}})),
                   0.1));
    // Diamond with half diagonals 3 and 4: the sides have length 5 and distance 3 * 4 / 5.
    QVERIFY(isNear(inscribedRadius(polygonOf({{3, 0}, {0, 4}, {-3, 0}, {0, -4}})), 2.4));
    QCOMPARE(inscribedRadius(angle()), 0.0);  // on the corner
    QCOMPARE(inscribedRadius(polygonOf({{1, 0}, {2, 0}, {2, 1}})), 0.0);
  }

  void gapToDisc_discs_isTheDistanceLessBothRadii() {
    const Pose2 pose{{1.0, 1.0}, 2.0};
    QVERIFY(isNear(gapToDisc(discOf(0.35), pose, {4.0, 5.0}, 0.4), 4.25));
    QVERIFY(isNear(gapToDisc(discOf(0.35), pose, {1.0, 1.5}, 0.4), -0.25));
    QVERIFY(isNear(gapToDisc(discOf(0.35), pose, {1.0, 1.0}, 0.4), -0.75));
  }

  void gapToDisc_square_byHand_data() {
    QTest::addColumn<double>("heading");
    QTest::addColumn<double>("x");  // of the disc, from the robot
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("gap");
    const double quarter = base::kPi / 4.0;
    QTest::newRow("side") << 0.0 << 2.0 << 0.3 << 1.25;
    QTest::newRow("corner") << 0.0 << 3.5 << 4.5 << 4.75;          // 3 and 4 from the corner
    QTest::newRow("overlaps") << 0.0 << 0.6 << 0.0 << -0.15;       // 0.1 outside
    QTest::newRow("centre inside") << 0.0 << 0.3 << 0.1 << -0.45;  // 0.2 deep
    QTest::newRow("middle") << 0.0 << 0.0 << 0.0 << -0.75;         // 0.5 deep
    QTest::newRow("turned") << quarter << 2.0 << 0.0 << 1.75 - std::sqrt(0.5);
    QTest::newRow("quarter turned") << 2.0 * quarter << 0.3 << -2.0 << 1.25;
  }

  void gapToDisc_square_byHand() {
    QFETCH(double, heading);
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, gap);
    const Pose2 pose{{10.0, -20.0}, heading};
    QVERIFY(isNear(gapToDisc(square(), pose, {10.0 + x, -20.0 + y}, 0.25), gap, 1e-12));
  }

  void gapToDisc_notchOfAnAngle_isOutside() {
    QVERIFY(isNear(gapToDisc(angle(), {}, {1.5, 1.5}, 0.3), 0.2));
    QVERIFY(isNear(gapToDisc(angle(), {}, {2.5, 2.0}, 0.3), std::sqrt(1.25) - 0.3));
    QVERIFY(isNear(gapToDisc(angle(), {}, {0.9, 0.9}, 0.0), -std::sqrt(0.02)));  // from the notch
    QVERIFY(isNear(gapToDisc(angle(), {}, {0.4, 1.5}, 0.1), -0.5));
  }

  void gapToDisc_randomStars_agreesWithSamples() {
    std::mt19937 random(21);
    std::uniform_real_distribution<double> value(-1.5, 1.5);
    int inside = 0;
    for (int round = 0; round < 40; ++round) {
      const Footprint star = randomStar(random, {0.3 * value(random), 0.3 * value(random)});
      const Pose2 pose{{value(random), value(random)}, 2.0 * value(random)};
      const std::vector<Vec2> corners = placed(star, pose);
      const std::vector<Vec2> samples = samplesOf(corners, 0.001);
      for (int i = 0; i < 20; ++i) {
        const Vec2 centre = pose.position + Vec2(value(random), value(random));
        double distance = kInfinity;
        for (const Vec2& sample : samples) {
          distance = std::min(distance, (sample - centre).norm());
        }
        const bool isIn = isWoundRound(corners, centre);
        inside += isIn ? 1 : 0;
        const double expected = (isIn ? -distance : distance) - 0.2;
        QVERIFY(isNear(gapToDisc(star, pose, centre, 0.2), expected, 6e-4));
      }
    }
    QVERIFY(inside > 30 && inside < 400);
  }

  void gapToWalls_disc_isTheClearanceLessItsRadius() {
    const Obstacles wall = obstaclesOf({boxOutline({{5.0, 0.0}, 0.0}, 2.0, 20.0)});
    const auto gapAt = [&](double x) {
      return gapToWalls(discOf(0.4), {{x, 0.0}, 1.0}, wall, 3.0);
    };
    QVERIFY(isNear(gapAt(2.0), 1.6));
    QVERIFY(isNear(gapAt(3.7), -0.1));
    QVERIFY(isNear(gapAt(4.2), -0.6));  // 0.2 deep
    QCOMPARE(gapAt(0.5), 3.0);
    QCOMPARE(gapAt(-50.0), 3.0);
  }

  void gapToWalls_nothingNear_isTheLimit() {
    Obstacles none;
    none.build();
    const Obstacles wall = obstaclesOf({boxOutline({{5.0, 0.0}, 0.0}, 2.0, 20.0)});
    for (const Footprint& footprint : {square(), discOf(0.35), angle()}) {
      QCOMPARE(gapToWalls(footprint, {}, none, 2.0), 2.0);
      QCOMPARE(gapToWalls(footprint, {{-3.0, 0.0}, 0.3}, wall, 2.0), 2.0);
      QCOMPARE(gapToWalls(footprint, {{-3.0, 0.0}, 0.3}, wall, 0.0), 0.0);
    }
  }

  void gapToWalls_square_byHand() {
    const Obstacles box =
        obstaclesOf({boxOutline({{5.0, 0.0}, 0.0}, 2.0, 2.0)});  // 4 to 6, -1 to 1
    QVERIFY(isNear(gapToWalls(square(), {{2.0, 0.0}, 0.0}, box, 3.0), 1.5));
    QVERIFY(isNear(gapToWalls(square(), {{2.0, 0.0}, base::kPi / 4.0}, box, 3.0),
                   2.0 - std::sqrt(0.5)));
    // Corner to corner: 3 and 4 apart.
    QVERIFY(isNear(gapToWalls(square(), {{0.5, 5.5}, 0.0}, box, 9.0), 5.0));
    QVERIFY(isNear(gapToWalls(square(), {{0.5, 5.5}, 0.0}, box, 4.0), 4.0));
    QVERIFY(isNear(gapToWalls(square(), {{3.5, 0.0}, 0.0}, box, 3.0), 0.0));  // touches
  }

  void gapToWalls_squareIntoAWall_fallsEvenly() {
    const Obstacles wall = obstaclesOf({boxOutline({{10.0, 0.0}, 0.0}, 10.0, 40.0)});  // from x = 5
    for (int i = 0; i <= 390; ++i) {
      const double deep = -0.9 + 0.01 * i;  // of the front side
      const double gap = gapToWalls(square(), {{4.5 + deep, 0.123}, base::kPi}, wall, 4.0);
      QVERIFY2(isNear(gap, -deep, 1e-9), qPrintable(QString::number(deep)));
    }
  }

  /// A corner of the square that lies `deep` behind the border cuts off a piece of 2 `deep`; its
  /// middle has the distance deep / sqrt(2) from both sides.
  void gapToWalls_cornerIntoAWall_isHowDeepTheMiddleLies() {
    const Obstacles wall = obstaclesOf({boxOutline({{10.0, 0.0}, 0.0}, 10.0, 40.0)});
    for (const double deep : {0.001, 0.1, 0.4}) {
      const Pose2 pose{{5.0 + deep - std::sqrt(0.5), 0.0}, base::kPi / 4.0};
      QVERIFY(isNear(gapToWalls(square(), pose, wall, 1.0), -deep * std::sqrt(0.5), 1e-9));
    }
  }

  void gapToWalls_wallInsideTheFootprint_overlaps() {
    const Obstacles post = obstaclesOf({boxOutline({{0.2, 0.0}, 0.0}, 0.02, 0.02)});
    // Its side at x = 0.19 has the middle 0.31 from the front side.
    QVERIFY(isNear(gapToWalls(square(), {}, post, 1.0), -0.31, 1e-9));
    QVERIFY(gapToWalls(angle(), {{-0.5, -0.5}, 0.0}, post, 1.0) < -0.2);
  }

  void gapToWalls_wallInTheNotch_isApart() {
    const Obstacles post = obstaclesOf({boxOutline({{1.5, 1.6}, 0.0}, 0.2, 0.2)});
    QVERIFY(isNear(gapToWalls(angle(), {}, post, 1.0), 0.4));
    const Obstacles bar = obstaclesOf({boxOutline({{1.5, 1.5}, 0.0}, 0.2, 2.0)});  // y from 0.5
    QVERIFY(
        isNear(gapToWalls(angle(), {}, bar, 1.0), -0.5, 1e-9));  // end of the bar, in the middle
  }

  void gapToWalls_insideOfSolid_isNegative() {
    const Obstacles block = obstaclesOf({boxOutline({{0.0, 0.0}, 0.0}, 10.0, 10.0)});
    QVERIFY(isNear(gapToWalls(square(), {{1.0, 0.0}, 0.7}, block, 6.0), -4.5));
    QVERIFY(isNear(gapToWalls(discOf(0.3), {{1.0, 0.0}, 0.7}, block, 6.0), -4.3));
    QVERIFY(gapToWalls(square(), {{1.0, 0.0}, 0.7}, block, 0.1) < 0.0);
    QVERIFY(gapToWalls(discOf(0.3), {{1.0, 0.0}, 0.7}, block, 0.1) < 0.0);
  }

  void gapToWalls_insideOfARoom_isToItsWalls() {
    Outline room = boxOutline({}, 10.0, 8.0);  // clockwise: solid all round
    std::reverse(room.points.begin(), room.points.end());
    const Obstacles walls = obstaclesOf({room});
    QVERIFY(isNear(gapToWalls(square(), {{3.0, 0.0}, 0.0}, walls, 5.0), 1.5));
    QVERIFY(isNear(gapToWalls(square(), {{0.0, 3.6}, 0.0}, walls, 5.0), -0.1, 1e-9));
    QVERIFY(gapToWalls(square(), {{20.0, 0.0}, 0.0}, walls, 1.0) < 0.0);
  }

  void gapToWalls_originOutsideTheFootprint_countsTheFootprint() {
    const Footprint ahead = polygonOf({{1.0, -0.5}, {2.0, -0.5}, {2.0, 0.5}, {1.0, 0.5}});
    const Obstacles block = obstaclesOf({boxOutline({{5.0, 0.0}, 0.0}, 8.0, 8.0)});  // from x = 1
    QVERIFY(isNear(gapToWalls(ahead, {{0.2, 0.0}, 0.0}, block, 1.0), -0.2, 1e-9));
    QVERIFY(isNear(gapToWalls(ahead, {{-1.7, 0.0}, 0.0}, block, 1.0), 0.7));
    QVERIFY(gapToWalls(ahead, {{0.5, 0.0}, 0.0}, block, 1.0) < -0.4);  // wholly inside
    QVERIFY(gapToWalls(ahead, {{0.5, 0.0}, 0.0}, block, 0.0) < 0.0);
    // The origin inside, the footprint out of it again.
    QVERIFY(isNear(gapToWalls(ahead, {{8.5, 0.0}, 0.0}, block, 1.0), 0.5));
    QVERIFY(isNear(gapToWalls(ahead, {{1.5, 0.0}, base::kPi}, block, 1.0), 0.5));
  }

  void gapToWalls_openDoor_isNone() {
    Obstacles obstacles;
    const int door = obstacles.add({boxOutline({{2.0, 0.0}, 0.0}, 0.1, 1.0)});
    obstacles.build();
    QVERIFY(isNear(gapToWalls(square(), {}, obstacles, 3.0), 1.45));
    obstacles.setEnabled(door, false);
    QCOMPARE(gapToWalls(square(), {}, obstacles, 3.0), 3.0);
  }

  void gapToWalls_randomStars_agreesWithSamples() {
    std::mt19937 random(33);
    std::uniform_real_distribution<double> place(-3.0, 3.0);
    std::uniform_real_distribution<double> size(0.05, 1.2);
    int apart = 0;
    int overlapping = 0;
    for (int round = 0; round < 200; ++round) {
      std::vector<Outline> boxes;
      boxes.reserve(5);
      for (int i = 0; i < 5; ++i) {
        const Pose2 centre{{place(random), place(random)}, place(random)};
        boxes.push_back(boxOutline(centre, size(random), size(random)));
      }
      const Obstacles obstacles = obstaclesOf(boxes);
      const Vec2 shift(0.3 * place(random), 0.3 * place(random));  // the origin may lie outside
      const Footprint star = randomStar(random, shift);
      const Pose2 pose{{place(random), place(random)}, place(random)};
      const double gap = gapToWalls(star, pose, obstacles, 1.0);
      const PlainGap plain = plainGap(placed(star, pose), boxes);
      if (plain.overlaps) {
        ++overlapping;
        QVERIFY(gap < 0.0);
      } else if (plain.distance > 0.002) {  // below, the samples may have missed a corner
        ++apart;
        QVERIFY(isNear(gap, std::min(1.0, plain.distance), 1e-3));
      }
    }
    QVERIFY(apart > 40 && overlapping > 20);
  }

  void gaps_afterTheFirstCall_allocateNothingOfTheirOwn() {
    const Footprint footprint = angle();
    const Obstacles box = obstaclesOf({boxOutline({{5.0, 0.0}, 0.0}, 2.0, 2.0)});
    std::vector<Segment> walls;
    double sum = gapToWalls(footprint, {{2.5, 0.0}, 0.0}, box, 3.0);
    box.segmentsNear({2.5, 0.0}, 4.0, walls);
    walls.clear();
    long before = allocations;
    box.segmentsNear({2.5, 0.0}, 4.0, walls);
    const long ofSegments = allocations - before;
    before = allocations;
    sum += gapToWalls(footprint, {{2.5, 0.0}, 0.0}, box, 3.0);
    const long ofGap = allocations - before;
    QVERIFY(ofGap <= ofSegments);
    before = allocations;
    sum += gapToDisc(footprint, {}, {3.0, 0.1}, 0.3) + gapToWalls(footprint, {}, box, 0.5);
    sum += gapToWalls(discOf(0.3), {{2.5, 0.0}, 0.0}, box, 3.0) + inscribedRadius(footprint);
    const long ofOthers = allocations - before;
    QCOMPARE(ofOthers, 0L);
    QVERIFY(std::isfinite(sum));
  }
};

QTEST_GUILESS_MAIN(FootprintGapTest)
#include "tst_FootprintGap.moc"
