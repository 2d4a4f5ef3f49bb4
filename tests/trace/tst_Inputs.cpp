#include <QtTest>

#include "sim2d/trace/Inputs.h"

using namespace sim2d;

class InputsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void rows_ofEachKind_readBackEqual();
  void parse_brokenRows_areToldWithPlace_data();
  void parse_brokenRows_areToldWithPlace();
};

void InputsTest::rows_ofEachKind_readBackEqual() {
  std::string text = inputsHeader();
  RecordedInputs written;
  for (const InputKind kind : {InputKind::Robot, InputKind::Open, InputKind::Close, InputKind::Move,
                               InputKind::Add, InputKind::Set, InputKind::Push, InputKind::Stop,
                               InputKind::Resume, InputKind::Entry, InputKind::Goal}) {
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

void InputsTest::parse_brokenRows_areToldWithPlace_data() {
  QTest::addColumn<QString>("rows");
  QTest::addColumn<QString>("problem");
  const auto row = [](const char* name, const char* rows, const char* problem) {
    QTest::newRow(name) << rows << problem;
  };
  row("unknown kind", "1,kick,2,,0,0,0,0,0,0,0,0\n", "inputs.csv:2:3: error: unknown input 'kick'");
  row("no number", "1,move,2,,0,nan,0,0,0,0,0,0\n",
      "inputs.csv:2:13: error: not a finite number: 'nan'");
  row("no id", "1,move,x,,0,0,0,0,0,0,0,0\n", "inputs.csv:2:8: error: id is not an integer: 'x'");
  row("short", "1,move,2\n", "inputs.csv:2:8: error: the line has 3 fields instead of 12");
  row("cut", "1,move,2,,0,0,0,0,0,0,0,0",
      "inputs.csv:2:25: error: the file ends inside this line (truncated?)");
  row("backwards", "3,move,2,,0,0,0,0,0,0,0,0\n2,move,2,,0,0,0,0,0,0,0,0\n",
      "inputs.csv:3:1: error: steps decrease");
}

void InputsTest::parse_brokenRows_areToldWithPlace() {
  QFETCH(QString, rows);
  QFETCH(QString, problem);
  const base::Result<RecordedInputs> read =
      parseInputs(inputsHeader() + rows.toStdString(), "inputs.csv");
  QVERIFY(!read);
  QCOMPARE(QString::fromStdString(read.diagnostics().front().text()), problem);
  QVERIFY(!parseInputs("step,id\n", "inputs.csv"));
}

QTEST_APPLESS_MAIN(InputsTest)
#include "tst_Inputs.moc"
