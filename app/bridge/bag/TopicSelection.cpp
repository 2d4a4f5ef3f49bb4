#include <algorithm>
#include <string>
#include <string_view>

#include "app/bridge/bag/BagBodies.h"
#include "app/bridge/messages/nav_msgs.h"
#include "app/bridge/messages/people_msgs.h"
#include "app/bridge/messages/visualization_msgs.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"

namespace bridge {
namespace {

using Names = std::vector<std::string>;

// Suitable types, best first.
const Names kPeopleTypes = {hunav_msgs::Agents::kType, people_msgs::People::kType};
const Names kRobotTypes = {
    hunav_msgs::Agent::kType, nav_msgs::Odometry::kType, geometry_msgs::PoseStamped::kType,
    geometry_msgs::PoseWithCovarianceStamped::kType, tf2_msgs::TFMessage::kType};
const Names kMapTypes = {nav_msgs::OccupancyGrid::kType};
// Topics of these types with other purposes.
const Names kNotChosen = {"/goal_pose", "/initialpose", "/goal", "/global_costmap/costmap",
                          "/local_costmap/costmap"};

constexpr const char* kGoalPose = "/goal_pose";
constexpr const char* kObstacles = "/obstacles";

bool contains(const std::string& word, const Names& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// `name`: given by the user, with or without the leading slash.
bool isNamed(const std::string& topic, const std::string& name) {
  return !name.empty() && (topic == name || topic == "/" + name);
}

/// The namespace of a topic: "/robot2" for "/robot2/odom", "" for "/odom".
std::string spaceOf(const std::string& topic) {
  const std::size_t slash = topic.rfind('/');
  return slash == std::string::npos ? std::string() : topic.substr(0, slash);
}

/// Whether the topic contains the goals of a robot or the outlines of obstacles.
bool isGoalOrObstacleTopic(const BagChannel& channel) {
  return (channel.type == geometry_msgs::PoseStamped::kType &&
          base::endsWith(channel.topic, kGoalPose)) ||
         (channel.type == visualization_msgs::MarkerArray::kType && channel.topic == kObstacles);
}

class TopicSelector {
 public:
  TopicSelector(const std::vector<BagChannel>& channels, const std::string& path,
                base::Diagnostics& problems)
      : channels_(channels), path_(path), problems_(problems) {}

  /// The topic with this name and one of these types; without a name, the first topic of the best
  /// type.
  std::optional<std::size_t> choose(const std::string& name, const Names& types) {
    return name.empty() ? firstOf(types) : named(name, types);
  }

  /// The topic with exactly this name and type.
  std::optional<std::size_t> find(const std::string& topic, const char* type) const {
    return indexIf(
        [&](const BagChannel& each) { return each.topic == topic && each.type == type; });
  }

  /// The goal topic in the robot's namespace, otherwise the one without a namespace unless another
  /// robot uses it.
  std::optional<std::size_t> goalsOf(std::size_t robot) const {
    const char* const type = geometry_msgs::PoseStamped::kType;
    const std::string& topic = channels_[robot].topic;
    const std::optional<std::size_t> beside = find(spaceOf(topic) + kGoalPose, type);
    const std::string name = topic.substr(spaceOf(topic).size());
    return beside || find(name, channels_[robot].type.c_str()) ? beside : find(kGoalPose, type);
  }

  /// Warns about robots on other topics of the same type, which are not evaluated.
  void warnOfOtherRobots(std::size_t robot) {
    Names otherTopics;
    for (const std::size_t k : allOf(channels_[robot].type)) {
      if (k != robot) {
        otherTopics.push_back(channels_[k].topic);
      }
    }
    if (!otherTopics.empty()) {
      problems_.push_back(base::warning(
          "bag.other-robots",
          {otherTopics.size(), base::join(otherTopics, ", "), channels_[robot].topic}, path_));
    }
  }

  std::vector<std::size_t> allOf(const std::string& type) const {
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < channels_.size(); ++k) {
      if (channels_[k].type == type) {
        all.push_back(k);
      }
    }
    return all;
  }

 private:
  std::optional<std::size_t> firstOf(const Names& types) const {
    std::optional<std::size_t> first;
    for (auto type = types.begin(); type != types.end() && !first; ++type) {
      first = indexIf([&](const BagChannel& each) {
        return each.type == *type && !contains(each.topic, kNotChosen);
      });
    }
    return first;
  }

  template <class Condition>
  std::optional<std::size_t> indexIf(Condition condition) const {
    const BagChannel* const found = base::findIf(channels_, condition);
    return found == nullptr ? std::nullopt
                            : std::optional(static_cast<std::size_t>(found - channels_.data()));
  }

  std::optional<std::size_t> named(const std::string& name, const Names& types) {
    const std::optional<std::size_t> found =
        indexIf([&](const BagChannel& each) { return isNamed(each.topic, name); });
    if (found) {
      const BagChannel& channel = channels_[*found];
      if (!contains(channel.type, types)) {
        problems_.push_back(base::error(
            "bag.wrong-type", {channel.topic, channel.type, base::join(types, " or ")}, path_));
      }
      return found;
    }
    Names topics;
    for (const BagChannel& channel : channels_) {
      topics.push_back(channel.topic);
    }
    problems_.push_back(base::error(
        "bag.no-topic", {name, base::nearestName(name, topics), base::join(topics, ", ")}, path_));
    return std::nullopt;
  }

  const std::vector<BagChannel>& channels_;
  const std::string& path_;
  base::Diagnostics& problems_;
};

}  // namespace

base::Result<BagTopicOptions> parseBagTopicOptions(const std::string& text) {
  BagTopicOptions use;
  base::Diagnostics wrong;
  const std::vector<std::string> words =
      text.empty() ? std::vector<std::string>() : base::split(text, ',');
  for (const std::string& word : words) {
    const std::size_t middle = word.find('=');
    const std::string key = word.substr(0, middle);
    const std::string name = middle == std::string::npos ? "" : word.substr(middle + 1);
    std::string* const to = key == "people"  ? &use.people
                            : key == "robot" ? &use.robot
                            : key == "map"   ? &use.map
                                             : nullptr;
    if (to == nullptr || name.empty()) {
      wrong.push_back(base::error("bag.topic-use", {word}));
    } else {
      *to = name;
    }
  }
  return wrong.empty() ? base::Result<BagTopicOptions>(use) : base::Result<BagTopicOptions>(wrong);
}

TopicSelection hunavsimTopics(const std::vector<BagChannel>& channels) {
  TopicSelection choice;
  for (std::size_t k = 0; k < channels.size(); ++k) {
    if (channels[k].topic == "/human_states" && channels[k].type == hunav_msgs::Agents::kType) {
      choice.people = k;
    } else if (channels[k].type == hunav_msgs::Agent::kType) {
      choice.robots.push_back(k);
    }
  }
  return choice;
}

bool isUsableTopic(const BagChannel& channel, const BagTopicOptions& use) {
  const bool isSuitableType = contains(channel.type, kPeopleTypes) ||
                              contains(channel.type, kRobotTypes) ||
                              contains(channel.type, kMapTypes);
  const std::string& topic = channel.topic;
  const bool isAsked =
      isNamed(topic, use.people) || isNamed(topic, use.robot) || isNamed(topic, use.map);
  return (isSuitableType && (isAsked || !contains(topic, kNotChosen))) ||
         isGoalOrObstacleTopic(channel);
}

TopicSelection selectTopics(const std::vector<BagChannel>& channels, const BagTopicOptions& use,
                            const std::string& path, base::Diagnostics& problems) {
  TopicSelector chooser(channels, path, problems);
  TopicSelection choice;
  choice.people = chooser.choose(use.people, kPeopleTypes);
  const std::optional<std::size_t> robot = chooser.choose(use.robot, kRobotTypes);
  choice.map = chooser.choose(use.map, kMapTypes);
  choice.transforms = chooser.allOf(tf2_msgs::TFMessage::kType);
  choice.isRobotFromTf = robot && channels[*robot].type == tf2_msgs::TFMessage::kType;
  if (robot && !choice.isRobotFromTf) {
    choice.robots = {*robot};
  }
  if (robot && use.robot.empty() && channels[*robot].type == hunav_msgs::Agent::kType) {
    chooser.warnOfOtherRobots(*robot);
  }
  choice.goals = robot ? chooser.goalsOf(*robot) : std::nullopt;
  choice.obstacles = chooser.find(kObstacles, visualization_msgs::MarkerArray::kType);
  if (!choice.people && !robot && !base::hasErrors(problems)) {
    Names known = kPeopleTypes;
    known.insert(known.end(), kRobotTypes.begin(), kRobotTypes.end());
    problems.push_back(base::error("bag.no-people-or-robot", {base::join(known, ", ")}, path));
  }
  return choice;
}

}  // namespace bridge
