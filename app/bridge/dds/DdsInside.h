#pragma once

#include <atomic>
#include <condition_variable>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "app/bridge/dds/Graph.h"
#include "app/bridge/dds/OthersTopics.h"
#include "app/bridge/dds/Participant.h"

/// What the endpoints of a participant share; private to this folder.
namespace bridge {

namespace efd = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

Guid guidOf(const rtps::GUID_t& guid);

/// Rung by threads of DDS whenever something has arrived.
class Bell : public efd::DataReaderListener {
 public:
  void on_data_available(efd::DataReader* /*reader*/) override { ring(); }
  void on_subscription_matched(efd::DataReader* /*reader*/,
                               const efd::SubscriptionMatchedStatus& /*status*/) override {
    ring();
  }
  void ring();
  std::uint64_t count();
  /// False: the time is over and it has not been rung after `seen`.
  bool waitBeyond(std::uint64_t seen, std::chrono::steady_clock::time_point until);

 private:
  std::mutex mutex_;
  std::condition_variable rung_;
  std::uint64_t count_ = 0;
};

/// Which readers of others a writer has met; rings when that changes.
class MetReaders : public efd::DataWriterListener {
 public:
  explicit MetReaders(Bell& bell) : bell_(bell) {}
  void on_publication_matched(efd::DataWriter* writer,
                              const efd::PublicationMatchedStatus& status) override;
  /// Where the entity is unknown: any reader of this participant; as a whole unknown: yes.
  bool has(const rtps::GUID_t& reader);

 private:
  Bell& bell_;
  std::mutex mutex_;
  std::set<rtps::GUID_t> met_;
};

/// What is asked in `spin`.
class Source {
 public:
  virtual ~Source() = default;
  virtual bool handOutOne() = 0;  // false: nothing there
};

/// The entities of DDS; endpoints keep it alive.
class DdsEntities {
 public:
  static std::shared_ptr<DdsEntities> create(const DomainSettings& settings);
  ~DdsEntities();
  DdsEntities(const DdsEntities&) = delete;
  DdsEntities& operator=(const DdsEntities&) = delete;
  DdsEntities(DdsEntities&&) = delete;
  DdsEntities& operator=(DdsEntities&&) = delete;

  // Null when DDS refuses.
  efd::DataWriter* makeWriter(const std::string& topic, const std::string& type, const Qos& qos,
                              const std::string& userData, MetReaders* listener);
  efd::DataReader* makeReader(const std::string& topic, const std::string& type, const Qos& qos,
                              const std::string& userData,
                              efd::DataReaderListener* listener = nullptr);  // null: the bell
  void drop(efd::DataWriter* writer);
  void drop(efd::DataReader* reader);

  Guid guid() const { return guidOf(participant_->guid()); }
  rtps::GuidPrefix_t prefix() const { return participant_->guid().guidPrefix; }
  /// The type that a topic has here; empty: none yet.
  std::string typeOf(const std::string& topic) const;

  DomainSettings settings;
  OthersTopics others;
  Bell bell;
  std::vector<Source*> sources;
  std::vector<NodeEndpoints> nodes;

 private:
  DdsEntities() = default;
  efd::Topic* topicOf(const std::string& name, const std::string& type);

  efd::DomainParticipant* participant_ = nullptr;
  efd::Publisher* publisher_ = nullptr;
  efd::Subscriber* subscriber_ = nullptr;
  std::map<std::string, efd::Topic*> topics_;
};

using DdsPtr = std::shared_ptr<DdsEntities>;

/// A writer or reader that goes with its owner and is listed with its node while it lives.
class OwnedWriter {
 public:
  OwnedWriter(DdsPtr dds, int node, efd::DataWriter* writer);
  ~OwnedWriter();
  OwnedWriter(const OwnedWriter&) = delete;
  OwnedWriter& operator=(const OwnedWriter&) = delete;
  OwnedWriter(OwnedWriter&&) = delete;
  OwnedWriter& operator=(OwnedWriter&&) = delete;
  efd::DataWriter* operator->() const { return writer_; }
  bool write(const Bytes& bytes, rtps::WriteParams& parameters) const;
  int matched() const;

 private:
  DdsPtr dds_;
  int node_;
  efd::DataWriter* writer_;
};

/// The next sample with data; false: none.
bool takeNext(efd::DataReader& reader, Bytes& bytes, efd::SampleInfo& info);

class OwnedReader {
 public:
  OwnedReader(DdsPtr dds, int node, efd::DataReader* reader);
  ~OwnedReader();
  OwnedReader(const OwnedReader&) = delete;
  OwnedReader& operator=(const OwnedReader&) = delete;
  OwnedReader(OwnedReader&&) = delete;
  OwnedReader& operator=(OwnedReader&&) = delete;
  efd::DataReader* operator->() const { return reader_; }
  bool take(Bytes& bytes, efd::SampleInfo& info) const { return takeNext(*reader_, bytes, info); }
  int matched() const;

 private:
  DdsPtr dds_;
  int node_;
  efd::DataReader* reader_;
};

/// Of both kinds of services.
struct ServiceNames {
  std::string requestTopic, replyTopic, requestType, replyType;
};
std::unique_ptr<Server> makeServer(const DdsPtr& dds, int node, const ServiceNames& names,
                                   const Qos& qos, Participant::Answer answer);
std::unique_ptr<Client> makeClient(const DdsPtr& dds, int node, const ServiceNames& names);

}  // namespace bridge
