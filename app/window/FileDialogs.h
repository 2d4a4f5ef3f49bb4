#pragma once

#include <memory>

#include <QDateTime>
#include <QFileDialog>
#include <QFormLayout>
#include <QPushButton>
#include <QSettings>
#include <QStringList>
#include <QVBoxLayout>
#include <QVariant>

namespace app {

/// Recent files and what else is remembered between sessions. Without a store (pictures, tests)
/// nothing is read or written.
class Memory {
 public:
  explicit Memory(bool remembers);
  QStringList recentFiles() const;
  void noteFile(const QString& path);          // opened or saved just now
  QDateTime noted(const QString& path) const;  // when; invalid: not known
  QVariant value(const char* key) const;
  void setValue(const char* key, const QVariant& value);

 private:
  std::unique_ptr<QSettings> store_;
};

/// Asks for a file or folder; empty = cancelled. Large enough for names and dates the first time,
/// then as it was left.
QString askFile(QFileDialog& dialog, Memory& memory);

/// Labels right-aligned beside their fields.
QFormLayout* formRows();
/// The button that accepts and one that cancels, below all the rest. Returns the former.
QPushButton* addButtons(QDialog* dialog, QVBoxLayout& rows, const QString& accept);

}  // namespace app
