#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/BagTrace.h"

namespace bridge {

/// Indices of the channels from which a trace is created.
struct TopicSelection {
  std::optional<std::size_t> people, map;
  std::vector<std::size_t> robots;       // several only in bags written by hunavsim
  std::vector<std::size_t> transforms;   // tf and tf_static
  bool isRobotFromTf = false;            // the robot's pose is a transform
  std::optional<std::size_t> goals;      // /goal_pose of the chosen robot
  std::optional<std::size_t> obstacles;  // obstacle outlines published by hunavsim
};

/// The topics of a bag written by hunavsim. Without people: the bag was modified.
TopicSelection hunavsimTopics(const std::vector<BagChannel>& channels);

/// Whether the topic can be used: the user named it, or its type contains people, a robot or a map
/// and it has no other known purpose (costmaps), or it contains goals or obstacles.
bool isUsableTopic(const BagChannel& channel, const BagTopicOptions& use);

/// Selects topics by the user's options, otherwise by types and usual names. Errors: a missing
/// topic, a topic of an unsuitable type, neither people nor a robot.
TopicSelection selectTopics(const std::vector<BagChannel>& channels, const BagTopicOptions& use,
                            const std::string& path, base::Diagnostics& problems);

}  // namespace bridge
