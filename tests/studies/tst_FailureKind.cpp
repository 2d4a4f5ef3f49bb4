#include <QtTest>

#include "app/studies/FailureKind.h"

namespace {

app::ResultRow rowOf(const char* reason, const char* success, const char* bearing,
                     const char* distance, const char* speed) {
  app::ResultRow row;
  row.ok = true;
  row.reason = reason;
  row.simulated = "7.5";
  row.fields = {{"success", success},
                {"final_bearing_to_person", bearing},
                {"final_distance_to_person", distance},
                {"final_person_speed", speed}};
  return row;
}

}  // namespace

/// How failures are told apart.
class FailureKindTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void failedRun_kind_isThatOfItsEnd_data() {
    QTest::addColumn<QString>("reason");
    QTest::addColumn<QString>("bearing");
    QTest::addColumn<QString>("distance");
    QTest::addColumn<QString>("speed");
    QTest::addColumn<QString>("name");
    QTest::newRow("left") << "collision: robot1 with anna"
                          << "1.57"
                          << "-0.01"
                          << "1.2"
                          << "contact-left-moving";
    QTest::newRow("right") << "collision: robot1 with anna"
                           << "-1.57"
                           << "0"
                           << "0.1"
                           << "contact-right-standing";
    QTest::newRow("front, just") << "collision: robot1 with anna"
                                 << "-0.785"
                                 << "0"
                                 << "0.11"
                                 << "contact-front-moving";
    QTest::newRow("left, just") << "collision: robot1 with anna"
                                << "0.786"
                                << "0"
                                << "0.11"
                                << "contact-left-moving";
    QTest::newRow("behind") << "collision: robot1 with anna"
                            << "-2.36"
                            << "0"
                            << "1"
                            << "contact-behind-moving";
    QTest::newRow("obstacle") << "collision: robot1 with an obstacle"
                              << "0"
                              << "1"
                              << "1"
                              << "contact-obstacle";
    QTest::newRow("stuck") << "stuck: robot1"
                           << "0.2"
                           << "0.5"
                           << "0"
                           << "standstill-front-standing";
    QTest::newRow("alone") << "stuck: robot1"
                           << "0.2"
                           << "3.7"
                           << "0"
                           << "standstill-no-person";
    QTest::newRow("no people") << "duration"
                               << ""
                               << ""
                               << ""
                               << "time-no-person";
    QTest::newRow("navigator") << "navigation_failed: robot1, planner NO_VALID_PATH (208)"
                               << ""
                               << ""
                               << ""
                               << "failure-no-person";
    QTest::newRow("missed") << "goal_missed: robot1, 1.34 m from the goal"
                            << "3"
                            << "1"
                            << "0"
                            << "failure-behind-standing";
  }
  void failedRun_kind_isThatOfItsEnd() {
    QFETCH(QString, reason);
    QFETCH(QString, bearing);
    QFETCH(QString, distance);
    QFETCH(QString, speed);
    QFETCH(QString, name);
    const auto kind = app::failureKindOf(rowOf(qPrintable(reason), "False", qPrintable(bearing),
                                               qPrintable(distance), qPrintable(speed)));
    QVERIFY(kind.has_value());
    QCOMPARE(QString::fromStdString(kind->name()), name);
    QVERIFY(!kind->text().empty());
  }

  void contactThatDidNotEndTheRun_isAContact() {
    app::ResultRow row = rowOf("arrived", "False", "0.1", "2", "1");
    row.fields.emplace_back("person_on_robot_collision", "1");
    QCOMPARE(app::failureKindOf(row)->name(), std::string("contact-earlier"));
  }

  void otherRobot_collides_itsColumnsCount() {
    app::ResultRow row = rowOf("collision: robot2 with anna", "False", "0.1", "9", "1");
    row.fields.insert(row.fields.end(), {{"robot2.final_bearing_to_person", "-1.5"},
                                         {"robot2.final_distance_to_person", "0"},
                                         {"robot2.final_person_speed", "0"}});
    QCOMPARE(app::failureKindOf(row)->name(), std::string("contact-right-standing"));
  }

  void runsThatAreNoFailures_haveNoKind() {
    QVERIFY(!app::failureKindOf(rowOf("arrived", "True", "0.1", "2", "1")));
    app::ResultRow broken;
    broken.reason = "anna stands in a wall";
    QVERIFY(!app::failureKindOf(broken));
    QVERIFY(!app::wasSimulated(broken));
    broken.simulated = "3.2";  // the run broke off
    QCOMPARE(app::failureKindOf(broken)->name(), std::string("error-no-person"));
  }
};

QTEST_APPLESS_MAIN(FailureKindTest)
#include "tst_FailureKind.moc"
