#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

/// Messages of the Foxglove WebSocket protocol, version 1, as JSON texts and little-endian binary
/// ones: parsing of client requests, and the server's messages.
/// https://github.com/foxglove/ws-protocol, docs/spec.md.
namespace live {

struct Channel;           // of FoxgloveServer.h
struct FoxgloveSettings;  // of FoxgloveServer.h
struct Service;           // of FoxgloveServer.h

/// The value of a parameter. monostate: no value.
using ParameterValue = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

struct Subscription {
  std::uint32_t id = 0, channel = 0;  // client's subscription id; server's channel id
};
struct ClientChannel {
  std::uint32_t id = 0;  // client's channel id
  std::string topic, encoding, schemaName;
};
struct NamedValue {
  std::string name;
  ParameterValue value;
};

namespace request {
struct Subscribe {
  std::vector<Subscription> subscriptions;
};
struct Unsubscribe {
  std::vector<std::uint32_t> subscriptions;
};
struct Advertise {
  std::vector<ClientChannel> channels;
};
struct Unadvertise {
  std::vector<std::uint32_t> channels;
};
struct GetParameters {
  std::vector<std::string> names;  // empty: all
  std::optional<std::string> id;
};
struct SetParameters {
  std::vector<NamedValue> values;
  std::optional<std::string> id;
};
struct WatchParameters {
  std::vector<std::string> names;
  bool isWatched = true;
};
struct Publish {
  std::uint32_t channel = 0;  // client's channel id
  std::string_view payload;   // points into the message
};
struct CallService {
  std::uint32_t service = 0, call = 0;
  std::string_view encoding, payload;  // points into the message
};
/// An invalid or unsupported request.
struct Refused {
  std::string why;
};
}  // namespace request

using ClientRequest =
    std::variant<request::Subscribe, request::Unsubscribe, request::Advertise, request::Unadvertise,
                 request::GetParameters, request::SetParameters, request::WatchParameters,
                 request::Publish, request::CallService, request::Refused>;

/// Parse any bytes; an invalid message yields Refused.
ClientRequest requestOfText(std::string_view message);
ClientRequest requestOfBytes(std::string_view message);

std::string serverInfoText(const FoxgloveSettings& settings);
/// Channels are numbered from 1.
std::string advertiseText(const std::vector<Channel>& channels);
std::string servicesText(const std::vector<Service>& services);

enum class StatusLevel { Info, Warning, Error };
/// `id`: a later status with the same id replaces this one.
std::string statusText(StatusLevel level, const std::string& message, const std::string& id = {});
std::string parametersText(const std::vector<NamedValue>& values,
                           const std::optional<std::string>& id);
std::string callFailureText(std::uint32_t service, std::uint32_t call, const std::string& why);

std::string timeMessage(std::uint64_t time);  // [ns]
/// The beginning of a topic message, which its payload follows.
std::string messageHead(std::uint32_t subscription, std::uint64_t time);
/// `payload`: in the encoding of the call.
std::string callResponse(const request::CallService& call, const std::string& payload);

}  // namespace live
