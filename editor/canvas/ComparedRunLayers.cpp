#include "editor/canvas/ComparedRunLayers.h"

#include <array>
#include <cmath>

#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/Trails.h"
#include "editor/document/PeopleEdits.h"

namespace editor {

namespace {

constexpr double kSamePlace = 0.05;  // Closer bodies of two runs are at the same place [m].
constexpr double kLetterPx = 9.0;    // Minimum body radius for drawing the letter.
constexpr double kMinOutlinePx = 5.0;
constexpr double kEndedAlpha = 0.45;  // Of ghosts of runs that have ended.

constexpr std::size_t kMaxPeople = 60;  // Above that only trajectories with contacts.
constexpr double kCrossPx = 5.0;

/// Calls visit(id, pose) for people, then robots.
template <class Visit>
void forEachPose(const sim2d::Frame& frame, Visit visit) {
  forEachBody(frame, [&](const sim2d::BodyColumns& columns, std::size_t i) {
    visit(columns.id[i], base::Pose2{Vec2(columns.x[i], columns.y[i]), columns.heading[i]});
  });
}

/// The positions of all bodies by id; empty without a frame.
std::map<int, Vec2> placesIn(const sim2d::FramePtr& frame) {
  std::map<int, Vec2> places;
  if (frame != nullptr) {
    forEachPose(*frame, [&](int id, const base::Pose2& pose) { places[id] = pose.position; });
  }
  return places;
}

/// The trajectory points between two times [s] at which the body is present.
QPolygonF trajectorySection(const app::Future& future, const std::vector<Vec2>& way, double from,
                            double to) {
  QPolygonF line;
  for (std::size_t k = 0; k < way.size(); ++k) {
    if (future.times[k] >= from - 1e-9 && future.times[k] <= to + 1e-9 && way[k].allFinite()) {
      line << toScene(way[k]);
    }
  }
  return line;
}

QColor colorOf(const Theme& theme, int id, const BodyStyles::Body& body) {
  return id < 0 ? theme.color(Role::RobotLine) : theme.line(body.look);
}

}  // namespace

BodyStyles::BodyStyles(const ScenarioDocument& document, const sim2d::TraceHeader& header) {
  for (const sim2d::TraceHuman& human : header.humans) {
    const sim2d::Human* known = document.scenario().humanById(human.id);
    const bool isSame = known != nullptr && known->name == human.name;
    const bool isOfDocument = isSame && !human.customTree;
    bodies_[human.id] = {
        human.radius, isOfDocument ? lookOfPerson(document, *known) : lookOf(human), {}};
  }
  for (const sim2d::TraceRobot& robot : header.robots) {
    bodies_[robot.id] = {robot.radius, Look::Regular, robot.footprint};
  }
}

GhostStyle ghostStyle(std::size_t index, const Theme& theme) {
  // Okabe-Ito colours, ordered by contrast between neighbours, as used for lines in the palette.
  static constexpr std::array<Look, kGhostStyles> kColors = {
      Look::Threatening, Look::CustomTree, Look::Scared, Look::Surprised, Look::Curious};
  static const std::array<QVector<qreal>, kGhostStyles> kDashes = {
      QVector<qreal>{}, QVector<qreal>{4.0, 2.0}, QVector<qreal>{1.0, 2.0},
      QVector<qreal>{5.0, 2.0, 1.0, 2.0}, QVector<qreal>{2.0, 1.0}};
  const std::size_t style = index % kGhostStyles;
  return {theme.line(kColors[style]), kDashes[style],
          QString(QLatin1Char(static_cast<char>('B' + static_cast<char>(index % 25))))};
}

void paintOutline(QPainter& painter, const BodyStyles::Body& body, const base::Pose2& pose) {
  const double scale = pixelsPerMetreOf(painter);
  const double radius = std::max(body.radius, kMinOutlinePx / scale);
  if (body.footprint.empty()) {
    painter.drawEllipse(toScene(pose.position), radius, radius);
  } else {
    QPolygonF corners;
    for (const Vec2& corner : body.footprint) {
      corners << toScene(pose.toWorld(corner));
    }
    painter.drawPolygon(corners);
  }
  const Vec2 ahead = pose.position + radius * Vec2(std::cos(pose.heading), std::sin(pose.heading));
  painter.drawLine(toScene(pose.position), toScene(ahead));
}

void OnionLayer::show(std::vector<Skin> skins, std::shared_ptr<const sim2d::TraceHeader> header) {
  const bool isNothing = skins.empty() && skins_.empty();
  skins_ = std::move(skins);
  header_ = std::move(header);
  if (!isNothing) {
    update();
  }
}

void OnionLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (skins_.empty() || header_ == nullptr) {
    return;
  }
  painter->setRenderHint(QPainter::Antialiasing);
  const BodyStyles bodies(document(), *header_);
  for (const Skin& skin : skins_) {
    const double strength = 1.0 - (std::abs(skin.place) - 1) / double(kSkins);
    forEachPose(*skin.frame, [&](int id, const base::Pose2& pose) {
      if (id < 0 ? !options().robots : !options().people) {
        return;
      }
      const BodyStyles::Body& body = bodies.of(id);
      const QColor color = colorOf(theme(), id, body);
      const bool isPast = skin.place < 0;
      setPenAndBrush(
          *painter,
          isPast ? QPen(Qt::NoPen)
                 : screenPen(*painter, withAlpha(color, 0.75 * strength), 1.6, Qt::DashLine),
          isPast ? QBrush(withAlpha(color, 0.22 * strength)) : QBrush(Qt::NoBrush));
      paintOutline(*painter, body, pose);
    });
  }
}

