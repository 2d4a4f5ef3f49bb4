#include "app/window/DocumentGuard.h"

#include <utility>

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QUrl>

#include "app/run/Bundle.h"
#include "app/window/StartPage.h"
#include "editor/document/EntityLists.h"
#include "editor/document/MapEdit.h"
#include "editor/look/Form.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace app {

namespace {

constexpr int kPauseMs = 400;

// Notices of these take each other's place.
const QLatin1String kChanged("changed");
const QLatin1String kGone("gone");
const QLatin1String kReadOnly("read-only");
const QLatin1String kMap("map");
const QLatin1String kNotSaved("not-saved");
const QLatin1String kExport("export");
const QLatin1String kUnread("unread");

QString namesOf(const QStringList& files) {
  const QString first = QFileInfo(files.front()).fileName();
  return files.size() == 1 ? first : QObject::tr("%1 and %2 more").arg(first).arg(files.size() - 1);
}

/// "No space left on device", with the file when it is one among others that could be written.
QString reasonOf(const base::Diagnostics& problems, const QString& saved) {
  const base::Diagnostics errors = errorsOf(problems);
  const QString file = QFileInfo(QString::fromStdString(errors.front().file)).fileName();
  const std::string why = errors.front().value("reason");
  const QString reason = QString::fromStdString(why.empty() ? errors.front().message : why);
  return errors.size() > 1 || file.isEmpty() || file == saved
             ? reason
             : QStringLiteral("%1: %2").arg(file, reason);
}

/// Which map is not there, or what is wrong with it.
QString mapWords(const editor::ScenarioDocument& document) {
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
    return QObject::tr("The scenario names no map, so there are no walls.");
  }
  const bool isFile = scenario.desktop.mapFile.has_value();
  return QObject::tr("Map file %1 not found, so there are no walls.")
      .arg(isFile ? named : named + QStringLiteral(".yaml"));
}

}  // namespace

DocumentGuard::DocumentGuard(Workspace& workspace, FileCommands& files, NoticeBar& notices,
                             const QString& recoveryFolder, QObject* parent)
    : QObject(parent),
      workspace_(workspace),
      document_(workspace.document()),
      files_(files),
      notices_(notices),
      recoveryFolder_(recoveryFolder) {
  pause_.setSingleShot(true);
  pause_.setInterval(kPauseMs);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, &pause_, qOverload<>(&QTimer::start));
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, &pause_, qOverload<>(&QTimer::start));
  connect(&pause_, &QTimer::timeout, this, &DocumentGuard::lookNow);
  connect(&document_, &editor::ScenarioDocument::pathChanged, this, [this] {
    isThere_ = true;
    watchFiles();
    for (const QLatin1String& id : {kChanged, kGone, kNotSaved, kUnread, kExport}) {
      notices_.drop(id);
    }
    tellReadOnly();
  });
  connect(&document_, &editor::ScenarioDocument::mapChanged, this, [this] {
    watchFiles();
    tellMap();
  });
  connect(&files_, &FileCommands::notSaved, this, &DocumentGuard::tellNotSaved);
  connect(&files_, &FileCommands::exported, this, &DocumentGuard::tellExported);
  connect(&files_, &FileCommands::notExported, this, [this](const base::Diagnostics& problems) {
    notices_.warn(kExport, tr("Nothing was exported: %1.").arg(reasonOf(problems, {})),
                  {{tr("Export…"), [this] { files_.askExport(); }}});
  });
  if (recoveryFolder.isEmpty()) {
    return;
  }
  autosave_ = std::make_unique<editor::Autosave>(document_, recoveryFolder);
  connect(autosave_.get(), &editor::Autosave::failed, this,
          [this](const base::Diagnostics& problems) {
            notices_.warn(QStringLiteral("autosave"),
                          tr("No copy for a crash can be kept: %1")
                              .arg(QString::fromStdString(problems.front().text())));
          });
  offerRecovery();
}

/// Folders too: a file that is replaced by renaming is another one for the system.
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

void DocumentGuard::lookNow() {
  const QStringList changed = document_.changedOnDisk();
  watchFiles();
  const bool isThere = !files_.isLost();
  if (std::exchange(isThere_, isThere) != isThere) {
    tellGone();
    Q_EMIT scenarioThere();
  }
  if (!changed.isEmpty()) {
    tellChanged(changed);
  }
}

