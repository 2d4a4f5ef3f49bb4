#include "editor/look/Form.h"

#include <algorithm>

#include "editor/look/AppStyle.h"
#include "editor/look/Fields.h"
#include "editor/look/Icons.h"

namespace editor {

namespace {

constexpr int kLabelEnd = 112;  // Right edge of the labels from the left edge of the dock [px].
constexpr int kGap = 12;
constexpr int kMinHalf = 72;
constexpr int kFormRowHeight = 28;

}  // namespace

ElidedLabel::ElidedLabel(QWidget* parent, Qt::TextElideMode mode) : QLabel(parent), mode_(mode) {
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::setFullText(const QString& words) {
  setText(words);
  setToolTip(Qt::mightBeRichText(words) ? QStringLiteral("<p>%1</p>").arg(words.toHtmlEscaped())
                                        : words);
}

QString ElidedLabel::visibleText() const {
  return fontMetrics().elidedText(text(), mode_, contentsRect().width());
}

void ElidedLabel::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setPen(palette().color(foregroundRole()));
  painter.drawText(contentsRect(), int(alignment()) | Qt::TextSingleLine, visibleText());
}

QLabel* secondaryLabel(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setForegroundRole(QPalette::PlaceholderText);
  return label;
}

QLabel* headingLabel(const QString& text, const QFont& font, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setFont(font);
  return label;
}

QToolButton* linkButton(const QString& text, const QString& tip, QWidget* parent,
                        const std::function<void()>& action) {
  auto* button = new QToolButton(parent);
  button->setText(text);
  button->setProperty(kLinkProperty, true);
  button->setCursor(Qt::PointingHandCursor);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button->setAutoRaise(true);
  button->setToolTip(tip);
  QObject::connect(button, &QToolButton::clicked, parent, action);
  return button;
}

QScrollArea* scrollArea(QWidget* content, QWidget* parent) {
  auto* area = new QScrollArea(parent);
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setWidget(content);
  area->viewport()->setAutoFillBackground(false);
  content->setAutoFillBackground(false);
  return area;
}

QWidget* dividerLine(QWidget* parent) {
  auto* line = new QWidget(parent);
  line->setFixedHeight(1);
  line->setAutoFillBackground(true);
  line->setBackgroundRole(QPalette::Dark);
  return line;
}

int limitedToScreen(const QWidget& window, int wanted) {
  constexpr int kTitleBar = 38;  // Approximate height of the window frame.
  return std::min(wanted, window.screen()->availableGeometry().height() - kTitleBar);
}

QString counted(std::size_t count, const QString& one, const QString& many) {
  return QStringLiteral("%1 %2").arg(count).arg(count == 1 ? one : many);
}

QString capitalized(QString text) {
  if (!text.isEmpty()) {
    text[0] = text[0].toUpper();
  }
  return text;
}

QLabel* emptyState(const QString& text, QWidget* parent) {
  QLabel* label = secondaryLabel(text, parent);
  label->setAlignment(Qt::AlignCenter);
  label->setWordWrap(true);
  label->setContentsMargins(16, 16, 16, 16);
  return label;
}

void addClearButton(QLineEdit& field) {
  field.setClearButtonEnabled(true);
  auto* clear = field.findChild<QAction*>(QStringLiteral("_q_qlineeditclearaction"));
  if (clear != nullptr) {
    clear->setText(QObject::tr("Clear"));
  }
}

SearchField::SearchField(const QString& placeholder, const QString& accessibleName, QWidget* parent)
    : QLineEdit(parent), magnifier_(addAction(QIcon(), QLineEdit::LeadingPosition)) {
  setPlaceholderText(placeholder);
  setAccessibleName(accessibleName);
  magnifier_->setText(tr("Search"));  // the name of its button
  addClearButton(*this);
}

void SearchField::setTheme(const Theme& theme) {
  magnifier_->setIcon(tintedIcon(QStringLiteral("search"), theme.color(Role::TextSecondary)));
}

NoMatchesPlaceholder::NoMatchesPlaceholder(QLineEdit& filter, QWidget& list, QWidget* parent)
    : QWidget(parent), filter_(filter), list_(list), words_(emptyState({}, this)) {
  words_->setTextFormat(Qt::PlainText);
  auto* clear = linkButton(tr("Clear"), tr("Show the whole list"), this, [this] {
    filter_.clear();
    filter_.setFocus();
  });
  auto* layout = configuredLayout(new QVBoxLayout(this), {0, 0, 0, 0}, 0, {words_});
  layout->addWidget(clear, 0, Qt::AlignHCenter);
  layout->addStretch(1);
  hide();
}

void NoMatchesPlaceholder::setMatchFound(bool found) {
  constexpr int kMaxNamed = 40;  // Maximum number of characters.
  const QString text = filter_.text().trimmed();
  const QString named = text.size() > kMaxNamed ? text.left(kMaxNamed) + QChar(0x2026) : text;
  words_->setText(tr("No matches for '%1'").arg(named));
  list_.setVisible(found);
  setVisible(!found);
}

QAction* makeAction(const QString& text, const QKeySequence& shortcut, const QString& tip,
                    QObject* parent) {
  auto* action = new QAction(text, parent);
  action->setShortcut(shortcut);
  describe(*action, tip);
  return action;
}

void setEnabled(QAction& action, bool enabled, const QString& why) {
  action.setProperty(kWhyDisabledProperty, enabled ? QString() : why);
  action.setEnabled(enabled);
}

void describe(QAction& action, const QString& tip) {
  QString name = action.text().section(QLatin1Char('\t'), 0, 0);  // Without the shortcut of a tool.
  name.remove(QLatin1Char('&')).remove(QStringLiteral("…"));
  const QString key = action.shortcut().toString(QKeySequence::NativeText);
  action.setStatusTip(tip);
  action.setToolTip(key.isEmpty() ? name + QLatin1Char('\n') + tip
                                  : QStringLiteral("%1 (%2)\n%3").arg(name, key, tip));
}

namespace {

/// A label with an optional dot in the gap to its field.
class RowLabel : public QLabel {
 public:
  RowLabel(const QString& text, QWidget* parent) : QLabel(text, parent) {
    setForegroundRole(QPalette::PlaceholderText);
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setContentsMargins(0, 0, kGap, 0);
  }
  void setMark(const QString& tip) {
    setToolTip(tip);
    update();
  }

