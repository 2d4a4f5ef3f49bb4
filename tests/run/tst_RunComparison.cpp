#include <cmath>

#include <QtTest>

#include "app/run/RunBranch.h"
#include "app/run/RunComparison.h"
#include "app/run/Session.h"

namespace {

/// A robot that drives ten metres past somebody.
app::Bundle passing() {
  sim2d::Scenario scenario;
  sim2d::GlobalGoal& goal = scenario.goals.emplace_back();
  goal.key = {base::EntityKind::Goal, 9};
  goal.id = 1;
  goal.position = {0.0, 1.5};
  sim2d::Human& human = scenario.humans.emplace_back();
  human.key = {base::EntityKind::Human, 1};
  human.id = 1;
  human.name = "anna";
  human.initPose = {{10.0, 1.5}, base::kPi};
  human.goals = {1};
  sim2d::Robot& robot = scenario.robots.emplace_back();
  robot.key = {base::EntityKind::Robot, 20};
  robot.name = "robot1";
  robot.goal.point = sim2d::Vec2(10.0, 0.0);
  scenario.desktop.duration = 6.0;
  app::Bundle bundle;
  bundle.scenario = std::make_shared<const sim2d::Scenario>(std::move(scenario));
  bundle.map = std::make_shared<const sim2d::OccupancyGrid>();
  return bundle;
}

std::shared_ptr<const sim2d::Recording> runOf(const std::vector<app::RunBranch>& branches) {
  app::BranchedRun run(passing(), branches);
  const auto world = std::move(run.verdict().world);
  app::Session session({120, false});
  session.enableHistory(1);
  session.setStepHook(
      [&](const sim2d::Frame& frame, sim2d::World& changing) { run.apply(frame, changing); });
  session.run(*world);
  return session.history();
}

app::RunBranch branchAt(std::int64_t step, const char* set) {
  app::RunBranch branch;
  branch.step = step;
  branch.changes.set = {set};
  return branch;
}

std::string rowsOf(const sim2d::Recording& recording, std::size_t from, std::size_t to) {
  std::string rows;
  for (std::size_t k = from; k <= to; ++k) {
    sim2d::appendTrajectoryRows(rows, *recording.frame(k));
  }
  return rows;
}

/// Somebody who goes along x, and a robot; states once a second.
std::shared_ptr<sim2d::Recording> walk(const std::vector<double>& x) {
  auto recording = std::make_shared<sim2d::Recording>();
  sim2d::TraceHeader header;
  header.dt = 1.0;
  sim2d::TraceHuman human;
  human.id = 1;
  header.humans = {human};
  recording->setHeader(header);
  for (std::size_t k = 0; k < x.size(); ++k) {
    sim2d::Frame frame;
    frame.step = static_cast<std::int64_t>(k);
    frame.time = static_cast<double>(k);
    frame.humans.add(1, {{x[k], 0.0}, 0.0}, {0.0, 0.0}, 0.0, sim2d::kNoGoal);
    frame.humans.group = {-1};
    frame.humans.state = {0};
    recording->addState(frame);
  }
  return recording;
}

metrics::MetricResult resultOf(const char* key, std::optional<double> value) {
  metrics::MetricResult result;
  result.info.key = key;
  result.value.value = value;
  return result;
}

}  // namespace

