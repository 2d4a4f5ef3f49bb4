#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/external/CommandLine.h"
#include "sim2d/nav/external/ExternalPlanner.h"
#include "sim2d/nav/external/ExternalProcess.h"

namespace sim2d {

namespace {

constexpr double kLongestTimeout = 3600.0;  // [s]

class ExternalPlanner : public Planner {
 public:
  ExternalPlanner(PlannerSetup setup, const ExternalCommand& command,
                  std::unique_ptr<ExternalProcess> process)
      : setup_(std::move(setup)), command_(command), process_(std::move(process)) {}
  ~ExternalPlanner() override {
    if (isReady_ && !setup_.stop->isStopRequested()) {
      process_->finish(endLine("over"));
    }
  }
  ExternalPlanner(const ExternalPlanner&) = delete;
  ExternalPlanner& operator=(const ExternalPlanner&) = delete;
  ExternalPlanner(ExternalPlanner&&) = delete;
  ExternalPlanner& operator=(ExternalPlanner&&) = delete;

  base::Result<BodyTwist> command(const Observation& observation) override {
    if (problems_.empty() && !isReady_) {
      sendGreeting(observation);
    }
    base::Result<ExternalAnswer> answer =
        problems_.empty() ? next(observation) : base::Result<ExternalAnswer>(problems_);
    if (!answer) {
      fail(answer.diagnostics());
      return withRobotName(setup_.robot, problems_);
    }
    path_ = std::move(answer->path);
    return answer->twist;
  }

  std::vector<Vec2> path() const override { return path_; }

 private:
  void fail(const base::Diagnostics& problems) {
    problems_ = problems;
    path_.clear();
    process_->abandon();
  }

  void sendGreeting(const Observation& observation) {
    const base::Result<std::string> answer =
        process_->ask(greetingLine(setup_, observation), command_.firstTimeout);
    const base::Result<std::string> name =
        answer ? readReady(*answer) : base::Result<std::string>(answer.diagnostics());
    if (!name) {
      fail(name.diagnostics());
      return;
    }
    isReady_ = true;
    wallVersion_ = observation.navigation->version();
  }

  base::Result<ExternalAnswer> next(const Observation& observation) {
    ObservationParts parts;
    parts.walls = observation.navigation->version() != wallVersion_;
    parts.scan = observation.scan != nullptr && observation.scan->time != scanTime_;
    const base::Result<std::string> answer =
        process_->ask(observationLine(observation, parts), command_.timeout);
    if (!answer) {
      return answer.diagnostics();
    }
    wallVersion_ = observation.navigation->version();
    if (parts.scan) {
      scanTime_ = observation.scan->time;
    }
    return readAnswer(*answer);
  }

