#include <QTemporaryDir>
#include <QtTest>

#include "MetricCases.h"
#include "metrics/Report.h"
#include "sim2d/base/Text.h"

using namespace metrics;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string fileText(const QTemporaryDir& folder, const char* name) {
  const base::Result<std::string> text =
      base::readTextFile(folder.path().toStdString() + "/" + name);
  return text ? *text : "missing";
}

Evaluation evaluated(const sim2d::Trace& trace, const Selection& selection = {}) {
  return *evaluate(trace, selection, MetricParameters{});
}

Selection windowOf(const char* from, const char* until, double frequency = 0.0) {
  Selection selection;
  selection.window = {from, until, frequency};
  return selection;
}

sim2d::Trace withEvents(sim2d::Trace trace) {
  sim2d::Event say;
  say.kind = sim2d::EventKind::Say;
  say.id = 2;
  sim2d::Event arrived;
  arrived.kind = sim2d::EventKind::Arrived;
  arrived.id = -1;
  trace.events = {{10, say}, {30, arrived}};
  trace.header.robots[0].startTime = 0.25;
  return trace;
}

}  // namespace

class ReportTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void evaluatorNumber_formats_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("whole") << 4.0 << QByteArray("4.0");
    QTest::newRow("long") << 0.1 + 0.2 << QByteArray("0.30000000000000004");
    QTest::newRow("small") << 1e-7 << QByteArray("1e-07");
    QTest::newRow("fixed small") << 0.0001 << QByteArray("0.0001");
    QTest::newRow("first exponent") << 0.00001234 << QByteArray("1.234e-05");
    QTest::newRow("hundred thousand") << 100000.0 << QByteArray("100000.0");
    QTest::newRow("large") << 123456789012345680.0 << QByteArray("1.2345678901234568e+17");
    QTest::newRow("last fixed") << 1234567890123456.0 << QByteArray("1234567890123456.0");
    QTest::newRow("negative") << -2.5e-10 << QByteArray("-2.5e-10");
    QTest::newRow("negative zero") << -0.0 << QByteArray("-0.0");
    QTest::newRow("infinity") << HUGE_VAL << QByteArray("inf");
    QTest::newRow("undefined") << std::nan("") << QByteArray("");
  }

  void evaluatorNumber_formats() {
    QFETCH(double, value);
    QFETCH(QByteArray, text);
    QCOMPARE(QByteArray::fromStdString(evaluatorNumber(value, Kind::Number)), text);
  }

  void evaluate_withoutSamples_isRefused() {
    sim2d::Trace trace = cases::trace(3, 2);
    trace.frames.clear();
    QVERIFY(!evaluate(trace, Selection{}, MetricParameters{}));
    QVERIFY(!evaluate(cases::trace(3, 2), windowOf("time 100", "end"), MetricParameters{}));
    QVERIFY(!evaluate(cases::trace(3, 2), windowOf("lunch", "end"), MetricParameters{}));
  }

  void evaluate_withoutRobot_saysWhy() {
    sim2d::Trace trace = cases::trace(5, 2);
    trace.header.robots.clear();
    for (sim2d::Frame& frame : trace.frames) {
      frame.robots = {};
    }
    const Evaluation made = evaluated(trace);
    QVERIFY(!made.find("path_length")->value.value);
    QVERIFY(made.find("path_length")->value.why == "there is no robot");
    QVERIFY(made.find("avg_pedestrian_velocity")->value.value);
    // One line for all of them, instead of more than a hundred with the same reason.
    const std::string table = tableText(made);
    const auto lacking = std::count_if(
        made.results.begin(), made.results.end(),
        [](const MetricResult& result) { return result.value.why == "there is no robot"; });
    QVERIFY(lacking > 20);
    QVERIFY(contains(table, "\n" + std::to_string(lacking) +
                                " metrics of the robot are left out: there is no robot\n"));
    QVERIFY(!contains(table, "\npath_length "));
    QVERIFY(contains(table, "\navg_pedestrian_velocity "));
    Evaluation few = made;
    few.results = {*made.find("path_length"), *made.find("avg_pedestrian_velocity")};
    QVERIFY(contains(tableText(few), "\npath_length "));
    QVERIFY(!contains(tableText(few), "left out"));
  }

  /// Files have all digits, the table for people six.
  void tableText_numbers_haveSixDigits() {
    Evaluation made = evaluated(cases::trace(5, 2));
    for (MetricResult& result : made.results) {
      if (result.info.key == "path_length") {
        result.value = MetricValue(2.0 / 3.0 * 1000.0);
      }
    }
    QVERIFY(contains(tableText(made), " 666.667  m\n"));
    QVERIFY(contains(metricsCsv(made), "666.6666666666666"));
  }

  void evaluate_oneSampleWithoutPeople_neverFails() {
    for (const Profile profile : {Profile::Corrected, Profile::Hunav2}) {
      for (const int people : {0, 1}) {
        const auto made =
            evaluate(cases::trace(0, people), Selection{}, cases::parametersOf(profile));
        QVERIFY(made);
        for (const MetricResult& result : made->results) {
          QVERIFY2(result.value.value || !result.value.why.empty(), result.info.key.c_str());
        }
      }
    }
  }

  void evaluate_window_takesThePart_data() {
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("until");
    QTest::addColumn<double>("frequency");
    QTest::addColumn<double>("duration");
    QTest::addColumn<int>("samples");
    const QByteArray begin = "begin";
    const QByteArray end = "end";
    QTest::newRow("all") << begin << end << 0.0 << 2.0 << 41;
    QTest::newRow("times") << QByteArray("time 0.5") << QByteArray("time 1.0") << 0.0 << 0.5 << 11;
    QTest::newRow("event") << QByteArray("event say") << QByteArray("arrival") << 0.0 << 1.0 << 21;
    QTest::newRow("sets off") << QByteArray("goal") << end << 0.0 << 1.75 << 36;
    QTest::newRow("motion") << QByteArray("motion") << end << 0.0 << 2.0 << 41;
    QTest::newRow("10 Hz") << begin << end << 10.0 << 2.0 << 21;
    QTest::newRow("8 Hz does not drift") << begin << end << 8.0 << 2.0 << 17;
    QTest::newRow("faster than recorded") << begin << end << 100.0 << 2.0 << 41;
  }

  void evaluate_window_takesThePart() {
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, until);
    QFETCH(double, frequency);
    QFETCH(double, duration);
    QFETCH(int, samples);
    const Evaluation made = evaluated(withEvents(cases::trace(40, 2)),
                                      windowOf(from.constData(), until.constData(), frequency));
    QCOMPARE(static_cast<int>(made.times.size()), samples);
    QCOMPARE(*made.find("total_time")->value.value, duration);
  }

  void evaluate_behaviors_onlyThosePresent() {
    const Evaluation made = evaluated(cases::trace(8, 2));
    QCOMPARE(made.behaviors.size(), std::size_t{2});
    QCOMPARE(made.behaviors[0].behavior, 1);
    QCOMPARE(made.behaviors[1].behavior, 2);
    QCOMPARE(made.behaviors[0].active.size(), std::size_t{9});
    QCOMPARE(made.behaviors[0].active[4], 1.0);
    QCOMPARE(made.behaviors[0].active[5], 0.0);
    QCOMPARE(made.behaviors[0].results.size(), made.results.size());
  }

  void evaluate_ownForceFactor_countsInCorrectedOnly() {
    sim2d::Trace trace = cases::trace(5, 1);
    trace.header.humans[0].parameters = {{"social_force_factor", 4.2}};
    const auto ratio = [&trace](Profile profile) {
      const Evaluation made = *evaluate(trace, Selection{}, cases::parametersOf(profile));
      return *made.find("social_force_on_agents")->value.value /
             *made.find("social_force_on_robot")->value.value;
    };
    QCOMPARE(ratio(Profile::Corrected), 2.0);  // 4.2 / 2.1
    QCOMPARE(ratio(Profile::Hunav2), 1.0);
  }

  void toJson_undefinedAndInfinite_areNullWithReason() {
    sim2d::Trace trace = cases::trace(4, 0);
    trace.header.robots[0].goals.clear();
    const std::string text = toJson(evaluated(trace));
    QVERIFY(contains(text, "\"profile\": \"corrected\""));
    QVERIFY(contains(text,
                     "\"time_to_reach_goal\": {\n      \"value\": null,\n      \"unit\": "
                     "\"s\",\n      \"why\": \"the robot has no goal\""));
    QVERIFY(contains(text, "\"min_time_to_collision\": {\n      \"value\": null,"));
    QVERIFY(contains(text, "\"completed\": {\n      \"value\": false,"));
    QVERIFY(contains(text, "\"robot_on_person_collision\": {\n      \"value\": 0,"));
    QVERIFY(!contains(text, "NaN") && !contains(text, "inf,"));
  }

  /// The first is not named.
  void toJson_otherRobot_isNamed() {
    Evaluation made = evaluated(cases::trace(4, 0));
    QVERIFY(!contains(toJson(made), "\"robot\""));
    made.robotId = -2;
    QVERIFY(contains(toJson(made), "\"robot\": -2"));
  }

  void parseMetricsFile_missingKeys_areOn() {
    const char text[] =
        "hunav_evaluator_node:\n"
        "  ros__parameters:\n"
        "    use_sim_time: True\n"
        "    frequency: 2.0\n"
        "    result_file: 'results/r'\n"
        "    metrics:\n"
        "      path_length: False\n"
        "      completed: True\n"
        "      spl: True\n"
        "      stl: False\n";
    const base::Result<MetricsFile> file = parseMetricsFile(text, "metrics.yaml");
    QVERIFY(file);
    const auto on = [&file](const char* key) {
      return file->selection.selects(standardRegistry().find(key)->info);
    };
    QVERIFY(!on("path_length"));
    QVERIFY(on("completed"));
    QVERIFY(on("maximum_distance_to_people"));  // missing, HuNavSim's
    QVERIFY(on("social_work") && on("social_work_mean"));
    QVERIFY(on("spl"));
    QVERIFY(!on("stl"));
    QVERIFY(!on("total_time"));  // missing, ours
    QCOMPARE(file->selection.window.frequency, 2.0);
    QVERIFY(file->resultFile == "results/r");
  }

  /// A parameter file of ROS 2, whose parser takes the last value.
  void parseMetricsFile_repeatedKey_lastCounts() {
    const base::Result<MetricsFile> file =
        parseMetricsFile("metrics:\n  path_length: true\n  path_length: false\n", "m.yaml");
    QVERIFY(file);
    QVERIFY(!file->selection.selects(standardRegistry().find("path_length")->info));
    QCOMPARE(file.diagnostics().size(), std::size_t{1});
    QCOMPARE(
        file.diagnostics().front().text(),
        std::string("m.yaml:2:3: warning: key 'path_length' is repeated: the value of line 3 is "
                    "used, not that of line 2"));
  }

  void parseMetricsFile_problems_haveTheirPlace() {
    const base::Result<MetricsFile> wrong =
        parseMetricsFile("metrics:\n  path_length: maybe\nfrequency: -1\n", "m.yaml");
    QVERIFY(!wrong);
    QCOMPARE(wrong.diagnostics().size(), std::size_t{2});
    QVERIFY(contains(wrong.diagnostics()[0].text(), "m.yaml:2:16: error"));
    const base::Result<MetricsFile> unknown =
        parseMetricsFile("metrics: {path_lenght: true}", "m.yaml");
    QVERIFY(unknown);
    QVERIFY(contains(unknown.diagnostics()[0].text(), "did you mean 'path_length'?"));
    QVERIFY(!parseMetricsFile("metrics: [a, b", "m.yaml"));
  }

  void writeMetricsFile_readBack_isEqual() {
    MetricsFile file;
    file.selection.keys.emplace();
    file.selection.keys->off = {"social_work", "path_length"};
    file.selection.keys->on = {"spl"};
    file.selection.window.frequency = 1.0;
    file.resultFile = "it's \"two\"\nlines\\";
    const std::string text = writeMetricsFile(file);
    QVERIFY(contains(text, "      path_length: false\n") && contains(text, "frequency: 1.0\n"));
    const base::Result<MetricsFile> read = parseMetricsFile(text, "m.yaml");
    QVERIFY(read && read.diagnostics().empty());
    QVERIFY(read->selection.keys->off == file.selection.keys->off);
    QVERIFY(read->selection.keys->on == file.selection.keys->on);
    QVERIFY(read->resultFile == file.resultFile);
    QVERIFY(writeMetricsFile(*read) == text);
  }

  void selectionOfKeys_takesExactlyThose() {
    const base::Result<Selection> selection = selectionOfKeys({"path_length", "spl"});
    QVERIFY(selection);
    const Evaluation made = evaluated(cases::trace(5, 2), *selection);
    QCOMPARE(made.results.size(), std::size_t{2});
    QVERIFY(made.results[0].info.key == "path_length" && made.results[1].info.key == "spl");
    QVERIFY(!selectionOfKeys({"path_length", "sql", "nonsense"}));
    QCOMPARE(selectionOfKeys({"sql", "nonsense"}).diagnostics().size(), std::size_t{2});
  }

  void writeEvaluatorFiles_otherColumns_startNewFile() {
    QTemporaryDir folder;
    const std::string base = folder.path().toStdString() + "/sub/results.csv";
    Selection selection = *selectionOfKeys({"path_length"});
    selection.tag = "a, b";
    QVERIFY(writeEvaluatorFiles(evaluated(cases::trace(4, 0), selection), base, Layout::Hunav2));
    selection.runId = 1;
    QVERIFY(writeEvaluatorFiles(evaluated(cases::trace(4, 0), selection), base, Layout::Hunav2));
    selection.keys = selectionOfKeys({"completed"})->keys;
    QVERIFY(writeEvaluatorFiles(evaluated(cases::trace(4, 0), selection), base, Layout::Hunav2));
    const std::string rows = fileText(folder, "sub/results.csv");
    QVERIFY(contains(rows, "experiment_tag,run_id,path_length\n\"a, b\",0,"));
    QCOMPARE(base::split(rows, '\n').size(), std::size_t{4});
    QVERIFY(contains(fileText(folder, "sub/results_2.csv"), "experiment_tag,run_id,completed\n"));
    QVERIFY(contains(fileText(folder, "sub/results_steps_a, b_0.csv"), "time_stamps\n0.0\n0.05\n"));
  }

  void writeEvaluatorFiles_firstLayout_isTabSeparatedText() {
    QTemporaryDir folder;
    const Selection selection = *selectionOfKeys({"completed", "time_not_moving"});
    const auto written =
        writeEvaluatorFiles(evaluated(cases::trace(2, 1), selection),
                            folder.path().toStdString() + "/results", Layout::Hunav1);
    QVERIFY(written);
    QCOMPARE(written->size(), std::size_t{4});
    QVERIFY(fileText(folder, "results.txt") ==
            "experiment_tag\tcompleted\ttime_not_moving\nexp_1\tFalse\t0.0\n");
    QVERIFY(contains(fileText(folder, "results_beh_1_steps_exp_1.txt"),
                     "time_stamps\ttime_not_moving\tbehavior_active\n0.0\t0\t1\n"));
  }
};

QTEST_APPLESS_MAIN(ReportTest)
#include "tst_Report.moc"
