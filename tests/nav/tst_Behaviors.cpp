#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/servers/Behaviors.h"

using namespace sim2d::nav2;
using sim2d::BodyTwist;

namespace {

bool isNear(double a, double b, double within = 1e-9) {
  return std::fabs(a - b) < within;
}

/// A free square of 10 m about the origin, 0.1 m cells, and a robot of 0.46 m x 0.24 m.
struct Floor {
  Costmap costmap{100, 100, 0.1, {-5.0, -5.0}};
  Polygon footprint = {{0.23, 0.12}, {-0.23, 0.12}, {-0.23, -0.12}, {0.23, -0.12}};

  void put(double x, double y, std::uint8_t cost = kLethal) {
    costmap.set(*costmap.worldToCell({x, y}), cost);
  }
  BehaviorInput at(double time, const Pose2& pose, const BodyTwist& teleop = {}) const {
    return {time, pose, costmap, footprint, true, teleop};
  }
};

}  // namespace

/// Rules of nav2_behaviors: spin.cpp, drive_on_heading.hpp, back_up.cpp, wait.cpp,
/// assisted_teleop.cpp; all cases by hand.
class BehaviorsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// sqrt(2 * 3.2 * left) between 0.4 and 1.
  void spin_speeds_followWhatIsLeft() {
    const Floor floor;
    Spin spin({}, {-1.57, 10.0}, 0.0, {{0.0, 0.0}, 0.5});
    QVERIFY(isNear(spin.cycle(floor.at(0.0, {{0.0, 0.0}, 0.5})).twist.angular, -1.0));
    const BehaviorStep step = spin.cycle(floor.at(0.1, {{0.0, 0.0}, 0.5 - 1.47}));
    QVERIFY(isNear(step.twist.angular, -std::sqrt(0.64)));
    QVERIFY(isNear(spin.turned(), -1.47));
    QVERIFY(isNear(spin.cycle(floor.at(0.2, {{0.0, 0.0}, 0.5 - 1.56})).twist.angular, -0.4));
    const BehaviorStep end = spin.cycle(floor.at(0.3, {{0.0, 0.0}, 0.5 - 1.571}));
    QVERIFY(end.status == BehaviorStatus::Succeeded);
    QVERIFY(end.hasTwist && end.twist == BodyTwist{});
  }

  void spin_wholeTurn_isCountedOverPi() {
    const Floor floor;
    Spin spin({}, {6.28, 100.0}, 0.0, {{0.0, 0.0}, 2.0});
    double turned = 0.0;
    int cycles = 0;
    for (; cycles < 1000; ++cycles) {
      const double heading = base::wrapToPi(2.0 + turned);
      const BehaviorStep step = spin.cycle(floor.at(0.1 * cycles, {{0.0, 0.0}, heading}));
      if (step.status != BehaviorStatus::Running) {
        QVERIFY(step.status == BehaviorStatus::Succeeded);
        break;
      }
      turned += 0.1 * step.twist.angular;
    }
    QVERIFY(turned >= 6.28 - 1e-6 && turned < 6.28 + 0.04);
    QVERIFY(cycles < 80);
  }

  /// A quarter turn away stands something; at first nothing is looked at.
  void spin_obstacle_isSeenAsFarAsItHasTurned() {
    Floor floor;
    floor.put(0.05, 0.25);  // the left front corner is that far left from 0.69 rad on
    Spin spin({}, {1.57, 10.0}, 0.0, {});
    QVERIFY(spin.cycle(floor.at(0.0, {})).status == BehaviorStatus::Running);
    QVERIFY(spin.cycle(floor.at(0.1, {{0.0, 0.0}, 0.3})).status == BehaviorStatus::Running);
    const BehaviorStep step = spin.cycle(floor.at(0.2, {{0.0, 0.0}, 0.4}));  // up to 0.7
    QVERIFY(step.status == BehaviorStatus::Failed);
    QVERIFY(step.error == BehaviorError::CollisionAhead);
    QVERIFY(step.twist == BodyTwist{});
    Spin blind({}, {1.57, 10.0}, 0.0, {});
    blind.cycle(floor.at(0.0, {}));
    BehaviorInput input = floor.at(0.1, {{0.0, 0.0}, 0.4});
    input.isCollisionChecked = false;
    QVERIFY(blind.cycle(input).status == BehaviorStatus::Running);
  }

  void spin_allowance_endsIt() {
    const Floor floor;
    Spin spin({}, {1.57, 2.0}, 1.0, {});
    QVERIFY(spin.cycle(floor.at(3.0, {})).status == BehaviorStatus::Running);
    const BehaviorStep step = spin.cycle(floor.at(3.05, {}));
    QVERIFY(step.status == BehaviorStatus::Failed && step.error == BehaviorError::Timeout);
    Spin endless({}, {1.57, 0.0}, 1.0, {});
    QVERIFY(endless.cycle(floor.at(300.0, {})).status == BehaviorStatus::Running);
  }

  void driveOnHeading_distance_endsIt() {
    const Floor floor;
    const Pose2 start{{1.0, 1.0}, base::kPi / 2.0};
    DriveStraight drive({}, {}, {0.5, 0.2, 10.0}, 0.0, start);
    const BehaviorStep step = drive.cycle(floor.at(0.0, start));
    QVERIFY(step.status == BehaviorStatus::Running && step.twist == (BodyTwist{0.2, 0.0}));
    QVERIFY(drive.cycle(floor.at(0.1, {{1.3, 1.39}, 0.0})).status == BehaviorStatus::Running);
    QVERIFY(isNear(drive.driven(), std::hypot(0.3, 0.39)));
    QVERIFY(drive.cycle(floor.at(0.2, {{1.3, 1.41}, 0.0})).status == BehaviorStatus::Succeeded);
    DriveStraight slow({}, {}, {0.5, 0.2, 1.0}, 0.0, start);
    QVERIFY(slow.cycle(floor.at(1.1, start)).error == BehaviorError::Timeout);
  }

  /// In 2 s at 0.2 m/s: 20 cycles of 0.02 m, from 0; the front is 0.23 m ahead.
  void driveOnHeading_obstacle_isSeenUpToTheEnd() {
    const auto statusOf = [](double obstacle, double distance) {
      Floor floor;
      floor.put(obstacle, 0.05);
      DriveStraight drive({}, {}, {distance, 0.2, 100.0}, 0.0, {});
      return drive.cycle(floor.at(0.0, {})).status;
    };
    QVERIFY(statusOf(0.65, 5.0) == BehaviorStatus::Failed);    // 0.23 + 0.38 reaches cell 0.6
    QVERIFY(statusOf(0.75, 5.0) == BehaviorStatus::Running);   // not cell 0.7
    QVERIFY(statusOf(0.55, 0.25) == BehaviorStatus::Running);  // it ends before
  }

  void driveOnHeading_signs_mustMatch() {
    const Floor floor;
    DriveStraight drive({}, {}, {0.5, -0.2, 10.0}, 0.0, {});
    QVERIFY(drive.cycle(floor.at(0.0, {})).error == BehaviorError::InvalidInput);
    DriveStraight back({}, {}, {-0.5, -0.2, 10.0}, 0.0, {});
    QVERIFY(back.cycle(floor.at(0.0, {})).twist == (BodyTwist{-0.2, 0.0}));
  }

  /// 1 m/s² up, 0.5 m/s² down, 10 Hz; near the end sqrt(2 * 0.5 * rest).
  void driveOnHeading_accelerations_rampUpAndDown() {
    const Floor floor;
    const DriveParameters limits{1.0, -0.5, 0.05};
    for (const double sign : {1.0, -1.0}) {
      DriveStraight drive({}, limits, {sign * 1.0, sign * 0.25, 100.0}, 0.0, {});
      const auto speedAt = [&](double driven) {
        return sign * drive.cycle(floor.at(0.0, {{sign * driven, 0.0}, 0.0})).twist.linear;
      };
      QVERIFY(isNear(speedAt(0.0), 0.1));
      QVERIFY(isNear(speedAt(0.01), 0.2));
      QVERIFY(isNear(speedAt(0.03), 0.25));
      QVERIFY(isNear(speedAt(0.96), std::sqrt(0.04)));
      QVERIFY(isNear(speedAt(0.99), std::sqrt(0.01)));
      QVERIFY(isNear(speedAt(0.9999), 0.05));
    }
  }

  void backUp_goal_isDrivenBackwards() {
    for (const double sign : {1.0, -1.0}) {
      const DriveStraight::Goal goal = DriveStraight::backUp({sign * 0.3, sign * 0.05, 7.0});
      QCOMPARE(goal.distance, -0.3);
      QCOMPARE(goal.speed, -0.05);
      QCOMPARE(goal.timeAllowance, 7.0);
    }
    Floor floor;
    floor.put(-0.25, 0.05);  // behind it
    DriveStraight drive({}, {}, DriveStraight::backUp({0.3, 0.05, 10.0}), 0.0, {});
    QVERIFY(drive.cycle(floor.at(0.0, {})).error == BehaviorError::CollisionAhead);
  }

  void isBehaviorBlocked_costs_decide() {
    Floor floor;
    // Cells of the edges: rows from -0.2 and from 0.1 on; those between lie inside.
    floor.put(0.15, 0.15, kInscribed);
    floor.put(0.05, 0.05, kLethal);
    floor.put(-0.05, 0.05, kNoInformation);
    QVERIFY(!isBehaviorBlocked(floor.at(0.0, {}), {}));
    floor.put(0.05, -0.15, kNoInformation);
    QVERIFY(isBehaviorBlocked(floor.at(0.0, {}), {}));
    QVERIFY(isBehaviorBlocked(floor.at(0.0, {}), {{5.1, 0.0}, 0.0}));   // off the map
    QVERIFY(isBehaviorBlocked(floor.at(0.0, {}), {{4.95, 3.0}, 0.0}));  // a corner is
    QVERIFY(!isBehaviorBlocked(floor.at(0.0, {}), {{4.7, 3.0}, 0.0}));
  }

  void wait_time_passesSilently() {
    const Floor floor;
    const Wait wait(1.5, 2.0);
    const BehaviorStep step = wait.cycle(floor.at(3.4, {}));
    QVERIFY(step.status == BehaviorStatus::Running && !step.hasTwist);
    const BehaviorStep end = wait.cycle(floor.at(3.5, {}));
    QVERIFY(end.status == BehaviorStatus::Succeeded && end.hasTwist);
  }

  /// Its front is at 0.28 m, the wall at 0.5 m: met in the third step at 1 m/s.
  void assistedTeleop_obstacle_slowsDown() {
    Floor floor;
    floor.put(0.55, 0.05);
    const AssistedTeleop teleop({}, 10.0, 0.0);
    const Pose2 pose{{0.05, 0.0}, 0.0};
    const BehaviorStep step = teleop.cycle(floor.at(0.0, pose, {1.0, 1e-3}));
    QVERIFY(isNear(step.twist.linear, 0.3) && isNear(step.twist.angular, 0.3e-3));
    QVERIFY((teleop.cycle(floor.at(0.0, pose, {0.2, 0.0})).twist == BodyTwist{0.2, 0.0}));
    const BehaviorStep imminent = teleop.cycle(floor.at(0.0, {{0.25, 0.0}, 0.0}, {1.0, 0.0}));
    QVERIFY(imminent.twist == BodyTwist{});
    QVERIFY(teleop.cycle(floor.at(10.05, {})).error == BehaviorError::Timeout);
    // To the left, turned: the lateral wish moves it there.
    Floor side;
    side.put(-0.55, 0.0);
    const BehaviorStep strafe =
        teleop.cycle(side.at(0.0, {{0.0, 0.0}, base::kPi / 2.0}, {0.0, 0.0, 1.0}));
    QVERIFY(strafe.twist.lateral > 0.3 && strafe.twist.lateral < 0.6);
  }

  void server_cycles_areCountedFromTheStart() {
    const Floor floor;
    BehaviorServer server({}, {}, {});
    QVERIFY(!server.update(floor.at(0.0, {})));
    server.spin({1.57, 10.0}, 1.05, {});
    std::vector<int> cycles;
    for (int step = 21; step < 28; ++step) {  // steps of 0.05 s, cycles of 0.1 s
      if (server.update(floor.at(0.05 * step, {}))) {
        cycles.push_back(step);
      }
    }
    QVERIFY(cycles == std::vector<int>({21, 23, 25, 27}));
    server.wait(0.2, 2.0);
    QVERIFY(!server.update(floor.at(2.0, {}))->hasTwist);
    QVERIFY(!server.update(floor.at(2.05, {})));
    QVERIFY(server.update(floor.at(2.1, {})).has_value());
    QVERIFY(server.isRunning());
    QVERIFY(server.update(floor.at(2.2, {}))->status == BehaviorStatus::Succeeded);
    QVERIFY(!server.isRunning());
    QVERIFY(!server.update(floor.at(2.3, {})));
  }

  void server_code_isOfTheAction() {
    const Floor floor;
    BehaviorServer server({}, {}, {});
    server.spin({1.57, 1.0}, 0.0, {});
    server.update(floor.at(5.0, {}));
    QCOMPARE(int{server.code()}, 701);
    server.driveOnHeading({0.1, -0.1, 1.0}, 0.0, {});
    server.update(floor.at(0.0, {}));
    QCOMPARE(int{server.code()}, 724);
    Floor blocked;
    blocked.put(-0.25, 0.05);
    server.backUp({0.3, 0.05, 10.0}, 0.0, {});
    server.update(blocked.at(0.0, {}));
    QCOMPARE(int{server.code()}, 714);
    server.assistedTeleop(1.0, 0.0);
    QVERIFY((server.update(floor.at(0.0, {}, {0.3, 0.0}))->twist == BodyTwist{0.3, 0.0}));
    server.update(floor.at(2.0, {}));
    QCOMPARE(int{server.code()}, 731);
    server.wait(0.0, 0.0);
    server.update(floor.at(0.0, {}));
    QCOMPARE(int{server.code()}, 0);
  }

  void server_cancel_endsIt() {
    const Floor floor;
    BehaviorServer server({}, {}, {});
    server.spin({1.57, 10.0}, 0.0, {});
    server.cancel();
    QVERIFY(!server.isRunning());
    QVERIFY(!server.update(floor.at(1.0, {})));
  }

  void driveDefaults_distros_differ() {
    QCOMPARE(driveDefaults(Distro::Humble).accelerationLimit, 0.0);
    QCOMPARE(driveDefaults(Distro::Jazzy).minimumSpeed, 0.0);
    QCOMPARE(driveDefaults(Distro::Main).accelerationLimit, 2.5);
    QCOMPARE(driveDefaults(Distro::Main).decelerationLimit, -2.5);
    QCOMPARE(driveDefaults(Distro::Main).minimumSpeed, 0.10);
  }
};

QTEST_APPLESS_MAIN(BehaviorsTest)
#include "tst_Behaviors.moc"
