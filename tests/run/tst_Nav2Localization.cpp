#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <QtTest>

#include "app/run/Bundle.h"
#include "sim2d/base/Text.h"
#include "tests/run/Nav2Scene.h"

/// Whole runs of robots with a localiser.
class Nav2LocalizationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void exactLocalizer_changesNoBit();
  void errors_areThoseOfTheFile();
  void driftWithCorrections_arrives_withoutItDoesNot();
  void bringupOfJazzy_growingErrors_arrivesLessExactly();
  void localCostmapInTheMap_arrives();
  void lateInitialPose_treeWaitsForIt();
  void reinitialize_errorJumpsAndRelaxes();
  void ownPlanners_driveByTheEstimate();
};

namespace {

using base::Pose2;
using base::Vec2;
using Words = std::vector<std::string>;

constexpr const char* kCrossing = SOURCE_DIR "/maps/planners/crossing_agents.yaml";

struct Driven {
  std::vector<Pose2> places, estimates;  // of the same instants
  std::vector<bool> isLocalized;
  bool hasArrived = false;
  double left = 0.0;  // to the goal at the end [m]
  double time = 0.0;  // [s]
  std::string problems;
};

Driven drive(app::RunSpec options, const Words& set, double longest) {
  options.set = set;
  options.scenario = options.scenario.empty() ? kCrossing : options.scenario;
  const auto settings = app::runSettingsOf(options);
  const app::Bundle bundle = app::readBundle(options, *settings, {});
  app::Verdict verdict = app::check(bundle);
  Driven driven;
  for (const base::Diagnostic& problem : verdict.problems) {
    driven.problems += problem.severity == base::Severity::Error ? problem.text() + "\n" : "";
  }
  if (!verdict.world) {
    return driven;
  }
  sim2d::World& world = *verdict.world;
  world.publishSensors(true);
  const auto placeNow = [&world] {
    const sim2d::RobotColumns& robots = world.frame().robots;
    return Pose2{{robots.x[0], robots.y[0]}, robots.heading[0]};
  };
  Pose2 before = placeNow();
  while (!world.arrivedAt() && world.time() < longest && world.step()) {
    const sim2d::RobotTelemetry& senses = world.frame().senses->front();
    driven.places.push_back(before);
    driven.estimates.push_back(senses.believed);
    driven.isLocalized.push_back(!senses.localizer || senses.localizer->isLocalized);
    before = placeNow();
  }
  driven.hasArrived = world.arrivedAt().has_value();
  driven.time = world.time();
  driven.left = (placeNow().position - world.header().robots.front().goals.back().position).norm();
  return driven;
}

app::RunSpec nav2(const std::string& params = "turtlebot4") {
  app::RunSpec options;
  options.planner = "nav2";
  options.nav2Params = {SOURCE_DIR "/resources/nav2_params/" + params + ".yaml"};
  options.nav2Tree =
      SOURCE_DIR "/resources/nav2_trees/jazzy/navigate_to_pose_w_replanning_and_recovery.xml";
  return options;
}

app::RunSpec withTree(const std::string& nodes) {
  app::RunSpec options = nav2();
  options.nav2Tree = nav2scene::treeFile("localization_tree.xml", nodes);
  return options;
}

}  // namespace

/// Corrections by exact poses leave both frames together.
void Nav2LocalizationTest::exactLocalizer_changesNoBit() {
  const Driven without = drive(nav2(), {}, 6.0);
  const Driven with = drive(nav2(), {"robot1.localization.rate=10"}, 6.0);
  QCOMPARE(without.problems + with.problems, std::string());
  QVERIFY(without.places.size() > 100);
  QVERIFY(without.places == with.places);
}

void Nav2LocalizationTest::errors_areThoseOfTheFile() {
  const Driven driven = drive(nav2(),
                              {"robot1.localization.std_x=0.05", "robot1.localization.std_y=0.05",
                               "robot1.localization.std_yaw=0.035"},
                              20.0);
  QCOMPARE(driven.problems, std::string());
  double most = 0.0, turned = 0.0;
  for (std::size_t i = 0; i < driven.places.size(); ++i) {
    most = std::max(most, (driven.estimates[i].position - driven.places[i].position).norm());
    turned = std::max(
        turned, std::fabs(base::angleDiff(driven.estimates[i].heading, driven.places[i].heading)));
  }
  // Between corrections the error changes with the turned way of up to 0.5 s.
  QVERIFY2(most > 0.03 && most < std::hypot(0.15, 0.15) + 0.5 * 0.105, "position");
  QVERIFY2(turned > 0.02 && turned <= 0.105 + 1e-9, "heading");
}

/// 5 cm, with a drift of the odometry that alone misses the goal by a metre or so.
void Nav2LocalizationTest::driftWithCorrections_arrives_withoutItDoesNot() {
  const Words drift = {"robot1.odometry_noise.drift=0.02"};
  const Driven lost = drive(nav2(), drift, 90.0);
  QVERIFY2(lost.left > 0.8, qPrintable(QString::number(lost.left)));
  Words both = drift;
  both.insert(both.end(), {"robot1.localization.std_x=0.05", "robot1.localization.std_y=0.05"});
  const Driven driven = drive(nav2(), both, 90.0);
  QVERIFY(driven.hasArrived);
  QVERIFY2(driven.left < 0.4, qPrintable(QString::number(driven.left)));
}

