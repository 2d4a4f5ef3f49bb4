#include "app/bridge/agents/StepMessages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/bridge/agents/AgentMessages.h"
#include "sim2d/base/Math.h"

namespace bridge {
namespace {

using hunav_msgs::Agent;
using visualization_msgs::Marker;

constexpr double kNoForce = 1e-4;      // [m/s²]
constexpr double kArrowWidth = 0.1;    // [m]
constexpr double kTextHeight = 1.0;    // [m] above the person
constexpr double kTextSize = 0.5;      // [m]
constexpr std::int32_t kLifetime = 1;  // [s]

constexpr std::array<const char*, 7> kBehaviors = {"REGULAR", "REGULAR", "IMPASSIVE",  "SURPRISED",
                                                   "SCARED",  "CURIOUS", "THREATENING"};

tf2_msgs::TFMessage transformOf(const Agent& agent, const std_msgs::Header& header) {
  geometry_msgs::TransformStamped transform;
  transform.header = header;
  transform.childFrameId = agent.name;
  transform.transform.translation = {agent.position.position.x, agent.position.position.y,
                                     agent.position.position.z};
  transform.transform.rotation = quaternionOf(double{agent.yaw});
  tf2_msgs::TFMessage message;
  message.transforms.push_back(std::move(transform));
  return message;
}

Marker arrow(const Agent& agent, const std_msgs::Header& header, std::int32_t number,
             const sim2d::Vec2& force, const std_msgs::ColorRGBA& color) {
  const double size = force.norm();
  Marker marker;
  marker.header = header;
  marker.ns = agent.name + "/robot_forces";
  // Unsigned, so that the largest id wraps around.
  marker.id = static_cast<std::int32_t>(static_cast<std::uint32_t>(agent.id) +
                                        static_cast<std::uint32_t>(number));
  marker.type = Marker::kArrow;
  marker.action = size > kNoForce ? Marker::kAdd : Marker::kDelete;
  marker.pose.position = agent.position.position;
  marker.pose.position.z = 0.0;
  marker.pose.orientation = quaternionOf(base::atan2(force.y(), force.x()));
  marker.scale = {std::max(kNoForce, size), kArrowWidth, kArrowWidth};
  marker.color = color;
  marker.lifetime.sec = kLifetime;
  return marker;
}

Marker label(const Agent& agent, const std_msgs::Header& header, std::size_t behavior) {
  Marker marker;
  marker.header = header;
  marker.ns = agent.name + "/behavior";
  marker.id = agent.id;
  marker.type = Marker::kTextViewFacing;
  marker.action = Marker::kAdd;
  marker.pose.position = agent.position.position;
  marker.pose.position.z += kTextHeight;
  marker.scale.z = kTextSize;
  marker.color = {1.0F, 1.0F, 1.0F, 1.0F};
  marker.lifetime.sec = kLifetime;
  marker.text = agent.name + "/" + kBehaviors.at(std::min(behavior, kBehaviors.size() - 1));
  return marker;
}

void addForces(const Agent& agent, const std_msgs::Header& header, const sim2d::CoupledWorld& world,
               std::vector<Marker>& to) {
  const int human = world.view().indexOf(agent.id);
  const auto at = static_cast<std::size_t>(human);
  const sim2d::ForceColumns& all = world.forces();
  if (human < 0 || at >= all.goal.size()) {
    return;
  }
  const sim2d::Vec2 sum = all.goal[at] + all.social[at] + all.obstacle[at] + all.group[at];
  to.push_back(arrow(agent, header, 1, all.obstacle[at], {1.0F, 0.0F, 0.0F, 1.0F}));
  to.push_back(arrow(agent, header, 2, all.social[at], {0.0F, 0.0F, 1.0F, 1.0F}));
  to.push_back(arrow(agent, header, 3, all.goal[at], {0.0F, 1.0F, 0.0F, 1.0F}));
  to.push_back(arrow(agent, header, 4, sum, {1.0F, 1.0F, 1.0F, 1.0F}));
  to.push_back(
      label(agent, header, static_cast<std::size_t>(world.view().constants(human).behavior)));
}

people_msgs::Person personWithTags(const Agent& agent) {
  people_msgs::Person person;
  person.name = agent.name;
  const double yaw = double{agent.yaw};
  const double speed = double{agent.linearVel};
  const base::SinCos along = base::sinCos(std::isfinite(yaw) ? yaw : 0.0);
  person.position = {agent.position.position.x, agent.position.position.y, yaw};
  person.velocity = {speed * along.cos, speed * along.sin, double{agent.angularVel}};
  person.reliability = 1.0;
  person.tagnames = {"id", "group_id", "behavior"};
  person.tags = {std::to_string(agent.id), std::to_string(agent.groupId),
                 std::to_string(agent.behavior.type)};
  return person;
}

}  // namespace

StepMessages topicsOf(hunav_msgs::Agents agents, Agent robot, const sim2d::CoupledWorld& world) {
  StepMessages topics;
  const std_msgs::Header& header = agents.header;
  if (robotOf(robot) && !robot.name.empty()) {
    topics.transforms.push_back(transformOf(robot, header));
  }
  topics.people.header = header;
  for (const Agent& agent : agents.agents) {
    if (!agent.name.empty() && invalidReason(agent).empty()) {
      topics.transforms.push_back(transformOf(agent, header));
    }
    addForces(agent, header, world, topics.forces.markers);
    topics.people.people.push_back(personWithTags(agent));
  }
  topics.humans = std::move(agents);
  topics.robot = std::move(robot);
  return topics;
}

}  // namespace bridge
