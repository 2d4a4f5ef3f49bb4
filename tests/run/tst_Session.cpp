#include <algorithm>
#include <thread>

#include <QtTest>

#include "app/run/Bundle.h"
#include "app/run/Session.h"

namespace {

/// One person who walks ten metres to the right, on the open plane.
base::Result<std::unique_ptr<sim2d::World>> makeWorld() {
  sim2d::Scenario scenario;
  sim2d::GlobalGoal goal;
  goal.key = {base::EntityKind::Goal, 9};
  goal.id = 1;
  goal.position = {10.0, 0.0};
  scenario.goals = {goal};
  sim2d::Human human;
  human.key = {base::EntityKind::Human, 1};
  human.id = 1;
  human.name = "anna";
  human.goals = {1};
  scenario.humans = {human};
  app::Bundle bundle;
  bundle.scenario = std::make_shared<const sim2d::Scenario>(std::move(scenario));
  bundle.map = std::make_shared<const sim2d::OccupancyGrid>();
  app::Verdict verdict = app::check(bundle);
  if (!verdict.world) {
    return verdict.problems;
  }
  return std::move(verdict.world);
}

/// What the plain loop records, to be equalled.
sim2d::Trace plainTrace(std::int64_t steps) {
  auto world = makeWorld();
  sim2d::Recording recording;
  sim2d::run(**world, {steps, false}, recording);
  return recording.trace((*world)->header());
}

/// The news up to a moment, put together.
void collect(app::Session& session, app::SessionUpdate& all) {
  app::SessionUpdate news = session.takeUpdate();
  all.remarks = news.remarks ? news.remarks : all.remarks;
  all.history = news.history ? news.history : all.history;
  all.newest = news.newest ? news.newest : all.newest;
  all.measuredSpeed = news.measuredSpeed ? news.measuredSpeed : all.measuredSpeed;
  all.result = news.result ? news.result : all.result;
  all.breakpointHit = news.breakpointHit ? news.breakpointHit : all.breakpointHit;
  all.entries = news.entries ? news.entries : all.entries;
}

}  // namespace

