#include <random>

#include <QTemporaryDir>
#include <QtTest>

#include "MetricCases.h"
#include "metrics/IncrementalEvaluation.h"
#include "metrics/Report.h"
#include "metrics/RunResults.h"
#include "metrics/Samples.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/Outlines.h"
#include "tests/metrics/MetricCases.h"

using namespace metrics;
using base::Vec2;
using metrics::Sample;
using metrics::SampleBuilder;

namespace {

sim2d::Trace openTrace() {
  sim2d::Trace trace = cases::trace(80, 5, 0.1);
  trace.header.obstacles.clear();
  trace.header.map = sim2d::OccupancyGrid();
  return trace;
}

std::vector<MetricResult> resultsOf(const sim2d::Trace& trace, Profile profile) {
  return evaluate(trace, Selection{}, cases::parametersOf(profile))->results;
}

constexpr int kNoPeople = 0;

/// Records that leave much undefined: a single sample, a robot without goals, nobody there.
Evaluation poor(int steps, int people, Profile profile) {
  sim2d::Trace trace = cases::trace(steps, people);
  trace.header.robots[0].goals.clear();
  return *evaluate(trace, Selection{}, cases::parametersOf(profile));
}

/// Fields that are words for no number.
QStringList strangeFields(const std::string& table) {
  QStringList strange;
  const QStringList lines = QString::fromStdString(table).split(QLatin1Char('\n'));
  for (const QString& line : lines.mid(1)) {
    for (const QString& field : line.split(QLatin1Char(','))) {
      const bool isWord = field != QLatin1String("True") && field != QLatin1String("False") &&
                          field != QLatin1String("exp_1");
      bool isNumber = false;
      const double number = field.toDouble(&isNumber);
      if (isWord && !field.isEmpty() && !(isNumber && std::isfinite(number))) {
        strange << field;
      }
    }
  }
  return strange;
}

double between(std::mt19937& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
}

sim2d::Outline boxAt(std::mt19937& random) {
  const base::Pose2 pose{{between(random, 0.0, 12.0), between(random, 0.0, 12.0)},
                         between(random, -3.0, 3.0)};
  return sim2d::boxOutline(pose, between(random, 0.1, 1.5), between(random, 0.1, 1.5));
}

std::vector<sim2d::Outline> boxes(std::mt19937& random, int count) {
  std::vector<sim2d::Outline> all;
  all.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    all.push_back(boxAt(random));
  }
  return all;
}

}  // namespace

class LiveMetricsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void values_atEveryFrame_equalOffline_data() {
    QTest::addColumn<int>("profile");
    QTest::newRow("corrected") << static_cast<int>(Profile::Corrected);
    QTest::newRow("hunav2") << static_cast<int>(Profile::Hunav2);
  }

  void values_atEveryFrame_equalOffline() {
    QFETCH(int, profile);
    const MetricParameters parameters = cases::parametersOf(static_cast<Profile>(profile));
    sim2d::Trace trace = cases::trace(60, 6);
    const std::vector<sim2d::Frame> frames = std::move(trace.frames);
    trace.frames.clear();
    FrameEvaluation live(trace.header, Selection{}, parameters);
    QVERIFY(live.values().empty());
    for (const sim2d::Frame& frame : frames) {
      live.append(frame);
      trace.frames.push_back(frame);
      if (frame.step % 10 == 0) {
        const auto offline = evaluate(trace, Selection{}, parameters);
        QVERIFY(offline);
        const std::string problem = cases::difference(live.values(), offline->results, 0.0);
        QVERIFY2(problem.empty(), problem.c_str());
      }
    }
    QCOMPARE(live.finish()->times.size(), std::size_t{61});
  }

  void evaluate_movedWorld_givesTheSame() {
    for (const Profile profile : {Profile::Corrected, Profile::Hunav2}) {
      const sim2d::Trace trace = openTrace();
      const std::string problem =
          cases::difference(resultsOf(trace, profile),
                            resultsOf(cases::moved(trace, 2.0, Vec2(3.0, -7.0)), profile), 1e-7);
      QVERIFY2(problem.empty(), problem.c_str());
    }
  }

  void evaluate_otherIds_givesTheSame() {
    sim2d::Trace renamed = openTrace();
    for (sim2d::Frame& frame : renamed.frames) {
      for (int& id : frame.humans.id) {
        id = 100 - id;
      }
    }
    for (sim2d::TraceHuman& human : renamed.header.humans) {
      human.id = 100 - human.id;
    }
    const std::string problem = cases::difference(resultsOf(openTrace(), Profile::Corrected),
                                                  resultsOf(renamed, Profile::Corrected), 1e-12);
    QVERIFY2(problem.empty(), problem.c_str());
  }

  // What the clock says, with times of our own.

  void results_fourTimes_byHand() {
    PlanningTime time;
    for (const double seconds : {0.25, 0.5, 0.75, 1.5}) {
      time.add(seconds);
    }
    // Deviations -0.5, -0.25, 0, 0.75: squares sum up to 0.875.
    const std::vector<MetricResult> results = time.results();
    QCOMPARE(results.size(), std::size_t{2});
    QVERIFY(results[0].info.key == "planning_time_mean");
    QCOMPARE(*results[0].value.value, 0.75);
    QCOMPARE(*results[1].value.value, std::sqrt(0.875 / 3.0));
  }

  void results_nothingMeasured_sayWhy() {
    for (const MetricResult& result : PlanningTime().results()) {
      QVERIFY(!result.value.value && !result.value.why.empty());
    }
  }

  void results_oneTime_hasNoDeviation() {
    PlanningTime time;
    time.add(0.25);
    QCOMPARE(*time.results()[0].value.value, 0.25);
    QVERIFY(!time.results()[1].value.value);
  }

  /// Those of two equal runs are equal to the last digit.
  void infos_areNoMetricsOfARecord() {
    for (const MetricInfo& info : planningTimeInfos()) {
      QVERIFY(standardRegistry().find(info.key) == nullptr);
      QVERIFY(metricsMarkdown().find('`' + info.key + '`') != std::string::npos);
    }
  }

  // What is not defined is null in JSON and nothing between commas: never "nan" or "inf".

  void files_ofPoorRecords_holdNumbersOnly_data() {
    QTest::addColumn<int>("steps");
    QTest::addColumn<int>("people");
    QTest::addColumn<bool>("original");
    for (const bool original : {false, true}) {
      for (const int steps : {0, 1, 2, 20}) {
        for (const int people : {kNoPeople, 1, 4}) {
          QTest::addRow("%d samples, %d people%s", steps + 1, people, original ? ", hunav2" : "")
              << steps << people << original;
        }
      }
    }
  }
  void files_ofPoorRecords_holdNumbersOnly() {
    QFETCH(int, steps);
    QFETCH(int, people);
    QFETCH(bool, original);
    const Evaluation made = poor(steps, people, original ? Profile::Hunav2 : Profile::Corrected);
    QCOMPARE(strangeFields(metricsCsv(made)), QStringList());
    QCOMPARE(strangeFields(stepsCsv(made)), QStringList());
    const QString json = QString::fromStdString(toJson(made)).toLower();
    for (const char* word : {": nan", ": inf", ": -inf"}) {
      QVERIFY2(!json.contains(QLatin1String(word)), word);
    }
    QVERIFY(json.contains(QLatin1String("\"value\": null")));
  }

  /// The original tells the distance to no goal as inf; so do its own files alone.
  void infinity_standsInTheEvaluatorsFileAlone() {
    Selection selection = *selectionOfKeys({"minimum_distance_to_target"});
    sim2d::Trace trace = cases::trace(3, 1);
    trace.header.robots[0].goals.clear();
    const Evaluation made = *evaluate(trace, selection, cases::parametersOf(Profile::Hunav2));
    QCOMPARE(QString::fromStdString(metricsCsv(made)),
             QStringLiteral("experiment_tag,run_id,minimum_distance_to_target\nexp_1,0,\n"));
    const QTemporaryDir folder;
    const std::string base = folder.filePath(QStringLiteral("results")).toStdString();
    QVERIFY(writeEvaluatorFiles(made, base, Layout::Hunav2));
    QCOMPARE(QString::fromStdString(*base::readTextFile(base + ".csv")),
             QStringLiteral("experiment_tag,run_id,minimum_distance_to_target\nexp_1,0,inf\n"));
  }

  // Who is screened from the robot: by what is drawn and by closed doors, not by walls of the map.

  void screened_isWhatDrawnObstaclesHide() {
    std::mt19937 random(7);
    sim2d::TraceHeader header;
    header.robots.push_back({});
    header.humans.push_back({});
    header.humans.back().id = 1;
    header.obstacles.push_back({"map", false, false, {}, boxes(random, 8)});
    header.obstacles.push_back({"shelves", false, false, {}, boxes(random, 6)});
    header.obstacles.push_back({"door", true, true, {10.0}, boxes(random, 3)});  // closes at 10 s
    SampleBuilder builder(header);
    int screened = 0;
    int behindMapAlone = 0;
    for (int k = 0; k < 2000; ++k) {
      sim2d::Obstacles drawn;
      drawn.add(header.obstacles[1].outlines);
      drawn.add(header.obstacles[2].outlines, k >= 1000);
      drawn.build();
      sim2d::Obstacles map;
      map.add(header.obstacles[0].outlines);
      map.build();
      const Vec2 robot(between(random, 0.0, 12.0), between(random, 0.0, 12.0));
      const Vec2 person(between(random, 0.0, 12.0), between(random, 0.0, 12.0));
      sim2d::Frame frame;
      frame.time = k < 1000 ? 5.0 : 15.0;
      frame.robots.add(-1, {robot, 0.0}, Vec2::Zero(), 0.0, sim2d::kNoGoal);
      frame.humans.add(1, {person, 0.0}, Vec2::Zero(), 0.0, sim2d::kNoGoal);
      frame.humans.group.push_back(-1);
      frame.humans.state.push_back(0);
      const Sample sample = builder.sampleOf(frame);
      const bool isHidden = !drawn.isVisible(person, robot);
      QCOMPARE(sample.people.at(0).screened, isHidden);
      screened += isHidden ? 1 : 0;
      behindMapAlone += !isHidden && !map.isVisible(person, robot) ? 1 : 0;
    }
    QVERIFY(screened > 200 && behindMapAlone > 200);
  }
};

QTEST_APPLESS_MAIN(LiveMetricsTest)
#include "tst_LiveMetrics.moc"
