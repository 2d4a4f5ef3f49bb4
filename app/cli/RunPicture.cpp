#include "app/cli/RunPicture.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <QPainter>
#include <QPainterPath>

#include "editor/look/FigurePainter.h"
#include "editor/look/Theme.h"

namespace app {

namespace {

using editor::Role;
using editor::Theme;
using sim2d::Vec2;

constexpr double kMargin = 32.0;        // px around the map
constexpr double kLegendWidth = 300.0;  // px
constexpr double kRowHeight = 26.0;     // px
constexpr int kFadeSteps = 12;

struct Track {
  int id = 0;
  std::vector<QPointF> points;  // world [m]
  std::vector<double> times;
  double heading = 0.0;
};

std::map<int, Track> tracksOf(const sim2d::Trace& trace) {
  std::map<int, Track> tracks;
  const auto add = [&tracks](const auto& columns, double time) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      Track& track = tracks[columns.id[k]];
      track.id = columns.id[k];
      track.points.emplace_back(columns.x[k], columns.y[k]);
      track.times.push_back(time);
      track.heading = columns.heading[k];
    }
  };
  for (const sim2d::Frame& frame : trace.frames) {
    add(frame.humans, frame.time);
    add(frame.robots, frame.time);
  }
  return tracks;
}

class RunPainter {
 public:
  RunPainter(const sim2d::Trace& trace, QPainter& painter, const QRectF& area)
      : trace_(trace), painter_(painter), tracks_(tracksOf(trace)), figures_(theme_) {
    const QRectF world = extent();
    const QRectF place = area.adjusted(kMargin, kMargin, -kMargin - kLegendWidth, -2 * kMargin);
    scale_ = std::min(place.width() / world.width(), place.height() / world.height());
    origin_ = QPointF(place.center().x() - world.center().x() * scale_,
                      place.center().y() + world.center().y() * scale_);
    mapRect_ = QRectF(toPicture(world.bottomLeft()), toPicture(world.topRight())).normalized();
  }

  void paint() {
    painter_.setRenderHint(QPainter::Antialiasing);
    paintMap();
    paintObstacles();
    for (const auto& [id, track] : tracks_) {
      paintTrack(track);
    }
    paintGoals();
    for (const auto& [id, track] : tracks_) {
      paintEnds(track);
    }
    paintScale();
    paintLegend();
  }

 private:
  QPointF toPicture(const QPointF& world) const {
    return {origin_.x() + world.x() * scale_, origin_.y() - world.y() * scale_};
  }
  QPointF toPicture(const Vec2& world) const { return toPicture(QPointF(world.x(), world.y())); }

  QRectF extent() const {
    QRectF box;
    const auto include = [&box](const Vec2& point) {
      const QRectF dot(point.x() - 0.5, point.y() - 0.5, 1.0, 1.0);
      box = box.isNull() ? dot : box.united(dot);
    };
    for (const sim2d::TraceObstacle& obstacle : trace_.header.obstacles) {
      for (const sim2d::Outline& outline : obstacle.outlines) {
        std::for_each(outline.points.begin(), outline.points.end(), include);
      }
    }
    for (const auto& [id, track] : tracks_) {
      for (const QPointF& point : track.points) {
        include(Vec2(point.x(), point.y()));
      }
    }
    return box.isNull() ? QRectF(-5.0, -5.0, 10.0, 10.0) : box;
  }

  void paintMap() {
    painter_.fillRect(mapRect_, theme_.color(Role::MapFree));
    const sim2d::OccupancyGrid& grid = trace_.header.map;
    if (grid.isEmpty()) {
      return;
    }
    QImage image(grid.width(), grid.height(), QImage::Format_RGB32);
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
    painter_.save();
    painter_.setClipRect(mapRect_);
    const QPointF corner = toPicture(grid.origin().position);
    painter_.translate(corner);
    painter_.rotate(-grid.origin().heading * 180.0 / base::kPi);
    const double width = grid.width() * grid.resolution() * scale_;
    const double height = grid.height() * grid.resolution() * scale_;
    painter_.drawImage(QRectF(0.0, -height, width, height), image);
    painter_.restore();
  }

  void paintObstacles() {
    painter_.setPen(QPen(theme_.color(Role::ObstacleEdge), 1.0));
    painter_.setBrush(theme_.color(Role::ObstacleFill));
    for (const sim2d::TraceObstacle& obstacle : trace_.header.obstacles) {
      if (obstacle.name == "map") {
        continue;
      }
      for (const sim2d::Outline& outline : obstacle.outlines) {
        QPolygonF polygon;
        for (const Vec2& point : outline.points) {
          polygon << toPicture(point);
        }
        painter_.drawPolygon(polygon);
      }
    }
  }

