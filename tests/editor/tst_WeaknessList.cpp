#include <QDirIterator>
#include <QRegularExpression>
#include <QtTest>

/// The list of weaknesses names tests that exist.
class WeaknessListTest : public QObject {
  Q_OBJECT

 private:
  static QString contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
  }

 private Q_SLOTS:
  void rows_areAllThere_andNameTests() {
    const QString page = contentOf(QStringLiteral(SOURCE_DIR "/editor/WEAKNESSES.md"));
    const QRegularExpression row(QStringLiteral("^\\| (\\d+) \\|.*$"),
                                 QRegularExpression::MultilineOption);
    const QRegularExpression name(QStringLiteral("`(tst_\\w+)\\.(\\w+)`"));
    QMap<QString, QString> programs;
    QDirIterator files(QStringLiteral(SOURCE_DIR "/tests"), {QStringLiteral("tst_*.cpp")},
                       QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      const QString path = files.next();
      programs[QFileInfo(path).completeBaseName()] = contentOf(path);
    }
    int expected = 0;
    auto rows = row.globalMatch(page);
    while (rows.hasNext()) {
      const QRegularExpressionMatch found = rows.next();
      QCOMPARE(found.captured(1).toInt(), ++expected);
      auto names = name.globalMatch(found.captured(0));
      QVERIFY2(names.hasNext(), qPrintable(found.captured(0)));
      while (names.hasNext()) {
        const QRegularExpressionMatch test = names.next();
        const QRegularExpression slot(QStringLiteral("void %1\\(").arg(test.captured(2)));
        QVERIFY2(slot.match(programs.value(test.captured(1))).hasMatch(),
                 qPrintable(test.captured(0)));
      }
    }
    QCOMPARE(expected, 25);
  }
};

QTEST_APPLESS_MAIN(WeaknessListTest)
#include "tst_WeaknessList.moc"
