#include "app/cli/FigureMap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QPainterPath>

#include "editor/canvas/Layers.h"
#include "editor/look/FigurePainter.h"
#include "sim2d/trace/ContactMarks.h"

namespace app {

const std::vector<std::string>& figureOverlayNames() {
  static const std::vector<std::string> kNames = {"density",    "zones",  "gaussian",
                                                  "velocities", "forces", "contacts"};
  return kNames;
}

void FigureText::write(QPainter& painter, const QPointF& baseline, const QFont& font,
                       editor::Role role, const QString& text) const {
  if (asOutlines_) {
    painter.fillPath(editor::textOutline(baseline, font, text), theme_.color(role));
  } else {
    painter.setFont(font);
    painter.setPen(theme_.color(role));
    painter.drawText(baseline, text);
  }
}

std::map<int, Track> tracksOf(const sim2d::Trace& trace) {
  std::map<int, Track> tracks;
  const auto add = [&tracks](const auto& columns, double time) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      Track& track = tracks[columns.id[k]];
      track.id = columns.id[k];
      track.points.emplace_back(columns.x[k], columns.y[k]);
      track.headings.push_back(columns.heading[k]);
      track.velocities.emplace_back(columns.vx[k], columns.vy[k]);
      track.times.push_back(time);
    }
  };
  for (const sim2d::Frame& frame : trace.frames) {
    add(frame.humans, frame.time);
    add(frame.robots, frame.time);
  }
  const auto describe = [&tracks](const auto& bodies) {
    for (const auto& body : bodies) {
      if (const auto found = tracks.find(body.id); found != tracks.end()) {
        found->second.name = QString::fromStdString(body.name);
        found->second.radius = body.radius;
      }
    }
  };
  describe(trace.header.humans);
  describe(trace.header.robots);
  return tracks;
}

using editor::Role;
using editor::Theme;
using sim2d::Vec2;

namespace {

constexpr double kMinStep = 0.25;  // [px] between the points of a trajectory
constexpr double kMargin = 0.5;    // [m] margin around the drawn area
constexpr int kFadeSteps = 12;
constexpr double kTinyMap = 30.0;         // [px/m]
constexpr double kMapOversampling = 3.0;  // image pixels per picture pixel

}  // namespace

double barLength(double pixelsPerMetre, double longest) {
  double metres = 1.0;
  for (const double nice : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    metres = nice * pixelsPerMetre <= longest ? nice : metres;
  }
  return metres;
}

FigureMap::FigureMap(const sim2d::Trace& trace, const FigureSizes& sizes, const FigureText& text,
                     const FigureOptions& options)
    : trace_(trace),
      sizes_(sizes),
      text_(text),
      theme_(text.theme()),
      options_(options),
      tracks_(tracksOf(trace)),
      contacts_(sim2d::contactMarks(trace)),
      figures_(theme_),
      world_(extent()) {}

void FigureMap::place(const QRectF& room) {
  frame_.scale = std::min(room.width() / world_.width(), room.height() / world_.height());
  frame_.origin = room.center() + QPointF(-world_.center().x(), world_.center().y()) * frame_.scale;
  mapRect_ =
      QRectF(frame_.at({world_.left(), world_.top()}), frame_.at({world_.right(), world_.bottom()}))
          .normalized();
  map_ = drawnMap();
}

double FigureMap::drawnLeft() const {
  return mapRect_.left() + kMargin * frame_.scale;
}

double FigureMap::lastTime() const {
  return trace_.frames.empty() ? 0.0 : trace_.frames.back().time;
}

void FigureMap::paint(QPainter& painter, std::optional<double> time) {
  painter_ = &painter;
  isWhole_ = !time;
  time_ = std::min(time.value_or(lastTime()), lastTime()) + 1e-9;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.drawImage(mapRect_, map_);
  paintObstacles();
  paintGround();
  for (const auto& [id, track] : tracks_) {
    paintTrack(track);
  }
  paintGoals();
  for (const auto& [id, track] : tracks_) {
    paintStart(track);
  }
  if (options_.timeMarks > 0.0) {
    paintTimeMarks();
  }
  for (const auto& [id, track] : tracks_) {
    paintBody(track);
  }
  paintTop();
  if (options_.names) {
    paintNames();
  }
}

