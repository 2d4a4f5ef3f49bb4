#include "app/bridge/dds/DdsEntities.h"

#include <algorithm>
#include <cstring>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/log/Log.hpp>
#include <fastdds/rtps/common/WriteParams.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <iterator>
#include <utility>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/rmw_dds_common.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace bridge {
namespace {

constexpr int kAnnouncementPeriodMs = 200;
constexpr int kHeartbeatPeriodMs = 250;  // interval after which lost samples are requested again
constexpr unsigned kFirstPort = 7400, kPortsPerDomain = 250, kUnicastOffset = 10;
constexpr unsigned kPeers = 40;     // participants probed on this machine
constexpr int kUsualSamples = 400;  // default of Fast DDS
constexpr int kAllocatedSamples = 4;
constexpr unsigned kReceiveBuffer = 4 << 20;  // [bytes]; the system may limit it
constexpr int kKeptBytes = 16 << 20, kMmapThreshold = 4 << 20;

/// Raises malloc's trim and mmap thresholds. Message buffers are allocated and freed many times a
/// second; returning them to the system each time costs page faults.
void configureMalloc() {
#ifdef __GLIBC__
  [[maybe_unused]] static const bool isSet =
      mallopt(M_TRIM_THRESHOLD, kKeptBytes) == 1 && mallopt(M_MMAP_THRESHOLD, kMmapThreshold) == 1;
#endif
}

/// UDP only: shared memory segments survive a crash. The receive buffer is enlarged because the
/// states of a crowd exceed the default socket buffer, and dropped fragments are retransmitted or
/// lost.
std::shared_ptr<eprosima::fastdds::rtps::UDPv4TransportDescriptor> udpTransport() {
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->receiveBufferSize = kReceiveBuffer;
  return udp;
}

/// Restricts DDS to 127.0.0.1. Without multicast, discovery probes the unicast ports of the first
/// participants.
void restrictToLoopback(const DomainSettings& settings, efd::DomainParticipantQos& qos) {
  const auto udp = udpTransport();
  udp->interfaceWhiteList = {"127.0.0.1"};
  qos.transport().user_transports = {udp};
  rtps::Locator_t own;
  rtps::IPLocator::setIPv4(own, "127.0.0.1");
  qos.wire_protocol().builtin.metatrafficUnicastLocatorList.push_back(own);
  const unsigned first =
      kFirstPort + kPortsPerDomain * static_cast<unsigned>(settings.domain) + kUnicastOffset;
  for (unsigned peer = 0; peer < kPeers; ++peer) {
    rtps::Locator_t other = own;
    other.port = first + 2 * peer;
    qos.wire_protocol().builtin.initialPeersList.push_back(other);
  }
}

efd::DomainParticipantQos participantQos(const DomainSettings& settings) {
  efd::DomainParticipantQos qos;
  qos.name("/");
  const std::string enclave = "enclave=/;";
  qos.user_data().data_vec({enclave.c_str(), enclave.c_str() + enclave.size() + 1});
  qos.transport().use_builtin_transports = false;
  if (settings.localhostOnly) {
    restrictToLoopback(settings, qos);
  } else {
    qos.transport().user_transports = {udpTransport()};
  }
  qos.wire_protocol().builtin.discovery_config.leaseDuration_announcementperiod =
      eprosima::fastrtps::Duration_t(0, kAnnouncementPeriodMs * 1000000U);
  return qos;
}

template <class EndpointQos>
void apply(const Qos& from, const std::string& userData, EndpointQos& to) {
  to.reliability().kind =
      from.reliable ? efd::RELIABLE_RELIABILITY_QOS : efd::BEST_EFFORT_RELIABILITY_QOS;
  to.durability().kind =
      from.transientLocal ? efd::TRANSIENT_LOCAL_DURABILITY_QOS : efd::VOLATILE_DURABILITY_QOS;
  to.history().kind = efd::KEEP_LAST_HISTORY_QOS;
  to.history().depth = from.depth;
  to.resource_limits().max_samples_per_instance = std::max(from.depth, kUsualSamples);
  to.resource_limits().allocated_samples = std::min(from.depth, kAllocatedSamples);
  to.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  to.data_sharing().off();
  to.user_data().data_vec({userData.begin(), userData.end()});
}

/// A DDS type known only by name. Samples are `Bytes` with the CDR header.
class RawType : public efd::TopicDataType {
 public:
  explicit RawType(const std::string& name) {
    constexpr std::uint32_t kStartSize = 512;  // [bytes]; grows as needed
    setName(name.c_str());
    m_typeSize = kStartSize;
    m_isGetKeyDefined = false;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
  }

  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    const Bytes& bytes = *static_cast<const Bytes*>(data);
    if (bytes.size() > payload->max_size) {
      return false;
    }
    std::memcpy(payload->data, bytes.data(), bytes.size());
    payload->length = static_cast<std::uint32_t>(bytes.size());
    payload->encapsulation = CDR_LE;
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    const auto* const first = reinterpret_cast<const char*>(payload->data);
    static_cast<Bytes*>(data)->assign(first, payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    const auto size = static_cast<std::uint32_t>(static_cast<const Bytes*>(data)->size());
    return [size] { return size; };
  }
  void* createData() override { return new Bytes; }
  void deleteData(void* data) override { delete static_cast<Bytes*>(data); }
  bool getKey(void* /*data*/, rtps::InstanceHandle_t* /*handle*/, bool /*forceMd5*/) override {
    return false;
  }
};

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

Guid guidOf(const rtps::GUID_t& guid) {
  Guid bytes{};
  std::copy(std::begin(guid.guidPrefix.value), std::end(guid.guidPrefix.value), bytes.begin());
  std::copy(std::begin(guid.entityId.value), std::end(guid.entityId.value),
            bytes.begin() + rtps::GuidPrefix_t::size);
  return bytes;
}

void WakeSignal::notify() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++count_;
  }
  notified_.notify_all();
}

