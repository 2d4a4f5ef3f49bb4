#include "app/bridge/live/ServerMessages.h"

#include <type_traits>
#include <variant>

#include <nlohmann/json.hpp>

#include "sim2d/base/JsonText.h"
#include "sim2d/base/LittleEndian.h"

namespace live {

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
