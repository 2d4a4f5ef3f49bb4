#include "editor/canvas/MapView.h"

#include <cmath>
#include <limits>

#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/Layers.h"
#include "editor/canvas/LegendStrip.h"
#include "editor/canvas/ViewOverlays.h"

namespace editor {

namespace {

constexpr double kClosest = 800.0;  // [px/m]
constexpr double kFarthest = 0.25;
constexpr double kWheelFactor = 1.0015;  // Per eighth of a degree.
constexpr int kFitMs = 120;
constexpr int kFitMarginPx = 32;
constexpr double kMostFitted = 200.0;  // Largest scale of a fit [px/m].
constexpr int kSettleMs = 120;         // After the last movement of the view.
constexpr int kPictureMargin = 160;    // [px]
constexpr double kMaxBlur = 1.6;       // Maximum scale ratio of window and picture, both ways.

}  // namespace

bool CanvasCache::fits(const MapScene& scene, const Window& window, bool exactly) const {
  if (pixmap_.isNull() || revision_ != scene.restingRevision() ||
      pixmap_.devicePixelRatio() != window.ratio || moving_ != scene.movingIds()) {
    return false;
  }
  if (exactly) {
    return window.fromScene * QTransform::fromTranslate(margin_, margin_) == fromScene_;
  }
  const double scale = window.fromScene.m11() / fromScene_.m11();
  const QRectF seen =
      (window.fromScene.inverted() * fromScene_).mapRect(QRectF(QPointF(), window.size));
  const QRectF whole(QPointF(), QSizeF(pixmap_.size()) / window.ratio);
  return scale < kMaxBlur && scale > 1.0 / kMaxBlur && whole.contains(seen);
}

void CanvasCache::take(MapScene& scene, const Window& window, int margin) {
  const QSize size = window.size + QSize(2 * margin, 2 * margin);
  margin_ = margin;
  revision_ = scene.restingRevision();
  moving_ = scene.movingIds();
  fromScene_ = window.fromScene * QTransform::fromTranslate(margin, margin);
  pixmap_ = QPixmap(size * window.ratio);
  pixmap_.setDevicePixelRatio(window.ratio);
  pixmap_.fill(scene.groundColor());
  QPainter painter(&pixmap_);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  painter.setTransform(fromScene_);
  scene.paintPart(painter, CanvasPart::Resting,
                  fromScene_.inverted().mapRect(QRectF(QPointF(), size)));
}

void CanvasCache::draw(QPainter& painter, const Window& window) const {
  const QTransform toWindow = fromScene_.inverted() * window.fromScene;
  painter.save();
  painter.setTransform(toWindow);
  painter.setRenderHint(QPainter::SmoothPixmapTransform, toWindow.type() > QTransform::TxTranslate);
  painter.drawPixmap(QPointF(), pixmap_);
  painter.restore();
}

MapView::MapView(MapScene& scene, QWidget* parent) : QGraphicsView(&scene, parent), scene_(scene) {
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
  setOptimizationFlags(QGraphicsView::DontSavePainterState |
                       QGraphicsView::DontAdjustForAntialiasing);
  setTransformationAnchor(QGraphicsView::NoAnchor);
  setResizeAnchor(QGraphicsView::NoAnchor);
  setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  setMouseTracking(true);
  viewport()->setMouseTracking(true);
  setMinimumSize(320, 120);
  legend_ = new LegendStrip(*this);
  legend_->hide();
  setAccessibleName(tr("Map"));
  fitAnimation_.setDuration(kFitMs);
  fitAnimation_.setEasingCurve(QEasingCurve::OutCubic);
  fitAnimation_.setStartValue(0.0);
  fitAnimation_.setEndValue(1.0);
  connect(&fitAnimation_, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
    const double part = value.toDouble();
    const double scale =
        animationFrom_.scale * std::pow(animationTo_.scale / animationFrom_.scale, part);
    restartSettleTimer();
    applyView(animationFrom_.centre + part * (animationTo_.centre - animationFrom_.centre), scale);
  });
  settleTimer_.setSingleShot(true);
  settleTimer_.setInterval(kSettleMs);
  connect(&settleTimer_, &QTimer::timeout, viewport(), qOverload<>(&QWidget::update));
  // QGraphicsView requests no further repaints until its own paintEvent() has run, which is skipped
  // while a cached picture is shown.
  connect(&scene_, &QGraphicsScene::changed, viewport(), [this] { viewport()->update(); });
  connect(&scene_, &MapScene::optionsChanged, this, [this] { viewport()->update(); });
  connect(&scene_, &MapScene::themeChanged, this, [this] { viewport()->update(); });
  connect(&scene_, &QGraphicsScene::changed, this, &MapView::placeLegend);
  connect(&scene_, &MapScene::optionsChanged, this, &MapView::placeLegend);
  connect(&scene_, &MapScene::themeChanged, this, &MapView::placeLegend);
  connect(this, &MapView::zoomChanged, this, &MapView::placeLegend);
  connect(&scene_.document(), &ScenarioDocument::mapChanged, this, &MapView::fitNewMap);
  applyView({}, scene_.pixelsPerMetre());
}