void FigureMap::paintScale(QPainter& painter, const QPointF& left) const {
  const double metres = barLength(frame_.scale, sizes_.isNarrow ? 90.0 : 160.0);
  const QPointF right(left.x() + metres * frame_.scale, left.y());
  painter.setPen(QPen(theme_.color(Role::Text), 1.5));
  painter.drawLine(left, right);
  painter.drawLine(left + QPointF(0.0, -5.0), left);
  painter.drawLine(right + QPointF(0.0, -5.0), right);
  text_.write(painter, right + QPointF(8.0, 1.0), theme_.figureFont(sizes_.small()), Role::Text,
              QStringLiteral("%1 m").arg(metres));
}

QRectF FigureMap::extent() const {
  QRectF box;
  const auto include = [&box](const Vec2& point) {
    const QRectF dot(point.x() - kMargin, point.y() - kMargin, 2.0 * kMargin, 2.0 * kMargin);
    box = box.isNull() ? dot : box.united(dot);
  };
  for (const sim2d::TraceObstacle& obstacle : trace_.header.obstacles) {
    for (const sim2d::Outline& outline : obstacle.outlines) {
      std::for_each(outline.points.begin(), outline.points.end(), include);
    }
  }
  for (const auto& [id, track] : tracks_) {
    std::for_each(track.points.begin(), track.points.end(), include);
  }
  return box.isNull() ? QRectF(-5.0, -5.0, 10.0, 10.0) : box;
}

/// The map with its walls, clipped. An image, because not every paint device can clip.
QImage FigureMap::drawnMap() const {
  constexpr double kMaxSide = 4000.0;  // [px]; a limit for poster-sized pictures
  const QSizeF wanted = mapRect_.size() * (sizes_.isNarrow ? kMapOversampling : 1.0);
  const double longer = std::max(wanted.width(), wanted.height());
  const QSize pixels = (wanted * std::min(1.0, kMaxSide / std::max(longer, 1.0))).toSize();
  QImage drawn = editor::blankImage(pixels.expandedTo(QSize(1, 1)), QImage::Format_RGB32);
  drawn.fill(theme_.color(Role::MapFree));
  const sim2d::OccupancyGrid& grid = trace_.header.map;
  if (grid.isEmpty()) {
    return drawn;
  }
  QPainter painter(&drawn);
  painter.scale(drawn.width() / mapRect_.width(), drawn.height() / mapRect_.height());
  painter.translate(frame_.at(grid.origin().position) - mapRect_.topLeft());
  painter.rotate(-grid.origin().heading * 180.0 / base::kPi);
  const double width = grid.width() * grid.resolution() * frame_.scale;
  const double height = grid.height() * grid.resolution() * frame_.scale;
  painter.drawImage(QRectF(0.0, -height, width, height), cellImage(grid));
  return drawn;
}

QImage FigureMap::cellImage(const sim2d::OccupancyGrid& grid) const {
  QImage image = editor::blankImage({grid.width(), grid.height()}, QImage::Format_RGB32);
  for (int row = 0; row < grid.height(); ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(grid.height() - 1 - row));
    for (int column = 0; column < grid.width(); ++column) {
      const sim2d::Cell cell{column, row};
      const Role role = grid.isWall(cell)      ? Role::MapOccupied
                        : grid.isUnknown(cell) ? Role::MapUnknown
                                               : Role::MapFree;
      line[column] = theme_.color(role).rgb();
    }
  }
  return image;
}

void FigureMap::paintObstacles() const {
  painter_->setPen(QPen(theme_.color(Role::ObstacleEdge), 1.0));
  painter_->setBrush(theme_.color(Role::ObstacleFill));
  for (const sim2d::TraceObstacle& obstacle : trace_.header.obstacles) {
    if (obstacle.name == "map") {
      continue;
    }
    for (const sim2d::Outline& outline : obstacle.outlines) {
      painter_->drawPolygon(frame_.at(outline.points));
    }
  }
}

