#include <QtTest>

#include "tests/AllocationCount.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

/// Two groups that walk to each other past a standing robot. The wall of the small ones is felt by
/// all from the start: who comes to the first wall of the run needs memory for it.
Scenario streams(int people) {
  Scenario scenario;
  addGoal(scenario, 1, 200.0, 5.0);
  addGoal(scenario, 2, -200.0, 5.0);
  if (people < 50) {
    addWall(scenario, {{-20.0, -3.0}, {60.0, -3.0}});
  }
  Robot& robot = addRobot(scenario, Vec2(20.0, 30.0), Vec2(20.0, 30.0));
  robot.startTime = 1000.0;
  for (int i = 0; i < people; ++i) {
    const bool isLeft = i % 20 < 10;
    const int row = i / 20;
    const Vec2 place(1.1 * (i % 20) + (isLeft ? -10.0 : 10.0), 1.1 * row - 2.0);
    Human& human = addPerson(scenario, i + 1, place, {isLeft ? 1 : 2});
    human.radius = 0.25;
    human.ours.route = Route::Direct;
  }
  return scenario;
}

}  // namespace

/// Once its buffers have grown, a step takes no memory from the heap.
class StepMemoryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void step_withoutEvents_allocatesNothing_data() {
    QTest::addColumn<int>("people");
    QTest::newRow("pair by pair") << 30;
    QTest::newRow("all at once") << 200;
  }

  void step_withoutEvents_allocatesNothing() {
    QFETCH(int, people);
    const auto world = make(streams(people));
    advance(*world, 100);
    long most = 0;
    int quietSteps = 0;
    for (int i = 0; i < 100; ++i) {
      const long before = allocations;
      QVERIFY(world->step());
      const long taken = allocations - before;
      if (world->frame().events.empty()) {  // the text of an event may need memory
        most = std::max(most, taken);
        ++quietSteps;
      }
    }
    QVERIFY(quietSteps > 20);
    QVERIFY2(most == 0, qPrintable(QString::number(most)));
  }
};

QTEST_APPLESS_MAIN(StepMemoryTest)
#include "tst_StepMemory.moc"
