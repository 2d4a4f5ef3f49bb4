#include <cmath>

#include <QtTest>

#include "sim2d/world/RouteFollower.h"

using namespace sim2d;

namespace {

constexpr double kRadius = 0.3;
const Vec2 kFrom(0.0, 0.0);
const Vec2 kNext(6.0, 0.0);

/// The open plane with walls.
struct Place {
  explicit Place(const std::vector<std::vector<Vec2>>& walls = {}) {
    for (const std::vector<Vec2>& wall : walls) {
      obstacles.add(wallOutlines(wall, 0.1));
    }
    obstacles.build();
    navigation = std::make_unique<NavigationMap>(
        OccupancyGrid(), obstacles,
        std::vector<Vec2>{kFrom - Vec2(2.0, 2.0), kNext + Vec2(2.0, 2.0)});
  }
  std::optional<Vec2> beside(const std::vector<StandingBody>& standing) {
    return passingPoint(standing, kRadius, kFrom, kNext, *navigation);
  }
  Obstacles obstacles;
  std::unique_ptr<NavigationMap> navigation;
};

}  // namespace

/// Ways round people and robots that stand.
class DetourTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void nobodyInTheWay_isNothing() {
    Place plane;
    QVERIFY(!plane.beside({}));
    QVERIFY(!plane.beside({{Vec2(-1.0, 0.0), 0.35}}));  // behind
    QVERIFY(!plane.beside({{Vec2(1.0, 0.9), 0.35}}));   // beside, with room
    QVERIFY(!plane.beside({{Vec2(5.0, 0.0), 0.35}}));   // far
  }

  void bodyAhead_isPassedWithRoom() {
    Place plane;
    const std::optional<Vec2> place = plane.beside({{Vec2(1.0, 0.1), 0.35}});
    QVERIFY(place);
    QVERIFY(std::fabs((*place - Vec2(1.0, 0.1)).norm() - 0.8) < 1e-9);  // 0.3 + 0.35 + 0.15
    QVERIFY(place->y() < 0.0);                                          // the shorter side
  }

  void wallOnOneSide_takesTheOther() {
    Place room({{Vec2(-1.0, -0.5), Vec2(7.0, -0.5)}});
    const std::optional<Vec2> place = room.beside({{Vec2(1.0, 0.1), 0.35}});
    QVERIFY(place);
    QVERIFY(place->y() > 0.0);
  }

  void wallsOnBothSides_isNothing() {
    Place corridor({{Vec2(-1.0, -0.5), Vec2(7.0, -0.5)}, {Vec2(-1.0, 0.5), Vec2(7.0, 0.5)}});
    QVERIFY(!corridor.beside({{Vec2(1.0, 0.0), 0.35}}));
  }

  void secondBodyBeside_takesTheOtherSide() {
    Place plane;
    const std::optional<Vec2> place =
        plane.beside({{Vec2(1.0, 0.1), 0.35}, {Vec2(1.0, -0.7), 0.35}});
    QVERIFY(place);
    QVERIFY(place->y() > 0.0);
  }

  void touchingBody_isLeft() {
    Place plane;
    const std::optional<Vec2> place = plane.beside({{Vec2(0.65, 0.0), 0.35}});
    QVERIFY(place);
    QVERIFY(std::fabs(place->y()) > 0.5);
  }

  /// A follower that cannot pass walks to the place beside before it heads for the goal again.
  void follower_goesRoundAndOn() {
    Place plane;
    const StandingBody robot{Vec2(1.0, 0.0), 0.35};
    RouteFollower follower;
    RouteFollower::Request request;
    request.radius = kRadius;
    request.target.position = kNext;
    request.target.radius = 0.2;
    bool wasStuck = false;
    for (int step = 0; step < 300; ++step) {
      request.time = 0.05 * step;
      const RouteFollower::Guidance leg =
          follower.follow(request, *plane.navigation, plane.obstacles);
      if (leg.stuck) {
        wasStuck = true;
        follower.insertDetour(request, {robot}, *plane.navigation);
        continue;
      }
      request.position += 0.05 * leg.direction;
      const Vec2 apart = request.position - robot.position;
      if (apart.norm() < kRadius + robot.radius) {  // bodies slide along each other
        request.position = robot.position + (kRadius + robot.radius) / apart.norm() * apart;
      }
    }
    QVERIFY(wasStuck);
    QVERIFY((request.position - kNext).norm() <= 0.25);
  }
};

QTEST_APPLESS_MAIN(DetourTest)
#include "tst_Detour.moc"
