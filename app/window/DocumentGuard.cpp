#include "app/window/DocumentGuard.h"

#include <QFileInfo>

#include "app/window/StartCards.h"

namespace app {

namespace {

QString changedId() {
  return QStringLiteral("changed");
}
QString readOnlyId() {
  return QStringLiteral("read-only");
}

QString namesOf(const QStringList& files) {
  const QString first = QFileInfo(files.front()).fileName();
  return files.size() == 1 ? first : QObject::tr("%1 and %2 more").arg(first).arg(files.size() - 1);
}

}  // namespace

DocumentGuard::DocumentGuard(Workspace& workspace, FileCommands& files, NoticeBar& notices,
                             const QString& recoveryFolder, QObject* parent)
    : QObject(parent),
      document_(workspace.document()),
      files_(files),
      notices_(notices),
      recoveryFolder_(recoveryFolder),
      watch_(workspace.document()) {
  connect(&watch_, &FileWatch::changedOnDisk, this, &DocumentGuard::tellChanged);
  connect(&document_, &editor::ScenarioDocument::pathChanged, this, [this] {
    notices_.drop(changedId());
    tellReadOnly();
  });
  if (recoveryFolder.isEmpty()) {
    return;
  }
  autosave_ = std::make_unique<editor::Autosave>(document_, recoveryFolder);
  connect(autosave_.get(), &editor::Autosave::failed, this,
          [this](const base::Diagnostics& problems) {
            notices_.tell({QStringLiteral("autosave"),
                           true,
                           tr("No copy for a crash can be kept: %1")
                               .arg(QString::fromStdString(problems.front().text())),
                           {}});
          });
  offerRecovery();
}

void DocumentGuard::offerRecovery() {
  for (const QString& folder : editor::Autosave::leftBehind(recoveryFolder_)) {
    const base::Result<editor::DocumentSnapshot> copy = editor::readSnapshot(folder);
    if (!copy) {
      notices_.tell({folder,
                     true,
                     tr("Unsaved work of an earlier session cannot be read: %1")
                         .arg(QString::fromStdString(copy.diagnostics().front().text())),
                     {{tr("Discard"), [folder] { editor::Autosave::discard(folder); }}}});
      continue;
    }
    const QString name =
        copy->path.isEmpty() ? tr("an unnamed scenario") : QFileInfo(copy->path).fileName();
    notices_.tell({folder,
                   false,
                   tr("The program ended unexpectedly. Unsaved changes to %1 were kept (%2).")
                       .arg(name, agoText(copy->when.toLocalTime(), QDateTime::currentDateTime())),
                   {{tr("Restore"), [this, folder] { restore(folder); }},
                    {tr("Discard"), [folder] { editor::Autosave::discard(folder); }}}});
  }
}

/// The copy of the dead program goes only when there is one of this program.
void DocumentGuard::restore(const QString& folder) {
  if (!files_.restore(folder)) {
    offerRecovery();
    return;
  }
  autosave_->writeNow();
  editor::Autosave::discard(folder);
}

void DocumentGuard::tellChanged(const QStringList& changed) {
  const QString names = namesOf(changed);
  notices_.tell({changedId(),
                 true,
                 document_.isDirty()
                     ? tr("%1 was changed by another program. Reloading loses what is not saved "
                          "here.")
                           .arg(names)
                     : tr("%1 was changed by another program.").arg(names),
                 {{tr("Reload"), [this] { files_.reload(); }},
                  {tr("Keep mine"), [this] { document_.acceptDisk(); }}}});
}

void DocumentGuard::tellReadOnly() {
  if (!document_.isReadOnly()) {
    notices_.drop(readOnlyId());
    return;
  }
  notices_.tell(
      {readOnlyId(),
       true,
       tr("%1 is damaged and shown as far as it could be read. It will not be overwritten.")
           .arg(document_.displayName()),
       {{tr("Save as…"), [this] { files_.saveAs(); }}}});
}

}  // namespace app
