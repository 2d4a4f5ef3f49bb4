#include "app/bridge/bag/BagBodies.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/topics/RunMessages.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"

namespace bridge {
namespace {

constexpr double kSameHeading = 1e-6;         // [rad]: what a float leaves of it
constexpr int kRobot = -1;                    // id of a robot that has none
constexpr std::uint32_t kWidest = 1U << 16U;  // [cells] of a map
// [ns]: of any two times and stamps the difference is a number as well.
constexpr std::int64_t kLatest = std::int64_t{1} << 62U;

std::int64_t nanosecondsOf(const builtin_interfaces::Time& stamp) {
  return std::int64_t{stamp.sec} * 1000000000 + stamp.nanosec;
}

/// The quaternion when the two agree: it is a double. Some never fill it.
double turnedBy(const hunav_msgs::Agent& agent) {
  const double turned = headingOf(agent.position.orientation);
  const double yaw = static_cast<double>(agent.yaw);
  return std::fabs(base::angleDiff(turned, yaw)) < kSameHeading ? turned : base::wrapToPi(yaw);
}

/// The value of a tag of HuNavSim.
std::optional<int> tagOf(const people_msgs::Person& person, const char* name) {
  for (std::size_t k = 0; k < std::min(person.tagnames.size(), person.tags.size()); ++k) {
    if (person.tagnames[k] == name) {
      const std::optional<long long> value = base::parseInt(person.tags[k]);
      return value && std::abs(*value) < 1000000000 ? std::optional(static_cast<int>(*value))
                                                    : std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace

double asWritten(float value) {
  char text[32];
  const std::to_chars_result end = std::to_chars(text, text + sizeof(text), value);
  return base::parseDouble({text, static_cast<std::size_t>(end.ptr - text)}).value_or(value);
}

BagBodies::BagBodies(Bag& bag, BagChoice choice, std::string path)
    : bag_(bag), choice_(std::move(choice)), path_(std::move(path)) {}

template <class M>
std::optional<M> BagBodies::decoded(std::size_t channel, std::string_view bytes) {
  Losses& losses = losses_[channel];
  base::Result<M> message = decode<M>(bytes);
  if (!message) {
    if (losses.lost++ == 0) {
      losses.first = message.diagnostics().front().text();
    }
    return std::nullopt;
  }
  ++losses.read;
  return *std::move(message);
}

base::Diagnostics BagBodies::read() {
  std::vector<bool> wanted(bag_.channels().size(), false);
  const auto want = [&](std::size_t channel) {
    wanted[channel] = true;
    losses_[channel];
  };
  std::for_each(choice_.robots.begin(), choice_.robots.end(), want);
  if (choice_.people) {
    want(*choice_.people);
  }
  if (choice_.map) {
    want(*choice_.map);
  }
  for (const std::size_t channel : choice_.transforms) {
    wanted[channel] = true;
  }
  base::Diagnostics problems =
      bag_.read(wanted, [this](std::size_t channel, std::int64_t time, std::string_view bytes) {
        take(channel, time, bytes);
      });
  pairRobots();
  base::append(problems, losses());
  return problems;
}

void BagBodies::take(std::size_t channel, std::int64_t recorded, std::string_view bytes) {
  const std::int64_t time = std::clamp(recorded, std::int64_t{0}, kLatest);
  const std::string& type = bag_.channels()[channel].type;
  if (choice_.people == channel && type == hunav_msgs::Agents::kType) {
    takeAgents(channel, bytes, time);
  } else if (choice_.people == channel) {
    takePeople(channel, bytes);
  } else if (choice_.map == channel) {
    takeMap(channel, bytes);
  } else if (type == tf2_msgs::TFMessage::kType) {
    takeTransforms(channel, bytes);
  } else {
    takeRobot(channel, time, bytes);
  }
}

/// Where the frame lies in the map's; what nothing tells is taken for the map's.
base::Pose2 BagBodies::toMap(const std::string& frame) {
  if (frame.empty() || frame == kMapFrame) {
    return {};
  }
  const std::optional<base::Pose2> pose = frames_.inMap(frame);
  if (!pose) {
    ++strange_[frame];
  }
  return pose.value_or(base::Pose2());
}

void BagBodies::takeAgent(const hunav_msgs::Agent& agent, std::int64_t time,
                          std::map<int, BagBody>& to) {
  BagBody& body = to[agent.id];
  if (!body.told) {
    body.id = agent.id;
    body.name = agent.name;
    body.told = agent;
  }
  BagSample sample;
  sample.time = time;
  sample.pose.position = {agent.position.position.x, agent.position.position.y};
  sample.pose.heading = turnedBy(agent);
  sample.heading = sample.pose.heading;
  sample.velocity = base::Vec2(agent.velocity.linear.x, agent.velocity.linear.y);
  sample.omega = agent.velocity.angular.z;
  sample.group = agent.groupId;  // NOLINT(bugprone-signed-char-misuse): -1 is nobody's
  sample.state = agent.behavior.state;
  if (!agent.goals.empty()) {
    sample.goal = base::Vec2(agent.goals.front().position.x, agent.goals.front().position.y);
  }
  body.samples.push_back(sample);
}

void BagBodies::takeAgents(std::size_t channel, std::string_view bytes, std::int64_t time) {
  const std::optional<hunav_msgs::Agents> all = decoded<hunav_msgs::Agents>(channel, bytes);
  if (!all) {
    return;
  }
  const std::int64_t stamp = nanosecondsOf(all->header.stamp);
  stamps_.emplace_back(time, stamp);
  for (const hunav_msgs::Agent& agent : all->agents) {
    takeAgent(agent, stamp, people_);
  }
}

/// Of HuNavSim, which tags its people: position.z is the heading, the velocity ends with the
/// turning.
void BagBodies::takePeople(std::size_t channel, std::string_view bytes) {
  const std::optional<people_msgs::People> all = decoded<people_msgs::People>(channel, bytes);
  if (!all) {
    return;
  }
  const base::Pose2 frame = toMap(all->header.frameId);
  for (const people_msgs::Person& person : all->people) {
    const std::optional<int> id = tagOf(person, "id");
    const int known =
        id ? *id : named_.emplace(person.name, static_cast<int>(named_.size()) + 1).first->second;
    BagBody& body = people_[known];
    body.id = known;
    body.name = person.name;
    BagSample sample;
    sample.time = nanosecondsOf(all->header.stamp);
    sample.pose.position = frame.toWorld({person.position.x, person.position.y});
    const base::Vec2 velocity(person.velocity.x, person.velocity.y);
    sample.velocity = base::Pose2{base::Vec2::Zero(), frame.heading}.toWorld(velocity);
    sample.group = tagOf(person, "group_id").value_or(-1);
    if (id) {
      sample.heading = base::wrapToPi(person.position.z + frame.heading);
      sample.omega = person.velocity.z;
    }
    body.samples.push_back(sample);
  }
}

BagBody& BagBodies::robot() {
  BagBody& body = robots_[kRobot];
  body.id = kRobot;
  body.name = body.name.empty() ? "robot1" : body.name;
  return body;
}

void BagBodies::takeOdometry(const nav_msgs::Odometry& odometry) {
  takePose(odometry.header, odometry.pose.pose);
  BagSample& sample = robot().samples.back();
  const geometry_msgs::Twist& twist = odometry.twist.twist;
  sample.velocity = base::Pose2{base::Vec2::Zero(), sample.pose.heading}.toWorld(
      {twist.linear.x, twist.linear.y});
  sample.omega = twist.angular.z;
}

void BagBodies::takePose(const std_msgs::Header& header, const geometry_msgs::Pose& pose) {
  const base::Pose2 frame = toMap(header.frameId);
  const base::Pose2 inFrame = planarPose(pose);
  BagSample sample;
  sample.time = nanosecondsOf(header.stamp);
  sample.pose = {frame.toWorld(inFrame.position), base::wrapToPi(frame.heading + inFrame.heading)};
  sample.heading = sample.pose.heading;
  robot().samples.push_back(sample);
}

void BagBodies::takeRobot(std::size_t channel, std::int64_t time, std::string_view bytes) {
  const std::string& type = bag_.channels()[channel].type;
  if (type == hunav_msgs::Agent::kType) {
    if (const auto agent = decoded<hunav_msgs::Agent>(channel, bytes)) {
      takeAgent(*agent, time, robots_);
    }
  } else if (type == nav_msgs::Odometry::kType) {
    if (const auto odometry = decoded<nav_msgs::Odometry>(channel, bytes)) {
      takeOdometry(*odometry);
    }
  } else if (type == geometry_msgs::PoseStamped::kType) {
    if (const auto pose = decoded<geometry_msgs::PoseStamped>(channel, bytes)) {
      takePose(pose->header, pose->pose);
    }
  } else if (const auto pose = decoded<geometry_msgs::PoseWithCovarianceStamped>(channel, bytes)) {
    takePose(pose->header, pose->pose.pose);
  }
}

void BagBodies::takeTransforms(std::size_t channel, std::string_view bytes) {
  const auto message = decoded<tf2_msgs::TFMessage>(channel, bytes);
  if (!message) {
    return;
  }
  frames_.add(*message);
  if (!choice_.isRobotByTf) {
    return;
  }
  for (const geometry_msgs::TransformStamped& each : message->transforms) {
    const bool isRobot = each.childFrameId == "base_footprint" || each.childFrameId == "base_link";
    const std::optional<base::Pose2> pose =
        isRobot ? frames_.inMap(each.childFrameId) : std::nullopt;
    const std::int64_t stamp = nanosecondsOf(each.header.stamp);
    if (!pose || (!robot().samples.empty() && stamp <= robot().samples.back().time)) {
      continue;  // the same instant by its other name, or a transform that is fixed
    }
    BagSample sample;
    sample.time = stamp;
    sample.pose = *pose;
    sample.heading = pose->heading;
    robot().samples.push_back(sample);
  }
}

void BagBodies::takeMap(std::size_t channel, std::string_view bytes) {
  const auto map = decoded<nav_msgs::OccupancyGrid>(channel, bytes);
  if (!map) {
    return;
  }
  const std::uint64_t cells = std::uint64_t{map->info.width} * map->info.height;
  const bool isPossible = map->info.width <= kWidest && map->info.height <= kWidest && cells > 0 &&
                          cells <= std::uint64_t{sim2d::kMostMapCells} &&
                          cells == map->data.size() && map->info.resolution > 0.0F &&
                          std::isfinite(map->info.resolution);
  const base::Pose2 origin = planarPose(map->info.origin);
  if (!isPossible || !base::isInReach(origin.position) || !std::isfinite(origin.heading)) {
    ++losses_[channel].lost;
    --losses_[channel].read;
    losses_[channel].first = "its size and cells do not fit, or are too many";
    return;
  }
  std::vector<std::int8_t> values = map->data;
  for (std::int8_t& value : values) {
    value = value < -1 || value > 100 ? std::int8_t{-1} : value;
  }
  map_ = sim2d::OccupancyGrid(static_cast<int>(map->info.width), static_cast<int>(map->info.height),
                              asWritten(map->info.resolution), origin, std::move(values));
}

/// robot_states has no stamp: it gets that of the people recorded nearest to it.
void BagBodies::pairRobots() {
  std::sort(stamps_.begin(), stamps_.end());
  for (auto& [id, body] : robots_) {
    if (!body.told || stamps_.empty()) {
      continue;
    }
    for (BagSample& sample : body.samples) {
      auto next = std::lower_bound(stamps_.begin(), stamps_.end(),
                                   std::make_pair(sample.time, std::int64_t{0}));
      const bool isLast = next == stamps_.end();
      if (isLast || (next != stamps_.begin() &&
                     sample.time - std::prev(next)->first < next->first - sample.time)) {
        --next;
      }
      sample.time = next->second;
    }
  }
}

base::Diagnostics BagBodies::losses() const {
  base::Diagnostics problems;
  for (const auto& [channel, losses] : losses_) {
    const std::string& topic = bag_.channels()[channel].topic;
    if (losses.lost > 0) {
      problems.push_back(
          base::warning("bag.bad-messages", {losses.lost, topic, losses.first}, path_));
    }
    if (losses.read == 0) {
      problems.push_back(base::warning("bag.no-messages", {topic}, path_));
    }
  }
  for (const auto& [frame, count] : strange_) {
    problems.push_back(base::warning("bag.moved-frame", {count, frame}, path_));
  }
  return problems;
}

}  // namespace bridge
