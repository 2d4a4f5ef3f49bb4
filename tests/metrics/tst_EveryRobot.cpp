#include <QtTest>

#include "MetricCases.h"
#include "metrics/IncrementalEvaluation.h"
#include "metrics/Report.h"

using namespace metrics;

namespace {

sim2d::Event eventOf(sim2d::EventKind kind, int id) {
  sim2d::Event event;
  event.kind = kind;
  event.id = id;
  return event;
}

/// The people, walls and robot of MetricCases and a second robot, which sets off later, drives the
/// other way, is larger and arrives earlier.
sim2d::Trace pairTrace() {
  sim2d::Trace trace = cases::trace(160, 4);
  for (sim2d::Frame& frame : trace.frames) {
    const double t = std::clamp(frame.time - 1.0, 0.0, 5.0);
    const double speed = frame.time > 1.0 && frame.time < 6.0 ? 0.7 : 0.0;
    frame.robots.add(-2, {base::Vec2(4.0 - 0.7 * t, 0.4), base::kPi}, base::Vec2(-speed, 0.0), 0.0,
                     sim2d::kNoGoal);
  }
  sim2d::TraceRobot second = trace.header.robots[0];
  second.id = -2;
  second.name = "robot2";
  second.radius = 0.45;
  second.startTime = 1.0;
  second.maxVel = 0.7;
  second.goals = {{0, base::Vec2(0.5, 0.4), 0.2}};
  trace.header.robots.push_back(second);
  trace.events = {{60, eventOf(sim2d::EventKind::Replan, -2)},
                  {118, eventOf(sim2d::EventKind::Arrived, -2)},
                  {130, eventOf(sim2d::EventKind::Replan, -1)},
                  {132, eventOf(sim2d::EventKind::Arrived, -1)}};
  return trace;
}

/// The robots in the other order: -1 is -2 and the other way round.
sim2d::Trace swapped(sim2d::Trace trace) {
  const auto other = [](int id) { return id < 0 ? -3 - id : id; };
  std::swap(trace.header.robots[0], trace.header.robots[1]);
  for (sim2d::TraceRobot& robot : trace.header.robots) {
    robot.id = other(robot.id);
  }
  for (auto& [step, event] : trace.events) {
    event.id = other(event.id);
  }
  for (sim2d::Frame& frame : trace.frames) {
    sim2d::forEachColumn(frame.robots, [](auto& column) { std::swap(column[0], column[1]); });
    frame.robots.id = {-1, -2};
  }
  return trace;
}

Selection everyRobot() {
  Selection selection;
  selection.everyRobot = true;
  return selection;
}

/// Everything that is written of one robot.
std::string textOf(const Evaluation& evaluation) {
  Evaluation alone = evaluation;
  alone.others.clear();
  alone.robotId = -1;
  return toJson(alone) + metricsCsv(alone) + stepsCsv(alone);
}

sim2d::Trace without(sim2d::Trace trace, int robot) {
  const std::size_t row = static_cast<std::size_t>(-1 - robot);
  trace.header.robots.erase(trace.header.robots.begin() + static_cast<std::ptrdiff_t>(row));
  for (sim2d::Frame& frame : trace.frames) {
    sim2d::forEachColumn(frame.robots, [row](auto& column) {
      column.erase(column.begin() + static_cast<std::ptrdiff_t>(row));
    });
  }
  return trace;
}

}  // namespace

