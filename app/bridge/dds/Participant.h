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

/// Nodes of ROS 2 made of DDS alone: names and bytes, no types. Names are resolved and mangled
/// here; types are written as "pkg/msg/Name", "pkg/srv/Name".
namespace bridge {

using Milliseconds = std::chrono::milliseconds;

/// Endpoints live as long as these objects. All of it, with the participant, belongs to one thread.
class Publisher {
 public:
  virtual ~Publisher() = default;
  virtual bool publish(const Bytes& message) = 0;
  virtual int matched() const = 0;  // subscriptions of others
  /// A message would come to somebody, now or later: else it need not be made.
  virtual bool isWanted() const = 0;
};

class Subscription {
 public:
  virtual ~Subscription() = default;
  virtual int matched() const = 0;  // publishers of others
};

class Server {
 public:
  virtual ~Server() = default;
};

class Client {
 public:
  virtual ~Client() = default;
  /// A server is met, for half a second already: what is sent sooner may not reach it.
  virtual bool isReady() = 0;
  /// Waits for the answer in which nothing else is handed out. Nothing: no answer in time.
  virtual std::optional<Bytes> call(const Bytes& request, Milliseconds atMost) = 0;
  /// In two steps: send returns the number of the request, -1 when that was not possible; of
  /// `receive` one answer to any of them, when it is there.
  virtual std::int64_t send(const Bytes& request) = 0;
  virtual std::optional<std::pair<std::int64_t, Bytes>> receive() = 0;
};

/// A topic that others publish, with what their first publisher offers.
struct OthersTopic {
  std::string name, type;  // "/odom", "nav_msgs/msg/Odometry"
  bool reliable = false, transientLocal = false;
};

struct ServiceRequest {
  Bytes bytes;
  Rmw writtenFor = Rmw::FastRtps;  // as far as it can be told
};

/// One participant of a domain with any number of nodes. What arrives is handed out in `spin`, in
/// the thread that calls it, one after the other, of each endpoint in the order of arrival.
class Participant {
 public:
  using Handler = std::function<void(const Bytes&)>;
  using Answer = std::function<Bytes(const ServiceRequest&)>;

  /// Error: DDS refuses (no port is free, the domain is out of range …).
  static base::Result<std::unique_ptr<Participant>> create(const DomainSettings& settings);
  virtual ~Participant() = default;

  /// Returns its number. `space`: "/" or "/lab".
  virtual int addNode(const std::string& space, const std::string& name) = 0;

  // Errors: the topic is there with another type, DDS refuses. What the participant publishes
  // itself its subscriptions do not hear.
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
                                                       Answer answer) = 0;
  virtual base::Result<std::unique_ptr<Client>> client(int node, const std::string& service,
                                                       const std::string& type) = 0;

  /// Another participant of the domain was discovered, now or before.
  virtual bool hasMetAnyone() const = 0;
  /// Those that have been met so far, in that order, 10 000 at most.
  virtual std::vector<OthersTopic> topicsOfOthers() = 0;

  /// Tells the graph of ROS 2 the nodes and their endpoints: after the last one was made.
  virtual void announce() = 0;

  /// Hands out what has come; waits for the first of it at most so long. False: nothing came.
  virtual bool spin(Milliseconds atMost) = 0;
  /// Until `isDone`, at most so long; returns what `isDone` says at the end.
  bool spinUntil(const std::function<bool()>& isDone, Milliseconds atMost);
};

}  // namespace bridge
