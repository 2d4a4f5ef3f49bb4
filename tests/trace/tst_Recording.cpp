#include <atomic>
#include <cmath>
#include <random>
#include <thread>

#include <QTemporaryDir>
#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"
#include "sim2d/trace/Recording.h"
#include "tests/trace/WildRun.h"

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
    const Vec2 place(std::cos(phase), id % 3 == 0 ? -0.0 : std::sin(phase));  // some stand still
    humans.add(id, {place, phase}, {-std::sin(phase), std::cos(phase)}, 0.2,
               static_cast<int>(step / 100));
    humans.group.push_back(id % 5);
    humans.state.push_back(step % 50 == id ? 1 : 0);
    for (std::vector<Vec2>* forces :
         {&frame.forces.goal, &frame.forces.social, &frame.forces.obstacle, &frame.forces.group}) {
      forces->push_back(step == 0 ? Vec2(0.0, 0.0) : Vec2(phase, -phase));
    }
  }
  const double way = 0.001 * static_cast<double>(step);
  frame.robots.add(-1, {{way, way}, way}, {1.0, 1.0}, 1.0, kNoGoal);
  const std::int64_t plans = step / 70;
  frame.robotPaths = {{Vec2(0.0, 0.0), Vec2(1.0, static_cast<double>(plans))}};
  frame.doorOpen = {static_cast<char>(step < 60 ? 1 : 0)};
  return frame;
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

constexpr int kFrames = 6;

/// Two people and a robot, six states of 0.1 s, what was said in the middle, and its end.
Trace sample() {
  Trace trace;
  trace.header.dt = 0.1;
  for (const int id : {1, 2}) {
    TraceHuman human;
    human.id = id;
    human.name = "person" + std::to_string(id);
    trace.header.humans.push_back(human);
  }
  trace.header.robots.emplace_back();
  for (int step = 0; step < kFrames; ++step) {
    Frame& frame = trace.frames.emplace_back();
    frame.step = step;
    frame.time = step * 0.1;
    for (const int id : {1, 2}) {
      frame.humans.add(id, {{0.1 * step, id * 1.5}, 0.25}, {1.0, 0.0}, 0.0, kNoGoal);
      frame.humans.group.push_back(-1);
      frame.humans.state.push_back(0);
    }
    frame.robots.add(-1, {{-1.0, 0.1 * step}, 0.0}, {0.0, 1.0}, 0.0, kNoGoal);
  }
  trace.events.emplace_back(2, Event{EventKind::Say, 1, true, 0, false, "a \"quoted\"\nline, too"});
  trace.events.emplace_back(kFrames - 1, Event{EventKind::Stop, 0, false, 0, false, "duration"});
  return trace;
}

class Folder {
 public:
  explicit Folder(const Trace& trace) : trajectory(trajectoryCsv(trace)), events(eventsCsv(trace)) {
    write("trajectory.csv", trajectory);
    write("events.csv", events);
    write("trace.json", traceJson(trace.header));
  }
  std::string path() const { return folder_.path().toStdString(); }
  void write(const std::string& name, const std::string& text) const {
    QFile file(QString::fromStdString(path() + "/" + name));  // written often: not to the disk
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text.data(), static_cast<qint64>(text.size())),
             static_cast<qint64>(text.size()));
  }
  const std::string trajectory, events;

 private:
  QTemporaryDir folder_;
};

}  // namespace

/// Records, also those whose files end in the midst.
class RecordingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void append_everySecondStep_keepsAllEvents() {
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

