#include "app/window/settings/ShortcutsPage.h"

#include <algorithm>
#include <iterator>

#include "app/window/KeyRules.h"
#include "editor/panels/RowDelegate.h"

namespace app {

namespace {

constexpr QSize kShortcutsSize(680, 620);
constexpr int kNameWidth = 200;
constexpr int kKeyWidth = 150;
constexpr int kFieldWidth = 160;

/// Headings have none.
QString idOf(const QTreeWidgetItem& row) {
  return row.data(0, Qt::UserRole).toString();
}

}  // namespace

void KeyField::setKeys(const QKeySequence& keys) {
  keys_ = keys;
  setText(keys.toString(QKeySequence::NativeText));
  Q_EMIT keysChanged();
}

/// Keys of commands are shown instead of running them.
bool KeyField::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return true;
  }
  return QLineEdit::event(event);
}

void KeyField::keyPressEvent(QKeyEvent* event) {
  constexpr int kAlone[] = {Qt::Key_Shift, Qt::Key_Control, Qt::Key_Meta,
                            Qt::Key_Alt,   Qt::Key_AltGr,   Qt::Key_unknown};
  const bool isAlone =
      std::find(std::begin(kAlone), std::end(kAlone), event->key()) != std::end(kAlone);
  if (event->key() == Qt::Key_Escape && event->modifiers() == Qt::NoModifier) {
    event->ignore();  // closes the window
    return;
  }
  event->accept();
  if (!isAlone) {
    setKeys(
        QKeySequence(event->key() | static_cast<int>(event->modifiers() & ~Qt::KeypadModifier)));
  }
}

ShortcutsPage::ShortcutsPage(KeyMap& keys, QWidget* parent) : QWidget(parent), keys_(keys) {
  search_->setPlaceholderText(tr("Find a command or a key"));
  search_->setAccessibleName(tr("Find a command or a key"));
  editor::addClearButton(*search_);
  editor::styleList(*list_, tr("Keyboard shortcuts"));
  list_->setColumnCount(3);
  list_->setHeaderHidden(true);
  list_->header()->resizeSection(0, kNameWidth);
  list_->header()->resizeSection(1, kKeyWidth);
  nothing_ = new editor::NoMatchesPlaceholder(*search_, *list_, this);
  warning_->setWordWrap(true);
  auto* layout = editor::configuredLayout(new QVBoxLayout(this), {}, 8, {search_});
  layout->addWidget(list_, 1);
  layout->addWidget(nothing_, 1);
  layout->addLayout(makeEditor());
  layout->addWidget(warning_);
  connect(search_, &QLineEdit::textChanged, this, &ShortcutsPage::filter);
  connect(list_, &QTreeWidget::currentItemChanged, this, &ShortcutsPage::showSelected);
  connect(list_, &QTreeWidget::itemDoubleClicked, field_, qOverload<>(&QWidget::setFocus));
  connect(&keys_, &KeyMap::changed, this, [this] {
    for (QTreeWidgetItemIterator row(list_); *row != nullptr; ++row) {
      for (const KeyMap::Entry& entry : keys_.entries()) {
        if (idOf(**row) == entry.id) {
          fillRow(**row, entry);
        }
      }
    }
    showSelected();
  });
  fill();
  filter({});
  showSelected();
}

QLayout* ShortcutsPage::makeEditor() {
  field_->setAccessibleName(tr("New keys"));
  field_->setToolTip(tr("New keys\nPress the keys for the selected command"));
  field_->setPlaceholderText(tr("Press keys"));
  field_->setFixedWidth(kFieldWidth);
  name_->setBuddy(field_);
  assign_->setToolTip(tr("Give these keys to the selected command"));
  remove_->setToolTip(tr("Remove the keys of the selected command"));
  usual_->setToolTip(tr("Restore the default keys of the selected command"));
  allUsual_->setToolTip(tr("Restore the default keys of all commands"));
  auto* row = editor::configuredLayout(new QHBoxLayout, {}, 8, {name_});
  row->addStretch(1);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{field_, assign_, remove_, usual_, allUsual_}) {
    row->addWidget(widget);
  }
  for (QPushButton* button : {assign_, remove_, usual_, allUsual_}) {
    button->setAutoDefault(false);  // Enter in the search field must not change keys
  }
  connect(field_, &KeyField::keysChanged, this, &ShortcutsPage::judge);
  connect(assign_, &QPushButton::clicked, this, &ShortcutsPage::assign);
  connect(remove_, &QPushButton::clicked, this, [this] {
    if (const KeyMap::Entry* entry = selected()) {
      keys_.assign(*entry->action, {});
    }
  });
  connect(usual_, &QPushButton::clicked, this, [this] {
    if (const KeyMap::Entry* entry = selected()) {
      keys_.reset(*entry->action);
    }
  });
  connect(allUsual_, &QPushButton::clicked, &keys_, &KeyMap::resetAll);
  return row;
}

