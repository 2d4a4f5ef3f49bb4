#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/map/Outlines.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/FootprintGap.h"
#include "sim2d/nav/RobotTypes.h"

using namespace sim2d;

namespace {

const RobotType& typeOf(const char* name) {
  const RobotType* type = findRobotType(name);
  if (type == nullptr) {
    qFatal("there is no robot %s", name);
  }
  return *type;
}

bool isValidLidar(const RobotLidar& lidar, const RobotType& type) {
  const bool fits = std::hypot(lidar.x, lidar.y) <= circumscribedRadius(type.body.footprint);
  return lidar.beams > 1 && lidar.angleMin < lidar.angleMax && lidar.angleMin >= -base::kPi &&
         lidar.angleMax < base::kPi && lidar.range > 0.0 && lidar.rate > 0.0 && fits &&
         lidar.height > 0.0 && lidar.noise >= 0.0;
}

BatteryParameters battery() {
  BatteryParameters parameters;
  parameters.capacity = 100.0;
  return parameters;
}

}  // namespace

class RobotTypesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void robotTypes_all_areThere() {
    std::set<std::string> names;
    for (const RobotType& type : robotTypes()) {
      QVERIFY(names.insert(type.name).second);
      QVERIFY(!type.title.empty() && !type.source.empty());
      QVERIFY(findRobotType(type.name) == &type);
    }
    for (const char* name :
         {"generic", "pmb2", "tiago", "nova_carter", "jetbot", "create3", "turtlebot3_burger",
          "turtlebot3_waffle", "turtlebot4", "pepper", "jackal", "wheelchair", "ackermann_car"}) {
      QVERIFY2(names.count(name) == 1, name);
    }
    QCOMPARE(robotTypes().front().name, std::string("generic"));
  }

  void robotTypes_bodies_areValid() {
    for (const RobotType& type : robotTypes()) {
      const Footprint& footprint = type.body.footprint;
      const DriveLimits& limits = type.body.limits;
      QVERIFY2(inscribedRadius(footprint) > 0.0, type.name.c_str());
      QVERIFY(std::fabs(circumscribedRadius(footprint) - footprint.radius) < 1e-15);
      if (!footprint.isDisc()) {
        QVERIFY(isSimple(footprint.corners));
        QVERIFY(signedArea(footprint.corners) > 0.0);
      }
      QVERIFY(limits.maxVel > 0.0 && limits.maxReverse >= 0.0 && limits.maxAcc > 0.0);
      QVERIFY(limits.maxOmega > 0.0 && limits.maxAlpha > 0.0);
      QCOMPARE(limits.turningRadius > 0.0, type.body.kinematics == Kinematics::Ackermann);
      QVERIFY(type.body.mass > 0.0 && type.height > 0.0);
    }
  }

  void robotTypes_lidars_areValid() {
    int lidars = 0;
    for (const RobotType& type : robotTypes()) {
      if (type.lidar) {
        ++lidars;
        QVERIFY2(isValidLidar(*type.lidar, type), type.name.c_str());
      }
    }
    QVERIFY(lidars >= 5);
    // A beam per degree all round: the last one ends a degree before the first.
    const RobotLidar& burger = *typeOf("turtlebot3_burger").lidar;
    QVERIFY(std::fabs(burger.angleMin + base::kPi) < 1e-15);
    QVERIFY(std::fabs(burger.angleMax - 179.0 * base::kPi / 180.0) < 1e-14);
    const RobotLidar& pmb2 = *typeOf("pmb2").lidar;  // SICK TIM571: 666 beams over +-110 degrees
    QCOMPARE(pmb2.beams, 666);
    QVERIFY(std::fabs(pmb2.angleMax - 1.919862) < 1e-6);
    QVERIFY(std::fabs(pmb2.angleMin + pmb2.angleMax) < 1e-15);
    QCOMPARE(pmb2.range, 25.0);
    QCOMPARE(pmb2.x, 0.202);
  }

  void robotTypes_figures_areThoseOfTheSources() {
    const RobotBody& generic = typeOf("generic").body;
    QCOMPARE(generic.footprint.radius, 0.35);
    QCOMPARE(generic.mass, 50.0);
    const RobotBody& pmb2 = typeOf("pmb2").body;
    QVERIFY(std::fabs(pmb2.mass - (28.3 + 2 * 1.8 + 1.0)) < 1e-12);
    QCOMPARE(pmb2.footprint.radius, 0.27);
    QCOMPARE(pmb2.limits.maxReverse, 0.2);
    QCOMPARE(pmb2.limits.maxOmega, 1.05);
    QCOMPARE(typeOf("turtlebot3_burger").body.limits.maxVel, 0.22);
    QCOMPARE(typeOf("turtlebot3_burger").body.limits.maxOmega, 2.84);
    QCOMPARE(typeOf("turtlebot3_waffle").body.limits.maxVel, 0.26);
    QCOMPARE(typeOf("turtlebot4").body.mass, 3.945);
    QCOMPARE(typeOf("turtlebot4").body.limits.maxVel, 0.31);
    QCOMPARE(typeOf("create3").body.footprint.radius, 0.164);
    QCOMPARE(typeOf("create3").body.limits.maxVel, 0.306);
    QVERIFY(typeOf("pepper").body.kinematics == Kinematics::Omnidirectional);
    QVERIFY(std::fabs(typeOf("jackal").body.mass - 18.42) < 0.05);  // 16.5 + 4 x 0.48
    QCOMPARE(typeOf("ackermann_car").body.limits.turningRadius, 0.65);
  }

  void robotTypes_boxes_haveTheSizesOfTheSources() {
    const auto sizeOf = [](const char* name) {
      const std::vector<Vec2>& corners = typeOf(name).body.footprint.corners;
      return Vec2(corners[2] - corners[0]);
    };
    QVERIFY((sizeOf("nova_carter") - Vec2(0.725, 0.500)).norm() < 1e-12);
    QVERIFY((sizeOf("jackal") - Vec2(0.508, 0.4318)).norm() < 1e-12);
    QVERIFY((sizeOf("turtlebot3_burger") - Vec2(0.138, 0.178)).norm() < 1e-12);
    QVERIFY((sizeOf("turtlebot3_waffle") - Vec2(0.281, 0.306)).norm() < 1e-12);
    QVERIFY((sizeOf("ackermann_car") - Vec2(0.30, 0.16)).norm() < 1e-12);
    // The padded footprint of Nova Carter's navigation holds its body.
    const std::vector<Vec2>& carter = typeOf("nova_carter").body.footprint.corners;
    QVERIFY(carter[0].x() >= -0.607 && carter[2].x() <= 0.14);
  }

  void robotTypes_wheelchair_turnsWithinThirtyInches() {
    QVERIFY(std::fabs(circumscribedRadius(typeOf("wheelchair").body.footprint) - 30 * 0.0254) <
            0.002);
  }

  void findRobotType_unknown_isNull() {
    QVERIFY(findRobotType("hal9000") == nullptr);
    QVERIFY(findRobotType("") == nullptr);
  }

  // The battery of a robot against numbers calculated by hand.
  void effort_isTheLargerShare() {
    DriveLimits limits;
    limits.maxVel = 2.0;
    limits.maxOmega = 1.0;
    QCOMPARE(driveEffort({}, limits), 0.0);
    QCOMPARE(driveEffort({1.0, 0.2, 0.0}, limits), 0.5);
    QCOMPARE(driveEffort({-1.0, 0.8, 0.0}, limits), 0.8);
    QCOMPARE(driveEffort({0.6, 0.0, 0.8}, limits), 0.5);  // sideways as well: 1 m/s
    QCOMPARE(driveEffort({5.0, 0.0, 0.0}, limits), 1.0);
  }

  /// 20 W and 60 W at full effort; 120 W at a charger.
  void power_isOfMotionOrCharger() {
    QCOMPARE(batteryPower(battery(), 0.0, false), -20.0);
    QCOMPARE(batteryPower(battery(), 0.5, false), -50.0);
    QCOMPARE(batteryPower(battery(), 0.5, true), 120.0);
  }

  /// 50 W of 100 Wh for half an hour take a quarter.
  void level_isEnergyByCapacity() {
    QVERIFY(std::fabs(chargeLevelAfter(battery(), 0.8, -50.0, 1800.0) - 0.55) < 1e-12);
    QVERIFY(std::fabs(chargeLevelAfter(battery(), 0.5, 120.0, 900.0) - 0.8) < 1e-12);
    QCOMPARE(chargeLevelAfter(battery(), 0.1, -50.0, 1800.0), 0.0);
    QCOMPARE(chargeLevelAfter(battery(), 0.9, 120.0, 1800.0), 1.0);
  }

  /// Half way between 21 and 25.2 V; 46.2 W are 2 A.
  void voltage_isLinearInTheLevel() {
    const BatteryState state = batteryState(battery(), 0.5, 46.2, true);
    QVERIFY(std::fabs(state.voltage - 23.1) < 1e-12);
    QVERIFY(std::fabs(state.current - 2.0) < 1e-12);
    QCOMPARE(state.level, 0.5);
    QVERIFY(state.isCharging);
    QVERIFY(std::fabs(batteryState(battery(), 1.0, -25.2, false).current + 1.0) < 1e-12);
  }
};

QTEST_GUILESS_MAIN(RobotTypesTest)
#include "tst_RobotTypes.moc"
