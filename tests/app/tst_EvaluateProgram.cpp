#include <set>

#include <QDir>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

QString demo() {
  return text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
}

/// Who comes in later walks 10 m, which takes longer than the run.
void writeSource(const QString& file) {
  writeText(file,
            "hunav_loader:\n  ros__parameters:\n    agents: [walker]\n    walker:\n"
            "      id: 1\n      skin: 0\n      group_id: -1\n      max_vel: 1.2\n"
            "      radius: 0.3\n      init_pose: {x: 0.0, y: 0.0, z: 1.0, h: 0.0}\n"
            "      behavior: {type: 1, configuration: 0, duration: 40.0, once: true, "
            "vel: 0.6, dist: 2.5, goal_force_factor: 2.0, obstacle_force_factor: 10.0, "
            "social_force_factor: 5.0, other_force_factor: 20.0}\n"
            "      goal_radius: 0.3\n      cyclic_goals: false\n      goals: [1]\n"
            "    global_goals:\n      1: {x: 10.0, y: 0.0, h: 0.0}\n"
            "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n    map_file: none\n"
            "    duration: 8.0\n    areas: [entry]\n"
            "    entry: {kind: source, xs: [0.0, 3.0, 3.0, 0.0], ys: [2.0, 2.0, 5.0, 5.0], "
            "like: walker, rate: 1.0}\n");
}

/// A file of another program.
QString track(const char* name) {
  return text(TEST_DATA_DIR "/tracks/") + text(name);
}

}  // namespace

/// `hunavsim evaluate` from outside.
class EvaluateProgramTest : public QObject, protected InFolder {
  Q_OBJECT

 private:
  /// A run of two robots on the open plane, with ways of other lengths.
  void makePair(const char* name) {
    writeText(path("pair.yaml"),
              "hunav_loader:\n  ros__parameters:\n    agents: []\n"
              "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n"
              "    map_file: none\n    duration: 8.0\n    robots: [near, far]\n"
              "    near: {start: {x: 0.0, y: 0.0, h: 0.0}, goal: {x: 2.0, y: 0.0}}\n"
              "    far: {start: {x: 0.0, y: 9.0, h: 0.0}, goal: {x: 5.0, y: 9.0}}\n");
    const Finished made = runProgram("run % -o %", {path("pair.yaml"), path(name)});
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    QVERIFY2(made.err.isEmpty(), qPrintable(made.err));
  }

  Finished evaluate(const QString& file, const QStringList& more = {}) {
    return runProgram(list("evaluate % -o % -q --force", {file, path("out")}) + more);
  }
  double metric(const char* key) { return valueOf(metricsOf(path("out")), text(key)); }

 private Q_SLOTS:
  void evaluate_runFolder_equalsRun_data() {
    QTest::addColumn<QStringList>("scenario");
    QTest::addColumn<QStringList>("options");
    const QStringList shipped = list("% --duration 20", {demo()});
    QTest::newRow("demo") << shipped << QStringList();
    QTest::newRow("hunav2") << shipped << list("--metrics-profile hunav2");
    QTest::newRow("keys") << shipped << list("--metrics path_length,spl,social_work");
    QTest::newRow("house") << list("% --map % --duration 15 --robot-start % --robot-goal %",
                                   {interop(text("hunavsim2/gazebo_classic/scenarios/"
                                                 "agents_house.yaml")),
                                    interop(text("hunavsim2/gazebo_classic/maps/house.yaml")),
                                    text("0 0 0"), text("2 1")})
                           << QStringList();
    writeSource(path("source.yaml"));
    QTest::newRow("source") << QStringList{path("source.yaml")} << QStringList();
  }
  void evaluate_runFolder_equalsRun() {
    QFETCH(QStringList, scenario);
    QFETCH(QStringList, options);
    if (!QFile::exists(scenario.front())) {
      QSKIP("the files of the original are not here (HUNAV_INTEROP_DIR)");
    }
    const QString run = path(QTest::currentDataTag());
    const QString again = run + text("-again");
    QCOMPARE(failureOf(list("run") + scenario + options + list("-o %", {run})), QString());
    QCOMPARE(failureOf(list("evaluate % -o %", {run, again}) + options), QString());
    for (const char* name : {"/metrics.json", "/metrics.csv", "/steps.csv"}) {
      QVERIFY2(!bytesOf(run + text(name)).isEmpty(), name);
      QVERIFY2(bytesOf(run + text(name)) == bytesOf(again + text(name)), name);
    }
  }

