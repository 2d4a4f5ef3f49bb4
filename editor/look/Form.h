#pragma once

#include <functional>
#include <initializer_list>

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QToolButton>
#include <QWidget>

namespace editor {

/// A part of a property page under a heading that folds it: labels right-aligned in one column,
/// fields in the other.
class FormSection : public QWidget {
  Q_OBJECT
 public:
  explicit FormSection(const QString& title, QWidget* parent = nullptr);

  QString title() const;
  void setTitle(const QString& title);
  QString note() const { return note_->text(); }
  void setNote(const QString& note) { note_->setText(note); }  // right of the heading, secondary
  /// A link at the right end of the heading, hidden until it is shown. Once.
  QToolButton* addLink(const QString& text, const QString& says,
                       const std::function<void()>& action);
  /// `field` takes the whole column of fields.
  void addRow(const QString& label, QWidget* field);
  /// A slider or other short control left of the field, or two fields side by side.
  void addRow(const QString& label, QWidget* left, QWidget* right);
  /// Moves the row added last to the place after that of `field`; null: to the top.
  void moveLastRow(const QWidget* field);
  void setRowVisible(const QWidget* field, bool visible);
  void setOpen(bool open);
  bool isOpen() const;

 private:
  int rowOf(const QWidget* field) const;  // -1 = none
  QToolButton* heading_;
  QHBoxLayout* top_;
  QLabel* note_;
  QWidget* body_;
  QGridLayout* grid_;
};

/// One line that asks for no width of its own: of what does not fit the last parts go (they stand
/// between " · "), of one part the middle. The tool tip has the whole, and `text` stays whole.
class ElidedLabel : public QLabel {
 public:
  explicit ElidedLabel(QWidget* parent);
  void setWords(const QString& words);
  QString shownWords() const;  // as they fit now

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// A text in the secondary colour of the palette.
QLabel* secondaryLabel(const QString& text, QWidget* parent = nullptr);
/// A text in another font.
QLabel* headingLabel(const QString& text, const QFont& font, QWidget* parent = nullptr);
/// A button of words that looks like a link, with a tooltip and with what it does.
QToolButton* linkButton(const QString& text, const QString& says, QWidget* parent,
                        const std::function<void()>& action);
/// Lets what is too high for its panel be scrolled; both show the ground of the panel.
QScrollArea* scrollArea(QWidget* content, QWidget* parent);
/// A line over the whole width.
QWidget* dividerLine(QWidget* parent = nullptr);
/// The height that a window can have on its screen: this one, or less.
int heightOnScreen(const QWidget& window, int wanted);
/// "1 person", "3 people".
QString counted(std::size_t count, const QString& one, const QString& many);
/// "no tree" -> "No tree"
QString capitalized(QString text);
/// Takes the place of a list of which a filter leaves nothing: says so, and clears the filter.
class NothingFound : public QWidget {
  Q_OBJECT
 public:
  NothingFound(QLineEdit& filter, QWidget& list, QWidget* parent);
  void showFor(bool found);

 private:
  QLineEdit& filter_;
  QWidget& list_;
  QLabel* words_;
};

/// A centred sentence that says what to do when a panel has nothing to show.
QLabel* emptyState(const QString& text, QWidget* parent = nullptr);
/// A layout with these margins and this space between its parts [px], of which these are the first.
template <class Layout>
Layout* arranged(Layout* layout, const QMargins& margins, int spacing,
                 std::initializer_list<QWidget*> widgets = {}) {
  layout->setContentsMargins(margins);
  layout->setSpacing(spacing);
  for (QWidget* widget : widgets) {
    layout->addWidget(widget);
  }
  return layout;
}

/// What a command says of itself: the sentence in the status bar, and in its tooltip below its name
/// and its key. Call it again when one of them changes.
void describe(QAction& action, const QString& says);

}  // namespace editor
