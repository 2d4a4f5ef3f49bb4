#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

namespace {

/// A robot on an empty plane, 4 m from its goal.
const char* const kPlane =
    "hunav_loader:\n"
    "  ros__parameters:\n"
    "    map: none\n"
    "    agents: []\n"
    "hunavsim_desktop:\n"
    "  ros__parameters:\n"
    "    format: 1\n"
    "    map_file: none\n"
    "    duration: 60.0\n"
    "    robots: [robot1]\n"
    "    robot1:\n"
    "      start: {x: 0.0, y: 0.0, h: 0.0}\n"
    "      goal: {x: 4.0, y: 0.0}\n";

const QByteArray kScaling = "      approach_velocity_scaling_dist: 0.6\n";
const QByteArray kSabotaged = "      approach_velocity_scaling_dist: 3.0  # too early\n";

const char* const kFewParameters =
    "hunavsim_tuning: 1\n"
    "controllers:\n"
    "  nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController:\n"
    "    approach_velocity_scaling_dist: {range: [0.2, 1.5]}\n"
    "    lookahead_dist: {range: [0.3, 1.5]}\n";

QJsonObject tuneJson(const QString& path) {
  return QJsonDocument::fromJson(bytesOf(path)).object();
}

}  // namespace

/// `hunavsim tune` from outside.
class TuneProgramTest : public QObject, InFolder {
  Q_OBJECT

 private:
  Finished tune(const QString& folder, const QByteArray& parameters, const char* words,
                const QByteArray& plane = kPlane) const {
    QDir().mkpath(path(folder));
    writeText(path(folder + text("/plane.yaml")), plane);
    writeText(path(folder + text("/rpp.yaml")), parameters);
    writeText(path(folder + text("/few.yaml")), kFewParameters);
    return runProgram(list("tune rpp.yaml --scenarios plane.yaml") + list(words), path(folder));
  }
  /// The shipped file, whose robot slows down 3 m before the goal instead of 0.6 m.
  static QByteArray sabotaged() {
    QByteArray file = bytesOf(text(SOURCE_DIR "/maps/planners/nav2_rpp.yaml"));
    return file.contains(kScaling) ? file.replace(kScaling, kSabotaged) : QByteArray();
  }

 private Q_SLOTS:
  void sabotagedFile_recoversWithTheSameBytesForAnyJobs() {
    const char* const words[] = {
        "--objective time_to_reach_goal --parameters few.yaml --seeds 1 --runs 24 "
        "--held-out-seeds 2 -o out -j 1",
        "--objective time_to_reach_goal --parameters few.yaml --seeds 1 --runs 24 "
        "--held-out-seeds 2 -o out -j 2"};
    QVERIFY(!sabotaged().isEmpty());
    const Finished one = tune(text("one"), sabotaged(), words[0]);
    QVERIFY2(one.exitCode == 0, qPrintable(one.err));
    QVERIFY2(one.out.contains(text("IMPROVED: ")), qPrintable(one.out));
    QVERIFY(tuneJson(path("one/out/tune.json"))[text("improved")].toBool());
    const QList<QByteArray> before = sabotaged().split('\n');
    const QList<QByteArray> after = bytesOf(path("one/out/nav2_params.yaml")).split('\n');
    QCOMPARE(after.size(), before.size());
    int changed = 0;
    for (int k = 0; k < after.size(); ++k) {
      changed += after[k] != before[k] ? 1 : 0;
    }
    QVERIFY2(changed >= 1 && changed <= 8, qPrintable(QString::number(changed)));
    QVERIFY(bytesOf(path("one/out/nav2_params.yaml")).contains("  # too early\n"));
    QVERIFY(bytesOf(path("one/out/changes.diff")).contains("-" + kSabotaged));
    QXmlStreamReader page(bytesOf(path("one/out/report.html")));
    while (!page.atEnd()) {
      page.readNext();
    }
    QVERIFY2(!page.hasError(), qPrintable(page.errorString()));

    QCOMPARE(tune(text("two"), sabotaged(), words[1]).exitCode, 0);
    for (const char* name : {"nav2_params.yaml", "changes.diff", "tables/evaluation.csv"}) {
      QVERIFY2(bytesOf(path("one/out/") + text(name)) == bytesOf(path("two/out/") + text(name)),
               name);
    }
    const QByteArray json = bytesOf(path("two/out/tune.json"));
    const Finished again =
        runProgram(list("tune rpp.yaml --scenarios plane.yaml") + list(words[1]) + list("--resume"),
                   path("two"));
    QVERIFY2(again.exitCode == 0, qPrintable(again.err));
    QVERIFY(bytesOf(path("two/out/tune.json")) == json);
  }

  /// Nothing can be gained if the robot starts at its goal.
  void noImprovement_fileIsUnchanged() {
    const QByteArray file = bytesOf(text(SOURCE_DIR "/maps/planners/nav2_rpp.yaml"));
    QByteArray plane = kPlane;
    plane.replace("x: 4.0", "x: 0.05");
    const Finished none =
        tune(text("none"), file,
             "--parameters few.yaml --seeds 1 --runs 20 --held-out-seeds 2 -o out", plane);
    QVERIFY2(none.exitCode == 0, qPrintable(none.err));
    QVERIFY2(none.out.contains(text("NO IMPROVEMENT FOUND")), qPrintable(none.out));
    QCOMPARE(bytesOf(path("none/out/nav2_params.yaml")), file);
    QVERIFY(!tuneJson(path("none/out/tune.json"))[text("improved")].toBool(true));
  }

  void limitTooSmall_isReported() {
    const QByteArray file = bytesOf(text(SOURCE_DIR "/maps/planners/nav2_rpp.yaml"));
    const Finished untried =
        tune(text("untried"), file,
             "--parameters few.yaml --seeds 1 --runs 5 --held-out-seeds 2 -o out", kPlane);
    QVERIFY2(untried.exitCode == 0, qPrintable(untried.err));
    QVERIFY2(untried.out.contains(text("NOTHING TRIED: a limit of 5 runs is too small for 1 "
                                       "scenario with 1 seed each")),
             qPrintable(untried.out));
  }

  void wrongInput_isReported() {
    const QByteArray file = bytesOf(text(SOURCE_DIR "/maps/planners/nav2_rpp.yaml"));
    QCOMPARE(unexpected(tune(text("bad"), file, "--objective time_to_reach_gaol -o out"), 64,
                        text("did you mean 'time_to_reach_goal'")),
             QString());
    QCOMPARE(
        unexpected(tune(text("bad"), "controller_server: [1\n", "-o out"), 2, text("rpp.yaml")),
        QString());
    QCOMPARE(unexpected(runProgram(list("tune rpp.yaml -o out2"), path("bad")), 64,
                        text("name them with --scenarios")),
             QString());
    QVERIFY(!QFileInfo::exists(path("bad/out/tune.json")));
  }
};

QTEST_GUILESS_MAIN(TuneProgramTest)
#include "tst_TuneProgram.moc"
