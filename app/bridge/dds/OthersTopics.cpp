#include "app/bridge/dds/OthersTopics.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/bridge/dds/RosNames.h"
#include "app/bridge/messages/TypeNames.h"

namespace bridge {

namespace efd = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

void OthersTopics::on_participant_discovery(efd::DomainParticipant* /*participant*/,
                                            rtps::ParticipantDiscoveryInfo&& info) {
  if (info.status == rtps::ParticipantDiscoveryInfo::DISCOVERED_PARTICIPANT) {
    hasMet_ = true;
  }
}

void OthersTopics::on_publisher_discovery(efd::DomainParticipant* /*participant*/,
                                          rtps::WriterDiscoveryInfo&& info) {
  const rtps::GUID_t publisher = info.info.guid();
  if (info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const auto known = publishers_.find(publisher); known != publishers_.end()) {
      known->second.isGone = true;
    }
  }
  if (info.status != rtps::WriterDiscoveryInfo::DISCOVERED_WRITER) {
    return;  // the topic is kept: its publisher may come back
  }
  OthersTopic topic;
  topic.name = rosTopic(info.info.topicName().to_string());
  topic.type = rosTypeName(info.info.typeName().to_string());
  topic.reliable = info.info.m_qos.m_reliability.kind == efd::RELIABLE_RELIABILITY_QOS;
  topic.transientLocal = info.info.m_qos.m_durability.kind >= efd::TRANSIENT_LOCAL_DURABILITY_QOS;
  if (topic.name.empty() || topic.type.empty()) {
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  add(publisher, {topic.reliable, topic.transientLocal, false});
  const bool isKnown = std::any_of(topics_.begin(), topics_.end(), [&](const OthersTopic& other) {
    return other.name == topic.name && other.type == topic.type;
  });
  if (!isKnown && topics_.size() < kMost) {
    topics_.push_back(std::move(topic));
  }
}

/// Called with the lock held.
void OthersTopics::add(const rtps::GUID_t& publisher, const Offer& offer) {
  for (auto each = publishers_.begin(); publishers_.size() >= kMost && each != publishers_.end();) {
    each = each->second.isGone ? publishers_.erase(each) : std::next(each);
  }
  if (publishers_.size() < kMost) {
    publishers_[publisher] = offer;
  }
}

bool OthersTopics::offersLess(const rtps::GUID_t& publisher, const Qos& than) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = publishers_.find(publisher);
  return found != publishers_.end() && ((than.reliable && !found->second.reliable) ||
                                        (than.transientLocal && !found->second.transientLocal));
}

std::vector<OthersTopic> OthersTopics::topics() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return topics_;
}

}  // namespace bridge
