#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <QtTest>

#include "sim2d/base/Rng.h"
#include "sim2d/map/Obstacles.h"
#include "tests/AllocationCount.h"
#include "tests/support/Columns.h"

using namespace sim2d;

Q_DECLARE_METATYPE(base::Vec2)

namespace {

Obstacles obstaclesOf(const std::vector<std::vector<Outline>>& parts) {
  Obstacles obstacles;
  for (const auto& part : parts) {
    obstacles.add(part);
  }
  obstacles.build();
  return obstacles;
}

std::vector<Obstacles::Point> pointsAt(const Obstacles& obstacles, const Vec2& position,
                                       double range = 5.0) {
  std::vector<Obstacles::Point> points;
  obstacles.boundaryPoints(position, points, range);
  return points;
}

Outline cutFiner(const Outline& outline, std::mt19937& random) {
  Outline finer;
  for (std::size_t i = 0; i < outline.points.size(); ++i) {
    const Vec2 a = outline.points[i];
    const Vec2 b = outline.points[(i + 1) % outline.points.size()];
    std::vector<double> cuts{0.0};
    std::uniform_int_distribution<int> number(0, 5);
    std::uniform_real_distribution<double> place(0.001, 0.999);
    for (int n = number(random); n > 0; --n) {
      cuts.push_back(place(random));
    }
    std::sort(cuts.begin(), cuts.end());
    for (const double cut : cuts) {
      finer.points.push_back(a + cut * (b - a));
    }
  }
  return finer;
}

std::vector<Outline> randomShapes(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> place(-10.0, 10.0);
  std::uniform_real_distribution<double> size(0.2, 3.0);
  std::vector<Outline> shapes;
  for (int i = 0; i < count; ++i) {
    const Pose2 pose{{place(random), place(random)}, size(random)};
    switch (i % 4) {
      case 0:
        shapes.push_back(boxOutline(pose, size(random), size(random)));
        break;
      case 1:
        shapes.push_back(circleOutline(pose.position, size(random), 24));
        break;
      case 2:
        shapes.push_back(wallOutlines(
            {pose.position, pose.ahead(3.0), pose.ahead(3.0) + Vec2(place(random), place(random))},
            0.2)[0]);
        break;
      default:  // an L
        shapes.push_back({{pose.toWorld({0, 0}), pose.toWorld({3, 0}), pose.toWorld({3, 1}),
                           pose.toWorld({1, 1}), pose.toWorld({1, 3}), pose.toWorld({0, 3})}});
    }
  }
  return shapes;
}

bool insideAny(const std::vector<Outline>& shapes, const Vec2& point) {
  return std::any_of(shapes.begin(), shapes.end(),
                     [&](const Outline& shape) { return isInside(shape.points, point); });
}

template <class Visit>
void forEachEdge(const std::vector<Outline>& shapes, Visit visit) {
  for (const Outline& shape : shapes) {
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
      visit(Segment{shape.points[i], shape.points[(i + 1) % shape.points.size()]});
    }
  }
}

}  // namespace

class ObstaclesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void boundaryPoints_box_isOne_data() {
    addColumns<Vec2, Vec2>({"position", "expected"});
    QTest::newRow("beside") << Vec2(3, 0.2) << Vec2(1, 0.2);
    QTest::newRow("above") << Vec2(-0.5, 1.01) << Vec2(-0.5, 1);
    QTest::newRow("off a corner") << Vec2(2, 2) << Vec2(1, 1);
    QTest::newRow("level with a corner") << Vec2(3, 1) << Vec2(1, 1);
    QTest::newRow("on the border") << Vec2(1, 0.5) << Vec2(1, 0.5);
  }

  void boundaryPoints_box_isOne() {
    QFETCH(const Vec2, position);
    QFETCH(const Vec2, expected);
    const auto points = pointsAt(obstaclesOf({{boxOutline({}, 2.0, 2.0)}}), position);
    QCOMPARE(points.size(), std::size_t{1});
    QVERIFY((points[0].position - expected).norm() < 1e-9);
    QVERIFY(std::fabs(points[0].distance - (position - expected).norm()) < 1e-9);
    QVERIFY(position.x() == 1.0 || !points[0].inside);
    QCOMPARE(points[0].part, 0);
  }

  void boundaryPoints_corridor_isTwo() {
    const Obstacles corridor = obstaclesOf(
        {wallOutlines({{-20, -1}, {20, -1}}, 0.1), wallOutlines({{-20, 1}, {20, 1}}, 0.1)});
    const auto points = pointsAt(corridor, {3.0, 0.2});
    QCOMPARE(points.size(), std::size_t{2});
    QVERIFY((points[0].position - Vec2(3.0, 0.95)).norm() < 1e-9);
    QVERIFY((points[1].position - Vec2(3.0, -0.95)).norm() < 1e-9);
  }

  void boundaryPoints_roomCorner_isTwoUnlessNear() {
    // A room: the border runs clockwise, what lies outside it is solid.
    const Obstacles room = obstaclesOf({{{{{0, 0}, {0, 8}, {8, 8}, {8, 0}}}}});
    const auto apart = pointsAt(room, {1.0, 2.0}, 3.0);
    QCOMPARE(apart.size(), std::size_t{2});
    QVERIFY((apart[0].position - Vec2(0, 2)).norm() < 1e-9);
    QVERIFY((apart[1].position - Vec2(1, 0)).norm() < 1e-9);
    const auto merged = pointsAt(room, {0.2, 0.21}, 3.0);
    QCOMPARE(merged.size(), std::size_t{1});
    QVERIFY((merged[0].position - Vec2(0, 0.21)).norm() < 1e-9);
    QCOMPARE(pointsAt(room, {4.0, 4.0}).size(), std::size_t{4});
    QVERIFY(room.isInside({-1.0, 4.0}));
  }

  void boundaryPoints_thinWall_countsItsNearSide() {
    const Obstacles wall = obstaclesOf({wallOutlines({{0, -5}, {0, 5}}, 0.4)});
    const auto points = pointsAt(wall, {-1.0, 0.0});
    QCOMPARE(points.size(), std::size_t{1});
    QVERIFY((points[0].position - Vec2(-0.2, 0)).norm() < 1e-9);
  }

  void boundaryPoints_outOfRange_isNone() {
    const Obstacles box = obstaclesOf({{boxOutline({}, 2.0, 2.0)}});
    QVERIFY(pointsAt(box, {6.001, 0.0}).empty());
    QCOMPARE(pointsAt(box, {5.999, 0.0}).size(), std::size_t{1});
    QVERIFY(pointsAt(box, {500.0, 0.0}).empty());
  }

  void boundaryPoints_inside_isNearestAlone() {
    const Obstacles boxes =
        obstaclesOf({{boxOutline({}, 20.0, 40.0)}, {boxOutline({{11, 0}, 0}, 1, 1)}});
    const auto points = pointsAt(boxes, {3.0, 1.0});
    QCOMPARE(points.size(), std::size_t{1});
    QVERIFY(points[0].inside);
    QVERIFY((points[0].position - Vec2(10, 1)).norm() < 1e-9);
    QCOMPARE(points[0].distance, 7.0);
  }

  void boundaryPoints_insideOverlap_leavesTheUnion() {
    const Obstacles boxes =
        obstaclesOf({{boxOutline({}, 4.0, 4.0)}, {boxOutline({{3, 0}, 0}, 4.0, 10.0)}});
    const auto points = pointsAt(boxes, {0.9, 0.0});  // x = 1 is covered by the first box
    QCOMPARE(points.size(), std::size_t{1});
    QVERIFY(points[0].inside);
    QVERIFY(std::fabs(points[0].distance - 2.0) < 1e-9);
  }

  void boundaryPoints_existing_areKept() {
    const Obstacles box = obstaclesOf({{boxOutline({}, 2.0, 2.0)}});
    std::vector<Obstacles::Point> points(1);
    points[0].position = {1.0, 0.0};
    box.boundaryPoints({2.0, 0.0}, points);
    QCOMPARE(points.size(), std::size_t{2});
  }

  void boundaryPoints_finerCut_isTheSame() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-12.0, 12.0);
    for (int round = 0; round < 20; ++round) {
      const auto shapes = randomShapes(random, 12);
      std::vector<Outline> finer;
      finer.reserve(shapes.size());
      for (const Outline& shape : shapes) {
        finer.push_back(cutFiner(shape, random));
      }
      const Obstacles coarse = obstaclesOf({shapes});
      const Obstacles fine = obstaclesOf({finer});
      for (int i = 0; i < 200; ++i) {
        const Vec2 position(place(random), place(random));
        const auto expected = pointsAt(coarse, position);
        const auto actual = pointsAt(fine, position);
        QCOMPARE(actual.size(), expected.size());
        for (std::size_t n = 0; n < actual.size(); ++n) {
          QVERIFY((actual[n].position - expected[n].position).norm() < 1e-6);
          QCOMPARE(actual[n].inside, expected[n].inside);
        }
      }
    }
  }

  void boundaryPoints_closedDoor_counts() {
    Obstacles obstacles;
    const int door = obstacles.add(wallOutlines({{0, -0.5}, {0, 0.5}}, 0.05), false);
    obstacles.build();
    QVERIFY(pointsAt(obstacles, {1.0, 0.0}).empty());
    QVERIFY(!obstacles.isEnabled(door));
    obstacles.setEnabled(door, true);
    QCOMPARE(pointsAt(obstacles, {1.0, 0.0}).size(), std::size_t{1});
    QVERIFY(obstacles.isInside({0.0, 0.0}));
  }

  /// The last answers stay, but neither for a door that was switched since nor for another world.
  void boundaryPoints_askedAgain_areThoseOfNow() {
    Obstacles obstacles;
    obstacles.add({boxOutline({{3, 0}, 0}, 1, 1)});
    const int door = obstacles.add({boxOutline({{-2, 0}, 0}, 1, 1)});
    obstacles.build();
    const auto placesOf = [](const Obstacles& of, double range) {
      std::vector<Obstacles::Point> points;
      of.boundaryPoints({0, 0}, points, range);
      std::vector<double> places;
      places.reserve(points.size());
      for (const Obstacles::Point& point : points) {
        places.push_back(point.position.x());
      }
      return places;
    };
    const std::vector<double> both = {-1.5, 2.5};
    const std::vector<double> box = {2.5};
    QCOMPARE(placesOf(obstacles, 5.0), both);
    QCOMPARE(placesOf(obstacles, 5.0), both);
    QCOMPARE(placesOf(obstacles, 2.0), std::vector<double>{-1.5});
    Obstacles open = obstacles;
    open.setEnabled(door, false);
    QCOMPARE(placesOf(open, 5.0), box);
    QCOMPARE(placesOf(obstacles, 5.0), both);
    open.setEnabled(door, true);
    QCOMPARE(placesOf(open, 5.0), both);
    Obstacles other;
    other.add({boxOutline({{4, 0}, 0}, 1, 1)});
    other.build();
    QCOMPARE(placesOf(other, 5.0), std::vector<double>{3.5});
    QCOMPARE(placesOf(obstacles, 5.0), both);
  }

  void rayPoints_box_countsHits() {
    // A long wall at distance 2: rays within acos(2/4) = 60 degrees of its normal meet it; 0, 4
    // … 60.
    const Obstacles wall = obstaclesOf({wallOutlines({{2.05, -50}, {2.05, 50}}, 0.1)});
    std::vector<Obstacles::Point> points;
    wall.rayPoints({0.001, 0.0}, points);
    QCOMPARE(points.size(), std::size_t{31});
    QVERIFY((points[0].position - Vec2(2.0, 0.0)).norm() < 1e-9);
    QVERIFY(std::fabs(points[1].distance - 1.999 / std::cos(4.0 * base::kPi / 180.0)) < 1e-9);
  }

  void isInside_random_agrees() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-14.0, 14.0);
    for (int round = 0; round < 30; ++round) {
      const auto shapes = randomShapes(random, 16);
      std::vector<std::vector<Outline>> parts;
      for (const Outline& shape : shapes) {
        if (isSimple(shape.points)) {
          parts.push_back({shape});
        }
      }
      const Obstacles obstacles = obstaclesOf(parts);
      for (int i = 0; i < 500; ++i) {
        const Vec2 position(place(random), place(random));
        bool expected = false;
        for (const auto& part : parts) {
          expected = expected || insideAny(part, position);
        }
        QCOMPARE(obstacles.isInside(position), expected);
      }
    }
  }

  void clearance_random_agrees() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-30.0, 30.0);
    const auto shapes = randomShapes(random, 12);
    const Obstacles obstacles = obstaclesOf({shapes});
    for (int i = 0; i < 3000; ++i) {
      const Vec2 position(place(random), place(random));
      double expected = 5.0;
      forEachEdge(shapes, [&](const Segment& edge) {
        expected = std::min(expected, distanceToSegment(edge, position));
      });
      const double actual = obstacles.clearance(position);
      QVERIFY(std::fabs(std::fabs(actual) - expected) < 1e-9);
      QCOMPARE(actual < 0.0, obstacles.isInside(position));
    }
  }

  void raycast_random_agrees() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-20.0, 20.0);
    const auto shapes = randomShapes(random, 12);
    const Obstacles obstacles = obstaclesOf({shapes});
    for (int i = 0; i < 3000; ++i) {
      const Vec2 from(place(random), place(random));
      const Vec2 to(place(random), place(random));
      if (obstacles.isInside(from)) {
        continue;
      }
      const double range = (to - from).norm();
      double expected = range;
      forEachEdge(shapes, [&](const Segment& edge) {
        const auto hit = raySegmentHit(from, (to - from) / range, edge);
        expected = hit ? std::min(expected, *hit) : expected;
      });
      QVERIFY(std::fabs(obstacles.raycast(from, (to - from) / range, range) - expected) < 1e-9);
      QCOMPARE(obstacles.isVisible(from, to), expected == range && !obstacles.isInside(to));
    }
  }

  /// To the bit, also along edges, through corners and far from the origin.
  void raycast_equalsTheNearestHitOfEachEdge() {
    base::AgentRng rng(3, 1);
    std::uint32_t next = 0;
    const auto between = [&](double low, double high) {
      return low + (high - low) * rng.uniform01(base::DrawPurpose::Test, next++);
    };
    int hits = 0;
    const std::vector<std::pair<double, int>> scenes = {{0.0, 40}, {1e4, 40}, {0.0, 3}, {1e4, 3}};
    for (const auto& [far, boxes] : scenes) {
      const Vec2 origin(far, -far);
      Obstacles obstacles;
      std::vector<Segment> edges;
      std::vector<Vec2> corners;
      for (int k = 0; k < boxes; ++k) {  // few leave much room
        const Vec2 middle =
            origin + Vec2(std::floor(between(-10, 10)), std::floor(between(-10, 10)));
        const double heading = k % 2 == 0 ? 0.0 : between(-3.0, 3.0);
        const Outline box = boxOutline({middle, heading}, between(0.01, 1.5), between(0.01, 1.5));
        obstacles.add({box});
        for (std::size_t i = 0; i < box.points.size(); ++i) {
          edges.push_back({box.points[i], box.points[(i + 1) % box.points.size()]});
          corners.push_back(box.points[i]);
        }
      }
      obstacles.build();
      for (int k = 0; k < 4000; ++k) {
        const Vec2 from = k % 3 == 0 ? Vec2(corners[static_cast<std::size_t>(k) % corners.size()] -
                                            Vec2(between(0.0, 8.0), 0.0))
                                     : Vec2(origin + Vec2(between(-11, 11), between(-11, 11)));
        Vec2 to = k % 2 == 0 ? corners[static_cast<std::size_t>(7 * k) % corners.size()]
                             : Vec2(origin + Vec2(between(-11, 11), between(-11, 11)));
        if (k % 7 == 0) {
          to.x() = from.x();
        }
        const double range = (to - from).norm();
        if (range == 0.0 || obstacles.isInside(from)) {
          continue;
        }
        const Vec2 direction = (to - from) / range;
        double nearest = range;
        bool isHit = false;
        for (const Segment& edge : edges) {
          const std::optional<double> hit = raySegmentHit(from, direction, edge);
          isHit = isHit || (hit && *hit <= range);
          nearest = hit ? std::min(nearest, *hit) : nearest;
        }
        QCOMPARE(obstacles.raycast(from, direction, range), nearest);
        const bool isSeen = obstacles.isVisible(from, to);
        QCOMPARE(obstacles.isVisible(to, from), isSeen);
        // From there it is asked.
        if (from.x() < to.x() || (from.x() == to.x() && from.y() < to.y())) {
          QCOMPARE(isSeen, !isHit && !obstacles.isInside(to));
          hits += isHit ? 1 : 0;
        }
      }
    }
    QVERIFY(hits > 1000);
  }

  void raycast_throughCorner_hits() {
    const Obstacles box = obstaclesOf({{boxOutline({{0.5, 0.5}, 0}, 1.0, 1.0)}});
    const double half = std::sqrt(0.5);
    QVERIFY(std::fabs(box.raycast({-1, -1}, {half, half}, 10.0) - std::sqrt(2.0)) < 1e-9);
    QVERIFY(std::fabs(box.raycast({-1, 2}, {half, -half}, 10.0) - std::sqrt(2.0)) < 1e-9);
    QCOMPARE(box.raycast({-1, 0.5}, {-1, 0}, 10.0), 10.0);
    QVERIFY(std::fabs(box.raycast({-3, 0.5}, {1, 0}, 10.0) - 3.0) < 1e-9);
    QVERIFY(std::fabs(box.raycast({0.5, 4}, {0, -1}, 10.0) - 3.0) < 1e-9);
  }

  void raycast_inside_isZero() {
    const Obstacles box = obstaclesOf({{boxOutline({}, 2.0, 2.0)}});
    QCOMPARE(box.raycast({0, 0}, {1, 0}, 10.0), 0.0);
  }

  void isVisible_cases() {
    const Obstacles box = obstaclesOf({{boxOutline({}, 2.0, 2.0)}});
    QVERIFY(!box.isVisible({-3, 0}, {3, 0}));
    QVERIFY(box.isVisible({-3, 0}, {-1.5, 0}));
    QVERIFY(box.isVisible({-3, 2}, {3, 2}));
    QVERIFY(box.isVisible({-3, 2}, {-3, 2}));
    QVERIFY(!box.isVisible({0.1, 0}, {0.2, 0}));  // both in the solid
    QVERIFY(Obstacles().isVisible({0, 0}, {5, 5}));
  }

  /// Their distance is infinite and the direction 0; what stands is far from where the ray begins.
  void isVisible_placesTooFarApart_ends() {
    const Obstacles boxes = obstaclesOf(
        {{boxOutline({{-9, -9}, 0.0}, 1.0, 1.0)}, {boxOutline({{9, 9}, 0.0}, 1.0, 1.0)}});
    for (const double far : {1e155, 1e308, -1e308}) {
      QVERIFY(boxes.isVisible({0, 0}, {far, 3}));
      QVERIFY(boxes.isVisible({3, far}, {0, 0}));
    }
  }

  void setEnabled_door_opensSight() {
    Obstacles obstacles;
    obstacles.add(wallOutlines({{0, -5}, {0, -0.5}}, 0.1));
    obstacles.add(wallOutlines({{0, 0.5}, {0, 5}}, 0.1));
    const int door = obstacles.add(wallOutlines({{0, -0.5}, {0, 0.5}}, 0.05));
    obstacles.build();
    QVERIFY(!obstacles.isVisible({-2, 0}, {2, 0}));
    obstacles.setEnabled(door, false);
    QVERIFY(obstacles.isVisible({-2, 0}, {2, 0}));
    QVERIFY(!obstacles.isInside({0, 0}));
    QCOMPARE(obstacles.clearance({0, 0}), 0.5);
  }

  void segmentsNear_openDoor_areThoseOfTheRestOnceInOrder() {
    Obstacles obstacles;
    obstacles.add({boxOutline({{0, 0}, 0}, 2, 2)});
    const int door = obstacles.add({boxOutline({{1.5, 0}, 0}, 1, 1)});
    obstacles.add({boxOutline({{0, 3}, 0}, 8, 1)});
    obstacles.add({boxOutline({{500, 0}, 0}, 1, 1)});
    obstacles.build();
    obstacles.setEnabled(door, false);
    const Segment kept{{7, 7}, {8, 8}};
    std::vector<Segment> found = {kept};
    obstacles.segmentsNear({0, 1}, 20.0, found);
    std::vector<Segment> expected = {kept};
    for (const int part : {0, 2}) {
      const std::vector<Vec2>& points = obstacles.outlines(part).front().points;
      for (std::size_t i = 0; i < points.size(); ++i) {
        expected.push_back({points[i], points[(i + 1) % points.size()]});
      }
    }
    QCOMPARE(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      QVERIFY(found[i].a == expected[i].a && found[i].b == expected[i].b);
    }
  }

  void segmentsNear_enoughRoom_takesNoMemory() {
    Obstacles obstacles;
    for (int i = 0; i < 50; ++i) {
      obstacles.add({boxOutline({{0.3 * i, 0.1 * i}, 0.2 * i}, 2, 0.5)});
    }
    obstacles.build();
    std::vector<Segment> found;
    obstacles.segmentsNear({5, 2}, 6.0, found);
    found.clear();
    const long before = allocations;
    obstacles.segmentsNear({5, 2}, 6.0, found);
    QCOMPARE(static_cast<long>(allocations) - before, 0L);
    QVERIFY(found.size() > 20);
  }

  void build_degenerate_isSafe() {
    Obstacles obstacles = obstaclesOf({{}, {{{}}, {{{1, 1}}}, {{{1, 1}, {1, 1}}}}});
    QVERIFY(pointsAt(obstacles, {0, 0}).empty());
    QCOMPARE(obstacles.clearance({1, 1}, 2.0), 2.0);
    obstacles = obstaclesOf({{{{{0, 0}, {0, 0}, {2, 0}, {2, 2}, {2, 2}, {0, 2}, {0, 0}}}}});
    QCOMPARE(pointsAt(obstacles, {3, 1}).size(), std::size_t{1});
    QVERIFY(obstacles.isInside({1, 1}));
    const Obstacles far =
        obstaclesOf({{boxOutline({{1e6, 1e6}, 0}, 1, 1)}, {boxOutline({{-1e6, 0}, 0}, 1, 1)}});
    QVERIFY(far.isInside({1e6, 1e6}));
    QVERIFY(far.isVisible({0, 10}, {1000, 10}));
    QVERIFY(!far.isVisible({0, 0}, {-1.1e6, 0}));
  }

  void map_room_insideIsFree() {
    std::vector<std::int8_t> cells(100, 0);
    for (std::size_t i = 0; i < 10; ++i) {
      cells[i] = cells[90 + i] = cells[i * 10] = cells[i * 10 + 9] = 100;
    }
    const Obstacles room = obstaclesOf({traceOutlines(OccupancyGrid(10, 10, 1.0, {}, cells))});
    QVERIFY(!room.isInside({5, 5}));
    QVERIFY(room.isInside({0.5, 5}));
    QVERIFY(!room.isInside({-0.5, 5}));
    QCOMPARE(room.clearance({5, 4}), 3.0);
    QCOMPARE(room.clearance({0.25, 4}), -0.25);
  }
};

QTEST_APPLESS_MAIN(ObstaclesTest)
#include "tst_Obstacles.moc"
