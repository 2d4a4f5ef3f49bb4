#include <array>

#include "editor/document/MapEdit.h"
#include "editor/tools/ToolOptionFields.h"
#include "editor/tools/ToolRegistry.h"
#include "sim2d/base/Math.h"

namespace editor {

namespace {

constexpr std::array<MapPaint, 3> kPaints = {MapPaint::Occupied, MapPaint::Free, MapPaint::Unknown};
constexpr double kMinBrush = 0.05;  // Brush width [m].
constexpr double kMaxBrush = 5.0;

/// Paints map cells as wall, free or unknown; one command per stroke. Shift paints free cells
/// regardless of the choice; 1, 2 and 3 choose, brackets change the brush width.
class MapPaintTool : public Tool {
  Q_DECLARE_TR_FUNCTIONS(editor::MapPaintTool)
 public:
  using Tool::Tool;

  QString statusText() const override {
    if (document().map()->isEmpty()) {
      return tr("No map to paint on: start with a room, a map or an image");
    }
    const QStringList grounds = {tr("walls"), tr("free space"), tr("unknown space")};
    return tr("Drag to paint %1, %2 m wide · 1 wall, 2 free, 3 unknown · [ ] width · Shift: free")
        .arg(grounds[paint_])
        .arg(width_, 0, 'f', 2);
  }

  bool keyPress(const QKeyEvent& event) override {
    const int paint = event.key() - Qt::Key_1;
    if (paint >= 0 && paint < static_cast<int>(kPaints.size())) {
      setPaint(paint);
    } else if (event.key() == Qt::Key_BracketLeft) {
      setWidth(width_ - (width_ > 0.2 ? 0.1 : 0.05));
    } else if (event.key() == Qt::Key_BracketRight) {
      setWidth(width_ + (width_ < 0.2 ? 0.05 : 0.1));
    } else {
      return false;
    }
    return true;
  }

  QWidget* makeOptions(QWidget* parent) override {
    auto* row = new OptionsRow(parent);
    const QStringList words = {tr("Wall"), tr("Free space"), tr("Unknown")};  // As in kPaints.
    ChoiceField* paint =
        addChoice(*row, tr("Paint"), words, paint_, [this](int index) { setPaint(index); });
    paint->setAccessibleName(tr("Cell type"));
    NumberField* width = addNumber(*row, tr("Width"), {kMinBrush, kMaxBrush, 2, 0.05}, tr("m"),
                                   width_, [this](double value) { setWidth(value); });
    connect(this, &Tool::statusTextChanged, row, [this, paint, width] {
      paint->setCurrentIndex(paint_);
      if (width->value() != width_) {
        width->show(width_, false);
      }
    });
    return row;
  }

  void pressOther(Qt::MouseButton) override { cancel(); }
  void press(const CanvasMouse& mouse) override {
    cancel();
    if (document().map()->isEmpty()) {
      return;
    }
    stroke_.emplace(document().map());
    const bool isFree = mouse.modifiers.testFlag(Qt::ShiftModifier);
    strokePaint_ = isFree ? MapPaint::Free : kPaints.at(static_cast<std::size_t>(paint_));
    way_ = {mouse.world};
    paintTo(mouse.world);
    show(mouse.world);
  }

  void move(const CanvasMouse& mouse) override {
    if (stroke_) {
      paintTo(mouse.world);
      if (way_.back() != mouse.world) {
        way_.push_back(mouse.world);
      }
    }
    show(mouse.world);
  }

  void release(const CanvasMouse& mouse) override {
    if (stroke_) {
      paintTo(mouse.world);
      const MapStroke stroke = *std::move(stroke_);
      cancel();
      pushStroke(document(), stroke, tr("Paint the map"));
    }
  }

  void cancel() override {
    stroke_.reset();
    way_.clear();
    marks() = {};
  }

 private:
  void setPaint(int index) {
    paint_ = index;
    Q_EMIT statusTextChanged();
  }

  void setWidth(double metres) {
    width_ = std::clamp(metres, kMinBrush, kMaxBrush);
    Q_EMIT statusTextChanged();
  }

  void paintTo(const Vec2& at) { stroke_->paint(way_.back(), at, 0.5 * width_, strokePaint_); }

  /// Shows the current stroke and the brush.
  void show(const Vec2& at) {
    constexpr int kCircleCorners = 24;
    ToolLine brush;
    brush.isClosed = true;
    brush.hasCorners = false;
    for (int corner = 0; corner < kCircleCorners; ++corner) {
      const double angle = 2.0 * base::kPi * corner / kCircleCorners;
      brush.points.emplace_back(at + 0.5 * width_ * Vec2(base::cos(angle), base::sin(angle)));
    }
    marks().outline = std::move(brush);
    marks().stroke = way_;
    marks().strokeWidth = width_;
  }

  int paint_ = 0;                    // Index in kPaints.
  double width_ = 0.2;               // Brush width [m].
  std::optional<MapStroke> stroke_;  // Exists during a gesture.
  MapPaint strokePaint_ = MapPaint::Occupied;
  std::vector<Vec2> way_;
};

}  // namespace

void addMapPaintTool(ToolRegistry& to) {
  to.add<MapPaintTool>({140, QObject::tr("Paint map"), QStringLiteral("tool-map"), Qt::Key_I});
}

}  // namespace editor
