#pragma once

#include "app/window/Workspace.h"
#include "app/window/files/FileDialogs.h"
#include "app/window/settings/Language.h"
#include "editor/document/Autosave.h"

namespace app {

/// The folder in which file dialogs start when the open document has none; empty: that of the last
/// used file.
constexpr const char* kFolderKey = "files/folder";

/// Settings of the whole program, stored between sessions and applied to the parts of the window
/// immediately. The theme, the display options and the keys are stored by `MainWindow`,
/// `WindowActions` and `KeyMap`.
class Preferences : public QObject {
  Q_OBJECT
 public:
  static constexpr int kLeastSeconds = 1, kMostSeconds = 600;

  /// Applies the stored values. `autosave` null: no copies are kept.
  Preferences(Workspace& workspace, UserSettings& userSettings, editor::Autosave* autosave,
              QObject* parent);

  bool isAnimated() const;
  void setAnimated(bool on);
  QString folder() const { return userSettings_.value(kFolderKey).toString(); }
  void setFolder(const QString& folder) {
    userSettings_.setValue(kFolderKey, folder.isEmpty() ? folder : QDir::cleanPath(folder));
  }
  bool isAutosaved() const;
  int autosaveSeconds() const;  // the longest time between a change and its copy
  void setAutosave(bool on, int seconds);
  /// The stored code of the language; empty: that of the system. Takes effect at the next start.
  QString language() const { return userSettings_.value(kLanguageKey).toString(); }
  void setLanguage(const QString& code) { userSettings_.setValue(kLanguageKey, code); }
  int historyMegabytes() const;
  void setHistoryMegabytes(int megabytes);
  /// Restores the defaults of all values of this class.
  void reset();

 private:
  void apply();

  Workspace& workspace_;
  UserSettings& userSettings_;
  editor::Autosave* autosave_;
};

}  // namespace app
