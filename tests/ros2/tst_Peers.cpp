#include <algorithm>
#include <cmath>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include "app/bridge/nodes/AgentServer.h"
#include "app/bridge/nodes/RunNode.h"
#include "app/run/Bundle.h"
#include "tests/agents/Caller.h"
#include "tests/ros2/Ros2Test.h"
#include "tests/support/Peers.h"

using namespace ros2test;

namespace {

constexpr int kFirstDomain = 40;

/// On the loopback alone, looking for others at the ports they take in turn.
const char kConfiguration[] = R"(<CycloneDDS><Domain><General>
<Interfaces><NetworkInterface address="127.0.0.1" multicast="false"/></Interfaces>
<AllowMulticast>false</AllowMulticast></General>
<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>20</MaxAutoParticipantIndex>
<Peers><Peer address="127.0.0.1"/></Peers></Discovery></Domain></CycloneDDS>)";

QString cycloneProgram(const char* name) {
  return text(TEST_OUTPUT_DIR "/ros2/") + text(name);
}

constexpr const char* kNoCyclone =
    "Cyclone DDS is not installed (Debian: cyclonedds-dev cyclonedds-tools)";

/// A program of others, while it runs.
class Peer {
 public:
  Peer(const QString& program, const QStringList& words) {
    QFile file(folder_.filePath(text("cyclone.xml")));
    if (file.open(QIODevice::WriteOnly)) {
      file.write(kConfiguration);
      file.close();
    }
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(text("CYCLONEDDS_URI"), text("file://") + file.fileName());
    process_.setProcessEnvironment(environment);
    process_.setProcessChannelMode(QProcess::MergedChannels);
    process_.start(program, words);
    process_.waitForStarted();
  }
  /// Has said this line, or will within some time.
  bool says(const QByteArray& line) {
    constexpr qint64 kPatience = 60000;  // [ms]
    QElapsedTimer clock;
    clock.start();
    while (!lines().contains(line) && isRunning() && clock.elapsed() < kPatience) {
      process_.waitForReadyRead(20);
    }
    return lines().contains(line);
  }
  bool isRunning() const { return process_.state() != QProcess::NotRunning; }
  /// Its input ends; what it said in all.
  QByteArray end() {
    process_.closeWriteChannel();
    process_.waitForFinished(20000);
    return said();
  }
  bool isFine() const {
    return !isRunning() && process_.exitStatus() == QProcess::NormalExit &&
           process_.exitCode() == 0;
  }
  QByteArray said() {
    said_ += process_.readAll();
    return said_;
  }
  QList<QByteArray> lines() { return said().split('\n'); }
  void look() { process_.waitForFinished(0); }
  void stop() {
    process_.terminate();
    process_.waitForFinished(20000);
  }

 private:
  QTemporaryDir folder_;
  QProcess process_;
  QByteArray said_;
};

/// The café with a lidar on its robot, told on topics.
struct Told {
  explicit Told(int domain) {
    app::RunSpec options;
    options.scenario = SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml";
    options.set = {"robot1.lidar.beams=90", "robot1.lidar.rate=10"};
    bundle = app::readBundle(options, app::RunSettings{}, sim2d::ImageLoader());
    verdict = app::check(bundle);
    if (verdict.world == nullptr) {
      return;
    }
    verdict.world->enableScans(true);
    RunNodeSettings settings;
    settings.domain = inDomain(domain);
    auto made = RunNode::create(verdict.world->header(), lidarsOf(*bundle.scenario), settings,
                                [this](const base::Diagnostic& said) { told.push_back(said); });
    node = made ? *std::move(made) : nullptr;
  }
  bool step(int times) {
    for (int k = 0; k < times; ++k) {
      node->publishState(frame());
      if (!verdict.world->step(node->inputs(frame()))) {
        return false;
      }
      QTest::qWait(5);  // best effort: who hears shall keep up
    }
    node->publishState(frame());
    return true;
  }
  const sim2d::Frame& frame() const { return verdict.world->frame(); }

  app::Bundle bundle;
  app::Verdict verdict;
  base::Diagnostics told;
  std::unique_ptr<RunNode> node;
};

constexpr int kSteps = 40, kMaxSteps = 150;  // in all before the robot arrives

/// What a topic told last, in the words of cyclone_topics, beside how often.
struct Heard {
  int count = 0;
  QList<QByteArray> words;
  double number(int word) const { return words.value(word).toDouble(); }
};

