#include "app/bridge/bag/BagBodies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/bridge/topics/RunMessages.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"

namespace bridge {
namespace {

constexpr int kRobot = -1;                    // id of a robot that has none
constexpr std::uint32_t kWidest = 1U << 16U;  // [cells] of a map
// [ns]: of any two times and stamps the difference is a number as well.
constexpr std::int64_t kLatest = std::int64_t{1} << 62U;

/// The value of a tag of HuNavSim.
std::optional<int> tagOf(const people_msgs::Person& person, const char* name) {
  for (std::size_t k = 0; k < std::min(person.tagnames.size(), person.tags.size()); ++k) {
    if (person.tagnames[k] == name) {
      const std::optional<long long> value = base::parseInt(person.tags[k]);
      constexpr long long kLargest = 999999999;
      return value && *value >= -kLargest && *value <= kLargest
                 ? std::optional(static_cast<int>(*value))
                 : std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace

const BagObstacles::Part* BagObstacles::find(const std::string& name) const {
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&name](const Part& part) { return part.name == name; });
  return found == parts.end() ? nullptr : &*found;
}

BagBodies::BagBodies(Bag& bag, BagChoice choice, std::string path)
    : bag_(bag), choice_(std::move(choice)), path_(std::move(path)) {}

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
  for (const std::optional<std::size_t>& channel : {choice_.goals, choice_.obstacles}) {
    if (channel) {
      wanted[*channel] = true;
    }
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
  } else if (choice_.goals == channel) {
    takeGoal(channel, bytes);
  } else if (choice_.obstacles == channel) {
    takeObstacles(channel, bytes);
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

bool BagBodies::isFine(std::size_t channel, const people_msgs::Person& person, bool hasTurning) {
  const geometry_msgs::Point& place = person.position;
  const geometry_msgs::Point& velocity = person.velocity;
  return bad_.areFine(channel, "position", {place.x, place.y, hasTurning ? place.z : 0.0},
                      kMostMetres) &&
         bad_.areFine(channel, "velocity", {velocity.x, velocity.y, hasTurning ? velocity.z : 0.0},
                      kMostSpeed);
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
    if (!isFine(channel, person, id.has_value())) {
      continue;
    }
    const int known =
        id ? *id : named_.emplace(person.name, static_cast<int>(named_.size()) + 1).first->second;
    BagBody& body = people_[known];
    body.id = known;
    body.name = person.name;
    if (const std::optional<int> type = tagOf(person, "behavior"); type && !body.told) {
      body.told.emplace().behavior.type = static_cast<std::uint8_t>(std::clamp(*type, 1, 6));
    }
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

void BagBodies::takeOdometry(std::size_t channel, const nav_msgs::Odometry& odometry) {
  const geometry_msgs::Twist& twist = odometry.twist.twist;
  const bool isFine =
      bad_.areFine(channel, "twist.linear", {twist.linear.x, twist.linear.y}, kMostSpeed) &&
      bad_.areFine(channel, "twist.angular", {twist.angular.z}, kMostSpeed);
  if (!isFine || !takePose(channel, odometry.header, odometry.pose.pose)) {
    return;
  }
  BagSample& sample = robot().samples.back();
  sample.velocity = base::Pose2{base::Vec2::Zero(), sample.pose.heading}.toWorld(
      {twist.linear.x, twist.linear.y});
  sample.omega = twist.angular.z;
}

/// False: it has numbers that are not finite, and nothing is added.
bool BagBodies::takePose(std::size_t channel, const std_msgs::Header& header,
                         const geometry_msgs::Pose& pose) {
  const base::Pose2 inFrame = planarPose(pose);
  if (!bad_.areFine(channel, "pose.position", {pose.position.x, pose.position.y}, kMostMetres) ||
      !bad_.areFine(channel, "pose.orientation", {inFrame.heading}, kMostSpeed)) {
    return false;
  }
  const base::Pose2 frame = toMap(header.frameId);
  BagSample sample;
  sample.time = nanosecondsOf(header.stamp);
  sample.pose = {frame.toWorld(inFrame.position), base::wrapToPi(frame.heading + inFrame.heading)};
  sample.heading = sample.pose.heading;
  robot().samples.push_back(sample);
  return true;
}

void BagBodies::takeRobot(std::size_t channel, std::int64_t time, std::string_view bytes) {
  const std::string& type = bag_.channels()[channel].type;
  if (type == hunav_msgs::Agent::kType) {
    if (const auto agent = decoded<hunav_msgs::Agent>(channel, bytes)) {
      takeAgent(channel, *agent, time, robots_);
    }
  } else if (type == nav_msgs::Odometry::kType) {
    if (const auto odometry = decoded<nav_msgs::Odometry>(channel, bytes)) {
      takeOdometry(channel, *odometry);
    }
  } else if (type == geometry_msgs::PoseStamped::kType) {
    if (const auto pose = decoded<geometry_msgs::PoseStamped>(channel, bytes)) {
      takePose(channel, pose->header, pose->pose);
    }
  } else if (const auto pose = decoded<geometry_msgs::PoseWithCovarianceStamped>(channel, bytes)) {
    takePose(channel, pose->header, pose->pose.pose);
  }
}

void BagBodies::takeTransforms(std::size_t channel, std::string_view bytes) {
  auto message = decoded<tf2_msgs::TFMessage>(channel, bytes);
  if (!message) {
    return;
  }
  std::vector<geometry_msgs::TransformStamped>& all = message->transforms;
  all.erase(std::remove_if(all.begin(), all.end(),
                           [&](const geometry_msgs::TransformStamped& each) {
                             const geometry_msgs::Transform& t = each.transform;
                             const double turn = headingOf(t.rotation);
                             return !bad_.areFine(channel, "transforms",
                                                  {t.translation.x, t.translation.y, turn},
                                                  kMostMetres);
                           }),
            all.end());
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

void BagBodies::takeGoal(std::size_t channel, std::string_view bytes) {
  const auto pose = decoded<geometry_msgs::PoseStamped>(channel, bytes);
  if (!pose ||
      !bad_.areFine(channel, "pose.position", {pose->pose.position.x, pose->pose.position.y},
                    kMostMetres, BadNumbers::Loss::Value)) {
    return;
  }
  const base::Vec2 goal =
      toMap(pose->header.frameId).toWorld({pose->pose.position.x, pose->pose.position.y});
  firstGoal_ = firstGoal_.value_or(nanosecondsOf(pose->header.stamp));
  const auto isSame = [&](const base::Vec2& other) { return (goal - other).norm() < kSamePlace; };
  if (std::none_of(goals_.begin(), goals_.end(), isSame)) {
    goals_.push_back(goal);
  }
}

/// As hunavsim publishes them: all earlier outlines are deleted, then one closed line follows for
/// each.
void BagBodies::takeObstacles(std::size_t channel, std::string_view bytes) {
  using visualization_msgs::Marker;
  const auto all = decoded<visualization_msgs::MarkerArray>(channel, bytes);
  if (!all || all->markers.empty() || all->markers.front().action != Marker::kDeleteall) {
    return;
  }
  BagObstacles now;
  now.time = nanosecondsOf(all->markers.front().header.stamp);
  for (const Marker& marker : all->markers) {
    if (marker.type != Marker::kLineStrip || marker.action != Marker::kAdd) {
      continue;
    }
    const base::Pose2 frame = toMap(marker.header.frameId);
    const base::Pose2 inFrame = planarPose(marker.pose);
    sim2d::Outline outline;
    for (std::size_t k = 0; k + 1 < marker.points.size(); ++k) {  // the last repeats the first
      const geometry_msgs::Point& point = marker.points[k];
      if (bad_.areFine(channel, "points", {point.x, point.y}, kMostMetres,
                       BadNumbers::Loss::Value)) {
        outline.points.push_back(frame.toWorld(inFrame.toWorld({point.x, point.y})));
      }
    }
    if (outline.points.size() >= 3) {
      if (now.parts.empty() || now.parts.back().name != marker.ns) {
        now.parts.push_back({marker.ns, {}});
      }
      now.parts.back().outlines.push_back(std::move(outline));
    }
  }
  obstacles_.push_back(std::move(now));
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
  base::append(problems, bad_.warnings(bag_.channels(), path_));
  for (const auto& [frame, count] : strange_) {
    problems.push_back(base::warning("bag.moved-frame", {count, frame}, path_));
  }
  return problems;
}

}  // namespace bridge
