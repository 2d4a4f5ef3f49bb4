#include "app/cli/RunPicture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <QPainterPath>

#include "editor/look/FigurePainter.h"
#include "editor/look/Images.h"
#include "editor/look/Theme.h"

namespace app {

using editor::Role;
using editor::Theme;
using sim2d::Vec2;

namespace {

constexpr double kNarrow = 900.0;    // px: below this the legend stands under the map
constexpr double kLeastStep = 0.25;  // px between the points of a way
constexpr double kLegendTop = 16.0;  // px to the title of a legend beside the map
constexpr double kAround = 0.5;      // [m] of the ground around what is drawn
constexpr double kTallest = 1.4;     // height of the map over the width of the picture
constexpr int kFadeSteps = 12;
constexpr double kMapDetail = 3.0;  // px of its image for each of the picture

/// Sizes that follow from the width [px].
struct Measures {
  explicit Measures(double width) : isNarrow(width < kNarrow) {}
  bool isNarrow;
  double margin() const { return isNarrow ? 10.0 : 32.0; }  // around the map
  double legend() const { return isNarrow ? 0.0 : 300.0; }  // beside it
  double row() const { return isNarrow ? 16.0 : 26.0; }
  double column() const { return 150.0; }                 // of the legend below the map, at least
  double foot() const { return isNarrow ? 24.0 : 32.0; }  // with the scale
  double title() const { return isNarrow ? 9.0 : 12.0; }  // pt
  double text() const { return isNarrow ? 8.0 : 9.5; }
  double small() const { return isNarrow ? 8.0 : 9.0; }
  double body() const { return isNarrow ? 5.0 : 7.0; }  // the least radius of a figure
  double line() const { return isNarrow ? 1.2 : 1.8; }
};

/// The way of somebody, and how they are drawn.
struct Track {
  int id = 0;  // of robots: below 0
  std::vector<Vec2> points;
  std::vector<double> times, headings;  // of each
  QString name;
  double radius = 0.35;  // [m]

  /// How many points lie no later.
  std::size_t until(double time) const {
    const auto end = std::upper_bound(times.begin(), times.end(), time);
    return static_cast<std::size_t>(end - times.begin());
  }
};

std::map<int, Track> tracksOf(const sim2d::Trace& trace) {
  std::map<int, Track> tracks;
  const auto add = [&tracks](const auto& columns, double time) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      Track& track = tracks[columns.id[k]];
      track.id = columns.id[k];
      track.points.emplace_back(columns.x[k], columns.y[k]);
      track.headings.push_back(columns.heading[k]);
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

/// Whole metres that a bar of the scale may stand for.
double barLength(double pixelsPerMetre, double longest) {
  double metres = 1.0;
  for (const double nice : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    metres = nice * pixelsPerMetre <= longest ? nice : metres;
  }
  return metres;
}

}  // namespace

class RunPicture::Painting {
 public:
  Painting(const sim2d::Trace& trace, const PictureLayout& layout)
      : trace_(trace),
        layout_(layout),
        measures_(layout.width),
        tracks_(tracksOf(trace)),
        figures_(theme_) {
    const QRectF world = extent();
    const double margin = measures_.margin();
    const double width = layout.width - 2.0 * margin - measures_.legend();
    const double rest = 2.0 * margin + measures_.foot() + legendBelow();
    const double most = layout.height ? *layout.height - rest : kTallest * layout.width;
    scale_ = std::min(width / world.width(), most / world.height());
    const double high =
        layout.height ? most : std::max(scale_ * world.height(), legendBeside() - 2.0 * margin);
    const QPointF middle(margin + 0.5 * width, margin + 0.5 * high);
    origin_ = middle + QPointF(-world.center().x(), world.center().y()) * scale_;
    mapRect_ = QRectF(toPicture(world.bottomLeft()), toPicture(world.topRight())).normalized();
    size_ = QSizeF(layout.width, layout.height ? *layout.height : std::ceil(high + rest));
    map_ = drawnMap();
  }

  QSizeF size() const { return size_; }

