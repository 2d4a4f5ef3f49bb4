#include <QTemporaryDir>
#include <QtTest>

#include "bt/human/TreeBehavior.h"
#include "sim2d/base/Text.h"
#include "tests/world/TestWorld.h"

using base::Vec2;

/// Nodes whose end depends on how bodies move, in a real world.
class HumanInWorldTest : public QObject {
  Q_OBJECT

 private:
  static constexpr double kLongest = 60.0;  // [s]

  /// Person 1 runs `body`, then says "done"; the others have no tree of their own.
  std::unique_ptr<sim2d::World> make(const sim2d::Scenario& scenario, const std::string& body) {
    const std::string path = folder_.path().toStdString() + "/person1.xml";
    const std::string text =
        "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\"><Sequence><RunOnce>" + body +
        "</RunOnce><RunOnce><SaySomething agent_id='{id}' message='done'/></RunOnce></Sequence>"
        "</BehaviorTree></root>";
    if (!base::writeFileAtomically(path, text).empty()) {
      return nullptr;
    }
    base::Diagnostics found;
    sim2d::WorldSetup setup;
    setup.scenario = std::make_shared<const sim2d::Scenario>(scenario);
    setup.behavior = bt::makeTreeBehavior(scenario, {{"person1", path}}, found);
    if (!setup.behavior) {
      return nullptr;
    }
    base::Result<std::unique_ptr<sim2d::World>> world = sim2d::World::create(std::move(setup));
    return world ? *std::move(world) : nullptr;
  }
  /// Time at which person 1 says "done"; -1 = never.
  static double timeOfDone(sim2d::World& world) {
    while (world.frame().time < kLongest && world.step()) {
      for (const sim2d::Event& event : world.frame().events) {
        if (event.kind == sim2d::EventKind::Say && event.text == "done") {
          return world.frame().time;
        }
      }
    }
    return -1.0;
  }
  static sim2d::Area exitAt(const char* name, const Vec2& middle) {
    sim2d::Area area;
    area.name = name;
    area.kind = sim2d::AreaKind::Exit;
    for (const auto& [x, y] :
         {std::pair(-0.5, -0.5), std::pair(0.5, -0.5), std::pair(0.5, 0.5), std::pair(-0.5, 0.5)}) {
      area.points.emplace_back(middle + Vec2(x, y));
    }
    return area;
  }

  QTemporaryDir folder_;

 private Q_SLOTS:
  void fleeFrom_anySpeed_ends_data() {
    QTest::addColumn<double>("speed");
    for (const double speed : {0.2, 0.5, 1.0, 1.5}) {
      QTest::newRow(qPrintable(QString::number(speed))) << speed;
    }
  }
  void fleeFrom_anySpeed_ends() {
    QFETCH(double, speed);
    sim2d::Scenario scenario;
    testworld::addPerson(scenario, 1, Vec2(0.0, 0.0));
    testworld::addPerson(scenario, 2, Vec2(1.5, 0.0));
    const auto world = make(scenario,
                            "<FleeFrom agent_id='{id}' target_agent_id='2' "
                            "safe_distance='3' speed='" +
                                base::formatDouble(speed) + "'/>");
    QVERIFY(world);
    QVERIFY(timeOfDone(*world) > 0.0);
    const double distance =
        (testworld::positionOf(world->frame(), 0) - testworld::positionOf(world->frame(), 1))
            .norm();
    QVERIFY2(distance >= 3.0 - 1e-9 && distance < 3.7, qPrintable(QString::number(distance)));
  }

  void waitForAgent_withStartTime_waitsForThem() {
    sim2d::Scenario scenario;
    testworld::addPerson(scenario, 1, Vec2(0.0, 0.0));
    testworld::addPerson(scenario, 2, Vec2(1.5, 0.0)).ours.startTime = 2.0;
    const auto world = make(scenario, "<WaitForAgent agent_id='{id}' target_agent_id='2'/>");
    QVERIFY(world);
    const double time = timeOfDone(*world);
    QVERIFY2(time >= 2.0 && time < 2.3, qPrintable(QString::number(time)));
  }

  void goToNearestExit_behindAWall_takesTheOneWithTheShorterWay() {
    sim2d::Scenario scenario;
    testworld::addPerson(scenario, 1, Vec2(0.0, 0.0));
    testworld::addWall(scenario, {Vec2(1.0, -8.0), Vec2(1.0, 8.0)});
    scenario.areas = {exitAt("behind", Vec2(2.5, 0.0)), exitAt("free", Vec2(-5.0, 0.0))};
    const auto world = make(scenario, "<GoToNearestExit agent_id='{id}'/>");
    QVERIFY(world);
    QVERIFY(timeOfDone(*world) > 0.0);
    const Vec2 end = testworld::positionOf(world->frame(), 0);
    QVERIFY2((end - Vec2(-5.0, 0.0)).norm() <= 0.35, qPrintable(QString::number(end.x())));
  }
};

QTEST_GUILESS_MAIN(HumanInWorldTest)
#include "tst_HumanInWorld.moc"
