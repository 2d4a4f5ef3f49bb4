#include <QTemporaryDir>
#include <QtTest>

#include "SmallScenario.h"
#include "editor/document/Fixes.h"
#include "sim2d/base/Text.h"

using editor::Fix;
using editor::ScenarioDocument;
using sim2d::Scenario;

namespace {

using Damage = void (*)(Scenario&);

struct Problem {
  base::Diagnostic diagnostic;
  Fix fix;
};

std::optional<Problem> problemWith(const ScenarioDocument& document, const QString& label) {
  base::Diagnostics all = document.issues();
  base::append(all, editor::adviceFor(document.scenario()));
  for (const base::Diagnostic& each : all) {
    if (const std::optional<Fix> fix = editor::fixFor(document, each); fix && fix->label == label) {
      return Problem{each, *fix};
    }
  }
  return std::nullopt;
}

bool isToldStill(const ScenarioDocument& document, const base::Diagnostic& problem) {
  base::Diagnostics all = document.issues();
  base::append(all, editor::adviceFor(document.scenario()));
  return std::any_of(all.begin(), all.end(), [&](const base::Diagnostic& each) {
    return each.code == problem.code && each.values == problem.values;
  });
}

}  // namespace

Q_DECLARE_METATYPE(Damage)

namespace {

void row(const char* name, const char* label, Damage damage) {
  QTest::newRow(name) << damage << QString::fromUtf8(label);
}

void rowsOfPlaces() {
  const char* const out = "Move out of the wall";
  row("person in a wall", out, [](Scenario& s) { s.humans[0].initPose.position = {6.0, 1.0}; });
  row("person outside of the map", out, [](Scenario& s) {
    s.humans[0].initPose.position = {-9.0, 4.0};
  });
  row("goal in a wall", out, [](Scenario& s) { s.goals[0].position = {6.0, 7.0}; });
  row("robot's start in a table", out, [](Scenario& s) {
    s.robots[0].start.position = {4.2, 1.4};
  });
  row("robot's goal in a wall", out, [](Scenario& s) { s.robots[0].goal.point = {0.05, 4.0}; });
}

void rowsOfGoals() {
  row("goal number missing", "Renumber goals", [](Scenario& s) {
    s.goals[1].id = 8;
    s.humans[0].goals = {1, 8};
    s.humans[2].goals = {8};
    s.humans[5].goals = {8};
  });
  row("goal number twice", "Renumber goals", [](Scenario& s) { s.goals[1].id = 1; });
  row("goal number 0", "Renumber goals", [](Scenario& s) { s.goals[1].id = 0; });
  row("goal not defined", "Remove goal 9 from the route", [](Scenario& s) {
    s.humans[0].goals = {1, 9, 2, 9};
  });
  row("goal out of reach", "Remove goal 2 from the route", [](Scenario& s) {
    s.obstacles.resize(4, s.obstacles[0]);
    for (std::size_t i = 0; i < 4; ++i) {  // four walls round the goal at 2, 7
      sim2d::Obstacle& wall = s.obstacles[i];
      const double turn = static_cast<double>(i) * base::kPi / 2.0;
      wall = sim2d::Obstacle();
      wall.key = {base::EntityKind::Obstacle, 60 + static_cast<int>(i)};
      wall.name = "side" + std::to_string(i);
      wall.pose.position = base::Vec2(2.0, 7.0) + 0.9 * base::directionOf(turn);
      wall.pose.heading = turn;
      wall.length = 0.1;
      wall.width = 1.9;
    }
  });
}

void rowsOfPeople() {
  row("ids not in order", "Renumber people",
      [](Scenario& s) { std::swap(s.humans[0].id, s.humans[1].id); });
  row("id twice", "Renumber people", [](Scenario& s) { s.humans[1].id = 1; });
  row("id below 0", "Renumber people", [](Scenario& s) { s.humans[1].id = -1; });
  row("name twice", "Rename", [](Scenario& s) { s.humans[1].name = "Ana"; });
  row("name of a key", "Rename", [](Scenario& s) { s.humans[1].name = "agents"; });
  row("name with blanks", "Rename", [](Scenario& s) { s.obstacles[0].name = "my table"; });
  row("factor out of range", "Clamp to the range",
      [](Scenario& s) { s.humans[0].behavior.goalForceFactor = 77.0; });
  row("speed of reaction out of range", "Clamp to the range",
      [](Scenario& s) { s.humans[0].behavior.vel = 2.5; });
  row("skin out of range", "Clamp to the range", [](Scenario& s) {
    s.simulator = "Webots";
    s.humans[0].skin = 7;
  });
  row("reaction incomplete", "Add these values",
      [](Scenario& s) { s.humans[4].behavior.dist = 3.0; });
  row("no start", "Set the start to 0, 0", [](Scenario& s) { s.humans[0].hasInitPose = false; });
  row("waits do not fit", "Set one wait per goal",
      [](Scenario& s) { s.humans[0].ours.wait = {1.0}; });
}

void rowsOfTheRest() {
  row("model mistyped", "Use 'orca'", [](Scenario& s) { s.desktop.model = "orcs"; });
  row("model of a person unknown", "Use the default",
      [](Scenario& s) { s.humans[0].ours.model = "teleport9000"; });
  row("planner mistyped", "Use 'pursuit'", [](Scenario& s) { s.robots[0].planner = "persuit"; });
  row("source copies nobody", "Copy Ana",
      [](Scenario& s) { s.areas[0].kind = sim2d::AreaKind::Source; });
  row("source copies a stranger", "Copy Ana", [](Scenario& s) {
    s.areas[0].kind = sim2d::AreaKind::Source;
    s.areas[0].like = "Zoe";
  });
  row("source without rate", "Set rate to 0.1 /s", [](Scenario& s) {
    s.areas[0].kind = sim2d::AreaKind::Source;
    s.areas[0].like = "Ana";
  });
  row("source ends before it begins", "Swap the times", [](Scenario& s) {
    s.areas[0].kind = sim2d::AreaKind::Source;
    s.areas[0].like = "Ana";
    s.areas[0].rate = 1.0;
    s.areas[0].from = 9.0;
    s.areas[0].until = 3.0;
  });
  row("door in a wall of the map", "Open the wall", [](Scenario& s) {
    s.doors[0].from = sim2d::Vec2(6.0, 1.0);
    s.doors[0].to = sim2d::Vec2(6.0, 2.2);
  });
  row("door without length", "Remove", [](Scenario& s) { s.doors[0].to = s.doors[0].from; });
  row("map with extension", "Set to 'cafe'", [](Scenario& s) { s.map = "maps/cafe.yaml"; });
  row("robot unlike its Nav2 file", "Use the body in the Nav2 file", [](Scenario& s) {
    s.robots[0].planner = "nav2";
    s.robots[0].radius = 0.5;
    s.robots[0].nav2Params = {SOURCE_DIR "/resources/nav2_params/turtlebot4.yaml"};
    s.robots[0].nav2Tree = SOURCE_DIR "/resources/nav2_trees/jazzy/follow_point.xml";
  });
  row("no robot", "Add a robot", [](Scenario& s) { s.robots.clear(); });
}

}  // namespace

