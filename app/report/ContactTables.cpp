#include "app/report/ContactTables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "sim2d/base/Text.h"

namespace report {

namespace {

using app::AvoidableContact;
using app::AvoidingAction;
using app::ContactReport;
using app::ReportedContact;
using Cell = Table::Cell;

constexpr std::size_t kMostContactRows = 200;  // of a table on the page

Cell timeCell(const std::optional<double>& time) {
  return time ? numberCell(numberText(*time, 2), *time) : Cell{"–"};
}

/// The time of an action with its manoeuvre below.
Cell actionCell(const std::optional<AvoidingAction>& action, bool couldAvoid) {
  if (!action) {
    return Cell{"–"};
  }
  Cell cell = timeCell(action->time);
  cell.below = action->manoeuvre;
  cell.note = couldAvoid ? "" : "before first sight";
  return cell;
}

std::string neededPeopleText(const ReportedContact& reported, const ContactReport& report) {
  std::vector<std::string> names;
  for (const app::WithoutPerson& each : reported.withoutPeople) {
    if (!each.happens) {
      names.push_back(report.nameOf(each.person));
    }
  }
  return names.empty() ? std::string("–") : base::join(names, ", ");
}

/// The command that shows the run of a report, if it is in the results.
std::optional<std::string> playCommandOf(const Study& study, const ContactReport& report) {
  for (std::size_t run = 0; run < study.runCount(); ++run) {
    if (std::to_string(study.results.runs[run].number) == report.run) {
      return study.replayCommand(run);
    }
  }
  return std::nullopt;
}

std::vector<Cell> contactRow(const Study& study, const ContactReport& report,
                             const ReportedContact& reported) {
  const AvoidableContact& contact = reported.contact;
  const std::optional<std::string> command = playCommandOf(study, report);
  const char* const braking = !contact.brakingAvoids   ? "–"
                              : *contact.brakingAvoids ? "avoids it"
                                                       : "does not";
  return {{report.run},
          {report.scenario},
          {std::to_string(report.seed)},
          {report.planners},
          timeCell(contact.time),
          {report.nameOf(contact.robot)},
          {report.nameOf(contact.person)},
          {whoCouldAvoid(contact)},
          actionCell(contact.robotAction, contact.couldRobotAvoid()),
          timeCell(contact.robotSight),
          {braking},
          actionCell(contact.personAction, contact.couldPersonAvoid()),
          {neededPeopleText(reported, report)},
          command ? commandCell(*command) : Cell{"–"}};
}

/// Adds a table of which the page shows only the first rows if there are too many.
void addLongTable(const Table& table, const std::string& htmlClass, PageParts& parts) {
  Table shown = table;
  if (table.rows.size() > kMostContactRows) {
    shown.rows.resize(kMostContactRows);
    shown.caption += " The first " + std::to_string(kMostContactRows) + " of " +
                     std::to_string(table.rows.size()) + "; tables/" + table.name +
                     ".csv contains all.";
  }
  parts.add(shown, table, htmlClass);
}

/// Means over runs of what the robots cost a person.
struct PersonCost {
  std::size_t runs = 0, contacts = 0, delays = 0;  // delays: runs with a known delay
  double delay = 0.0, detour = 0.0, slowed = 0.0;

