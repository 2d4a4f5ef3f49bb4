#include "editor/canvas/FrameLayer.h"

#include <cmath>
#include <limits>

#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/RobotPainters.h"
#include "editor/canvas/RunOverlays.h"
#include "editor/document/PeopleEdits.h"
#include "editor/document/RunValues.h"
#include "sim2d/scenario/ResolvedValues.h"

namespace editor {

namespace {

constexpr double kStandingSpeed = 0.05;  // [m/s]
constexpr std::size_t kMaxNames = 120;
constexpr double kStrideMetres = 1.4;  // Walked distance of a full step cycle.
constexpr double kSpeechSeconds = 4.0;
constexpr double kSpeechFade = 0.6;  // Duration of the fade-out [s].
constexpr double kBubbleWidthPx = 220.0;
constexpr double kEstimated = 0.4;  // Opacity of the pose that a robot estimates.
constexpr int kBubbleText = int{Qt::TextWordWrap} | int{Qt::AlignCenter};

/// The perception of all robots; empty if the frame has none.
const std::vector<sim2d::RobotTelemetry>& sensesOf(const sim2d::Frame& frame) {
  static const std::vector<sim2d::RobotTelemetry> nothing;
  return frame.senses != nullptr ? *frame.senses : nothing;
}

sim2d::FramePtr withoutSenses(const sim2d::FramePtr& frame) {
  if (frame == nullptr || frame->senses == nullptr) {
    return frame;
  }
  auto bare = std::make_shared<sim2d::Frame>(*frame);
  bare->senses = nullptr;
  return bare;
}

/// The first entry that is still visible at `time`.
template <class Said>
typename std::vector<Said>::const_iterator firstWithin(const std::vector<Said>& said, double time) {
  return std::partition_point(said.begin(), said.end(), [time](const Said& each) {
    return each.since + kSpeechSeconds <= time;
  });
}

}  // namespace

void FrameLayer::begin() {
  agents_.clear();
  trails_.clear();
  hasBodySizes_ = false;
  const sim2d::Scenario& scenario = document().scenario();
  const long long seed = scenario.desktop.seed.value_or(1);
  for (const sim2d::Human& human : scenario.humans) {
    const sim2d::ResolvedHuman resolved = sim2d::resolveHuman(scenario, human, seed);
    agents_[human.id] = {QString::fromStdString(human.name), human.key,
                         shownLookOf(document(), human), resolved.kind,
                         mapScene().bodyRadius(human)};
  }
  int id = 0;
  for (const sim2d::Robot& robot : scenario.robots) {
    if (robot.listed) {
      --id;
      const sim2d::ResolvedRobot resolved = sim2d::resolveRobot(scenario, robot, id);
      agents_[id] = {QString::fromStdString(robot.name),
                     robot.key,
                     Look::Regular,
                     sim2d::PersonKind::Adult,
                     resolved.radius,
                     resolved.footprint,
                     resolved.kinematics};
    }
  }
  unknownAgent_ = Agent();
  for (const sim2d::Area& area : scenario.areas) {
    const sim2d::Human* like = area.like ? scenario.human(*area.like) : nullptr;
    if (area.kind == sim2d::AreaKind::Source && like != nullptr) {
      unknownAgent_ = agents_[like->id];
      unknownAgent_.name.clear();
      unknownAgent_.entity = {};
      break;
    }
  }
}

void FrameLayer::show(sim2d::FramePtr frame, const sim2d::Recording* recording) {
  before_.clear();
  for (const Body& body : bodies_) {
    before_.emplace(body.id, body.at);
  }
  interpolation_ = 1.0;
  if (recording != nullptr && recording->size() > 0) {
    updateAgents(*recording->header(), *frame);
  }
  trails_.advance(frame_.get(), *frame, recording, options().trailSeconds);
  whole_ = std::move(frame);
  frame_ = areSensesHidden_ ? withoutSenses(whole_) : whole_;
  bodies_.clear();
  places_.clear();
  forEachBody(*frame_, [this](const sim2d::BodyColumns& columns, std::size_t i) {
    const int id = columns.id[i];
    const Pose2 pose{Vec2(columns.x[i], columns.y[i]), columns.heading[i]};
    places_.emplace(id, bodies_.size());
    bodies_.push_back({id, &agent(id), pose, pose, Vec2(columns.vx[i], columns.vy[i])});
  });
}

void FrameLayer::setSensesHidden(bool hidden) {
  areSensesHidden_ = hidden;
  frame_ = hidden ? withoutSenses(whole_) : whole_;
  update();
}

/// Takes the body sizes from the run, where the pedestrian model determines them, and adds the
/// agents that were spawned since.
void FrameLayer::updateAgents(const sim2d::TraceHeader& header, const sim2d::Frame& frame) {
  if (!std::exchange(hasBodySizes_, true)) {
    for (const sim2d::TraceHuman& human : header.humans) {
      if (const auto known = agents_.find(human.id); known != agents_.end()) {
        known->second.radius = human.radius;
      }
    }
  }
  const auto isNew = [this](int id) { return agents_.count(id) == 0; };
  if (std::none_of(frame.humans.id.begin(), frame.humans.id.end(), isNew)) {
    return;
  }
  for (const sim2d::TraceHuman& human : header.humans) {
    if (isNew(human.id)) {
      agents_[human.id] = {QString::fromStdString(human.name), EntityId(), lookOf(human),
                           unknownAgent_.kind, human.radius};
    }
  }
}

bool FrameLayer::setInterpolation(double share) {
  if (share == interpolation_ || frame_ == nullptr) {
    return false;
  }
  interpolation_ = share;
  for (Body& body : bodies_) {
    const auto from = before_.find(body.id);
    if (from != before_.end() &&
        (body.at.position - from->second.position).norm() <= kFarthestStep) {
      const Pose2& start = from->second;
      body.pose.position = start.position + share * (body.at.position - start.position);
      body.pose.heading = start.heading + share * base::angleDiff(body.at.heading, start.heading);
    }
  }
  return true;
}

void FrameLayer::addSpeech(const std::vector<sim2d::Event>& events, double time) {
  for (const sim2d::Event& event : events) {
    if (event.kind == sim2d::EventKind::Say && event.hasId) {
      speeches_.push_back({event.id, QString::fromStdString(event.text), time});
    } else if (event.kind == sim2d::EventKind::Heard && event.hasId && event.hasOther) {
      hearings_.push_back({event.id, event.other, time});
    }
  }
}

double FrameLayer::figureRadiusPx(const Body& body, double pixelsPerMetre) const {
  const EntityKind kind = body.isRobot() ? EntityKind::Robot : EntityKind::Human;
  return std::max(body.agent->radius * pixelsPerMetre, mapScene().minFigurePx(kind));
}

std::vector<ShownBody> FrameLayer::shownBodies() const {
  std::vector<ShownBody> shown;
  shown.reserve(bodies_.size());
  const double scale = mapScene().pixelsPerMetre();
  for (const Body& body : bodies_) {
    shown.push_back({body.id, body.pose, body.velocity, figureRadiusPx(body, scale),
                     body.agent->look, isChosen(body)});
  }
  return shown;
}

std::optional<int> FrameLayer::agentAt(const Vec2& world) const {
  std::optional<int> best;
  double nearest = std::numeric_limits<double>::max();
  for (const Body& body : bodies_) {
    const double distance =
        (world - body.pose.position).norm() - std::max(body.agent->radius, metres(8.0));
    if (distance <= 0.0 && distance < nearest) {
      best = body.id;
      nearest = distance;
    }
  }
  return best;
}

std::vector<QRectF> FrameLayer::labelObstacles() const {
  std::vector<QRectF> parts;
  for (const Body& body : bodies_) {
    const double radius = metres(figureRadiusPx(body, mapScene().pixelsPerMetre()));
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

bool FrameLayer::isLabelled(const Body& body, bool isNamed) const {
  if (body.isRobot()) {
    return options().robots && options().names;
  }
  return options().people && isNamed && !body.agent->name.isEmpty();
}

std::vector<Label> FrameLayer::labels() const {
  const double scale = mapScene().pixelsPerMetre();
  const bool showsNames =
      options().names && frame_->humans.size() <= kMaxNames && scale >= kNameZoom;
  std::vector<Label> labels;
  for (const Body& body : bodies_) {
    const bool chosen = isChosen(body);
    // Spawned people have a label only if chosen.
    if (!isLabelled(body, chosen || (showsNames && body.agent->entity))) {
      continue;
    }
    Label& label = labels.emplace_back();
    label.text = body.agent->name;
    label.centre = toScene(body.pose.position);
    label.clearancePx = figureRadiusPx(body, scale);
    if (body.isRobot()) {
      label.clearancePx += 5.0;
      label.priority = 2;
    } else {
      label.clearancePx += chosen ? 9.0 : 4.0;
      label.priority = chosen ? 3 : 1;
      label.mark = body.agent->look;
      label.detail = options().thoughts ? mapScene().overlays().thoughtOf(body.id) : QString();
    }
  }
  return labels;
}

void FrameLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (frame_ == nullptr) {
    return;
  }
  painter->setRenderHint(QPainter::Antialiasing);
  const CanvasOptions& on = options();
  using Options = CanvasOptions;
  const std::pair<bool Options::*, void (FrameLayer::*)(QPainter&) const> parts[] = {
      {&Options::lidar, &FrameLayer::paintScans},
      {&Options::candidates, &FrameLayer::paintCandidateTrajectories},
      {&Options::trails, &FrameLayer::paintTrails},
      {&Options::robotPath, &FrameLayer::paintRobotPaths},
      {&Options::people, &FrameLayer::paintPeople},
      {&Options::detections, &FrameLayer::paintEstimatedPoses},
      {nullptr, &FrameLayer::paintPull},
      {nullptr, &FrameLayer::paintPush},
      {nullptr, &FrameLayer::paintPlacement},
      {&Options::robots, &FrameLayer::paintRobots},
      {&Options::forces, &FrameLayer::paintForces},
      {&Options::speech, &FrameLayer::paintHearing},
      {&Options::speech, &FrameLayer::paintSpeech}};
  for (const auto& [layer, paintPart] : parts) {
    if (layer == nullptr || on.*layer) {
      const LayerOpacity opacity(*painter, on, layer);
      (this->*paintPart)(*painter);
    }
  }
}

PersonFigure FrameLayer::figureOf(const Body& person, double pixelsPerMetre) const {
  PersonFigure figure;
  figure.look = person.agent->look;
  figure.kind = person.agent->kind;
  figure.radiusPx = figureRadiusPx(person, pixelsPerMetre);
  figure.headingDeg = degrees(person.pose.heading);
  if (std::hypot(person.velocity.x(), person.velocity.y()) > kStandingSpeed) {
    figure.stride = std::sin(2.0 * base::kPi * trails_.walked(person.id) / kStrideMetres);
  }
  return figure;
}

void FrameLayer::paintPeople(QPainter& painter) const {
  const double pixelsPerMetre = pixelsPerMetreOf(painter);
  std::vector<std::pair<QPointF, PersonFigure>> figures;
  figures.reserve(bodies_.size());
  const PixelFrame frame(painter, {});
  for (const Body& body : bodies_) {
    if (body.isRobot()) {
      continue;
    }
    const QPointF at = toScene(body.pose.position) * pixelsPerMetre;
    figures.emplace_back(at, figureOf(body, pixelsPerMetre));
    if (isChosen(body)) {
      paintRing(painter, QPen(theme().color(Role::Accent), 2.0),
                figures.back().second.radiusPx + 4.0, at);
    }
  }
  mapScene().sprites().draw(painter, theme(), figures);
}

void FrameLayer::paintRobot(QPainter& painter, const Body& robot) const {
  const RobotFigure figure =
      robotFigure(robot.agent->radius, robot.agent->footprint, robot.agent->kinematics,
                  robot.pose.heading, pixelsPerMetreOf(painter));
  const PixelFrame frame(painter, toScene(robot.pose.position));
  if (isChosen(robot)) {
    paintRing(painter, QPen(theme().color(Role::Accent), 2.0), figure.radiusPx + 5.0);
  }
  FigurePainter(theme()).robot(painter, figure);
}

void FrameLayer::paintRobots(QPainter& painter) const {
  for (const Body& body : bodies_) {
    if (body.isRobot()) {
      paintRobot(painter, body);
    }
  }
}

void FrameLayer::paintRobotPaths(QPainter& painter) const {
  for (const std::vector<Vec2>& points : frame_->robotPaths) {
    const QPainterPath path = roundedPath(points, 0.3);
    setPenAndBrush(painter,
                   cosmetic(dashedPen(theme().color(Role::RobotLine), 2.0, {3.5, 2.5}), painter));
    painter.drawPath(path);
    paintArrowHeads(painter, path, 1.5, 8.0, theme());
  }
  for (const sim2d::Robot& robot : document().scenario().robots) {
    if (robot.listed && robot.goal.point) {
      paintRobotGoal(painter, theme(), *robot.goal.point);
    }
  }
}

void FrameLayer::paintScans(QPainter& painter) const {
  for (const sim2d::RobotTelemetry& each : sensesOf(*frame_)) {
    if (each.scan) {
      paintScan(painter, theme(), *each.scan);
    }
  }
}

void FrameLayer::paintCandidateTrajectories(QPainter& painter) const {
  for (const sim2d::RobotTelemetry& each : sensesOf(*frame_)) {
    paintCandidates(painter, theme(), each);
  }
}

/// Draws the estimated poses of people and robots over the people.
void FrameLayer::paintEstimatedPoses(QPainter& painter) const {
  if (frame_->senses == nullptr) {
    return;
  }
  for (std::size_t i = 0; i < std::min(frame_->robots.size(), frame_->senses->size()); ++i) {
    paintTracks(painter, theme(), (*frame_->senses)[i].bodies,
                [this](const auto& track) { return positionOf(track.id); });
    const Body* robot = body(frame_->robots.id[i]);
    const std::optional<Pose2> believed = divergentPoseEstimate(*frame_, i);
    if (believed && robot != nullptr) {
      paintLocalizationError(painter, theme(), robot->pose.position, believed->position);
      Body ghost = *robot;
      ghost.pose = *believed;
      const double opacity = painter.opacity();
      painter.setOpacity(kEstimated * opacity);
      paintRobot(painter, ghost);
      painter.setOpacity(opacity);
    }
  }
}

void FrameLayer::paintTrails(QPainter& painter) const {
  const double seconds = trailSeconds(bodies_.size(), options().trailSeconds);
  for (const auto& [id, trail] : trails_.all()) {
    if (!trail.points.empty()) {
      const Body* there = body(id);
      paintTrail(painter, trail, there != nullptr ? there->pose.position : *trail.last,
                 frame_->time, seconds,
                 id < 0 ? theme().color(Role::RobotLine) : theme().line(agent(id).look));
    }
  }
}

/// Draws forces on the selected people, or on all if none is selected.
void FrameLayer::paintForces(QPainter& painter) const {
  const double scale = pixelsPerMetreOf(painter);
  const PixelFrame frame(painter, {});
  const OverlayPainter over(painter, theme(), {QPointF(), scale});
  const bool anyChosen = hasSelectedBody();
  for (const Body& body : bodies_) {
    if (body.isRobot() || (anyChosen && !isChosen(body))) {
      continue;
    }
    std::vector<ForceArrow> arrows = forcesOn(*frame_, body.id);
    if (!anyChosen && frame_->humans.size() > kMaxTerms && !arrows.empty()) {
      arrows.erase(arrows.begin(), arrows.end() - 1);
    }
    over.forces(body.pose.position, figureRadiusPx(body, scale) + (anyChosen ? 7.0 : 2.0), arrows);
  }
}

void FrameLayer::paintBubble(QPainter& painter, const Body& speaker, const Speech& speech) const {
  const double left = speech.since + kSpeechSeconds - frame_->time;
  const double radiusPx = figureRadiusPx(speaker, pixelsPerMetreOf(painter));
  const PixelFrame frame(painter, toScene(speaker.pose.position));
  painter.setOpacity(painter.opacity() * std::clamp(left / kSpeechFade, 0.0, 1.0));
  const QFont font = theme().font(9.0);
  const QRectF text = QFontMetricsF(font).boundingRect(QRectF(0.0, 0.0, kBubbleWidthPx, 200.0),
                                                       kBubbleText, speech.text);
  QRectF box(QPointF(), text.size() + QSizeF(20.0, 12.0));
  box.moveBottomLeft(QPointF(-14.0, -radiusPx - 12.0));
  QPainterPath bubble;
  bubble.addRoundedRect(box, 6.0, 6.0);
  QPainterPath tail;
  tail.addPolygon(QPolygonF({QPointF(-6.0, box.bottom() - 1.0), QPointF(8.0, box.bottom() - 1.0),
                             QPointF(0.0, -radiusPx - 3.0)}));
  tail.closeSubpath();
  setPenAndBrush(painter, QPen(theme().color(Role::FieldEdge), 1.0),
                 theme().color(theme().isDark() ? Role::Text : Role::Panel));
  painter.drawPath(bubble.united(tail));
  painter.setFont(font);
  painter.setPen(theme().color(theme().isDark() ? Role::Window : Role::Text));
  painter.drawText(box, kBubbleText, speech.text);
}

/// Draws dashed lines from a speaker to the listeners, which fade with the speech.
void FrameLayer::paintHearing(QPainter& painter) const {
  for (auto at = firstWithin(hearings_, frame_->time);
       at != hearings_.end() && at->since <= frame_->time; ++at) {
    const Body* const speaker = body(at->speaker);
    const Body* const listener = body(at->listener);
    if (speaker == nullptr || listener == nullptr) {
      continue;
    }
    const double left = at->since + kSpeechSeconds - frame_->time;
    const double alpha = 0.7 * std::clamp(left / kSpeechFade, 0.0, 1.0);
    setPenAndBrush(painter,
                   screenPen(painter, theme().color(Role::TextSecondary, alpha), 1.2, Qt::DotLine));
    painter.drawLine(toScene(speaker->pose.position), toScene(listener->pose.position));
  }
}

void FrameLayer::paintSpeech(QPainter& painter) const {
  std::map<int, const Speech*> latest;  // The newest speech of a person replaces older ones.
  for (auto at = firstWithin(speeches_, frame_->time);
       at != speeches_.end() && at->since <= frame_->time; ++at) {
    latest[at->id] = &*at;
  }
  for (const auto& [id, speech] : latest) {
    if (const Body* speaker = body(id)) {
      paintBubble(painter, *speaker, *speech);
    }
  }
}

}  // namespace editor