  void append_eventsOfOneStep_areOrderedByKindThenId() {
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

  void treesCsv_nodesWithCommas_areQuoted() {
    Recording recording(10);
    Frame frame;
    frame.step = 3;
    const auto paths = std::make_shared<const std::vector<std::string>>(
        std::vector<std::string>{"Main", "Main/Go, then stop"});
    frame.treeChanges.add(5, paths, 1, base::NodeStatus::Running);
    recording.append(frame);
    QVERIFY(recording.treesCsv() == "step,id,node,status\n3,5,\"Main/Go, then stop\",RUNNING\n");
  }

  void frame_anyStep_isWhatWasAppended_data() {
    QTest::addColumn<int>("memory");
    QTest::newRow("in memory") << (1 << 30);
    QTest::newRow("on disk") << 0;
    QTest::newRow("both") << 100000;
  }

  void frame_anyStep_isWhatWasAppended() {
    QFETCH(int, memory);
    Recording recording(2, static_cast<std::size_t>(memory));
    for (std::int64_t step = 0; step < 400; ++step) {
      recording.append(crowdAt(step, 7 + static_cast<int>(step / 100)));
    }
    QCOMPARE(recording.size(), std::size_t{200});
    for (const std::size_t index : std::vector<std::size_t>{0, 199, 64, 63, 65, 128, 100, 1}) {
      const auto step = static_cast<std::int64_t>(2 * index);
      QVERIFY(wild::isSameState(*recording.frame(index),
                                crowdAt(step, 7 + static_cast<int>(step / 100))));
      QCOMPARE(recording.stepOf(index), step);
      QCOMPARE(recording.indexAt(step), index);
      QCOMPARE(recording.indexAt(step + 1), index);
      QCOMPARE(recording.indexAtTime(recording.timeOf(index)), index);
    }
    QCOMPARE(recording.indexAt(-5), std::size_t{0});
    const Trace trace = recording.trace();
    QCOMPARE(trace.frames.size(), std::size_t{200});
    QVERIFY(wild::isSameState(trace.frames[131], crowdAt(262, 9)));
  }

  void treesAt_anyStep_isWhatTheChangesMake() {
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

  void read_whileItIsWritten_seesWholeSteps() {
    Recording recording(1, 200000);
    constexpr std::int64_t kSteps = 3000;
    std::atomic<bool> isWrong{false};
    const auto read = [&] {
      while (recording.size() < kSteps) {
        const std::size_t size = recording.size();
        for (std::size_t index = 0; index < size; index += 97) {
          const auto step = static_cast<std::int64_t>(index);
          isWrong = isWrong || !wild::isSameState(*recording.frame(index), crowdAt(step, 3)) ||
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

  void readRecording_folder_isWhatWasRecorded() {
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

  void csvReader_quotedFields_giveTextAndPlace() {
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

  void eventKindOf_everyName_roundTrips() {
    for (int k = 0; k < kEventKinds; ++k) {
      const auto kind = static_cast<EventKind>(k);
      QVERIFY(eventKindOf(eventKindName(kind)) == kind);
    }
    QVERIFY(!eventKindOf("bump"));
    QVERIFY(std::string(eventKindName(EventKind::Stop)) == "stop");
  }

  void wholeLines_ofTexts_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("length");
    QTest::newRow("nothing") << QByteArray() << 0;
    QTest::newRow("no end") << QByteArray("a,b") << 0;
    QTest::newRow("whole") << QByteArray("a,b\nc,d\n") << 8;
    QTest::newRow("half a line") << QByteArray("a,b\nc,") << 4;
    QTest::newRow("quoted end") << QByteArray("a,b\nc,\"d\n") << 4;
    QTest::newRow("quotes closed") << QByteArray("a,\"b\nc\"\nx") << 8;
  }
  void wholeLines_ofTexts() {
    QFETCH(QByteArray, text);
    QFETCH(int, length);
    QCOMPARE(static_cast<int>(completeLinesSize(text.toStdString())), length);
  }

  void whole_isNotCut() {
    const Folder folder(sample());
    Truncation cut;
    const auto read = readTruncatedTrace(folder.path(), cut);
    QVERIFY2(read, read ? "" : read.diagnostics().front().text().c_str());
    QVERIFY(!cut.isTruncated());
    QCOMPARE(read->frames.size(), std::size_t{kFrames});
    QCOMPARE(read->events.size(), std::size_t{2});
  }

  /// Cut behind any byte: what is read is the beginning of the whole, and never a state of which
  /// a row is missing. A line is whole with its end; the row of the robot is the last of a state.
  void trajectory_cutAnywhere_givesWholeStates() {
    const Trace whole = sample();
    const Folder folder(whole);
    for (std::size_t length = 1; length < folder.trajectory.size(); ++length) {
      const std::string text = folder.trajectory.substr(0, length);
      folder.write("trajectory.csv", text);
      const auto lines = std::count(text.begin(), text.end(), '\n');
      const int states = std::max(0, (static_cast<int>(lines) - 1) / 3);
      const bool isTouched = (lines - 1) % 3 != 0;  // rows of the next state are there
      Truncation cut;
      const auto read = readTruncatedTrace(folder.path(), cut);
      if (lines == 0) {
        QVERIFY(!read || read->frames.empty());
        continue;
      }
      QVERIFY2(read, read ? "" : read.diagnostics().front().text().c_str());
      QVERIFY(cut.has("trajectory.csv"));
      const int expected = isTouched ? states : std::max(0, states - 1);
      QCOMPARE(static_cast<int>(read->frames.size()), expected);
      for (int k = 0; k < expected; ++k) {
        QVERIFY(read->frames[static_cast<std::size_t>(k)].humans ==
                whole.frames[static_cast<std::size_t>(k)].humans);
      }
      QVERIFY(std::fabs(cut.time - 0.1 * std::max(0, expected - 1)) < 1e-12);
      QVERIFY(cut.end && std::fabs(*cut.end - 0.1 * (kFrames - 1)) < 1e-12);
      QCOMPARE(read->events.size(), std::size_t{expected > 2 ? 1U : 0U});
      QVERIFY(!readTrace(folder.path()));  // who wants all of it is told so
    }
  }

  void events_cutAnywhere_leaveTheStates() {
    const Folder folder(sample());
    for (std::size_t length = 0; length < folder.events.size(); ++length) {
      folder.write("events.csv", folder.events.substr(0, length));
      Truncation cut;
      const auto read = readTruncatedTrace(folder.path(), cut);
      if (!read) {
        QVERIFY(folder.events.substr(0, length).find('\n') == std::string::npos);
        continue;
      }
      QCOMPARE(read->frames.size(), std::size_t{kFrames});
      QVERIFY(read->events.size() < 2);
    }
  }

  void recording_ofACutFolder_hasWhatIsWhole() {
    const Folder folder(sample());
    folder.write("trajectory.csv", folder.trajectory.substr(0, folder.trajectory.size() - 5));
    Truncation cut;
    const auto read = readRecording(folder.path(), Recording::kDefaultMemory, &cut);
    QVERIFY2(read, read ? "" : read.diagnostics().front().text().c_str());
    QCOMPARE((*read)->size(), std::size_t{kFrames - 1});
    QVERIFY(!readRecording(folder.path()));
  }

  void unfinished_fileOfAKilledProcess_isFound() {
    const Folder folder(sample());
    QVERIFY(QFile::remove(QString::fromStdString(folder.path() + "/trajectory.csv")));
    folder.write("trajectory.csv.new-123-0", folder.trajectory);
    Truncation cut;
    const auto read = readTruncatedTrace(folder.path(), cut);
    QVERIFY2(read, read ? "" : read.diagnostics().front().text().c_str());
    QCOMPARE(read->frames.size(), std::size_t{kFrames});
  }

  /// People from sources came in after the header was written.
  void unknownPeople_ofACutRecord_areMet() {
    Trace trace = sample();
    trace.header.humans.pop_back();
    const Folder folder(trace);
    Truncation cut;
    QVERIFY(!readTruncatedTrace(folder.path(), cut));  // a whole run knows its people
    cut.isUnfinished = true;
    const auto read = readTruncatedTrace(folder.path(), cut);
    QVERIFY2(read, read ? "" : read.diagnostics().front().text().c_str());
    QVERIFY(read->header.human(2) != nullptr);
    QVERIFY(!readTrace(folder.path()));
  }
};

QTEST_APPLESS_MAIN(RecordingTest)
#include "tst_Recording.moc"
