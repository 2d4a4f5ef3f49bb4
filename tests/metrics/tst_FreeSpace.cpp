#include <cmath>

#include <QtTest>

#include "HandMade.h"
#include "metrics/Samples.h"
#include "metrics/VoronoiCells.h"
#include "sim2d/base/Rng.h"
#include "sim2d/map/PathPlanner.h"
#include "tests/map/MapSketch.h"

using namespace sketch;
using namespace metrics;

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

constexpr double kRobotRadius = 0.35;  // [m]

constexpr double kRadius = 2.0;  // [m]

class Dice {
 public:
  explicit Dice(std::uint32_t seed) : rng_(seed, 1) {}
  double between(double low, double high) {
    return low + (high - low) * rng_.uniform01(base::DrawPurpose::Test, next_++);
  }

 private:
  base::AgentRng rng_;
  std::uint32_t next_ = 0;
};

/// A person at the origin among others and walls.
struct Scene {
  std::vector<Vec2> others;
  std::vector<sim2d::Segment> walls;
  RunContext context;
};

/// Boxes askew, many of which cross each other; none covers the person.
Scene randomScene(std::uint32_t seed) {
  Dice dice(seed);
  Scene scene;
  sim2d::Obstacles obstacles;
  for (int k = 0; k < 3 + static_cast<int>(seed % 9); ++k) {
    const Vec2 middle(dice.between(-4.0, 4.0), dice.between(-4.0, 4.0));
    const Vec2 along = dice.between(0.05, 0.9) * base::directionOf(dice.between(-3.0, 3.0));
    const Vec2 across = dice.between(0.05, 0.9) * Vec2(-along.y(), along.x()).normalized();
    if (middle.norm() < along.norm() + across.norm() + 0.05) {
      continue;
    }
    sim2d::Outline box;
    box.points = {middle - along - across, middle + along - across, middle + along + across,
                  middle - along + across};
    obstacles.add({box});
    for (std::size_t i = 0; i < 4; ++i) {
      scene.walls.push_back({box.points[i], box.points[(i + 1) % 4]});
    }
  }
  obstacles.build();
  scene.context.walls = std::make_shared<const sim2d::Obstacles>(std::move(obstacles));
  for (int k = 0; k < 5; ++k) {
    scene.others.emplace_back(dice.between(-3.0, 3.0), dice.between(-3.0, 3.0));
  }
  return scene;
}

Scene sceneOf(const sim2d::Outline& outline) {
  Scene scene;
  sim2d::Obstacles obstacles;
  obstacles.add({outline});
  obstacles.build();
  scene.context.walls = std::make_shared<const sim2d::Obstacles>(std::move(obstacles));
  for (std::size_t i = 0; i < outline.points.size(); ++i) {
    scene.walls.push_back({outline.points[i], outline.points[(i + 1) % outline.points.size()]});
  }
  return scene;
}

/// Along the unit vector to the line of two points; infinite when it runs beside or away.
double distanceAlong(const Vec2& direction, const Vec2& a, const Vec2& b) {
  const double distance = base::cross(a, b - a) / base::cross(direction, b - a);
  return distance > 0.0 ? distance : HUGE_VAL;
}

bool meets(const Vec2& direction, const sim2d::Segment& wall) {
  return (base::cross(direction, wall.a) > 0.0) != (base::cross(direction, wall.b) > 0.0);
}

/// Turns at which a line or wall may stop to be the first: its ends, where it meets the circle or
/// another one.
std::vector<double> turnsOf(const std::vector<sim2d::Segment>& lines) {
  std::vector<double> turns = {-base::kPi, base::kPi};
  const auto turnTo = [&turns](const Vec2& place) {
    turns.push_back(std::atan2(place.y(), place.x()));
  };
  for (const sim2d::Segment& line : lines) {
    turnTo(line.a);
    turnTo(line.b);
    const Vec2 along = (line.b - line.a).normalized();
    const Vec2 foot = line.a - along.dot(line.a) * along;
    const double half = std::sqrt(std::max(kRadius * kRadius - foot.squaredNorm(), 0.0));
    turnTo(foot + half * along);
    turnTo(foot - half * along);
    for (const sim2d::Segment& other : lines) {
      const double across = base::cross(line.b - line.a, other.b - other.a);
      if (across != 0.0) {
        const double share = base::cross(other.a - line.a, other.b - other.a) / across;
        turnTo(line.a + share * (line.b - line.a));
      }
    }
  }
  std::sort(turns.begin(), turns.end());
  return turns;
}

