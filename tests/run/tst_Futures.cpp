#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include <QtTest>

#include "app/run/Futures.h"
#include "app/run/Session.h"

namespace {

constexpr double kDt = 0.05;  // [s]

/// A robot that drives ten metres to the right and two people who walk towards it.
app::Bundle crossing() {
  sim2d::Scenario scenario;
  const auto goal = [&](int id, double x, double y) {
    sim2d::GlobalGoal& each = scenario.goals.emplace_back();
    each.key = {base::EntityKind::Goal, 10 + id};
    each.id = id;
    each.position = {x, y};
  };
  goal(1, 0.0, 0.2);
  goal(2, 0.0, -2.0);
  const auto person = [&](int id, const char* name, double y) {
    sim2d::Human& human = scenario.humans.emplace_back();
    human.key = {base::EntityKind::Human, id};
    human.id = id;
    human.name = name;
    human.initPose = {{10.0, y}, base::kPi};
    human.goals = {id};
  };
  person(1, "anna", 0.2);
  person(2, "ben", -2.0);
  sim2d::Robot& robot = scenario.robots.emplace_back();
  robot.key = {base::EntityKind::Robot, 20};
  robot.name = "robot1";
  robot.goal.point = sim2d::Vec2(10.0, 0.0);
  scenario.desktop.duration = 12.0;
  app::Bundle bundle;
  bundle.scenario = std::make_shared<const sim2d::Scenario>(std::move(scenario));
  bundle.map = std::make_shared<const sim2d::OccupancyGrid>();
  return bundle;
}

std::unique_ptr<sim2d::World> worldAt(const app::Bundle& bundle, std::int64_t step) {
  app::Verdict verdict = app::check(bundle);
  while (verdict.world != nullptr && verdict.world->stepIndex() < step) {
    verdict.world->step();
  }
  return std::move(verdict.world);
}

app::Future touching(int number, double time) {
  app::Future future;
  future.number = number;
  future.times = {0.0};
  if (time > 0.0) {
    future.contact = app::FutureContact{time, -1, 1, {0.0, 0.0}};
  }
  return future;
}

bool isClose(double a, double b) {
  return std::fabs(a - b) < 5e-4;
}

const auto kGoOn = [] { return false; };

}  // namespace