QMap<QByteArray, Heard> heardIn(const QByteArray& said) {
  QMap<QByteArray, Heard> all;
  for (const QByteArray& line : said.split('\n')) {
    QList<QByteArray> words = line.simplified().split(' ');
    if (line.startsWith('/') && words.size() >= 2) {
      const QByteArray topic = words.takeFirst();
      const int count = words.takeFirst().toInt();
      all[topic] = {count, words};
    }
  }
  return all;
}

/// The same words of what Foxglove's reader has decoded.
QByteArray wordsOf(const QString& topic, const QJsonObject& last) {
  const auto at = [](const QJsonValue& from, const char* path) {
    QJsonValue value = from;
    for (const QByteArray& name : QByteArray(path).split('.')) {
      value = value.toObject().value(QString::fromLatin1(name));
    }
    return value;
  };
  const auto number = [](const QJsonValue& value) {
    return QByteArray::number(value.toDouble(), 'g', 17) + ' ';
  };
  const auto agent = [&](const QJsonValue& of) {
    return number(of[text("id")]) + of[text("name")].toString().toUtf8() + ' ' +
           number(at(of, "position.position.x")) + number(at(of, "position.position.y")) +
           number(of[text("yaw")]);
  };
  const auto size = [&](const char* path) { return number(at(last, path).toArray().size()); };
  QByteArray words;
  if (topic == text("/clock")) {
    words = QByteArray::number(
        at(last, "clock.sec").toDouble() + 1e-9 * at(last, "clock.nsec").toDouble(), 'f', 9);
  } else if (topic == text("/tf") || topic == text("/tf_static")) {
    for (const QJsonValue& each : last[text("transforms")].toArray()) {
      words += at(each, "header.frame_id").toString().toUtf8() + '>' +
               each[text("child_frame_id")].toString().toUtf8() + ": ";
    }
  } else if (topic == text("/map")) {
    int occupied = 0;
    for (const QJsonValue& cell : last[text("data")].toArray()) {
      occupied += cell.toInt() == 100 ? 1 : 0;
    }
    words = number(at(last, "info.width")) + number(at(last, "info.height")) +
            number(at(last, "info.resolution")) + QByteArray::number(occupied);
  } else if (topic == text("/obstacles") || topic == text("/markers")) {
    words = size("markers");
  } else if (topic == text("/human_states")) {
    words = at(last, "header.frame_id").toString().toUtf8() + ' ';
    for (const QJsonValue& each : last[text("agents")].toArray()) {
      words += agent(each);
    }
  } else if (topic == text("/people")) {
    for (const QJsonValue& each : last[text("people")].toArray()) {
      words += each[text("name")].toString().toUtf8() + ' ' + number(at(each, "position.x")) +
               number(each[text("tags")].toArray().size());
    }
  } else if (topic == text("/robot_states")) {
    words = agent(last);
  } else if (topic == text("/odom")) {
    words = at(last, "header.frame_id").toString().toUtf8() + ' ' +
            last[text("child_frame_id")].toString().toUtf8() + ' ' +
            number(at(last, "pose.pose.position.x")) + number(at(last, "twist.twist.linear.x"));
  } else if (topic == text("/scan")) {
    words = at(last, "header.frame_id").toString().toUtf8() + ' ' + size("ranges") +
            number(last[text("range_max")]);
  } else if (topic == text("/plan")) {
    const QJsonArray poses = last[text("poses")].toArray();
    words = number(poses.size()) + number(at(poses.last(), "pose.position.x"));
  } else if (topic == text("/goal_pose")) {
    words = at(last, "header.frame_id").toString().toUtf8() + ' ' +
            number(at(last, "pose.position.x")) + number(at(last, "pose.position.y"));
  }
  return words;
}

/// What ros2_topics.js said, as lines of cyclone_topics.
QByteArray linesOf(const QByteArray& said) {
  QByteArray lines;
  for (const QByteArray& line : said.split('\n')) {
    const QJsonObject all = QJsonDocument::fromJson(line).object();
    for (auto topic = all.begin(); topic != all.end(); ++topic) {
      const QJsonObject heard = topic.value().toObject();
      lines += topic.key().toUtf8() + ' ' + QByteArray::number(heard[text("count")].toInt()) + ' ' +
               wordsOf(topic.key(), heard[text("last")].toObject()) + '\n';
    }
  }
  return lines.isEmpty() ? said : lines;
}

