#include <algorithm>

#include <QDir>
#include <QtTest>

#include "MetricCases.h"
#include "VectorFile.h"
#include "metrics/Report.h"
#include "sim2d/base/Text.h"

using namespace metrics;
using metrics::Evaluation;
using metrics::MetricParameters;
using metrics::MetricResult;
using metrics::MetricValue;
using metrics::Profile;
using vectors::Json;

namespace {

/// Quarter turns to the left, then a shift by whole cells; exact but for the sums.
struct Motion {
  int quarters = 0;
  Vec2 shift = Vec2::Zero();

  Vec2 turned(Vec2 vector) const {
    for (int k = 0; k < quarters; ++k) {
      vector = Vec2(-vector.y(), vector.x());
    }
    return vector;
  }
  Vec2 moved(const Vec2& point) const { return turned(point) + shift; }
};

sim2d::OccupancyGrid quarterTurned(const sim2d::OccupancyGrid& map) {
  const int width = map.height();
  const int height = map.width();
  std::vector<std::int8_t> cells(static_cast<std::size_t>(width) *
                                 static_cast<std::size_t>(height));
  for (int row = 0; row < map.height(); ++row) {
    for (int column = 0; column < map.width(); ++column) {
      const int newColumn = map.height() - 1 - row;
      cells[static_cast<std::size_t>(column) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(newColumn)] = map.isWall({column, row}) ? 100 : 0;
    }
  }
  const Vec2 corner = map.origin().position;
  const Vec2 origin(-(corner.y() + map.resolution() * map.height()), corner.x());
  return {width, height, map.resolution(), {origin, 0.0}, std::move(cells)};
}

sim2d::OccupancyGrid movedMap(sim2d::OccupancyGrid map, const Motion& motion) {
  if (map.isEmpty()) {
    return map;
  }
  for (int k = 0; k < motion.quarters; ++k) {
    map = quarterTurned(map);
  }
  std::vector<std::int8_t> cells;
  for (int row = 0; row < map.height(); ++row) {
    for (int column = 0; column < map.width(); ++column) {
      cells.push_back(map.isWall({column, row}) ? 100 : 0);
    }
  }
  const Vec2 origin = map.origin().position + motion.shift;
  return {map.width(), map.height(), map.resolution(), {origin, 0.0}, std::move(cells)};
}

template <class Columns>
void moveColumns(Columns& columns, const Motion& motion) {
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Vec2 position = motion.moved(Vec2(columns.x[k], columns.y[k]));
    const Vec2 velocity = motion.turned(Vec2(columns.vx[k], columns.vy[k]));
    columns.x[k] = position.x();
    columns.y[k] = position.y();
    columns.vx[k] = velocity.x();
    columns.vy[k] = velocity.y();
    columns.heading[k] = base::wrapToPi(columns.heading[k] + motion.quarters * base::kPi / 2.0);
  }
}

/// The whole scene: bodies, goals, map, obstacles and doors.
sim2d::Trace moved(sim2d::Trace trace, const Motion& motion) {
  for (sim2d::Frame& frame : trace.frames) {
    moveColumns(frame.humans, motion);
    moveColumns(frame.robots, motion);
  }
  for (sim2d::TraceRobot& robot : trace.header.robots) {
    for (sim2d::TraceGoal& goal : robot.goals) {
      goal.position = motion.moved(goal.position);
    }
  }
  trace.header.map = movedMap(trace.header.map, motion);
  for (sim2d::TraceObstacle& obstacle : trace.header.obstacles) {
    for (sim2d::Outline& outline : obstacle.outlines) {
      for (Vec2& point : outline.points) {
        point = motion.moved(point);
      }
    }
  }
  return trace;
}

std::vector<MetricResult> resultsOf(const sim2d::Trace& trace, Profile profile) {
  MetricParameters parameters = cases::parametersOf(profile);
  parameters.timeLimit = 9.9;  // within the records, which take 10 s
  return evaluate(trace, Selection{}, parameters)->results;
}

