#pragma once

#include <optional>

#include "app/report/PageParts.h"
#include "app/report/Study.h"

namespace report {

/// The contacts of a study, a row each: last avoidable actions, who could have avoided it, without
/// whom it does not happen, and the command that shows the run.
Table contactsTable(const Study& study);
/// What the robots cost each person, as means over the runs with the same planners and scenario,
/// the highest delay first. Nothing: not compared with runs without robots.
std::optional<Table> contactPeopleTable(const Study& study);
/// Contacts and costs per planner. Nothing: no run was analysed.
std::optional<Table> contactPlannersTable(const Study& study);

/// Adds the section with these tables, of which the page shows at most 200 rows each, and all rows
/// to the tables of the report. Nothing if the contacts were not analysed (Study::contacts).
void addContactsSection(const Study& study, PageParts& parts);

}  // namespace report
