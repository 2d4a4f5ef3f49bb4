#pragma once

#include <atomic>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/rtps/common/Guid.h>
#include <map>
#include <mutex>
#include <vector>

#include "app/bridge/dds/Participant.h"

namespace bridge {

/// The other participants of the domain, and the topics that they publish. Filled by threads of
/// DDS; private to this folder.
class OthersTopics : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  static constexpr std::size_t kMost = 10000;

  void on_participant_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                                eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override;
  void on_publisher_discovery(eprosima::fastdds::dds::DomainParticipant* participant,
                              eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;
  std::vector<OthersTopic> topics();
  /// Another participant was discovered, now or before.
  bool hasMetAnyone() const { return hasMet_; }
  /// The publisher is known and offers less than a reader with this quality of service requests.
  bool offersLess(const eprosima::fastrtps::rtps::GUID_t& publisher, const Qos& than);

 private:
  struct Offer {
    bool reliable = false, transientLocal = false;
    bool isGone = false;  // its samples may still wait to be delivered
  };

  void add(const eprosima::fastrtps::rtps::GUID_t& publisher, const Offer& offer);

  std::atomic<bool> hasMet_{false};
  std::mutex mutex_;
  std::vector<OthersTopic> topics_;
  std::map<eprosima::fastrtps::rtps::GUID_t, Offer> publishers_;  // kMost at most
};

}  // namespace bridge