class FixesTest : public QObject {
  Q_OBJECT

 private:
  static void load(ScenarioDocument& document, const Scenario& scenario) {
    document.load(scenario);
    document.setMap(small::room());
    document.checkNow();
  }

 private Q_SLOTS:
  void fix_ofEachProblem_mendsItInOneStep_data() {
    QTest::addColumn<Damage>("damage");
    QTest::addColumn<QString>("label");
    rowsOfPlaces();
    rowsOfGoals();
    rowsOfPeople();
    rowsOfTheRest();
  }
  void fix_ofEachProblem_mendsItInOneStep() {
    QFETCH(Damage, damage);
    QFETCH(QString, label);
    Scenario scenario = small::scenario();
    damage(scenario);
    ScenarioDocument document;
    load(document, scenario);
    const std::optional<Problem> problem = problemWith(document, label);
    QVERIFY2(problem,
             [&] {
               std::string all;
               for (const base::Diagnostic& each : document.issues()) {
                 all += each.text() + "\n";
               }
               return all;
             }()
                 .c_str());
    problem->fix.apply(document);
    QCOMPARE(document.undoStack().count(), 1);
    document.checkNow();
    QVERIFY2(!isToldStill(document, problem->diagnostic), problem->diagnostic.message.c_str());
    document.undoStack().undo();
    QVERIFY(document.scenario() == scenario);
  }

