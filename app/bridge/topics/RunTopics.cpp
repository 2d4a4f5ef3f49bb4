#include "app/bridge/topics/RunTopics.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/bridge/topics/RunMarkers.h"
#include "app/bridge/topics/RunMessages.h"
#include "app/bridge/topics/Telling.h"
#include "sim2d/nav/FrameTransform.h"
#include "sim2d/scenario/Defaults.h"

namespace bridge {
namespace {

constexpr const char* kFootprint = "base_footprint";
constexpr const char* kBase = "base_link";
constexpr double kTimeSlack = 1e-9;  // [s]
constexpr int kDepthOfTf = 100;
constexpr int kDepthOfStates = 1;  // as HuNavSim has them

template <class M>
Topic topic(std::string name, int depth = 10) {
  return {std::move(name), M::kType, false, depth};
}

template <class M>
Topic latchedTopic(std::string name) {
  return {std::move(name), M::kType, true, 1};
}

/// The goal of that id, or the one that comes next where it is a plain point, which has no id.
const sim2d::TraceGoal* goalIn(const std::vector<sim2d::TraceGoal>& goals, int id,
                               std::size_t passed) {
  if (id == sim2d::kNoGoal) {
    return passed < goals.size() && goals[passed].id <= 0 ? &goals[passed] : nullptr;
  }
  const auto found = std::find_if(goals.begin(), goals.end(),
                                  [id](const sim2d::TraceGoal& goal) { return goal.id == id; });
  return found == goals.end() ? nullptr : &*found;
}

}  // namespace

geometry_msgs::TransformStamped transformTo(double seconds, const std::string& parent,
                                            const std::string& child, const base::Pose2& pose) {
  return {headerOf(seconds, parent), child, transformOf(pose)};
}

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
  topics_.resize(CommonCount);
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
void RunTopics::latch(const Telling& telling, std::size_t topic, const Make& make) {
  std::string unstamped = encode(make(0.0));
  if (unstamped == unstamped_[topic]) {
    return;
  }
  unstamped_[topic] = std::move(unstamped);
  latched_[topic] = encode(make(telling.frame.time));
  if (telling.isWanted(topic)) {
    telling.send(topic, latched_[topic]);
  }
}

std::optional<base::Pose2> RunTopics::mountOf(std::size_t robot) const {
  return robot < options_.lidarMounts.size() ? options_.lidarMounts[robot] : std::nullopt;
}

void RunTopics::setHeader(sim2d::TraceHeader header) {
  header_ = std::move(header);
  for (Robot& robot : robots_) {
    robot.goal = nullptr;  // of the next frame
  }
}

/// Inputs act first in a step.
void RunTopics::note(const sim2d::Frame& frame) {
  for (const sim2d::Input& input : frame.inputs) {
    note(input);
  }
  for (const sim2d::Event& event : frame.events) {
    note(event);
  }
}

void RunTopics::note(const sim2d::Input& input) {
  const auto robot = static_cast<std::size_t>(-1 - input.id);  // -1, -2 …
  if (input.kind == sim2d::InputKind::Goal && input.id < 0 && robot < robots_.size()) {
    robots_[robot].isOrdered = true;
    robots_[robot].order.emplace().position = input.pose.position;
  }
}

void RunTopics::note(const sim2d::Event& event) {
  const auto robot = static_cast<std::size_t>(-1 - event.id);  // -1, -2 …
  if (event.id >= 0 || robot >= robots_.size()) {
    return;
  }
  robots_[robot].passed += event.kind == sim2d::EventKind::Goal ? 1 : 0;
  const bool endsNavigation = event.kind == sim2d::EventKind::NavigationSucceeded ||
                              event.kind == sim2d::EventKind::NavigationFailed;
  if (endsNavigation) {  // a goal that was given up has no event `goal`
    robots_[robot].passed = std::max(robots_[robot].passed, std::size_t{1});
  }
  if (event.kind == sim2d::EventKind::Arrived || endsNavigation) {
    robots_[robot].order.reset();
    robots_[robot].goal = nullptr;
  }
}

void RunTopics::tell(const sim2d::Frame& frame, const Send& send, const Wants& wants) {
  const std::size_t robots = std::min(robots_.size(), frame.robots.size());
  for (std::size_t k = 0; k < robots; ++k) {
    Robot& robot = robots_[k];
    robot.isOrdered = robot.isOrdered && frame.robots.goal[k] == sim2d::kNoGoal;
    const sim2d::TraceRobot& told = header_.robots[k];
    const bool isParked = told.startTime > frame.time + kTimeSlack;  // no goal published yet
    if (robot.isOrdered) {
      robot.goal = robot.order ? &*robot.order : nullptr;
    } else {
      robot.goal = isParked ? nullptr : goalIn(told.goals, frame.robots.goal[k], robot.passed);
    }
  }
  const Telling telling{frame, send, wants, lengths_};
  if (options_.clock) {
    telling.tell(Clock, [&] { return rosgraph_msgs::Clock{stampOf(frame.time)}; });
  }
  tellFixedTransforms(telling);
  tellTransforms(telling);
  tellSurroundings(telling);
  for (std::size_t k = 0; k < robots_.size() && k < frame.robots.size(); ++k) {
    tellRobot(telling, k);
  }
  tellPeople(telling);
}

/// The robot in the frame odom, and that frame in the map: the correction of its localiser, none
/// before the first one. A robot without a localiser is where it is: odometry is corrected by the
/// truth, and without senses it is the truth.
RunTopics::Placed RunTopics::placedBy(const sim2d::Frame& frame, std::size_t robot) {
  const base::Pose2 truth = poseIn(frame.robots, robot);
  if (frame.senses == nullptr || robot >= frame.senses->size()) {
    return {truth, base::Pose2{}};
  }
  const sim2d::RobotSenses& senses = (*frame.senses)[robot];
  if (!senses.localizer) {
    return {senses.believed, sim2d::frameBetween(truth, senses.believed)};
  }
  const sim2d::RobotSenses::Localizer& localizer = *senses.localizer;
  return {sim2d::toFrame(localizer.mapToOdom, senses.believed),
          localizer.isLocalized ? std::optional(localizer.mapToOdom) : std::nullopt};
}

void RunTopics::tellFixedTransforms(const Telling& telling) {
  if (robots_.empty() || !latched_[TfStatic].empty()) {
    return;
  }
  latch(telling, TfStatic, [&](double seconds) {
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
    const Placed placed = placedBy(frame, k);
    const std::string odometry = robots_[k].frames + kOdometry;
    if (placed.mapToOdom) {
      *next++ = transformTo(frame.time, kMapFrame, odometry, *placed.mapToOdom);
    }
    *next++ = transformTo(frame.time, odometry, robots_[k].frames + kFootprint, placed.inOdom);
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

void RunTopics::tellTransforms(const Telling& telling) {
  telling.tellReused(Tf, ofPeople_.transforms, [&](auto& to) { setTransforms(telling.frame, to); });
}

void RunTopics::tellSurroundings(const Telling& telling) {
  if (latched_[Map].empty() && !header_.map.isEmpty()) {
    latch(telling, Map, [&](double /*seconds*/) { return mapOf(header_.map); });
  }
  if (latched_[Obstacles].empty() || doors_ != telling.frame.doorOpen) {
    doors_ = telling.frame.doorOpen;
    latch(telling, Obstacles,
          [&](double seconds) { return obstacleMarkersOf(header_, telling.frame, seconds); });
  }
}

void RunTopics::tellPeople(const Telling& telling) {
  const sim2d::Frame& frame = telling.frame;
  telling.tellReused(Markers, ofPeople_.markers,
                     [&](auto& to) { setBodyMarkers(header_, frame, to); });
  telling.tellReused(HumanStates, ofPeople_.agents,
                     [&](auto& to) { setAgents(header_, frame, to); });
  telling.tellReused(People, ofPeople_.people, [&](auto& to) { setPeople(header_, frame, to); });
}

void RunTopics::tellRobot(const Telling& telling, std::size_t robot) {
  const sim2d::Frame& frame = telling.frame;
  const std::string& frames = robots_[robot].frames;
  telling.tell(topicOf(robot, RobotStates), [&] { return robotOf(header_, frame, robot); });
  telling.tell(topicOf(robot, Odometry), [&] {
    return odometryOf(frame, robot, placedBy(frame, robot).inOdom, frames + kOdometry,
                      frames + kFootprint);
  });
  tellNewScan(telling, robot);
  tellWay(telling, robot);
}

void RunTopics::tellWay(const Telling& telling, std::size_t robot) {
  const sim2d::Frame& frame = telling.frame;
  static const std::vector<base::Vec2> kNone;
  const std::vector<base::Vec2>& path =
      robot < frame.robotPaths.size() ? frame.robotPaths[robot] : kNone;
  const std::size_t plan = topicOf(robot, Plan);
  if (!path.empty() || !latched_[plan].empty()) {
    latch(telling, plan, [&](double seconds) { return pathOf(path, seconds); });
  }
  if (const sim2d::TraceGoal* const goal = robots_[robot].goal; goal != nullptr) {
    latch(telling, topicOf(robot, GoalPose),
          [&](double seconds) { return bridge::goalOf(goal->position, seconds); });
  }
}

}  // namespace bridge
