#include <set>

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

using outside::bytesOf;
using outside::Finished;
using outside::interop;
using outside::metricsOf;
using outside::runProgram;
using outside::text;
using outside::valueOf;

namespace {

QString demo() {
  return QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
}

/// Who comes in later walks 10 m, which takes longer than the run.
void writeSource(const QString& file) {
  outside::writeText(
      file,
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

}  // namespace

/// `hunavsim evaluate` from outside.
class EvaluateProgramTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString path(const char* name) const { return folder_.filePath(text(name)); }

  /// A run of two robots on the open plane, with ways of other lengths.
  void makePair(const char* name) {
    outside::writeText(path("pair.yaml"),
                       "hunav_loader:\n  ros__parameters:\n    agents: []\n"
                       "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n"
                       "    map_file: none\n    duration: 8.0\n    robots: [near, far]\n"
                       "    near: {start: {x: 0.0, y: 0.0, h: 0.0}, goal: {x: 2.0, y: 0.0}}\n"
                       "    far: {start: {x: 0.0, y: 9.0, h: 0.0}, goal: {x: 5.0, y: 9.0}}\n");
    const Finished made = runProgram({text("run"), path("pair.yaml"), text("-o"), path(name)});
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    QVERIFY2(made.err.isEmpty(), qPrintable(made.err));
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
    QTest::newRow("house") << QStringList{interop(text("hunavsim2/gazebo_classic/scenarios/"
                                                       "agents_house.yaml")),
                                          text("--map"),
                                          interop(text("hunavsim2/gazebo_classic/maps/house.yaml")),
                                          text("--duration"),
                                          text("15"),
                                          text("--robot-start"),
                                          text("0 0 0"),
                                          text("--robot-goal"),
                                          text("2 1")}
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
    outside::writeText(path("own.yaml"),
                       "hunavsim_metrics:\n  ros__parameters:\n    fast: {expression: "
                       "\"integral(speed > 0.3)\", unit: s}\n");
    QByteArray scenario = bytesOf(demo());
    QFile::copy(QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe.yaml"),
                path("corner_cafe.yaml"));
    QFile::copy(QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe.pgm"),
                path("corner_cafe.pgm"));
    scenario +=
        "    metrics:\n      from: motion\n      frequency: 5.0\n      tag: mine\n"
        "      file: own.yaml\n      parameters:\n        goal_tolerance: 0.7\n";
    outside::writeText(path("corner_cafe_agents.yaml"), scenario);
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
    outside::writeText(path("walk.csv"),
                       "t,ped,px,py\n0,1,0,0\n1,1,1,0\n2,1,2,0\n0,2,5,5\n1,2,5,5\n");
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
    // Columns of the evaluator alone; ours come when they are listed.
    QCOMPARE(rows[1].size(), std::size_t{2 + 34});
    QCOMPARE(runProgram(words + QStringList{text("5"), text("--metrics"), text("path_length,spl")})
                 .exitCode,
             0);
    QVERIFY(bytesOf(path("layout/metrics_2.csv"))
                .startsWith("experiment_tag,run_id,path_length,spl\nreal,5,2.0,1.0"));
    words[words.indexOf(text("hunav2"))] = text("hunav1");
    QCOMPARE(runProgram(words + QStringList{text("5")}).exitCode, 2);  // it has no rows of ours
    words[words.indexOf(path("layout"))] = path("layout1");
    QCOMPARE(runProgram(words + QStringList{text("5")}).exitCode, 0);
    QVERIFY(bytesOf(path("layout1/metrics.txt")).startsWith("experiment_tag\t"));
    // What was read is a record that can be measured again.
    const Finished again =
        runProgram({text("evaluate"), path("layout"), text("-o"), path("layout-again")});
    QVERIFY2(again.exitCode == 0, qPrintable(again.err));
    QCOMPARE(valueOf(metricsOf(path("layout-again")), text("path_length")), 2.0);
  }

  void evaluate_ofOneRobotIntoItsRun_leavesNoTableOfTheOther() {
    makePair("own");
    QVERIFY(QFile::exists(path("own/metrics_far.csv")));
    const Finished own = runProgram(
        {text("evaluate"), path("own"), text("-o"), path("own"), text("--robot"), text("far")});
    QVERIFY2(own.exitCode == 0, qPrintable(own.err));
    QVERIFY(!QFile::exists(path("own/metrics_far.csv")));
    QVERIFY(!QFile::exists(path("own/steps_far.csv")));
    QVERIFY(QFile::exists(path("own/trees.csv")));
    QCOMPARE(runProgram({text("evaluate"), path("own"), text("-o"), path("own")}).exitCode, 0);
    QVERIFY(QFile::exists(path("own/metrics_far.csv")));
  }

  void evaluate_robot_isMeasured() {
    makePair("pair");
    const auto lengthOf = [this](const QString& id) {  // until it arrived, by code of this test
      int end = 0;
      for (const auto& row : outside::readCsv(path("pair/events.csv"))) {
        const bool isIts = row.at(text("id")) == id && row.at(text("kind")) == text("arrived");
        end = isIts ? row.at(text("step")).toInt() : end;
      }
      double length = 0.0;
      double before = 0.0;
      for (const auto& row : outside::readCsv(path("pair/trajectory.csv"))) {
        if (row.at(text("id")) == id && row.at(text("step")).toInt() <= end) {
          length += row.at(text("x")).toDouble() - before;
          before = row.at(text("x")).toDouble();
        }
      }
      return length;
    };
    const auto isMeasured = [&](const char* word, const char* id) {
      QStringList words{text("evaluate"), path("pair"), text("-o"), path("pair-again")};
      words << (*word == '\0' ? QStringList() : QStringList{text("--robot"), text(word)});
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
    const Finished itself =
        runProgram({text("evaluate"), path("pair"), text("-o"), path("pair-itself"),
                    text("--robot"), text("far"), text("--reference"), path("pair")});
    QVERIFY2(itself.exitCode == 0, qPrintable(itself.err));
    for (const char* key : {"ade", "fde", "dtw", "path_deviation"}) {
      QCOMPARE(valueOf(metricsOf(path("pair-itself")), text(key)), 0.0);
    }
    const Finished wrong = runProgram(
        {text("evaluate"), path("pair"), text("-o"), path("none"), text("--robot"), text("3")});
    QCOMPARE(wrong.exitCode, 64);
    QVERIFY2(wrong.err.contains(text("there is no '3' (known: near, far)")), qPrintable(wrong.err));
  }

  /// Of several robots in a file one is chosen by its id; the others are people then.
  void evaluate_fileOfTwoRobots_wantsAnId() {
    outside::writeText(path("robots.csv"),
                       "time,id,kind,x,y\n0,1,robot,0,0\n0,2,robot,0,5\n"
                       "1,1,robot,1,0\n1,2,robot,3,5\n");
    const QStringList words{text("evaluate"), path("robots.csv"), text("-o"), path("chosen")};
    const Finished unsaid = runProgram(words);
    QCOMPARE(unsaid.exitCode, 2);
    QVERIFY2(unsaid.err.contains(text("more than one robot")), qPrintable(unsaid.err));
    const Finished chosen = runProgram(words + QStringList{text("--robot"), text("2")});
    QVERIFY2(chosen.exitCode == 0, qPrintable(chosen.err));
    QCOMPARE(valueOf(metricsOf(path("chosen")), text("path_length")), 3.0);
  }

  /// A way of 2000 mm in 2000 ms, towards 90 degrees, by somebody of 0.2 m.
  void evaluate_units_count() {
    outside::writeText(path("units.csv"),
                       "time,id,x,y,heading\n0,anna,0,0,90\n1000,anna,1000,0,90\n"
                       "2000,anna,2000,0,90\n0,ben,0,5000,90\n1000,ben,0,5000,90\n"
                       "2000,ben,0,5000,90\n");
    const Finished finished =
        runProgram({text("evaluate"), path("units.csv"), text("-o"), path("units"), text("--unit"),
                    text("mm"), text("--time-unit"), text("ms"), text("--degrees"),
                    text("--radius"), text("0.2"), text("--robot"), text("anna")});
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    QCOMPARE(valueOf(metricsOf(path("units")), text("path_length")), 2.0);
    const auto rows = outside::readCsv(path("units/trajectory.csv"));
    QCOMPARE(rows.back().at(text("time")).toDouble(), 2.0);
    QVERIFY(std::fabs(rows.back().at(text("heading")).toDouble() - 1.5707963267948966) < 1e-12);
    QVERIFY(bytesOf(path("units/trace.json")).contains("0.2"));
  }

  /// The folder of a run stays one run.
  void evaluate_intoAnotherRun_isRefused() {
    outside::writeText(path("w.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,0\n");
    outside::writeText(path("other/manifest.json"), "{}");
    outside::writeText(path("other/trajectory.csv"), "mine");
    const Finished finished =
        runProgram({text("evaluate"), path("w.csv"), text("-o"), path("other")});
    QCOMPARE(finished.exitCode, 2);
    QVERIFY2(finished.err.contains(text("contains a run")), qPrintable(finished.err));
    QCOMPARE(bytesOf(path("other/trajectory.csv")), QByteArray("mine"));
  }

  void evaluate_resultOverItsInput_isRefused() {
    outside::writeText(path("same/steps.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,0\n");
    const Finished finished =
        runProgram({text("evaluate"), path("same/steps.csv"), text("-o"), path("same")});
    QCOMPARE(finished.exitCode, 2);
    QVERIFY2(finished.err.contains(text("this is an input file")), qPrintable(finished.err));
    QVERIFY(bytesOf(path("same/steps.csv")).startsWith("time,id,x,y"));
  }

  /// Not only what is read: the output folder has a way of somebody else.
  void evaluate_resultOverAnotherWay_isRefused() {
    const QByteArray mine = "time,id,x,y\n0,1,0,0\n1,1,1,0\n";
    outside::writeText(path("others/trajectory.csv"), mine);
    outside::writeText(path("way.csv"), mine);
    const QStringList words = {text("evaluate"), path("way.csv"), text("-o"), path("others")};
    const Finished finished = runProgram(words);
    QCOMPARE(finished.exitCode, 2);
    QVERIFY2(finished.err.contains(text("trajectory.csv: error: this file was not created here")),
             qPrintable(finished.err));
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
    const Finished table =
        through("\x89HDF\r\n", {text("evaluate"), text("-"), text("-o"), path("h5")});
    QCOMPARE(table.exitCode, 2);
    QVERIFY2(table.err.contains(text("HDF5 cannot be read")), qPrintable(table.err));
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
    outside::writeText(path("two.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,0.5\n2,1,2,0\n");
    outside::writeText(path("way.csv"), "time,id,x,y\n5,7,0,0\n6,7,1,0\n7,7,2,0\n");
    const Finished finished =
        runProgram({text("evaluate"), path("two.csv"), text("-o"), path("reference"),
                    text("--robot"), text("1"), text("--reference"), path("way.csv")});
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    const QJsonObject metrics = metricsOf(path("reference"));
    QVERIFY(std::fabs(valueOf(metrics, text("ade")) - 0.5 / 3.0) < 1e-12);
    QVERIFY(std::fabs(valueOf(metrics, text("path_deviation")) - 0.5 / 3.0) < 1e-12);
    QCOMPARE(valueOf(metrics, text("fde")), 0.0);
    // The folder that was just made is a reference too; several people are not.
    QCOMPARE(runProgram({text("evaluate"), path("two.csv"), text("-o"), path("itself"),
                         text("--robot"), text("1"), text("--reference"), path("reference")})
                 .exitCode,
             0);
    QCOMPARE(valueOf(metricsOf(path("itself")), text("ade")), 0.0);
    outside::writeText(path("both.csv"), "time,id,x,y\n0,1,0,0\n0,2,1,0.5\n1,1,0,0\n1,2,1,1\n");
    const Finished wrong =
        runProgram({text("evaluate"), path("two.csv"), text("-o"), path("wrong"), text("--robot"),
                    text("1"), text("--reference"), path("both.csv")});
    QCOMPARE(wrong.exitCode, 2);
    QVERIFY2(wrong.err.contains(text("both.csv: error: a reference")), qPrintable(wrong.err));
  }

  /// What the reader of a file has to say, of a reference too.
  void evaluate_warningsOfTheReader_areTold() {
    outside::writeText(path("words.csv"), "time,id,x,y\n0,anna,0,0\n1,anna,1,0\n");
    const QString told = text("ids are text and are replaced by numbers: anna = 1");
    const Finished words =
        runProgram({text("evaluate"), path("words.csv"), text("-o"), path("words")});
    QVERIFY2(words.exitCode == 0, qPrintable(words.err));
    QVERIFY2(words.err.contains(text("words.csv: warning: ") + told), qPrintable(words.err));
    outside::writeText(path("number.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,0\n");
    const Finished reference =
        runProgram({text("evaluate"), path("number.csv"), text("-o"), path("number"),
                    text("--robot"), text("1"), text("--reference"), path("words.csv")});
    QVERIFY2(reference.exitCode == 0, qPrintable(reference.err));
    QVERIFY2(reference.err.contains(told), qPrintable(reference.err));
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
    outside::writeText(path("plain.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,0\n2,1,2,0\n");
    QCOMPARE(runProgram({text("evaluate"), path("plain.csv"), text("-o"), plain}).exitCode, 0);
    QByteArray rows = bytesOf(plain + text("/trajectory.csv"));
    QVERIFY2(rows.contains(from), rows.constData());
    outside::writeText(plain + text("/trajectory.csv"), rows.replace(from, to));
    const Finished finished = runProgram({text("evaluate"), plain, text("-o"), path("broken")});
    QCOMPARE(finished.exitCode, 2);
    QVERIFY2(finished.err.contains(told), qPrintable(finished.err));
  }

  /// Well-formed, but not what the manifest lists: a way of another run.
  void evaluate_partOfAnotherRun_isRefused() {
    const QString out = path("mixed");
    for (const char* seed : {"1", "2"}) {
      const Finished made =
          runProgram({text("run"), text("corner_cafe_agents"), text("--duration"), text("1"),
                      text("--seed"), text(seed), text("-q"), text("-o"), out + text(seed)});
      QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    }
    QVERIFY(QFile::remove(out + text("1/trajectory.csv")));
    QVERIFY(QFile::copy(out + text("2/trajectory.csv"), out + text("1/trajectory.csv")));
    const QStringList words{text("evaluate"), out + text("1"), text("-o"), path("of mixed")};
    const Finished refused = runProgram(words);
    QCOMPARE(refused.exitCode, 2);
    QVERIFY2(refused.err.contains(text("1/trajectory.csv: error: the file does not match")),
             qPrintable(refused.err));
    QVERIFY(QFile::remove(out + text("1/manifest.json")));
    QCOMPARE(runProgram(words).exitCode, 0);
  }

  void evaluate_badInput_isTold_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("told");
    outside::writeText(path("bad.csv"), "time,id,x,y\n0,1,nan,0\n");
    outside::writeText(path("good.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,0\n");
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
};

QTEST_GUILESS_MAIN(EvaluateProgramTest)
#include "tst_EvaluateProgram.moc"
