#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <QtTest>

#include "sim2d/base/Rng.h"
#include "sim2d/nav/nav2/mppi/MppiOptimizer.h"
#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "tests/nav/MppiReference.h"
#include "tests/nav/Nav2MppiReference.h"
#include "tests/nav/Nav2MppiScenes.h"

using namespace sim2d::nav2;
using nav2test::HandScene;
using sim2d::BodyTwist;
using sim2d::MppiSimdLevel;

namespace {

MppiConfiguration smallMppi(Distro distro, MppiMotion motion) {
  MppiConfiguration mppi = nav2test::stockMppi(distro);
  mppi.motion = motion;
  mppi.settings.batchSize = 50;  // no multiple of 16
  mppi.settings.timeSteps = 24;
  mppi.critics.pathAlign.offsetFromFurthest = 3;  // short ways shall meet it
  mppi.critics.pathAngle.maxAngleToFurthest = 0.05;
  mppi.critics.goalAngle.threshold = mppi.critics.goal.threshold = 5.0;
  return mppi;
}

struct Bits {
  std::vector<float> costs, weights, x, controls;
  MppiSequence sequence;
  BodyTwist twist;
};

Bits bitsOf(const MppiConfiguration& mppi, const HandScene& scene, MppiSimdLevel path) {
  MppiOptimizer optimizer(mppi, {0.05, 7, 3, path});
  Bits bits;
  for (int call = 0; call < 3; ++call) {
    const auto command = optimizer.command(scene.view());
    bits.twist = command.value_or(BodyTwist{9.0, 9.0, 9.0});
  }
  bits.costs = optimizer.costs();
  bits.weights = optimizer.weights();
  bits.x = optimizer.trajectories().x;
  bits.controls = optimizer.trajectories().controls[1];
  bits.sequence = optimizer.sequence();
  return bits;
}

/// Three cycles on the noise of the optimiser. Single precision is 6e-8 of a number; sums over 24
/// steps and 8 critics: 1e-5 of the costs. Costs of the trajectories that count differ by less than
/// 10, off by 1e-5 of that, over the temperature of 0.3: 3e-4 of a weight at the very most. What is
/// averaged differs by less than 1: found are 2e-6, allowed 2e-5.
void compareCycles(const MppiConfiguration& mppi, double period, HandScene scene) {
  int hits = 0;
  MppiOptimizer optimizer(mppi, {period, 7, 3});
  nav2reference::Reference reference(mppi, period);
  double worstCost = 0.0;
  double worstControl = 0.0;
  for (int call = 0; call < 3; ++call) {
    const auto command = optimizer.command(scene.view());
    QVERIFY(command.has_value());
    const auto& columns = optimizer.trajectories();
    const auto wanted = reference.cycle(scene, [&](int sample, int step, int axis) {
      return static_cast<double>(
          columns.noise[static_cast<std::size_t>(axis)][columns.elementIndex(step, sample)]);
    });
    QCOMPARE(optimizer.critics().furthest().value_or(-1), static_cast<int>(reference.furthest()));
    for (int i = 0; i < columns.count(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const auto& way = reference.trajectories()[at];
      QCOMPARE(optimizer.critics().hits()[at] > 0.0F, way.hits);
      hits += way.hits ? 1 : 0;
      const double cost = static_cast<double>(optimizer.costs()[at]);
      worstCost = std::max(worstCost, std::fabs(cost - way.cost) / (1.0 + way.cost));
    }
    for (std::size_t i = 0; i < reference.sequence().size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double control = static_cast<double>(optimizer.sequence()[axis][i]);
        worstControl = std::max(worstControl, std::fabs(control - reference.sequence()[i][axis]));
      }
    }
    QVERIFY(std::fabs(command->linear - wanted[0]) < 2e-5);
    QVERIFY(std::fabs(command->angular - wanted[1]) < 2e-5);
    QVERIFY(std::fabs(command->lateral - wanted[2]) < 2e-5);
    for (std::size_t critic = 0; critic < optimizer.critics().names().size(); ++critic) {
      QVERIFY2(call > 0 || optimizer.critics().wasEvaluated(critic),  // 0 would agree with 0
               optimizer.critics().names()[critic].c_str());
    }
    scene.robot.position += 0.05 * command->linear * scene.robot.direction();
    scene.robot.heading += 0.05 * command->angular;
    scene.speed = *command;
  }
  qInfo("%d hits, costs within %.1e, controls within %.1e", hits, worstCost, worstControl);
  QVERIFY(worstCost < 1e-5);
  QVERIFY(worstControl < 2e-5);
}

/// Main, without a critic that sees obstacles: after one step of 0.0125 m, whatever the noise, the
/// robot is in the cell of a wall.
HandScene wallAhead(MppiConfiguration& mppi, std::uint8_t cost) {
  mppi = smallMppi(Distro::Main, MppiMotion::DiffDrive);
  mppi.settings.critics = {"PathFollowCritic"};
  mppi.settings.timeSteps = 56;
  HandScene scene;
  scene.goAhead(1.45, 30);
  scene.goal.position.x() = 9.0;
  scene.robot.position.x() = 0.04;
  scene.speed.linear = 0.4;  // the last command was 0: 0.4 - 3 * 0.05 is the start
  const int wall = scene.costmap.worldToCell(Vec2(0.06, 0.0))->column;
  for (int row = 0; row < scene.costmap.height(); ++row) {
    scene.costmap.set({wall, row}, cost);
  }
  return scene;
}

bool isCommanded(const MppiConfiguration& mppi, const HandScene& scene) {
  return MppiOptimizer(mppi, {}).command(scene.view()).has_value();
}

/// Anything that `readMppi` lets through, by number.
MppiConfiguration wildMppi(std::uint32_t number, HandScene& scene) {
  const base::AgentRng rng(number, 0);
  std::uint32_t draw = 0;
  const auto pick = [&](const std::vector<double>& values) {
    const double u = rng.uniform01(base::DrawPurpose::Test, draw++);
    return values[static_cast<std::size_t>(u * static_cast<double>(values.size()))];
  };
  const auto count = [&](const std::vector<double>& values) {
    return static_cast<int>(pick(values));
  };
  MppiConfiguration mppi = nav2test::stockMppi(static_cast<Distro>(count({0, 1, 4})));
  mppi.motion = static_cast<MppiMotion>(count({0, 1, 2}));
  visitCritics(mppi.critics, [&](const char* name, auto& critic) {
    critic.power = count({0, 1, 1, 2, 3});
    critic.weight = pick({0.0, 1.0, 5.0, 1000.0});
    if (count({0, 1, 1}) != 0) {
      mppi.settings.critics.emplace_back(name);
    }
  });
  MppiSettings& settings = mppi.settings;
  settings.batchSize = count({1, 2, 15, 16, 17, 40});
  settings.timeSteps = count({2, 3, 20, 21, 56, 200});
  settings.iterationCount = count({1, 3});
  settings.retryAttemptLimit = count({0, 1, 3});
  settings.temperature = pick({1e-9, 0.3, 1e6});
  settings.vxStd = pick({0.0, 1e-6, 0.2, 100.0});
  settings.wzStd = pick({0.0, 0.4, 100.0});
  settings.vyStd = pick({0.0, 0.2, 100.0});
  settings.vxMin = pick({-0.35, 0.0, 0.4});
  settings.axMax = pick({0.0, 3.0, 1e6});
  settings.vxDelay = pick({0.0, 0.05, 0.12, 1e6});
  settings.sgfOrder = count({1, 2});
  settings.collisionLookahead = pick({0.0, 2.0, 1e6});
  settings.validatesFootprint = count({0, 1}) != 0;
  settings.isOpenLoop = count({0, 1}) != 0;
  settings.regeneratesNoises = count({0, 1}) != 0;
  mppi.critics.cost.considersFootprint = count({0, 1}) != 0;
  mppi.critics.obstacles.considersFootprint = count({0, 1}) != 0;
  mppi.critics.cost.pointStep = count({1, 2, 200});
  mppi.critics.pathAlign.pointStep = count({1, 4, 200});
  mppi.critics.pathAlign.offsetFromFurthest = count({0, 1, 20});
  mppi.critics.pathFollow.offsetFromFurthest = count({0, 6, 50000});
  mppi.critics.pathAngle.offsetFromFurthest = count({0, 4, 50000});
  mppi.critics.pathAngle.mode = count({0, 1, 2});
  scene.path.resize(static_cast<std::size_t>(count({1, 2, 3, 33})));
  scene.shape.tracksUnknown = count({0, 1}) != 0;
  scene.shape.inflationRadius = pick({0.0, 0.7});
  scene.robot.position.x() = pick({0.0, 0.0, 1.4, 1e6});
  scene.speed = {pick({0.0, -0.3, 0.5}), pick({0.0, 1.9}), pick({0.0, 0.3})};
  if (count({0, 0, 0, 1}) != 0) {
    scene.costmap = Costmap(0, 0, 0.05, Vec2(0.0, 0.0));
  }
  return mppi;
}

}  // namespace

