#include <cmath>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

using namespace sim2d;

namespace {

std::string dataFile(const char* name) {
  return std::string(TEST_DATA_DIR) + "/scenario/" + name;
}

std::string textOf(const std::string& path) {
  const auto text = base::readTextFile(path);
  return text ? *text : std::string();
}

QString shown(const base::Diagnostics& diagnostics) {
  QString all;
  for (const base::Diagnostic& diagnostic : diagnostics) {
    all += QString::fromStdString(diagnostic.text()) + QLatin1Char('\n');
  }
  return all;
}

}  // namespace

class ScenarioWriterTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void write_canonicalFile_sameBytes_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::newRow("plain") << QByteArray("canonical.yaml");
    QTest::newRow("block") << QByteArray("block.yaml");
  }
  void write_canonicalFile_sameBytes() {
    QFETCH(QByteArray, file);
    const std::string path = dataFile(file.constData());
    const ScenarioReading reading = readScenario(path);
    QVERIFY2(reading.ok(), qPrintable(shown(reading.diagnostics)));
    QCOMPARE(QString::fromStdString(writeScenario(reading.scenario)),
             QString::fromStdString(textOf(path)));
  }

  void write_plainScenario_noNewlineAtEnd() {
    const ScenarioReading reading = readScenario(dataFile("canonical.yaml"));
    QVERIFY(writeScenario(reading.scenario).back() != '\n');
    QVERIFY(reading.diagnostics.empty());
  }
};

QTEST_APPLESS_MAIN(ScenarioWriterTest)
#include "tst_ScenarioWriter.moc"
