#include "app/run/Bundle.h"
#include "app/window/files/FileCommands.h"
#include "app/window/start/StartCards.h"
#include "editor/document/Entity.h"
#include "editor/document/MapEdit.h"
#include "editor/look/Form.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace app {

namespace {

constexpr int kPauseMs = 400;

// Ids of notices; a new notice replaces the one with the same id.
const QLatin1String kChanged("changed");
const QLatin1String kGone("gone");
const QLatin1String kReadOnly("read-only");
const QLatin1String kElsewhere("open-elsewhere");
const QLatin1String kMap("map");
const QLatin1String kNotSaved("not-saved");
const QLatin1String kExport("export");
const QLatin1String kUnread("unread");

QString namesOf(const QStringList& files) {
  const QString first = QFileInfo(files.front()).fileName();
  return files.size() == 1 ? first : QObject::tr("%1 and %2 more").arg(first).arg(files.size() - 1);
}

/// The reason of the first error ("No space left on device"), with the file name if other files
/// could be written.
QString reasonOf(const base::Diagnostics& problems, const QString& saved) {
  const base::Diagnostics errors = errorsOf(problems);
  const QString file = QFileInfo(QString::fromStdString(errors.front().file)).fileName();
  const std::string why = errors.front().value("reason");
  const QString reason = QString::fromStdString(why.empty() ? errors.front().message : why);
  return errors.size() > 1 || file.isEmpty() || file == saved
             ? reason
             : QStringLiteral("%1: %2").arg(file, reason);
}

/// The text about a missing or invalid map.
QString mapProblemText(const editor::ScenarioDocument& document) {
  const sim2d::Scenario& scenario = document.scenario();
  const base::Diagnostic problem = errorsOf(document.mapState().problems).front();
  const QString file = QString::fromStdString(problem.file);
  if (!file.isEmpty() && file != document.path()) {
    return QObject::tr("Map file %1 cannot be used, so there are no walls: %2.")
        .arg(QFileInfo(file).fileName(), QString::fromStdString(problem.message));
  }
  const QString named = QString::fromStdString(
      scenario.desktop.mapFile.value_or(sim2d::mapBaseName(scenario.map.value_or(""))));
  if (named.isEmpty()) {
    return QObject::tr("The scenario specifies no map, so there are no walls.");
  }
  const bool isFile = scenario.desktop.mapFile.has_value();
  return QObject::tr("Map file %1 not found, so there are no walls.")
      .arg(isFile ? named : named + QStringLiteral(".yaml"));
}

}  // namespace

DocumentGuard::DocumentGuard(Workspace& workspace, FileCommands& files, NoticeBar& notices,
                             const QString& recoveryFolder, const QString& openFilesFolder,
                             QObject* parent)
    : QObject(parent),
      workspace_(workspace),
      document_(workspace.document()),
      files_(files),
      notices_(notices),
      recoveryFolder_(recoveryFolder),
      openFiles_(openFilesFolder, this) {
  connect(&openFiles_, &OpenFiles::changed, this, &DocumentGuard::reportOpenElsewhere);
  pause_.setSingleShot(true);
  pause_.setInterval(kPauseMs);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, &pause_, qOverload<>(&QTimer::start));
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, &pause_, qOverload<>(&QTimer::start));
  connect(&pause_, &QTimer::timeout, this, &DocumentGuard::checkFiles);
  connect(&document_, &editor::ScenarioDocument::pathChanged, this, [this] {
    isThere_ = true;
    watchFiles();
    openFiles_.setFile(document_.path());
    reportOpenElsewhere();
    for (const QLatin1String& id : {kChanged, kGone, kNotSaved, kUnread, kExport}) {
      notices_.drop(id);
    }
    reportReadOnly();
  });
  connect(&document_, &editor::ScenarioDocument::mapChanged, this, [this] {
    watchFiles();
    reportMapProblem();
  });
  connect(&files_, &FileCommands::notSaved, this, &DocumentGuard::reportNotSaved);
  connect(&files_, &FileCommands::exported, this, &DocumentGuard::reportExported);
  connect(&files_, &FileCommands::notExported, this, [this](const base::Diagnostics& problems) {
    notices_.warn(kExport, tr("Export failed: %1.").arg(reasonOf(problems, {})),
                  {{tr("Export…"), [this] { files_.askExport(); }}});
  });
  if (recoveryFolder.isEmpty()) {
    return;
  }
  autosave_ = std::make_unique<editor::Autosave>(document_, recoveryFolder);
  connect(autosave_.get(), &editor::Autosave::failed, this,
          [this](const base::Diagnostics& problems) {
            notices_.warn(QStringLiteral("autosave"),
                          tr("Cannot save a copy for crash recovery: %1")
                              .arg(QString::fromStdString(problems.front().text())));
          });
  connect(&files_, &FileCommands::opened, this, [this] {
    isStart_ = false;
    offerRecovery();
  });
  connect(&files_, &FileCommands::closed, this, [this] {
    isStart_ = true;
    offerRecovery();
  });
  offerRecovery();
}