void MapView::applyView(const QPointF& centre, double pixelsPerMetre) {
  setTransform(QTransform::fromScale(pixelsPerMetre, pixelsPerMetre));
  centerOn(centre);
  scene_.setPixelsPerMetre(pixelsPerMetre);
  Q_EMIT zoomChanged(pixelsPerMetre);
}

void MapView::moveTo(const ViewCentre& place, bool animated) {
  fitAnimation_.stop();
  if (!animated || !isAnimated_ || !isVisible()) {
    applyView(place.centre, place.scale);
    return;
  }
  animationFrom_ = {sceneCentre(), pixelsPerMetre()};
  animationTo_ = place;
  fitAnimation_.start();
}

void MapView::fitAll(bool animated) {
  fitted_ = true;
  const QRectF content = scene_.contentRect();
  const int covered = std::max(0, coveredTop_ - kFitMarginPx / 2);
  const QSizeF room = viewport()->size() - QSize(2 * kFitMarginPx, 2 * kFitMarginPx + covered);
  if (content.isEmpty() || room.width() < 1.0 || room.height() < 1.0) {
    return;
  }
  const double scale = std::min(room.width() / content.width(), room.height() / content.height());
  const double shown = std::clamp(scale, kFarthest, kMostFitted);
  moveTo({content.center() - QPointF(0.0, 0.5 * covered / shown), shown}, animated);
}

/// A new map is fitted into the view; painting on the map keeps the view.
void MapView::fitNewMap() {
  const QRectF ground = scene_.groundRect();
  if (std::exchange(ground_, ground) != ground) {
    fitAll(false);
  }
}

void MapView::centerOnEntity(EntityId id) {
  const std::optional<Entity> value = scene_.document().entity(id);
  const std::optional<Vec2> at = value ? positionOf(*value) : std::nullopt;
  if (at) {
    fitted_ = false;
    moveTo({toScene(*at), std::max(pixelsPerMetre(), 30.0)}, true);
  }
}

void MapView::zoomBy(double factor, const QPointF& viewportPoint) {
  restartSettleTimer();
  fitAnimation_.stop();
  fitted_ = false;
  const double scale = std::clamp(pixelsPerMetre() * factor, kFarthest, kClosest);
  const QPointF centre = sceneCentre();
  const QPointF fixed = mapToScene(viewportPoint.toPoint());
  applyView(fixed + (centre - fixed) * pixelsPerMetre() / scale, scale);
}

/// Invalid while editing.
QColor MapView::stateColor() const {
  return runColor_.isValid()              ? runColor_
         : state_ == CanvasState::Editing ? QColor()
         : state_ == CanvasState::Running ? scene_.theme().color(Role::Ok)
         : state_ == CanvasState::Paused  ? scene_.theme().color(Role::WarningMark)
                                          : scene_.theme().color(Role::Past);
}

void MapView::setLegendBrief(bool brief) {
  legend_->setBrief(brief);
  placeLegend();
}

/// Over the map while an overlay has a legend, in a corner that it keeps.
void MapView::placeLegend() {
  if (legend_ == nullptr) {
    return;
  }
  legend_->setParts(legendOf(scene_, pixelsPerMetre()));
  if (legend_->isEmpty()) {
    legend_->hide();
    return;
  }
  if (legend_->isHidden()) {
    legend_->setCorner(freeLegendCorner());
  }
  legend_->place(viewport()->rect().adjusted(0, coveredTop_, 0, 0));
  legend_->show();
}

/// The corner in which the legend covers the fewest bodies and goals.
int MapView::freeLegendCorner() const {
  const std::vector<ShownBody> bodies = scene_.frameLayer().shownBodies();
  const std::vector<sim2d::GlobalGoal>& goals = scene_.document().scenario().goals;
  std::vector<QPoint> places;
  places.reserve(bodies.size() + goals.size());
  for (const ShownBody& body : bodies) {
    places.push_back(viewportFrom(body.pose.position));
  }
  for (const sim2d::GlobalGoal& goal : goals) {
    places.push_back(viewportFrom(goal.position));
  }
  const QRect room = viewport()->rect().adjusted(0, coveredTop_, 0, 0);
  int best = 0;
  std::ptrdiff_t fewest = std::numeric_limits<std::ptrdiff_t>::max();
  for (int corner = 0; corner < LegendStrip::kCorners; ++corner) {
    const QRect box = legend_->boxAt(corner, room);
    const auto covered = std::count_if(places.begin(), places.end(),
                                       [&box](const QPoint& place) { return box.contains(place); });
    if (covered < fewest) {
      fewest = covered;
      best = corner;
    }
  }
  return best;
}

