#include "app/bridge/dds/Participant.h"

#include <algorithm>
#include <fastdds/rtps/common/WriteParams.h>
#include <utility>
#include <vector>

#include "app/bridge/dds/DdsEntities.h"
#include "app/bridge/messages/Codec.h"

namespace bridge {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kGraphTopic = "ros_discovery_info";
constexpr const char* kGraphType = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";

class DdsPublisher : public Publisher {
 public:
  DdsPublisher(const DdsPtr& dds, int node, efd::DataWriter* writer, bool isKept)
      : writer_(dds, node, writer), isKept_(isKept) {}
  bool publish(const Bytes& message) override {
    rtps::WriteParams none;
    return writer_.write(message, none);
  }
  int matched() const override { return writer_.matched(); }
  bool hasReceivers() const override { return isKept_ || matched() > 0; }

 private:
  OwnedWriter writer_;
  bool isKept_;  // transient local: kept for late subscribers
};

/// With Qos::anyPublisher it has two readers: one with the requested QoS, and one with the weakest
/// QoS that delivers samples of publishers the first cannot match.
class DdsSubscription : public Subscription, public SampleSource {
 public:
  DdsSubscription(DdsPtr dds, int node, const Qos& qos, efd::DataReader* reader,
                  efd::DataReader* least, Participant::Handler handler)
      : SampleSource(std::move(dds)),
        qos_(qos),
        handler_(std::move(handler)),
        reader_(dds_, node, reader) {
    if (least != nullptr) {
      least_ = std::make_unique<OwnedReader>(dds_, node, least);
    }
  }

  int matched() const override { return least_ ? least_->matched() : reader_.matched(); }
  bool deliverOne() override {
    const auto any = [](const rtps::GUID_t& /*publisher*/) { return true; };
    const auto unmatched = [this](const rtps::GUID_t& publisher) {
      return dds_->remote.hasIncompatibleQos(publisher, qos_);
    };
    return deliverOne(reader_, any) || (least_ && deliverOne(*least_, unmatched));
  }

 private:
  template <class IsFrom>
  bool deliverOne(const OwnedReader& reader, const IsFrom& isFrom) const {
    Bytes bytes;
    efd::SampleInfo info;
    if (!reader.take(bytes, info)) {
      return false;
    }
    const rtps::GUID_t& publisher = info.sample_identity.writer_guid();
    if (publisher.guidPrefix != dds_->prefix() && isFrom(publisher)) {
      handler_(bytes);
    }
    return true;
  }

  Qos qos_;
  Participant::Handler handler_;
  OwnedReader reader_;
  std::unique_ptr<OwnedReader> least_;
};

}  // namespace

std::string resolvedName(const std::string& name, const std::string& nameSpace,
                         const std::string& node) {
  if (!name.empty() && name.front() == '/') {
    return name;
  }
  const std::string begin = nameSpace == "/" ? "/" : nameSpace + "/";
  if (name.rfind("~/", 0) == 0) {
    return begin + node + name.substr(1);
  }
  return begin + name;
}

std::string ddsTopic(const std::string& topic) {
  return "rt" + topic;
}

std::string rosTopic(const std::string& ddsTopic) {
  return ddsTopic.rfind("rt/", 0) == 0 ? ddsTopic.substr(2) : std::string();
}

ServiceNames serviceNames(const std::string& name, const std::string& type) {
  return {"rq" + name + "Request", "rr" + name + "Reply", ddsTypeName(type + "_Request"),
          ddsTypeName(type + "_Response")};
}

Participant::Participant(std::shared_ptr<DdsEntities> dds) : dds_(std::move(dds)) {}

int Participant::addNode(const std::string& nameSpace, const std::string& name) {
  dds_->nodes.push_back({nameSpace, name, {}, {}});
  return static_cast<int>(dds_->nodes.size()) - 1;
}

bool Participant::hasDiscoveredPeers() const {
  return dds_->remote.hasDiscoveredPeers();
}

std::vector<RemoteTopic> Participant::remoteTopics() {
  return dds_->remote.topics();
}

std::string Participant::resolved(int node, const std::string& name) const {
  const NodeEndpoints& of = dds_->nodes[static_cast<std::size_t>(node)];
  return resolvedName(name, of.nameSpace, of.name);
}

/// The reason why an endpoint could not be created.
base::Diagnostic Participant::endpointError(const std::string& name, const std::string& ddsName,
                                            const std::string& type) const {
  const std::string there = dds_->typeOf(ddsName);
  return there.empty() || there == type ? base::error("ros2.endpoint-refused", {name})
                                        : base::error("ros2.other-type", {name, there, type});
}

