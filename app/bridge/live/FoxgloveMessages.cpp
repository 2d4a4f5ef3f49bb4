#include "app/bridge/live/FoxgloveMessages.h"

#include <limits>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "app/bridge/live/FoxgloveServer.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/LittleEndian.h"

namespace live {

namespace {

using RequestJson = nlohmann::json;

constexpr int kDeepest = 16;                // nesting depth of JSON
constexpr std::size_t kMostItems = 1000;    // of a list
constexpr std::size_t kLongestName = 1000;  // [B], of names sent by clients

/// Thrown by the functions below, caught in requestOfText.
struct ParseError {
  std::string why;
};

const RequestJson& at(const RequestJson& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) {
    throw ParseError{std::string("'") + key + "' is missing"};
  }
  return *found;
}

std::uint32_t numberOf(const RequestJson& value, const char* what) {
  if (!value.is_number_unsigned() ||
      value.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max()) {
    throw ParseError{std::string("'") + what + "' must be an integer from 0 to 4294967295"};
  }
  return value.get<std::uint32_t>();
}

std::string textOf(const RequestJson& value, const char* what) {
  if (!value.is_string() || value.get_ref<const std::string&>().size() > kLongestName) {
    throw ParseError{std::string("'") + what + "' must be a short text"};
  }
  return value.get<std::string>();
}

std::string textAt(const RequestJson& object, const char* key) {
  return textOf(at(object, key), key);
}

/// Calls read(item) for each item of a list.
template <class Read>
auto listAt(const RequestJson& object, const char* key, Read read) {
  const RequestJson& list = at(object, key);
  if (!list.is_array() || list.size() > kMostItems) {
    throw ParseError{std::string("'") + key + "' must be a list of at most 1000 items"};
  }
  std::vector<decltype(read(list))> items;
  items.reserve(list.size());
  for (const RequestJson& item : list) {
    items.push_back(read(item));
  }
  return items;
}

std::vector<std::uint32_t> numbersAt(const RequestJson& object, const char* key) {
  return listAt(object, key, [key](const RequestJson& item) { return numberOf(item, key); });
}

std::vector<std::string> namesAt(const RequestJson& object) {
  return listAt(object, "parameterNames",
                [](const RequestJson& item) { return textOf(item, "parameterNames"); });
}

std::optional<std::string> idOf(const RequestJson& object) {
  const auto found = object.find("id");
  return found == object.end() || found->is_null() ? std::nullopt
                                                   : std::optional(textOf(*found, "id"));
}

const RequestJson& asObject(const RequestJson& item) {
  if (!item.is_object()) {
    throw ParseError{"the items of a list must be objects"};
  }
  return item;
}

/// Lists and objects are not supported as values.
ParameterValue valueOf(const RequestJson& value) {
  if (value.is_boolean()) {
    return value.get<bool>();
  }
  if (value.is_number_integer()) {
    const bool isTooLarge =
        value.is_number_unsigned() &&
        value.get<std::uint64_t>() >
            static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    return isTooLarge ? ParameterValue(value.get<double>())
                      : ParameterValue(value.get<std::int64_t>());
  }
  if (value.is_number_float()) {
    return value.get<double>();
  }
  return value.is_string() ? ParameterValue(textOf(value, "value")) : ParameterValue();
}

request::Subscribe subscribeOf(const RequestJson& object) {
  return {listAt(object, "subscriptions", [](const RequestJson& item) {
    return Subscription{numberOf(at(asObject(item), "id"), "id"),
                        numberOf(at(item, "channelId"), "channelId")};
  })};
}

request::Advertise advertiseOf(const RequestJson& object) {
  return {listAt(object, "channels", [](const RequestJson& item) {
    return ClientChannel{numberOf(at(asObject(item), "id"), "id"), textAt(item, "topic"),
                         textAt(item, "encoding"), textAt(item, "schemaName")};
  })};
}

request::SetParameters setParametersOf(const RequestJson& object) {
  request::SetParameters set;
  set.values = listAt(object, "parameters", [](const RequestJson& item) {
    const auto value = asObject(item).find("value");
    return NamedValue{textAt(item, "name"),
                      value == item.end() ? ParameterValue() : valueOf(*value)};
  });
  set.id = idOf(object);
  return set;
}

ClientRequest requestOf(const RequestJson& object) {
  const std::string op = textAt(object, "op");
  if (op == "subscribe") {
    return subscribeOf(object);
  }
  if (op == "unsubscribe") {
    return request::Unsubscribe{numbersAt(object, "subscriptionIds")};
  }
  if (op == "advertise") {
    return advertiseOf(object);
  }
  if (op == "unadvertise") {
    return request::Unadvertise{numbersAt(object, "channelIds")};
  }
  if (op == "getParameters") {
    return request::GetParameters{namesAt(object), idOf(object)};
  }
  if (op == "setParameters") {
    return setParametersOf(object);
  }
  if (op == "subscribeParameterUpdates" || op == "unsubscribeParameterUpdates") {
    return request::WatchParameters{namesAt(object), op.front() == 's'};
  }
  return request::Refused{"unknown operation '" + op + "'"};
}

}  // namespace

ClientRequest requestOfText(std::string_view message) {
  if (base::shallowJson(message, kDeepest).size() < message.size()) {
    return request::Refused{"brackets are nested too deeply"};
  }
  const RequestJson object = RequestJson::parse(message, nullptr, false);
  if (!object.is_object()) {
    return request::Refused{"a text message must be a JSON object"};
  }
  try {
    return requestOf(object);
  } catch (const ParseError& wrong) {
    return request::Refused{wrong.why};
  }
}