/// All that differs by more than the share, with both values.
std::string differences(const std::vector<MetricResult>& a, const std::vector<MetricResult>& b,
                        double share) {
  std::string text;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double left = a[k].value.value.value_or(std::nan(""));
    const double right = b[k].value.value.value_or(std::nan(""));
    const double limit = share * std::max({std::fabs(left), std::fabs(right), 1.0});
    const bool isSame = left == right || (std::isnan(left) && std::isnan(right)) ||
                        std::fabs(left - right) <= limit;
    if (!isSame) {
      text += a[k].info.key + " " + std::to_string(left) + " " + std::to_string(right) + "; ";
    }
  }
  return text;
}

sim2d::Trace openPlane() {
  sim2d::Trace trace = cases::trace(120, 6, 0.05);
  trace.header.obstacles.clear();
  trace.header.map = {};
  return trace;
}

/// Own vectors always; the published ones where they are at hand.
QString publishedFolder() {
  const QString set = QString::fromLocal8Bit(qgetenv("HUNAV_METRIC_VECTORS"));
  return set.isEmpty() ? QStringLiteral(SOURCE_DIR "/../shared/reference/metric-vectors") : set;
}

Json readJson(const QString& path) {
  const base::Result<std::string> text = base::readTextFile(path.toStdString());
  return text ? Json::parse(*text) : Json();
}

bool isClose(double actual, double expected) {
  if (std::isnan(expected) || std::isinf(expected)) {
    return std::isnan(expected) ? std::isnan(actual) : actual == expected;
  }
  const double difference = std::fabs(actual - expected);
  return difference <= 1e-9 || difference <= 1e-9 * std::fabs(expected);
}

std::string seriesProblem(const std::optional<metrics::Series>& series, const Json& expected) {
  if (!series) {
    return "has no series";
  }
  if (series->values.size() != expected.size()) {
    return "series has " + std::to_string(series->values.size()) + " values instead of " +
           std::to_string(expected.size());
  }
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (!isClose(series->values[k], vectors::numberOf(expected[k]))) {
      return "series[" + std::to_string(k) + "] is " + base::formatDouble(series->values[k]) +
             " instead of " + expected[k].dump();
    }
  }
  return "";
}

/// Empty when the value is as expected.
std::string valueProblem(const MetricValue& actual, const Json& expected) {
  if (expected.contains("error")) {
    const auto error = expected["error"].get<std::string>();
    const bool same = !actual.value && actual.why.find(error) != std::string::npos;
    return same ? "" : "should be undefined because of " + error;
  }
  const double value = actual.value.value_or(std::nan(""));
  if (!isClose(value, vectors::numberOf(expected["value"]))) {
    return "is " + base::formatDouble(value) + " instead of " + expected["value"].dump();
  }
  if (!actual.value && actual.why.empty()) {
    return "is undefined without a reason";
  }
  return expected.contains("series") ? seriesProblem(actual.series, expected["series"]) : "";
}

std::string resultsProblem(const std::vector<MetricResult>& results, const Json& expected) {
  std::string problems;
  for (const auto& [key, value] : expected.items()) {
    const auto found =
        std::find_if(results.begin(), results.end(),
                     [&k = key](const MetricResult& result) { return result.info.key == k; });
    const Json wanted = value.is_object() ? value : Json{{"value", value}};
    const std::string problem =
        found == results.end() ? "is not computed" : valueProblem(found->value, wanted);
    if (!problem.empty()) {
      problems.append(key).append(" ").append(problem).append("\n");
    }
  }
  return problems;
}

Evaluation evaluated(const Json& file, Profile profile) {
  MetricParameters parameters;
  parameters.profile = profile;
  return *metrics::evaluate(vectors::sampledRunOf(file), metrics::Selection{}, parameters);
}

