#include <QTemporaryDir>
#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/trace/JsonInput.h"
#include "sim2d/trace/Recording.h"
#include "sim2d/trace/Trace.h"
#include "tests/support/TraceHash.h"

using namespace sim2d;

namespace {

TraceHeader sampleHeader() {
  TraceHeader header;
  header.scenario = "two \"rooms\", one door";
  header.dt = 0.1;
  header.seed = 12345678901LL;
  TraceHuman human;
  human.id = 3;
  human.name = "Ana";
  human.kind = "child";
  human.model = "sfm";
  human.radius = 0.1 + 0.2;
  human.group = 2;
  human.goals = {{5, Vec2(1.0 / 3.0, -2.5), 0.4}};
  human.parameters = {{"social_force_factor", 5.0}, {"a_first", 1e-300}};
  header.humans.push_back(human);
  human.id = 7;
  human.goals.clear();
  header.humans.push_back(human);
  TraceRobot robot;
  robot.name = "robot1";
  robot.goals = {{0, Vec2(4, 1), 0.2}};
  robot.footprint = {Vec2(-0.2, -0.1), Vec2(0.3, 0.0), Vec2(-0.2, 0.1)};
  header.robots.push_back(robot);
  TraceObstacle door;
  door.name = "door1";
  door.isDoor = true;
  door.open = true;
  door.toggles = {1.5, 2.25};
  door.outlines = {Outline{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 0.05)}}, Outline{{Vec2(2, 2)}}};
  header.obstacles.push_back(door);
  header.map = OccupancyGrid(3, 2, 0.25, Pose2{Vec2(-1, 2), 0.5}, {0, 0, 100, 100, -1, 37});
  return header;
}

Frame frameAt(int step, double dt) {
  Frame frame;
  frame.step = step;
  frame.time = step * dt;
  HumanColumns& humans = frame.humans;
  for (const int id : {3, 7}) {
    if (id == 7 && step == 0) {
      continue;  // enters later
    }
    humans.add(id, {{0.1 * step, -1.0 / (step + 3)}, 3.0}, {1e-17, -0.0}, 1e22,
               id == 3 ? 5 : kNoGoal);
    humans.group.push_back(id == 3 ? 2 : -1);
    humans.state.push_back(id == 3 ? 1 : 0);
  }
  frame.robots.add(-1, {{1.0, 2.0}, 0.0}, {0.5, 0.0}, -0.25, kNoGoal);
  return frame;
}

Event makeEvent(EventKind kind, int id, const std::string& text) {
  Event made;
  made.kind = kind;
  made.id = id;
  made.text = text;
  return made;
}

Trace sampleTrace(int recordEvery = 1) {
  Recording recording(recordEvery);
  for (int step = 0; step <= 4; ++step) {
    Frame frame = frameAt(step, 0.1);
    if (step == 1) {
      Event contact = makeEvent(EventKind::Contact, -1, "0.5");
      contact.hasOther = true;
      contact.other = 3;
      frame.events = {makeEvent(EventKind::Say, 7, "line one\nsays \"hi\", twice"), contact};
    }
    if (step == 4) {
      Event stop = makeEvent(EventKind::Stop, 0, "duration");
      stop.hasId = false;
      frame.events = {stop};
    }
    recording.append(frame);
  }
  return recording.trace(sampleHeader());
}

void writeRun(const Trace& trace, const std::string& folder) {
  QVERIFY(base::writeFileAtomically(folder + "/trajectory.csv", trajectoryCsv(trace)).empty());
  QVERIFY(base::writeFileAtomically(folder + "/events.csv", eventsCsv(trace)).empty());
  QVERIFY(base::writeFileAtomically(folder + "/trace.json", traceJson(trace.header)).empty());
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

constexpr char kText[] =
    "{\n"
    " \"dt\": 0.05,\n"
    " \"empty\": [],\n"
    " \"humans\": [\n"
    "  {\"id\": 1, \"name\": \"a \\\" b\"},\n"
    "  {\"id\": 2,\n"
    "   \"goals\": [\n"
    "     {\"x\": 1.0},\n"
    "     {\"x\": 2.0}]}\n"
    " ],\n"
    " \"map\": {\n"
    "  \"cells\": [0, 12]\n"
    " }\n"
    "}\n";

}  // namespace

