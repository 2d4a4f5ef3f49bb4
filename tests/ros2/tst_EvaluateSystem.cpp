#include <csignal>

#include <QElapsedTimer>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/hunav_msgs.h"
#include "app/bridge/messages/nav_msgs.h"
#include "app/bridge/messages/std_srvs.h"
#include "app/bridge/nodes/Recorder.h"
#include "tests/ros2/Ros2Test.h"

using namespace ros2test;

namespace {

constexpr int kDomain = 33;
constexpr int kSamples = 21;
constexpr double kStep = 0.1;  // [s]

/// A robot that drives along x at 1 m/s past a person who stands at (1, 2).
class FakeSystem {
 public:
  FakeSystem() : participant_(participant(inDomain(kDomain))) {
    const int node = participant_->addNode("/", "simulator");
    people_ =
        *participant_->publisher(node, "human_states", hunav_msgs::Agents::kType, Qos::keepLast(1));
    robot_ =
        *participant_->publisher(node, "robot_states", hunav_msgs::Agent::kType, Qos::keepLast(1));
    map_ = *participant_->publisher(node, "map", nav_msgs::OccupancyGrid::kType, Qos::latched());
    costmap_ = *participant_->publisher(node, "/local_costmap/costmap",
                                        nav_msgs::OccupancyGrid::kType, Qos::keepLast(1));
    start_ =
        *participant_->client(node, "hunav_start_recording", hunav_msgs::StartEvaluation::kType);
    stop_ = *participant_->client(node, "hunav_stop_recording", std_srvs::Empty::kType);
    participant_->publishGraph();
    publishMap();
  }

  bool isHeard() {
    return participant_->spinUntil(
        [this] {
          return people_->matched() > 0 && robot_->matched() > 0 && map_->matched() > 0 &&
                 start_->isReady() && stop_->isReady();
        },
        kLong);
  }
  bool isCostmapHeard() const { return costmap_->matched() > 0; }

  std::optional<bool> start(const std::string& tag, int run, std::optional<base::Vec2> goal) {
    hunav_msgs::StartEvaluation::Request request;
    request.experimentTag = tag;
    request.runId = run;
    if (goal) {
      request.robotGoal.header.frameId = "map";
      request.robotGoal.pose.position.x = goal->x();
      request.robotGoal.pose.position.y = goal->y();
    }
    const std::optional<Bytes> answer = start_->call(encode(request), kLong);
    const auto response =
        answer ? decode<hunav_msgs::StartEvaluation::Response>(*answer)
               : base::Result<hunav_msgs::StartEvaluation::Response>(base::Diagnostics());
    return response ? std::optional(response->success) : std::nullopt;
  }
  bool stop() { return stop_->call(encode(std_srvs::Empty::Request()), kLong).has_value(); }

  void drive() {
    for (int k = 0; k < kSamples; ++k) {
      publish(k);
      QTest::qWait(20);  // depth 1 on the other side keeps the newest alone
    }
  }

 private:
  void publishMap() {
    nav_msgs::OccupancyGrid map;
    map.header.frameId = "map";
    map.info.resolution = 0.5F;
    map.info.width = map.info.height = 20;
    map.info.origin.position.x = map.info.origin.position.y = -5.0;
    map.data.assign(400, 0);
    map_->publish(encode(map));
  }

  void publish(int k) {
    hunav_msgs::Agents people;
    people.header.frameId = "map";
    people.header.stamp.sec = 100 + k / 10;
    people.header.stamp.nanosec = static_cast<std::uint32_t>(k % 10) * 100000000U;
    hunav_msgs::Agent person;
    person.id = 1;
    person.type = hunav_msgs::Agent::kPerson;
    person.name = "anna";
    person.radius = 0.3F;
    person.position.position.x = 1.0;
    person.position.position.y = 2.0;
    people.agents.push_back(person);
    hunav_msgs::Agent robot;
    robot.id = 0;
    robot.type = hunav_msgs::Agent::kRobot;
    robot.name = "robot1";
    robot.radius = 0.4F;
    robot.position.position.x = kStep * k;
    robot.velocity.linear.x = 1.0;
    robot.linearVel = 1.0F;
    people_->publish(encode(people));
    robot_->publish(encode(robot));
  }

  std::unique_ptr<Participant> participant_;
  std::unique_ptr<Publisher> people_, robot_, map_, costmap_;
  std::unique_ptr<Client> start_, stop_;
};

/// `hunavsim evaluate --ros2`, without Qt's timers in the way.
class Evaluator {
 public:
  explicit Evaluator(const QStringList& more) {
    process_.start(text(HUNAVSIM_PROGRAM), QStringList{text("evaluate"), text("--ros2"),
                                                       text("--domain"), QString::number(kDomain)} +
                                               more);
    isRunning_ = process_.waitForStarted();
  }
  bool isRunning() const { return isRunning_; }
  /// By Ctrl-C.
  int end() {
    ::kill(static_cast<pid_t>(process_.processId()), SIGINT);
    return exitCode();
  }
  int exitCode() {
    const bool isOver = process_.waitForFinished(30000);
    said_ = QString::fromLocal8Bit(process_.readAllStandardError());
    return isOver && process_.exitStatus() == QProcess::NormalExit ? process_.exitCode() : -1;
  }
  const QString& said() const { return said_; }

 private:
  QProcess process_;
  QString said_;
  bool isRunning_ = false;
};

double metric(const QString& folder, const char* name) {
  QFile file(folder + text("/metrics.json"));
  if (!file.open(QIODevice::ReadOnly)) {
    return std::nan("");
  }
  const QJsonObject all = QJsonDocument::fromJson(file.readAll()).object();
  return all[text("metrics")].toObject()[text(name)].toObject()[text("value")].toDouble(-1.0);
}

}  // namespace

