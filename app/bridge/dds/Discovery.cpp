#include "app/bridge/dds/Discovery.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/bridge/dds/Domain.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/TypeNames.h"
#include "app/bridge/messages/rmw_dds_common.h"

namespace bridge {
namespace {

template <class Gid>
Gid gidOf(const Guid& guid) {
  Gid gid;
  std::copy(guid.begin(), guid.end(), gid.data.begin());
  return gid;
}

template <class Gid>
std::vector<Gid> gidsOf(const std::vector<Guid>& guids) {
  std::vector<Gid> gids;
  std::transform(guids.begin(), guids.end(), std::back_inserter(gids), gidOf<Gid>);
  return gids;
}

template <class Info, class Gid = decltype(Info::gid)>
Bytes sampleOf(const Guid& participant, const std::vector<NodeEndpoints>& nodes) {
  Info info;
  info.gid = gidOf<Gid>(participant);
  for (const NodeEndpoints& node : nodes) {
    auto& entry = info.nodeEntitiesInfoSeq.emplace_back();
    entry.nodeNamespace = node.nameSpace;
    entry.nodeName = node.name;
    entry.readerGidSeq = gidsOf<Gid>(node.readers);
    entry.writerGidSeq = gidsOf<Gid>(node.writers);
  }
  return encode(info);
}

}  // namespace

Bytes graphSample(const Guid& participant, const std::vector<NodeEndpoints>& nodes, Distro distro) {
  using namespace rmw_dds_common;
  return distro == Distro::Humble ? sampleOf<ParticipantEntitiesInfo>(participant, nodes)
                                  : sampleOf<IronParticipantEntitiesInfo>(participant, nodes);
}

namespace efd = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

void RemoteTopics::on_participant_discovery(efd::DomainParticipant* /*participant*/,
                                            rtps::ParticipantDiscoveryInfo&& info) {
  if (info.status == rtps::ParticipantDiscoveryInfo::DISCOVERED_PARTICIPANT) {
    hasDiscovered_ = true;
  }
}

void RemoteTopics::on_publisher_discovery(efd::DomainParticipant* /*participant*/,
                                          rtps::WriterDiscoveryInfo&& info) {
  const rtps::GUID_t publisher = info.info.guid();
  if (info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const auto known = publishers_.find(publisher); known != publishers_.end()) {
      known->second.isRemoved = true;
    }
  }
  if (info.status != rtps::WriterDiscoveryInfo::DISCOVERED_WRITER) {
    return;  // topics are kept: the publisher may return
  }
  RemoteTopic topic;
  topic.name = rosTopic(info.info.topicName().to_string());
  topic.type = rosTypeName(info.info.typeName().to_string());
  topic.reliable = info.info.m_qos.m_reliability.kind == efd::RELIABLE_RELIABILITY_QOS;
  topic.transientLocal = info.info.m_qos.m_durability.kind >= efd::TRANSIENT_LOCAL_DURABILITY_QOS;
  if (topic.name.empty() || topic.type.empty()) {
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  add(publisher, {topic.reliable, topic.transientLocal, false});
  const bool isKnown = std::any_of(topics_.begin(), topics_.end(), [&](const RemoteTopic& other) {
    return other.name == topic.name && other.type == topic.type;
  });
  if (!isKnown && topics_.size() < kMost) {
    topics_.push_back(std::move(topic));
  }
}

/// Called with the lock held.
void RemoteTopics::add(const rtps::GUID_t& publisher, const Offer& offer) {
  for (auto each = publishers_.begin(); publishers_.size() >= kMost && each != publishers_.end();) {
    each = each->second.isRemoved ? publishers_.erase(each) : std::next(each);
  }
  if (publishers_.size() < kMost) {
    publishers_[publisher] = offer;
  }
}

bool RemoteTopics::hasIncompatibleQos(const rtps::GUID_t& publisher, const Qos& requested) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = publishers_.find(publisher);
  return found != publishers_.end() &&
         ((requested.reliable && !found->second.reliable) ||
          (requested.transientLocal && !found->second.transientLocal));
}

std::vector<RemoteTopic> RemoteTopics::topics() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return topics_;
}

}  // namespace bridge
