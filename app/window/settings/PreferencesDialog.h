#pragma once

#include "app/window/WindowActions.h"
#include "app/window/settings/Preferences.h"
#include "app/window/settings/ShortcutsPage.h"

namespace app {

/// All preferences in one place. Every change takes effect immediately.
class PreferencesDialog : public QDialog {
  Q_OBJECT
 public:
  /// `folder`: where file dialogs start without a preferred folder.
  PreferencesDialog(Preferences& preferences, const WindowActions& actions, KeyMap& keys,
                    Workspace& workspace, QString folder, QWidget* parent);
  QTabWidget& pages() const { return *pages_; }
  ShortcutsPage& shortcuts() const { return *shortcuts_; }

 private:
  QWidget* makeGeneral();
  QWidget* makeFiles();
  void addButtons(QVBoxLayout& rows);
  void fill();
  void chooseTheme(int theme);
  void chooseFolder();
  void resetAll();

  Preferences& preferences_;
  const WindowActions& actions_;
  KeyMap& keys_;
  Workspace& workspace_;
  QString usualFolder_;
  bool isFilling_ = false;
  QTabWidget* pages_ = new QTabWidget(this);
  QComboBox* theme_ = new QComboBox(this);
  QComboBox* language_ = new QComboBox(this);
  QCheckBox* animation_ = new QCheckBox(tr("&Animate zooming and fitting"), this);
  QSpinBox* history_ = new QSpinBox(this);
  QLineEdit* folder_ = new QLineEdit(this);
  QCheckBox* autosave_ = new QCheckBox(tr("&Keep copies of unsaved changes"), this);
  QSpinBox* seconds_ = new QSpinBox(this);
  ShortcutsPage* shortcuts_;
};

}  // namespace app
