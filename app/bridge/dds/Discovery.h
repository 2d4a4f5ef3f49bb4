#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/rtps/common/Guid.h>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "app/bridge/dds/Domain.h"
#include "app/bridge/dds/Participant.h"

namespace bridge {

using Guid = std::array<std::uint8_t, 16>;  // RTPS GUID of an endpoint or participant

struct NodeEndpoints {
  std::string nameSpace;  // namespace
  std::string name;
  std::vector<Guid> readers, writers;
};

/// The sample of `ros_discovery_info` (rmw_dds_common/msg/ParticipantEntitiesInfo) that tells `ros2
/// node list` and other tools which endpoints belong to which node.
Bytes graphSample(const Guid& participant, const std::vector<NodeEndpoints>& nodes, Distro distro);

/// The remote participants of the domain and the topics they publish. Updated by DDS threads.
/// Private to this folder.
class RemoteTopics : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  static constexpr std::size_t kMost = 10000;

  void on_participant_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                                eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override;
  void on_publisher_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                              eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;
  std::vector<RemoteTopic> topics();
  /// Whether any remote participant has ever been discovered.
  bool hasDiscoveredPeers() const { return hasDiscovered_; }
  /// Whether the publisher is known and its offered QoS is incompatible with the requested QoS
  /// `requested`.
  bool hasIncompatibleQos(const eprosima::fastrtps::rtps::GUID_t& publisher, const Qos& requested);

 private:
  struct Offer {
    bool reliable = false, transientLocal = false;
    bool isRemoved = false;  // undelivered samples may remain
  };

  void add(const eprosima::fastrtps::rtps::GUID_t& publisher, const Offer& offer);

  std::atomic<bool> hasDiscovered_{false};
  std::mutex mutex_;
  std::vector<RemoteTopic> topics_;
  std::map<eprosima::fastrtps::rtps::GUID_t, Offer> publishers_;  // at most kMost entries
};

}  // namespace bridge
