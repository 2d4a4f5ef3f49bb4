#include "ScenarioTest.h"
#include "tests/support/Columns.h"
#include "tests/support/CommaLocale.h"

using namespace sim2d;
using namespace scenariotest;

namespace {

const Human& humanOf(const Scenario& scenario, const char* name) {
  const Human* human = scenario.human(name);
  if (human == nullptr) {
    throw std::runtime_error(std::string("no person ") + name);
  }
  return *human;
}

Vec2 goalOf(const Scenario& scenario, const Human& human, std::size_t index) {
  return scenario.goal(human.goals.at(index))->position;
}

/// The canonical fixture with one text put in the place of another.
ScenarioReading readChanged(const char* from, const char* to) {
  QString text = QString::fromStdString(textOf(dataFile("canonical.yaml")));
  text.replace(QString::fromUtf8(from), QString::fromUtf8(to));
  return readScenarioText(text.toStdString(), "canonical.yaml");
}

}  // namespace

class ScenarioReaderTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void read_dialectC_everyKey() {
    const ScenarioReading reading = readScenario(dataFile("canonical.yaml"));
    QVERIFY2(reading.diagnostics.empty(), qPrintable(shown(reading.diagnostics)));
    QCOMPARE(reading.dialect, Dialect::C);
    const Scenario& scenario = reading.scenario;
    QVERIFY(scenario.yamlBaseName == std::string("canonical"));
    QVERIFY(scenario.simulator == std::string("Gazebo Classic"));
    QVERIFY(scenario.map == std::string("yard"));
    QVERIFY(scenario.publishPeople == true);
    QCOMPARE(scenario.goals.size(), std::size_t(3));
    QCOMPARE(scenario.goals[2].id, 3);
    QVERIFY(scenario.goals[2].position == Vec2(9.125, -5.0));
    QCOMPARE(scenario.humans.size(), std::size_t(6));
    const Human& dora = humanOf(scenario, "dora");
    QCOMPARE(dora.id, 4);
    QVERIFY(dora.listed && dora.groupId == -1 && dora.skin == 1 && dora.cyclicGoals == true);
    QVERIFY(dora.maxVel == 1.5 && dora.radius == 0.4 && dora.goalRadius == 0.3);
    QVERIFY(dora.initPose == (Pose2{{7.0, 2.0}, 0.785}) && dora.initZ == 1.25);
    QVERIFY(dora.behavior.type == BehaviorType::Scared);
    QVERIFY(dora.behavior.configuration == Configuration::Custom);
    QVERIFY(dora.behavior.dist == 4.0 && dora.behavior.duration == 40.0);
    QVERIFY(dora.behavior.once == false && dora.behavior.vel == 0.6);
    QVERIFY(dora.behavior.safeDistance == 5.0 && !dora.behavior.stopDist);
    QVERIFY(dora.goals == (std::vector<int>{1, 3}));
  }

  void read_block_everyKey() {
    const ScenarioReading reading = readScenario(dataFile("block.yaml"));
    QVERIFY2(reading.ok(), qPrintable(shown(reading.diagnostics)));
    const DesktopSettings& desktop = reading.scenario.desktop;
    QVERIFY(desktop.mapFile == std::string("../maps/yard.yaml"));
    QVERIFY(desktop.mapRule == std::string("main"));
    QVERIFY(desktop.seed == 7 && desktop.duration == 60.0 && desktop.dt == 0.02);
    QVERIFY(desktop.stopOnCollision == StopOnCollision::People && desktop.stuckAfter == 12.5);
    QVERIFY(desktop.recordEvery == 5 && desktop.model == std::string("das"));
    QVERIFY(desktop.route == Route::Direct && desktop.loopTrees == false);
    QVERIFY(desktop.obstaclePoints == ObstaclePoints::Rays);
    QVERIFY(desktop.wrapX == (std::vector<double>{-5.0, 25.5}));
    QCOMPARE(desktop.groups.size(), std::size_t(2));
    QVERIFY(desktop.groups[1] == std::make_pair(4, std::string("on")));
    QVERIFY(desktop.metrics.until == std::string("time 30.0") && desktop.metrics.runId == 3);
    QVERIFY(desktop.unknown == (UnknownKeys{{"later_key", "kept"}}));
    const PersonExtension& anna = humanOf(reading.scenario, "anna").ours;
    QVERIFY(anna.startTime == 2.5 && anna.kind == PersonKind::Child && anna.mass == 30.5);
    QVERIFY(anna.model == std::string("orca") && anna.route == Route::Planned);
    QVERIFY(anna.atEnd == AtEnd::Leave && anna.tree == std::string("trees/anna.xml"));
    QVERIFY(anna.wait == (std::vector<double>{1.0, 0.0, 2.25}));
  }

  void read_block_everyEntity() {
    const Scenario scenario = readScenario(dataFile("block.yaml")).scenario;
    QCOMPARE(scenario.robots.size(), std::size_t(2));
    const Robot& robot = scenario.robots[0];
    QVERIFY(robot.type == std::string("delivery") && robot.goal.point == Vec2(8.0, 3.5));
    QVERIFY(robot.command == std::string("python3 \"my planner.py\" --fast"));
    QCOMPARE(robot.plannerParameters.size(), std::size_t(3));
    QVERIFY(robot.plannerParameters[0] ==
            std::make_pair(std::string("lookahead"), std::string("0.8")));
    QVERIFY(robot.start == (Pose2{{1.0, 2.0}, 1.5708}) && robot.maxAlpha == 2.0);
    QVERIFY(scenario.robots[1].goal.goals == (std::vector<int>{1, 3}));
    QCOMPARE(scenario.robots[1].footprintY.size(), std::size_t(4));
    QCOMPARE(scenario.obstacles.size(), std::size_t(4));
    QVERIFY(scenario.obstacles[0].pose == (Pose2{{6.0, 6.0}, 0.5}));
    QVERIFY(scenario.obstacles[2].points.size() == 3 && scenario.obstacles[3].thickness == 0.2);
    QVERIFY(scenario.doors.at(0).open == false && scenario.doors[0].to == Vec2(11.0, 0.0));
    QCOMPARE(scenario.areas.size(), std::size_t(3));
    QVERIFY(scenario.areas[0].like == std::string("anna") && scenario.areas[0].count == 12);
    QVERIFY(scenario.areas[1].listed && !scenario.areas[2].listed);
    QVERIFY(scenario.areas[2].kind == AreaKind::Exit);
  }

  void read_dialectA_becomesC() {
    const ScenarioReading reading = readScenario(dataFile("dialect_a.yaml"));
    QVERIFY2(reading.ok(), qPrintable(shown(reading.diagnostics)));
    QCOMPARE(reading.dialect, Dialect::A);
    QCOMPARE(reading.commentCount, 2);
    const Scenario& scenario = reading.scenario;
    QVERIFY(scenario.yamlBaseName == std::string("dialect_a") && !scenario.simulator);
    QVERIFY(suggestedSimulator(scenario) == std::string("Gazebo Classic"));
    QCOMPARE(scenario.goals.size(), std::size_t(6));  // equal places stay apart
    QCOMPARE(scenario.goals.back().id, 6);
    const Human& tom = humanOf(scenario, "tom");
    QVERIFY(tom.behavior.type == BehaviorType::Scared && tom.behavior.once == false);
    QVERIFY(tom.behavior.dist == 3.0 && tom.behavior.duration == 40.0 && tom.behavior.vel == 0.6);
    QVERIFY(tom.behavior.configuration == Configuration::Default);
    QVERIFY(tom.behavior.goalForceFactor == 2.0 && tom.behavior.obstacleForceFactor == 10.0);
    QVERIFY(tom.behavior.socialForceFactor == 5.0 && tom.behavior.otherForceFactor == 20.0);
    QVERIFY(goalOf(scenario, tom, 1) == Vec2(2.0, -3.484565));
    const Human& ida = humanOf(scenario, "ida");
    QVERIFY(ida.behavior.type == BehaviorType::Threatening && ida.behavior.dist == 4.0);
    QVERIFY(ida.behavior.vel == 2.0 && ida.behavior.frontDist == 1.1);
    QVERIFY(ida.goals == (std::vector<int>{3, 4}) && goalOf(scenario, ida, 1) == Vec2(4.5, 5.5));
    QVERIFY(scenario.goal(3)->unknown == (UnknownKeys{{"h", "0.5"}}));
    QVERIFY(scenario.goal(1)->unknown.empty());
    const Human& max = humanOf(scenario, "max");
    QVERIFY(max.behavior.type == BehaviorType::Curious && max.behavior.dist == 10.0);
    QVERIFY(max.behavior.duration == 30.0 && max.behavior.stopDist == 1.5);
    const Human& eva = humanOf(scenario, "eva");
    QVERIFY(eva.behavior.type == BehaviorType::Surprised && eva.behavior.dist == 4.0);
    QVERIFY(eva.behavior.duration == 30.0 && eva.behavior.once == true && !eva.behavior.vel);
  }

  void read_dialectB_becomesC() {
    const ScenarioReading reading = readScenario(dataFile("dialect_b.yaml"));
    QVERIFY2(reading.ok(), qPrintable(shown(reading.diagnostics)));
    QCOMPARE(reading.dialect, Dialect::B);
    const Scenario& scenario = reading.scenario;
    QCOMPARE(scenario.humans.size(), std::size_t(7));
    QVERIFY(!humanOf(scenario, "p2").listed && scenario.humans.back().name == "p2");
    QVERIFY(scenario.map == std::string("yard.yaml"));
    const Behavior surprised = humanOf(scenario, "p3").behavior;
    QVERIFY(surprised.dist == 3.5 && surprised.duration == 25.0 && surprised.once == false);
    QVERIFY(surprised.goalForceFactor == 3.0 && surprised.otherForceFactor == 18.0);
    const Behavior scared = humanOf(scenario, "p4").behavior;  // configuration 0
    QVERIFY(scared.dist == 3.0 && scared.duration == 40.0 && scared.vel == 0.6);
    QVERIFY(scared.once == true && scared.otherForceFactor == 20.0 && scared.safeDistance == 5.0);
    QVERIFY(scared.goalForceFactor == 2.0 && scared.obstacleForceFactor == 10.0);
    const Behavior curious = humanOf(scenario, "p5").behavior;
    QVERIFY(curious.dist == 10.0 && curious.stopDist == 2.25 && curious.vel == 0.9);
    const Behavior threatening = humanOf(scenario, "p6").behavior;
    QVERIFY(threatening.dist == 4.5 && threatening.frontDist == 1.75);
    const Behavior defaults = humanOf(scenario, "p7").behavior;  // Curious, configuration 0
    QVERIFY(defaults.dist == 10.0 && defaults.stopDist == 1.5 && defaults.vel == 1.4);
    QVERIFY(goalOf(scenario, humanOf(scenario, "p6"), 1) == Vec2(4.0, 6.0));
  }

  void convert_BtoCtoBtoC_keepsAll() {
    Scenario first = readScenario(dataFile("dialect_b.yaml")).scenario;
    base::Diagnostics losses;
    const std::string text = writeScenarioB(first, losses);
    QVERIFY2(losses.empty(), qPrintable(shown(losses)));
    for (Human& human : first.humans) {  // the numbers of 0 are written, so that they count: 1
      if (human.behavior.configuration == Configuration::Default) {
        human.behavior.configuration = Configuration::Custom;
      }
    }
    ScenarioReading again = readScenarioText(text, "dialect_b.yaml");
    QVERIFY2(again.ok(), qPrintable(shown(again.diagnostics)));
    QCOMPARE(again.dialect, Dialect::B);
    QVERIFY(again.scenario == first);
  }

  void convert_CtoB_tellsWhatIsLost() {
    const Scenario scenario = readScenario(dataFile("canonical.yaml")).scenario;
    base::Diagnostics losses;
    const std::string text = writeScenarioB(scenario, losses);
    QCOMPARE(losses.size(), std::size_t(1));  // Threatening: noticed at 4.0, not 4.5
    QVERIFY(losses[0].message.find("fred: dist 4 is lost") == 0);
    const ScenarioReading again = readScenarioText(text, "old.yaml");
    QVERIFY(again.ok());
    for (const Human& human : scenario.humans) {
      const Human& other = humanOf(again.scenario, human.name.c_str());
      QVERIFY(other.initPose == human.initPose && other.behavior.type == human.behavior.type);
      QCOMPARE(other.goals.size(), human.goals.size());
      for (std::size_t i = 0; i < human.goals.size(); ++i) {
        QVERIFY(goalOf(again.scenario, other, i) == goalOf(scenario, human, i));
      }
    }
    QVERIFY(humanOf(again.scenario, "emil").behavior.stopDist == 1.5);
  }

  /// HuNavSim reads no global goals in that format; who knows them finds them, numbered by hand:
  /// goals 1 and 4 are nobody's, then follow 3, 2 and 3 of anna, each a goal of its own.
  void convert_CtoB_keepsGoalsOfNobody() {
    const char* const text =
        "hunav_loader:\n  ros__parameters:\n    global_goals:\n"
        "      1: {x: 1.0, y: 1.5}\n      2: {x: 2.0, y: 2.5}\n"
        "      3: {x: 3.0, y: 3.5}\n      4: {x: 4.0, y: 4.5, h: 0.5}\n"
        "    agents: [anna]\n    anna:\n      id: 1\n      init_pose: {x: 0.0, y: 0.0}\n"
        "      behavior: {type: Regular}\n      goals: [3, 2, 3]\n";
    base::Diagnostics losses;
    Scenario scenario = readScenarioText(text, "new.yaml").scenario;
    scenario.goals.at(3).id = 2;  // as an export numbers them
    scenario.goals.at(1).id = 4;
    scenario.humans.at(0).goals = {3, 4, 3};
    const ScenarioReading again = readScenarioText(writeScenarioB(scenario, losses), "old.yaml");
    QVERIFY2(again.ok(), qPrintable(shown(again.diagnostics)));
    const std::vector<GlobalGoal>& goals = again.scenario.goals;
    QCOMPARE(goals.size(), std::size_t(5));
    QVERIFY(goals[0].id == 1 && goals[0].position == Vec2(1.0, 1.5));
    QVERIFY(goals[1].id == 2 && goals[1].position == Vec2(4.0, 4.5));
    QCOMPARE(goals[1].unknown.at(0).key, std::string("h"));
    QCOMPARE(again.scenario.humans.at(0).goals, (std::vector<int>{3, 4, 5}));
    QVERIFY(goalOf(again.scenario, again.scenario.humans[0], 1) == Vec2(2.0, 2.5));
  }

  /// The key must be there; above 1.8 m/s the loader clamps it, and says so.
  void convert_CtoB_speedOfAReactionIsWithinTheLimit() {
    Scenario scenario = readScenario(dataFile("canonical.yaml")).scenario;
    scenario.humans.at(0).behavior.vel.reset();
    for (const auto& [walks, reacts] : {std::pair(2.5, 1.8), std::pair(1.25, 1.25)}) {
      scenario.humans.at(0).maxVel = walks;
      base::Diagnostics losses;
      const ScenarioReading again = readScenarioText(writeScenarioB(scenario, losses), "old.yaml");
      QVERIFY(again.scenario.humans.at(0).maxVel == walks);
      QVERIFY(again.scenario.humans.at(0).behavior.vel == reacts);
    }
  }

  /// A goal that a file of that format has beside the person's list stays, under its own name.
  void convert_BtoB_doesNotMixUpSpareGoals() {
    const char* const text =
        "hunav_loader:\n  ros__parameters:\n    agents: [anna]\n    anna:\n      id: 1\n"
        "      init_pose: {x: 0.0, y: 0.0, h: 0.0}\n      behavior: {type: 1, dist: 0.0}\n"
        "      goals: [g0, g2]\n      g0: {x: 1.0, y: 1.5, h: 0.0}\n"
        "      g1: {x: 9.0, y: 9.5, h: 0.0}\n      g2: {x: 3.0, y: 3.5, h: 0.0}\n";
    base::Diagnostics losses;
    const ScenarioReading first = readScenarioText(text, "old.yaml");
    const ScenarioReading again =
        readScenarioText(writeScenarioB(first.scenario, losses), "old.yaml");
    QVERIFY2(again.ok(), qPrintable(shown(again.diagnostics)));
    QVERIFY(goalOf(again.scenario, again.scenario.humans.at(0), 0) == Vec2(1.0, 1.5));
    QVERIFY(goalOf(again.scenario, again.scenario.humans.at(0), 1) == Vec2(3.0, 3.5));
    QCOMPARE(again.scenario.humans.at(0).unknown.at(0).key, std::string("g1"));
  }

  void read_wordInAnyCase_isKnown_data() {
    QTest::addColumn<QByteArray>("word");
    for (const char* word : {"scared", "SCARED", "Scared", "'Scared'"}) {
      QTest::newRow(word) << QByteArray(word);
    }
  }
  void read_wordInAnyCase_isKnown() {
    QFETCH(QByteArray, word);
    const ScenarioReading reading = readChanged("type: Surprised", ("type: " + word).constData());
    QVERIFY(humanOf(reading.scenario, "cleo").behavior.type == BehaviorType::Scared);
    QVERIFY(reading.diagnostics.empty() && reading.dialect == Dialect::C);
  }

  void read_lenientScalars_data() {
    addColumns<QByteArray, bool>({"written", "value"});
    QTest::newRow("quoted") << QByteArray("\"True\"") << true;
    QTest::newRow("number") << QByteArray("1") << true;
    QTest::newRow("zero") << QByteArray("0") << false;
    QTest::newRow("word") << QByteArray("off") << false;
    QTest::newRow("python") << QByteArray("False") << false;
  }
  void read_lenientScalars() {
    QFETCH(QByteArray, written);
    QFETCH(bool, value);
    const ScenarioReading reading = readChanged("once: true", ("once: " + written).constData());
    QVERIFY(reading.ok());
    QVERIFY(humanOf(reading.scenario, "cleo").behavior.once == value);
  }

  void read_unknownKeys_keptAtEveryLevel() {
    const char* text =
        "hunav_loader:\n  ros__parameters:\n    agents: [a]\n    extra: {list: [1, 'no'], n: ~}\n"
        "    global_goals: {1: {x: 1.0, y: 2.0, note: door}}\n"
        "    a:\n      id: 1\n      hat: \"red: one\"\n"
        "      init_pose: {x: 0.0, y: 0.0, h: 0.0, roll: 0.10}\n"
        "      behavior: {type: Regular, mood: 007}\n      goals: [1]\n"
        "other_node:\n  ros__parameters: {rate: 1.50}\n";
    const ScenarioReading reading = readScenarioText(text, "extra.yaml");
    QVERIFY2(reading.ok(), qPrintable(shown(reading.diagnostics)));
    const std::string written = writeScenario(reading.scenario);
    for (const char* line :
         {"    extra:\n      list:\n        - 1\n        - \"no\"\n      n: null\n",
          "        note: door\n", "      hat: \"red: one\"\n", "        roll: 0.10\n",
          "        mood: 007\n", "other_node:\n  ros__parameters:\n    rate: 1.50"}) {
      QVERIFY2(written.find(line) != std::string::npos, line);
    }
    const ScenarioReading again = readScenarioText(written, "extra.yaml");
    QVERIFY(again.scenario == reading.scenario);
    QVERIFY(writeScenario(again.scenario) == written);
  }

  void read_crlfAndBom_sameScenario() {
    QByteArray text = QByteArray::fromStdString(textOf(dataFile("block.yaml")));
    text.replace("\n", "\r\n");
    const ScenarioReading plain = readScenario(dataFile("block.yaml"));
    const ScenarioReading reading =
        readScenarioText("\xEF\xBB\xBF" + text.toStdString(), "block.yaml");
    QVERIFY(reading.ok() && reading.scenario == plain.scenario);
  }

  void read_commaLocale_sameScenario() {
    const Scenario expected = readScenario(dataFile("block.yaml")).scenario;
    Scenario scenario;
    std::string text;
    {
      const CommaLocale locale;
      if (!locale.active()) {
        QSKIP("no locale that writes 1,5");
      }
      scenario = readScenario(dataFile("block.yaml")).scenario;
      text = writeScenario(scenario);
    }
    QVERIFY(scenario == expected);
    QCOMPARE(QString::fromStdString(text), QString::fromStdString(textOf(dataFile("block.yaml"))));
  }

  void read_entities_haveKeysAndLines() {
    const ScenarioReading reading = readScenario(dataFile("block.yaml"));
    const Human& anna = humanOf(reading.scenario, "anna");
    QVERIFY(anna.key.kind == base::EntityKind::Human && anna.key.key > 0);
    QCOMPARE(reading.lines.at(anna.key), 24);
    QVERIFY(reading.scenario.nextKey() > reading.scenario.areas.back().key.key);
    base::Diagnostics about = {base::warning("run.failed", {"something"})};
    about[0].entity = anna.key;
    addLocations(about, reading.lines, dataFile("block.yaml"));
    QCOMPARE(about[0].line, 24);
  }

  void read_comments_counted_data() {
    addColumns<QByteArray, int>({"text", "count"});
    QTest::newRow("none") << QByteArray("a: 1\n") << 0;
    QTest::newRow("lines") << QByteArray("# one\na: 1 # two\n  # three") << 3;
    QTest::newRow("quotes") << QByteArray("a: \"x # y\" # one\nb: 'it''s # no'\n") << 1;
    QTest::newRow("inside a word") << QByteArray("a: x#y\n") << 0;
    QTest::newRow("apostrophe") << QByteArray("a: it's # one\n") << 1;
    QTest::newRow("block") << QByteArray("a: |\n  # text\nb: 1 # one\n") << 1;
  }
  void read_comments_counted() {
    QFETCH(QByteArray, text);
    QFETCH(int, count);
    QCOMPARE(readScenarioText(text.toStdString(), "c.yaml").commentCount, count);
  }

  void read_interopFiles_asExpected_data() {
    addColumns<QByteArray, int>({"file", "dialect"});
    QTest::addColumn<QByteArray>("listed");  // name id goals
    QTest::addColumn<int>("goals");
    const auto row = [](const char* file, Dialect dialect, const char* listed, int goals) {
      QTest::newRow(file) << QByteArray(file) << static_cast<int>(dialect) << QByteArray(listed)
                          << goals;
    };
    const char* first = "agent1 1 3,agent2 2 3,agent7 3 3,agent4 4 3,agent5 5 3";
    row("own/scenarios/agents_yard.yaml", Dialect::C, "agent1 1 2,agent2 2 2", 3);
    row("isaac/scenarios/warehouse_agents.yaml", Dialect::C,
        "agent1 1 5,agent2 2 5,agent3 3 5,agent4 4 6,agent5 5 8", 11);
    row("isaac_docker_branch/config/agents_warehouse.yaml", Dialect::B,
        "agent1 1 3,agent2 2 3,agent3 3 3,agent4 4 3,agent5 5 3", 15);
    row("gazebo_classic/scenarios/agents_cafe.yaml", Dialect::C, "agent1 1 2,agent2 2 2,agent3 3 3",
        7);
    row("gazebo_classic/scenarios/agents_house.yaml", Dialect::C,
        "agent1 1 4,agent2 2 3,agent3 3 5", 8);
    row("gazebo_classic/scenarios/agents_warehouse.yaml", Dialect::C,
        "agent1 1 2,agent2 2 4,agent3 3 2", 8);
    row("gazebo_fortress/scenarios/cafe_agents.yaml", Dialect::C, "agent2 2 2", 8);
    row("gazebo_fortress/scenarios/agents2_cafe.yaml", Dialect::B, "Jan 1 4,Mario 2 2", 6);
    row("gazebo_fortress/scenarios/agents_test.yaml", Dialect::B,
        "agent2 2 3,agent4 4 3,agent6 6 3", 15);
    row("hunav_sim_v1/config/agents.yaml", Dialect::A, first, 15);
    row("hunav_sim_2024/config/agents.yaml", Dialect::B, first, 15);
    row("hunav_sim_2024/config/agents_house.yaml", Dialect::B, "Francis 1 4,John 2 6,Jesus 3 6",
        16);
    row("hunav_sim_2024/config/agents_warehouse.yaml", Dialect::B,
        "worker1 1 2,worker2 2 4,worker3 3 4,worker4 4 4", 14);
    row("third_party_fork/config/custom_agents.yaml", Dialect::A, "agent0 0 4,agent1 1 3", 7);
    row("third_party_fork/config/default_agents.yaml", Dialect::A, first, 15);
  }
  void read_interopFiles_asExpected() {
    QFETCH(QByteArray, file);
    QFETCH(int, dialect);
    QFETCH(QByteArray, listed);
    QFETCH(int, goals);
    const std::string path = hunavFile(file);
    if (path.empty()) {
      QSKIP("the real files of HuNavSim are not here");
    }
    const ScenarioReading reading = readScenario(path);
    QVERIFY2(reading.ok(), qPrintable(shown(reading.diagnostics)));
    QCOMPARE(static_cast<int>(reading.dialect), dialect);
    QCOMPARE(static_cast<int>(reading.scenario.goals.size()), goals);
    std::string found;
    for (const Human& human : reading.scenario.humans) {
      if (human.listed) {
        found += (found.empty() ? "" : ",") + human.name + " " + std::to_string(human.id) + " " +
                 std::to_string(human.goals.size());
      }
    }
    QCOMPARE(QByteArray::fromStdString(found), listed);
    const std::string text = writeScenario(reading.scenario);
    const ScenarioReading again = readScenarioText(text, reading.scenario.yamlBaseName.value());
    QVERIFY2(again.ok(), qPrintable(shown(again.diagnostics)));
    QVERIFY(again.scenario == reading.scenario);
    QVERIFY(writeScenario(again.scenario) == text);
    base::Diagnostics losses;
    const ScenarioReading old = readScenarioText(writeScenarioB(reading.scenario, losses), "b");
    QVERIFY2(old.ok(), qPrintable(shown(old.diagnostics)));
    QCOMPARE(old.scenario.humans.size(), reading.scenario.humans.size());
  }

  void write_panelFiles_sameBytesButSpeedDigits_data() {
    QTest::addColumn<QByteArray>("file");
    for (const char* file :
         {"own/scenarios/agents_yard.yaml", "isaac/scenarios/warehouse_agents.yaml",
          "gazebo_classic/scenarios/agents_cafe.yaml", "gazebo_classic/scenarios/agents_house.yaml",
          "gazebo_classic/scenarios/agents_warehouse.yaml"}) {
      QTest::newRow(file) << QByteArray(file);
    }
  }
  void write_panelFiles_sameBytesButSpeedDigits() {
    QFETCH(QByteArray, file);
    const std::string path = hunavFile(file);
    if (path.empty()) {
      QSKIP("the real files of HuNavSim are not here");
    }
    QString original = QString::fromStdString(textOf(path));
    const QString written = QString::fromStdString(writeScenario(readScenario(path).scenario));
    const QRegularExpression speed(QStringLiteral("max_vel: ([0-9.]+)"));
    QStringList expected = original.split(QLatin1Char('\n'));
    if (expected.last().isEmpty()) {
      expected.removeLast();  // a hand has been at the Isaac file
    }
    const QStringList lines = written.split(QLatin1Char('\n'));
    QCOMPARE(lines.size(), expected.size());
    for (int i = 0; i < lines.size(); ++i) {
      const auto match = speed.match(expected[i]);
      if (match.hasMatch()) {
        QCOMPARE(speed.match(lines[i]).captured(1).toDouble(), match.captured(1).toDouble());
      } else {
        QCOMPARE(lines[i], expected[i]);
      }
    }
  }
};

QTEST_APPLESS_MAIN(ScenarioReaderTest)
#include "tst_ScenarioReader.moc"
