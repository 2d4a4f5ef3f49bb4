#pragma once

#include <memory>

#include <QtWidgets>

namespace app {

/// Recent files and other settings stored between sessions. Without a store (pictures, tests)
/// nothing is read or written.
class UserSettings {
 public:
  explicit UserSettings(bool storesSettings);
  QStringList recentFiles() const;
  void addRecentFile(const QString& path);        // call when a file is opened or saved
  QDateTime lastUsed(const QString& path) const;  // time of last use; invalid: unknown
  QVariant value(const char* key) const;
  void setValue(const char* key, const QVariant& value);

 private:
  std::unique_ptr<QSettings> store_;
};

/// Asks for a file or folder. Empty: cancelled. The dialog has its last size and state.
QString askFile(QFileDialog& dialog, UserSettings& userSettings);

/// A form with right-aligned labels.
QFormLayout* formRows();
/// Adds an accept and a cancel button at the bottom. Returns the accept button.
QPushButton* addButtons(QDialog* dialog, QVBoxLayout& rows, const QString& accept);

}  // namespace app