  void paint(QPainter& painter, std::optional<double> time) {
    painter_ = &painter;
    isWhole_ = !time;
    const double last = trace_.frames.empty() ? 0.0 : trace_.frames.back().time;
    time_ = std::min(time.value_or(last), last) + 1e-9;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(QRectF(QPointF(), size_), Qt::white);
    painter.drawImage(mapRect_, map_);
    paintObstacles();
    for (const auto& [id, track] : tracks_) {
      paintTrack(track);
    }
    paintGoals();
    for (const auto& [id, track] : tracks_) {
      paintStart(track);
    }
    for (const auto& [id, track] : tracks_) {
      paintBody(track);
    }
    for (const auto& [id, track] : tracks_) {
      label(track);
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
      const QRectF dot(point.x() - kAround, point.y() - kAround, 2.0 * kAround, 2.0 * kAround);
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

  /// With its walls, cut to its place. An image: not all that draws can cut.
  QImage drawnMap() const {
    const QSize pixels = (mapRect_.size() * (measures_.isNarrow ? kMapDetail : 1.0)).toSize();
    QImage drawn = editor::blankImage(pixels.expandedTo(QSize(1, 1)), QImage::Format_RGB32);
    drawn.fill(theme_.color(Role::MapFree));
    const sim2d::OccupancyGrid& grid = trace_.header.map;
    if (grid.isEmpty()) {
      return drawn;
    }
    QPainter painter(&drawn);
    painter.scale(drawn.width() / mapRect_.width(), drawn.height() / mapRect_.height());
    painter.translate(toPicture(grid.origin().position) - mapRect_.topLeft());
    painter.rotate(-grid.origin().heading * 180.0 / base::kPi);
    const double width = grid.width() * grid.resolution() * scale_;
    const double height = grid.height() * grid.resolution() * scale_;
    painter.drawImage(QRectF(0.0, -height, width, height), cellImage(grid));
    return drawn;
  }

  QImage cellImage(const sim2d::OccupancyGrid& grid) const {
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

  void paintObstacles() {
    painter_->setPen(QPen(theme_.color(Role::ObstacleEdge), 1.0));
    painter_->setBrush(theme_.color(Role::ObstacleFill));
    for (const sim2d::TraceObstacle& obstacle : trace_.header.obstacles) {
      if (obstacle.name == "map") {
        continue;
      }
      for (const sim2d::Outline& outline : obstacle.outlines) {
        painter_->drawPolygon(toPicture(outline.points));
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

  /// Up to now, without points that nobody could tell apart.
  QPolygonF lineOf(const Track& track) const {
    QPolygonF line;
    const std::size_t count = track.until(time_);
    for (std::size_t k = 0; k < count; ++k) {
      const QPointF point = toPicture(track.points[k]);
      const QPointF step = line.isEmpty() ? point : point - line.back();
      if (line.isEmpty() || std::hypot(step.x(), step.y()) >= kLeastStep || k + 1 == count) {
        line << point;
      }
    }
    return line;
  }

  /// Light at the start, full at the end: a few pieces of rising strength.
  void paintTrack(const Track& track) {
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
      painter_->setPen(QPen(color, measures_.line() * (track.id < 0 ? 4.0 / 3.0 : 1.0),
                            track.id < 0 ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap,
                            Qt::RoundJoin));
      painter_->drawPolyline(&*from, static_cast<int>(to - from) + 1);
    }
  }

  void paintStart(const Track& track) {
    if (track.until(time_) > 0) {
      const double ring = 0.7 * measures_.body();
      painter_->setPen(QPen(colorOf(track.id), 1.1 * measures_.line()));
      painter_->setBrush(theme_.color(Role::MapFree));
      painter_->drawEllipse(toPicture(track.points.front()), ring, ring);
    }
  }

  /// Where the body is drawn, counted from 0; none: it has not come yet, or is gone.
  std::optional<std::size_t> placeOf(const Track& track) const {
    const std::size_t count = track.until(time_);
    const auto next =
        std::upper_bound(trace_.frames.begin(), trace_.frames.end(), time_,
                         [](double time, const sim2d::Frame& frame) { return time < frame.time; });
    const bool isSeen = count > 0 && next != trace_.frames.begin() &&
                        (isWhole_ || track.times[count - 1] >= (next - 1)->time);
    return isSeen ? std::optional(count - 1) : std::nullopt;
  }
  double radiusOf(const Track& track) const {
    return std::max(measures_.body(), track.radius * scale_);
  }

  void paintBody(const Track& track) {
    const std::optional<std::size_t> at = placeOf(track);
    if (!at) {
      return;
    }
    const double heading = track.headings[*at] * 180.0 / base::kPi;
    painter_->save();
    painter_->translate(toPicture(track.points[*at]));
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

  /// The name below the figure, on a halo of the ground.
  void label(const Track& track) {
    const std::optional<std::size_t> at = placeOf(track);
    if (!at) {
      return;
    }
    const QFont font = theme_.font(measures_.small());
    const QPointF place = toPicture(track.points[*at]);
    const QPointF baseline(place.x() - QFontMetricsF(font).horizontalAdvance(track.name) / 2.0,
                           place.y() + radiusOf(track) + (measures_.isNarrow ? 10.0 : 13.0));
    const QPainterPath text = editor::textOutline(baseline, font, track.name);
    painter_->strokePath(text, QPen(theme_.color(Role::MapFree, 0.85), 3.5));
    painter_->fillPath(text, theme_.color(Role::Text));
  }

  void paintGoals() {
    std::map<int, Vec2> goals;  // shared goals get one pin
    for (const sim2d::TraceHuman& human : trace_.header.humans) {
      for (const sim2d::TraceGoal& goal : human.goals) {
        goals.emplace(goal.id, goal.position);
      }
    }
    for (const auto& [id, position] : goals) {
      painter_->save();
      painter_->translate(toPicture(position));
      pin(QString::number(id));
      painter_->restore();
    }
    for (const sim2d::TraceRobot& machine : trace_.header.robots) {
      for (const sim2d::TraceGoal& goal : machine.goals) {
        painter_->setPen(QPen(theme_.color(Role::RobotBody), 1.1 * measures_.line()));
        painter_->setBrush(theme_.color(Role::RobotFront));
        painter_->drawEllipse(toPicture(goal.position), 1.15 * measures_.body(),
                              1.15 * measures_.body());
      }
    }
  }

  /// At the painter's origin, the number as other text.
  void pin(const QString& number) {
    const double scale = measures_.isNarrow ? 0.8 : 1.0;
    figures_.pin(*painter_, {}, false, scale);
    QFont font = theme_.figureFont();
    font.setPixelSize(static_cast<int>((number.size() > 2 ? 8 : 11) * scale));
    font.setWeight(QFont::DemiBold);
    const QFontMetricsF metrics(font);
    text({-0.5 * metrics.horizontalAdvance(number), -17.0 * scale + 0.5 * metrics.capHeight()},
         font, Role::Text, number);
  }

  void text(const QPointF& baseline, const QFont& font, Role role, const QString& words) {
    if (layout_.textAsOutlines) {
      painter_->fillPath(editor::textOutline(baseline, font, words), theme_.color(role));
    } else {
      painter_->setFont(font);
      painter_->setPen(theme_.color(role));
      painter_->drawText(baseline, words);
    }
  }

  void paintScale() {
    const double metres = barLength(scale_, measures_.isNarrow ? 90.0 : 160.0);
    const QPointF left(wallsLeft(), mapRect_.bottom() + 0.6 * measures_.foot());
    const QPointF right(left.x() + metres * scale_, left.y());
    painter_->setPen(QPen(theme_.color(Role::Text), 1.5));
    painter_->drawLine(left, right);
    painter_->drawLine(left + QPointF(0.0, -5.0), left);
    painter_->drawLine(right + QPointF(0.0, -5.0), right);
    text(right + QPointF(8.0, 1.0), theme_.figureFont(measures_.small()), Role::Text,
         QStringLiteral("%1 m").arg(metres));
  }

  /// Where what is drawn begins: the map keeps a little distance.
  double wallsLeft() const { return mapRect_.left() + kAround * scale_; }

  QString secondsAndSeed() const {
    return QStringLiteral("%1 s · seed %2").arg(time_, 0, 'f', 1).arg(trace_.header.seed);
  }

  void paintLegend() {
    if (measures_.isNarrow) {
      paintLegendBelow();
    } else {
      paintLegendBeside();
    }
  }

  void paintLegendBeside() {
    const double row = measures_.row();
    double y = measures_.margin() + kLegendTop;
    const double x = layout_.width - measures_.legend();
    text({x, y}, theme_.font(measures_.title(), QFont::DemiBold), Role::Text,
         QString::fromStdString(trace_.header.scenario));
    y += row;
    text({x, y}, theme_.figureFont(measures_.small()), Role::TextSecondary, secondsAndSeed());
    y += 1.5 * row;
    const double foot = size_.height() - measures_.margin() - 0.4 * measures_.foot();
    const double bottom = foot - measures_.foot() - row;
    std::size_t shown = 0;
    for (const Entry& entry : entries_) {
      if (y > bottom) {
        break;
      }
      legendRow(x, y, entry, measures_.legend());
      y += row;
      ++shown;
    }
    const QFont font = theme_.font(measures_.text());
    if (shown < entries_.size()) {
      text({x, y}, font, Role::TextSecondary,
           QStringLiteral("and %1 more").arg(entries_.size() - shown));
    }
    text({x, foot}, font, Role::TextSecondary,
         isWhole_ ? QStringLiteral("○ start   the figure stands at the end")
                  : QStringLiteral("○ start   the figure stands at %1 s").arg(time_, 0, 'f', 1));
  }

  /// Its height [px] with everybody, up to a number that makes no picture tall.
  double legendBeside() const {
    constexpr std::size_t kMostRows = 24;
    const auto rows = static_cast<double>(std::min(kMostRows, entries_.size()));
    return measures_.isNarrow ? 0.0
                              : kLegendTop + measures_.row() * (rows + 5.0) + measures_.foot();
  }

  int columnsBelow() const {
    const double width = layout_.width - 2.0 * measures_.margin();
    return std::max(1, static_cast<int>(width / measures_.column()));
  }
  int rowsBelow() const {
    constexpr int kMostRows = 8;
    const auto count = static_cast<int>(entries_.size());
    return std::min(kMostRows, (count + columnsBelow() - 1) / columnsBelow());
  }
  double legendBelow() const {
    return measures_.isNarrow ? measures_.row() * (rowsBelow() + 1) : 0.0;
  }

  /// In columns; the last one says how many have no place.
  void paintLegendBelow() {
    const double left = wallsLeft();
    const double width = (layout_.width - left - measures_.margin()) / columnsBelow();
    double y = mapRect_.bottom() + measures_.foot() + 0.8 * measures_.row();
    text({left, y}, theme_.font(measures_.text(), QFont::DemiBold), Role::Text,
         QString::fromStdString(trace_.header.scenario) + QStringLiteral(" · ") + secondsAndSeed());
    y += measures_.row();
    const auto rows = static_cast<std::size_t>(std::max(1, rowsBelow()));
    const std::size_t places = static_cast<std::size_t>(columnsBelow()) * rows;
    const std::size_t shown = entries_.size() > places ? places - 1 : entries_.size();
    const auto placeOf = [&](std::size_t k) {
      const std::size_t column = k / rows;
      return QPointF(left + width * static_cast<double>(column),
                     y + measures_.row() * static_cast<double>(k % rows));
    };
    for (std::size_t k = 0; k < shown; ++k) {
      legendRow(placeOf(k).x(), placeOf(k).y(), entries_[k], width);
    }
    if (shown < entries_.size()) {
      text(placeOf(shown), theme_.font(measures_.text()), Role::TextSecondary,
           QStringLiteral("and %1 more").arg(entries_.size() - shown));
    }
  }

  struct Entry {
    int id = 0;
    QString name, kind;
  };

  std::vector<Entry> entriesOf() const {
    std::vector<Entry> entries;
    entries.reserve(trace_.header.robots.size() + trace_.header.humans.size());
    for (const sim2d::TraceRobot& machine : trace_.header.robots) {
      entries.push_back(
          {machine.id, QString::fromStdString(machine.name), QStringLiteral("robot")});
    }
    for (const sim2d::TraceHuman& human : trace_.header.humans) {
      entries.push_back(
          {human.id, QString::fromStdString(human.name), editor::lookName(lookOf(human.id))});
    }
    return entries;
  }

  /// In a column of that width; what does not fit is cut with dots.
  void legendRow(double x, double y, const Entry& entry, double width) {
    const double line = measures_.isNarrow ? 18.0 : 28.0;
    painter_->setPen(QPen(colorOf(entry.id), measures_.line() * 4.0 / 3.0,
                          entry.id < 0 ? Qt::DashLine : Qt::SolidLine));
    painter_->drawLine(QPointF(x, y - 4.0), QPointF(x + line, y - 4.0));
    if (entry.id >= 0) {
      figures_.mark(*painter_, lookOf(entry.id), QPointF(x + line + 14.0, y - 4.0), 10.0);
    }
    const QFont font = theme_.font(measures_.text());
    const QFontMetricsF metrics(font);
    const double names = x + line + 28.0;
    const double room = measures_.isNarrow ? x + width - 6.0 - names : 176.0 - line - 34.0;
    const QString name = metrics.elidedText(entry.name, Qt::ElideRight, room);
    text({names, y}, font, Role::Text, name);
    const double kinds =
        measures_.isNarrow ? names + metrics.horizontalAdvance(name) + 6.0 : x + 176.0;
    if (kinds + metrics.horizontalAdvance(entry.kind) < x + width) {
      text({kinds, y}, font, Role::TextSecondary, entry.kind);
    }
  }

  const sim2d::Trace& trace_;
  const PictureLayout layout_;
  const Measures measures_;
  const std::map<int, Track> tracks_;
  const Theme theme_ = Theme::light();
  const editor::FigurePainter figures_;
  const std::vector<Entry> entries_ = entriesOf();
  QPainter* painter_ = nullptr;  // while something is painted
  bool isWhole_ = true;
  double time_ = 0.0;    // [s] that is painted
  double scale_ = 50.0;  // px per m
  QPointF origin_;       // of the world, in the picture
  QRectF mapRect_;
  QSizeF size_;
  QImage map_;
};

RunPicture::RunPicture(const sim2d::Trace& trace, const PictureLayout& layout)
    : painting_(std::make_unique<Painting>(trace, layout)) {}

RunPicture::~RunPicture() = default;

QSizeF RunPicture::size() const {
  return painting_->size();
}

void RunPicture::paint(QPainter& painter, std::optional<double> time) {
  painting_->paint(painter, time);
}

}  // namespace app
