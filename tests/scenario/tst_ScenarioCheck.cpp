#include <QTemporaryDir>

#include "ScenarioTest.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "tests/support/Columns.h"

using namespace sim2d;
using namespace scenariotest;

namespace {

/// 10 m x 10 m in cells of 0.1 m with a wall of 0.2 m along x = 5 that has no gap, and a strip of
/// unknown cells at the right edge.
OccupancyGrid dividedRoom(bool gap) {
  std::vector<std::int8_t> cells(std::size_t{100} * 100, 0);
  for (std::size_t row = 0; row < 100; ++row) {
    for (std::size_t column = 0; column < 100; ++column) {
      const bool wall = (column == 50 || column == 51) && !(gap && row < 20);
      cells[row * 100 + column] = static_cast<std::int8_t>(wall ? 100 : column >= 90 ? -1 : 0);
    }
  }
  return {100, 100, 0.1, Pose2{}, std::move(cells)};
}

Human walker(int id, const char* name, const Vec2& start, std::vector<int> goals) {
  Human human;
  human.key = {base::EntityKind::Human, id};
  human.id = id;
  human.name = name;
  human.radius = 0.3;
  human.initPose.position = start;
  human.goals = std::move(goals);
  return human;
}

Scenario oneWalker(const Vec2& start, const Vec2& goal) {
  Scenario scenario;
  scenario.map = "room";
  GlobalGoal first;
  first.id = 1;
  first.key = {base::EntityKind::Goal, 50};
  first.position = goal;
  scenario.goals.push_back(first);
  scenario.humans.push_back(walker(1, "anna", start, {1}));
  return scenario;
}

base::Diagnostics check(const Scenario& scenario, OccupancyGrid grid = {}) {
  return checkScenario(scenario, makeSurroundings(scenario, std::move(grid)), "room.yaml",
                       usualNames());
}

void touch(const QTemporaryDir& folder, const char* name) {
  const QString path = folder.filePath(QString::fromUtf8(name));
  QDir().mkpath(QFileInfo(path).path());
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
}

using Change = std::function<void(Scenario&)>;

}  // namespace
Q_DECLARE_METATYPE(Change)

class ScenarioCheckTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void check_goodScenario_silent() {
    const auto said = check(oneWalker({1.0, 1.0}, {4.0, 8.0}), dividedRoom(true));
    QVERIFY2(said.empty(), qPrintable(shown(said)));
  }

  void check_valueFarFromAnyReal_isWarned_data() {
    QTest::addColumn<Change>("change");
    QTest::addColumn<QByteArray>("text");  // empty: no warning
    const auto factor = [](double value, Configuration configuration) -> Change {
      return [=](Scenario& scenario) {
        scenario.humans[0].behavior.configuration = configuration;
        scenario.humans[0].behavior.socialForceFactor = value;
      };
    };
    const auto body = [](auto member, double value) -> Change {
      return [=](Scenario& scenario) { scenario.humans[0].*member = value; };
    };
    const auto robot = [](auto member, double value) -> Change {
      return [=](Scenario& scenario) {
        Robot one;
        one.key = {base::EntityKind::Robot, 70};
        one.name = "rob";
        one.start.position = {2.0, 2.0};
        one.goal.goals = {1};
        one.*member = value;
        scenario.robots.push_back(one);
      };
    };
    QTest::newRow("a sprinter in km/h")
        << body(&Human::maxVel, 99.0)
        << QByteArray("anna: max_vel 99 is implausible: usual values are 0 to 5 m/s");
    QTest::newRow("somebody who rushes") << body(&Human::maxVel, 5.0) << QByteArray();
    QTest::newRow("somebody who stands") << body(&Human::maxVel, 0.0) << QByteArray();
    QTest::newRow("a radius in centimetres")
        << body(&Human::radius, 35.0)
        << QByteArray("anna: radius 35 is implausible: usual values are 0.1 to 1 m");
    QTest::newRow("a point") << body(&Human::radius, 0.01)
                             << QByteArray(
                                    "anna: radius 0.01 is implausible: usual values are 0.1 "
                                    "to 1 m");
    QTest::newRow("arrival") << body(&Human::goalRadius, 40.0)
                             << QByteArray(
                                    "anna: goal_radius 40 is implausible: usual values "
                                    "are 0 to 10 m");
    QTest::newRow("a mass in grams")
        << Change([](Scenario& scenario) { scenario.humans[0].ours.mass = 80000.0; })
        << QByteArray("anna: mass 80000 is implausible: usual values are 3 to 400 kg");
    QTest::newRow("a force that attracts")
        << factor(-5.0, Configuration::Custom)
        << QByteArray(
               "anna: social_force_factor -5 is implausible: usual values are 0 to "
               "200");
    QTest::newRow("a custom force") << factor(50.0, Configuration::Custom) << QByteArray();
    QTest::newRow("a force that the loader clamps")
        << factor(999.0, Configuration::Default)
        << QByteArray(
               "anna: social_force_factor 999 is outside 5 to 20: HuNavSim's loader "
               "clamps it");
    QTest::newRow("a robot in km/h")
        << robot(&Robot::maxVel, 20.0)
        << QByteArray("rob: max_vel 20 is implausible: usual values are 0 to 6 m/s");
    QTest::newRow("a robot as wide as a house")
        << robot(&Robot::radius, 9.0)
        << QByteArray("rob: radius 9 is implausible: usual values are 0.02 to 5 m");
    QTest::newRow("a robot of a tonne") << robot(&Robot::mass, 1000.0) << QByteArray();
  }
  void check_valueFarFromAnyReal_isWarned() {
    QFETCH(Change, change);
    QFETCH(QByteArray, text);
    Scenario scenario = oneWalker({1.0, 1.0}, {4.0, 8.0});
    change(scenario);
    QByteArray told;
    for (const base::Diagnostic& each : check(scenario)) {
      QCOMPARE(each.severity, base::Severity::Warning);
      told += QByteArray::fromStdString(each.message);
    }
    QCOMPARE(told, text);
  }

  void shippedAndInteropFiles_haveNoImplausibleValues() {
    int files = 0;
    for (const QString& folder : {QStringLiteral(SOURCE_DIR "/maps"), interopFolder()}) {
      QDirIterator each(folder, {QStringLiteral("*.yaml")}, QDir::Files,
                        QDirIterator::Subdirectories);
      while (each.hasNext()) {
        const std::string path = each.next().toStdString();
        if (textOf(path).find("hunav_loader") == std::string::npos) {
          continue;
        }
        ++files;
        for (const base::Diagnostic& found : check(readScenario(path).scenario)) {
          QVERIFY2(found.code != "scenario.implausible", found.text().c_str());
        }
      }
    }
    QVERIFY(files > 30);
  }

  void check_sourceWithoutIds_told() {
    Scenario scenario = oneWalker({1.0, 1.0}, {4.0, 8.0});
    Area door;
    door.key = {base::EntityKind::Area, 60};
    door.name = "door";
    door.kind = AreaKind::Source;
    door.points = {{1.0, 1.0}, {2.0, 1.0}, {2.0, 2.0}};
    door.like = "anna";
    door.rate = 1.0;
    door.count = 3;
    scenario.areas.push_back(door);
    scenario.humans[0].id = 2147483644;  // three are left
    QVERIFY(!shown(check(scenario)).contains(QStringLiteral("ids remain")));
    scenario.humans[0].id = 2147483645;
    QVERIFY(shown(check(scenario))
                .contains(QStringLiteral("warning: door: too few ids remain after id 2147483645 "
                                         "for the people that are spawned")));
    scenario.humans[0].id = 2147483643;  // four, of which the first door takes three
    door.name = "gate";
    door.key = {base::EntityKind::Area, 61};
    door.count = 2;
    scenario.areas.push_back(door);
    const QString said = shown(check(scenario));
    QVERIFY(!said.contains(QStringLiteral("door: too few ids remain")));
    QVERIFY2(said.contains(QStringLiteral("gate: too few ids remain after id 2147483643")),
             qPrintable(said));
  }

  void check_places_data() {
    addColumns<QPointF, QPointF, bool, QString, QString>(
        {"start", "goal", "gap", "severity", "message"});
    QTest::newRow("start in the wall")
        << QPointF(5.05, 5.0) << QPointF(2.0, 5.0) << true << QStringLiteral("warning")
        << QStringLiteral(
               "anna: init_pose (5.05, 5): a body of radius 0.3 does not fit here, a run uses (");
    QTest::newRow("start beside the wall")
        << QPointF(4.9, 5.0) << QPointF(2.0, 5.0) << true << QStringLiteral("warning")
        << QStringLiteral("anna: init_pose (4.9, 5): a body");
    QTest::newRow("goal in the wall")
        << QPointF(2.0, 5.0) << QPointF(5.1, 5.0) << true << QStringLiteral("warning")
        << QStringLiteral("goal 1 (5.1, 5): a body of radius 0.3 does not fit here, a run uses (");
    QTest::newRow("no way") << QPointF(2.0, 5.0) << QPointF(8.0, 5.0) << false
                            << QStringLiteral("warning")
                            << QStringLiteral(
                                   "anna: no path from the start to goal 1 (8, 5): the goal is "
                                   "skipped");
    QTest::newRow("round the wall")
        << QPointF(2.0, 5.0) << QPointF(8.0, 5.0) << true << QStringLiteral("info")
        << QStringLiteral("anna: a wall blocks the straight line to goal 1");
    QTest::newRow("unknown cell") << QPointF(9.5, 5.0) << QPointF(8.0, 5.0) << true
                                  << QStringLiteral("warning")
                                  << QStringLiteral(
                                         "anna: init_pose (9.5, 5): the map cell is unknown");
  }
  void check_places() {
    QFETCH(QPointF, start);
    QFETCH(QPointF, goal);
    QFETCH(bool, gap);
    QFETCH(QString, severity);
    QFETCH(QString, message);
    const Scenario scenario = oneWalker({start.x(), start.y()}, {goal.x(), goal.y()});
    const auto said = check(scenario, dividedRoom(gap));
    QVERIFY2(!said.empty(), "nothing was said");
    QVERIFY2(QString::fromStdString(said[0].message).startsWith(message), qPrintable(shown(said)));
    QCOMPARE(QString::fromUtf8(base::severityName(said[0].severity)), severity);
    QVERIFY(said[0].entity && !base::hasErrors(said));
  }

  void check_noPlaceWithinAMetre_isError() {
    std::vector<std::int8_t> cells(std::size_t{100} * 100, 0);
    for (std::size_t i = 0; i < std::size_t{100} * 60; ++i) {
      cells[i] = 100;  // the lower 6 m are solid
    }
    const OccupancyGrid grid(100, 100, 0.1, Pose2{}, std::move(cells));
    const auto said = check(oneWalker({5.0, 3.0}, {5.0, 8.0}), grid);
    QCOMPARE(said.size(), std::size_t(1));
    QVERIFY(said[0].severity == base::Severity::Error);
    QVERIFY(said[0].message.find("no free space for a body of radius 0.3 here or within 1 m") !=
            std::string::npos);
  }

  void check_directRoute_wallIsWarningAndNoWayIsNone() {
    Scenario scenario = oneWalker({2.0, 5.0}, {8.0, 5.0});
    scenario.desktop.route = Route::Direct;
    const auto said = check(scenario, dividedRoom(false));
    QCOMPARE(said.size(), std::size_t(1));
    QVERIFY(said[0].severity == base::Severity::Warning);
    QVERIFY(said[0].message.find("anna: a wall blocks the straight line") == 0);
  }

  void check_door_closedCutsOffUnlessItOpens_data() {
    addColumns<bool, bool, bool>({"open", "toggles", "reachable"});
    QTest::newRow("open") << true << false << true;
    QTest::newRow("closed") << false << false << false;
    QTest::newRow("opens later") << false << true << true;
  }
  void check_door_closedCutsOffUnlessItOpens() {
    QFETCH(bool, open);
    QFETCH(bool, toggles);
    QFETCH(bool, reachable);
    Scenario scenario = oneWalker({2.0, 1.0}, {8.0, 1.0});
    Door door;
    door.key = {base::EntityKind::Door, 70};
    door.name = "gate";
    door.from = Vec2(5.1, 0.0);
    door.to = Vec2(5.1, 2.0);
    door.open = open;
    door.toggles = toggles ? std::vector<double>{5.0} : std::vector<double>{};
    scenario.doors.push_back(door);
    const auto said = check(scenario, dividedRoom(true));
    const QString all = shown(said);
    QVERIFY2(all.contains(QStringLiteral("no path from the start")) != reachable, qPrintable(all));
  }

  void check_nobodyButASource_hasSomebody() {
    Scenario scenario;
    const auto isNobodyThere = [&scenario] {
      const base::Diagnostics said = check(scenario);
      return std::any_of(said.begin(), said.end(),
                         [](const auto& each) { return each.code == "scenario.nobody"; });
    };
    QVERIFY(isNobodyThere());
    Area entrance;
    entrance.key = {base::EntityKind::Area, 70};
    entrance.name = "entrance";
    entrance.kind = AreaKind::Source;
    entrance.points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}};
    scenario.areas.push_back(entrance);
    QVERIFY(!isNobodyThere());
    scenario.areas[0].listed = false;
    QVERIFY(isNobodyThere());
  }

  void check_obstacleOnOpenPlane_startMoves() {
    Scenario scenario = oneWalker({0.0, 0.0}, {5.0, 0.0});
    Obstacle box;
    box.key = {base::EntityKind::Obstacle, 80};
    box.name = "box";
    scenario.obstacles.push_back(box);
    const auto said = check(scenario);
    QVERIFY2(!said.empty() && said[0].message.find("anna: init_pose (0, 0): a body") == 0,
             qPrintable(shown(said)));
    scenario.obstacles[0].listed = false;
    QVERIFY(check(scenario).empty());
  }

  void check_farApartOnOpenPlane_endsQuickly() {
    Scenario scenario = oneWalker({-9e5, 0.0}, {9e5, 9e5});
    scenario.obstacles.resize(1);
    scenario.obstacles[0].name = "box";
    const auto said = check(scenario);
    QCOMPARE(said.size(), std::size_t(1));
    QVERIFY(said[0].message.find("too far apart") != std::string::npos);
  }

  void check_knownNames_canBeHandedIn() {
    Scenario scenario = oneWalker({0.0, 0.0}, {5.0, 0.0});
    scenario.desktop.model = "mine";
    const Surroundings surroundings = makeSurroundings(scenario, {});
    KnownNames names = usualNames();
    QVERIFY(base::hasErrors(checkScenario(scenario, surroundings, "room.yaml", names)));
    names.models.push_back("mine");
    QVERIFY(checkScenario(scenario, surroundings, "room.yaml", names).empty());
  }

  void check_names_data() {
    addColumns<QByteArray, QByteArray, bool>({"human", "box", "good"});
    QTest::newRow("good") << QByteArray("Anna M.") << QByteArray("box_1") << true;
    QTest::newRow("same") << QByteArray("box") << QByteArray("box") << false;
    QTest::newRow("person as key") << QByteArray("agents") << QByteArray("box") << false;
    QTest::newRow("person without name") << QByteArray("") << QByteArray("box") << false;
    QTest::newRow("key") << QByteArray("anna") << QByteArray("seed") << false;
    QTest::newRow("map") << QByteArray("anna") << QByteArray("map") << false;
    QTest::newRow("digit first") << QByteArray("anna") << QByteArray("1box") << false;
    QTest::newRow("blank") << QByteArray("anna") << QByteArray("my box") << false;
  }
  void check_names() {
    QFETCH(QByteArray, human);
    QFETCH(QByteArray, box);
    QFETCH(bool, good);
    Scenario scenario = oneWalker({5.0, 5.0}, {5.0, 9.0});
    scenario.humans[0].name = human.toStdString();
    scenario.obstacles.resize(1);
    scenario.obstacles[0].name = box.toStdString();
    QCOMPARE(!base::hasErrors(check(scenario)), good);
  }

  void makeSurroundings_partsInOrder() {
    const Scenario scenario = readScenario(dataFile("block.yaml")).scenario;
    const Surroundings surroundings = makeSurroundings(scenario, dividedRoom(false));
    QCOMPARE(surroundings.firstObstaclePart, 1);
    QCOMPARE(surroundings.firstDoorPart, 5);
    QCOMPARE(surroundings.obstacles.partCount(), 6);
    QVERIFY(surroundings.obstacles.isEnabled(5));  // the gate is closed
    QVERIFY(surroundings.obstacles.isInside({12.0, 3.0}));
    QVERIFY(surroundings.obstacles.isInside({6.0, 6.0}));
    QVERIFY(surroundings.obstacles.isInside({1.5, 9.05}));
    QVERIFY(!surroundings.obstacles.isVisible({10.5, -1.0}, {10.5, 1.0}));
    QVERIFY(!surroundings.obstacles.isVisible({4.0, 5.0}, {5.6, 5.0}));
    QVERIFY(surroundings.obstacles.isVisible({8.0, 2.0}, {9.0, 2.0}));
  }

  void findMap_searchOrder() {
    QTemporaryDir folder;
    Scenario scenario;
    scenario.map = "maps/yard.yaml";
    FileSearchPaths places;
    places.scenarioPath = folder.filePath(QStringLiteral("scenarios/a.yaml")).toStdString();
    places.shippedMaps = folder.filePath(QStringLiteral("shipped")).toStdString();
    const auto found = [&] {
      const auto map = findMap(scenario, places);
      return map ? QString::fromStdString(*map) : QString();
    };
    const auto missing = findMap(scenario, places);
    QVERIFY(!missing);
    const std::string said = missing.diagnostics()[0].text();
    for (const char* place :
         {"/scenarios/yard.yaml", "/maps/yard.yaml", "/shipped/yard/yard.yaml"}) {
      QVERIFY2(said.find(place) != std::string::npos, said.c_str());
    }
    touch(folder, "shipped/yard/yard.yaml");
    QVERIFY(found().endsWith(QStringLiteral("/shipped/yard/yard.yaml")));
    touch(folder, "maps/yard.yaml");
    QCOMPARE(found(), folder.filePath(QStringLiteral("maps/yard.yaml")));
    touch(folder, "scenarios/yard.yaml");
    QVERIFY(found().endsWith(QStringLiteral("/scenarios/yard.yaml")));
    touch(folder, "scenarios/other/b.yaml");
    scenario.desktop.mapFile = "other/b.yaml";
    QVERIFY(found().endsWith(QStringLiteral("/scenarios/other/b.yaml")));
    scenario.desktop.mapFile = "other/c.yaml";
    QVERIFY(!findMap(scenario, places));
    scenario.desktop.mapFile = "none";
    QVERIFY(findMap(scenario, places)->empty());
    places.mapOption = folder.filePath(QStringLiteral("maps/yard.yaml")).toStdString();
    QCOMPARE(found(), folder.filePath(QStringLiteral("maps/yard.yaml")));
    places.mapOption = "none";
    scenario.desktop.mapFile.reset();
    QVERIFY(findMap(scenario, places)->empty());
  }

  void findTree_searchOrder() {
    QTemporaryDir folder;
    Scenario scenario;
    scenario.yamlBaseName = "base";
    Human human;
    human.id = 12;
    FileSearchPaths places;
    places.scenarioPath = folder.filePath(QStringLiteral("scenarios/a.yaml")).toStdString();
    const auto found = [&] { return QString::fromStdString(findTree(scenario, human, places)); };
    QVERIFY(found().isEmpty());
    touch(folder, "behavior_trees/base__agent_12_bt.xml");
    QCOMPARE(found(), folder.filePath(QStringLiteral("behavior_trees/base__agent_12_bt.xml")));
    touch(folder, "scenarios/base__agent_12_bt.xml");
    QVERIFY(found().endsWith(QStringLiteral("scenarios/base__agent_12_bt.xml")));
    touch(folder, "given/base__agent_12_bt.xml");
    places.treesOption = folder.filePath(QStringLiteral("given")).toStdString();
    QVERIFY(found().endsWith(QStringLiteral("given/base__agent_12_bt.xml")));
    human.ours.tree = "own/anna.xml";
    QCOMPARE(found(), folder.filePath(QStringLiteral("scenarios/own/anna.xml")));
    human.ours.tree.reset();
    scenario.yamlBaseName.reset();
    places.treesOption.clear();
    QVERIFY(found().isEmpty());
    touch(folder, "scenarios/a__agent_12_bt.xml");
    QVERIFY(found().endsWith(QStringLiteral("scenarios/a__agent_12_bt.xml")));
  }

  void mapBaseName_stripsFolderAndExtension_data() {
    addColumns<QByteArray, QByteArray>({"map", "name"});
    QTest::newRow("plain") << QByteArray("yard") << QByteArray("yard");
    QTest::newRow("extension") << QByteArray("yard.yaml") << QByteArray("yard");
    QTest::newRow("folder") << QByteArray("/a/b/yard.PGM") << QByteArray("yard");
    QTest::newRow("photograph") << QByteArray("yard.jpg") << QByteArray("yard");
    QTest::newRow("dot in the name") << QByteArray("yard.v2") << QByteArray("yard.v2");
    QTest::newRow("empty") << QByteArray("") << QByteArray("");
  }
  void mapBaseName_stripsFolderAndExtension() {
    QFETCH(QByteArray, map);
    QFETCH(QByteArray, name);
    QCOMPARE(QByteArray::fromStdString(mapBaseName(map.toStdString())), name);
  }

  /// Every start and goal of the real files lies in a free cell of its map, but for two places of
  /// one file of a fork. Isaac's map is a PNG: it is read where images can be read, not here.
  void interop_placesAreFree_data() {
    addColumns<QByteArray, QByteArray, int>({"file", "map", "notFree"});
    const auto row = [](const char* file, const char* map, int notFree) {
      QTest::newRow(file) << QByteArray(file) << QByteArray(map) << notFree;
    };
    const char* cafe = "gazebo_classic/maps/cafe.yaml";
    const char* first = "hunav_sim_v1/maps/map_cafe2.yaml";
    row("own/scenarios/agents_yard.yaml", "own/maps/yard.yaml", 0);
    row("gazebo_classic/scenarios/agents_cafe.yaml", cafe, 0);
    row("gazebo_classic/scenarios/agents_house.yaml", "gazebo_classic/maps/house.yaml", 0);
    row("gazebo_classic/scenarios/agents_warehouse.yaml", "gazebo_classic/maps/warehouse.yaml", 0);
    row("gazebo_fortress/scenarios/cafe_agents.yaml", cafe, 0);
    row("gazebo_fortress/scenarios/agents2_cafe.yaml", cafe, 0);
    row("gazebo_fortress/scenarios/agents_test.yaml", cafe, 0);
    row("hunav_sim_v1/config/agents.yaml", first, 0);
    row("hunav_sim_2024/config/agents.yaml", first, 0);
    row("hunav_sim_2024/config/agents_house.yaml", "hunav_sim_v1/maps/small_house.yaml", 0);
    row("hunav_sim_2024/config/agents_warehouse.yaml", "hunav_sim_v1/maps/small_warehouse.yaml", 0);
    row("third_party_fork/config/default_agents.yaml", first, 0);
    row("third_party_fork/config/custom_agents.yaml", "hunav_sim_v1/maps/small_warehouse.yaml", 2);
  }
  void interop_placesAreFree() {
    QFETCH(QByteArray, file);
    QFETCH(QByteArray, map);
    QFETCH(int, notFree);
    const std::string path = hunavFile(file);
    if (path.empty()) {
      QSKIP("the real files of HuNavSim are not here");
    }
    const ScenarioReading reading = readScenario(path);
    const auto read = readMap(hunavFile(map), {});
    QVERIFY2(read, qPrintable(shown(read.diagnostics())));
    int occupied = 0;
    const auto look = [&](const Vec2& point) {
      const Cell cell = read->grid.worldToCell(point);
      occupied += read->grid.contains(cell) && read->grid.valueAt(cell) == 0 ? 0 : 1;
    };
    for (const Human& human : reading.scenario.humans) {
      if (human.listed) {
        look(human.initPose.position);
        for (const int goal : human.goals) {
          look(reading.scenario.goal(goal)->position);
        }
      }
    }
    QCOMPARE(occupied, notFree);
    // the whole check copes with the real maps
    const auto said =
        checkScenario(reading.scenario, makeSurroundings(reading.scenario, read->grid), "file.yaml",
                      usualNames());
    QVERIFY2(!base::hasErrors(said), qPrintable(shown(said)));
  }
};

QTEST_APPLESS_MAIN(ScenarioCheckTest)
#include "tst_ScenarioCheck.moc"
