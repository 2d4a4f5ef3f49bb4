#include <atomic>
#include <cmath>
#include <random>
#include <thread>

#include <QTemporaryDir>
#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"
#include "sim2d/trace/Recording.h"

using namespace sim2d;

namespace {

Event makeEvent(EventKind kind, int id) {
  Event made;
  made.kind = kind;
  made.id = id;
  return made;
}

/// A crowd that walks, turns and changes goals; one planner's way; a door.
Frame crowdAt(std::int64_t step, int people) {
  Frame frame;
  frame.step = step;
  frame.time = 0.05 * static_cast<double>(step);
  HumanColumns& humans = frame.humans;
  for (int id = 1; id <= people; ++id) {
    const double phase = 0.01 * static_cast<double>(step) + id;
    humans.id.push_back(id);
    humans.x.push_back(std::cos(phase));
    humans.y.push_back(id % 3 == 0 ? -0.0 : std::sin(phase));  // some stand still
    humans.heading.push_back(phase);
    humans.vx.push_back(-std::sin(phase));
    humans.vy.push_back(std::cos(phase));
    humans.omega.push_back(0.2);
    humans.group.push_back(id % 5);
    humans.state.push_back(step % 50 == id ? 1 : 0);
    humans.goal.push_back(static_cast<int>(step / 100));
    for (std::vector<Vec2>* forces :
         {&frame.forces.goal, &frame.forces.social, &frame.forces.obstacle, &frame.forces.group}) {
      forces->push_back(step == 0 ? Vec2(0.0, 0.0) : Vec2(phase, -phase));
    }
  }
  frame.robots.id = {-1};
  frame.robots.x = frame.robots.y = frame.robots.heading = {0.001 * static_cast<double>(step)};
  frame.robots.vx = frame.robots.vy = frame.robots.omega = {1.0};
  frame.robots.goal = {kNoGoal};
  const std::int64_t plans = step / 70;
  frame.robotPaths = {{Vec2(0.0, 0.0), Vec2(1.0, static_cast<double>(plans))}};
  frame.doorOpen = {static_cast<char>(step < 60 ? 1 : 0)};
  return frame;
}

bool isSameState(const Frame& a, const Frame& b) {
  return a.step == b.step && a.time == b.time && a.humans == b.humans && a.robots == b.robots &&
         a.forces.goal == b.forces.goal && a.forces.social == b.forces.social &&
         a.forces.obstacle == b.forces.obstacle && a.forces.group == b.forces.group &&
         a.robotPaths == b.robotPaths && a.doorOpen == b.doorOpen &&
         (a.humans.y.empty() || std::signbit(a.humans.y.back()) == std::signbit(b.humans.y.back()));
}

TreeChanges::Paths nodeNames(int count) {
  std::vector<std::string> names = {"Main"};
  for (int node = 1; node < count; ++node) {
    names.push_back("Main/Go[" + std::to_string(node) + "]");
  }
  return std::make_shared<const std::vector<std::string>>(std::move(names));
}

/// A door that closes at step 60, a push at 61, a tree that changes.
void recordDoor(Recording& recording) {
  TraceHeader header;
  header.humans.resize(2);
  header.humans[0].id = 1;
  header.humans[1].id = 2;
  header.robots.resize(1);
  TraceObstacle door;
  door.name = "front";
  door.isDoor = door.open = true;
  header.obstacles = {door};
  recording.setHeader(header);
  const TreeChanges::Paths names = nodeNames(4);
  for (std::int64_t step = 0; step <= 100; ++step) {
    Frame frame = crowdAt(step, 2);
    if (step == 60) {
      Event closes = makeEvent(EventKind::Door, 0);
      closes.hasId = false;
      closes.text = "front closed";
      frame.events = {closes};
    }
    if (step == 61) {
      Input push;
      push.kind = InputKind::Push;
      push.id = 2;
      push.velocity = Vec2(0.5, 0.0);
      frame.inputs = {push};
    }
    if (step % 10 == 1) {
      frame.treeChanges.add(1, names, static_cast<int>(step / 10 % 4), base::NodeStatus::Running);
    }
    recording.append(frame);
  }
}

}  // namespace

class RecordingTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void append_everySecondStep_keepsAllEvents();
  void append_eventsOfOneStep_areOrderedByKindThenId();
  void treesCsv_nodesWithCommas_areQuoted();
  void frame_anyStep_isWhatWasAppended_data();
  void frame_anyStep_isWhatWasAppended();
  void treesAt_anyStep_isWhatTheChangesMake();
  void read_whileItIsWritten_seesWholeSteps();
  void readRecording_folder_isWhatWasRecorded();
  void csvReader_quotedFields_giveTextAndPlace();
  void eventKindOf_everyName_roundTrips();
};

