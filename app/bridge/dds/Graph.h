#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "app/bridge/dds/Domain.h"

namespace bridge {

using Guid = std::array<std::uint8_t, 16>;  // of an endpoint or participant, as in RTPS

struct NodeEndpoints {
  std::string space;  // namespace
  std::string name;
  std::vector<Guid> readers, writers;
};

/// The sample of `ros_discovery_info` (rmw_dds_common/msg/ParticipantEntitiesInfo) by which
/// `ros2 node list` and others learn which endpoints belong to which node.
Bytes graphSample(const Guid& participant, const std::vector<NodeEndpoints>& nodes, Distro distro);

}  // namespace bridge
