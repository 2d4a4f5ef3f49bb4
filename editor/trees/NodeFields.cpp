#include "editor/trees/NodeFields.h"

#include <algorithm>
#include <utility>

#include "editor/panels/behavior/BehaviorDialogs.h"
#include "editor/panels/behavior/TreeOutline.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

constexpr int kPortFieldWidth = 168;  // [px]
constexpr int kFrameRadius = 6;
constexpr int kWindowMargin = 8;

enum FieldColumn { LabelColumn, ValueColumn, UnitColumn };

}  // namespace

NodeFields::NodeFields(QWidget& canvas, const Theme& theme)
    : QFrame(&canvas), canvas_(canvas), theme_(theme) {
  hide();
  configuredLayout(new QVBoxLayout(this), {12, 8, 12, 8}, 6);
  setAccessibleName(tr("Name and ports of the node"));
  connect(qApp, &QApplication::focusChanged, this,
          [this](const QWidget* /*before*/, const QWidget* now) { closeIfLeft(now); });
}

void NodeFields::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

void NodeFields::open(const bt::NodeSpec& node, const QRect& place) {
  close(true);
  node_ = node;
  rows_.clear();
  delete std::exchange(body_, new QWidget(this));
  grid_ = configuredLayout(new QGridLayout(body_), {}, 6);
  grid_->addWidget(headingLabel(QString::fromStdString(node.isSubTree() ? node.subTree : node.id),
                                theme_.font(9.5, QFont::DemiBold), body_),
                   0, LabelColumn, 1, 3);
  Row name{{}, new TextField(body_), {}};
  name.field->show(QString::fromStdString(node.name));
  name.field->setPlaceholderText(nodeTitle(node));
  addRow(tr("Name"), {}, std::move(name));
  for (const ValueRow& each : portRows(node, true).rows) {
    Row row{each.key, new TextField(body_), each.check};
    row.field->setHint(QString(each.help).remove(QStringLiteral("\n%1")));
    row.field->setPlaceholderText(QString::fromStdString(each.defaultText.value_or("")));
    row.field->setCheck(each.check);
    row.field->show(QString::fromStdString(each.text));
    addRow(each.label, each.unit, std::move(row));
  }
  QLabel* keys = secondaryLabel(tr("Enter applies, Esc cancels"), body_);
  grid_->addWidget(keys, grid_->rowCount(), LabelColumn, 1, 3, Qt::AlignRight);
  layout()->addWidget(body_);
  setParent(canvas_.window());
  body_->show();
  adjustSize();
  moveTo(place);
  show();
  raise();
  moveFocus(rows_.size() > 1 ? 2 : 1);  // The first port, else the name.
}

void NodeFields::addRow(const QString& label, const QString& unit, Row row) {
  const int at = grid_->rowCount();
  QLabel* words = secondaryLabel(label, body_);
  words->setBuddy(row.field);
  grid_->addWidget(words, at, LabelColumn, Qt::AlignRight | Qt::AlignVCenter);
  grid_->addWidget(row.field, at, ValueColumn);
  grid_->addWidget(secondaryLabel(unit, body_), at, UnitColumn);
  row.field->setMinimumWidth(kPortFieldWidth);
  row.field->setAccessibleName(label);
  row.field->installEventFilter(this);
  rows_.push_back(std::move(row));
}

/// Within the window, because a small dock is lower than the fields.
void NodeFields::moveTo(const QRect& place) {
  const QWidget* window = canvas_.window();
  const QRect room =
      window->rect().adjusted(kWindowMargin, kWindowMargin, -kWindowMargin, -kWindowMargin);
  const QPoint corner = canvas_.mapTo(window, place.topLeft());
  move(std::max(room.left(), std::min(corner.x(), room.right() - width())),
       std::max(room.top(), std::min(corner.y(), room.bottom() - height())));
}