void ShortcutsPage::fillRow(QTreeWidgetItem& row, const KeyMap::Entry& entry) const {
  row.setText(0, entry.name);
  row.setText(1, commandKeys(*entry.action));
  row.setText(2, entry.action->statusTip());
  row.setToolTip(2, entry.action->statusTip());
  row.setData(0, Qt::UserRole, entry.id);
  QFont changed = font();
  changed.setWeight(keys_.isChanged(entry) ? QFont::DemiBold : QFont::Normal);
  row.setFont(1, changed);
}

/// One group per menu, in menu order.
void ShortcutsPage::fill() {
  QFont bold = font();
  bold.setWeight(QFont::DemiBold);
  QTreeWidgetItem* group = nullptr;
  for (const KeyMap::Entry& entry : keys_.entries()) {
    if (group == nullptr || group->text(0) != entry.menu) {
      group = new QTreeWidgetItem(list_, {entry.menu});
      group->setFont(0, bold);
      group->setFlags(Qt::ItemIsEnabled);
      group->setExpanded(true);
    }
    fillRow(*new QTreeWidgetItem(group), entry);
  }
}

void ShortcutsPage::filter(const QString& text) {
  bool isAny = false;
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem& group = *list_->topLevelItem(i);
    bool isHere = false;
    for (int k = 0; k < group.childCount(); ++k) {
      QTreeWidgetItem& row = *group.child(k);
      const QString whole =
          row.text(0) + QLatin1Char('\n') + row.text(1) + QLatin1Char('\n') + row.text(2);
      row.setHidden(!whole.contains(text.trimmed(), Qt::CaseInsensitive));
      isHere = isHere || !row.isHidden();
    }
    group.setHidden(!isHere);
    isAny = isAny || isHere;
  }
  nothing_->setMatchFound(isAny);
}

const KeyMap::Entry* ShortcutsPage::selected() const {
  const QTreeWidgetItem* row = list_->currentItem();
  const QString id = row == nullptr ? QString() : idOf(*row);
  for (const KeyMap::Entry& entry : keys_.entries()) {
    if (!id.isEmpty() && entry.id == id) {
      return &entry;
    }
  }
  return nullptr;
}

void ShortcutsPage::showSelected() {
  const KeyMap::Entry* entry = selected();
  const bool isFree = entry != nullptr && !entry->isFixed;
  name_->setText(entry == nullptr ? tr("Select a command to change its keys")
                                  : tr("Keys for \"%1\"").arg(entry->name));
  field_->setKeys({});
  field_->setEnabled(isFree);
  remove_->setEnabled(isFree && !entry->action->shortcuts().isEmpty());
  usual_->setEnabled(isFree && keys_.isChanged(*entry));
  allUsual_->setEnabled(keys_.isAnyChanged());
  judge();
  if (entry != nullptr && entry->isFixed) {
    warning_->setText(tr("This key belongs to the active tool and cannot be changed."));
  }
}

/// What is wrong with the typed keys is shown before they are assigned.
void ShortcutsPage::judge() {
  const KeyMap::Entry* entry = selected();
  const QKeySequence typed = field_->keys();
  const QString against = KeyMap::reasonAgainst(typed);
  const KeyMap::Entry* owner = entry == nullptr ? nullptr : keys_.ownerOf(typed, entry->action);
  assign_->setEnabled(entry != nullptr && !typed.isEmpty() && against.isEmpty());
  warning_->setText(
      !against.isEmpty() ? against
      : owner != nullptr
          ? tr("%1 is used by \"%2\" (%3). Assigning removes it there.")
                .arg(typed.toString(QKeySequence::NativeText), owner->name, owner->menu)
          : QString());
}

void ShortcutsPage::assign() {
  const KeyMap::Entry* entry = selected();
  if (entry != nullptr && assign_->isEnabled()) {
    keys_.assign(*entry->action, field_->keys());
    list_->setFocus();
  }
}

ShortcutsDialog::ShortcutsDialog(KeyMap& keys, QWidget* parent)
    : QDialog(parent), page_(new ShortcutsPage(keys, this)) {
  setWindowTitle(tr("Keyboard shortcuts"));
  resize(kShortcutsSize.boundedTo(parent->size()));
  auto* layout = editor::configuredLayout(new QVBoxLayout(this), {12, 12, 12, 12}, 8);
  layout->addWidget(page_, 1);
  for (const QString& rule : KeyRules::rules()) {
    QLabel* words = editor::secondaryLabel(rule, this);
    words->setWordWrap(true);
    layout->addWidget(words);
  }
}

}  // namespace app
