#include <QtTest>

#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

Area& addZone(Scenario& scenario, double x0, double x1) {
  Area area;
  area.name = "zone" + std::to_string(scenario.areas.size() + 1);
  area.kind = AreaKind::Speed;
  area.points = {{x0, -2.0}, {x1, -2.0}, {x1, 2.0}, {x0, 2.0}};
  scenario.areas.push_back(area);
  return scenario.areas.back();
}

/// A person who walks from x = 0 to x = 30 at 1.2 m/s.
Scenario walker(const QString& model) {
  Scenario scenario;
  scenario.desktop.model = model.toStdString();
  scenario.desktop.mapFile = "none";
  addGoal(scenario, 1, 30.0, 0.0);
  addPerson(scenario, 1, Vec2(0.0, 0.0), {1}).maxVel = 1.2;
  return scenario;
}

/// Speed when the person is at this place.
double speedAt(World& world, double x) {
  for (int step = 0; step < 4000 && world.frame().humans.x[0] < x; ++step) {
    world.step();
  }
  return world.frame().humans.vx[0];
}

void addModels() {
  QTest::addColumn<QString>("model");
  for (const char* model : {"sfm", "das", "orca", "sfm-hunav2"}) {
    QTest::newRow(model) << QString::fromLatin1(model);
  }
}

}  // namespace

/// Areas in which people walk slower or are carried, with every model.
class SpeedZonesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void stairs_slowPeopleInside_data() { addModels(); }
  void stairs_slowPeopleInside() {
    QFETCH(QString, model);
    Scenario scenario = walker(model);
    addZone(scenario, 6.0, 12.0).factor = 0.5;
    const auto world = make(scenario);
    QVERIFY(std::fabs(speedAt(*world, 5.0) - 1.2) < 0.05);
    QVERIFY(std::fabs(speedAt(*world, 11.0) - 0.6) < 0.05);
    QVERIFY(std::fabs(speedAt(*world, 20.0) - 1.2) < 0.05);
  }

  void travelator_carriesPeopleWhoStand_data() { addModels(); }
  void travelator_carriesPeopleWhoStand() {
    QFETCH(QString, model);
    Scenario scenario;
    scenario.desktop.model = model.toStdString();
    addPerson(scenario, 1, Vec2(8.0, 1.0));  // without a goal
    Area& belt = addZone(scenario, 6.0, 14.0);
    belt.carrySpeed = 0.75;
    belt.carryHeading = 0.0;
    const auto world = make(scenario);
    const auto wait = [&world](int steps) {
      for (int step = 0; step < steps; ++step) {
        world->step();
      }
      return world->frame().humans.x[0];
    };
    const double early = wait(80);  // 4 s: the person stands on the belt
    QVERIFY(early > 10.0 && early < 11.0);
    const double moved = wait(40) - early;  // 2 s
    QVERIFY2(std::fabs(moved - 1.5) < 0.02, std::to_string(moved).c_str());
    const double last = wait(300);  // beyond the end of the belt
    QVERIFY(last > 13.9 && last < 14.6);
    QVERIFY(std::fabs(world->frame().humans.vx[0]) < 1e-3);
  }

  void travelator_addsItsSpeed_data() { addModels(); }
  void travelator_addsItsSpeed() {
    QFETCH(QString, model);
    Scenario along = walker(model);
    addZone(along, 6.0, 14.0).carrySpeed = 0.75;
    QVERIFY(std::fabs(speedAt(*make(along), 13.0) - 1.95) < 0.05);
    Scenario against = walker(model);
    Area& belt = addZone(against, 6.0, 14.0);
    belt.carrySpeed = 0.75;
    belt.carryHeading = 3.14159265358979;
    QVERIFY(std::fabs(speedAt(*make(against), 13.0) - 0.45) < 0.05);
  }

  void zone_thatIsNotListed_hasNoEffect() {
    Scenario plain = walker(QStringLiteral("sfm"));
    Scenario unlisted = plain;
    Area& zone = addZone(unlisted, 6.0, 12.0);
    zone.factor = 0.5;
    zone.listed = false;
    QCOMPARE(speedAt(*make(unlisted), 11.0), speedAt(*make(plain), 11.0));
  }
};

QTEST_APPLESS_MAIN(SpeedZonesTest)
#include "tst_SpeedZones.moc"
