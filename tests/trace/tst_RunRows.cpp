#include <limits>

#include <QtTest>

#include "sim2d/trace/Csv.h"
#include "sim2d/trace/Frame.h"
#include "sim2d/trace/Trace.h"

using namespace sim2d;

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

/// inputs.csv and scans.csv: written, read, refused. Fields of our own CSV files: what is written
/// is read again, and no spreadsheet works it out.
class RunRowsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void rows_ofEachKind_readBackEqual() {
    std::string text = inputsHeader();
    RecordedInputs written;
    for (const InputKind kind :
         {InputKind::Robot, InputKind::Open, InputKind::Close, InputKind::Move, InputKind::Add,
          InputKind::Set, InputKind::Push, InputKind::Stop, InputKind::Resume, InputKind::Entry,
          InputKind::Goal}) {
      Input input;
      input.kind = kind;
      input.id = -1 + static_cast<int>(kind);
      input.name = "door, \"left\"";
      input.pose = {{0.1, -1.0 / 3.0}, 1e-9};
      input.velocity = {2.5, -7e3};
      input.omega = 0.7;
      input.desiredVelocity = {1.0, 3.0};
      written.emplace_back(static_cast<std::int64_t>(kind) / 2, input);
      appendInputRow(text, written.back().first, input);
    }
    const base::Result<RecordedInputs> read = parseInputs(text, "inputs.csv");
    QVERIFY(read);
    QVERIFY(*read == written);
    for (const char* word : {"stop", "resume", "entry", "goal"}) {
      QVERIFY(text.find(std::string(",") + word + ",") != std::string::npos);
    }
  }

  void parse_brokenRows_areToldWithPlace_data() {
    QTest::addColumn<QString>("rows");
    QTest::addColumn<QString>("problem");
    const auto row = [](const char* name, const char* rows, const char* problem) {
      QTest::newRow(name) << rows << problem;
    };
    row("unknown kind", "1,kick,2,,0,0,0,0,0,0,0,0\n",
        "inputs.csv:2:3: error: unknown input 'kick'");
    row("no number", "1,move,2,,0,nan,0,0,0,0,0,0\n",
        "inputs.csv:2:13: error: not a finite number: 'nan'");
    row("no id", "1,move,x,,0,0,0,0,0,0,0,0\n", "inputs.csv:2:8: error: id is not an integer: 'x'");
    row("short", "1,move,2\n", "inputs.csv:2:8: error: the line has 3 fields instead of 12");
    row("cut", "1,move,2,,0,0,0,0,0,0,0,0",
        "inputs.csv:2:25: error: the file ends inside this line (truncated?)");
    row("backwards", "3,move,2,,0,0,0,0,0,0,0,0\n2,move,2,,0,0,0,0,0,0,0,0\n",
        "inputs.csv:3:1: error: steps decrease");
  }

  void parse_brokenRows_areToldWithPlace() {
    QFETCH(QString, rows);
    QFETCH(QString, problem);
    const base::Result<RecordedInputs> read =
        parseInputs(inputsHeader() + rows.toStdString(), "inputs.csv");
    QVERIFY(!read);
    QCOMPARE(QString::fromStdString(read.diagnostics().front().text()), problem);
    QVERIFY(!parseInputs("step,id\n", "inputs.csv"));
  }

  void rows_writtenAndRead_areEqual() {
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

  void row_byHand_isAsDocumented() {
    RecordedScan turn{4, -1, {}};
    turn.scan = {{base::Vec2(1.0, 2.5), 0.5}, 0.2, -1.5, 0.25, 10.0, {0.75, 10.0, 3.0}};
    std::string text = scansHeader();
    appendScanRow(text, turn);
    QCOMPARE(QString::fromStdString(text),
             QStringLiteral("step,time,id,x,y,heading,angle_min,angle_step,range,distances\n"
                            "4,0.2,-1,1,2.5,0.5,-1.5,0.25,10,0.75 10 3\n"));
  }

  void parse_badRow_tellsItsPlace_data() {
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

  void parse_badRow_tellsItsPlace() {
    QFETCH(QString, rows);
    QFETCH(QString, told);
    const base::Result<std::vector<RecordedScan>> read =
        parseScans(scansHeader() + rows.toStdString(), "scans.csv");
    QVERIFY(!read);
    QCOMPARE(QString::fromStdString(read.diagnostics()[0].text()), told);
  }

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

QTEST_APPLESS_MAIN(RunRowsTest)
#include "tst_RunRows.moc"
