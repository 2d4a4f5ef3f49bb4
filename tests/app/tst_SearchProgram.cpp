#include <set>

#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/StudyFiles.h"

using namespace outside;

namespace {

/// A person without social forces (model of HuNavSim) whose path crosses that of the robot.
QByteArray person(const char* name, int id, const char* pose, int goal) {
  return "    " + QByteArray(name) + ":\n      id: " + QByteArray::number(id) +
         "\n      group_id: -1\n      max_vel: 1.2\n      radius: 0.3\n      goal_radius: 0.3\n"
         "      cyclic_goals: false\n      init_pose: " +
         pose +
         "\n      behavior: {type: Regular, configuration: 1, duration: 40.0, once: true, vel: "
         "0.6, dist: 0.0, goal_force_factor: 2.0, obstacle_force_factor: 10.0, "
         "social_force_factor: 0.0, other_force_factor: 0.0}\n      goals: [" +
         QByteArray::number(goal) + "]\n";
}

/// The robot's planner ignores people on its left: lea comes from there, rob from the right.
QByteArray yard() {
  return "hunav_loader:\n  ros__parameters:\n    map: none\n    global_goals:\n"
         "      1: {x: 5.0, y: -6.0}\n      2: {x: 5.0, y: 6.0}\n      3: {x: 9.0, y: 7.0}\n"
         "    agents: [lea, rob, far, way]\n" +
         person("lea", 1, "{x: 5.0, y: 5.0, z: 0.0, h: -1.57}", 1) +
         person("rob", 2, "{x: 5.0, y: -5.0, z: 0.0, h: 1.57}", 2) +
         person("far", 3, "{x: -4.0, y: 6.0, z: 0.0, h: 0.0}", 3) +
         person("way", 4, "{x: -4.0, y: 8.0, z: 0.0, h: 0.0}", 3) +
         "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n    map_file: none\n"
         "    duration: 40.0\n    model: sfm-hunav2\n    robots: [robot1]\n    robot1:\n"
         "      planner: library\n      planner_parameters:\n        file: '" TEST_OUTPUT_DIR
         "/planners/one_sided_planner.so'\n"
         "      start: {x: 0.0, y: 0.0, h: 0.0}\n      goal: {x: 10.0, y: 0.0}\n"
         "    obstacles: [pillar]\n    pillar: {kind: circle, x: 2.0, y: -4.0, radius: 0.3}\n";
}

constexpr const char* kStudy =
    "hunavsim_experiment: 1\n"
    "scenarios: [yard.yaml]\n"
    "seeds: 3\n"
    "values:\n"
    "  lea.start_time: {uniform: [0.0, 30.0]}\n"
    "  rob.start_time: {uniform: [0.0, 30.0]}\n"
    "  far.max_vel: {uniform: [0.5, 1.5]}\n"
    "  way.behavior.type: [Regular, Impassive]\n";

QJsonObject archiveOf(const QString& folder) {
  return QJsonDocument::fromJson(bytesOf(folder + text("/archive.json"))).object();
}

QJsonObject failureOfKind(const QString& folder, const QString& kind) {
  for (const auto& each : archiveOf(folder).value(text("failures")).toArray()) {
    if (each.toObject().value(text("kind")).toString() == kind) {
      return each.toObject();
    }
  }
  return {};
}

}  // namespace