void NodeFields::close(bool apply) {
  if (!isOpen()) {
    return;
  }
  bt::NodeSpec edited = node_;
  for (const Row& row : rows_) {
    const std::string text = row.field->text().trimmed().toStdString();
    const bool isValid = !row.check || row.check(row.field->text()).isEmpty();
    if (row.key.empty()) {
      edited.name = text;
    } else if (const std::string* before = bt::findAttribute(node_.ports, row.key);
               isValid && text != (before == nullptr ? std::string() : *before)) {
      text.empty() ? bt::removeAttribute(edited.ports, row.key)
                   : bt::setAttribute(edited.ports, row.key, text);
    }
  }
  hide();
  setParent(&canvas_);  // Belongs to the canvas again, even if the dock moves to another window.
  if (apply && (edited.name != node_.name || !(edited.ports == node_.ports))) {
    Q_EMIT applied(edited);
  }
}

TextField* NodeFields::field(const std::string& key) const {
  const auto row =
      std::find_if(rows_.begin(), rows_.end(), [&key](const Row& each) { return each.key == key; });
  return row == rows_.end() ? nullptr : row->field;
}

int NodeFields::focusedRow() const {
  const auto row = std::find_if(rows_.begin(), rows_.end(),
                                [](const Row& each) { return each.field->hasFocus(); });
  return row == rows_.end() ? -1 : static_cast<int>(row - rows_.begin());
}

/// From the last field to the first and back.
void NodeFields::moveFocus(int by) {
  const int count = static_cast<int>(rows_.size());
  const int row = (focusedRow() + by + count) % count;
  TextField& field = *rows_[static_cast<std::size_t>(row)].field;
  field.setFocus(Qt::TabFocusReason);
  field.selectAll();
}

int NodeFields::invalidRow() const {
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const QString text = rows_[k].field->text();
    const std::string* before = bt::findAttribute(node_.ports, rows_[k].key);
    const bool isChanged = text.toStdString() != (before == nullptr ? std::string() : *before);
    if (rows_[k].check && isChanged && !rows_[k].check(text).isEmpty()) {
      return static_cast<int>(k);
    }
  }
  return -1;
}

bool NodeFields::handleKey(const QKeyEvent& event) {
  const int key = event.key();
  if (key == Qt::Key_Tab || key == Qt::Key_Backtab) {
    moveFocus(key == Qt::Key_Tab ? 1 : -1);
    return true;
  }
  const bool isEnter = key == Qt::Key_Return || key == Qt::Key_Enter;
  if (!isEnter && key != Qt::Key_Escape) {
    return false;
  }
  const int invalid = isEnter ? invalidRow() : -1;
  if (invalid >= 0) {
    rows_[static_cast<std::size_t>(invalid)].field->setFocus();
  } else {
    close(isEnter);
    canvas_.setFocus();
  }
  return true;
}

bool NodeFields::eventFilter(QObject* watched, QEvent* event) {
  const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
  if (!isOpen() || !isKey) {
    return QFrame::eventFilter(watched, event);
  }
  const auto& key = static_cast<const QKeyEvent&>(*event);
  if (event->type() == QEvent::KeyPress) {
    return handleKey(key) || QFrame::eventFilter(watched, event);
  }
  const int keys[] = {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Escape, Qt::Key_Tab, Qt::Key_Backtab};
  if (std::find(std::begin(keys), std::end(keys), key.key()) != std::end(keys)) {
    event->accept();  // Not a shortcut of the window.
    return true;
  }
  return QFrame::eventFilter(watched, event);
}

void NodeFields::closeIfLeft(const QWidget* focused) {
  const bool isInside =
      focused == nullptr || isAncestorOf(focused) || focused->window()->windowType() == Qt::Popup;
  if (isOpen() && !isInside) {
    close(true);
  }
}

void NodeFields::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), theme_.color(Role::Window));
  painter.setPen(QPen(theme_.color(Role::Accent), 1.5));
  painter.setBrush(theme_.color(Role::Panel));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), kFrameRadius, kFrameRadius);
}

}  // namespace editor
