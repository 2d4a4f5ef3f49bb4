#include <cmath>

#include <QTemporaryDir>
#include <QtTest>

#include "app/report/StudyOutput.h"
#include "tests/app/StudyOutputs.h"

using namespace outside;
using namespace report;

namespace {

template <class Output>
Output outputIn(const QString& folder) {
  const auto file = studyOutputFile(folder.toStdString());
  if (!file) {
    return {};
  }
  const base::Result<StudyOutput> read = readStudyOutput(*file);
  return read && std::holds_alternative<Output>(*read) ? std::get<Output>(*read) : Output();
}

}  // namespace

/// The results of tune, gate, sensitivity and search, read from their folders.
class StudyOutputTest : public QObject, InFolder {
  Q_OBJECT

 private Q_SLOTS:
  void tune_isReadAsWritten() {
    const QString folder = writeOutput(path("tune"), "tune.json", kTuneOutput);
    writeText(folder + text("/changes.diff"), "--- a\n+++ b\n-x: 1\n+x: 2\n");
    const auto tune = outputIn<TuneOutput>(folder);
    QCOMPARE(tune.verdict, app::TuneVerdict::NotConfirmed);
    QCOMPARE(tune.objectives,
             (std::vector<std::string>{"time_to_reach_goal", "intimate_space_intrusions"}));
    QCOMPARE(tune.parameters.size(), std::size_t{3});
    QCOMPARE(tune.parameters[1].chosen.value(), std::string("1.15"));
    QVERIFY(tune.parameters[1].isLogarithmic && !tune.parameters[0].isLogarithmic);
    QCOMPARE(tune.evaluations.size(), std::size_t{2});  // all, then the scenario
    QCOMPARE(tune.evaluations[0].scenario, std::string());
    QCOMPARE(tune.evaluations[1].objectives[0].interval.low, -8.0);
    QVERIFY(!tune.evaluations[0].objectives[1].interval.isDefined());  // null
    QCOMPARE(tune.effects[0].objectives[0].difference, -1.0);
    QVERIFY(tune.effects[0].isKept && !tune.effects[1].isKept);
    QCOMPARE(tune.tried, std::size_t{3});
    QCOMPARE(tune.candidates.size(), std::size_t{3});  // one is not complete
    QVERIFY(tune.candidates[0].isBefore && tune.candidates[2].isChosen);
    QCOMPARE(tune.candidates[1].ratios, (std::vector<double>{1.25, 0.5}));
    QCOMPARE(tune.diff, std::string("--- a\n+++ b\n-x: 1\n+x: 2\n"));
  }

  void gate_isReadAsWritten() {
    const auto gate = outputIn<GateOutput>(writeOutput(path("gate"), "gate.json", kGateOutput));
    QCOMPARE(gate.verdict, app::GateVerdict::Worse);
    QCOMPARE(gate.metrics.size(), std::size_t{3});
    QCOMPARE(gate.metrics[1].interval.high, 30.0);
    QCOMPARE(gate.metrics[1].margin, 5.0);
    QVERIFY(!gate.metrics[2].isMeasured && std::isnan(gate.metrics[2].base));
    QCOMPARE(gate.remarks, std::vector<std::string>{"a remark"});
    QCOMPARE(gate.findings[1].seed, 9LL);
    QCOMPARE(studyOutputPage(gate), std::string("gate.html"));
  }

  void sensitivity_isReadAsWritten() {
    const auto morris =
        outputIn<SensitivityOutput>(writeOutput(path("morris"), "sensitivity.json", kMorrisOutput));
    QVERIFY(morris.isMorris);
    QCOMPARE(morris.results.size(), std::size_t{2});
    const SensitivityOutput::Factor& first = morris.results[0].factors[0];
    QCOMPARE(first.importance, 2.5);
    QCOMPARE(first.deviation, 0.75);
    QCOMPARE(first.to, 1.2);
    QCOMPARE(morris.results[1].factors[0].from, 0.25);  // found by its path
    QCOMPARE(morris.results[1].required, 12.0);
    QCOMPARE(morris.results[1].unordered.front().second, std::string("anna.radius"));
    const auto sobol =
        outputIn<SensitivityOutput>(writeOutput(path("sobol"), "sensitivity.json", kSobolOutput));
    QVERIFY(!sobol.isMorris);
    QCOMPARE(sobol.results[0].factors[0].first, 0.25);
    QCOMPARE(sobol.results[0].factors[0].importanceInterval.high, 1.0);
  }

