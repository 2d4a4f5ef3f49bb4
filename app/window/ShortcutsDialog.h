#pragma once

#include <QtWidgets>

namespace editor {
class NoMatchesPlaceholder;
}  // namespace editor

namespace app {

/// A searchable list of all shortcuts, taken from the commands and tools, and the rules of
/// precedence.
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
  editor::NoMatchesPlaceholder* nothing_;
};

}  // namespace app
