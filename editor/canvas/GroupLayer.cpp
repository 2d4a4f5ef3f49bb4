#include <algorithm>
#include <array>
#include <limits>

#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/Layers.h"
#include "editor/canvas/Overlays.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/document/Groups.h"

namespace editor {

namespace {

constexpr double kRingGapPx = 3.0;
constexpr double kLeastRingPx = 7.0;
constexpr double kRowPx = 20.0;
constexpr double kBoxPadPx = 10.0;
constexpr double kSamplePx = 18.0;  // ring and gap before the name
constexpr double kMarginPx = 12.0;
constexpr std::size_t kMostRows = 6;

using GroupMap = std::map<int, std::vector<EntityId>>;

QStringList legendRows(const sim2d::Scenario& scenario, const GroupMap& groups) {
  QStringList rows;
  for (const auto& [group, people] : groups) {
    if (static_cast<std::size_t>(rows.size()) == kMostRows && groups.size() > kMostRows) {
      rows.push_back(QObject::tr("%1 more").arg(groups.size() - kMostRows));
      break;
    }
    rows.push_back(QObject::tr("%1 · %2").arg(groupName(scenario, group)).arg(people.size()));
  }
  return rows;
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> shortestLinks(const std::vector<Vec2>& points) {
  std::vector<std::pair<std::size_t, std::size_t>> links;
  std::vector<std::size_t> nearest(points.size(), 0);  // of those that are joined already
  std::vector<double> distance(points.size(), std::numeric_limits<double>::max());
  std::vector<bool> joined(points.size(), false);
  std::size_t newest = 0;
  for (std::size_t count = 1; count < points.size(); ++count) {
    joined[newest] = true;
    std::size_t next = points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double toNewest = (points[i] - points[newest]).norm();
      if (!joined[i] && toNewest < distance[i]) {
        distance[i] = toNewest;
        nearest[i] = newest;
      }
      if (!joined[i] && (next == points.size() || distance[i] < distance[next])) {
        next = i;
      }
    }
    links.emplace_back(nearest[next], next);
    newest = next;
  }
  return links;
}

std::vector<GroupLayer::Member> GroupLayer::membersOf(const std::vector<EntityId>& people) const {
  std::vector<Member> members;
  for (const EntityId id : people) {
    const std::optional<Entity> value = mapScene().shown(id);
    const auto* human = value ? std::get_if<sim2d::Human>(&*value) : nullptr;
    if (human == nullptr || !human->listed) {
      continue;
    }
    const std::optional<Vec2> at = mapScene().isRunMode()
                                       ? mapScene().frameLayer().positionOf(human->id)
                                       : std::optional(human->initPose.position);
    if (at) {
      members.push_back({*at, mapScene().bodyRadius(*value)});
    }
  }
  return members;
}

/// A group with somebody who moves belongs to what moves.
bool GroupLayer::isPartOf(const std::vector<EntityId>& people) const {
  const auto isPainted = [this](EntityId id) { return mapScene().isPainted(id); };
  return mapScene().paintedPart() == CanvasPart::Moving
             ? std::any_of(people.begin(), people.end(), isPainted)
             : std::all_of(people.begin(), people.end(), isPainted);
}

void GroupLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (!mapScene().options().groups || !mapScene().options().people) {
    return;
  }
  painter->setRenderHint(QPainter::Antialiasing);
  const double pixelsPerMetre = pixelsPerMetreOf(*painter);
  painter->setBrush(Qt::NoBrush);
  for (const auto& [group, people] : groupsOf(mapScene().document().scenario())) {
    if (!isPartOf(people)) {
      continue;
    }
    const std::vector<Member> members = membersOf(people);
    std::vector<Vec2> places;
    for (const Member& member : members) {
      places.push_back(member.at);
    }
    QPen pen(groupColor(group, theme()), 1.5, Qt::CustomDashLine, Qt::RoundCap);
    pen.setDashPattern({1.0, 3.0});
    makeCosmetic(pen, *painter);
    painter->setPen(pen);
    for (const auto& [from, to] : shortestLinks(places)) {
      painter->drawLine(MapScene::sceneFromWorld(places[from]),
                        MapScene::sceneFromWorld(places[to]));
    }
    for (const Member& member : members) {
      const PixelFrame frame(*painter, MapScene::sceneFromWorld(member.at));
      const double ring = std::max(member.radius * pixelsPerMetre + kRingGapPx, kLeastRingPx);
      painter->setPen(QPen(groupColor(group, theme()), 2.0));
      painter->drawEllipse(QPointF(), ring, ring);
    }
  }
}

namespace {

struct LegendPlace {
  QRectF box;
  int corner = 0;
};

LegendPlace legendPlace(const OverlayContext& context) {
  const MapScene& scene = context.scene;
  const GroupMap groups = groupsOf(scene.document().scenario());
  if (groups.empty() || !scene.options().groups || !scene.options().people) {
    return {{}, context.legendCorner};
  }
  const QFontMetricsF metrics(scene.theme().font(9.0));
  const QStringList rows = legendRows(scene.document().scenario(), groups);
  double width = 0.0;
  for (const QString& row : rows) {
    width = std::max(width, metrics.horizontalAdvance(row));
  }
  QRectF box(0.0, 0.0, width + kSamplePx + 2.0 * kBoxPadPx, rows.size() * kRowPx + kBoxPadPx);
  const QRectF room = context.window.adjusted(kMarginPx, kMarginPx, -kMarginPx, -kMarginPx);
  const std::array<QPointF, 3> corners = {
      QPointF(room.right() - box.width(), room.bottom() - box.height()),
      QPointF(room.right() - box.width(), room.top()),
      QPointF(room.left(), room.bottom() - box.height() - 3.0 * kMarginPx)};  // above the scale
  const auto count = static_cast<int>(corners.size());
  for (int i = 0; i < count; ++i) {
    const int corner = (context.legendCorner + i) % count;  // it does not jump without need
    box.moveTopLeft(corners.at(static_cast<std::size_t>(corner)));
    const auto covers = [&](const sim2d::Human& human) {
      return box.adjusted(-kMarginPx, -kMarginPx, kMarginPx, kMarginPx)
          .contains(context.windowFromScene.map(MapScene::sceneFromWorld(human.initPose.position)));
    };
    const auto& people = scene.document().scenario().humans;
    if (std::none_of(people.begin(), people.end(), covers)) {
      return {box, corner};
    }
  }
  return {{}, context.legendCorner};  // people come first
}

}  // namespace

QRectF groupLegendBox(const OverlayContext& context) {
  return legendPlace(context).box;
}

int paintGroupLegend(QPainter& painter, const OverlayContext& context) {
  const auto [box, corner] = legendPlace(context);
  if (box.isEmpty()) {
    return corner;
  }
  const Theme& theme = context.scene.theme();
  const sim2d::Scenario& scenario = context.scene.document().scenario();
  const GroupMap groups = groupsOf(scenario);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(theme.color(Role::Line));
  painter.setBrush(theme.color(Role::Panel));
  painter.drawRoundedRect(box, 6.0, 6.0);
  painter.setFont(theme.font(9.0));
  QRectF row(box.left() + kBoxPadPx, box.top() + 0.5 * kBoxPadPx, box.width() - 2.0 * kBoxPadPx,
             kRowPx);
  auto group = groups.begin();
  for (const QString& words : legendRows(scenario, groups)) {
    if (static_cast<std::size_t>(std::distance(groups.begin(), group)) < kMostRows) {
      paintRing(painter, QPen(groupColor(group->first, theme), 2.0), 4.5,
                QPointF(row.left() + 5.0, row.center().y()));
      ++group;
    }
    painter.setPen(theme.color(Role::Text));
    painter.drawText(row.adjusted(kSamplePx, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter,
                     words);
    row.translate(0.0, kRowPx);
  }
  return corner;
}

}  // namespace editor
