#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/bridge/bag/BagBodies.h"
#include "app/bridge/topics/RunMessages.h"
#include "sim2d/base/Text.h"

/// Contents of hunav_msgs in bags.
namespace bridge {
namespace {

constexpr double kSameHeading = 1e-6;  // [rad]: precision of a float

/// The quaternion when the two agree, as it is a double. Some programs never fill it in.
double turnedBy(const hunav_msgs::Agent& agent) {
  const double turned = headingOf(agent.position.orientation);
  const double yaw = static_cast<double>(agent.yaw);
  return std::fabs(base::angleDiff(turned, yaw)) < kSameHeading ? turned : base::wrapToPi(yaw);
}

/// The twist; the speed along the heading where that alone is filled in.
base::Vec2 velocityOf(const hunav_msgs::Agent& agent, double heading) {
  const base::Vec2 velocity(agent.velocity.linear.x, agent.velocity.linear.y);
  return velocity.isZero(0.0) ? base::Vec2(asWritten(agent.linearVel) * base::directionOf(heading))
                              : velocity;
}

double turningOf(const hunav_msgs::Agent& agent) {
  const double turning = agent.velocity.angular.z;
  return turning != 0.0 ? turning : asWritten(agent.angularVel);
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

double asWritten(float value) {
  char text[32];
  const std::to_chars_result end = std::to_chars(text, text + sizeof(text), value);
  return base::parseDouble({text, static_cast<std::size_t>(end.ptr - text)}).value_or(value);
}

bool BagBodies::isFine(std::size_t channel, const hunav_msgs::Agent& agent) {
  const geometry_msgs::Point& place = agent.position.position;
  const geometry_msgs::Vector3& velocity = agent.velocity.linear;
  return bad_.areFine(channel, "position", {place.x, place.y}, kMostMetres) &&
         bad_.areFine(channel, "yaw", {static_cast<double>(agent.yaw)}, kMostSpeed) &&
         bad_.areFine(channel, "velocity.linear", {velocity.x, velocity.y}, kMostSpeed) &&
         bad_.areFine(channel, "velocity.angular", {agent.velocity.angular.z}, kMostSpeed) &&
         bad_.areFine(channel, "linear_vel", {static_cast<double>(agent.linearVel)}, kMostSpeed) &&
         bad_.areFine(channel, "angular_vel", {static_cast<double>(agent.angularVel)}, kMostSpeed);
}

std::vector<base::Vec2> BagBodies::obstaclesOf(std::size_t channel,
                                               const hunav_msgs::Agent& agent) {
  std::vector<base::Vec2> points;
  points.reserve(agent.closestObs.size());
  for (const geometry_msgs::Point& point : agent.closestObs) {
    if (bad_.areFine(channel, "closest_obs", {point.x, point.y}, kMostMetres,
                     BadNumbers::Loss::Value)) {
      points.emplace_back(point.x, point.y);
    }
  }
  return points;
}

/// Fills in what earlier messages have left open.
void BagBodies::fillIn(std::size_t channel, const hunav_msgs::Agent& agent, BagBody& body) {
  if (!body.told) {
    body.told.emplace();
    body.told->behavior = agent.behavior;
    body.told->behavior.socialForceFactor = 0.0F;
    body.told->behavior.goalForceFactor = 0.0F;
    body.told->behavior.obstacleForceFactor = 0.0F;
    body.told->behavior.otherForceFactor = 0.0F;
  }
  hunav_msgs::Agent& told = *body.told;
  const auto take = [&](float& to, float from, const char* field, double most) {
    const bool isFine =
        bad_.areFine(channel, field, {static_cast<double>(from)}, most, BadNumbers::Loss::Value);
    to = isFine && from > 0.0F ? from : to;
  };
  const auto takeFirst = [&](float& to, float from, const char* field, double most) {
    if (to == 0.0F) {
      take(to, from, field, most);
    }
  };
  takeFirst(told.radius, agent.radius, "radius", kMostRadius);
  takeFirst(told.desiredVelocity, agent.desiredVelocity, "desired_velocity", kMostSpeed);
  takeFirst(told.goalRadius, agent.goalRadius, "goal_radius", kMostFactor);
  if (!hasFactors(told.behavior)) {
    const hunav_msgs::AgentBehavior& from = agent.behavior;
    hunav_msgs::AgentBehavior& to = told.behavior;
    take(to.socialForceFactor, from.socialForceFactor, "social_force_factor", kMostFactor);
    take(to.goalForceFactor, from.goalForceFactor, "goal_force_factor", kMostFactor);
    take(to.obstacleForceFactor, from.obstacleForceFactor, "obstacle_force_factor", kMostFactor);
    take(to.otherForceFactor, from.otherForceFactor, "other_force_factor", kMostFactor);
  }
  told.cyclicGoals = told.goals.empty() ? agent.cyclicGoals : told.cyclicGoals;
  for (const geometry_msgs::Pose& goal : agent.goals) {
    if (bad_.areFine(channel, "goals", {goal.position.x, goal.position.y}, kMostMetres,
                     BadNumbers::Loss::Value)) {
      addGoal(goal, told.goals);
    }
  }
}

void BagBodies::takeAgent(std::size_t channel, const hunav_msgs::Agent& agent, std::int64_t time,
                          std::map<int, BagBody>& to) {
  if (!isFine(channel, agent)) {
    return;
  }
  BagBody& body = to[agent.id];
  body.id = agent.id;
  body.name = body.name.empty() ? agent.name : body.name;
  fillIn(channel, agent, body);
  BagSample sample;
  sample.time = time;
  sample.pose.position = {agent.position.position.x, agent.position.position.y};
  sample.pose.heading = turnedBy(agent);
  sample.heading = sample.pose.heading;
  sample.velocity = velocityOf(agent, sample.pose.heading);
  sample.omega = turningOf(agent);
  sample.group = agent.groupId;  // NOLINT(bugprone-signed-char-misuse): -1 is no group
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
  stamps_.emplace_back(time, stamp);
  for (const hunav_msgs::Agent& agent : all->agents) {
    takeAgent(channel, agent, stamp, people_);
  }
}

/// robot_states has no stamp: it gets the stamp of the people recorded nearest to it.
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

}  // namespace bridge