/// Metrics of every robot of a record.
class EveryRobotTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void others_areThoseOfTheOtherOrder_data() {
    QTest::addColumn<int>("profile");
    QTest::newRow("corrected") << static_cast<int>(Profile::Corrected);
    QTest::newRow("hunav2") << static_cast<int>(Profile::Hunav2);
  }
  void others_areThoseOfTheOtherOrder() {
    QFETCH(int, profile);
    const MetricParameters parameters = cases::parametersOf(static_cast<Profile>(profile));
    const auto one = evaluate(pairTrace(), everyRobot(), parameters);
    const auto two = evaluate(swapped(pairTrace()), everyRobot(), parameters);
    QVERIFY(one && two);
    QCOMPARE(one->others.size(), std::size_t{1});
    QCOMPARE(two->others.size(), std::size_t{1});
    QCOMPARE(textOf(*one), textOf(two->others[0]));
    QCOMPARE(textOf(one->others[0]), textOf(*two));
    QVERIFY(textOf(*one) != textOf(*two));
    QVERIFY(one->others[0].robot == "robot2" && two->others[0].robot == "robot1");
  }

  /// It sets off at 1 s and arrives at 5.9 s, at 0.7 m/s.
  void others_haveTheirOwnWay() {
    const auto both = evaluate(pairTrace(), everyRobot(), {});
    const Evaluation& second = both->others[0];
    QVERIFY(std::fabs(*second.find("path_length")->value.value - 0.7 * 4.9) < 1e-9);
    QCOMPARE(*second.find("replanning_count")->value.value, 1.0);
    QCOMPARE(second.times.size(), both->times.size());
    QVERIFY(both->find("path_length")->value.value != second.find("path_length")->value.value);
  }

  void first_isTheSameWithoutTheOthers() {
    const auto both = evaluate(pairTrace(), everyRobot(), {});
    const auto alone = evaluate(pairTrace(), Selection{}, {});
    QCOMPARE(textOf(*both), textOf(*alone));
    QVERIFY(alone->others.empty());
    const auto only = evaluate(without(pairTrace(), -2), everyRobot(), {});
    QCOMPARE(textOf(*both), textOf(*only));
    QVERIFY(only->others.empty());
  }

  /// It never moves, so a window that begins with its motion holds nothing.
  void other_withoutAWindow_isUndefined() {
    sim2d::Trace trace = pairTrace();
    for (sim2d::Frame& frame : trace.frames) {
      frame.robots.vx[1] = 0.0;
    }
    Selection selection = everyRobot();
    selection.window.from = "motion";
    const auto both = evaluate(trace, selection, {});
    QVERIFY(both);
    QVERIFY(both->find("path_length")->value.value);
    QCOMPARE(both->others[0].results.size(), both->results.size());
    for (const MetricResult& result : both->others[0].results) {
      QVERIFY2(!result.value.value && !result.value.why.empty(), result.info.key.c_str());
    }
  }

  void names_canBeThoseOfFiles() {
    sim2d::Trace trace = pairTrace();
    trace.header.robots[0].name = "../a b";
    trace.header.robots[1].name = "../a/b";
    const auto both = evaluate(trace, everyRobot(), {});
    QCOMPARE(both->robot, std::string("___a_b"));
    QCOMPARE(both->others[0].robot, std::string("___a_b_"));
  }

  void table_hasAColumnForEach() {
    const auto both = evaluate(pairTrace(), everyRobot(), {});
    const QStringList lines = QString::fromStdString(tableText(*both)).split(QLatin1Char('\n'));
    QCOMPARE(lines[0].simplified(), QStringLiteral("metric robot1 robot2 unit"));
    const QStringList length = lines.filter(QRegularExpression(QStringLiteral("^path_length ")))
                                   .front()
                                   .simplified()
                                   .split(QLatin1Char(' '));
    QCOMPARE(length.size(), 4);
    QVERIFY(std::fabs(length[2].toDouble() - 3.43) < 1e-9);
    QVERIFY(length[1].toDouble() > 3.43);
    const auto alone = evaluate(pairTrace(), Selection{}, {});
    QVERIFY(QString::fromStdString(tableText(*alone))
                .simplified()
                .startsWith(QStringLiteral("metric value unit")));
  }

  /// What others do after its arrival does not count against a robot: somebody runs into it where
  /// it is parked, another one walks round it. No metric of the robot tells.
  void afterArrival_nothingCounts() {
    sim2d::Trace calm = pairTrace();
    for (sim2d::Frame& frame : calm.frames) {  // parked from the arrival on
      if (frame.step > 132) {
        const sim2d::RobotColumns& parked = calm.frames[132].robots;
        frame.robots.x[0] = parked.x[0];
        frame.robots.y[0] = parked.y[0];
        frame.robots.vx[0] = frame.robots.vy[0] = frame.robots.omega[0] = 0.0;
      }
    }
    sim2d::Trace crowded = calm;
    for (sim2d::Frame& frame : crowded.frames) {
      if (frame.step > 132) {
        frame.humans.x[0] = frame.robots.x[0] + 0.2;
        frame.humans.y[0] = frame.robots.y[0];
        frame.humans.x[1] = frame.robots.x[0] - 0.5;
        frame.humans.y[1] = frame.robots.y[0] + 0.4;
      }
    }
    Selection selection;
    selection.behaviors = false;
    const auto before = evaluate(calm, selection, {});
    const auto after = evaluate(crowded, selection, {});
    for (std::size_t k = 0; k < before->results.size(); ++k) {
      const MetricResult& result = before->results[k];
      if (result.info.needs.robot) {
        QVERIFY2(result.value.value == after->results[k].value.value, result.info.key.c_str());
      }
    }
    // It does see them where they come before the arrival.
    crowded.events.back().first = 160;
    const auto late = evaluate(crowded, selection, {});
    QVERIFY(*late->find("intimate_zone_entries")->value.value >
            *after->find("intimate_zone_entries")->value.value);
  }
};

QTEST_APPLESS_MAIN(EveryRobotTest)
#include "tst_EveryRobot.moc"
