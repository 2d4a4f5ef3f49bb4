#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <QtTest>

#include "tests/nav/CostmapSketch.h"
#include "tests/nav/DwbJudge.h"
#include "tests/nav/PlainDwbCritics.h"

using costs::Numbers;
using dwb_judge::Judge;
using namespace sim2d::nav2;
using base::Vec2;
using plain_dwb::Price;
using sim2d::BodyTwist;

/// DWB's critics against second implementations (PlainDwbCritics.h) on random trajectories.
class DwbCriticsRandomTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void obstacleCritics_areTheSame();
  void gridCritics_areTheSame();
  void rotateToGoal_isTheSame();
  void oscillation_isTheSame();
};

namespace {

bool isHeads(Numbers& numbers, double share = 0.5) {
  return numbers.next() < share;
}

/// Ten poses from somewhere near the robot; now and then they leave the map.
std::vector<Pose2> anyPoses(Numbers& numbers) {
  std::vector<Pose2> poses;
  Pose2 pose{{numbers.between(-1.4, 1.4), numbers.between(-1.4, 1.4)}, numbers.between(-3.1, 3.1)};
  for (int i = 0; i < 10; ++i) {
    poses.push_back(pose);
    pose.heading += numbers.between(-0.3, 0.3);
    pose.position += numbers.between(0.0, 0.06) * pose.direction();
  }
  return poses;
}

BodyTwist anyTwist(Numbers& numbers) {
  const auto axis = [&] { return isHeads(numbers, 0.3) ? 0.0 : numbers.between(-0.3, 0.3); };
  const double linear = axis(), angular = axis();
  return {linear, angular, axis()};
}

/// What differs, and how much was compared.
struct Tally {
  int legal = 0, illegal = 0;
  double largest = 0.0;  // in parts of prices above 1

  /// False: only one of both calls the trajectory legal.
  bool add(const DwbScore& found, const Price& wanted) {
    if ((found.rejection == nullptr) != wanted.has_value()) {
      return false;
    }
    ++(wanted ? legal : illegal);
    if (wanted) {
      largest = std::max(largest, std::fabs(found.raw - *wanted) / std::max(1.0, *wanted));
    }
    return true;
  }
  void check() const {
    QVERIFY2(legal > 100 && illegal > 100,
             qPrintable(QStringLiteral("%1 %2").arg(legal).arg(illegal)));
    QVERIFY2(largest < 1e-12, qPrintable(QString::number(largest)));
    qInfo("%d legal and %d illegal trajectories, largest difference %.1e", legal, illegal, largest);
  }
};

Path bentPath(Numbers& numbers) {
  Path path;
  Pose2 pose{{numbers.between(-0.5, 0.0), numbers.between(-0.3, 0.3)}, numbers.between(-0.7, 0.7)};
  for (int i = 0; i < 20; ++i) {
    path.push_back(pose);
    pose.heading += numbers.between(-0.1, 0.1);
    pose.position += 0.05 * pose.direction();
  }
  return path;
}

}  // namespace

void DwbCriticsRandomTest::obstacleCritics_areTheSame() {
  Tally centre, edges;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Numbers numbers(seed);
    DwbCriticParameters parameters;
    parameters.sumsScores = isHeads(numbers);
    Judge base("BaseObstacle", parameters), footprint("ObstacleFootprint", parameters);
    for (std::uint8_t& cost : base.scene.costmap.costs()) {
      const bool isHigh = isHeads(numbers, 0.004);
      cost =
          static_cast<std::uint8_t>(isHigh ? numbers.between(250, 256) : numbers.between(0, 240));
    }
    footprint.scene.costmap = base.scene.costmap;
    base.prepare(bentPath(numbers));
    footprint.prepare(bentPath(numbers));
    for (int i = 0; i < 50; ++i) {
      const std::vector<Pose2> poses = anyPoses(numbers);
      QVERIFY(centre.add(base.score(poses), plain_dwb::obstaclePrice(base.scene.costmap, poses,
                                                                     parameters.sumsScores)));
      QVERIFY(
          edges.add(footprint.score(poses),
                    plain_dwb::footprintPrice(base.scene.costmap, footprint.scene.shape.vertices,
                                              poses, parameters.sumsScores)));
    }
  }
  centre.check();
  edges.check();
}