ClientRequest requestOfBytes(std::string_view message) {
  constexpr char kPublish = 1, kCall = 2;
  if (message.empty() || (message[0] != kPublish && message[0] != kCall)) {
    return request::Refused{"the first byte of a binary message must be 1 or 2"};
  }
  const bool isCall = message[0] == kCall;
  message.remove_prefix(1);
  if (message.size() < (isCall ? 12U : 4U)) {
    return request::Refused{"a binary message is truncated"};
  }
  const std::uint32_t first = base::littleEndian<std::uint32_t>(message);
  if (!isCall) {
    return request::Publish{first, message.substr(4)};
  }
  const std::uint32_t call = base::littleEndian<std::uint32_t>(message.substr(4));
  const std::uint32_t length = base::littleEndian<std::uint32_t>(message.substr(8));
  message.remove_prefix(12);
  if (length > message.size()) {
    return request::Refused{"a binary message is truncated"};
  }
  return request::CallService{first, call, message.substr(0, length), message.substr(length)};
}

namespace {

using ServerJson = nlohmann::ordered_json;

enum BinaryOp : char { MessageData = 1, ServerTime = 2, ServiceResponse = 3 };

constexpr const char* kEncoding = "cdr";
constexpr const char* kSchemaEncoding = "ros2msg";

std::string lineOf(const ServerJson& json) {
  return base::jsonText(json, -1);
}

ServerJson schemaJson(const Schema& schema) {
  return {{"encoding", kEncoding},
          {"schemaName", schema.name},
          {"schemaEncoding", kSchemaEncoding},
          {"schema", schema.text}};
}

ServerJson valueJson(const NamedValue& each) {
  ServerJson json = {{"name", each.name}};
  std::visit(
      [&json](const auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (!std::is_same_v<Value, std::monostate>) {
          json["value"] = value;
        }
        if constexpr (std::is_same_v<Value, double>) {
          json["type"] = "float64";
        }
      },
      each.value);
  return json;
}

}  // namespace

std::string serverInfoText(const FoxgloveSettings& settings) {
  ServerJson capabilities = ServerJson::array({"time"});
  if (!settings.clientTopics.empty()) {
    capabilities.push_back("clientPublish");
  }
  if (!settings.services.empty()) {
    capabilities.push_back("services");
  }
  if (!settings.parameters.empty()) {
    capabilities.push_back("parameters");
    capabilities.push_back("parametersSubscribe");
  }
  return lineOf({{"op", "serverInfo"},
                 {"name", settings.name},
                 {"capabilities", capabilities},
                 {"supportedEncodings", {kEncoding, "json"}},
                 {"metadata", ServerJson::object()},
                 {"sessionId", settings.session}});
}

std::string advertiseText(const std::vector<Channel>& channels) {
  ServerJson list = ServerJson::array();
  for (std::size_t i = 0; i < channels.size(); ++i) {
    list.push_back({{"id", i + 1}, {"topic", channels[i].topic}});
    list.back().update(schemaJson(channels[i].schema));
  }
  return lineOf({{"op", "advertise"}, {"channels", list}});
}

std::string servicesText(const std::vector<Service>& services) {
  ServerJson list = ServerJson::array();
  for (std::size_t i = 0; i < services.size(); ++i) {
    list.push_back({{"id", i + 1},
                    {"name", services[i].name},
                    {"type", services[i].type},
                    {"request", schemaJson(services[i].request)},
                    {"response", schemaJson(services[i].response)},
                    // for clients older than 2024
                    {"requestSchema", services[i].request.text},
                    {"responseSchema", services[i].response.text}});
  }
  return lineOf({{"op", "advertiseServices"}, {"services", list}});
}

std::string statusText(StatusLevel level, const std::string& message, const std::string& id) {
  ServerJson json = {{"op", "status"}, {"level", static_cast<int>(level)}, {"message", message}};
  if (!id.empty()) {
    json["id"] = id;
  }
  return lineOf(json);
}

std::string parametersText(const std::vector<NamedValue>& values,
                           const std::optional<std::string>& id) {
  ServerJson list = ServerJson::array();
  for (const NamedValue& each : values) {
    list.push_back(valueJson(each));
  }
  ServerJson json = {{"op", "parameterValues"}, {"parameters", list}};
  if (id) {
    json["id"] = *id;
  }
  return lineOf(json);
}

std::string callFailureText(std::uint32_t service, std::uint32_t call, const std::string& why) {
  return lineOf(
      {{"op", "serviceCallFailure"}, {"serviceId", service}, {"callId", call}, {"message", why}});
}

std::string timeMessage(std::uint64_t time) {
  std::string bytes(1, ServerTime);
  base::appendLittleEndian(bytes, time);
  return bytes;
}

std::string messageHead(std::uint32_t subscription, std::uint64_t time) {
  std::string bytes(1, MessageData);
  base::appendLittleEndian(bytes, subscription);
  base::appendLittleEndian(bytes, time);
  return bytes;
}

std::string callResponse(const request::CallService& call, const std::string& payload) {
  std::string bytes(1, ServiceResponse);
  base::appendLittleEndian(bytes, call.service);
  base::appendLittleEndian(bytes, call.call);
  base::appendLittleEndian(bytes, static_cast<std::uint32_t>(call.encoding.size()));
  return bytes.append(call.encoding).append(payload);
}

}  // namespace live
