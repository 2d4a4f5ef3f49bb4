#include "app/window/ContactNotes.h"

#include <algorithm>
#include <utility>

#include "app/studies/ContactList.h"
#include "app/studies/ContactReport.h"
#include "app/window/Workspace.h"

namespace app {

namespace {

using Notes = std::vector<editor::RunNote>;

/// Whether the recording has this contact; otherwise it is of an earlier run in the folder.
bool isRecorded(const AvoidableContact& contact, const std::vector<AvoidableContact>& recorded) {
  return std::any_of(recorded.begin(), recorded.end(), [&](const AvoidableContact& each) {
    return each.step == contact.step && each.robot == contact.robot &&
           each.person == contact.person;
  });
}

void addNote(const std::optional<AvoidingAction>& action, const std::string& who,
             const std::string& other, double contactTime, Notes& notes) {
  if (action) {
    notes.push_back(
        {action->time,
         QCoreApplication::translate("app::ContactNotes",
                                     "Until here %1 could avoid the contact with %2 at %3 s: %4")
             .arg(QString::fromStdString(who), QString::fromStdString(other),
                  QString::number(contactTime, 'f', 2),
                  QString::fromStdString(action->manoeuvre))});
  }
}

}  // namespace

void showContactNotes(const QString& folder, Workspace& workspace) {
  const editor::RecordingPtr recording = workspace.runner().recording();
  Notes notes;
  const std::vector<AvoidableContact> recorded =
      recording != nullptr ? contactsIn(*recording) : std::vector<AvoidableContact>();
  for (const ContactReport& report : readContactReports(folder.toStdString())) {
    for (const ReportedContact& each : report.contacts) {
      const AvoidableContact& contact = each.contact;
      if (isRecorded(contact, recorded)) {
        const std::string robot = report.nameOf(contact.robot);
        const std::string person = report.nameOf(contact.person);
        addNote(contact.robotAction, robot, person, contact.time, notes);
        addNote(contact.personAction, person, robot, contact.time, notes);
      }
    }
  }
  workspace.events().setNotes(std::move(notes));
}

}  // namespace app
