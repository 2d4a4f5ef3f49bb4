#include <map>
#include <string>

#include <QtTest>

#include "sim2d/trace/Recording.h"
#include "tests/bt/ShippedScenario.h"
#include "tests/support/TraceHash.h"

using namespace shipped;

namespace {

constexpr const char* kGoRound[] = {"dwa", "mppi", "social_mppi"};

bool isLong() {
  return qEnvironmentVariableIsSet("HUNAV_ALL_TESTS");
}

/// Seed 0: as it is written, else with the people that the seed draws.
Loaded cafeWith(const std::string& planner, const std::string& model, int seed) {
  Loaded cafe = seed > 0 ? load("corner_cafe", "corner_cafe_agents")
                         : loadAsWritten("corner_cafe", "corner_cafe_agents");
  auto scenario = std::make_shared<sim2d::Scenario>(*cafe.scenario);
  scenario->desktop.seed = seed;
  scenario->desktop.model = model;
  scenario->robots.front().planner = planner;
  cafe.scenario = scenario;
  return cafe;
}

std::unique_ptr<sim2d::World> makeWith(Loaded& loaded, const sim2d::Compatibility& compatibility) {
  sim2d::WorldSetup setup;
  setup.scenario = loaded.scenario;
  setup.map = loaded.map;
  setup.compatibility = compatibility;
  setup.behavior =
      bt::makeTreeBehavior(*loaded.scenario, loaded.trees, loaded.diagnostics, compatibility);
  base::Result<std::unique_ptr<sim2d::World>> world = sim2d::World::create(std::move(setup));
  return world ? *std::move(world) : nullptr;
}

/// Where the robot and those near it are.
QByteArray placesNearRobot(const sim2d::Frame& frame) {
  const base::Pose2 robot = robotPoseOf(frame);
  QByteArray text = QByteArray::number(robot.position.x()) + " " +
                    QByteArray::number(robot.position.y()) + " " +
                    QByteArray::number(robot.heading);
  for (std::size_t i = 0; i < frame.humans.size(); ++i) {
    const base::Pose2 person = poseOf(frame, i);
    if ((person.position - robot.position).norm() < 2.5) {
      text += ", person " + QByteArray::number(frame.humans.id[i]) + ": " +
              QByteArray::number(person.position.x()) + " " +
              QByteArray::number(person.position.y());
    }
  }
  return text;
}

}  // namespace

/// The demo goes on for long after its robot has arrived: nobody runs into it. Ten more seeds with
/// each planner that goes round people, two minutes each, with HUNAV_ALL_TESTS alone.
class CafeWithParkedRobotTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void people_doNotTouchTheRobot_data() {
    QTest::addColumn<QString>("planner");
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("seed");
    const auto add = [](const char* planner, const std::string& model, int seed) {
      QTest::addRow("%s %s %d", planner, model.c_str(), seed)
          << QString::fromUtf8(planner) << QString::fromStdString(model) << seed;
    };
    for (const std::string& model : sim2d::builtinRegistries().models.names()) {
      if (model == "sfm-hunav2") {
        continue;  // there they push, as in the original
      }
      add("pursuit", model, 0);
      for (const char* planner : kGoRound) {
        for (int seed = 1; isLong() && seed <= 10; ++seed) {
          add(planner, model, seed);
        }
      }
    }
  }

  void people_doNotTouchTheRobot() {
    QFETCH(QString, planner);
    QFETCH(QString, model);
    QFETCH(int, seed);
    Loaded cafe = cafeWith(planner.toStdString(), model.toStdString(), seed);
    const std::unique_ptr<sim2d::World> world = makeWorld(cafe);
    QVERIFY(world != nullptr);
    const double seconds = isLong() ? 120.0 : 60.0;
    int goals = 0;
    QByteArray contacts;
    while (world->time() < seconds && world->step()) {
      for (const sim2d::Event& event : world->frame().events) {
        if (event.kind == sim2d::EventKind::Contact && event.id < 0 && event.hasOther) {
          const QByteArray text = QByteArray::number(world->time()) + " s, person " +
                                  QByteArray::number(event.other) + ": " + event.text.c_str();
          QVERIFY2(seed > 0 && !world->arrivedAt(), text);  // never once it is parked
          contacts += "; " + text;
        }
        goals += event.kind == sim2d::EventKind::Goal && event.id > 0 ? 1 : 0;
      }
    }
    QVERIFY2(world->failure().empty(), world->failure().c_str());
    QVERIFY2(seed > 0 || world->arrivedAt().has_value(), placesNearRobot(world->frame()));
    QVERIFY2(goals > seconds / 2.0, QByteArray::number(goals));  // they get on
    if (seed > 0) {
      Count& count = counts_[planner.toStdString()];
      ++count.runs;
      count.arrived += world->arrivedAt() ? 1 : 0;
      count.contacts += contacts.isEmpty() ? 0 : 1;
      qInfo("arrived after %.1f s, %d goals%s", world->arrivedAt().value_or(-1.0), goals,
            contacts.constData());
    }
  }

  void robot_reachesItsGoal_data() {
    QTest::addColumn<QString>("planner");
    for (const char* planner : kGoRound) {
      QTest::newRow(planner) << QString::fromUtf8(planner);
    }
  }

  void robot_reachesItsGoal() {
    QFETCH(QString, planner);
    const Count& count = counts_[planner.toStdString()];
    if (!isLong()) {
      QSKIP("30 runs of two minutes: with HUNAV_ALL_TESTS alone");
    }
    qInfo("%d of %d arrived, %d touched somebody on the way", count.arrived, count.runs,
          count.contacts);
    QCOMPARE(count.runs, 30);
    QVERIFY(count.arrived >= 0.95 * count.runs);
  }

  void original_walksAsItDid_data() {
    QTest::addColumn<QString>("compatibility");
    QTest::addColumn<qulonglong>("hash");
    // Of 60 s, before people gave way to robots.
    QTest::newRow("quirks") << "hunav2" << qulonglong(0x837ce96cc0065502ULL);
    QTest::newRow("model") << "" << qulonglong(0x5c66656b41a01860ULL);
  }

  /// Where everybody was.
  void original_walksAsItDid() {
    QFETCH(QString, compatibility);
    QFETCH(qulonglong, hash);
    Loaded cafe = loadAsWritten("corner_cafe", "corner_cafe_agents");
    auto scenario = std::make_shared<sim2d::Scenario>(*cafe.scenario);
    scenario->desktop.model = "sfm-hunav2";
    scenario->robots.front().detector.kind = sim2d::DetectorKind::GroundTruth;  // as it was
    sim2d::Compatibility quirks;
    if (!compatibility.isEmpty()) {  // as `run --compat` does
      quirks = *sim2d::Compatibility::parse(compatibility.toStdString());
      scenario->desktop.route = sim2d::Route::Direct;
    }
    cafe.scenario = scenario;
    const std::unique_ptr<sim2d::World> world = makeWith(cafe, quirks);
    QVERIFY(world != nullptr);
    sim2d::Recording recording(1);
    sim2d::run(*world, sim2d::stopRuleOf(*cafe.scenario), recording);
    sim2d::Trace trace = recording.trace(world->header());
    trace.events.clear();
    QCOMPARE(qulonglong(sim2d::hashOf(trace)), hash);
  }

 private:
  struct Count {
    int runs = 0, arrived = 0, contacts = 0;
  };
  std::map<std::string, Count> counts_;  // by planner, of the long runs
};

QTEST_APPLESS_MAIN(CafeWithParkedRobotTest)
#include "tst_CafeWithParkedRobot.moc"