void RecordingTest::append_everySecondStep_keepsAllEvents() {
  Recording recording(2);
  for (int step = 0; step < 5; ++step) {
    Frame frame;
    frame.step = step;
    frame.events = {makeEvent(EventKind::Say, step)};
    recording.append(frame);
  }
  const Trace trace = recording.trace(TraceHeader{});
  QCOMPARE(trace.frames.size(), std::size_t{3});
  QCOMPARE(trace.frames[2].step, std::int64_t{4});
  QCOMPARE(trace.events.size(), std::size_t{5});
  QCOMPARE(trace.header.recordEvery, 2);
  QVERIFY(trace.frames[0].events.empty());
}

void RecordingTest::append_eventsOfOneStep_areOrderedByKindThenId() {
  Recording recording;
  Frame frame;
  frame.events = {makeEvent(EventKind::Say, 2), makeEvent(EventKind::Goal, 9),
                  makeEvent(EventKind::Goal, 4)};
  recording.append(frame);
  const Trace trace = recording.trace(TraceHeader{});
  QCOMPARE(trace.events[0].second.id, 4);
  QCOMPARE(trace.events[1].second.id, 9);
  QCOMPARE(trace.events[2].second.id, 2);
}

void RecordingTest::treesCsv_nodesWithCommas_areQuoted() {
  Recording recording(10);
  Frame frame;
  frame.step = 3;
  const auto paths = std::make_shared<const std::vector<std::string>>(
      std::vector<std::string>{"Main", "Main/Go, then stop"});
  frame.treeChanges.add(5, paths, 1, base::NodeStatus::Running);
  recording.append(frame);
  QVERIFY(recording.treesCsv() == "step,id,node,status\n3,5,\"Main/Go, then stop\",RUNNING\n");
}

void RecordingTest::frame_anyStep_isWhatWasAppended_data() {
  QTest::addColumn<int>("memory");
  QTest::newRow("in memory") << (1 << 30);
  QTest::newRow("on disk") << 0;
  QTest::newRow("both") << 100000;
}

void RecordingTest::frame_anyStep_isWhatWasAppended() {
  QFETCH(int, memory);
  Recording recording(2, static_cast<std::size_t>(memory));
  for (std::int64_t step = 0; step < 400; ++step) {
    recording.append(crowdAt(step, 7 + static_cast<int>(step / 100)));
  }
  QCOMPARE(recording.size(), std::size_t{200});
  for (const std::size_t index : std::vector<std::size_t>{0, 199, 64, 63, 65, 128, 100, 1}) {
    const auto step = static_cast<std::int64_t>(2 * index);
    QVERIFY(isSameState(*recording.frame(index), crowdAt(step, 7 + static_cast<int>(step / 100))));
    QCOMPARE(recording.stepOf(index), step);
    QCOMPARE(recording.indexAt(step), index);
    QCOMPARE(recording.indexAt(step + 1), index);
    QCOMPARE(recording.indexAtTime(recording.timeOf(index)), index);
  }
  QCOMPARE(recording.indexAt(-5), std::size_t{0});
  const Trace trace = recording.trace();
  QCOMPARE(trace.frames.size(), std::size_t{200});
  QVERIFY(isSameState(trace.frames[131], crowdAt(262, 9)));
}

void RecordingTest::treesAt_anyStep_isWhatTheChangesMake() {
  constexpr int kPeople = 5, kNodes = 9, kSteps = 3000;
  Recording recording;
  const TreeChanges::Paths names = nodeNames(kNodes);
  std::vector<std::vector<std::vector<base::NodeStatus>>> expected;  // by step, person, node
  std::vector<std::vector<base::NodeStatus>> now(
      kPeople, std::vector<base::NodeStatus>(kNodes, base::NodeStatus::Idle));
  std::mt19937 draw(7);
  for (int step = 0; step < kSteps; ++step) {
    Frame frame;
    frame.step = step;
    for (int person = 0; person < kPeople; ++person) {
      for (int node = 0; node < kNodes; ++node) {
        const auto status = static_cast<base::NodeStatus>(draw() % 4);
        base::NodeStatus& last =
            now[static_cast<std::size_t>(person)][static_cast<std::size_t>(node)];
        if ((step == 1 || draw() % 5 == 0) && status != last) {
          last = status;
          frame.treeChanges.add(person, names, node, status);
        }
      }
    }
    recording.append(frame);
    expected.push_back(now);
  }
  for (const int step : {2, 17, 1999, 2, 2999, 1000}) {
    const std::map<int, TreeStatuses> trees = recording.treesAt(step);
    QCOMPARE(trees.size(), std::size_t{kPeople});
    for (int person = 0; person < kPeople; ++person) {
      const auto& statuses =
          expected[static_cast<std::size_t>(step)][static_cast<std::size_t>(person)];
      QVERIFY(trees.at(person).statuses == statuses);
      QVERIFY(recording.treeAt(person, step).statuses == statuses);
    }
  }
  QVERIFY(recording.treeAt(99, 2000).paths == nullptr);
  QVERIFY(Recording().treeAt(1, 0).paths == nullptr);
}

