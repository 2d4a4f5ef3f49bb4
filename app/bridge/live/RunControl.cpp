#include "app/bridge/live/RunControl.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/messages/FieldTraits.h"
#include "app/bridge/messages/geometry_msgs.h"
#include "app/bridge/messages/std_srvs.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/world/WorldState.h"

namespace live {
namespace {

/// A visitor that fills the fields of a message from a JSON object. Missing fields keep their
/// default, unknown fields are ignored. Lists are not supported; accepted messages have none.
class JsonReader {
 public:
  explicit JsonReader(const nlohmann::json& object)
      : object_(object), isValid_(object.is_object()) {}

  template <class T>
  void operator()(const char* name, T& value) {
    if (!isValid_) {
      return;
    }
    const auto found = object_.find(name);
    if (found != object_.end()) {
      read(*found, value);
    }
  }
  bool isValid() const { return isValid_; }

 private:
  template <class T>
  void read(const nlohmann::json& json, T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      take(json.is_boolean(), json, value);
    } else if constexpr (std::is_floating_point_v<T>) {
      take(json.is_number(), json, value);
    } else if constexpr (std::is_integral_v<T>) {
      const bool isWhole =
          json.is_number_integer() &&
          json.get<double>() >= static_cast<double>(std::numeric_limits<T>::min()) &&
          json.get<double>() <= static_cast<double>(std::numeric_limits<T>::max());
      take(isWhole, json, value);
    } else if constexpr (bridge::kIsString<T>) {
      take(json.is_string(), json, value);
    } else if constexpr (!bridge::kIsSequence<T> && !bridge::kIsArray<T>) {
      JsonReader inner(json);
      if constexpr (!bridge::kIsEmptyMessage<T>) {
        T::fields(value, inner);
      }
      isValid_ = isValid_ && inner.isValid();
    }
  }
  template <class T>
  void take(bool isValid, const nlohmann::json& json, T& value) {
    isValid_ = isValid_ && isValid;
    if (isValid) {
      value = json.get<T>();
    }
  }

  const nlohmann::json& object_;
  bool isValid_;
};

constexpr std::size_t kLargestJson = 65536;  // [B], far above valid messages

/// Nothing: the text is not JSON or too large, or a field has another type. Any bytes are safe.
template <class M>
std::optional<M> messageOfJson(std::string_view text) {
  if (text.size() > kLargestJson) {
    return std::nullopt;
  }
  const nlohmann::json object = nlohmann::json::parse(base::shallowJson(text), nullptr, false);
  M message;
  JsonReader fields(object);
  if constexpr (!bridge::kIsEmptyMessage<M>) {
    M::fields(message, fields);
  }
  return fields.isValid() ? std::optional<M>(message) : std::nullopt;
}

/// The JSON of a message that contains only numbers and strings.
template <class M>
std::string jsonOf(const M& message) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  M::fields(message, [&object](const char* name, const auto& value) { object[name] = value; });
  return base::jsonText(object, -1);
}

constexpr std::string_view kJson = "json";

template <class M>
std::optional<M> messageOf(std::string_view encoding, std::string_view payload) {
  if (encoding == kJson) {
    return messageOfJson<M>(payload);
  }
  base::Result<M> read = bridge::decode<M>(payload);
  return read ? std::optional<M>(*std::move(read)) : std::nullopt;
}

template <class Response>
ServiceAnswer answerOf(std::string_view encoding, bool isFine, const std::string& message) {
  Response response;
  response.success = isFine;
  response.message = message;
  return {true, encoding == kJson ? jsonOf(response) : bridge::encode(response)};
}

template <class M>
Schema schemaOf() {
  return {M::kType, M::kDefinition};
}

template <class S>
Service serviceOf(const char* name) {
  Service service;
  service.name = name;
  service.type = S::kType;
  service.request = schemaOf<typename S::Request>();
  service.response = schemaOf<typename S::Response>();
  return service;
}

std::optional<double> numberOf(const ParameterValue& value) {
  if (const auto* const whole = std::get_if<std::int64_t>(&value)) {
    return static_cast<double>(*whole);
  }
  const auto* const number = std::get_if<double>(&value);
  return number != nullptr ? std::optional(*number) : std::nullopt;
}

}  // namespace

RunControl::RunControl(app::Session& session, Facts facts, const std::vector<TeleopRobot>& robots)
    : session_(session), facts_(std::move(facts)), robots_(robots) {
  if (!robots_.empty()) {
    session_.steer([this](const sim2d::Frame&) { return takeCommands(); });
  }
}

