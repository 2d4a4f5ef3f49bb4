#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/control/dwb/DwbController.h"
#include "tests/nav/ControlScene.h"
#include "tests/nav/CostmapSketch.h"
#include "tests/nav/PlainDwb.h"

using namespace control_scene;
using base::Vec2;
using sim2d::BodyTwist;

namespace {

constexpr char kDwb[] = "dwb_core::DWBLocalPlanner";
using Names = std::vector<std::string>;

DwbParameters parametersOf(const Nav2ParameterBlock& block) {
  base::Diagnostics problems;
  return applyBlock(DwbParameters(), dwbKeys(), block, Distro::Humble, problems);
}

/// A path that curves to the left, dense.
Path curve() {
  Path path;
  for (int i = 0; i <= 60; ++i) {
    const double angle = 0.03 * i;
    path.push_back({Vec2(std::sin(angle), 1.0 - std::cos(angle)), angle});
  }
  return path;
}

/// Costs that fall off round a pillar beside the path.
void addPillar(Scene& scene, double x, double y) {
  for (int row = 0; row < 60; ++row) {
    for (int column = 0; column < 60; ++column) {
      const double d = (scene.costmap.cellToWorld({column, row}) - Vec2(x, y)).norm();
      const double cost = d < 0.1 ? 254.0 : d < 0.3 ? 253.0 : 252.0 * std::exp(-5.0 * (d - 0.3));
      const auto old = static_cast<double>(scene.costmap.at({column, row}));
      scene.costmap.set({column, row}, static_cast<std::uint8_t>(std::max(old, cost)));
    }
  }
}

}  // namespace

class DwbControllerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void choice_equalsPlainCode_data();
  void choice_equalsPlainCode();
  void choice_randomScenes_equalsPlainCode();
  void totals_equalPlainCode();
  void shortCircuit_changesNothing();
  void watched_scoresAddUp();
  void unwatched_randomScenes_sameChoice();
  void boxedIn_isNoValidControl();
  void standingStill_isNoCandidate();
  void equalTotals_firstWins();
  void speedLimit_scalesGreatestAlone();
  void newPath_resetsCritics();
  void scaleZero_criticIsNotAsked();
  void main_localPlanIsTheServers();
  void make_problems();
  void keys_dependOnCritics();
};

void DwbControllerTest::choice_equalsPlainCode_data() {
  QTest::addColumn<double>("y");
  QTest::addColumn<double>("heading");
  QTest::addColumn<double>("speed");
  QTest::addColumn<double>("turning");
  QTest::newRow("on the path") << 0.0 << 0.0 << 0.2 << 0.0;
  QTest::newRow("from rest") << 0.0 << 0.0 << 0.0 << 0.0;
  QTest::newRow("beside") << 0.3 << -0.4 << 0.1 << 0.5;
  QTest::newRow("turned away") << -0.2 << 2.8 << 0.26 << -0.9;
}

void DwbControllerTest::choice_equalsPlainCode() {
  QFETCH(double, y);
  QFETCH(double, heading);
  QFETCH(double, speed);
  QFETCH(double, turning);
  Scene scene(Distro::Humble);
  addPillar(scene, 0.5, 0.3);
  addPillar(scene, -0.55, -0.2);
  scene.robot = {Vec2(0.0, y), heading};
  scene.speed = {speed, turning};
  const auto controller = scene.make(kDwb, bringup());
  controller->setPlan(curve());
  const ControlResult control = scene.run(*controller);
  QVERIFY(control);
  const plain_dwb::Best plain =
      plain_dwb::choose(parametersOf(bringup()), {}, scene.costmap, controller->view().localPlan,
                        scene.robot, scene.speed);
  QVERIFY(plain.total > 0.0F);
  QVERIFY(plain.illegal > 0);
  QCOMPARE(control.twist, plain.command);
}

void DwbControllerTest::choice_randomScenes_equalsPlainCode() {
  costs::Numbers numbers(5);
  int legal = 0, blocked = 0;
  double largest = 0.0;
  for (int i = 0; i < 60; ++i) {
    Scene scene(i % 2 == 0 ? Distro::Humble : Distro::Jazzy);
    for (int pillar = 0; pillar < 5; ++pillar) {
      addPillar(scene, numbers.between(-1.2, 1.2), numbers.between(-1.2, 1.2));
    }
    scene.robot = {Vec2(numbers.between(-0.3, 0.3), numbers.between(-0.3, 0.3)),
                   numbers.between(-3.1, 3.1)};
    scene.speed = {numbers.between(0.0, 0.26), numbers.between(-1.0, 1.0)};
    const auto controller = scene.make(kDwb, bringup());
    controller->setPlan(curve());
    const ControlResult control = scene.run(*controller);
    const plain_dwb::Best plain =
        plain_dwb::choose(parametersOf(bringup()), {}, scene.costmap, controller->view().localPlan,
                          scene.robot, scene.speed);
    QCOMPARE(static_cast<bool>(control), plain.total >= 0.0F);
    if (!control) {
      ++blocked;
      continue;
    }
    ++legal;
    largest = std::max({largest, std::abs(control.twist.linear - plain.command.linear),
                        std::abs(control.twist.angular - plain.command.angular)});
  }
  QVERIFY(legal > 30 && blocked > 0);
  QCOMPARE(largest, 0.0);
  qInfo("%d choices and %d scenes without one, largest difference 0", legal, blocked);
}

