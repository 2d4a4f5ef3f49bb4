#include <QtTest>

#include "tests/bt/FakeWorld.h"
#include "tests/support/CommaLocale.h"

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

  // What the check of a tree says about ports of people's nodes.

  void checkTree_ports_warnsWithLine_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::addColumn<QByteArray>("message");  // empty = nothing is said
    for (const char* const id :
         {"GoTo", "SetGoal", "LookAtPoint", "IsAtPosition", "WaitInQueue", "UseObject"}) {
      const QByteArray name(id);
      const QByteArray node = "<" + name + " agent_id='1'";
      const QByteArray message =
          name + ": port 'goal_id' of '" + name + "' is missing (for example 1)";
      QTest::newRow((name + " without a place").constData()) << node + "/>" << message;
      QTest::newRow((name + " with x alone").constData()) << node + " target_x='1'/>" << message;
      QTest::newRow((name + " with a point").constData())
          << node + " target_x='1' target_y='{y}'/>" << QByteArray();
      QTest::newRow((name + " with a goal").constData())
          << node + " goal_id='{g}'/>" << QByteArray();
    }
    const char* const noCentre =
        "ConversationFormation: port 'goal_id' of 'ConversationFormation' is missing (for example "
        "1)";
    row("<ConversationFormation main_agent_id='1'/>", noCentre);
    row("<ConversationFormation main_agent_id='1' center_x='1'/>", noCentre);
    row("<ConversationFormation main_agent_id='1' center_x='1' center_y='2'/>", "");

    row("<IsRobotVisible agent_id='1' distance='1,5'/>",
        "IsRobotVisible: port 'distance' is '1,5', read as 1");
    row("<IsRobotVisible agent_id='1' distance='2.5m'/>",
        "IsRobotVisible: port 'distance' is '2.5m', read as 2.5");
    row("<IsRobotVisible agent_id='1.5' distance='2'/>",
        "IsRobotVisible: port 'agent_id' is '1.5', read as 1");
    row("<IsRobotVisible agent_id='1.0' distance='2.50'/>", "");
    row("<IsRobotVisible agent_id='1' distance='1e1'/>", "");

    row("<ApproachAgent agent_id='1' target_agent_id='2' duration='-1'/>", "");
    row("<AvoidRobot agent_id='1' safe_distance='3' runaway_vel='1' duration='-1'/>", "");
    row("<SetGroupWalk main_agent_id='1' duration='-1'/>", "");
    row("<WanderInArea agent_id='1' area='a' duration='-1'/>", "");
    row("<WaitForAgent agent_id='1' target_agent_id='2' duration='-1'/>", "");
    row("<FleeFrom agent_id='1' target_agent_id='2' duration='-1'/>", "");
    row("<FleeFrom agent_id='1' target_agent_id='2' duration='36001'/>",
        "FleeFrom: port 'duration' is 36001, more than 36000");
    row("<StopAndWaitTimerAction agent_id='1' wait_duration='-1'/>",
        "StopAndWaitTimerAction: port 'wait_duration' is -1, less than 0");
    row("<FollowAgent agent_id='1' target_agent_id='2' max_vel='-1'/>", "");
    row("<FollowAgent agent_id='1' target_agent_id='2' max_vel='11'/>",
        "FollowAgent: port 'max_vel' is 11, more than 10");
    row("<IsAgentVisible observer_id='1' agent_id='2' field_of_view='6.28'/>", "");
    row("<IsAgentVisible observer_id='1' agent_id='2' field_of_view='6.29'/>",
        "IsAgentVisible: port 'field_of_view' is 6.29, more than 6.283185307179586");
  }
  void checkTree_ports_warnsWithLine() {
    QFETCH(QByteArray, body);
    QFETCH(QByteArray, message);
    const QString expected =
        message.isEmpty() ? QString()
                          : QStringLiteral("t.xml:2: warning: T/") + QString::fromUtf8(message);
    QCOMPARE(check(body.toStdString()), expected);
  }

  void legacyDurations_haveAUnit() {
    const bt::NodeLibrary library = bt::humanNodes();
    const std::pair<const char*, const char*> ports[] = {
        {"GoTo", "stop_duration"}, {"SurprisedNav", "beh_duration"}, {"ScaredNav", "beh_duration"}};
    for (const auto& [id, port] : ports) {
      QVERIFY2(library.catalogue().find(id)->port(port)->unit == "s", id);
    }
  }

  void tree_inALocaleWithCommas_isTheSame() {
    const std::string body =
        "<Sequence><IsRobotClose agent_id='{id}' threshold='2.5'/>"
        "<StopAndWaitTimerAction agent_id='{id}' wait_duration='0.15'/>"
        "</Sequence>";
    const bt::NodeLibrary library = bt::humanNodes();
    const std::string written = bt::writeTree(*read(body), library.catalogue());
    const CommaLocale locale;
    if (!locale.active()) {
      QSKIP("no locale that writes 1,5");
    }
    QCOMPARE(check(body), QString());
    QVERIFY(bt::writeTree(*read(body), library.catalogue()) == written);
    QCOMPARE(check("<IsRobotClose agent_id='1' threshold='2,5'/>"),
             QStringLiteral("t.xml:2: warning: T/IsRobotClose: port 'threshold' is '2,5', read as "
                            "2"));
    FakeWorld world = withOnePerson();
    world.addRobot(2.25, 0.0);
    TreeBench bench(world);
    QVERIFY(bench.load(body));
    QCOMPARE(bench.stepsUntil(base::NodeStatus::Success), 3);
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

  static base::Result<bt::TreeFile> read(const std::string& body) {
    return bt::readTreeText(
        "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\">\n" + body + "</BehaviorTree></root>",
        "t.xml");
  }
  /// All lines of reading and checking.
  static QString check(const std::string& body) {
    const base::Result<bt::TreeFile> file = read(body);
    base::Diagnostics found = file.diagnostics();
    if (file) {
      const bt::NodeLibrary library = bt::humanNodes();
      base::append(found, bt::diagnosticsOf(bt::checkTree(file->trees.front(), library.catalogue(),
                                                          {"T"}, "t.xml")));
    }
    QStringList lines;
    for (const base::Diagnostic& diagnostic : found) {
      lines << QString::fromStdString(diagnostic.text());
    }
    return lines.join(QLatin1Char('\n'));
  }
  static void row(const char* body, const char* message) {
    QTest::newRow(body) << QByteArray(body) << QByteArray(message);
  }
};

QTEST_GUILESS_MAIN(HumanHaltTest)
#include "tst_HumanHalt.moc"