  void search_isReadAsWritten() {
    const auto search =
        outputIn<SearchOutput>(writeOutput(path("search"), "archive.json", kSearchOutput));
    QCOMPARE(search.failures.size(), std::size_t{2});
    QCOMPARE(search.failures[0].changes,  // without the list of agents
             (std::vector<std::string>{"robot1.max_vel=0.9", "variation.preset=none"}));
    QCOMPARE(search.failures[0].end, 4.5);
    QVERIFY(!search.failures[1].isMinimal && !search.failures[1].isRepeated);
    QCOMPARE(search.unavoidable, std::size_t{3});
    QCOMPARE(search.cells.size(), std::size_t{2});
    QVERIFY(!search.worst);
    const auto worst =
        outputIn<SearchOutput>(writeOutput(path("worst"), "archive.json", kWorstOutput));
    QVERIFY(worst.worst.has_value());
    QCOMPARE(worst.worst->changes, std::vector<std::string>{"robot1.max_vel=0.7"});
    QCOMPARE(worst.worstValue, 0.25);
  }

  void cover_isReadAsWritten() {
    const auto cover =
        outputIn<CoverOutput>(writeOutput(path("cover"), "archive.json", kCoverOutput));
    QCOMPARE(cover.reached, std::size_t{6});
    QCOMPARE(cover.trees.size(), std::size_t{2});
    QCOMPARE(cover.trees[0].neverReached, std::vector<std::string>{"Main/Fallback/Run"});
    QCOMPARE(cover.coveringRuns[0].nodes, (std::vector<std::string>{"1: Main", "2: Nav"}));
    QCOMPARE(cover.coveringRuns[0].play, std::string("hunavsim yard.yaml --seed 5 --duration 1"));
  }

  /// A folder, or the file in it; other files of the same name have no manifest beside them.
  void folder_isRecognised() {
    const QString folder = writeOutput(path("one"), "gate.json", kGateOutput);
    const std::string file = (folder + text("/gate.json")).toStdString();
    QCOMPARE(studyOutputFile(folder.toStdString()).value_or(""), file);
    QCOMPARE(studyOutputFile(file).value_or(""), file);
    QVERIFY(!studyOutputFile((folder + text("/manifest.json")).toStdString()));
    QFile::remove(folder + text("/manifest.json"));
    QVERIFY(!studyOutputFile(folder.toStdString()));
    QVERIFY(!studyOutputFile(file));
    QVERIFY(!studyOutputFile(path("absent").toStdString()));
  }

