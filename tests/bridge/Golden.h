#pragma once

#include <string>

#include <QByteArray>

#include "app/bridge/messages/hunav_msgs.h"

/// A message of hunav_msgs as the middleware of ROS 2 Humble wrote it (rmw_fastrtps and
/// rmw_cyclonedds the same bytes), and what it says.
inline std::string goldenBytes() {
  return QByteArray::fromHex(
             "000100000c0000000065cd1d040000006d61700001000000070000000103000005000000616e6e6100ff0"
             "0000000"
             "00000000f83f00000000000000c0000000000000000000000000000000000000000000000000333333333"
             "333e33f"
             "9a9999999999e93f0000a03f00000000000000000000e03f0000000000000000000000000000000000000"
             "0000000"
             "00000000000000000000000000000000d03f0000c03f0000c03e0000003f0000803e05010200000020420"
             "1000000"
             "0000403f000040400000a04000000040000020410000a0410100000000000000000010400000000000001"
             "4400000"
             "000000000000000000000000000000000000000000000000000000000000000000000000f03f010000000"
             "000803e"
             "0100000000000000000000000000f03f00000000000000400000000000000840")
      .toStdString();
}

inline bridge::hunav_msgs::Agents goldenAgents() {
  bridge::hunav_msgs::Agents all;
  all.header.stamp = {12, 500000000};
  all.header.frameId = "map";
  bridge::hunav_msgs::Agent anna;
  anna.id = 7;
  anna.type = bridge::hunav_msgs::Agent::kPerson;
  anna.skin = 3;
  anna.name = "anna";
  anna.groupId = -1;
  anna.position = {{1.5, -2.0, 0.0}, {0.0, 0.0, 0.6, 0.8}};
  anna.yaw = 1.25F;
  anna.velocity = {{0.5, 0.0, 0.0}, {0.0, 0.0, 0.25}};
  anna.desiredVelocity = 1.5F;
  anna.radius = 0.375F;
  anna.linearVel = 0.5F;
  anna.angularVel = 0.25F;
  anna.behavior = {5, 1, 2, 40.0F, true, 0.75F, 3.0F, 5.0F, 2.0F, 10.0F, 20.0F};
  anna.goals.push_back({{4.0, 5.0, 0.0}, {}});  // no rotation: w is 1
  anna.cyclicGoals = true;
  anna.goalRadius = 0.25F;
  anna.closestObs.push_back({1.0, 2.0, 3.0});
  all.agents.push_back(anna);
  return all;
}
