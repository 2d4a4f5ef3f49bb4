#include "app/bridge/bag/BagBodies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/bridge/messages/visualization_msgs.h"
#include "app/bridge/topics/RunMessages.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"

namespace bridge {

bool InvalidNumbers::areValid(std::size_t channel, const char* field,
                              std::initializer_list<double> numbers, double most, Loss loss) {
  const auto* const bad = std::find_if(numbers.begin(), numbers.end(), [most](double number) {
    return !(std::fabs(number) <= most);  // also for NaN
  });
  if (bad == numbers.end()) {
    return true;
  }
  Count& count = counts_[{channel, field}];
  if (count.count++ == 0) {
    count.first = *bad;
    count.loss = loss;
  }
  return false;
}

bool InvalidNumbers::hasDiscardedSamples() const {
  return std::any_of(counts_.begin(), counts_.end(),
                     [](const auto& each) { return each.second.loss == Loss::Sample; });
}

base::Diagnostics InvalidNumbers::warnings(const std::vector<BagChannel>& channels,
                                           const std::string& path) const {
  base::Diagnostics warnings;
  for (const auto& [where, count] : counts_) {
    const char* const code = count.loss == Loss::Sample ? "bag.bad-samples" : "bag.bad-values";
    warnings.push_back(base::warning(
        code,
        {count.count, channels[where.first].topic, where.second, base::formatDouble(count.first)},
        path));
  }
  return warnings;
}

namespace {

constexpr int kLongestChain = 32;

/// Removes a leading slash, which some programs write.
std::string nameOf(const std::string& frame) {
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

base::Pose2 composed(const base::Pose2& outer, const base::Pose2& inner) {
  return {outer.toWorld(inner.position), base::wrapToPi(outer.heading + inner.heading)};
}

}  // namespace

base::Pose2 planarPose(const geometry_msgs::Pose& pose) {
  return {{pose.position.x, pose.position.y}, headingOf(pose.orientation)};
}

void FrameTree::add(const tf2_msgs::TFMessage& message) {
  for (const geometry_msgs::TransformStamped& each : message.transforms) {
    const geometry_msgs::Transform& t = each.transform;
    links_[nameOf(each.childFrameId)] = {
        nameOf(each.header.frameId), {{t.translation.x, t.translation.y}, headingOf(t.rotation)}};
  }
}

std::optional<base::Pose2> FrameTree::inMap(const std::string& frame) const {
  std::string name = nameOf(frame);
  base::Pose2 pose;
  for (int k = 0; k < kLongestChain; ++k) {
    if (name == kMapFrame) {
      return pose;
    }
    const auto link = links_.find(name);
    if (link == links_.end()) {
      return std::nullopt;
    }
    pose = composed(link->second.pose, pose);
    name = link->second.parent;
  }
  return std::nullopt;  // cyclic or too long
}

namespace {

constexpr int kRobot = -1;                    // id of a robot without an id
constexpr std::uint32_t kWidest = 1U << 16U;  // [cells], map width and height
// [ns]: limits times, so that differences do not overflow.
constexpr std::int64_t kLatest = std::int64_t{1} << 62U;

/// The integer value of one of HuNavSim's tags.
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

BagBodies::BagBodies(Bag& bag, TopicSelection choice, std::string path)
    : bag_(bag), selection_(std::move(choice)), path_(std::move(path)) {}

base::Diagnostics BagBodies::read() {
  std::vector<bool> wanted(bag_.channels().size(), false);
  const auto want = [&](std::size_t channel) {
    wanted[channel] = true;
    readCounts_[channel];
  };
  std::for_each(selection_.robots.begin(), selection_.robots.end(), want);
  if (selection_.people) {
    want(*selection_.people);
  }
  if (selection_.map) {
    want(*selection_.map);
  }
  for (const std::size_t channel : selection_.transforms) {
    wanted[channel] = true;
  }
  for (const std::optional<std::size_t>& channel : {selection_.goals, selection_.obstacles}) {
    if (channel) {
      wanted[*channel] = true;
    }
  }
  base::Diagnostics problems =
      bag_.read(wanted, [this](std::size_t channel, std::int64_t time, std::string_view bytes) {
        take(channel, time, bytes);
      });
  assignRobotStamps();
  base::append(problems, losses());
  return problems;
}

void BagBodies::take(std::size_t channel, std::int64_t recorded, std::string_view bytes) {
  const std::int64_t time = std::clamp(recorded, std::int64_t{0}, kLatest);
  const std::string& type = bag_.channels()[channel].type;
  if (selection_.people == channel && type == hunav_msgs::Agents::kType) {
    takeAgents(channel, bytes, time);
  } else if (selection_.people == channel) {
    takePeople(channel, bytes);
  } else if (selection_.map == channel) {
    takeMap(channel, bytes);
  } else if (selection_.goals == channel) {
    takeGoal(channel, bytes);
  } else if (selection_.obstacles == channel) {
    takeObstacles(channel, bytes);
  } else if (type == tf2_msgs::TFMessage::kType) {
    takeTransforms(channel, bytes);
  } else {
    takeRobot(channel, time, bytes);
  }
}

/// The pose of a frame in the map frame. An unknown frame is treated as the map frame and counted.
base::Pose2 BagBodies::toMap(const std::string& frame) {
  if (frame.empty() || frame == kMapFrame) {
    return {};
  }
  const std::optional<base::Pose2> pose = frames_.inMap(frame);
  if (!pose) {
    ++unknownFrames_[frame];
  }
  return pose.value_or(base::Pose2());
}

bool BagBodies::isValid(std::size_t channel, const people_msgs::Person& person, bool hasTurning) {
  const geometry_msgs::Point& place = person.position;
  const geometry_msgs::Point& velocity = person.velocity;
  return invalid_.areValid(channel, "position", {place.x, place.y, hasTurning ? place.z : 0.0},
                           kMostMetres) &&
         invalid_.areValid(channel, "velocity",
                           {velocity.x, velocity.y, hasTurning ? velocity.z : 0.0}, kMostSpeed);
}

/// Messages of HuNavSim have tags; then position.z is the heading and velocity.z the angular
/// velocity.
void BagBodies::takePeople(std::size_t channel, std::string_view bytes) {
  const std::optional<people_msgs::People> all = decoded<people_msgs::People>(channel, bytes);
  if (!all) {
    return;
  }
  const base::Pose2 frame = toMap(all->header.frameId);
  for (const people_msgs::Person& person : all->people) {
    const std::optional<int> id = tagOf(person, "id");
    if (!isValid(channel, person, id.has_value())) {
      continue;
    }
    const int known =
        id ? *id : named_.emplace(person.name, static_cast<int>(named_.size()) + 1).first->second;
    BagBody& body = people_[known];
    body.id = known;
    body.name = person.name;
    if (const std::optional<int> type = tagOf(person, "behavior"); type && !body.properties) {
      body.properties.emplace().behavior.type = static_cast<std::uint8_t>(std::clamp(*type, 1, 6));
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
  const bool isValid =
      invalid_.areValid(channel, "twist.linear", {twist.linear.x, twist.linear.y}, kMostSpeed) &&
      invalid_.areValid(channel, "twist.angular", {twist.angular.z}, kMostSpeed);
  if (!isValid || !takePose(channel, odometry.header, odometry.pose.pose)) {
    return;
  }
  BagSample& sample = robot().samples.back();
  sample.velocity = base::Pose2{base::Vec2::Zero(), sample.pose.heading}.toWorld(
      {twist.linear.x, twist.linear.y});
  sample.omega = twist.angular.z;
}

/// False: the pose has invalid numbers and is discarded.
bool BagBodies::takePose(std::size_t channel, const std_msgs::Header& header,
                         const geometry_msgs::Pose& pose) {
  const base::Pose2 inFrame = planarPose(pose);
  if (!invalid_.areValid(channel, "pose.position", {pose.position.x, pose.position.y},
                         kMostMetres) ||
      !invalid_.areValid(channel, "pose.orientation", {inFrame.heading}, kMostSpeed)) {
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
                             return !invalid_.areValid(channel, "transforms",
                                                       {t.translation.x, t.translation.y, turn},
                                                       kMostMetres);
                           }),
            all.end());
  frames_.add(*message);
  if (!selection_.isRobotFromTf) {
    return;
  }
  for (const geometry_msgs::TransformStamped& each : message->transforms) {
    const bool isRobot = each.childFrameId == "base_footprint" || each.childFrameId == "base_link";
    const std::optional<base::Pose2> pose =
        isRobot ? frames_.inMap(each.childFrameId) : std::nullopt;
    const std::int64_t stamp = nanosecondsOf(each.header.stamp);
    if (!pose || (!robot().samples.empty() && stamp <= robot().samples.back().time)) {
      continue;  // same time with the other frame name, or a static transform
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
                          cells <= std::uint64_t{sim2d::kMaxMapCells} &&
                          cells == map->data.size() && map->info.resolution > 0.0F &&
                          std::isfinite(map->info.resolution);
  const base::Pose2 origin = planarPose(map->info.origin);
  if (!isPossible || !base::isWithinCoordinateRange(origin.position) ||
      !std::isfinite(origin.heading)) {
    ++readCounts_[channel].lost;
    --readCounts_[channel].read;
    readCounts_[channel].first = "its size does not match its cells, or there are too many cells";
    return;
  }
  std::vector<std::int8_t> values = map->data;
  for (std::int8_t& value : values) {
    value = value < -1 || value > 100 ? std::int8_t{-1} : value;
  }
  map_ = sim2d::OccupancyGrid(static_cast<int>(map->info.width), static_cast<int>(map->info.height),
                              shortestDecimal(map->info.resolution), origin, std::move(values));
}

void BagBodies::takeGoal(std::size_t channel, std::string_view bytes) {
  const auto pose = decoded<geometry_msgs::PoseStamped>(channel, bytes);
  if (!pose ||
      !invalid_.areValid(channel, "pose.position", {pose->pose.position.x, pose->pose.position.y},
                         kMostMetres, InvalidNumbers::Loss::Value)) {
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

/// Expects the format of hunavsim: a DELETEALL marker, then one closed line strip per outline.
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
      if (invalid_.areValid(channel, "points", {point.x, point.y}, kMostMetres,
                            InvalidNumbers::Loss::Value)) {
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
  for (const auto& [channel, losses] : readCounts_) {
    const std::string& topic = bag_.channels()[channel].topic;
    if (losses.lost > 0) {
      problems.push_back(
          base::warning("bag.bad-messages", {losses.lost, topic, losses.first}, path_));
    }
    if (losses.read == 0) {
      problems.push_back(base::warning("bag.no-messages", {topic}, path_));
    }
  }
  base::append(problems, invalid_.warnings(bag_.channels(), path_));
  for (const auto& [frame, count] : unknownFrames_) {
    problems.push_back(base::warning("bag.moved-frame", {count, frame}, path_));
  }
  return problems;
}

}  // namespace bridge
