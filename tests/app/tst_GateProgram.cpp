#include <QJsonArray>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

/// A robot crosses the path of one person; 4 s long.
QByteArray scenario(const char* speed) {
  return QByteArray(
             "hunav_loader:\n"
             "  ros__parameters:\n"
             "    map: none\n"
             "    yaml_base_name: hall\n"
             "    global_goals:\n"
             "      1: {x: 3.0, y: 0.5}\n"
             "      2: {x: 3.0, y: 3.5}\n"
             "    agents: [p1]\n"
             "    p1:\n"
             "      id: 1\n"
             "      group_id: -1\n"
             "      max_vel: 1.0\n"
             "      radius: 0.3\n"
             "      goal_radius: 0.4\n"
             "      cyclic_goals: true\n"
             "      init_pose: {x: 3.0, y: 0.6, z: 1.25, h: 1.571}\n"
             "      behavior: {type: Regular, configuration: 0, goal_force_factor: 2.0,\n"
             "        obstacle_force_factor: 10.0, social_force_factor: 5.0,\n"
             "        other_force_factor: 20.0}\n"
             "      goals: [2, 1]\n"
             "hunavsim_desktop:\n"
             "  ros__parameters:\n"
             "    format: 1\n"
             "    map_file: none\n"
             "    variation: {preset: strong}\n"
             "    robots: [robot1]\n"
             "    robot1:\n"
             "      planner: pursuit\n"
             "      start: {x: 1.0, y: 2.0, h: 0.0}\n"
             "      goal: {x: 5.0, y: 2.0}\n"
             "      max_vel: ") +
         speed + "\n";
}

QJsonObject jsonOf(const QString& path) {
  return QJsonDocument::fromJson(bytesOf(path)).object();
}

/// Tests, failures and errors of a JUnit file, as its elements and as its attributes say.
QString junitCounts(const QString& path) {
  QXmlStreamReader xml(bytesOf(path));
  std::map<QString, int> counts;
  QString said;
  while (!xml.atEnd()) {
    if (xml.readNext() == QXmlStreamReader::StartElement) {
      ++counts[xml.name().toString()];
      if (xml.name() == text("testsuite")) {
        const QXmlStreamAttributes of = xml.attributes();
        said = of.value(text("tests")) + text(" ") + of.value(text("failures")) + text(" ") +
               of.value(text("errors"));
      }
    }
  }
  const QString found = QStringLiteral("%1 %2 %3")
                            .arg(counts[text("testcase")])
                            .arg(counts[text("failure")])
                            .arg(counts[text("error")]);
  return !xml.hasError() && found == said ? found : xml.errorString() + said;
}

bool isWellFormed(const QByteArray& page) {
  QXmlStreamReader xml(page);
  while (!xml.atEnd()) {
    xml.readNext();
  }
  return !xml.hasError();
}

}  // namespace

/// `hunavsim gate` from outside.
class GateProgramTest : public QObject, InFolder {
  Q_OBJECT

 private:
  /// In a folder of its own, so that command lines are equal.
  Finished gate(const QString& folder, const char* words) const {
    QDir().mkpath(path(folder));
    writeText(path(folder + text("/hall.yaml")), scenario("1.0"));
    return runProgram(list("gate") + list(words), path(folder));
  }

 private Q_SLOTS:
  void equalSides_passWithTheSameBytesForAnyJobs() {
    const char* const words[] = {
        "pursuit pursuit --scenarios hall.yaml --metric success:20% --duration 8 -o gate -j 1",
        "pursuit pursuit --scenarios hall.yaml --metric success:20% --duration 8 -o gate -j 2"};
    const Finished one = gate(text("one"), words[0]);
    QVERIFY2(one.exitCode == 0, qPrintable(one.err));
    QVERIFY2(one.out.contains(text("PASS: pursuit is not worse than pursuit")),
             qPrintable(one.out));
    QCOMPARE(gate(text("two"), words[1]).exitCode, 0);
    for (const char* name : {"gate.html", "gate.md", "gate.xml", "gate.json"}) {
      const QByteArray bytes = bytesOf(path(text("one/gate/") + text(name)));
      QVERIFY2(bytes.size() > 200, name);
      QVERIFY2(bytes == bytesOf(path(text("two/gate/") + text(name))), name);
    }
    QCOMPARE(junitCounts(path("one/gate/gate.xml")), text("1 0 0"));
    const QJsonObject json = jsonOf(path("one/gate/gate.json"));
    QCOMPARE(json[text("verdict")].toString(), text("pass"));
    const QJsonObject metric = json[text("metrics")].toArray()[0].toObject();
    QCOMPARE(metric[text("pairs")].toInt(), 16);  // 0.6 1.25^n + … >= 20
    const QJsonObject difference = metric[text("difference")].toObject();
    QCOMPARE(difference[text("mean")].toDouble(), 0.0);
    QVERIFY(difference[text("low")].toDouble() > -20.0);
    QVERIFY(bytesOf(path("one/gate/gate.html")).contains("<figure>"));
  }