  template <class Body>
  static const Body* find(const std::vector<Body>& bodies, int id) {
    const auto found = std::find_if(bodies.begin(), bodies.end(),
                                    [id](const Body& body) { return body.id == id; });
    return found == bodies.end() ? nullptr : &*found;
  }
  const sim2d::TraceHuman* person(int id) const { return find(trace_.header.humans, id); }
  const sim2d::TraceRobot* robot(int id) const { return find(trace_.header.robots, id); }
  editor::Look lookOfPerson(int id) const {
    const sim2d::TraceHuman* human = person(id);
    return editor::lookOf(human ? static_cast<sim2d::BehaviorType>(human->behavior)
                                : sim2d::BehaviorType::Regular);
  }
  QColor colorOf(int id) const {
    return id < 0 ? theme_.color(Role::RobotLine) : theme_.line(lookOfPerson(id));
  }
  double radiusOf(int id) const {
    if (const sim2d::TraceRobot* machine = robot(id)) {
      return machine->radius;
    }
    const sim2d::TraceHuman* human = person(id);
    return human ? human->radius : 0.35;
  }

  /// Light at the start, full at the end: a few pieces of rising strength.
  void paintTrack(const Track& track) {
    if (track.points.size() < 2) {
      return;
    }
    const QColor full = colorOf(track.id);
    const std::size_t last = track.points.size() - 1;
    for (int piece = 0; piece < kFadeSteps; ++piece) {
      const std::size_t from = last * static_cast<std::size_t>(piece) / kFadeSteps;
      const std::size_t to = last * static_cast<std::size_t>(piece + 1) / kFadeSteps;
      QPolygonF line;
      for (std::size_t k = from; k <= to; ++k) {
        line << toPicture(track.points[k]);
      }
      QColor color = full;
      color.setAlphaF(0.22 + 0.78 * (piece + 1) / kFadeSteps);
      QPen pen(color, track.id < 0 ? 2.4 : 1.8, track.id < 0 ? Qt::DashLine : Qt::SolidLine,
               Qt::FlatCap, Qt::RoundJoin);
      painter_.setPen(pen);
      painter_.drawPolyline(line);
    }
  }

  void paintEnds(const Track& track) {
    painter_.setPen(QPen(colorOf(track.id), 2.0));
    painter_.setBrush(theme_.color(Role::MapFree));
    painter_.drawEllipse(toPicture(track.points.front()), 5.0, 5.0);
    const double radius = std::max(7.0, radiusOf(track.id) * scale_);
    const double heading = track.heading * 180.0 / base::kPi;
    painter_.save();
    painter_.translate(toPicture(track.points.back()));
    if (track.id < 0) {
      editor::RobotFigure figure;
      figure.radiusPx = radius;
      figure.headingDeg = heading;
      figures_.robot(painter_, figure);
    } else {
      editor::PersonFigure figure;
      figure.look = lookOfPerson(track.id);
      figure.radiusPx = radius;
      figure.headingDeg = heading;
      figures_.person(painter_, figure);
    }
    painter_.restore();
    label(track, radius);
  }

  /// The name below the figure, on a halo of the ground.
  void label(const Track& track, double radius) {
    const sim2d::TraceHuman* human = person(track.id);
    const sim2d::TraceRobot* machine = robot(track.id);
    const QString name = QString::fromStdString(human     ? human->name
                                                : machine ? machine->name
                                                          : std::string());
    painter_.setFont(theme_.font(9.0));
    const QFontMetricsF metrics(painter_.font());
    const QPointF end = toPicture(track.points.back());
    const QPointF baseline(end.x() - metrics.horizontalAdvance(name) / 2.0,
                           end.y() + radius + 13.0);
    const QPainterPath text = editor::textOutline(baseline, painter_.font(), name);
    painter_.strokePath(text, QPen(theme_.color(Role::MapFree, 0.85), 3.5));
    painter_.fillPath(text, theme_.color(Role::Text));
  }

