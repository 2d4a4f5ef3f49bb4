#include <optional>

#include <QTemporaryDir>
#include <QtTest>

#include "bt/human/TreeBehavior.h"
#include "bt/human/TreeGenerator.h"
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
  void init() { run_.emplace(); }

  void generatedTree_regular_walksFromTheFirstStep() {
    run_->add(1, {1, 2});
    QVERIFY(run_->start());
    run_->step();
    QCOMPARE(run_->last.motion, Motion::Walk);
    QVERIFY(run_->last.targetIsGoal);
    QCOMPARE(run_->last.target.id, 1);
    QCOMPARE(run_->controls[0].goals.size(), std::size_t(2));
    QCOMPARE(run_->shown("RegularNavFallback/SetGoals"), QStringLiteral("FAILURE"));
    run_->step();
    QCOMPARE(run_->shown("RegularNavFallback/SetGoals"), QStringLiteral("SKIPPED"));
    QCOMPARE(run_->last.motion, Motion::Walk);
  }

  void generatedTree_cyclicGoals_areVisitedInOrder() {
    run_->add(1, {1, 2}).goalRadius = 0.3;
    run_->scenario.humans.front().maxVel = 1.0;
    QVERIFY(run_->start());
    std::string visited;
    for (int i = 0; i < 200; ++i) {
      run_->step();
      for (const sim2d::Event& event : run_->events) {
        visited += event.kind == EventKind::Goal ? event.text : "";
      }
    }
    QVERIFY(visited.rfind("1212", 0) == 0);
  }

  void curious_robotNeverVisible_neverReacts() {
    run_->add(1, {1, 2}).behavior.type = BehaviorType::Curious;
    QVERIFY(run_->start());
    for (int i = 0; i < 50; ++i) {
      run_->step();
      QVERIFY(!run_->last.active);
      QVERIFY(!run_->hasEvent(EventKind::Action, "ApproachRobot"));
    }
  }

  void curious_robotVisible_reactsForItsDurationThenWalksOn() {
    sim2d::Human& human = run_->add(1, {1, 2});
    human.behavior.type = BehaviorType::Curious;
    human.behavior.duration = 1.0;
    human.behavior.once = true;
    run_->world.addRobot(3.0, 1.0);
    QVERIFY(run_->start());
    run_->step();
    QVERIFY(run_->hasEvent(EventKind::Action, "ApproachRobot"));
    QVERIFY(run_->last.active);
    int steps = 1;
    while (!run_->hasEvent(EventKind::ActionEnd, "ApproachRobot SUCCESS") && steps < 100) {
      run_->step();
      ++steps;
      QVERIFY(run_->last.active);
    }
    QCOMPARE(steps, 11);
    int walked = 0;  // a step is lost at each goal
    for (int i = 0; i < 20; ++i) {
      run_->step();
      QVERIFY(!run_->last.active);
      walked += run_->last.motion == Motion::Walk ? 1 : 0;
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
    run_->add(1, {1});
    run_->file("agent1", body.toStdString());
    QVERIFY(!run_->start());
    QVERIFY(base::hasErrors(run_->diagnostics));
  }

  void q08_d06_missingFile_isAnErrorBeforeTheFirstTick() {
    run_->add(1, {1});
    run_->files["agent1"] = std::string("/does/not/exist.xml");
    QVERIFY(!run_->start());
  }

  void q33_faultyTree_brakesWithOneWarning() {
    run_->add(1, {1});
    run_->add(2, {1});
    run_->file("agent1",
               "<Sequence><RegularNav agent_id='{id}'/><GoTo agent_id='{id}' "
               "goal_id='{nothing}'/></Sequence>");
    QVERIFY(run_->start());
    base::Diagnostics pendingDiagnostics;
    for (int i = 0; i < 3; ++i) {
      run_->step();
      QCOMPARE(run_->last.motion, Motion::Brake);
      base::Diagnostics found;
      run_->behavior->takeDiagnostics(found);
      base::append(pendingDiagnostics, found);
    }
    QCOMPARE(pendingDiagnostics.size(), std::size_t(1));
    QVERIFY(pendingDiagnostics.front().message.find("agent1") != std::string::npos);
  }

  void loopTrees_off_standsAfterTheEnd() {
    run_->add(1, {});
    run_->scenario.desktop.loopTrees = false;
    run_->file("agent1",
               "<SequenceWithMemory><TimeDelay delay='0.2'><AlwaysSuccess/></TimeDelay>"
               "<GoTo agent_id='{id}' goal_id='1' time_step='{dt}'/></SequenceWithMemory>");
    QVERIFY(run_->start());
    bool hasEnded = false;
    for (int i = 0; i < 100; ++i) {
      run_->step();
      hasEnded = hasEnded || run_->hasEvent(EventKind::ActionEnd, "GoTo SUCCESS");
    }
    QVERIFY(hasEnded);
    QCOMPARE(run_->last.motion, Motion::Stand);
    QVERIFY((run_->world.at(0).pose.position - base::Vec2(2.0, 0.0)).norm() <= 0.2);
    QVERIFY(run_->changes.size() == 0);
  }

  void loopTrees_off_navigationGoesOn() {
    run_->add(1, {1, 2});
    run_->scenario.desktop.loopTrees = false;
    QVERIFY(run_->start());
    int goals = 0;
    for (int i = 0; i < 200; ++i) {
      run_->step();
      goals += static_cast<int>(
          std::count_if(run_->events.begin(), run_->events.end(),
                        [](const sim2d::Event& event) { return event.kind == EventKind::Goal; }));
    }
    QVERIFY(goals >= 4);
  }

  void loopTrees_on_startsAgain() {
    run_->add(1, {});
    run_->file("agent1", "<StopAndWaitTimerAction agent_id='{id}' wait_duration='0.2'/>");
    QVERIFY(run_->start());
    int starts = 0;
    for (int i = 0; i < 9; ++i) {
      run_->step();
      starts += run_->hasEvent(EventKind::Action, "StopAndWaitTimerAction") ? 1 : 0;
    }
    QCOMPARE(starts, 3);
  }

  void blackboard_hasIdAndStep() {
    run_->add(7, {1});
    QVERIFY(run_->start());
    run_->step();
    const auto lines = run_->behavior->blackboard(0);
    const auto has = [&lines](const std::string& key, const std::string& text) {
      return std::find(lines.begin(), lines.end(), std::make_pair(key, text)) != lines.end();
    };
    QVERIFY(has("id", "7"));
    QVERIFY(has("dt", "0.1"));
  }

  /// The entry `mood` chooses what is said; a number stays a number, words become words.
  void setEntry_actsInTheNextTick() {
    run_->add(7, {1});
    run_->file("agent7",
               "<Sequence><RunOnce><Script code='mood := 1'/></RunOnce><Fallback><Sequence>"
               "<ScriptCondition code='mood &gt; 3'/>"
               "<SaySomething agent_id='{id}' message='well'/></Sequence>"
               "<AlwaysSuccess/></Fallback></Sequence>");
    QVERIFY2(run_->start(),
             run_->diagnostics.empty() ? "" : run_->diagnostics.front().text().c_str());
    run_->step();
    run_->step();
    QVERIFY(!run_->hasEvent(EventKind::Say, "well"));
    QCOMPARE(run_->behavior->setBlackboardEntry(0, "mood", "3.5"), std::string());
    const auto lines = run_->behavior->blackboard(0);
    QVERIFY(std::find(lines.begin(), lines.end(),
                      std::make_pair(std::string("mood"), std::string("3.5"))) != lines.end());
    run_->step();
    QVERIFY(run_->hasEvent(EventKind::Say, "well"));
    QVERIFY(!run_->behavior->setBlackboardEntry(0, "mood", "happy")
                 .empty());  // it is a number for ever
    QVERIFY(!run_->behavior->setBlackboardEntry(0, "nothing", "1").empty());
    QVERIFY(!run_->behavior->setBlackboardEntry(0, "id", "9").empty());
    QVERIFY(!run_->behavior->setBlackboardEntry(0, "dt", "1.0").empty());
    QVERIFY(!run_->behavior->setBlackboardEntry(5, "mood", "1").empty());
  }

  void personOfASource_runsTheTreeOfItsModel() {
    sim2d::Human& pattern = run_->add(1, {1});
    pattern.listed = false;
    run_->file("agent1", "<SaySomething agent_id='{id}' message='I am new'/>");
    sim2d::Area source;
    source.name = "entrance";
    source.kind = sim2d::AreaKind::Source;
    source.like = "agent1";
    run_->scenario.areas = {source};
    QVERIFY(run_->start());
    QCOMPARE(run_->world.humanCount(), 0);
    run_->world.addPerson(5, 0.0, 0.0);
    run_->world.at(0).constants.name = "entrance_1";
    run_->controls.emplace_back();
    run_->intents = std::make_unique<sim2d::Intents>(run_->controls);
    run_->behavior->enter(0, run_->world);
    run_->step();
    QVERIFY(run_->hasEvent(EventKind::Say, "I am new"));
    QCOMPARE(run_->events.front().id, 5);
  }

  /// Neither a tree without a file nor a file that the generator would write is a custom tree.
  void customTree_isOneThatWasNotGenerated() {
    run_->add(1, {1}).listed = false;
    run_->file("agent1", "<StopMovement agent_id='{id}'/>");
    run_->add(2, {1, 2});
    run_->add(3, {2, 1});
    const std::string saved =
        bt::makeTreeText(run_->scenario, run_->scenario.humans.back(), bt::TreeStyle::Corrected,
                         bt::humanNodes().catalogue());
    run_->files["agent3"] = bt::TreeSource(saved, "", "");
    run_->add(4, {1, 2});
    run_->files["agent4"] = bt::TreeSource(saved, "", "");  // other goals than the person's
    sim2d::Area source;
    source.kind = sim2d::AreaKind::Source;
    source.name = "entrance";
    source.like = "agent1";
    run_->scenario.areas = {source};
    QVERIFY(run_->start());
    const int guest = run_->world.addPerson(1000001, 5.0, 5.0);
    run_->world.at(guest).constants.name = "entrance_1";
    const auto isCustom = [this](int human) {
      return run_->behavior->hasCustomTree(human, run_->world);
    };
    QVERIFY(!isCustom(0));  // agent2
    QVERIFY(!isCustom(1));  // agent3
    QVERIFY(isCustom(2));   // agent4
    QVERIFY(isCustom(guest));
  }

  void enter_again_givesAFreshMind() {
    run_->add(1, {1});
    run_->file("agent1", "<RunOnce><SaySomething agent_id='{id}' message='once'/></RunOnce>");
    QVERIFY(run_->start());
    run_->step();
    QVERIFY(run_->hasEvent(EventKind::Say, "once"));
    run_->step();
    QVERIFY(!run_->hasEvent(EventKind::Say, "once"));
    run_->behavior->enter(0, run_->world);
    run_->step();
    QVERIFY(run_->hasEvent(EventKind::Say, "once"));
  }

  void enter_again_endsWhatWasDoneToOthers() {
    run_->add(1, {1});
    run_->add(2, {2});
    run_->file("agent1", "<SetGroupWalk main_agent_id='{id}' non_main_agent_ids='2'/>");
    run_->file("agent2", "<RegularNav agent_id='{id}'/>");
    QVERIFY(run_->start());
    run_->step();
    QCOMPARE(run_->controls[1].group, 1);
    QCOMPARE(run_->controls[1].goals.front().id, 1);
    run_->behavior->enter(0, run_->world);
    run_->world.at(0).isPresent = false;
    run_->step();
    QCOMPARE(run_->controls[1].group, -1);
    QCOMPARE(run_->controls[1].goals.front().id, 2);
  }

  void enter_memberOfAGroupWalk_keepsWhatItCameWith() {
    run_->add(1, {1});
    run_->add(2, {2});
    run_->file("agent1",
               "<SetGroupWalk main_agent_id='{id}' non_main_agent_ids='2' duration='0.3'/>");
    run_->file("agent2", "<RegularNav agent_id='{id}'/>");
    QVERIFY(run_->start());
    run_->step();
    QCOMPARE(run_->controls[1].group, 1);
    run_->controls[1] = {};
    run_->controls[1].group = 8;
    run_->controls[1].goals = {{3, run_->world.goals[3], 0.3}};
    run_->behavior->enter(1, run_->world);
    for (int i = 0; i < 3; ++i) {
      run_->step();
    }
    QVERIFY(run_->hasEvent(EventKind::ActionEnd, "SetGroupWalk SUCCESS"));
    QCOMPARE(run_->controls[0].group, -1);
    QCOMPARE(run_->controls[1].group, 8);
    QCOMPARE(run_->controls[1].goals.front().id, 3);
  }

  void leaving_haltsTheTree() {
    run_->add(1, {1});
    run_->file("agent1",
               "<StopAndWaitTimerAction name='pause' agent_id='{id}' wait_duration='9'/>");
    QVERIFY(run_->start());
    run_->step();
    QCOMPARE(run_->shown("pause"), QStringLiteral("RUNNING"));
    run_->world.at(0).isPresent = false;
    run_->step();
    QVERIFY(run_->hasEvent(EventKind::ActionEnd, "pause HALTED"));
    QCOMPARE(run_->shown("pause"), QStringLiteral("IDLE"));
    run_->step();
    QVERIFY(run_->changes.size() == 0);
  }

  void placeholdersOfVersion15_areFilled() {
    sim2d::Human& human = run_->add(1, {1});
    human.behavior.dist = 3.0;
    run_->file("agent1", "<IsRobotVisible agent_id='{id}' distance='{dist}'/>");
    run_->world.addRobot(2.9, 1.0);
    QVERIFY(run_->start());
    run_->step();
    QCOMPARE(run_->shown("IsRobotVisible"), QStringLiteral("SUCCESS"));
    run_->world.robots[0].pose.position.x() = 3.1;
    run_->step();
    QCOMPARE(run_->shown("IsRobotVisible"), QStringLiteral("FAILURE"));
  }

  void q28_twoPeople_areTickedInTheOrderOfTheirIds() {
    run_->add(5, {});
    run_->add(2, {});
    run_->file("agent5", "<SaySomething agent_id='{id}' message='five'/>");
    run_->file("agent2", "<SaySomething agent_id='{id}' message='two'/>");
    QVERIFY(run_->start());
    run_->step();
    QVERIFY(run_->events[0].text == "two" && run_->events[1].text == "five");
  }

 private:
  std::optional<Run> run_;
};

QTEST_APPLESS_MAIN(HumanTreeBehaviorTest)
#include "tst_HumanTreeBehavior.moc"
