#include <algorithm>
#include <map>

#include <QImage>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

#include "sim2d/scenario/ScenarioFile.h"
#include "tests/app/RunRecomputation.h"

using namespace outside;

/// `hunavsim run` from outside: files, numbers, invariants.
class RunProgramTest : public QObject, protected InFolder {
  Q_OBJECT

 private:
  Finished runFor5s(const char* scenario, const char* to) {
    return runProgram("run % --duration 5 -o %", {text(scenario), path(to)});
  }
  QJsonValue ofManifest(const char* run, const char* key) const {
    return readJson(path(run) + text("/manifest.json")).value(text(key));
  }

  /// Robot start and goal: two global goals of the file, the start where most room is.
  static QStringList robotWords(const sim2d::Scenario& scenario) {
    for (const sim2d::Robot& robot : scenario.robots) {
      if (robot.listed) {
        return {};
      }
    }
    const auto room = [&scenario](const sim2d::GlobalGoal& goal) {
      double least = 1e300;
      for (const sim2d::Human& human : scenario.humans) {
        if (human.listed) {
          least = std::min(least, (human.initPose.position - goal.position).norm());
        }
      }
      return least;
    };
    sim2d::GlobalGoal from = scenario.goals.front(), to = scenario.goals.front();
    for (const sim2d::GlobalGoal& place : scenario.goals) {
      from = room(place) > room(from) ? place : from;
    }
    for (const sim2d::GlobalGoal& place : scenario.goals) {
      to = (place.position - from.position).norm() > (to.position - from.position).norm() ? place
                                                                                          : to;
    }
    const sim2d::Vec2 start = from.position;
    const sim2d::Vec2 goal = to.position;
    const auto digits = [](double number) { return QString::number(number, 'g', 17); };
    return {text("--robot-start"),
            digits(start.x()) + QLatin1Char(' ') + digits(start.y()) + text(" 0"),
            text("--robot-goal"), digits(goal.x()) + QLatin1Char(' ') + digits(goal.y())};
  }

  /// Of the robot's way: it ends at its arrival.
  static void compareMetrics(Run run, const QString& folder) {
    for (const auto& row : readCsv(folder + text("/events.csv"))) {
      const bool isRobots = row.at(text("id")) == text("-1");
      if (isRobots && row.at(text("kind")) == text("arrived")) {
        run.samples.resize(row.at(text("step")).toUInt() + 1);
        run.hasArrived = true;
        break;
      }
    }
    for (const auto& [key, expected] : recompute(run)) {
      const QJsonValue value = run.metrics[key].toObject()[text("value")];
      const double found = value.isBool() ? (value.toBool() ? 1.0 : 0.0) : value.toDouble(-1e9);
      QVERIFY2(std::fabs(found - expected) <= 1e-9 * std::max(1.0, std::fabs(expected)),
               qPrintable(text("%1: %2, recomputed %3").arg(key).arg(found).arg(expected)));
    }
  }

