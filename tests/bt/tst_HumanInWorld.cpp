#include <cmath>

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include "bt/engine/Program.h"
#include "bt/human/HumanContext.h"
#include "bt/human/Motions.h"
#include "bt/human/TreeBehavior.h"
#include "bt/human/TreeGenerator.h"
#include "bt/human/TreeLoader.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "tests/bt/FakeWorld.h"
#include "tests/support/Interop.h"
#include "tests/world/TestWorld.h"

using base::Vec2;

namespace {

/// The model block documents nodes and is ours; everything behind it is to be equal.
QByteArray behindTheModel(const QByteArray& text) {
  const int at = text.indexOf("</TreeNodesModel>");
  return at < 0 ? QByteArray() : text.mid(at);
}

}  // namespace

/// Real files of HuNavSim.
class HumanInWorldTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void goalsOfTheTree_areThoseOfTheScenario_data() {
    QTest::addColumn<QString>("scenario");
    QTest::newRow("own") << QStringLiteral("own/scenarios/agents_yard.yaml");
    QTest::newRow("isaac") << QStringLiteral("isaac/scenarios/warehouse_agents.yaml");
    for (const char* name : {"cafe", "house", "warehouse"}) {
      QTest::newRow(name)
          << QStringLiteral("gazebo_classic/scenarios/agents_%1.yaml").arg(QString::fromUtf8(name));
    }
    QTest::newRow("fortress") << QStringLiteral("gazebo_fortress/scenarios/cafe_agents.yaml");
  }
  void goalsOfTheTree_areThoseOfTheScenario() {
    QFETCH(QString, scenario);
    const QString path = interopFile(QStringLiteral("hunavsim2/") + scenario);
    if (path.isEmpty()) {
      QSKIP("the interoperability files are not here");
    }
    const sim2d::ScenarioReading reading = sim2d::readScenario(path.toStdString());
    QVERIFY(reading.ok());
    const bt::NodeLibrary library = bt::humanNodes();
    const QDir trees(QFileInfo(path).dir().filePath(QStringLiteral("../behavior_trees")));
    int compared = 0;
    for (const sim2d::Human& human : reading.scenario.humans) {
      const QString tree = trees.filePath(QString::fromStdString(
          bt::treeFileName(reading.scenario.yamlBaseName.value_or(""), human.id)));
      if (!human.listed || !QFile::exists(tree)) {
        continue;
      }
      const auto table = bt::loadAgentTrees(bt::readTree(tree.toStdString()));
      QVERIFY2(table, qPrintable(tree));
      QVERIFY2(bt::compile(*table, library), qPrintable(tree));
      QVERIFY2(bt::treeGoals(*table) == human.goals, qPrintable(tree));
      ++compared;
      base::Diagnostics problems;
      bt::TreeLoader(reading.scenario).load(human, tree.toStdString(), problems);
      for (const base::Diagnostic& found : problems) {
        QWARN(found.text().c_str());
        QVERIFY(found.severity != base::Severity::Error);
      }
    }
    QVERIFY(compared > 0);
  }
  void hunav2Tree_ofAnInteropScenario_isTheOneShipped_data() {
    goalsOfTheTree_areThoseOfTheScenario_data();
  }
  void hunav2Tree_ofAnInteropScenario_isTheOneShipped() {
    QFETCH(QString, scenario);
    const QString path = interopFile(QStringLiteral("hunavsim2/") + scenario);
    if (path.isEmpty()) {
      QSKIP("the interoperability files are not here");
    }
    const sim2d::ScenarioReading reading = sim2d::readScenario(path.toStdString());
    const bt::NodeLibrary library = bt::humanNodes();
    const QDir trees(QFileInfo(path).dir().filePath(QStringLiteral("../behavior_trees")));
    int compared = 0;
    for (const sim2d::Human& human : reading.scenario.humans) {
      QFile shipped(trees.filePath(QString::fromStdString(
          bt::treeFileName(reading.scenario.yamlBaseName.value_or(""), human.id))));
      if (!human.listed || !shipped.open(QIODevice::ReadOnly)) {
        continue;
      }
      const QByteArray ours = QByteArray::fromStdString(
          bt::makeTreeText(reading.scenario, human, bt::TreeStyle::Hunav2, library.catalogue()));
      QCOMPARE(behindTheModel(ours), behindTheModel(shipped.readAll()));
      ++compared;
    }
    QVERIFY(compared > 0);
  }

  // Nodes whose end depends on how bodies move, in a real world.

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

  void isRobotVisible_byDistanceAndBearing_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("distance");
    QTest::addColumn<bool>("expected");
    QTest::newRow("ahead") << 2.0 << 0.0 << 5.0 << true;
    QTest::newRow("exactly at the distance") << 2.0 << 0.0 << 2.0 << true;
    QTest::newRow("too far") << 2.0 << 0.0 << 1.99 << false;
    // half of the field of view is 99.74 degrees
    QTest::newRow("99 degrees") << std::cos(1.728) << std::sin(1.728) << 5.0 << true;
    QTest::newRow("-99 degrees") << std::cos(1.728) << -std::sin(1.728) << 5.0 << true;
    QTest::newRow("100 degrees") << std::cos(1.7453) << std::sin(1.7453) << 5.0 << false;
    QTest::newRow("behind") << -1.0 << 0.0 << 5.0 << false;
  }
  void isRobotVisible_byDistanceAndBearing() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, distance);
    QFETCH(bool, expected);
    FakeWorld world;
    world.addPerson(1, 0.0, 0.0, 0.0);
    world.addRobot(x, y);
    QCOMPARE(bt::isRobotVisible(world, 0, distance), expected);
  }

  void isRobotVisible_withoutRobot_isFalse() {
    FakeWorld world = withOnePerson();
    QVERIFY(!bt::isRobotVisible(world, 0, 100.0));
    QVERIFY(std::isinf(bt::robotDistance(world, 0)));
  }

  void sightAndSound_behindWall_areBlocked() {
    FakeWorld world = withOnePerson();
    world.addPerson(2, 2.0, 0.0, base::kPi);
    world.addRobot(1.0, 0.0);
    QVERIFY(bt::isRobotVisible(world, 0, 5.0));
    QVERIFY(bt::isAudible(world, 0, 1, 5.0));
    QVERIFY(bt::isAgentVisible(world, 1, 0, 5.0, 0.2));
    world.isDark = true;
    QVERIFY(!bt::isRobotVisible(world, 0, 5.0));
    QVERIFY(!bt::isAgentVisible(world, 0, 1, 5.0, base::kPi));
    QVERIFY(!bt::isAgentVisible(world, 1, 0, 5.0, 0.2));
    QVERIFY(!bt::isAudible(world, 0, 1, 5.0));
  }

  void isRobotFacing_atAnyDistance_byAngle() {
    FakeWorld world;
    world.addPerson(1, 50.0, 0.0);
    world.addRobot(0.0, 0.0, 0.29);
    QVERIFY(bt::isRobotFacing(world, 0));
    world.robots[0].pose.heading = 0.31;
    QVERIFY(!bt::isRobotFacing(world, 0));
  }

  void nearestPerson_ofEqualDistances_isSmallestId() {
    FakeWorld world = withOnePerson();
    world.addPerson(9, 1.0, 0.0);
    world.addPerson(4, -1.0, 0.0);
    world.addPerson(2, 0.5, 0.0);
    QCOMPARE(bt::nearestAgent(world, 0), 3);
    world.at(3).isPresent = false;
    QCOMPARE(bt::nearestAgent(world, 0), 2);
  }

  void speechBus_wordsOfOneStep_areHeardInTheNext() {
    bt::SpeechBus bus;
    bus.say(1, 0, "one");
    QVERIFY(bus.audibleUtterances().empty());
    bus.beginStep();
    bus.say(2, 1, "two");
    QCOMPARE(bus.audibleUtterances().size(), std::size_t(1));
    bus.beginStep();
    QCOMPARE(bus.audibleUtterances().size(), std::size_t(2));
    QVERIFY(bus.audibleUtterances().front().text == "two");
    bus.forget(1);
    QVERIFY(bus.audibleUtterances().front().text == "one");
  }

  void parseIds_ofLists_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QList<int>>("ids");
    QTest::addColumn<bool>("isList");
    QTest::newRow("one") << QStringLiteral("2") << QList<int>{2} << true;
    QTest::newRow("blanks") << QStringLiteral(" 2 , 3,,5x") << QList<int>{2, 3, 5} << true;
    QTest::newRow("empty") << QString() << QList<int>{} << true;
    QTest::newRow("word") << QStringLiteral("2,all") << QList<int>{} << false;
  }
  void parseIds_ofLists() {
    QFETCH(QString, text);
    QFETCH(QList<int>, ids);
    QFETCH(bool, isList);
    const std::optional<std::vector<int>> found = bt::parseIds(text.toStdString());
    QCOMPARE(found.has_value(), isList);
    if (found) {
      QCOMPARE(QList<int>(found->begin(), found->end()), ids);
    }
  }

  void circleSpots_ofTwo_areOppositeAndClosestFirst() {
    FakeWorld world;
    world.addPerson(1, -2.0, 0.0, 0.0);
    world.addPerson(2, 3.0, 0.0, base::kPi);
    const std::vector<bt::FormationSpot> spots =
        bt::assignCirclePositions(world, {0, 1}, base::Vec2(0.0, 0.0));
    QCOMPARE(spots.size(), std::size_t(2));
    // radius 0.5 + 0.2: person 1 on the left, person 2 on the right
    QVERIFY((spots[0].position - base::Vec2(-0.7, 0.0)).norm() < 1e-12);
    QVERIFY((spots[1].position - base::Vec2(0.7, 0.0)).norm() < 1e-12);
  }

  void circleSpots_ofFour_haveRadius1point1() {
    FakeWorld world;
    for (int i = 0; i < 4; ++i) {
      world.addPerson(i, i, 5.0, 0.3);
    }
    for (const bt::FormationSpot& spot :
         bt::assignCirclePositions(world, {0, 1, 2, 3}, base::Vec2(1.0, 1.0))) {
      QVERIFY(std::fabs((spot.position - base::Vec2(1.0, 1.0)).norm() - 1.1) < 1e-12);
    }
  }

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
};

QTEST_GUILESS_MAIN(HumanInWorldTest)
#include "tst_HumanInWorld.moc"
