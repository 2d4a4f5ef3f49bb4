#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <QElapsedTimer>
#include <QtTest>

#include "sim2d/base/Rng.h"
#include "tests/nav/DriveWorld.h"
#include "tests/nav/PlannerFunctions.h"

using namespace sim2d;

/// What one decision of `dwa` costs with 400 samples, 20 people and 200 edges of walls near.
class DwaBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void command_amongPeopleAndWalls_data();
  void command_amongPeopleAndWalls();
};

namespace {

constexpr int kSteps = 400;

/// Columns of 8 edges each at both sides of a way along x.
std::vector<Outline> columnsBeside() {
  std::vector<Outline> columns;
  for (int i = 0; i < 25; ++i) {
    const Vec2 place(-2.0 + 0.5 * i, i % 2 == 0 ? 1.6 : -1.6);
    columns.push_back(circleOutline(place, 0.2, 8));
  }
  return columns;
}

std::vector<TrackedBody> peopleAround() {
  const base::AgentRng random(1, 0);
  std::vector<TrackedBody> people;
  for (int i = 0; i < 20; ++i) {
    const auto draw = static_cast<std::uint32_t>(4 * i);
    const double angle = random.uniform(-base::kPi, base::kPi, base::DrawPurpose::Test, draw);
    const double speed = i % 3 == 0 ? 0.0 : 1.0;
    const Vec2 place(random.uniform(1.0, 5.0, base::DrawPurpose::Test, draw + 1),
                     random.uniform(-3.0, 3.0, base::DrawPurpose::Test, draw + 2));
    people.push_back(drive::person(i, place, speed * Vec2(std::cos(angle), std::sin(angle))));
  }
  return people;
}

}  // namespace

void DwaBench::command_amongPeopleAndWalls_data() {
  QTest::addColumn<int>("kinematics");
  QTest::addColumn<bool>("isPolygon");
  QTest::newRow("differential, disc") << static_cast<int>(Kinematics::Differential) << false;
  QTest::newRow("differential, polygon") << static_cast<int>(Kinematics::Differential) << true;
  QTest::newRow("omnidirectional, disc") << static_cast<int>(Kinematics::Omnidirectional) << false;
  QTest::newRow("ackermann, disc") << static_cast<int>(Kinematics::Ackermann) << false;
}

void DwaBench::command_amongPeopleAndWalls() {
  QFETCH(int, kinematics);
  QFETCH(bool, isPolygon);
  RobotBody body = drive::robotBody(static_cast<Kinematics>(kinematics));
  if (isPolygon) {
    body.footprint.corners = {Vec2(-0.35, -0.2), Vec2(0.35, -0.2), Vec2(0.35, 0.2),
                              Vec2(-0.35, 0.2)};
  }
  drive::World world(body, {Vec2::Zero(), 0.0}, Vec2(9.0, 0.0), columnsBeside());
  world.observation().bodies = peopleAround();
  const std::shared_ptr<Planner> dwa = drive::planner(addDwa, body);
  std::vector<double> times;
  for (int i = 0; i < kSteps; ++i) {
    if (world.distanceLeft() < 1.0) {
      world.observation().pose = {Vec2::Zero(), 0.0};
    }
    if (i % 100 == 0) {
      world.observation().bodies = peopleAround();
    }
    QElapsedTimer timer;
    timer.start();
    world.step(*dwa);
    times.push_back(1e-3 * static_cast<double>(timer.nsecsElapsed()));
  }
  std::sort(times.begin(), times.end());
  const auto share = [&](double part) {
    return times[static_cast<std::size_t>(part * (kSteps - 1))];
  };
  qInfo("decision: median %.0f us, 95 %% %.0f us, most %.0f us", share(0.5), share(0.95),
        share(1.0));
  QTest::setBenchmarkResult(share(0.5) * 1e3, QTest::WalltimeNanoseconds);
}

QTEST_GUILESS_MAIN(DwaBench)
#include "bench_Dwa.moc"
