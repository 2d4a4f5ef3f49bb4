#include <QtTest>

#include "sim2d/trace/Csv.h"
#include "sim2d/trace/Recorder.h"
#include "sim2d/trace/TraceRows.h"

using namespace sim2d;

namespace {

Event makeEvent(EventKind kind, int id) {
  Event made;
  made.kind = kind;
  made.id = id;
  return made;
}

/// Writes the files of a run row by row.
class RowSink : public RecordSink {
 public:
  void take(const RecordedStep& step) override {
    if (step.frame != nullptr) {
      appendTrajectoryRows(trajectory, *step.frame);
    }
    for (const Event& event : step.events) {
      appendEventRow(events, step.step, 0.05, event);
    }
    trees += step.treeRows;
  }
  std::string trajectory = trajectoryHead();
  std::string events = eventsHead();
  std::string trees = treesHead();
};

}  // namespace

class RecorderTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void append_everySecondStep_keepsAllEvents();
  void append_eventsOfOneStep_areOrderedByKindThenId();
  void treesCsv_nodesWithCommas_areQuoted();
  void finish_thenAppend_startsAnew();
  void sink_takesAllAndNothingIsKept();
  void csvReader_quotedFields_giveTextAndPlace();
  void eventKindOf_everyName_roundTrips();
};

void RecorderTest::append_everySecondStep_keepsAllEvents() {
  Recorder recorder(2);
  for (int step = 0; step < 5; ++step) {
    Frame frame;
    frame.step = step;
    frame.events = {makeEvent(EventKind::Say, step)};
    recorder.append(frame);
  }
  const Trace trace = recorder.finish(TraceHeader{});
  QCOMPARE(trace.frames.size(), std::size_t{3});
  QCOMPARE(trace.frames[2].step, std::int64_t{4});
  QCOMPARE(trace.events.size(), std::size_t{5});
  QCOMPARE(trace.header.recordEvery, 2);
  QVERIFY(trace.frames[0].events.empty());
}

void RecorderTest::append_eventsOfOneStep_areOrderedByKindThenId() {
  Recorder recorder;
  Frame frame;
  frame.events = {makeEvent(EventKind::Say, 2), makeEvent(EventKind::Goal, 9),
                  makeEvent(EventKind::Goal, 4)};
  recorder.append(frame);
  const Trace trace = recorder.finish(TraceHeader{});
  QCOMPARE(trace.events[0].second.id, 4);
  QCOMPARE(trace.events[1].second.id, 9);
  QCOMPARE(trace.events[2].second.id, 2);
}

void RecorderTest::treesCsv_nodesWithCommas_areQuoted() {
  Recorder recorder(10);
  Frame frame;
  frame.step = 3;
  const auto paths = std::make_shared<const std::vector<std::string>>(
      std::vector<std::string>{"Main", "Main/Go, then stop"});
  frame.treeChanges.add(5, paths, 1, base::NodeStatus::Running);
  recorder.append(frame);
  QVERIFY(recorder.treesCsv() == "step,id,node,status\n3,5,\"Main/Go, then stop\",RUNNING\n");
}

void RecorderTest::sink_takesAllAndNothingIsKept() {
  RowSink rows;
  Recorder streamed(2, &rows);
  Recorder kept(2);
  const auto paths =
      std::make_shared<const std::vector<std::string>>(std::vector<std::string>{"Main"});
  for (int step = 0; step < 5; ++step) {
    Frame frame;
    frame.step = step;
    frame.time = 0.05 * step;
    frame.robots.id = {-1};
    frame.robots.x = frame.robots.y = frame.robots.heading = {0.1 * step};
    frame.robots.vx = frame.robots.vy = frame.robots.omega = {1.0};
    frame.robots.goal = {kNoGoal};
    frame.events = {makeEvent(EventKind::Say, step), makeEvent(EventKind::Goal, step)};
    frame.treeChanges.add(1, paths, 0, base::NodeStatus::Success);
    streamed.append(frame);
    kept.append(frame);
  }
  TraceHeader header;
  header.dt = 0.05;
  const std::string trees = kept.treesCsv();
  const Trace trace = kept.finish(header);
  QVERIFY(rows.trajectory == trajectoryCsv(trace));
  QVERIFY(rows.events == eventsCsv(trace));
  QVERIFY(rows.trees == trees);
  const Trace empty = streamed.finish(header);
  QVERIFY(empty.frames.empty() && empty.events.empty() && streamed.treesCsv() == treesHead());
}

void RecorderTest::finish_thenAppend_startsAnew() {
  Recorder recorder;
  Frame frame;
  const auto paths =
      std::make_shared<const std::vector<std::string>>(std::vector<std::string>{"Main"});
  frame.treeChanges.add(1, paths, 0, base::NodeStatus::Success);
  recorder.append(frame);
  QCOMPARE(recorder.finish(TraceHeader{}).frames.size(), std::size_t{1});
  QVERIFY(recorder.treesCsv() == "step,id,node,status\n0,1,Main,SUCCESS\n");
  recorder.append(Frame{});
  QVERIFY(recorder.treesCsv() == "step,id,node,status\n");
  QCOMPARE(recorder.finish(TraceHeader{}).frames.size(), std::size_t{1});
}

void RecorderTest::csvReader_quotedFields_giveTextAndPlace() {
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

void RecorderTest::eventKindOf_everyName_roundTrips() {
  for (int k = 0; k < kEventKinds; ++k) {
    const auto kind = static_cast<EventKind>(k);
    QVERIFY(eventKindOf(eventKindName(kind)) == kind);
  }
  QVERIFY(!eventKindOf("bump"));
  QVERIFY(std::string(eventKindName(EventKind::Stop)) == "stop");
}

QTEST_APPLESS_MAIN(RecorderTest)
#include "tst_Recorder.moc"