std::uint64_t WakeSignal::count() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return count_;
}

bool WakeSignal::waitAfter(std::uint64_t seen, std::chrono::steady_clock::time_point until) {
  std::unique_lock<std::mutex> lock(mutex_);
  return notified_.wait_until(lock, until, [&] { return count_ != seen; });
}

void MatchedReaders::on_publication_matched(efd::DataWriter* /*writer*/,
                                            const efd::PublicationMatchedStatus& status) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const rtps::GUID_t reader = rtps::iHandle2GUID(status.last_subscription_handle);
    if (status.current_count_change > 0) {
      matched_.insert(reader);
    } else {
      matched_.erase(reader);
    }
  }
  wakeSignal_.notify();
}

bool MatchedReaders::has(const rtps::GUID_t& reader) {
  if (reader == rtps::GUID_t::unknown()) {
    return true;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (reader.entityId != rtps::EntityId_t::unknown()) {
    return matched_.count(reader) > 0;
  }
  return std::any_of(matched_.begin(), matched_.end(), [&](const rtps::GUID_t& each) {
    return each.guidPrefix == reader.guidPrefix;
  });
}

SampleSource::SampleSource(DdsPtr dds) : dds_(std::move(dds)) {
  dds_->sources.push_back(this);
}

SampleSource::~SampleSource() {
  std::vector<SampleSource*>& all = dds_->sources;
  all.erase(std::remove(all.begin(), all.end(), this), all.end());
}

std::shared_ptr<DdsEntities> DdsEntities::create(const DomainSettings& settings) {
  configureMalloc();
  std::shared_ptr<DdsEntities> made(new DdsEntities);
  made->settings = settings;
  made->participant_ = efd::DomainParticipantFactory::get_instance()->create_participant(
      static_cast<efd::DomainId_t>(settings.domain), participantQos(settings), &made->remote,
      efd::StatusMask::none());
  if (made->participant_ == nullptr) {
    return nullptr;
  }
  made->publisher_ = made->participant_->create_publisher(efd::PUBLISHER_QOS_DEFAULT);
  made->subscriber_ = made->participant_->create_subscriber(efd::SUBSCRIBER_QOS_DEFAULT);
  const bool isWhole = made->publisher_ != nullptr && made->subscriber_ != nullptr;
  return isWhole ? made : nullptr;
}

DdsEntities::~DdsEntities() {
  if (participant_ != nullptr) {
    participant_->delete_contained_entities();
    efd::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
}

std::string DdsEntities::typeOf(const std::string& topic) const {
  const auto found = topics_.find(topic);
  return found == topics_.end() ? std::string() : found->second->get_type_name();
}

/// DDS allows one topic per name. Topics are kept until the participant is deleted.
efd::Topic* DdsEntities::topicOf(const std::string& name, const std::string& type) {
  const auto found = topics_.find(name);
  if (found != topics_.end()) {
    return found->second->get_type_name() == type ? found->second : nullptr;
  }
  if (participant_->find_type(type).empty()) {
    efd::TypeSupport support(new RawType(type));
    if (support.register_type(participant_) !=
        eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
      return nullptr;
    }
  }
  efd::Topic* const made = participant_->create_topic(name, type, efd::TOPIC_QOS_DEFAULT);
  if (made != nullptr) {
    topics_.emplace(name, made);
  }
  return made;
}

efd::DataWriter* DdsEntities::makeWriter(const std::string& topic, const std::string& type,
                                         const Qos& qos, const std::string& userData,
                                         MatchedReaders* listener) {
  efd::Topic* const on = topicOf(topic, type);
  if (on == nullptr) {
    return nullptr;
  }
  efd::DataWriterQos wanted = publisher_->get_default_datawriter_qos();
  apply(qos, userData, wanted);
  wanted.publish_mode().kind = efd::SYNCHRONOUS_PUBLISH_MODE;
  wanted.reliable_writer_qos().times.heartbeatPeriod =
      eprosima::fastrtps::Duration_t(0, kHeartbeatPeriodMs * 1000000U);
  if (qos.lifespan > 0.0) {
    wanted.lifespan().duration = eprosima::fastrtps::Duration_t(qos.lifespan);
  }
  return publisher_->create_datawriter(on, wanted, listener,
                                       efd::StatusMask::publication_matched());
}

efd::DataReader* DdsEntities::makeReader(const std::string& topic, const std::string& type,
                                         const Qos& qos, const std::string& userData,
                                         efd::DataReaderListener* listener) {
  efd::Topic* const on = topicOf(topic, type);
  if (on == nullptr) {
    return nullptr;
  }
  efd::DataReaderQos wanted = subscriber_->get_default_datareader_qos();
  apply(qos, userData, wanted);
  return subscriber_->create_datareader(on, wanted, listener != nullptr ? listener : &wakeSignal,
                                        efd::StatusMask::data_available()
                                            << efd::StatusMask::subscription_matched());
}

void DdsEntities::drop(efd::DataWriter* writer) {
  publisher_->delete_datawriter(writer);
}

void DdsEntities::drop(efd::DataReader* reader) {
  reader->set_listener(nullptr);
  subscriber_->delete_datareader(reader);
}

bool OwnedWriter::write(const Bytes& bytes, rtps::WriteParams& parameters) const {
  return (*this)->write(const_cast<Bytes*>(&bytes), parameters);  // NOLINT: DDS only reads it
}

int OwnedWriter::matched() const {
  efd::PublicationMatchedStatus status;
  (*this)->get_publication_matched_status(status);
  return status.current_count;
}

bool takeNext(efd::DataReader& reader, Bytes& bytes, efd::SampleInfo& info) {
  while (reader.take_next_sample(&bytes, &info) ==
         eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK) {
    if (info.valid_data) {
      return true;
    }
  }
  return false;
}

int OwnedReader::matched() const {
  efd::SubscriptionMatchedStatus status;
  (*this)->get_subscription_matched_status(status);
  return status.current_count;
}

Bytes graphSample(const Guid& participant, const std::vector<NodeEndpoints>& nodes, Distro distro) {
  using namespace rmw_dds_common;
  return distro == Distro::Humble ? sampleOf<ParticipantEntitiesInfo>(participant, nodes)
                                  : sampleOf<IronParticipantEntitiesInfo>(participant, nodes);
}

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
