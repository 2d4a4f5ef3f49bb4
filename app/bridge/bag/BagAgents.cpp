#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "app/bridge/bag/BagBodies.h"
#include "app/bridge/topics/RunMessages.h"
#include "sim2d/base/Text.h"

/// Checks of numbers, frames and hunav_msgs for the reading of bodies.
namespace bridge {
namespace {

constexpr int kLongestChain = 32;

/// Removes a leading slash, which some programs write.
std::string nameOf(const std::string& frame) {
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

base::Pose2 composed(const base::Pose2& outer, const base::Pose2& inner) {
  return {outer.toWorld(inner.position), base::wrapToPi(outer.heading + inner.heading)};
}

constexpr double kSameHeading = 1e-6;  // [rad], float precision

/// The heading of the quaternion (double precision) if it agrees with yaw, otherwise yaw: some
/// programs do not set the quaternion.
double headingOfAgent(const hunav_msgs::Agent& agent) {
  const double turned = headingOf(agent.position.orientation);
  const double yaw = static_cast<double>(agent.yaw);
  return std::fabs(base::angleDiff(turned, yaw)) < kSameHeading ? turned : base::wrapToPi(yaw);
}

/// The linear velocity of the twist, or linear_vel along the heading if the twist is not set.
base::Vec2 velocityOf(const hunav_msgs::Agent& agent, double heading) {
  const base::Vec2 velocity(agent.velocity.linear.x, agent.velocity.linear.y);
  return velocity.isZero(0.0)
             ? base::Vec2(shortestDecimal(agent.linearVel) * base::directionOf(heading))
             : velocity;
}

double angularVelocityOf(const hunav_msgs::Agent& agent) {
  const double turning = agent.velocity.angular.z;
  return turning != 0.0 ? turning : shortestDecimal(agent.angularVel);
}

bool hasFactors(const hunav_msgs::AgentBehavior& behavior) {
  return behavior.socialForceFactor != 0.0F || behavior.goalForceFactor != 0.0F ||
         behavior.obstacleForceFactor != 0.0F || behavior.otherForceFactor != 0.0F;
}

void addGoal(const geometry_msgs::Pose& goal, std::vector<geometry_msgs::Pose>& to) {
  const auto isSame = [&](const geometry_msgs::Pose& other) {
    return std::hypot(goal.position.x - other.position.x, goal.position.y - other.position.y) <
           kSamePlace;
  };
  if (std::none_of(to.begin(), to.end(), isSame)) {
    to.push_back(goal);
  }
}

bool isValid(std::size_t channel, const hunav_msgs::Agent& agent, InvalidNumbers& invalid) {
  const geometry_msgs::Point& place = agent.position.position;
  const geometry_msgs::Vector3& velocity = agent.velocity.linear;
  return invalid.areValid(channel, "position", {place.x, place.y}, kMostMetres) &&
         invalid.areValid(channel, "yaw", {static_cast<double>(agent.yaw)}, kMostSpeed) &&
         invalid.areValid(channel, "velocity.linear", {velocity.x, velocity.y}, kMostSpeed) &&
         invalid.areValid(channel, "velocity.angular", {agent.velocity.angular.z}, kMostSpeed) &&
         invalid.areValid(channel, "linear_vel", {static_cast<double>(agent.linearVel)},
                          kMostSpeed) &&
         invalid.areValid(channel, "angular_vel", {static_cast<double>(agent.angularVel)},
                          kMostSpeed);
}

std::vector<base::Vec2> obstaclesOf(std::size_t channel, const hunav_msgs::Agent& agent,
                                    InvalidNumbers& invalid) {
  std::vector<base::Vec2> points;
  points.reserve(agent.closestObs.size());
  for (const geometry_msgs::Point& point : agent.closestObs) {
    if (invalid.areValid(channel, "closest_obs", {point.x, point.y}, kMostMetres,
                         InvalidNumbers::Loss::Value)) {
      points.emplace_back(point.x, point.y);
    }
  }
  return points;
}

/// Sets the properties that earlier messages left unset.
void setMissing(std::size_t channel, const hunav_msgs::Agent& agent, InvalidNumbers& invalid,
                BagBody& body) {
  if (!body.properties) {
    body.properties.emplace();
    body.properties->behavior = agent.behavior;
    body.properties->behavior.socialForceFactor = 0.0F;
    body.properties->behavior.goalForceFactor = 0.0F;
    body.properties->behavior.obstacleForceFactor = 0.0F;
    body.properties->behavior.otherForceFactor = 0.0F;
  }
  hunav_msgs::Agent& properties = *body.properties;
  const auto take = [&](float& to, float from, const char* field, double most) {
    const bool isValid = invalid.areValid(channel, field, {static_cast<double>(from)}, most,
                                          InvalidNumbers::Loss::Value);
    to = isValid && from > 0.0F ? from : to;
  };
  const auto takeFirst = [&](float& to, float from, const char* field, double most) {
    if (to == 0.0F) {
      take(to, from, field, most);
    }
  };
  takeFirst(properties.radius, agent.radius, "radius", kMostRadius);
  takeFirst(properties.desiredVelocity, agent.desiredVelocity, "desired_velocity", kMostSpeed);
  takeFirst(properties.goalRadius, agent.goalRadius, "goal_radius", kMostFactor);
  if (!hasFactors(properties.behavior)) {
    const hunav_msgs::AgentBehavior& from = agent.behavior;
    hunav_msgs::AgentBehavior& to = properties.behavior;
    take(to.socialForceFactor, from.socialForceFactor, "social_force_factor", kMostFactor);
    take(to.goalForceFactor, from.goalForceFactor, "goal_force_factor", kMostFactor);
    take(to.obstacleForceFactor, from.obstacleForceFactor, "obstacle_force_factor", kMostFactor);
    take(to.otherForceFactor, from.otherForceFactor, "other_force_factor", kMostFactor);
  }
  properties.cyclicGoals = properties.goals.empty() ? agent.cyclicGoals : properties.cyclicGoals;
  for (const geometry_msgs::Pose& goal : agent.goals) {
    if (invalid.areValid(channel, "goals", {goal.position.x, goal.position.y}, kMostMetres,
                         InvalidNumbers::Loss::Value)) {
      addGoal(goal, properties.goals);
    }
  }
}

}  // namespace

void addAgent(std::size_t channel, const hunav_msgs::Agent& agent, std::int64_t time,
              InvalidNumbers& invalid, std::map<int, BagBody>& to) {
  if (!isValid(channel, agent, invalid)) {
    return;
  }
  BagBody& body = to[agent.id];
  body.id = agent.id;
  body.name = body.name.empty() ? agent.name : body.name;
  setMissing(channel, agent, invalid, body);
  BagSample sample;
  sample.time = time;
  sample.pose.position = {agent.position.position.x, agent.position.position.y};
  sample.pose.heading = headingOfAgent(agent);
  sample.heading = sample.pose.heading;
  sample.velocity = velocityOf(agent, sample.pose.heading);
  sample.omega = angularVelocityOf(agent);
  sample.group = agent.groupId;  // NOLINT(bugprone-signed-char-misuse): -1 means no group
  sample.state = agent.behavior.state;
  if (!agent.goals.empty()) {
    sample.goal = base::Vec2(agent.goals.front().position.x, agent.goals.front().position.y);
  }
  sample.obstacles = obstaclesOf(channel, agent, invalid);
  body.samples.push_back(std::move(sample));
}

double shortestDecimal(float value) {
  char text[32];
  const std::to_chars_result end = std::to_chars(text, text + sizeof(text), value);
  return base::parseDouble({text, static_cast<std::size_t>(end.ptr - text)}).value_or(value);
}

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

}  // namespace bridge
