#include "app/run/ResultRow.h"

#include <algorithm>
#include <iterator>

#include <nlohmann/json.hpp>

#include "metrics/MetricRegistry.h"
#include "metrics/Report.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(InputHash, path, sha256)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TreeRow, owners, paths, returned)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ResultRow, ok, failedBy, reason, simulated, fields, trees,
                                   inputs)

namespace {

using Json = nlohmann::ordered_json;
using RowJson = nlohmann::json;

constexpr const char* kTrue = "True";  // as in results.csv
constexpr const char* kFalse = "False";

std::string fieldOf(const Json& value) {
  if (value.is_null()) {
    return {};
  }
  if (value.is_boolean()) {
    return value.get<bool>() ? kTrue : kFalse;
  }
  if (value.is_number_float()) {
    return base::formatDouble(value.get<double>());
  }
  return base::jsonText(value, -1);
}

void addFields(const Json& of, const std::string& prefix, ResultRow& to) {
  for (const auto& [key, entry] : of.at("metrics").items()) {
    to.fields.emplace_back(prefix + key, fieldOf(entry.value("value", Json())));
  }
}

const char* fieldOf(bool value) {
  return value ? kTrue : kFalse;
}

/// For robots whose planners end goals themselves.
void addEnds(const FinishedRun& run, ResultRow& to) {
  const std::vector<std::string> names = metrics::robotNames(run.header.robots);
  for (std::size_t k = 0; k < run.result.robots.size() && k < names.size(); ++k) {
    const sim2d::RobotResult& robot = run.result.robots[k];
    if (!robot.decidesGoalEnd || !robot.result) {
      continue;
    }
    const std::string prefix = k == 0 ? std::string() : names[k] + ".";
    for (const EndColumn& column : endColumns()) {
      to.fields.emplace_back(prefix + column.key, fieldOf(column.end == endedBy(robot)));
    }
    to.fields.emplace_back(prefix + kDistanceLeft,
                           robot.goalResults.empty()
                               ? std::string()
                               : base::formatDouble(robot.goalResults.back().distance));
  }
}

}  // namespace

std::optional<EndedBy> endedBy(const sim2d::RobotResult& robot) {
  using sim2d::NavigationOutcome;
  if (!robot.result) {
    return std::nullopt;
  }
  switch (*robot.result) {
    case NavigationOutcome::Arrived:
    case NavigationOutcome::GoalMissed:
      return EndedBy::Success;
    case NavigationOutcome::NavigationFailed:
      return EndedBy::Failure;
    case NavigationOutcome::Collision:
      return EndedBy::Contact;
    case NavigationOutcome::Stuck:
      return EndedBy::Standstill;
    case NavigationOutcome::Timeout:
      return EndedBy::Time;
    case NavigationOutcome::Failed:
    case NavigationOutcome::Interrupted:
      break;
  }
  return std::nullopt;
}

const std::vector<EndColumn>& endColumns() {
  static const std::vector<EndColumn> kColumns = {
      {"ended_by_success", "Ended by the navigator's success", EndedBy::Success, 1},
      {"ended_by_failure", "Ended by the navigator's failure", EndedBy::Failure, -1},
      {"ended_by_contact", "Ended by a contact", EndedBy::Contact, -1},
      {"ended_by_standstill", "Ended by a standstill", EndedBy::Standstill, -1},
      {"ended_by_time", "Ended by time", EndedBy::Time, -1}};
  return kColumns;
}

std::optional<ColumnInfo> columnInfo(const std::string& column) {
  const std::size_t dot = column.rfind('.');
  const bool isOfRobot = dot != std::string::npos;
  const std::string own = isOfRobot ? column.substr(dot + 1) : column;
  const std::string robot = isOfRobot ? column.substr(0, dot) + ": " : "";
  if (const metrics::MetricEntry* entry = metrics::standardRegistry().find(own)) {
    const metrics::MetricInfo& info = entry->info;
    const int sense = info.better == metrics::Better::Higher  ? 1
                      : info.better == metrics::Better::Lower ? -1
                                                              : 0;
    return ColumnInfo{robot + info.name, info.unit, info.kind == metrics::Kind::Boolean,
                      info.kind == metrics::Kind::Count, sense};
  }
  if (const EndColumn* const end =
          base::findIf(endColumns(), [&own](const EndColumn& each) { return own == each.key; })) {
    return ColumnInfo{robot + end->name, {}, true, false, end->sense};
  }
  if (own == kDistanceLeft) {
    return ColumnInfo{robot + "Distance left when the navigator ended", "m", false, false, -1};
  }
  return std::nullopt;
}

