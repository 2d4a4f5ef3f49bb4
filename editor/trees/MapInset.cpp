#include "editor/trees/MapInset.h"

#include <algorithm>

#include <QtWidgets>

namespace editor {

namespace {

constexpr double kMinScale = 24.0, kMaxScale = 60.0;  // [px/m]
constexpr double kInsetRadius = 6.0;

}  // namespace

MapInset::MapInset(MapScene& scene, SimulationRunner& runner, QWidget* parent)
    : QWidget(parent), scene_(scene), runner_(runner) {
  resize(kSize);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAccessibleName(tr("The map around the person"));
  connect(&scene_, &QGraphicsScene::changed, this, qOverload<>(&QWidget::update));
  connect(&runner_, &SimulationRunner::frameShown, this, qOverload<>(&QWidget::update));
}

void MapInset::follow(EntityId person) {
  person_ = person;
  update();
}

std::optional<Vec2> MapInset::centre() const {
  const sim2d::Human* human = scene_.document().human(person_);
  if (human == nullptr) {
    return std::nullopt;
  }
  if (const FramePtr frame = runner_.shownFrame()) {
    const std::vector<int>& ids = frame->humans.id;
    const auto found = std::find(ids.begin(), ids.end(), human->id);
    if (found != ids.end()) {
      const auto row = static_cast<std::size_t>(found - ids.begin());
      return Vec2(frame->humans.x[row], frame->humans.y[row]);
    }
  }
  return human->initPose.position;
}

void MapInset::paintEvent(QPaintEvent* /*event*/) {
  const std::optional<Vec2> at = centre();
  if (!at) {
    return;
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  QPainterPath shape;
  shape.addRoundedRect(frame, kInsetRadius, kInsetRadius);
  painter.setClipPath(shape);
  painter.fillRect(rect(), scene_.groundColor());
  // The sizes of labels and lines correspond to the zoom of the main map.
  const double scale = std::clamp(scene_.pixelsPerMetre(), kMinScale, kMaxScale);
  painter.save();
  painter.translate(frame.center());
  painter.scale(scale, scale);
  painter.translate(-toScene(*at));
  const QSizeF seen = QSizeF(frame.size()) / scale;
  scene_.paintPart(painter, CanvasPart::All,
                   QRectF(toScene(*at) - QPointF(0.5 * seen.width(), 0.5 * seen.height()), seen));
  painter.restore();
  painter.setClipping(false);
  painter.setPen(QPen(scene_.theme().color(Role::FieldEdge), 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(shape);
}

}  // namespace editor
