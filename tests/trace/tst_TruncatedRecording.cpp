#include <cmath>

#include <QTemporaryDir>
#include <QtTest>

#include "sim2d/trace/Recording.h"
#include "sim2d/trace/TruncatedRecording.h"

using namespace sim2d;

namespace {

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

/// Records whose files end in the midst.
class CutRecordTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
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

QTEST_APPLESS_MAIN(CutRecordTest)
#include "tst_TruncatedRecording.moc"
