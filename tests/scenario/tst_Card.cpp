#include "ScenarioTest.h"
#include "sim2d/scenario/Expectation.h"
#include "tests/support/Columns.h"

using namespace sim2d;
using namespace scenariotest;
using What = Expectation::What;

namespace {

constexpr const char* kCard =
    "    card:\n      title: Blind corner\n      family: Classics\n      purpose: People behind a "
    "corner\n      robot_task: Turn around the corner\n      people: \"Come around it, fast\"\n"
    "      outcome: Slow at the corner\n      metrics:\n        - minimum_distance_to_people\n"
    "        - success\n      difficulty: hard\n      source: Francis et al. 2025\n      licence: "
    "MIT\n      expect:\n        - anna reaches goal 1 before 12 s\n        - anna says \"hello\"\n"
    "      reviewer: kept\n";

std::string fileWith(const std::string& block) {
  return "hunav_loader:\n  ros__parameters:\n    global_goals:\n      1:\n        x: 1.000\n"
         "        y: 2.000\n    agents:\n      - anna\n    anna:\n      id: 1\n      init_pose:\n"
         "        x: 0.000\n        y: 0.000\n        h: 0.000\n      goals:\n        - 1\n"
         "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n" +
         block;
}

/// The scenario's problems with these expectations.
QStringList problemsOf(const std::string& expectation) {
  ScenarioReading reading = readScenarioText(
      fileWith("    card:\n      expect:\n        - " + expectation +
               "\n    map_file: none\n    doors:\n      - gate\n    gate:\n      x1: 0.0\n"
               "      y1: 3.0\n      x2: 1.0\n      y2: 3.0\n    areas:\n      - hall\n    hall:\n"
               "      kind: wait\n      xs:\n        - 0.0\n        - 1.0\n        - 1.0\n"
               "      ys:\n        - 0.0\n        - 0.0\n        - 1.0\n"),
      "test.yaml");
  QStringList found;
  for (const base::Diagnostic& problem :
       checkScenario(reading.scenario, makeSurroundings(reading.scenario, OccupancyGrid()),
                     "test.yaml", usualNames())) {
    if (problem.code == "card.expectation-form" || problem.code == "card.expectation-name") {
      found << QString::fromStdString(std::string(problem.code));
    }
  }
  return found;
}

}  // namespace

