#include <QTemporaryDir>
#include <QtTest>

#include "metrics/Report.h"
#include "sim2d/base/Text.h"
#include "tests/metrics/MetricCases.h"

using namespace metrics;

namespace {

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

}  // namespace

/// What is not defined is null in JSON and nothing between commas: never "nan" or "inf".
class UndefinedValuesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
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
};

QTEST_APPLESS_MAIN(UndefinedValuesTest)
#include "tst_UndefinedValues.moc"
