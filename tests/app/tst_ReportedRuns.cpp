#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/ReportFiles.h"
#include "tests/app/StudyFiles.h"

using namespace outside;
using outside::report;

/// Runs in a report: their ways on the map, contacts, and what its player has.
class ReportedRunsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Of runs that were kept: their ways on the map, and data for the player, decoded here anew.
  void report_keptRuns_canBePlayed() {
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("e.yaml"));
    writeText(experiment,
              "hunavsim_experiment: 1\nscenarios: [corner_cafe_agents]\nseeds: 2\n"
              "duration: 4.0\nrecord: all\nvalues:\n  robot1.max_vel: [0.5, 1.0]\n");
    const QString out = folder.filePath(text("out"));
    QCOMPARE(failureOf("batch % -o %", {experiment, out}), QString());
    const Finished done = report(out);
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    QVERIFY(QFile::exists(out + text("/figures/trajectories.svg")));
    const QByteArray page = bytesOf(out + text("/report.html"));
    checkPlayer(page, out + text("/runs/0/trajectory.csv"), 0.2);
    QVERIFY(!textsOf(page, "code").filter(text("hunavsim ") + out + text("/runs/0")).isEmpty());

    const QString single = folder.filePath(text("run.html"));
    QCOMPARE(failureOf("render % -o %", {out + text("/runs/0"), single}), QString());
    checkPlayer(bytesOf(single), out + text("/runs/0/trajectory.csv"), 0.1);
  }

  /// A robot that looks at nobody passes somebody who stands, 3 cm and 1 cm away, and shoves her:
  /// the second, too, is a contact to the metrics, though no body touches.
  void report_contacts_areThoseOfTheMetrics() {
    const StudyFolder yard;
    QByteArray scene = kYardText;
    scene.replace("max_vel: 1.2", "max_vel: 0.0");
    scene.replace("h: 1.5}", "h: 1.5707963}");  // along x = 3 m; together they are 0.65 m wide
    scene += "      planner: replay\n      planner_parameters:\n        file: velocities.csv\n";
    writeText(yard.path(text("yard.yaml")), scene);
    writeText(yard.path(text("velocities.csv")), "time,linear,angular\n0,0.5,0\n");
    const QString study =
        yard.writeStudy("passes.yaml",
                        "duration: 10.0\nrecord: all\nvalues:\n"
                        "  ben.init_pose.y: [9.0]\n  anna.init_pose.x: [2.32, 2.34, 2.4]\n");
    const QString out = yard.path(text("out"));
    QCOMPARE(failureOf("batch % -o %", {study, out}), QString());
    const Finished done = report(out, {text("--no-pdf")});
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    const QByteArray figure = bytesOf(out + text("/figures/contacts.svg"));
    QVERIFY2(figure.contains("yard.yaml: 2 contacts"), figure.constData());
    const QJsonArray runs = playedRuns(bytesOf(out + text("/report.html")));
    QCOMPARE(runs.size(), 3);
    int told = 0;
    for (const auto& run : runs) {
      const bool isTold = tellsContact(run.toObject());
      told += isTold ? 1 : 0;
      QVERIFY2(isTold || run.toObject().value(text("title")) == text("Run 0"), "the wrong run");
    }
    QCOMPARE(told, 2);
    const auto events = bytesOf(out + text("/runs/1/events.csv"));
    QVERIFY2(!events.contains("contact"), events.constData());
    const QString page = yard.path(text("run.html"));
    QCOMPARE(failureOf("render % -o %", {out + text("/runs/1"), page}), QString());
    QVERIFY(tellsContact(playedRuns(bytesOf(page)).at(0).toObject()));
  }

  /// 28 runs that a second does not suffice for: the player has some, and what it has is told.
  void report_manyFailures_saysWhichCanBePlayed() {
    const StudyFolder yard;
    const QString out = yard.path(text("out"));
    const QString study = yard.writeStudy("short.yaml",
                                          "duration: 1.0\nseeds: 14\nrecord: all\nvalues:\n"
                                          "  robot1.planner: [pursuit, dwa]\n");
    QCOMPARE(failureOf("batch % -o %", {study, out}), QString());
    const Finished done = report(out, {text("--no-pdf")});
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    const QByteArray page = bytesOf(out + text("/report.html"));
    QCOMPARE(textsOf(page, "button").count(text("Play")), 24 + 1);  // the player has one itself
    const QStringList captions = textsOf(page, "caption");
    QVERIFY2(!captions.filter(text("24 of the 28 can be played here")).isEmpty(),
             qPrintable(captions.join(text("|"))));
    const QJsonObject run = playedRuns(page).at(1).toObject();
    QCOMPARE(run.value(text("title")).toString(), text("Run 1"));
    QCOMPARE(run.value(text("about")).toString(), text("pursuit, yard.yaml, seed 2"));
    QVERIFY(!run.value(text("outcome")).toString().isEmpty());
    QVERIFY(textsOf(page, "td").contains(run.value(text("outcome")).toString()));
  }

  /// Of both options some can be played, though all runs of the first come first.
  void report_noFailures_playsSomeOfEachOption() {
    QTemporaryDir folder;
    const QString experiment = folder.filePath(text("e.yaml"));
    writeText(experiment,
              "hunavsim_experiment: 1\nscenarios: [corner_cafe_agents]\nseeds: 4\n"
              "duration: 1.0\nrecord: all\nvalues:\n  robot1.max_vel: [0.5, 1.0]\n");
    const QString out = folder.filePath(text("out"));
    QCOMPARE(failureOf("batch % -o %", {experiment, out}), QString());
    QByteArray results = bytesOf(out + text("/results.csv"));
    const QByteArray head = results.left(results.indexOf('\n'));
    for (const char* key : {",success,", ",completed,"}) {  // as if nobody had asked
      QVERIFY(head.contains(key));
      results.replace(key, QByteArray(",own") + QByteArray(key).mid(1));
    }
    writeText(out + text("/results.csv"), results);
    QVERIFY(QFile::remove(out + text("/manifest.json")));  // which knows what they were
    const Finished done = report(out, {text("--no-pdf")});
    QVERIFY2(done.exitCode == 0, qPrintable(done.err));
    const QByteArray page = bytesOf(out + text("/report.html"));
    QStringList told;
    for (const auto& run : playedRuns(page)) {
      told.append(run.toObject().value(text("about")).toString().section(QLatin1Char(','), 0, 0));
      QCOMPARE(run.toObject().value(text("outcome")).toString(), QString());
    }
    QCOMPARE(told, QStringList({text("robot1.max_vel 0.5"), text("robot1.max_vel 0.5"),
                                text("robot1.max_vel 1.0"), text("robot1.max_vel 1.0")}));
    QVERIFY(page.contains("The player contains 4 of the 8 runs"));
  }

 private:
  static QJsonArray playedRuns(const QByteArray& page) {
    const int from = page.indexOf("id=\"replays\">") + 13;
    return QJsonDocument::fromJson(page.mid(from, page.indexOf("</script>", from) - from)).array();
  }
  /// Of the robot and Anna, once.
  static bool tellsContact(const QJsonObject& run) {
    const QJsonArray events = run.value(text("events")).toArray();
    const auto isIt = [](const auto& event) {
      const QJsonArray parts = event.toArray();
      return parts.at(1) == text("contact") && parts.at(2) == -1 && parts.at(3) == 1;
    };
    return std::count_if(events.begin(), events.end(), isIt) == 1;
  }
  /// The robot's places in the page are those of the trajectory, to the centimetre.
  static void checkPlayer(const QByteArray& page, const QString& trajectory, double step) {
    const QJsonObject run = playedRuns(page).at(0).toObject();
    QCOMPARE(run.value(text("dt")).toDouble(), step);
    const auto samples = readTrajectory(trajectory);
    QVERIFY(samples.size() > 60);
    const QJsonArray bodies = run.value(text("bodies")).toArray();
    int compared = 0;
    for (const auto& body : bodies) {
      if (body.toObject().value(text("id")).toInt() != -1) {
        continue;
      }
      const QJsonArray d = body.toObject()
                               .value(text("stays"))
                               .toArray()
                               .at(0)
                               .toObject()
                               .value(text("d"))
                               .toArray();
      double x = 0.0;
      double y = 0.0;
      const auto stride = static_cast<int>(std::lround(step / 0.05));
      for (int k = 0; k + 2 < d.size(); k += 3) {
        x += d.at(k).toInt();
        y += d.at(k + 1).toInt();
        const int sample = k / 3 * stride;
        const auto& robot = samples[static_cast<std::size_t>(sample)].robot;
        QVERIFY(robot.has_value());
        QVERIFY(std::abs(x / 100.0 - robot->x) < 0.00501);
        QVERIFY(std::abs(y / 100.0 - robot->y) < 0.00501);
        ++compared;
      }
    }
    QVERIFY(compared > 10);
  }
};

QTEST_MAIN(ReportedRunsTest)
#include "tst_ReportedRuns.moc"
