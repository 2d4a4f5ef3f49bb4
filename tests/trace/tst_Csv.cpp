#include <QtTest>

#include "sim2d/trace/Csv.h"

/// Fields of our own CSV files: what is written is read again, and no spreadsheet works it out.
class CsvTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void field_isWrittenAndReadAgain_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("written");
    const auto row = [](const char* text, const char* written) {
      QTest::newRow(text) << QString::fromUtf8(text) << QString::fromUtf8(written);
    };
    row("", "");
    row("anna", "anna");
    row("two, three", "\"two, three\"");
    row("a \"b\"", "\"a \"\"b\"\"\"");
    row("-1.5", "-1.5");
    row("-inf", "-inf");
    row("+3e4", "+3e4");
    row("-5 %", "-5 %");
    row("-5+1 %", "'-5+1 %");
    row("=1+1", "'=1+1");
    row("+1+1", "'+1+1");
    row("-2-3", "'-2-3");
    row("@sum", "'@sum");
    row("-", "'-");
    row("=a,b", "\"'=a,b\"");
    row("=\"x\"", "\"'=\"\"x\"\"\"");
    row("'=1", "''=1");
    row("''=1", "'''=1");
    row("'tis", "'tis");
    row("'", "'");
    row("a=1", "a=1");
  }
  void field_isWrittenAndReadAgain() {
    QFETCH(QString, text);
    QFETCH(QString, written);
    std::string line;
    sim2d::appendCsvField(line, text.toStdString());
    QCOMPARE(QString::fromStdString(line), written);
    const std::string table = "x,y\n1," + line + "\n";
    base::Diagnostics problems;
    sim2d::CsvTable rows(table, "t.csv", problems);
    QVERIFY(rows.readColumns("x,y"));
    QVERIFY(rows.next());
    QCOMPARE(QString::fromStdString(rows[1].text), text);
    QVERIFY(problems.empty());
  }
};

QTEST_APPLESS_MAIN(CsvTest)
#include "tst_Csv.moc"
