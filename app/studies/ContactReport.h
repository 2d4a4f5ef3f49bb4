#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/studies/AvoidableContact.h"
#include "metrics/RunResults.h"

/// All that is known about the contacts of a run: last avoidable actions, the same run without each
/// person nearby, and the effect of the robots on people.
namespace app {

struct ContactReportOptions {
  AvoidanceOptions avoidance;
  /// People within this distance of robot or person of a contact, during `influenceTime` before it,
  /// are removed one by one in a repetition of the run [m]; 0: none.
  double influenceRange = 5.0;
  double influenceTime = 10.0;  // [s]
  bool compareWithoutRobots = true;
  int jobs = 1;  // repetitions at a time
};

/// A contact in the same run without one other person.
struct WithoutPerson {
  int person = 0;
  bool happens = true;  // the pair touches until `settle` after the time of the contact
  std::string problem;  // why the run could not be simulated; empty: it was
};

struct ReportedContact {
  AvoidableContact contact;
  std::vector<WithoutPerson> withoutPeople;  // by id
};

struct ContactReport {
  std::string run;  // folder, or number in a batch
  std::string scenario;
  long long seed = 1;
  std::string planners;              // of the robots, separated by "+"
  std::map<int, std::string> names;  // of robots and people
  std::vector<ReportedContact> contacts;
  std::vector<metrics::PersonEffect> effects;  // of the robots on people; empty without robots
  std::string problem;  // why there is no result, or the run without robots is missing

  std::string nameOf(int id) const;
};

/// Analyses a run. Errors and threads: as avoidableContacts(). When `wantsStop` returns true, the
/// report has the contacts finished so far.
base::Result<ContactReport> reportContacts(
    const RepeatableRun& run, const ContactReportOptions& options,
    const std::function<bool()>& wantsStop,
    const std::function<void(const std::string& what)>& showProgress = {});

/// One line of JSON; reading gives equal values.
std::string contactReportText(const ContactReport& report);
std::optional<ContactReport> contactReportOf(const std::string& text);

/// The reports as a JSON array, for users.
std::string contactReportsJson(const std::vector<ContactReport>& reports);
/// Those of the file contacts.json in a folder; none if it is missing or damaged.
std::vector<ContactReport> readContactReports(const std::string& folder);
/// A row per contact: FORMAT.md.
std::string contactsCsv(const std::vector<ContactReport>& reports);
/// A row per person and run: the columns of counterfactual.csv after run, scenario, seed, planners
/// and person.
std::string peopleCsv(const std::vector<ContactReport>& reports);

/// The effect on people of the robots of one planner, or of several together, in all runs with
/// them.
struct PlannerCost {
  std::string planners;
  std::size_t runs = 0, people = 0;  // people: of all runs together
  std::size_t contacts = 0, robotCould = 0, personCould = 0, neitherCould = 0;
  double meanDelay = 0.0, meanDetour = 0.0, meanSlowed = 0.0;  // per person [s], [m], [s]
};
/// By name of the planners.
std::vector<PlannerCost> plannerCosts(const std::vector<ContactReport>& reports);
/// The same as CSV.
std::string plannersCsv(const std::vector<PlannerCost>& costs);

}  // namespace app