  static void checkOverlaps(const Run& run) {
    double deepest = 0;
    for (const Sample& sample : run.samples) {
      std::vector<Body> bodies = sample.people;
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::size_t j = i + 1; j < bodies.size(); ++j) {
          const double reach = run.radius.at(bodies[i].id) + run.radius.at(bodies[j].id);
          deepest = std::max(deepest,
                             reach - hypot2(bodies[i].x - bodies[j].x, bodies[i].y - bodies[j].y));
        }
        if (sample.robot) {
          deepest = std::max(deepest, -run.gap(sample, bodies[i]));
        }
      }
    }
    QVERIFY2(deepest <= 0.05, qPrintable(text("overlap of %1 m").arg(deepest)));
  }

  /// Centres are never in a cell of the map that is dark in the picture file itself.
  static void checkWalls(const Run& run, const QString& mapYaml) {
    const QString text = QString::fromUtf8(bytesOf(mapYaml));
    const auto field = [&text](const char* key) {
      const QRegularExpression line(QString::fromLatin1(key) + QStringLiteral(":\\s*(\\S.*)"));
      return line.match(text).captured(1).trimmed();
    };
    const QString folder = QFileInfo(mapYaml).absolutePath() + QLatin1Char('/');
    const QImage image(folder + field("image"));
    QVERIFY2(!image.isNull(), qPrintable(mapYaml));
    const double resolution = field("resolution").toDouble();
    const QStringList origin =
        field("origin").remove(QLatin1Char('[')).remove(QLatin1Char(']')).split(QLatin1Char(','));
    for (const Sample& sample : run.samples) {
      for (const Body& person : sample.people) {
        const int column =
            static_cast<int>(std::floor((person.x - origin[0].toDouble()) / resolution));
        const int row =
            static_cast<int>(std::floor((person.y - origin[1].toDouble()) / resolution));
        const QPoint pixel(column, image.height() - 1 - row);
        QVERIFY2(
            !image.rect().contains(pixel) || qGray(image.pixel(pixel)) > 50,
            qPrintable(QStringLiteral("%1 in a wall at %2 s").arg(person.id).arg(sample.time)));
      }
    }
  }

  static void checkGoals(const QString& folder, const sim2d::Scenario& scenario) {
    std::map<int, std::vector<int>> reached;
    for (const auto& row : readCsv(folder + text("/events.csv"))) {
      if (row.at(text("kind")) == QLatin1String("goal") && row.at(text("id")).toInt() >= 0) {
        reached[row.at(text("id")).toInt()].push_back(row.at(text("text")).toInt());
      }
    }
    for (const sim2d::Human& human : scenario.humans) {
      if (!human.listed || human.goals.empty()) {
        continue;
      }
      const std::vector<int>& found = reached[human.id];
      for (std::size_t k = 0; k < found.size(); ++k) {
        QCOMPARE(found[k], human.goals[k % human.goals.size()]);
      }
      if (human.cyclicGoals.value_or(true) && human.goals.size() >= 2) {
        QVERIFY2(found.size() >= 2, human.name.c_str());
      }
    }
  }

 private Q_SLOTS:
  void run_scenario_filesAgreeWithThemselves_data() {
    QTest::addColumn<QString>("scenario");
    QTest::addColumn<QString>("map");
    QTest::addColumn<bool>("goalsFromFile");  // no reaction holds people up for long
    QTest::newRow("demo") << text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml")
                          << text(SOURCE_DIR "/maps/corner_cafe/corner_cafe.yaml") << false;
    const QString root = interop(text("hunavsim2/"));
    const auto row = [&root](const char* scenario, const char* map, bool goals) {
      QTest::newRow(scenario) << root + QString::fromLatin1(scenario)
                              << root + QString::fromLatin1(map) << goals;
    };
    row("isaac/scenarios/warehouse_agents.yaml", "isaac/maps/warehouse.yaml", true);
    row("isaac_docker_branch/config/agents_warehouse.yaml", "isaac/maps/warehouse.yaml", true);
    row("gazebo_classic/scenarios/agents_cafe.yaml", "gazebo_classic/maps/cafe.yaml", false);
    row("gazebo_classic/scenarios/agents_house.yaml", "gazebo_classic/maps/house.yaml", true);
    row("gazebo_classic/scenarios/agents_warehouse.yaml", "gazebo_classic/maps/warehouse.yaml",
        true);
    row("gazebo_fortress/scenarios/cafe_agents.yaml", "gazebo_classic/maps/cafe.yaml", true);
    row("gazebo_fortress/scenarios/agents2_cafe.yaml", "gazebo_classic/maps/cafe.yaml", true);
    row("gazebo_fortress/scenarios/agents_test.yaml", "gazebo_classic/maps/cafe.yaml", false);
    row("hunav_sim_v1/config/agents.yaml", "hunav_sim_v1/maps/map_cafe2.yaml", false);
    row("hunav_sim_2024/config/agents.yaml", "hunav_sim_v1/maps/map_cafe2.yaml", false);
    row("hunav_sim_2024/config/agents_house.yaml", "hunav_sim_v1/maps/small_house.yaml", false);
    row("hunav_sim_2024/config/agents_warehouse.yaml", "hunav_sim_v1/maps/small_warehouse.yaml",
        false);
    row("third_party_fork/config/default_agents.yaml", "hunav_sim_v1/maps/map_cafe2.yaml", false);
  }
  void run_scenario_filesAgreeWithThemselves() {
    QFETCH(QString, scenario);
    QFETCH(QString, map);
    QFETCH(bool, goalsFromFile);
    if (!QFile::exists(scenario)) {
      QSKIP("the files of the original are not here (HUNAV_INTEROP_DIR)");
    }
    const sim2d::ScenarioReading reading = sim2d::readScenario(scenario.toStdString());
    QVERIFY(reading.ok());
    QTemporaryDir folder;
    const QStringList words =
        list("run % --map % --duration 60", {scenario, map}) + robotWords(reading.scenario);
    const QString first = folder.filePath(text("first"));
    const QString second = folder.filePath(text("second"));
    const Finished a = runProgram(words + list("-o %", {first}));
    QVERIFY2(a.exitCode == 0, qPrintable(a.err));
    QVERIFY(a.out.trimmed().split(QLatin1Char('\n')).last().contains(text("real time")));
    QCOMPARE(runProgram(words + list("-o %", {second})).exitCode, 0);
    for (const char* name :
         {"trajectory.csv", "events.csv", "trees.csv", "trace.json", "metrics.csv"}) {
      const QString file = QLatin1Char('/') + QString::fromLatin1(name);
      QVERIFY2(!bytesOf(first + file).isEmpty(), name);
      QVERIFY2(bytesOf(first + file) == bytesOf(second + file), name);
    }
    const Run run(first);
    QCOMPARE(run.samples.size(), std::size_t{1201});
    compareMetrics(run, first);
    checkOverlaps(run);
    checkWalls(run, map);
    if (goalsFromFile) {
      checkGoals(first, reading.scenario);
    }
  }

  void run_personInsideWall_saysWhatTheFormatDemands() {
    const QString scenario = interop(text("hunavsim2/third_party_fork/config/custom_agents.yaml"));
    if (!QFile::exists(scenario)) {
      QSKIP("the files of the original are not here (HUNAV_INTEROP_DIR)");
    }
    const QString map = interop(text("hunavsim2/hunav_sim_v1/maps/small_warehouse.yaml"));
    const Finished found = runProgram("run % --map %", {scenario, map});
    QVERIFY2(found.err.contains(text("-1.207")), qPrintable(found.err));
    QVERIFY(found.exitCode == 0 || found.exitCode == 2);
  }

  void run_withoutRobot_peopleOnlyAndReasons() {
    QTemporaryDir folder;
    const QString scenario = text(TEST_DATA_DIR "/scenario/people_only.yaml");
    const QString out = folder.filePath(text("out"));
    QCOMPARE(failureOf("run % --map none -o %", {scenario, out}), QString());
    const QJsonObject length = metricsOf(out)[text("path_length")].toObject();
    QVERIFY(length[text("value")].isNull());
    QVERIFY(!length[text("why")].toString().isEmpty());
  }

  void run_nameOfAShippedScenario_isFound() {
    QCOMPARE(failureOf("run corner_cafe_agents --duration 0.1 --metrics path_length"), QString());
  }

  void run_wrongInput_exitCodesAndMessages_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("message");
    const QString demo = QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
    const auto row = [](const char* name, const QStringList& words, int code, const char* message) {
      QTest::newRow(name) << words << code << QString::fromLatin1(message);
    };
    const auto text = [](const char* word) { return QString::fromLatin1(word); };
    row("unknown option", {text("run"), demo, text("--sed"), text("3")}, 64, "--sed");
    row("no scenario", {text("run")}, 64, "scenario");
    row("unknown command", {text("lst"), text("nodes"), text("x")}, 64, "");
    row("bad pose", {text("run"), demo, text("--robot-start"), text("1 2")}, 64, "three numbers");
    row("bad dt", {text("run"), demo, text("--dt"), text("10")}, 64, "0.001");
    row("bad quirk", {text("run"), demo, text("--compat"), text("Q-99")}, 64, "Q-99");
    row("no file", {text("run"), text("/nowhere/x.yaml")}, 2, "/nowhere/x.yaml");
    row("folder", {text("run"), QStringLiteral(SOURCE_DIR "/maps")}, 2, "maps");
    row("no map", {text("run"), demo, text("--map"), text("/nowhere/m.yaml")}, 2, "m.yaml");
    row("map a folder", {text("run"), demo, text("--map"), text("/tmp")}, 2, "is a folder");
    row("unknown metric", {text("run"), demo, text("--metrics"), text("path_lenght")}, 64,
        "path_length");
    row("unknown set", {text("run"), demo, text("--set"), text("Ana.max_vell=1.0")}, 64, "max_vel");
    row("unknown model", {text("run"), demo, text("--model"), text("foo")}, 64, "--model");
    row("seed too large", {text("run"), demo, text("--seed"), text("9223372036854775808")}, 64,
        "9223372036854775808");
    row("metrics file not there", {text("run"), demo, text("--metrics"), text("no.yaml")}, 2,
        "no.yaml");
    row("no folder of trees", {text("run"), demo, text("--trees"), text("/nope")}, 2, "/nope");
    row("window, bad pose", {demo, text("--robot-start"), text("a b")}, 64, "three numbers");
    row("window, bad threads", {demo, text("--threads"), text("0")}, 64, "--threads");
    row("window, no file", {text("frobnicate")}, 2, "frobnicate");
    row("window, no picture", {demo, text("--screenshot"), text("x.jpg")}, 64, ".png");
    row("no permission", {text("run"), demo, text("-o"), text("/proc/here")}, 2, "/proc/here");
  }
  void run_wrongInput_exitCodesAndMessages() {
    QFETCH(QStringList, words);
    QFETCH(int, exitCode);
    QFETCH(QString, message);
    const Finished found = runProgram(words);
    QVERIFY2(found.exitCode == exitCode, qPrintable(found.err + QString::number(found.exitCode)));
    QVERIFY2(found.err.contains(message), qPrintable(found.err));
  }

  /// What the clock says of a run is told, and in none of the files that are equal from run to run.
  void clock_withRobot_tellsPlanningTime() {
    const Finished first = runFor5s("two_workers_agents", "first");
    QCOMPARE(first.exitCode, 0);
    QCOMPARE(runFor5s("two_workers_agents", "second").exitCode, 0);
    for (const char* key : {"planning_time_mean", "planning_time_std"}) {
      QVERIFY2(ofManifest("first", key).toDouble() > 0.0, key);
      QVERIFY2(first.out.contains(QRegularExpression(text(key) + text(" +[0-9.e-]+  s\n"))), key);
    }
    for (const char* name : {"/metrics.json", "/metrics.csv", "/steps.csv", "/trace.json"}) {
      const QByteArray bytes = bytesOf(path("first") + text(name));
      QVERIFY2(!bytes.isEmpty() && !bytes.contains("planning_time"), name);
      QVERIFY2(bytes == bytesOf(path("second") + text(name)), name);
    }
  }
  void clock_withoutRobot_saysWhyNot() {
    const Finished finished = runFor5s("realism_corner_agents", "alone");
    QCOMPARE(finished.exitCode, 0);
    QVERIFY(ofManifest("alone", "planning_time_mean").isNull());
    QVERIFY(finished.out.contains(
        QRegularExpression(text("planning_time_mean +-  s \\(no planner was called\\)"))));
  }
};

QTEST_GUILESS_MAIN(RunProgramTest)
#include "tst_RunProgram.moc"
