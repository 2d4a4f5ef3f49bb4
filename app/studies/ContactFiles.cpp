#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/run/ManifestFiles.h"
#include "app/studies/ContactReport.h"
#include "app/studies/PathJson.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"

// Reports on contacts as JSON and CSV.
namespace app {

namespace {

using ReportJson = nlohmann::ordered_json;
using Cause = sim2d::ContactMark::Cause;

constexpr std::pair<Cause, const char*> kCauses[] = {
    {Cause::Robot, "robot"}, {Cause::Person, "person"}, {Cause::Both, "both"}};

const char* causeName(Cause cause) {
  const auto* const found = std::find_if(std::begin(kCauses), std::end(kCauses),
                                         [cause](const auto& each) { return each.first == cause; });
  return found->second;
}

Cause contactCauseOf(const std::string& name) {
  const auto* const found = std::find_if(std::begin(kCauses), std::end(kCauses),
                                         [&name](const auto& each) { return name == each.second; });
  return found != std::end(kCauses) ? found->first : Cause::Both;
}

template <class T>
ReportJson optionalJson(const std::optional<T>& value) {
  return value ? ReportJson(*value) : ReportJson();
}

std::optional<double> optionalNumberOf(const ReportJson& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

ReportJson sideJson(const std::optional<double>& sight, const std::optional<AvoidingAction>& action,
                    bool couldAvoid) {
  ReportJson json;
  json["first_sight"] = optionalJson(sight);
  json["last_action"] = action ? ReportJson(action->time) : ReportJson();
  json["manoeuvre"] = action ? ReportJson(action->manoeuvre) : ReportJson();
  json["could_avoid"] = couldAvoid;
  if (action) {
    json["robot_path"] = pathJson<ReportJson>(action->robotPath);
    json["person_path"] = pathJson<ReportJson>(action->personPath);
  }
  return json;
}

std::optional<AvoidingAction> sideActionOf(const ReportJson& json) {
  if (json.at("last_action").is_null()) {
    return std::nullopt;
  }
  return AvoidingAction{json.at("last_action").get<double>(),
                        json.at("manoeuvre").get<std::string>(), pathOfJson(json.at("robot_path")),
                        pathOfJson(json.at("person_path"))};
}

ReportJson contactJson(const ReportedContact& reported, const ContactReport& report) {
  const AvoidableContact& contact = reported.contact;
  ReportJson json;
  json["time"] = contact.time;
  json["step"] = contact.step;
  json["robot"] = report.nameOf(contact.robot);
  json["robot_id"] = contact.robot;
  json["person"] = report.nameOf(contact.person);
  json["person_id"] = contact.person;
  json["position"] = {contact.position.x(), contact.position.y()};
  json["cause"] = causeName(contact.cause);
  json["could_avoid"] = whoCouldAvoid(contact);
  json["by_robot"] = sideJson(contact.robotSight, contact.robotAction, contact.couldRobotAvoid());
  json["by_robot"]["braking_at_first_sight_avoids"] = optionalJson(contact.brakingAvoids);
  json["by_person"] =
      sideJson(contact.personSight, contact.personAction, contact.couldPersonAvoid());
  json["without"] = ReportJson::array();
  for (const WithoutPerson& each : reported.withoutPeople) {
    json["without"].push_back({{"person", report.nameOf(each.person)},
                               {"id", each.person},
                               {"happens", each.happens},
                               {"problem", each.problem}});
  }
  json["trials"] = contact.trials;
  return json;
}

ReportedContact reportedContactOf(const ReportJson& json) {
  ReportedContact reported;
  AvoidableContact& contact = reported.contact;
  contact.time = json.at("time").get<double>();
  contact.step = json.at("step").get<std::int64_t>();
  contact.robot = json.at("robot_id").get<int>();
  contact.person = json.at("person_id").get<int>();
  contact.position = {json.at("position").at(0).get<double>(),
                      json.at("position").at(1).get<double>()};
  contact.cause = contactCauseOf(json.at("cause").get<std::string>());
  const ReportJson &robot = json.at("by_robot"), &person = json.at("by_person");
  contact.robotSight = optionalNumberOf(robot.at("first_sight"));
  contact.personSight = optionalNumberOf(person.at("first_sight"));
  contact.robotAction = sideActionOf(robot);
  contact.personAction = sideActionOf(person);
  const ReportJson& braking = robot.at("braking_at_first_sight_avoids");
  contact.brakingAvoids = braking.is_null() ? std::nullopt : std::optional(braking.get<bool>());
  contact.trials = json.at("trials").get<std::size_t>();
  for (const ReportJson& each : json.at("without")) {
    reported.withoutPeople.push_back({each.at("id").get<int>(), each.at("happens").get<bool>(),
                                      each.at("problem").get<std::string>()});
  }
  return reported;
}

struct EffectColumn {
  const char* name;
  double metrics::PersonEffect::*member;
};
constexpr EffectColumn kEffects[] = {{"detour", &metrics::PersonEffect::detour},
                                     {"delay", &metrics::PersonEffect::delay},
                                     {"extra_force", &metrics::PersonEffect::extraForce},
                                     {"slowed_time", &metrics::PersonEffect::slowedTime},
                                     {"heading_disturbance", &metrics::PersonEffect::disturbance}};

ReportJson effectJson(const metrics::PersonEffect& effect, const ContactReport& report) {
  ReportJson json = {{"person", report.nameOf(effect.id)}, {"id", effect.id}};
  for (const EffectColumn& column : kEffects) {
    json[column.name] = base::jsonNumber<ReportJson>(effect.*column.member);
  }
  return json;
}

metrics::PersonEffect personEffectOf(const ReportJson& json) {
  metrics::PersonEffect effect;
  effect.id = json.at("id").get<int>();
  for (const EffectColumn& column : kEffects) {
    effect.*column.member =
        optionalNumberOf(json.at(column.name)).value_or(std::numeric_limits<double>::quiet_NaN());
  }
  return effect;
}

ReportJson reportJson(const ContactReport& report) {
  ReportJson json;
  json["run"] = report.run;
  json["scenario"] = report.scenario;
  json["seed"] = report.seed;
  json["planners"] = report.planners;
  json["names"] = ReportJson::object();
  for (const auto& [id, name] : report.names) {
    json["names"][std::to_string(id)] = name;
  }
  json["contacts"] = ReportJson::array();
  for (const ReportedContact& each : report.contacts) {
    json["contacts"].push_back(contactJson(each, report));
  }
  json["people"] = ReportJson::array();
  for (const metrics::PersonEffect& each : report.effects) {
    json["people"].push_back(effectJson(each, report));
  }
  json["problem"] = report.problem;
  return json;
}

ContactReport reportOfJson(const ReportJson& json) {
  ContactReport report;
  report.run = json.at("run").get<std::string>();
  report.scenario = json.at("scenario").get<std::string>();
  report.seed = json.at("seed").get<long long>();
  report.planners = json.at("planners").get<std::string>();
  for (const auto& [id, name] : json.at("names").items()) {
    report.names[static_cast<int>(base::parseInt(id).value_or(0))] = name.get<std::string>();
  }
  for (const ReportJson& each : json.at("contacts")) {
    report.contacts.push_back(reportedContactOf(each));
  }
  for (const ReportJson& each : json.at("people")) {
    report.effects.push_back(personEffectOf(each));
  }
  report.problem = json.at("problem").get<std::string>();
  return report;
}

std::string fieldText(const std::string& text) {
  std::string field;
  sim2d::appendCsvField(field, text);
  return field;
}

std::string runFields(const ContactReport& report) {
  return fieldText(report.run) + "," + fieldText(report.scenario) + "," +
         std::to_string(report.seed) + "," + fieldText(report.planners);
}

std::string timeField(const std::optional<double>& time) {
  return time ? base::formatDouble(*time) : std::string();
}

const char* flagField(bool flag) {
  return flag ? "True" : "False";
}

std::string actionFields(const std::optional<double>& sight,
                         const std::optional<AvoidingAction>& action, bool couldAvoid) {
  return timeField(sight) + "," +
         (action ? base::formatDouble(action->time) + "," + fieldText(action->manoeuvre)
                 : std::string(",")) +
         "," + flagField(couldAvoid);
}

/// People without whom the contact does not happen.
std::string neededPeople(const ReportedContact& reported, const ContactReport& report) {
  std::string names;
  for (const WithoutPerson& each : reported.withoutPeople) {
    if (!each.happens) {
      names += (names.empty() ? "" : ";") + report.nameOf(each.person);
    }
  }
  return names;
}

}  // namespace

std::string contactReportText(const ContactReport& report) {
  return base::jsonText(reportJson(report), -1);
}

std::optional<ContactReport> contactReportOf(const std::string& text) {
  try {
    return reportOfJson(ReportJson::parse(base::shallowJson(text), nullptr, false));
  } catch (const ReportJson::exception&) {
    return std::nullopt;
  }
}

std::string contactReportsJson(const std::vector<ContactReport>& reports) {
  ReportJson all = ReportJson::array();
  for (const ContactReport& report : reports) {
    all.push_back(reportJson(report));
  }
  return base::jsonText(all) + "\n";
}

std::vector<ContactReport> readContactReports(const std::string& folder) {
  const base::Result<std::string> text =
      base::readTextFile(pathIn(folder, "contacts.json"), base::kMaxRecord);
  std::vector<ContactReport> reports;
  try {
    for (const ReportJson& each :
         ReportJson::parse(base::shallowJson(text ? *text : "[]"), nullptr, false)) {
      reports.push_back(reportOfJson(each));
    }
  } catch (const ReportJson::exception&) {
    reports.clear();
  }
  return reports;
}

std::string contactsCsv(const std::vector<ContactReport>& reports) {
  std::string text =
      "run,scenario,seed,planners,time,robot,person,x,y,cause,could_avoid,robot_first_sight,"
      "robot_last_action,robot_manoeuvre,robot_could_avoid,braking_avoids,person_first_sight,"
      "person_last_action,person_manoeuvre,person_could_avoid,needed_people\n";
  for (const ContactReport& report : reports) {
    for (const ReportedContact& reported : report.contacts) {
      const AvoidableContact& contact = reported.contact;
      text += runFields(report) + "," + base::formatDouble(contact.time) + "," +
              fieldText(report.nameOf(contact.robot)) + "," +
              fieldText(report.nameOf(contact.person)) + "," +
              base::formatDouble(contact.position.x()) + "," +
              base::formatDouble(contact.position.y()) + "," + causeName(contact.cause) + "," +
              whoCouldAvoid(contact) + "," +
              actionFields(contact.robotSight, contact.robotAction, contact.couldRobotAvoid()) +
              "," + (contact.brakingAvoids ? flagField(*contact.brakingAvoids) : "") + "," +
              actionFields(contact.personSight, contact.personAction, contact.couldPersonAvoid()) +
              "," + fieldText(neededPeople(reported, report)) + "\n";
    }
  }
  return text;
}

std::string peopleCsv(const std::vector<ContactReport>& reports) {
  std::string text = "run,scenario,seed,planners,person,id";
  for (const EffectColumn& column : kEffects) {
    text += std::string(",") + column.name;
  }
  text += "\n";
  for (const ContactReport& report : reports) {
    for (const metrics::PersonEffect& effect : report.effects) {
      text += runFields(report) + "," + fieldText(report.nameOf(effect.id)) + "," +
              std::to_string(effect.id);
      for (const EffectColumn& column : kEffects) {
        const double value = effect.*column.member;
        text += std::isnan(value) ? "," : "," + base::formatDouble(value);
      }
      text += "\n";
    }
  }
  return text;
}

std::vector<PlannerCost> plannerCosts(const std::vector<ContactReport>& reports) {
  std::map<std::string, PlannerCost> costs;
  std::map<std::string, std::size_t> delays;  // people with a known delay
  for (const ContactReport& report : reports) {
    PlannerCost& cost = costs[report.planners];
    cost.planners = report.planners;
    ++cost.runs;
    for (const ReportedContact& each : report.contacts) {
      const bool robot = each.contact.couldRobotAvoid(), person = each.contact.couldPersonAvoid();
      ++cost.contacts;
      cost.robotCould += robot ? 1 : 0;
      cost.personCould += person ? 1 : 0;
      cost.neitherCould += robot || person ? 0 : 1;
    }
    cost.people += report.effects.size();
    for (const metrics::PersonEffect& effect : report.effects) {
      cost.meanDetour += effect.detour;
      cost.meanSlowed += effect.slowedTime;
      if (!std::isnan(effect.delay)) {
        cost.meanDelay += effect.delay;
        ++delays[report.planners];
      }
    }
  }
  std::vector<PlannerCost> all;
  for (auto& [planners, cost] : costs) {
    const double people = static_cast<double>(std::max<std::size_t>(1, cost.people));
    cost.meanDetour /= people;
    cost.meanSlowed /= people;
    cost.meanDelay /= static_cast<double>(std::max<std::size_t>(1, delays[planners]));
    all.push_back(std::move(cost));
  }
  return all;
}

std::string plannersCsv(const std::vector<PlannerCost>& costs) {
  std::string text =
      "planners,runs,people,contacts,robot_could_avoid,person_could_avoid,unavoidable,mean_delay,"
      "mean_detour,mean_slowed_time\n";
  for (const PlannerCost& cost : costs) {
    text += fieldText(cost.planners);
    for (const std::size_t count : {cost.runs, cost.people, cost.contacts, cost.robotCould,
                                    cost.personCould, cost.neitherCould}) {
      text += "," + std::to_string(count);
    }
    for (const double mean : {cost.meanDelay, cost.meanDetour, cost.meanSlowed}) {
      text += "," + base::formatDouble(mean);
    }
    text += "\n";
  }
  return text;
}

}  // namespace app
