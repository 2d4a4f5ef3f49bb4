#include <cmath>
#include <limits>

#include <QtTest>

#include "sim2d/world/PersonMotion.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

Scenario walk(const std::string& model, double distance = 10.0) {
  Scenario scenario;
  scenario.desktop.model = model;
  addGoal(scenario, 1, distance, 0.0);
  addPerson(scenario, 1, Vec2::Zero(), {1});
  return scenario;
}

bool isRefused(double dt) {
  Scenario scenario = walk("sfm");
  scenario.desktop.dt = dt;
  return !create(scenario);
}

/// The force of the wall on somebody who stands 1 m beside its middle.
Vec2 forceOfWall(const std::vector<Vec2>& line) {
  Scenario scenario;
  addWall(scenario, line);
  addPerson(scenario, 1, Vec2(0.0, 1.0)).radius = 0.3;
  const auto world = make(scenario);
  advance(*world, 1);
  return world->frame().forces.obstacle[0];
}

}  // namespace

/// Faults of the forces that the original is known for, one test each: the numbers of the table in
/// sim2d/world/models/README.md.
class KnownFaultsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void n01_vanishingInteraction_countsZero() {
    const Walker self{1, Vec2::Zero(), Vec2(0.5, 0.0), 0.4};
    const Walker faster{2, Vec2(1.0, 0.0), Vec2(1.0, 0.0), 0.4};
    QVERIFY(socialForce(ForceParameters{}, self, faster).isZero(0.0));
  }

  void n02_twoInOnePlace_part() {
    const Walker one{1, Vec2::Zero(), Vec2::Zero(), 0.4};
    const Walker two{2, Vec2::Zero(), Vec2::Zero(), 0.4};
    const Vec2 onOne = socialForce(ForceParameters{}, one, two);
    QVERIFY(onOne.allFinite() && onOne.norm() > 1.0);
    const Vec2 onTwo = socialForce(ForceParameters{}, two, one);
    QVERIFY(onOne.dot(onTwo) < 0.0);
  }

  void n03_exactlyHeadOn_passWithoutTouch_data() { addModels(); }

  void n03_exactlyHeadOn_passWithoutTouch() {
    QFETCH(QString, model);
    Scenario scenario;
    scenario.desktop.model = model.toStdString();
    addGoal(scenario, 1, 8.0, 0.0);
    addGoal(scenario, 2, -8.0, 0.0);
    addPerson(scenario, 1, Vec2(-4.0, 0.0), {1}).radius = 0.2;
    addPerson(scenario, 2, Vec2(4.0, 0.0), {2}, base::kPi).radius = 0.2;
    const auto world = make(scenario);
    double least = 1e9;
    double slowest = 1e9;
    advance(*world, 100, [&](const Frame& frame) {
      least = std::min(least, (positionOf(frame, 0) - positionOf(frame, 1)).norm());
      slowest = frame.step > 20 ? std::min(slowest, speedOf(frame, 0)) : slowest;
    });
    QVERIFY2(least >= 0.4, qPrintable(QString::number(least)));
    QVERIFY2(slowest >= 1.0, qPrintable(QString::number(slowest)));
  }

  void n04_gazeExactlyBehindOrNoGoal_isFinite() {
    const Walker self{1, Vec2::Zero(), Vec2(0.3, 0.1), 0.4};
    const Walker behind{2, Vec2(-3.0, 0.0), Vec2::Zero(), 0.4};
    const ForceParameters parameters;
    QCOMPARE(groupForce(parameters, self, Vec2(1.0, 0.0), {behind}).gaze, Vec2(-9.0, 0.0));
    QVERIFY(groupForce(parameters, self, Vec2::Zero(), {behind}).gaze.isZero(0.0));
  }

  void n05_bodiesWithoutForces_stopAtEachOther() {
    Scenario scenario = walk("sfm");
    addPerson(scenario, 2, Vec2(4.0, 0.1));
    for (Human& human : scenario.humans) {
      human.behavior.configuration = Configuration::Custom;
      human.behavior.goalForceFactor = 2.0;
      human.behavior.socialForceFactor = human.behavior.obstacleForceFactor = 0.0;
    }
    const auto world = make(scenario);
    double least = 1e9;
    const std::vector<Recorded> events = advance(*world, 200, [&](const Frame& frame) {
      least = std::min(least, (positionOf(frame, 0) - positionOf(frame, 1)).norm());
    });
    QVERIFY2(least >= 0.8, qPrintable(QString::number(least)));
    QCOMPARE(ofKind(events, EventKind::Contact).size(), std::size_t{1});
  }

  void n06_insideAnObstacle_isLedOut() {
    const Walker self{1, Vec2(0.3, 0.0), Vec2::Zero(), 0.2};
    Obstacles::Point edge;
    edge.position = Vec2(0.5, 0.0);
    edge.distance = 0.2;
    edge.inside = true;
    QVERIFY(obstacleForce(ForceParameters{}, self, {edge}).x() > 1.0);
    edge.inside = false;
    QVERIFY(obstacleForce(ForceParameters{}, self, {edge}).x() < -1.0);
  }

  void n07_wallOfManyPoints_pushesAsOfTwo() {
    std::vector<Vec2> fine;
    for (int i = 0; i <= 60; ++i) {
      fine.emplace_back(-3.0 + 0.1 * i, 0.0);
    }
    const Vec2 coarse = forceOfWall({Vec2(-3.0, 0.0), Vec2(3.0, 0.0)});
    QVERIFY(coarse.y() > 0.1);
    QVERIFY((coarse - forceOfWall(fine)).norm() < 1e-6);
  }

  void n08_longStepStrongGoal_doesNotOvershoot_data() { addModels(); }

  void n08_longStepStrongGoal_doesNotOvershoot() {
    QFETCH(QString, model);
    Scenario scenario = walk(model.toStdString());
    scenario.desktop.dt = 0.1;  // tau / k_g is 0.05 s
    Human& human = scenario.humans.front();
    human.behavior.configuration = Configuration::Custom;
    human.behavior.goalForceFactor = 10.0;
    human.behavior.socialForceFactor = 5.0;
    human.behavior.obstacleForceFactor = 10.0;
    const auto world = make(scenario);
    advance(*world, 1);
    const double first = world->frame().humans.vx[0];
    QVERIFY2(first > 0.7 && first < 1.3, qPrintable(QString::number(first)));
    double before = first;
    advance(*world, 20, [&](const Frame& frame) {
      QVERIFY(frame.humans.vx[0] >= before && frame.humans.vx[0] <= 1.5);
      before = frame.humans.vx[0];
    });
  }

  void n09_d10_stepOfZero_isRefused() {
    QVERIFY(isRefused(0.0) && isRefused(-0.05) && isRefused(std::nan("")));
    QVERIFY(!isRefused(0.001) && !isRefused(0.1));
  }

  void n10_slowPerson_keepsTheHeading() {
    QCOMPARE(turnedHeading(1.0, Vec2(-0.069, 0.0), 0.05), 1.0);
    QVERIFY(turnedHeading(1.0, Vec2(-0.071, 0.0), 0.05) > 1.0);
    QCOMPARE(turnedHeading(1.0, Vec2::Zero(), 0.05), 1.0);
  }

  void n11_hugeAngles_areWrapped() {
    const double wrapped = base::wrapToPi(1e300);
    QVERIFY(wrapped > -base::kPi - 1e-12 && wrapped <= base::kPi + 1e-12);
    QVERIFY(!std::isfinite(base::wrapToPi(std::numeric_limits<double>::infinity())));
  }

  void n12_numberThatIsNone_stopsTheRunAndNamesThePerson() {
    const auto world = make(walk("sfm"), [](const WorldView& view, Intents& intents) {
      intents.of(0).speed = view.step() > 3 ? std::nan("") : 1.0;
    });
    advance(*world, 20);
    QCOMPARE(world->frame().step, std::int64_t{3});
    QVERIFY(world->failure().find("person1") != std::string::npos);
    QVERIFY(std::isfinite(world->frame().humans.x[0]));
  }

  void n13_velocityAtAWall_isThatAfterTheContact() {
    Scenario scenario = walk("sfm");
    scenario.desktop.route = Route::Direct;
    addWall(scenario, {Vec2(3.0, -4.0), Vec2(3.0, 4.0)});
    Human& human = scenario.humans.front();
    human.behavior.configuration = Configuration::Custom;
    human.behavior.goalForceFactor = 2.0;
    human.behavior.socialForceFactor = human.behavior.obstacleForceFactor = 0.0;
    const auto world = make(scenario);
    advance(*world, 200);
    QVERIFY(world->frame().humans.x[0] <= 2.5);
    QVERIFY(speedOf(world->frame(), 0) < 1e-3);
  }

  void n14_n15_d01_orderInTheFile_changesNothing_data() { addModels(); }

  void n14_n15_d01_orderInTheFile_changesNothing() {
    QFETCH(QString, model);
    Scenario scenario = walk(model.toStdString());
    addGoal(scenario, 2, -10.0, 1.0);
    addPerson(scenario, 2, Vec2(6.0, 0.2), {2}, base::kPi);
    addPerson(scenario, 5, Vec2(3.0, -3.0), {2});
    Scenario reversed = scenario;
    std::reverse(reversed.humans.begin(), reversed.humans.end());
    const auto one = make(scenario);
    const auto two = make(reversed);
    advance(*one, 200);
    advance(*two, 200);
    QCOMPARE(one->frame().humans.id, two->frame().humans.id);
    QCOMPARE(one->frame().humans.x, two->frame().humans.x);
    QCOMPARE(one->frame().humans.y, two->frame().humans.y);
  }

  void n15_farFromTheOrigin_walksAlike() {
    const auto played = [](const Vec2& origin) {
      Scenario scenario;
      addGoal(scenario, 1, origin.x() + 10.0, origin.y());
      addGoal(scenario, 2, origin.x() - 10.0, origin.y() + 1.0);
      addPerson(scenario, 1, origin, {1});
      addPerson(scenario, 2, origin + Vec2(6.0, 0.25), {2}, base::kPi);
      const auto world = make(scenario);
      advance(*world, 80);
      return Vec2(positionOf(world->frame(), 0) - origin);
    };
    const Vec2 near = played(Vec2::Zero());
    QVERIFY((played(Vec2(65536.0, -32768.0)) - near).norm() < 1e-6);
  }

  void n16_goalBehindAWall_isReached() {
    Scenario scenario = walk("sfm", 6.0);
    addWall(scenario, {Vec2(3.0, -2.0), Vec2(3.0, 2.0)});
    scenario.desktop.route = Route::Planned;
    const auto world = make(scenario);
    QCOMPARE(ofKind(advance(*world, 300), EventKind::Arrived).size(), std::size_t{1});
  }

  void n17_braking_endsAtRest_data() { addModels(); }

  void n17_braking_endsAtRest() {
    QFETCH(QString, model);
    const auto world = make(walk(model.toStdString()), [](const WorldView& view, Intents& intents) {
      intents.of(0).motion = view.time() > 1.0 ? Motion::Brake : Motion::Walk;
    });
    advance(*world, 200);
    QVERIFY(world->frame().humans.x[0] > 1.0);
    QCOMPARE(speedOf(world->frame(), 0), 0.0);
  }

 private:
  static void addModels() {
    QTest::addColumn<QString>("model");
    QTest::newRow("sfm") << QStringLiteral("sfm");
    QTest::newRow("das") << QStringLiteral("das");
  }
};

QTEST_APPLESS_MAIN(KnownFaultsTest)
#include "tst_KnownFaults.moc"