/// Also watches folders: replacing a file by renaming creates a new file.
void DocumentGuard::watchFiles() {
  const QStringList before = watcher_.files() + watcher_.directories();
  if (!before.isEmpty()) {
    watcher_.removePaths(before);
  }
  QStringList paths;
  for (const QString& file : document_.files()) {
    for (const QString& path : {file, QFileInfo(file).absolutePath()}) {
      if (QFileInfo::exists(path) && !paths.contains(path)) {
        paths << path;
      }
    }
  }
  if (!paths.isEmpty()) {
    watcher_.addPaths(paths);
  }
}

void DocumentGuard::checkFiles() {
  const QStringList changed = document_.changedOnDisk();
  watchFiles();
  const bool isThere = !files_.isFileMissing();
  if (std::exchange(isThere_, isThere) != isThere) {
    reportRemoved();
    Q_EMIT scenarioFileChanged();
  }
  if (!changed.isEmpty()) {
    reportChanged(changed);
  }
}

/// Copies are offered on the start page, and with the file that they belong to. Other files are not
/// affected by them.
void DocumentGuard::offerRecovery() {
  if (recoveryFolder_.isEmpty()) {
    return;
  }
  for (const QString& folder : std::exchange(offered_, {})) {
    notices_.drop(folder);
  }
  for (const QString& folder : editor::Autosave::orphanedFolders(recoveryFolder_)) {
    offerCopy(folder);
  }
}

void DocumentGuard::offerCopy(const QString& folder) {
  const base::Result<editor::DocumentSnapshot> copy = editor::readSnapshot(folder);
  const Notice::Choice discard = {tr("Discard"), [folder] { QDir(folder).removeRecursively(); }};
  if (!isStart_ && (!copy || copy->path.isEmpty() || copy->path != document_.path())) {
    return;
  }
  offered_ << folder;
  if (!copy) {
    notices_.warn(folder,
                  tr("Unsaved changes of an earlier session cannot be read: %1")
                      .arg(QString::fromStdString(copy.diagnostics().front().text())),
                  {discard});
    return;
  }
  const QString name =
      copy->path.isEmpty() ? tr("an unnamed scenario") : QFileInfo(copy->path).fileName();
  const QString words =
      copy->isFromCrash
          ? tr("The program ended unexpectedly. Unsaved changes to %1 were kept (%2).")
          : tr("Unsaved changes to %1 were kept when the last session ended (%2).");
  notices_.inform(
      folder,
      words.arg(name, relativeTimeText(copy->when.toLocalTime(), QDateTime::currentDateTime())),
      {{tr("Restore"), [this, folder] { restore(folder); }}, discard});
}

void DocumentGuard::endSession() {
  if (autosave_) {
    autosave_->keepForNextSession();
  }
}

/// The copy of the crashed session is deleted only after this session has its own copy.
void DocumentGuard::restore(const QString& folder) {
  if (!files_.restore(folder)) {
    offerRecovery();
    return;
  }
  autosave_->writeNow();
  QDir(folder).removeRecursively();
  offerRecovery();
}

