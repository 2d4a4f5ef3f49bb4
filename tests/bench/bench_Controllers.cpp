#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QtTest>

#include "tests/nav/ControlScene.h"
#include "tests/nav/PlainDwb.h"

using namespace control_scene;
using base::Vec2;

/// What a cycle of Nav2's controllers costs on a local map of 60 x 60 cells with a dozen obstacles,
/// beside DWB written down plainly.
class ControllersBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void command_data();
  void command();
};

namespace {

constexpr int kCycles = 400;
using Names = std::vector<std::string>;

Nav2ParameterBlock dwbBlock(const Names& critics) {
  Nav2ParameterBlock block = bringup();
  block["max_speed_xy"] = 0.27;  // so that 20 velocities ahead count
  block["critics"] = critics;
  block["RotateToGoal.scale"] = 32.0;
  return block;
}

/// A path that winds along x.
Path winding() {
  Path path;
  for (int i = 0; i <= 200; ++i) {
    const double x = 0.05 * i;
    path.push_back({Vec2(x, 0.2 * std::sin(2.0 * x)), 0.0});
  }
  return path;
}

/// Obstacles beside the path, each with what an inflation of 3/m puts round it; the map follows the
/// robot.
void look(Scene& scene) {
  const double resolution = scene.costmap.resolution();
  const Vec2 corner = (scene.robot.position / resolution).array().floor() * resolution;
  scene.costmap.setOrigin(corner - Vec2(1.5, 1.5));
  std::fill(scene.costmap.costs().begin(), scene.costmap.costs().end(), kFreeSpace);
  for (int i = -2; i < 24; ++i) {
    const Vec2 at(0.5 * i, i % 2 == 0 ? 0.75 : -0.75);
    for (int row = 0; row < 60; ++row) {
      for (int column = 0; column < 60; ++column) {
        const double d = (scene.costmap.cellToWorld({column, row}) - at).norm();
        if (d < 1.0) {
          const double cost = d < 0.05   ? 254.0
                              : d < 0.25 ? 253.0
                                         : 252.0 * std::exp(-3.0 * (d - 0.25));
          const double old = scene.costmap.at({column, row});
          scene.costmap.set({column, row}, static_cast<std::uint8_t>(std::max(old, cost)));
        }
      }
    }
  }
}

/// Median of the microseconds that `command` takes along the path.
double medianOf(Scene& scene, const std::function<sim2d::BodyTwist()>& command) {
  std::vector<double> times;
  for (int i = 0; i < kCycles; ++i) {
    look(scene);
    QElapsedTimer timer;
    timer.start();
    const sim2d::BodyTwist twist = command();
    times.push_back(1e-3 * static_cast<double>(timer.nsecsElapsed()));
    scene.speed = twist;
    scene.robot.position += 0.05 * twist.linear * scene.robot.direction();
    scene.robot.heading += 0.05 * twist.angular;
    scene.time += 0.05;
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

}  // namespace

void ControllersBench::command_data() {
  QTest::addColumn<QString>("plugin");
  QTest::addColumn<bool>("isPlain");
  QTest::newRow("DWB 20 x 20, five critics") << "dwb_core::DWBLocalPlanner" << false;
  QTest::newRow("the same, plainly") << "dwb_core::DWBLocalPlanner" << true;
  QTest::newRow("DWB 20 x 20, Humble's seven") << "seven" << false;
  QTest::newRow("regulated pure pursuit")
      << "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController" << false;
  QTest::newRow("graceful") << "nav2_graceful_controller::GracefulController" << false;
}

void ControllersBench::command() {
  QFETCH(QString, plugin);
  QFETCH(bool, isPlain);
  Scene scene(Distro::Jazzy);
  Nav2ParameterBlock block;
  if (plugin == QLatin1String("seven")) {
    block = dwbBlock({"RotateToGoal", "Oscillation", "BaseObstacle", "GoalAlign", "PathAlign",
                      "PathDist", "GoalDist"});
    plugin = QStringLiteral("dwb_core::DWBLocalPlanner");
  } else if (plugin.startsWith(QLatin1String("dwb"))) {
    block = dwbBlock({"BaseObstacle", "GoalAlign", "PathAlign", "PathDist", "GoalDist"});
  }
  const auto controller = scene.make(plugin.toStdString(), block);
  controller->setPlan(winding());
  base::Diagnostics problems;
  const auto parameters = applyBlock(DwbParameters(), dwbKeys(), block, scene.distro, problems);
  const auto plainly = [&] {
    const Path plan(winding());
    Path local;
    for (const Pose2& pose : plan) {
      const double d = (pose.position - scene.robot.position).norm();
      if (d < 1.5 && pose.position.x() > scene.robot.position.x() - 0.3) {
        local.push_back(pose);
      }
    }
    return plain_dwb::choose(parameters, {}, scene.costmap, local, scene.robot, scene.speed)
        .command;
  };
  const auto ours = [&] { return scene.run(*controller).twist; };
  const double median = isPlain ? medianOf(scene, plainly) : medianOf(scene, ours);
  QVERIFY(scene.robot.position.x() > 0.5);
  QTest::setBenchmarkResult(median / 1000.0, QTest::WalltimeMilliseconds);
}

QTEST_APPLESS_MAIN(ControllersBench)
#include "bench_Controllers.moc"
