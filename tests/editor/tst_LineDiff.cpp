#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "editor/document/LineDiff.h"
#include "sim2d/base/Text.h"

using editor::DiffLine;
using editor::lineDiff;

class LineDiffTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void lineDiff_texts_giveTheFewestChanges_data() {
    QTest::addColumn<QByteArray>("left");
    QTest::addColumn<QByteArray>("right");
    QTest::addColumn<QByteArray>("expected");
    QTest::newRow("equal") << QByteArray("a\nb\n") << QByteArray("a\nb\n") << QByteArray(" a b");
    QTest::newRow("both empty") << QByteArray() << QByteArray() << QByteArray();
    QTest::newRow("from nothing") << QByteArray() << QByteArray("a\nb") << QByteArray("+a+b");
    QTest::newRow("to nothing") << QByteArray("a\nb\n") << QByteArray() << QByteArray("-a-b");
    QTest::newRow("one put in") << QByteArray("a\nc\n") << QByteArray("a\nb\nc\n")
                                << QByteArray(" a+b c");
    QTest::newRow("replaced") << QByteArray("a\nb\nc\n") << QByteArray("a\nx\nc\n")
                              << QByteArray(" a-b+x c");
    QTest::newRow("moved") << QByteArray("a\nb\nc\nd\n") << QByteArray("b\nc\nd\na\n")
                           << QByteArray("-a b c d+a");
    QTest::newRow("all different")
        << QByteArray("a\nb\n") << QByteArray("x\ny\n") << QByteArray("-a-b+x+y");
    QTest::newRow("no newline at the end")
        << QByteArray("a\nb") << QByteArray("a\nb\nc") << QByteArray(" a b+c");
  }
  void lineDiff_texts_giveTheFewestChanges() {
    QFETCH(QByteArray, left);
    QFETCH(QByteArray, right);
    QFETCH(QByteArray, expected);
    QByteArray found;
    for (const DiffLine& line : lineDiff(left.toStdString(), right.toStdString())) {
      found += " -+"[static_cast<int>(line.kind)];
      found += QByteArray::fromStdString(line.text);
    }
    QCOMPARE(found, expected);
  }

  /// The number of lines changed is that of the system's diff, and the lines put together again
  /// are the two texts.
  void lineDiff_randomTexts_agreeWithDiff() {
    const QTemporaryDir folder;
    std::uint32_t state = 12345;
    const auto next = [&state](std::uint32_t below) {
      state = state * 1664525U + 1013904223U;
      return (state >> 16U) % below;
    };
    for (int round = 0; round < 10; ++round) {
      std::string left;
      std::string right;
      for (int i = 0; i < 60; ++i) {
        const std::string line = std::string(1, static_cast<char>('a' + next(8))) + "\n";
        left += next(5) == 0 ? "" : line;
        right += next(5) == 0 ? "" : line;
      }
      const QString a = folder.filePath(QStringLiteral("a"));
      const QString b = folder.filePath(QStringLiteral("b"));
      QVERIFY(base::writeFileAtomically(a.toStdString(), left).empty());
      QVERIFY(base::writeFileAtomically(b.toStdString(), right).empty());
      QProcess diff;
      diff.start(QStringLiteral("diff"), {QStringLiteral("--minimal"), a, b});
      QVERIFY(diff.waitForFinished());
      int theirs = 0;
      for (const QByteArray& line : diff.readAllStandardOutput().split('\n')) {
        theirs += line.startsWith('<') || line.startsWith('>') ? 1 : 0;
      }
      int ours = 0;
      std::string leftAgain;
      std::string rightAgain;
      for (const DiffLine& line : lineDiff(left, right)) {
        ours += line.kind != DiffLine::Kind::Same ? 1 : 0;
        leftAgain += line.kind != DiffLine::Kind::Added ? line.text + "\n" : "";
        rightAgain += line.kind != DiffLine::Kind::Removed ? line.text + "\n" : "";
      }
      QCOMPARE(ours, theirs);
      QVERIFY(leftAgain == left);
      QVERIFY(rightAgain == right);
    }
  }
};

QTEST_APPLESS_MAIN(LineDiffTest)
#include "tst_LineDiff.moc"
