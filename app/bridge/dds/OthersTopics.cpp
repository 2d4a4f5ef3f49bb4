#include "app/bridge/dds/OthersTopics.h"

#include <algorithm>
#include <utility>

#include "app/bridge/dds/RosNames.h"
#include "app/bridge/messages/TypeNames.h"

namespace bridge {

namespace efd = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

void OthersTopics::on_publisher_discovery(efd::DomainParticipant* /*participant*/,
                                          rtps::WriterDiscoveryInfo&& info) {
  if (info.status != rtps::WriterDiscoveryInfo::DISCOVERED_WRITER) {
    return;  // who goes may come back
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
  const bool isKnown = std::any_of(topics_.begin(), topics_.end(), [&](const OthersTopic& other) {
    return other.name == topic.name && other.type == topic.type;
  });
  if (!isKnown && topics_.size() < kMost) {
    topics_.push_back(std::move(topic));
  }
}

std::vector<OthersTopic> OthersTopics::topics() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return topics_;
}

}  // namespace bridge
