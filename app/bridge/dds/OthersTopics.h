#pragma once

#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <mutex>
#include <vector>

#include "app/bridge/dds/Participant.h"

namespace bridge {

/// Which topics others publish. Told by threads of DDS; private to this folder.
class OthersTopics : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  static constexpr std::size_t kMost = 10000;

  void on_publisher_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                              eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;
  std::vector<OthersTopic> topics();

 private:
  std::mutex mutex_;
  std::vector<OthersTopic> topics_;
};

}  // namespace bridge