void DwbCriticsRandomTest::gridCritics_areTheSame() {
  Tally all;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Numbers numbers(seed);
    const std::array<const char*, 3> aggregations = {"last", "sum", "product"};
    DwbCriticParameters parameters;
    parameters.aggregation = aggregations[seed % 3];
    const Path path = bentPath(numbers);
    for (const std::string name : {"PathDist", "GoalDist", "PathAlign", "GoalAlign"}) {
      Judge judge(name, parameters);
      judge.scene.robot = {{numbers.between(-0.6, 0.2), 0.1}, 0.0};
      judge.prepare(path);
      Path shown = path;
      if (name == "GoalAlign") {
        const Vec2 way = path.back().position - judge.scene.robot.position;
        shown.back().position += parameters.forwardPointDistance * way / way.norm();
      }
      std::vector<sim2d::Cell> seeds = plain_dwb::seedsOf(shown, judge.scene.costmap);
      if (name.find("Goal") == 0) {
        seeds = {seeds.back()};
      }
      const plain_dwb::Grid grid(judge.scene.costmap, seeds);
      const double ahead = name.find("Align") == 4 ? parameters.forwardPointDistance : 0.0;
      for (int i = 0; i < 50; ++i) {
        const std::vector<Pose2> poses = anyPoses(numbers);
        QVERIFY2(all.add(judge.score(poses), plain_dwb::gridPrice(judge.scene.costmap, grid, poses,
                                                                  ahead, parameters.aggregation)),
                 name.c_str());
      }
    }
  }
  all.check();
}

void DwbCriticsRandomTest::rotateToGoal_isTheSame() {
  Tally all;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Numbers numbers(seed);
    const Distro distro = seed % 2 == 0 ? Distro::Jazzy : Distro::Main;
    DwbCriticParameters parameters;
    parameters.slowingFactor = numbers.between(1.0, 10.0);
    Judge judge("RotateToGoal", parameters, distro);
    plain_dwb::RotateToGoal second(parameters, DwbParameters());
    const Pose2 goal{{numbers.between(-0.3, 0.3), 0.0}, numbers.between(-3.1, 3.1)};
    for (int cycle = 0; cycle < 5; ++cycle) {
      judge.scene.robot = {{numbers.between(-0.2, 0.2), 0.0}, 0.0};
      judge.scene.speed = {numbers.between(-0.5, 0.5), 0.0, numbers.between(-0.3, 0.3)};
      const double length = numbers.between(0.5, 1.5);
      const Path plan = {{Vec2::Zero(), 0.0}, {{length, 0.0}, 0.0}};
      judge.prepare(plan, goal);
      second.prepare(judge.scene.robot, judge.scene.speed, goal,
                     distro == Distro::Main ? length : 0.0);
      for (int i = 0; i < 10; ++i) {
        const std::vector<Pose2> poses = anyPoses(numbers);
        const BodyTwist twist = anyTwist(numbers);
        QVERIFY(all.add(judge.score(poses, twist), second.score(twist, poses.back().heading)));
      }
    }
  }
  all.check();
}

void DwbCriticsRandomTest::oscillation_isTheSame() {
  Tally all;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Numbers numbers(seed);
    DwbCriticParameters parameters;
    parameters.xOnlyThreshold = isHeads(numbers, 0.2) ? -1.0 : 0.15;
    parameters.resetTime = isHeads(numbers) ? -1.0 : 0.5;
    parameters.resetDistance = isHeads(numbers, 0.2) ? -1.0 : 0.05;
    Judge judge("Oscillation", parameters);
    plain_dwb::Oscillation second(parameters);
    for (int cycle = 0; cycle < 60; ++cycle) {
      judge.scene.time = 0.1 * cycle;
      judge.scene.robot.position +=
          Vec2(numbers.between(-0.02, 0.03), numbers.between(-0.02, 0.02));
      judge.scene.robot.heading += numbers.between(-0.08, 0.08);
      judge.prepare(control_scene::straight(1.0));
      for (int i = 0; i < 4; ++i) {
        const BodyTwist twist = anyTwist(numbers);
        QVERIFY(all.add(judge.priceOf(twist), second.score(twist)));
      }
      const BodyTwist chosen = anyTwist(numbers);
      judge.critic().debrief(chosen);
      second.debrief(chosen, judge.scene.robot, judge.scene.time);
    }
  }
  all.check();
}

QTEST_APPLESS_MAIN(DwbCriticsRandomTest)
#include "tst_DwbCriticsRandom.moc"
