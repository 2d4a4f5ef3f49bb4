#include <QTemporaryDir>
#include <QtTest>

#include "bt/human/TreeBehavior.h"
#include "sim2d/base/Text.h"
#include "tests/bt/FakeWorld.h"

using base::NodeStatus;
using sim2d::BehaviorType;
using sim2d::EventKind;
using sim2d::Motion;

namespace {

/// A scenario, its fake world and the behaviour under test.
class Run {
 public:
  Run() {
    scenario.yamlBaseName = "demo";
    for (int id = 1; id <= 3; ++id) {
      scenario.goals.push_back({{}, id, base::Vec2(2.0 * id, 0.0), {}});
      world.goals[id] = base::Vec2(2.0 * id, 0.0);
    }
  }
  sim2d::Human& add(int id, const std::vector<int>& goals) {
    sim2d::Human human;
    human.name = "agent" + std::to_string(id);
    human.id = id;
    human.goals = goals;
    scenario.humans.push_back(human);
    return scenario.humans.back();
  }
  void file(const std::string& person, const std::string& body) {
    const std::string path = folder_.path().toStdString() + "/" + person + ".xml";
    QVERIFY(base::writeFileAtomically(path, "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\">" +
                                                body + "</BehaviorTree></root>")
                .empty());
    files[person] = path;
  }
  bool start() {
    behavior = bt::makeTreeBehavior(scenario, files, diagnostics);
    for (const sim2d::Human& human : scenario.humans) {
      if (human.listed) {
        enter(world.addPerson(human.id, 0.0, human.id), human);
      }
    }
    intents = std::make_unique<sim2d::Intents>(controls);
    for (int i = 0; behavior && i < world.humanCount(); ++i) {
      behavior->enter(i, world);
    }
    return behavior != nullptr;
  }
  void step() {
    behavior->decide(world, *intents);
    last = intents->of(0);
    events = intents->events();
    behavior->takeTreeChanges(changes);
    world.apply(*intents);
  }
  bool hasEvent(EventKind kind, const std::string& text) const {
    return std::any_of(events.begin(), events.end(), [&](const sim2d::Event& event) {
      return event.kind == kind && event.text == text;
    });
  }
  /// Status that a node returned in the last step, as the changes tell it.
  QString shown(const std::string& path) {
    QString found;
    changes.forEach(
        [&](int, const sim2d::TreeChanges::Paths& paths, int node, base::NodeStatus status) {
          if ((*paths)[static_cast<std::size_t>(node)] == path && found.isEmpty()) {
            found = QString::fromUtf8(base::nodeStatusName(status));
          }
        });
    return found;
  }

  sim2d::Scenario scenario;
  FakeWorld world;
  bt::TreeFiles files;
  base::Diagnostics diagnostics;
  std::unique_ptr<sim2d::HumanBehavior> behavior;
  std::vector<sim2d::HumanControl> controls;
  std::unique_ptr<sim2d::Intents> intents;
  sim2d::Intent last;
  std::vector<sim2d::Event> events;
  sim2d::TreeChanges changes;

 private:
  void enter(int index, const sim2d::Human& human) {
    world.at(index).constants = sim2d::resolveHuman(scenario, human, 1);
    sim2d::HumanControl control;
    for (const int goal : human.goals) {
      control.goals.push_back({goal, world.goals[goal], 0.3});
    }
    controls.push_back(control);
  }

  QTemporaryDir folder_;
};

}  // namespace

class HumanTreeBehaviorTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void generatedTree_regular_walksFromTheFirstStep() {
    Run run;
    run.add(1, {1, 2});
    QVERIFY(run.start());
    run.step();
    QCOMPARE(run.last.motion, Motion::Walk);
    QVERIFY(run.last.targetIsGoal);
    QCOMPARE(run.last.target.id, 1);
    QCOMPARE(run.controls[0].goals.size(), std::size_t(2));
    QCOMPARE(run.shown("RegularNavFallback/SetGoals"), QStringLiteral("FAILURE"));
    run.step();
    QCOMPARE(run.shown("RegularNavFallback/SetGoals"), QStringLiteral("SKIPPED"));
    QCOMPARE(run.last.motion, Motion::Walk);
  }

  void generatedTree_cyclicGoals_areVisitedInOrder() {
    Run run;
    run.add(1, {1, 2}).goalRadius = 0.3;
    run.scenario.humans.front().maxVel = 1.0;
    QVERIFY(run.start());
    std::string visited;
    for (int i = 0; i < 200; ++i) {
      run.step();
      for (const sim2d::Event& event : run.events) {
        visited += event.kind == EventKind::Goal ? event.text : "";
      }
    }
    QVERIFY(visited.rfind("1212", 0) == 0);
  }

  void curious_robotNeverVisible_neverReacts() {
    Run run;
    run.add(1, {1, 2}).behavior.type = BehaviorType::Curious;
    QVERIFY(run.start());
    for (int i = 0; i < 50; ++i) {
      run.step();
      QVERIFY(!run.last.active);
      QVERIFY(!run.hasEvent(EventKind::Action, "ApproachRobot"));
    }
  }

  void curious_robotVisible_reactsForItsDurationThenWalksOn() {
    Run run;
    sim2d::Human& human = run.add(1, {1, 2});
    human.behavior.type = BehaviorType::Curious;
    human.behavior.duration = 1.0;
    human.behavior.once = true;
    run.world.addRobot(3.0, 1.0);
    QVERIFY(run.start());
    run.step();
    QVERIFY(run.hasEvent(EventKind::Action, "ApproachRobot"));
    QVERIFY(run.last.active);
    int steps = 1;
    while (!run.hasEvent(EventKind::ActionEnd, "ApproachRobot SUCCESS") && steps < 100) {
      run.step();
      ++steps;
      QVERIFY(run.last.active);
    }
    QCOMPARE(steps, 11);
    int walked = 0;  // a step is lost at each goal
    for (int i = 0; i < 20; ++i) {
      run.step();
      QVERIFY(!run.last.active);
      walked += run.last.motion == Motion::Walk ? 1 : 0;
    }
    QVERIFY(walked >= 18);
  }

  void q08_brokenFile_isAnError_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::newRow("unknown node") << QByteArray("<Dance agent_id='1'/>");
    QTest::newRow("not a number") << QByteArray("<GoTo agent_id='x' goal_id='1'/>");
    QTest::newRow("no child") << QByteArray("<Sequence/>");
  }
  void q08_brokenFile_isAnError() {
    QFETCH(QByteArray, body);
    Run run;
    run.add(1, {1});
    run.file("agent1", body.toStdString());
    QVERIFY(!run.start());
    QVERIFY(base::hasErrors(run.diagnostics));
  }

  void q08_d06_missingFile_isAnErrorBeforeTheFirstTick() {
    Run run;
    run.add(1, {1});
    run.files["agent1"] = std::string("/does/not/exist.xml");
    QVERIFY(!run.start());
  }

  void q33_faultyTree_brakesWithOneWarning() {
    Run run;
    run.add(1, {1});
    run.add(2, {1});
    run.file("agent1",
             "<Sequence><RegularNav agent_id='{id}'/><GoTo agent_id='{id}' "
             "goal_id='{nothing}'/></Sequence>");
    QVERIFY(run.start());
    base::Diagnostics pendingDiagnostics;
    for (int i = 0; i < 3; ++i) {
      run.step();
      QCOMPARE(run.last.motion, Motion::Brake);
      base::Diagnostics found;
      run.behavior->takeDiagnostics(found);
      base::append(pendingDiagnostics, found);
    }
    QCOMPARE(pendingDiagnostics.size(), std::size_t(1));
    QVERIFY(pendingDiagnostics.front().message.find("agent1") != std::string::npos);
  }

  void loopTrees_off_standsAfterTheEnd() {
    Run run;
    run.add(1, {});
    run.scenario.desktop.loopTrees = false;
    run.file("agent1",
             "<SequenceWithMemory><TimeDelay delay='0.2'><AlwaysSuccess/></TimeDelay>"
             "<GoTo agent_id='{id}' goal_id='1' time_step='{dt}'/></SequenceWithMemory>");
    QVERIFY(run.start());
    bool hasEnded = false;
    for (int i = 0; i < 100; ++i) {
      run.step();
      hasEnded = hasEnded || run.hasEvent(EventKind::ActionEnd, "GoTo SUCCESS");
    }
    QVERIFY(hasEnded);
    QCOMPARE(run.last.motion, Motion::Stand);
    QVERIFY((run.world.at(0).pose.position - base::Vec2(2.0, 0.0)).norm() <= 0.2);
    QVERIFY(run.changes.size() == 0);
  }

  void loopTrees_off_navigationGoesOn() {
    Run run;
    run.add(1, {1, 2});
    run.scenario.desktop.loopTrees = false;
    QVERIFY(run.start());
    int goals = 0;
    for (int i = 0; i < 200; ++i) {
      run.step();
      goals += static_cast<int>(
          std::count_if(run.events.begin(), run.events.end(),
                        [](const sim2d::Event& event) { return event.kind == EventKind::Goal; }));
    }
    QVERIFY(goals >= 4);
  }

  void loopTrees_on_startsAgain() {
    Run run;
    run.add(1, {});
    run.file("agent1", "<StopAndWaitTimerAction agent_id='{id}' wait_duration='0.2'/>");
    QVERIFY(run.start());
    int starts = 0;
    for (int i = 0; i < 9; ++i) {
      run.step();
      starts += run.hasEvent(EventKind::Action, "StopAndWaitTimerAction") ? 1 : 0;
    }
    QCOMPARE(starts, 3);
  }

  void blackboard_hasIdAndStep() {
    Run run;
    run.add(7, {1});
    QVERIFY(run.start());
    run.step();
    const auto lines = run.behavior->blackboard(0);
    const auto has = [&lines](const std::string& key, const std::string& text) {
      return std::find(lines.begin(), lines.end(), std::make_pair(key, text)) != lines.end();
    };
    QVERIFY(has("id", "7"));
    QVERIFY(has("dt", "0.1"));
  }

  /// The entry `mood` chooses what is said; a number stays a number, words become words.
  void setEntry_actsInTheNextTick() {
    Run run;
    run.add(7, {1});
    run.file("agent7",
             "<Sequence><RunOnce><Script code='mood := 1'/></RunOnce><Fallback><Sequence>"
             "<ScriptCondition code='mood &gt; 3'/>"
             "<SaySomething agent_id='{id}' message='well'/></Sequence>"
             "<AlwaysSuccess/></Fallback></Sequence>");
    QVERIFY2(run.start(), run.diagnostics.empty() ? "" : run.diagnostics.front().text().c_str());
    run.step();
    run.step();
    QVERIFY(!run.hasEvent(EventKind::Say, "well"));
    QCOMPARE(run.behavior->setBlackboardEntry(0, "mood", "3.5"), std::string());
    const auto lines = run.behavior->blackboard(0);
    QVERIFY(std::find(lines.begin(), lines.end(),
                      std::make_pair(std::string("mood"), std::string("3.5"))) != lines.end());
    run.step();
    QVERIFY(run.hasEvent(EventKind::Say, "well"));
    QVERIFY(
        !run.behavior->setBlackboardEntry(0, "mood", "happy").empty());  // it is a number for ever
    QVERIFY(!run.behavior->setBlackboardEntry(0, "nothing", "1").empty());
    QVERIFY(!run.behavior->setBlackboardEntry(0, "id", "9").empty());
    QVERIFY(!run.behavior->setBlackboardEntry(0, "dt", "1.0").empty());
    QVERIFY(!run.behavior->setBlackboardEntry(5, "mood", "1").empty());
  }

  void personOfASource_runsTheTreeOfItsModel() {
    Run run;
    sim2d::Human& pattern = run.add(1, {1});
    pattern.listed = false;
    run.file("agent1", "<SaySomething agent_id='{id}' message='I am new'/>");
    sim2d::Area source;
    source.name = "entrance";
    source.kind = sim2d::AreaKind::Source;
    source.like = "agent1";
    run.scenario.areas = {source};
    QVERIFY(run.start());
    QCOMPARE(run.world.humanCount(), 0);
    run.world.addPerson(5, 0.0, 0.0);
    run.world.at(0).constants.name = "entrance_1";
    run.controls.emplace_back();
    run.intents = std::make_unique<sim2d::Intents>(run.controls);
    run.behavior->enter(0, run.world);
    run.step();
    QVERIFY(run.hasEvent(EventKind::Say, "I am new"));
    QCOMPARE(run.events.front().id, 5);
  }

  void enter_again_givesAFreshMind() {
    Run run;
    run.add(1, {1});
    run.file("agent1", "<RunOnce><SaySomething agent_id='{id}' message='once'/></RunOnce>");
    QVERIFY(run.start());
    run.step();
    QVERIFY(run.hasEvent(EventKind::Say, "once"));
    run.step();
    QVERIFY(!run.hasEvent(EventKind::Say, "once"));
    run.behavior->enter(0, run.world);
    run.step();
    QVERIFY(run.hasEvent(EventKind::Say, "once"));
  }

  void enter_again_endsWhatWasDoneToOthers() {
    Run run;
    run.add(1, {1});
    run.add(2, {2});
    run.file("agent1", "<SetGroupWalk main_agent_id='{id}' non_main_agent_ids='2'/>");
    run.file("agent2", "<RegularNav agent_id='{id}'/>");
    QVERIFY(run.start());
    run.step();
    QCOMPARE(run.controls[1].group, 1);
    QCOMPARE(run.controls[1].goals.front().id, 1);
    run.behavior->enter(0, run.world);
    run.world.at(0).isPresent = false;
    run.step();
    QCOMPARE(run.controls[1].group, -1);
    QCOMPARE(run.controls[1].goals.front().id, 2);
  }

  void enter_memberOfAGroupWalk_keepsWhatItCameWith() {
    Run run;
    run.add(1, {1});
    run.add(2, {2});
    run.file("agent1",
             "<SetGroupWalk main_agent_id='{id}' non_main_agent_ids='2' duration='0.3'/>");
    run.file("agent2", "<RegularNav agent_id='{id}'/>");
    QVERIFY(run.start());
    run.step();
    QCOMPARE(run.controls[1].group, 1);
    run.controls[1] = {};
    run.controls[1].group = 8;
    run.controls[1].goals = {{3, run.world.goals[3], 0.3}};
    run.behavior->enter(1, run.world);
    for (int i = 0; i < 3; ++i) {
      run.step();
    }
    QVERIFY(run.hasEvent(EventKind::ActionEnd, "SetGroupWalk SUCCESS"));
    QCOMPARE(run.controls[0].group, -1);
    QCOMPARE(run.controls[1].group, 8);
    QCOMPARE(run.controls[1].goals.front().id, 3);
  }

  void leaving_haltsTheTree() {
    Run run;
    run.add(1, {1});
    run.file("agent1", "<StopAndWaitTimerAction name='pause' agent_id='{id}' wait_duration='9'/>");
    QVERIFY(run.start());
    run.step();
    QCOMPARE(run.shown("pause"), QStringLiteral("RUNNING"));
    run.world.at(0).isPresent = false;
    run.step();
    QVERIFY(run.hasEvent(EventKind::ActionEnd, "pause HALTED"));
    QCOMPARE(run.shown("pause"), QStringLiteral("IDLE"));
    run.step();
    QVERIFY(run.changes.size() == 0);
  }

  void placeholdersOfVersion15_areFilled() {
    Run run;
    sim2d::Human& human = run.add(1, {1});
    human.behavior.dist = 3.0;
    run.file("agent1", "<IsRobotVisible agent_id='{id}' distance='{dist}'/>");
    run.world.addRobot(2.9, 1.0);
    QVERIFY(run.start());
    run.step();
    QCOMPARE(run.shown("IsRobotVisible"), QStringLiteral("SUCCESS"));
    run.world.robots[0].pose.position.x() = 3.1;
    run.step();
    QCOMPARE(run.shown("IsRobotVisible"), QStringLiteral("FAILURE"));
  }

  void q28_twoPeople_areTickedInTheOrderOfTheirIds() {
    Run run;
    run.add(5, {});
    run.add(2, {});
    run.file("agent5", "<SaySomething agent_id='{id}' message='five'/>");
    run.file("agent2", "<SaySomething agent_id='{id}' message='two'/>");
    QVERIFY(run.start());
    run.step();
    QVERIFY(run.events[0].text == "two" && run.events[1].text == "five");
  }
};

QTEST_APPLESS_MAIN(HumanTreeBehaviorTest)
#include "tst_HumanTreeBehavior.moc"
