#include <cmath>

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

using outside::bytesOf;
using outside::Finished;
using outside::metricsOf;
using outside::runProgram;
using outside::text;

namespace {

QString demo() {
  return QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
}

/// Keys of metrics that differ by more than 1e-9 (relative above 1), or are undefined in one alone.
QString different(const QJsonObject& a, const QJsonObject& b) {
  QString keys;
  for (const QString& key : a.keys()) {
    const QJsonValue x = a.value(key).toObject().value(text("value"));
    const QJsonValue y = b.value(key).toObject().value(text("value"));
    const double gap = std::fabs(x.toDouble() - y.toDouble());
    const bool isSame =
        x.type() == y.type() && (x == y || gap <= 1e-9 * std::max(1.0, std::fabs(x.toDouble())));
    keys += isSame ? QString() : key + text(" ");
  }
  return keys;
}

}  // namespace

/// Bags from outside: `run --record mcap`, `render -o x.mcap`, `evaluate BAG`.
class BagsProgramTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  QString path(const char* name) const { return folder_.filePath(text(name)); }

 private Q_SLOTS:
  void initTestCase() {
    const QStringList words = {text("run"), demo(), text("--duration"), text("8"), text("-q")};
    const Finished made =
        runProgram(words + QStringList{text("--record"), text("mcap"), text("-o"), path("run")});
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    const Finished plain = runProgram(words + QStringList{text("-o"), path("plain")});
    QVERIFY2(plain.exitCode == 0, qPrintable(plain.err));
  }

  void record_changesNothingOfTheRun() {
    for (const char* name : {"/trajectory.csv", "/events.csv", "/trees.csv", "/metrics.csv"}) {
      QVERIFY2(bytesOf(path("run") + text(name)) == bytesOf(path("plain") + text(name)), name);
    }
  }

  void record_again_takesTheBagAway() {
    const Finished made =
        runProgram({text("run"), demo(), text("--duration"), text("1"), text("-o"), path("plain"),
                    text("-q"), text("--record"), text("mcap")});
    QVERIFY2(made.exitCode == 0, qPrintable(made.err));
    QVERIFY(QFile::exists(path("plain/bag/bag_0.mcap")));
    QCOMPARE(runProgram({text("run"), demo(), text("--duration"), text("1"), text("-o"),
                         path("plain"), text("-q")})
                 .exitCode,
             0);
    QVERIFY(!QFile::exists(path("plain/bag/bag_0.mcap")));
  }

  void record_wrongWords_areTold() {
    QCOMPARE(runProgram({text("run"), demo(), text("--record"), text("mcap")}).exitCode, 64);
    QCOMPARE(
        runProgram({text("run"), demo(), text("--record"), text("bag"), text("-o"), path("no")})
            .exitCode,
        64);
    QCOMPARE(runProgram({text("run"), demo(), text("--record"), text("mcap"), text("--totals"),
                         text("-o"), path("no")})
                 .exitCode,
             64);
    QVERIFY(!QFile::exists(path("no")));
  }

  void evaluate_bag_isAsEvaluateOfTheRun() {
    const Finished run =
        runProgram({text("evaluate"), path("run"), text("-o"), path("of_run"), text("-q")});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    const Finished drawn =
        runProgram({text("render"), path("run"), text("-o"), path("drawn.mcap"), text("-q")});
    QVERIFY2(drawn.exitCode == 0, qPrintable(drawn.err));
    for (const char* source : {"run/bag", "run/bag/bag_0.mcap", "drawn.mcap"}) {
      const Finished bag =
          runProgram({text("evaluate"), path(source), text("-o"), path("of_bag"), text("-q")});
      QVERIFY2(bag.exitCode == 0 && bag.err.isEmpty(), qPrintable(bag.err));
      const QJsonObject wanted = metricsOf(path("of_run"));
      QVERIFY(wanted.size() > 30);
      const QString keys = different(wanted, metricsOf(path("of_bag")));
      QVERIFY2(keys.isEmpty(), qPrintable(keys));
    }
  }

  void evaluate_topics_areChosen() {
    const Finished bag =
        runProgram({text("evaluate"), path("run/bag"), text("--topics"),
                    text("people=/people,robot=/odom"), text("-o"), path("chosen"), text("-q")});
    QVERIFY2(bag.exitCode == 0, qPrintable(bag.err));
    const double length = outside::valueOf(metricsOf(path("chosen")), text("path_length"));
    QVERIFY(std::fabs(length - outside::valueOf(metricsOf(path("run")), text("path_length"))) <
            1e-6);
    const Finished wrong = runProgram({text("evaluate"), path("run/bag"), text("--topics"),
                                       text("robot=/odm"), text("-o"), path("no"), text("-q")});
    QCOMPARE(wrong.exitCode, 2);
    QVERIFY2(wrong.err.contains(text("/odom")), qPrintable(wrong.err));
    QCOMPARE(wrong.err.trimmed().count(QLatin1Char('\n')), 0);
    QCOMPARE(runProgram({text("evaluate"), path("run"), text("--topics"), text("robot=/odom"),
                         text("-o"), path("no")})
                 .exitCode,
             64);
  }
};

QTEST_APPLESS_MAIN(BagsProgramTest)
#include "tst_BagsProgram.moc"
