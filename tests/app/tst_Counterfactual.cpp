#include <QDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

QByteArray personText(int id, double x, double y, int behavior, const QByteArray& goals) {
  const QByteArray name = "walker" + QByteArray::number(id);
  return "    " + name + ":\n      id: " + QByteArray::number(id) +
         "\n      skin: 0\n      group_id: " + (id % 5 == 0 ? "1" : "-1") +
         "\n      max_vel: 1.2\n      radius: 0.3\n      init_pose: {x: " +
         QByteArray::number(x, 'f', 3) + ", y: " + QByteArray::number(y, 'f', 3) +
         ", z: 1.0, h: 0.0}\n      behavior: {type: " + QByteArray::number(behavior) +
         ", configuration: 0, duration: 40.0, once: true, vel: 0.6, dist: 2.5, "
         "goal_force_factor: 2.0, obstacle_force_factor: 10.0, social_force_factor: 5.0, "
         "other_force_factor: 20.0}\n      goal_radius: 0.3\n      cyclic_goals: true\n"
         "      goals: " +
         goals + "\n";
}

/// When the first goal was reached; -1: none was.
double goalTime(const QString& folder) {
  for (const auto& event : readCsv(folder + text("/events.csv"))) {
    if (event.at(text("kind")) == text("goal")) {
      return event.at(text("time")).toDouble();
    }
  }
  return -1.0;
}

/// Of the first person's way until the end [m].
double length(const std::vector<Sample>& samples, double end) {
  double sum = 0.0;
  for (std::size_t k = 1; k < samples.size() && samples[k].time < end + 1e-6; ++k) {
    const Body& a = samples[k - 1].people.at(0);
    const Body& b = samples[k].people.at(0);
    sum += std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
  }
  return sum;
}

}  // namespace

/// `hunavsim run --counterfactual` from outside.
class CounterfactualTest : public QObject, protected InFolder {
  Q_OBJECT

 private:
  /// A corridor 3 m wide: a person walks from left to right, a robot stands where it is put.
  QString corridor(const char* name, const char* robot) {
    QString file = path(name);
    const QByteArray content =
        QByteArray(
            "hunav_loader:\n  ros__parameters:\n    agents: [walker]\n    walker:\n"
            "      id: 1\n      skin: 0\n      group_id: -1\n      max_vel: 1.2\n"
            "      radius: 0.3\n      init_pose: {x: 0.0, y: 0.0, z: 1.0, h: 0.0}\n"
            "      behavior: {type: 1, configuration: 0, duration: 40.0, once: true, "
            "vel: 0.6, dist: 2.5, goal_force_factor: 2.0, obstacle_force_factor: 10.0, "
            "social_force_factor: 5.0, other_force_factor: 20.0}\n"
            "      goal_radius: 0.3\n      cyclic_goals: false\n      goals: [1]\n"
            "    global_goals:\n      1: {x: 10.0, y: 0.0, h: 0.0}\n"
            "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n    map_file: none\n"
            "    duration: 20.0\n    robots: [robot1]\n    robot1:\n      start: ") +
        robot + "\n    obstacles: [low, high]\n" +
        "    low: {kind: wall, xs: [-3.0, 13.0], ys: [-1.5, -1.5]}\n"
        "    high: {kind: wall, xs: [-3.0, 13.0], ys: [1.5, 1.5]}\n";
    writeText(file, content);
    return file;
  }

  /// A crowd of all behaviours that crosses itself on an open plane.
  QString crowd(const char* name, int people, const QByteArray& robot) {
    QByteArray names;
    QByteArray bodies;
    for (int k = 0; k < people; ++k) {
      const int row = k / 6;
      names += (k > 0 ? ", walker" : "walker") + QByteArray::number(k + 1);
      bodies += personText(k + 1, 1.1 * (k % 6) - 3.0, 1.1 * row - 3.0, 1 + k % 6,
                           k % 2 == 0 ? "[1, 2]" : "[2, 1]");
    }
    const QByteArray content =
        "hunav_loader:\n  ros__parameters:\n    agents: [" + names + "]\n" + bodies +
        "    global_goals:\n      1: {x: 6.0, y: 0.3, h: 0.0}\n"
        "      2: {x: -6.0, y: 0.1, h: 0.0}\n"
        "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n    map_file: none\n"
        "    duration: 12.0\n    robots: [robot1]\n    robot1:\n      start: " +
        robot + "\n";
    writeText(path(name), content);
    return path(name);
  }

