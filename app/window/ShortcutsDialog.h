#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QMenuBar>
#include <QTreeWidget>

namespace editor {
class NothingFound;
}  // namespace editor

namespace app {

/// All keys of the window, as its commands and tools say them themselves, with a search; below them
/// who has a key that several want.
class ShortcutsDialog : public QDialog {
  Q_OBJECT
 public:
  ShortcutsDialog(const QMenuBar& menus, QWidget* parent);
  QLineEdit& search() const { return *search_; }
  QTreeWidget& list() const { return *list_; }

 private:
  void addMenu(QTreeWidgetItem& group, const QMenu& menu);
  void filter(const QString& text);

  QLineEdit* search_;
  QTreeWidget* list_;
  editor::NothingFound* nothing_;
};

}  // namespace app
