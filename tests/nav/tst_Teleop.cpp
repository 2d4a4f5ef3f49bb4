#include <cmath>
#include <thread>

#include <QtTest>

#include "sim2d/nav/Teleop.h"
#include "tests/nav/DriveWorld.h"
#include "tests/nav/MetaTypes.h"
#include "tests/nav/PlannerFunctions.h"

using drive::robotBody;
using drive::World;
using namespace sim2d;

namespace {

struct Driven {
  explicit Driven(Kinematics kinematics,
                  std::vector<std::pair<std::string, double>> parameters = {})
      : planner(drive::planner(addTeleop, robotBody(kinematics), std::move(parameters))),
        input(dynamic_cast<TeleopPlanner&>(*planner).input()),
        world(robotBody(kinematics), {Vec2::Zero(), 0.0}, Vec2(50.0, 0.0)) {}

  BodyTwist commandNow() {
    world.step(*planner);
    return world.commands().back();
  }

  std::shared_ptr<Planner> planner;
  std::shared_ptr<TeleopInput> input;
  World world;
};

}  // namespace

class TeleopTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void command_nothingSaid_stands() {
    Driven driven(Kinematics::Differential);
    QVERIFY(driven.commandNow() == BodyTwist{});
    QVERIFY(driven.planner->path().empty());
  }

  void command_drive_isTheTwist() {
    Driven driven(Kinematics::Differential);
    driven.input->drive({0.4, -0.7});
    QVERIFY(driven.commandNow() == (BodyTwist{0.4, -0.7}));
    driven.input->drive({-0.2, 0.0, 0.5});
    QVERIFY(driven.commandNow() == (BodyTwist{-0.2, 0.0}));  // this drive cannot go sideways
    Driven omni(Kinematics::Omnidirectional);
    omni.input->drive({-0.2, 0.0, 0.5});
    QVERIFY(omni.commandNow() == (BodyTwist{-0.2, 0.0, 0.5}));
  }

  void command_speedShare_cutsSpeedAndTurn() {
    Driven driven(Kinematics::Differential, {{"speed_share", 0.5}});
    driven.input->drive({0.9, 1.4});  // of 1 m/s and 1.5 rad/s
    QVERIFY(driven.commandNow() == (BodyTwist{0.5, 0.75}));
    driven.input->driveTo(Vec2(20.0, 0.0));
    QVERIFY(std::fabs(driven.commandNow().linear - 0.5) < 1e-12);
  }

  void command_newestWord_counts() {
    Driven driven(Kinematics::Differential);
    driven.input->driveTo(Vec2(3.0, 0.0));
    driven.input->drive({0.1, 0.2});
    QVERIFY(driven.commandNow() == (BodyTwist{0.1, 0.2}));
    driven.input->driveTo(Vec2(0.0, 3.0));
    const BodyTwist turning = driven.commandNow();
    QVERIFY(turning.linear == 0.0 && turning.angular > 0.0);
    QCOMPARE(driven.planner->path().size(), std::size_t{2});
    driven.input->release();
    QVERIFY(driven.commandNow() == BodyTwist{});
  }

  void command_afterTheTimeout_stands() {
    Driven driven(Kinematics::Differential, {{"timeout", 0.3}});
    driven.input->drive({0.4, 0.0});
    int steps = 0;
    while (driven.commandNow().linear > 0.0 && steps < 100) {
      ++steps;
    }
    QCOMPARE(steps, 7);  // at 0, 0.05 … 0.3 s
  }

  void command_timeoutZero_goesOn() {
    Driven driven(Kinematics::Differential, {{"timeout", 0.0}});
    driven.input->drive({0.4, 0.0});
    for (int i = 0; i < 1000; ++i) {
      QVERIFY(driven.commandNow().linear == 0.4);
    }
  }

  void command_sameWordAgain_startsTheTimeAnew() {
    Driven driven(Kinematics::Differential, {{"timeout", 0.3}});
    for (int i = 0; i < 20; ++i) {
      driven.input->drive({0.4, 0.0});
      for (int k = 0; k < 5; ++k) {
        QVERIFY(driven.commandNow().linear == 0.4);
      }
    }
  }

  void command_pointAhead_isTheArcThroughIt() {
    Driven driven(Kinematics::Differential);
    driven.input->driveTo(Vec2(3.0, 1.0));
    const BodyTwist twist = driven.commandNow();
    // The circle that touches the x axis in the origin and passes (3, 1): r = (9 + 1) / 2.
    QVERIFY(std::fabs(twist.linear - 1.0) < 1e-12);
    QVERIFY(std::fabs(twist.angular - 0.2) < 1e-9);
  }

  void headFor_point_arrivesAndStands_data() {
    QTest::addColumn<Kinematics>("kinematics");
    QTest::addColumn<QPointF>("point");
    for (const Kinematics kinematics :
         {Kinematics::Differential, Kinematics::Omnidirectional, Kinematics::Ackermann}) {
      for (const QPointF& point : {QPointF(3.0, 0.5), QPointF(0.5, 0.6), QPointF(-2.0, -1.0),
                                   QPointF(-1.0, 0.0), QPointF(0.2, -0.3)}) {
        QTest::addRow("%s, %g, %g", kinematicsName(kinematics), point.x(), point.y())
            << kinematics << point;
      }
    }
  }

  void headFor_point_arrivesAndStands() {
    QFETCH(Kinematics, kinematics);
    QFETCH(QPointF, point);
    Driven driven(kinematics, {{"timeout", 0.0}});
    const Vec2 place(point.x(), point.y());
    driven.input->driveTo(place);
    for (int i = 0; i < 500; ++i) {
      driven.commandNow();
    }
    QVERIFY(driven.world.isGood());
    const double left = (driven.world.observation().pose.position - place).norm();
    QVERIFY2(left < 0.1, QByteArray::number(left));
    QVERIFY(driven.commandNow() == BodyTwist{});
  }

  void say_fromOtherThreads_isHeardWhole() {
    TeleopInput input;
    std::thread one([&] {
      for (int i = 0; i < 20000; ++i) {
        input.drive({1.0, 1.0, 1.0});
      }
    });
    std::thread other([&] {
      for (int i = 0; i < 20000; ++i) {
        input.drive({2.0, 2.0, 2.0});
      }
    });
    bool isWhole = true;
    for (int i = 0; i < 20000; ++i) {
      const TeleopInput::Command wish = input.latest();
      isWhole = isWhole && wish.twist.linear == wish.twist.angular &&
                wish.twist.linear == wish.twist.lateral;
    }
    one.join();
    other.join();
    QVERIFY(isWhole);
    QCOMPARE(input.latest().number, std::uint64_t{40000});
  }
};

QTEST_GUILESS_MAIN(TeleopTest)
#include "tst_Teleop.moc"