  void mapThatIsLost_canBeLeftOut_data() {
    QTest::addColumn<Damage>("damage");
    QTest::newRow("by its name") << Damage([](Scenario& s) { s.map = "no_such_map"; });
    QTest::newRow("by its file") << Damage([](Scenario& s) { s.desktop.mapFile = "lost.yaml"; });
    QTest::newRow("a folder") << Damage([](Scenario& s) { s.desktop.mapFile = "."; });
    QTest::newRow("none is named") << Damage([](Scenario& s) { s.map.reset(); });
  }
  void mapThatIsLost_canBeLeftOut() {
    QFETCH(Damage, damage);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("room.yaml"));
    Scenario scenario = small::scenario();
    damage(scenario);
    QVERIFY(base::writeFileAtomically(path.toStdString(), sim2d::writeScenario(scenario)).empty());
    ScenarioDocument document;
    QVERIFY(!base::hasErrors(document.open(path)));
    QVERIFY(document.mapState().isMissing);
    const std::optional<Problem> problem = problemWith(document, QStringLiteral("Use open plane"));
    QVERIFY(problem);
    problem->fix.apply(document);
    QVERIFY(!isToldStill(document, problem->diagnostic));
    document.undoStack().undo();
    QVERIFY(isToldStill(document, problem->diagnostic));
  }

  void personWithoutGoals_needsAHand() {
    ScenarioDocument document;
    load(document, small::scenario());  // Farid has none
    const std::optional<Problem> problem =
        problemWith(document, QString::fromUtf8("Assign goals…"));
    QVERIFY(problem);
    QVERIFY(!problem->fix.apply);
    QCOMPARE(problem->diagnostic.entity, document.scenario().humans[4].key);
  }

  void renumberedGoals_takeTheirRoutesAlong() {
    Scenario scenario = small::scenario();
    scenario.goals[1].id = 8;
    scenario.humans[0].goals = {1, 8, 3};
    scenario.robots[0].goal = {std::nullopt, {8}};
    ScenarioDocument document;
    load(document, scenario);
    problemWith(document, QStringLiteral("Renumber goals"))->fix.apply(document);
    QCOMPARE(document.scenario().humans[0].goals, (std::vector<int>{1, 3, 2}));
    QCOMPARE(document.scenario().robots[0].goal.goals, std::vector<int>{3});
    QCOMPARE(document.scenario().goals[1].id, 3);  // 1, 3, 8 became 1, 2, 3
    QCOMPARE(document.scenario().goals[2].id, 2);
  }

  void applyToAll_isOneStep() {
    Scenario scenario = small::scenario();
    scenario.humans[0].behavior.goalForceFactor = 77.0;
    scenario.humans[1].behavior.socialForceFactor = 1.0;
    ScenarioDocument document;
    load(document, scenario);
    editor::applyToAll(document, document.issues(), QStringLiteral("Clamp to the range"));
    QCOMPARE(*document.scenario().humans[0].behavior.goalForceFactor, 5.0);
    QCOMPARE(*document.scenario().humans[1].behavior.socialForceFactor, 5.0);
    QCOMPARE(document.undoStack().count(), 1);
    document.undoStack().undo();
    QVERIFY(document.scenario() == scenario);
  }

  void problemWithoutFix_hasNone() {
    ScenarioDocument document;
    load(document, small::scenario());
    QVERIFY(!editor::fixFor(document, base::error("scenario.nobody", {}, "a.yaml", 3, 1)));
    base::Diagnostic riddle = base::error("places.unknown-ground", {"start", "(1, 1)"});
    riddle.entity = document.scenario().humans[0].key;
    QVERIFY(!editor::fixFor(document, riddle));
  }
};

QTEST_MAIN(FixesTest)
#include "tst_Fixes.moc"