/// A run in one thread, and its orders from another.
class SessionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void run_withSinkAndHistory_bothEqualThePlainLoop() {
    const sim2d::Trace plain = plainTrace(100);
    auto world = makeWorld();
    QVERIFY(bool(world));
    app::Session session({100, false});
    session.enableHistory(1);
    sim2d::Recording sink;
    int seen = 0;
    const sim2d::RunResult result =
        session.run(**world, &sink, [&seen](const sim2d::Frame&) { ++seen; });
    QVERIFY(result.status == sim2d::RunStatus::Finished && result.reason == "duration");
    QCOMPARE(result.steps, std::int64_t{100});
    QCOMPARE(seen, 100);  // all but the last, which ends the run
    for (const sim2d::Trace& trace : {sink.trace((*world)->header()), session.history()->trace()}) {
      QVERIFY(sim2d::trajectoryCsv(trace) == sim2d::trajectoryCsv(plain));
      QVERIFY(sim2d::eventsCsv(trace) == sim2d::eventsCsv(plain));
      QVERIFY(sim2d::traceJson(trace.header) == sim2d::traceJson(plain.header));
    }
  }

  void stop_fromTheWatcher_interrupts() {
    auto world = makeWorld();
    app::Session session({100, false});
    sim2d::Recording sink;
    const sim2d::RunResult result =
        session.run(**world, &sink, [&session](const sim2d::Frame& frame) {
          if (frame.step == 7) {
            session.stop();
          }
        });
    QVERIFY(result.status == sim2d::RunStatus::Interrupted);
    QCOMPARE(result.steps, std::int64_t{7});
    QVERIFY(sink.events()[sink.events().size() - 1].second.text == "interrupted");
    QVERIFY(session.history() == nullptr);
  }

  void add_input_actsInTheNextStep() {
    auto world = makeWorld();
    app::Session session({10, false});
    session.enableHistory(1);
    session.run(**world, nullptr, [&session](const sim2d::Frame& frame) {
      if (frame.step == 3) {
        sim2d::Input input;
        input.kind = sim2d::InputKind::Move;
        input.id = 1;
        input.pose = {{50.0, 20.0}, 0.0};
        session.add(input);
      }
    });
    const app::RecordingPtr history = session.history();
    QCOMPARE(history->inputs().size(), std::size_t{1});
    QCOMPARE(history->inputs()[0].first, std::int64_t{4});
    QVERIFY(history->frame(3)->humans.x[0] < 2.0);
    QVERIFY(history->frame(4)->humans.x[0] > 40.0);
  }

  void orders_ofAnotherThread_pauseAndStep() {
    app::Session session({1000, false});
    session.enableHistory(1);
    session.setPaused(true);
    session.stepOnce();
    session.stepOnce();
    std::thread thread([&session] { session.run(makeWorld); });
    app::SessionUpdate news;
    QTRY_VERIFY_WITH_TIMEOUT((collect(session, news), news.newest && news.newest->step == 2),
                             20000);
    QVERIFY(news.remarks && !base::hasErrors(*news.remarks));
    QCOMPARE(news.history->size(), std::size_t{3});
    session.stop();
    thread.join();
    collect(session, news);
    QVERIFY(news.result && news.result->status == sim2d::RunStatus::Interrupted);
    QCOMPARE(news.result->steps, std::int64_t{2});
  }

  /// The run waits after the step in which a node begins to be as wanted, once, and goes on.
  void breakpoint_met_pausesAfterThatStep() {
    auto world = makeWorld();
    sim2d::Recording plain;
    sim2d::run(**makeWorld(), {40, false}, plain);
    const sim2d::TreeStatuses first = plain.treeAt(1, 1);
    const auto isTicked = [](base::NodeStatus each) { return each != base::NodeStatus::Idle; };
    const auto ticked = std::find_if(first.statuses.begin(), first.statuses.end(), isTicked);
    QVERIFY(ticked != first.statuses.end());
    const base::NodeStatus status = *ticked;
    const std::string& path =
        (*first.paths)[static_cast<std::size_t>(ticked - first.statuses.begin())];
    app::Session session({40, false});
    session.enableHistory(1);
    session.setBreakpoints({{1, path, status, "id == 1"},
                            {2, path, status, {}},
                            {1, path, status, "id == 2"},
                            {1, path, status, "nothing > 1"},
                            {1, path, status, "id := 3"}});
    session.watchBlackboard(1);
    std::thread thread([&] { session.run(**world); });
    app::SessionUpdate news;
    QTRY_VERIFY((collect(session, news), news.breakpointHit.has_value()));
    QCOMPARE(news.newest->step, std::int64_t{1});
    QCOMPARE(news.breakpointHit->person, 1);
    QCOMPARE(news.breakpointHit->at.path, path);
    QCOMPARE(news.breakpointHit->at.condition, std::string("id == 1"));
    QTRY_VERIFY((collect(session, news), news.entries.has_value()));
    const auto isId = [](const auto& entry) { return entry.first == "id" && entry.second == "1"; };
    QVERIFY(std::any_of(news.entries->begin(), news.entries->end(), isId));
    news.breakpointHit.reset();
    session.setPaused(false);
    QTRY_VERIFY((collect(session, news), news.result.has_value() ||
                                             news.breakpointHit.has_value() ||
                                             session.history()->size() == 41));
    thread.join();
    QVERIFY(!news.breakpointHit);
    QCOMPARE(session.history()->size(), std::size_t{41});
  }

  void setSpeed_asTheClock_isNeverAheadOfIt() {
    auto world = makeWorld();
    app::Session session({20, false});
    session.setSpeed(4.0);  // a second of the world: a quarter of one here
    QElapsedTimer timer;
    timer.start();
    const sim2d::RunResult result = session.run(**world);
    QVERIFY(timer.elapsed() >= 245);
    QCOMPARE(result.steps, std::int64_t{20});
  }

  void run_worldThatCannotBe_isTold() {
    app::Session session({20, false});
    session.run([]() -> base::Result<std::unique_ptr<sim2d::World>> {
      return base::error("run.failed", {"no place for Ana"});
    });
    const app::SessionUpdate news = session.takeUpdate();
    QVERIFY(news.remarks && base::hasErrors(*news.remarks));
    QVERIFY(!news.result);
  }
};

QTEST_GUILESS_MAIN(SessionTest)
#include "tst_Session.moc"
