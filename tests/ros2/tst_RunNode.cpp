#include <cmath>

#include <QtTest>

#include "app/bridge/messages/nav_msgs.h"
#include "app/bridge/messages/rosgraph_msgs.h"
#include "app/bridge/messages/sensor_msgs.h"
#include "app/bridge/messages/tf2_msgs.h"
#include "app/bridge/nodes/Node.h"
#include "app/bridge/nodes/RunNode.h"
#include "tests/agents/Caller.h"
#include "tests/ros2/Ros2Test.h"

using namespace ros2test;

namespace {

constexpr int kDomain = 30;

sim2d::Scenario driven(const char* planner) {
  sim2d::Scenario scenario = agentstest::oneWalker();
  sim2d::Robot& robot = agentstest::addRobot(scenario, {-3.0, 2.0});
  robot.planner = planner;
  robot.maxAcc = 2.0;
  robot.lidar.beams = 90;
  robot.lidar.rate = 10.0;
  return scenario;
}

/// A world, its node and somebody who hears and drives it.
struct Drive {
  explicit Drive(bool stamped, const char* planner = "ros2") {
    const sim2d::Scenario scenario = driven(planner);
    verdict = app::check(agentstest::bundleOf(scenario));
    if (verdict.world == nullptr) {
      return;
    }
    verdict.world->enableScans(true);
    auto made = RunNode::create(verdict.world->header(), lidarsOf(scenario),
                                {inDomain(kDomain), stamped, false},
                                [this](const base::Diagnostic& said) { told.push_back(said); });
    run = made ? *std::move(made) : nullptr;
    other = participant(inDomain(kDomain));
    node = other->addNode("/", "driver");
  }
  template <class M>
  std::unique_ptr<Subscription> hear(const char* topic, const Qos& qos,
                                     std::function<void(const M&)> take) {
    return ros2test::hear<M>(*other, node, topic, qos, take);
  }
  bool step() {
    run->reportRejected(verdict.world->refused());
    run->publishState(verdict.world->frame());
    return verdict.world->step(run->inputs(verdict.world->frame()));
  }
  double robotX() const { return verdict.world->frame().robots.x.at(0); }

  app::Verdict verdict;
  base::Diagnostics told;
  std::unique_ptr<RunNode> run;
  std::unique_ptr<Participant> other;
  int node = 0;
};

void addReliabilities() {
  QTest::addColumn<bool>("reliable");
  QTest::newRow("reliable") << true;
  QTest::newRow("best effort") << false;
}

}  // namespace