/// The file of nav2_bringup with MPPI arrives in 95 % of the runs with 5 cm and 2 degrees, and does
/// not fail at once with more. With HUNAV_ALL_TESTS in more runs.
void Nav2LocalizationTest::bringupOfJazzy_growingErrors_arrivesLessExactly() {
  const int seeds = qEnvironmentVariableIsSet("HUNAV_ALL_TESTS") ? 20 : 2;
  app::RunSpec options = nav2();
  options.nav2Params.insert(
      options.nav2Params.end(),
      {"FollowPath.vx_max:=0.5", "FollowPath.vx_min:=-0.35", "FollowPath.wz_max:=1.9",
       "robot_radius:=0.22", "inflation_layer.cost_scaling_factor:=3.0",
       "inflation_layer.inflation_radius:=0.7", "velocity_smoother:max_velocity:=[0.5, 0.0, 2.0]",
       "velocity_smoother:min_velocity:=[-0.5, 0.0, -2.0]"});
  double before = 0.0;  // mean distance to the goal with smaller errors [m]
  for (const double error : {0.05, 0.1, 0.2}) {
    int arrived = 0;
    double left = 0.0;  // of those who arrive [m]
    for (int seed = 1; seed <= seeds; ++seed) {
      options.seed = seed;
      const std::string std = base::formatDouble(error);
      const Driven driven =
          drive(options,
                {"robot1.localization.std_x=" + std, "robot1.localization.std_y=" + std,
                 "robot1.localization.std_yaw=" + base::formatDouble(0.7 * error)},
                150.0);
      QCOMPARE(driven.problems, std::string());
      arrived += driven.hasArrived ? 1 : 0;
      left += driven.hasArrived ? driven.left : 0.0;
    }
    left /= std::max(1, arrived);
    qInfo("%g m: %d of %d arrive, %.3f m from the goal", error, arrived, seeds, left);
    const double least = error < 0.1 ? 0.95 : error < 0.2 ? 0.9 : 0.5;
    QVERIFY2(arrived >= least * seeds, qPrintable(QString::number(error)));
    QVERIFY2(seeds < 10 || left > before, qPrintable(QString::number(left)));
    before = left;
  }
}

void Nav2LocalizationTest::localCostmapInTheMap_arrives() {
  const Driven driven =
      drive(nav2(),
            {"nav2.local_costmap.global_frame=map", "robot1.localization.std_x=0.05",
             "robot1.localization.std_y=0.05", "robot1.localization.std_yaw=0.02"},
            90.0);
  QCOMPARE(driven.problems, std::string());
  QVERIFY(driven.hasArrived);
}

/// The tree stands until the pose comes at 2 s, then it turns.
void Nav2LocalizationTest::lateInitialPose_treeWaitsForIt() {
  const Driven driven = drive(
      withTree("<Sequence><RetryUntilSuccessful num_attempts=\"-1\"><Sequence>"
               "<InitialPoseReceived/><TransformAvailable parent=\"map\" child=\"base_link\"/>"
               "</Sequence></RetryUntilSuccessful><Spin spin_dist=\"1.0\"/></Sequence>"),
      {"robot1.localization.initial_pose_time=2"}, 6.0);
  QCOMPARE(driven.problems, std::string());
  for (std::size_t i = 0; i < driven.places.size(); ++i) {
    const double time = 0.05 * static_cast<double>(i);
    QCOMPARE(bool(driven.isLocalized[i]), time >= 2.0 - 1e-9);
    if (time <= 2.0) {
      QVERIFY(driven.places[i] == driven.places.front());
    }
  }
  const double turned = base::angleDiff(driven.places.back().heading, driven.places[0].heading);
  QVERIFY2(std::fabs(turned - 1.0) < 0.3, qPrintable(QString::number(turned)));
}

void Nav2LocalizationTest::reinitialize_errorJumpsAndRelaxes() {
  const Driven driven =
      drive(withTree("<Sequence><Wait wait_duration=\"1.0\"/><ReinitializeGlobalLocalization/>"
                     "<Wait wait_duration=\"100.0\"/></Sequence>"),
            {"robot1.localization.rate=2", "robot1.localization.global_std=1.0",
             "robot1.localization.correlation_time=2.0"},
            12.0);
  QCOMPARE(driven.problems, std::string());
  const auto errorAt = [&](double time) {
    const auto i = static_cast<std::size_t>(std::lround(time / 0.05));
    return (driven.estimates.at(i).position - driven.places.at(i).position).norm();
  };
  QCOMPARE(errorAt(0.9), 0.0);
  const double jump = errorAt(2.0);
  QVERIFY2(jump > 0.1, qPrintable(QString::number(jump)));
  QVERIFY(std::fabs(errorAt(6.0) / jump - std::exp(-2.0)) < 1e-6);  // 4 s later
}

/// Every planner gets the estimate: a wrong initial pose without corrections shifts the way.
void Nav2LocalizationTest::ownPlanners_driveByTheEstimate() {
  app::RunSpec options;
  options.planner = "pursuit";
  const Driven exact = drive(options, {}, 5.0);
  const Driven wrong =
      drive(options, {"robot1.localization.start_y=0.4", "robot1.localization.rate=0"}, 5.0);
  QCOMPARE(wrong.problems, std::string());
  for (std::size_t i = 0; i < wrong.places.size(); ++i) {
    QVERIFY(((wrong.estimates[i].position - wrong.places[i].position) - Vec2(0.0, 0.4)).norm() <
            1e-9);
  }
  QVERIFY(!(exact.places == wrong.places));
}

QTEST_APPLESS_MAIN(Nav2LocalizationTest)
#include "tst_Nav2Localization.moc"