/// `hunavsim search` from outside.
class SearchProgramTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString at(const char* name) const { return folder_.filePath(text(name)); }

  static QByteArray people() { return kYardText; }
  Finished cover(const QString& output, const char* more) const {
    return runProgram(list("search % -o % --cover --quiet", {at("cover.yaml"), output}) +
                      list(more));
  }
  Finished search(const QString& output, const char* more) const {
    QStringList words = list("search % -o % --allow-code --quiet", {at("study.yaml"), output});
    return runProgram(words + list(more));
  }

 private Q_SLOTS:
  void initTestCase() {
    writeText(at("yard.yaml"), yard());
    writeText(at("study.yaml"), kStudy);
    writeText(at("people.yaml"), people());
    writeText(at("cover.yaml"),
              "hunavsim_experiment: 1\nscenarios: [people.yaml]\nseeds: 2\nduration: 8.0\nvalues:\n"
              "  anna.behavior.type: [Regular, Scared, Curious]\n"
              "  robot1.max_vel: {uniform: [0.2, 1.0]}\n");
  }

  /// A planner that ignores people on its left fails because of them; one of them is enough.
  void plantedFailure_isFoundAndShrunkToOnePerson() {
    const QString out = at("planted");
    const Finished finished = search(out, "--until-failure --failures 2 --runs 500");
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    const QJsonObject failure = failureOfKind(out, text("contact-left-moving"));
    QVERIFY2(!failure.isEmpty(), bytesOf(out + text("/archive.json")).constData());
    QVERIFY(failure.value(text("found")).toObject().value(text("run")).toInt() < 500);
    QCOMPARE(failure.value(text("people_before")).toInt(), 4);
    QCOMPARE(failure.value(text("people")).toInt(), 1);
    QVERIFY(failure.value(text("repeated")).toBool());
    QVERIFY(failure.value(text("minimal")).toBool());
    QVERIFY(failure.value(text("removed")).toArray().contains(text("pillar")));
    const QByteArray page = bytesOf(out + text("/report.html"));
    QVERIFY(page.contains("failures/contact-left-moving.yaml"));
    QVERIFY(page.contains("contact with a moving person on the left"));
  }

  /// The file alone gives the failure, twice the same bytes.
  void savedFailure_run_failsInTheSameWay() {
    const QString out = at("planted");
    const QString file = out + text("/failures/contact-left-moving.yaml");
    for (const char* name : {"a", "b"}) {
      QCOMPARE(failureOf("run % --allow-code --quiet -o %", {file, at(name)}), QString());
    }
    QCOMPARE(bytesOf(at("a") + text("/trajectory.csv")),
             bytesOf(at("b") + text("/trajectory.csv")));
    const QJsonObject manifest =
        QJsonDocument::fromJson(bytesOf(at("a") + text("/manifest.json"))).object();
    QCOMPARE(manifest.value(text("reason")).toString(), text("collision: robot1 with lea"));
    const QJsonObject failure = failureOfKind(out, text("contact-left-moving"));
    QCOMPARE(manifest.value(text("simulated_seconds")).toDouble(),
             failure.value(text("simulated")).toString().toDouble());
    QCOMPARE(failureOf("check %", {file}), QString());
  }

  void anyJobsAndResumption_giveEqualBytes() {
    const char* const kMore =
        "--until-failure --failures 2 --runs 40 --shrink-runs 20 --all-contacts --jobs ";
    const QString one = at("one"), three = at("three");
    QCOMPARE(search(one, qPrintable(text(kMore) + text("1"))).exitCode, 0);
    QCOMPARE(search(three, qPrintable(text(kMore) + text("3"))).exitCode, 0);
    for (const char* name : {"/archive.json", "/runs.csv"}) {
      const QByteArray bytes = bytesOf(one + text(name));
      QVERIFY(bytes.size() > 100);
      QVERIFY2(bytes == bytesOf(three + text(name)), name);
    }
    // A part of the journal, as an interruption leaves it.
    const QByteArray before = bytesOf(one + text("/archive.json"));
    const QByteArray journal = bytesOf(one + text("/journal.jsonl"));
    const QString again = at("again");
    QVERIFY(QDir().mkpath(again));
    writeText(again + text("/journal.jsonl"), journal.left(journal.size() / 2));
    QCOMPARE(unexpected(search(again, qPrintable(text(kMore) + text("1"))), 2, "--resume"),
             QString());
    QCOMPARE(search(again, qPrintable(text(kMore) + text("1 --resume"))).exitCode, 0);
    QCOMPARE(bytesOf(again + text("/archive.json")), before);
  }

  void worst_ofAMetric_isSavedAsAScenario() {
    const QString out = at("worst");
    const Finished finished =
        search(out, "--worst minimum_distance_to_people --runs 24 --shrink-runs 0 --all-contacts");
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    const QJsonObject worst = archiveOf(out).value(text("worst_run")).toObject();
    QVERIFY(worst.value(text("value")).toDouble() < 1.0);
    QVERIFY(worst.value(text("repeated")).toBool());
    QVERIFY(QFile::exists(out + text("/failures/worst.yaml")));
    const auto rows = readCsv(out + text("/runs.csv"));
    QCOMPARE(rows.size(), std::size_t{24});
    double least = 1e9;
    for (const auto& row : rows) {
      least = std::min(least, row.at(text("value")).toDouble());
    }
    QCOMPARE(worst.value(text("value")).toDouble(), least);
  }

  /// Each node that a run was the first to execute is in trees.csv when its command is repeated.
  void cover_foundNodes_areExecutedByTheCommands() {
    const QString out = at("covered");
    const Finished finished = cover(out, "--runs 24 --jobs 2");
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    const QJsonObject archive = archiveOf(out);
    const QJsonArray runs = archive.value(text("archive")).toArray();
    QVERIFY(!runs.isEmpty());
    int found = 0;
    for (const QJsonValue& each : runs) {
      QStringList words = each.toObject().value(text("command")).toString().split(QLatin1Char(' '));
      QCOMPARE(words.takeFirst(), text("hunavsim"));
      const QString folder = at("again_") + QString::number(found);
      QCOMPARE(failureOf(words + QStringList{text("--quiet"), text("-o"), folder}), QString());
      std::set<QString> executed;
      for (const auto& row : readCsv(folder + text("/trees.csv"))) {
        const QString status = row.at(text("status"));
        if (status != text("IDLE") && status != text("SKIPPED")) {
          executed.insert(row.at(text("node")));
        }
      }
      for (const auto& node : each.toObject().value(text("nodes")).toArray()) {
        const QString path = node.toObject().value(text("node")).toString();
        QVERIFY2(executed.count(path) > 0, qPrintable(path));
        ++found;
      }
    }
    QCOMPARE(found, archive.value(text("reached")).toInt());
    int reached = 0, never = 0;
    for (const auto& row : readCsv(out + text("/coverage.csv"))) {
      reached += row.at(text("state")) == text("reached") ? 1 : 0;
      never += row.at(text("state")) == text("never") ? 1 : 0;
    }
    QCOMPARE(reached, found);
    QCOMPARE(reached + never + archive.value(text("unreachable")).toInt(),
             archive.value(text("nodes")).toInt());
    const QByteArray page = bytesOf(out + text("/report.html"));
    QVERIFY(page.contains("id=\"never\"") && page.contains("reachable nodes"));
    QCOMPARE(failureOf("trees % --agent anna --picture % --coverage %",
                       {at("people.yaml"), at("tree.svg"), out}),
             QString());
  }

  void cover_anyJobs_givesEqualBytes() {
    const QString one = at("one_job"), two = at("covered");
    QCOMPARE(cover(one, "--runs 24 --jobs 1").exitCode, 0);
    if (!QFile::exists(two)) {  // this test runs alone
      QCOMPARE(cover(two, "--runs 24 --jobs 2").exitCode, 0);
    }
    for (const char* name : {"/archive.json", "/coverage.csv", "/tree_coverage.csv", "/runs.csv"}) {
      const QByteArray bytes = bytesOf(one + text(name));
      QVERIFY(bytes.size() > 50);
      QVERIFY2(bytes == bytesOf(two + text(name)), name);
    }
  }

  void cover_shippedExperiment_isValid() {
    const Finished done =
        runProgram("check %", {text(SOURCE_DIR "/maps/library/nav2_recoveries.yaml")});
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    QVERIFY2(done.err.isEmpty(), qPrintable(done.err));
  }

  void cover_withoutTrees_isReported() {
    writeText(at("empty.yaml"), people().replace("agents: [anna, ben]", "agents: []"));
    writeText(at("cover_empty.yaml"),
              "hunavsim_experiment: 1\nscenarios: [empty.yaml]\nseeds: 2\nduration: 1.0\n");
    const Finished finished =
        runProgram("search % -o % --cover", {at("cover_empty.yaml"), at("none")});
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    QVERIFY2(finished.err.contains(text("no run has a behaviour tree")), qPrintable(finished.err));
  }

  void wrongWords_areReported() {
    QCOMPARE(cover(at("x"), "--until-failure").exitCode, 64);
    QCOMPARE(unexpected(search(at("x"), "--runs 5"), 64,
                        "one of --worst KEY, --until-failure and --cover"),
             QString());
    QCOMPARE(unexpected(search(at("x"), "--worst minimum_distance_to_peple"), 64,
                        "did you mean 'minimum_distance_to_people'"),
             QString());
    QCOMPARE(unexpected(search(at("x"),
                               "--until-failure --descriptor totl_time:0:9:3 "
                               "final_people_near:0:4:4"),
                        64, "did you mean 'total_time'"),
             QString());
    QCOMPARE(unexpected(search(at("x"),
                               "--until-failure --descriptor total_time:9:0:3 "
                               "final_people_near:0:4:4"),
                        64, "KEY:LOW:HIGH:CELLS"),
             QString());
    const Finished noCode =
        runProgram("search % -o % --until-failure", {at("study.yaml"), at("y")});
    QCOMPARE(unexpected(noCode, 2, "--allow-code"), QString());
    QVERIFY(!QFile::exists(at("x")));
  }
};

QTEST_GUILESS_MAIN(SearchProgramTest)
#include "tst_SearchProgram.moc"