 protected:
  void paintEvent(QPaintEvent* event) override {
    QLabel::paintEvent(event);
    if (!toolTip().isEmpty()) {
      QPainter painter(this);
      painter.setRenderHint(QPainter::Antialiasing);
      painter.setPen(Qt::NoPen);
      painter.setBrush(Theme::fromSystem(palette()).color(Role::WarningMark));
      painter.drawEllipse(QPointF(width() - 0.5 * kGap, 0.5 * height()), kMarkRadius, kMarkRadius);
    }
  }

 private:
  static constexpr double kMarkRadius = 3.0;  // [px]
};

}  // namespace

FormSection::FormSection(const QString& title, QWidget* parent)
    : QWidget(parent),
      heading_(new QToolButton(this)),
      top_(new QHBoxLayout),
      note_(secondaryLabel({}, this)),
      body_(new QWidget(this)),
      grid_(new QGridLayout(body_)) {
  heading_->setText(title);
  heading_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  heading_->setAutoRaise(true);
  heading_->setArrowType(Qt::DownArrow);
  heading_->setFixedHeight(32);
  heading_->setToolTip(QObject::tr("Collapse or expand"));
  QFont bold = heading_->font();
  bold.setWeight(QFont::DemiBold);
  heading_->setFont(bold);
  connect(heading_, &QToolButton::clicked, this, [this] { setOpen(!isOpen()); });

  configuredLayout(top_, {8, 0, 12, 0}, 8, {heading_});
  top_->addStretch();
  top_->addWidget(note_);

  grid_->setContentsMargins(12, 0, 12, 8);
  grid_->setHorizontalSpacing(0);  // The labels contain the gap.
  grid_->setVerticalSpacing(0);
  grid_->setColumnMinimumWidth(0, kLabelEnd - 12 + kGap);
  grid_->setColumnStretch(1, 1);

  auto* layout = configuredLayout(new QVBoxLayout(this), {}, 0);
  layout->addLayout(top_);
  layout->addWidget(body_);
  layout->addWidget(dividerLine(this));
}

QToolButton* FormSection::addLink(const QString& text, const QString& tip,
                                  const std::function<void()>& action) {
  QToolButton* link = linkButton(text, tip, this, action);
  top_->addWidget(link);
  link->hide();
  return link;
}

void FormSection::addRow(const QString& label, QWidget* field) {
  const int row = grid_->rowCount();
  grid_->setRowMinimumHeight(row, kFormRowHeight);
  auto* words = new RowLabel(label, body_);
  words->setBuddy(field);
  field->setAccessibleName(label);
  QSizePolicy policy = field->sizePolicy();
  Qt::Alignment alignment = Qt::AlignVCenter;
  if ((static_cast<int>(policy.horizontalPolicy()) & QSizePolicy::GrowFlag) != 0) {
    policy.setHorizontalPolicy(QSizePolicy::Ignored);  // A wide field would widen the page,
    field->setSizePolicy(policy);                      // which does not scroll sideways.
  } else {
    alignment |= Qt::AlignLeft;  // Otherwise the column is no wider than this field.
  }
  grid_->addWidget(words, row, 0);
  grid_->addWidget(field, row, 1, alignment);
}

void FormSection::addRow(const QString& label, QWidget* left, QWidget* right) {
  auto* both = new QWidget(body_);
  auto* line = configuredLayout(new QHBoxLayout(both), {}, 8);
  for (QWidget* part : {left, right}) {
    part->setMinimumWidth(kMinHalf);
    part->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    line->addWidget(part, 1);
    part->setAccessibleName(label);
  }
  addRow(label, both);
}

int FormSection::rowOf(const QWidget* field) const {
  for (const QWidget* widget = field; widget != nullptr; widget = widget->parentWidget()) {
    const int index = grid_->indexOf(const_cast<QWidget*>(widget));
    if (index >= 0) {
      int row = 0;
      int other = 0;
      grid_->getItemPosition(index, &row, &other, &other, &other);
      return row;
    }
  }
  return -1;
}

void FormSection::moveLastRow(const QWidget* field) {
  const int wanted = rowOf(field) + 1;
  const auto take = [this](int row, int column) {
    QLayoutItem* item = grid_->itemAtPosition(row, column);
    grid_->removeItem(item);
    return item;
  };
  for (int row = grid_->rowCount() - 1; row > wanted; --row) {
    for (int column = 0; column < 2; ++column) {
      QLayoutItem* moved = take(row, column);
      if (QLayoutItem* other = grid_->itemAtPosition(row - 1, column)) {
        grid_->removeItem(other);
        grid_->addItem(other, row, column, 1, 1, other->alignment());
      }
      grid_->addItem(moved, row - 1, column, 1, 1, moved->alignment());
    }
  }
}

void FormSection::setRowVisible(const QWidget* field, bool visible) {
  const int row = rowOf(field);
  if (row < 0) {
    return;
  }
  grid_->setRowMinimumHeight(row, visible ? kFormRowHeight : 0);
  for (int column = 0; column < 2; ++column) {
    if (QLayoutItem* item = grid_->itemAtPosition(row, column);
        item != nullptr && item->widget() != nullptr) {
      item->widget()->setVisible(visible);
    }
  }
}

void FormSection::setRowMark(const QWidget* field, const QString& tip) {
  const int row = rowOf(field);
  QLayoutItem* item = row < 0 ? nullptr : grid_->itemAtPosition(row, 0);
  if (auto* label = item == nullptr ? nullptr : dynamic_cast<RowLabel*>(item->widget())) {
    label->setMark(tip);
  }
}

namespace {

/// Renames a file after the current event. Qt reports a failure in a modal dialog, during which the
/// item editor may be deleted; Qt 5.15 then reads freed memory.
class NamingDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void setModelData(QWidget* editor, QAbstractItemModel* model,
                    const QModelIndex& index) const override {
    const auto* const line = qobject_cast<QLineEdit*>(editor);
    auto* const files = qobject_cast<QFileSystemModel*>(model);
    if (line == nullptr || files == nullptr) {
      QStyledItemDelegate::setModelData(editor, model, index);
      return;
    }
    // Looks the index up by path, because the model may have reloaded the folder.
    QTimer::singleShot(0, files, [files, name = line->text(), path = files->filePath(index)] {
      files->setData(files->index(path), name);
    });
  }
};

}  // namespace

