#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/PictureFiles.h"
#include "app/cli/RunProgress.h"
#include "app/report/AvoidanceFigure.h"
#include "app/run/Batch.h"
#include "app/run/ManifestFiles.h"
#include "app/run/OutputFolder.h"
#include "app/run/ResultStore.h"
#include "app/studies/BatchContacts.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

struct ContactsOptions {
  std::string source, output;
  ContactReportOptions report;
  bool quick = false, force = false;
};

base::Diagnostics checkContactsOptions(const ContactsOptions& options) {
  base::Diagnostics wrong;
  const auto checkRange = [&wrong](const char* option, double value, double low, double high) {
    if (!(value >= low && value <= high)) {
      wrong.push_back(base::error("contacts.range", {option, low, high, value}));
    }
  };
  checkRange("--lookback", options.report.avoidance.lookback, 0.1, 60.0);
  checkRange("--settle", options.report.avoidance.settle, 0.1, 60.0);
  checkRange("--range", options.report.influenceRange, 0.0, 1000.0);
  return wrong;
}

bool isBatchFolder(const std::string& source) {
  return ResultStore::isResultDatabase(pathIn(source, "results.sqlite"));
}

/// Rounded to these decimals.
std::string roundedText(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return base::formatDecimals(std::round(value * scale) / scale, decimals);
}

std::string seconds(double time) {
  return roundedText(time, 2) + " s";
}

/// "3.95 s: brake" or "-".
std::string actionCell(const std::optional<AvoidingAction>& action, bool couldAvoid) {
  if (!action) {
    return "-";
  }
  return seconds(action->time) + ": " + action->manoeuvre + (couldAvoid ? "" : " (out of sight)");
}

/// Names of the people without whom the contact does not happen.
std::string neededCell(const ReportedContact& reported, const ContactReport& report) {
  std::string names;
  for (const WithoutPerson& each : reported.withoutPeople) {
    if (!each.happens) {
      names += (names.empty() ? "" : ", ") + report.nameOf(each.person);
    }
  }
  return names.empty() ? "-" : names;
}

void printContacts(const std::vector<ContactReport>& reports, bool isBatch) {
  std::vector<std::vector<std::string>> rows = {{"contact", "time", "robot", "person",
                                                 "could avoid", "robot until", "seen", "braking",
                                                 "person until", "needed"}};
  if (isBatch) {
    rows.front().front() = "run";
  }
  for (const ContactReport& report : reports) {
    for (std::size_t k = 0; k < report.contacts.size(); ++k) {
      const ReportedContact& reported = report.contacts[k];
      const AvoidableContact& contact = reported.contact;
      rows.push_back({isBatch ? report.run : std::to_string(k + 1), seconds(contact.time),
                      report.nameOf(contact.robot), report.nameOf(contact.person),
                      whoCouldAvoid(contact),
                      actionCell(contact.robotAction, contact.couldRobotAvoid()),
                      contact.robotSight ? seconds(*contact.robotSight) : "-",
                      !contact.brakingAvoids   ? "-"
                      : *contact.brakingAvoids ? "avoids"
                                               : "contact",
                      actionCell(contact.personAction, contact.couldPersonAvoid()),
                      neededCell(reported, report)});
    }
  }
  if (rows.size() > 1) {
    printTable(rows);
  } else {
    printLine("no contact of a robot with a person");
  }
}

std::string signedText(double value, int decimals, const char* unit) {
  return std::isnan(value) ? "-" : roundedText(value, decimals) + " " + unit;
}

/// What the robots did to each person of a run.
void printPeople(const ContactReport& report) {
  if (report.effects.empty()) {
    return;
  }
  std::vector<std::vector<std::string>> rows = {{"person", "delay", "detour", "slowed"}};
  for (const metrics::PersonEffect& effect : report.effects) {
    rows.push_back({report.nameOf(effect.id), signedText(effect.delay, 1, "s"),
                    signedText(effect.detour, 2, "m"), signedText(effect.slowedTime, 1, "s")});
  }
  printLine("");
  printTable(rows);
}

void printPlanners(const std::vector<ContactReport>& reports) {
  std::vector<std::vector<std::string>> rows = {{"planner", "runs", "contacts", "robot could avoid",
                                                 "person could avoid", "unavoidable",
                                                 "delay per person", "detour per person"}};
  for (const PlannerCost& cost : plannerCosts(reports)) {
    rows.push_back({cost.planners, std::to_string(cost.runs), std::to_string(cost.contacts),
                    std::to_string(cost.robotCould), std::to_string(cost.personCould),
                    std::to_string(cost.neitherCould), signedText(cost.meanDelay, 2, "s"),
                    signedText(cost.meanDetour, 2, "m")});
  }
  printLine("");
  printTable(rows);
}