/// The key `card`, and the sentences below `expect`.
class CardTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void card_readAndWritten_isTheSameText() {
    const std::string text = fileWith(kCard);
    const ScenarioReading reading = readScenarioText(text, "test.yaml");
    const ScenarioCard& card = reading.scenario.desktop.card;
    QVERIFY(card.title == std::string("Blind corner"));
    QVERIFY(card.people == std::string("Come around it, fast"));
    QVERIFY(card.difficulty == Difficulty::Hard);
    QCOMPARE(card.metrics.size(), std::size_t{2});
    QCOMPARE(card.expect.at(1), std::string("anna says \"hello\""));
    QCOMPARE(writeScenario(reading.scenario), text);
  }

  void cardOf_text_isTheCardOfTheWholeFile() {
    const std::string text = fileWith(std::string(kCard) + "    seed: 3\n");
    QVERIFY(cardOf(text) == readScenarioText(text, "test.yaml").scenario.desktop.card);
    QVERIFY(cardOf(fileWith("    seed: 3\n")) == ScenarioCard());
    const std::string inOneLine = fileWith("    card: {title: Corner, metrics: [success]}\n");
    QVERIFY(cardOf(inOneLine).title == std::string("Corner"));
  }

  void card_wrongValue_isReportedAtItsLine_data() {
    addColumns<QByteArray, int>({"block", "line"});
    QTest::newRow("difficulty") << QByteArray("    card:\n      difficulty: extreme\n") << 21;
    QTest::newRow("metrics") << QByteArray("    card:\n      metrics: path_length\n") << 21;
    QTest::newRow("no map") << QByteArray("    card: text\n") << 20;
  }
  void card_wrongValue_isReportedAtItsLine() {
    QFETCH(QByteArray, block);
    QFETCH(int, line);
    const ScenarioReading reading = readScenarioText(fileWith(block.toStdString()), "test.yaml");
    QVERIFY2(base::hasErrors(reading.diagnostics), qPrintable(shown(reading.diagnostics)));
    QCOMPARE(reading.diagnostics.front().line, line);
  }

  void card_setByPath_changesTheFile() {
    Scenario scenario = readScenarioText(fileWith(""), "test.yaml").scenario;
    QVERIFY(!base::hasErrors(setValue(scenario, "card.title", "Corner")));
    QVERIFY(!base::hasErrors(setValue(scenario, "card.metrics", "[success]")));
    QVERIFY(scenario.desktop.card.title == std::string("Corner"));
    QCOMPARE(scenario.desktop.card.metrics.at(0), std::string("success"));
    QVERIFY(base::hasErrors(setValue(scenario, "card.tittle", "Corner")));
  }

  void expectation_ofEachForm_isTakenApart() {
    const auto taken = [](const char* text) { return *parseExpectation(text); };
    const Expectation reaches = taken("anna reaches goal 2 before 12.5 s");
    QVERIFY(reaches.what == What::ReachesGoal && reaches.goal == 2 && reaches.until == 12.5);
    QCOMPARE(reaches.subject, std::string("anna"));
    const Expectation yields = taken("visitor_2 yields at the door before 12 s");
    QVERIFY(yields.what == What::Stands && yields.object == "door" && yields.amount == 0.5);
    const Expectation stands = taken("anna stands at goal 3 for 2 s from 1 to 9 s");
    QVERIFY(stands.goal == 3 && stands.amount == 2.0 && stands.from == 1.0 && stands.until == 9.0);
    const Expectation near = taken("anna comes within 1.5 m of ben after 3 s");
    QVERIFY(near.what == What::Nears && near.amount == 1.5 && near.object == "ben");
    QVERIFY(near.from == 3.0 && std::isinf(near.until));
    const Expectation people = taken("3 people arrive before 60 s");
    QVERIFY(people.people == 3 && people.subject.empty() && people.what == What::Arrives);
    const Expectation never = taken("anna never touches anyone");
    QVERIFY(never.isDenied && never.object.empty() && never.what == What::Touches);
    QCOMPARE(taken("anna says \"before 5 s\" before 8 s").object, std::string("before 5 s"));
    QCOMPARE(taken("\"old man\" starts GoTo before 2 s").subject, std::string("old man"));
  }

  void expectation_ofNoForm_isAnError_data() {
    QTest::addColumn<QByteArray>("text");
    for (const char* text :
         {"anna", "anna dances", "anna reaches 2", "anna reaches goal 0", "anna arrives before",
          "anna arrives before 5", "anna arrives before -5 s", "anna arrives from 5 to 3 s",
          "0 people arrive", "anna stands at before 5 s", "anna comes within 2 m",
          "anna arrives before 5 s please", "anna arrives quickly"}) {
      QTest::newRow(text) << QByteArray(text);
    }
  }
  void expectation_ofNoForm_isAnError() {
    QFETCH(QByteArray, text);
    QVERIFY(!parseExpectation(text.toStdString()));
    QCOMPARE(problemsOf(text.toStdString()),
             QStringList({QStringLiteral("card.expectation-form")}));
  }

  void expectation_unknownNames_areErrors_data() {
    addColumns<QByteArray, int>({"text", "count"});
    QTest::newRow("all known") << QByteArray("anna stands at the gate before 3 s") << 0;
    QTest::newRow("area") << QByteArray("anna enters hall") << 0;
    QTest::newRow("person") << QByteArray("ben arrives") << 1;
    QTest::newRow("goal") << QByteArray("anna reaches goal 2") << 1;
    QTest::newRow("door is no area") << QByteArray("anna enters gate") << 1;
    QTest::newRow("partner") << QByteArray("anna hears ben") << 1;
    QTest::newRow("two") << QByteArray("ben comes within 1 m of goal 7") << 2;
  }
  void expectation_unknownNames_areErrors() {
    QFETCH(QByteArray, text);
    QFETCH(int, count);
    const QStringList found = problemsOf(text.toStdString());
    QCOMPARE(found.size(), count);
    QCOMPARE(found.filter(QStringLiteral("card.expectation-name")).size(), count);
  }
};

QTEST_APPLESS_MAIN(CardTest)
#include "tst_Card.moc"
