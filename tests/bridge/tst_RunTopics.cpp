#include <cmath>
#include <map>

#include <QtTest>

#include "app/bridge/messages/AllMessages.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/topics/RunMessages.h"
#include "app/bridge/topics/RunTopics.h"

using namespace bridge;

namespace {

sim2d::TraceHeader smallHeader() {
  sim2d::TraceHeader header;
  sim2d::TraceHuman anna;
  anna.id = 7;
  anna.name = "anna";
  anna.radius = 0.25;
  anna.desiredSpeed = 1.5;
  anna.behavior = 4;
  anna.cyclicGoals = true;
  anna.goals = {{1, {1.0, 2.0}, 0.5}, {2, {3.0, 4.0}, 0.5}, {3, {5.0, 6.0}, 0.5}};
  anna.parameters = {{"duration", 40.0}, {"once", 1.0}, {"social_force_factor", 5.0}};
  header.humans = {anna};
  sim2d::TraceRobot robot;
  robot.name = "robot1";
  robot.radius = 0.5;
  robot.goals = {{0, {8.0, 3.5}, 0.25}};
  header.robots = {robot};
  header.map = sim2d::OccupancyGrid(2, 1, 0.05, {{-1.0, -2.0}, 0.0}, {100, 0});
  header.obstacles = {{"box1", false, false, {}, {{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}}}}};
  return header;
}

/// Anna walks to her second goal, the robot looks to the left (up) and drives so.
sim2d::Frame smallFrame() {
  sim2d::Frame frame;
  frame.step = 250;
  frame.time = 12.5;
  frame.humans.add(7, {{1.5, -2.0}, base::kPi / 2.0}, {0.0, 0.75}, 0.25, 2);
  frame.humans.group.push_back(-1);
  frame.humans.state.push_back(1);
  frame.robots.add(-1, {{3.0, 4.0}, base::kPi / 2.0}, {0.0, 0.5}, 0.125, 0);
  return frame;
}

/// What was sent, by the name of the topic; messages of one topic in their order.
std::map<std::string, std::vector<std::string>> toldBy(RunTopics& topics,
                                                       const sim2d::Frame& frame) {
  std::map<std::string, std::vector<std::string>> all;
  topics.publish(frame, [&](std::size_t topic, std::string bytes) {
    all[topics.topics()[topic].name].push_back(std::move(bytes));
  });
  return all;
}

template <class M>
M read(const std::string& bytes) {
  const base::Result<M> message = decode<M>(bytes);
  return message ? *message : M{};
}

}  // namespace

class RunTopicsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void stampOf_isExact() {
    QCOMPARE(stampOf(12.5).sec, 12);
    QCOMPARE(stampOf(12.5).nanosec, 500000000U);
    QCOMPARE(stampOf(0.55).nanosec, 550000000U);
    QCOMPARE(stampOf(-0.25).sec, -1);
    QCOMPARE(stampOf(-0.25).nanosec, 750000000U);
    QCOMPARE(nanosecondsOf(0.15), std::int64_t{150000000});
  }

  void headings_comeBackFromQuaternions() {
    QCOMPARE(quaternionFromYaw(0.0).w, 1.0);
    QVERIFY(std::abs(quaternionFromYaw(base::kPi / 2.0).z - std::sqrt(0.5)) < 1e-15);
    for (const double heading : {-3.1, -1.0, 0.0, 0.3, 2.0, 3.14159}) {
      QVERIFY(std::abs(headingOf(quaternionFromYaw(heading)) - heading) < 1e-14);
    }
  }

  void setAgents_tellsWhatIsKnown() {
    hunav_msgs::Agents all;
    setAgents(smallHeader(), smallFrame(), all);
    QCOMPARE(all.header.frameId, std::string("map"));
    QCOMPARE(all.agents.size(), std::size_t{1});
    const hunav_msgs::Agent& anna = all.agents.front();
    QCOMPARE(anna.id, 7);
    QCOMPARE(anna.type, std::uint8_t{1});
    QCOMPARE(anna.groupId, std::int8_t{-1});
    QCOMPARE(anna.position.position.x, 1.5);
    QCOMPARE(anna.velocity.linear.y, 0.75);
    QCOMPARE(anna.linearVel, 0.75F);
    QCOMPARE(anna.angularVel, 0.25F);
    QCOMPARE(anna.behavior.type, hunav_msgs::AgentBehavior::kBehScared);
    QCOMPARE(anna.behavior.state, std::uint8_t{1});
    QCOMPARE(anna.behavior.duration, 40.0F);
    QVERIFY(anna.behavior.once);
    QCOMPARE(anna.behavior.socialForceFactor, 5.0F);
    QCOMPARE(anna.goals.size(), std::size_t{3});  // the second is the current one: 2, 3, 1
    QCOMPARE(anna.goals[0].position.x, 3.0);
    QCOMPARE(anna.goals[2].position.x, 1.0);
    QCOMPARE(anna.goalRadius, 0.5F);
  }

  void robotOf_isARobotWithItsGoal() {
    const hunav_msgs::Agent robot = robotOf(smallHeader(), smallFrame(), 0);
    QCOMPARE(robot.id, -1);
    QCOMPARE(robot.type, hunav_msgs::Agent::kRobot);
    QCOMPARE(robot.name, std::string("robot1"));
    QCOMPARE(robot.radius, 0.5F);
    QCOMPARE(robot.goals.size(), std::size_t{1});
    QCOMPARE(robot.goals[0].position.y, 3.5);
    QCOMPARE(robot.goalRadius, 0.25F);
  }

  void odometryOf_hasTheTwistInTheRobotsFrame() {
    const nav_msgs::Odometry odometry =
        odometryOf(smallFrame(), 0, {{3.0, 4.0}, base::kPi / 2.0}, "odom", "base_footprint");
    QVERIFY(std::abs(odometry.twist.twist.linear.x - 0.5) < 1e-15);  // it drives as it looks
    QVERIFY(std::abs(odometry.twist.twist.linear.y) < 1e-15);
    QCOMPARE(odometry.twist.twist.angular.z, 0.125);
    QCOMPARE(odometry.pose.pose.position.x, 3.0);
  }

  void scanOf_hasInfinityWhereNothingIsHit() {
    sim2d::RobotTelemetry::Scan scan;
    scan.time = 1.5;
    scan.angleMin = -1.0;
    scan.angleIncrement = 0.5;
    scan.range = 10.0;
    scan.distances = {1.0, 2.5, 10.0, 4.0, 10.0};
    const sensor_msgs::LaserScan message = scanOf(scan, 0.1, "base_scan");
    QCOMPARE(message.angleMin, -1.0F);
    QCOMPARE(message.angleMax, 1.0F);
    QCOMPARE(message.ranges.size(), std::size_t{5});
    QCOMPARE(message.ranges[1], 2.5F);
    QVERIFY(std::isinf(message.ranges[2]));
    QCOMPARE(message.header.stamp.nanosec, 500000000U);
  }

  /// Messages are made in the memory of those of before, of which nothing may be left.
  void tell_saysNothingOfStatesBefore() {
    sim2d::Frame crowd = smallFrame();
    crowd.humans.add(8, {{2.5, 1.0}, 0.5}, {1.0, 0.0}, 0.0, 0);  // not in the header
    crowd.humans.group.push_back(3);
    crowd.humans.state.push_back(0);
    sim2d::Frame stranger;  // stands where Anna was
    stranger.time = 12.6;
    stranger.humans.add(9, {{4.0, 2.0}, 0.0}, {0.0, 0.0}, 0.0, 0);
    stranger.humans.group.push_back(-1);
    stranger.humans.state.push_back(0);
    sim2d::Frame last = smallFrame();  // at her last goal, standing
    last.humans.goal[0] = 3;
    last.humans.vy[0] = 0.0;
    last.robots.vy[0] = 0.0;
    RunTopics topics(smallHeader());
    for (const sim2d::Frame& frame : {smallFrame(), crowd, stranger, last, crowd}) {
      auto again = toldBy(topics, frame);
      RunTopics fresh(smallHeader());
      auto first = toldBy(fresh, frame);
      for (const char* name : {"/tf", "/markers", "/human_states", "/people"}) {
        QCOMPARE(again[name].size(), std::size_t{1});
        QVERIFY2(again[name] == first[name], name);
      }
    }
  }

  void tell_sendsWhatIsLatchedOnce() {
    RunTopics topics(smallHeader());
    const auto first = toldBy(topics, smallFrame());
    for (const char* name : {"/clock", "/tf", "/tf_static", "/map", "/obstacles", "/markers",
                             "/human_states", "/people", "/robot_states", "/odom", "/goal_pose"}) {
      QVERIFY2(first.count(name) == 1, name);
    }
    QVERIFY(first.count("/scan") == 0);  // nobody saw one
    QVERIFY(first.count("/plan") == 0);
    sim2d::Frame later = smallFrame();
    later.time = 12.55;
    const auto second = toldBy(topics, later);
    for (const char* name : {"/tf_static", "/map", "/obstacles", "/goal_pose"}) {
      QVERIFY2(second.count(name) == 0, name);
    }
    QVERIFY(second.count("/human_states") == 1);
    later.robotPaths = {{{0.0, 0.0}, {1.0, 0.0}}};
    QVERIFY(toldBy(topics, later).count("/plan") == 1);
    later.time = 12.6;
    QVERIFY(toldBy(topics, later).count("/plan") == 0);  // the same way
    later.robotPaths.clear();
    QVERIFY(toldBy(topics, later).count("/plan") == 1);  // there is none any more
  }

  void tell_map_isThatOfTheRun() {
    RunTopics topics(smallHeader());
    const auto map = read<nav_msgs::OccupancyGrid>(toldBy(topics, smallFrame()).at("/map").front());
    QCOMPARE(map.info.width, 2U);
    QCOMPARE(map.info.height, 1U);
    QCOMPARE(map.info.origin.position.y, -2.0);
    QCOMPARE(map.data, (std::vector<std::int8_t>{100, 0}));
  }

  void tell_transforms_areATree() {
    RunTopicsOptions options;
    options.lidarMounts = {base::Pose2{{0.25, 0.0}, 0.0}};
    RunTopics topics(smallHeader(), options);
    sim2d::Frame frame = smallFrame();
    auto senses = std::make_shared<std::vector<sim2d::RobotTelemetry>>(1);
    senses->front().believed = {{3.5, 4.0}, base::kPi / 2.0};  // half a metre wrong
    frame.senses = senses;
    auto told = toldBy(topics, frame);
    std::map<std::string, geometry_msgs::TransformStamped> byChild;
    for (const char* name : {"/tf", "/tf_static"}) {
      for (const auto& each : read<tf2_msgs::TFMessage>(told.at(name).front()).transforms) {
        byChild[each.childFrameId] = each;
      }
    }
    QCOMPARE(byChild.at("anna").header.frameId, std::string("map"));
    QCOMPARE(byChild.at("odom").header.frameId, std::string("map"));
    QVERIFY(std::abs(byChild.at("odom").transform.translation.x + 0.5) < 1e-12);
    QCOMPARE(byChild.at("base_footprint").header.frameId, std::string("odom"));
    QCOMPARE(byChild.at("base_footprint").transform.translation.x, 3.5);
    QCOMPARE(byChild.at("base_link").header.frameId, std::string("base_footprint"));
    QCOMPARE(byChild.at("base_scan").header.frameId, std::string("base_link"));
    QCOMPARE(byChild.at("base_scan").transform.translation.x, 0.25);
  }

  /// map -> odom is (1, 2), turned by a right angle; the estimate (0.5, 5) of it is (3, 0.5) in
  /// odom.
  void tell_transformsOfALocalizer_areItsOwn() {
    RunTopics topics(smallHeader());
    sim2d::Frame frame = smallFrame();
    auto senses = std::make_shared<std::vector<sim2d::RobotTelemetry>>(1);
    senses->front().believed = {{0.5, 5.0}, 0.0};
    senses->front().localizer = {true, {{1.0, 2.0}, base::kPi / 2.0}};
    frame.senses = senses;
    auto told = toldBy(topics, frame);
    std::map<std::string, geometry_msgs::TransformStamped> byChild;
    for (const auto& each : read<tf2_msgs::TFMessage>(told.at("/tf").front()).transforms) {
      byChild[each.childFrameId] = each;
    }
    QCOMPARE(byChild.at("odom").transform.translation.x, 1.0);
    QCOMPARE(byChild.at("odom").transform.translation.y, 2.0);
    QVERIFY(std::abs(byChild.at("odom").transform.rotation.z - std::sqrt(0.5)) < 1e-12);
    QVERIFY(std::abs(byChild.at("base_footprint").transform.translation.x - 3.0) < 1e-12);
    QVERIFY(std::abs(byChild.at("base_footprint").transform.translation.y - 0.5) < 1e-12);
    const auto odometry = read<nav_msgs::Odometry>(told.at("/odom").front());
    QVERIFY(std::abs(odometry.pose.pose.position.x - 3.0) < 1e-12);
    senses->front().localizer->isLocalized = false;  // before the initial pose
    told = toldBy(topics, frame);
    for (const auto& each : read<tf2_msgs::TFMessage>(told.at("/tf").front()).transforms) {
      QVERIFY(each.childFrameId != "odom");
    }
  }

  void tell_scan_comesOncePerTurn() {
    RunTopics topics(smallHeader());
    sim2d::Frame frame = smallFrame();
    sim2d::RobotTelemetry::Scan scan;
    scan.time = 12.45;
    scan.distances = {1.0, 2.0};
    frame.scans = {{249, -1, scan}};
    const auto told = toldBy(topics, frame);
    QVERIFY(told.count("/scan") == 1);
    QCOMPARE(told.at("/tf").size(), std::size_t{2});  // and where the sensor was
    QVERIFY(toldBy(topics, frame).count("/scan") == 0);
    frame.scans.front().scan.time = 12.55;
    QVERIFY(toldBy(topics, frame).count("/scan") == 1);
  }

  void tell_scanForLater_isMadeForWhoHearsIt() {
    RunTopicsOptions options;
    options.lidarMounts = {base::Pose2{}};  // else /tf tells where it sits
    RunTopics topics(smallHeader(), options);
    sim2d::RobotTelemetry::Scan scan;
    scan.distances = {1.0, 2.0};
    int made = 0;
    int told = 0;
    const auto tell = [&](double time, bool isLater, bool isHeard) {
      sim2d::RobotTelemetry senses;
      scan.time = time;
      if (isLater) {
        senses.deferredScan = std::make_shared<const sim2d::RobotTelemetry::DeferredScan>(
            sim2d::RobotTelemetry::DeferredScan{time, [&]() -> const sim2d::RobotTelemetry::Scan& {
                                                  ++made;
                                                  return scan;
                                                }});
      } else {
        senses.scan = scan;
      }
      sim2d::Frame frame = smallFrame();
      frame.senses = std::make_shared<const std::vector<sim2d::RobotTelemetry>>(1, senses);
      const auto isScan = [&](std::size_t topic) { return topics.topics()[topic].name == "/scan"; };
      topics.publish(
          frame, [&](std::size_t topic, const std::string&) { told += isScan(topic) ? 1 : 0; },
          [&](std::size_t topic) { return isHeard || !isScan(topic); });
    };
    tell(12.45, true, false);
    QCOMPARE(made, 0);
    tell(12.55, true, true);
    tell(12.55, true, true);   // the same turn
    tell(12.55, false, true);  // a planner has looked at it meanwhile
    QCOMPARE(made, 1);
    QCOMPARE(told, 1);
    tell(12.65, false, true);
    QCOMPARE(told, 2);
  }

  void tell_markers_takeTheOldAwayFirst() {
    RunTopics topics(smallHeader());
    const auto told = toldBy(topics, smallFrame());
    const auto all = read<visualization_msgs::MarkerArray>(told.at("/markers").front());
    QCOMPARE(all.markers.front().action, visualization_msgs::Marker::kDeleteall);
    QCOMPARE(all.markers.size(), std::size_t{7});  // and body, arrow, name of two
    QCOMPARE(all.markers[1].type, visualization_msgs::Marker::kCylinder);
    QCOMPARE(all.markers[1].scale.x, 0.5);
    QCOMPARE(all.markers[3].text, std::string("anna"));
    const auto walls = read<visualization_msgs::MarkerArray>(told.at("/obstacles").front());
    QCOMPARE(walls.markers.size(), std::size_t{2});
    QCOMPARE(walls.markers[1].points.size(), std::size_t{4});  // closed
  }

  void tell_onlyWhatIsWanted() {
    RunTopics topics(smallHeader());
    std::vector<std::string> sent;
    topics.publish(
        smallFrame(),
        [&](std::size_t topic, const std::string& /*bytes*/) {
          sent.push_back(topics.topics()[topic].name);
        },
        [&](std::size_t topic) { return topics.topics()[topic].name == "/people"; });
    QCOMPARE(sent, std::vector<std::string>{"/people"});
  }

  void topics_ofFurtherRobots_haveTheirNames() {
    sim2d::TraceHeader header = smallHeader();
    header.robots.push_back(header.robots.front());
    header.robots.back().id = -2;
    header.robots.back().name = "robot2";
    header.robots.back().goals.clear();
    sim2d::Frame frame = smallFrame();
    frame.robots.add(-2, {{0.0, 0.0}, 0.0}, {0.0, 0.0}, 0.0, sim2d::kNoGoal);
    RunTopics topics(header);
    const auto told = toldBy(topics, frame);
    QCOMPARE(read<hunav_msgs::Agent>(told.at("/robot2/robot_states").front()).id, -2);
    QCOMPARE(read<nav_msgs::Odometry>(told.at("/robot2/odom").front()).childFrameId,
             std::string("robot2/base_footprint"));
    QVERIFY(told.count("/robot2/goal_pose") == 0);
  }

  void goals_thatArePlainPoints_areToldUntilTheyArePassed() {
    sim2d::TraceHeader header = smallHeader();
    header.robots.front().goals = {{0, {4.0, 1.0}, 0.3}, {0, {5.0, 2.0}, 0.3}};
    sim2d::Frame frame = smallFrame();
    frame.robots.goal.front() = sim2d::kNoGoal;  // they have no id
    RunTopics topics(header);
    toldBy(topics, frame);
    QVERIFY(topics.goalOf(0) != nullptr);
    QCOMPARE(topics.goalOf(0)->position.x(), 4.0);
    sim2d::Event event;
    event.kind = sim2d::EventKind::Goal;
    event.id = -1;
    topics.track(event);
    const auto second = toldBy(topics, frame);
    QCOMPARE(read<geometry_msgs::PoseStamped>(second.at("/goal_pose").front()).pose.position.x,
             5.0);
    topics.track(event);
    toldBy(topics, frame);
    QVERIFY(topics.goalOf(0) == nullptr);
  }

  /// From outside: those of the header are given up, also when it has arrived.
  void goals_thatAreOrdered_areToldUntilTheRobotArrives() {
    sim2d::TraceHeader header = smallHeader();
    header.robots.front().goals = {{0, {4.0, 1.0}, 0.3}, {0, {5.0, 2.0}, 0.3}};
    sim2d::Frame frame = smallFrame();
    frame.robots.goal.front() = sim2d::kNoGoal;
    sim2d::Input order;
    order.kind = sim2d::InputKind::Goal;
    order.id = -1;
    order.pose.position = {-1.5, 0.5};
    frame.inputs = {order};
    RunTopics topics(header);
    topics.track(frame);
    const auto first = toldBy(topics, frame);
    QCOMPARE(read<geometry_msgs::PoseStamped>(first.at("/goal_pose").front()).pose.position.x,
             -1.5);
    sim2d::Event event;
    event.kind = sim2d::EventKind::Goal;
    event.id = -1;
    frame.inputs.clear();
    frame.events = {event};
    frame.events.push_back(event);
    frame.events.back().kind = sim2d::EventKind::Arrived;
    topics.track(frame);
    toldBy(topics, frame);
    QVERIFY(topics.goalOf(0) == nullptr);
  }
};

QTEST_APPLESS_MAIN(RunTopicsTest)
#include "tst_RunTopics.moc"
