#include <set>

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

using outside::bytesOf;
using outside::Finished;
using outside::runProgram;

namespace {

QString text(const char* words) {
  return QString::fromUtf8(words);
}

QString demo() {
  return QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
}

QString interop(const char* file) {
  const QString folder =
      qEnvironmentVariable("HUNAV_INTEROP_DIR", QStringLiteral(SOURCE_DIR "/../shared/interop"));
  return QDir(folder).absoluteFilePath(text(file));
}

QJsonObject metricsOf(const QString& folder) {
  return QJsonDocument::fromJson(bytesOf(folder + text("/metrics.json")))
      .object()
      .value(text("metrics"))
      .toObject();
}

double valueOf(const QJsonObject& metrics, const char* key) {
  return metrics.value(text(key)).toObject().value(text("value")).toDouble(-1e300);
}

bool write(const QString& path, const QByteArray& content) {
  QFile file(path);
  return file.open(QIODevice::WriteOnly) && file.write(content) == content.size();
}

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::acos(-1.0));
}

}  // namespace

/// `hunavsim evaluate` and `run --counterfactual` from outside.
class EvaluateProgramTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString path(const char* name) const { return folder_.filePath(text(name)); }

  /// A corridor 3 m wide: a person walks from left to right, a robot stands where it is put.
  QString corridor(const char* name, const char* robot) {
    const QString file = path(name);
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
    return write(file, content) ? file : QString();
  }

 private Q_SLOTS:
  void evaluate_runFolder_equalsRun_data() {
    QTest::addColumn<QStringList>("scenario");
    QTest::addColumn<QStringList>("options");
    const QStringList shipped{demo(), text("--duration"), text("20")};
    QTest::newRow("demo") << shipped << QStringList();
    QTest::newRow("hunav2") << shipped << QStringList{text("--metrics-profile"), text("hunav2")};
    QTest::newRow("keys") << shipped
                          << QStringList{text("--metrics"), text("path_length,spl,social_work")};
    QTest::newRow("house") << QStringList{interop("hunavsim2/gazebo_classic/scenarios/"
                                                  "agents_house.yaml"),
                                          text("--map"),
                                          interop("hunavsim2/gazebo_classic/maps/house.yaml"),
                                          text("--duration"),
                                          text("15"),
                                          text("--robot-start"),
                                          text("0 0 0"),
                                          text("--robot-goal"),
                                          text("2 1")}
                           << QStringList();
  }
  void evaluate_runFolder_equalsRun() {
    QFETCH(QStringList, scenario);
    QFETCH(QStringList, options);
    if (!QFile::exists(scenario.front())) {
      QSKIP("the files of the original are not here (HUNAV_INTEROP_DIR)");
    }
    const QString run = path(QTest::currentDataTag());
    const QString again = run + text("-again");
    const Finished made =
        runProgram(QStringList{text("run")} + scenario + options + QStringList{text("-o"), run});
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    const Finished evaluated =
        runProgram(QStringList{text("evaluate"), run, text("-o"), again} + options);
    QVERIFY2(evaluated.exitCode == 0, qPrintable(evaluated.err));
    for (const char* name : {"/metrics.json", "/metrics.csv", "/steps.csv"}) {
      QVERIFY2(!bytesOf(run + text(name)).isEmpty(), name);
      QVERIFY2(bytesOf(run + text(name)) == bytesOf(again + text(name)), name);
    }
  }

  void evaluate_settingsOfTheScenario_areInTheRecord() {
    QVERIFY(write(path("own.yaml"),
                  "hunavsim_metrics:\n  ros__parameters:\n    fast: {expression: "
                  "\"integral(speed > 0.3)\", unit: s}\n"));
    QByteArray scenario = bytesOf(demo());
    QFile::copy(QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe.yaml"),
                path("corner_cafe.yaml"));
    QFile::copy(QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe.pgm"),
                path("corner_cafe.pgm"));
    scenario +=
        "    metrics:\n      from: motion\n      frequency: 5.0\n      tag: mine\n"
        "      file: own.yaml\n      parameters:\n        goal_tolerance: 0.7\n";
    QVERIFY(write(path("corner_cafe_agents.yaml"), scenario));
    const Finished made = runProgram({text("run"), path("corner_cafe_agents.yaml"),
                                      text("--duration"), text("8"), text("-o"), path("set")});
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    const Finished evaluated =
        runProgram({text("evaluate"), path("set"), text("-o"), path("set-again")});
    QVERIFY2(evaluated.exitCode == 0, qPrintable(evaluated.err));
    QVERIFY(bytesOf(path("set/metrics.csv")).contains(",fast"));
    QVERIFY(bytesOf(path("set/metrics.csv")).contains("\nmine,"));
    QCOMPARE(bytesOf(path("set/metrics.json")), bytesOf(path("set-again/metrics.json")));
  }

  void evaluate_layouts_appendRows() {
    QVERIFY(write(path("walk.csv"), "t,ped,px,py\n0,1,0,0\n1,1,1,0\n2,1,2,0\n0,2,5,5\n1,2,5,5\n"));
    QStringList words{text("evaluate"), path("walk.csv"),  text("-o"),
                      path("layout"),   text("--columns"), text("time=t,id=ped,x=px,y=py"),
                      text("--robot"),  text("1"),         text("--robot-goal"),
                      text("2 0"),      text("--tag"),     text("real"),
                      text("--layout"), text("hunav2"),    text("--run-id")};
    for (const char* id : {"3", "4"}) {
      const Finished finished = runProgram(words + QStringList{text(id)});
      QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    }
    const auto rows = outside::readCsv(path("layout/metrics.csv"));
    QCOMPARE(rows.size(), std::size_t{2});
    QCOMPARE(rows[1].at(text("run_id")), text("4"));
    QCOMPARE(rows[1].at(text("experiment_tag")), text("real"));
    QCOMPARE(rows[1].at(text("path_length")), text("2.0"));
    QCOMPARE(rows[1].at(text("completed")), text("True"));
    QVERIFY(QFile::exists(path("layout/metrics_steps_real_4.csv")));
    words[words.indexOf(text("hunav2"))] = text("hunav1");
    QCOMPARE(runProgram(words + QStringList{text("5")}).exitCode, 0);
    QVERIFY(bytesOf(path("layout/metrics.txt")).startsWith("experiment_tag\t"));
    // What was read is a record that can be measured again.
    const Finished again =
        runProgram({text("evaluate"), path("layout"), text("-o"), path("layout-again")});
    QVERIFY2(again.exitCode == 0, qPrintable(again.err));
    QCOMPARE(valueOf(metricsOf(path("layout-again")), "path_length"), 2.0);
  }

  void evaluate_zara_distancesRecomputed() {
    const QString file = interop("trajectories/zara01/obsmat.txt");
    if (!QFile::exists(file)) {
      QSKIP("the recordings are not here (HUNAV_INTEROP_DIR)");
    }
    const int robot = 10;
    const Finished finished =
        runProgram({text("evaluate"), file, text("-o"), path("zara"), text("--robot"),
                    QString::number(robot), text("--fps"), text("25")});
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    // Rows by frame, read by code of this test.
    std::map<int, std::map<int, std::pair<double, double>>> rows;
    for (const QByteArray& line : bytesOf(file).split('\n')) {
      const QStringList words =
          QString::fromLatin1(line).split(QLatin1Char(' '), Qt::SkipEmptyParts);
      if (words.size() == 8) {
        rows[static_cast<int>(words[0].toDouble())][static_cast<int>(words[1].toDouble())] = {
            words[2].toDouble(), words[4].toDouble()};
      }
    }
    double smallest = 1e300;
    double sum = 0.0;
    double samples = 0.0;
    double intimate = 0.0;
    double personal = 0.0;
    double withPeople = 0.0;
    for (const auto& [frame, people] : rows) {
      const auto self = people.find(robot);
      if (self == people.end()) {
        continue;
      }
      double closest = 1e300;
      for (const auto& [id, place] : people) {
        if (id != robot) {
          const double dx = place.first - self->second.first;
          const double dy = place.second - self->second.second;
          closest = std::min(closest, std::max(std::sqrt(dx * dx + dy * dy) - 0.7, 0.0));
        }
      }
      samples += 1.0;
      intimate += closest < 0.45 ? 1.0 : 0.0;
      personal += closest >= 0.45 && closest < 1.2 ? 1.0 : 0.0;
      if (closest < 1e299) {
        withPeople += 1.0;
        sum += closest;
        smallest = std::min(smallest, closest);
      }
    }
    const QJsonObject metrics = metricsOf(path("zara"));
    QVERIFY(samples > 20.0);
    const auto near = [&](const char* key, double expected) {
      const double actual = valueOf(metrics, key);
      return std::fabs(actual - expected) <= 1e-9 * std::max(1.0, expected);
    };
    QVERIFY(near("minimum_distance_to_people", smallest));
    QVERIFY(near("avg_distance_to_closest_person", sum / withPeople));
    QVERIFY(near("intimate_space_intrusions", 100.0 * intimate / samples));
    QVERIFY(near("personal_space_intrusions", 100.0 * personal / samples));
  }

  void evaluate_badInput_isTold_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("told");
    QVERIFY(write(path("bad.csv"), "time,id,x,y\n0,1,nan,0\n"));
    QVERIFY(write(path("good.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,0\n"));
    QVERIFY(QDir(folder_.path()).mkpath(text("empty")));
    const auto row = [this](const char* name, const char* source, const QStringList& more,
                            int exitCode, const char* told) {
      QTest::newRow(name) << (QStringList{text("evaluate"), path(source), text("-o"), path("out")} +
                              more)
                          << exitCode << text(told);
    };
    row("missing", "none.csv", {}, 2, "none.csv");
    row("empty folder", "empty", {}, 2, "trajectory.csv");
    row("nan", "bad.csv", {}, 2, "bad.csv:2:5: error: x");
    row("nobody", "good.csv", {text("--robot"), text("9")}, 2, "nobody has the id 9");
    row("columns", "good.csv", {text("--columns"), text("tme=t")}, 64, "tme");
    row("fps", "good.csv", {text("--fps"), text("0")}, 64, "--fps");
    row("goal", "good.csv", {text("--robot-goal"), text("1")}, 64, "--robot-goal");
    row("format", "good.csv", {text("--format"), text("xls")}, 64, "--format");
    row("key", "good.csv", {text("--metrics"), text("path_lenght")}, 64, "path_length");
    row("foreign words", "empty", {text("--robot"), text("1")}, 64, "--robot");
    row("one sample", "good.csv", {text("--robot"), text("1"), text("--dt"), text("5")}, 0, "");
  }
  void evaluate_badInput_isTold() {
    QFETCH(QStringList, words);
    QFETCH(int, exitCode);
    QFETCH(QString, told);
    const Finished finished = runProgram(words);
    QVERIFY2(finished.exitCode == exitCode, qPrintable(finished.err));
    QVERIFY2(finished.err.contains(told), qPrintable(finished.err));
  }

  void counterfactual_robotFarAway_isExactlyZero() {
    const QString scenario = corridor("far.yaml", "{x: 0.0, y: 25.0, h: 0.0}");
    const Finished finished =
        runProgram({text("run"), scenario, text("--counterfactual"), text("-o"), path("far")});
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    const auto rows = outside::readCsv(path("far/counterfactual.csv"));
    QCOMPARE(rows.size(), std::size_t{1});
    for (const auto& [column, value] : rows[0]) {
      QVERIFY2(column == text("id") || value == text("0"), qPrintable(column + value));
    }
    const QJsonObject metrics = metricsOf(path("far"));
    QCOMPARE(valueOf(metrics, "counterfactual_detour"), 0.0);
    QCOMPARE(valueOf(metrics, "counterfactual_heading_disturbance"), 0.0);
  }

  void counterfactual_robotInTheWay_equalsRecomputation() {
    const QString scenario = corridor("block.yaml", "{x: 5.0, y: 0.05, h: 0.0}");
    const QString alone = corridor("alone.yaml", "{x: 5.0, y: 0.05, h: 0.0}");
    QByteArray without = bytesOf(alone);
    without.replace("    robots: [robot1]\n", "");
    QVERIFY(write(alone, without));
    const Finished finished =
        runProgram({text("run"), scenario, text("--counterfactual"), text("-o"), path("block")});
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    QVERIFY(bytesOf(path("block/metrics.csv")).contains("counterfactual_delay"));
    QCOMPARE(runProgram({text("run"), alone, text("-o"), path("alone")}).exitCode, 0);
    const auto row = outside::readCsv(path("block/counterfactual.csv")).at(0);
    const auto told = [&row](const char* column) { return row.at(text(column)).toDouble(); };
    const auto goalTime = [](const QString& folder) {
      for (const auto& event : outside::readCsv(folder + text("/events.csv"))) {
        if (event.at(text("kind")) == text("goal")) {
          return event.at(text("time")).toDouble();
        }
      }
      return -1.0;
    };
    const auto with = outside::readTrajectory(path("block/trajectory.csv"));
    const auto bare = outside::readTrajectory(path("alone/trajectory.csv"));
    QCOMPARE(with.size(), bare.size());
    const auto length = [](const std::vector<outside::Sample>& samples, double end) {
      double sum = 0.0;
      for (std::size_t k = 1; k < samples.size() && samples[k].time < end + 1e-6; ++k) {
        const outside::Body& a = samples[k - 1].people.at(0);
        const outside::Body& b = samples[k].people.at(0);
        sum += std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
      }
      return sum;
    };
    const double end = goalTime(path("block"));
    const double endAlone = goalTime(path("alone"));
    QVERIFY(end > 0.0 && endAlone > 0.0);
    double force = 0.0;
    double turned = 0.0;
    double slowed = 0.0;
    for (std::size_t k = 0; k < with.size(); ++k) {
      const outside::Body& a = with[k].people.at(0);
      const outside::Body& b = bare[k].people.at(0);
      turned += std::fabs(wrapped(a.heading - b.heading)) / static_cast<double>(with.size());
      if (k > 0) {
        const outside::Body& a0 = with[k - 1].people.at(0);
        const outside::Body& b0 = bare[k - 1].people.at(0);
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
    QCOMPARE(valueOf(metricsOf(path("block")), "counterfactual_delay"), told("delay"));
  }
};

QTEST_GUILESS_MAIN(EvaluateProgramTest)
#include "tst_EvaluateProgram.moc"
