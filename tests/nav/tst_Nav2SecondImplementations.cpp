#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/PathSmoother.h"
#include "tests/nav/CostmapSketch.h"
#include "tests/nav/MetaTypes.h"
#include "tests/nav/Nav2SecondPlanners.h"
#include "tests/nav/Nav2SecondServers.h"

using namespace costs;
using namespace sim2d::nav2;
using sim2d::BodyTwist;

namespace {

int wholeBetween(Numbers& numbers, int low, int high) {  // without `high`
  return static_cast<int>(numbers.between(low, high));
}

bool isHeads(Numbers& numbers, double share = 0.5) {
  return numbers.next() < share;
}

/// Lethal and unknown cells and costs of other layers at random.
Costmap speckled(Numbers& numbers, int side) {
  Costmap costmap(side, side, isHeads(numbers) ? 0.05 : 0.1, {-1.0, 2.0});
  const double lethal = numbers.between(0.002, 0.08);
  for (std::uint8_t& cost : costmap.costs()) {
    const double drawn = numbers.next();
    if (drawn < lethal) {
      cost = 254;
    } else if (drawn < lethal + 0.03) {
      cost = 255;
    } else if (drawn < lethal + 0.1) {
      cost = static_cast<std::uint8_t>(wholeBetween(numbers, 1, 254));
    }
  }
  return costmap;
}

/// A wavy path; `turnsBack` gives it cusps.
Path wavy(Numbers& numbers, bool turnsBack) {
  Path path;
  Pose2 pose{{numbers.between(-3.0, 3.0), numbers.between(-3.0, 3.0)}, numbers.between(-3.0, 3.0)};
  const int count = wholeBetween(numbers, 3, 70);
  for (int i = 0; i < count; ++i) {
    path.push_back(pose);
    pose.heading += numbers.between(-0.5, 0.5);
    if (turnsBack && isHeads(numbers, 0.06)) {
      pose.heading += base::kPi;
    }
    pose.position += numbers.between(0.03, 0.12) * pose.direction();
  }
  return path;
}

Costmap clutteredWithUnknown(Numbers& numbers, std::uint64_t seed) {
  Costmap costmap = cluttered(50, seed);
  for (int i = 0; i < 60; ++i) {
    const int cost = isHeads(numbers) ? 254 : 255;
    costmap.set({wholeBetween(numbers, 0, 50), wholeBetween(numbers, 0, 50)},
                static_cast<std::uint8_t>(cost));
  }
  return costmap;
}

Smac2DParameters anySmac2D(Numbers& numbers, Distro distro) {
  Smac2DParameters parameters;
  parameters.allowUnknown = isHeads(numbers);
  parameters.tolerance = numbers.between(0.01, 0.5);
  parameters.costTravelMultiplier = isHeads(numbers) ? 1.0 : numbers.between(0.0, 3.0);
  parameters.maxOnApproachIterations = wholeBetween(numbers, 1, 300);
  parameters.smootherRefinementNum = distro == Distro::Humble ? 4 : 2;
  return parameters;
}

double farthestApart(const Path& path, const std::vector<Vec2>& wanted) {
  double farthest = path.size() == wanted.size() ? 0.0 : 1e9;
  for (std::size_t i = 0; i < std::min(path.size(), wanted.size()); ++i) {
    farthest = std::max(farthest, (path[i].position - wanted[i]).norm());
  }
  return farthest;
}

/// A shape of collision_monitor at random: a circle or a star about the robot.
nav2second::Shape anyShape(Numbers& numbers, Distro distro, int number) {
  nav2second::Shape shape;
  MonitorPolygon& keys = shape.keys;
  keys.name = "shape" + std::to_string(number);
  keys.actionType = std::array{
      "stop", "slowdown", "limit",
      "approach"}[static_cast<std::size_t>(wholeBetween(numbers, number == 0 ? 1 : 0, 4))];
  keys.minPoints = wholeBetween(numbers, 1, 6);
  keys.maxPoints = wholeBetween(numbers, 0, 6);
  shape.needed = distro == Distro::Humble ? keys.maxPoints + 1 : keys.minPoints;
  keys.slowdownRatio = numbers.between(0.1, 1.2);
  keys.linearLimit = numbers.between(0.05, 0.6);
  keys.angularLimit = numbers.between(0.05, 0.8);
  keys.timeBeforeCollision = numbers.between(0.5, 2.5);
  keys.simulationTimeStep = numbers.between(0.02, 0.2);
  keys.type = isHeads(numbers, 0.3) ? "circle" : "polygon";
  keys.radius = numbers.between(0.2, 0.6);
  if (keys.type == "polygon") {
    const int count = wholeBetween(numbers, 3, 9);
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * base::kPi * (i + numbers.between(0.0, 0.7)) / count;
      shape.corners.push_back(numbers.between(0.15, 0.7) * base::directionOf(angle));
      keys.pointList.push_back(shape.corners.back().x());
      keys.pointList.push_back(shape.corners.back().y());
    }
  }
  return shape;
}

}  // namespace

