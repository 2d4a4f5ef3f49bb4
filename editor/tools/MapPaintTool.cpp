#include "editor/tools/MapPaintTool.h"

#include <algorithm>
#include <array>

#include "editor/canvas/Layers.h"
#include "editor/canvas/MapScene.h"
#include "editor/tools/CrowdOptions.h"
#include "editor/tools/ToolRegistry.h"
#include "sim2d/base/Math.h"

namespace editor {

namespace {

constexpr std::array<MapPaint, 3> kPaints = {MapPaint::Occupied, MapPaint::Free, MapPaint::Unknown};
constexpr double kLeastWidth = 0.05;  // of the brush [m]
constexpr double kMostWidth = 5.0;

}  // namespace

QString MapPaintTool::statusText() const {
  if (document().map()->isEmpty()) {
    return tr("There is no map to paint on: begin with a room, a map or an image");
  }
  const QString paint = paint_ == MapPaint::Occupied ? tr("walls")
                        : paint_ == MapPaint::Free   ? tr("free ground")
                                                     : tr("unknown ground");
  return tr("Drag to paint %1, %2 m wide · 1 wall, 2 free, 3 unknown · [ ] width · Shift: free")
      .arg(paint)
      .arg(width_, 0, 'f', 2);
}

void MapPaintTool::setPaint(MapPaint paint) {
  paint_ = paint;
  Q_EMIT statusTextChanged();
}

void MapPaintTool::setWidth(double metres) {
  width_ = std::clamp(metres, kLeastWidth, kMostWidth);
  Q_EMIT statusTextChanged();
}

bool MapPaintTool::keyPress(const QKeyEvent& event) {
  switch (event.key()) {
    case Qt::Key_1:
    case Qt::Key_2:
    case Qt::Key_3:
      setPaint(kPaints.at(static_cast<std::size_t>(event.key() - Qt::Key_1)));
      return true;
    case Qt::Key_BracketLeft:
      setWidth(width_ - (width_ > 0.2 ? 0.1 : 0.05));
      return true;
    case Qt::Key_BracketRight:
      setWidth(width_ + (width_ < 0.2 ? 0.05 : 0.1));
      return true;
    default:
      return false;
  }
}

QWidget* MapPaintTool::makeOptions(QWidget* parent) {
  auto* row = new OptionsRow(parent);
  auto* paint = new ChoiceField(row);
  paint->addItems({tr("Wall"), tr("Free ground"), tr("Unknown")});  // in the order of kPaints
  paint->setAccessibleName(tr("What is painted"));
  row->add(tr("Paint"), paint);
  NumberField* width = addNumber(*row, tr("Width"), {kLeastWidth, kMostWidth, 2, 0.05}, tr("m"),
                                 width_, [this](double value) { setWidth(value); });
  connect(paint, qOverload<int>(&QComboBox::activated), this,
          [this](int at) { setPaint(kPaints.at(static_cast<std::size_t>(at))); });
  const auto follow = [this, paint, width] {
    paint->setCurrentIndex(
        static_cast<int>(std::find(kPaints.begin(), kPaints.end(), paint_) - kPaints.begin()));
    if (width->value() != width_) {
      width->show(width_, false);
    }
  };
  connect(this, &Tool::statusTextChanged, row, follow);
  follow();
  return row;
}

MapPaint MapPaintTool::paintFor(const CanvasMouse& mouse) const {
  return mouse.modifiers.testFlag(Qt::ShiftModifier) ? MapPaint::Free : paint_;
}

void MapPaintTool::press(const CanvasMouse& mouse) {
  cancel();
  if (mouse.button != Qt::LeftButton || document().map()->isEmpty()) {
    return;
  }
  stroke_.emplace(document().map());
  strokePaint_ = paintFor(mouse);
  way_ = {mouse.world};
  stroke_->paint(mouse.world, mouse.world, 0.5 * width_, strokePaint_);
  show(mouse.world);
}

void MapPaintTool::move(const CanvasMouse& mouse) {
  if (stroke_) {
    stroke_->paint(way_.back(), mouse.world, 0.5 * width_, strokePaint_);
    if (way_.back() != mouse.world) {
      way_.push_back(mouse.world);
    }
  }
  show(mouse.world);
}

void MapPaintTool::release(const CanvasMouse& mouse) {
  if (mouse.button != Qt::LeftButton || !stroke_) {
    return;
  }
  stroke_->paint(way_.back(), mouse.world, 0.5 * width_, strokePaint_);
  const MapStroke stroke = *std::move(stroke_);
  cancel();
  pushStroke(document(), stroke, tr("Paint the map"));
}

/// What the stroke covers so far, and the brush.
void MapPaintTool::show(const Vec2& at) {
  constexpr int kCorners = 24;
  ToolLine brush;
  brush.isClosed = true;
  brush.hasCorners = false;
  for (int corner = 0; corner < kCorners; ++corner) {
    const double angle = 2.0 * base::kPi * corner / kCorners;
    brush.points.emplace_back(at + 0.5 * width_ * Vec2(base::cos(angle), base::sin(angle)));
  }
  scene().toolLayer().setOutline(std::move(brush));
  scene().toolLayer().setStroke(way_, width_);
}

void MapPaintTool::cancel() {
  stroke_.reset();
  way_.clear();
  scene().toolLayer().clear();
}

void addMapPaintTool(ToolRegistry& to) {
  to.add<MapPaintTool>({140, QObject::tr("Paint map"), QStringLiteral("tool-map"), Qt::Key_I});
}

}  // namespace editor
