#include <QImage>
#include <QTemporaryDir>
#include <QtTest>

#include "RunFiles.h"

/// The window started from outside, with words of the command line.
class WindowProgramTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void dock_beforeOrBehindTheScenario_showsItAndOpensTheFile_data() {
    QTest::addColumn<QStringList>("words");
    const QString demo = QStringLiteral("corner_cafe_agents");
    const auto dock = QStringLiteral("--dock");
    const auto issues = QStringLiteral("issues");
    QTest::newRow("behind") << QStringList{demo, dock, issues};
    QTest::newRow("before") << QStringList{dock, issues, demo};
    QTest::newRow("two before") << QStringList{dock, issues, QStringLiteral("events"), demo};
    QTest::newRow("with a sign") << QStringList{dock + QStringLiteral("=issues"), demo};
  }
  void dock_beforeOrBehindTheScenario_showsItAndOpensTheFile() {
    QFETCH(QStringList, words);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("a.png"));
    words << QStringLiteral("--at") << QStringLiteral("0") << QStringLiteral("--theme")
          << QStringLiteral("light") << QStringLiteral("--screenshot") << file;
    const outside::Finished found = outside::runProgram(words);
    QVERIFY2(found.exitCode == 0, qPrintable(found.err));
    const QImage picture(file);
    QCOMPARE(picture.size(), QSize(1280, 800));
    // Properties stood at the right edge, and the start page is white there: now it is the canvas.
    QCOMPARE(picture.pixelColor(1270, 300), QColor(0xEC, 0xEE, 0xF0));
  }

  void image_asPicture_isRefusedAtOnce() {
    const QTemporaryDir folder;
    const QString picture = folder.filePath(QStringLiteral("a.png"));
    const outside::Finished found = outside::runProgram(
        {QStringLiteral(SOURCE_DIR "/maps/reactions/reactions.pgm"), QStringLiteral("--at"),
         QStringLiteral("0"), QStringLiteral("--screenshot"), picture});
    QCOMPARE(found.exitCode, 2);
    QVERIFY2(found.err.contains(QStringLiteral("reactions.pgm: error: an image has no scale")),
             qPrintable(found.err));
    QVERIFY(!QFile::exists(picture));
  }

  void words_tooMany_areToldInOrder() {
    const outside::Finished found =
        outside::runProgram({QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml"),
                             QStringLiteral("a"), QStringLiteral("b")});
    QCOMPARE(found.exitCode, 64);
    QVERIFY2(found.err.contains(QStringLiteral("unexpected arguments: a b")),
             qPrintable(found.err));
  }

  void dock_unknown_isRefused() {
    const outside::Finished found =
        outside::runProgram({QStringLiteral("corner_cafe_agents"), QStringLiteral("--dock"),
                             QStringLiteral("nothing"), QStringLiteral("--at"), QStringLiteral("0"),
                             QStringLiteral("--screenshot"), QStringLiteral("/tmp/x.png")});
    QCOMPARE(found.exitCode, 64);
    QVERIFY2(found.err.contains(QStringLiteral("nothing")), qPrintable(found.err));
  }
};

QTEST_GUILESS_MAIN(WindowProgramTest)
#include "tst_WindowProgram.moc"
