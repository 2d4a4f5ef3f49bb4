#include <QtTest/QtTest>
#include <algorithm>

#include "bt/engine/Program.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"

/// Every file of data/bt/bad with exactly the problems that expected.txt names for it.
class TreeErrorsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void load_badFile_saysWhatIsWrong_data();
  void load_badFile_saysWhatIsWrong();
};

namespace {

const char* const kFolder = TEST_DATA_DIR "/bt/bad/";

/// All that reading, checking and compiling say, folders left out.
QStringList problemsOf(const std::string& path) {
  base::Diagnostics problems;
  const base::Result<bt::TreeTable> table = bt::loadTrees(path);
  base::append(problems, table.diagnostics());
  if (table) {
    const bt::NodeLibrary library;
    base::append(problems, bt::diagnosticsOf(bt::checkForImport(*table, library.catalogue())));
    if (!base::hasErrors(problems)) {
      base::append(problems, bt::compile(*table, library).diagnostics());
    }
  }
  QStringList lines;
  for (const base::Diagnostic& problem : problems) {
    QString line = QString::fromStdString(problem.text());
    line.remove(QString::fromUtf8(kFolder));
    if (!lines.contains(line)) {
      lines << line;
    }
  }
  return lines;
}

}  // namespace

void TreeErrorsTest::load_badFile_saysWhatIsWrong_data() {
  QTest::addColumn<QStringList>("expected");
  QMap<QString, QStringList> expected;
  QFile file(QString::fromUtf8(kFolder) + QStringLiteral("expected.txt"));
  QVERIFY(file.open(QIODevice::ReadOnly | QIODevice::Text));
  QString name;
  for (const QString& line :
       QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
    if (line.startsWith(QLatin1String("  "))) {
      expected[name] << line.mid(2);
    } else {
      name = line;
      expected[name];
    }
  }
  const QStringList files = QDir(QString::fromUtf8(kFolder)).entryList({QStringLiteral("*.xml")});
  QCOMPARE(QStringList(expected.keys()), files);
  for (const QString& one : files) {
    QTest::newRow(qPrintable(one)) << expected[one];
  }
}

void TreeErrorsTest::load_badFile_saysWhatIsWrong() {
  QFETCH(QStringList, expected);
  const std::string path = kFolder + std::string(QTest::currentDataTag());
  const QStringList problems = problemsOf(path);
  if (qEnvironmentVariableIsSet("BT_PRINT_PROBLEMS")) {
    QTextStream(stdout) << "=" << QTest::currentDataTag()
                        << "\n=  " << problems.join(QStringLiteral("\n=  ")) << "\n";
  }
  QCOMPARE(problems, expected);
  QVERIFY(!problems.isEmpty());
}

QTEST_APPLESS_MAIN(TreeErrorsTest)
#include "tst_TreeErrors.moc"
