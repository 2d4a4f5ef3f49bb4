#pragma once

#include "app/window/help/Commands.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"

namespace app {

/// A list of all commands of the window with their keys, opened by Ctrl+Shift+P. Typing filters it,
/// Enter runs the selected command. Commands that are not available are listed below the others
/// with the reason. Commands used before in this session come first while nothing is typed.
class CommandPalette : public QDialog {
  Q_OBJECT
 public:
  CommandPalette(const QMenuBar& menus, const editor::Theme& theme, QWidget* parent);

  /// Fills the list with the commands as they are now, and shows the palette at the top of the
  /// window.
  void open() override;
  QLineEdit& search() const { return *search_; }
  QListWidget& list() const { return *list_; }
  void setTheme(const editor::Theme& theme);

  static constexpr int kReasonRole = Qt::UserRole + 1;  // why a row is not available
  static constexpr int kKeysRole = Qt::UserRole + 2;
  static constexpr int kPathRole = Qt::UserRole + 3;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fill();
  void addRow(std::size_t index);  // of the command
  void run(QListWidgetItem* row);

  const QMenuBar& menus_;
  editor::Theme theme_;
  editor::SearchField* search_;
  QListWidget* list_ = new QListWidget(this);
  QLabel* reason_ = editor::secondaryLabel({}, this);
  editor::NoMatchesPlaceholder* nothing_;
  std::vector<Command> commands_;
  QList<QPointer<QAction>> used_;  // newest first
};

}  // namespace app