/// Topics and their types in lines of tshark ("GUID<tab>topics<tab>types"), of one maker's
/// programs.
QMap<QString, QString> namedByVendor(const QList<QByteArray>& lines, const QByteArray& vendor) {
  QMap<QString, QString> named;
  for (const QByteArray& line : lines) {
    const QList<QByteArray> columns = line.split('\t');
    if (columns.size() != 3 || !columns[0].startsWith(vendor)) {
      continue;
    }
    const QList<QByteArray> topics = columns[1].split(',');
    const QList<QByteArray> types = columns[2].split(',');
    for (int i = 0; i < topics.size() && topics.size() == types.size(); ++i) {
      named[QString::fromUtf8(topics[i])] = QString::fromUtf8(types[i]);
    }
  }
  return named;
}

/// A writer keeps ten states for who is too slow.
bool isOften(const Heard& topic) {
  return topic.count >= 10;
}

bool isNear(double a, double b, double tolerance = 1e-6) {
  return std::fabs(a - b) <= tolerance;
}

/// The latched ones, whoever hears them.
void compareLatched(const QMap<QByteArray, Heard>& heard, const Told& told) {
  const sim2d::Frame& frame = told.frame();
  const sim2d::OccupancyGrid& map = *told.bundle.map;
  QCOMPARE(heard["/map"].count, 1);
  QCOMPARE(int(heard["/map"].number(0)), map.width());
  QCOMPARE(int(heard["/map"].number(1)), map.height());
  QVERIFY(isNear(heard["/map"].number(2), map.resolution()));
  QVERIFY(heard["/map"].number(3) > 0.0);
  QVERIFY(heard["/tf_static"].words.value(0).startsWith("base_footprint>base_link:"));
  QVERIFY(heard["/tf_static"].words.value(1).startsWith("base_link>base_scan:"));
  QVERIFY(heard["/obstacles"].number(0) > 0.0);
  QCOMPARE(std::size_t(heard["/plan"].number(0)), frame.robotPaths.at(0).size());
  QVERIFY(isNear(heard["/plan"].number(1), frame.robotPaths.at(0).back().x()));
  QCOMPARE(heard["/goal_pose"].words.value(0), QByteArray("map"));
  QVERIFY(isNear(heard["/goal_pose"].number(1), 4.9));
  QVERIFY(isNear(heard["/goal_pose"].number(2), 1.3));
}

void comparePeople(const QMap<QByteArray, Heard>& heard, const Told& told) {
  const sim2d::HumanColumns& humans = told.frame().humans;
  const Heard& states = heard["/human_states"];
  const Heard& people = heard["/people"];
  QVERIFY(isOften(states) && isOften(people));
  QCOMPARE(states.words.value(0), QByteArray("map"));
  for (std::size_t k = 0; k < humans.size(); ++k) {
    const int at = 1 + 5 * static_cast<int>(k);
    QCOMPARE(int(states.number(at)), humans.id[k]);
    QVERIFY(isNear(states.number(at + 2), humans.x[k]));
    QVERIFY(isNear(states.number(at + 3), humans.y[k]));
    QVERIFY(isNear(states.number(at + 4), humans.heading[k], 2e-6));  // a float
    QVERIFY(isNear(people.number(3 * static_cast<int>(k) + 1), humans.x[k]));
    QCOMPARE(int(people.number(3 * static_cast<int>(k) + 2)), 3);  // id, group, behaviour
  }
}

void compareAll(const QMap<QByteArray, Heard>& heard, const Told& told) {
  const sim2d::Frame& frame = told.frame();
  compareLatched(heard, told);
  comparePeople(heard, told);
  QVERIFY(isNear(heard["/clock"].number(0), frame.time, 1e-9));
  QVERIFY(isOften(heard["/tf"]));
  QVERIFY(heard["/tf"].words.join().contains("odom>base_footprint:"));
  QVERIFY(isOften(heard["/robot_states"]));
  QVERIFY(isNear(heard["/robot_states"].number(2), frame.robots.x[0]));
  QVERIFY(isOften(heard["/odom"]));
  QCOMPARE(heard["/odom"].words.value(0), QByteArray("odom"));
  QCOMPARE(heard["/odom"].words.value(1), QByteArray("base_footprint"));
  QVERIFY(isNear(heard["/odom"].number(3), std::hypot(frame.robots.vx[0], frame.robots.vy[0])));
  QVERIFY(heard["/scan"].count > 0);
  QCOMPARE(heard["/scan"].words.value(0), QByteArray("base_scan"));
  QCOMPARE(int(heard["/scan"].number(1)), 90);
  QVERIFY(heard["/markers"].number(0) >= double(frame.humans.size()));
}

}  // namespace

