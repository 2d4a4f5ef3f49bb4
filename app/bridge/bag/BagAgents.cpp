#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/bridge/bag/BagBodies.h"
#include "app/bridge/topics/RunMessages.h"
#include "sim2d/base/Text.h"

/// The part of BagBodies that reads hunav_msgs.
namespace bridge {
namespace {

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

}  // namespace

double shortestDecimal(float value) {
  char text[32];
  const std::to_chars_result end = std::to_chars(text, text + sizeof(text), value);
  return base::parseDouble({text, static_cast<std::size_t>(end.ptr - text)}).value_or(value);
}

bool BagBodies::isValid(std::size_t channel, const hunav_msgs::Agent& agent) {
  const geometry_msgs::Point& place = agent.position.position;
  const geometry_msgs::Vector3& velocity = agent.velocity.linear;
  return invalid_.areValid(channel, "position", {place.x, place.y}, kMostMetres) &&
         invalid_.areValid(channel, "yaw", {static_cast<double>(agent.yaw)}, kMostSpeed) &&
         invalid_.areValid(channel, "velocity.linear", {velocity.x, velocity.y}, kMostSpeed) &&
         invalid_.areValid(channel, "velocity.angular", {agent.velocity.angular.z}, kMostSpeed) &&
         invalid_.areValid(channel, "linear_vel", {static_cast<double>(agent.linearVel)},
                           kMostSpeed) &&
         invalid_.areValid(channel, "angular_vel", {static_cast<double>(agent.angularVel)},
                           kMostSpeed);
}

std::vector<base::Vec2> BagBodies::obstaclesOf(std::size_t channel,
                                               const hunav_msgs::Agent& agent) {
  std::vector<base::Vec2> points;
  points.reserve(agent.closestObs.size());
  for (const geometry_msgs::Point& point : agent.closestObs) {
    if (invalid_.areValid(channel, "closest_obs", {point.x, point.y}, kMostMetres,
                          InvalidNumbers::Loss::Value)) {
      points.emplace_back(point.x, point.y);
    }
  }
  return points;
}

/// Sets the properties that earlier messages left unset.
void BagBodies::setMissing(std::size_t channel, const hunav_msgs::Agent& agent, BagBody& body) {
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
    const bool isValid = invalid_.areValid(channel, field, {static_cast<double>(from)}, most,
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
    if (invalid_.areValid(channel, "goals", {goal.position.x, goal.position.y}, kMostMetres,
                          InvalidNumbers::Loss::Value)) {
      addGoal(goal, properties.goals);
    }
  }
}

void BagBodies::takeAgent(std::size_t channel, const hunav_msgs::Agent& agent, std::int64_t time,
                          std::map<int, BagBody>& to) {
  if (!isValid(channel, agent)) {
    return;
  }
  BagBody& body = to[agent.id];
  body.id = agent.id;
  body.name = body.name.empty() ? agent.name : body.name;
  setMissing(channel, agent, body);
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
  sample.obstacles = obstaclesOf(channel, agent);
  body.samples.push_back(std::move(sample));
}

void BagBodies::takeAgents(std::size_t channel, std::string_view bytes, std::int64_t time) {
  const std::optional<hunav_msgs::Agents> all = decoded<hunav_msgs::Agents>(channel, bytes);
  if (!all) {
    return;
  }
  const std::int64_t stamp = nanosecondsOf(all->header.stamp);
  peopleStamps_.emplace_back(time, stamp);
  for (const hunav_msgs::Agent& agent : all->agents) {
    takeAgent(channel, agent, stamp, people_);
  }
}

/// robot_states has no stamp. Each sample gets the stamp of the people message recorded nearest to
/// it.
void BagBodies::assignRobotStamps() {
  std::sort(peopleStamps_.begin(), peopleStamps_.end());
  for (auto& [id, body] : robots_) {
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

}  // namespace bridge