void DocumentGuard::reportChanged(const QStringList& changed) {
  notices_.warn(kChanged,
                (document_.isDirty()
                     ? tr("%1 was changed by another program. Reloading discards unsaved changes.")
                     : tr("%1 was changed by another program."))
                    .arg(namesOf(changed)),
                {{tr("Reload"), [this] { files_.reload(); }},
                 {tr("Keep mine"), [this] { document_.acceptDiskChanges(); }}});
}

void DocumentGuard::reportRemoved() {
  if (isThere_) {
    notices_.drop(kGone);
    return;
  }
  notices_.warn(kGone,
                tr("%1 was moved or deleted by another program. It is still open here.")
                    .arg(document_.displayName()),
                {{tr("Save again"), [this] { files_.save(); }},
                 {tr("Save as…"), [this] { files_.saveAs(); }}});
}

/// Both windows show the notice, and drop it when one of them closes the file.
void DocumentGuard::reportOpenElsewhere() {
  if (!openFiles_.isOpenElsewhere()) {
    notices_.drop(kElsewhere);
    return;
  }
  if (!notices_.has(kElsewhere)) {
    notices_.warn(kElsewhere,
                  tr("%1 is also open in another window. The window that saves last overwrites the "
                     "changes of the other.")
                      .arg(document_.displayName()),
                  {{tr("Save as…"), [this] { files_.saveAs(); }}});
  }
}

void DocumentGuard::reportReadOnly() {
  if (!document_.isReadOnly()) {
    notices_.drop(kReadOnly);
    return;
  }
  const auto saveAs = [this] {
    files_.saveAs();
    reportReadOnly();  // if the user cancelled
  };
  notices_.warn(kReadOnly,
                (editor::isBlank(document_.scenario())
                     ? tr("%1 is damaged and cannot be read. It will not be overwritten.")
                     : tr("%1 is damaged and only partly loaded. It will not be overwritten."))
                    .arg(document_.displayName()),
                {{tr("Save as…"), saveAs}});
}

/// Shown again if the user did not choose a map.
void DocumentGuard::reportMapProblem() {
  if (!document_.mapState().isMissing) {
    notices_.drop(kMap);
    return;
  }
  const auto choose = [this] {
    files_.askReplaceMap();
    reportMapProblem();
  };
  const auto clear = [this] {
    workspace_.runner().reset();
    editor::pushOpenPlane(document_);
  };
  notices_.warn(kMap, mapProblemText(document_),
                {{tr("Choose map…"), choose}, {tr("Use open plane"), clear}});
}

void DocumentGuard::reportExported(const QString& folder, int files) {
  const auto show = [this, folder] {
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder))) {
      notices_.warn(kExport, tr("Cannot open a file manager. The files are in %1.")
                                 .arg(QDir::toNativeSeparators(folder)));
    }
  };
  notices_.inform(
      kExport,
      tr("Exported %1 to %2.")
          .arg(editor::counted(static_cast<std::size_t>(files), tr("file"), tr("files")),
               QDir::toNativeSeparators(folder)),
      {{tr("Show folder"), show}});
}

void DocumentGuard::reportNotSaved(const QString& name, const base::Diagnostics& problems) {
  const auto saveAs = [this, name, problems] {
    if (!files_.saveAs() && !notices_.has(kNotSaved)) {
      reportNotSaved(name, problems);
    }
  };
  notices_.warn(
      kNotSaved,
      tr("%1 was not saved: %2. Your changes are not lost.").arg(name, reasonOf(problems, name)),
      {{tr("Save as…"), saveAs}});
}

void DocumentGuard::reportUnreadable(const base::Diagnostics& problems) {
  const base::Diagnostic problem = errorsOf(problems).front();
  const QString reason = QString::fromStdString(problem.message);
  notices_.warn(kUnread,
                problem.file.empty()
                    ? tr("The file cannot be opened: %1").arg(reason)
                    : tr("%1 cannot be opened: %2")
                          .arg(QFileInfo(QString::fromStdString(problem.file)).fileName(), reason));
}

}  // namespace app