  const PlannerSetup setup_;
  const ExternalCommand command_;
  std::unique_ptr<ExternalProcess> process_;
  bool isReady_ = false;
  int wallVersion_ = -1;            // version of the walls sent last
  std::optional<double> scanTime_;  // [s], of the last scan sent
  std::vector<Vec2> path_;
  base::Diagnostics problems_;  // set after a failure
};

base::Diagnostics timeoutProblems(const ExternalCommand& command) {
  for (const double seconds : {command.timeout, command.firstTimeout}) {
    if (!(seconds > 0.0 && seconds <= kLongestTimeout)) {
      return {base::error("external.bad-timeout", {kLongestTimeout, seconds})};
    }
  }
  return {};
}

base::Result<std::unique_ptr<ExternalProcess>> startExternal(const PlannerSetup& setup,
                                                             const ExternalCommand& command) {
  if (base::trimmed(command.command).empty()) {
    return base::error("external.no-command");
  }
  if (setup.code != ExternalCodePolicy::Allowed) {
    return base::error("external.not-allowed", {command.command});
  }
  const base::Diagnostics wrong = timeoutProblems(command);
  return wrong.empty() ? ExternalProcess::start(command.command, setup.stop) : wrong;
}

}  // namespace

base::Result<std::shared_ptr<Planner>> makeExternalPlanner(const PlannerSetup& setup,
                                                           const ExternalCommand& command) {
  base::Result<std::unique_ptr<ExternalProcess>> process = startExternal(setup, command);
  if (!process) {
    return withRobotName(setup.robot, process.diagnostics());
  }
  return std::shared_ptr<Planner>(
      std::make_shared<ExternalPlanner>(setup, command, *std::move(process)));
}

base::Diagnostics checkExternalCommand(const PlannerSetup& setup, const ExternalCommand& command) {
  base::Diagnostics problems = timeoutProblems(command);
  if (!ExternalProcess::isSocket(command.command)) {
    const base::Result<std::vector<std::string>> words = splitCommandLine(command.command);
    base::append(problems,
                 words ? resolveExecutable(words->front()).diagnostics() : words.diagnostics());
  }
  return withRobotName(setup.robot, problems);
}

namespace {

using ProtocolJson = nlohmann::ordered_json;

constexpr int kProtocol = 1;  // incremented by incompatible changes

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
  for (const Outline* outline : enabledOutlines(obstacles)) {
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
          {"angle_min", scan.angleMin}, {"per_beam", scan.angleIncrement},
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
          {"radius", circumscribedRadius(footprint)},
          {"footprint", outline},
          {"mass", setup.body.mass},
          {"limits", protocolJson(setup.body.limits)}};
}

/// Parses an answer; its `error` key, if present, becomes an error.
base::Result<ProtocolJson> answerObject(const std::string& line) {
  ProtocolJson json =
      ProtocolJson::parse(base::shallowJson(line), nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) {
    return base::error("external.not-json", {printableText(line)});
  }
  if (const auto complaint = json.find("error"); complaint != json.end()) {
    const std::string text =
        complaint->is_string() ? complaint->get<std::string>() : base::jsonText(*complaint, -1);
    return base::error("external.complaint", {printableText(text)});
  }
  return json;
}

std::optional<double> finiteJsonNumber(const ProtocolJson& json) {
  if (!json.is_number() || !std::isfinite(json.get<double>())) {
    return std::nullopt;
  }
  return json.get<double>();
}

/// `fallback` none: the key is required.
base::Result<double> answerNumber(const ProtocolJson& object, const char* key,
                                  std::optional<double> fallback) {
  const auto found = object.find(key);
  if (found == object.end()) {
    if (fallback) {
      return *fallback;
    }
    return base::error("external.no-key", {key, printableText(base::jsonText(object, -1))});
  }
  const std::optional<double> number = finiteJsonNumber(*found);
  if (!number) {
    return base::error("external.no-number", {key, printableText(base::jsonText(*found, -1))});
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
    return base::error("external.bad-path", {printableText(base::jsonText(*found, -1))});
  }
  path.reserve(found->size());
  for (const ProtocolJson& each : *found) {
    const std::optional<Vec2> point = answerPoint(each);
    if (!point) {
      return base::error("external.bad-path", {printableText(base::jsonText(each, -1))});
    }
    path.push_back(*point);
  }
  return path;
}

}  // namespace

std::vector<const Outline*> enabledOutlines(const Obstacles& obstacles) {
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
    return base::error("external.not-ready", {printableText(line)});
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

namespace {

base::ParameterTable<ExternalCommand> externalTable() {
  base::ParameterTable<ExternalCommand> table;
  table.add(&ExternalCommand::timeout, "timeout", "s", {0.0, 3600.0, true},
            "Maximum response time of the program in the robot's `command`.");
  return table;
}

base::Result<std::shared_ptr<Planner>> makeExternal(const PlannerSetup& setup) {
  ExternalCommand command;
  externalTable().set(command, setup.parameters);
  command.command = setup.command;
  if (setup.code != ExternalCodePolicy::Skipped) {
    return makeExternalPlanner(setup, command);
  }
  base::Diagnostics problems = checkExternalCommand(setup, command);
  if (!problems.empty()) {
    return problems;
  }
  return std::shared_ptr<Planner>(std::make_shared<IdlePlanner>());
}

}  // namespace

void addExternal(PlannerRegistry& to);
void addExternal(PlannerRegistry& to) {
  to.add(kExternalPlanner, externalTable().specs(), makeExternal,
         "An external planner: a program that is called in every time step.");
}

}  // namespace sim2d
