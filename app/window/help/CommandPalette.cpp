#include "app/window/help/CommandPalette.h"

#include <algorithm>

#include "editor/look/DeferredActions.h"
#include "editor/panels/RowDelegate.h"

namespace app {

using editor::Role;

namespace {

constexpr QSize kPaletteSize(640, 440);
constexpr int kPaletteTop = 72;  // [px] below the upper edge of the window
constexpr int kPaletteRow = 30;
constexpr int kPaletteIcon = 18;
constexpr int kPalettePad = 12;
constexpr int kUsedFirst = 5;             // commands used before that come first
constexpr int kIndexRole = Qt::UserRole;  // of the command

/// Icon, name with its menus, and key; unavailable commands in the secondary colour.
class PaletteDelegate : public QStyledItemDelegate {
 public:
  PaletteDelegate(const editor::Theme& theme, QObject* parent)
      : QStyledItemDelegate(parent), theme_(theme) {}
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    return {QStyledItemDelegate::sizeHint(option, index).width(), kPaletteRow};
  }
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    const bool isOff = !index.data(CommandPalette::kReasonRole).toString().isEmpty();
    const QWidget* widget = option.widget;
    widget->style()->drawPrimitive(QStyle::PE_PanelItemViewItem, &option, painter, widget);
    QRect room = option.rect.adjusted(kPalettePad, 0, -kPalettePad, 0);
    painter->save();
    const QIcon icon = index.data(Qt::DecorationRole).value<QIcon>();
    icon.paint(painter,
               QRect(room.left(), room.center().y() - kPaletteIcon / 2, kPaletteIcon, kPaletteIcon),
               Qt::AlignCenter, isOff ? QIcon::Disabled : QIcon::Normal);
    room.setLeft(room.left() + kPaletteIcon + kPalettePad);
    painter->setFont(theme_.font(9.0));
    painter->setPen(theme_.color(Role::TextSecondary));
    const QString keys = index.data(CommandPalette::kKeysRole).toString();
    painter->drawText(room, Qt::AlignRight | Qt::AlignVCenter, keys);
    const int used = painter->fontMetrics().horizontalAdvance(keys) + kPalettePad;
    room.setRight(room.right() - used);
    painter->setFont(theme_.font(9.5, isOff ? QFont::Normal : QFont::Medium));
    painter->setPen(theme_.color(isOff ? Role::TextSecondary : Role::Text));
    const QString name = index.data(Qt::DisplayRole).toString();
    painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                      painter->fontMetrics().elidedText(name, Qt::ElideRight, room.width()));
    room.setLeft(room.left() + painter->fontMetrics().horizontalAdvance(name) + kPalettePad);
    painter->setFont(theme_.font(9.0));
    painter->setPen(theme_.color(Role::TextSecondary));
    const QString path = index.data(CommandPalette::kPathRole).toString();
    painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                      painter->fontMetrics().elidedText(path, Qt::ElideRight, room.width()));
    painter->restore();
  }

 private:
  const editor::Theme& theme_;  // of the palette
};

/// Why a command is not available; empty: it is.
QString whyDisabled(const QAction& action) {
  if (action.isEnabled()) {
    return {};
  }
  const QString known = action.property(editor::kWhyDisabledProperty).toString();
  return known.isEmpty() ? CommandPalette::tr("Not available at the moment") : known;
}

bool containsWords(const QString& text, const QString& typed) {
  const QStringList words = typed.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  return std::all_of(words.begin(), words.end(), [&text](const QString& word) {
    return text.contains(word, Qt::CaseInsensitive);
  });
}

/// Letters may be scattered in the name only; in the menus they would match nearly everything.
std::optional<int> pointsOf(const Command& command, const QString& typed) {
  constexpr int kKey = 1000000;
  constexpr int kName = 1000;  // a match in the name is better than one with its menus
  const QString keys = commandKeys(*command.action);
  if (!keys.isEmpty() && keys.compare(typed.trimmed(), Qt::CaseInsensitive) == 0) {
    return kKey;
  }
  if (const std::optional<int> points = fuzzyScore(typed, command.name)) {
    return *points + kName;
  }
  const QString menus = command.path + QLatin1Char(' ') + command.name;
  return containsWords(menus, typed) ? std::optional<int>(0) : std::nullopt;
}

/// By the explanation of the command; for a text that no name matches.
std::optional<int> pointsOfExplanation(const Command& command, const QString& typed) {
  static const QRegularExpression kTag(QStringLiteral("<[^>]*>"));
  const QString text = command.action->whatsThis().replace(kTag, QStringLiteral(" "));
  return containsWords(text, typed) ? std::optional<int>(0) : std::nullopt;
}

struct CommandMatch {
  int points = 0;
  bool isAvailable = false;
  std::size_t index = 0;
};

/// Available commands first, best match first; equal ones in menu order.
std::vector<CommandMatch> matchesOf(
    const std::vector<Command>& commands,
    const std::function<std::optional<int>(const Command& command)>& pointsOfCommand) {
  std::vector<CommandMatch> matches;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (commands[i].action == nullptr) {
      continue;  // removed since the palette was opened
    }
    if (const std::optional<int> points = pointsOfCommand(commands[i])) {
      matches.push_back({*points, commands[i].action->isEnabled(), i});
    }
  }
  std::stable_sort(matches.begin(), matches.end(),
                   [](const CommandMatch& a, const CommandMatch& b) {
                     return a.isAvailable != b.isAvailable ? a.isAvailable : a.points > b.points;
                   });
  return matches;
}

}  // namespace

