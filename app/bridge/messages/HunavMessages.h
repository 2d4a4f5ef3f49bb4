#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/bridge/messages/GeometryMessages.h"

/// Messages of hunav_msgs 2.0 (identical in 1.5, different in earlier 1.x), and of people_msgs.
/// Field names, types and order match the ROS 2 Humble .msg and .srv files.
namespace bridge::hunav_msgs {

/// Units: duration [s], vel [m/s], dist [m].
struct AgentBehavior {
  static constexpr const char* kType = "hunav_msgs/msg/AgentBehavior";
  static constexpr std::uint8_t kBehRegular = 1;
  static constexpr std::uint8_t kBehImpassive = 2;
  static constexpr std::uint8_t kBehSurprised = 3;
  static constexpr std::uint8_t kBehScared = 4;
  static constexpr std::uint8_t kBehCurious = 5;
  static constexpr std::uint8_t kBehThreatening = 6;
  static constexpr std::uint8_t kBehNoActive = 0;
  static constexpr std::uint8_t kBehActive1 = 1;
  static constexpr std::uint8_t kBehActive2 = 2;
  static constexpr std::uint8_t kBehConfDefault = 0;
  static constexpr std::uint8_t kBehConfCustom = 1;
  static constexpr std::uint8_t kBehConfRandomNormal = 2;
  static constexpr std::uint8_t kBehConfRandomUniform = 3;

  std::uint8_t type = 0;
  std::uint8_t state = 0;
  std::uint8_t configuration = 0;
  float duration = 0;
  bool once = false;
  float vel = 0;
  float dist = 0;
  float socialForceFactor = 0;
  float goalForceFactor = 0;
  float obstacleForceFactor = 0;
  float otherForceFactor = 0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("type", self.type);
    field("state", self.state);
    field("configuration", self.configuration);
    field("duration", self.duration);
    field("once", self.once);
    field("vel", self.vel);
    field("dist", self.dist);
    field("social_force_factor", self.socialForceFactor);
    field("goal_force_factor", self.goalForceFactor);
    field("obstacle_force_factor", self.obstacleForceFactor);
    field("other_force_factor", self.otherForceFactor);
  }
  template <class F>
  static void constants(F&& constant) {
    constant("BEH_REGULAR", kBehRegular);
    constant("BEH_IMPASSIVE", kBehImpassive);
    constant("BEH_SURPRISED", kBehSurprised);
    constant("BEH_SCARED", kBehScared);
    constant("BEH_CURIOUS", kBehCurious);
    constant("BEH_THREATENING", kBehThreatening);
    constant("BEH_NO_ACTIVE", kBehNoActive);
    constant("BEH_ACTIVE_1", kBehActive1);
    constant("BEH_ACTIVE_2", kBehActive2);
    constant("BEH_CONF_DEFAULT", kBehConfDefault);
    constant("BEH_CONF_CUSTOM", kBehConfCustom);
    constant("BEH_CONF_RANDOM_NORMAL", kBehConfRandomNormal);
    constant("BEH_CONF_RANDOM_UNIFORM", kBehConfRandomUniform);
  }
};

/// An agent or the robot. The velocity is in the frame of the positions; group_id -1: no group.
struct Agent {
  static constexpr const char* kType = "hunav_msgs/msg/Agent";
  static constexpr std::uint8_t kPerson = 1;
  static constexpr std::uint8_t kRobot = 2;
  static constexpr std::uint8_t kOther = 3;

  std::int32_t id = 0;
  std::uint8_t type = 0;
  std::uint8_t skin = 0;
  std::string name;
  std::int8_t groupId = 0;
  geometry_msgs::Pose position;
  float yaw = 0;
  geometry_msgs::Twist velocity;
  float desiredVelocity = 0;
  float radius = 0;
  float linearVel = 0;
  float angularVel = 0;
  AgentBehavior behavior;
  std::vector<geometry_msgs::Pose> goals;
  bool cyclicGoals = false;
  float goalRadius = 0;
  std::vector<geometry_msgs::Point> closestObs;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("id", self.id);
    field("type", self.type);
    field("skin", self.skin);
    field("name", self.name);
    field("group_id", self.groupId);
    field("position", self.position);
    field("yaw", self.yaw);
    field("velocity", self.velocity);
    field("desired_velocity", self.desiredVelocity);
    field("radius", self.radius);
    field("linear_vel", self.linearVel);
    field("angular_vel", self.angularVel);
    field("behavior", self.behavior);
    field("goals", self.goals);
    field("cyclic_goals", self.cyclicGoals);
    field("goal_radius", self.goalRadius);
    field("closest_obs", self.closestObs);
  }
  template <class F>
  static void constants(F&& constant) {
    constant("PERSON", kPerson);
    constant("ROBOT", kRobot);
    constant("OTHER", kOther);
  }
};

struct Agents {
  static constexpr const char* kType = "hunav_msgs/msg/Agents";

  std_msgs::Header header;
  std::vector<Agent> agents;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("header", self.header);
    field("agents", self.agents);
  }
};

}  // namespace bridge::hunav_msgs

namespace bridge::people_msgs {

struct Person {
  static constexpr const char* kType = "people_msgs/msg/Person";

  std::string name;
  geometry_msgs::Point position;
  geometry_msgs::Point velocity;
  double reliability = 0;
  std::vector<std::string> tagnames;
  std::vector<std::string> tags;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("name", self.name);
    field("position", self.position);
    field("velocity", self.velocity);
    field("reliability", self.reliability);
    field("tagnames", self.tagnames);
    field("tags", self.tags);
  }
};

struct People {
  static constexpr const char* kType = "people_msgs/msg/People";

  std_msgs::Header header;
  std::vector<Person> people;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("header", self.header);
    field("people", self.people);
  }
};

}  // namespace bridge::people_msgs
