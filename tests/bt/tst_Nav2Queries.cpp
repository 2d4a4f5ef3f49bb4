#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <QtTest>

#include "bt/robot/Nav2Servers.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"

/// What Nav2's servers answer the nodes of a tree: a plane of 10 m x 3 m with a wall across it,
/// 0.05 m thick, at x = 5 m; the generic robot's file.
class Nav2QueriesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void checkPath_throughTheWall_hasItsCollisions_data();
  void checkPath_throughTheWall_hasItsCollisions();
  void checkPath_badRequests_areNotValid();
  void costAt_centreOrFootprint();
  void acceleration_isOfTheLastTwoReadings();
  void tracking_ofFollowPath_hasASide();
  void clear_unknownLayer_isRefused();
};

namespace {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else

/// The robot at (0.525, 1.525), as it was told to be.
struct Scene {
  std::unique_ptr<bt::Nav2Servers> servers;
  sim2d::Observation observation;
  bt::PathId path = 0;

  explicit Scene(double y = 1.525) {
    constexpr std::size_t kColumns = 200, kRows = 60;
    std::vector<std::int8_t> cells(kColumns * kRows, 0);
    for (std::size_t row = 0; row < kRows; ++row) {
      cells[row * kColumns + 100] = 100;
    }
    const auto file = ParameterFile::read(SOURCE_DIR "/resources/nav2_params/generic.yaml");
    bt::Nav2Servers::Setup setup;
    setup.parameters = readNav2Parameters(*file, {Distro::Jazzy, {}}).parameters;
    setup.map = sim2d::OccupancyGrid(kColumns, kRows, 0.05, {}, std::move(cells));
    auto made = bt::Nav2Servers::make(std::move(setup));
    servers = made ? *std::move(made) : nullptr;
    observation.pose = {{0.525, y}, 0.0};
    observation.dt = 0.05;
    step();
    Path poses;
    for (int i = 0; i < 19; ++i) {
      poses.push_back({{0.525 + 0.5 * i, 1.525}, 0.0});
    }
    path = servers->paths().add(poses);
  }
  void step(double speed = 0.0) {
    observation.motion.linear = speed;
    servers->sense(observation);
    observation.time += observation.dt;
  }
};

}  // namespace

void Nav2QueriesTest::checkPath_throughTheWall_hasItsCollisions_data() {
  QTest::addColumn<int>("maxCost");
  QTest::addColumn<double>("lookahead");
  QTest::addColumn<QString>("layer");
  QTest::addColumn<QString>("footprint");
  QTest::addColumn<bool>("stops");
  QTest::addColumn<int>("collisions");
  // Poses are 0.5 m apart, one of them, 4.5 m ahead, in the wall. The neighbours are 0.5 m from it,
  // where the cost is 252 exp(-3 (0.5 - 0.353)) = 162.
  QTest::newRow("usual") << 254 << -1.0 << ""
                         << "" << false << 1;
  QTest::newRow("cost") << 160 << -1.0 << ""
                        << "" << false << 3;
  QTest::newRow("cost, first") << 160 << -1.0 << ""
                               << "" << true << 1;
  QTest::newRow("higher cost") << 165 << -1.0 << ""
                               << "" << false << 1;
  QTest::newRow("before the wall") << 254 << 4.4 << ""
                                   << "" << false << 0;
  QTest::newRow("up to the wall") << 254 << 4.6 << ""
                                  << "" << false << 1;
  const QString kLong = QStringLiteral("[[0.6, 0.1], [0.6, -0.1], [-0.6, -0.1], [-0.6, 0.1]]");
  // The wall's pose, its neighbours, and both ends of the path, where it reaches off the map.
  QTest::newRow("long footprint") << 254 << -1.0 << "" << kLong << false << 5;
  QTest::newRow("layer without inflation") << 160 << -1.0 << "static_layer"
                                           << "" << false << 1;
}

void Nav2QueriesTest::checkPath_throughTheWall_hasItsCollisions() {
  QFETCH(int, maxCost);
  QFETCH(double, lookahead);
  QFETCH(QString, layer);
  QFETCH(QString, footprint);
  QFETCH(bool, stops);
  QFETCH(int, collisions);
  const Scene scene;
  const bt::PathCheckResult result = scene.servers->checkPath(
      {scene.path, maxCost, false, lookahead, layer.toStdString(), footprint.toStdString(), stops});
  QCOMPARE(static_cast<int>(result.collisions.size()), collisions);
  QCOMPARE(result.isValid, collisions == 0);
}

void Nav2QueriesTest::checkPath_badRequests_areNotValid() {
  const Scene scene;
  bt::PathCheck check;
  QVERIFY(!scene.servers->checkPath(check).isValid);  // no path
  check.path = scene.path;
  check.lookahead = 1.0;
  QVERIFY(scene.servers->checkPath(check).isValid);
  check.layer = "nowhere";
  QVERIFY(!scene.servers->checkPath(check).isValid);
  check.layer.clear();
  check.footprint = "[[0, 0], [1, 1]]";
  QVERIFY(!scene.servers->checkPath(check).isValid);
}

void Nav2QueriesTest::costAt_centreOrFootprint() {
  const Scene scene;
  const auto cost = [&](double x, double y, bool usesFootprint) {
    return scene.servers->costAt(false, {{x, y}, 0.0}, usesFootprint);
  };
  QVERIFY(!cost(-1.0, 1.0, false) && !cost(-1.0, 1.0, true));
  QCOMPARE(static_cast<int>(*cost(5.025, 1.525, false)), 254);
  QCOMPARE(static_cast<int>(*cost(2.025, 1.525, false)), 0);
  QCOMPARE(static_cast<int>(*cost(4.525, 1.525, false)), 162);
  QCOMPARE(static_cast<int>(*cost(4.525, 1.525, true)), 253);  // its edge is 0.14 m from the wall
  QCOMPARE(static_cast<int>(*cost(4.725, 1.525, true)), 254);
}

void Nav2QueriesTest::acceleration_isOfTheLastTwoReadings() {
  Scene scene;
  scene.step(0.6);
  scene.step(0.6);
  QCOMPARE(scene.servers->acceleration(), 0.0);
  scene.step(0.1);
  QVERIFY(std::fabs(scene.servers->acceleration() + 10.0) < 1e-9);
}

void Nav2QueriesTest::tracking_ofFollowPath_hasASide() {
  Scene scene(1.725);
  QCOMPARE(scene.servers->tracking().number, 0);
  bt::RobotRequest request;
  request.path = scene.path;
  scene.servers->begin(bt::RobotAction::FollowPath, request);
  scene.servers->act();
  const TrackingFeedback tracking = scene.servers->tracking();
  QCOMPARE(tracking.number, 1);
  QVERIFY(std::fabs(tracking.positionError - 0.2) < 1e-9);  // on the left
  QVERIFY(std::fabs(tracking.remaining - 9.0) < 1e-9);
}

void Nav2QueriesTest::clear_unknownLayer_isRefused() {
  const Scene scene;
  bt::ClearRequest request;
  request.isLocal = false;
  QVERIFY(scene.servers->clear(request));
  request.plugins = "obstacle_layer";
  QVERIFY(scene.servers->clear(request));
  request.plugins = "nowhere";
  QVERIFY(!scene.servers->clear(request));
}

QTEST_GUILESS_MAIN(Nav2QueriesTest)
#include "tst_Nav2Queries.moc"
