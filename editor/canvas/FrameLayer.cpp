#include "editor/canvas/FrameLayer.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/EntityItem.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/RouteLayer.h"
#include "editor/document/Groups.h"
#include "sim2d/scenario/Defaults.h"

namespace editor {

namespace {

constexpr double kTrailSeconds = 6.0;
constexpr double kTrailStep = 0.05;      // [m] between two points
constexpr double kStrideMetres = 1.4;    // both feet once
constexpr double kStandingSpeed = 0.05;  // [m/s]
constexpr std::size_t kMostNames = 120;

const sim2d::BodyColumns& peopleOf(const sim2d::Frame& frame) {
  return frame.humans;
}

/// Calls `visit` with the id and place of each person, then of each robot.
template <class Visit>
void forEachBody(const sim2d::Frame& frame, Visit&& visit) {
  for (const sim2d::BodyColumns* bodies : {&peopleOf(frame), &frame.robots}) {
    for (std::size_t i = 0; i < bodies->size(); ++i) {
      visit(bodies->id[i], positionAt(*bodies, i));
    }
  }
}

}  // namespace

void FrameLayer::begin() {
  agents_.clear();
  trails_.clear();
  const sim2d::Scenario& scenario = scene_.document().scenario();
  const long long seed = scenario.desktop.seed.value_or(1);
  for (const sim2d::Human& human : scenario.humans) {
    const sim2d::ResolvedHuman resolved = sim2d::resolveHuman(scenario, human, seed);
    agents_[human.id] = {QString::fromStdString(human.name),
                         human.key,
                         lookOfPerson(scene_.document(), human),
                         resolved.kind,
                         resolved.radius,
                         {}};
  }
  int id = 0;
  for (const sim2d::Robot& robot : scenario.robots) {
    if (robot.listed) {
      --id;
      const sim2d::ResolvedRobot resolved = sim2d::resolveRobot(scenario, robot, id);
      agents_[id] = {QString::fromStdString(robot.name), robot.key,       Look::Regular,
                     sim2d::PersonKind::Adult,           resolved.radius, resolved.footprint};
    }
  }
  stranger_ = Agent();
  for (const sim2d::Area& area : scenario.areas) {
    const sim2d::Human* like = area.like ? scenario.human(*area.like) : nullptr;
    if (area.kind == sim2d::AreaKind::Source && like != nullptr) {
      stranger_ = agents_[like->id];
      stranger_.name.clear();
      stranger_.entity = {};
      break;
    }
  }
}

void FrameLayer::end() {
  frame_.reset();
  speeches_.clear();
  updateBounds();
}

void FrameLayer::show(std::shared_ptr<const sim2d::Frame> frame) {
  const bool isBackwards = frame_ != nullptr && frame->time < frame_->time;
  if (isBackwards) {
    trails_.clear();
  }
  frame_ = std::move(frame);
  follow(*frame_);
  updateBounds();
}

void FrameLayer::updateBounds() {
  prepareGeometryChange();
  bounds_ = frame_ == nullptr ? QRectF() : scene_.sceneRect();
}

void FrameLayer::follow(const sim2d::Frame& frame) {
  const auto note = [&](int id, const base::Vec2& at) {
    Trail& trail = trails_[id];
    const double step = trail.points.empty() ? 0.0 : (at - trail.points.back().second).norm();
    if (step > 2.0) {  // set somewhere else (restart, periodic corridor)
      trail.points.clear();
    }
    if (trail.points.empty() || step >= kTrailStep) {
      trail.points.emplace_back(frame.time, at);
      trail.walked += step;
    }
    while (!trail.points.empty() && trail.points.front().first < frame.time - kTrailSeconds) {
      trail.points.pop_front();
    }
  };
  forEachBody(frame, note);
}

void FrameLayer::hear(const std::vector<sim2d::Event>& events, double time) {
  for (const sim2d::Event& event : events) {
    if (event.kind == sim2d::EventKind::Say && event.hasId) {
      speeches_.push_back({event.id, QString::fromStdString(event.text), time});
    }
  }
}

const FrameLayer::Agent& FrameLayer::agent(int id) const {
  const auto found = agents_.find(id);
  return found == agents_.end() ? stranger_ : found->second;
}

bool FrameLayer::isChosen(int id) const {
  const base::EntityId entity = agent(id).entity;
  return entity && scene_.document().isSelected(entity);
}

std::optional<base::Vec2> FrameLayer::positionOf(int id) const {
  if (frame_ == nullptr) {
    return std::nullopt;
  }
  const sim2d::BodyColumns& bodies = id >= 0 ? peopleOf(*frame_) : frame_->robots;
  const auto found = std::find(bodies.id.begin(), bodies.id.end(), id);
  return found == bodies.id.end()
             ? std::optional<base::Vec2>()
             : positionAt(bodies, static_cast<std::size_t>(found - bodies.id.begin()));
}

std::optional<int> FrameLayer::agentAt(const base::Vec2& world) const {
  if (frame_ == nullptr) {
    return std::nullopt;
  }
  const double reach = 8.0 / scene_.pixelsPerMetre();
  std::optional<int> best;
  double nearest = 0.0;
  const auto consider = [&](int id, const base::Vec2& at) {
    const double distance = (world - at).norm() - std::max(agent(id).radius, reach);
    if (distance <= 0.0 && (!best || distance < nearest)) {
      best = id;
      nearest = distance;
    }
  };
  forEachBody(*frame_, consider);
  return best;
}

std::vector<QRectF> FrameLayer::solidParts() const {
  std::vector<QRectF> parts;
  forEachBody(*frame_, [&](int id, const base::Vec2& at) {
    const double reach = (id < 0 ? 1.0 : 0.9) * agent(id).radius;
    parts.push_back(around(MapScene::sceneFromWorld(at), reach));
  });
  for (std::size_t i = 0; scene_.options().forces && i < frame_->humans.size(); ++i) {
    if (!isChosen(frame_->humans.id[i])) {
      continue;
    }
    const base::Vec2 from = positionAt(frame_->humans, i);
    for (const ForceArrow& arrow : forcesOn(*frame_, frame_->humans.id[i])) {
      const base::Vec2 to = from + (kMetresPerForce + agent(frame_->humans.id[i]).radius /
                                                          (arrow.force.norm() + 1e-9)) *
                                       arrow.force;
      parts.push_back(
          QRectF(MapScene::sceneFromWorld(from), MapScene::sceneFromWorld(to)).normalized());
    }
  }
  return parts;
}

std::vector<Label> FrameLayer::labels() const {
  std::vector<Label> labels;
  const double scale = scene_.pixelsPerMetre();
  const CanvasOptions& options = scene_.options();
  const bool showAll = options.names && frame_->humans.size() <= kMostNames;
  for (std::size_t i = 0; options.people && i < frame_->humans.size(); ++i) {
    const Agent& person = agent(frame_->humans.id[i]);
    const double radiusPx = std::max(person.radius * scale, kLeastFigurePx);
    const bool chosen = isChosen(frame_->humans.id[i]);
    if (!person.name.isEmpty() && (chosen || (showAll && 2.0 * radiusPx >= kNameZoomPx))) {
      labels.push_back({person.name, person.look,
                        MapScene::sceneFromWorld(positionAt(frame_->humans, i)),
                        radiusPx + (chosen ? 9.0 : 4.0), chosen ? 3 : 1, false});
    }
  }
  for (std::size_t i = 0; options.robots && i < frame_->robots.size(); ++i) {
    const Agent& robot = agent(frame_->robots.id[i]);
    if (options.names) {
      labels.push_back({robot.name, std::nullopt,
                        MapScene::sceneFromWorld(positionAt(frame_->robots, i)),
                        std::max(robot.radius * scale, kLeastFigurePx) + 5.0, 2, false});
    }
  }
  return labels;
}

PersonFigure FrameLayer::figureOf(std::size_t index, double pixelsPerMetre) const {
  const sim2d::HumanColumns& people = frame_->humans;
  const Agent& person = agent(people.id[index]);
  PersonFigure figure;
  figure.look = person.look;
  figure.kind = person.kind;
  figure.radiusPx = std::max(person.radius * pixelsPerMetre, kLeastFigurePx);
  figure.headingDeg = degrees(people.heading[index]);
  const auto trail = trails_.find(people.id[index]);
  if (std::hypot(people.vx[index], people.vy[index]) > kStandingSpeed && trail != trails_.end()) {
    figure.stride = std::sin(2.0 * base::kPi * trail->second.walked / kStrideMetres);
  }
  return figure;
}

void FrameLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (frame_ == nullptr) {
    return;
  }
  painter->setRenderHint(QPainter::Antialiasing);
  const CanvasOptions& options = scene_.options();
  if (options.proxemics) {
    for (std::size_t i = 0; i < frame_->humans.size(); ++i) {
      const int id = frame_->humans.id[i];
      if (isChosen(id)) {
        paintSpaces(*painter, positionAt(frame_->humans, i), scene_.theme().fill(agent(id).look));
      }
    }
  }
  if (options.trails) {
    paintTrails(*painter);
  }
  if (options.robotPath) {
    paintRobotPaths(*painter);
  }
  if (options.people) {
    paintPeople(*painter);
  }
  if (options.robots) {
    paintRobots(*painter);
  }
  if (options.forces) {
    paintForces(*painter);
  }
  if (options.speech) {
    paintSpeech(*painter);
  }
}

}  // namespace editor