/// The optimiser of Nav2's MPPI: whole cycles against plain loops in double precision
/// (Nav2MppiReference.h), its instruction sets against each other, its noise, its failures.
class Nav2MppiTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cycle_anyRelease_agreesWithReference_data() {
    QTest::addColumn<int>("distro");
    QTest::addColumn<int>("motion");
    QTest::addColumn<double>("period");
    QTest::addColumn<bool>("isOpenLoop");
    const char* motions[] = {"DiffDrive", "Omni", "Ackermann"};
    for (const Distro branch : kDistros) {
      const int distro = static_cast<int>(branch);
      for (int motion = 0; motion < 3; ++motion) {
        QTest::addRow("%s, %s", distroTitle(branch), motions[motion])
            << distro << motion << 0.05 << false;
      }
      QTest::addRow("%s, no shift", distroTitle(branch)) << distro << 0 << 0.04 << false;
      QTest::addRow("%s, open loop", distroTitle(branch)) << distro << 1 << 0.05 << true;
    }
  }

  void cycle_anyRelease_agreesWithReference() {
    QFETCH(int, distro);
    QFETCH(int, motion);
    QFETCH(double, period);
    QFETCH(bool, isOpenLoop);
    MppiConfiguration mppi =
        smallMppi(static_cast<Distro>(distro), static_cast<MppiMotion>(motion));
    mppi.settings.isOpenLoop = isOpenLoop;
    HandScene scene = nav2test::curve();
    scene.speed.lateral = motion == 1 ? 0.05 : 0.0;
    compareCycles(mppi, period, scene);
  }

  void cycle_otherCritics_agreesWithReference_data() {
    QTest::addColumn<int>("distro");
    QTest::addColumn<int>("motion");
    for (const Distro branch : kDistros) {
      QTest::addRow("%s, DiffDrive", distroTitle(branch)) << static_cast<int>(branch) << 0;
      QTest::addRow("%s, Omni", distroTitle(branch)) << static_cast<int>(branch) << 1;
    }
  }

  /// The critics that the bringup's file leaves out, odd strides, headings of the path, powers.
  void cycle_otherCritics_agreesWithReference() {
    QFETCH(int, distro);
    QFETCH(int, motion);
    MppiConfiguration mppi =
        smallMppi(static_cast<Distro>(distro), static_cast<MppiMotion>(motion));
    mppi.settings.critics = {"ObstaclesCritic", "TwirlingCritic", "VelocityDeadbandCritic",
                             "PathAlignCritic", "PathAngleCritic"};
    mppi.critics.obstacles.nearGoalDistance = 0.1;
    mppi.critics.obstacles.collisionCost = 1e3;  // sums of single precision stay comparable
    mppi.critics.twirling.power = 2;
    mppi.critics.deadband.velocities = {0.3, 0.2, 0.4};
    mppi.critics.pathAlign.pointStep = 3;
    mppi.critics.pathAlign.usesOrientations = true;
    HandScene scene = nav2test::curve();
    scene.addObstacle(Vec2(0.325, -0.075));
    scene.speed.lateral = motion == 1 ? 0.05 : 0.0;
    compareCycles(mppi, 0.05, scene);
  }

  void cycle_everyInstructionSet_hasEqualBits() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy, Distro::Main}) {
      for (int motion = 0; motion < 3; ++motion) {
        MppiConfiguration mppi = smallMppi(distro, static_cast<MppiMotion>(motion));
        mppi.settings.critics.insert(
            mppi.settings.critics.end(),
            {"ObstaclesCritic", "TwirlingCritic", "VelocityDeadbandCritic"});
        mppi.settings.iterationCount = 2;
        mppi.settings.regeneratesNoises = motion == 1;
        mppi.critics.cost.considersFootprint = motion == 2;
        mppi.critics.obstacles.considersFootprint = motion == 2;
        mppi.critics.pathAlign.usesOrientations = motion == 0;
        mppi.critics.pathAngle.mode = motion;
        mppi.critics.deadband.velocities = {0.1, 0.1, 0.1};
        const HandScene scene = nav2test::curve();
        const Bits first = bitsOf(mppi, scene, MppiSimdLevel::Sse2);
        QVERIFY(first.twist.linear < 9.0);
        for (const MppiSimdLevel path : {MppiSimdLevel::Avx2, MppiSimdLevel::Avx512}) {
          if (!sim2d::isMppiSimdLevelSupported(path)) {
            continue;
          }
          const Bits other = bitsOf(mppi, scene, path);
          QVERIFY(other.x == first.x);
          QVERIFY(other.controls == first.controls);
          QVERIFY(other.costs == first.costs);
          QVERIFY(other.weights == first.weights);
          QVERIFY(other.sequence == first.sequence);
          QVERIFY(other.twist == first.twist);
        }
      }
    }
  }

  void command_twoObjectsSideBySide_areEqual() {
    const MppiConfiguration mppi = nav2test::stockMppi(Distro::Main);
    HandScene scene = nav2test::curve();
    MppiOptimizer one(mppi, {0.05, 7, 3});
    MppiOptimizer two(mppi, {0.05, 7, 3});
    for (int call = 0; call < 4; ++call) {
      const auto command = one.command(scene.view());
      QVERIFY(command.has_value());
      QVERIFY(two.command(scene.view()) == command);
      QVERIFY(one.sequence() == two.sequence());
      scene.speed = *command;
    }
  }

  void command_otherSeedOrRobot_differs() {
    const MppiConfiguration mppi = smallMppi(Distro::Jazzy, MppiMotion::DiffDrive);
    const HandScene scene = nav2test::curve();
    const auto commandOf = [&](std::uint64_t seed, int robot) {
      return *MppiOptimizer(mppi, {0.05, seed, robot}).command(scene.view());
    };
    QVERIFY(commandOf(1, 0) == commandOf(1, 0));
    QVERIFY(commandOf(1, 0) != commandOf(2, 0));
    QVERIFY(commandOf(1, 0) != commandOf(1, 1));
    QVERIFY(commandOf(1, 0) != commandOf((1ULL << 32U) + 1, 0));
  }

  /// 2000 x 56 independent numbers per axis: the mean is off by sigma / 335, the variance by sigma²
  /// sqrt(2) / 335, correlations by 1 / 335; five of these.
  void noise_deviations_areThoseOfItsLaw() {
    MppiConfiguration mppi = nav2test::stockMppi(Distro::Jazzy);
    mppi.motion = MppiMotion::Omni;
    mppi.settings.batchSize = 2000;
    const MppiOptimizer optimizer(mppi, {});
    const auto& noise = optimizer.trajectories().noise;
    const double deviations[] = {0.2, 0.4, 0.2};
    const double n = 2000.0 * 56.0;
    const double unit = 1.0 / std::sqrt(n);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double sum = 0.0;
      double second = 0.0;
      double fourth = 0.0;
      double next = 0.0;   // with the next step of the same sample, mostly
      double other = 0.0;  // with the next axis
      for (std::size_t i = 0; i < noise[axis].size(); ++i) {
        const double value = static_cast<double>(noise[axis][i]) / deviations[axis];
        sum += value;
        second += value * value;
        fourth += value * value * value * value;
        next += value * static_cast<double>(noise[axis][(i + 16) % noise[axis].size()]) /
                deviations[axis];
        other += value * static_cast<double>(noise[(axis + 1) % 3][i]) / deviations[(axis + 1) % 3];
      }
      QCOMPARE(static_cast<double>(noise[axis].size()), n);
      QVERIFY(std::fabs(sum / n) < 5.0 * unit);
      QVERIFY(std::fabs(second / n - 1.0) < 5.0 * std::sqrt(2.0) * unit);
      QVERIFY(std::fabs(fourth / n - 3.0) < 5.0 * std::sqrt(96.0) * unit);
      QVERIFY(std::fabs(next / n) < 5.0 * unit);
      QVERIFY(std::fabs(other / n) < 5.0 * unit);
    }
  }

  void noise_values_areThoseOfTheCounter() {
    MppiConfiguration mppi = nav2test::stockMppi(Distro::Jazzy);
    mppi.motion = MppiMotion::Omni;
    mppi.settings.batchSize = 40;
    mppi.settings.timeSteps = 25;
    MppiOptimizer optimizer(mppi, {0.05, (5ULL << 32U) + 9, 4});
    sim2d::MppiNoise law;
    law.key[0] = 9;
    law.key[1] = 5;
    law.robot = 4;
    const double deviations[] = {0.2, 0.4, 0.2};
    for (int round = 0; round < 2; ++round) {
      const auto& columns = optimizer.trajectories();
      for (int sample = 0; sample < 40; ++sample) {
        for (int step = 0; step < 25; ++step) {
          for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            const double wanted = deviations[a] * reference::normal(law, sample, step, axis);
            const double found =
                static_cast<double>(columns.noise[a][columns.elementIndex(step, sample)]);
            QVERIFY(std::fabs(found - wanted) < 1e-6);
          }
        }
      }
      optimizer.reset();  // draws the next
      ++law.call;
    }
  }

  void noise_regenerateOrNot_changesFromCallToCall() {
    const HandScene scene = nav2test::curve();
    for (const bool regenerates : {false, true}) {
      MppiConfiguration mppi = smallMppi(Distro::Jazzy, MppiMotion::DiffDrive);
      mppi.settings.regeneratesNoises = regenerates;
      MppiOptimizer optimizer(mppi, {});
      optimizer.command(scene.view());
      const std::vector<float> first = optimizer.trajectories().noise[0];
      optimizer.command(scene.view());
      QCOMPARE(optimizer.trajectories().noise[0] != first, regenerates);
      optimizer.reset();
      optimizer.command(scene.view());
      QVERIFY(optimizer.trajectories().noise[0] != first);
    }
  }

  /// Without noise both iterations price the same trajectory: twice the critic's cost.
  void command_iterations_accumulateCosts() {
    MppiConfiguration mppi = smallMppi(Distro::Humble, MppiMotion::DiffDrive);
    mppi.settings.critics = {"GoalCritic"};
    mppi.settings.vxStd = mppi.settings.wzStd = 0.0;
    HandScene scene;
    scene.goAhead(1.0, 10);  // at rest 1 m from the goal
    for (const int iterations : {1, 2, 3}) {
      mppi.settings.iterationCount = iterations;
      MppiOptimizer optimizer(mppi, {});
      QVERIFY(optimizer.command(scene.view()).has_value());
      QVERIFY(std::fabs(static_cast<double>(optimizer.costs()[0]) - 5.0 * iterations) < 1e-4);
    }
  }

  /// Whatever the limit of retries: the flag stays set in them, and they fail too.
  void command_allCollide_givesUpAtOnce() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy, Distro::Main}) {
      MppiConfiguration mppi = smallMppi(distro, MppiMotion::DiffDrive);
      mppi.settings.retryAttemptLimit = 3;
      HandScene scene = nav2test::curve();
      MppiOptimizer optimizer(mppi, {});
      QVERIFY(optimizer.command(scene.view()).has_value());
      const auto costs = scene.costmap.costs();
      std::fill(scene.costmap.costs().begin(), scene.costmap.costs().end(), kLethal);
      QVERIFY(!optimizer.command(scene.view()).has_value());
      for (const std::vector<float>& axis : optimizer.sequence()) {
        QVERIFY(std::all_of(axis.begin(), axis.end(), [](float value) { return value == 0.0F; }));
      }
      const std::vector<float>& hits = optimizer.critics().hits();
      QVERIFY(std::all_of(hits.begin(), hits.end(), [](float hit) { return hit == 1.0F; }));
      QVERIFY(!optimizer.critics().wasEvaluated(2));  // behind CostCritic nobody is asked
      QVERIFY(optimizer.optimal().empty());
      scene.costmap.costs() = costs;
      QVERIFY(optimizer.command(scene.view()).has_value());
    }
  }

  void command_validator_retries() {
    MppiConfiguration mppi;
    HandScene scene = wallAhead(mppi, kInscribed);
    MppiOptimizer failing(mppi, {});
    QVERIFY(!failing.command(scene.view()).has_value());
    QVERIFY(failing.critics().wasEvaluated(0));  // in the retry as well
    // A fast sequence meets a wall far ahead; the retry, which begins from nothing, does not.
    scene = wallAhead(mppi, kFreeSpace);
    MppiOptimizer optimizer(mppi, {});
    for (int call = 0; call < 20; ++call) {
      scene.speed = optimizer.command(scene.view()).value_or(BodyTwist{});
    }
    QVERIFY(scene.speed.linear > 0.4);
    const std::vector<float> noise = optimizer.trajectories().noise[0];
    const int wall = scene.costmap.worldToCell(Vec2(0.51, 0.0))->column;
    for (int row = 0; row < scene.costmap.height(); ++row) {
      scene.costmap.set({wall, row}, kInscribed);
    }
    QVERIFY(optimizer.command(scene.view()).has_value());
    QVERIFY(optimizer.trajectories().noise[0] != noise);  // a failure draws anew
  }

  void command_validator_looksAsFarAsTold() {
    MppiConfiguration mppi;
    HandScene scene = wallAhead(mppi, kInscribed);
    QVERIFY(!isCommanded(mppi, scene));
    mppi.settings.collisionLookahead = 0.05;
    QVERIFY(!isCommanded(mppi, scene));
    mppi.settings.collisionLookahead = 0.049;  // not one step
    QVERIFY(isCommanded(mppi, scene));
    mppi.settings.collisionLookahead = 2.0;
    const HandScene lethal = wallAhead(mppi, kLethal);
    QVERIFY(!isCommanded(mppi, lethal));
    mppi.settings.validatesFootprint = true;
    QVERIFY(isCommanded(mppi, scene));  // its edges meet no 254
    QVERIFY(!isCommanded(mppi, lethal));
    mppi.distro = Distro::Jazzy;  // has no validator
    QVERIFY(isCommanded(mppi, scene));
    mppi.distro = Distro::Main;
    mppi.settings.validatesFootprint = false;
    scene.costmap = Costmap(3, 60, 0.05, Vec2(-0.1, -1.5));  // what is off the map passes
    QVERIFY(isCommanded(mppi, scene));
  }

  void command_wildParameters_isFiniteOrNone() {
    int commanded = 0;
    for (std::uint32_t number = 0; number < 200; ++number) {
      HandScene scene = nav2test::curve();
      const MppiConfiguration mppi = wildMppi(number, scene);
      MppiOptimizer optimizer(mppi, {number % 2 == 0 ? 0.05 : 0.02, number, 0});
      for (int call = 0; call < 3; ++call) {
        const auto command = optimizer.command(scene.view());
        if (command) {
          ++commanded;
          QVERIFY2(std::isfinite(command->linear) && std::isfinite(command->angular) &&
                       std::isfinite(command->lateral),
                   qPrintable(QString::number(number)));
          QVERIFY(mppi.motion == MppiMotion::Omni || command->lateral == 0.0);
        }
      }
    }
    qInfo("%d commands of 600 calls", commanded);
    QVERIFY(commanded > 200);
  }

  /// Some 10 to the power of 100 is no float.
  void command_costsBeyondFloats_isNone() {
    MppiConfiguration mppi = smallMppi(Distro::Jazzy, MppiMotion::DiffDrive);
    mppi.settings.critics = {"GoalCritic"};
    mppi.critics.goal.power = 100;
    mppi.critics.goal.threshold = 100.0;
    HandScene scene = nav2test::curve();
    scene.goal.position.x() = 5.0;
    MppiOptimizer optimizer(mppi, {});
    QVERIFY(!optimizer.command(scene.view()).has_value());
    mppi.critics.goal.power = 1;
    QVERIFY(MppiOptimizer(mppi, {}).command(scene.view()).has_value());
  }

  void setSpeedLimit_half_limitsTheCommand() {
    MppiConfiguration mppi = nav2test::stockMppi(Distro::Humble);
    HandScene scene;
    scene.goAhead(1.4, 29);
    scene.goal.position.x() = 9.0;
    MppiOptimizer optimizer(mppi, {});
    const auto fastest = [&] {
      double most = 0.0;
      for (int call = 0; call < 30; ++call) {
        const auto command = optimizer.command(scene.view());
        scene.speed = *command;
        most = command->linear;
      }
      return most;
    };
    QVERIFY(fastest() > 0.4);
    optimizer.setSpeedLimit(50.0, true);
    const double half = fastest();
    QVERIFY(half < 0.27 && half > 0.2);  // the filter comes after the limits
    optimizer.setSpeedLimit(0.0, false);
    QVERIFY(fastest() > 0.4);
    optimizer.setSpeedLimit(0.1, false);
    QVERIFY(fastest() < 0.11);
    optimizer.reset();  // Humble lifts the limit
    QVERIFY(fastest() > 0.4);
  }

  void reset_afterCalls_beginsAnew() {
    const MppiConfiguration mppi = smallMppi(Distro::Main, MppiMotion::DiffDrive);
    const HandScene scene = nav2test::curve();
    MppiOptimizer one(mppi, {});
    MppiOptimizer two(mppi, {});
    one.command(scene.view());
    one.command(scene.view());
    one.reset();
    two.reset();  // the same draw of the noise
    QVERIFY(one.command(scene.view()) == two.command(scene.view()));
  }

  void drive_toTheGoal_arrives_data() {
    QTest::addColumn<int>("distro");
    QTest::addColumn<int>("motion");
    const char* motions[] = {"DiffDrive", "Omni", "Ackermann"};
    for (const Distro branch : kDistros) {
      const int distro = static_cast<int>(branch);
      for (int motion = 0; motion < 3; ++motion) {
        QTest::addRow("%s, %s", distroTitle(branch), motions[motion]) << distro << motion;
      }
    }
  }

  /// 3 m along a bend past an obstacle, with the numbers of the bringup, perfect drive.
  void drive_toTheGoal_arrives() {
    QFETCH(int, distro);
    QFETCH(int, motion);
    MppiConfiguration mppi = nav2test::stockMppi(static_cast<Distro>(distro));
    mppi.motion = static_cast<MppiMotion>(motion);
    HandScene scene;
    scene.costmap = Costmap(120, 100, 0.05, Vec2(-1.0, -2.0));
    scene.addObstacle(Vec2(1.525, -0.275));  // its inflation reaches over the path
    Path whole;
    for (int i = 0; i <= 60; ++i) {
      const double s = 0.05 * i;
      whole.push_back({Vec2(s, 0.1 * s * s), std::atan(0.2 * s)});
    }
    scene.goal = whole.back();
    MppiOptimizer optimizer(mppi, {0.05, 1, 0});
    double nearest = 10.0;
    for (int call = 0; call < 400; ++call) {
      const auto closest =
          std::min_element(whole.begin(), whole.end(), [&](const Pose2& a, const Pose2& b) {
            return (a.position - scene.robot.position).norm() <
                   (b.position - scene.robot.position).norm();
          });
      whole.erase(whole.begin(), closest);
      scene.path.assign(whole.begin(),
                        whole.begin() + std::min<std::ptrdiff_t>(30, whole.end() - whole.begin()));
      const auto command = optimizer.command(scene.view());
      QVERIFY(command.has_value());
      scene.speed = *command;
      scene.robot.position = scene.robot.toWorld(0.05 * Vec2(command->linear, command->lateral));
      scene.robot.heading = base::wrapToPi(scene.robot.heading + 0.05 * command->angular);
      nearest = std::min(nearest, (scene.robot.position - Vec2(1.525, -0.275)).norm());
      if ((scene.robot.position - scene.goal.position).norm() < 0.25) {
        QVERIFY(nearest > scene.shape.inscribedRadius);
        qInfo("%d calls, obstacle %.2f m away, heading off by %.2f", call, nearest,
              base::angleDiff(scene.goal.heading, scene.robot.heading));
        return;
      }
    }
    QFAIL("did not arrive");
  }
};

QTEST_APPLESS_MAIN(Nav2MppiTest)
#include "tst_Nav2Mppi.moc"
