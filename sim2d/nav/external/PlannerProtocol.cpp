#include "sim2d/nav/external/PlannerProtocol.h"

#include <cmath>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "sim2d/base/JsonText.h"
#include "sim2d/nav/external/ShownText.h"

namespace sim2d {
namespace {

using ProtocolJson = nlohmann::ordered_json;

constexpr int kProtocol = 1;  // raised when old programs would not understand the lines any more

ProtocolJson protocolJson(const Vec2& point) {
  return ProtocolJson::array({point.x(), point.y()});
}

ProtocolJson protocolJson(const Pose2& pose) {
  return {{"x", pose.position.x()}, {"y", pose.position.y()}, {"heading", pose.heading}};
}

ProtocolJson protocolJson(const std::vector<Vec2>& points) {
  ProtocolJson all = ProtocolJson::array();
  for (const Vec2& point : points) {
    all.push_back(protocolJson(point));
  }
  return all;
}

ProtocolJson protocolJson(const Obstacles& obstacles) {
  ProtocolJson all = ProtocolJson::array();
  for (const Outline* outline : standingOutlines(obstacles)) {
    all.push_back(protocolJson(outline->points));
  }
  return all;
}

ProtocolJson protocolJson(const DriveLimits& limits) {
  return {{"max_vel", limits.maxVel},     {"max_reverse", limits.maxReverse},
          {"max_acc", limits.maxAcc},     {"max_omega", limits.maxOmega},
          {"max_alpha", limits.maxAlpha}, {"turning_radius", limits.turningRadius}};
}

ProtocolJson protocolJson(const TrackedBody& body) {
  return {{"id", body.id},
          {"kind", body.kind == BodyKind::Person ? "person" : "robot"},
          {"position", protocolJson(body.position)},
          {"velocity", protocolJson(body.velocity)},
          {"heading", body.heading},
          {"radius", body.radius}};
}

ProtocolJson protocolJson(const LaserScan& scan) {
  return {{"time", scan.time},          {"sensor", protocolJson(scan.sensor)},
          {"angle_min", scan.angleMin}, {"per_beam", scan.perBeam},
          {"range", scan.range},        {"distances", scan.distances}};
}

ProtocolJson protocolJson(const PlannerSetup& setup) {
  const Footprint& footprint = setup.body.footprint;
  const ProtocolJson outline =
      footprint.isDisc() ? ProtocolJson::object({{"radius", footprint.radius}})
                         : ProtocolJson::object({{"corners", protocolJson(footprint.corners)}});
  return {{"name", setup.robot},
          {"id", setup.robotId},
          {"kinematics", kinematicsName(setup.body.kinematics)},
          {"radius", reachOf(footprint)},
          {"footprint", outline},
          {"mass", setup.body.mass},
          {"limits", protocolJson(setup.body.limits)}};
}

/// The object of an answer; its complaint, if it has one, is an error.
base::Result<ProtocolJson> answerObject(const std::string& line) {
  ProtocolJson json = ProtocolJson::parse(line, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) {
    return base::error("external.not-json", {shownText(line)});
  }
  if (const auto complaint = json.find("error"); complaint != json.end()) {
    const std::string text =
        complaint->is_string() ? complaint->get<std::string>() : base::jsonText(*complaint, -1);
    return base::error("external.complaint", {shownText(text)});
  }
  return json;
}

std::optional<double> finiteJsonNumber(const ProtocolJson& json) {
  if (!json.is_number() || !std::isfinite(json.get<double>())) {
    return std::nullopt;
  }
  return json.get<double>();
}

/// `fallback` none: the key must be there.
base::Result<double> answerNumber(const ProtocolJson& object, const char* key,
                                  std::optional<double> fallback) {
  const auto found = object.find(key);
  if (found == object.end()) {
    if (fallback) {
      return *fallback;
    }
    return base::error("external.no-key", {key, shownText(base::jsonText(object, -1))});
  }
  const std::optional<double> number = finiteJsonNumber(*found);
  if (!number) {
    return base::error("external.no-number", {key, shownText(base::jsonText(*found, -1))});
  }
  return *number;
}

std::optional<Vec2> answerPoint(const ProtocolJson& json) {
  if (!json.is_array() || json.size() != 2) {
    return std::nullopt;
  }
  const std::optional<double> x = finiteJsonNumber(json[0]);
  const std::optional<double> y = finiteJsonNumber(json[1]);
  return x && y ? std::make_optional(Vec2(*x, *y)) : std::nullopt;
}

base::Result<std::vector<Vec2>> answerPath(const ProtocolJson& object) {
  std::vector<Vec2> path;
  const auto found = object.find("path");
  if (found == object.end()) {
    return path;
  }
  if (!found->is_array()) {
    return base::error("external.bad-path", {shownText(base::jsonText(*found, -1))});
  }
  path.reserve(found->size());
  for (const ProtocolJson& each : *found) {
    const std::optional<Vec2> point = answerPoint(each);
    if (!point) {
      return base::error("external.bad-path", {shownText(base::jsonText(each, -1))});
    }
    path.push_back(*point);
  }
  return path;
}

}  // namespace

std::vector<const Outline*> standingOutlines(const Obstacles& obstacles) {
  std::vector<const Outline*> standing;
  for (int part = 0; part < obstacles.partCount(); ++part) {
    if (obstacles.isEnabled(part)) {
      for (const Outline& outline : obstacles.outlines(part)) {
        standing.push_back(&outline);
      }
    }
  }
  return standing;
}

std::string greetingLine(const PlannerSetup& setup, const Observation& observation) {
  ProtocolJson line;
  line["hunavsim"] = kProtocol;
  line["robot"] = protocolJson(setup);
  line["dt"] = observation.dt;
  line["seed"] = setup.seed;
  line["walls"] = protocolJson(*observation.obstacles);
  return base::jsonText(line, -1);
}

std::string observationLine(const Observation& observation, const ObservationParts& parts) {
  ProtocolJson line;
  line["time"] = observation.time;
  line["dt"] = observation.dt;
  line["pose"] = protocolJson(observation.pose);
  line["motion"] = {{"linear", observation.motion.linear},
                    {"angular", observation.motion.angular},
                    {"lateral", observation.motion.lateral}};
  line["goal"] = protocolJson(observation.goal);
  line["goal_radius"] = observation.goalRadius;
  line["bodies"] = ProtocolJson::array();
  for (const TrackedBody& body : observation.bodies) {
    line["bodies"].push_back(protocolJson(body));
  }
  if (parts.scan) {
    line["scan"] = protocolJson(*observation.scan);
  }
  if (parts.walls) {
    line["walls"] = protocolJson(*observation.obstacles);
  }
  return base::jsonText(line, -1);
}

std::string endLine(const std::string& reason) {
  return base::jsonText(ProtocolJson{{"end", true}, {"reason", reason}}, -1);
}

base::Result<std::string> readReady(const std::string& line) {
  const base::Result<ProtocolJson> object = answerObject(line);
  if (!object) {
    return object.diagnostics();
  }
  const auto ready = object->find("ready");
  if (ready == object->end() || *ready != true) {
    return base::error("external.not-ready", {shownText(line)});
  }
  const auto name = object->find("name");
  return name != object->end() && name->is_string() ? name->get<std::string>() : std::string();
}

base::Result<ExternalAnswer> readAnswer(const std::string& line) {
  const base::Result<ProtocolJson> object = answerObject(line);
  if (!object) {
    return object.diagnostics();
  }
  ExternalAnswer answer;
  const auto take = [&object](const char* key, std::optional<double> fallback, double& to) {
    const base::Result<double> number = answerNumber(*object, key, fallback);
    to = number ? *number : 0.0;
    return number.diagnostics();
  };
  base::Diagnostics problems = take("linear", std::nullopt, answer.twist.linear);
  base::append(problems, take("angular", std::nullopt, answer.twist.angular));
  base::append(problems, take("lateral", 0.0, answer.twist.lateral));
  base::Result<std::vector<Vec2>> path = answerPath(*object);
  base::append(problems, path.diagnostics());
  if (!problems.empty()) {
    return problems;
  }
  answer.path = *std::move(path);
  return answer;
}

}  // namespace sim2d
