#include <cmath>

#include <QtTest>

#include "metrics/ReportFiles.h"
#include "tests/metrics/MetricCases.h"

using namespace metrics;

/// All metrics of 60 s in steps of 0.05 s. Limits: 50 ms with 20 people, 2 s with 1000; twice the
/// people or twice the time may take twice as long.
class MetricsBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void evaluate_all_data();
  void evaluate_all();
  void samples_ofFrames_data() { evaluate_all_data(); }
  void samples_ofFrames();
};

namespace {

/// People in a block of 1.5 m by 1.5 m each, in three directions, and a robot among them.
sim2d::Trace crowd(int people, int steps) {
  constexpr double kStep = 0.05;
  sim2d::Trace trace = cases::trace(steps, 0, kStep);
  trace.header = cases::header(people, kStep);
  const int side = static_cast<int>(std::ceil(std::sqrt(people)));
  for (sim2d::Frame& frame : trace.frames) {
    sim2d::HumanColumns& humans = frame.humans;
    for (int k = 0; k < people; ++k) {
      const double heading = 2.1 * (k % 3);
      const double way = 0.5 * std::sin(0.8 * frame.time + k);
      const double speed = 0.4 * std::cos(0.8 * frame.time + k);
      humans.id.push_back(k + 1);
      humans.x.push_back(1.5 * (k % side) + way * std::cos(heading));
      humans.y.push_back(1.5 * (k / side) + way * std::sin(heading) - 3.0);
      humans.vx.push_back(speed * std::cos(heading));
      humans.vy.push_back(speed * std::sin(heading));
      humans.heading.push_back(heading);
      humans.omega.push_back(0.0);
      humans.group.push_back(k % 10 < 3 ? k / 10 : -1);
      humans.state.push_back(0);
      humans.goal.push_back(sim2d::kNoGoal);
    }
  }
  return trace;
}

}  // namespace

void MetricsBench::evaluate_all_data() {
  QTest::addColumn<int>("people");
  QTest::addColumn<int>("steps");
  QTest::newRow("20 people") << 20 << 1200;
  QTest::newRow("20 people, 600 s") << 20 << 12000;
  QTest::newRow("100 people") << 100 << 1200;
  QTest::newRow("1000 people") << 1000 << 1200;
}

void MetricsBench::evaluate_all() {
  QFETCH(int, people);
  QFETCH(int, steps);
  const Recording recording = recordingOf(crowd(people, steps));
  QBENCHMARK_ONCE {
    QVERIFY(evaluate(recording, {}, {}));
  }
}

void MetricsBench::samples_ofFrames() {
  QFETCH(int, people);
  QFETCH(int, steps);
  const sim2d::Trace trace = crowd(people, steps);
  QBENCHMARK_ONCE {
    QCOMPARE(recordingOf(trace).samples.size(), trace.frames.size());
  }
}

QTEST_APPLESS_MAIN(MetricsBench)
#include "bench_Metrics.moc"
