#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/bridge/dds/Participant.h"

/// DDS entities shared by the endpoints of a participant. Private to this folder.
namespace bridge {

namespace efd = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

using Guid = std::array<std::uint8_t, 16>;  // RTPS GUID of an endpoint or participant

struct NodeEndpoints {
  std::string nameSpace;  // namespace
  std::string name;
  std::vector<Guid> readers, writers;
};

/// The sample of `ros_discovery_info` (rmw_dds_common/msg/ParticipantEntitiesInfo), from which
/// `ros2 node list` and other tools read which endpoints belong to which node.
Bytes graphSample(const Guid& participant, const std::vector<NodeEndpoints>& nodes, Distro distro);

/// The remote participants of the domain and the topics they publish. Updated by DDS threads.
class RemoteTopics : public efd::DomainParticipantListener {
 public:
  static constexpr std::size_t kMost = 10000;

  void on_participant_discovery(efd::DomainParticipant* participant,
                                rtps::ParticipantDiscoveryInfo&& info) override;
  void on_publisher_discovery(efd::DomainParticipant* participant,
                              rtps::WriterDiscoveryInfo&& info) override;
  std::vector<RemoteTopic> topics();
  /// Whether any remote participant has ever been discovered.
  bool hasDiscoveredPeers() const { return hasDiscovered_; }
  /// Whether the publisher is known and its offered QoS is incompatible with the requested QoS
  /// `requested`.
  bool hasIncompatibleQos(const rtps::GUID_t& publisher, const Qos& requested);

 private:
  struct Offer {
    bool reliable = false, transientLocal = false;
    bool isRemoved = false;  // undelivered samples may remain
  };

  void add(const rtps::GUID_t& publisher, const Offer& offer);

  std::atomic<bool> hasDiscovered_{false};
  std::mutex mutex_;
  std::vector<RemoteTopic> topics_;
  std::map<rtps::GUID_t, Offer> publishers_;  // at most kMost entries
};

Guid guidOf(const rtps::GUID_t& guid);

/// Wakes the spinning thread when data or a match arrives. Notified by DDS threads.
class WakeSignal : public efd::DataReaderListener {
 public:
  void on_data_available(efd::DataReader* /*reader*/) override { notify(); }
  void on_subscription_matched(efd::DataReader* /*reader*/,
                               const efd::SubscriptionMatchedStatus& /*status*/) override {
    notify();
  }
  void notify();
  std::uint64_t count();
  /// Waits until a notification after `seen`. False: timeout.
  bool waitAfter(std::uint64_t seen, std::chrono::steady_clock::time_point until);

 private:
  std::mutex mutex_;
  std::condition_variable notified_;
  std::uint64_t count_ = 0;
};

/// The remote readers matched with a writer. Notifies the signal when the set changes.
class MatchedReaders : public efd::DataWriterListener {
 public:
  explicit MatchedReaders(WakeSignal& wakeSignal) : wakeSignal_(wakeSignal) {}
  void on_publication_matched(efd::DataWriter* writer,
                              const efd::PublicationMatchedStatus& status) override;
  /// If the entity id is unknown: whether any reader of the participant is matched. If the GUID is
  /// unknown: true.
  bool has(const rtps::GUID_t& reader);

 private:
  WakeSignal& wakeSignal_;
  std::mutex mutex_;
  std::set<rtps::GUID_t> matched_;
};

class DdsEntities;
using DdsPtr = std::shared_ptr<DdsEntities>;

/// An endpoint that `spin` polls for samples while it exists.
class SampleSource {
 public:
  explicit SampleSource(DdsPtr dds);
  virtual ~SampleSource();
  SampleSource(const SampleSource&) = delete;
  SampleSource& operator=(const SampleSource&) = delete;
  SampleSource(SampleSource&&) = delete;
  SampleSource& operator=(SampleSource&&) = delete;
  virtual bool deliverOne() = 0;  // false: no sample

