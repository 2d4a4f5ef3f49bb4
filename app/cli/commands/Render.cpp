#include <algorithm>
#include <filesystem>
#include <map>

#include <CLI/CLI.hpp>

#include <QImage>
#include <QImageWriter>
#include <QPainter>
#include <QPainterPath>
#include <QSaveFile>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/report/Page.h"
#include "app/run/RunFolder.h"
#include "editor/look/FigurePainter.h"
#include "editor/look/Images.h"
#include "editor/look/Theme.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Trace.h"

namespace app {

namespace {

struct RenderOptions {
  std::string run;     // folder of a run
  std::string output;  // picture
};

namespace fs = std::filesystem;
using editor::Role;
using editor::Theme;
using sim2d::Vec2;

constexpr QSize kSize(1600, 1000);
constexpr double kMargin = 32.0;        // px around the map
constexpr double kLegendWidth = 300.0;  // px
constexpr double kRowHeight = 26.0;     // px
constexpr int kFadeSteps = 12;

/// The way of somebody, and how they are drawn.
struct Track {
  int id = 0;  // of robots: below 0
  std::vector<Vec2> points;
  double heading = 0.0;
  QString name;
  double radius = 0.35;  // [m]
};

std::map<int, Track> tracksOf(const sim2d::Trace& trace) {
  std::map<int, Track> tracks;
  const auto add = [&tracks](const auto& columns) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      Track& track = tracks[columns.id[k]];
      track.id = columns.id[k];
      track.points.emplace_back(columns.x[k], columns.y[k]);
      track.heading = columns.heading[k];
    }
  };
  for (const sim2d::Frame& frame : trace.frames) {
    add(frame.humans);
    add(frame.robots);
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

/// The picture of a run for a paper: map and obstacles on white, trajectories fading from light to
/// full in time, starts as rings, goals as pins, legend and scale beside the map.
class RunPainter {
 public:
  RunPainter(const sim2d::Trace& trace, QPainter& painter)
      : trace_(trace), painter_(painter), tracks_(tracksOf(trace)), figures_(theme_) {
    const QRectF world = extent();
    const QRectF place(kMargin, kMargin, kSize.width() - 2 * kMargin - kLegendWidth,
                       kSize.height() - 3 * kMargin);
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
  template <class Point>
  QPointF toPicture(const Point& world) const {
    return {origin_.x() + world.x() * scale_, origin_.y() - world.y() * scale_};
  }
  QPolygonF toPicture(const std::vector<Vec2>& world) const {
    QPolygonF polygon;
    for (const Vec2& point : world) {
      polygon << toPicture(point);
    }
    return polygon;
  }

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
      std::for_each(track.points.begin(), track.points.end(), include);
    }
    return box.isNull() ? QRectF(-5.0, -5.0, 10.0, 10.0) : box;
  }

  void paintMap() {
    painter_.fillRect(mapRect_, theme_.color(Role::MapFree));
    const sim2d::OccupancyGrid& grid = trace_.header.map;
    if (grid.isEmpty()) {
      return;
    }
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
        painter_.drawPolygon(toPicture(outline.points));
      }
    }
  }

  /// Of a person.
  editor::Look lookOf(int id) const {
    const std::vector<sim2d::TraceHuman>& humans = trace_.header.humans;
    const auto found = std::find_if(humans.begin(), humans.end(),
                                    [id](const auto& human) { return human.id == id; });
    return editor::lookOf(found != humans.end() ? static_cast<sim2d::BehaviorType>(found->behavior)
                                                : sim2d::BehaviorType::Regular);
  }
  QColor colorOf(int id) const {
    return id < 0 ? theme_.color(Role::RobotLine) : theme_.line(lookOf(id));
  }

  /// Light at the start, full at the end: a few pieces of rising strength.
  void paintTrack(const Track& track) {
    if (track.points.size() < 2) {
      return;
    }
    const QColor full = colorOf(track.id);
    const QPolygonF line = toPicture(track.points);
    const int last = line.size() - 1;
    for (int piece = 0; piece < kFadeSteps; ++piece) {
      const auto from = line.begin() + last * piece / kFadeSteps;
      const auto to = line.begin() + last * (piece + 1) / kFadeSteps;
      QColor color = full;
      color.setAlphaF(0.22 + 0.78 * (piece + 1) / kFadeSteps);
      painter_.setPen(QPen(color, track.id < 0 ? 2.4 : 1.8,
                           track.id < 0 ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap,
                           Qt::RoundJoin));
      painter_.drawPolyline(&*from, static_cast<int>(to - from) + 1);
    }
  }

  void paintEnds(const Track& track) {
    painter_.setPen(QPen(colorOf(track.id), 2.0));
    painter_.setBrush(theme_.color(Role::MapFree));
    painter_.drawEllipse(toPicture(track.points.front()), 5.0, 5.0);
    const double radius = std::max(7.0, track.radius * scale_);
    const double heading = track.heading * 180.0 / base::kPi;
    painter_.save();
    painter_.translate(toPicture(track.points.back()));
    if (track.id < 0) {
      figures_.robot(painter_, {radius, heading, {}});
    } else {
      editor::PersonFigure figure;
      figure.look = lookOf(track.id);
      figure.radiusPx = radius;
      figure.headingDeg = heading;
      figures_.person(painter_, figure);
    }
    painter_.restore();
    label(track, radius);
  }

  /// The name below the figure, on a halo of the ground.
  void label(const Track& track, double radius) {
    painter_.setFont(theme_.font(9.0));
    const QFontMetricsF metrics(painter_.font());
    const QPointF end = toPicture(track.points.back());
    const QPointF baseline(end.x() - metrics.horizontalAdvance(track.name) / 2.0,
                           end.y() + radius + 13.0);
    const QPainterPath text = editor::textOutline(baseline, painter_.font(), track.name);
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
                editor::lookName(lookOf(human.id)));
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
      figures_.mark(painter_, lookOf(id), QPointF(x + 42.0, y - 4.0), 10.0);
    }
    painter_.setFont(theme_.font(9.5));
    painter_.setPen(theme_.color(Role::Text));
    painter_.drawText(QPointF(x + 56.0, y), name);
    painter_.setPen(theme_.color(Role::TextSecondary));
    painter_.drawText(QPointF(x + 176.0, y), kind);
  }

  const sim2d::Trace& trace_;
  QPainter& painter_;
  const std::map<int, Track> tracks_;
  const Theme theme_ = Theme::light();
  editor::FigurePainter figures_;
  double scale_ = 50.0;  // px per m
  QPointF origin_;       // of the world, in the picture
  QRectF mapRect_;
};