std::vector<std::string> knownColumns() {
  std::vector<std::string> keys = metrics::standardRegistry().keys();
  for (const EndColumn& column : endColumns()) {
    keys.emplace_back(column.key);
  }
  keys.emplace_back(kDistanceLeft);
  return keys;
}

const std::string* fieldOf(const ResultRow& row, const std::string& column) {
  const auto* const field =
      base::findBy(row.fields, &std::pair<std::string, std::string>::first, column);
  return field != nullptr ? &field->second : nullptr;
}

std::optional<double> numberIn(const std::string& field) {
  return field == kTrue    ? std::optional(1.0)
         : field == kFalse ? std::optional(0.0)
                           : base::parseDouble(field);
}

std::optional<double> numberOf(const ResultRow& row, const std::string& column) {
  const std::string* const field = fieldOf(row, column);
  return field != nullptr ? numberIn(*field) : std::nullopt;
}

bool isSuccessKey(const std::string& key) {
  return std::find(std::begin(kSuccessKeys), std::end(kSuccessKeys), key) != std::end(kSuccessKeys);
}

bool isUnsuccessful(const ResultRow& row) {
  if (!row.ok) {
    return true;
  }
  for (const char* key : kSuccessKeys) {
    if (const std::string* const found = fieldOf(row, key)) {
      return *found == kFalse;
    }
  }
  return false;
}

std::string outcomeText(bool ok, const std::string& reason,
                        const std::function<double(const char* column)>& valueOf) {
  if (!ok) {
    return reason.empty() ? "failed" : reason;
  }
  const struct {
    const char* key;
    bool whenZero;
    const char* words;
  } signs[] = {{"robot_on_person_collision", false, "collided with a person"},
               {"person_on_robot_collision", false, "a person collided with the robot"},
               {"obstacle_collisions", false, "collided with an obstacle"},
               {"timeout", false, "timeout"},
               {"completed", true, "goal not reached"}};
  std::vector<std::string> texts;
  for (const auto& sign : signs) {
    const double value = valueOf(sign.key);
    if (sign.whenZero ? value == 0.0 : value > 0.0) {
      texts.emplace_back(sign.words);
    }
  }
  for (const sim2d::NavigationOutcome end :
       {sim2d::NavigationOutcome::NavigationFailed, sim2d::NavigationOutcome::GoalMissed}) {
    if (base::startsWith(reason, sim2d::navigationOutcomeName(end))) {
      texts.push_back(reason);
    }
  }
  return texts.empty() ? "not successful" : base::join(texts, ", ");
}

ResultRow rowOf(const FinishedRun& run) {
  ResultRow row;
  row.ok = run.result.status == sim2d::RunStatus::Finished;
  row.reason = run.result.reason;
  row.simulated = base::formatDouble(static_cast<double>(run.result.steps) * run.header.dt);
  if (run.evaluation) {  // numbers as in metrics.json
    const Json json = Json::parse(metrics::toJson(*run.evaluation));
    addFields(json, "", row);
    const Json robots = json.value("robots", Json::object());
    for (const auto& [robot, of] : robots.items()) {
      addFields(of, robot + ".", row);
    }
  }
  addEnds(run, row);
  return row;
}

ResultRow rowOf(const base::Diagnostics& problems) {
  ResultRow row;
  const auto* const first =
      base::findBy(problems, &base::Diagnostic::severity, base::Severity::Error);
  row.reason = first != nullptr ? first->message : "the run could not start";
  return row;
}

std::string serializeRow(const ResultRow& row) {
  return base::jsonText(RowJson(row), -1);
}

std::optional<ResultRow> tryParseRow(const std::string& text) {
  try {
    return RowJson::parse(base::shallowJson(text)).get<ResultRow>();
  } catch (const RowJson::exception&) {
    return std::nullopt;
  }
}

ResultRow parseRow(const std::string& text) {
  std::optional<ResultRow> row = tryParseRow(text);
  if (!row) {
    row.emplace();
    row->reason = "the worker process returned no result";
  }
  return *std::move(row);
}

}  // namespace app
