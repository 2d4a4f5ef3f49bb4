#include <QElapsedTimer>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

using outside::bytesOf;
using outside::Finished;
using outside::runProgram;
using outside::text;
using outside::valueOf;

namespace {

QString data(const char* name) {
  return QStringLiteral(TEST_DATA_DIR "/tracks/") + text(name);
}

}  // namespace

/// `hunavsim evaluate` and `render` with files of other programs, from outside.
class EvaluateFormatsTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString path(const char* name) const { return folder_.filePath(text(name)); }

  Finished evaluate(const QString& file, const QStringList& more = {}) {
    return runProgram(
        QStringList{text("evaluate"), file, text("-o"), path("out"), text("-q"), text("--force")} +
        more);
  }
  double metric(const char* key) { return valueOf(outside::metricsOf(path("out")), text(key)); }

 private Q_SLOTS:
  /// 0.1 m per frame at 25 frames per second.
  void hdf5_rateOnTheTable_isUsed() {
    const Finished finished = evaluate(data("fps_on_table.h5"), {text("--robot"), text("1")});
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    QVERIFY(std::fabs(metric("avg_robot_linear_speed") - 2.5) < 1e-6);
    QVERIFY(std::fabs(metric("path_length") - 4.9) < 1e-6);
  }
  void hdf5_declaredRows_areRefusedAtOnce() {
    QElapsedTimer clock;
    clock.start();
    const Finished finished = evaluate(data("declares_20_million_rows.h5"));
    QCOMPARE(finished.exitCode, 2);
    QVERIFY2(finished.err.contains(text("declares 20000000 rows")), qPrintable(finished.err));
    QVERIFY(clock.elapsed() < 10000);
  }
  /// 0.12 m per frame at 10 frames per second, 1 m and 2 m from the nearer wall.
  void jupedsim_database_isNoBag() {
    const Finished finished = evaluate(data("corridor.sqlite"), {text("--robot"), text("1")});
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    QVERIFY(std::fabs(metric("avg_robot_linear_speed") - 1.2) < 1e-6);
    QVERIFY(std::fabs(metric("clearing_distance_min") - 0.65) < 1e-6);  // 1 m less the radius
    const Finished said = evaluate(data("corridor.sqlite"), {text("--format"), text("jupedsim")});
    QVERIFY2(said.exitCode == 0, qPrintable(said.err));
  }
  void bareRows_nameTheOptions() {
    QByteArray rows;
    for (int id = 1; id <= 2; ++id) {
      for (int frame = 0; frame < 5; ++frame) {
        rows += QByteArray::number(id) + " " + QByteArray::number(frame) + " " +
                QByteArray::number(10 * frame) + " " + QByteArray::number(500 * id) + " 170\n";
      }
    }
    outside::writeText(path("bare.txt"), rows);
    const Finished asked = evaluate(path("bare.txt"));
    QCOMPARE(asked.exitCode, 2);
    QVERIFY2(asked.err.contains(text("--fps F")) && asked.err.contains(text("--unit")),
             qPrintable(asked.err));
    const Finished finished = evaluate(path("bare.txt"), {text("--fps"), text("10"), text("--unit"),
                                                          text("cm"), text("--robot"), text("1")});
    QVERIFY2(finished.exitCode == 0, qPrintable(finished.err));
    QVERIFY(std::fabs(metric("avg_robot_linear_speed") - 1.0) < 1e-6);
  }

  void run_asTracks_isEvaluatedAgain() {
    const Finished run =
        runProgram({text("run"), QStringLiteral(SOURCE_DIR "/maps/planners/crossing_agents.yaml"),
                    text("--duration"), text("10"), text("-o"), path("run"), text("-q")});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    const Finished json =
        runProgram({text("render"), path("run"), text("-o"), path("run.json"), text("-q")});
    QVERIFY2(json.exitCode == 0, qPrintable(json.err));
    const Finished again = evaluate(path("run.json"));
    QVERIFY2(again.exitCode == 0, qPrintable(again.err));
    const double length = metric("path_length");
    const double distance = metric("minimum_distance_to_people");
    const Finished plain = evaluate(path("run"));
    QVERIFY2(plain.exitCode == 0, qPrintable(plain.err));
    QVERIFY(length > 1.0);
    QVERIFY(std::fabs(length - metric("path_length")) < 1e-6);
    QVERIFY(std::fabs(distance - metric("minimum_distance_to_people")) < 1e-6);
    const Finished lines = runProgram(
        {text("render"), path("run"), text("-o"), path("run.ndjson"), text("--fps"), text("5")});
    QVERIFY2(lines.exitCode == 0, qPrintable(lines.err));
    QVERIFY2(lines.err.contains(text("is written as the pedestrian")), qPrintable(lines.err));
    const QList<QByteArray> rows = bytesOf(path("run.ndjson")).split('\n');
    const QJsonObject scene =
        QJsonDocument::fromJson(rows.first()).object()[text("scene")].toObject();
    QCOMPARE(scene[text("fps")].toDouble(), 5.0);
    QCOMPARE(scene[text("e")].toInt() - scene[text("s")].toInt(), 20);
    const Finished wrong = runProgram({text("render"), path("run"), text("-o"), path("run.ndjson"),
                                       text("--width"), text("100")});
    QCOMPARE(wrong.exitCode, 64);
  }
};

QTEST_APPLESS_MAIN(EvaluateFormatsTest)
#include "tst_EvaluateFormats.moc"