/// The first line that differs; empty when the bytes are equal.
std::string layoutProblem(const std::string& actual, const std::string& expected) {
  if (actual == expected) {
    return "";
  }
  const std::vector<std::string> lines = base::split(actual, '\n');
  const std::vector<std::string> expectedLines = base::split(expected, '\n');
  for (std::size_t i = 0; i < std::min(lines.size(), expectedLines.size()); ++i) {
    if (lines[i] != expectedLines[i]) {
      return lines[i] + " instead of " + expectedLines[i];
    }
  }
  return "another number of lines";
}

/// Metrics that the original drops (no map) must be undefined with a reason.
std::string droppedProblem(const Evaluation& evaluation, const Json& expected) {
  std::string problems;
  for (const MetricResult& result : evaluation.results) {
    const bool isDropped = result.info.hunav > 0 && !expected.contains(result.info.key);
    if (isDropped && (result.value.value || result.value.why.empty())) {
      problems += result.info.key + " should be undefined\n";
    }
  }
  return problems;
}

std::string behaviorProblem(const Evaluation& evaluation, int behavior, const Json& expected) {
  const auto found = std::find_if(
      evaluation.behaviors.begin(), evaluation.behaviors.end(),
      [behavior](const metrics::BehaviorEvaluation& part) { return part.behavior == behavior; });
  if (expected.is_null() || found == evaluation.behaviors.end()) {
    return expected.is_null() == (found == evaluation.behaviors.end()) ? "" : "presence differs\n";
  }
  const metrics::Series active{found->active, metrics::Kind::Count};
  const std::string problem = seriesProblem(active, expected["behavior_active"]);
  return (problem.empty() ? "" : "behavior_active " + problem + "\n") +
         resultsProblem(found->results, expected["metrics"]);
}

}  // namespace

