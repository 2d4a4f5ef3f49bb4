#include <QtTest>

#include "tests/bt/FakeWorld.h"

using base::NodeStatus;
using base::Vec2;

namespace {

constexpr int kTicks = 4;

/// Person 1 at the origin looking along x, 2 ahead looking back, 3 to the left; a robot that comes
/// towards 1. Goals 1 and 2 are far and to the left.
FakeWorld scene() {
  FakeWorld world;
  world.addPerson(1, 0.0, 0.0, 0.0);
  world.addPerson(2, 3.0, 0.0, base::kPi);
  world.addPerson(3, 0.0, 4.0, 0.0);
  world.addRobot(2.0, 0.0, base::kPi);
  world.robots[0].velocity = Vec2(-0.5, 0.0);
  world.goals = {{1, Vec2(9.0, 0.0)}, {2, Vec2(0.0, 2.0)}, {3, Vec2(0.1, 0.0)}};
  for (const char* const name : {"hall", "door"}) {
    sim2d::Area area;
    area.name = name;
    area.kind = area.name == "door" ? sim2d::AreaKind::Exit : sim2d::AreaKind::Wait;
    area.points = {Vec2(5.0, 5.0), Vec2(9.0, 5.0), Vec2(9.0, 9.0), Vec2(5.0, 9.0)};
    world.settings.areas.push_back(area);
  }
  return world;
}

/// What nodes may change beside the motion, different for each person.
void prepare(FakeWorld& world, TreeBench& bench) {
  for (int human = 0; human < world.humanCount(); ++human) {
    sim2d::HumanControl& control = bench.control(human);
    control.goals = {{1, world.goals[1], 0.3}, {2, world.goals[2], 0.1 * (human + 1)}};
    control.group = human == 0 ? -1 : 10 + human;
    control.frozen = human == 2;
  }
  bench.society().speech.say(0, 2, "Hello");
}

std::vector<sim2d::HumanControl> controlsOf(const FakeWorld& world, TreeBench& bench) {
  std::vector<sim2d::HumanControl> controls;
  controls.reserve(static_cast<std::size_t>(world.humanCount()));
  for (int human = 0; human < world.humanCount(); ++human) {
    controls.push_back(bench.control(human));
  }
  return controls;
}

bool areEqual(const std::vector<sim2d::HumanControl>& a,
              const std::vector<sim2d::HumanControl>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& two) {
    return one.goals == two.goals && one.frozen == two.frozen && one.group == two.group;
  });
}

std::string wordsOf(TreeBench& bench) {
  std::string words;
  for (const bt::Utterance& said : bench.society().speech.audibleUtterances()) {
    words += std::to_string(said.serial) + said.text + "\n";
  }
  return words;
}

/// "RUNNING*|RUNNING|": statuses of the next ticks, a star for each leaf that was started.
std::string play(TreeBench& bench) {
  std::string text;
  for (int i = 0; i < kTicks; ++i) {
    text += base::nodeStatusName(bench.step());
    for (const bt::LeafEvent& event : bench.tree().events()) {
      text += event.kind == bt::LeafEvent::Kind::Started ? "*" : "";
    }
    text += "|";
  }
  return text;
}

}  // namespace

