#include <cmath>

#include "RandomScenario.h"
#include "ScenarioTest.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "tests/support/Columns.h"

using namespace sim2d;
using base::YamlNode;
using namespace scenariotest;

class ScenarioWriterTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void write_canonicalFile_sameBytes_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::newRow("plain") << QByteArray("canonical.yaml");
    QTest::newRow("block") << QByteArray("block.yaml");
  }
  void write_canonicalFile_sameBytes() {
    QFETCH(QByteArray, file);
    const std::string path = dataFile(file.constData());
    const ScenarioReading reading = readScenario(path);
    QVERIFY2(reading.ok(), qPrintable(shown(reading.diagnostics)));
    QCOMPARE(QString::fromStdString(writeScenario(reading.scenario)),
             QString::fromStdString(textOf(path)));
  }

  void write_endOfFile_newlineOnlyWithBlock() {
    Scenario scenario = readScenario(dataFile("canonical.yaml")).scenario;
    QVERIFY(writeScenario(scenario).back() != '\n');
    scenario.desktop.seed = 2;
    QVERIFY(writeScenario(scenario).back() == '\n');
  }

  void write_defaultsOnly_noBlock() {
    Scenario scenario = readScenario(dataFile("canonical.yaml")).scenario;
    const std::string plain = writeScenario(scenario);
    scenario.desktop.seed = 1;
    scenario.desktop.dt = 0.05;
    scenario.desktop.model = "sfm";
    scenario.desktop.mapRule = "humble";
    scenario.desktop.loopTrees = true;
    scenario.humans[0].ours.kind = PersonKind::Adult;
    scenario.humans[0].ours.mass = 80.0;
    scenario.humans[0].ours.startTime = 0.0;
    QCOMPARE(QString::fromStdString(writeScenario(scenario)), QString::fromStdString(plain));
  }

  void write_numbers_atLeastTheUsualDigits() {
    Scenario scenario = readScenario(dataFile("canonical.yaml")).scenario;
    scenario.humans[0].maxVel = 1.8999999999999999;
    scenario.humans[0].initPose.position = Vec2(3.484565, -0.0005);
    scenario.humans[0].radius = 2.0;
    const std::string text = writeScenario(scenario);
    for (const char* line : {"      max_vel: 1.9\n", "        x: 3.484565\n",
                             "        y: -0.0005\n", "      radius: 2.0\n"}) {
      QVERIFY2(text.find(line) != std::string::npos, line);
    }
  }

  void write_switchedOffPeople_afterTheListed() {
    Scenario scenario = readScenario(dataFile("canonical.yaml")).scenario;
    scenario.humans[0].listed = false;
    const std::string text = writeScenario(scenario);
    QVERIFY(text.find("      - anna\n") == std::string::npos);
    QVERIFY(text.find("    anna:\n") > text.find("    fred:\n"));
    const ScenarioReading again = readScenarioText(text, "canonical.yaml");
    QVERIFY(again.ok() && !again.scenario.human("anna")->listed);
  }

  void readWrite_randomScenario_same() {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      const Scenario scenario = RandomScenario(seed).make();
      const std::string text = writeScenario(scenario);
      const ScenarioReading reading = readScenarioText(text, "random.yaml");
      const QString what = QStringLiteral("seed %1\n").arg(seed) + shown(reading.diagnostics) +
                           QString::fromStdString(text);
      QVERIFY2(reading.ok(), qPrintable(what));
      QVERIFY2(reading.scenario == withoutDefaults(scenario), qPrintable(what));
      QVERIFY2(writeScenario(reading.scenario) == text, qPrintable(what));
    }
  }

  void needsQuotes_yaml11_data() {
    addColumns<QByteArray, bool>({"text", "quotes"});
    for (const char* text : {"on",    "Off",        "no",   "YES",
                             "y",     "N",          "true", "null",
                             "~",     "1e3",        "010",  "0x1F",
                             "1_000", "12:30",      "1.5",  "-3",
                             "+1",    ".5",         ".inf", "-.INF",
                             ".nan",  "2001-01-01", "",     " a",
                             "a ",    "a: b",       "a #b", "#",
                             "- a",   "?",          "[a",   "{a",
                             "a, b",  "*a",         "&a",   "!a",
                             "|",     ">",          "'",    "\"",
                             "%",     "@",          "`",    "<<",
                             "=",     "a:",         "a\nb", "a\tb",
                             "...",   "... x",      "---",  "\xEF\xBB\xBFz"}) {
      QTest::newRow(qPrintable(QStringLiteral("<%1>").arg(QString::fromUtf8(text))))
          << QByteArray(text) << true;
    }
    for (const char* text :
         {"anna", "Gazebo Classic", "agent1", "a:b", "a#b", "it's", "warehouse_2",
          "../maps/yard.yaml", "event contact", "ä", "yesterday", "nobody"}) {
      QTest::newRow(text) << QByteArray(text) << false;
    }
  }
  void needsQuotes_yaml11() {
    QFETCH(QByteArray, text);
    QFETCH(bool, quotes);
    QCOMPARE(base::needsQuotes(text.toStdString()), quotes);
    base::Diagnostics problems;
    YamlNode map;
    map.child("key") = base::stringNode(text.toStdString());
    map.items.back().key = "key";
    const YamlNode read = parseYaml(emitYaml(map), "t", problems);
    QVERIFY(problems.empty());
    QCOMPARE(QByteArray::fromStdString(read.items.at(0).text), text);
    // as the value of a key that is not ours, which is kept as a text of its own
    const YamlNode alone = parseYaml(emitYaml(map.items.at(0)), "t", problems);
    QVERIFY(problems.empty());
    QCOMPARE(QByteArray::fromStdString(alone.text), text);
  }

  void suggestedSimulator_byHeight() {
    Scenario scenario;
    QVERIFY(!suggestedSimulator(scenario));
    scenario.humans.resize(1);
    QVERIFY(!suggestedSimulator(scenario));
    scenario.humans[0].initZ = 0.01;
    QVERIFY(suggestedSimulator(scenario) == std::string("Webots"));
    scenario.humans[0].initZ = 0.0;
    QVERIFY(suggestedSimulator(scenario) == std::string("Isaac Sim"));
  }
};

QTEST_APPLESS_MAIN(ScenarioWriterTest)
#include "tst_ScenarioWriter.moc"