/// A running system is recorded and measured as HuNavSim's evaluator does it.
class EvaluateSystemTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void ctrlC_measuresWhatWasHeard() {
    QTemporaryDir folder;
    const QString out = folder.filePath(text("once"));
    Evaluator evaluator({text("-o"), out, text("-q")});
    FakeSystem system;
    QVERIFY(evaluator.isRunning() && system.isHeard());
    QVERIFY(!system.isCostmapHeard());                                       // no map of the world
    QCOMPARE(system.start("exp_1", 0, std::nullopt), std::optional(false));  // it records already
    system.drive();
    QTest::qWait(300);
    QCOMPARE(evaluator.end(), 0);
    checkNumbers(out);
    checkRecording(out + text("/recording.mcap"));
  }

  void services_beginAndEndEachRecording() {
    QTemporaryDir folder;
    const QString out = folder.filePath(text("many"));
    Evaluator evaluator(
        {text("-o"), out, text("-q"), text("--by-services"), text("--layout"), text("hunav2")});
    FakeSystem system;
    QVERIFY(evaluator.isRunning() && system.isHeard());
    system.drive();  // nobody listens yet
    QCOMPARE(system.start("walk", 3, base::Vec2(1.95, 0.0)), std::optional(true));
    QCOMPARE(system.start("walk", 4, std::nullopt), std::optional(false));
    system.drive();
    QTest::qWait(300);
    QVERIFY(system.stop());
    // Within 0.2 m: at x = 1.8, in every key.
    QCOMPARE(metric(out + text("/walk_3"), "time_to_reach_goal"), 1.8);
    QCOMPARE(metric(out + text("/walk_3"), "path_length"), 1.8);
    QCOMPARE(system.start("walk", 4, std::nullopt), std::optional(true));
    system.drive();
    QTest::qWait(300);
    QVERIFY(system.stop());
    checkNumbers(out + text("/walk_4"));
    QCOMPARE(evaluator.end(), 0);
    QFile table(out + text("/metrics.csv"));
    QVERIFY(table.open(QIODevice::ReadOnly));
    QCOMPARE(table.readAll().count('\n'), 3);  // a head and two recordings
  }

  void tag_thatLeavesTheFolder_isRefused() {
    QTemporaryDir folder;
    const QString out = folder.filePath(text("a/b"));
    Evaluator evaluator({text("-o"), out, text("-q"), text("--by-services")});
    FakeSystem system;
    QVERIFY(evaluator.isRunning() && system.isHeard());
    for (const char* tag : {"../x", "/tmp/x", "", ".hidden", "a/b"}) {
      QCOMPARE(system.start(tag, 1, std::nullopt), std::optional(false));
    }
    QCOMPARE(evaluator.end(), 0);
    QVERIFY2(evaluator.said().contains(text("cannot start '../x'")), qPrintable(evaluator.said()));
    QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).size(), 0);
  }

  void recording_withoutARobot_isKeptAndTold() {
    QTemporaryDir folder;
    const QString out = folder.filePath(text("empty"));
    Evaluator evaluator({text("-o"), out, text("--duration"), text("1")});
    QVERIFY(evaluator.isRunning());
    QCOMPARE(evaluator.exitCode(), 2);
    QVERIFY2(evaluator.said().contains(text("recording is kept")), qPrintable(evaluator.said()));
    QVERIFY(bridge::isBag((out + text("/recording.mcap")).toStdString()));
  }

  void recorder_noOtherParticipant_warnsOnce() {
    constexpr int kEmptyDomain = 64;
    base::Diagnostics reported;
    bridge::RecorderSettings settings;
    settings.domain = inDomain(kEmptyDomain);
    const auto recorder = bridge::Recorder::create(
        settings, {[](const bridge::RecordingRequest&) { return true; }, [] {}},
        [&](const base::Diagnostic& problem) { reported.push_back(problem); });
    QVERIFY(recorder);
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < Milliseconds(6500)) {
      (*recorder)->spin(Milliseconds(20));
    }
    QCOMPARE(reported.size(), std::size_t{1});
    QCOMPARE(reported[0].code, std::string_view("ros2.no-peer-here"));
  }

 private:
  static void checkNumbers(const QString& folder) {
    QVERIFY2(std::abs(metric(folder, "path_length") - 2.0) < 1e-6,
             qPrintable(QString::number(metric(folder, "path_length"))));
    QVERIFY(std::abs(metric(folder, "total_time") - 2.0) < 1e-6);
    // Closest at x = 1: 2 m between the centres less 0.3 m and 0.4 m.
    QVERIFY2(std::abs(metric(folder, "minimum_distance_to_people") - 1.3) < 1e-6,
             qPrintable(QString::number(metric(folder, "minimum_distance_to_people"))));
  }

  static void checkRecording(const QString& path) {
    const auto bag = bridge::openBag(path.toStdString());
    QVERIFY(bag);
    std::vector<std::string> topics;
    for (const bridge::BagChannel& channel : (*bag)->channels()) {
      topics.push_back(channel.topic);
    }
    std::sort(topics.begin(), topics.end());
    QCOMPARE(topics, (std::vector<std::string>{"/human_states", "/map", "/robot_states"}));
  }
};

QTEST_GUILESS_MAIN(EvaluateSystemTest)
#include "tst_EvaluateSystem.moc"
