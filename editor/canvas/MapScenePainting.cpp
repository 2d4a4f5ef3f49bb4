#include <algorithm>

#include <QGraphicsSceneMouseEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QStyleOptionGraphicsItem>

#include "app/run/Nav2Robots.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/RunOverlays.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/world/Registries.h"

// The functions of MapScene for tools, layers and painting.
namespace editor {

namespace {

constexpr std::size_t kCrowd = 200;           // Number of entities.
constexpr double kFewPeople = 60.0;           // With more people, figures are smaller.
constexpr std::size_t kMaxMovingRoutes = 20;  // Maximum number of routes drawn while they change.

sim2d::ResolvedHuman resolvedPerson(const sim2d::Scenario& scenario, const sim2d::Human& human) {
  return sim2d::resolveHuman(scenario, human, scenario.desktop.seed.value_or(1));
}

/// The radius set by the person's model, which overrides that of the scenario.
std::optional<double> ownRadius(const sim2d::ResolvedHuman& person) {
  static const sim2d::Registries registries = app::builtinRegistries();
  return sim2d::bodyRadiusOverride(registries, person);
}

void paintItem(QPainter& painter, QGraphicsItem& item, const QRectF& exposed) {
  const QRectF seen = item.boundingRect() & exposed;
  if (!item.isVisible() || seen.isEmpty()) {
    return;
  }
  QStyleOptionGraphicsItem option;
  option.exposedRect = seen;
  painter.save();
  painter.setOpacity(item.effectiveOpacity());
  item.paint(&painter, &option, nullptr);
  painter.restore();
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

QColor MapScene::groundColor() const {
  return theme_.color(isOpenPlane() ? Role::MapFree : Role::CanvasOutside);
}

bool MapScene::isCrowded() const {
  const sim2d::Frame* const frame = frameLayer_->frame();
  return items_.size() >= kCrowd || (frame != nullptr && frame->humans.size() >= kCrowd);
}

std::vector<EntityId> MapScene::movingIds() const {
  std::vector<EntityId> ids;
  for (const auto& [id, value] : preview_) {
    ids.push_back(id);
  }
  return ids;
}

/// Previewed, or simulated in a run.
bool MapScene::isMoving(EntityId id) const {
  const bool isBody = id.kind == EntityKind::Human || id.kind == EntityKind::Robot;
  return preview_.count(id) > 0 || (isBody && isRunMode());
}

void MapScene::paintPart(QPainter& painter, CanvasPart part, const QRectF& exposed) {
  part_ = part;
  std::vector<QGraphicsItem*> wanted;
  if (part == CanvasPart::Moving) {
    wanted = {groupLayer_, frameLayer_,     labelLayer_, groundOverlay_,
              topOverlay_, selectionLayer_, toolLayer_};
    wanted.insert(wanted.end(), runLayers_.begin(), runLayers_.end());
    if (preview_.size() <= kMaxMovingRoutes) {
      wanted.push_back(routeLayer_);
    }
    for (const auto& [id, value] : preview_) {
      wanted.push_back(item(id));
    }
    QGraphicsItem* const hovered = item(hoveredOnTop());
    if (hovered != nullptr && preview_.count(hovered_) == 0) {
      wanted.push_back(hovered);
    }
  } else {
    for (QGraphicsItem* each : items(Qt::AscendingOrder)) {
      const auto* entityItem = dynamic_cast<EntityItem*>(each);
      const bool isMark = each == selectionLayer_ || each == toolLayer_ || each == frameLayer_ ||
                          each == groundOverlay_ || each == topOverlay_ ||
                          std::count(runLayers_.begin(), runLayers_.end(), each) > 0;
      const bool isPartOf = entityItem == nullptr || isPainted(entityItem->id());
      if (isMark ? part == CanvasPart::All : isPartOf) {
        wanted.push_back(each);
      }
    }
  }
  std::stable_sort(wanted.begin(), wanted.end(),
                   [](const auto* a, const auto* b) { return a->zValue() < b->zValue(); });
  for (QGraphicsItem* each : wanted) {
    paintItem(painter, *each, exposed);
  }
  part_ = CanvasPart::All;
}

bool MapScene::isDoorOpen(EntityId id, const sim2d::Door& door) const {
  if (const sim2d::Frame* frame = frameLayer_->frame()) {
    std::size_t number = 0;  // Frames contain only the listed doors, in order.
    for (const sim2d::Door& other : document_.scenario().doors) {
      if (other.key == id && number < frame->doorOpen.size()) {
        return frame->doorOpen[number] != 0;
      }
      number += other.listed ? 1 : 0;
    }
  }
  return door.open.value_or(true);
}

double MapScene::bodyRadius(const Entity& entity) const {
  const sim2d::Scenario& scenario = document_.scenario();
  if (const auto* human = std::get_if<sim2d::Human>(&entity)) {
    const sim2d::ResolvedHuman person = resolvedPerson(scenario, *human);
    return ownRadius(person).value_or(person.radius);
  }
  if (std::holds_alternative<sim2d::Dock>(entity)) {
    return 0.3;  // Half side of the square that represents a docked robot.
  }
  if (const auto* robot = std::get_if<sim2d::Robot>(&entity)) {
    return sim2d::resolveRobot(scenario, *robot, -1).radius;
  }
  return 0.0;
}

bool MapScene::isSizable(const Entity& entity) const {
  const auto* human = std::get_if<sim2d::Human>(&entity);
  return human == nullptr || !ownRadius(resolvedPerson(document_.scenario(), *human));
}

double MapScene::minFigurePx(EntityKind kind) const {
  if (kind != EntityKind::Human) {
    return kMinFigurePx;
  }
  const sim2d::Frame* frame = frameLayer_->frame();
  const std::size_t people =
      frame != nullptr ? frame->humans.size() : document_.scenario().humans.size();
  return std::clamp(kFewFigurePx * kFewPeople / double(people + 1), kMinFigurePx, kFewFigurePx);
}

double MapScene::figureRadius(const Entity& entity) const {
  return std::max(bodyRadius(entity), minFigurePx(kindOf(entity)) / pixelsPerMetre());
}

std::vector<Label> MapScene::labels() const {
  std::vector<Label> all;
  for (const auto& [id, entityItem] : items_) {
    const bool isAll = isPainted(id);
    const bool isHoverAlone = id == hovered_ && part_ == CanvasPart::Moving;  // Over the picture.
    if (!entityItem->isVisible() || !(isAll || isHoverAlone)) {
      continue;
    }
    for (const Label& label : entityItem->labels()) {
      if (isAll || label.isHoverOnly) {
        all.push_back(label);
      }
    }
  }
  if (isRunMode() && part_ != CanvasPart::Resting) {
    append(all, frameLayer_->labels());
  }
  return all;
}

std::vector<QRectF> MapScene::labelObstacles() const {
  std::vector<QRectF> all;
  for (const auto& [id, entityItem] : items_) {
    if (entityItem->isVisible()) {
      append(all, entityItem->labelObstacles());
    }
  }
  if (!isRunMode()) {
    append(all, selectionLayer_->labelObstacles());
  } else if (part_ != CanvasPart::Resting) {
    append(all, frameLayer_->labelObstacles());
  }
  return all;
}

bool MapScene::isRunMode() const {
  return frameLayer_->frame() != nullptr;
}

void MapScene::showFrame(sim2d::FramePtr frame, const sim2d::Recording* recording) {
  const bool wasRunning = isRunMode();
  const bool turnsDoors =
      wasRunning && frame != nullptr && frame->doorOpen != frameLayer_->frame()->doorOpen;
  if (frame != nullptr) {
    if (!wasRunning) {
      frameLayer_->begin();
    }
    overlays_->show(frame, recording);
    frameLayer_->show(std::move(frame), recording);
  } else {
    frameLayer_->end();
    overlays_->end();
    setSpawnedAgent({});
  }
  if (isRunMode() != wasRunning) {
    routeLayer_->setVisible(wasRunning);
    syncItems();
    planRoutes();
  }
  if (turnsDoors) {
    invalidateResting();
  } else {
    update();
  }
}

void MapScene::setSpawnedAgent(std::optional<int> agent) {
  if (agent != spawnedAgent_) {
    spawnedAgent_ = agent;
    update();
    Q_EMIT spawnedAgentChanged();
  }
}

void MapScene::setPull(std::optional<Pull> pull) {
  const bool isRefused = pull && !isPullable_;
  if ((pull || pull_) && !isRefused) {
    pull_ = std::move(pull);
    update();
    Q_EMIT pullChanged();
  }
}

void MapScene::setPullable(bool pullable) {
  isPullable_ = pullable;
  if (!pullable) {
    setPull({});
    setPush({});
    armedPush_.reset();
  }
}

void MapScene::setFrameInterpolation(double share) {
  if (frameLayer_->setInterpolation(share)) {
    update();
  }
}

ToolMarks& MapScene::marks() {
  toolLayer_->update();
  return toolLayer_->marks();
}

void MapScene::setTool(Tool* tool) {
  if (tool_ == tool) {
    return;
  }
  if (tool_ != nullptr) {
    tool_->deactivate();
  }
  tool_ = tool;
  marks() = {};
  if (tool_ != nullptr) {
    tool_->activate();
  }
}

void MapScene::dispatchMouse(QGraphicsSceneMouseEvent& event,
                             void (Tool::*handler)(const CanvasMouse&)) {
  if (tool_ != nullptr) {
    (tool_->*handler)(
        {toWorld(event.scenePos()), event.button(), event.modifiers(), pixelsPerMetre_});
    event.accept();
  }
}

void MapScene::mousePressEvent(QGraphicsSceneMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    dispatchMouse(*event, &Tool::press);
  } else if (tool_ != nullptr) {
    tool_->pressOther(event->button());
    event->accept();
  }
}

void MapScene::mouseMoveEvent(QGraphicsSceneMouseEvent* event) {
  dispatchMouse(*event, &Tool::move);
}

void MapScene::mouseReleaseEvent(QGraphicsSceneMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    dispatchMouse(*event, &Tool::release);
  }
  event->setAccepted(tool_ != nullptr);
}

void MapScene::mouseDoubleClickEvent(QGraphicsSceneMouseEvent* event) {
  mousePressEvent(event);
  dispatchMouse(*event, &Tool::doubleClick);
}

void MapScene::keyPressEvent(QKeyEvent* event) {
  if (tool_ == nullptr) {
    event->ignore();
  } else if (event->key() == Qt::Key_Escape) {
    tool_->cancel();
    event->accept();
  } else {
    event->setAccepted(tool_->keyPress(*event));
  }
}

}  // namespace editor