void restrictFileDialog(QFileDialog& dialog, bool allowNewFolders) {
  if (!allowNewFolders) {
    dialog.setOption(QFileDialog::ReadOnly);
    return;
  }
  for (const char* name : {"qt_delete_action", "qt_rename_action"}) {
    if (auto* action = dialog.findChild<QAction*>(QString::fromLatin1(name))) {
      action->setVisible(false);
    }
  }
  for (QShortcut* shortcut : dialog.findChildren<QShortcut*>()) {
    shortcut->setEnabled(shortcut->key() != QKeySequence(Qt::Key_Delete));
  }
  for (const char* name : {"listView", "treeView"}) {
    if (auto* files = dialog.findChild<QAbstractItemView*>(QString::fromLatin1(name))) {
      files->setEditTriggers(
          QAbstractItemView::NoEditTriggers);  // A new folder can be named nevertheless.
      files->setDragDropMode(QAbstractItemView::NoDragDrop);
      files->setItemDelegate(new NamingDelegate(files));
      // Commits the name of a new folder before the folder changes: Qt 5.15 reads freed memory if
      // the user leaves the folder while typing.
      for (QToolButton* button : dialog.findChildren<QToolButton*>()) {
        QObject::connect(button, &QToolButton::pressed, files,
                         [files] { commitPendingEdit(*files); });
      }
    }
  }
}

QStringList chosenFiles(QFileDialog& dialog, bool allowNewFolders) {
  restrictFileDialog(dialog, allowNewFolders);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles() : QStringList();
}

}  // namespace editor
