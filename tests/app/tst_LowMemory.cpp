#include <QtTest>

#include "tests/app/Nav2Yard.h"
#include "tests/app/RunFiles.h"
#include "tests/support/Sanitizers.h"

using namespace outside;

namespace {

constexpr int kRangeKiB = 48 * 1024;  // from where the program starts at all

/// From one start of a command to the next.
int stepKiB() {
  return qEnvironmentVariableIsSet("HUNAV_ALL_TESTS") ? 1024 : 2048;
}

/// With so much address space and no more.
Finished runWithin(int kib, const QStringList& words) {
  QProcess process;
  process.start(text("sh"), QStringList{text("-c"), text("ulimit -v $0 && exec \"$@\""),
                                        QString::number(kib), text(HUNAVSIM_PROGRAM)} +
                                words);
  return finishedOf(process);
}

/// Without a word no command begins: libraries are loaded, no more.
int leastToStart() {
  for (int kib = 64 * 1024; kib < 1024 * 1024; kib += 1024) {
    if (runWithin(kib, {text("--version")}).exitCode == 0) {
      return kib;
    }
  }
  return 0;
}

}  // namespace

/// Commands end with a line where memory does, never with a signal.
class LowMemoryTest : public QObject, protected InFolder {
  Q_OBJECT

 private:
  int least_ = 0;  // [KiB]
  bool hadTooLittle_ = false;

 private Q_SLOTS:
  void initTestCase() {
    if (kIsSanitized) {
      QSKIP("sanitizers take address space by the terabyte");
    }
    // Without memory fontconfig finds no fonts and remembers it: not for those who come after.
    writeText(path("fonts.conf"),
              "<?xml version=\"1.0\"?>\n<fontconfig><dir>/usr/share/fonts</dir><cachedir>" +
                  path("fonts").toUtf8() + "</cachedir></fontconfig>\n");
    qputenv("FONTCONFIG_FILE", path("fonts.conf").toUtf8());
    writeText(path("room.yaml"),
              "image: room.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n"
              "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.2\n");
    QByteArray pixels("P5\n1500 1500\n255\n");
    writeText(path("room.pgm"), pixels + QByteArray(1500 * 1500, '\xff'));
    const QString scenario = text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
    QCOMPARE(failureOf("run % --duration 5 -q -o %", {scenario, path("run")}), QString());
    writeNav2Yard(path("n"));
    writeText(path("e.yaml"), "hunavsim_experiment: 1\nscenarios: [" + scenario.toUtf8() +
                                  "]\nseeds: 2\nduration: 1.0\n");
    least_ = leastToStart();
    QVERIFY(least_ > 0);
  }

  void command_withLittleMemory_endsWithALine_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("from");  // [KiB] more than the least
    QTest::addColumn<int>("until");
    QTest::addColumn<int>("step");
    const QString scenario = text(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
    const auto row = [](const char* name, const QStringList& words) {
      QTest::newRow(name) << words << 0 << kRangeKiB << stepKiB();
    };
    row("check", {text("check"), scenario, text("--map"), path("room.yaml")});
    row("run", {text("run"), scenario, text("--map"), path("room.yaml"), text("--duration"),
                text("2"), text("-q"), text("--force"), text("-o"), path("again")});
    row("batch", {text("batch"), path("e.yaml"), text("--jobs"), text("2"), text("-q"),
                  text("--force"), text("-o"), path("batch")});
    row("evaluate", {text("evaluate"), path("run"), text("-q"), text("--force"), text("-o"),
                     path("evaluated")});
    // No picture: Qt's painter does not look at what malloc hands out.
    const QStringList page = list("render % -o %", {path("run"), path("run.html")});
    row("page", page);
    // Qt's plugin is in, its fonts are not: for some 150 KiB.
    QTest::newRow("page in small steps") << page << -1024 << 2048 << 32;
    QTest::newRow("window in small steps")
        << list("% --screenshot % --at 0", {scenario, path("window.png")}) << -1024 << 2048 << 32;
    row("from", {text("run"), text("--from"), path("run@3"), text("--seed"), text("5"), text("-q"),
                 text("--force"), text("-o"), path("from")});
    row("futures", {text("futures"), path("run@3"), text("--seeds"), text("2"), text("--horizon"),
                    text("1"), text("-q")});
    row("nav2", {text("run"), path("n/yard.yaml"), text("--duration"), text("1"), text("-q"),
                 text("--force"), text("-o"), path("nav2")});
    row("check of Nav2",
        {text("check"), text(TEST_DATA_DIR "/nav2/params_jazzy.yaml"), text("-q")});
    row("trees", {text("trees"), scenario, text("--force"), text("-o"), path("trees")});
  }
  void command_withLittleMemory_endsWithALine() {
    QFETCH(QStringList, words);
    QFETCH(int, from);
    QFETCH(int, until);
    QFETCH(int, step);
    int failures = 0;
    for (int kib = least_ + from; kib < least_ + until; kib += step) {
      const Finished finished = runWithin(kib, words);
      const QByteArray where = QByteArray::number(kib) + " KiB: " + finished.err.toUtf8();
      if (from < 0 && finished.err.contains(text("error while loading shared libraries"))) {
        continue;  // it has not begun
      }
      QVERIFY2(finished.exitCode == 0 || finished.exitCode == 1, where.constData());
      if (finished.exitCode != 0) {
        const QByteArray told =
            finished.err.toUtf8() + bytesOf(path("batch/results.csv"));  // of its runs
        QVERIFY2(
            told.contains("not enough memory") ||
                told.contains("error: This application failed to start because no Qt platform"),
            where.constData());
      }
      failures += finished.exitCode;
    }
    const Finished enough = runProgram(words);  // what they left is in nobody's way
    QVERIFY2(enough.exitCode == 0, qPrintable(enough.err));
    hadTooLittle_ = hadTooLittle_ || failures > 0;
  }
  void cleanupTestCase() { QVERIFY(kIsSanitized || hadTooLittle_); }
};

QTEST_APPLESS_MAIN(LowMemoryTest)
#include "tst_LowMemory.moc"