  void paintGoals() {
    std::map<int, Vec2> goals;  // shared goals get one pin
    for (const sim2d::TraceHuman& human : trace_.header.humans) {
      for (const sim2d::TraceGoal& goal : human.goals) {
        goals.emplace(goal.id, goal.position);
      }
    }
    for (const auto& [id, position] : goals) {
      painter_.save();
      painter_.translate(toPicture(position));
      figures_.pin(painter_, QString::number(id), false);
      painter_.restore();
    }
    for (const sim2d::TraceRobot& machine : trace_.header.robots) {
      for (const sim2d::TraceGoal& goal : machine.goals) {
        painter_.setPen(QPen(theme_.color(Role::RobotBody), 2.0));
        painter_.setBrush(theme_.color(Role::RobotFront));
        painter_.drawEllipse(toPicture(goal.position), 8.0, 8.0);
      }
    }
  }

  void paintScale() {
    double metres = 1.0;
    for (const double nice : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
      metres = nice * scale_ <= 160.0 ? nice : metres;
    }
    const QPointF left(mapRect_.left(), mapRect_.bottom() + 20.0);
    const QPointF right(left.x() + metres * scale_, left.y());
    painter_.setPen(QPen(theme_.color(Role::Text), 1.5));
    painter_.drawLine(left, right);
    painter_.drawLine(left + QPointF(0.0, -5.0), left);
    painter_.drawLine(right + QPointF(0.0, -5.0), right);
    painter_.setFont(theme_.figureFont(9.0));
    painter_.drawText(right + QPointF(8.0, 1.0), QStringLiteral("%1 m").arg(metres));
  }

  void paintLegend() {
    double y = mapRect_.top() + 16.0;
    const double x = mapRect_.right() + kMargin;
    painter_.setPen(theme_.color(Role::Text));
    painter_.setFont(theme_.font(12.0, QFont::DemiBold));
    painter_.drawText(QPointF(x, y), QString::fromStdString(trace_.header.scenario));
    y += kRowHeight;
    painter_.setPen(theme_.color(Role::TextSecondary));
    painter_.setFont(theme_.figureFont(9.0));
    const double seconds = trace_.frames.empty() ? 0.0 : trace_.frames.back().time;
    painter_.drawText(
        QPointF(x, y),
        QStringLiteral("%1 s · seed %2").arg(seconds, 0, 'f', 1).arg(trace_.header.seed));
    y += 1.5 * kRowHeight;
    const double bottom = mapRect_.bottom() - kRowHeight;
    for (const sim2d::TraceRobot& machine : trace_.header.robots) {
      legendRow(x, y, machine.id, QString::fromStdString(machine.name), QStringLiteral("robot"));
      y += kRowHeight;
    }
    std::size_t shown = 0;
    for (const sim2d::TraceHuman& human : trace_.header.humans) {
      if (y > bottom) {
        break;
      }
      legendRow(x, y, human.id, QString::fromStdString(human.name),
                editor::lookName(lookOfPerson(human.id)));
      y += kRowHeight;
      ++shown;
    }
    painter_.setPen(theme_.color(Role::TextSecondary));
    if (shown < trace_.header.humans.size()) {
      painter_.drawText(
          QPointF(x, y),
          QStringLiteral("and %1 more people").arg(trace_.header.humans.size() - shown));
    }
    painter_.drawText(QPointF(x, mapRect_.bottom() + 21.0),
                      QStringLiteral("○ start   the figure stands at the end"));
  }

  void legendRow(double x, double y, int id, const QString& name, const QString& kind) {
    painter_.setPen(QPen(colorOf(id), 2.4, id < 0 ? Qt::DashLine : Qt::SolidLine));
    painter_.drawLine(QPointF(x, y - 4.0), QPointF(x + 28.0, y - 4.0));
    if (id >= 0) {
      figures_.mark(painter_, lookOfPerson(id), QPointF(x + 42.0, y - 4.0), 10.0);
    }
    painter_.setFont(theme_.font(9.5));
    painter_.setPen(theme_.color(Role::Text));
    painter_.drawText(QPointF(x + 56.0, y), name);
    painter_.setPen(theme_.color(Role::TextSecondary));
    painter_.drawText(QPointF(x + 176.0, y), kind);
  }

  const sim2d::Trace& trace_;
  QPainter& painter_;
  std::map<int, Track> tracks_;
  Theme theme_ = Theme::light();
  editor::FigurePainter figures_;
  double scale_ = 50.0;  // px per m
  QPointF origin_;       // of the world, in the picture
  QRectF mapRect_;
};

}  // namespace

QImage drawRun(const sim2d::Trace& trace, const QSize& size) {
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::white);
  QPainter painter(&image);
  RunPainter(trace, painter, QRectF(QPointF(0.0, 0.0), QSizeF(size))).paint();
  return image;
}

}  // namespace app
