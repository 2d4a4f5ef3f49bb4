#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/bridge/dds/Participant.h"
#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/ParameterMessages.h"
#include "app/bridge/messages/ParameterServices.h"

namespace bridge {

/// A publisher of one type.
template <class M>
class TopicOf {
 public:
  TopicOf() = default;
  explicit TopicOf(std::unique_ptr<Publisher> publisher) : publisher_(std::move(publisher)) {}
  /// Costs nothing where nobody would hear it.
  bool publish(const M& message) const {
    return publisher_ != nullptr &&
           (!publisher_->isWanted() || publisher_->publish(encode(message)));
  }
  int matched() const { return publisher_ == nullptr ? 0 : publisher_->matched(); }

 private:
  std::unique_ptr<Publisher> publisher_;
};

/// A node as rclcpp makes them: with `/rosout`, `/parameter_events` and the services of its
/// parameters. What could not be made, and requests or messages that cannot be read, go to `tell`.
class Node {
 public:
  using Tell = std::function<void(const base::Diagnostic&)>;
  using Parameters = std::vector<rcl_interfaces::Parameter>;

  /// `parameters`: all that the node has; others can set them to values of the same type.
  Node(Participant& participant, const DomainSettings& settings, const std::string& space,
       const std::string& name, Parameters parameters, Tell tell);
  ~Node() = default;
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  Node(Node&&) = delete;
  Node& operator=(Node&&) = delete;

  template <class M>
  TopicOf<M> publisher(const std::string& topic, const Qos& qos) {
    return TopicOf<M>(taken(participant_.publisher(node_, topic, M::kType, qos)));
  }

  /// Null: DDS refuses (told).
  template <class M>
  const Subscription* subscribe(const std::string& topic, const Qos& qos,
                                std::function<void(const M&)> handler) {
    const auto read = [this, topic, handler = std::move(handler)](const Bytes& bytes) {
      const base::Result<M> message = decode<M>(bytes);
      if (message) {
        handler(*message);
      } else {
        tellBadMessage(topic, message.diagnostics());
      }
    };
    subscriptions_.push_back(taken(participant_.subscription(node_, topic, M::kType, qos, read)));
    return subscriptions_.back().get();
  }

  /// Messages of a type that this node does not look into. False: DDS refuses (told).
  bool subscribeBytes(const OthersTopic& topic, const Qos& qos, Participant::Handler handler) {
    subscriptions_.push_back(
        taken(participant_.subscription(node_, topic.name, topic.type, qos, std::move(handler))));
    return subscriptions_.back() != nullptr;
  }

  /// A request that cannot be read is answered by an empty response: some clients wait for ever.
  template <class S>
  void serve(const std::string& service, const Qos& qos,
             std::function<typename S::Response(const typename S::Request&)> answer) {
    const auto reply = [this, service, answer = std::move(answer)](const ServiceRequest& asked) {
      const base::Result<typename S::Request> request = decode<typename S::Request>(asked.bytes);
      if (!request) {
        tellBadRequest(service, asked, request.diagnostics());
      }
      return encode(request ? answer(*request) : typename S::Response());
    };
    servers_.push_back(taken(participant_.server(node_, service, S::kType, qos, reply)));
  }

  int number() const { return node_; }  // in the participant

  /// To /rosout; level as in rcl_interfaces::Log.
  void log(std::uint8_t level, const std::string& text);

  /// Null: the node does not have it.
  const rcl_interfaces::ParameterValue* parameter(const std::string& name) const;

 private:
  template <class E>
  std::unique_ptr<E> taken(base::Result<std::unique_ptr<E>> made) {
    if (made) {
      return *std::move(made);
    }
    for (const base::Diagnostic& problem : made.diagnostics()) {
      tell_(problem);
    }
    return nullptr;
  }
  void serveParameters();
  void tellBadMessage(const std::string& topic, const base::Diagnostics& why);
  void tellBadRequest(const std::string& service, const ServiceRequest& asked,
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
  Tell tell_;
  TopicOf<rcl_interfaces::Log> log_;
  TopicOf<rcl_interfaces::ParameterEvent> events_;
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
  std::vector<std::unique_ptr<Server>> servers_;
};

/// What is told once: the same however the bytes of a message differ.
std::string causeOf(const base::Diagnostic& said);

/// Of the wall clock.
builtin_interfaces::Time wallTime();
/// "rmw_fastrtps_cpp", as RMW_IMPLEMENTATION has it.
const char* implementationName(Rmw rmw);
const char* rmwName(Rmw rmw);  // "fastrtps", "cyclonedds"

}  // namespace bridge
