#pragma once

#include <functional>

#include "editor/look/Theme.h"

namespace editor {

/// A collapsible section of a property page: right-aligned labels in one column, fields in the
/// other.
class FormSection : public QWidget {
  Q_OBJECT
 public:
  explicit FormSection(const QString& title, QWidget* parent = nullptr);

  QString title() const { return heading_->text(); }
  void setTitle(const QString& title) { heading_->setText(title); }
  QString note() const { return note_->text(); }
  void setNote(const QString& note) { note_->setText(note); }  // Right of the heading, secondary.
  /// Adds a link at the right end of the heading, initially hidden. Call it at most once.
  QToolButton* addLink(const QString& text, const QString& tip,
                       const std::function<void()>& action);
  /// `field` spans the whole field column.
  void addRow(const QString& label, QWidget* field);
  /// Adds a slider or other short control to the left of the field, or two fields side by side.
  void addRow(const QString& label, QWidget* left, QWidget* right);
  /// Moves the row added last below the row of `field`; null: to the top.
  void moveLastRow(const QWidget* field);
  void setRowVisible(const QWidget* field, bool visible);
  /// Marks the label of a row with a dot in the colour of warnings, and sets the tooltip of the
  /// label; empty: no mark. The layout does not change.
  void setRowMark(const QWidget* field, const QString& tip);
  void setOpen(bool open) {
    body_->setVisible(open);
    heading_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
  }
  bool isOpen() const { return heading_->arrowType() == Qt::DownArrow; }

 private:
  int rowOf(const QWidget* field) const;  // -1 = none
  QToolButton* heading_;
  QHBoxLayout* top_;
  QLabel* note_;
  QWidget* body_;
  QGridLayout* grid_;
};

/// A single-line label without a minimum width. Text that does not fit is elided, a name in the
/// middle, a sentence at its end. The tooltip and `text` contain the full text.
class ElidedLabel : public QLabel {
 public:
  explicit ElidedLabel(QWidget* parent, Qt::TextElideMode mode = Qt::ElideMiddle);
  void setFullText(const QString& words);
  QString visibleText() const;  // The text that currently fits.

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Qt::TextElideMode mode_;
};

/// A label in the secondary colour of the palette.
QLabel* secondaryLabel(const QString& text, QWidget* parent = nullptr);
/// A label in the given font.
QLabel* headingLabel(const QString& text, const QFont& font, QWidget* parent = nullptr);
/// A text button styled as a link. `tip`: tooltip; `action`: called on a click.
QToolButton* linkButton(const QString& text, const QString& tip, QWidget* parent,
                        const std::function<void()>& action);
/// A scroll area for content that is too tall for its panel, with the background of the panel.
QScrollArea* scrollArea(QWidget* content, QWidget* parent);
/// A horizontal line over the full width.
QWidget* dividerLine(QWidget* parent = nullptr);
/// `wanted` [px], limited to the screen of the window.
int limitedToScreen(const QWidget& window, int wanted);
/// "1 person", "3 people".
QString counted(std::size_t count, const QString& one, const QString& many);
/// "no tree" -> "No tree"
QString capitalized(QString text);
/// Adds a button that clears the field, with a name for screen readers.
void addClearButton(QLineEdit& field);

/// A field for filtering a list, with a magnifier and a button that clears it.
class SearchField : public QLineEdit {
  Q_DECLARE_TR_FUNCTIONS(editor::SearchField)
 public:
  SearchField(const QString& placeholder, const QString& accessibleName, QWidget* parent);
  void setTheme(const Theme& theme);

 private:
  QAction* magnifier_;
};

/// A placeholder shown instead of a list when the filter matches nothing. It names the filter text
/// and offers to clear the filter.
class NoMatchesPlaceholder : public QWidget {
  Q_OBJECT
 public:
  NoMatchesPlaceholder(QLineEdit& filter, QWidget& list, QWidget* parent);
  void setMatchFound(bool found);

 private:
  QLineEdit& filter_;
  QWidget& list_;
  QLabel* words_;
};

/// A centred hint for a panel that has nothing to show.
QLabel* emptyState(const QString& text, QWidget* parent = nullptr);
/// Sets the margins and the spacing [px] of a layout, adds the widgets and returns the layout.
template <class Layout>
Layout* configuredLayout(Layout* layout, const QMargins& margins, int spacing,
                         std::initializer_list<QWidget*> widgets = {}) {
  layout->setContentsMargins(margins);
  layout->setSpacing(spacing);
  for (QWidget* widget : widgets) {
    layout->addWidget(widget);
  }
  return layout;
}

/// A new action with a status tip and a tooltip.
QAction* makeAction(const QString& text, const QKeySequence& shortcut, const QString& tip,
                    QObject* parent);
/// A widget with this property has the page of the manual with this name (the stem of its file).
constexpr const char* kManualPageProperty = "manualPage";

/// A disabled action has this property: the reason, as a sentence for the user.
constexpr const char* kWhyDisabledProperty = "whyDisabled";
/// Enables or disables an action. `why`: the reason while it is disabled.
void setEnabled(QAction& action, bool enabled, const QString& why);
/// Sets the status tip of an action, and its tooltip from name, shortcut and `tip`. Call it again
/// when one of them changes.
void describe(QAction& action, const QString& tip);

/// Disables deleting, renaming and moving files in the dialog; new folders are allowed if
/// `allowNewFolders`. Call it before the dialog is shown. Native desktop dialogs are not affected.
void restrictFileDialog(QFileDialog& dialog, bool allowNewFolders);
/// Shows the restricted dialog. Returns the chosen files; empty: cancelled.
QStringList chosenFiles(QFileDialog& dialog, bool allowNewFolders);

}  // namespace editor
