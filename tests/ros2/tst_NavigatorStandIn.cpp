#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/ros2/NavigatorStandIn.h"

using namespace ros2test;

namespace {

constexpr int kDomain = 34;

QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

bool write(const QString& path, const QByteArray& content) {
  QFile file(path);
  return file.open(QIODevice::WriteOnly) && file.write(content) == content.size();
}

/// 10 m x 6 m with a wall from below between start and goal, and somebody who walks to and fro.
bool writeScene(const QString& folder) {
  constexpr int kWidth = 100, kHeight = 60;
  QByteArray pixels = "P5\n100 60\n255\n";
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const bool isBorder = row < 1 || row >= kHeight - 1 || column < 1 || column >= kWidth - 1;
      const bool isWall = column >= 50 && column < 52 && row >= 25;
      pixels += isBorder || isWall ? '\0' : '\xfe';
    }
  }
  return write(folder + text("/hall.pgm"), pixels) &&
         write(folder + text("/hall.yaml"),
               "image: hall.pgm\nresolution: 0.1\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
               "occupied_thresh: 0.65\nfree_thresh: 0.25\n") &&
         write(folder + text("/scene.yaml"),
               "hunav_loader:\n  ros__parameters:\n    yaml_base_name: scene\n    agents: [anna]\n"
               "    anna:\n      id: 1\n      skin: 0\n      group_id: -1\n      max_vel: 1.0\n"
               "      radius: 0.3\n      init_pose: {x: 4.0, y: 5.0, z: 1.0, h: 0.0}\n"
               "      behavior: {type: Regular, configuration: 2}\n"
               "      goal_radius: 0.3\n      cyclic_goals: true\n      goals: [1, 2]\n"
               "    global_goals:\n      1: {x: 7.0, y: 5.0, h: 0.0}\n"
               "      2: {x: 3.0, y: 5.0, h: 0.0}\n"
               "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n"
               "    map_file: hall.yaml\n    robots: [robot1]\n    robot1:\n"
               "      start: {x: 2.0, y: 1.5, h: 0.0}\n      goal: {x: 8.0, y: 1.5}\n"
               "      planner: ros2\n      lidar: {beams: 120, rate: 10.0}\n");
}

}  // namespace

/// A navigator of others, over the wire, brings our robot to its goal.
class NavigatorStandInTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void lockstep_reachesTheGoal_twiceWithEqualBytes() {
    QTemporaryDir folder;
    QVERIFY(writeScene(folder.path()));
    for (const char* name : {"first", "second"}) {
      drive(folder.path(), folder.filePath(text(name)));
      if (QTest::currentTestFailed()) {
        return;
      }
    }
    for (const char* file : {"trajectory.csv", "events.csv", "inputs.csv"}) {
      const QByteArray one = bytesOf(folder.filePath(text("first/") + text(file)));
      QVERIFY(!one.isEmpty());
      QCOMPARE(bytesOf(folder.filePath(text("second/") + text(file))), one);
    }
  }

 private:
  static void drive(const QString& folder, const QString& out) {
    NavigatorStandIn navigator(kDomain);
    QProcess run;
    run.start(
        text(HUNAVSIM_PROGRAM),
        {text("run"), folder + text("/scene.yaml"), text("--ros2"), text("--domain"),
         QString::number(kDomain), text("--lockstep"), text("--stamped"), text("--ros2-send-goals"),
         text("--speed"), text("20"), text("--duration"), text("40"), text("-q"), text("-o"), out});
    QVERIFY(run.waitForStarted());
    navigator.spinUntil([&] {
      QCoreApplication::processEvents();
      return run.state() == QProcess::NotRunning;
    });
    const QByteArray said = run.readAllStandardError();
    QVERIFY2(run.exitCode() == 0 && run.state() == QProcess::NotRunning, said.constData());
    QVERIFY2(!said.contains("warning"), said.constData());  // nothing late, nothing refused
    QCOMPARE(navigator.goals(), 1);
    QVERIFY(navigator.hasArrived());
    QVERIFY(bytesOf(out + text("/events.csv")).contains(",arrived,-1,"));
  }
};

QTEST_GUILESS_MAIN(NavigatorStandInTest)
#include "tst_NavigatorStandIn.moc"