  void damaged_isReported_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QByteArray>("json");
    const auto changed = [](QByteArray json, const char* from, const char* to) {
      return json.replace(json.indexOf(from), static_cast<int>(qstrlen(from)), to);
    };
    QTest::newRow("cut") << QByteArray("gate.json") << QByteArray(kGateOutput).left(300);
    QTest::newRow("list") << QByteArray("tune.json") << QByteArray("[1]");
    QTest::newRow("other command") << QByteArray("tune.json") << QByteArray(kGateOutput);
    QTest::newRow("verdict") << QByteArray("gate.json")
                             << changed(kGateOutput, "\"worse\"", "\"bad\"");
    QTest::newRow("number of values")
        << QByteArray("tune.json") << changed(kTuneOutput, R"(["1.1", "2.2", "0.3"])", R"(["1"])");
    QTest::newRow("cell") << QByteArray("archive.json")
                          << changed(kSearchOutput, "[1, 1]", "[2, 1]");
    QTest::newRow("cells") << QByteArray("archive.json")
                           << changed(kSearchOutput, R"("cells": 2)", R"("cells": 2000000000)");
    QTest::newRow("method") << QByteArray("sensitivity.json")
                            << changed(kMorrisOutput, "\"morris\"", "\"guess\"");
  }
  void damaged_isReported() {
    QFETCH(QByteArray, file);
    QFETCH(QByteArray, json);
    const QString folder = path(QTest::currentDataTag());
    writeOutput(folder, file.constData(), json);
    const auto read = readStudyOutput(*studyOutputFile(folder.toStdString()));
    QVERIFY(!read);
    QCOMPARE(std::string(read.diagnostics().front().code), std::string("study.bad-output"));
    QCOMPARE(read.diagnostics().front().file,
             QDir(folder).filePath(QString::fromLatin1(file)).toStdString());
  }

  /// What the commands write is what is read.
  void commands_writeWhatIsRead() {
    writeText(path("yard.yaml"), kYard);
    writeText(path("study.yaml"),
              "hunavsim_experiment: 1\nscenarios: [yard.yaml]\nseeds: 1\nduration: 2.0\n"
              "values:\n  robot1.max_vel: {uniform: [0.4, 0.8]}\n");
    const Finished gate = runProgram(
        list("gate pursuit dwa --scenarios yard.yaml --seeds 2 --duration 2 -o g"), path("."));
    QVERIFY2(QFile::exists(path("g/gate.json")), qPrintable(gate.err));
    QCOMPARE(outputIn<GateOutput>(path("g")).candidate, std::string("dwa"));
    const Finished tune = runProgram(
        list("tune yard.yaml --seeds 1 --runs 4 --held-out-seeds 2 --duration 2 -o t"), path("."));
    QVERIFY2(tune.exitCode == 0, qPrintable(tune.err));
    QVERIFY(outputIn<TuneOutput>(path("t")).parameters.size() > 1);
    const Finished search = runProgram(
        list("search study.yaml --until-failure --runs 2 --shrink-runs 0 -o s"), path("."));
    QVERIFY2(search.exitCode == 0, qPrintable(search.err));
    QCOMPARE(outputIn<SearchOutput>(path("s")).descriptors.size(), std::size_t{2});
    const Finished cover = runProgram(list("search study.yaml --cover --runs 2 -o c"), path("."));
    QVERIFY2(cover.exitCode == 0, qPrintable(cover.err));
    QVERIFY(!outputIn<CoverOutput>(path("c")).trees.empty());
    const Finished sensitivity =
        runProgram(list("sensitivity study.yaml --points 2 --no-pdf -o m"), path("."));
    QVERIFY2(sensitivity.exitCode == 0, qPrintable(sensitivity.err));
    QCOMPARE(outputIn<SensitivityOutput>(path("m")).points, std::size_t{2});
  }

 private:
  /// A robot and a person on the open plane.
  static constexpr char kYard[] =
      "hunav_loader:\n  ros__parameters:\n    yaml_base_name: yard\n    agents: [anna]\n"
      "    anna:\n      id: 1\n      skin: 0\n      group_id: -1\n      max_vel: 1.2\n"
      "      radius: 0.3\n      init_pose: {x: 0.0, y: 0.0, z: 1.0, h: 0.0}\n"
      "      behavior: {type: Regular, configuration: 2}\n"
      "      goal_radius: 0.3\n      cyclic_goals: true\n      goals: [1]\n"
      "    global_goals:\n      1: {x: 8.0, y: 0.0, h: 0.0}\n"
      "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n    map_file: none\n"
      "    variation: {preset: strong}\n"
      "    robots: [robot1]\n    robot1:\n      planner: pursuit\n"
      "      start: {x: 3.0, y: -3.0, h: 1.5}\n      goal: {x: 3.0, y: 4.0}\n";
};

QTEST_GUILESS_MAIN(StudyOutputTest)
#include "tst_StudyOutput.moc"
