#include <QtTest>

#include "app/run/ResultColumns.h"

using Strings = std::vector<std::string>;

/// What of metrics.json becomes a field of results.csv.
class ResultColumnsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void values_ofSeveralRobots_arePrefixed() {
    const app::ResultValues values = app::resultValues(
        R"({"profile": "corrected",
            "metrics": {"path_length": {"value": 7.5, "unit": "m"},
                        "completed": {"value": true, "unit": ""},
                        "spl": {"value": null, "unit": "", "why": "no goal"}},
            "robots": {"slow": {"metrics": {"path_length": {"value": 2, "unit": "m"}}},
                       "big": {"metrics": {"path_length": {"value": 0.25, "unit": "m"}}}}})");
    QCOMPARE(values.robots, (Strings{"slow", "big"}));
    const std::map<std::string, std::string> expected = {{"path_length", "7.5"},
                                                         {"completed", "True"},
                                                         {"spl", ""},
                                                         {"slow.path_length", "2"},
                                                         {"big.path_length", "0.25"}};
    QVERIFY(values.fields == expected);
  }

  /// A file that was cut short, or is something else.
  void values_ofNoMetrics_areNone_data() {
    QTest::addColumn<QByteArray>("json");
    for (const char* json : {"", "{", "[]", "{\"metrics\": 3}", "{\"robots\": [1]}",
                             "{\"metrics\": {}, \"robots\": {\"a\": 2}}"}) {
      QTest::newRow(json) << QByteArray(json);
    }
  }
  void values_ofNoMetrics_areNone() {
    QFETCH(QByteArray, json);
    QVERIFY(app::resultValues(json.toStdString()).fields.empty());
  }

  void columns_areInTheOrderOfTheRegistryRobotByRobot() {
    const std::set<std::string> present = {"spl",    "path_length", "time_to_reach_goal",
                                           "b.spl",  "a.spl",       "a.path_length",
                                           "nobody", "c.spl"};
    QCOMPARE(
        app::resultColumns(present, {"b", "a"}),
        (Strings{"time_to_reach_goal", "path_length", "spl", "b.spl", "a.path_length", "a.spl"}));
    QVERIFY(app::resultColumns({}, {"b"}).empty());
  }
};

QTEST_APPLESS_MAIN(ResultColumnsTest)
#include "tst_ResultColumns.moc"