 protected:
  const DdsPtr dds_;
};

/// The DDS participant with its publisher, subscriber and topics. Endpoints share ownership.
class DdsEntities {
 public:
  static std::shared_ptr<DdsEntities> create(const DomainSettings& settings);
  ~DdsEntities();
  DdsEntities(const DdsEntities&) = delete;
  DdsEntities& operator=(const DdsEntities&) = delete;
  DdsEntities(DdsEntities&&) = delete;
  DdsEntities& operator=(DdsEntities&&) = delete;

  // Null on failure.
  efd::DataWriter* makeWriter(const std::string& topic, const std::string& type, const Qos& qos,
                              const std::string& userData, MatchedReaders* listener);
  efd::DataReader* makeReader(const std::string& topic, const std::string& type, const Qos& qos,
                              const std::string& userData,
                              efd::DataReaderListener* listener = nullptr);  // null: wake signal
  void drop(efd::DataWriter* writer);
  void drop(efd::DataReader* reader);

  Guid guid() const { return guidOf(participant_->guid()); }
  rtps::GuidPrefix_t prefix() const { return participant_->guid().guidPrefix; }
  /// The DDS type of a topic in this participant; empty: topic not created.
  std::string typeOf(const std::string& topic) const;

  DomainSettings settings;
  RemoteTopics remote;
  WakeSignal wakeSignal;
  std::vector<SampleSource*> sources;
  std::vector<NodeEndpoints> nodes;

 private:
  DdsEntities() = default;
  efd::Topic* topicOf(const std::string& name, const std::string& type);

  efd::DomainParticipant* participant_ = nullptr;
  efd::Publisher* publisher_ = nullptr;
  efd::Subscriber* subscriber_ = nullptr;
  std::map<std::string, efd::Topic*> topics_;
};

/// Owns a writer or reader and lists it with its node while it exists.
template <class Entity, std::vector<Guid> NodeEndpoints::*List>
class OwnedEntity {
 public:
  OwnedEntity(DdsPtr dds, int node, Entity* entity)
      : dds_(std::move(dds)), node_(node), entity_(entity) {
    if (node_ >= 0) {
      list().push_back(guidOf(entity_->guid()));
    }
  }
  ~OwnedEntity() {
    if (node_ >= 0) {
      list().erase(std::remove(list().begin(), list().end(), guidOf(entity_->guid())),
                   list().end());
    }
    dds_->drop(entity_);
  }
  OwnedEntity(const OwnedEntity&) = delete;
  OwnedEntity& operator=(const OwnedEntity&) = delete;
  OwnedEntity(OwnedEntity&&) = delete;
  OwnedEntity& operator=(OwnedEntity&&) = delete;
  Entity* operator->() const { return entity_; }
  Entity& operator*() const { return *entity_; }

 private:
  std::vector<Guid>& list() const { return dds_->nodes[static_cast<std::size_t>(node_)].*List; }

  DdsPtr dds_;
  int node_;
  Entity* entity_;
};

class OwnedWriter : public OwnedEntity<efd::DataWriter, &NodeEndpoints::writers> {
 public:
  using OwnedEntity::OwnedEntity;
  bool write(const Bytes& bytes, rtps::WriteParams& parameters) const;
  int matched() const;
};

/// Takes the next sample with valid data. False: none.
bool takeNext(efd::DataReader& reader, Bytes& bytes, efd::SampleInfo& info);

class OwnedReader : public OwnedEntity<efd::DataReader, &NodeEndpoints::readers> {
 public:
  using OwnedEntity::OwnedEntity;
  bool take(Bytes& bytes, efd::SampleInfo& info) const { return takeNext(**this, bytes, info); }
  int matched() const;
};

/// DDS names of a service, for both RMW implementations.
struct ServiceNames {
  std::string requestTopic, replyTopic, requestType, replyType;
};
/// For the resolved name of a service and its type "pkg/srv/Name".
ServiceNames serviceNames(const std::string& name, const std::string& type);
std::unique_ptr<Server> makeServer(const DdsPtr& dds, int node, const ServiceNames& names,
                                   const Qos& qos, Participant::ServiceCallback callback);
std::unique_ptr<Client> makeClient(const DdsPtr& dds, int node, const ServiceNames& names);

}  // namespace bridge
