#pragma once

#include <QString>

namespace app {

class Workspace;

/// Marks last avoidable actions on the timeline of the displayed recorded run: those in the file
/// contacts.json of its folder (`hunavsim contacts RUN -o RUN`) whose contacts are in the
/// recording.
void showContactNotes(const QString& folder, Workspace& workspace);

}  // namespace app
