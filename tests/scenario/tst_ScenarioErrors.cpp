#include <QRegularExpression>

#include "ScenarioTest.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "tests/support/Columns.h"

using namespace sim2d;
using namespace scenariotest;

namespace {

/// The scenario knows no planners; the world hands in what they declare.
KnownNames knownNames() {
  KnownNames names = usualNames();
  for (const char* key : {"lookahead", "slow_distance", "stop_distance"}) {
    base::ParameterSpec spec;
    spec.key = key;
    spec.unit = "m";
    spec.range = base::kNotNegative;
    names.plannerParameters["pursuit"].push_back(spec);
  }
  return names;
}

}  // namespace

/// Every file of data/scenario/bad has its diagnostics beside it, line by line: what the reader
/// says and, if it could read, what the check of the meaning says.
class ScenarioErrorsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void read_badFile_saysEveryProblem_data() {
    QTest::addColumn<QString>("name");
    const QDir folder(QString::fromStdString(dataFile("bad")));
    for (const QString& file : folder.entryList({QStringLiteral("*.yaml")})) {
      QTest::newRow(qPrintable(file)) << file;
    }
  }
  void read_badFile_saysEveryProblem() {
    QFETCH(QString, name);
    const std::string path = dataFile("bad/" + name.toStdString());
    ScenarioReading reading = readScenarioText(textOf(path), name.toStdString());
    base::Diagnostics said = reading.diagnostics;
    if (reading.ok()) {
      const Surroundings surroundings = makeSurroundings(reading.scenario, OccupancyGrid());
      base::append(said,
                   checkScenario(reading.scenario, surroundings, name.toStdString(), knownNames()));
    }
    addLocations(said, reading.lines, name.toStdString());
    const QString expected =
        QString::fromStdString(path).replace(QStringLiteral(".yaml"), QStringLiteral(".txt"));
    QCOMPARE(shown(said), QString::fromStdString(textOf(expected.toStdString())));
  }

  void read_fileOfAnotherKind_saysWhatItIs_data() {
    addColumns<QByteArray, QByteArray>({"text", "said"});
    QTest::newRow("experiment") << QByteArray("hunavsim_experiment: 1\nscenarios: [yard.yaml]\n")
                                << QByteArray(
                                       "f.yaml:1:1: error: this is an experiment, not a scenario");
    QTest::newRow("map") << QByteArray("image: yard.pgm\nresolution: 0.05\n")
                         << QByteArray("f.yaml:1:1: error: this is a map, not a scenario");
    QTest::newRow("nav2") << QByteArray(
                                 "a_server:\n  ros__parameters:\n    x: 1.0\n"
                                 "b_server:\n  ros__parameters:\n    y: 1.0\n")
                          << QByteArray(
                                 "f.yaml:1:1: error: no node hunav_loader among a_server, "
                                 "b_server (give parameters of Nav2 with --nav2-params)");
  }
  void read_fileOfAnotherKind_saysWhatItIs() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, said);
    const ScenarioReading reading = readScenarioText(text.toStdString(), "f.yaml");
    QVERIFY(!reading.ok());
    QCOMPARE(reading.diagnostics.size(), std::size_t{1});
    const std::string found = reading.diagnostics.front().text();
    QVERIFY2(found.find(said.toStdString()) == 0, found.c_str());
  }

  void read_missingFile_isError() {
    const ScenarioReading reading = readScenario(dataFile("nowhere.yaml"));
    QVERIFY(!reading.ok());
    QVERIFY(reading.diagnostics.front().text().find("nowhere.yaml") != std::string::npos);
  }

  void read_folder_isError() { QVERIFY(!readScenario(dataFile("bad")).ok()); }

  void read_brokenYaml_importsNothing_data() {
    QTest::addColumn<QByteArray>("name");
    for (const char* name : {"not_yaml", "tab", "duplicate_key", "truncated_quote", "binary"}) {
      QTest::newRow(name) << QByteArray(name);
    }
  }
  void read_brokenYaml_importsNothing() {
    QFETCH(QByteArray, name);
    const ScenarioReading reading = readScenario(dataFile("bad/" + name.toStdString() + ".yaml"));
    QVERIFY(!reading.ok());
    QVERIFY(reading.scenario == Scenario{});
  }

  void read_tooManyPeople_isOneErrorWithItsPlace_data() {
    addColumns<QByteArray, QByteArray, int, QByteArray>({"open", "line", "lines", "expected"});
    QTest::newRow("names") << QByteArray("    agents:\n") << QByteArray("      - a\n") << 100001
                           << QByteArray(
                                  "many.yaml:100004:9: error: more than 100000 people in agents, "
                                  "which is the limit\n");
    QTest::newRow("blocks") << QByteArray() << QByteArray("    a#: {}\n") << 250001
                            << QByteArray(
                                   "many.yaml:250003:5: error: more than 250000 keys in one map, "
                                   "which is the limit (100000 for people)\n");
  }
  /// What comes behind is not read: a file may be larger than the memory.
  void read_tooManyPeople_isOneErrorWithItsPlace() {
    QFETCH(QByteArray, open);
    QFETCH(QByteArray, line);
    QFETCH(int, lines);
    QFETCH(QByteArray, expected);
    QByteArray text = "hunav_loader:\n  ros__parameters:\n" + open;
    for (int i = 0; i < lines; ++i) {
      text += QByteArray(line).replace('#', QByteArray::number(i));
    }
    text += "    : : not YAML any more\n";
    const ScenarioReading reading = readScenarioText(text.toStdString(), "many.yaml");
    QCOMPARE(shown(reading.diagnostics), QString::fromUtf8(expected));
    QVERIFY(reading.scenario == Scenario{});
  }

  void read_anyPrefixOfFile_endsWithScenarioOrErrors() {
    const std::string text = textOf(dataFile("block.yaml"));
    for (std::size_t length = 0; length < text.size(); length += 7) {
      const ScenarioReading reading = readScenarioText(text.substr(0, length), "cut.yaml");
      if (reading.ok()) {
        const ScenarioReading again = readScenarioText(writeScenario(reading.scenario), "cut.yaml");
        QVERIFY2(again.ok(), qPrintable(shown(again.diagnostics)));
        QVERIFY(again.scenario == reading.scenario);
      }
    }
  }

  void read_anyValueReplaced_isErrorOrCanBeWritten_data() {
    QTest::addColumn<QByteArray>("value");
    for (const char* value : {"~", "''", "nan", "010", "-1", "5e-324", "...", "[]", "{}", "|"}) {
      QTest::newRow(value) << QByteArray(value);
    }
  }
  void read_anyValueReplaced_isErrorOrCanBeWritten() {
    QFETCH(QByteArray, value);
    static const QRegularExpression kValue(QStringLiteral("(?<=[:-] )[^\\s\\[{#][^\\s#]*"));
    const QString text = QString::fromStdString(textOf(dataFile("block.yaml")));
    for (auto found = kValue.globalMatch(text); found.hasNext();) {
      const QRegularExpressionMatch match = found.next();
      QString changed = text;
      changed.replace(match.capturedStart(), match.capturedLength(), QString::fromUtf8(value));
      const ScenarioReading reading = readScenarioText(changed.toStdString(), "odd.yaml");
      if (reading.ok()) {
        const std::string written = writeScenario(reading.scenario);
        const ScenarioReading again = readScenarioText(written, "odd.yaml");
        QVERIFY2(again.ok(), qPrintable(shown(again.diagnostics)));
        QVERIFY2(again.scenario == withoutDefaults(reading.scenario), written.c_str());
      }
    }
  }
};

QTEST_APPLESS_MAIN(ScenarioErrorsTest)
#include "tst_ScenarioErrors.moc"
