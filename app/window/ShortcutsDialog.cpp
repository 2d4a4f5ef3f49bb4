#include "app/window/ShortcutsDialog.h"

#include "app/window/KeyRules.h"
#include "app/window/WindowActions.h"
#include "editor/look/Form.h"
#include "editor/panels/RowDelegate.h"

namespace app {

namespace {

constexpr QSize kUsual(640, 560);
constexpr int kNameWidth = 200;
constexpr int kKeyWidth = 150;

/// The command name without menu mnemonics, undo texts and the tool's key.
QString nameOf(const QAction& action) {
  const QString lasting = action.property(WindowActions::kNameProperty).toString();
  return (lasting.isEmpty() ? action.text() : lasting)
      .section(QLatin1Char('\t'), 0, 0)
      .remove(QLatin1Char('&'))
      .remove(QChar(0x2026));
}

/// The keys of the command or of its tool; empty: none.
QString keysOf(const QAction& action) {
  const QString heard = action.text().section(QLatin1Char('\t'), 1);
  return heard.isEmpty() ? QKeySequence::listToString(action.shortcuts(), QKeySequence::NativeText)
                         : heard;
}

}  // namespace

ShortcutsDialog::ShortcutsDialog(const QMenuBar& menus, QWidget* parent)
    : QDialog(parent), search_(new QLineEdit(this)), list_(new QTreeWidget(this)) {
  setWindowTitle(tr("Keyboard shortcuts"));
  resize(kUsual.boundedTo(parent->size()));
  search_->setPlaceholderText(tr("Find a command or a key"));
  search_->setAccessibleName(tr("Find a command or a key"));
  search_->setClearButtonEnabled(true);
  editor::styleList(*list_, windowTitle());
  list_->setColumnCount(3);
  list_->setHeaderHidden(true);
  list_->header()->resizeSection(0, kNameWidth);
  list_->header()->resizeSection(1, kKeyWidth);
  QFont bold = font();
  bold.setWeight(QFont::DemiBold);
  for (const QAction* top : menus.actions()) {
    auto* group = new QTreeWidgetItem(list_, {nameOf(*top)});
    group->setFont(0, bold);
    addMenu(*group, *top->menu());
    group->setExpanded(true);
  }
  nothing_ = new editor::NoMatchesPlaceholder(*search_, *list_, this);
  auto* layout = editor::configuredLayout(new QVBoxLayout(this), {12, 12, 12, 12}, 8, {search_});
  layout->addWidget(list_, 1);
  layout->addWidget(nothing_, 1);
  for (const QString& rule : KeyRules::rules()) {
    QLabel* words = editor::secondaryLabel(rule, this);
    words->setWordWrap(true);
    layout->addWidget(words);
  }
  connect(search_, &QLineEdit::textChanged, this, &ShortcutsDialog::filter);
  filter({});
}

void ShortcutsDialog::addMenu(QTreeWidgetItem& group, const QMenu& menu) {
  for (const QAction* action : menu.actions()) {
    if (action->menu() != nullptr) {
      addMenu(group, *action->menu());
    } else if (const QString keys = keysOf(*action); !keys.isEmpty()) {
      auto* row = new QTreeWidgetItem(&group, {nameOf(*action), keys, action->statusTip()});
      row->setToolTip(2, action->statusTip());
    }
  }
}

void ShortcutsDialog::filter(const QString& text) {
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

}  // namespace app