  void evaluate_settingsOfTheScenario_areInTheRecord() {
    writeText(path("own.yaml"),
              "hunavsim_metrics:\n  ros__parameters:\n    fast: {expression: "
              "\"integral(speed > 0.3)\", unit: s}\n");
    QByteArray scenario = bytesOf(demo());
    QFile::copy(text(SOURCE_DIR "/maps/corner_cafe/corner_cafe.yaml"), path("corner_cafe.yaml"));
    QFile::copy(text(SOURCE_DIR "/maps/corner_cafe/corner_cafe.pgm"), path("corner_cafe.pgm"));
    scenario +=
        "    metrics:\n      from: motion\n      frequency: 5.0\n      tag: mine\n"
        "      file: own.yaml\n      parameters:\n        goal_tolerance: 0.7\n";
    writeText(path("corner_cafe_agents.yaml"), scenario);
    QCOMPARE(failureOf("run % --duration 8 -o %", {path("corner_cafe_agents.yaml"), path("set")}),
             QString());
    QCOMPARE(failureOf("evaluate % -o %", {path("set"), path("set-again")}), QString());
    QVERIFY(bytesOf(path("set/metrics.csv")).contains(",fast"));
    QVERIFY(bytesOf(path("set/metrics.csv")).contains("\nmine,"));
    QCOMPARE(bytesOf(path("set/metrics.json")), bytesOf(path("set-again/metrics.json")));
  }

  void evaluate_layouts_appendRows() {
    writeText(path("walk.csv"), "t,ped,px,py\n0,1,0,0\n1,1,1,0\n2,1,2,0\n0,2,5,5\n1,2,5,5\n");
    QStringList words = list(
        "evaluate % -o % --columns time=t,id=ped,x=px,y=py --robot 1 --robot-goal % --tag real "
        "--layout hunav2 --run-id",
        {path("walk.csv"), path("layout"), text("2 0")});
    for (const char* id : {"3", "4"}) {
      QCOMPARE(failureOf(words + QStringList{text(id)}), QString());
    }
    const auto rows = readCsv(path("layout/metrics.csv"));
    QCOMPARE(rows.size(), std::size_t{2});
    QCOMPARE(rows[1].at(text("run_id")), text("4"));
    QCOMPARE(rows[1].at(text("experiment_tag")), text("real"));
    QCOMPARE(rows[1].at(text("path_length")), text("2.0"));
    QCOMPARE(rows[1].at(text("completed")), text("True"));
    QVERIFY(QFile::exists(path("layout/metrics_steps_real_4.csv")));
    // Columns of the evaluator alone; ours come when they are listed.
    QCOMPARE(rows[1].size(), std::size_t{2 + 34});
    QCOMPARE(runProgram(words + list("5 --metrics path_length,spl")).exitCode, 0);
    QVERIFY(bytesOf(path("layout/metrics_2.csv"))
                .startsWith("experiment_tag,run_id,path_length,spl\nreal,5,2.0,1.0"));
    words[words.indexOf(text("hunav2"))] = text("hunav1");
    QCOMPARE(runProgram(words + list("5")).exitCode, 2);  // it has no rows of ours
    words[words.indexOf(path("layout"))] = path("layout1");
    QCOMPARE(runProgram(words + list("5")).exitCode, 0);
    QVERIFY(bytesOf(path("layout1/metrics.txt")).startsWith("experiment_tag\t"));
    // What was read is a record that can be measured again.
    const Finished again = runProgram("evaluate % -o %", {path("layout"), path("layout-again")});
    QVERIFY2(again.exitCode == 0, qPrintable(again.err));
    QCOMPARE(valueOf(metricsOf(path("layout-again")), text("path_length")), 2.0);
  }

