#include <algorithm>
#include <cmath>
#include <ctime>

#include <QtTest>

#include "metrics/Report.h"
#include "tests/metrics/MetricCases.h"
#include "tests/metrics/SampledRun.h"

using namespace metrics;

/// All metrics of records in steps of 0.05 s, in processor time, so that other programs on the
/// machine do not count. Limits: 50 ms for 60 s with 20 people, 2 s with 1000. The ratio says how
/// much a person and sample costs beside the first row: about 1 when the time is linear in both.
class MetricsBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void evaluate_all_data();
  void evaluate_all();
  void evaluate_frames_data() { evaluate_all_data(); }
  void evaluate_frames();

 private:
  void tell(double seconds, double& first);
  double firstOfSamples_ = 0.0, firstOfFrames_ = 0.0;  // of a person and sample [s]
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

/// The quickest of some rounds, in seconds of the processor.
template <class Round>
double processorTime(Round round) {
  constexpr int kRounds = 3;
  double best = HUGE_VAL;
  for (int k = 0; k < kRounds; ++k) {
    const std::clock_t begin = std::clock();
    round();
    best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return best;
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

void MetricsBench::tell(double seconds, double& first) {
  QFETCH(int, people);
  QFETCH(int, steps);
  const double each = seconds / (static_cast<double>(people) * static_cast<double>(steps));
  first = first > 0.0 ? first : each;
  qInfo("%4d people, %4.0f s: %7.1f ms, %.2f us per person and sample, ratio %.2f", people,
        0.05 * steps, 1e3 * seconds, 1e6 * each, each / first);
  QTest::setBenchmarkResult(1e3 * seconds, QTest::WalltimeMilliseconds);
}

void MetricsBench::evaluate_all() {
  QFETCH(int, people);
  QFETCH(int, steps);
  const SampledRun recording = sampledRunOf(crowd(people, steps));
  tell(processorTime([&recording] { QVERIFY(evaluate(recording, {}, {})); }), firstOfSamples_);
}

/// As a program does it: walls and sight are looked up as well.
void MetricsBench::evaluate_frames() {
  QFETCH(int, people);
  QFETCH(int, steps);
  const sim2d::Trace trace = crowd(people, steps);
  tell(processorTime([&trace] { QVERIFY(evaluate(trace, {}, {})); }), firstOfFrames_);
}

QTEST_APPLESS_MAIN(MetricsBench)
#include "bench_Metrics.moc"
