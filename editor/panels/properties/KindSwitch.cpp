#include "editor/panels/properties/KindSwitch.h"

#include "editor/look/Form.h"

namespace editor {

namespace {

constexpr int kButtonColumns = 3;  // The longest text, "12 obstacles", fits a third of the panel.

/// The kinds in the order of the scenario list.
constexpr EntityKind kSwitchKinds[] = {EntityKind::Human,    EntityKind::Goal, EntityKind::Robot,
                                       EntityKind::Obstacle, EntityKind::Door, EntityKind::Area,
                                       EntityKind::Dock};

}  // namespace

QString kindText(EntityKind kind, std::size_t count) {
  const QString one = kindName(kind);
  return count == 1 ? one : counted(count, one, kindNamePlural(kind));
}

KindSwitch::KindSwitch(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  setAccessibleName(tr("Selected kinds"));
  grid_->setContentsMargins(12, 0, 12, 12);
  grid_->setSpacing(4);
  for (int column = 0; column < kButtonColumns; ++column) {
    grid_->setColumnStretch(column, 1);
  }
  auto* group = new QButtonGroup(this);
  for (const EntityKind kind : kSwitchKinds) {
    auto* button = new QPushButton(this);
    button->setCheckable(true);
    button->setAutoDefault(false);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    button->setToolTip(tr("Show and change the selected items of this kind"));
    group->addButton(button);
    buttons_[kind] = button;
    connect(button, &QPushButton::clicked, this, [this, kind] { choose(kind); });
  }
  hide();
}

void KindSwitch::choose(EntityKind kind) {
  byUser_ = kind;
  Q_EMIT chosen();
}

EntityKind KindSwitch::setSelection(const std::vector<EntityId>& selection) {
  std::map<EntityKind, std::size_t> counts;
  for (const EntityId id : selection) {
    ++counts[id.kind];
  }
  if (counts.count(byUser_) == 0) {
    byUser_ = EntityKind::None;
  }
  const auto* const first = std::find_if(std::begin(kSwitchKinds), std::end(kSwitchKinds),
                                         [&](EntityKind kind) { return counts.count(kind) > 0; });
  const EntityKind current = byUser_ != EntityKind::None       ? byUser_
                             : first != std::end(kSwitchKinds) ? *first
                                                               : selection.front().kind;
  int place = 0;
  for (const EntityKind kind : kSwitchKinds) {
    QPushButton* button = buttons_.at(kind);
    const auto found = counts.find(kind);
    grid_->removeWidget(button);
    button->setVisible(found != counts.end());
    if (found != counts.end()) {
      button->setText(kindText(kind, found->second));
      button->setChecked(kind == current);
      grid_->addWidget(button, place / kButtonColumns, place % kButtonColumns);
      ++place;
    }
  }
  setVisible(counts.size() > 1);
  return current;
}

}  // namespace editor