  void evaluate_ofOneRobotIntoItsRun_leavesNoTableOfTheOther() {
    makePair("own");
    QVERIFY(QFile::exists(path("own/metrics_far.csv")));
    const Finished own = runProgram("evaluate % -o % --robot far", {path("own"), path("own")});
    QVERIFY2(own.exitCode == 0, qPrintable(own.err));
    QVERIFY(!QFile::exists(path("own/metrics_far.csv")));
    QVERIFY(!QFile::exists(path("own/steps_far.csv")));
    QVERIFY(QFile::exists(path("own/trees.csv")));
    QCOMPARE(runProgram("evaluate % -o %", {path("own"), path("own")}).exitCode, 0);
    QVERIFY(QFile::exists(path("own/metrics_far.csv")));
  }

  void evaluate_robot_isMeasured() {
    makePair("pair");
    const auto lengthOf = [this](const QString& id) {  // until it arrived, by code of this test
      int end = 0;
      for (const auto& row : readCsv(path("pair/events.csv"))) {
        const bool isIts = row.at(text("id")) == id && row.at(text("kind")) == text("arrived");
        end = isIts ? row.at(text("step")).toInt() : end;
      }
      double length = 0.0;
      double before = 0.0;
      for (const auto& row : readCsv(path("pair/trajectory.csv"))) {
        if (row.at(text("id")) == id && row.at(text("step")).toInt() <= end) {
          length += row.at(text("x")).toDouble() - before;
          before = row.at(text("x")).toDouble();
        }
      }
      return length;
    };
    const auto isMeasured = [&](const char* word, const char* id) {
      QStringList words = list("evaluate % -o %", {path("pair"), path("pair-again")});
      words << (*word == '\0' ? QStringList() : list("--robot %", {text(word)}));
      const Finished finished = runProgram(words);
      const double length = valueOf(metricsOf(path("pair-again")), text("path_length"));
      return finished.exitCode == 0 && finished.err.isEmpty() &&
             std::fabs(length - lengthOf(text(id))) < 1e-6;
    };
    QVERIFY(lengthOf(text("-2")) > lengthOf(text("-1")) + 2.0);
    QVERIFY(isMeasured("", "-1"));
    QVERIFY(isMeasured("near", "-1"));
    for (const char* word : {"far", "2", "-2"}) {
      QVERIFY2(isMeasured(word, "-2"), word);
    }
    // Beside itself it is nowhere else, though it is parked at the end and not the first robot.
    const Finished itself = runProgram("evaluate % -o % --robot far --reference %",
                                       {path("pair"), path("pair-itself"), path("pair")});
    QVERIFY2(itself.exitCode == 0, qPrintable(itself.err));
    for (const char* key : {"ade", "fde", "dtw", "path_deviation"}) {
      QCOMPARE(valueOf(metricsOf(path("pair-itself")), text(key)), 0.0);
    }
    QCOMPARE(unexpected(runProgram("evaluate % -o % --robot 3", {path("pair"), path("none")}), 64,
                        "there is no '3' (known: near, far)"),
             QString());
  }

  /// Of several robots in a file one is chosen by its id; the others are people then.
  void evaluate_fileOfTwoRobots_wantsAnId() {
    writeText(path("robots.csv"),
              "time,id,kind,x,y\n0,1,robot,0,0\n0,2,robot,0,5\n"
              "1,1,robot,1,0\n1,2,robot,3,5\n");
    const QStringList words = list("evaluate % -o %", {path("robots.csv"), path("chosen")});
    QCOMPARE(unexpected(runProgram(words), 2, "more than one robot"), QString());
    const Finished chosen = runProgram(words + list("--robot 2"));
    QVERIFY2(chosen.exitCode == 0, qPrintable(chosen.err));
    QCOMPARE(valueOf(metricsOf(path("chosen")), text("path_length")), 3.0);
  }

