#include "app/bridge/bag/BagBodies.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/nav_msgs.h"
#include "app/bridge/messages/people_msgs.h"
#include "app/bridge/messages/visualization_msgs.h"
#include "app/bridge/topics/RunMessages.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"

namespace bridge {
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

/// Collects the bodies, map, goals and obstacles.
class BodyReader {
 public:
  BodyReader(Bag& bag, const TopicSelection& selection, const std::string& path)
      : bag_(bag), selection_(selection), path_(path) {}

  BagBodies read(base::Diagnostics& problems) {
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
    base::append(problems,
                 bag_.read(wanted, [this](std::size_t channel, std::int64_t time,
                                          std::string_view bytes) { take(channel, time, bytes); }));
    assignRobotStamps();
    base::append(problems, losses());
    found_.hasInvalidSamples = invalid_.hasDiscardedSamples();
    return std::move(found_);
  }

 private:
  struct ReadCounts {
    std::size_t read = 0, lost = 0;
    std::string first;  // first error
  };

  void take(std::size_t channel, std::int64_t recorded, std::string_view bytes) {
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
  template <class M>
  std::optional<M> decoded(std::size_t channel, std::string_view bytes) {
    ReadCounts& losses = readCounts_[channel];
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
  void takeAgents(std::size_t channel, std::string_view bytes, std::int64_t time) {
    const std::optional<hunav_msgs::Agents> all = decoded<hunav_msgs::Agents>(channel, bytes);
    if (!all) {
      return;
    }
    const std::int64_t stamp = nanosecondsOf(all->header.stamp);
    peopleStamps_.emplace_back(time, stamp);
    for (const hunav_msgs::Agent& agent : all->agents) {
      addAgent(channel, agent, stamp, invalid_, found_.people);
    }
  }
  /// Messages of HuNavSim have tags; then position.z is the heading and velocity.z the angular
  /// velocity.
  void takePeople(std::size_t channel, std::string_view bytes) {
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
      BagBody& body = found_.people[known];
      body.id = known;
      body.name = person.name;
      if (const std::optional<int> type = tagOf(person, "behavior"); type && !body.properties) {
        body.properties.emplace().behavior.type =
            static_cast<std::uint8_t>(std::clamp(*type, 1, 6));
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
  bool isValid(std::size_t channel, const people_msgs::Person& person, bool hasTurning) {
    const geometry_msgs::Point& place = person.position;
    const geometry_msgs::Point& velocity = person.velocity;
    return invalid_.areValid(channel, "position", {place.x, place.y, hasTurning ? place.z : 0.0},
                             kMostMetres) &&
           invalid_.areValid(channel, "velocity",
                             {velocity.x, velocity.y, hasTurning ? velocity.z : 0.0}, kMostSpeed);
  }
  void takeRobot(std::size_t channel, std::int64_t time, std::string_view bytes) {
    const std::string& type = bag_.channels()[channel].type;
    if (type == hunav_msgs::Agent::kType) {
      if (const auto agent = decoded<hunav_msgs::Agent>(channel, bytes)) {
        addAgent(channel, *agent, time, invalid_, found_.robots);
      }
    } else if (type == nav_msgs::Odometry::kType) {
      if (const auto odometry = decoded<nav_msgs::Odometry>(channel, bytes)) {
        takeOdometry(channel, *odometry);
      }
    } else if (type == geometry_msgs::PoseStamped::kType) {
      if (const auto pose = decoded<geometry_msgs::PoseStamped>(channel, bytes)) {
        takePose(channel, pose->header, pose->pose);
      }
    } else if (const auto pose =
                   decoded<geometry_msgs::PoseWithCovarianceStamped>(channel, bytes)) {
      takePose(channel, pose->header, pose->pose.pose);
    }
  }
  void takeOdometry(std::size_t channel, const nav_msgs::Odometry& odometry) {
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
  bool takePose(std::size_t channel, const std_msgs::Header& header,
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
    sample.pose = {frame.toWorld(inFrame.position),
                   base::wrapToPi(frame.heading + inFrame.heading)};
    sample.heading = sample.pose.heading;
    robot().samples.push_back(sample);
    return true;
  }
  void takeTransforms(std::size_t channel, std::string_view bytes) {
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
      const bool isRobot =
          each.childFrameId == "base_footprint" || each.childFrameId == "base_link";
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
  void takeMap(std::size_t channel, std::string_view bytes) {
    const auto map = decoded<nav_msgs::OccupancyGrid>(channel, bytes);
    if (!map) {
      return;
    }
    const std::uint64_t cells = std::uint64_t{map->info.width} * map->info.height;
    const bool isPossible = map->info.width <= kWidest && map->info.height <= kWidest &&
                            cells > 0 && cells <= std::uint64_t{sim2d::kMaxMapCells} &&
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
    found_.map =
        sim2d::OccupancyGrid(static_cast<int>(map->info.width), static_cast<int>(map->info.height),
                             shortestDecimal(map->info.resolution), origin, std::move(values));
  }
  void takeGoal(std::size_t channel, std::string_view bytes) {
    const auto pose = decoded<geometry_msgs::PoseStamped>(channel, bytes);
    if (!pose ||
        !invalid_.areValid(channel, "pose.position", {pose->pose.position.x, pose->pose.position.y},
                           kMostMetres, InvalidNumbers::Loss::Value)) {
      return;
    }
    const base::Vec2 goal =
        toMap(pose->header.frameId).toWorld({pose->pose.position.x, pose->pose.position.y});
    found_.firstGoal = found_.firstGoal.value_or(nanosecondsOf(pose->header.stamp));
    const auto isSame = [&](const base::Vec2& other) { return (goal - other).norm() < kSamePlace; };
    if (std::none_of(found_.goals.begin(), found_.goals.end(), isSame)) {
      found_.goals.push_back(goal);
    }
  }
  /// Expects the format of hunavsim: a DELETEALL marker, then one closed line strip per outline.
  void takeObstacles(std::size_t channel, std::string_view bytes) {
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
    found_.obstacles.push_back(std::move(now));
  }
  /// The pose of a frame in the map frame. An unknown frame is treated as the map frame and
  /// counted.
  base::Pose2 toMap(const std::string& frame) {
    if (frame.empty() || frame == kMapFrame) {
      return {};
    }
    const std::optional<base::Pose2> pose = frames_.inMap(frame);
    if (!pose) {
      ++unknownFrames_[frame];
    }
    return pose.value_or(base::Pose2());
  }
  BagBody& robot() {
    BagBody& body = found_.robots[kRobot];
    body.id = kRobot;
    body.name = body.name.empty() ? "robot1" : body.name;
    return body;
  }
  /// robot_states has no stamp. Each sample gets the stamp of the people message recorded nearest
  /// to it.
  void assignRobotStamps() {
    std::sort(peopleStamps_.begin(), peopleStamps_.end());
    for (auto& [id, body] : found_.robots) {
      if (!body.properties || peopleStamps_.empty()) {
        continue;
      }
      for (BagSample& sample : body.samples) {
        auto next = std::lower_bound(peopleStamps_.begin(), peopleStamps_.end(),
                                     std::make_pair(sample.time, std::int64_t{0}));
        const bool isLast = next == peopleStamps_.end();
        if (isLast || (next != peopleStamps_.begin() &&
                       sample.time - std::prev(next)->first < next->first - sample.time)) {
          --next;
        }
        sample.time = next->second;
      }
    }
  }
  base::Diagnostics losses() const {
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

  Bag& bag_;
  const TopicSelection& selection_;
  const std::string& path_;
  FrameTree frames_;
  BagBodies found_;
  InvalidNumbers invalid_;
  std::map<std::size_t, ReadCounts> readCounts_;      // by channel
  std::map<std::string, std::size_t> unknownFrames_;  // frames without a transform to map
  std::map<std::string, int> named_;                  // ids assigned to people by name
  std::vector<std::pair<std::int64_t, std::int64_t>>
      peopleStamps_;  // [ns], recording time and stamp
};

}  // namespace

BagBodies readBodies(Bag& bag, const TopicSelection& selection, const std::string& path,
                     base::Diagnostics& problems) {
  return BodyReader(bag, selection, path).read(problems);
}

}  // namespace bridge