/// What must not change any metric.
class MetricPropertiesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void movedScene_withMap_changesNothing_data() {
    QTest::addColumn<int>("quarters");
    QTest::addColumn<int>("cellsX");
    QTest::addColumn<int>("cellsY");
    QTest::addColumn<bool>("original");
    QTest::newRow("shift") << 0 << 35 << -12 << false;
    QTest::newRow("quarter") << 1 << 0 << 0 << false;
    QTest::newRow("half") << 2 << 10 << 4 << false;
    QTest::newRow("three quarters") << 3 << -7 << 21 << false;
    QTest::newRow("shift, hunav2") << 0 << 35 << -12 << true;
    QTest::newRow("quarter, hunav2") << 1 << 0 << 0 << true;
    QTest::newRow("half, hunav2") << 2 << 10 << 4 << true;
    QTest::newRow("three quarters, hunav2") << 3 << -7 << 21 << true;
  }

  void movedScene_withMap_changesNothing() {
    QFETCH(int, quarters);
    QFETCH(int, cellsX);
    QFETCH(int, cellsY);
    QFETCH(bool, original);
    const Profile profile = original ? Profile::Hunav2 : Profile::Corrected;
    const sim2d::Trace trace = cases::trace(120, 6, 0.05);
    const double cell = trace.header.map.resolution();
    const sim2d::Trace other = moved(trace, {quarters, Vec2(cellsX * cell, cellsY * cell)});
    const std::vector<MetricResult> results = resultsOf(trace, profile);
    const std::string problem = differences(results, resultsOf(other, profile), 1e-9);
    QVERIFY2(problem.empty(), problem.c_str());
    // Somebody sees the robot past the walls of the map.
    QVERIFY(findResult(results, "surprise_visibility_cost")->value.value.value_or(0.0) > 0.0);
  }

  void movedScene_openPlane_changesNothing_data() {
    QTest::addColumn<double>("angle");
    QTest::newRow("shift") << 0.0;
    QTest::newRow("a bit") << 0.7;
    QTest::newRow("much") << -2.9;
  }

  void movedScene_openPlane_changesNothing() {
    QFETCH(double, angle);
    const sim2d::Trace trace = openPlane();
    const sim2d::Trace other = cases::moved(trace, angle, Vec2(11.0, -4.0));
    for (const Profile profile : {Profile::Corrected, Profile::Hunav2}) {
      const std::string problem =
          differences(resultsOf(trace, profile), resultsOf(other, profile), 1e-9);
      QVERIFY2(problem.empty(), problem.c_str());
    }
  }

  void otherIds_changeNothing_data() {
    QTest::addColumn<bool>("original");
    QTest::newRow("corrected") << false;
    QTest::newRow("hunav2") << true;
  }

  void otherIds_changeNothing() {
    QFETCH(bool, original);
    const Profile profile = original ? Profile::Hunav2 : Profile::Corrected;
    const sim2d::Trace trace = cases::trace(120, 6, 0.05);
    sim2d::Trace other = trace;
    for (sim2d::TraceHuman& human : other.header.humans) {
      human.id = 1000 - 7 * human.id;
    }
    const auto turn = [](auto& column) { std::reverse(column.begin(), column.end()); };
    for (sim2d::Frame& frame : other.frames) {
      sim2d::HumanColumns& humans = frame.humans;
      for (std::size_t k = 0; k < humans.size(); ++k) {
        humans.id[k] = 1000 - 7 * humans.id[k];
        humans.group[k] = humans.group[k] < 0 ? -1 : humans.group[k] + 30;
      }
      turn(humans.id);
      turn(humans.group);
      turn(humans.state);
      turn(humans.goal);
      for (std::vector<double>* column :
           {&humans.x, &humans.y, &humans.heading, &humans.vx, &humans.vy, &humans.omega}) {
        turn(*column);
      }
    }
    const std::string problem =
        differences(resultsOf(trace, profile), resultsOf(other, profile), 1e-9);
    QVERIFY2(problem.empty(), problem.c_str());
  }

  void doubleRate_changesLessThanTheBound() {
    const auto coarse = resultsOf(cases::trace(200, 6, 0.05), Profile::Corrected);
    const auto fine = resultsOf(cases::trace(400, 6, 0.025), Profile::Corrected);
    std::string problems;
    for (std::size_t k = 0; k < coarse.size(); ++k) {
      const std::optional<double>& left = coarse[k].value.value;
      const std::optional<double>& right = fine[k].value.value;
      const MetricInfo& info = coarse[k].info;
      const double change = left && right ? std::fabs(*left - *right) : 0.0;
      const double size =
          left && right ? std::max({std::fabs(*left), std::fabs(*right), 0.1}) : 1.0;
      if (left.has_value() != right.has_value() || change > info.rateBound * size) {
        problems += info.key + " " + std::to_string(left.value_or(-1e9)) + " " +
                    std::to_string(right.value_or(-1e9)) + " (" + std::to_string(change / size) +
                    "); ";
      }
    }
    QVERIFY2(problems.empty(), problems.c_str());
  }

  void idsThatComeAndGo_giveDefinedResults() {
    sim2d::Trace trace = cases::trace(60, 4, 0.05);
    for (sim2d::Frame& frame : trace.frames) {
      const int away = static_cast<int>(frame.step / 7 % 5);  // 4: nobody is away, 0: all are
      sim2d::HumanColumns kept;
      const sim2d::HumanColumns& all = frame.humans;
      for (std::size_t k = 0; k < all.size(); ++k) {
        if (away == 0 || all.id[k] == away) {
          continue;
        }
        kept.id.push_back(all.id[k]);
        kept.x.push_back(all.x[k]);
        kept.y.push_back(all.y[k]);
        kept.heading.push_back(all.heading[k]);
        kept.vx.push_back(all.vx[k]);
        kept.vy.push_back(all.vy[k]);
        kept.omega.push_back(all.omega[k]);
        kept.group.push_back(all.group[k]);
        kept.state.push_back(all.state[k]);
        kept.goal.push_back(all.goal[k]);
      }
      frame.humans = kept;
    }
    for (const Profile profile : {Profile::Corrected, Profile::Hunav2}) {
      const auto evaluation = evaluate(trace, Selection{}, cases::parametersOf(profile));
      QVERIFY(evaluation);
      for (const MetricResult& result : evaluation->results) {
        const std::optional<double>& value = result.value.value;
        QVERIFY2(value ? !std::isnan(*value) : !result.value.why.empty(), result.info.key.c_str());
      }
    }
  }

  void evaluate_vector_givesExpected_data() {
    QTest::addColumn<QString>("path");
    for (const QString& folder : {QStringLiteral(TEST_DATA_DIR "/metrics"), publishedFolder()}) {
      const QDir files(folder);
      for (const QString& name : files.entryList({QStringLiteral("*.json")}, QDir::Files)) {
        QTest::newRow(name.toUtf8().constData()) << files.filePath(name);
      }
    }
  }

  void evaluate_vector_givesExpected() {
    QFETCH(QString, path);
    const Json file = readJson(path);
    QVERIFY(file.is_object());
    const Json& expected = file["expected"];
    const Evaluation corrected = evaluated(file, Profile::Corrected);
    const Evaluation original = evaluated(file, Profile::Hunav2);
    std::string problems = resultsProblem(corrected.results, expected["corrected"]);
    if (expected.contains("hunav2")) {
      problems += resultsProblem(original.results, expected["hunav2"]);
      if (file.contains("schema")) {  // the published ones list every key
        problems += droppedProblem(original, expected["hunav2"]);
      }
    }
    if (expected.contains("extended")) {
      problems += resultsProblem(corrected.results, expected["extended"]);
    }
    if (file.contains("expected_by_behavior")) {
      for (const auto& [behavior, byProfile] : file["expected_by_behavior"].items()) {
        const Json none;
        const int number = std::stoi(behavior);
        problems +=
            behaviorProblem(corrected, number, byProfile.is_null() ? none : byProfile["corrected"]);
        problems +=
            behaviorProblem(original, number, byProfile.is_null() ? none : byProfile["hunav2"]);
      }
    }
    QVERIFY2(problems.empty(), problems.c_str());
  }

  void writeEvaluatorFiles_publishedRuns_haveTheSameBytes() {
    const QDir published(publishedFolder());
    if (!published.exists(QStringLiteral("layout"))) {
      QSKIP("the published vectors are not here (HUNAV_METRIC_VECTORS)");
    }
    struct Run {
      const char* file;
      const char* tag;
      int id;
    };
    QTemporaryDir folder;
    for (const Run& run :
         {Run{"v01_straight_pass.json", "exp_1", 0}, Run{"v06_stop_go_nonuniform.json", "exp_1", 1},
          Run{"v07_no_people.json", "exp_2", 0}}) {
      const Json file = readJson(published.filePath(QString::fromLatin1(run.file)));
      metrics::Selection selection;
      selection.tag = run.tag;
      selection.runId = run.id;
      selection.keys.emplace();
      Evaluation evaluation =
          *metrics::evaluate(vectors::sampledRunOf(file), selection, MetricParameters{});
      evaluation.behaviors.clear();
      QVERIFY(metrics::writeEvaluatorFiles(evaluation, folder.path().toStdString() + "/metrics",
                                           metrics::Layout::Hunav2));
    }
    const QDir layout(published.filePath(QStringLiteral("layout")));
    for (const QString& name : layout.entryList(QDir::Files)) {
      if (name == QStringLiteral("comparison_table.csv")) {  // of many runs; ours: batch
        continue;
      }
      const base::Result<std::string> actual =
          base::readTextFile((folder.path() + QStringLiteral("/") + name).toStdString());
      QVERIFY2(actual, name.toUtf8().constData());
      const std::string expected = *base::readTextFile(layout.filePath(name).toStdString());
      const std::string problem = layoutProblem(*actual, expected);
      QVERIFY2(problem.empty(), (name.toStdString() + ": " + problem).c_str());
    }
  }
};

QTEST_APPLESS_MAIN(MetricPropertiesTest)
#include "tst_MetricProperties.moc"