  /// A way of 2000 mm in 2000 ms, towards 90 degrees, by somebody of 0.2 m.
  void evaluate_units_count() {
    writeText(path("units.csv"),
              "time,id,x,y,heading\n0,anna,0,0,90\n1000,anna,1000,0,90\n"
              "2000,anna,2000,0,90\n0,ben,0,5000,90\n1000,ben,0,5000,90\n"
              "2000,ben,0,5000,90\n");
    QCOMPARE(
        failureOf("evaluate % -o % --unit mm --time-unit ms --degrees --radius 0.2 --robot anna",
                  {path("units.csv"), path("units")}),
        QString());
    QCOMPARE(valueOf(metricsOf(path("units")), text("path_length")), 2.0);
    const auto rows = readCsv(path("units/trajectory.csv"));
    QCOMPARE(rows.back().at(text("time")).toDouble(), 2.0);
    QVERIFY(std::fabs(rows.back().at(text("heading")).toDouble() - 1.5707963267948966) < 1e-12);
    QVERIFY(bytesOf(path("units/trace.json")).contains("0.2"));
  }

  /// The folder of a run stays one run.
  void evaluate_intoAnotherRun_isRefused() {
    writeText(path("w.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,0\n");
    writeText(path("other/manifest.json"), "{}");
    writeText(path("other/trajectory.csv"), "mine");
    QCOMPARE(unexpected(runProgram("evaluate % -o %", {path("w.csv"), path("other")}), 2,
                        "contains a run"),
             QString());
    QCOMPARE(bytesOf(path("other/trajectory.csv")), QByteArray("mine"));
  }

  void evaluate_resultOverItsInput_isRefused() {
    writeText(path("same/steps.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,0\n");
    QCOMPARE(unexpected(runProgram("evaluate % -o %", {path("same/steps.csv"), path("same")}), 2,
                        "this is an input file"),
             QString());
    QVERIFY(bytesOf(path("same/steps.csv")).startsWith("time,id,x,y"));
  }

  /// Not only what is read: the output folder has a way of somebody else.
  void evaluate_resultOverAnotherWay_isRefused() {
    const QByteArray mine = "time,id,x,y\n0,1,0,0\n1,1,1,0\n";
    writeText(path("others/trajectory.csv"), mine);
    writeText(path("way.csv"), mine);
    const QStringList words = list("evaluate % -o %", {path("way.csv"), path("others")});
    QCOMPARE(
        unexpected(runProgram(words), 2, "trajectory.csv: error: this file was not created here"),
        QString());
    QCOMPARE(bytesOf(path("others/trajectory.csv")), mine);
    QVERIFY(QFile::remove(path("others/trajectory.csv")));
    QCOMPARE(runProgram(words).exitCode, 0);
    QCOMPARE(runProgram(words).exitCode, 0);  // what it wrote itself it writes again
  }

  void standardInput_isRead() {
    const auto through = [](const QByteArray& input, const QStringList& words) {
      QProcess process;
      process.start(text(HUNAVSIM_PROGRAM), words);
      process.write(input);
      process.closeWriteChannel();
      const bool isDone = process.waitForFinished(55000);
      return Finished{isDone ? process.exitCode() : -1,
                      QString::fromUtf8(process.readAllStandardOutput()),
                      QString::fromUtf8(process.readAllStandardError())};
    };
    const Finished way =
        through("time,id,x,y\n0,1,0,0\n1,1,3,4\n",
                {text("evaluate"), text("-"), text("-o"), path("in"), text("--robot"), text("1")});
    QVERIFY2(way.exitCode == 0, qPrintable(way.err));
    QCOMPARE(valueOf(metricsOf(path("in")), text("path_length")), 5.0);
    QCOMPARE(
        unexpected(through("\x89HDF\r\n", {text("evaluate"), text("-"), text("-o"), path("h5")}), 2,
                   "HDF5 cannot be read"),
        QString());
    const QByteArray scenario =
        "hunav_loader:\n  ros__parameters:\n    agents: []\n"
        "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n    map_file: none\n"
        "    robots: [near]\n"
        "    near: {start: {x: 0.0, y: 0.0, h: 0.0}, goal: {x: 2.0, y: 0.0}}\n";
    const Finished checked = through(scenario, {text("check"), text("-")});
    QVERIFY2(checked.exitCode == 0, qPrintable(checked.err));
    const Finished run = through(scenario, {text("run"), text("-"), text("--duration"), text("1")});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    const Finished kept = through(scenario, {text("run"), text("-"), text("--duration"), text("1"),
                                             text("-o"), path("kept")});
    QVERIFY2(kept.exitCode == 0, qPrintable(kept.err));
    const auto hash = QCryptographicHash::hash(scenario, QCryptographicHash::Sha256).toHex();
    QVERIFY(bytesOf(path("kept/manifest.json")).contains(hash));
    const Finished converted = through(scenario, {text("convert"), text("-"), text("-o"),
                                                  path("conv"), text("--target"), text("native")});
    QVERIFY2(converted.exitCode == 0, qPrintable(converted.err));
    QVERIFY(QFile::exists(path("conv/scenarios/scenario.yaml")));
  }

  void evaluate_reference_isTheRecordedWay() {
    writeText(path("two.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,0.5\n2,1,2,0\n");
    writeText(path("way.csv"), "time,id,x,y\n5,7,0,0\n6,7,1,0\n7,7,2,0\n");
    QCOMPARE(failureOf("evaluate % -o % --robot 1 --reference %",
                       {path("two.csv"), path("reference"), path("way.csv")}),
             QString());
    const QJsonObject metrics = metricsOf(path("reference"));
    QVERIFY(std::fabs(valueOf(metrics, text("ade")) - 0.5 / 3.0) < 1e-12);
    QVERIFY(std::fabs(valueOf(metrics, text("path_deviation")) - 0.5 / 3.0) < 1e-12);
    QCOMPARE(valueOf(metrics, text("fde")), 0.0);
    // The folder that was just made is a reference too; several people are not.
    QCOMPARE(runProgram("evaluate % -o % --robot 1 --reference %",
                        {path("two.csv"), path("itself"), path("reference")})
                 .exitCode,
             0);
    QCOMPARE(valueOf(metricsOf(path("itself")), text("ade")), 0.0);
    writeText(path("both.csv"), "time,id,x,y\n0,1,0,0\n0,2,1,0.5\n1,1,0,0\n1,2,1,1\n");
    QCOMPARE(unexpected(runProgram("evaluate % -o % --robot 1 --reference %",
                                   {path("two.csv"), path("wrong"), path("both.csv")}),
                        2, "both.csv: error: a reference"),
             QString());
  }

  /// What the reader of a file has to say, of a reference too.
  void evaluate_warningsOfTheReader_areTold() {
    writeText(path("words.csv"), "time,id,x,y\n0,anna,0,0\n1,anna,1,0\n");
    const QString told = text("ids are text and are replaced by numbers: anna = 1");
    const Finished words = runProgram("evaluate % -o %", {path("words.csv"), path("words")});
    QVERIFY2(words.exitCode == 0, qPrintable(words.err));
    QVERIFY2(words.err.contains(text("words.csv: warning: ") + told), qPrintable(words.err));
    writeText(path("number.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,0\n");
    QCOMPARE(unexpected(runProgram("evaluate % -o % --robot 1 --reference %",
                                   {path("number.csv"), path("number"), path("words.csv")}),
                        0, told),
             QString());
  }

  void evaluate_brokenRunFolder_isTold_data() {
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QString>("told");
    QTest::newRow("nan") << QByteArray("1,1,1,human,1,") << QByteArray("1,1,1,human,nan,")
                         << text("trajectory.csv:3:");
    QTest::newRow("backwards") << QByteArray("\n2,2,1,") << QByteArray("\n0,0,1,")
                               << text("trajectory.csv:4:");
    QTest::newRow("stranger") << QByteArray("\n2,2,1,") << QByteArray("\n2,2,9,")
                              << text("trajectory.csv:4:");
  }
  void evaluate_brokenRunFolder_isTold() {
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QString, told);
    const QString plain = path("plain ") + QString::fromUtf8(QTest::currentDataTag());
    writeText(path("plain.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,0\n2,1,2,0\n");
    QCOMPARE(runProgram("evaluate % -o %", {path("plain.csv"), plain}).exitCode, 0);
    QByteArray rows = bytesOf(plain + text("/trajectory.csv"));
    QVERIFY2(rows.contains(from), rows.constData());
    writeText(plain + text("/trajectory.csv"), rows.replace(from, to));
    QCOMPARE(unexpected(runProgram("evaluate % -o %", {plain, path("broken")}), 2, told),
             QString());
  }

  /// Well-formed, but not what the manifest lists: a way of another run.
  void evaluate_partOfAnotherRun_isRefused() {
    const QString out = path("mixed");
    for (const char* seed : {"1", "2"}) {
      QCOMPARE(failureOf("run corner_cafe_agents --duration 1 --seed % -q -o %",
                         {text(seed), out + text(seed)}),
               QString());
    }
    QVERIFY(QFile::remove(out + text("1/trajectory.csv")));
    QVERIFY(QFile::copy(out + text("2/trajectory.csv"), out + text("1/trajectory.csv")));
    const QStringList words = list("evaluate % -o %", {out + text("1"), path("of mixed")});
    QCOMPARE(unexpected(runProgram(words), 2, "1/trajectory.csv: error: the file does not match"),
             QString());
    QVERIFY(QFile::remove(out + text("1/manifest.json")));
    QCOMPARE(runProgram(words).exitCode, 0);
  }

  void evaluate_badInput_isTold_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("told");
    writeText(path("bad.csv"), "time,id,x,y\n0,1,nan,0\n");
    writeText(path("good.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,0\n");
    QVERIFY(QDir(folder_.path()).mkpath(text("empty")));
    const auto row = [this](const char* name, const char* source, const QStringList& more,
                            int exitCode, const char* told) {
      QTest::newRow(name) << (list("evaluate % -o %", {path(source), path("out")}) + more)
                          << exitCode << text(told);
    };
    row("missing", "none.csv", {}, 2, "none.csv");
    row("empty folder", "empty", {}, 2, "trajectory.csv");
    row("nan", "bad.csv", {}, 2, "bad.csv:2:5: error: x");
    row("nobody", "good.csv", {text("--robot"), text("9")}, 2, "no body has the id 9");
    row("columns", "good.csv", {text("--columns"), text("tme=t")}, 64, "tme");
    row("fps", "good.csv", {text("--fps"), text("0")}, 64, "--fps");
    row("goal", "good.csv", {text("--robot-goal"), text("1")}, 64, "--robot-goal");
    row("format", "good.csv", {text("--format"), text("xls")}, 64, "--format");
    row("key", "good.csv", {text("--metrics"), text("path_lenght")}, 64, "path_length");
    row("foreign words", "empty", {text("--fps"), text("1")}, 64, "--fps");
    row("no id", "good.csv", {text("--robot"), text("anna")}, 2, "no body has the id anna");
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

  /// 0.1 m per frame at 25 frames per second.
  void hdf5_rateOnTheTable_isUsed() {
    const Finished finished = evaluate(track("fps_on_table.h5"), {text("--robot"), text("1")});
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    QVERIFY(std::fabs(metric("avg_robot_linear_speed") - 2.5) < 1e-6);
    QVERIFY(std::fabs(metric("path_length") - 4.9) < 1e-6);
  }
  void hdf5_declaredRows_areRefusedAtOnce() {
    QElapsedTimer clock;
    clock.start();
    QCOMPARE(
        unexpected(evaluate(track("declares_20_million_rows.h5")), 2, "declares 20000000 rows"),
        QString());
    QVERIFY(clock.elapsed() < 10000);
  }
  /// 0.12 m per frame at 10 frames per second, 1 m and 2 m from the nearer wall.
  void jupedsim_database_isNoBag() {
    const Finished finished = evaluate(track("corridor.sqlite"), {text("--robot"), text("1")});
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    QVERIFY(std::fabs(metric("avg_robot_linear_speed") - 1.2) < 1e-6);
    QVERIFY(std::fabs(metric("clearing_distance_min") - 0.65) < 1e-6);  // 1 m less the radius
    const Finished said = evaluate(track("corridor.sqlite"), {text("--format"), text("jupedsim")});
    QVERIFY2(said.exitCode == 0, qPrintable(said.err));
  }
  void bareRows_nameTheOptions() {
    QByteArray rows;
    for (int id = 1; id <= 2; ++id) {
      for (int frame = 0; frame < 5; ++frame) {
        rows += QByteArray::number(id) + " " + QByteArray::number(frame) + " " +
                QByteArray::number(10 * frame) + " " + QByteArray::number(500 * id) + " 170\n";
      }
    }
    writeText(path("bare.txt"), rows);
    const Finished asked = evaluate(path("bare.txt"));
    QCOMPARE(asked.exitCode, 2);
    QVERIFY2(asked.err.contains(text("--fps F")) && asked.err.contains(text("--unit")),
             qPrintable(asked.err));
    const Finished finished = evaluate(path("bare.txt"), {text("--fps"), text("10"), text("--unit"),
                                                          text("cm"), text("--robot"), text("1")});
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    QVERIFY(std::fabs(metric("avg_robot_linear_speed") - 1.0) < 1e-6);
  }

  void run_asTracks_isEvaluatedAgain() {
    const Finished run =
        runProgram("run % --duration 10 -o % -q",
                   {text(SOURCE_DIR "/maps/planners/crossing_agents.yaml"), path("run")});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    const Finished json = runProgram("render % -o % -q", {path("run"), path("run.json")});
    QVERIFY2(json.exitCode == 0, qPrintable(json.err));
    const Finished again = evaluate(path("run.json"));
    QVERIFY2(again.exitCode == 0, qPrintable(again.err));
    const double length = metric("path_length");
    const double distance = metric("minimum_distance_to_people");
    const Finished plain = evaluate(path("run"));
    QVERIFY2(plain.exitCode == 0, qPrintable(plain.err));
    QVERIFY(length > 1.0);
    QVERIFY(std::fabs(length - metric("path_length")) < 1e-6);
    QVERIFY(std::fabs(distance - metric("minimum_distance_to_people")) < 1e-6);
    QCOMPARE(unexpected(runProgram("render % -o % --fps 5", {path("run"), path("run.ndjson")}), 0,
                        "is written as the pedestrian"),
             QString());
    const QList<QByteArray> rows = bytesOf(path("run.ndjson")).split('\n');
    const QJsonObject scene =
        QJsonDocument::fromJson(rows.first()).object()[text("scene")].toObject();
    QCOMPARE(scene[text("fps")].toDouble(), 5.0);
    QCOMPARE(scene[text("e")].toInt() - scene[text("s")].toInt(), 20);
    const Finished wrong =
        runProgram("render % -o % --width 100", {path("run"), path("run.ndjson")});
    QCOMPARE(wrong.exitCode, 64);
  }
};

QTEST_GUILESS_MAIN(EvaluateProgramTest)
#include "tst_EvaluateProgram.moc"
