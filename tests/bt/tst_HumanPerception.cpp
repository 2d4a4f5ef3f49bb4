#include <cmath>

#include <QtTest>

#include "bt/human/Goals.h"
#include "bt/human/HumanContext.h"
#include "bt/human/Motions.h"
#include "bt/human/Perception.h"
#include "tests/bt/FakeWorld.h"

class HumanPerceptionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void isRobotVisible_byDistanceAndBearing_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("distance");
    QTest::addColumn<bool>("expected");
    QTest::newRow("ahead") << 2.0 << 0.0 << 5.0 << true;
    QTest::newRow("exactly at the distance") << 2.0 << 0.0 << 2.0 << true;
    QTest::newRow("too far") << 2.0 << 0.0 << 1.99 << false;
    // half of the field of view is 99.74 degrees
    QTest::newRow("99 degrees") << std::cos(1.728) << std::sin(1.728) << 5.0 << true;
    QTest::newRow("-99 degrees") << std::cos(1.728) << -std::sin(1.728) << 5.0 << true;
    QTest::newRow("100 degrees") << std::cos(1.7453) << std::sin(1.7453) << 5.0 << false;
    QTest::newRow("behind") << -1.0 << 0.0 << 5.0 << false;
  }
  void isRobotVisible_byDistanceAndBearing() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, distance);
    QFETCH(bool, expected);
    FakeWorld world;
    world.addPerson(1, 0.0, 0.0, 0.0);
    world.addRobot(x, y);
    QCOMPARE(bt::isRobotVisible(world, 0, distance), expected);
  }

  void isRobotVisible_withoutRobot_isFalse() {
    FakeWorld world;
    world.addPerson(1, 0.0, 0.0);
    QVERIFY(!bt::isRobotVisible(world, 0, 100.0));
    QVERIFY(std::isinf(bt::robotDistance(world, 0)));
  }

  void sightAndSound_behindWall_areBlocked() {
    FakeWorld world;
    world.addPerson(1, 0.0, 0.0);
    world.addPerson(2, 2.0, 0.0, base::kPi);
    world.addRobot(1.0, 0.0);
    QVERIFY(bt::isRobotVisible(world, 0, 5.0));
    QVERIFY(bt::isAudible(world, 0, 1, 5.0));
    QVERIFY(bt::isAgentVisible(world, 1, 0, 5.0, 0.2));
    world.isDark = true;
    QVERIFY(!bt::isRobotVisible(world, 0, 5.0));
    QVERIFY(!bt::isAgentVisible(world, 0, 1, 5.0, base::kPi));
    QVERIFY(!bt::isAgentVisible(world, 1, 0, 5.0, 0.2));
    QVERIFY(!bt::isAudible(world, 0, 1, 5.0));
  }

  void isRobotFacing_atAnyDistance_byAngle() {
    FakeWorld world;
    world.addPerson(1, 50.0, 0.0);
    world.addRobot(0.0, 0.0, 0.29);
    QVERIFY(bt::isRobotFacing(world, 0));
    world.robots[0].pose.heading = 0.31;
    QVERIFY(!bt::isRobotFacing(world, 0));
  }

  void nearestPerson_ofEqualDistances_isSmallestId() {
    FakeWorld world;
    world.addPerson(1, 0.0, 0.0);
    world.addPerson(9, 1.0, 0.0);
    world.addPerson(4, -1.0, 0.0);
    world.addPerson(2, 0.5, 0.0);
    QCOMPARE(bt::nearestAgent(world, 0), 3);
    world.at(3).isPresent = false;
    QCOMPARE(bt::nearestAgent(world, 0), 2);
  }

  void speechBus_wordsOfOneStep_areHeardInTheNext() {
    bt::SpeechBus bus;
    bus.say(1, 0, "one");
    QVERIFY(bus.audibleUtterances().empty());
    bus.beginStep();
    bus.say(2, 1, "two");
    QCOMPARE(bus.audibleUtterances().size(), std::size_t(1));
    bus.beginStep();
    QCOMPARE(bus.audibleUtterances().size(), std::size_t(2));
    QVERIFY(bus.audibleUtterances().front().text == "two");
    bus.forget(1);
    QVERIFY(bus.audibleUtterances().front().text == "one");
  }

  void parseIds_ofLists_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QList<int>>("ids");
    QTest::addColumn<bool>("isList");
    QTest::newRow("one") << QStringLiteral("2") << QList<int>{2} << true;
    QTest::newRow("blanks") << QStringLiteral(" 2 , 3,,5x") << QList<int>{2, 3, 5} << true;
    QTest::newRow("empty") << QString() << QList<int>{} << true;
    QTest::newRow("word") << QStringLiteral("2,all") << QList<int>{} << false;
  }
  void parseIds_ofLists() {
    QFETCH(QString, text);
    QFETCH(QList<int>, ids);
    QFETCH(bool, isList);
    const std::optional<std::vector<int>> found = bt::parseIds(text.toStdString());
    QCOMPARE(found.has_value(), isList);
    if (found) {
      QCOMPARE(QList<int>(found->begin(), found->end()), ids);
    }
  }

  void circleSpots_ofTwo_areOppositeAndClosestFirst() {
    FakeWorld world;
    world.addPerson(1, -2.0, 0.0, 0.0);
    world.addPerson(2, 3.0, 0.0, base::kPi);
    const std::vector<bt::FormationSpot> spots =
        bt::assignCirclePositions(world, {0, 1}, base::Vec2(0.0, 0.0));
    QCOMPARE(spots.size(), std::size_t(2));
    // radius 0.5 + 0.2: person 1 on the left, person 2 on the right
    QVERIFY((spots[0].position - base::Vec2(-0.7, 0.0)).norm() < 1e-12);
    QVERIFY((spots[1].position - base::Vec2(0.7, 0.0)).norm() < 1e-12);
  }

  void circleSpots_ofFour_haveRadius1point1() {
    FakeWorld world;
    for (int i = 0; i < 4; ++i) {
      world.addPerson(i, i, 5.0, 0.3);
    }
    for (const bt::FormationSpot& spot :
         bt::assignCirclePositions(world, {0, 1, 2, 3}, base::Vec2(1.0, 1.0))) {
      QVERIFY(std::fabs((spot.position - base::Vec2(1.0, 1.0)).norm() - 1.1) < 1e-12);
    }
  }
};

QTEST_APPLESS_MAIN(HumanPerceptionTest)
#include "tst_HumanPerception.moc"
