#pragma once

#include "app/window/settings/KeyMap.h"
#include "editor/look/Form.h"

namespace app {

/// A field that shows the keys pressed in it. Tab and Esc keep their meaning.
class KeyField : public QLineEdit {
  Q_OBJECT
 public:
  explicit KeyField(QWidget* parent) : QLineEdit(parent) { setReadOnly(true); }
  QKeySequence keys() const { return keys_; }
  void setKeys(const QKeySequence& keys);

 Q_SIGNALS:
  void keysChanged();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QKeySequence keys_;
};

/// A searchable list of all commands and their keys. The keys of the selected command can be
/// changed; keys that another command has are taken from it after a warning.
class ShortcutsPage : public QWidget {
  Q_OBJECT
 public:
  ShortcutsPage(KeyMap& keys, QWidget* parent);
  QLineEdit& search() const { return *search_; }
  QTreeWidget& list() const { return *list_; }
  KeyField& field() const { return *field_; }
  QString warning() const { return warning_->text(); }

 private:
  QLayout* makeEditor();
  void fill();
  void fillRow(QTreeWidgetItem& row, const KeyMap::Entry& entry) const;
  void filter(const QString& text);
  const KeyMap::Entry* selected() const;  // null: none, or a heading
  void showSelected();
  void judge();
  void assign();

  KeyMap& keys_;
  QLineEdit* search_ = new QLineEdit(this);
  QTreeWidget* list_ = new QTreeWidget(this);
  editor::NoMatchesPlaceholder* nothing_;
  QLabel* name_ = new QLabel(this);
  KeyField* field_ = new KeyField(this);
  QPushButton* assign_ = new QPushButton(tr("&Assign"), this);
  QPushButton* remove_ = new QPushButton(tr("&Remove"), this);
  QPushButton* usual_ = new QPushButton(tr("&Default"), this);
  QPushButton* allUsual_ = new QPushButton(tr("Restore a&ll defaults"), this);
  QLabel* warning_ = editor::secondaryLabel({}, this);
};

/// The shortcuts as a window, with the rules of precedence between fields, lists and commands. It
/// is not modal, so that keys can be tried.
class ShortcutsDialog : public QDialog {
  Q_OBJECT
 public:
  ShortcutsDialog(KeyMap& keys, QWidget* parent);
  ShortcutsPage& page() const { return *page_; }
  QLineEdit& search() const { return page_->search(); }
  QTreeWidget& list() const { return page_->list(); }

 private:
  ShortcutsPage* page_;
};

}  // namespace app
