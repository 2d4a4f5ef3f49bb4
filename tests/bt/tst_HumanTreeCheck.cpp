#include <QtTest>

#include "tests/bt/FakeWorld.h"
#include "tests/support/CommaLocale.h"

/// What the check of a tree says about ports of people's nodes.
class HumanTreeCheckTest : public QObject {
  Q_OBJECT

 private:
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

 private Q_SLOTS:
  void checkTree_ports_warnsWithLine_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::addColumn<QByteArray>("message");  // empty = nothing is said
    for (const char* const id :
         {"GoTo", "SetGoal", "LookAtPoint", "IsAtPosition", "WaitInQueue", "UseObject"}) {
      const QByteArray name(id);
      const QByteArray node = "<" + name + " agent_id='1'";
      const QByteArray message = name + ": port 'goal_id' of '" + name + "' is missing (e.g. 1)";
      QTest::newRow((name + " without a place").constData()) << node + "/>" << message;
      QTest::newRow((name + " with x alone").constData()) << node + " target_x='1'/>" << message;
      QTest::newRow((name + " with a point").constData())
          << node + " target_x='1' target_y='{y}'/>" << QByteArray();
      QTest::newRow((name + " with a goal").constData())
          << node + " goal_id='{g}'/>" << QByteArray();
    }
    const char* const noCentre =
        "ConversationFormation: port 'goal_id' of 'ConversationFormation' is missing (e.g. 1)";
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
    FakeWorld world;
    world.addPerson(1, 0.0, 0.0);
    world.addRobot(2.25, 0.0);
    TreeBench bench(world);
    QVERIFY(bench.load(body));
    QCOMPARE(bench.stepsUntil(base::NodeStatus::Success), 3);
  }
};

QTEST_GUILESS_MAIN(HumanTreeCheckTest)
#include "tst_HumanTreeCheck.moc"