void MapView::wheelEvent(QWheelEvent* event) {
  zoomBy(std::pow(kWheelFactor, event->angleDelta().y()), event->position());
  event->accept();
}

bool MapView::startsPan(const QMouseEvent& event) const {
  return event.button() == Qt::MiddleButton || (spaceHeld_ && event.button() == Qt::LeftButton) ||
         (leftButtonPans_ && event.button() == Qt::LeftButton);
}

void MapView::mousePressEvent(QMouseEvent* event) {
  setFocus();
  if (startsPan(*event)) {
    fitAnimation_.stop();
    panning_ = true;
    spaceUsed_ = true;
    panFrom_ = event->pos();
    updateCursor();
    event->accept();
    return;
  }
  QGraphicsView::mousePressEvent(event);
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->pos();
  Q_EMIT cursorMoved(worldAt(event->pos()));
  if (panning_) {
    const QPoint by = event->pos() - panFrom_;
    panFrom_ = event->pos();
    fitted_ = false;
    restartSettleTimer();
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() - by.x());
    verticalScrollBar()->setValue(verticalScrollBar()->value() - by.y());
    event->accept();
    return;
  }
  QGraphicsView::mouseMoveEvent(event);
  updateCursor();
}

void MapView::mouseReleaseEvent(QMouseEvent* event) {
  if (panning_) {
    panning_ = false;
    updateCursor();
    event->accept();
    return;
  }
  QGraphicsView::mouseReleaseEvent(event);
}

void MapView::updateCursor() {
  if (panning_) {
    viewport()->setCursor(Qt::ClosedHandCursor);
  } else if (spaceHeld_ || leftButtonPans_) {
    viewport()->setCursor(Qt::OpenHandCursor);
  } else if (scene_.tool() != nullptr) {
    viewport()->setCursor(scene_.tool()->cursor());
  } else {
    viewport()->unsetCursor();
  }
}

void MapView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && event->modifiers() == Qt::NoModifier) {
    if (!event->isAutoRepeat()) {
      spaceHeld_ = true;
      spaceUsed_ = false;
      updateCursor();
    }
    event->accept();
    return;
  }
  scene_.setFocus();
  // The tool gets the key first. Arrow keys that it does not handle must not scroll the view.
  QCoreApplication::sendEvent(&scene_, event);
}

void MapView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
    spaceHeld_ = false;
    updateCursor();
    if (!spaceUsed_) {
      Q_EMIT spaceTapped();
    }
    event->accept();
    return;
  }
  QGraphicsView::keyReleaseEvent(event);
}

void MapView::showEvent(QShowEvent* event) {
  QGraphicsView::showEvent(event);
  if (fitted_) {
    fitAll(false);
  }
}

void MapView::resizeEvent(QResizeEvent* event) {
  const QPointF centre =
      viewportTransform().inverted().map(QRectF(QPointF(), event->oldSize()).center());
  QGraphicsView::resizeEvent(event);
  if (fitted_) {
    fitAll(false);
  } else if (event->oldSize().isValid()) {
    centerOn(centre);
  }
  placeLegend();
}

void MapView::paintEvent(QPaintEvent* event) {
  const bool glides = settleTimer_.isActive();
  if (!scene_.isCrowded()) {
    picture_.clear();
    QGraphicsView::paintEvent(event);
    return;
  }
  const CanvasCache::Window window{viewportTransform(), viewport()->size(),
                                   viewport()->devicePixelRatioF()};
  if (!picture_.fits(scene_, window, !glides)) {
    picture_.take(scene_, window, glides ? kPictureMargin : 0);
  }
  QPainter painter(viewport());
  painter.setRenderHints(renderHints());
  picture_.draw(painter, window);
  const QRectF seen = mapToScene(viewport()->rect()).boundingRect();
  painter.setTransform(viewportTransform());
  scene_.paintPart(painter, CanvasPart::Moving, seen);
  painter.resetTransform();
  drawForeground(&painter, seen);
}

void MapView::drawForeground(QPainter* painter, const QRectF&) {
  painter->save();
  painter->resetTransform();
  const QRectF window = viewport()->rect();
  const OverlayContext context{scene_, window, viewportTransform(), pixelsPerMetre(),
                               legendCorner_};
  if (scene_.options().rulers) {
    const LayerOpacity opacity(*painter, scene_.options(), &CanvasOptions::rulers);
    paintRulers(*painter, context);
  }
  paintScaleBar(*painter, context);
  OverlayContext besideLegend = context;
  if (!legend_->isHidden() && legend_->geometry().right() > width() / 2) {
    besideLegend.window.setRight(legend_->geometry().left());
  }
  legendCorner_ = paintGroupLegend(*painter, besideLegend);
  if (const QColor color = stateColor(); color.isValid()) {
    painter->fillRect(QRectF(0.0, 0.0, window.width(), kStateLinePx), color);
  }
  painter->restore();
}

}  // namespace editor
