#include <QDir>
#include <QtTest>

#include "VectorFile.h"
#include "metrics/Report.h"
#include "sim2d/base/Text.h"

using metrics::Evaluation;
using metrics::MetricParameters;
using metrics::MetricResult;
using metrics::MetricValue;
using metrics::Profile;
using vectors::Json;

namespace {

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

class GoldenVectorsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void evaluate_vector_givesExpected_data();
  void evaluate_vector_givesExpected();
  void writeEvaluatorFiles_publishedRuns_haveTheSameBytes();
};

void GoldenVectorsTest::evaluate_vector_givesExpected_data() {
  QTest::addColumn<QString>("path");
  for (const QString& folder : {QStringLiteral(TEST_DATA_DIR "/metrics"), publishedFolder()}) {
    const QDir files(folder);
    for (const QString& name : files.entryList({QStringLiteral("*.json")}, QDir::Files)) {
      QTest::newRow(name.toUtf8().constData()) << files.filePath(name);
    }
  }
}

void GoldenVectorsTest::evaluate_vector_givesExpected() {
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

void GoldenVectorsTest::writeEvaluatorFiles_publishedRuns_haveTheSameBytes() {
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

QTEST_APPLESS_MAIN(GoldenVectorsTest)
#include "tst_GoldenVectors.moc"
