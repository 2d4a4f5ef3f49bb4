#include <limits>

#include <QtTest>

#include "sim2d/trace/Scans.h"

using namespace sim2d;

/// scans.csv: written, read, refused.
class ScansTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void rows_writtenAndRead_areEqual();
  void row_byHand_isAsDocumented();
  void parse_badRow_tellsItsPlace_data();
  void parse_badRow_tellsItsPlace();
};

namespace {

RecordedScan scanOf(std::int64_t step, int robot, std::vector<double> distances) {
  RecordedScan turn{step, robot, {}};
  turn.scan.sensor = {base::Vec2(0.1, -2.0 / 3.0), 1e-17};
  turn.scan.time = 0.1 * static_cast<double>(step);
  turn.scan.angleMin = -3.141592653589793;
  turn.scan.angleIncrement = 0.017453292519943295;
  turn.scan.range = 30.0;
  turn.scan.distances = std::move(distances);
  return turn;
}

}  // namespace

void ScansTest::rows_writtenAndRead_areEqual() {
  const std::vector<RecordedScan> turns = {
      scanOf(0, -1, {1.0 / 3.0, 30.0, 0.0, std::numeric_limits<double>::denorm_min()}),
      scanOf(0, -2, {5.5}), scanOf(3, -1, {2.0, 1e-3})};
  std::string text = scansHeader();
  for (const RecordedScan& turn : turns) {
    appendScanRow(text, turn);
  }
  const base::Result<std::vector<RecordedScan>> read = parseScans(text, "scans.csv");
  QVERIFY(read);
  QCOMPARE(read->size(), turns.size());
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const RecordedScan& a = (*read)[i];
    const RecordedScan& b = turns[i];
    QVERIFY(a.step == b.step && a.robot == b.robot && a.scan.time == b.scan.time);
    QVERIFY(a.scan.sensor.position == b.scan.sensor.position);
    QVERIFY(a.scan.sensor.heading == b.scan.sensor.heading);
    QVERIFY(a.scan.angleMin == b.scan.angleMin && a.scan.angleIncrement == b.scan.angleIncrement);
    QVERIFY(a.scan.range == b.scan.range && a.scan.distances == b.scan.distances);
  }
}

void ScansTest::row_byHand_isAsDocumented() {
  RecordedScan turn{4, -1, {}};
  turn.scan = {{base::Vec2(1.0, 2.5), 0.5}, 0.2, -1.5, 0.25, 10.0, {0.75, 10.0, 3.0}};
  std::string text = scansHeader();
  appendScanRow(text, turn);
  QCOMPARE(QString::fromStdString(text),
           QStringLiteral("step,time,id,x,y,heading,angle_min,angle_step,range,distances\n"
                          "4,0.2,-1,1,2.5,0.5,-1.5,0.25,10,0.75 10 3\n"));
}

void ScansTest::parse_badRow_tellsItsPlace_data() {
  QTest::addColumn<QString>("rows");
  QTest::addColumn<QString>("told");
  QTest::newRow("distance") << "1,0.05,-1,0,0,0,0,1,9,1 x 2\n"
                            << "scans.csv:2:23: error: not a distance: 'x'";
  QTest::newRow("negative") << "1,0.05,-1,0,0,0,0,1,9,-1\n"
                            << "scans.csv:2:23: error: not a distance: '-1'";
  QTest::newRow("none") << "1,0.05,-1,0,0,0,0,1,9,\n"
                        << "scans.csv:2:23: error: not a distance: ''";
  QTest::newRow("backwards") << "2,0.1,-1,0,0,0,0,1,9,1\n1,0.05,-1,0,0,0,0,1,9,1\n"
                             << "scans.csv:3:1: error: steps decrease";
}

void ScansTest::parse_badRow_tellsItsPlace() {
  QFETCH(QString, rows);
  QFETCH(QString, told);
  const base::Result<std::vector<RecordedScan>> read =
      parseScans(scansHeader() + rows.toStdString(), "scans.csv");
  QVERIFY(!read);
  QCOMPARE(QString::fromStdString(read.diagnostics()[0].text()), told);
}

QTEST_APPLESS_MAIN(ScansTest)
#include "tst_Scans.moc"
