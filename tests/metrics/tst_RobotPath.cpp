#include <QtTest>

#include "HandMade.h"
#include "metrics/RunResults.h"
#include "sim2d/trace/Frame.h"

using namespace metrics;
using namespace handmade;

namespace {

sim2d::Event arrivedOf(int id) {
  return eventOf(EventKind::Arrived, id);
}

/// At 1 m/s along x from 0 to `end` m, then standing, a sample every `step` seconds; the goal is at
/// 5 m, its radius 0.2 m, somebody stands far away.
SampledRun driveTo(double end, double step, double duration) {
  std::vector<Sample> samples;
  const int last = static_cast<int>(duration / step + 1e-9);
  for (int k = 0; k <= last; ++k) {
    const double t = k * step;
    samples.push_back(sampleAt(t, std::min(t, end), 0.0, t < end ? 1.0 : 0.0));
    samples.back().people = {personAt(1, 20.0, 20.0)};
  }
  SampledRun run = recordingOfSamples(std::move(samples));
  run.goals = {{1, Vec2(5.0, 0.0), 0.2}};
  return run;
}

SampledRun arriving(double step, double duration) {
  SampledRun run = driveTo(5.0, step, duration);
  run.events = {{4.8, arrivedOf(-1)}};  // at the border of the goal
  return run;
}

double valueIn(const SampledRun& run, const char* from, const char* until, const char* key,
               double frequency = 0.0) {
  Selection selection;
  selection.behaviors = false;
  selection.window = {from, until, frequency};
  const base::Result<Evaluation> made = evaluate(run, selection, {});
  return made ? made->find(key)->value.value.value_or(std::nan("")) : std::nan("");
}

sim2d::TraceObstacle solid(const std::vector<Vec2>& corners) {
  sim2d::TraceObstacle obstacle;
  obstacle.name = "block";
  obstacle.outlines.emplace_back();
  obstacle.outlines[0].points = corners;
  return obstacle;
}

/// Robots -1 and -2 at these places of each second; where there is one alone, it is -1.
sim2d::Trace driven(const std::vector<std::vector<Vec2>>& places) {
  sim2d::Trace trace;
  trace.header.dt = 1.0;
  for (std::size_t k = 0; k < places[0].size(); ++k) {
    sim2d::Frame frame;
    frame.step = static_cast<std::int64_t>(k);
    frame.time = static_cast<double>(k);
    for (std::size_t robot = 0; robot < places.size(); ++robot) {
      frame.robots.add(-1 - static_cast<int>(robot), {places[robot][k], 0.0}, Vec2::Zero(), 0.0, 0);
    }
    trace.frames.push_back(frame);
  }
  for (std::size_t robot = 0; robot < places.size(); ++robot) {
    sim2d::TraceRobot each;
    each.id = -1 - static_cast<int>(robot);
    each.radius = 0.1;
    each.goals = {{1, places[robot].back(), 0.2}};
    trace.header.robots.push_back(each);
  }
  return trace;
}

QString contactsIn(const sim2d::Trace& trace, const Selection& selection,
                   const MetricParameters& parameters) {
  QString words;
  for (const RobotContact& contact : robotContacts(trace, selection, parameters)) {
    words += QStringLiteral("%1 s at %2: ").arg(contact.time).arg(contact.place.x()) +
             (contact.person ? QString::number(*contact.person) : QStringLiteral("block")) +
             QStringLiteral("; ");
  }
  return words;
}

/// Robot -1 stands; -2 sets off at 2 s, reaches (5, y) at 7 s and is parked there until 12 s.
sim2d::Trace parkedSecond(double y) {
  std::vector<Vec2> way;
  for (int t = 0; t <= 12; ++t) {
    way.emplace_back(std::clamp(t - 2.0, 0.0, 5.0), y);
  }
  sim2d::Trace trace = driven({std::vector<Vec2>(13, Vec2(9.0, 9.0)), way});
  trace.header.robots[1].startTime = 2.0;
  trace.events = {{7, arrivedOf(-2)}};
  return trace;
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

class RobotPathTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // From where to where the robot is measured, and beside which way; expected values by hand.

  /// Samples at 4 s and 6 s: the second is at the goal and ends the way.
  void arrival_betweenSamples_endsWithTheSecond() {
    for (const double duration : {6.0, 20.0}) {
      const SampledRun run = arriving(2.0, duration);
      QCOMPARE(valueOf(run, "completed"), 1.0);
      QCOMPARE(valueOf(run, "success"), 1.0);
      QCOMPARE(valueOf(run, "spl"), 1.0);
      QCOMPARE(valueOf(run, "path_length"), 5.0);
      QCOMPARE(valueOf(run, "time_to_reach_goal"), 4.8);
      QCOMPARE(valueOf(run, "stl"), 1.0);  // the event has the time, not the sample
    }
  }
  void arrival_betweenSamplesOfTheFrequency_endsWithTheSecond() {
    const SampledRun run = arriving(1.0, 20.0);
    QCOMPARE(valueIn(run, "begin", "end", "path_length", 0.5), 5.0);
    QCOMPARE(valueIn(run, "begin", "end", "completed", 0.5), 1.0);
    QCOMPARE(valueIn(run, "begin", "end", "time_to_reach_goal", 0.5), 4.8);
    QCOMPARE(valueIn(run, "begin", "end", "stl", 0.5), 1.0);
  }
  void untilArrival_betweenSamples_endsWithTheSecond() {
    const SampledRun run = arriving(2.0, 20.0);
    QCOMPARE(valueIn(run, "begin", "arrival", "total_time"), 6.0);
    QCOMPARE(valueIn(run, "begin", "arrival", "completed"), 1.0);
    QCOMPARE(valueIn(arriving(1.0, 20.0), "begin", "arrival", "total_time", 0.5), 6.0);
  }
  /// It sets off at 1 s; what it drove until the sample at 2 s is not seen.
  void settingOff_betweenSamples_beginsWithTheSecond() {
    SampledRun run = driveTo(5.0, 2.0, 10.0);
    for (Sample& sample : run.samples) {
      sample.robot.position.x() = std::clamp(sample.time - 1.0, 0.0, 5.0);
    }
    run.robotStartTime = 1.0;
    run.events = {{6.0, arrivedOf(-1)}};
    QCOMPARE(valueOf(run, "path_length"), 4.0);
    QVERIFY(isNear(valueOf(run, "stl"), 1.0));  // 4 m in 4 s at 1 m/s
  }

  void window_aroundTheArrival_rules() {
    const SampledRun run = arriving(1.0, 20.0);
    // Begins after the arrival: the parked robot.
    QCOMPARE(valueIn(run, "time 10", "end", "path_length"), 0.0);
    QCOMPARE(valueIn(run, "time 10", "end", "avg_robot_linear_speed"), 0.0);
    QCOMPARE(valueIn(run, "time 10", "end", "completed"), 1.0);
    // 18 samples from 3 s on, two of them at 1 m/s; the same until 20 s.
    QVERIFY(isNear(valueIn(run, "time 3", "end", "avg_robot_linear_speed"), 2.0 / 18.0));
    QVERIFY(isNear(valueIn(run, "time 3", "time 20", "avg_robot_linear_speed"), 2.0 / 18.0));
    // Ends before it.
    QCOMPARE(valueIn(run, "begin", "time 4", "path_length"), 4.0);
    QCOMPARE(valueIn(run, "begin", "time 4", "completed"), 0.0);
  }

  /// It stays 2 m before the goal for good.
  void robot_thatNeverArrives_hasFailed() {
    const SampledRun run = driveTo(3.0, 1.0, 20.0);
    for (const char* key : {"completed", "success", "spl", "stl"}) {
      QVERIFY2(valueOf(run, key) == 0.0, key);
    }
    QCOMPARE(valueOf(run, "path_length"), 3.0);
    QVERIFY(isNear(valueOf(run, "avg_robot_linear_speed"), 3.0 / 21.0));
    QVERIFY(std::isnan(valueOf(run, "time_to_reach_goal")));
    QCOMPARE(valueOf(run, "final_distance_to_target"), 2.0);
  }

  /// A block with a notch on its far side: only the near side, 1 m away, faces robot and person.
  void obstacleForces_ofCornersThatFaceAway_areNone() {
    sim2d::Trace trace = driven({{Vec2(0, 0), Vec2(0, 0)}});
    trace.header.obstacles = {
        solid({Vec2(1, -1), Vec2(3, -1), Vec2(2, 0), Vec2(3, 1), Vec2(1, 1)})};
    sim2d::TraceHuman human;
    human.id = 1;
    human.radius = 0.3;
    trace.header.humans = {human};
    for (sim2d::Frame& frame : trace.frames) {
      frame.humans.add(1, {Vec2(0, 0), 0.0}, Vec2::Zero(), 0.0, 0);
      frame.humans.group.push_back(-1);
      frame.humans.state.push_back(0);
    }
    MetricParameters parameters;
    parameters.obstacleFactor = 10.0;
    parameters.obstacleSigma = 0.2;
    const SampledRun run = sampledRunOf(trace);  // of two samples
    const double onRobot = 20.0 * std::exp(-(1.0 - 0.1) / 0.2);
    const double onPerson = 20.0 * std::exp(-(1.0 - 0.3) / 0.2);
    QVERIFY(isNear(valueOf(run, "obstacle_force_on_robot", parameters), onRobot));
    QVERIFY(isNear(valueOf(run, "obstacle_force_on_agents", parameters), onPerson));
  }

  /// From one side of a wall to the other, 3 m up and down: over its two corners with 0.1 m of
  /// room.
  void shortestWay_roundACorner_isThatOfSplAndStl() {
    sim2d::Trace trace = driven({{Vec2(0, 0), Vec2(0, 4), Vec2(4, 4), Vec2(4, 0)}});
    trace.header.obstacles = {solid({Vec2(1.9, -20), Vec2(2.1, -20), Vec2(2.1, 3), Vec2(1.9, 3)})};
    const SampledRun run = sampledRunOf(trace);
    // A tangent to the circle round the corner, its arc, 0.2 m straight on, and the same down.
    const double toCorner = std::hypot(1.9, 3.0);
    const double tangent = std::sqrt(toCorner * toCorner - 0.01);
    const double rise = std::atan2(3.0, 1.9) + std::asin(0.1 / toCorner);
    const double shortest = 2.0 * tangent + 2.0 * 0.1 * rise + 0.2;
    const auto isAbout = [](double value, double expected) {
      return std::fabs(value - expected) < 2e-3;
    };
    QVERIFY(isAbout(valueOf(run, "spl"), shortest / 12.0));
    QVERIFY(isAbout(valueOf(run, "path_efficiency"), shortest / 12.0));
    SampledRun slow = run;
    for (Sample& sample : slow.samples) {
      sample.time *= 10.0;  // 30 s at up to 1 m/s
    }
    QVERIFY(isAbout(valueOf(slow, "stl"), shortest / 30.0));
  }

  void reference_ofAParkedRun_isItsWay() {
    Selection selection;
    selection.robotId = -2;
    const TimedPath way = robotPathOf(parkedSecond(0.0), selection, {});
    QCOMPARE(way.size(), std::size_t{6});  // from 2 s to 7 s
    QVERIFY(way.front() == std::make_pair(0.0, Vec2(0.0, 0.0)));
    QVERIFY(way.back() == std::make_pair(5.0, Vec2(5.0, 0.0)));
    selection.reference = way;
    for (const char* key : {"ade", "fde", "dtw", "path_deviation"}) {
      const auto itself = evaluate(parkedSecond(0.0), selection, {});
      QCOMPARE(*itself->find(key)->value.value, 0.0);
      const auto beside = evaluate(parkedSecond(1.0), selection, {});  // 1 m aside all the time
      QVERIFY2(isNear(*beside->find(key)->value.value, 1.0), key);
    }
    MetricParameters original;
    original.profile = Profile::Hunav2;
    QCOMPARE(robotPathOf(parkedSecond(0.0), selection, original).size(), std::size_t{13});
    selection.window.from = "time 1";
    QCOMPARE(robotPathOf(parkedSecond(0.0), selection, {}).size(), std::size_t{12});
    selection.robotId = -7;  // the first robot instead
    QVERIFY(robotPathOf(parkedSecond(0.0), selection, {}).back().second == Vec2(9.0, 9.0));
  }

  /// Metres and seconds are the same: it passes four people, whose borders it comes to within 1, 1,
  /// 1 and 3 cm (the limit is 2), and grazes a block.
  void contacts_ofARun_areWhereTheyBegin() {
    std::vector<Vec2> way;
    way.reserve(10);
    for (int k = 0; k < 10; ++k) {
      way.emplace_back(k, 0.0);
    }
    sim2d::Trace trace = driven({way});
    trace.header.obstacles = {solid({{3.8, -0.05}, {3.8, -2.0}, {4.2, -2.0}, {4.2, -0.05}})};
    const Vec2 people[] = {{2.0, 0.46}, {6.0, 0.46}, {6.0, -0.46}, {8.0, 0.48}};
    for (int k = 0; k < 4; ++k) {
      sim2d::TraceHuman human;
      human.id = k + 1;
      human.radius = 0.35;
      trace.header.humans.push_back(human);
      for (sim2d::Frame& frame : trace.frames) {
        frame.humans.add(human.id, {people[k], 0.0}, Vec2::Zero(), 0.0, 0);
        frame.humans.group.push_back(-1);
        frame.humans.state.push_back(0);
      }
    }
    QCOMPARE(contactsIn(trace, {}, {}),
             QStringLiteral("2 s at 2: 1; 4 s at 4: block; 6 s at 6: 2; 6 s at 6: 3; "));
    MetricParameters wide;
    wide.contactDistance = 0.04;
    QCOMPARE(contactsIn(trace, {}, wide),
             contactsIn(trace, {}, {}) + QStringLiteral("8 s at 8: 4; "));
    Selection late;
    late.window.from = "time 5";
    QCOMPARE(contactsIn(trace, late, {}), QStringLiteral("6 s at 6: 2; 6 s at 6: 3; "));
    late.window.from = "whenever";
    QCOMPARE(contactsIn(trace, late, {}), QString());
  }

  // Where a way ends that no event ends; expected values by hand.

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
    run.events = {{7.0, arrivedOf(-1)}};
    QCOMPARE(valueOf(run, "path_length"), 5.0);
    QVERIFY(isNear(valueOf(run, "stl"), 5.4 / 7.0));
    run.events = {{9.0, arrivedOf(-1)}};
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
    run.events = {{7.0, arrivedOf(-1)}};
    QVERIFY(isNear(valueOf(run, "stl", parameters), 5.4 / 7.0));
  }
  /// All results use the same arrival: the robot is in the region at 5 s, at its goal at 7 s.
  void everyKey_hasTheArrivalOfTheEvent() {
    SampledRun run = runAlong({0, 1, 2, 3, 4, 5, 5.1, 5.3, 5.3, 5.3});
    run.eventsReportArrivals = true;
    run.events = {{7.0, arrivedOf(-1)}};
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
    sim2d::Event order = arrivedOf(-1);
    order.text = sim2d::kOrderText;
    run.events = {{3.0, order}};
    QCOMPARE(valueOf(run, "completed"), 0.0);
    QCOMPARE(valueOf(run, "path_length"), 5.3);
    QCOMPARE(valueOf(run, "aggregated_time"), 9.0);
    run.events = {{3.0, order}, {8.0, arrivedOf(-1)}};
    QCOMPARE(valueOf(run, "time_to_reach_goal"), 8.0);
    Selection selection;
    selection.window.until = "arrival";
    const auto made = evaluate(run, selection, {});
    QCOMPARE(*made->find("total_time")->value.value, 8.0);
  }
  void arrivalBeforeTheWindow_isOneAtItsBegin() {
    SampledRun run = runAlong(parkedAt(5, 10));
    run.eventsReportArrivals = true;
    run.events = {{5.0, arrivedOf(-1)}};
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

QTEST_APPLESS_MAIN(RobotPathTest)
#include "tst_RobotPath.moc"