/// Parts of Nav2 against second implementations (Nav2SecondPlanners.h, Nav2SecondServers.h) on
/// random input, each distribution by its own rules. The figures are those of NAV2.md.
class Nav2SecondImplementationsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void inflation_randomMaps_isTheSame_data() { addRows(); }

  void inflation_randomMaps_isTheSame() {
    QFETCH(Distro, distro);
    int cells = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      Numbers numbers(seed);
      Costmap costmap = speckled(numbers, 40);
      InflationLayerParameters parameters;
      parameters.inflationRadius = numbers.between(0.05, 0.7);
      parameters.costScalingFactor = numbers.between(0.5, 12.0);
      parameters.inflateUnknown = isHeads(numbers);
      parameters.inflateAroundUnknown = isHeads(numbers, 0.3);
      CostmapContext context;
      context.distro = distro;
      context.footprint.inscribed = numbers.between(0.0, 0.3);
      const int left = wholeBetween(numbers, 0, 20), bottom = wholeBetween(numbers, 0, 20);
      const CellWindow window{left, bottom, wholeBetween(numbers, left, 41),
                              wholeBetween(numbers, bottom, 41)};
      const nav2second::Inflation wanted(costmap, window, parameters, context.footprint.inscribed,
                                         distro);
      makeLayer(parameters, LayerSite{"inflation_layer", context, costmap, CostmapSetup()})
          ->updateCosts(costmap, window);
      QVERIFY2(costmap.costs() == wanted.result().costs(), qPrintable(QString::number(seed)));
      cells += (window.right - window.left) * (window.top - window.bottom);
    }
    qInfo("%d cells, largest difference 0", cells);
  }
  void smac2D_randomMaps_isTheSame_data() { addRows(); }

  void smac2D_randomMaps_isTheSame() {
    QFETCH(Distro, distro);
    int found = 0, nearer = 0;
    double farthest = 0.0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      Numbers numbers(seed * 31);
      const Costmap costmap = clutteredWithUnknown(numbers, seed);
      Smac2DParameters parameters = anySmac2D(numbers, distro);
      parameters.smootherMaxIterations = 0;
      const Cell from{wholeBetween(numbers, 0, 50), wholeBetween(numbers, 0, 50)};
      const Cell to{wholeBetween(numbers, 0, 50), wholeBetween(numbers, 0, 50)};
      if (from == to) {
        continue;
      }
      const Pose2 start{costmap.cellToWorld(from), 0.0}, goal{costmap.cellToWorld(to), 0.0};
      const Path path = makeGlobalPlanner(parameters, distro)->plan({costmap, start, goal}).path;
      const std::vector<Cell> wanted =
          nav2second::Smac2D(costmap, parameters, distro).path(from, to);
      std::vector<Cell> cells;
      for (const Pose2& pose : path) {
        cells.push_back(*costmap.worldToCell(pose.position));
      }
      QVERIFY2(cells == wanted, qPrintable(QString::number(seed)));
      std::vector<Vec2> places;
      for (const Cell cell : wanted) {
        places.push_back(costmap.cellToWorld(cell));
      }
      parameters.smootherMaxIterations = 1000;
      const Path smooth = makeGlobalPlanner(parameters, distro)->plan({costmap, start, goal}).path;
      farthest = std::max(
          farthest, farthestApart(smooth, nav2second::smacSmoothed(places, costmap, parameters)));
      found += path.empty() ? 0 : 1;
      nearer += path.empty() || cells.back() == to ? 0 : 1;
    }
    QVERIFY(found > 100 && nearer > 5);
    QVERIFY2(farthest < 1e-11, qPrintable(QString::number(farthest)));
    qInfo("%d paths, %d of them only near the goal, largest difference 0, smoothed %.1e m", found,
          nearer, farthest);
  }
  void simpleSmoother_randomPaths_isTheSame_data() { addRows(); }

  void simpleSmoother_randomPaths_isTheSame() {
    QFETCH(Distro, distro);
    double farthest = 0.0;
    int blocked = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      Numbers numbers(seed);
      const Path path = wavy(numbers, seed % 3 == 0);
      Costmap costmap(140, 140, 0.1, {-7.0, -7.0});
      for (int i = 0; i < 400; ++i) {
        const Cell cell{wholeBetween(numbers, 0, 140), wholeBetween(numbers, 0, 140)};
        costmap.set(cell, static_cast<std::uint8_t>(wholeBetween(numbers, 250, 256)));
      }
      SimpleSmootherParameters parameters;
      parameters.maxIts = isHeads(numbers) ? 1000 : wholeBetween(numbers, 1, 30);
      parameters.tolerance = isHeads(numbers) ? 1e-10 : 1e-3;
      parameters.wData = numbers.between(0.05, 0.5);
      parameters.wSmooth = numbers.between(0.05, 0.45);
      parameters.doRefinement = isHeads(numbers);
      parameters.refinementNum = wholeBetween(numbers, 0, 4);
      const SmoothResult found = smoothPath(parameters, distro, path, costmap, 60.0);
      const auto wanted = nav2second::simplySmoothed(path, costmap, parameters, distro);
      farthest = std::max(farthest, farthestApart(found.path, wanted));
      blocked += found.wasCompleted ? 0 : 1;
    }
    QVERIFY2(farthest < 1e-11, qPrintable(QString::number(farthest)));
    QVERIFY(blocked > 30 && blocked < 190);
    qInfo("200 paths, %d of them ended early, largest difference %.1e m", blocked, farthest);
  }
  void savitzkyGolay_randomPaths_isTheSame_data() { addRows(); }

  void savitzkyGolay_randomPaths_isTheSame() {
    QFETCH(Distro, distro);
    double farthest = 0.0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      Numbers numbers(seed);
      const Path path = wavy(numbers, seed % 3 == 0);
      SavitzkyGolayParameters parameters;
      parameters.windowSize = 2 * wholeBetween(numbers, 1, 7) + 1;
      parameters.polyOrder = wholeBetween(numbers, 0, std::min(parameters.windowSize, 6));
      parameters.doRefinement = isHeads(numbers);
      parameters.refinementNum = wholeBetween(numbers, 0, 4);
      const Path found = smoothPath(parameters, distro, path, Costmap(), 3.0).path;
      const auto wanted = nav2second::polynomiallySmoothed(path, parameters, distro);
      farthest = std::max(farthest, farthestApart(found, wanted));
    }
    QVERIFY2(farthest < 1e-11, qPrintable(QString::number(farthest)));
    qInfo("200 paths, largest difference %.1e m", farthest);
  }

  void velocitySmoother_randomCommands_isTheSame() {
    double largest = 0.0;
    int silent = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      Numbers numbers(seed);
      VelocitySmootherParameters parameters;
      parameters.scaleVelocities = isHeads(numbers);
      parameters.feedback = isHeads(numbers) ? "OPEN_LOOP" : "CLOSED_LOOP";
      parameters.odomDuration = 0.02;  // the newest odometry alone
      parameters.velocityTimeout = numbers.between(0.1, 1.0);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        parameters.maxVelocity[axis] = numbers.between(0.1, 1.5);
        parameters.minVelocity[axis] = -numbers.between(0.0, 1.5);
        parameters.maxAccel[axis] = isHeads(numbers, 0.1) ? 0.0 : numbers.between(0.1, 4.0);
        parameters.maxDecel[axis] = -numbers.between(0.1, 6.0);
        parameters.deadbandVelocity[axis] = isHeads(numbers, 0.3) ? 0.05 : 0.0;
      }
      VelocitySmoother smoother(parameters);
      nav2second::Smoother second(parameters);
      nav2second::Twist command{}, odometry{};
      for (int tick = 0; tick < 300; ++tick) {
        const double time = 0.05 * tick;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          command[axis] = isHeads(numbers, 0.1) ? numbers.between(-2.0, 2.0) : command[axis];
          odometry[axis] = numbers.between(-1.0, 1.0);
        }
        if (tick % 100 < 70) {  // then no command comes for 1.5 s
          smoother.command({command[0], command[2], command[1]}, time);
          second.command(command, time);
        }
        nav2second::Twist wanted{};
        const bool isSent = second.tick(time, odometry, wanted);
        const auto found = smoother.update(time, {odometry[0], odometry[2], odometry[1]});
        QCOMPARE(found.has_value(), isSent);
        silent += isSent ? 0 : 1;
        if (isSent) {
          largest = std::max({largest, std::fabs(found->linear - wanted[0]),
                              std::fabs(found->lateral - wanted[1]),
                              std::fabs(found->angular - wanted[2])});
        }
      }
    }
    QVERIFY2(largest < 1e-12, qPrintable(QString::number(largest)));
    QVERIFY(silent > 1000);
    qInfo("30000 ticks, %d of them silent, largest difference %.1e", silent, largest);
  }
  void collisionMonitor_randomScans_isTheSame_data() { addRows(); }

  void collisionMonitor_randomScans_isTheSame() {
    QFETCH(Distro, distro);
    double largest = 0.0;
    int acted = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
      Numbers numbers(seed);
      CollisionMonitorParameters parameters;
      parameters.sources = {MonitorSource{"scan"}};
      std::vector<nav2second::Shape> shapes;
      for (int i = 0; i < wholeBetween(numbers, 1, 4); ++i) {
        shapes.push_back(anyShape(numbers, distro, i));
        parameters.shapes.push_back(shapes.back().keys);
      }
      sim2d::LaserScan scan;
      scan.angleIncrement = 2.0 * base::kPi / 90.0;
      scan.range = 2.0;
      std::vector<Vec2> points;
      for (int i = 0; i < 90; ++i) {
        scan.distances.push_back(isHeads(numbers, 0.6) ? 2.0 : numbers.between(0.3, 1.9));
        if (scan.distances.back() < scan.range) {
          points.push_back(scan.distances.back() * base::directionOf(i * scan.angleIncrement));
        }
      }
      const nav2second::Twist command = {numbers.between(-0.6, 1.0),
                                         isHeads(numbers) ? 0.0 : numbers.between(-0.5, 0.5),
                                         isHeads(numbers) ? 0.0 : numbers.between(-1.0, 1.0)};
      std::string by;
      const nav2second::Twist wanted = nav2second::Monitor(shapes).filtered(command, points, by);
      sim2d::Observation observation;
      observation.scan = &scan;
      const MonitoredCommand found = CollisionMonitor(parameters, {}, distro)
                                         .filter({command[0], command[2], command[1]}, observation);
      QCOMPARE(found.polygon, by);
      acted += by.empty() ? 0 : 1;
      largest = std::max({largest, std::fabs(found.twist.linear - wanted[0]),
                          std::fabs(found.twist.lateral - wanted[1]),
                          std::fabs(found.twist.angular - wanted[2])});
    }
    QVERIFY2(largest < 1e-12, qPrintable(QString::number(largest)));
    QVERIFY(acted > 100 && acted < 390);
    qInfo("400 scans, on %d of them a shape acted, largest difference %.1e", acted, largest);
  }
  void goalCheckers_randomWalks_areTheSame_data() { addRows(); }

  void goalCheckers_randomWalks_areTheSame() {
    QFETCH(Distro, distro);
    int reached = 0, asked = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
      Numbers numbers(seed);
      const std::string kind = std::array{"Simple", "Stopped", "Position"}[seed % 3];
      GoalCheckerParameters parameters;
      parameters.isStateful = isHeads(numbers);
      parameters.isSymmetric = isHeads(numbers);
      const Nav2ParameterBlock block = {
          {"stateful", Nav2Value(parameters.isStateful)},
          {"symmetric_yaw_tolerance", Nav2Value(parameters.isSymmetric)}};
      auto checker = makeGoalChecker("nav2_controller::" + kind + "GoalChecker", distro, block);
      QVERIFY(checker);
      nav2second::Arrival second(kind, distro, parameters);
      for (int i = 0; i < 200; ++i) {
        GoalQuery query;
        query.robot = {{numbers.between(-0.5, 0.5), numbers.between(-0.5, 0.5)},
                       numbers.between(-3.1, 3.1)};
        query.goal = {Vec2::Zero(), numbers.between(-0.4, 0.4)};
        query.speed = {numbers.between(-0.4, 0.4), numbers.between(-0.4, 0.4),
                       isHeads(numbers) ? 0.0 : numbers.between(-0.3, 0.3)};
        query.pathLength = numbers.between(0.0, 1.2);
        if (isHeads(numbers, 0.1)) {
          (*checker)->reset();
          second.reset();
        }
        const bool isReached = second.isReached(query);
        QCOMPARE((*checker)->isGoalReached(query), isReached);
        reached += isReached ? 1 : 0;
        ++asked;
      }
    }
    QVERIFY(reached > 1000);
    qInfo("%d questions, %d of them with the goal reached, no difference", asked, reached);
  }

  void progressCheckers_randomWalks_areTheSame() {
    int failed = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      Numbers numbers(seed);
      const bool countsTurns = seed % 2 == 0;
      ProgressCheckerParameters parameters;
      parameters.movementRadius = numbers.between(0.2, 1.0);
      parameters.movementAngle = numbers.between(0.2, 1.5);
      parameters.movementTimeAllowance = numbers.between(1.0, 5.0);
      ProgressChecker checker(
          countsTurns ? ProgressChecker::Kind::Pose : ProgressChecker::Kind::Simple, parameters);
      std::vector<std::pair<double, Pose2>> history;
      Pose2 pose;
      for (int i = 0; i < 200; ++i) {
        pose.position += Vec2(numbers.between(-0.1, 0.1), numbers.between(-0.1, 0.1));
        pose.heading += numbers.between(-0.1, 0.1);
        history.emplace_back(0.05 * i, pose);
        const bool isMoving = nav2second::progresses(history, countsTurns, parameters);
        QCOMPARE(checker.check(pose, 0.05 * i), isMoving);
        failed += isMoving ? 0 : 1;
      }
    }
    QVERIFY(failed > 1000 && failed < 19000);
    qInfo("20000 questions, %d of them without progress, no difference", failed);
  }

 private:
  static void addRows() {
    QTest::addColumn<Distro>("distro");
    for (const Distro distro : kDistros) {
      QTest::newRow(std::array{"humble", "jazzy", "kilted", "lyrical",
                               "main"}[static_cast<std::size_t>(distro)])
          << distro;
    }
  }
};

QTEST_APPLESS_MAIN(Nav2SecondImplementationsTest)
#include "tst_Nav2SecondImplementations.moc"
