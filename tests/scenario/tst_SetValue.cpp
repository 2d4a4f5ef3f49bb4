#include "ScenarioTest.h"
#include "tests/support/Columns.h"

using namespace sim2d;
using namespace scenariotest;

class SetValueTest : public QObject {
  Q_OBJECT

  static Scenario block() { return readScenario(dataFile("block.yaml")).scenario; }

 private Q_SLOTS:
  void setValue_knownPath_changesTheFile_data() {
    addColumns<QByteArray, QByteArray>({"path", "value"});
    QTest::addColumn<QByteArray>("line");  // of the written file
    const auto row = [](const char* path, const char* value, const char* line) {
      QTest::newRow(path) << QByteArray(path) << QByteArray(value) << QByteArray(line);
    };
    row("dt", "0.1", "    dt: 0.1\n");
    row("seed", "99", "    seed: 99\n");
    row("anna.max_vel", "2", "      max_vel: 2.0\n");
    row("anna.behavior.type", "Curious", "        type: Curious\n");
    row("anna.behavior.dist", "7.5", "        dist: 7.50\n");
    row("anna.start_time", "4", "      start_time: 4.0\n");
    row("ben.start_time", "3.5", "    ben:\n      start_time: 3.5\n");
    row("anna.goals", "[3, 3]", "      goals:\n        - 3\n        - 3\n");
    row("anna.wait", "[1, 2, 3]", "      wait:\n        - 1.0\n        - 2.0\n        - 3.0\n");
    row("global_goals.3.x", "-1.25", "        x: -1.250\n");
    row("robot1.planner_parameters.lookahead", "0.9", "        lookahead: 0.9\n");
    row("robot1.planner_parameters.other", "true", "        other: true\n");
    row("model_parameters.orca.horizon", "3", "      orca:\n        horizon: 3\n");
    row("robot1.start.h", "1", "        h: 1.0\n");
    row("robot1.planner", "dwa", "      planner: dwa\n");
    row("robot1.command", "python3 'a b.py'", "      command: python3 'a b.py'\n");
    row("robot2.command", "./follow", "      command: ./follow\n");
    row("robot1.planner_parameters.file", "out/trajectory.csv",
        "        file: out/trajectory.csv\n");
    row("gate.open", "true", "      thickness: 0.08\n      toggles:\n");
    row("metrics.parameters.safe", "2", "        safe: 2.0\n");
    row("simulator", "Webots", "    simulator: Webots\n");
    row("map_file", "none", "    map_file: none\n");
    row("agents", "[ben, anna]", "    agents:\n      - ben\n      - anna\n    ben:\n");
    row("groups.7", "friends", "      7: friends\n");
    row("robot1", "{planner: orca}", "      planner: orca\n");
    row("anna", "{max_vel: 2}", "      max_vel: 2.0\n");
  }
  void setValue_knownPath_changesTheFile() {
    QFETCH(QByteArray, path);
    QFETCH(QByteArray, value);
    QFETCH(QByteArray, line);
    Scenario scenario = block();
    const base::Diagnostics said = setValue(scenario, path.toStdString(), value.toStdString());
    QVERIFY2(said.empty(), qPrintable(shown(said)));
    const std::string text = writeScenario(scenario);
    QVERIFY2(text.find(line.toStdString()) != std::string::npos, text.c_str());
  }

  void setValue_badPathOrValue_isErrorAndChangesNothing_data() {
    addColumns<QByteArray, QByteArray, QByteArray>({"path", "value", "message"});
    const auto row = [](const char* path, const char* value, const char* message) {
      QTest::newRow(path) << QByteArray(path) << QByteArray(value) << QByteArray(message);
    };
    row("anna.max_vell", "1.0", "unknown path 'anna.max_vell' (did you mean 'anna.max_vel'?)");
    row("sed", "1", "unknown path 'sed' (did you mean 'seed'?)");
    row("*.start_tim", "1", "unknown path '*.start_tim' (did you mean '*.start_time'?)");
    row("robot3.radius", "1.0", "unknown path 'robot3.radius' (did you mean 'robot1.radius'?)");
    row("nobody.behavior.type", "Scared", "unknown path 'nobody.behavior.type'");
    row("", "1", "unknown path ''");
    row("dt", "0.5", "dt: 0.5 must be from 0.001 to 0.1");
    row("seed", "1.5", "seed: '1.5' is not an integer");
    row("seed", "", "seed: '' is not a value");
    row("seed", "[", "seed: '[' is not a value");
    row("anna.max_vel", "fast", "anna.max_vel: 'fast' is not a number");
    row("anna.max_vel", ".nan", "anna.max_vel: .nan is not a finite number");
    row("anna.goals", "3", "anna.goals: must be a list of goal numbers");
    row("anna.behavior.type", "4", "anna.behavior.type: '4' is not the name of a behaviour");
    row("global_goals.9.x", "1.0", "global_goals.9.y: is missing");
    row("robot1", "{planer: dwa}", "unknown path 'robot1.planer' (did you mean 'robot1.planner'?)");
    row("robot1", "{planner: dwa, radius: wide}", "robot1.radius: 'wide' is not a number");
    row("robot1", "{planner: ~}", "robot1.planner: '' is not a value");
    row("robot1", "{}", "robot1: '{}' is not a value");
    row("*", "{max_vell: 1}", "unknown path '*.max_vell' (did you mean '*.max_vel'?)");
    row("anna", "{behavior.type: 4}", "anna.behavior.type: '4' is not the name of a behaviour");
    row("anna.behavior", "{dist: 7.5, type: 2}",
        "anna.behavior.type: '2' is not the name of a behaviour");
    row("*.behavior", "{type: 2}", "*.behavior.type: '2' is not the name of a behaviour");
    row("*", "{max_vel: 1.0, behavior: {type: 2}}",
        "*.behavior.type: '2' is not the name of a behaviour");
    row("anna.behavior", "2", "anna.behavior: '2' is not the name of a behaviour");
    row("ben", "{behavior: 3}", "ben.behavior: '3' is not the name of a behaviour");
    row("robot1.goals", "[1]", "robot1.goals: a robot has either 'goal' or 'goals'");
  }
  void setValue_badPathOrValue_isErrorAndChangesNothing() {
    QFETCH(QByteArray, path);
    QFETCH(QByteArray, value);
    QFETCH(QByteArray, message);
    Scenario scenario = block();
    const base::Diagnostics said = setValue(scenario, path.toStdString(), value.toStdString());
    QVERIFY(base::hasErrors(said));
    QVERIFY2(said[0].message.find(message.toStdString()) == 0, said[0].message.c_str());
    QVERIFY(scenario == block());
  }

