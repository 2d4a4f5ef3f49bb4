#include <QtTest>

#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

constexpr double kLow = 2.0;
constexpr double kHigh = 14.0;

/// Person 1 to the right, person 2 to the left, forever, along the corridor.
void walkRound(const WorldView& view, Intents& intents) {
  for (int human = 0; human < view.humanCount(); ++human) {
    Intent& intent = intents.of(human);
    const double sense = view.constants(human).id == 2 ? -1.0 : 1.0;
    intent.motion = Motion::Walk;
    intent.target = {0, view.pose(human).position + Vec2(sense * 1000.0, 0.0), 0.1};
    intent.speed = view.constants(human).desiredSpeed;
  }
}

Scenario corridor(bool isClosed, const std::string& model) {
  Scenario scenario;
  scenario.desktop.model = model;
  scenario.desktop.route = Route::Direct;
  if (isClosed) {
    scenario.desktop.wrapX = {kLow, kHigh};
  }
  return scenario;
}

double inside(double x) {
  return x - (kHigh - kLow) * std::floor((x - kLow) / (kHigh - kLow));
}

}  // namespace

class PeriodicCorridorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void step_pastTheEnd_comesInAtTheOther() {
    Scenario scenario = corridor(true, "sfm");
    addPerson(scenario, 1, Vec2(13.0, 0.0));
    addPerson(scenario, 2, Vec2(3.0, 20.0));
    const auto world = make(scenario, walkRound);
    int passed = 0;
    double before = 13.0;
    advance(*world, 200, [&](const Frame& frame) {
      for (const double x : frame.humans.x) {
        QVERIFY(x >= kLow && x < kHigh);
      }
      passed += frame.humans.x[0] < before ? 1 : 0;
      before = frame.humans.x[0];
    });
    QCOMPARE(passed, 2);  // 14.6 m of way from 1 m before the seam, one round has 12 m
    QVERIFY(world->frame().humans.vx[0] > 1.4);
    QVERIFY(world->frame().humans.vx[1] < -1.4);
  }

  void step_pairAcrossTheSeam_movesAsOnThePlane_data() {
    QTest::addColumn<QString>("model");
    QTest::newRow("sfm") << QStringLiteral("sfm");
    QTest::newRow("das") << QStringLiteral("das");
  }

  void step_pairAcrossTheSeam_movesAsOnThePlane() {
    QFETCH(QString, model);
    Scenario ring = corridor(true, model.toStdString());
    addPerson(ring, 1, Vec2(12.5, 0.0));
    addPerson(ring, 2, Vec2(4.5, 0.1));
    Scenario plane = corridor(false, model.toStdString());
    addPerson(plane, 1, Vec2(12.5, 0.0));
    addPerson(plane, 2, Vec2(16.5, 0.1));
    const auto onRing = make(ring, walkRound);
    const auto onPlane = make(plane, walkRound);
    for (int i = 0; i < 60; ++i) {
      QVERIFY(onRing->step() && onPlane->step());
      for (std::size_t row = 0; row < 2; ++row) {
        const Vec2 expected = positionOf(onPlane->frame(), row);
        const Vec2 found = positionOf(onRing->frame(), row);
        QVERIFY(std::fabs(found.x() - inside(expected.x())) < 1e-4);
        QVERIFY(std::fabs(found.y() - expected.y()) < 1e-4);
      }
    }
  }

  /// More people than are summed without the grid; the one at the end is slowed by the one behind
  /// it.
  void step_bigCrowd_feelsAcrossTheSeam() {
    Scenario scenario = corridor(true, "das");
    addPerson(scenario, 1, Vec2(13.8, 0.0));
    addPerson(scenario, 3, Vec2(2.5, 0.0)).maxVel = 0.2;
    for (int i = 0; i < 80; ++i) {
      addPerson(scenario, 10 + i, Vec2(3.0 + 0.1 * i, 40.0 + 2.0 * i));
    }
    const auto world = make(scenario, walkRound);
    advance(*world, 20);
    QVERIFY(world->frame().humans.vx[0] < 0.7);
    QVERIFY(world->frame().humans.vx[2] > 1.2);
  }

  void step_stoppedBehindTheSeam_bodiesDoNotOverlap() {
    Scenario scenario = corridor(true, "sfm");
    addPerson(scenario, 1, Vec2(12.0, 0.0));
    addPerson(scenario, 3, Vec2(2.2, 0.0));
    const auto world = make(scenario, [](const WorldView& view, Intents& intents) {
      walkRound(view, intents);
      intents.of(1).motion = Motion::Stand;
    });
    double least = 1e9;
    advance(*world, 100, [&](const Frame& frame) {
      const double x = frame.humans.x[1] - frame.humans.x[0];
      const double apart = std::min(std::fabs(x), kHigh - kLow - std::fabs(x));
      least = std::min(least, Vec2(apart, frame.humans.y[1] - frame.humans.y[0]).norm());
    });
    QVERIFY2(least > 0.8 - 0.01, qPrintable(QString::number(least)));
  }
};

QTEST_APPLESS_MAIN(PeriodicCorridorTest)
#include "tst_PeriodicCorridor.moc"