RunControl::~RunControl() {
  if (!robots_.empty()) {
    session_.steer({});
  }
}

std::vector<Service> RunControl::services() {
  return {pauseService(), stepService()};
}

Service RunControl::pauseService() {
  using bridge::std_srvs::SetBool;
  Service service = serviceOf<SetBool>("/hunavsim/pause");
  service.call = [this](std::string_view encoding, std::string_view payload) {
    const auto request = messageOf<SetBool::Request>(encoding, payload);
    if (!request) {
      return ServiceAnswer{false, "the request is not a std_srvs/srv/SetBool"};
    }
    session_.setPaused(request->data);
    return answerOf<SetBool::Response>(encoding, true, request->data ? "paused" : "resumed");
  };
  return service;
}

/// The request is empty and need not be decoded.
Service RunControl::stepService() {
  using bridge::std_srvs::Trigger;
  Service service = serviceOf<Trigger>("/hunavsim/step");
  service.call = [this](std::string_view encoding, std::string_view) {
    if (!session_.isPaused()) {
      return answerOf<Trigger::Response>(encoding, false,
                                         "the run is not paused (/hunavsim/pause)");
    }
    session_.stepOnce();
    return answerOf<Trigger::Response>(encoding, true, "one step");
  };
  return service;
}

std::vector<Parameter> RunControl::parameters() {
  const auto fact = [](const char* name, const ParameterValue& value) {
    return Parameter{name, [value] { return value; }, nullptr};
  };
  return {{"/hunavsim.paused", [this] { return ParameterValue(session_.isPaused()); },
           [this](const ParameterValue& value) { return setPaused(value); }},
          {"/hunavsim.real_time_factor",
           // JSON has no infinity: unlimited speed has no value.
           [this] {
             const double factor = session_.speed();
             return std::isinf(factor) ? ParameterValue() : ParameterValue(factor);
           },
           [this](const ParameterValue& value) { return setSpeed(value); }},
          fact("/hunavsim.scenario", facts_.scenario),
          fact("/hunavsim.seed", facts_.seed),
          fact("/hunavsim.time_step", facts_.timeStep)};
}

std::string RunControl::setPaused(const ParameterValue& value) {
  const bool* const isPaused = std::get_if<bool>(&value);
  if (isPaused == nullptr) {
    return "must be true or false";
  }
  session_.setPaused(*isPaused);
  return {};
}

std::string RunControl::setSpeed(const ParameterValue& value) {
  const std::optional<double> speed = numberOf(value);
  if (!speed || !(*speed >= kSlowest && *speed <= kFastest)) {
    return "must be a number from 0.1 to 100";
  }
  session_.setSpeed(*speed);
  return {};
}

std::vector<ClientTopic> RunControl::clientTopics() {
  std::vector<ClientTopic> clientTopics;
  for (const TeleopRobot& robot : robots_) {
    clientTopics.push_back(
        {robot.topic, bridge::geometry_msgs::Twist::kType,
         [this, id = robot.id](std::string_view encoding, std::string_view payload) {
           return drive(id, encoding, payload);
         }});
  }
  return clientTopics;
}

std::string RunControl::drive(int robot, std::string_view encoding, std::string_view payload) {
  const auto twist = messageOf<bridge::geometry_msgs::Twist>(encoding, payload);
  if (!twist || !std::isfinite(twist->linear.x) || !std::isfinite(twist->linear.y) ||
      !std::isfinite(twist->angular.z)) {
    return "not a geometry_msgs/msg/Twist with finite numbers";
  }
  const auto isTooFast = [](double value) { return std::fabs(value) > sim2d::kMaxPlausibleSpeed; };
  if (isTooFast(twist->linear.x) || isTooFast(twist->linear.y) || isTooFast(twist->angular.z)) {
    return "velocities must be at most 1000";  // the world rejects them
  }
  sim2d::Input input;
  input.kind = sim2d::InputKind::Robot;
  input.id = robot;
  input.velocity = {twist->linear.x, twist->linear.y};
  input.omega = twist->angular.z;
  const std::lock_guard<std::mutex> lock(mutex_);
  commands_[robot] = input;
  return {};
}

sim2d::StepInputs RunControl::takeCommands() {
  const std::lock_guard<std::mutex> lock(mutex_);
  sim2d::StepInputs inputs;
  for (const auto& [robot, input] : commands_) {
    inputs.push_back(input);
  }
  commands_.clear();
  return inputs;
}

}  // namespace live