/// Every trajectory's total of a cycle, without short circuit.
void DwbControllerTest::totals_equalPlainCode() {
  Scene scene(Distro::Humble);
  addPillar(scene, 0.5, 0.3);
  Nav2ParameterBlock block = bringup();
  block["short_circuit_trajectory_evaluation"] = false;
  const auto controller = scene.make(kDwb, block);
  controller->watch(true);
  controller->setPlan(curve());
  QVERIFY(scene.run(*controller));
  const Path plan = controller->view().localPlan;
  const auto seeds = plain_dwb::seedsOf(plan, scene.costmap);
  Path on = plan;  // no cell of it is farther than two from the next: nothing to fill in
  on.back().position += 0.1 * base::directionOf(base::headingOf(curve().back().position));
  const plain_dwb::Grid path(scene.costmap, seeds), goal(scene.costmap, {seeds.back()}),
      pushed(scene.costmap, {plain_dwb::seedsOf(on, scene.costmap).back()});
  std::size_t legal = 0;
  for (const EvaluatedTrajectory& each : controller->view().trajectories) {
    const auto total = plain_dwb::totalOf(
        plain_dwb::rollOut(parametersOf(block), scene.robot, scene.speed, each.twist),
        scene.costmap, path, goal, pushed, {});
    QCOMPARE(each.rejection.empty(), total.has_value());
    if (total) {
      QCOMPARE(each.total, static_cast<double>(*total));
      ++legal;
    }
  }
  QVERIFY(legal > 100 && legal < controller->view().trajectories.size());
}

void DwbControllerTest::shortCircuit_changesNothing() {
  Nav2ParameterBlock whole = bringup();
  whole["short_circuit_trajectory_evaluation"] = false;
  Scene scene(Distro::Humble);
  addPillar(scene, 0.5, 0.4);
  const auto cut = scene.make(kDwb, bringup());
  const auto full = scene.make(kDwb, whole);
  cut->setPlan(curve());
  full->setPlan(curve());
  for (int cycle = 0; cycle < 20; ++cycle) {
    const ControlResult control = scene.run(*cut);
    QCOMPARE(control.twist, scene.run(*full).twist);
    scene.speed = control.twist;
    scene.robot.position += 0.05 * control.twist.linear * scene.robot.direction();
    scene.robot.heading += 0.05 * control.twist.angular;
  }
  QVERIFY(scene.robot.position.x() > 0.1);
}

void DwbControllerTest::watched_scoresAddUp() {
  Scene scene(Distro::Humble);
  addPillar(scene, 0.5, 0.3);
  const auto controller = scene.make(kDwb, bringup());
  controller->setPlan(curve());
  const ControlResult unwatched = scene.run(*controller);
  QVERIFY(controller->view().trajectories.empty());
  controller->watch(true);
  const ControlResult control = scene.run(*controller);
  QCOMPARE(control.twist, unwatched.twist);
  int chosen = 0;
  double best = 1e9;
  for (const EvaluatedTrajectory& each : controller->view().trajectories) {
    double sum = 0.0;
    for (const CriticScore& score : each.scores) {
      sum += score.scale * score.raw;
    }
    QVERIFY(!each.rejection.empty() || isNear(sum, each.total, 1e-3));
    QVERIFY(each.rejection.empty() || each.total < 0.0);
    best = each.rejection.empty() ? std::min(best, each.total) : best;
    if (each.isChosen) {
      ++chosen;
      QCOMPARE(each.twist, control.twist);
      QCOMPARE(each.scores.size(), std::size_t{5});
      QCOMPARE(each.scores[1].critic, std::string("GoalAlign"));
      QVERIFY(isNear(each.scores[1].scale, 0.6, 1e-6));
      QVERIFY(each.poses == controller->view().predicted);
    }
  }
  QCOMPARE(chosen, 1);
  for (const EvaluatedTrajectory& each : controller->view().trajectories) {
    QVERIFY(!each.isChosen || each.total == best);
  }
}

