#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/bridge/dds/Domain.h"
#include "sim2d/base/Result.h"

/// ROS 2 nodes on plain DDS. Messages are bytes; topic and service names are resolved and mangled
/// here; types are written as "pkg/msg/Name" or "pkg/srv/Name".
namespace bridge {

using Milliseconds = std::chrono::milliseconds;

/// Endpoints exist as long as these objects. The participant and its endpoints must be used from
/// one thread.
class Publisher {
 public:
  virtual ~Publisher() = default;
  virtual bool publish(const Bytes& message) = 0;
  virtual int matched() const = 0;  // number of matched remote subscriptions
  /// Whether a message can reach a subscriber, now or (transient local) later. If not, it need not
  /// be created.
  virtual bool hasReceivers() const = 0;
};

class Subscription {
 public:
  virtual ~Subscription() = default;
  virtual int matched() const = 0;  // number of matched remote publishers
};

class Server {
 public:
  virtual ~Server() = default;
};

class Client {
 public:
  virtual ~Client() = default;
  /// Whether a server has been matched for at least 0.5 s. Earlier requests may be lost.
  virtual bool isReady() = 0;
  /// Sends a request and waits for its response without delivering other samples. Nothing: timeout.
  virtual std::optional<Bytes> call(const Bytes& request, Milliseconds atMost) = 0;
  /// Asynchronous call: `send` returns the request number, or -1 on failure. `receive` returns the
  /// next available response with its request number.
  virtual std::int64_t send(const Bytes& request) = 0;
  virtual std::optional<std::pair<std::int64_t, Bytes>> receive() = 0;
};

/// A topic published by another participant, with the QoS of its first publisher.
struct RemoteTopic {
  std::string name, type;  // "/odom", "nav_msgs/msg/Odometry"
  bool reliable = false, transientLocal = false;
};

struct ServiceRequest {
  Bytes bytes;
  Rmw clientRmw = Rmw::FastRtps;  // RMW implementation of the client, if detectable
};

/// A participant of a domain with any number of nodes. Samples and requests are delivered in
/// `spin`, in the calling thread, one at a time and in order of arrival per endpoint.
class Participant {
 public:
  using Handler = std::function<void(const Bytes&)>;
  using ServiceCallback = std::function<Bytes(const ServiceRequest&)>;

  /// Errors: DDS cannot create the participant (no free port, domain out of range …).
  static base::Result<std::unique_ptr<Participant>> create(const DomainSettings& settings);
  virtual ~Participant() = default;

  /// Returns the node index. `nameSpace` is the namespace: "/" or "/lab".
  virtual int addNode(const std::string& nameSpace, const std::string& name) = 0;

  // Errors: the topic exists with another type, or DDS cannot create the endpoint. Subscriptions do
  // not receive samples published by this participant.
  virtual base::Result<std::unique_ptr<Publisher>> publisher(int node, const std::string& topic,
                                                             const std::string& type,
                                                             const Qos& qos) = 0;
  virtual base::Result<std::unique_ptr<Subscription>> subscription(int node,
                                                                   const std::string& topic,
                                                                   const std::string& type,
                                                                   const Qos& qos,
                                                                   Handler handler) = 0;
  virtual base::Result<std::unique_ptr<Server>> server(int node, const std::string& service,
                                                       const std::string& type, const Qos& qos,
                                                       ServiceCallback callback) = 0;
  virtual base::Result<std::unique_ptr<Client>> client(int node, const std::string& service,
                                                       const std::string& type) = 0;

  /// Whether another participant of the domain has ever been discovered.
  virtual bool hasDiscoveredPeers() const = 0;
  /// The topics discovered so far, in order of discovery, at most 10 000.
  virtual std::vector<RemoteTopic> remoteTopics() = 0;

  /// Publishes the nodes and endpoints to the ROS 2 graph. Call after the last endpoint is created.
  virtual void publishGraph() = 0;

  /// Delivers the samples that have arrived; waits at most `atMost` for the first one. False: none
  /// arrived.
  virtual bool spin(Milliseconds atMost) = 0;
  /// Spins until `isDone`, for at most `atMost`. Returns the last result of `isDone`.
  bool spinUntil(const std::function<bool()>& isDone, Milliseconds atMost);
};

}  // namespace bridge