void DocumentGuard::offerRecovery() {
  for (const QString& folder : editor::Autosave::leftBehind(recoveryFolder_)) {
    const base::Result<editor::DocumentSnapshot> copy = editor::readSnapshot(folder);
    const Notice::Choice discard = {tr("Discard"), [folder] { QDir(folder).removeRecursively(); }};
    if (!copy) {
      notices_.warn(folder,
                    tr("Unsaved work of an earlier session cannot be read: %1")
                        .arg(QString::fromStdString(copy.diagnostics().front().text())),
                    {discard});
      continue;
    }
    const QString name =
        copy->path.isEmpty() ? tr("an unnamed scenario") : QFileInfo(copy->path).fileName();
    notices_.inform(folder,
                    tr("The program ended unexpectedly. Unsaved changes to %1 were kept (%2).")
                        .arg(name, agoText(copy->when.toLocalTime(), QDateTime::currentDateTime())),
                    {{tr("Restore"), [this, folder] { restore(folder); }}, discard});
  }
}

/// The copy of the dead program goes only when there is one of this program.
void DocumentGuard::restore(const QString& folder) {
  if (!files_.restore(folder)) {
    offerRecovery();
    return;
  }
  autosave_->writeNow();
  QDir(folder).removeRecursively();
}

void DocumentGuard::tellChanged(const QStringList& changed) {
  notices_.warn(kChanged,
                (document_.isDirty()
                     ? tr("%1 was changed by another program. Reloading loses what is not saved "
                          "here.")
                     : tr("%1 was changed by another program."))
                    .arg(namesOf(changed)),
                {{tr("Reload"), [this] { files_.reload(); }},
                 {tr("Keep mine"), [this] { document_.acceptDisk(); }}});
}

void DocumentGuard::tellGone() {
  if (isThere_) {
    notices_.drop(kGone);
    return;
  }
  notices_.warn(kGone,
                tr("%1 is no longer in its folder: another program has moved or removed it. It is "
                   "still open here.")
                    .arg(document_.displayName()),
                {{tr("Save it again"), [this] { files_.save(); }},
                 {tr("Save as…"), [this] { files_.saveAs(); }}});
}

void DocumentGuard::tellReadOnly() {
  if (!document_.isReadOnly()) {
    notices_.drop(kReadOnly);
    return;
  }
  const auto saveAs = [this] {
    files_.saveAs();
    tellReadOnly();  // when it was not saved after all
  };
  notices_.warn(
      kReadOnly,
      (editor::isBlank(document_.scenario())
           ? tr("%1 is damaged: nothing of it could be read. It will not be overwritten.")
           : tr("%1 is damaged and shown as far as it could be read. It will not be overwritten."))
          .arg(document_.displayName()),
      {{tr("Save as…"), saveAs}});
}

/// Once more when no map was chosen after all.
void DocumentGuard::tellMap() {
  if (!document_.mapState().isMissing) {
    notices_.drop(kMap);
    return;
  }
  const auto choose = [this] {
    files_.askOtherMap();
    tellMap();
  };
  const auto clear = [this] {
    workspace_.runner().reset();
    editor::pushOpenPlane(document_);
  };
  notices_.warn(kMap, mapWords(document_),
                {{tr("Choose map…"), choose}, {tr("Open plane"), clear}});
}

void DocumentGuard::tellExported(const QString& folder, int files) {
  const auto show = [this, folder] {
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(folder))) {
      notices_.warn(kExport, tr("No program of this desktop shows folders. The files are in %1.")
                                 .arg(QDir::toNativeSeparators(folder)));
    }
  };
  notices_.inform(
      kExport,
      tr("%1 were exported to %2.")
          .arg(editor::counted(static_cast<std::size_t>(files), tr("file"), tr("files")),
               QDir::toNativeSeparators(folder)),
      {{tr("Show the folder"), show}});
}

void DocumentGuard::tellNotSaved(const QString& name, const base::Diagnostics& problems) {
  const auto saveAs = [this, name, problems] {
    if (!files_.saveAs() && !notices_.isTold(kNotSaved)) {
      tellNotSaved(name, problems);
    }
  };
  notices_.warn(
      kNotSaved,
      tr("%1 was not saved: %2. Your changes are still here.").arg(name, reasonOf(problems, name)),
      {{tr("Save as…"), saveAs}});
}

void DocumentGuard::tellUnread(const base::Diagnostics& problems) {
  const base::Diagnostic problem = errorsOf(problems).front();
  const QString reason = QString::fromStdString(problem.message);
  notices_.warn(kUnread,
                problem.file.empty()
                    ? tr("The file cannot be opened: %1").arg(reason)
                    : tr("%1 cannot be opened: %2")
                          .arg(QFileInfo(QString::fromStdString(problem.file)).fileName(), reason));
}

}  // namespace app