/// Bounds exclude trajectories only while nobody watches: the choice is the same, also with sums,
/// products, footprints and negative scales.
void DwbControllerTest::unwatched_randomScenes_sameChoice() {
  costs::Numbers numbers(11);
  const Names aggregations{"last", "sum", "product"};
  int legal = 0;
  for (int i = 0; i < 60; ++i) {
    Scene scene(Distro::Jazzy);
    addPillar(scene, numbers.between(-1.2, 1.2), numbers.between(-1.2, 1.2));
    addPillar(scene, numbers.between(-1.2, 1.2), numbers.between(-1.2, 1.2));
    scene.robot = {Vec2(numbers.between(-0.3, 0.3), numbers.between(-0.3, 0.3)),
                   numbers.between(-3.1, 3.1)};
    scene.speed = {numbers.between(0.0, 0.26), numbers.between(-1.0, 1.0)};
    Nav2ParameterBlock block = bringup();
    block["critics"] = Names{"RotateToGoal", "ObstacleFootprint", "BaseObstacle", "GoalAlign",
                             "PathAlign",    "PathDist",          "GoalDist",     "Twirling"};
    block["BaseObstacle.sum_scores"] = i % 2 == 0;
    block["PathDist.aggregation_type"] = aggregations[static_cast<std::size_t>(i % 3)];
    block["PathAlign.aggregation_type"] = aggregations[static_cast<std::size_t>(i / 3 % 3)];
    block["GoalDist.scale"] = i % 5 == 0 ? -2.0 : 24.0;
    const auto controller = scene.make(kDwb, block);
    controller->setPlan(curve());
    const ControlResult unwatched = scene.run(*controller);
    controller->watch(true);
    const ControlResult watched = scene.run(*controller);
    QCOMPARE(static_cast<bool>(unwatched), static_cast<bool>(watched));
    if (watched) {
      QCOMPARE(unwatched.twist, watched.twist);
      ++legal;
    }
  }
  QVERIFY(legal > 20);
}

void DwbControllerTest::boxedIn_isNoValidControl() {
  Scene scene(Distro::Jazzy);
  const auto controller = scene.make(kDwb, bringup());
  controller->setPlan(straight(1.0));
  scene.block(-2.0, -2.0, 2.0, 2.0, kInscribed);
  const ControlResult control = scene.run(*controller);
  QCOMPARE(control.code, ControllerError::NoValidControl);
  // 19 times (20 and zero), without standing still: the steps of the 20th add up to more than
  // max_speed_xy
  QCOMPARE(control.words, std::string("Could not find a legal trajectory: No valid trajectories "
                                      "out of 398!"));
  QCOMPARE(control.twist, BodyTwist());
}

/// A wall ahead: nothing but turning on the spot is legal, though standing would be cheapest.
void DwbControllerTest::standingStill_isNoCandidate() {
  Scene scene(Distro::Humble);
  scene.block(0.05, -2.0, 2.0, 2.0);
  scene.robot.position.x() = 0.04;
  Nav2ParameterBlock block = bringup();
  block["critics"] = Names{"BaseObstacle", "Twirling"};
  block["linear_granularity"] = 0.01;
  const auto controller = scene.make(kDwb, block);
  controller->setPlan(straight(1.0));
  const ControlResult control = scene.run(*controller);
  QVERIFY(control);
  QVERIFY(control.twist.angular != 0.0);
}

/// Left and right cost the same: the first tried, to the right, is taken.
void DwbControllerTest::equalTotals_firstWins() {
  Scene scene(Distro::Humble);
  Nav2ParameterBlock block = bringup();
  block["critics"] = Names{"Twirling"};
  block["min_vel_x"] = 0.1;
  block["max_vel_x"] = 0.1;
  block["vtheta_samples"] = 2;
  block["min_speed_theta"] = 0.5;
  block["min_speed_xy"] = 0.2;  // so that 0 rad/s is none
  const auto controller = scene.make(kDwb, block);
  controller->setPlan(straight(1.0));
  QVERIFY(isNear(scene.run(*controller).twist.angular, -1.0));
}

void DwbControllerTest::speedLimit_scalesGreatestAlone() {
  Scene scene(Distro::Humble);
  Nav2ParameterBlock block = bringup();
  block["max_vel_y"] = 0.1;
  block["min_vel_x"] = -0.1;
  const auto made = scene.make(kDwb, block);
  auto& controller = dynamic_cast<DwbController&>(*made);
  const auto holds = [&controller](double speed, double x, double y, double theta) {
    const DwbParameters& p = controller.parameters();
    return isNear(p.maxSpeedXy, speed) && isNear(p.maxVelX, x) && isNear(p.maxVelY, y) &&
           isNear(p.maxVelTheta, theta) && p.minVelX == -0.1;
  };
  controller.setSpeedLimit(50.0, true);
  QVERIFY(holds(0.13, 0.13, 0.05, 0.5));
  controller.setSpeedLimit(0.3, false);  // not below max_speed_xy: ignored
  QVERIFY(holds(0.13, 0.13, 0.05, 0.5));
  controller.setSpeedLimit(0.065, false);
  QVERIFY(holds(0.065, 0.065, 0.025, 0.25));
  controller.setSpeedLimit(0.0, false);
  QVERIFY(holds(0.26, 0.26, 0.1, 1.0));
}

