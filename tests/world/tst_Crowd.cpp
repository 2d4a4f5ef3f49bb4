#include <QtTest>

#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

/// Two streams through a hall with a wall in the middle that has a gap.
Scenario hall(int people) {
  Scenario scenario;
  addGoal(scenario, 1, 60.0, 10.0);
  addGoal(scenario, 2, -40.0, 10.0);
  addWall(scenario, {{10.0, -5.0}, {10.0, 8.0}});
  addWall(scenario, {{10.0, 12.0}, {10.0, 25.0}});
  for (int i = 0; i < people; ++i) {
    const int row = i / 15;
    const Vec2 place(1.3 * (i % 15) + (i % 15 > 7 ? 1.0 : 0.0) - 0.7, 1.3 * row);
    addPerson(scenario, i, place, {i % 2 + 1}).radius = 0.3;
  }
  return scenario;
}

std::unique_ptr<World> makeWith(int people, int threads, bool exact, const char* model = "sfm") {
  Scenario scenario = hall(people);
  scenario.desktop.model = model;
  WorldSetup setup = setupOf(scenario);
  setup.threads = threads;
  setup.exact = exact;
  return make(std::move(setup));
}

}  // namespace

class CrowdTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void step_largeCrowd_isNearTheExactOne() {
    const auto fast = makeWith(150, 1, false);
    const auto exact = makeWith(150, 1, true);
    advance(*fast, 20);
    advance(*exact, 20);
    double farthest = 0.0;
    for (std::size_t i = 0; i < fast->frame().humans.size(); ++i) {
      farthest =
          std::max(farthest, (positionOf(fast->frame(), i) - positionOf(exact->frame(), i)).norm());
    }
    QVERIFY2(farthest > 0.0 && farthest < 0.02, qPrintable(QString::number(farthest)));
  }

  void step_smallCrowd_equalsTheExactOne() {
    const auto fast = makeWith(30, 1, false);
    const auto exact = makeWith(30, 1, true);
    advance(*fast, 1);
    advance(*exact, 1);
    for (std::size_t i = 0; i < fast->frame().humans.size(); ++i) {
      QVERIFY((positionOf(fast->frame(), i) - positionOf(exact->frame(), i)).norm() < 1e-6);
    }
  }

  /// Searching the grid for the nearest visible people finds those that a comparison of all finds.
  void step_nearestPeopleOfLargeCrowd_areThoseOfAllPairs() {
    const auto searched = makeWith(150, 1, false, "orca");
    const auto compared = makeWith(150, 1, true, "orca");
    advance(*searched, 60);
    advance(*compared, 60);
    QCOMPARE(searched->frame().humans.x, compared->frame().humans.x);
    QCOMPARE(searched->frame().humans.y, compared->frame().humans.y);
    QCOMPARE(searched->frame().humans.vx, compared->frame().humans.vx);
  }

  void step_everyThreadCount_givesTheSameFrames() {
    const auto one = makeWith(300, 1, false);
    advance(*one, 60);
    for (const int threads : {2, 8}) {
      const auto many = makeWith(300, threads, false);
      advance(*many, 60);
      QCOMPARE(many->frame().humans.x, one->frame().humans.x);
      QCOMPARE(many->frame().humans.y, one->frame().humans.y);
      QCOMPARE(many->frame().humans.vx, one->frame().humans.vx);
      QCOMPARE(many->frame().humans.heading, one->frame().humans.heading);
    }
  }

  void measure_steps_addUp() {
    const auto world = makeWith(100, 1, false);
    StepTimes times;
    advance(*world, 2);
    QCOMPARE(times.steps, std::int64_t{0});
    world->measure(&times);
    advance(*world, 3);
    world->measure(nullptr);
    advance(*world, 2);
    QCOMPARE(times.steps, std::int64_t{3});
    QVERIFY(times.sum() > 0.0);
    for (const double seconds : times.seconds) {
      QVERIFY(seconds >= 0.0 && seconds <= times.sum());
    }
  }
};

QTEST_APPLESS_MAIN(CrowdTest)
#include "tst_Crowd.moc"
