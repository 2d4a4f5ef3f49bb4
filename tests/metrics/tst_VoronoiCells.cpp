#include <QtTest>

#include "HandMade.h"
#include "metrics/VoronoiCells.h"
#include "sim2d/base/Rng.h"

using namespace metrics;

namespace {

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

/// Voronoi cells among many walls.
class VoronoiCellsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
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

QTEST_APPLESS_MAIN(VoronoiCellsTest)
#include "tst_VoronoiCells.moc"
