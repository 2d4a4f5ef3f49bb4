#include <QGraphicsSceneMouseEvent>
#include <QKeyEvent>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/Layers.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/RouteLayer.h"
#include "editor/canvas/Tool.h"
#include "editor/document/EntityLists.h"
#include "sim2d/scenario/Defaults.h"

// The part of MapScene that has to do with tools, runs and what the layers ask for.
namespace editor {

namespace {

CanvasMouse mouseOf(const QGraphicsSceneMouseEvent& event, double pixelsPerMetre) {
  return {MapScene::worldFromScene(event.scenePos()), event.button(), event.buttons(),
          event.modifiers(), pixelsPerMetre};
}

}  // namespace

void putInto(sim2d::Scenario& scenario, const Entity& value) {
  withList(
      scenario, kindOf(value),
      [&](auto& list) {
        using Value = typename std::decay_t<decltype(list)>::value_type;
        const int at = positionIn(list, idOf(value));
        if (at >= 0) {
          list[static_cast<std::size_t>(at)] = std::get<Value>(value);
        } else {
          list.push_back(std::get<Value>(value));
        }
        return true;
      },
      false);
}

bool MapScene::isDoorOpen(EntityId id, const sim2d::Door& door) const {
  if (const sim2d::Frame* frame = frameLayer_->frame()) {
    std::size_t number = 0;  // frames know the listed doors only, in their order
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
    return sim2d::resolveHuman(scenario, *human, scenario.desktop.seed.value_or(1)).radius;
  }
  if (const auto* robot = std::get_if<sim2d::Robot>(&entity)) {
    return sim2d::resolveRobot(scenario, *robot, -1).radius;
  }
  return 0.0;
}

std::vector<Label> MapScene::labels() const {
  std::vector<Label> all;
  for (const auto& [id, entityItem] : items_) {
    if (entityItem->isVisible() && isPainted(id)) {
      const std::vector<Label> labels = entityItem->labels();
      all.insert(all.end(), labels.begin(), labels.end());
    } else if (entityItem->isVisible() && id == hovered_ && part_ == CanvasPart::Moving) {
      for (const Label& label : entityItem->labels()) {
        if (label.isOfHover) {  // others are in the picture
          all.push_back(label);
        }
      }
    }
  }
  if (isRunMode()) {
    const std::vector<Label> labels = frameLayer_->labels();
    all.insert(all.end(), labels.begin(), labels.end());
  }
  return all;
}

std::vector<QRectF> MapScene::solidParts() const {
  std::vector<QRectF> all;
  for (const auto& [id, entityItem] : items_) {
    if (entityItem->isVisible()) {
      const std::vector<QRectF> parts = entityItem->solidParts();
      all.insert(all.end(), parts.begin(), parts.end());
    }
  }
  if (isRunMode()) {
    const std::vector<QRectF> parts = frameLayer_->solidParts();
    all.insert(all.end(), parts.begin(), parts.end());
  } else {
    const std::vector<QRectF> parts = selectionLayer_->solidParts();
    all.insert(all.end(), parts.begin(), parts.end());
  }
  return all;
}

std::pair<EntityId, Handle> MapScene::handleAt(const Vec2& world) const {
  return selectionLayer_->handleAt(world);
}

const sim2d::Frame* MapScene::frame() const {
  return frameLayer_->frame();
}

std::optional<EntityId> MapScene::agentEntityAt(const Vec2& world) const {
  const std::optional<int> id = frameLayer_->agentAt(world);
  const EntityId entity = id ? frameLayer_->entityOf(*id) : EntityId{};
  return entity ? std::optional<EntityId>(entity) : std::nullopt;
}

bool MapScene::isRunMode() const {
  return frameLayer_->frame() != nullptr;
}

void MapScene::showFrame(std::shared_ptr<const sim2d::Frame> frame) {
  const bool wasRunning = isRunMode();
  if (frame != nullptr) {
    if (!wasRunning) {
      frameLayer_->begin();
    }
    frameLayer_->show(std::move(frame));
  } else {
    frameLayer_->end();
  }
  if (isRunMode() != wasRunning) {
    routeLayer_->setVisible(wasRunning);
    for (const auto& [id, entityItem] : items_) {
      entityItem->setVisible(isShown(id));
    }
    planRoutes();
  }
  noteChange();
}

void MapScene::setTool(Tool* tool) {
  if (tool_ == tool) {
    return;
  }
  if (tool_ != nullptr) {
    tool_->deactivate();
  }
  tool_ = tool;
  toolLayer_->clear();
  if (tool_ != nullptr) {
    tool_->activate();
  }
}

void MapScene::mousePressEvent(QGraphicsSceneMouseEvent* event) {
  if (tool_ != nullptr) {
    tool_->press(mouseOf(*event, pixelsPerMetre_));
    event->accept();
  }
}

void MapScene::mouseMoveEvent(QGraphicsSceneMouseEvent* event) {
  if (tool_ != nullptr) {
    tool_->move(mouseOf(*event, pixelsPerMetre_));
    event->accept();
  }
}

void MapScene::mouseReleaseEvent(QGraphicsSceneMouseEvent* event) {
  if (tool_ != nullptr) {
    tool_->release(mouseOf(*event, pixelsPerMetre_));
    event->accept();
  }
}

void MapScene::mouseDoubleClickEvent(QGraphicsSceneMouseEvent* event) {
  if (tool_ != nullptr) {
    tool_->press(mouseOf(*event, pixelsPerMetre_));
    tool_->doubleClick(mouseOf(*event, pixelsPerMetre_));
    event->accept();
  }
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
