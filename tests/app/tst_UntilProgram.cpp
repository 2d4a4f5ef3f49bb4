#include <QJsonDocument>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

/// `hunavsim batch` of experiments with a stopping rule.
class UntilProgramTest : public QObject, InFolder {
  Q_OBJECT

 private:
  QString experiment(const char* name, const char* seeds, const char* halfWidth) const {
    QString file = path(name);
    writeText(file, QByteArray("hunavsim_experiment: 1\nscenarios: [" SOURCE_DIR
                               "/maps/planners/crossing_agents.yaml]\nduration: 0.5\nseeds: ") +
                        seeds + "\nuntil: {metric: completed, halfwidth: " + halfWidth + "}\n");
    return file;
  }
  QJsonObject manifestOf(const char* name) const {
    return QJsonDocument::fromJson(bytesOf(path(name) + text("/manifest.json"))).object();
  }

 private Q_SLOTS:
  /// No robot arrives in half a second: the upper end of the interval is below 0.4 as soon as
  /// 0.3 (5/3)^n + … >= 40, that is after 10 seeds; the batch looks after 16.
  void batch_enoughSeeds_endsEarlyWithTheSameBytes() {
    const QString file = experiment("study.yaml", "100", "0.2");
    for (const char* jobs : {"1", "2"}) {
      const Finished batch = runProgram("batch % -o % --jobs %", {file, path(jobs), text(jobs)});
      QVERIFY2(batch.exitCode == 0, qPrintable(batch.err));
      QVERIFY2(batch.out.contains(text("16 seeds were enough")), qPrintable(batch.out));
    }
    for (const char* name : {"/results.csv", "/manifest.json"}) {
      const QByteArray bytes = bytesOf(path("1") + text(name));
      QVERIFY(!bytes.isEmpty());
      QVERIFY2(bytes == bytesOf(path("2") + text(name)), name);
    }
    QCOMPARE(readCsv(path("1/results.csv")).size(), std::size_t{16});
    const QJsonObject manifest = manifestOf("1");
    QCOMPARE(manifest[text("status")].toString(), text("finished"));
    QCOMPARE(manifest[text("until")].toObject()[text("seeds")].toInt(), 16);
    QCOMPARE(failureOf("report % --no-pdf", {path("1")}), QString());
    QVERIFY(bytesOf(path("1/report.html")).contains("ended after 16 seeds"));
    // Finished: there is nothing to resume, and a new batch may replace it.
    QCOMPARE(failureOf("batch % -o % --resume", {file, path("1")}), QString());
    QCOMPARE(readCsv(path("1/results.csv")).size(), std::size_t{16});
    QCOMPARE(failureOf("batch % -o %", {file, path("1")}), QString());
  }

  void batch_tooFewSeeds_warns() {
    const QString file = experiment("narrow.yaml", "6", "0.05");
    const Finished batch = runProgram("batch % -o %", {file, path("narrow")});
    QCOMPARE(unexpected(batch, 0, "the largest number of seeds was not enough"), QString());
    QCOMPARE(readCsv(path("narrow/results.csv")).size(), std::size_t{6});
    QCOMPARE(manifestOf("narrow").value(text("until")).toObject().value(text("met")).toBool(true),
             false);
  }

  void batch_shardsAndScripts_areRefused() {
    const QString file = experiment("parts.yaml", "20", "0.2");
    QCOMPARE(unexpected(runProgram("batch % -o % --shard 1/2", {file, path("parts")}), 2,
                        "cannot be split"),
             QString());
    QCOMPARE(unexpected(runProgram("batch % -o % --script slurm", {file, path("parts")}), 2,
                        "cannot be split"),
             QString());
  }
};

QTEST_GUILESS_MAIN(UntilProgramTest)
#include "tst_UntilProgram.moc"
