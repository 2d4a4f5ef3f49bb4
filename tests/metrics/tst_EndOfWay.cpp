#include <QtTest>

#include "HandMade.h"
#include "sim2d/trace/RobotArrival.h"

using namespace metrics;
using namespace handmade;

namespace {

sim2d::Event arrived() {
  sim2d::Event event;
  event.kind = sim2d::EventKind::Arrived;
  event.id = -1;
  return event;
}

/// A robot along x at these places of each second, somebody far away; the goal is at 5.4 m, its
/// radius 0.2 m, so that within 0.5 m of it is completed.
SampledRun runAlong(const std::vector<double>& places) {
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const bool moves = k + 1 < places.size() && places[k + 1] != places[k];
    samples.push_back(sampleAt(static_cast<double>(k), places[k], 0.0, moves ? 1.0 : 0.0));
    samples.back().people = {personAt(1, 20.0, 20.0)};
  }
  SampledRun run = recordingOfSamples(std::move(samples));
  run.robotId = -1;
  run.goals = {{1, Vec2(5.4, 0.0), 0.2}};
  return run;
}

/// At 1 m/s to `end`, then parked for so many seconds.
std::vector<double> parkedAt(int end, int seconds) {
  std::vector<double> places;
  for (int t = 0; t <= end + seconds; ++t) {
    places.push_back(std::min(t, end));
  }
  return places;
}

/// Results of all metrics of the robot as one text.
QString allOf(const SampledRun& run, const Selection& selection) {
  QString text;
  const base::Result<Evaluation> made = evaluate(run, selection, {});
  for (const MetricResult& result : made->results) {
    if (result.info.needs.robot) {
      text += QString::fromStdString(result.info.key) + QLatin1Char(' ') +
              QString::number(result.value.value.value_or(-77.0), 'g', 12) + QLatin1Char('\n');
    }
  }
  for (const BehaviorEvaluation& behavior : made->behaviors) {
    for (const MetricResult& result : behavior.results) {
      if (result.info.needs.robot) {
        text += QString::number(result.value.value.value_or(-77.0), 'g', 12);
      }
    }
  }
  return text;
}

}  // namespace