/// The slow way: between two turns one line (or the circle) is the first, and what lies before it
/// has half d^2 (tan - tan) of area, d being its distance. Bisectors count as long walls.
double plainArea(const Scene& scene) {
  std::vector<sim2d::Segment> lines = scene.walls;
  for (const Vec2& other : scene.others) {
    const bool isHidden =
        std::any_of(scene.walls.begin(), scene.walls.end(), [&](const sim2d::Segment& wall) {
          return meets(other, wall) && distanceAlong(other, wall.a, wall.b) < 1.0;
        });
    if (!isHidden) {
      const Vec2 aside = 1e3 * Vec2(-other.y(), other.x()).normalized();
      lines.push_back({0.5 * other - aside, 0.5 * other + aside});
    }
  }
  const std::vector<double> turns = turnsOf(lines);
  double area = 0.0;
  for (std::size_t k = 1; k < turns.size(); ++k) {
    const Vec2 middle = base::directionOf(0.5 * (turns[k - 1] + turns[k]));
    double nearest = kRadius;
    const sim2d::Segment* first = nullptr;
    for (const sim2d::Segment& line : lines) {
      const double distance = distanceAlong(middle, line.a, line.b);
      if (meets(middle, line) && distance < nearest) {
        nearest = distance;
        first = &line;
      }
    }
    if (first == nullptr) {
      area += 0.5 * kRadius * kRadius * (turns[k] - turns[k - 1]);
      continue;
    }
    const Vec2 along = (first->b - first->a).normalized();
    const Vec2 foot = first->a - along.dot(first->a) * along;
    const double normal = std::atan2(foot.y(), foot.x());
    area +=
        0.5 * foot.squaredNorm() * (std::tan(turns[k] - normal) - std::tan(turns[k - 1] - normal));
  }
  return area;
}

/// A room of 10 x 10 m with 8000 specks of 5 cm.
std::shared_ptr<const sim2d::Obstacles> specks() {
  Dice dice(5);
  sim2d::Obstacles obstacles;
  for (int k = 0; k < 8000; ++k) {
    const Vec2 low(0.05 * std::floor(dice.between(0.0, 200.0)),
                   0.05 * std::floor(dice.between(0.0, 200.0)));
    sim2d::Outline speck;
    speck.points = {low, low + Vec2(0.05, 0.0), low + Vec2(0.05, 0.05), low + Vec2(0.0, 0.05)};
    obstacles.add({speck});
  }
  obstacles.build();
  return std::make_shared<const sim2d::Obstacles>(std::move(obstacles));
}

}  // namespace

class FreeSpaceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // The ways that metrics measure against; lengths by hand.

  /// The narrow way costs the planner of a run more than the way round, which is longer by 15 %.
  void narrowPassage_isTakenWhereItIsShorter() {
    const metrics::RunContext context = contextOf(twoBlocks(), kRobotRadius);
    const double narrow = 8.0 + 2.0 * roundACorner(1.0, 7.0 - 6.45, kRobotRadius);
    const double wide = 8.0 + 2.0 * roundACorner(1.0, 8.5 - 7.0, kRobotRadius);
    QVERIFY(wide > 1.15 * narrow);
    const double length = lengthBetween(context, {1.0, 7.0}, {11.0, 7.0});
    QVERIFY2(isAbout(length, narrow), qPrintable(QString::number(length)));
  }
  void wayRound_isTakenWhereItIsShorter() {
    const metrics::RunContext context = contextOf(twoBlocks(), kRobotRadius);
    const double wide = 8.0 + 2.0 * roundACorner(1.0, 8.5 - 8.0, kRobotRadius);
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
    const metrics::RunContext context = contextOf(sketch, kRobotRadius);
    QVERIFY(context.map.width() * context.map.height() > DistanceField::kMaxCells);
    const double length = lengthBetween(context, {60.0, 48.0}, {60.0, 54.0});
    const double expected = 2.0 + 2.0 * roundACorner(2.0, 40.0, kRobotRadius);
    QVERIFY2(isAbout(length, expected), qPrintable(QString::number(length)));
  }

  void straightWay_isTheDistance() {
    const metrics::RunContext context = contextOf(twoBlocks(), kRobotRadius);
    QCOMPARE(lengthBetween(context, {1.0, 6.0}, {11.0, 6.0}), 10.0);
    QCOMPARE(lengthBetween(context, {1.0, 1.0}, {4.0, 2.0}), std::sqrt(10.0));
  }

  // Voronoi cells among many walls.

  void plainArea_ofKnownShapes_isRight() {
    Scene scene;
    QVERIFY(std::fabs(plainArea(scene) - 4.0 * base::kPi) < 1e-12);
    scene.others = {Vec2(2.0, 0.0)};  // leaves all but the segment beyond x = 1
    const double cap = 4.0 * std::acos(0.5) - std::sqrt(3.0);
    QVERIFY(std::fabs(plainArea(scene) - (4.0 * base::kPi - cap)) < 1e-12);
  }

  void area_amongRandomBoxes_isThatOfThePlainWay() {
    VoronoiCellAreas areas(kRadius);
    int isSmaller = 0;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
      const Scene scene = randomScene(seed);
      const double expected = plainArea(scene);
      const double area = areas.areaOf(Vec2(0, 0), scene.others, scene.context);
      QVERIFY2(std::fabs(area - expected) < 1e-9,
               qPrintable(QStringLiteral("seed %1: %2, not %3").arg(seed).arg(area).arg(expected)));
      Scene open = scene;
      open.walls.clear();
      isSmaller += expected < plainArea(open) - 1e-6 ? 1 : 0;
    }
    QVERIFY(isSmaller > 150);  // the walls mattered
  }

  /// Bisectors of four on one circle meet in one corner.
  void area_inRowsBesideAWall_isThatOfThePlainWay() {
    sim2d::Outline wall;
    wall.points = {Vec2(-3.0, -0.6), Vec2(3.0, -0.6), Vec2(3.0, -0.4), Vec2(-3.0, -0.4)};
    Scene scene = sceneOf(wall);
    VoronoiCellAreas areas(kRadius);
    for (int i = 0; i < 20; ++i) {
      for (int k = 0; k < 20; ++k) {
        const double x = 0.3 + 0.05 * i;
        const double y = 0.3 + 0.05 * k;
        scene.others = {Vec2(x, 0.0), Vec2(-x, 0.0), Vec2(0.0, y), Vec2(x, y), Vec2(-x, y)};
        const double expected = plainArea(scene);
        const double area = areas.areaOf(Vec2(0, 0), scene.others, scene.context);
        QVERIFY2(
            std::fabs(area - expected) < 1e-9,
            qPrintable(QStringLiteral("%1, %2: %3, not %4").arg(x).arg(y).arg(area).arg(expected)));
      }
    }
  }

  /// Which of its ends is the first is a matter of rounding.
  void area_wallSeenEdgeOn_takesWhatIsBehind() {
    VoronoiCellAreas areas(kRadius);
    for (int k = 0; k < 200; ++k) {
      const Vec2 along = base::directionOf(-3.1 + 0.031 * k);
      sim2d::Outline wedge;
      wedge.points = {0.6 * along, 1.7 * along, 1.1 * along + 0.3 * Vec2(-along.y(), along.x())};
      const Scene scene = sceneOf(wedge);
      const double expected = plainArea(scene);
      const double area = areas.areaOf(Vec2(0, 0), {}, scene.context);
      QVERIFY2(std::fabs(area - expected) < 1e-9,
               qPrintable(QStringLiteral("%1: %2, not %3").arg(k).arg(area).arg(expected)));
    }
  }

  /// Walls cubed would take minutes: the limit of the program ends it then.
  void area_amongManySpecks_ends() {
    RunContext context;
    context.walls = specks();
    Dice dice(9);
    std::vector<Vec2> people(20);
    for (Vec2& person : people) {
      person.x() = dice.between(0.0, 10.0);
      person.y() = dice.between(0.0, 10.0);
    }
    VoronoiCellAreas areas(kRadius);
    double sum = 0.0;
    for (const Vec2& person : people) {
      sum += areas.areaOf(person, people, context);
    }
    QVERIFY(sum > 0.0 && std::isfinite(sum));
  }
};

QTEST_APPLESS_MAIN(FreeSpaceTest)
#include "tst_FreeSpace.moc"