/// Runs that go on another way, and what they differ by.
class RunComparisonTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void stages_none_isTheRun() {
    const auto plain = runOf({});
    const auto same = runOf({branchAt(40, "robot1.max_vel=1.0")});  // as it is
    QCOMPARE(rowsOf(*plain, 0, 120), rowsOf(*same, 0, 120));
    QVERIFY(!app::divergenceTime(*plain, *same));
  }

  /// Up to the step it is the run; then the robot is slower, and never faster than it may be.
  void stage_fromItsStepOn_counts() {
    const auto plain = runOf({});
    const auto slow = runOf({branchAt(40, "robot1.max_vel=0.3")});
    QCOMPARE(rowsOf(*plain, 0, 40), rowsOf(*slow, 0, 40));
    QVERIFY(rowsOf(*plain, 41, 60) != rowsOf(*slow, 41, 60));
    const auto speed = [](const sim2d::Recording& recording, std::size_t index) {
      const sim2d::RobotColumns& robots = recording.frame(index)->robots;
      return std::hypot(robots.vx[0], robots.vy[0]);
    };
    QVERIFY(speed(*plain, 100) > 0.5);
    QVERIFY(speed(*slow, 100) < 0.3 + 1e-6);
    const auto parting = app::divergenceTime(*plain, *slow);
    QVERIFY(parting && *parting > 2.0 && *parting < 2.3);
  }

  void continueWith_fixedValue_isRefused() {
    QVERIFY(bool(app::continueWith(passing(), {branchAt(0, "robot1.planner=dwa")})));
    QVERIFY(!app::continueWith(passing(), {branchAt(0, "robot1.radius=0.9")}));
    QVERIFY(!app::continueWith(passing(), {branchAt(0, "seed=")}));
    QVERIFY(!app::continueWith(passing(), {branchAt(0, "nobody.planner=dwa")}));
  }

  void moves_ofPeople_areInputs() {
    const auto header = *walk({0.0})->header();
    sim2d::TraceHeader named = header;
    named.humans[0].name = "anna";
    const auto inputs = app::inputsOfMoves({"anna 2.5 1 0.5"}, named);
    QVERIFY(bool(inputs));
    QCOMPARE(inputs->size(), std::size_t{1});
    QCOMPARE(inputs->front().id, 1);
    QVERIFY(inputs->front().pose.position == base::Vec2(2.5, 1.0));
    const auto wrong = app::inputsOfMoves({"ben 1 2 0", "anna 1"}, named);
    QCOMPARE(wrong.diagnostics().size(), std::size_t{2});
  }

  void changes_inWords() {
    app::RunSpec options;
    QVERIFY(app::changesText(options).empty());
    options.set = {"robot1.planner=dwa", "robot1.max_vel=0.8"};
    options.seed = 7;
    options.moves = {"anna 1 2 0"};
    QCOMPARE(QString::fromStdString(app::changesText(options)),
             QStringLiteral("robot1.planner = dwa, robot1.max_vel = 0.8, seed 7, anna moved"));
  }

  void partingTime_isTheFirstDifference() {
    QVERIFY(!app::divergenceTime(*walk({0, 1, 2}), *walk({0, 1, 2, 9})));  // as long as both go on
    QCOMPARE(*app::divergenceTime(*walk({0, 1, 2, 3}), *walk({0, 1, 2.01, 3})), 2.0);
    QVERIFY(!app::divergenceTime(*walk({0, 1, 2}), *walk({0, 1, 2.01}), 0.02));
    auto alone = walk({0, 1});
    sim2d::Frame empty;
    empty.step = 2;
    empty.time = 2.0;
    alone->addState(empty);
    QCOMPARE(*app::divergenceTime(*walk({0, 1, 2}), *alone), 2.0);
  }

  void measures_differByWhatTheOtherHasMore() {
    app::RecordingMetrics first, second;
    first.results = {resultOf("a", 1.5), resultOf("b", std::nullopt)};
    second.results = {resultOf("a", 1.25), resultOf("b", 2.0), resultOf("c", 3.0)};
    const auto rows = app::compareRecordingMetrics({first, second});
    QCOMPARE(rows.size(), std::size_t{3});
    QCOMPARE(*rows[0].difference(1), -0.25);
    QVERIFY(!rows[1].difference(1) && !rows[2].difference(1));
    QCOMPARE(*rows[2].values[1], 3.0);
  }

  /// Of the robot: ten metres of way at most, and the course ends at the value.
  void measureRun_ofARobot_measuresItsWay() {
    const auto run = runOf({});
    const auto setup = app::metricsSetupOf(*passing().scenario, "");
    const app::RecordingMetrics measures =
        app::measureRun(*run, *setup, std::make_shared<base::StopFlag>());
    QVERIFY(!measures.isCut);
    const metrics::MetricResult* length = metrics::findResult(measures.results, "path_length");
    QVERIFY(length != nullptr && length->value.value);
    double way = 0.0;
    for (std::size_t k = 1; k < run->size(); ++k) {
      const auto& before = run->frame(k - 1)->robots;
      const auto& now = run->frame(k)->robots;
      way += std::hypot(now.x[0] - before.x[0], now.y[0] - before.y[0]);
    }
    QVERIFY(way > 2.0 && std::fabs(*length->value.value - way) < 1e-6);
    const app::MetricTimeSeries& course = measures.curves.at("path_length");
    QVERIFY(course.times.size() > 10);
    for (std::size_t k = 1; k < course.values.size(); ++k) {
      QVERIFY(course.values[k] >= course.values[k - 1]);
    }
  }

  /// Within one step two runs are equally long.
  void commonEnd_isThatOfTheShortestRun() {
    const auto one = walk({0, 1, 2, 3, 4, 5}), other = walk({0, 1, 2});
    QVERIFY(!app::commonEnd({one.get(), one.get()}));
    QCOMPARE(*app::commonEnd({one.get(), other.get()}), 2.0);
    QCOMPARE(*app::commonEnd({other.get(), one.get(), one.get()}), 2.0);
  }

  void measureRun_upToATime_measuresThatPart() {
    const auto run = runOf({});
    const auto setup = app::metricsSetupOf(*passing().scenario, "");
    const app::RecordingMetrics part =
        app::measureRun(*run, *setup, std::make_shared<base::StopFlag>(), 2.0);
    double way = 0.0;
    for (std::size_t k = 1; k < run->size() && run->timeOf(k) < 2.0 + 1e-6; ++k) {
      const auto& before = run->frame(k - 1)->robots;
      const auto& now = run->frame(k)->robots;
      way += std::hypot(now.x[0] - before.x[0], now.y[0] - before.y[0]);
    }
    const metrics::MetricResult* length = metrics::findResult(part.results, "path_length");
    QVERIFY(way > 0.3 && length != nullptr);
    QVERIFY(std::fabs(*length->value.value - way) < 1e-6);
  }

  /// What a run comes to is not known before its end.
  void measures_upToTheCommonEnd_keepOutcomesOfWholeRuns() {
    app::RecordingMetrics whole, part;
    whole.results = {resultOf("path_length", 9.0), resultOf("success", 1.0)};
    part.results = {resultOf("path_length", 4.0), resultOf("success", 0.0)};
    const auto rows = app::compareRecordingMetrics({whole, whole}, {part, part});
    QCOMPARE(*rows[0].values[1], 4.0);
    QVERIFY(!rows[0].isWholeRun);
    QCOMPARE(*rows[1].values[1], 1.0);
    QVERIFY(rows[1].isWholeRun);
  }
};

QTEST_GUILESS_MAIN(RunComparisonTest)
#include "tst_RunComparison.moc"