 private Q_SLOTS:
  void robotFarFromACrowd_isExactlyZero_data() {
    QTest::addColumn<int>("people");
    QTest::addColumn<QByteArray>("robot");
    const QByteArray stands("{x: 71.3, y: -40.9, h: 0.4}");
    const QByteArray drives = stands + "\n      goal: {x: 79.0, y: -44.0}";
    QTest::newRow("few") << 5 << stands;
    QTest::newRow("crowd") << 30 << stands;
    QTest::newRow("large crowd") << 66 << stands;
    QTest::newRow("crowd, it drives") << 30 << drives;
    QTest::newRow("large crowd, it drives") << 66 << drives;
  }
  void robotFarFromACrowd_isExactlyZero() {
    QFETCH(int, people);
    QFETCH(QByteArray, robot);
    const QString scenario = crowd("crowd.yaml", people, robot);
    QCOMPARE(failureOf("run % --counterfactual -o %", {scenario, path("crowd")}), QString());
    const auto rows = readCsv(path("crowd/counterfactual.csv"));
    QCOMPARE(rows.size(), static_cast<std::size_t>(people));
    for (const auto& row : rows) {
      for (const auto& [column, value] : row) {
        QVERIFY2(column == text("id") || value == text("0"),
                 qPrintable(row.at(text("id")) + text(" ") + column + text(" ") + value));
      }
    }
  }

  void robotFarAway_isExactlyZero() {
    const QString scenario = corridor("far.yaml", "{x: 0.0, y: 25.0, h: 0.0}");
    QCOMPARE(failureOf("run % --counterfactual -o %", {scenario, path("far")}), QString());
    const auto rows = readCsv(path("far/counterfactual.csv"));
    QCOMPARE(rows.size(), std::size_t{1});
    for (const auto& [column, value] : rows[0]) {
      QVERIFY2(column == text("id") || value == text("0"), qPrintable(column + value));
    }
    QCOMPARE(valueOf(metricsOf(path("far")), text("counterfactual_detour")), 0.0);
    QCOMPARE(valueOf(metricsOf(path("far")), text("counterfactual_heading_disturbance")), 0.0);
  }

  void robotInTheWay_equalsRecomputation() {
    const QString scenario = corridor("block.yaml", "{x: 5.0, y: 0.05, h: 0.0}");
    const QString alone = corridor("alone.yaml", "{x: 5.0, y: 0.05, h: 0.0}");
    QByteArray without = bytesOf(alone);
    without.replace("    robots: [robot1]\n", "");
    writeText(alone, without);
    QCOMPARE(failureOf("run % --counterfactual -o %", {scenario, path("block")}), QString());
    QVERIFY(bytesOf(path("block/metrics.csv")).contains("counterfactual_delay"));
    QCOMPARE(runProgram("run % -o %", {alone, path("alone")}).exitCode, 0);
    const auto row = readCsv(path("block/counterfactual.csv")).at(0);
    const auto told = [&row](const char* column) { return row.at(text(column)).toDouble(); };
    const auto with = readTrajectory(path("block/trajectory.csv"));
    const auto bare = readTrajectory(path("alone/trajectory.csv"));
    QCOMPARE(with.size(), bare.size());
    const double end = goalTime(path("block"));
    const double endAlone = goalTime(path("alone"));
    QVERIFY(end > 0.0 && endAlone > 0.0);
    double force = 0.0;
    double turned = 0.0;
    double slowed = 0.0;
    for (std::size_t k = 0; k < with.size(); ++k) {
      const Body& a = with[k].people.at(0);
      const Body& b = bare[k].people.at(0);
      turned += std::fabs(turn(a.heading - b.heading)) / static_cast<double>(with.size());
      if (k > 0) {
        const Body& a0 = with[k - 1].people.at(0);
        const Body& b0 = bare[k - 1].people.at(0);
        const double x = (a.vx - a0.vx) - (b.vx - b0.vx);
        const double y = (a.vy - a0.vy) - (b.vy - b0.vy);
        force += std::sqrt(x * x + y * y);
        const bool isSlower =
            std::sqrt(a.vx * a.vx + a.vy * a.vy) < std::sqrt(b.vx * b.vx + b.vy * b.vy) - 0.1;
        slowed += isSlower ? 0.05 : 0.0;
      }
    }
    const auto near = [](double a, double b) { return std::fabs(a - b) < 1e-6; };
    QVERIFY(near(told("delay"), end - endAlone) && end > endAlone);
    QVERIFY(near(told("detour"), length(with, end) - length(bare, endAlone)));
    QVERIFY(told("detour") > 0.0);
    QVERIFY(near(told("extra_force"), force) && force > 0.0);
    QVERIFY(near(told("heading_disturbance"), turned) && turned > 0.0);
    QVERIFY(near(told("slowed_time"), slowed));
    QCOMPARE(valueOf(metricsOf(path("block")), text("counterfactual_delay")), told("delay"));
  }
};

QTEST_GUILESS_MAIN(CounterfactualTest)
#include "tst_Counterfactual.moc"
