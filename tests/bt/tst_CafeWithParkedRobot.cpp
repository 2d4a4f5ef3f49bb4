#include <QtTest>

#include "sim2d/trace/Recording.h"
#include "tests/bt/ShippedScenario.h"
#include "tests/support/TraceHash.h"

using namespace shipped;

/// The demo goes on for long after its robot has arrived: nobody runs into it. All seeds and two
/// minutes with HUNAV_ALL_TESTS alone.
class CafeWithParkedRobotTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void people_doNotTouchTheRobot_data();
  void people_doNotTouchTheRobot();
  void original_walksAsItDid_data();
  void original_walksAsItDid();
};

namespace {

bool isLong() {
  return qEnvironmentVariableIsSet("HUNAV_ALL_TESTS");
}

/// Seeds above 0 draw the forces: with those of the file all seeds are alike.
std::shared_ptr<const sim2d::Scenario> withSeed(const sim2d::Scenario& original, int seed,
                                                const std::string& model) {
  auto scenario = std::make_shared<sim2d::Scenario>(original);
  scenario->desktop.seed = seed;
  scenario->desktop.model = model;
  for (sim2d::Human& human : scenario->humans) {
    human.behavior.configuration =
        seed > 0 ? sim2d::Configuration::Normal : human.behavior.configuration;
  }
  return scenario;
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

void CafeWithParkedRobotTest::people_doNotTouchTheRobot_data() {
  QTest::addColumn<QString>("model");
  QTest::addColumn<int>("seed");
  const int seeds = isLong() ? 10 : 0;
  for (const std::string& name : sim2d::programRegistries().models.names()) {
    for (int seed = 0; seed <= seeds && name != "sfm-hunav2"; ++seed) {
      QTest::addRow("%s %d", name.c_str(), seed) << QString::fromStdString(name) << seed;
    }
  }
}

void CafeWithParkedRobotTest::people_doNotTouchTheRobot() {
  QFETCH(QString, model);
  QFETCH(int, seed);
  Loaded cafe = loadAsWritten("corner_cafe", "corner_cafe_agents");
  cafe.scenario = withSeed(*cafe.scenario, seed, model.toStdString());
  const std::unique_ptr<sim2d::World> world = makeWorld(cafe);
  QVERIFY(world != nullptr);
  const double seconds = isLong() ? 120.0 : 60.0;
  int goals = 0;
  while (world->time() < seconds && world->step()) {
    for (const sim2d::Event& event : world->frame().events) {
      const bool isOfRobot = event.kind == sim2d::EventKind::Contact && event.id < 0;
      QVERIFY2(!isOfRobot || !event.hasOther,
               qPrintable(QStringLiteral("%1 s, person %2: %3")
                              .arg(world->time())
                              .arg(event.other)
                              .arg(QString::fromStdString(event.text))));
      goals += event.kind == sim2d::EventKind::Goal && event.id > 0 ? 1 : 0;
    }
  }
  QVERIFY2(world->failure().empty(), world->failure().c_str());
  QVERIFY2(world->arrivedAt().has_value(), placesNearRobot(world->frame()));
  if (isLong()) {
    qInfo("arrived after %.1f s, %d goals", *world->arrivedAt(), goals);
  }
  QVERIFY2(goals > seconds / 2.0, qPrintable(QString::number(goals)));  // they get on
}

void CafeWithParkedRobotTest::original_walksAsItDid_data() {
  QTest::addColumn<QString>("compatibility");
  QTest::addColumn<qulonglong>("hash");
  // Of 60 s, before people gave way to robots.
  QTest::newRow("quirks") << "hunav2" << qulonglong(0x837ce96cc0065502ULL);
  QTest::newRow("model") << "" << qulonglong(0x5c66656b41a01860ULL);
}

/// Where everybody was.
void CafeWithParkedRobotTest::original_walksAsItDid() {
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

QTEST_APPLESS_MAIN(CafeWithParkedRobotTest)
#include "tst_CafeWithParkedRobot.moc"
