#include "editor/panels/behavior/TreeOutline.h"
#include "editor/trees/TreeGraph.h"

namespace editor {

namespace {

using base::NodeStatus;

constexpr double kNodeRadius = 6.0;
constexpr double kBend = 8.0;  // Corner radius of lines.
constexpr double kNodeTextLeft = 10.0;

/// An orthogonal line from parent to child with rounded corners.
QPainterPath lineBetween(const QPointF& from, const QPointF& to, bool isDown) {
  QPainterPath path(from);
  const double half = isDown ? 0.5 * (to.y() - from.y()) : 0.5 * (to.x() - from.x());
  const double across = isDown ? to.x() - from.x() : to.y() - from.y();
  const double bend = std::min({kBend, half, 0.5 * std::abs(across)});
  const double side = across < 0.0 ? -bend : bend;
  const auto point = [&](double along, double aside) {
    return isDown ? from + QPointF(aside, along) : from + QPointF(along, aside);
  };
  if (bend < 0.5) {
    path.lineTo(to);
    return path;
  }
  path.lineTo(point(half - bend, 0.0));
  path.quadTo(point(half, 0.0), point(half, side));
  path.lineTo(point(half, across - side));
  path.quadTo(point(half, across), point(half + bend, across));
  path.lineTo(to);
  return path;
}

bool holdsWord(const std::string& id, const char* word) {
  return id.find(word) != std::string::npos;
}

void paintArrowSign(QPainter& painter, const QPointF& c, bool isDouble) {
  for (const double dy : isDouble ? std::vector<double>{-2.5, 2.5} : std::vector<double>{0.0}) {
    painter.drawLine(c + QPointF(-5, dy), c + QPointF(5, dy));
    if (!isDouble) {
      painter.drawPolyline(
          QPolygonF({c + QPointF(1.5, -3.5), c + QPointF(5, 0), c + QPointF(1.5, 3.5)}));
    } else {
      painter.drawPolyline(
          QPolygonF({c + QPointF(3, dy - 2), c + QPointF(5, dy), c + QPointF(3, dy + 2)}));
    }
  }
}

void paintControlSign(QPainter& painter, const std::string& id, const QPointF& c) {
  if (holdsWord(id, "Sequence") || holdsWord(id, "Parallel")) {
    paintArrowSign(painter, c, holdsWord(id, "Parallel"));
    return;
  }
  QFont font = painter.font();
  font.setPointSizeF(9.5);
  font.setWeight(QFont::DemiBold);
  painter.setFont(font);
  painter.drawText(QRectF(c.x() - 8, c.y() - 9, 16, 18), Qt::AlignCenter,
                   holdsWord(id, "Choice") ? QStringLiteral("%") : QStringLiteral("?"));
}

QPolygonF decoratorShape(const QPointF& c) {
  return QPolygonF({c + QPointF(0, -5), c + QPointF(5, 0), c + QPointF(0, 5), c + QPointF(-5, 0)});
}

QPolygonF conditionShape(const QPointF& c) {
  return QPolygonF({c + QPointF(-5.5, 0), c + QPointF(-2.8, -4.6), c + QPointF(2.8, -4.6),
                    c + QPointF(5.5, 0), c + QPointF(2.8, 4.6), c + QPointF(-2.8, 4.6)});
}

QPolygonF actionShape(const QPointF& c) {
  return QPolygonF({c + QPointF(1.5, -6), c + QPointF(-4, 1), c + QPointF(-0.5, 1),
                    c + QPointF(-1.5, 6), c + QPointF(4, -1), c + QPointF(0.5, -1)});
}

}  // namespace

void paintNodeSign(QPainter& painter, const bt::NodeSpec& node, const QPointF& centre,
                   const QColor& color) {
  painter.save();
  painter.setPen(QPen(color, 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  const bt::NodeManifest* manifest = treeCatalogue().find(node.id);
  if (node.isSubTree()) {
    painter.drawRoundedRect(QRectF(centre.x() - 5, centre.y() - 5, 10, 10), 1.5, 1.5);
    painter.drawLine(centre - QPointF(2.5, 0), centre + QPointF(2.5, 0));
    painter.drawLine(centre - QPointF(0, 2.5), centre + QPointF(0, 2.5));
  } else if (manifest == nullptr) {
    painter.drawLine(centre + QPointF(-4, -4), centre + QPointF(4, 4));
    painter.drawLine(centre + QPointF(4, -4), centre + QPointF(-4, 4));
  } else if (manifest->kind == bt::NodeKind::Control) {
    paintControlSign(painter, node.id, centre);
  } else if (manifest->kind == bt::NodeKind::Decorator) {
    painter.drawPolygon(decoratorShape(centre));
  } else if (manifest->kind == bt::NodeKind::Condition) {
    painter.drawPolygon(conditionShape(centre));
  } else {
    painter.setBrush(color);
    painter.setPen(Qt::NoPen);
    painter.drawPolygon(actionShape(centre));
  }
  painter.restore();
}

const NodeStatus* TreeView::statusOf(int node) const {
  const auto place = static_cast<std::size_t>(node);
  return node >= 0 && place < statuses.size() ? &statuses[place] : nullptr;
}

QRectF TreePainter::foldHandleRect(const TreeGraph& graph, int node) {
  if (graph.childrenOf(node).empty() || !graph.isShown(node)) {
    return {};
  }
  const bool isFolded = graph.isFolded(node);
  const double width = isFolded ? 30.0 : kFoldHandle;
  const QPointF at = graph.outlet(node);
  return {at.x() - 0.5 * width, at.y() - 0.5 * kFoldHandle, width, kFoldHandle};
}

void TreePainter::paint(QPainter& painter, const QRectF& visible) const {
  painter.setRenderHint(QPainter::Antialiasing);
  std::vector<int> lines;
  for (const int node : graph_.shown()) {
    if (graph_.node(node).parent >= 0) {
      lines.push_back(node);
    }
  }
  // Lines of running nodes are drawn last.
  std::stable_partition(lines.begin(), lines.end(), [this](int node) {
    const NodeStatus* status = view_.statusOf(node);
    return status == nullptr || *status != NodeStatus::Running;
  });
  for (const int child : lines) {
    const QRectF reach =
        QRectF(graph_.outlet(graph_.node(child).parent), graph_.inlet(child)).normalized();
    if (reach.adjusted(-2, -2, 2, 2).intersects(visible)) {
      paintLine(painter, child);
    }
  }
  for (const int node : graph_.shown()) {
    if (graph_.box(node).adjusted(-12, -12, 12, 12).intersects(visible)) {
      paintNode(painter, node);
    }
  }
  paintDrop(painter);
  paintBand(painter);
}

QPen TreePainter::penOf(int node, double width) const {
  const NodeStatus* status = view_.statusOf(node);
  if (status == nullptr) {
    const bool isUnknown = graph_.isUnknown(node);
    return {theme_.color(isUnknown ? Role::Error : Role::ObstacleEdge), width,
            isUnknown ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap};
  }
  switch (*status) {
    case NodeStatus::Running:
      return {theme_.color(Role::Accent), width + 0.8};
    case NodeStatus::Success:
      return {theme_.color(Role::Ok), width + 0.3};
    case NodeStatus::Failure:
      return {theme_.color(Role::ErrorSoft), width + 0.3};
    case NodeStatus::Idle:
    case NodeStatus::Skipped:
      break;
  }
  QPen pen(theme_.color(Role::ObstacleEdge), width, Qt::CustomDashLine, Qt::FlatCap);
  pen.setDashPattern({3.0, 3.0});
  return pen;
}

void TreePainter::paintLine(QPainter& painter, int child) const {
  QPen pen = penOf(child, 1.4);
  const bool isRunning =
      view_.statusOf(child) != nullptr && *view_.statusOf(child) == NodeStatus::Running;
  pen.setWidthF(isRunning ? 2.6 : pen.widthF());
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(lineBetween(graph_.outlet(graph_.node(child).parent), graph_.inlet(child),
                               graph_.direction() == TreeDirection::Down));
}

void TreePainter::paintNode(QPainter& painter, int node) const {
  const QRectF box = graph_.box(node);
  const bool isDragged =
      std::find(view_.dragged.begin(), view_.dragged.end(), node) != view_.dragged.end();
  painter.setOpacity(isDragged ? 0.4 : 1.0);
  if (view_.isSelected(node)) {
    painter.setPen(QPen(theme_.color(Role::Accent), node == view_.chosen ? 2.0 : 1.2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(box.adjusted(-4, -4, 4, 4), kNodeRadius + 3, kNodeRadius + 3);
  }
  const NodeStatus* status = view_.statusOf(node);
  const bool isIdle =
      status != nullptr && (*status == NodeStatus::Idle || *status == NodeStatus::Skipped);
  QPen edge = penOf(node, 1.2);
  if (isIdle) {
    edge = QPen(theme_.color(Role::ObstacleEdge), 1.0);
  }
  painter.setPen(edge);
  painter.setBrush(theme_.color(node == view_.hovered ? Role::RowHover : Role::Panel));
  painter.drawRoundedRect(box, kNodeRadius, kNodeRadius);
  paintTexts(painter, node, isIdle || !graph_.isEditable(node));
  paintFoldHandle(painter, node);
  paintMarks(painter, node);
  painter.setOpacity(1.0);
}

void TreePainter::paintTexts(QPainter& painter, int node, bool isDimmed) const {
  const bt::NodeSpec& spec = *graph_.node(node).node;
  const QRectF box = graph_.box(node).adjusted(kNodeTextLeft, 5.0, -kNodeTextLeft, -5.0);
  const auto write = [&](const QFont& font, const QRectF& where, const QString& text, Role role) {
    painter.setFont(font);
    painter.setPen(theme_.color(role));
    painter.drawText(where, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetricsF(font).elidedText(text, Qt::ElideRight, where.width()));
  };
  // Small text is drawn paler than its colour, therefore darker when the view is zoomed out.
  const Role secondary = painter.worldTransform().m11() < 1.0 ? Role::Text : Role::TextSecondary;
  const double half = 0.5 * box.height();
  write(theme_.font(9.5, QFont::DemiBold), QRectF(box.left(), box.top(), box.width(), half),
        nodeTitle(spec), isDimmed ? secondary : Role::Text);
  write(theme_.font(9.0), QRectF(box.left(), box.top() + half, box.width() - 18.0, half),
        nodeDetail(spec), graph_.isUnknown(node) ? Role::Error : secondary);
  paintNodeSign(painter, spec, QPointF(box.right() - 5.0, box.bottom() - 0.5 * half),
                theme_.color(isDimmed ? Role::TextSecondary : Role::Text));
}

bool TreePainter::isStopped(int node) const {
  const std::string& name = graph_.names()[static_cast<std::size_t>(node)];
  return std::any_of(view_.breakpoints.begin(), view_.breakpoints.end(),
                     [&name](const sim2d::TreeBreakpoint& point) { return point.path == name; });
}

void TreePainter::paintMarks(QPainter& painter, int node) const {
  const QRectF box = graph_.box(node);
  const auto clear = [&](const QPointF& at) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme_.color(Role::Window));
    painter.drawEllipse(at, 8.0, 8.0);
    painter.setBrush(theme_.color(Role::Panel));
    painter.drawEllipse(at, 7.0, 7.0);
  };
  if (const NodeStatus* status = view_.statusOf(node)) {
    const QPointF at = box.topRight() + QPointF(-10.0, 0.0);
    clear(at);
    painter.save();
    painter.translate(at);
    paintStatusMark(painter, *status, theme_);
    painter.restore();
  }
  if (isStopped(node)) {
    const QPointF at = box.topLeft() + QPointF(10.0, 0.0);
    clear(at);
    painter.setBrush(theme_.color(Role::Error));
    painter.drawEllipse(at, 5.5, 5.5);
    painter.setBrush(theme_.color(Role::Panel));
    painter.drawEllipse(at, 1.8, 1.8);
  }
  const std::vector<TreeGraph::Problem>& problems = graph_.problemsOf(node);
  if (!problems.empty()) {
    const bool isError = std::any_of(
        problems.begin(), problems.end(),
        [](const TreeGraph::Problem& each) { return each.severity == base::Severity::Error; });
    const QPointF at = box.bottomLeft() + QPointF(10.0, 0.0);
    clear(at);
    painter.setBrush(theme_.color(isError ? Role::Error : Role::WarningMark));
    painter.drawPolygon(QPolygonF({at + QPointF(0, -6), at + QPointF(6, 5), at + QPointF(-6, 5)}));
    painter.setPen(QPen(theme_.color(Role::Panel), 1.4));
    painter.drawLine(at + QPointF(0, -2), at + QPointF(0, 1));
    painter.drawPoint(at + QPointF(0, 3.4));
  }
}

/// Draws the number of hidden nodes if folded; otherwise a sign while the mouse is over the node.
void TreePainter::paintFoldHandle(QPainter& painter, int node) const {
  const bool isFolded = graph_.isFolded(node);
  const QRectF knob = foldHandleRect(graph_, node);
  if (knob.isNull() || (!isFolded && node != view_.hovered)) {
    return;
  }
  painter.setPen(QPen(theme_.color(Role::ObstacleEdge), 1.0));
  painter.setBrush(theme_.color(Role::Panel));
  painter.drawRoundedRect(knob.adjusted(0.5, 0.5, -0.5, -0.5), 8.0, 8.0);
  painter.setPen(theme_.color(Role::TextSecondary));
  painter.setFont(theme_.font(8.0));
  painter.drawText(knob, Qt::AlignCenter,
                   isFolded ? QStringLiteral("+%1").arg(graph_.below(node)) : QStringLiteral("–"));
}

void TreePainter::paintBand(QPainter& painter) const {
  if (view_.band) {
    QColor inside = theme_.color(Role::Accent);
    painter.setPen(QPen(inside, 1.0));
    inside.setAlphaF(0.12);
    painter.setBrush(inside);
    painter.drawRect(*view_.band);
  }
}

void TreePainter::paintDrop(QPainter& painter) const {
  if (!view_.drop) {
    return;
  }
  const DropTarget& drop = *view_.drop;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme_.color(Role::Accent), 2.0, Qt::DashLine));
  if (drop.how == DropTarget::How::Around) {
    painter.drawRoundedRect(graph_.box(drop.node).adjusted(-8, -8, 8, 8), 10, 10);
    return;
  }
  painter.drawPath(lineBetween(graph_.outlet(drop.node), drop.mark.center(),
                               graph_.direction() == TreeDirection::Down));
  painter.setPen(QPen(theme_.color(Role::Accent), 4.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(drop.mark);
}

}  // namespace editor