void RecordingTest::read_whileItIsWritten_seesWholeSteps() {
  Recording recording(1, 200000);
  constexpr std::int64_t kSteps = 3000;
  std::atomic<bool> isWrong{false};
  const auto read = [&] {
    while (recording.size() < kSteps) {
      const std::size_t size = recording.size();
      for (std::size_t index = 0; index < size; index += 97) {
        const auto step = static_cast<std::int64_t>(index);
        isWrong = isWrong || !isSameState(*recording.frame(index), crowdAt(step, 3)) ||
                  recording.events().size() <= index || recording.header()->humans.empty();
      }
    }
  };
  std::thread first(read), second(read);
  for (std::int64_t step = 0; step < kSteps; ++step) {
    if (step % 500 == 0) {
      TraceHeader header;
      header.humans.resize(1 + static_cast<std::size_t>(step));
      recording.setHeader(header);
    }
    Frame frame = crowdAt(step, 3);
    frame.events = {makeEvent(EventKind::Say, 1)};
    recording.append(frame);
  }
  first.join();
  second.join();
  QVERIFY(!isWrong);
}

void RecordingTest::readRecording_folder_isWhatWasRecorded() {
  Recording recording;
  recordDoor(recording);
  QTemporaryDir folder;
  const std::string path = folder.path().toStdString() + "/";
  const Trace trace = recording.trace();
  QVERIFY(base::writeFileAtomically(path + "trajectory.csv", trajectoryCsv(trace)).empty());
  QVERIFY(base::writeFileAtomically(path + "events.csv", eventsCsv(trace)).empty());
  QVERIFY(base::writeFileAtomically(path + "trace.json", traceJson(trace.header)).empty());
  const auto without = readRecording(path);
  QVERIFY(without && (*without)->treeAt(1, 50).paths == nullptr);
  QVERIFY(base::writeFileAtomically(path + "trees.csv", recording.treesCsv()).empty());
  std::string inputs = inputsHeader();
  appendInputRow(inputs, recording.inputs()[0].first, recording.inputs()[0].second);
  QVERIFY(base::writeFileAtomically(path + "inputs.csv", inputs).empty());
  const auto read = readRecording(path);
  QVERIFY(read);
  QCOMPARE((*read)->size(), recording.size());
  for (const std::size_t index : std::vector<std::size_t>{0, 59, 60, 100}) {
    const FramePtr frame = (*read)->frame(index);
    QVERIFY(frame->humans == recording.frame(index)->humans);
    QVERIFY(frame->robots == recording.frame(index)->robots);
    QVERIFY(frame->doorOpen == recording.frame(index)->doorOpen);
    QVERIFY(frame->forces.goal.empty() && frame->robotPaths.empty());
  }
  QVERIFY((*read)->treesCsv() == recording.treesCsv());
  QCOMPARE((*read)->inputs().size(), std::size_t{1});
  QVERIFY((*read)->inputs()[0] == recording.inputs()[0]);
  QVERIFY((*read)->treeAt(1, 12).statuses ==
          (std::vector<base::NodeStatus>{base::NodeStatus::Running, base::NodeStatus::Running,
                                         base::NodeStatus::Idle, base::NodeStatus::Idle}));
  QVERIFY(eventsCsv((*read)->trace()) == eventsCsv(trace));
  QVERIFY(base::writeFileAtomically(path + "trees.csv", "step,id,node,status\n1,1,Main,LATE\n")
              .empty());
  const auto damaged = readRecording(path);
  QVERIFY(!damaged);
  QCOMPARE(damaged.diagnostics()[0].line, 2);
  QVERIFY(damaged.diagnostics()[0].message == "unknown status 'LATE'");
}

void RecordingTest::csvReader_quotedFields_giveTextAndPlace() {
  CsvReader reader("a,\"b\"\"c\nd\",e\r\n\nlast");
  CsvRow row;
  QVERIFY(reader.next(row));
  QCOMPARE(row.size(), std::size_t{3});
  QVERIFY(row[1].text == "b\"c\nd");
  QVERIFY(row[2].text == "e");
  QCOMPARE(row[1].line, 1);
  QCOMPARE(row[1].column, 3);
  QCOMPARE(row[2].line, 2);
  QCOMPARE(row[2].column, 4);
  QVERIFY(reader.next(row));
  QCOMPARE(row.size(), std::size_t{1});
  QVERIFY(!reader.isTruncated());
  QVERIFY(reader.next(row));
  QVERIFY(row[0].text == "last");
  QVERIFY(reader.isTruncated());
  QVERIFY(!reader.next(row));
}

void RecordingTest::eventKindOf_everyName_roundTrips() {
  for (int k = 0; k < kEventKinds; ++k) {
    const auto kind = static_cast<EventKind>(k);
    QVERIFY(eventKindOf(eventKindName(kind)) == kind);
  }
  QVERIFY(!eventKindOf("bump"));
  QVERIFY(std::string(eventKindName(EventKind::Stop)) == "stop");
}

QTEST_APPLESS_MAIN(RecordingTest)
#include "tst_Recording.moc"
