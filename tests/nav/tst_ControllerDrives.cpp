#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/control/ControllerServer.h"
#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "tests/nav/ControlScene.h"

using namespace control_scene;
using base::Vec2;
using sim2d::BodyTwist;

namespace {

using Names = std::vector<std::string>;
constexpr double kStep = 0.05;  // [s]

/// The controller_server's block for a controller under its usual name.
Nav2ParameterBlock nodeOf(const std::string& plugin, Distro distro) {
  Nav2ParameterBlock node{{"FollowPath.plugin", plugin}};
  node["failure_tolerance"] = 0.3;
  if (plugin == "dwb_core::DWBLocalPlanner") {
    Nav2ParameterBlock keys = bringup();
    keys["critics"] = Names{"RotateToGoal", "Oscillation", "BaseObstacle", "GoalAlign",
                            "PathAlign",    "PathDist",    "GoalDist"};
    keys["RotateToGoal.scale"] = 32.0;
    for (const auto& [key, value] : keys) {
      node["FollowPath." + key] = value;
    }
  }
  if (plugin.find("Shim") != std::string::npos) {
    node[distro >= Distro::Lyrical ? "FollowPath.primary_controller.plugin"
                                   : "FollowPath.primary_controller"] =
        std::string("nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController");
  }
  return node;
}

/// Round a quarter of a circle of 1.5 m and straight on; it ends turned to the side.
Path bend() {
  Path path;
  for (int i = 0; i <= 47; ++i) {
    const double angle = base::kPi / 2.0 * i / 47.0;
    path.push_back({1.5 * Vec2(std::sin(angle), 1.0 - std::cos(angle)), angle});
  }
  for (int i = 1; i <= 20; ++i) {
    path.push_back({Vec2(1.5, 1.5 + 0.05 * i), base::kPi / 2.0});
  }
  path.back().heading = 0.5;
  return path;
}

/// Walls 0.7 m beside the bend, in a local map that follows the robot.
void look(Scene& scene) {
  const Vec2 corner = (scene.robot.position / 0.05).array().floor() * 0.05;
  scene.costmap.setOrigin(corner - Vec2(1.5, 1.5));
  for (int row = 0; row < 60; ++row) {
    for (int column = 0; column < 60; ++column) {
      const Vec2 place = scene.costmap.cellToWorld({column, row});
      const double off = place.y() < 1.5 ? (place - Vec2(0.0, 1.5)).norm() - 1.5 : place.x() - 1.5;
      const double d = 0.7 - std::abs(off);  // to the wall
      const double cost = d < 0.0      ? 254.0
                          : d < 0.2255 ? 253.0
                                       : 252.0 * std::exp(-3.0 * (d - 0.2255));
      scene.costmap.set({column, row}, static_cast<std::uint8_t>(cost));
    }
  }
}

struct Drive {
  FollowFeedback last;
  std::vector<Pose2> poses;
};

Drive driven(const std::string& plugin, Distro distro) {
  Scene scene(distro);
  scene.robot.heading = -1.2;  // looks elsewhere
  const auto server = *makeControllerServer(nodeOf(plugin, distro), distro);
  FollowPathGoal goal;
  goal.path = bend();
  server->follow(goal);
  Drive drive;
  for (int i = 0; i < 1200; ++i) {  // a minute
    look(scene);
    drive.last =
        server->update({scene.robot, scene.speed, scene.costmap, scene.shape, true, i * kStep});
    if (drive.last.status != FollowStatus::Running) {
      break;
    }
    scene.speed = *drive.last.command;
    scene.robot.position += kStep * scene.speed.linear * scene.robot.direction();
    scene.robot.heading = base::wrapToPi(scene.robot.heading + kStep * scene.speed.angular);
    drive.poses.push_back(scene.robot);
  }
  return drive;
}

}  // namespace

/// Controllers round a bend between walls, by the server, until the goal checker is content.
class ControllerDrivesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void bend_isDrivenToItsEnd_alwaysTheSame_data() {
    QTest::addColumn<QString>("plugin");
    QTest::addColumn<int>("distro");
    const char* plugins[] = {
        "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController",
        "dwb_core::DWBLocalPlanner", "nav2_graceful_controller::GracefulController",
        "nav2_rotation_shim_controller::RotationShimController"};
    const char* names[] = {"pursuit", "dwb", "graceful", "shim"};
    for (int i = 0; i < 4; ++i) {
      for (const Distro distro : kDistros) {
        QTest::addRow("%s, %s", names[i], distroName(distro))
            << QString::fromLatin1(plugins[i]) << static_cast<int>(distro);
      }
    }
  }

  void bend_isDrivenToItsEnd_alwaysTheSame() {
    QFETCH(QString, plugin);
    QFETCH(int, distro);
    const Drive drive = driven(plugin.toStdString(), static_cast<Distro>(distro));
    QVERIFY2(drive.last.status == FollowStatus::Succeeded, drive.last.words.c_str());
    const Pose2& end = drive.poses.back();
    QVERIFY(std::abs(base::angleDiff(end.heading, 0.5)) < 0.26);
    double farthest = 0.0;  // from the bend [m]
    for (const Pose2& pose : drive.poses) {
      double nearest = 9.0;
      for (const Pose2& on : bend()) {
        nearest = std::min(nearest, (on.position - pose.position).norm());
      }
      farthest = std::max(farthest, nearest);
    }
    QVERIFY2(farthest < 0.3, QByteArray::number(farthest));
    const Drive again = driven(plugin.toStdString(), static_cast<Distro>(distro));
    QVERIFY(drive.poses == again.poses);
  }
};

QTEST_APPLESS_MAIN(ControllerDrivesTest)
#include "tst_ControllerDrives.moc"
