#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/bridge/dds/Participant.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/rcl_interfaces.h"
#include "sim2d/base/Result.h"

namespace bridge {

/// A publisher of messages of type M.
template <class M>
class TypedPublisher {
 public:
  TypedPublisher() = default;
  explicit TypedPublisher(std::unique_ptr<Publisher> publisher)
      : publisher_(std::move(publisher)) {}
  /// Does not encode the message if there are no subscribers.
  bool publish(const M& message) const {
    return publisher_ != nullptr &&
           (!publisher_->hasReceivers() || publisher_->publish(encode(message)));
  }
  int matched() const { return publisher_ == nullptr ? 0 : publisher_->matched(); }

 private:
  std::unique_ptr<Publisher> publisher_;
};

/// A node like those of rclcpp: with `/rosout`, `/parameter_events` and the parameter services.
/// Endpoints that could not be created, and requests or messages that cannot be decoded, are
/// reported to `report`.
class Node {
 public:
  using ReportCallback = std::function<void(const base::Diagnostic&)>;
  using Parameters = std::vector<rcl_interfaces::Parameter>;

  /// `parameters`: all parameters of the node. Other nodes can set them to values of the same type.
  Node(Participant& participant, const DomainSettings& settings, const std::string& nameSpace,
       const std::string& name, Parameters parameters, ReportCallback report);
  ~Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  Node(Node&&) = delete;
  Node& operator=(Node&&) = delete;

  template <class M>
  TypedPublisher<M> publisher(const std::string& topic, const Qos& qos) {
    return TypedPublisher<M>(unwrapOrReport(participant_.publisher(node_, topic, M::kType, qos)));
  }

  /// Null: DDS cannot create the subscription (reported).
  template <class M>
  const Subscription* subscribe(const std::string& topic, const Qos& qos,
                                std::function<void(const M&)> handler) {
    const auto read = [this, topic, handler = std::move(handler)](const Bytes& bytes) {
      const base::Result<M> message = decode<M>(bytes);
      if (message) {
        handler(*message);
      } else {
        reportBadMessage(topic, message.diagnostics());
      }
    };
    subscriptions_.push_back(
        unwrapOrReport(participant_.subscription(node_, topic, M::kType, qos, read)));
    return subscriptions_.back().get();
  }

  /// Subscribes without decoding. False: DDS cannot create the subscription (reported).
  bool subscribeBytes(const RemoteTopic& topic, const Qos& qos, Participant::Handler handler) {
    subscriptions_.push_back(unwrapOrReport(
        participant_.subscription(node_, topic.name, topic.type, qos, std::move(handler))));
    return subscriptions_.back() != nullptr;
  }

  /// A request that cannot be decoded gets an empty response, because some clients wait without a
  /// timeout.
  template <class S>
  void serve(const std::string& service, const Qos& qos,
             std::function<typename S::Response(const typename S::Request&)> answer) {
    const auto reply = [this, service, answer = std::move(answer)](const ServiceRequest& asked) {
      const base::Result<typename S::Request> request = decode<typename S::Request>(asked.bytes);
      if (!request) {
        reportBadRequest(service, asked, request.diagnostics());
      }
      return encode(request ? answer(*request) : typename S::Response());
    };
    servers_.push_back(unwrapOrReport(participant_.server(node_, service, S::kType, qos, reply)));
  }

  int number() const { return node_; }  // index in the participant

  /// Publishes to /rosout. Levels are those of rcl_interfaces::Log.
  void log(std::uint8_t level, const std::string& text);

  /// Null: unknown parameter.
  const rcl_interfaces::ParameterValue* parameter(const std::string& name) const;

 private:
  template <class E>
  std::unique_ptr<E> unwrapOrReport(base::Result<std::unique_ptr<E>> made) {
    if (made) {
      return *std::move(made);
    }
    for (const base::Diagnostic& problem : made.diagnostics()) {
      report_(problem);
    }
    return nullptr;
  }
  void serveParameters();
  void reportBadMessage(const std::string& topic, const base::Diagnostics& why);
  void reportBadRequest(const std::string& service, const ServiceRequest& asked,
                        const base::Diagnostics& why);
  rcl_interfaces::SetParametersResult set(const Parameters& wanted);
  std::string whyNot(const rcl_interfaces::Parameter& wanted) const;
  rcl_interfaces::ListParametersResult list(
      const rcl_interfaces::ListParameters::Request& request) const;

  Participant& participant_;
  Rmw rmw_;
  std::string fullName_, name_;
  int node_;
  Parameters parameters_;
  ReportCallback report_;
  TypedPublisher<rcl_interfaces::Log> log_;
  TypedPublisher<rcl_interfaces::ParameterEvent> events_;
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
  std::vector<std::unique_ptr<Server>> servers_;
};

/// How long to wait for other participants before their absence is reported.
constexpr std::chrono::seconds kNoPeerAfter(5);

/// Warns if no other participant of the domain is discovered in the first seconds. Otherwise a
/// program without subscribers looks like a working one.
class NoPeerCheck {
 public:
  explicit NoPeerCheck(const DomainSettings& settings)
      : settings_(settings), due_(std::chrono::steady_clock::now() + kNoPeerAfter) {}

  /// Returns the warning once, when it is due. Call it repeatedly.
  std::optional<base::Diagnostic> check(const Participant& participant);

 private:
  DomainSettings settings_;
  std::chrono::steady_clock::time_point due_;
  bool isDone_ = false;
};

/// Base of the programs on ROS 2. Owns the participant, reports each problem once and warns if
/// there is no other participant. The problems before `finishStart` are its result and not
/// reported.
class NodeProgram {
 public:
  using ReportCallback = Node::ReportCallback;

 protected:
  NodeProgram(std::unique_ptr<Participant> participant, const DomainSettings& domain,
              ReportCallback report)
      : participant_(std::move(participant)),
        report_(std::move(report)),
        domain_(domain),
        noPeer_(domain) {}

  std::unique_ptr<Node> makeNode(const std::string& nameSpace, const std::string& name,
                                 Node::Parameters parameters);
  /// Publishes the nodes and endpoints to the ROS 2 graph.
  base::Diagnostics finishStart();
  void reportOnce(const base::Diagnostic& diagnostic);
  void reportMissingPeers();

  std::unique_ptr<Participant> participant_;
  ReportCallback report_;
  base::Diagnostics startProblems_;

 private:
  DomainSettings domain_;
  NoPeerCheck noPeer_;
  base::DiagnosticFilter reported_;
  bool hasStarted_ = false;
};

}  // namespace bridge
