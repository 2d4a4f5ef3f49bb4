#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/FaultyProgram.h"
#include "tests/app/Nav2Yard.h"
#include "tests/app/StudyFiles.h"
#include "tests/support/CommaLocale.h"

using faults::Files;
using outside::text;

/// What surrounds the program does not come into its files: the same words, the same bytes. Without
/// what manifests tell of the clock and the command line.
class SameBytesTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir place_;
  Files usual_;  // in the environment of the tests

  QString work() const { return place_.filePath(text("w")); }
  Files made(const QProcessEnvironment& environment, const QStringList& more, const QString& jobs,
             const QString& prefix = {}) const;

 private Q_SLOTS:
  void initTestCase();
  void environment_anyOther_sameBytes_data();
  void environment_anyOther_sameBytes();
  void folder_anyOther_sameBytesButForItsName();
};

/// `prefix` before each file, as seen from the folder that the program works in: with one, that is
/// the root. `more`: what a shell does before it starts the program.
Files SameBytesTest::made(const QProcessEnvironment& environment, const QStringList& more,
                          const QString& jobs, const QString& prefix) const {
  for (const char* folder : {"run", "batch", "measured", "export", "on", "nav2"}) {
    QDir(work() + QLatin1Char('/') + text(folder)).removeRecursively();
  }
  const char* const commands[] = {"run @yard.yaml -q --duration 3 -o @run",
                                  "batch @study.yaml -q -o @batch --jobs #",
                                  "evaluate @run -q -o @measured",
                                  "convert @two_workers_agents.yaml --target isaac -q -o @export",
                                  "report @batch --no-pdf -q",
                                  "run --from @run@2 -q --seed 5 -o @on",
                                  "run @n/yard.yaml -q --duration 1 -o @nav2",
                                  "render @run -q --strip 2 -o @strip.svg",
                                  "render @run -q --plot avg_robot_linear_speed -o @plot.svg"};
  for (const char* command : commands) {
    QString line = text(command);
    line.replace(text(" @"), QLatin1Char(' ') + prefix).replace(QLatin1Char('#'), jobs);
    QProcess process;
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(prefix.isEmpty() ? work() : text("/"));
    process.start(text("sh"),
                  {text("-c"), (more + QStringList(text("exec \"$0\" ") + line)).join(text("; ")),
                   text(HUNAVSIM_PROGRAM)});
    const outside::Finished found = outside::finishedOf(process);
    if (found.exitCode != 0) {
      return {{line, found.err.toUtf8()}};
    }
  }
  return faults::filesIn(work());
}

void SameBytesTest::initTestCase() {
  outside::writeText(work() + text("/yard.yaml"), outside::kYardText);
  outside::writeNav2Yard(work() + text("/n"));
  outside::writeText(work() + text("/study.yaml"),
                     "hunavsim_experiment: 1\nscenarios: [yard.yaml]\nseeds: 3\nduration: 2.5\n"
                     "record: all\nvalues:\n  \"*.max_vel\": {normal: [1.2, 0.2, 0.6, 1.8]}\n"
                     "  robot1.planner: [pursuit, dwa]\n");
  for (const char* file :
       {"two_workers_agents.yaml", "two_workers.yaml", "two_workers.pgm",
        "two_workers_agents__agent_1_bt.xml", "two_workers_agents__agent_2_bt.xml"}) {
    outside::writeText(work() + QLatin1Char('/') + text(file),
                       outside::bytesOf(text(SOURCE_DIR "/maps/two_workers/") + text(file)));
  }
  usual_ = made(QProcessEnvironment::systemEnvironment(), {}, text("2"));
  const QByteArray first = usual_.empty() ? QByteArray() : usual_.begin()->second;
  for (const char* file :
       {"run/trajectory.csv", "batch/results.csv", "batch/report.html", "batch/runs/5/trace.json",
        "measured/metrics.json", "on/trajectory.csv", "nav2/trees.csv", "strip.svg", "plot.svg",
        "export/scenarios/two_workers_agents.yaml"}) {
    QVERIFY2(usual_.count(text(file)) > 0, (QByteArray(file) + ": " + first.left(500)).constData());
  }
}

void SameBytesTest::environment_anyOther_sameBytes_data() {
  QTest::addColumn<QStringList>("given");  // NAME=VALUE; without a value it is taken away
  QTest::addColumn<QStringList>("before");
  QTest::addColumn<QString>("jobs");
  const auto row = [](const char* name, const QStringList& given, const QStringList& before = {},
                      const char* jobs = "2") {
    QTest::newRow(name) << given << before << text(jobs);
  };
  row("as it was", {});
  row("LC_ALL=C", {text("LC_ALL=C")});
  row("LC_ALL=C.UTF-8", {text("LC_ALL=C.UTF-8")});
  row("German numbers", {text("LC_ALL=de_DE.UTF-8"), text("LANGUAGE=de")});
  row("LANG of nowhere", {text("LC_ALL"), text("LANG=xx_YY.UTF-8")});
  row("Tokyo", {text("TZ=Asia/Tokyo")}, {}, "3");
  row("St. John's", {text("TZ=America/St_Johns")}, {}, "1");
  row("no home", {text("HOME"), text("XDG_CONFIG_HOME"), text("XDG_CACHE_HOME")});
  row("a home that cannot be written",
      {text("HOME=/proc"), text("XDG_CONFIG_HOME=/proc"), text("XDG_CACHE_HOME=/proc")});
  row("umask", {}, {text("umask 077")});
  row("another platform of Qt",
      {text("QT_QPA_PLATFORM=minimal"), text("QT_SCALE_FACTOR=2"), text("QT_FONT_DPI=144")});
  row("threads", {text("OMP_NUM_THREADS=1"), text("MALLOC_PERTURB_=165")}, {}, "4");
}

void SameBytesTest::environment_anyOther_sameBytes() {
  QFETCH(QStringList, given);
  QFETCH(QStringList, before);
  QFETCH(QString, jobs);
  {
    const CommaLocale locale;  // made where the system has none
    if (given.contains(text("LC_ALL=de_DE.UTF-8")) && !locale.active()) {
      QSKIP("no locale with commas");
    }
  }
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const QString& each : given) {
    const QString name = each.section(QLatin1Char('='), 0, 0);
    if (each.contains(QLatin1Char('='))) {
      environment.insert(name, each.section(QLatin1Char('='), 1));
    } else {
      environment.remove(name);
    }
  }
  const Files found = made(environment, before, jobs);
  QVERIFY2(found.size() > 1, found.begin()->second.constData());
  QCOMPARE(faults::differences(found, usual_), QString());
}

/// Manifests tell where their inputs lie, a report with its table of failures how runs are played.
void SameBytesTest::folder_anyOther_sameBytesButForItsName() {
  const auto withoutNames = [](const Files& files) {
    Files found;
    for (const auto& [name, bytes] : files) {
      if (!name.endsWith(text("manifest.json")) && !name.endsWith(text("report.html")) &&
          !name.contains(text("tables/failures."))) {
        found[name] = bytes;
      }
    }
    return found;
  };
  const Files found =
      made(QProcessEnvironment::systemEnvironment(), {}, text("2"), work() + QLatin1Char('/'));
  QVERIFY2(found.size() > 1, found.begin()->second.constData());
  QCOMPARE(faults::differences(withoutNames(found), withoutNames(usual_)), QString());
}

QTEST_GUILESS_MAIN(SameBytesTest)
#include "tst_SameBytes.moc"
