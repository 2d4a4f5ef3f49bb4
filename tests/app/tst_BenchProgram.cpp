#include <QImage>
#include <QTemporaryDir>
#include <QtTest>

#include "tests/app/RunFiles.h"

using namespace outside;

/// `hunavsim bench` from outside: what the table says of itself, never how fast.
class BenchProgramTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void quick_csv_rowsAgreeWithThemselves();
  void picture_wrongName_exitsWith64_data();
  void picture_wrongName_exitsWith64();
};

namespace {

Finished bench(const QStringList& words) {
  return runProgram(QStringList{text("bench"), text("--quick")} + words);
}

bool isNear(double value, double expected, double share) {
  return std::fabs(value - expected) <= share * std::fabs(expected);
}

/// Phases, scan and record together are the step; shown with three digits.
void checkTimes(const std::map<QString, QString>& row) {
  const auto number = [&row](const char* column) { return row.at(text(column)).toDouble(); };
  double sum = 0.0;
  for (const char* phase : {"trees", "robots", "ways", "forces", "bodies", "contacts", "goals",
                            "grid", "frame", "sensing", "recording"}) {
    QVERIFY2(number(phase) > 0.0, phase);
    sum += number(phase);
  }
  const double people = number("people");
  QVERIFY(isNear(number("ns/person"), sum * 1e6 / people, 0.02));
  QVERIFY(isNear(number("x real time"), 50.0 / sum, 0.02));
  QVERIFY(isNear(number("plain/forces"), number("plain") / number("forces"), 0.02));
  QVERIFY(isNear(number("plain/step"), number("plain") / sum, 0.02));
}

}  // namespace

void BenchProgramTest::quick_csv_rowsAgreeWithThemselves() {
  QTemporaryDir folder;
  const QString picture = folder.filePath(text("bench.png"));
  const Finished found = bench({text("--format"), text("csv"), text("--picture"), picture});
  QVERIFY2(found.exitCode == 0, qPrintable(found.err));
  const QString table = folder.filePath(text("bench.csv"));
  QString csv = found.out;
  csv.replace(QRegularExpression(text("\"([^\"]*)\"")), text("machine"));  // it has a comma
  writeText(table, csv.toUtf8());
  const auto rows = readCsv(table);
  QCOMPARE(rows.size(), std::size_t(6));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    QCOMPARE(rows[i].at(text("people")), text(i < 2 ? "10" : i < 4 ? "100" : "1000"));
    QCOMPARE(rows[i].at(text("scene")), text(i % 2 == 0 ? "open" : "200 walls"));
    checkTimes(rows[i]);
  }
  const QImage drawn(picture);
  QCOMPARE(drawn.size(), QSize(1440, 810));
  QSet<QRgb> colors;
  for (int x = 0; x < drawn.width(); ++x) {
    for (int y = 0; y < drawn.height(); ++y) {
      colors.insert(drawn.pixel(x, y));
    }
  }
  QVERIFY(colors.size() > 20);
}

void BenchProgramTest::picture_wrongName_exitsWith64_data() {
  QTest::addColumn<QString>("file");
  QTest::newRow("ending") << text("bench.txt");
  QTest::newRow("no ending") << text("bench");
  QTest::newRow("no folder") << text("/nowhere/at/all/bench.png");
}

void BenchProgramTest::picture_wrongName_exitsWith64() {
  QFETCH(QString, file);
  const Finished found = bench({text("--picture"), file});
  QCOMPARE(found.exitCode, 64);
  QVERIFY(found.out.isEmpty());
  QVERIFY(found.err.contains(file));
}

QTEST_GUILESS_MAIN(BenchProgramTest)
#include "tst_BenchProgram.moc"