/// Nodes that last are halted in the middle.
class HumanHaltTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void halt_whileRunning_leavesNothingBehind_data() {
    QTest::addColumn<QByteArray>("body");
    for (const auto& [id, ports] : bodies()) {
      QTest::newRow(id.c_str())
          << QByteArray("<").append(id.c_str()).append(' ').append(ports.c_str());
    }
  }
  void halt_whileRunning_leavesNothingBehind() {
    QFETCH(QByteArray, body);
    FakeWorld world = scene();
    TreeBench bench(world);
    prepare(world, bench);
    const std::vector<FakeWorld::Person> before = world.people;
    const std::vector<sim2d::HumanControl> controls = controlsOf(world, bench);
    QVERIFY(bench.load(body.toStdString()));
    QVERIFY(bench.loadDiagnostics().empty());
    const std::string first = play(bench);
    QVERIFY2(QByteArray(first.c_str()).endsWith("RUNNING|"), first.c_str());
    QVERIFY2(first.find('*') != std::string::npos, first.c_str());
    const std::string words = wordsOf(bench);
    QVERIFY(!words.empty());

    bench.halt();
    QVERIFY(areEqual(controlsOf(world, bench), controls));
    QVERIFY(wordsOf(bench) == words);
    QVERIFY(!bench.society().agentStates[0].queue);
    QVERIFY(bench.society().agentStates[0].groupNodeState.empty());
    QVERIFY(bench.tree().events().back().kind == bt::LeafEvent::Kind::Halted);

    world.people = before;
    QCOMPARE(QString::fromStdString(play(bench)), QString::fromStdString(first));
    QVERIFY(bench.pendingDiagnostics().empty() && !bench.isFaulty());
  }

  void table_holdsAllNodesThatLast() {
    const bt::NodeLibrary library = bt::humanNodes();
    for (const bt::NodeManifest& manifest : library.catalogue().all()) {
      const bt::NodeFunctions* const functions = library.functions(manifest.id);
      const bool lasts = functions && functions->kind != bt::NodeFunctions::Kind::Synchronous;
      QVERIFY2(!lasts || bodies().count(manifest.id) > 0, manifest.id.c_str());
    }
  }

  void lookAtPoint_pushedAside_turnsToItAllTheSame() {
    FakeWorld world = scene();
    TreeBench bench(world);
    QVERIFY(bench.load("<LookAtPoint agent_id='1' goal_id='2'/>"));
    bench.step();
    bench.step();
    world.at(0).pose.position = Vec2(3.0, 5.0);
    QVERIFY(bench.stepsUntil(NodeStatus::Success, 20) > 0);
    // (0, 2) from (3, 5): to the lower left
    QVERIFY(std::fabs(world.at(0).pose.heading + 0.75 * base::kPi) <= 0.01);
  }

  void look_ofSomebodyWhoLeft_fails_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::newRow("point") << QByteArray("<LookAtPoint agent_id='3' goal_id='1'/>");
    QTest::newRow("robot") << QByteArray("<LookAtRobot agent_id='3'/>");
    QTest::newRow("person") << QByteArray("<LookAtAgent observer_id='3' target_id='1'/>");
  }
  void look_ofSomebodyWhoLeft_fails() {
    QFETCH(QByteArray, body);
    FakeWorld world = scene();
    TreeBench bench(world);
    QVERIFY(bench.load(body.toStdString()));
    QCOMPARE(bench.step(), NodeStatus::Running);
    world.at(2).isPresent = false;
    QCOMPARE(bench.step(), NodeStatus::Failure);
    QVERIFY(bench.pendingDiagnostics().empty());
  }

 private:
  /// What follows the name of each node.
  static std::map<std::string, std::string> bodies() {
    const std::string wait = "<StopAndWaitTimerAction agent_id='{id}' wait_duration='9'/>";
    return {
        {"StopAndWaitTimerAction", "agent_id='{id}' wait_duration='9'/>"},
        {"GoTo", "agent_id='{id}' goal_id='1' time_step='{dt}'/>"},
        {"ApproachRobot", "agent_id='{id}' closest_dist='1' max_vel='1'/>"},
        {"AvoidRobot", "agent_id='{id}' safe_distance='4' runaway_vel='1'/>"},
        {"BlockRobot", "agent_id='{id}' front_dist='1'/>"},
        {"ApproachAgent", "agent_id='{id}' target_agent_id='2'/>"},
        {"FollowAgent", "agent_id='{id}' target_agent_id='2'/>"},
        {"BlockAgent", "agent_id='{id}' target_agent_id='2' front_dist='1'/>"},
        {"SetGroupWalk", "main_agent_id='{id}' non_main_agent_ids='2,3' time_step='{dt}'/>"},
        {"ConversationFormation", "main_agent_id='{id}' goal_id='2' non_main_agent_ids='2,3'/>"},
        {"LookAtPoint", "agent_id='{id}' goal_id='2'/>"},
        {"LookAtAgent", "observer_id='{id}' target_id='3'/>"},
        {"LookAtRobot", "agent_id='3'/>"},
        {"IsLookingAtMe", "agent_id='{id}' target_id='3'/>"},
        {"IsAnyoneLookingAtMe", "agent_id='3' observer_id='{o}'/>"},
        {"IsSpeaking", "agent_id='{id}' target_id='2'/>"},
        {"IsAnyoneSpeaking", "agent_id='{id}' distance_threshold='1' speaker_id='{s}'/>"},
        {"WaitForAgent", "agent_id='{id}' target_agent_id='2'/>"},
        {"FleeFrom", "agent_id='{id}' target_agent_id='2'/>"},
        {"WanderInArea", "agent_id='{id}' area='hall'/>"},
        {"GoToNearestExit", "agent_id='{id}'/>"},
        {"UseObject", "agent_id='{id}' goal_id='3' duration='9'/>"},
        {"WaitInQueue", "agent_id='{id}' goal_id='3' duration='9'/>"},
        {"YieldToRobot", "agent_id='{id}'/>"},
        {"PassOnSide", "agent_id='{id}'/>"},
        {"TimeDelay", "delay='0.2'>" + wait + "</TimeDelay>"},
        {"Cooldown", "duration='9'>" + wait + "</Cooldown>"},
        {"ProbabilityChoice", "weights='1'>" + wait + "</ProbabilityChoice>"},
    };
  }
};

QTEST_APPLESS_MAIN(HumanHaltTest)
#include "tst_HumanHalt.moc"