base::Diagnostics saveImage(const QImage& image, const std::string& path) {
  std::error_code ignored;  // an impossible folder shows when the file is opened
  fs::create_directories(fs::path(path).parent_path(), ignored);
  QSaveFile file(QString::fromStdString(path));
  if (!file.open(QIODevice::WriteOnly)) {
    return {base::error("file.cannot-write-picture", {file.errorString().toStdString()}, path)};
  }
  QImageWriter writer(&file, "png");
  if (!writer.write(image) || !file.commit()) {
    return {base::error("file.cannot-write-picture", {writer.errorString().toStdString()}, path)};
  }
  return {};
}

int renderCommand(const RenderOptions& options, const Invocation& given) {
  const std::string ending = base::lowered(fs::path(options.output).extension().string());
  if (ending != ".png" && ending != ".html") {
    printError(base::error("option.picture-format", {ending}, options.output).text());
    return ExitWrongCommandLine;
  }
  const base::Result<sim2d::Trace> trace = readRun(options.run);
  requireFine(trace.diagnostics());
  if (ending == ".html") {
    const std::string& name = trace->header.scenario;
    requireFine(base::writeFileAtomically(options.output, report::playerPage(*trace, name)));
    if (!given.quiet) {
      printLine(options.output);
    }
    return ExitFine;
  }
  QImage image = editor::blankImage(kSize, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::white);
  QPainter painter(&image);
  RunPainter(*trace, painter).paint();
  painter.end();
  requireFine(saveImage(image, options.output));
  if (!given.quiet) {
    printLine(options.output);
  }
  return ExitFine;
}

Drawing drawingOf(const RenderOptions& /*options*/) {
  return Drawing::Pictures;
}

}  // namespace

void addRender(CommandRegistry& commands) {
  const auto [command, options] =
      commands.add("render", "Draw a recorded run", renderCommand, drawingOf);
  command.add_option("run", options.run, "Folder of the run")->required();
  command
      .add_option("-o,--output", options.output,
                  "Picture (.png), or a page that plays the run (.html)")
      ->required();
}

}  // namespace app
