#include <QtTest>

#include "MetricCases.h"
#include "metrics/IncrementalEvaluation.h"

using namespace metrics;

namespace {

/// Turns and moves a trace without obstacles and map.
sim2d::Trace moved(sim2d::Trace trace, double angle, const Vec2& shift) {
  const base::Pose2 pose{shift, angle};
  const auto moveColumns = [&](auto& columns) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const Vec2 position = pose.toWorld(Vec2(columns.x[k], columns.y[k]));
      const Vec2 velocity =
          base::Pose2{Vec2(0, 0), angle}.toWorld(Vec2(columns.vx[k], columns.vy[k]));
      columns.x[k] = position.x();
      columns.y[k] = position.y();
      columns.vx[k] = velocity.x();
      columns.vy[k] = velocity.y();
      columns.heading[k] = base::wrapToPi(columns.heading[k] + angle);
    }
  };
  for (sim2d::Frame& frame : trace.frames) {
    moveColumns(frame.humans);
    moveColumns(frame.robots);
  }
  for (sim2d::TraceRobot& robot : trace.header.robots) {
    for (sim2d::TraceGoal& goal : robot.goals) {
      goal.position = pose.toWorld(goal.position);
    }
  }
  return trace;
}

sim2d::Trace openTrace() {
  sim2d::Trace trace = cases::trace(80, 5, 0.1);
  trace.header.obstacles.clear();
  trace.header.map = sim2d::OccupancyGrid();
  return trace;
}

std::vector<MetricResult> resultsOf(const sim2d::Trace& trace, Profile profile) {
  return evaluate(trace, Selection{}, cases::parametersOf(profile))->results;
}

}  // namespace

class LiveMetricsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void values_atEveryFrame_equalOffline_data();
  void values_atEveryFrame_equalOffline();
  void evaluate_movedWorld_givesTheSame();
  void evaluate_otherIds_givesTheSame();
};

void LiveMetricsTest::values_atEveryFrame_equalOffline_data() {
  QTest::addColumn<int>("profile");
  QTest::newRow("corrected") << static_cast<int>(Profile::Corrected);
  QTest::newRow("hunav2") << static_cast<int>(Profile::Hunav2);
}

void LiveMetricsTest::values_atEveryFrame_equalOffline() {
  QFETCH(int, profile);
  const MetricParameters parameters = cases::parametersOf(static_cast<Profile>(profile));
  sim2d::Trace trace = cases::trace(60, 6);
  const std::vector<sim2d::Frame> frames = std::move(trace.frames);
  trace.frames.clear();
  FrameEvaluation live(trace.header, Selection{}, parameters);
  QVERIFY(live.values().empty());
  for (const sim2d::Frame& frame : frames) {
    live.append(frame);
    trace.frames.push_back(frame);
    if (frame.step % 10 == 0) {
      const auto offline = evaluate(trace, Selection{}, parameters);
      QVERIFY(offline);
      const std::string problem = cases::difference(live.values(), offline->results, 0.0);
      QVERIFY2(problem.empty(), problem.c_str());
    }
  }
  QCOMPARE(live.finish()->times.size(), std::size_t{61});
}

void LiveMetricsTest::evaluate_movedWorld_givesTheSame() {
  for (const Profile profile : {Profile::Corrected, Profile::Hunav2}) {
    const sim2d::Trace trace = openTrace();
    const std::string problem = cases::difference(
        resultsOf(trace, profile), resultsOf(moved(trace, 2.0, Vec2(3.0, -7.0)), profile), 1e-7);
    QVERIFY2(problem.empty(), problem.c_str());
  }
}

void LiveMetricsTest::evaluate_otherIds_givesTheSame() {
  sim2d::Trace renamed = openTrace();
  for (sim2d::Frame& frame : renamed.frames) {
    for (int& id : frame.humans.id) {
      id = 100 - id;
    }
  }
  for (sim2d::TraceHuman& human : renamed.header.humans) {
    human.id = 100 - human.id;
  }
  const std::string problem = cases::difference(resultsOf(openTrace(), Profile::Corrected),
                                                resultsOf(renamed, Profile::Corrected), 1e-12);
  QVERIFY2(problem.empty(), problem.c_str());
}

QTEST_APPLESS_MAIN(LiveMetricsTest)
#include "tst_LiveMetrics.moc"