/// In the goal's window the robot only turns, until a new path comes.
void DwbControllerTest::newPath_resetsCritics() {
  Scene scene(Distro::Humble);
  Nav2ParameterBlock block = bringup();
  block["critics"] = Names{"RotateToGoal", "PathDist", "GoalDist"};
  const auto controller = scene.make(kDwb, block);
  Path near = straight(0.2);
  near.back().heading = 1.0;
  controller->setPlan(near);
  QCOMPARE(scene.run(*controller).twist.linear, 0.0);
  scene.robot.position.x() = -0.5;
  QCOMPARE(scene.run(*controller).twist.linear, 0.0);
  controller->setPlan(near);
  QVERIFY(scene.run(*controller).twist.linear > 0.0);
}

void DwbControllerTest::scaleZero_criticIsNotAsked() {
  Scene scene(Distro::Humble);
  scene.block(-2.0, -2.0, 2.0, 2.0, kLethal);
  Nav2ParameterBlock block = bringup();
  block["BaseObstacle.scale"] = 0.0;  // its refusal does not count either
  const auto controller = scene.make(kDwb, block);
  controller->setPlan(straight(1.0));
  QVERIFY(scene.run(*controller));
}

void DwbControllerTest::main_localPlanIsTheServers() {
  Scene scene(Distro::Main);
  const auto controller = scene.make(kDwb, bringup());
  controller->setPlan(straight(3.0));
  scene.local = straight(0.5);
  QVERIFY(scene.run(*controller));
  QVERIFY(controller->view().localPlan == scene.local);
}

void DwbControllerTest::make_problems() {
  ControllerSetup setup;
  setup.distro = Distro::Humble;
  const auto without = makeController("dwb_core/DWBLocalPlanner", setup);
  QVERIFY(!without);
  QCOMPARE(without.diagnostics()[0].code, std::string_view("nav2.missing-key"));
  setup.block = bringup();
  setup.block["critics"] = Names{"PathDistt", "GoalDist"};
  setup.block["sim_time"] = 0.0;
  setup.block["trajectory_generator_name"] = std::string("dwb_plugins::StandardGenerator");
  setup.block["GoalDist.scale"] = 24;
  setup.block["GoalDist.aggregation_type"] = std::string("mean");
  const auto wrong = makeController(kDwb, setup);
  QVERIFY(!wrong);
  Names codes;
  for (const base::Diagnostic& each : wrong.diagnostics()) {
    codes.push_back(std::string(each.code) + " " + each.value("found"));
  }
  QCOMPARE(codes, (Names{"nav2.wrong-value 0", "nav2.unknown-plugin dwb_plugins::StandardGenerator",
                         "nav2.unknown-plugin dwb_critics::PathDistt", "nav2.wrong-type integer",
                         "nav2.wrong-value 'mean'"}));
  QCOMPARE(wrong.diagnostics()[2].value("nearest"), std::string("dwb_critics::PathDistCritic"));
  setup.block = bringup();
  setup.block["angular_granularity"] = 1e-9;
  QVERIFY(!makeController(kDwb, setup));  // a thousand million poses
  setup.distro = Distro::Main;
  setup.block = bringup();
  setup.block["decel_lim_x"] = 2.5;
  const auto mended = makeController(kDwb, setup);
  QVERIFY(mended);
  QCOMPARE(mended.diagnostics()[0].code, std::string_view("nav2.positive-deceleration"));
}

void DwbControllerTest::keys_dependOnCritics() {
  const ControllerType* type = findController(kDwb);
  QVERIFY(type != nullptr);
  const Nav2ParameterBlock given{{"critics", Names{"Mine", "Twirling"}},
                                 {"Mine.class", std::string("dwb_critics::PathAlign")}};
  const Nav2KeyTable keys = type->keys(given, Distro::Humble);
  QVERIFY(keys.find("Mine.forward_point_distance", Distro::Humble) != nullptr);
  QVERIFY(keys.find("Twirling.scale", Distro::Humble) != nullptr);
  QVERIFY(keys.find("Twirling.forward_point_distance", Distro::Humble) == nullptr);
  QVERIFY(keys.find("prune_distance", Distro::Humble) != nullptr);
  QVERIFY(keys.find("prune_distance", Distro::Main) == nullptr);
  QCOMPARE(std::get<double>(keys.find("sim_time", Distro::Humble)->fallback), 1.7);
}

QTEST_APPLESS_MAIN(DwbControllerTest)
#include "tst_DwbController.moc"
