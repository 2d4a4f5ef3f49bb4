#include "app/bridge/agents/AgentMessages.h"

#include <cmath>

#include "sim2d/base/Math.h"

namespace bridge {
namespace {

constexpr double kFarthest = 1e6;  // [m]

bool isUsable(double value, double most) {
  return std::isfinite(value) && std::fabs(value) <= most;
}

}  // namespace

std::string invalidReason(const hunav_msgs::Agent& agent) {
  const geometry_msgs::Twist& v = agent.velocity;
  if (!isUsable(agent.position.position.x, kFarthest) ||
      !isUsable(agent.position.position.y, kFarthest)) {
    return "position is not finite or beyond 1e6 m";
  }
  if (!isUsable(agent.yaw, 1e5)) {
    return "yaw is not finite or beyond 1e5 rad";
  }
  if (!isUsable(v.linear.x, sim2d::kMaxPlausibleSpeed) ||
      !isUsable(v.linear.y, sim2d::kMaxPlausibleSpeed)) {
    return "velocity is not finite or above 1000 m/s";
  }
  return {};
}

sim2d::CoupledPerson personOf(const hunav_msgs::Agent& agent) {
  sim2d::CoupledPerson person;
  person.id = agent.id;
  person.pose = {{agent.position.position.x, agent.position.position.y}, double{agent.yaw}};
  person.velocity = {agent.velocity.linear.x, agent.velocity.linear.y};
  person.omega = std::isfinite(agent.velocity.angular.z) ? agent.velocity.angular.z : 0.0;
  for (const geometry_msgs::Point& point : agent.closestObs) {
    if (isUsable(point.x, kFarthest) && isUsable(point.y, kFarthest)) {
      person.obstacles.emplace_back(point.x, point.y);
    }
  }
  return person;
}

std::optional<sim2d::CoupledRobot> robotOf(const hunav_msgs::Agent& robot) {
  if (robot.type == 0 && robot.name.empty()) {
    return std::nullopt;
  }
  constexpr double kLargestRadius = 100.0;  // [m]
  const sim2d::CoupledPerson body = personOf(robot);
  sim2d::CoupledRobot known;
  known.name = robot.name;
  known.pose = body.pose;
  known.velocity = body.velocity;
  known.omega = body.omega;
  if (robot.radius > 0.0F && double{robot.radius} <= kLargestRadius) {
    known.radius = double{robot.radius};
  }
  return known;
}

void setBehavior(const sim2d::ResolvedHuman& person, hunav_msgs::AgentBehavior& to) {
  to.type = static_cast<std::uint8_t>(person.behavior);
  to.duration = static_cast<float>(person.reactionDuration);
  to.once = person.reactionOnce;
  to.vel = static_cast<float>(person.reactionSpeed);
  to.dist = static_cast<float>(person.noticeDistance);
  to.socialForceFactor = static_cast<float>(person.socialFactor);
  to.goalForceFactor = static_cast<float>(person.goalFactor);
  to.obstacleForceFactor = static_cast<float>(person.obstacleFactor);
  to.otherForceFactor = static_cast<float>(person.otherFactor);
}

hunav_msgs::Agent responseFor(const hunav_msgs::Agent& asked, const sim2d::CoupledWorld& world,
                              int human) {
  const sim2d::ResolvedHuman& person = world.view().constants(human);
  const sim2d::Pose2 pose = world.view().pose(human);
  const sim2d::Vec2 velocity = world.view().velocity(human);
  hunav_msgs::Agent response = asked;
  response.type = hunav_msgs::Agent::kPerson;
  response.position.position.x = pose.position.x();
  response.position.position.y = pose.position.y();
  response.position.orientation = quaternionOf(pose.heading);
  response.yaw = static_cast<float>(pose.heading);
  response.linearVel = static_cast<float>(velocity.norm());
  response.angularVel = static_cast<float>(world.omega(human));
  response.velocity = {};
  response.velocity.linear.x = velocity.x();
  response.velocity.linear.y = velocity.y();
  response.velocity.angular.z = world.omega(human);
  response.desiredVelocity = static_cast<float>(person.desiredSpeed);
  response.radius = static_cast<float>(person.radius);
  response.goalRadius = static_cast<float>(person.goalRadius);
  response.cyclicGoals = person.cyclicGoals;
  setBehavior(person, response.behavior);
  response.behavior.state = world.isActive(human) ? hunav_msgs::AgentBehavior::kBehActive1
                                                  : hunav_msgs::AgentBehavior::kBehNoActive;
  response.closestObs.clear();
  const std::vector<sim2d::GoalItem>& goals = world.control(human).goals;
  if (!goals.empty()) {
    response.goals.clear();
  }
  for (const sim2d::GoalItem& goal : goals) {
    response.goals.push_back({{goal.position.x(), goal.position.y(), 0.0}, {}});
  }
  return response;
}

geometry_msgs::Quaternion quaternionOf(double yaw) {
  const base::SinCos half = base::sinCos(yaw / 2.0);
  geometry_msgs::Quaternion turn;
  turn.z = half.sin;
  turn.w = half.cos;
  return turn;
}

}  // namespace bridge
