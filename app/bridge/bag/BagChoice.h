#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/BagTrace.h"

namespace bridge {

/// Places of the channels that a record is made of.
struct BagChoice {
  std::optional<std::size_t> people, map;
  std::vector<std::size_t> robots;       // several only in bags that hunavsim wrote
  std::vector<std::size_t> transforms;   // tf and tf_static
  bool isRobotByTf = false;              // the robot is among the transforms
  std::optional<std::size_t> goals;      // of the chosen robot: /goal_pose beside its topic
  std::optional<std::size_t> obstacles;  // outlines beside the map, as hunavsim publishes them
};

/// Those of a bag of ours; none of people: it is not as we write it.
BagChoice ownTopics(const std::vector<BagChannel>& channels);

/// Whether a record can be made of the topic: it is named by the user, has a type that holds
/// people, a robot or a map and no known other use (costmaps), or has goals and obstacles beside
/// them.
bool isOfUse(const BagChannel& channel, const BagUse& use);

/// By the words of the user, else by types and usual names. Problems: a topic that is not there, of
/// a type that does not tell that, nobody at all.
BagChoice chooseTopics(const std::vector<BagChannel>& channels, const BagUse& use,
                       const std::string& path, base::Diagnostics& problems);

}  // namespace bridge
