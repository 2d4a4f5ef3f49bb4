#include "editor/canvas/FrameLayer.h"

#include <algorithm>
#include <cmath>

#include "editor/document/Groups.h"
#include "sim2d/scenario/Defaults.h"

namespace editor {

namespace {

constexpr double kTrailSeconds = 6.0;
constexpr double kTrailStep = 0.05;      // [m] between two points
constexpr double kStandingSpeed = 0.05;  // [m/s]
constexpr std::size_t kMostNames = 120;

}  // namespace

void FrameLayer::begin() {
  agents_.clear();
  trails_.clear();
  const sim2d::Scenario& scenario = document().scenario();
  const long long seed = scenario.desktop.seed.value_or(1);
  for (const sim2d::Human& human : scenario.humans) {
    const sim2d::ResolvedHuman resolved = sim2d::resolveHuman(scenario, human, seed);
    agents_[human.id] = {QString::fromStdString(human.name),
                         human.key,
                         lookOfPerson(document(), human),
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
  bodies_.clear();
  speeches_.clear();
}

void FrameLayer::show(std::shared_ptr<const sim2d::Frame> frame) {
  if (frame_ != nullptr && frame->time < frame_->time) {
    trails_.clear();
  }
  frame_ = std::move(frame);
  bodies_.clear();
  for (const sim2d::BodyColumns* columns :
       {static_cast<const sim2d::BodyColumns*>(&frame_->humans), &frame_->robots}) {
    for (std::size_t i = 0; i < columns->size(); ++i) {
      const int id = columns->id[i];
      const Pose2 pose{Vec2(columns->x[i], columns->y[i]), columns->heading[i]};
      const bool isMoving = std::hypot(columns->vx[i], columns->vy[i]) > kStandingSpeed;
      bodies_.push_back({id, &agent(id), pose, isMoving});
      lengthen(trails_[id], pose.position);
    }
  }
}

void FrameLayer::lengthen(Trail& trail, const Vec2& at) const {
  const double step = trail.points.empty() ? 0.0 : (at - trail.points.back().second).norm();
  if (step > 2.0) {  // set somewhere else (restart, periodic corridor)
    trail.points.clear();
  }
  if (trail.points.empty() || step >= kTrailStep) {
    trail.points.emplace_back(frame_->time, at);
    trail.walked += step;
  }
  while (!trail.points.empty() && trail.points.front().first < frame_->time - kTrailSeconds) {
    trail.points.pop_front();
  }
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

const FrameLayer::Body* FrameLayer::body(int id) const {
  const auto found = std::find_if(bodies_.begin(), bodies_.end(),
                                  [id](const Body& each) { return each.id == id; });
  return found == bodies_.end() ? nullptr : &*found;
}

bool FrameLayer::isChosen(const Body& body) const {
  return body.agent->entity && document().isSelected(body.agent->entity);
}

std::optional<Vec2> FrameLayer::positionOf(int id) const {
  const Body* found = body(id);
  return found == nullptr ? std::nullopt : std::optional<Vec2>(found->pose.position);
}

EntityId FrameLayer::entityAt(const Vec2& world) const {
  EntityId best;
  double nearest = 0.0;
  bool isFound = false;
  for (const Body& body : bodies_) {
    const double distance =
        (world - body.pose.position).norm() - std::max(body.agent->radius, metres(8.0));
    if (distance <= 0.0 && (!isFound || distance < nearest)) {
      best = body.agent->entity;
      nearest = distance;
      isFound = true;
    }
  }
  return best;
}

std::vector<QRectF> FrameLayer::solidParts() const {
  std::vector<QRectF> parts;
  for (const Body& body : bodies_) {
    const double radius = body.agent->radius;
    parts.push_back(around(toScene(body.pose.position), (body.isRobot() ? 1.0 : 0.9) * radius));
    if (!options().forces || !isChosen(body)) {
      continue;
    }
    for (const ForceArrow& arrow : forcesOn(*frame_, body.id)) {
      const double length = kMetresPerForce + radius / (arrow.force.norm() + 1e-9);
      const Vec2 tip = body.pose.position + length * arrow.force;
      parts.push_back(QRectF(toScene(body.pose.position), toScene(tip)).normalized());
    }
  }
  return parts;
}

std::vector<Label> FrameLayer::labels() const {
  std::vector<Label> labels;
  const bool showAll = options().names && frame_->humans.size() <= kMostNames;
  for (const Body& body : bodies_) {
    const double radiusPx =
        std::max(body.agent->radius * mapScene().pixelsPerMetre(), kLeastFigurePx);
    Label label;
    label.text = body.agent->name;
    label.centre = toScene(body.pose.position);
    if (body.isRobot()) {
      label.clearancePx = radiusPx + 5.0;
      label.priority = 2;
      if (options().robots && options().names) {
        labels.push_back(label);
      }
      continue;
    }
    const bool chosen = isChosen(body);
    label.mark = body.agent->look;
    label.clearancePx = radiusPx + (chosen ? 9.0 : 4.0);
    label.priority = chosen ? 3 : 1;
    const bool isShown = chosen || (showAll && 2.0 * radiusPx >= kNameZoomPx);
    if (options().people && !label.text.isEmpty() && isShown) {
      labels.push_back(label);
    }
  }
  return labels;
}

}  // namespace editor