/// The report of a run, and one picture per contact for its output.
std::vector<ContactReport> contactsOfRun(const ContactsOptions& options, bool quiet,
                                         std::vector<base::FileContent>& pictures) {
  const base::Result<RepeatableRun> run = repeatableRunOf(options.source, loadMapImage);
  requireFine(run.diagnostics());
  catchInterrupts();
  Progress progress(quiet);
  base::Result<ContactReport> report =
      reportContacts(*run, options.report, wasInterrupted,
                     [&progress](const std::string& what) { progress.show(what); });
  progress.clear();
  requireFine(report.diagnostics());
  report->run = options.source;
  if (!options.output.empty() && !report->contacts.empty()) {
    const sim2d::Trace trace = run->recording->trace();
    const report::FloorPlan floorPlan = report::floorPlanOf(trace);
    for (std::size_t k = 0; k < report->contacts.size(); ++k) {
      const std::string name = "contact_" + std::to_string(k + 1);
      pictures.push_back(
          {"figures/" + name + ".svg",
           report::avoidanceFigure(name, trace, floorPlan, report->contacts[k].contact)
               .standalone()});
    }
  }
  return {*std::move(report)};
}

std::vector<ContactReport> contactsOfBatch(const ContactsOptions& options, bool quiet) {
  catchInterrupts();
  RunProgress progress(quiet, 0, false);
  base::Result<std::vector<ContactReport>> reports =
      reportBatchContacts(options.source, options.report, loadMapImage, wasInterrupted,
                          [&progress](std::size_t done, std::size_t all) {
                            progress.setTotal(all);
                            progress.show(done, done);
                          });
  progress.clear();
  requireFine(reports.diagnostics());
  return *std::move(reports);
}

void writeContacts(const ContactsOptions& options, const std::vector<ContactReport>& reports,
                   const std::vector<base::FileContent>& pictures) {
  std::vector<base::FileContent> files = {
      {"contacts.json", contactReportsJson(reports)},
      {"contacts.csv", contactsCsv(reports)},
      {"contact_people.csv", peopleCsv(reports)},
      {"contact_planners.csv", plannersCsv(plannerCosts(reports))}};
  files.insert(files.end(), pictures.begin(), pictures.end());
  std::vector<std::string> dropped;  // of an earlier analysis with more contacts
  if (const base::Result<Manifest> manifest = readManifest(options.output, Manifest::kHiddenName)) {
    for (const auto& [name, hash] : manifest->outputs) {
      if (base::startsWith(name, "figures/contact_")) {
        dropped.push_back(name);
      }
    }
  }
  requireFine(writeIntoForeignFolder(options.output, files, "contacts", options.force, dropped));
}

int contactsCommand(const ContactsOptions& given, const Invocation& invocation) {
  requireFine(checkContactsOptions(given), ExitWrongCommandLine);
  ContactsOptions options = given;
  if (options.quick) {
    options.report.influenceRange = 0.0;
    options.report.compareWithoutRobots = false;
  }
  const bool isBatch = isBatchFolder(options.source);
  std::vector<base::FileContent> pictures;
  const bool quiet = invocation.quiet || invocation.json;
  const std::vector<ContactReport> reports =
      isBatch ? contactsOfBatch(options, quiet) : contactsOfRun(options, quiet, pictures);
  if (!options.output.empty()) {
    writeContacts(options, reports, pictures);
  }
  if (invocation.json) {
    print(contactReportsJson(reports));
  } else if (!invocation.quiet) {
    printContacts(reports, isBatch);
    if (isBatch) {
      printPlanners(reports);
    } else {
      printPeople(reports.front());
    }
  }
  base::Diagnostics troubles;
  for (const ContactReport& report : reports) {
    if (!report.problem.empty()) {
      troubles.push_back(base::warning("contacts.run-failed", {report.run, report.problem}));
    }
  }
  printDiagnostics(troubles);
  if (wasInterrupted()) {
    printError("interrupted: the contacts analysed so far are reported");
  }
  return wasInterrupted() ? ExitRunFailed : ExitFine;
}

}  // namespace

void addContacts(CommandRegistry& commands) {
  const auto added = commands.add(
      "contacts", "Find the last action that would have avoided each contact of a run or batch",
      contactsCommand);
  CLI::App& command = added.first;
  ContactsOptions& options = added.second;
  options.report.jobs = processorCount();
  command.add_option("source", options.source, "Folder of a recorded run or of a batch")
      ->required();
  addOutputFolder(command, options.output,
                  "Folder for contacts.json, contacts.csv, contact_people.csv, "
                  "contact_planners.csv and a picture of each contact of a run (default: write no "
                  "files); may be the folder of the run or batch");
  addForce(command, options.force);
  command.add_option("--lookback", options.report.avoidance.lookback,
                     "Longest time before a contact at which actions are tried [s] (default: 10)");
  command.add_option(
      "--settle", options.report.avoidance.settle,
      "Time after a contact during which an action must still avoid it [s] (default: 2)");
  command.add_option("--range", options.report.influenceRange,
                     "Repeat the run without each person within this distance of a contact during "
                     "the 10 s before it [m] (default: 5; 0: none)");
  command.add_flag("--quick", options.quick,
                   "Find only last avoidable actions; do not repeat runs without people or robots");
  addJobs(command, options.report.jobs);
  commands.addExamples(
      command, {{"hunavsim contacts out --quick",
                 "Show when and by whom each contact of a run could last have been avoided"},
                {"hunavsim contacts out -o contacts",
                 "Also write the tables and a picture of each contact"}});
}

}  // namespace app
