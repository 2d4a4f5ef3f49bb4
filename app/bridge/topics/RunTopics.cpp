#include "app/bridge/topics/RunTopics.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "app/bridge/messages/rosgraph_msgs.h"
#include "app/bridge/topics/RunMessages.h"
#include "sim2d/base/Find.h"
#include "sim2d/nav/Body.h"
#include "sim2d/scenario/ResolvedValues.h"

namespace bridge {
namespace {

constexpr const char* kFootprint = "base_footprint";
constexpr const char* kBase = "base_link";
constexpr const char* kOdometry = "odom";
constexpr const char* kSensor = "base_scan";
constexpr double kTimeSlack = 1e-9;  // [s]
constexpr int kDepthOfTf = 100;
constexpr int kDepthOfStates = 1;  // as in HuNavSim

template <class M>
Topic topic(std::string name, int depth = 10) {
  return {std::move(name), M::kType, false, depth};
}

template <class M>
Topic latchedTopic(std::string name) {
  return {std::move(name), M::kType, true, 1};
}

/// The goal with this id. A plain point has no id: then the next goal after the reached ones.
const sim2d::TraceGoal* goalIn(const std::vector<sim2d::TraceGoal>& goals, int id,
                               std::size_t passed) {
  if (id == sim2d::kNoGoal) {
    return passed < goals.size() && goals[passed].id <= 0 ? &goals[passed] : nullptr;
  }
  return base::findBy(goals, &sim2d::TraceGoal::id, id);
}

/// The transform from `parent` to `child` at `seconds` of simulation time.
geometry_msgs::TransformStamped transformTo(double seconds, const std::string& parent,
                                            const std::string& child, const base::Pose2& pose) {
  return {headerOf(seconds, parent), child, transformOf(pose)};
}

}  // namespace

RunTopicsOptions lidarsOf(const sim2d::Scenario& scenario) {
  RunTopicsOptions options;
  int id = -1;
  sim2d::forEachListed(scenario.robots, [&](const sim2d::Robot& robot) {
    const sim2d::LidarParameters lidar = sim2d::resolveRobot(scenario, robot, id).lidar;
    options.lidarMounts.emplace_back(lidar.mount);
    options.lidarRates.push_back(lidar.rate);
    --id;
  });
  return options;
}

RunTopics::RunTopics(sim2d::TraceHeader header, RunTopicsOptions options)
    : header_(std::move(header)), options_(std::move(options)) {
  addTopics();
  latched_.resize(topics_.size());
  unstamped_.resize(topics_.size());
  lengths_.resize(topics_.size());
}

void RunTopics::addTopics() {
  topics_.resize(CommonTopicCount);
  topics_[Clock] = topic<rosgraph_msgs::Clock>("/clock");
  topics_[Tf] = topic<tf2_msgs::TFMessage>("/tf", kDepthOfTf);
  topics_[TfStatic] = latchedTopic<tf2_msgs::TFMessage>("/tf_static");
  topics_[Map] = latchedTopic<nav_msgs::OccupancyGrid>("/map");
  topics_[Obstacles] = latchedTopic<visualization_msgs::MarkerArray>("/obstacles");
  topics_[Markers] = topic<visualization_msgs::MarkerArray>("/markers");
  topics_[HumanStates] = topic<hunav_msgs::Agents>("/human_states", kDepthOfStates);
  topics_[People] = topic<people_msgs::People>("/people", kDepthOfStates);
  for (std::size_t k = 0; k < header_.robots.size(); ++k) {
    const std::string name = k == 0 ? "" : header_.robots[k].name;
    Robot& robot = robots_.emplace_back();
    robot.prefix = name.empty() ? "" : "/" + name;
    robot.frames = name.empty() ? "" : name + "/";
    topics_.push_back(topic<hunav_msgs::Agent>(robot.prefix + "/robot_states", kDepthOfStates));
    topics_.push_back(topic<nav_msgs::Odometry>(robot.prefix + "/odom"));
    topics_.push_back(topic<sensor_msgs::LaserScan>(robot.prefix + "/scan"));
    topics_.push_back(latchedTopic<nav_msgs::Path>(robot.prefix + "/plan"));
    topics_.push_back(latchedTopic<geometry_msgs::PoseStamped>(robot.prefix + "/goal_pose"));
  }
}

template <class Make>
void RunTopics::latch(const PublishContext& context, std::size_t topic, const Make& make) {
  std::string unstamped = encode(make(0.0));
  if (unstamped == unstamped_[topic]) {
    return;
  }
  unstamped_[topic] = std::move(unstamped);
  latched_[topic] = encode(make(context.frame.time));
  if (context.isWanted(topic)) {
    context.send(topic, latched_[topic]);
  }
}

std::optional<base::Pose2> RunTopics::mountOf(std::size_t robot) const {
  return robot < options_.lidarMounts.size() ? options_.lidarMounts[robot] : std::nullopt;
}

void RunTopics::setHeader(sim2d::TraceHeader header) {
  header_ = std::move(header);
  for (Robot& robot : robots_) {
    robot.goal = nullptr;  // set by the next frame
  }
}

/// Inputs take effect before events in a step.
void RunTopics::track(const sim2d::Frame& frame) {
  for (const sim2d::Input& input : frame.inputs) {
    track(input);
  }
  for (const sim2d::Event& event : frame.events) {
    track(event);
  }
}

void RunTopics::track(const sim2d::Input& input) {
  const auto robot = static_cast<std::size_t>(-1 - input.id);  // -1, -2 …
  if (input.kind == sim2d::InputKind::Goal && input.id < 0 && robot < robots_.size()) {
    robots_[robot].hasExternalGoal = true;
    robots_[robot].externalGoal.emplace().position = input.pose.position;
  }
}

void RunTopics::track(const sim2d::Event& event) {
  const auto robot = static_cast<std::size_t>(-1 - event.id);  // -1, -2 …
  if (event.id >= 0 || robot >= robots_.size()) {
    return;
  }
  robots_[robot].passed += event.kind == sim2d::EventKind::Goal ? 1 : 0;
  const bool endsNavigation = event.kind == sim2d::EventKind::NavigationSucceeded ||
                              event.kind == sim2d::EventKind::NavigationFailed;
  if (endsNavigation) {  // an aborted goal has no event `goal`
    robots_[robot].passed = std::max(robots_[robot].passed, std::size_t{1});
  }
  if (event.kind == sim2d::EventKind::Arrived || endsNavigation) {
    robots_[robot].externalGoal.reset();
    robots_[robot].goal = nullptr;
  }
}

void RunTopics::publish(const sim2d::Frame& frame, const Send& send, const Filter& filter) {
  const std::size_t robots = std::min(robots_.size(), frame.robots.size());
  for (std::size_t k = 0; k < robots; ++k) {
    Robot& robot = robots_[k];
    robot.hasExternalGoal = robot.hasExternalGoal && frame.robots.goal[k] == sim2d::kNoGoal;
    const sim2d::TraceRobot& told = header_.robots[k];
    const bool isParked = told.startTime > frame.time + kTimeSlack;  // no goal published yet
    if (robot.hasExternalGoal) {
      robot.goal = robot.externalGoal ? &*robot.externalGoal : nullptr;
    } else {
      robot.goal = isParked ? nullptr : goalIn(told.goals, frame.robots.goal[k], robot.passed);
    }
  }
  const PublishContext context{frame, send, filter, lengths_};
  if (options_.clock) {
    context.publish(Clock, [&] { return rosgraph_msgs::Clock{stampOf(frame.time)}; });
  }
  publishStaticTransforms(context);
  context.publishReused(Tf, transforms_, [&](auto& to) { setTransforms(frame, to); });
  publishSurroundings(context);
  for (std::size_t k = 0; k < robots_.size() && k < frame.robots.size(); ++k) {
    publishRobot(context, k);
  }
  publishPeople(context);
}

/// The robot's pose in odom, and the pose of odom in the map: the localizer's correction, none
/// before the first one. Without a localizer, odom is chosen so that the robot is at its true pose;
/// without sensors, odometry is the truth.
RunTopics::RobotFrames RunTopics::robotFramesOf(const sim2d::Frame& frame, std::size_t robot) {
  const base::Pose2 truth = poseIn(frame.robots, robot);
  if (frame.senses == nullptr || robot >= frame.senses->size()) {
    return {truth, base::Pose2{}};
  }
  const sim2d::RobotTelemetry& senses = (*frame.senses)[robot];
  if (!senses.localizer) {
    return {senses.believed, sim2d::frameBetween(truth, senses.believed)};
  }
  const sim2d::RobotTelemetry::Localizer& localizer = *senses.localizer;
  return {sim2d::toFrame(localizer.mapToOdom, senses.believed),
          localizer.isLocalized ? std::optional(localizer.mapToOdom) : std::nullopt};
}

void RunTopics::publishStaticTransforms(const PublishContext& context) {
  if (robots_.empty() || !latched_[TfStatic].empty()) {
    return;
  }
  latch(context, TfStatic, [&](double seconds) {
    tf2_msgs::TFMessage all;
    for (std::size_t k = 0; k < robots_.size(); ++k) {
      const std::string& frames = robots_[k].frames;
      all.transforms.push_back(transformTo(seconds, frames + kFootprint, frames + kBase, {}));
      if (const std::optional<base::Pose2> mount = mountOf(k)) {
        all.transforms.push_back(transformTo(seconds, frames + kBase, frames + kSensor, *mount));
      }
    }
    return all;
  });
}

void RunTopics::setTransforms(const sim2d::Frame& frame, tf2_msgs::TFMessage& to) const {
  const std::size_t robots = std::min(robots_.size(), frame.robots.size());
  to.transforms.resize(2 * robots + frame.humans.size());
  auto next = to.transforms.begin();
  for (std::size_t k = 0; k < robots; ++k) {
    const RobotFrames robotFrames = robotFramesOf(frame, k);
    const std::string odometry = robots_[k].frames + kOdometry;
    if (robotFrames.mapToOdom) {
      *next++ = transformTo(frame.time, kMapFrame, odometry, *robotFrames.mapToOdom);
    }
    *next++ = transformTo(frame.time, odometry, robots_[k].frames + kFootprint, robotFrames.inOdom);
  }
  for (std::size_t k = 0; k < frame.humans.size(); ++k, ++next) {
    const sim2d::TraceHuman* const human = humanOf(header_, frame.humans, k);
    next->header = headerOf(frame.time);
    next->childFrameId =
        human != nullptr ? human->name : "agent" + std::to_string(frame.humans.id[k]);
    next->transform = transformOf(poseIn(frame.humans, k));
  }
  to.transforms.erase(next, to.transforms.end());
}

void RunTopics::publishSurroundings(const PublishContext& context) {
  if (latched_[Map].empty() && !header_.map.isEmpty()) {
    latch(context, Map, [&](double /*seconds*/) { return mapOf(header_.map); });
  }
  if (latched_[Obstacles].empty() || doors_ != context.frame.doorOpen) {
    doors_ = context.frame.doorOpen;
    latch(context, Obstacles,
          [&](double seconds) { return obstacleMarkersOf(header_, context.frame, seconds); });
  }
}

void RunTopics::publishPeople(const PublishContext& context) {
  const sim2d::Frame& frame = context.frame;
  context.publishReused(Markers, markers_, [&](auto& to) { setBodyMarkers(header_, frame, to); });
  context.publishReused(HumanStates, agents_, [&](auto& to) { setAgents(header_, frame, to); });
  context.publishReused(People, people_, [&](auto& to) { setPeople(header_, frame, to); });
}

void RunTopics::publishRobot(const PublishContext& context, std::size_t robot) {
  const sim2d::Frame& frame = context.frame;
  const std::string& frames = robots_[robot].frames;
  context.publish(topicOf(robot, RobotStates), [&] { return robotOf(header_, frame, robot); });
  context.publish(topicOf(robot, Odometry), [&] {
    return odometryOf(frame, robot, robotFramesOf(frame, robot).inOdom, frames + kOdometry,
                      frames + kFootprint);
  });
  publishNewScan(context, robot);
  publishPlan(context, robot);
}

void RunTopics::publishPlan(const PublishContext& context, std::size_t robot) {
  const sim2d::Frame& frame = context.frame;
  static const std::vector<base::Vec2> kNone;
  const std::vector<base::Vec2>& path =
      robot < frame.robotPaths.size() ? frame.robotPaths[robot] : kNone;
  const std::size_t plan = topicOf(robot, Plan);
  if (!path.empty() || !latched_[plan].empty()) {
    latch(context, plan, [&](double seconds) { return pathOf(path, seconds); });
  }
  if (const sim2d::TraceGoal* const goal = robots_[robot].goal; goal != nullptr) {
    latch(context, topicOf(robot, GoalPose),
          [&](double seconds) { return bridge::goalOf(goal->position, seconds); });
  }
}

namespace {

constexpr double kUsualRate = 10.0;  // [Hz], default lidar rate

}  // namespace

/// The last scan of the robot in this frame: from its sensors, otherwise recorded.
const sim2d::RobotTelemetry::Scan* RunTopics::scanIn(const sim2d::Frame& frame, std::size_t robot) {
  if (frame.senses != nullptr && robot < frame.senses->size() && (*frame.senses)[robot].scan) {
    return &*(*frame.senses)[robot].scan;
  }
  const auto found = std::find_if(
      frame.scans.rbegin(), frame.scans.rend(),
      [&](const sim2d::RecordedScan& each) { return each.robot == frame.robots.id[robot]; });
  return found == frame.scans.rend() ? nullptr : &found->scan;
}

void RunTopics::resendScans() {
  for (Robot& robot : robots_) {
    robot.scanned.reset();
  }
}

void RunTopics::publishNewScan(const PublishContext& context, std::size_t robot) {
  const sim2d::Frame& frame = context.frame;
  const bool hasSenses = frame.senses != nullptr && robot < frame.senses->size();
  std::optional<double>& told = robots_[robot].scanned;
  if (hasSenses && (*frame.senses)[robot].deferredScan != nullptr) {
    const sim2d::RobotTelemetry::DeferredScan& later = *(*frame.senses)[robot].deferredScan;
    const bool isWanted =
        context.isWanted(topicOf(robot, Scan)) || (context.isWanted(Tf) && !mountOf(robot));
    if (std::exchange(told, later.time) != later.time && isWanted) {
      publishScan(context, robot, later.make());
    }
  } else if (const sim2d::RobotTelemetry::Scan* const scan = scanIn(frame, robot)) {
    if (std::exchange(told, scan->time) != scan->time) {
      publishScan(context, robot, *scan);
    }
  }
}

void RunTopics::publishScan(const PublishContext& context, std::size_t robot,
                            const sim2d::RobotTelemetry::Scan& scan) const {
  const std::string& frames = robots_[robot].frames;
  if (!mountOf(robot) && context.isWanted(Tf)) {  // much shorter than the others of its topic
    context.send(Tf, encode(tf2_msgs::TFMessage{{transformTo(scan.time, frames + kOdometry,
                                                             frames + kSensor, scan.sensor)}}));
  }
  const double rate = robot < options_.lidarRates.size() ? options_.lidarRates[robot] : kUsualRate;
  context.publish(topicOf(robot, Scan), [&] { return scanOf(scan, 1.0 / rate, frames + kSensor); });
}

}  // namespace bridge