base::Result<std::unique_ptr<Publisher>> Participant::publisher(int node, const std::string& topic,
                                                                const std::string& type,
                                                                const Qos& qos) {
  const std::string name = resolved(node, topic);
  const std::string mangled = ddsTypeName(type);
  efd::DataWriter* const writer = dds_->makeWriter(ddsTopic(name), mangled, qos, {}, nullptr);
  if (writer == nullptr) {
    return endpointError(name, ddsTopic(name), mangled);
  }
  return std::unique_ptr<Publisher>(
      std::make_unique<DdsPublisher>(dds_, node, writer, qos.transientLocal));
}

base::Result<std::unique_ptr<Subscription>> Participant::subscription(
    int node, const std::string& topic, const std::string& type, const Qos& qos, Handler handler) {
  const std::string name = resolved(node, topic);
  const std::string mangled = ddsTypeName(type);
  const auto make = [&](const Qos& with) {
    return dds_->makeReader(ddsTopic(name), mangled, with, {});
  };
  efd::DataReader* const reader = make(qos);
  Qos least = qos;
  least.reliable = least.transientLocal = false;
  efd::DataReader* const second = reader != nullptr && qos.anyPublisher ? make(least) : nullptr;
  if (reader == nullptr || (qos.anyPublisher && second == nullptr)) {
    if (reader != nullptr) {
      dds_->drop(reader);
    }
    return endpointError(name, ddsTopic(name), mangled);
  }
  return std::unique_ptr<Subscription>(
      std::make_unique<DdsSubscription>(dds_, node, qos, reader, second, std::move(handler)));
}

base::Result<std::unique_ptr<Server>> Participant::server(int node, const std::string& service,
                                                          const std::string& type, const Qos& qos,
                                                          ServiceCallback callback) {
  const std::string name = resolved(node, service);
  const ServiceNames names = serviceNames(name, type);
  std::unique_ptr<Server> made = makeServer(dds_, node, names, qos, std::move(callback));
  if (made == nullptr) {
    return endpointError(name, names.requestTopic, names.requestType);
  }
  return made;
}

base::Result<std::unique_ptr<Client>> Participant::client(int node, const std::string& service,
                                                          const std::string& type) {
  const std::string name = resolved(node, service);
  const ServiceNames names = serviceNames(name, type);
  std::unique_ptr<Client> made = makeClient(dds_, node, names);
  if (made == nullptr) {
    return endpointError(name, names.requestTopic, names.requestType);
  }
  return made;
}

void Participant::publishGraph() {
  if (graph_ == nullptr) {
    efd::DataWriter* const writer =
        dds_->makeWriter(kGraphTopic, kGraphType, Qos::latched(), {}, nullptr);
    if (writer == nullptr) {
      return;  // topics and services are still discoverable
    }
    graph_ = std::make_shared<OwnedWriter>(dds_, -1, writer);
  }
  rtps::WriteParams none;
  graph_->write(graphSample(dds_->guid(), dds_->nodes, dds_->settings.distro), none);
}

bool Participant::spin(Milliseconds atMost) {
  const Clock::time_point until = Clock::now() + atMost;
  while (true) {
    const std::uint64_t seen = dds_->wakeSignal.count();
    bool any = false;
    for (std::size_t i = 0; i < dds_->sources.size(); ++i) {
      any = dds_->sources[i]->deliverOne() || any;
    }
    if (any) {
      return true;
    }
    if (!dds_->wakeSignal.waitAfter(seen, until)) {
      return false;
    }
  }
}

base::Result<std::unique_ptr<Participant>> Participant::create(const DomainSettings& settings) {
  // DDS terminates the process if a port number is out of range.
  const bool isPossible = settings.domain >= 0 && settings.domain <= kLastDomain;
  DdsPtr dds = isPossible ? DdsEntities::create(settings) : nullptr;
  if (dds == nullptr) {
    return base::error("ros2.no-participant", {std::to_string(settings.domain)});
  }
  return std::unique_ptr<Participant>(new Participant(std::move(dds)));
}

bool Participant::spinUntil(const std::function<bool()>& isDone, Milliseconds atMost) {
  const Clock::time_point until = Clock::now() + atMost;
  bool done = isDone();
  while (!done && Clock::now() < until) {
    spin(Milliseconds(10));
    done = isDone();
  }
  return done;
}

}  // namespace bridge