  double meanDelay() const {
    return delays > 0 ? delay / static_cast<double>(delays)
                      : std::numeric_limits<double>::quiet_NaN();
  }
  double meanDetour() const { return detour / static_cast<double>(runs); }
  double meanSlowed() const { return slowed / static_cast<double>(runs); }
};
using PersonKey = std::tuple<std::string, std::string, std::string>;  // planners, scenario, person

std::map<PersonKey, PersonCost> personCosts(const std::vector<ContactReport>& reports) {
  std::map<PersonKey, PersonCost> costs;
  for (const ContactReport& report : reports) {
    for (const metrics::PersonEffect& effect : report.effects) {
      PersonCost& cost = costs[{report.planners, report.scenario, report.nameOf(effect.id)}];
      ++cost.runs;
      cost.contacts += static_cast<std::size_t>(std::count_if(
          report.contacts.begin(), report.contacts.end(),
          [&](const ReportedContact& each) { return each.contact.person == effect.id; }));
      cost.detour += effect.detour;
      cost.slowed += effect.slowedTime;
      if (!std::isnan(effect.delay)) {
        cost.delay += effect.delay;
        ++cost.delays;
      }
    }
  }
  return costs;
}

Cell meanCell(double value) {
  return numberCell(signedNumberText(value, 2), value);
}

}  // namespace

Table contactsTable(const Study& study) {
  Table table;
  table.name = "contacts";
  table.caption =
      "Contacts of robots with people. Could avoid: who had an action within the limits of its "
      "body that would have avoided the contact, at or after the first sight of the other. Until: "
      "the last instant of such an action. Needed: people without whom the contact does not "
      "happen.";
  table.columns = {{"Run", {}, true},
                   {"Scenario", {}, false},
                   {"Seed", {}, true},
                   {"Planner", {}, false},
                   {"Time", "s", true},
                   {"Robot", {}, false},
                   {"Person", {}, false},
                   {"Could avoid", {}, false},
                   {"Robot until", "s", true},
                   {"First sight", "s", true},
                   {"Braking at first sight", {}, false},
                   {"Person until", "s", true},
                   {"Needed", {}, false},
                   {"Play", {}, false}};
  for (const ContactReport& report : *study.contacts) {
    for (const ReportedContact& reported : report.contacts) {
      table.rows.push_back(contactRow(study, report, reported));
    }
  }
  return table;
}

std::optional<Table> contactPeopleTable(const Study& study) {
  const std::map<PersonKey, PersonCost> costs = personCosts(*study.contacts);
  if (costs.empty()) {
    return std::nullopt;
  }
  std::vector<std::pair<PersonKey, PersonCost>> rows(costs.begin(), costs.end());
  const auto rank = [](const PersonCost& cost) {
    return std::isnan(cost.meanDelay()) ? -std::numeric_limits<double>::infinity()
                                        : cost.meanDelay();
  };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const auto& a, const auto& b) { return rank(a.second) > rank(b.second); });
  Table table;
  table.name = "contact_people";
  table.caption =
      "What the robots cost each person, as means over runs: the same run without robots is the "
      "reference. Slowed: time in which the person was slower by more than 0.1 m/s. Contacts are "
      "counted over all these runs.";
  table.columns = {{"Planner", {}, false}, {"Scenario", {}, false}, {"Person", {}, false},
                   {"Runs", {}, true},     {"Contacts", {}, true},  {"Delay", "s", true},
                   {"Detour", "m", true},  {"Slowed", "s", true}};
  for (const auto& [key, cost] : rows) {
    const auto& [planners, scenario, person] = key;
    table.rows.push_back({{planners},
                          {scenario},
                          {person},
                          {std::to_string(cost.runs)},
                          {std::to_string(cost.contacts)},
                          meanCell(cost.meanDelay()),
                          meanCell(cost.meanDetour()),
                          meanCell(cost.meanSlowed())});
  }
  return table;
}

std::optional<Table> contactPlannersTable(const Study& study) {
  const std::vector<app::PlannerCost> costs = app::plannerCosts(*study.contacts);
  if (costs.empty()) {
    return std::nullopt;
  }
  Table table;
  table.name = "contact_planners";
  table.caption =
      "Contacts by who could have avoided them, and mean costs per person, of each planner.";
  table.columns = {{"Planner", {}, false},
                   {"Runs", {}, true},
                   {"Contacts", {}, true},
                   {"Robot could avoid", {}, true},
                   {"Person could avoid", {}, true},
                   {"Unavoidable", {}, true},
                   {"Delay", "s", true},
                   {"Detour", "m", true},
                   {"Slowed", "s", true}};
  for (const app::PlannerCost& cost : costs) {
    std::vector<Cell> row = {{cost.planners}};
    for (const std::size_t count :
         {cost.runs, cost.contacts, cost.robotCould, cost.personCould, cost.neitherCould}) {
      row.push_back({std::to_string(count)});
    }
    for (const double mean : {cost.meanDelay, cost.meanDetour, cost.meanSlowed}) {
      row.push_back(cost.people > 0 ? meanCell(mean) : Cell{"–"});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

void addContactsSection(const Study& study, PageParts& parts) {
  if (!study.contacts) {
    return;
  }
  parts.section("contacts", "Contacts");
  const Table contacts = contactsTable(study);
  if (contacts.rows.empty()) {
    parts.body += paragraph("No run has a contact of a robot with a person.");
  } else {
    addLongTable(contacts, "failures", parts);
  }
  parts.add(contactPlannersTable(study));
  if (const std::optional<Table> people = contactPeopleTable(study)) {
    addLongTable(*people, {}, parts);
  }
  parts.report.moreTables.emplace_back("contact_people_runs", app::peopleCsv(*study.contacts));
  for (const ContactReport& report : *study.contacts) {
    if (!report.problem.empty()) {
      parts.body +=
          paragraph("Run " + report.run + " is not analysed completely: " + report.problem,
                    " class=\"warning\"");
    }
  }
}

}  // namespace report