/// A run on topics, whose robot somebody else drives.
class RunNodeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void run_commandsOfOthers_driveTheRobot_data() {
    QTest::addColumn<bool>("stamped");
    QTest::addColumn<bool>("reliable");
    QTest::newRow("Twist") << false << true;
    QTest::newRow("TwistStamped") << true << true;
    QTest::newRow("Twist, best effort") << false << false;
    QTest::newRow("TwistStamped, best effort") << true << false;
  }

  void run_commandsOfOthers_driveTheRobot() {
    QFETCH(const bool, stamped);
    QFETCH(const bool, reliable);
    Drive drive(stamped);
    QVERIFY(drive.run && drive.verdict.world);
    double clock = -1.0;
    nav_msgs::Odometry odometry;
    std::size_t beams = 0;
    int fixed = 0;
    const auto clocks = drive.hear<rosgraph_msgs::Clock>(
        "/clock", Qos::clockReader(),
        [&](const rosgraph_msgs::Clock& now) { clock = now.clock.sec + 1e-9 * now.clock.nanosec; });
    const auto odometries = drive.hear<nav_msgs::Odometry>(
        "/odom", Qos(), [&](const nav_msgs::Odometry& now) { odometry = now; });
    const auto scans = drive.hear<sensor_msgs::LaserScan>(
        "/scan", Qos::sensor(),
        [&](const sensor_msgs::LaserScan& scan) { beams = scan.ranges.size(); });
    geometry_msgs::Twist twist;
    twist.linear.x = 0.4;
    geometry_msgs::TwistStamped withStamp;
    withStamp.twist = twist;
    const auto commands = drive.other->publisher(
        drive.node, "/cmd_vel",
        stamped ? geometry_msgs::TwistStamped::kType : geometry_msgs::Twist::kType,
        reliable ? Qos() : Qos::sensor());
    QVERIFY(clocks && odometries && scans && commands);
    for (int k = 0; k < 20; ++k) {
      QVERIFY(drive.step());
    }
    QCOMPARE(drive.robotX(), -3.0);  // it stands until somebody drives it
    // Who comes late still gets what is latched.
    const auto transforms = drive.hear<tf2_msgs::TFMessage>(
        "/tf_static", Qos::latched(),
        [&](const tf2_msgs::TFMessage& all) { fixed = static_cast<int>(all.transforms.size()); });
    const auto until = std::chrono::steady_clock::now() + kLong;
    while ((drive.robotX() < -2.5 || fixed == 0 || beams == 0) &&
           std::chrono::steady_clock::now() < until) {
      (*commands)->publish(stamped ? encode(withStamp) : encode(twist));
      drive.other->spin(Milliseconds(5));
      QVERIFY(drive.step());
    }
    while (drive.other->spin(Milliseconds(50))) {  // what is still on its way
    }
    QVERIFY(drive.robotX() >= -2.5);
    QVERIFY(drive.run->commands() > 0);
    QCOMPARE(fixed, 2);  // base_footprint -> base_link -> base_scan
    QCOMPARE(beams, std::size_t{90});
    QVERIFY(std::fabs(odometry.twist.twist.linear.x - 0.4) < 1e-6);
    QVERIFY(clock > 1.0);
    QVERIFY(std::fabs(odometry.header.stamp.sec + 1e-9 * odometry.header.stamp.nanosec - clock) <
            0.2);
    const double timeout = drive.verdict.world->time() + 2.0;
    while (drive.verdict.world->time() < timeout) {  // nobody drives: it stops after 1 s
      QVERIFY(drive.step());
    }
    const double stands = drive.robotX();
    QVERIFY(drive.step());
    QCOMPARE(drive.robotX(), stands);
  }

  void run_badCommand_isLeftOutAndTold() {
    Drive drive(false);
    QVERIFY(drive.run && drive.verdict.world);
    geometry_msgs::Twist bad;
    bad.linear.x = std::nan("");
    const auto commands =
        drive.other->publisher(drive.node, "/cmd_vel", geometry_msgs::Twist::kType, Qos());
    const auto until = std::chrono::steady_clock::now() + kLong;
    while (drive.told.empty() && std::chrono::steady_clock::now() < until) {
      (*commands)->publish(encode(bad));
      drive.other->spin(Milliseconds(5));
      QVERIFY(drive.step());
    }
    QVERIFY(agentstest::hasRemark(drive.told, "ros2.bad-message"));
    QCOMPARE(drive.robotX(), -3.0);
    const std::size_t before = drive.told.size();
    for (int k = 0; k < 20; ++k) {
      (*commands)->publish(encode(bad));
      QVERIFY(drive.step());
    }
    QCOMPARE(drive.told.size(), before);
  }

  void run_initialPose_putsTheRobotThere_data() { addReliabilities(); }

  void run_initialPose_putsTheRobotThere() {
    QFETCH(const bool, reliable);
    Drive drive(false);
    QVERIFY(drive.run && drive.verdict.world);
    using Pose = geometry_msgs::PoseWithCovarianceStamped;
    const auto poses = drive.other->publisher(drive.node, "/initialpose", Pose::kType,
                                              reliable ? Qos() : Qos::sensor());
    Pose pose;
    pose.header.frameId = "odom";
    pose.pose.pose.position = {1.0, -2.0, 0.0};
    pose.pose.pose.orientation = {0.0, 0.0, std::sin(0.6), std::cos(0.6)};
    const auto until = std::chrono::steady_clock::now() + kLong;
    const auto publishUntil = [&](const std::function<bool()>& isDone) {
      while (!isDone() && std::chrono::steady_clock::now() < until) {
        (*poses)->publish(encode(pose));
        drive.other->spin(Milliseconds(5));
        QVERIFY(drive.step());
      }
    };
    publishUntil([&] { return !drive.told.empty(); });
    QVERIFY(agentstest::hasRemark(drive.told, "ros2.bad-message"));
    QCOMPARE(drive.robotX(), -3.0);
    pose.header.frameId = "map";
    publishUntil([&] { return drive.robotX() > 0.0; });
    const sim2d::RobotColumns& robots = drive.verdict.world->frame().robots;
    QCOMPARE(robots.x[0], 1.0);
    QCOMPARE(robots.y[0], -2.0);
    QVERIFY(std::fabs(robots.heading[0] - 1.2) < 1e-12);
    pose.pose.pose.position.x = 1e12;  // the world does not go so far
    publishUntil([&] { return agentstest::hasRemark(drive.told, "world.refused-input"); });
    QVERIFY(agentstest::hasRemark(drive.told, "world.refused-input"));
    QCOMPARE(drive.robotX(), 1.0);
  }

  void run_goalPose_isWhereOurPlannerDrives_data() { addReliabilities(); }

  /// The robot of a planner of ours, without a goal in the scenario. The order is not told again:
  /// Nav2 would take it for another one.
  void run_goalPose_isWhereOurPlannerDrives() {
    QFETCH(const bool, reliable);
    Drive drive(false, "pursuit");
    QVERIFY(drive.run && drive.verdict.world);
    using Pose = geometry_msgs::PoseStamped;
    double toldX = 0.0;
    const auto hears = drive.hear<Pose>("/goal_pose", Qos::latched(),
                                        [&](const Pose& pose) { toldX = pose.pose.position.x; });
    const auto orders = drive.other->publisher(drive.node, "/goal_pose", Pose::kType,
                                               reliable ? Qos() : Qos::sensor());
    QVERIFY(hears && orders);
    for (int k = 0; k < 20; ++k) {
      QVERIFY(drive.step());
    }
    QCOMPARE(drive.robotX(), -3.0);
    Pose order;
    order.header.frameId = "map";
    order.pose.position = {1.0, 2.0, 0.0};
    std::size_t given = 0;
    const auto until = std::chrono::steady_clock::now() + kLong;
    while (!drive.verdict.world->arrivedAt() && std::chrono::steady_clock::now() < until) {
      if (given == 0) {
        (*orders)->publish(encode(order));
      }
      drive.other->spin(Milliseconds(5));
      QVERIFY(drive.step());
      given += drive.verdict.world->frame().inputs.size();
    }
    QVERIFY(drive.verdict.world->arrivedAt().has_value());
    QVERIFY(std::fabs(drive.robotX() - 1.0) < 0.5);
    QCOMPARE(toldX, 0.0);
    QVERIFY(given > 0 && given < 20);  // those that were on their way before the first one acted
  }

  void run_noOtherParticipant_isToldOnce_data() {
    QTest::addColumn<bool>("isAlone");
    QTest::newRow("alone") << true;
    QTest::newRow("with another one") << false;
  }

  void run_noOtherParticipant_isToldOnce() {
    QFETCH(const bool, isAlone);
    Drive drive(false);
    QVERIFY(drive.run && drive.verdict.world);
    if (isAlone) {  // in an empty domain
      constexpr int kEmptyDomain = 61;
      drive.run =
          *RunNode::create(drive.verdict.world->header(), {}, {inDomain(kEmptyDomain)},
                           [&](const base::Diagnostic& said) { drive.told.push_back(said); });
    }
    DomainSettings onNetwork = inDomain(62);
    const auto nobody = participant(onNetwork);
    onNetwork.localhostOnly = false;
    NoPeerCheck withNetwork(onNetwork);  // of a participant on loopback: only the text differs
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < Milliseconds(6500)) {
      QVERIFY(drive.step());
      drive.other->spin(Milliseconds(20));
      if (std::chrono::steady_clock::now() - begin < Milliseconds(4500)) {
        QVERIFY(drive.told.empty());
      }
    }
    QCOMPARE(drive.told.size(), std::size_t{isAlone ? 1U : 0U});
    const auto ofNetwork = withNetwork.check(*nobody);
    QVERIFY(ofNetwork && ofNetwork->code == std::string_view("ros2.no-peer-on-network"));
    QVERIFY(ofNetwork->message.find("--network") == std::string::npos);
    QVERIFY(!withNetwork.check(*nobody));
    if (isAlone) {
      QCOMPARE(drive.told[0].code, std::string_view("ros2.no-peer-here"));
      for (const char* reason : {"domain 61", "--network", "ROS_DOMAIN_ID", "interface"}) {
        QVERIFY2(drive.told[0].message.find(reason) != std::string::npos, reason);
      }
    }
  }
};

QTEST_APPLESS_MAIN(RunNodeTest)
#include "tst_RunNode.moc"