CommandPalette::CommandPalette(const QMenuBar& menus, const editor::Theme& theme, QWidget* parent)
    : QDialog(parent, Qt::Popup | Qt::FramelessWindowHint),
      menus_(menus),
      theme_(theme),
      search_(new editor::SearchField(tr("Type a command or a key"), tr("Find a command"), this)) {
  setWindowTitle(tr("Commands"));
  setAccessibleName(windowTitle());
  editor::styleList(*list_, tr("Commands"));
  list_->setItemDelegate(new PaletteDelegate(theme_, list_));
  list_->setUniformItemSizes(true);
  list_->setFocusPolicy(Qt::NoFocus);  // the field keeps the focus and passes on the cursor keys
  reason_->setWordWrap(true);
  reason_->setContentsMargins(4, 0, 4, 0);
  nothing_ = new editor::NoMatchesPlaceholder(*search_, *list_, this);
  auto* layout = editor::configuredLayout(new QVBoxLayout(this), {8, 8, 8, 8}, 6, {search_});
  layout->addWidget(list_, 1);
  layout->addWidget(nothing_, 1);
  layout->addWidget(reason_);
  search_->installEventFilter(this);
  connect(search_, &QLineEdit::textChanged, this, &CommandPalette::fill);
  connect(list_, &QListWidget::itemClicked, this, &CommandPalette::run);
  connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* row) {
    const QString reason = row == nullptr ? QString() : row->data(kReasonRole).toString();
    reason_->setText(reason.isEmpty() && row != nullptr ? row->toolTip() : reason);
  });
  setTheme(theme);
}

void CommandPalette::setTheme(const editor::Theme& theme) {
  theme_ = theme;
  search_->setTheme(theme);
}

void CommandPalette::open() {
  commands_ = commandsOf(menus_, true);
  search_->clear();
  fill();
  const QWidget& window = *parentWidget();
  resize(kPaletteSize.boundedTo(window.size() - QSize(32, kPaletteTop + 16)));
  move(window.mapToGlobal(QPoint((window.width() - width()) / 2, kPaletteTop)));
  show();
  activateWindow();
  search_->setFocus(Qt::PopupFocusReason);
}

void CommandPalette::addRow(std::size_t index) {
  const Command& command = commands_[index];
  auto* row = new QListWidgetItem(command.action->icon(), command.name, list_);
  const QString reason = whyDisabled(*command.action);
  row->setData(kIndexRole, QVariant::fromValue(index));
  row->setData(kReasonRole, reason);
  row->setData(kKeysRole, commandKeys(*command.action));
  row->setData(kPathRole, command.path);
  const bool isOn = command.action->isCheckable() && command.action->isChecked();
  row->setData(Qt::AccessibleTextRole,
               QStringList({command.name, command.path, commandKeys(*command.action),
                            isOn ? tr("on") : QString(), reason})
                   .filter(QRegularExpression(QStringLiteral(".")))
                   .join(QStringLiteral(", ")));
  row->setToolTip(command.action->statusTip());
}

void CommandPalette::fill() {
  const QString typed = search_->text();
  std::vector<CommandMatch> matches = matchesOf(commands_, [&](const Command& command) {
    std::optional<int> points = pointsOf(command, typed);
    const int before = used_.indexOf(command.action);
    if (points && typed.isEmpty() && before >= 0 && before < kUsedFirst) {
      *points += kUsedFirst - before;
    }
    return points;
  });
  if (matches.empty()) {
    matches = matchesOf(commands_, [&typed](const Command& command) {
      return pointsOfExplanation(command, typed);
    });
  }
  list_->clear();
  for (const CommandMatch& match : matches) {
    addRow(match.index);
  }
  list_->setCurrentRow(0);
  nothing_->setMatchFound(!matches.empty());
  reason_->setVisible(!matches.empty());
}

/// The command runs after the palette has closed, because it may open a dialog.
void CommandPalette::run(QListWidgetItem* row) {
  if (row == nullptr || !row->data(kReasonRole).toString().isEmpty()) {
    return;  // the reason is shown below the list
  }
  const QPointer<QAction> action = commands_[row->data(kIndexRole).value<std::size_t>()].action;
  used_.removeAll(action);
  used_.prepend(action);
  hide();
  editor::later(*parentWidget(), [action] {
    if (action) {
      action->trigger();
    }
  });
}

/// A popup has no frame of its own.
void CommandPalette::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setPen(theme_.color(Role::FieldEdge));
  painter.setBrush(theme_.color(Role::Panel));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (watched != search_ || event->type() != QEvent::KeyPress) {
    return QDialog::eventFilter(watched, event);
  }
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp ||
      key == Qt::Key_PageDown) {
    QCoreApplication::sendEvent(list_, event);
    return true;
  }
  if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    run(list_->currentItem());
    return true;
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace app