editor::Look FigureMap::lookOf(int id) const {
  if (options_.customTrees.count(id) > 0) {
    return editor::Look::CustomTree;
  }
  const sim2d::TraceHuman* const human = trace_.header.human(id);
  return human != nullptr ? editor::lookOf(*human) : editor::Look::Regular;
}
QColor FigureMap::colorOf(int id) const {
  return id < 0 ? theme_.color(Role::RobotLine) : theme_.line(lookOf(id));
}

/// Up to the current time, without points closer than kMinStep.
QPolygonF FigureMap::lineOf(const Track& track) const {
  QPolygonF line;
  const std::size_t count = track.countUntil(time_);
  for (std::size_t k = 0; k < count; ++k) {
    const QPointF point = frame_.at(track.points[k]);
    const QPointF step = line.isEmpty() ? point : point - line.back();
    if (line.isEmpty() || std::hypot(step.x(), step.y()) >= kMinStep || k + 1 == count) {
      line << point;
    }
  }
  return line;
}

/// Fades from light at the start to full at the end, in kFadeSteps steps of opacity.
void FigureMap::paintTrack(const Track& track) const {
  const QPolygonF line = lineOf(track);
  if (line.size() < 2) {
    return;
  }
  const QColor full = colorOf(track.id);
  const int last = line.size() - 1;
  for (int piece = 0; piece < kFadeSteps; ++piece) {
    const auto from = line.begin() + last * piece / kFadeSteps;
    const auto to = line.begin() + last * (piece + 1) / kFadeSteps;
    QColor color = full;
    color.setAlphaF(0.22 + 0.78 * (piece + 1) / kFadeSteps);
    painter_->setPen(QPen(color, sizes_.line() * (track.id < 0 ? 4.0 / 3.0 : 1.0),
                          track.id < 0 ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter_->drawPolyline(&*from, static_cast<int>(to - from) + 1);
  }
}

void FigureMap::paintStart(const Track& track) const {
  if (track.countUntil(time_) > 0) {
    const double ring = 0.7 * sizes_.body();
    painter_->setPen(QPen(colorOf(track.id), 1.1 * sizes_.line()));
    painter_->setBrush(theme_.color(Role::MapFree));
    painter_->drawEllipse(frame_.at(track.points.front()), ring, ring);
  }
}

/// The index of the drawn position; nullopt: the body is not present.
std::optional<std::size_t> FigureMap::positionIndexOf(const Track& track) const {
  const std::size_t count = track.countUntil(time_);
  const bool isSeen =
      count > 0 && (isWhole_ || track.times[count - 1] >= trace_.frames[currentFrame()].time);
  return isSeen ? std::optional(count - 1) : std::nullopt;
}
double FigureMap::radiusOf(const Track& track) const {
  return std::max(sizes_.body(), track.radius * frame_.scale);
}

void FigureMap::paintBody(const Track& track) const {
  const std::optional<std::size_t> at = positionIndexOf(track);
  if (!at) {
    return;
  }
  const double heading = track.headings[*at] * 180.0 / base::kPi;
  painter_->save();
  painter_->translate(frame_.at(track.points[*at]));
  if (track.id < 0) {
    figures_.robot(*painter_, {radiusOf(track), heading, {}});
  } else {
    editor::PersonFigure figure;
    figure.look = lookOf(track.id);
    figure.radiusPx = radiusOf(track);
    figure.headingDeg = heading;
    figures_.person(*painter_, figure);
  }
  painter_->restore();
}

std::vector<editor::Label> FigureMap::nameLabels(const QFontMetricsF& metrics) const {
  const double gap = std::max(0.0, (sizes_.isNarrow ? 10.0 : 13.0) - metrics.ascent());
  std::vector<editor::Label> labels;
  for (const auto& [id, track] : tracks_) {
    const std::optional<std::size_t> at = positionIndexOf(track);
    if (!at || track.name.isEmpty()) {
      continue;
    }
    editor::Label& label = labels.emplace_back();
    label.text = track.name;
    label.centre = frame_.at(track.points[*at]);
    label.clearancePx = radiusOf(track) + gap;
    label.size = {metrics.horizontalAdvance(track.name), metrics.height()};
    label.priority = id < 0 ? 1 : 0;
    label.isNeeded = true;
    const auto side = sides_.find(track.name);
    label.side = side == sides_.end() ? editor::Label::kNoSide : side->second;
  }
  return labels;
}

/// The names of the bodies, with halos in the ground colour. They do not cover each other and,
/// where there is space, no bodies; from one painted state to the next they keep their sides.
void FigureMap::paintNames() {
  const QFont font = theme_.font(sizes_.small());
  const QFontMetricsF metrics(font);
  const std::vector<editor::Label> labels = nameLabels(metrics);
  std::vector<QRectF> bodies;
  for (const auto& [id, track] : tracks_) {
    if (const std::optional<std::size_t> at = positionIndexOf(track)) {
      bodies.push_back(editor::around(frame_.at(track.points[*at]), radiusOf(track) - 1.0));
    }
  }
  nameRects_ = editor::layoutLabels(labels, bodies, mapRect_);
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const QRectF& place = nameRects_[k];
    sides_[labels[k].text] = editor::sideOf(labels[k], place, mapRect_);
    if (!place.isNull()) {
      const QPainterPath text =
          editor::textOutline({place.left(), place.top() + metrics.ascent()}, font, labels[k].text);
      painter_->strokePath(text, QPen(theme_.color(Role::MapFree, 0.85), 3.5));
      painter_->fillPath(text, theme_.color(Role::Text));
    }
  }
}

void FigureMap::paintGoals() const {
  std::map<int, Vec2> goals;  // shared goals get one pin
  for (const sim2d::TraceHuman& human : trace_.header.humans) {
    for (const sim2d::TraceGoal& goal : human.goals) {
      goals.emplace(goal.id, goal.position);
    }
  }
  for (const auto& [id, position] : goals) {
    painter_->save();
    painter_->translate(frame_.at(position));
    pin(QString::number(id));
    painter_->restore();
  }
  for (const sim2d::TraceRobot& machine : trace_.header.robots) {
    for (const sim2d::TraceGoal& goal : machine.goals) {
      painter_->setPen(QPen(theme_.color(Role::RobotBody), 1.1 * sizes_.line()));
      painter_->setBrush(theme_.color(Role::RobotFront));
      painter_->drawEllipse(frame_.at(goal.position), 1.15 * sizes_.body(), 1.15 * sizes_.body());
    }
  }
}

/// At the painter's origin, with the number written by text_.
void FigureMap::pin(const QString& number) const {
  const bool isTiny =
      !options_.names && frame_.scale < kTinyMap;  // in a strip, which has no space for numbers
  const double scale = isTiny ? 0.45 : sizes_.isNarrow ? 0.8 : 1.0;
  figures_.pin(*painter_, {}, false, scale);
  if (isTiny) {
    return;
  }
  QFont font = theme_.figureFont();
  font.setPixelSize(static_cast<int>((number.size() > 2 ? 8 : 11) * scale));
  font.setWeight(QFont::DemiBold);
  const QFontMetricsF metrics(font);
  text_.write(*painter_,
              {-0.5 * metrics.horizontalAdvance(number), -17.0 * scale + 0.5 * metrics.capHeight()},
              font, Role::Text, number);
}

/// Dots on the trajectories, with the time beside them where it fits.
void FigureMap::paintTimeMarks() const {
  const QFont font = theme_.figureFont(sizes_.small() - 1.0);
  const QFontMetricsF metrics(font);
  std::vector<QRectF> taken;
  for (const auto& [id, track] : tracks_) {
    for (int mark = 1; mark * options_.timeMarks <= time_; ++mark) {
      const double time = mark * options_.timeMarks;
      const std::size_t count = track.countUntil(time + 1e-9);
      if (count == 0 || track.times[count - 1] < time - options_.timeMarks ||
          time > track.times.back() + 1e-9) {
        continue;
      }
      const QPointF at = frame_.at(track.points[count - 1]);
      painter_->setPen(QPen(colorOf(id), sizes_.line()));
      painter_->setBrush(theme_.color(Role::MapFree));
      painter_->drawEllipse(at, 1.7 * sizes_.line(), 1.7 * sizes_.line());
      const QString timeText = QString::number(time, 'g', 6);
      const QRectF box(at.x() + 4.0, at.y() - metrics.ascent() - 1.0,
                       metrics.horizontalAdvance(timeText) + 2.0, metrics.height());
      if (std::none_of(taken.begin(), taken.end(),
                       [&box](const QRectF& other) { return other.intersects(box); })) {
        taken.push_back(box);
        text_.write(*painter_, box.bottomLeft() + QPointF(0.0, -metrics.descent()), font,
                    Role::TextSecondary, timeText);
      }
    }
  }
}

/// The frame at the painted time.
std::size_t FigureMap::currentFrame() const {
  const auto next =
      std::upper_bound(trace_.frames.begin(), trace_.frames.end(), time_,
                       [](double time, const sim2d::Frame& frame) { return time < frame.time; });
  return next == trace_.frames.begin() ? 0
                                       : static_cast<std::size_t>(next - trace_.frames.begin()) - 1;
}

void FigureMap::paintGround() {
  const bool isAnything =
      has(FigureOverlay::Density) || has(FigureOverlay::Zones) || has(FigureOverlay::Gaussian);
  if (!isAnything || trace_.frames.empty()) {
    return;
  }
  const sim2d::HumanColumns& people = trace_.frames[currentFrame()].humans;
  editor::OverlayPainter over(*painter_, theme_, frame_, sizes_.line() / 1.8);
  over.limitTo(mapRect_);
  if (has(FigureOverlay::Density)) {
    std::vector<Vec2> places;
    for (std::size_t k = 0; k < people.size(); ++k) {
      places.emplace_back(people.x[k], people.y[k]);
    }
    const metrics::DensityField field = metrics::densityField(
        places, {world_.left(), world_.top()}, {world_.right(), world_.bottom()}, 0.1);
    maxDensity_ = editor::densityScale(field.peak());
    over.density(field, editor::densityImage(field, theme_, maxDensity_));
  }
  for (std::size_t k = 0; k < people.size(); ++k) {
    const base::Pose2 pose{{people.x[k], people.y[k]}, people.heading[k]};
    if (has(FigureOverlay::Zones)) {
      over.hallZones(pose.position, theme_.fill(lookOf(people.id[k])), people.size() <= 12);
    }
    if (has(FigureOverlay::Gaussian)) {
      over.gaussian(pose, std::hypot(people.vx[k], people.vy[k]), colorOf(people.id[k]));
    }
  }
}

void FigureMap::paintForces(const editor::OverlayPainter& over) const {
  const sim2d::Frame& frame = trace_.frames[currentFrame()];
  for (std::size_t k = 0; k < frame.humans.size(); ++k) {
    const auto track = tracks_.find(frame.humans.id[k]);
    over.forces({frame.humans.x[k], frame.humans.y[k]}, radiusOf(track->second) + 1.0,
                editor::forcesOn(frame, frame.humans.id[k]));
  }
}

void FigureMap::paintTop() const {
  const editor::OverlayPainter over(*painter_, theme_, frame_, sizes_.line() / 1.8);
  if (has(FigureOverlay::Velocities)) {
    std::vector<editor::MovingBody> moving;
    for (const auto& [id, track] : tracks_) {
      if (const std::optional<std::size_t> at = positionIndexOf(track)) {
        moving.push_back(
            {track.points[*at], track.velocities[*at], radiusOf(track) + 1.0, colorOf(id)});
      }
    }
    over.velocities(moving);
  }
  if (has(FigureOverlay::Forces) && !trace_.frames.empty()) {
    paintForces(over);
  }
  if (has(FigureOverlay::Contacts)) {
    for (const sim2d::ContactMark& mark : contacts_) {
      if (mark.time <= time_) {
        over.contact(mark, std::numeric_limits<double>::infinity());
      }
    }
  }
}

}  // namespace app
