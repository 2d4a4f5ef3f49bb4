#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"

/// ROS 2 nodes on plain DDS. Messages are bytes; topic and service names are resolved and mangled
/// here; types are written as "pkg/msg/Name" or "pkg/srv/Name".
namespace bridge {

/// The RMW implementation of the other nodes (their RMW_IMPLEMENTATION). Topics are compatible
/// between both. Service calls encode the request identity differently, so services work with one
/// of them.
enum class Rmw { FastRtps, CycloneDds };
/// From Iron on, GIDs in the graph are 16 bytes instead of 24. There is no other difference.
enum class Distro { Humble, Jazzy };

constexpr int kLastDomain = 232;  // the last domain with valid UDP ports

struct DomainSettings {
  int domain = 0;  // ROS_DOMAIN_ID, 0 … 232
  Rmw rmw = Rmw::FastRtps;
  Distro distro = Distro::Humble;
  bool localhostOnly = true;  // false: every interface, with multicast
};

/// Whether `name` is a namespace: "/" or "/lab/a", parts of letters, digits and _, not starting
/// with a digit.
inline bool isNamespace(const std::string& name) {
  bool begins = true;  // start of a name part
  for (std::size_t i = 1; i < name.size(); ++i) {
    const char c = name[i];
    const bool isLetter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    const bool isInside = !begins && ((c >= '0' && c <= '9') || c == '/');
    if (!isLetter && !isInside) {
      return false;
    }
    begins = c == '/';
  }
  return !name.empty() && name.front() == '/' && (name.size() == 1 || !begins);
}

/// A CDR message with its 4-byte encapsulation header.
using Bytes = std::string;

/// Quality of service of a topic. The defaults are those of a ROS 2 topic.
struct Qos {
  bool reliable = true;
  bool transientLocal = false;  // late subscribers get the last samples
  int depth = 10;               // history depth
  double lifespan = 0.0;        // [s]; 0: infinite
  /// For subscriptions: also receives from publishers whose offered QoS is incompatible, without
  /// retransmission of lost samples. Plain DDS does not match them.
  bool anyPublisher = false;

  static Qos keepLast(int depth) { return {true, false, depth, 0.0, false}; }
  static Qos sensor() { return {false, false, 5, 0.0, false}; }  // for subscriptions
  static Qos latched() { return {true, true, 1, 0.0, false}; }   // /map, /tf_static
  static Qos clockReader() { return {false, false, 1, 0.0, false}; }
  /// For input from other programs with any QoS.
  static Qos input(int depth = 10) { return {true, false, depth, 0.0, true}; }
  static Qos transforms() { return keepLast(100); }
  static Qos parameters() { return keepLast(1000); }  // parameter services and events
  static Qos log() { return {true, true, 1000, 10.0, false}; }
};

/// Mangling of ROS 2 names for DDS. See design.ros2.org, "Topic and Service name mapping to
/// DDS".

/// "human_states" in namespace "/lab" -> "/lab/human_states"; "~/x" of node "a" -> "/lab/a/x".
/// Absolute names are unchanged.
std::string resolvedName(const std::string& name, const std::string& nameSpace,
                         const std::string& node);

/// "/a/b" -> "rt/a/b".
std::string ddsTopic(const std::string& topic);
/// "rt/a/b" -> "/a/b". Empty if it is not a ROS 2 topic.
std::string rosTopic(const std::string& ddsTopic);

class DdsEntities;
class OwnedWriter;
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

  /// Returns the node index. `nameSpace` is the namespace: "/" or "/lab".
  int addNode(const std::string& nameSpace, const std::string& name);

  // Errors: the topic exists with another type, or DDS cannot create the endpoint. Subscriptions do
  // not receive samples published by this participant.
  base::Result<std::unique_ptr<Publisher>> publisher(int node, const std::string& topic,
                                                     const std::string& type, const Qos& qos);
  base::Result<std::unique_ptr<Subscription>> subscription(int node, const std::string& topic,
                                                           const std::string& type, const Qos& qos,
                                                           Handler handler);
  base::Result<std::unique_ptr<Server>> server(int node, const std::string& service,
                                               const std::string& type, const Qos& qos,
                                               ServiceCallback callback);
  base::Result<std::unique_ptr<Client>> client(int node, const std::string& service,
                                               const std::string& type);

  /// Whether another participant of the domain has ever been discovered.
  bool hasDiscoveredPeers() const;
  /// The topics discovered so far, in order of discovery, at most 10 000.
  std::vector<RemoteTopic> remoteTopics();

  /// Publishes the nodes and endpoints to the ROS 2 graph. Call after the last endpoint is created.
  void publishGraph();

  /// Delivers the samples that have arrived; waits at most `atMost` for the first one. False: none
  /// arrived.
  bool spin(Milliseconds atMost);
  /// Spins until `isDone`, for at most `atMost`. Returns the last result of `isDone`.
  bool spinUntil(const std::function<bool()>& isDone, Milliseconds atMost);

 private:
  explicit Participant(std::shared_ptr<DdsEntities> dds);
  std::string resolved(int node, const std::string& name) const;
  base::Diagnostic endpointError(const std::string& name, const std::string& ddsName,
                                 const std::string& type) const;

  std::shared_ptr<DdsEntities> dds_;
  std::shared_ptr<OwnedWriter> graph_;
};

}  // namespace bridge