  void setValue_star_setsEveryListedPerson() {
    Scenario scenario = readScenario(dataFile("dialect_b.yaml")).scenario;
    QVERIFY(setValue(scenario, "*.max_vel", "0.5").empty());
    QVERIFY(setValue(scenario, "*.kind", "elderly").empty());
    for (const Human& human : scenario.humans) {
      QVERIFY((human.maxVel == 0.5) == human.listed);
      QVERIFY((human.ours.kind == PersonKind::Elderly) == human.listed);
    }
  }

  void setValue_mapForAnEntity_setsItsKeysAndLeavesTheOthers() {
    Scenario scenario = block(), one = scenario;
    QVERIFY(setValue(scenario, "anna", "{max_vel: 2, start_time: 4, behavior.dist: 7.5}").empty());
    QVERIFY(
        setValue(scenario, "robot1", "{planner: dwa, start.h: 1, planner_parameters: {}}").empty());
    for (const auto& [path, value] :
         {std::pair("anna.max_vel", "2"), std::pair("anna.start_time", "4"),
          std::pair("anna.behavior.dist", "7.5"), std::pair("robot1.planner_parameters", "{}"),
          std::pair("robot1.planner", "dwa"), std::pair("robot1.start.h", "1")}) {
      QVERIFY(setValue(one, path, value).empty());
    }
    QVERIFY(scenario == one);
  }

  void setValue_mapForABehavior_takesNames() {
    Scenario scenario = block(), one = scenario;
    QVERIFY(setValue(scenario, "anna", "{behavior: {type: Scared, dist: 7.5}}").empty());
    QVERIFY(setValue(one, "anna.behavior", "{type: Scared, dist: 7.5}").empty());
    QVERIFY(scenario == one);
    QVERIFY(scenario.human("anna")->behavior.type == BehaviorType::Scared);
    QVERIFY(scenario.human("anna")->behavior.dist == 7.5);
  }

  void setValue_mapForEveryone_setsEveryListedPerson() {
    Scenario scenario = readScenario(dataFile("dialect_b.yaml")).scenario;
    QVERIFY(setValue(scenario, "*", "{max_vel: 0.5, kind: elderly}").empty());
    for (const Human& human : scenario.humans) {
      QVERIFY((human.maxVel == 0.5) == human.listed);
      QVERIFY((human.ours.kind == PersonKind::Elderly) == human.listed);
    }
  }

  void setValue_starWithoutPeople_isError() {
    Scenario scenario;
    QVERIFY(base::hasErrors(setValue(scenario, "*.max_vel", "0.5")));
  }

  void setValue_entitiesKeepTheirKeys() {
    Scenario scenario = block();
    scenario.humans[1].key.key = 500;
    scenario.goals[0].key.key = 501;
    scenario.robots[1].key.key = 502;
    QVERIFY(setValue(scenario, "agents", "[ben, anna]").empty());
    QCOMPARE(scenario.humans[0].name, std::string("ben"));
    QCOMPARE(scenario.humans[0].key.key, 500);
    QCOMPARE(scenario.goals[0].key.key, 501);
    QCOMPARE(scenario.robots[1].key.key, 502);
  }

  void setValue_plainScenario_makesTheBlock() {
    Scenario scenario = readScenario(dataFile("canonical.yaml")).scenario;
    QVERIFY(setValue(scenario, "duration", "30").empty());
    QVERIFY(scenario.desktop.duration == 30.0);
  }
};

QTEST_APPLESS_MAIN(SetValueTest)
#include "tst_SetValue.moc"
