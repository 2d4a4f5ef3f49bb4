#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <QtTest>

#include "sim2d/map/Obstacles.h"
#include "tests/support/Columns.h"

using sim2d::Obstacles;
using sim2d::Outline;
using sim2d::Vec2;

namespace {

constexpr double kSpacing = 3.0;  // [m] of shapes, which touch nobody

/// L shapes and polygons of many corners, turned at random, counter-clockwise. Every second corner
/// of a polygon lies deeper by the share `notch`.
std::vector<Outline> scatteredShapes(int side, int corners, unsigned seed, double notch = 0.0) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> turn(0.0, 6.28);
  std::uniform_real_distribution<double> aside(-0.2, 0.2);
  std::vector<Outline> shapes;
  for (int k = 0; k < side * side; ++k) {
    const int row = k / side;
    const Vec2 centre(kSpacing * (k % side) + aside(random), kSpacing * row + aside(random));
    const sim2d::Pose2 pose{centre, base::wrapToPi(turn(random))};
    Outline shape;
    if (k % 2 == 0) {
      for (const Vec2& corner : {Vec2(-0.8, -0.8), Vec2(0.8, -0.8), Vec2(0.8, 0.0), Vec2(0.0, 0.0),
                                 Vec2(0.0, 0.8), Vec2(-0.8, 0.8)}) {
        shape.points.push_back(pose.toWorld(corner));
      }
    } else {
      for (int i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * i / corners;
        const double size = i % 2 == 0 ? 1.0 : 1.0 - notch;
        shape.points.push_back(
            pose.toWorld({0.9 * size * std::cos(angle), 0.6 * size * std::sin(angle)}));
      }
    }
    shapes.push_back(shape);
  }
  return shapes;
}

struct Foot {
  Vec2 place = Vec2::Zero();
  double distance = 0.0;
};

/// Local minima of the distance on one outline, by its definition: nearer than the points a
/// millionth before and behind it on the outline, and seen from outside.
std::vector<Foot> minimaOf(const Outline& shape, const Vec2& from, double range) {
  std::vector<Foot> minima;
  const std::size_t count = shape.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2& a = shape.points[i];
    const Vec2& b = shape.points[(i + 1) % count];
    const Vec2& before = shape.points[(i + count - 1) % count];
    const Vec2 along = (b - a).normalized();
    const double foot = (from - a).dot(along);
    const double outside = -base::cross(along, from - a);
    if (foot > 0.0 && foot < (b - a).norm() && outside > 0.0 && outside < range) {
      minima.push_back({a + foot * along, outside});
    }
    const Vec2 in = (a - before).normalized();
    const bool isMinimum = foot <= 0.0 && (from - a).dot(in) >= 0.0;
    const bool faces = outside > 0.0 || -base::cross(in, from - a) > 0.0;
    if (isMinimum && faces && (from - a).norm() < range) {
      minima.push_back({a, (from - a).norm()});
    }
  }
  return minima;
}

std::vector<Foot> pointsOf(const std::vector<Outline>& shapes, const Vec2& from, double range) {
  std::vector<Foot> all;
  for (const Outline& shape : shapes) {
    for (const Foot& foot : minimaOf(shape, from, range)) {
      all.push_back(foot);
    }
  }
  std::sort(all.begin(), all.end(),
            [](const Foot& a, const Foot& b) { return a.distance < b.distance; });
  std::vector<Foot> kept;
  for (const Foot& each : all) {
    const bool isAlone = std::none_of(kept.begin(), kept.end(), [&](const Foot& nearer) {
      return (nearer.place - each.place).norm() < 0.3;
    });
    if (isAlone) {
      kept.push_back(each);
    }
  }
  return kept;
}

void walk(const std::vector<Outline>& shapes, int side, double range, int steps, unsigned seed) {
  Obstacles obstacles;
  for (const Outline& shape : shapes) {
    obstacles.add({shape});
  }
  obstacles.build();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-2.0, kSpacing * side);
  std::uniform_real_distribution<double> turn(-0.3, 0.3);
  Vec2 at(place(random), place(random));
  double heading = 0.0;
  int compared = 0;
  for (int step = 0; step < steps; ++step) {
    if (step % 200 == 0) {
      at = Vec2(place(random), place(random));
    }
    heading += turn(random);
    at += 0.06 * Vec2(std::cos(heading), std::sin(heading));
    if (obstacles.isInside(at)) {
      continue;
    }
    std::vector<Obstacles::Point> found;
    obstacles.boundaryPoints(at, found, range);
    const std::vector<Foot> wanted = pointsOf(shapes, at, range);
    QCOMPARE(found.size(), wanted.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      QVERIFY2((found[k].position - wanted[k].place).norm() < 1e-9,
               qPrintable(QString::number(step)));
    }
    compared += static_cast<int>(found.size());
  }
  QVERIFY(compared > steps / 4);
}

}  // namespace

/// Boundary points asked step by step along walks, as people do, against all edges looked at anew
/// each time: what is kept of the step before must not be seen.
class BoundaryWalkTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void boundaryPoints_alongWalks_areThoseOfAllEdges_data() {
    QTest::addColumn<double>("range");
    QTest::newRow("of forces") << 5.0;
    QTest::newRow("of bodies") << 1.35;
  }

  void boundaryPoints_alongWalks_areThoseOfAllEdges() {
    QFETCH(double, range);
    walk(scatteredShapes(5, 9, 7), 5, range, 6000, 11);
  }

  void boundaryPoints_manyCorners_areThoseOfAllEdges_data() {
    addColumns<int, double>({"corners", "notch"});
    QTest::newRow("round") << 160 << 0.0;
    QTest::newRow("jagged") << 40 << 0.05;
    QTest::newRow("more edges than are kept of a square") << 600 << 0.01;
  }

  void boundaryPoints_manyCorners_areThoseOfAllEdges() {
    QFETCH(int, corners);
    QFETCH(double, notch);
    walk(scatteredShapes(4, corners, 3, notch), 4, 5.0, 1000, 5);
  }
};

QTEST_APPLESS_MAIN(BoundaryWalkTest)
#include "tst_BoundaryWalk.moc"
