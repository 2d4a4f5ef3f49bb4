#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <QtTest>

#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

constexpr double kRadius = 0.4;     // [m] of people in TestWorld.h
constexpr double kWall = 0.1;       // [m] half of its thickness
constexpr double kGrid = 0.02;      // [m]
constexpr double kOverlap = 0.011;  // [m]

/// Two rooms of 4 m, the wall between them at x = 4; five people, three of them at the wall.
Scenario rooms(VariationPreset preset, long long seed) {
  Scenario scenario;
  scenario.desktop.variation.preset = preset;
  scenario.desktop.seed = seed;
  addRoom(scenario, {0.0, 0.0}, {8.0, 4.0});
  addWall(scenario, {{4.0, 0.0}, {4.0, 4.0}});
  addGoal(scenario, 1, 3.0, 1.0);
  addGoal(scenario, 2, 1.0, 3.0);
  addGoal(scenario, 3, 7.0, 1.0);
  addPerson(scenario, 1, {3.3, 1.0}, {1, 2}).cyclicGoals = true;
  addPerson(scenario, 2, {3.3, 2.0}, {2, 1}).cyclicGoals = true;
  addPerson(scenario, 3, {4.7, 2.0}, {3});
  addPerson(scenario, 4, {6.0, 2.0}, {3});
  addPerson(scenario, 5, {1.0, 2.0}, {1});
  addRobot(scenario, {2.0, 3.2}, {1.0, 1.0});
  return scenario;
}

using Numbers = std::map<std::string, double>;

/// By person and key; nothing: there is no such world.
Numbers peopleOf(const Scenario& scenario) {
  const auto world = make(scenario);
  Numbers numbers;
  if (world) {
    for (const TraceHuman& human : world->header().humans) {
      for (const auto& [key, value] : human.parameters) {
        numbers[std::to_string(human.id) + " " + key] = value;
      }
    }
  }
  return numbers;
}

Vec2 startOf(const Numbers& numbers, int id) {
  const std::string person = std::to_string(id);
  return {numbers.at(person + " start_x"), numbers.at(person + " start_y")};
}

}  // namespace