/// Run folders, written and read; lines of the members of a JSON text, counted by hand.
class TraceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void readTrace_ofWrittenRun_isEqual_data() {
    QTest::addColumn<int>("recordEvery");
    QTest::newRow("every step") << 1;
    QTest::newRow("every third step") << 3;
  }

  void readTrace_ofWrittenRun_isEqual() {
    QFETCH(int, recordEvery);
    QTemporaryDir folder;
    const std::string path = folder.path().toStdString();
    const Trace trace = sampleTrace(recordEvery);
    writeRun(trace, path);
    const base::Result<Trace> read = readTrace(path);
    QVERIFY2(read, read ? "" : read.diagnostics().front().text().c_str());
    QVERIFY(read->header == trace.header);
    QVERIFY(read->events == trace.events);
    QCOMPARE(read->frames.size(), trace.frames.size());
    for (std::size_t k = 0; k < trace.frames.size(); ++k) {
      QCOMPARE(read->frames[k].step, trace.frames[k].step);
      QVERIFY(read->frames[k].time == trace.frames[k].time);
      QVERIFY(read->frames[k].humans == trace.frames[k].humans);
      QVERIFY(read->frames[k].robots == trace.frames[k].robots);
    }
    QVERIFY(traceJson(read->header) == traceJson(trace.header));
    QCOMPARE(hashOf(*read), hashOf(trace));
  }

  void readTrace_instantsWithoutAnybody_areKept() {
    QTemporaryDir folder;
    const std::string path = folder.path().toStdString();
    Trace trace = sampleTrace();
    trace.header.robots.clear();
    trace.events.erase(trace.events.begin());  // the contact of the robot
    for (const std::size_t empty : std::vector<std::size_t>{0, 1, 3, 4}) {
      trace.frames[empty].humans = {};
    }
    for (Frame& frame : trace.frames) {
      frame.robots = {};
    }
    writeRun(trace, path);
    const base::Result<Trace> read = readTrace(path);
    QVERIFY2(read, read ? "" : read.diagnostics().front().text().c_str());
    QCOMPARE(read->frames.size(), std::size_t{5});
    QVERIFY(trajectoryCsv(*read) == trajectoryCsv(trace));
    QVERIFY(read->frames[4].time == 4 * 0.1);
  }

  void readTrace_badFile_namesPlace_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char* name, const char* file, const char* from, const char* to,
                        const char* expected) {
      QTest::newRow(name) << QByteArray(file) << QByteArray(from) << QByteArray(to)
                          << QByteArray(expected);
    };
    const char* const rows = "trajectory.csv";
    row("NaN position", rows, "1,0.1,3,human,0.1,", "1,0.1,3,human,nan,",
        "trajectory.csv:4:15: error: x is not a finite");
    row("text for a number", rows, "2,0.2,7,human,0.2,", "2,0.2,7,human,0.2m,",
        "trajectory.csv:8:15: error: x is not");
    row("time backwards", rows, "\n3,0.30000000000000004,3", "\n1,0.1,3",
        "trajectory.csv:10:1: error: step and time decrease");
    row("time off the grid", rows, "\n1,0.1,3", "\n1,0.15,3",
        "trajectory.csv:4:3: error: time is not step");
    row("unknown person", rows, "\n1,0.1,7", "\n1,0.1,8",
        "trajectory.csv:5:7: error: id 8 is not in");
    row("robot without row", rows, "1,0.1,-1,robot,1,2,0,0.5,0,-0.25,-1,0,\n", "",
        "step 1 has no row for a robot");
    row("field missing", rows, "2,0.2,-1,robot,", "2,0.2,-1,", "trajectory.csv:9:");
    row("columns", rows, "step,time,id", "step,id,time",
        "trajectory.csv:1:1: error: the first line must be");
    row("kind of event", "events.csv", ",contact,", ",bump,",
        "events.csv:2:7: error: unknown kind of event 'bump'");
    row("JSON syntax", "trace.json", "\"dt\": 0.1", "\"dt\": ,",
        "trace.json:4:8: error: not valid JSON");
    row("JSON number", "trace.json", "\"dt\": 0.1", "\"dt\": 1e999",
        "trace.json:4:8: error: number overflow parsing");
    row("JSON type", "trace.json", "\"dt\": 0.1", "\"dt\": \"0.1\"",
        "trace.json:4: error: dt: must be a finite number");
    row("wrap of one number", "trace.json", "\"dt\": 0.1", "\"dt\": 0.1, \"wrap_x\": [1]",
        "trace.json:4: error: wrap_x");
    row("wrap backwards", "trace.json", "\"dt\": 0.1", "\"dt\": 0.1, \"wrap_x\": [3, 1]",
        "trace.json:4: error: wrap_x");
    row("cells", "trace.json", "[0,2,100,2,", "[0,2,100,99,", "map.cells: must be pairs");
    row("too many cells", "trace.json", "\"width\":3,\"height\":2",
        "\"width\":2000000000,\"height\":2000000000",
        "map: must have at most 100000000 cells, not 2000000000 x 2000000000");
  }

  void readTrace_badFile_namesPlace() {
    QFETCH(QByteArray, file);
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QByteArray, expected);
    QTemporaryDir folder;
    const std::string path = folder.path().toStdString();
    writeRun(sampleTrace(), path);
    const std::string name = path + "/" + file.toStdString();
    const std::string text = *base::readTextFile(name);
    const std::string bad = replaced(text, from.toStdString(), to.toStdString());
    QVERIFY(bad != text);
    QVERIFY(base::writeFileAtomically(name, bad).empty());
    const base::Result<Trace> read = readTrace(path);
    QVERIFY(!read);
    std::string all;
    for (const base::Diagnostic& problem : read.diagnostics()) {
      all += problem.text() + "\n";
    }
    QVERIFY2(all.find(expected.toStdString()) != std::string::npos, all.c_str());
  }

  void readTrace_fileInsteadOfFolder_isOneProblem() {
    QTemporaryDir folder;
    const std::string file = folder.filePath(QStringLiteral("yard.yaml")).toStdString();
    QVERIFY(base::writeFileAtomically(file, "dt: 0.05\n").empty());
    const base::Result<Trace> read = readTrace(file);
    QCOMPARE(read.diagnostics().size(), std::size_t{1});
    QVERIFY(read.diagnostics().front().code == "trace.file-for-run");
  }

  void readTrace_missingFiles_areAllNamed() {
    QTemporaryDir folder;
    const base::Result<Trace> read = readTrace(folder.path().toStdString());
    QVERIFY(!read);
    QCOMPARE(read.diagnostics().size(), std::size_t{3});
  }

  void wrap_isInTheHeader_whereThereIsOne() {
    QTemporaryDir folder;
    const std::string path = folder.path().toStdString();
    Trace trace = sampleTrace();
    writeRun(trace, path);
    QVERIFY(base::readTextFile(path + "/trace.json")->find("wrap_x") == std::string::npos);
    QVERIFY(readTrace(path)->header.wrapX.empty());
    trace.header.wrapX = {-2.0, 3.5};
    writeRun(trace, path);
    QVERIFY((readTrace(path)->header.wrapX == std::vector<double>{-2.0, 3.5}));
  }

  /// Absent in most files and in those of older versions.
  void customTree_isInTheHeader_ofThosePeopleAlone() {
    QTemporaryDir folder;
    const std::string path = folder.path().toStdString();
    Trace trace = sampleTrace();
    writeRun(trace, path);
    QVERIFY(base::readTextFile(path + "/trace.json")->find("custom_tree") == std::string::npos);
    QVERIFY(!readTrace(path)->header.humans[1].customTree);
    trace.header.humans[1].customTree = true;
    writeRun(trace, path);
    const TraceHeader read = readTrace(path)->header;
    QVERIFY(!read.humans[0].customTree);
    QVERIFY(read.humans[1].customTree);
    QVERIFY(read.humans[1] == trace.header.humans[1]);
  }

  void hashOf_otherPosition_differs() {
    const Trace trace = sampleTrace();
    Trace moved = trace;
    moved.frames[2].humans.x[0] += 1e-15;
    QVERIFY(hashOf(moved) != hashOf(trace));
  }

  void lineOf_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<int>("line");
    const auto row = [](const char* path, int line) {
      QTest::newRow(path) << QString::fromUtf8(path) << line;
    };
    row("dt", 2);
    row("empty", 3);
    row("humans", 4);
    row("humans[0]", 5);
    row("humans[0].name", 5);
    row("humans[1]", 6);
    row("humans[1].goals", 7);
    row("humans[1].goals[1].x", 9);
    row("map.cells", 12);
    row("map.cells[1]", 12);       // a number: where its list is
    row("map.width", 11);          // is not there: its object
    row("humans[1].velocity", 6);  // idem
    row("humans[7].id", 4);
    row("nothing", 0);
  }
  void lineOf() {
    QFETCH(QString, path);
    QTEST(JsonLineIndex(kText).lineOf(path.toStdString()), "line");
  }

  void noJson_hasNoPlaces() {
    QCOMPARE(JsonLineIndex("{\"a\": 1,\n\"b\": }").lineOf("a"), 0);
    QCOMPARE(JsonLineIndex("").lineOf("a"), 0);
  }
};

QTEST_APPLESS_MAIN(TraceTest)
#include "tst_Trace.moc"
