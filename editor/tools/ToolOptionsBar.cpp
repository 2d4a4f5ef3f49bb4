#include "editor/tools/ToolOptionsBar.h"

#include <QHBoxLayout>

#include "editor/canvas/Overlays.h"

namespace editor {

namespace {

constexpr int kGapPx = 12;
constexpr int kPadPx = 8;

}  // namespace

ToolOptionsBar::ToolOptionsBar(ToolManager& tools, MapView& view) : QWidget(&view), view_(view) {
  setAccessibleName(tr("Options of the tool"));
  setCursor(Qt::ArrowCursor);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(kPadPx + 4, kPadPx, kPadPx + 4, kPadPx);
  layout->setSizeConstraint(QLayout::SetFixedSize);
  connect(&tools, &ToolManager::currentChanged, this, &ToolOptionsBar::showFor);
  connect(&view.mapScene(), &MapScene::optionsChanged, this, &ToolOptionsBar::place);
  connect(&view.mapScene(), &MapScene::themeChanged, this, qOverload<>(&QWidget::update));
  showFor(tools.current());
}

void ToolOptionsBar::showFor(Tool* tool) {
  if (row_ != nullptr) {
    layout()->removeWidget(row_);
    row_->hide();
  }
  const auto [found, isNew] = rows_.try_emplace(tool, nullptr);
  if (isNew && tool != nullptr) {
    found->second = tool->makeOptions(this);
  }
  row_ = found->second;
  setVisible(row_ != nullptr);
  if (row_ != nullptr) {
    layout()->addWidget(row_);
    row_->show();
    place();
    raise();
  }
}

void ToolOptionsBar::place() {
  const int left = kGapPx + (view_.mapScene().options().rulers ? kRulerPx : 0);
  move(left, left);
}

void ToolOptionsBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintPlate(painter, view_.mapScene().theme(), QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

}  // namespace editor