/// People who differ from seed to seed: where they begin, and that nothing but the seed counts.
class StartVariationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void starts_manySeeds_areInFreePlacesOnTheirSideOfWalls() {
    std::map<int, std::set<double>> places;
    for (int seed = 1; seed <= 200; ++seed) {
      const Scenario scenario = rooms(VariationPreset::Strong, seed);
      const base::Result<std::unique_ptr<World>> world = create(scenario);
      QVERIFY(world);
      QVERIFY(world.diagnostics().empty());  // else a goal was left out or a start moved
      const Numbers numbers = peopleOf(scenario);
      for (const Human& human : scenario.humans) {
        const Vec2 place = startOf(numbers, human.id);
        const double left = human.initPose.position.x() < 4.0 ? 0.0 : 4.0;
        const double room = kRadius + kWall - kGrid;
        QVERIFY(place.x() > left + room && place.x() < left + 4.0 - room);
        QVERIFY(place.y() > room && place.y() < 4.0 - room);
        places[human.id].insert(place.x());
        QVERIFY((place - scenario.robots[0].start.position).norm() > kRadius + 0.35 - kOverlap);
        for (const Human& other : scenario.humans) {
          QVERIFY(other.id == human.id ||
                  (place - startOf(numbers, other.id)).norm() > 2.0 * kRadius - kOverlap);
        }
      }
    }
    for (const auto& [id, all] : places) {
      QVERIFY2(all.size() > 50, qPrintable(QStringLiteral("%1: %2").arg(id).arg(all.size())));
    }
  }

  /// A kilometre to either side of a room of 8 m: no person passes through the walls, and it does
  /// not take longer than a run.
  void starts_farWiderThanTheRoom_staysInIt() {
    QElapsedTimer clock;
    clock.start();
    for (int seed = 1; seed <= 20; ++seed) {
      Scenario scenario = rooms(VariationPreset::Strong, seed);
      SpreadSettings& start = scenario.desktop.variation.of(VariationQuantity::Start);
      start.kind = SpreadKind::Uniform;
      start.halfWidth = 1000.0;
      const Numbers numbers = peopleOf(scenario);
      QVERIFY(!numbers.empty());
      for (const Human& human : scenario.humans) {
        const Vec2 place = startOf(numbers, human.id);
        QVERIFY(place.x() > 0.0 && place.x() < 8.0 && place.y() > 0.0 && place.y() < 4.0);
      }
    }
    QVERIFY(clock.elapsed() < 20000);
  }

  void people_otherRobotPlannerModelOrderStep_areTheSame() {
    const Scenario scenario = rooms(VariationPreset::Strong, 7);
    const Numbers wanted = peopleOf(scenario);
    QVERIFY(!wanted.empty());
    const auto changed = [&](const std::function<void(Scenario&)>& change) {
      Scenario other = scenario;
      change(other);
      Numbers numbers = peopleOf(other);
      for (auto& [key, value] : numbers) {  // the body that a model gives people
        value = key.find(" radius") != std::string::npos ? kRadius : value;
      }
      return numbers;
    };
    QVERIFY(changed([](Scenario& of) { of.robots[0].planner = "dwa"; }) == wanted);
    QVERIFY(changed([](Scenario& of) { of.robots[0].type = "jackal"; }) == wanted);
    QVERIFY(changed([](Scenario& of) { of.robots[0].listed = false; }) == wanted);
    QVERIFY(changed([](Scenario& of) { of.desktop.model = "das"; }) == wanted);
    QVERIFY(changed([](Scenario& of) { of.desktop.dt = 0.02; }) == wanted);
    QVERIFY(changed([](Scenario& of) { std::reverse(of.humans.begin(), of.humans.end()); }) ==
            wanted);
    QVERIFY(changed([](Scenario& of) { of.desktop.seed = 8; }) != wanted);
  }

  void people_presetNone_areAsWritten() {
    Scenario plain = rooms(VariationPreset::None, 3);
    const auto none = make(plain);
    plain.desktop.variation = {};
    plain.desktop.seed = 4;
    const auto absent = make(plain);
    QVERIFY(none && absent);
    QVERIFY(none->header().humans[0].parameters == absent->header().humans[0].parameters);
    for (int step = 0; step < 100; ++step) {
      none->step();
      absent->step();
      QVERIFY(none->frame().humans.x == absent->frame().humans.x);
      QVERIFY(none->frame().humans.heading == absent->frame().humans.heading);
    }
    QCOMPARE(peopleOf(plain).count("1 reaction_time"), std::size_t{0});
  }

  void firstGoal_drawn_isWalkedToFirst() {
    std::set<int> first;
    for (int seed = 1; seed <= 20; ++seed) {
      Scenario scenario = rooms(VariationPreset::None, seed);
      scenario.desktop.variation.of(VariationQuantity::FirstGoal).kind = SpreadKind::Uniform;
      const auto world = make(scenario);
      QVERIFY(world);
      const TraceHuman person = world->header().humans[0];
      const std::vector<Recorded> events = advance(*world, 200);
      const auto reached = std::find_if(events.begin(), events.end(), [](const Recorded& each) {
        return each.event.kind == EventKind::Goal && each.event.id == 1;
      });
      QVERIFY(reached != events.end());
      QCOMPARE(reached->event.text, std::to_string(person.goals.front().id));
      first.insert(person.goals.front().id);
    }
    QCOMPARE(first, (std::set<int>{1, 2}));
  }

  void source_people_differInSpeed() {
    Scenario scenario = rooms(VariationPreset::Light, 2);
    Area source;
    source.name = "entry";
    source.kind = AreaKind::Source;
    source.points = {{5.0, 0.6}, {7.4, 0.6}, {7.4, 3.4}, {5.0, 3.4}};
    source.like = "person3";
    source.rate = 5.0;
    source.count = 4;
    scenario.areas.push_back(source);
    const auto world = make(scenario);
    QVERIFY(world);
    advance(*world, 400);
    std::set<double> speeds;
    for (const TraceHuman& human : world->header().humans) {
      if (human.name.rfind("entry_", 0) == 0) {
        QVERIFY(human.desiredSpeed >= 0.8 * 1.5 && human.desiredSpeed <= 1.2 * 1.5);
        speeds.insert(human.desiredSpeed);
      }
    }
    QVERIFY2(speeds.size() > 1, qPrintable(QString::number(speeds.size())));
  }

  void reactionTime_slow_setsOffLater_data() {
    QTest::addColumn<QString>("model");
    QTest::newRow("sfm") << "sfm";
    QTest::newRow("sfm-hunav2") << "sfm-hunav2";
    QTest::newRow("das") << "das";
  }

  /// With the relaxation rate k / tau the speed after t is v0 (1 - exp(-k t / tau)): who has twice
  /// the tau is slower while setting off.
  void reactionTime_slow_setsOffLater() {
    QFETCH(QString, model);
    std::map<double, double> speeds;  // after 0.2 s, by factor
    for (int seed = 1; seed <= 10; ++seed) {
      Scenario scenario;
      scenario.desktop.seed = seed;
      scenario.desktop.model = model.toStdString();
      scenario.desktop.variation.of(VariationQuantity::ReactionTime).kind = SpreadKind::Uniform;
      scenario.desktop.variation.of(VariationQuantity::ReactionTime).halfWidth = 0.8;
      addGoal(scenario, 1, 20.0, 0.0);
      addPerson(scenario, 1, {0.0, 0.0}, {1});
      const auto world = make(scenario);
      QVERIFY(world);
      const auto parameters = world->header().humans[0].parameters;
      const auto factor = std::find_if(parameters.begin(), parameters.end(), [](const auto& each) {
        return each.first == "reaction_time";
      });
      QVERIFY(factor != parameters.end());
      QCOMPARE(world->header().humans[0].desiredSpeed, 1.5);  // nothing else is drawn
      advance(*world, 4);
      speeds[factor->second] = world->frame().humans.vx[0];
    }
    QCOMPARE(speeds.size(), std::size_t{10});
    double before = 10.0;
    for (const auto& [factor, speed] : speeds) {
      QVERIFY2(speed < before && speed > 0.0, qPrintable(QString::number(factor)));
      before = speed;
    }
  }
};

QTEST_APPLESS_MAIN(StartVariationTest)
#include "tst_StartVariation.moc"
