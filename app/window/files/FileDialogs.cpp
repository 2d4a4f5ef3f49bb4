#include "app/window/files/FileDialogs.h"

#include <array>

#include "editor/look/FileDialog.h"
#include "editor/look/Form.h"

namespace app {

namespace {

constexpr int kRecentFiles = 8;
constexpr const char* kRecentKey = "files/recent";
constexpr const char* kNotedKey = "files/noted";  // time of last use, by file
constexpr const char* kStateKey = "files/dialog";
constexpr const char* kSizeKey = "files/dialog-size";
constexpr QSize kSize(920, 560);
constexpr int kPlaces = 150;                                  // width of the folder column
constexpr std::array<int, 4> kColumns = {330, 90, 100, 160};  // name, size, type, date

/// Restores size and state of Qt's own dialog. Native dialogs do this themselves.
void restoreDialog(QFileDialog& dialog, const UserSettings& userSettings) {
  auto* list = dialog.findChild<QTreeView*>(QStringLiteral("treeView"));
  if (list == nullptr) {
    return;
  }
  const QSize size = userSettings.value(kSizeKey).toSize();
  dialog.resize(size.isValid()
                    ? size
                    : QSize(kSize.width(), editor::limitedToScreen(dialog, kSize.height())));
  if (!dialog.restoreState(userSettings.value(kStateKey).toByteArray())) {
    dialog.setViewMode(QFileDialog::Detail);
    if (auto* sides = dialog.findChild<QSplitter*>(QStringLiteral("splitter"))) {
      sides->setSizes({kPlaces, kSize.width() - kPlaces});
    }
    list->header()->setStretchLastSection(true);
    for (int column = 0; column < static_cast<int>(kColumns.size()); ++column) {
      list->header()->resizeSection(column, kColumns.at(static_cast<std::size_t>(column)));
    }
  }
}

}  // namespace

UserSettings::UserSettings(bool storesSettings) {
  if (storesSettings) {
    store_ = std::make_unique<QSettings>(QStringLiteral("hunavsim"), QStringLiteral("desktop"));
  }
}

QVariant UserSettings::value(const char* key) const {
  return store_ ? store_->value(QString::fromLatin1(key)) : QVariant();
}

void UserSettings::setValue(const char* key, const QVariant& value) {
  if (store_) {
    store_->setValue(QString::fromLatin1(key), value);
  }
}

QStringList UserSettings::recentFiles() const {
  return value(kRecentKey).toStringList();
}

void UserSettings::addRecentFile(const QString& path) {
  QStringList files = recentFiles();
  const QString whole = QFileInfo(path).absoluteFilePath();
  files.removeAll(whole);
  files.prepend(whole);
  while (files.size() > kRecentFiles) {
    files.removeLast();
  }
  setValue(kRecentKey, files);
  const QVariantMap before = value(kNotedKey).toMap();
  QVariantMap lastUsed;
  for (const QString& file : files) {
    lastUsed[file] = file == whole ? QDateTime::currentDateTime() : before.value(file);
  }
  setValue(kNotedKey, lastUsed);
}

QDateTime UserSettings::lastUsed(const QString& path) const {
  return value(kNotedKey).toMap().value(path).toDateTime();
}

QString askFile(QFileDialog& dialog, UserSettings& userSettings) {
  const QString folder = dialog.directory().absolutePath();
  restoreDialog(dialog, userSettings);
  editor::restrictFileDialog(dialog, dialog.acceptMode() == QFileDialog::AcceptSave);
  dialog.setDirectory(folder);  // restoreState would set the last folder
  const bool isAccepted = dialog.exec() == QDialog::Accepted;
  userSettings.setValue(kStateKey, dialog.saveState());
  userSettings.setValue(kSizeKey, dialog.size());
  return isAccepted ? dialog.selectedFiles().value(0) : QString();
}

QFormLayout* formRows() {
  auto* form = new QFormLayout;
  form->setLabelAlignment(Qt::AlignRight);
  form->setHorizontalSpacing(8);
  form->setVerticalSpacing(4);
  return form;
}

QPushButton* addButtons(QDialog* dialog, QVBoxLayout& rows, const QString& accept) {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, dialog);
  QPushButton* button = buttons->addButton(accept, QDialogButtonBox::AcceptRole);
  button->setDefault(true);
  QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  rows.addWidget(buttons);
  return button;
}

}  // namespace app