  /// The page is one well-formed file; the command of the first finding repeats its run.
  void slowerCandidate_isWorseAndItsRunsCanBePlayed() {
    const Finished worse =
        gate(text("worse"),
             "robot1.max_vel=1.0 robot1.max_vel=0.6 --scenarios hall.yaml --metric "
             "time_to_reach_goal:5% --metric success:10% --duration 12 -o gate");
    QVERIFY2(worse.exitCode == 1, qPrintable(worse.err));
    QVERIFY2(worse.out.contains(text("WORSE: ")), qPrintable(worse.out));
    // Means of different kinds stand side by side.
    for (const char* words : {"Base, mean", "Candidate, mean", "Difference of pairs",
                              "one pair counts at most 10 margins"}) {
      QVERIFY2(worse.out.contains(text(words)), words);
    }
    QCOMPARE(junitCounts(path("worse/gate/gate.xml")).left(3), text("2 1"));
    QVERIFY(isWellFormed(bytesOf(path("worse/gate/gate.html"))));
    QVERIFY(bytesOf(path("worse/gate/gate.md")).contains("**worse**"));
    const QJsonObject json = jsonOf(path("worse/gate/gate.json"));
    QCOMPARE(json[text("verdict")].toString(), text("worse"));
    const QJsonObject difference =
        json[text("metrics")].toArray()[0].toObject()[text("difference")].toObject();
    QVERIFY(difference[text("low")].toDouble() > 0.0);  // slower
    QVERIFY(difference[text("mean")].toDouble() > 20.0);
    QJsonObject slow;  // the first finding about times
    const QJsonArray findings = json[text("findings")].toArray();
    for (const QJsonValue& each : findings) {
      if (slow.isEmpty() && each[text("what")].toString().startsWith(text("Time to reach"))) {
        slow = each.toObject();
      }
    }
    QStringList words = slow[text("play_candidate")].toString().split(QLatin1Char(' '));
    QCOMPARE(words.takeFirst(), text("hunavsim"));
    const Finished played = runProgram(list("run") + words + list("--json"), path("worse"));
    QVERIFY2(played.exitCode == 0, qPrintable(played.err));
    const double time = QJsonDocument::fromJson(played.out.toUtf8())
                            .object()[text("metrics")]
                            .toObject()[text("time_to_reach_goal")]
                            .toObject()[text("value")]
                            .toDouble();
    const double listed = slow[text("what")].toString().section(text(" to "), -1).toDouble();
    QVERIFY2(time > 0.0 && std::abs(time - listed) < 0.06,
             qPrintable(slow[text("what")].toString()));
  }

  void tooFewSeeds_areUndecidedAndCanBeResumed() {
    const Finished few =
        gate(text("few"),
             "pursuit pursuit --scenarios hall.yaml --metric success:20% --duration 8 --seeds 3 "
             "-o gate");
    QVERIFY2(few.exitCode == 3, qPrintable(few.err));
    QVERIFY(few.out.contains(text("UNDECIDED: 3 pairs")));
    QCOMPARE(junitCounts(path("few/gate/gate.xml")), text("1 0 1"));
    const QByteArray journal = bytesOf(path("few/gate/journal.jsonl"));
    QCOMPARE(journal.count('\n'), 4);  // program, three runs: both sides are equal
    const Finished more =
        gate(text("few"),
             "pursuit pursuit --scenarios hall.yaml --metric success:20% --duration 8 -o gate "
             "--resume");
    QVERIFY2(more.exitCode == 0, qPrintable(more.err));
    QVERIFY(bytesOf(path("few/gate/journal.jsonl")).startsWith(journal));
  }

  void folders_areComparedByName() {
    writeText(path("folders/base/hall.yaml"), scenario("1.0"));
    writeText(path("folders/base/other.yaml"), scenario("1.0"));
    writeText(path("folders/slow/hall.yaml"), scenario("0.6"));
    writeText(path("folders/slow/notes.yaml"), "a: 1\n");
    const char* const words = "base slow --metric time_to_reach_goal:5% --duration 12 --json";
    const Finished unmatched = gate(text("folders"), words);
    QCOMPARE(unexpected(unmatched, 2, text("slow")), QString());
    QVERIFY(unmatched.out.contains(text("gate.unmatched")) ||
            unmatched.err.contains(text("'other'")));
    QFile::remove(path("folders/base/other.yaml"));
    const Finished worse = gate(text("folders"), words);
    QVERIFY2(worse.exitCode == 1, qPrintable(worse.err));
    const QJsonObject json = QJsonDocument::fromJson(worse.out.toUtf8()).object();
    QCOMPARE(json[text("verdict")].toString(), text("worse"));
    QCOMPARE(json[text("scenarios")].toArray()[0].toString(), text("hall"));
  }

  void wrongInput_isReported_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const char* words, int code, const char* message) {
      QTest::newRow(name) << text(words) << code << text(message);
    };
    row("side", "pursiut pursuit --scenarios hall.yaml", 2, "did you mean 'pursuit'?");
    row("no scenarios", "pursuit dwa", 2, "--scenarios is missing");
    row("mixed", "hall.yaml dwa", 2, "'dwa' is not a scenario");
    row("scenario", "pursuit dwa --scenarios crosing_agents", 2, "crossing_agents");
    row("metric", "pursuit dwa --scenarios hall.yaml --metric sucess:5%", 64, "success");
    row("margin", "pursuit dwa --scenarios hall.yaml --metric success", 64, "KEY:MARGIN");
    row("empty folder", "empty empty", 2, "contains no scenarios");
    row("value", "robot1.max_vel=1 robot1.max_vle=1 --scenarios hall.yaml", 64, "robot1.max_vle");
    row("level", "pursuit dwa --scenarios hall.yaml --level 2", 64, "--level");
    row("no values",
        "pursuit dwa --scenarios hall.yaml --duration 1 --seeds 2 --metric time_to_reach_goal:5%",
        2, "no run of the first pairs has a value of 'time_to_reach_goal'");
  }
  void wrongInput_isReported() {
    QFETCH(QString, words);
    QFETCH(int, exitCode);
    QFETCH(QString, message);
    QDir().mkpath(path("wrong/empty"));
    QCOMPARE(unexpected(gate(text("wrong"), words.toUtf8().constData()), exitCode, message),
             QString());
  }
};

QTEST_GUILESS_MAIN(GateProgramTest)
#include "tst_GateProgram.moc"
