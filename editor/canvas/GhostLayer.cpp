#include "editor/canvas/GhostLayer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "editor/canvas/PixelFrame.h"
#include "editor/document/Groups.h"

namespace editor {

namespace {

constexpr double kSamePlace = 0.05;  // [m]; nearer to each other two runs have a body in one place
constexpr double kLetterPx = 9.0;    // radius of a body from which its letter has room
constexpr double kLeastOutlinePx = 5.0;

/// Calls visit(id, pose) for people, then robots.
template <class Visit>
void forEachBody(const sim2d::Frame& frame, Visit visit) {
  for (const sim2d::BodyColumns* columns :
       {static_cast<const sim2d::BodyColumns*>(&frame.humans), &frame.robots}) {
    for (std::size_t i = 0; i < columns->size(); ++i) {
      visit(columns->id[i], base::Pose2{Vec2(columns->x[i], columns->y[i]), columns->heading[i]});
    }
  }
}

std::optional<Vec2> placeIn(const sim2d::Frame& frame, int id) {
  std::optional<Vec2> place;
  forEachBody(frame, [&](int each, const base::Pose2& pose) {
    if (each == id) {
      place = pose.position;
    }
  });
  return place;
}

QColor colorOf(const Theme& theme, int id, const RunBodies::Body& body) {
  return id < 0 ? theme.color(Role::RobotLine) : theme.line(body.look);
}

}  // namespace

RunBodies::RunBodies(const ScenarioDocument& document, const sim2d::TraceHeader& header) {
  for (const sim2d::TraceHuman& human : header.humans) {
    const sim2d::Human* known = document.scenario().humanById(human.id);
    const bool isSame = known != nullptr && known->name == human.name;
    bodies_[human.id] = {human.radius,
                         isSame ? lookOfPerson(document, *known)
                                : lookOf(static_cast<sim2d::BehaviorType>(human.behavior)),
                         {}};
  }
  for (const sim2d::TraceRobot& robot : header.robots) {
    bodies_[robot.id] = {robot.radius, Look::Regular, robot.footprint};
  }
}

const RunBodies::Body& RunBodies::of(int id) const {
  const auto found = bodies_.find(id);
  return found == bodies_.end() ? stranger_ : found->second;
}

GhostStyle ghostStyle(std::size_t index, const Theme& theme) {
  // Okabe-Ito, in the order in which neighbours differ most; those of the palette's lines.
  static constexpr std::array<Look, kGhostStyles> kColors = {
      Look::Threatening, Look::CustomTree, Look::Scared, Look::Surprised, Look::Curious};
  static const std::array<QVector<qreal>, kGhostStyles> kDashes = {
      QVector<qreal>{}, QVector<qreal>{4.0, 2.0}, QVector<qreal>{1.0, 2.0},
      QVector<qreal>{5.0, 2.0, 1.0, 2.0}, QVector<qreal>{2.0, 1.0}};
  const std::size_t style = index % kGhostStyles;
  return {theme.line(kColors[style]), kDashes[style],
          QString(QLatin1Char(static_cast<char>('B' + static_cast<char>(index % 25))))};
}

void paintOutline(QPainter& painter, const RunBodies::Body& body, const base::Pose2& pose) {
  const double scale = pixelsPerMetreOf(painter);
  const double radius = std::max(body.radius, kLeastOutlinePx / scale);
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
  const RunBodies bodies(document(), *header_);
  for (const Skin& skin : skins_) {
    const double strength = 1.0 - (std::abs(skin.place) - 1) / double(kSkins);
    forEachBody(*skin.frame, [&](int id, const base::Pose2& pose) {
      if (id < 0 ? !options().robots : !options().people) {
        return;
      }
      const RunBodies::Body& body = bodies.of(id);
      QColor ink = colorOf(theme(), id, body);
      QColor fill = ink;
      ink.setAlphaF(0.75 * strength);
      fill.setAlphaF(0.22 * strength);
      const bool isPast = skin.place < 0;
      setInk(*painter, isPast ? QPen(Qt::NoPen) : screenPen(*painter, ink, 1.6, Qt::DashLine),
             isPast ? QBrush(fill) : QBrush(Qt::NoBrush));
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

bool GhostLayer::isApart(const Ghost& ghost, int id) const {
  const std::optional<Vec2> here = shown_ ? placeIn(*shown_, id) : std::nullopt;
  const std::optional<Vec2> there = placeIn(*ghost.frame, id);
  return there && (!here || (*here - *there).norm() > kSamePlace);
}

void GhostLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  for (const Ghost& ghost : ghosts_) {
    paintGhost(*painter, ghost);
  }
}

void GhostLayer::paintGhost(QPainter& painter, const Ghost& ghost) const {
  const GhostStyle style = ghostStyle(ghost.style, theme());
  const RunBodies bodies(document(), *ghost.header);
  const double scale = pixelsPerMetreOf(painter);
  std::map<int, Vec2> here;
  if (shown_ != nullptr) {
    forEachBody(*shown_, [&](int id, const base::Pose2& pose) { here[id] = pose.position; });
  }
  const auto penOf = [&](double width, double alpha) {
    QColor color = style.color;
    color.setAlphaF(alpha);
    QPen pen = screenPen(painter, color, width);
    if (!style.dashes.isEmpty()) {
      pen.setDashPattern(style.dashes);
    }
    return pen;
  };
  forEachBody(*ghost.frame, [&](int id, const base::Pose2& pose) {
    const auto other = here.find(id);
    const bool isSame = other != here.end() && (other->second - pose.position).norm() <= kSamePlace;
    if (isSame || (id < 0 ? !options().robots : !options().people)) {
      return;
    }
    const auto trail = ghost.trails.find(id);
    if (options().trails && trail != ghost.trails.end() && trail->second.size() > 1) {
      setInk(painter, penOf(2.0, 0.55));
      painter.drawPolyline(toScene(trail->second));
    }
    if (other != here.end()) {  // whose ghost it is
      setInk(painter,
             screenPen(painter, theme().color(Role::TextSecondary, 0.7), 1.0, Qt::DotLine));
      painter.drawLine(toScene(pose.position), toScene(other->second));
    }
    const RunBodies::Body& body = bodies.of(id);
    QColor fill = theme().color(Role::Panel, 0.6);
    setInk(painter, penOf(2.2, 1.0), fill);
    paintOutline(painter, body, pose);
    if (body.radius * scale >= kLetterPx) {
      const PixelFrame frame(painter, toScene(pose.position));
      painter.setFont(theme().font(8.0, QFont::DemiBold));
      painter.setPen(theme().color(Role::Text));
      painter.drawText(QRectF(-10.0, -10.0, 20.0, 20.0), Qt::AlignCenter, style.letter);
    }
  });
}

}  // namespace editor