/// Programs of others, neither whose DDS nor whose types are ours, hear, call and drive us: on
/// Eclipse Cyclone DDS (tests/ros2/peer) and on Foxglove's RTPS (tests/peers).
class PeersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void run_everyTopic_isHeard_data() {
    QTest::addColumn<bool>("isCyclone");
    QTest::newRow("Foxglove's RTPS") << false;  // it meets the first participant of a program only
    QTest::newRow("Cyclone DDS") << true;
  }

  void run_everyTopic_isHeard() {
    QFETCH(const bool, isCyclone);
    const QString program = isCyclone ? cycloneProgram("cyclone_topics") : text("node");
    if (isCyclone && !QFile::exists(program)) {
      QSKIP(kNoCyclone);
    }
    if (!isCyclone && !hasPeer(text("@foxglove/ros2"))) {
      QSKIP("@foxglove/ros2 is not installed (tests/README.md)");
    }
    const int domain = kFirstDomain + (isCyclone ? 2 : 3);
    Told told(domain);
    QVERIFY2(told.node,
             told.verdict.problems.empty() ? "" : told.verdict.problems[0].message.c_str());
    QStringList words = {QString::number(domain)};
    if (!isCyclone) {
      words = QStringList{text(SOURCE_DIR "/tests/peers/ros2_topics.js"), peersFolder()} + words;
    }
    Peer peer(program, words);
    QVERIFY2(peer.says("ready"), peer.said());
    int steps = 0;
    for (; steps < kMaxSteps && !peer.lines().contains("hearing"); ++steps) {
      QVERIFY(told.step(1));  // the writers see the readers a little later
      QTest::qWait(50);
    }
    QVERIFY2(steps < kMaxSteps, peer.said());
    QVERIFY(told.step(kSteps));
    QVERIFY2(peer.says("kept"), peer.said());
    for (int again = 0; again < 5; ++again) {  // the last state, should a datagram have been lost
      QTest::qWait(100);
      told.node->publishState(told.frame());
    }
    QTest::qWait(300);  // what is on its way
    const QByteArray said = peer.end();
    QVERIFY2(peer.isFine(), said);
    compareAll(heardIn(linesOf(said)), told);
    if (QTest::currentTestFailed()) {
      qWarning("%s", linesOf(said).constData());
    }
    QVERIFY(told.told.empty());
  }

  void cyclone_callsComputeAgents_walksByTheNumbersByHand() {
    const QString program = cycloneProgram("cyclone_compute");
    if (!QFile::exists(program)) {
      QSKIP(kNoCyclone);
    }
    ServeSettings settings;
    settings.domain = inDomain(kFirstDomain, Rmw::CycloneDds);
    base::Diagnostics told;
    auto server =
        AgentServer::create(agentstest::bundleOf(agentstest::oneWalker(), "hunav2"), settings,
                            [&](const base::Diagnostic& said) { told.push_back(said); });
    QVERIFY(server);
    Peer peer(program, {QString::number(kFirstDomain), text("21")});
    QElapsedTimer clock;
    clock.start();
    while (peer.isRunning() && clock.elapsed() < 50000) {
      (*server)->spin(Milliseconds(5));
      peer.look();
    }
    QVERIFY2(peer.isFine(), "not fine: " + peer.said());
    QVERIFY(told.empty());
    const QList<QByteArray> lines = peer.lines();
    QVERIFY(lines.contains("answer 1 0.000000000 0.000000000 map"));
    QVERIFY(lines.contains("answer 2 0.015000000 0.300000000 map"));
    QVERIFY(!peer.said().contains("states 1 "));      // nothing is published in the first call
    QVERIFY(lines.contains("states 2 0.000000000"));  // the state before the step
    QVERIFY(lines.contains("states 3 0.015000000"));
    // After 1 s x is 1.203459 m and v 1.482706 m/s: from the library of HuNavSim itself.
    for (const QByteArray& line : lines) {
      if (line.startsWith("answer 21 ")) {
        const QList<QByteArray> words = line.split(' ');
        QVERIFY2(isNear(words[2].toDouble(), 1.203459, 2e-6), line);
        QVERIFY2(isNear(words[3].toDouble(), 1.482706, 2e-6), line);
        return;
      }
    }
    QFAIL(peer.said());
  }

  void cyclone_callsEveryService_isAnswered() {
    const QString program = cycloneProgram("cyclone_services");
    if (!QFile::exists(program)) {
      QSKIP(kNoCyclone);
    }
    ServeSettings settings;
    settings.domain = inDomain(kFirstDomain + 1, Rmw::CycloneDds);
    settings.actsAsLoader = true;
    settings.actsAsGenerator = true;
    auto server = AgentServer::create(
        agentstest::bundleOf(agentstest::oneWalker(), "hunav2"), settings,
        [](const base::Diagnostic& said) { qWarning("%s", said.message.c_str()); });
    QVERIFY(server);
    Peer peer(program, {QString::number(kFirstDomain + 1)});
    QElapsedTimer clock;
    clock.start();
    while (peer.isRunning() && clock.elapsed() < 50000) {
      (*server)->spin(Milliseconds(5));
      peer.look();
    }
    QVERIFY2(peer.isFine(), peer.said());
    const QList<QByteArray> wanted = {
        "get_agents 1 person1 0.000000",
        "get_parameters 1 1 5.000",
        "compute_agents 1 person1 0.000000",
        "compute_agents 1 person1 0.015000",  // the first step of the numbers by hand
        "compute_agent 1 person1",
        "move_agent 1 person1",
        "reset_agents 1",
        "get 1 0",
        "types 1 1",
        "describe use_sim_time 1",
        "list publish_tf publish_sfm_forces use_sim_time",
        "set 1",
        "set_atomically 0 1",
        ""};
    QCOMPARE(peer.lines(), wanted);
  }

  void cyclone_comesLate_hearsWhatIsLatched() {
    const QString program = cycloneProgram("cyclone_topics");
    if (!QFile::exists(program)) {
      QSKIP(kNoCyclone);
    }
    Told told(kFirstDomain + 4);
    QVERIFY(told.node && told.step(kSteps));
    Peer peer(program, {QString::number(kFirstDomain + 4)});
    QVERIFY2(peer.says("kept"), peer.said());
    const QByteArray said = peer.end();
    QVERIFY2(peer.isFine(), said);
    const QMap<QByteArray, Heard> heard = heardIn(said);
    compareLatched(heard, told);
    QCOMPARE(heard["/human_states"].count, 0);
  }

  void cyclone_isTheNavigator_theRobotArrives_data() {
    QTest::addColumn<QString>("reliability");
    QTest::newRow("reliable commands") << QString();
    QTest::newRow("best effort") << text("best_effort");
  }

  void cyclone_isTheNavigator_theRobotArrives() {
    QFETCH(const QString, reliability);
    const QString program = cycloneProgram("cyclone_navigator");
    if (!QFile::exists(program)) {
      QSKIP(kNoCyclone);
    }
    const int domain = kFirstDomain + 5;
    sim2d::Scenario scenario = agentstest::oneWalker();
    sim2d::Robot& robot = agentstest::addRobot(scenario, {-3.0, 2.0});
    robot.planner = "ros2";
    robot.goal.point = base::Vec2(-1.0, 3.0);
    app::Verdict verdict = app::check(agentstest::bundleOf(scenario));
    QVERIFY(verdict.world);
    RunNodeSettings settings;
    settings.domain = inDomain(domain, Rmw::CycloneDds);
    settings.lockstep = true;
    settings.sendsGoals = true;
    base::Diagnostics told;
    auto node = RunNode::create(verdict.world->header(), lidarsOf(scenario), settings,
                                [&](const base::Diagnostic& said) { told.push_back(said); });
    QVERIFY(node);
    QStringList words = {QString::number(domain)};
    if (!reliability.isEmpty()) {
      words += reliability;
    }
    Peer peer(program, words);
    QVERIFY2(peer.says("ready"), peer.said());
    bool hasArrived = false;
    for (int k = 0; k < 400 && !hasArrived; ++k) {
      const sim2d::Frame& frame = verdict.world->frame();
      (*node)->publishState(frame);
      QVERIFY(verdict.world->step((*node)->inputs(frame)));
      for (const sim2d::Event& event : verdict.world->frame().events) {
        hasArrived = hasArrived || (event.kind == sim2d::EventKind::Arrived && event.id < 0);
      }
    }
    const QByteArray said = peer.end();
    QVERIFY2(peer.isFine() && hasArrived, said);
    QVERIFY2(said.contains("goal -1.000000 3.000000 map\n"), said);
    for (const base::Diagnostic& each : told) {
      QVERIFY2(each.severity == base::Severity::Info, each.message.c_str());
    }
  }

  /// What Wireshark's dissector reads on the loopback while we and Cyclone DDS meet.
  void tshark_namesEveryTopicAndType() {
    const QString program = cycloneProgram("cyclone_topics");
    const QString tshark = QStandardPaths::findExecutable(text("tshark"));
    if (!QFile::exists(program) || tshark.isEmpty()) {
      QSKIP("tshark or Cyclone DDS is not installed (Debian: tshark, cyclonedds-dev)");
    }
    constexpr int kDomain = kFirstDomain + 6, kFirstPort = 7400 + 250 * kDomain;
    Peer capture(tshark,
                 {text("-l"), text("-n"), text("-i"), text("lo"), text("-f"),
                  QStringLiteral("udp portrange %1-%2").arg(kFirstPort).arg(kFirstPort + 249),
                  text("-Y"), text("rtps.param.topicName"), text("-T"), text("fields"), text("-e"),
                  text("rtps.guidPrefix.src"), text("-e"), text("rtps.param.topicName"), text("-e"),
                  text("rtps.param.typeName")});
    if (!capture.says("Capturing on 'Loopback: lo'")) {
      QSKIP("tshark may not capture here");
    }
    Told told(kDomain);
    QVERIFY(told.node);
    const QMap<QString, QString> wanted = {
        {text("rt/clock"), text("rosgraph_msgs::msg::dds_::Clock_")},
        {text("rt/tf"), text("tf2_msgs::msg::dds_::TFMessage_")},
        {text("rt/tf_static"), text("tf2_msgs::msg::dds_::TFMessage_")},
        {text("rt/map"), text("nav_msgs::msg::dds_::OccupancyGrid_")},
        {text("rt/obstacles"), text("visualization_msgs::msg::dds_::MarkerArray_")},
        {text("rt/markers"), text("visualization_msgs::msg::dds_::MarkerArray_")},
        {text("rt/human_states"), text("hunav_msgs::msg::dds_::Agents_")},
        {text("rt/people"), text("people_msgs::msg::dds_::People_")},
        {text("rt/robot_states"), text("hunav_msgs::msg::dds_::Agent_")},
        {text("rt/odom"), text("nav_msgs::msg::dds_::Odometry_")},
        {text("rt/scan"), text("sensor_msgs::msg::dds_::LaserScan_")},
        {text("rt/plan"), text("nav_msgs::msg::dds_::Path_")},
        {text("rt/goal_pose"), text("geometry_msgs::msg::dds_::PoseStamped_")},
        {text("rt/cmd_vel"), text("geometry_msgs::msg::dds_::Twist_")},
        {text("rt/rosout"), text("rcl_interfaces::msg::dds_::Log_")},
        {text("rt/parameter_events"), text("rcl_interfaces::msg::dds_::ParameterEvent_")},
        {text("rq/hunavsim/get_parametersRequest"),
         text("rcl_interfaces::srv::dds_::GetParameters_Request_")},
        {text("rr/hunavsim/get_parametersReply"),
         text("rcl_interfaces::srv::dds_::GetParameters_Response_")},
        {text("ros_discovery_info"), text("rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_")}};
    QMap<QString, QString> named;
    const auto isAllNamed = [&] {
      named = namedByVendor(capture.lines(), "010f");  // eProsima: us, not Cyclone
      return std::all_of(wanted.keyBegin(), wanted.keyEnd(),
                         [&](const QString& topic) { return named.contains(topic); });
    };
    for (int peers = 0; peers < 4 && !isAllNamed(); ++peers) {  // a busy machine drops packets
      Peer peer(program, {QString::number(kDomain)});
      QVERIFY2(peer.says("ready"), peer.said());
      QElapsedTimer clock;
      clock.start();
      while (!isAllNamed() && clock.elapsed() < 10000) {
        QTest::qWait(100);
      }
    }
    for (auto topic = wanted.begin(); topic != wanted.end(); ++topic) {
      QVERIFY2(named.value(topic.key()) == topic.value(),
               qPrintable(topic.key() + text(" is ") + named.value(topic.key())));
    }
    capture.stop();
  }
};

QTEST_GUILESS_MAIN(PeersTest)
#include "tst_Peers.moc"