/// Ways in which a run may go on.
class FuturesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The interval by hand: p = 9/20, z = 1.959964, centre (p + z²/40)/(1 + z²/20).
  void contactChances_areSharesWithWilsonsInterval() {
    std::vector<app::Future> futures;
    for (int k = 0; k < 20; ++k) {
      futures.push_back(touching(k, k < 9 ? 5.0 + 0.5 * k : 0.0));
    }
    const auto chances = app::contactChances(futures, 4.0, 6.0, 0.5);
    QCOMPARE(chances.size(), std::size_t{13});
    QCOMPARE(chances[1].contacts, 0);  // 4.5 s
    QCOMPARE(chances[2].contacts, 1);  // 5.0 s
    QCOMPARE(chances[6].contacts, 5);  // 7.0 s
    QCOMPARE(chances.back().contacts, 9);
    QVERIFY(isClose(chances.back().chance, 0.45));
    QVERIFY(isClose(chances.back().interval.low, 0.2582));
    QVERIFY(isClose(chances.back().interval.high, 0.6579));
    QVERIFY(isClose(chances[0].interval.low, 0.0));
    QVERIFY(isClose(chances[0].interval.high, 0.1611));  // z²/(n + z²)
  }

  void decisiveMoment_isTheMedianOfContacts() {
    QVERIFY(!app::medianContactTime({touching(0, 0.0)}));
    QCOMPARE(*app::medianContactTime(
                 {touching(0, 7.0), touching(1, 0.0), touching(2, 5.0), touching(3, 6.0)}),
             6.0);
    QCOMPARE(*app::medianContactTime({touching(0, 7.0), touching(1, 5.0)}), 5.0);
  }

  void text_readBack_isEqual() {
    app::Future future = touching(3, 1.25);
    future.seed = 1LL << 40;
    future.times = {0.1, 0.30000000000000004};
    const double gone = std::numeric_limits<double>::quiet_NaN();
    future.ways[-1] = {{0.1, -0.7}, {1e-17, 3.0}};
    future.ways[4] = {{gone, gone}, {2.0, 1.0}};
    future.failure = "diverged: \"anna\"";
    const auto read = app::futureOf(app::futureText(future));
    QVERIFY(read.has_value());
    QCOMPARE(read->number, 3);
    QCOMPARE(read->seed, future.seed);
    QVERIFY(read->times == future.times);
    QVERIFY(read->ways.at(-1) == future.ways.at(-1));
    QVERIFY(std::isnan(read->ways.at(4)[0].x()));
    QVERIFY(read->ways.at(4)[1] == future.ways.at(4)[1]);
    QCOMPARE(read->contact->time, 1.25);
    QCOMPARE(read->contact->other, 1);
    QVERIFY(read->failure == future.failure);
    QVERIFY(!app::futureOf("{\"number\": 3"));
    QVERIFY(!app::futureOf("{}"));
  }

  /// Nothing is drawn in this scenario: without a spread all go on as the run does.
  void futures_withoutSpread_areTheRun() {
    const app::Bundle bundle = crossing();
    constexpr std::int64_t kAt = 40;
    std::vector<sim2d::Vec2> way;
    const auto plain = worldAt(bundle, kAt);
    while (plain->stepIndex() <= kAt + 100) {
      if ((plain->stepIndex() - kAt) % 4 == 0) {
        way.emplace_back(plain->frame().robots.x[0], plain->frame().robots.y[0]);
      }
      plain->step();
    }
    app::FuturesOptions options;
    options.count = 3;
    options.horizon = 100 * kDt;
    options.spread = 0.0;
    options.jobs = 2;
    std::vector<app::Future> futures;
    const auto world = worldAt(bundle, kAt);
    const auto onFuture = [&](const app::Future& future) { futures.push_back(future); };
    QVERIFY(app::simulateFutures(*world, bundle, options, onFuture, kGoOn).empty());
    QCOMPARE(futures.size(), std::size_t{3});
    QCOMPARE(world->stepIndex(), kAt);  // this process has not moved
    for (const app::Future& future : futures) {
      QVERIFY(future.failure.empty());
      QCOMPARE(future.times.size(), std::size_t{26});
      QVERIFY(std::fabs(future.times.front() - kAt * kDt) < 1e-9);
      QVERIFY(future.ways.at(-1) == way);
    }
  }

  /// Copies of the process make what one makes by itself; seeds make the difference.
  void futures_withSpread_differAndAreTheSameTwice() {
    const app::Bundle bundle = crossing();
    constexpr std::int64_t kAt = 40;
    app::FuturesOptions options;
    options.count = 8;
    options.horizon = 6.0;
    options.spread = 0.3;
    options.jobs = 3;
    std::vector<std::string> texts(8);
    const auto world = worldAt(bundle, kAt);
    QVERIFY(app::simulateFutures(
                *world, bundle, options,
                [&](const app::Future& future) {
                  texts[static_cast<std::size_t>(future.number)] = app::futureText(future);
                },
                kGoOn)
                .empty());
    for (int number = 0; number < 8; ++number) {
      const auto again = worldAt(bundle, kAt);
      QCOMPARE(texts[static_cast<std::size_t>(number)],
               app::futureText(app::simulateFuture(*again, bundle, options, number)));
    }
    std::sort(texts.begin(), texts.end());
    QVERIFY(std::unique(texts.begin(), texts.end()) == texts.end());
  }

  /// The contact of a future is the first that the same run, made by hand, tells.
  void contact_isTheFirstOfARobotWithAPerson() {
    const app::Bundle bundle = crossing();
    app::FuturesOptions options;
    options.horizon = 10.0;
    options.spread = 0.0;
    const auto plain = worldAt(bundle, 0);
    std::optional<double> first;
    while (!first && plain->time() < options.horizon - 1e-9) {
      plain->step();
      for (const sim2d::Event& event : plain->frame().events) {
        const bool isOfRobot = event.kind == sim2d::EventKind::Contact && event.hasOther &&
                               event.id < 0 && event.other > 0;
        first = isOfRobot ? std::optional(plain->time()) : first;
      }
    }
    const auto world = worldAt(bundle, 0);
    const app::Future future = app::simulateFuture(*world, bundle, options, 0);
    QCOMPARE(future.contact.has_value(), first.has_value());
    QVERIFY(!first || future.contact->time == *first);
  }

  /// Two people who do not heed each other, head-on: 10 m apart, with 1 m/s and a radius of 0.35 m
  /// each they meet after (10 - 0.7) / 2 s, later by the time that they take to set off.
  void contact_ofPeopleAlone_isTold() {
    app::Bundle bundle = crossing();
    auto scenario = std::make_shared<sim2d::Scenario>(*bundle.scenario);
    scenario->robots.clear();
    scenario->goals[0].position = {10.0, 0.0};
    scenario->goals[1].position = {0.0, 0.0};
    for (std::size_t k = 0; k < 2; ++k) {
      sim2d::Human& human = scenario->humans[k];
      human.initPose = {{k == 0 ? 0.0 : 10.0, 0.0}, k == 0 ? 0.0 : base::kPi};
      human.maxVel = 1.0;
      human.radius = 0.35;
      human.behavior.socialForceFactor = 0.0;
    }
    bundle.scenario = scenario;
    app::FuturesOptions options;
    options.horizon = 8.0;
    options.spread = 0.0;
    const auto world = worldAt(bundle, 0);
    QVERIFY(world != nullptr);
    const app::Future future = app::simulateFuture(*world, bundle, options, 0);
    QVERIFY(future.contact.has_value());
    QVERIFY2(future.contact->time > 4.65 && future.contact->time < 6.0,
             QByteArray::number(future.contact->time));
    QCOMPARE(future.contact->id + future.contact->other, 3);
    // They may step aside, but not by more than a body.
    QVERIFY2(std::fabs(future.contact->where.y()) < 0.35,
             QByteArray::number(future.contact->where.y()));
    QCOMPARE(*app::medianContactTime({future}), future.contact->time);
  }

  void question_throughBytes_isAnsweredAlike() {
    app::FuturesRequest request;
    request.bundle = crossing();
    app::RunBranch branch;
    branch.step = 20;
    branch.changes.set = {"robot1.max_vel=0.4"};
    branch.changes.stuckAfter = 3.5;
    request.branches = {branch};
    sim2d::Input push;
    push.kind = sim2d::InputKind::Push;
    push.id = 2;
    push.velocity = {0.1, 0.3};
    request.inputs = {{12, push}};
    request.at = 60;
    request.options.count = 2;
    request.options.horizon = 2.0;
    const auto answered = [](const app::FuturesRequest& asked) {
      std::map<int, std::string> texts;
      const base::Diagnostics problems = app::runFuturesRequest(
          asked, [&](const app::Future& future) { texts[future.number] = app::futureText(future); },
          kGoOn);
      return problems.empty() ? texts : std::map<int, std::string>();
    };
    const auto read = app::decodeFuturesRequest(app::encodeFuturesRequest(request));
    QVERIFY(bool(read));
    const auto texts = answered(request);
    QCOMPARE(texts.size(), std::size_t{2});
    QVERIFY(answered(*read) == texts);
    app::FuturesRequest nav2 = request;
    nav2.branches.front().changes.nav2Params = {"FollowPath.max_vel_x:=0.3"};
    const auto readNav2 = app::decodeFuturesRequest(app::encodeFuturesRequest(nav2));
    QVERIFY(bool(readNav2));
    QVERIFY(readNav2->branches.front().changes.nav2Params ==
            nav2.branches.front().changes.nav2Params);
    app::FuturesRequest slower = request;  // what it was made of counts
    slower.branches.clear();
    QVERIFY(answered(slower) != texts);
    app::FuturesRequest other = request;
    other.state = "60,3,1,human,0,0\n";
    QVERIFY(answered(other).empty());
    QVERIFY(!app::decodeFuturesRequest("no request"));
    QVERIFY(
        !app::decodeFuturesRequest(std::string(1000000, '\x81')));  // a list of one list of one …
  }

  void question_withOneWrongValue_isRefused_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("value");
    const auto row = [](const char* path, const char* value) {
      QTest::addRow("%s %s", path, value) << QString::fromUtf8(path) << QString::fromUtf8(value);
    };
    row("/map/width", "3");
    row("/map/height", "-2");
    row("/map/resolution", "0.0");
    row("/compat", "\"Q-99999\"");
    row("/at", "-1");
    row("/options/count", "1000000000");
    row("/options/jobs", "0");
    row("/options/sampleGap", "0.0");
    row("/options/horizon", "1e300");
    row("/options/spread", "-1.0");
    row("/branches", "3");
    row("/trees", "[3]");
  }
  void question_withOneWrongValue_isRefused() {
    QFETCH(QString, path);
    QFETCH(QString, value);
    app::FuturesRequest request;
    request.bundle = crossing();
    request.bundle.map = std::make_shared<const sim2d::OccupancyGrid>(
        2, 2, 0.5, base::Pose2(), std::vector<std::int8_t>(4, 0));
    const std::string bytes = app::encodeFuturesRequest(request);
    QVERIFY(bool(app::decodeFuturesRequest(bytes)));
    nlohmann::json json = nlohmann::json::from_cbor(bytes);
    json[nlohmann::json::json_pointer(path.toStdString())] =
        nlohmann::json::parse(value.toStdString());
    const std::vector<std::uint8_t> other = nlohmann::json::to_cbor(json);
    QVERIFY(!app::decodeFuturesRequest({other.begin(), other.end()}));
  }

  void futures_stopped_endAtOnce() {
    const app::Bundle bundle = crossing();
    app::FuturesOptions options;
    options.count = 1000;
    options.horizon = 600.0;
    int asked = 0, told = 0;
    const auto world = worldAt(bundle, 0);
    QElapsedTimer clock;
    clock.start();
    QVERIFY(app::simulateFutures(
                *world, bundle, options, [&](const app::Future&) { ++told; },
                [&] { return ++asked > 3; })
                .empty());
    QVERIFY(told < 1000);
    QVERIFY(clock.elapsed() < 20000);
  }

  void futures_ofForeignCode_areRefused() {
    app::Bundle bundle = crossing();
    const auto world = worldAt(bundle, 0);
    auto scenario = std::make_shared<sim2d::Scenario>(*bundle.scenario);
    scenario->robots[0].planner = "external";
    scenario->robots[0].command = "true";
    bundle.scenario = scenario;
    const base::Diagnostics problems = app::simulateFutures(
        *world, bundle, {}, [](const app::Future&) {}, kGoOn);
    QCOMPARE(problems.size(), std::size_t{1});
    QVERIFY(problems[0].code == "futures.foreign-code");
  }
};

QTEST_GUILESS_MAIN(FuturesTest)
#include "tst_Futures.moc"
