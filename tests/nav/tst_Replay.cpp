#include <cmath>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/nav/VelocityRecording.h"
#include "tests/nav/DriveWorld.h"
#include "tests/nav/PlannerFunctions.h"

using drive::robotBody;
using drive::World;
using namespace sim2d;

namespace {

QStringList problemsOf(const std::string& text, int robot = -1) {
  QStringList found;
  const base::Result<VelocityRecording> record = parseVelocities(text, "drive.csv", robot);
  for (const base::Diagnostic& problem : record.diagnostics()) {
    found << QString::fromStdString(problem.text());
  }
  return record ? QStringList() : found;
}

/// The file written into the test's folder.
std::string writtenFile(const QTemporaryDir& folder, const std::string& text) {
  std::string path = folder.filePath(QStringLiteral("drive.csv")).toStdString();
  base::writeFileAtomically(path, text);
  return path;
}

base::Result<std::shared_ptr<Planner>> replayOf(const std::string& file, double robot = -1.0) {
  PlannerRegistry registry;
  addReplay(registry);
  PlannerSetup setup;
  setup.robot = "anna";
  setup.body = robotBody(Kinematics::Differential);
  setup.parameters = {{"robot", robot}};
  setup.texts = {{"file", file}};
  return registry.find("replay")->make(setup);
}

}  // namespace

class ReplayTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void at_betweenRows_holdsTheLast() {
    const base::Result<VelocityRecording> record = parseVelocities(
        "time,linear,angular,lateral\n1,0.5,0.1,0\n2,0.25,-0.5,0.75\n4,1,0,0\n", "drive.csv", -1);
    QVERIFY(record);
    QVERIFY(record->at(0.9) == BodyTwist{});
    QVERIFY(record->at(1.0) == (BodyTwist{0.5, 0.1}));
    QVERIFY(record->at(1.99) == (BodyTwist{0.5, 0.1}));
    QVERIFY(record->at(2.0 - 1e-12) == (BodyTwist{0.25, -0.5, 0.75}));  // 40 * 0.05
    QVERIFY(record->at(3.9) == (BodyTwist{0.25, -0.5, 0.75}));
    QVERIFY(record->at(5.9) == (BodyTwist{1.0, 0.0}));  // as long as the one before: 2 s
    QVERIFY(record->at(6.0) == BodyTwist{});
  }

  void at_oneRow_holdsForGood() {
    const base::Result<VelocityRecording> record =
        parseVelocities("time,linear,angular\n0,0.5,0.1", "drive.csv", -1);
    QVERIFY(record);
    QVERIFY(record->at(1000.0) == (BodyTwist{0.5, 0.1}));
  }

  void parse_columnsInAnyOrderAndLineEnds_isTheSame() {
    const base::Result<VelocityRecording> record =
        parseVelocities("angular, time, linear\r\n 0.5, 0, 1\r\n\r\n-0.5,1,2\r\n", "drive.csv", -1);
    QVERIFY(record);
    QCOMPARE(record->rows.size(), std::size_t{2});
    QVERIFY(record->at(0.5) == (BodyTwist{1.0, 0.5}));
    QVERIFY(record->at(1.5) == (BodyTwist{2.0, -0.5}));
  }

  void parse_trajectory_isTheRobotsVelocities() {
    const std::string text =
        "step,time,id,kind,x,y,heading,vx,vy,omega,group,state,goal\n"
        "0,0,1,human,5,5,0,1,0,0,-1,walking,1\n"
        "0,0,-1,robot,0,0,0,0.25,0,0,-1,,\n"
        "0,0,-2,robot,3,3,0,9,9,9,-1,,\n"
        "1,0.5,1,human,5,5,0,1,0,0,-1,\"a,b\",1\n"
        "1,0.5,-1,robot,0,0,1.5707963267948966,0,0.5,0,-1,,\n"
        "1,0.5,-2,robot,3,3,0,9,9,9,-1,,\n"
        "2,1,-1,robot,0,0,3.141592653589793,-0.75,0.25,0,-1,,\n";
    base::Result<VelocityRecording> record = parseVelocities(text, "trajectory.csv", -1);
    QVERIFY(record);
    QCOMPARE(record->rows.size(), std::size_t{2});
    // The velocity with which it came to a row acts from the row before.
    QVERIFY(std::fabs(record->at(0.0).linear - 0.5) < 1e-12);
    QVERIFY(std::fabs(record->at(0.0).lateral) < 1e-12);
    QVERIFY(std::fabs(record->at(0.5).linear - 0.75) < 1e-12);
    QVERIFY(std::fabs(record->at(0.5).lateral + 0.25) < 1e-12);
    QVERIFY(record->at(1.0) == BodyTwist{});
    record = parseVelocities(text, "trajectory.csv", -2);
    QVERIFY(record && record->at(0.2).angular == 9.0);
    QCOMPARE(
        problemsOf(text, -3),
        QStringList(QStringLiteral("drive.csv: error: there is no robot -3 in this trajectory")));
  }

  void parse_badRows_areAllTold() {
    const QStringList found =
        problemsOf("time,linear,angular\n0,0.5,x\n1,nan,inf\n0.5,0,0\n0.5,1,1\n2,1\n3,1,2,4\n");
    const QStringList expected = {
        QStringLiteral("drive.csv:2:7: error: angular is not a finite number: 'x'"),
        QStringLiteral("drive.csv:3:3: error: linear is not a finite number: 'nan'"),
        QStringLiteral("drive.csv:3:7: error: angular is not a finite number: 'inf'"),
        QStringLiteral("drive.csv:5:1: error: time does not increase"),
        QStringLiteral("drive.csv:6:3: error: the line has 2 fields instead of 3"),
        QStringLiteral("drive.csv:7:7: error: the line has 4 fields instead of 3")};
    QVERIFY2(found == expected, qPrintable(found.join(QLatin1Char('\n'))));
  }

  void parse_badFirstLine_isRefused() {
    for (const char* const line : {"", "time,linear", "0,1,2", "time,linear,angular,speed",
                                   "step,time,id,kind,x,y,heading,vx,vy"}) {
      const QStringList found = problemsOf(std::string(line) + "\n0,0,0\n");
      QCOMPARE(found.size(), 1);
      QVERIFY2(found.front().startsWith(QStringLiteral("drive.csv:1:1: error: the first line")),
               qPrintable(found.front()));
    }
  }

  void parse_nothingInIt_isRefused() {
    QCOMPARE(problemsOf("time,linear,angular\n"),
             QStringList(QStringLiteral("drive.csv: error: the file contains no velocities")));
  }

  void make_badFiles_areErrors() {
    const base::Result<std::shared_ptr<Planner>> none = replayOf("");
    QVERIFY(!none);
    QCOMPARE(none.diagnostics().front().code, std::string_view("replay.no-file"));
    QVERIFY(QString::fromStdString(none.diagnostics().front().text())
                .contains(QStringLiteral("robot 'anna'")));
    QVERIFY(!replayOf("/nowhere/drive.csv"));
    QTemporaryDir folder;
    const base::Result<std::shared_ptr<Planner>> bad =
        replayOf(writtenFile(folder, "time,linear,angular\n0,a,b\n"));
    QCOMPARE(bad.diagnostics().size(), std::size_t{2});
  }

  void command_ownRecord_drivesTheSameWay() {
    // Along arcs, with what a run would write of it.
    World first(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.3}, Vec2(50.0, 0.0));
    QTemporaryDir folder;
    const std::string plain =
        writtenFile(folder, "time,linear,angular\n0,0.8,0.5\n1,0.4,-0.9\n2,0,0\n");
    base::Result<std::shared_ptr<Planner>> planner = replayOf(plain);
    QVERIFY(planner);
    std::string text = "step,time,id,kind,x,y,heading,vx,vy,omega\n0,0,-1,robot,0,0,0.3,0,0,0\n";
    for (int i = 1; i <= 60; ++i) {
      const Vec2 before = first.observation().pose.position;
      first.step(**planner);
      const Pose2& pose = first.observation().pose;
      const double v = first.observation().motion.linear;
      const Vec2 chord = pose.position - before;
      const Vec2 velocity = chord.isZero(0.0) ? Vec2(Vec2::Zero()) : Vec2(v * chord.normalized());
      for (const double value : {0.05 * i, -1.0}) {
        text += (value < 0.0 ? "" : std::to_string(i) + ",") + base::formatDouble(value) + ",";
      }
      text += "robot,0,0," + base::formatDouble(pose.heading) + "," +
              base::formatDouble(velocity.x()) + "," + base::formatDouble(velocity.y()) + "," +
              base::formatDouble(first.observation().motion.angular) + "\n";
    }
    World second(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.3}, Vec2(50.0, 0.0));
    planner = replayOf(writtenFile(folder, text));
    QVERIFY(planner);
    for (int i = 0; i < 60; ++i) {
      second.step(**planner);
    }
    const Vec2 difference = second.observation().pose.position - first.observation().pose.position;
    QVERIFY(first.observation().pose.position.norm() > 0.9);
    QVERIFY2(difference.norm() < 1e-6, QByteArray::number(difference.norm()));
    second.step(**planner);
    QVERIFY(second.commands().back() == BodyTwist{});
  }
};

QTEST_GUILESS_MAIN(ReplayTest)
#include "tst_Replay.moc"