/// Where a way ends that no event ends; expected values by hand.
class EndOfWayTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// At 5 m it is 0.4 m from the goal: completed, though it has not arrived by the world's rule.
  void parkedInTheRegion_endsWithItsFirstSample() {
    for (const int seconds : {0, 1, 50, 200}) {
      const SampledRun run = runAlong(parkedAt(5, seconds));
      QCOMPARE(valueOf(run, "completed"), 1.0);
      QCOMPARE(valueOf(run, "success"), 1.0);
      QCOMPARE(valueOf(run, "time_to_reach_goal"), 5.0);
      QCOMPARE(valueOf(run, "stl"), 1.0);  // 5.4 m at 1 m/s, in 5 s
      QCOMPARE(valueOf(run, "timeout"), 0.0);
      QVERIFY(isNear(valueOf(run, "avg_robot_linear_speed"), 5.0 / 6.0));
      QCOMPARE(valueOf(run, "total_time"), 5.0 + seconds);  // of the record
    }
  }
  void parkedInTheRegion_allMetricsOfAnySelection_areThoseOfTheWay() {
    Selection selection;
    selection.behaviors = true;
    const QString atOnce = allOf(runAlong(parkedAt(5, 0)), selection);
    QVERIFY(atOnce.count(QLatin1Char('\n')) > 60);
    QCOMPARE(allOf(runAlong(parkedAt(5, 100)), selection), atOnce);
    selection.seriesOnDisk = true;
    QCOMPARE(allOf(runAlong(parkedAt(5, 600)), selection), atOnce);
  }
  /// Stands in the region at 5 s, drives out of it at 6 s, stands in it again from 9 s on.
  void standingThatEnds_isNoArrival() {
    const SampledRun run = runAlong({0, 1, 2, 3, 4, 5, 5, 6, 7, 5, 5, 5});
    QCOMPARE(valueOf(run, "time_to_reach_goal"), 9.0);
    QCOMPARE(valueOf(run, "path_length"), 9.0);
    QVERIFY(isNear(valueOf(run, "stl"), 5.4 / 9.0));
    const SampledRun away = runAlong({0, 1, 2, 3, 4, 5, 5, 6, 7, 7, 7});
    QCOMPARE(valueOf(away, "completed"), 0.0);
    QCOMPARE(valueOf(away, "path_length"), 7.0);
  }
  /// On into the region to the end of the record.
  void movingInTheRegion_isOnItsWay() {
    QCOMPARE(valueOf(runAlong({0, 1, 2, 3, 4, 5, 5.1, 5.2, 5.3}), "path_length"), 5.3);
  }
  void standingAtTheGoalAllTheTime_isNoArrival() {
    QCOMPARE(valueOf(runAlong({5, 5, 5, 5}), "stalled_time"), 3.0);
  }
  void arrivalThatIsTold_rules() {
    SampledRun run = runAlong({0, 1, 2, 3, 4, 5, 5, 5, 5.3, 5.3});
    QCOMPARE(valueOf(run, "path_length"), 5.3);
    run.events = {{7.0, arrived()}};
    QCOMPARE(valueOf(run, "path_length"), 5.0);
    QVERIFY(isNear(valueOf(run, "stl"), 5.4 / 7.0));
    run.events = {{9.0, arrived()}};
    QVERIFY(isNear(valueOf(run, "stl"), 5.4 / 9.0));
  }
  void windowThatSaysItsEnd_isHeeded() {
    Selection selection;
    selection.window.until = "time 20";
    const auto made = evaluate(runAlong(parkedAt(5, 30)), selection, {});
    QVERIFY(isNear(*made->find("avg_robot_linear_speed")->value.value, 5.0 / 21.0));
  }
  void series_ofAStay_hasNothingAfterIt() {
    const SampledRun run = runAlong(parkedAt(5, 4));
    const auto made = evaluate(run, Selection(), {});
    const std::vector<double>& speeds = made->find("avg_robot_linear_speed")->value.series->values;
    QCOMPARE(speeds.size(), std::size_t{10});
    QCOMPARE(speeds[4], 1.0);
    QCOMPARE(speeds[5], 0.0);
    QVERIFY(std::isnan(speeds[6]) && std::isnan(speeds[9]));
  }

  /// It stands 2 m before the goal for good: after the time limit it has failed, however long the
  /// record goes on.
  void failure_isTheTimeLimit() {
    MetricParameters parameters;
    parameters.timeLimit = 20.0;
    for (const int duration : {20, 30, 300}) {
      const SampledRun run = runAlong(parkedAt(3, duration - 3));
      QVERIFY(isNear(valueOf(run, "avg_robot_linear_speed", parameters), 3.0 / 21.0));
      QCOMPARE(valueOf(run, "timeout", parameters), 1.0);
      QCOMPARE(valueOf(run, "stalled_time", parameters), 17.0);
      QCOMPARE(valueOf(run, "success", parameters), 0.0);
    }
    const SampledRun earlier = runAlong(parkedAt(3, 7));
    QVERIFY(isNear(valueOf(earlier, "avg_robot_linear_speed", parameters), 3.0 / 11.0));
    QCOMPARE(valueOf(earlier, "timeout", parameters), 0.0);
  }
  void arrivalAfterTheLimit_isOneAllTheSame() {
    MetricParameters parameters;
    parameters.timeLimit = 3.0;
    SampledRun run = runAlong(parkedAt(5, 10));
    QCOMPARE(valueOf(run, "completed", parameters), 1.0);
    QCOMPARE(valueOf(run, "path_length", parameters), 5.0);
    QCOMPARE(valueOf(run, "timeout", parameters), 1.0);
    QCOMPARE(valueOf(run, "success", parameters), 0.0);
    run.events = {{7.0, arrived()}};
    QVERIFY(isNear(valueOf(run, "stl", parameters), 5.4 / 7.0));
  }
  /// All results use the same arrival: the robot is in the region at 5 s, at its goal at 7 s.
  void everyKey_hasTheArrivalOfTheEvent() {
    SampledRun run = runAlong({0, 1, 2, 3, 4, 5, 5.1, 5.3, 5.3, 5.3});
    run.eventsReportArrivals = true;
    run.events = {{7.0, arrived()}};
    QCOMPARE(valueOf(run, "time_to_reach_goal"), 7.0);
    QCOMPARE(valueOf(run, "aggregated_time"), 7.0);
    QVERIFY(isNear(valueOf(run, "stl"), 5.4 / 7.0));
    QCOMPARE(valueOf(run, "completed"), 1.0);
    QCOMPARE(valueOf(run, "success"), 1.0);
    QCOMPARE(valueOf(run, "path_length"), 5.3);
    MetricParameters original;  // ignores events: the whole record, and the wide region
    original.profile = Profile::Hunav2;
    QCOMPARE(valueOf(run, "time_to_reach_goal", original), 9.0);
    QVERIFY(isNear(valueOf(run, "stl", original), 5.4 / 9.0));
  }
  /// 0.4 m from its goal a robot of a simulation has not arrived, in any key.
  void simulatedRobotWithoutEvent_hasNotArrived() {
    SampledRun run = runAlong(parkedAt(5, 20));
    run.eventsReportArrivals = true;
    for (const char* key : {"completed", "success", "spl", "stl"}) {
      QVERIFY2(valueOf(run, key) == 0.0, key);
    }
    QVERIFY(std::isnan(valueOf(run, "time_to_reach_goal")));
    QCOMPARE(valueOf(run, "aggregated_time"), 25.0);  // until the end
    QCOMPARE(valueOf(run, "stalled_time"), 20.0);     // it continues
    MetricParameters original;
    original.profile = Profile::Hunav2;
    QCOMPARE(valueOf(run, "completed", original), 1.0);
    run.eventsReportArrivals = false;  // a record without events of arrivals
    QCOMPARE(valueOf(run, "aggregated_time"), valueOf(run, "time_to_reach_goal"));
    QCOMPARE(valueOf(run, "completed"), 1.0);
  }
  /// It is sent elsewhere on its way, arrives there, and continues.
  void arrivalAtAnOrder_isNotTheEnd() {
    SampledRun run = runAlong({0, 1, 2, 3, 4, 5, 5, 5, 5.3, 5.3});
    run.eventsReportArrivals = true;
    sim2d::Event order = arrived();
    order.text = sim2d::kOrderText;
    run.events = {{3.0, order}};
    QCOMPARE(valueOf(run, "completed"), 0.0);
    QCOMPARE(valueOf(run, "path_length"), 5.3);
    QCOMPARE(valueOf(run, "aggregated_time"), 9.0);
    run.events = {{3.0, order}, {8.0, arrived()}};
    QCOMPARE(valueOf(run, "time_to_reach_goal"), 8.0);
    Selection selection;
    selection.window.until = "arrival";
    const auto made = evaluate(run, selection, {});
    QCOMPARE(*made->find("total_time")->value.value, 8.0);
  }
  void arrivalBeforeTheWindow_isOneAtItsBegin() {
    SampledRun run = runAlong(parkedAt(5, 10));
    run.eventsReportArrivals = true;
    run.events = {{5.0, arrived()}};
    Selection selection;
    selection.window.from = "time 8";
    const auto made = evaluate(run, selection, {});
    QCOMPARE(*made->find("completed")->value.value, 1.0);
    QCOMPARE(*made->find("time_to_reach_goal")->value.value, 0.0);
  }
  void robotWithoutGoal_doesNotFail() {
    MetricParameters parameters;
    parameters.timeLimit = 3.0;
    SampledRun run = runAlong(parkedAt(5, 0));
    run.goals.clear();
    QCOMPARE(valueOf(run, "path_length", parameters), 5.0);
  }
};

QTEST_APPLESS_MAIN(EndOfWayTest)
#include "tst_EndOfWay.moc"