void GhostLayer::show(std::vector<Ghost> ghosts, sim2d::FramePtr shown) {
  const bool isNothing = ghosts.empty() && ghosts_.empty();
  ghosts_ = std::move(ghosts);
  shown_ = std::move(shown);
  if (!isNothing) {
    update();
  }
}

bool GhostLayer::isDisplaced(const Ghost& ghost, int id) const {
  const std::map<int, Vec2> here = placesIn(shown_);
  const std::map<int, Vec2> there = placesIn(ghost.frame);
  return there.count(id) > 0 &&
         (here.count(id) == 0 || (here.at(id) - there.at(id)).norm() > kSamePlace);
}

void GhostLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  for (const Ghost& ghost : ghosts_) {
    paintGhost(*painter, ghost);
  }
}

void GhostLayer::paintGhost(QPainter& painter, const Ghost& ghost) const {
  const GhostStyle style = ghostStyle(ghost.style, theme());
  const BodyStyles bodies(document(), *ghost.header);
  const double scale = pixelsPerMetreOf(painter);
  const double strength = ghost.hasEnded ? kEndedAlpha : 1.0;
  const std::map<int, Vec2> here = placesIn(shown_);
  const auto penOf = [&](double width, double alpha) {
    QPen pen = screenPen(painter, withAlpha(style.color, strength * alpha), width);
    if (!style.dashes.isEmpty()) {
      pen.setDashPattern(style.dashes);
    }
    return pen;
  };
  forEachPose(*ghost.frame, [&](int id, const base::Pose2& pose) {
    const auto other = here.find(id);
    const bool isSame = other != here.end() && (other->second - pose.position).norm() <= kSamePlace;
    if (isSame || (id < 0 ? !options().robots : !options().people)) {
      return;
    }
    const auto trail = ghost.trails.find(id);
    if (options().trails && trail != ghost.trails.end() && trail->second.size() > 1) {
      setPenAndBrush(painter, penOf(2.0, 0.55));
      painter.drawPolyline(toScene(trail->second));
    }
    if (other != here.end()) {  // Connects the ghost with its body in the shown run.
      setPenAndBrush(painter,
                     screenPen(painter, theme().color(Role::TextSecondary, 0.7), 1.0, Qt::DotLine));
      painter.drawLine(toScene(pose.position), toScene(other->second));
    }
    const BodyStyles::Body& body = bodies.of(id);
    setPenAndBrush(painter, penOf(2.2, 1.0), theme().color(Role::Panel, 0.6));
    paintOutline(painter, body, pose);
    if (body.radius * scale >= kLetterPx) {
      const PixelFrame frame(painter, toScene(pose.position));
      painter.setFont(theme().font(8.0, QFont::DemiBold));
      painter.setPen(theme().color(Role::Text));
      painter.drawText(QRectF(-10.0, -10.0, 20.0, 20.0), Qt::AlignCenter, style.letter);
    }
  });
}

void FuturesLayer::show(Futures futures) {
  const bool isNothing = futures_ == nullptr && futures == nullptr;
  futures_ = std::move(futures);
  if (!isNothing) {
    update();
  }
}

void FuturesLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (futures_ == nullptr) {
    return;
  }
  painter->setRenderHint(QPainter::Antialiasing);
  for (const app::Future& future : *futures_) {
    if (options().people) {
      paintPeople(*painter, future);
    }
  }
  for (const bool isOfContact : {false, true}) {  // Trajectories with contacts are drawn last.
    for (const app::Future& future : *futures_) {
      if (options().robots && future.contact.has_value() == isOfContact) {
        paintRobots(*painter, future);
      }
    }
  }
  for (const app::Future& future : *futures_) {
    if (future.contact && future.contact->where.allFinite()) {
      paintContact(*painter, future.contact->where);
    }
  }
}

void FuturesLayer::paintContact(QPainter& painter, const Vec2& where) const {
  const PixelFrame frame(painter, toScene(where));
  for (const bool isHalo : {true, false}) {
    const QColor color = isHalo ? theme().color(Role::Panel) : theme().color(Role::Error);
    painter.setPen(QPen(color, isHalo ? 5.0 : 2.4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(-kCrossPx, -kCrossPx), QPointF(kCrossPx, kCrossPx));
    painter.drawLine(QPointF(-kCrossPx, kCrossPx), QPointF(kCrossPx, -kCrossPx));
  }
}

void FuturesLayer::paintPeople(QPainter& painter, const app::Future& future) const {
  const bool showsAll = future.ways.size() <= kMaxPeople;
  for (const auto& [id, way] : future.ways) {
    const bool isTouched =
        future.contact && (future.contact->id == id || future.contact->other == id);
    if (id < 0 || way.empty() || !(showsAll || isTouched)) {
      continue;
    }
    const QColor color = theme().color(Role::TextSecondary, isTouched ? 0.55 : 0.22);
    setPenAndBrush(painter, screenPen(painter, color, isTouched ? 1.6 : 1.2));
    painter.drawPolyline(trajectorySection(future, way, future.times.front(), future.times.back()));
  }
}

/// Draws the part after a contact dotted.
void FuturesLayer::paintRobots(QPainter& painter, const app::Future& future) const {
  const QColor color =
      future.contact ? theme().color(Role::Error, 0.8) : theme().color(Role::Accent, 0.55);
  for (const auto& [id, way] : future.ways) {
    if (id >= 0 || way.empty()) {
      continue;
    }
    const double end = future.contact ? future.contact->time : future.times.back();
    setPenAndBrush(painter, screenPen(painter, color, 2.0));
    painter.drawPolyline(trajectorySection(future, way, future.times.front(), end));
    if (future.contact) {
      setPenAndBrush(painter, screenPen(painter, color, 1.4, Qt::DotLine));
      painter.drawPolyline(trajectorySection(future, way, end, future.times.back()));
    }
  }
}

}  // namespace editor
