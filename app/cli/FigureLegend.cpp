#include "app/cli/FigureLegend.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

using editor::Role;

namespace {

constexpr double kLegendTop = 16.0;  // px to the title of a legend beside the map
constexpr double kKeyGap = 18.0;     // px between two items

}  // namespace

FigureLegend::FigureLegend(const sim2d::Trace& trace, const FigureMap& map,
                           const FigureSizes& sizes, const FigureText& text)
    : title_(QString::fromStdString(trace.header.scenario)),
      map_(map),
      sizes_(sizes),
      text_(text),
      entries_(entriesOf(trace)) {}

std::vector<FigureLegend::Entry> FigureLegend::entriesOf(const sim2d::Trace& trace) const {
  std::vector<Entry> entries;
  entries.reserve(trace.header.robots.size() + trace.header.humans.size());
  for (const sim2d::TraceRobot& machine : trace.header.robots) {
    entries.push_back({machine.id, QString::fromStdString(machine.name), QStringLiteral("robot")});
  }
  for (const sim2d::TraceHuman& human : trace.header.humans) {
    entries.push_back(
        {human.id, QString::fromStdString(human.name), editor::lookName(map_.lookOf(human.id))});
  }
  return entries;
}

double FigureLegend::heightBeside() const {
  constexpr std::size_t kMaxRows = 24;
  const auto rows = static_cast<double>(std::min(kMaxRows, entries_.size()));
  return kLegendTop + sizes_.row() * (rows + 5.0) + sizes_.foot();
}

int FigureLegend::columns(double width) const {
  return std::max(1, static_cast<int>(width / sizes_.column()));
}

int FigureLegend::rows(double width) const {
  constexpr int kMaxRows = 8;
  const auto count = static_cast<int>(entries_.size());
  return std::min(kMaxRows, (count + columns(width) - 1) / columns(width));
}

double FigureLegend::heightBelow(double width) const {
  return sizes_.row() * (rows(width) + 1);
}

void FigureLegend::paintBeside(QPainter& painter, const QPointF& leftTop, double foot,
                               const QString& when, const QString& last) const {
  const editor::Theme& theme = text_.theme();
  const double row = sizes_.row();
  double y = leftTop.y() + kLegendTop;
  const double x = leftTop.x();
  text_.write(painter, {x, y}, theme.font(sizes_.title(), QFont::DemiBold), Role::Text, title_);
  y += row;
  text_.write(painter, {x, y}, theme.figureFont(sizes_.small()), Role::TextSecondary, when);
  y += 1.5 * row;
  const double bottom = foot - sizes_.foot() - row;
  std::size_t shown = 0;
  for (const Entry& entry : entries_) {
    if (y > bottom) {
      break;
    }
    this->row(painter, {x, y}, entry, sizes_.legend());
    y += row;
    ++shown;
  }
  const QFont font = theme.font(sizes_.text());
  if (shown < entries_.size()) {
    text_.write(painter, {x, y}, font, Role::TextSecondary,
                QStringLiteral("and %1 more").arg(entries_.size() - shown));
  }
  text_.write(painter, {x, foot}, font, Role::TextSecondary, last);
}

/// In columns; the last entry states how many do not fit.
void FigureLegend::paintBelow(QPainter& painter, const QPointF& leftTop, double width,
                              const QString& when) const {
  const editor::Theme& theme = text_.theme();
  const double columnWidth = width / columns(width);
  double y = leftTop.y() + 0.8 * sizes_.row();
  text_.write(painter, {leftTop.x(), y}, theme.font(sizes_.text(), QFont::DemiBold), Role::Text,
              title_ + QStringLiteral(" · ") + when);
  y += sizes_.row();
  const auto perColumn = static_cast<std::size_t>(std::max(1, rows(width)));
  const std::size_t places = static_cast<std::size_t>(columns(width)) * perColumn;
  const std::size_t shown = entries_.size() > places ? places - 1 : entries_.size();
  const auto placeOf = [&](std::size_t k) {
    const std::size_t column = k / perColumn;
    return QPointF(leftTop.x() + columnWidth * static_cast<double>(column),
                   y + sizes_.row() * static_cast<double>(k % perColumn));
  };
  for (std::size_t k = 0; k < shown; ++k) {
    row(painter, placeOf(k), entries_[k], columnWidth);
  }
  if (shown < entries_.size()) {
    text_.write(painter, placeOf(shown), theme.font(sizes_.text()), Role::TextSecondary,
                QStringLiteral("and %1 more").arg(entries_.size() - shown));
  }
}

/// In a column of this width; text that does not fit is elided.
void FigureLegend::row(QPainter& painter, const QPointF& at, const Entry& entry,
                       double width) const {
  const editor::Theme& theme = text_.theme();
  const double line = sizes_.isNarrow ? 18.0 : 28.0;
  const double x = at.x();
  const double middle = at.y() - 4.0;
  painter.setPen(QPen(map_.colorOf(entry.id), sizes_.line() * 4.0 / 3.0,
                      entry.id < 0 ? Qt::DashLine : Qt::SolidLine));
  painter.drawLine(QPointF(x, middle), QPointF(x + line, middle));
  if (entry.id >= 0) {
    editor::FigurePainter(theme).mark(painter, map_.lookOf(entry.id),
                                      QPointF(x + line + 14.0, middle), 10.0);
  }
  const QFont font = theme.font(sizes_.text());
  const QFontMetricsF metrics(font);
  const double names = x + line + 28.0;
  const double room = sizes_.isNarrow ? x + width - 6.0 - names : 176.0 - line - 34.0;
  const QString name = metrics.elidedText(entry.name, Qt::ElideRight, room);
  text_.write(painter, {names, at.y()}, font, Role::Text, name);
  const double kinds = sizes_.isNarrow ? names + metrics.horizontalAdvance(name) + 6.0 : x + 176.0;
  if (kinds + metrics.horizontalAdvance(entry.kind) < x + width) {
    text_.write(painter, {kinds, at.y()}, font, Role::TextSecondary, entry.kind);
  }
}

OverlayLegend::OverlayLegend(const FigureMap& map, const FigureSizes& sizes, const FigureText& text,
                             const FigureOptions& options)
    : map_(map), sizes_(sizes), text_(text), options_(options) {}

OverlayLegend::Item OverlayLegend::textItem(
    double sample, const QString& label,
    std::function<void(QPainter&, const QPointF&)> paintSample) const {
  const QFont font = text_.theme().font(sizes_.small());
  const double gap = sample > 0.0 ? 6.0 : 0.0;
  Item item;
  item.width = sample + gap + QFontMetricsF(font).horizontalAdvance(label) + kKeyGap;
  item.paint = [this, font, label, at = sample + gap, draw = std::move(paintSample)](
                   QPainter& painter, const QPointF& place) {
    if (draw) {
      draw(painter, place + QPointF(0.0, -3.5));
    }
    text_.write(painter, place + QPointF(at, 0.0), font, Role::TextSecondary, label);
  };
  return item;
}

/// Arrows with the length of one unit.
void OverlayLegend::addArrows(std::vector<Item>& items) const {
  const auto arrow = [this](double length, const QColor& color) {
    return [this, length, color](QPainter& painter, const QPointF& at) {
      const QPointF tip = at + QPointF(length, 0.0);
      painter.setPen(QPen(color, sizes_.line()));
      painter.drawLine(at, tip);
      editor::FigurePainter(text_.theme()).arrowHead(painter, tip, 0.0, 5.0);
    };
  };
  if (options_.overlays.count(FigureOverlay::Velocities) > 0) {
    const double length = editor::kMetresPerVelocity * map_.scale();
    items.push_back(textItem(length, QStringLiteral("1 m/s"),
                             arrow(length, text_.theme().color(Role::TextSecondary))));
  }
  if (options_.overlays.count(FigureOverlay::Forces) > 0) {
    const std::pair<const char*, Role> terms[] = {{"goal", Role::ForceGoal},
                                                  {"people", Role::ForceSocial},
                                                  {"obstacles", Role::ForceObstacle},
                                                  {"group", Role::ForceGroup},
                                                  {"total", Role::ForceTotal}};
    for (const auto& [name, role] : terms) {
      items.push_back(
          textItem(14.0, QString::fromLatin1(name), arrow(14.0, text_.theme().color(role))));
    }
    const double length = editor::kMetresPerForce * map_.scale();
    items.push_back(textItem(length, QStringLiteral("1 m/s²"),
                             arrow(length, text_.theme().color(Role::TextSecondary))));
  }
}

std::vector<OverlayLegend::Item> OverlayLegend::items() const {
  std::vector<Item> all;
  const editor::Theme& theme = text_.theme();
  if (options_.overlays.count(FigureOverlay::Density) > 0) {
    const double most = map_.maxDensity();
    all.push_back(textItem(60.0,
                           QStringLiteral("0 to %1 people per m² (kernel radius R = %2 m)")
                               .arg(most, 0, 'g', 3)
                               .arg(metrics::kDensityRadius),
                           [&theme](QPainter& painter, const QPointF& at) {
                             for (int x = 0; x < 60; x += 2) {
                               painter.fillRect(QRectF(at.x() + x, at.y() - 4.0, 2.0, 8.0),
                                                editor::densityColor(theme, (x + 1.0) / 60.0));
                             }
                           }));
  }
  if (options_.overlays.count(FigureOverlay::Zones) > 0) {
    all.push_back(textItem(0.0, QStringLiteral("Hall zones: 0.45, 1.2, 3.6 m"), {}));
  }
  if (options_.overlays.count(FigureOverlay::Gaussian) > 0) {
    all.push_back(textItem(0.0, QStringLiteral("Gaussian personal space at 0.6, 0.2"), {}));
  }
  addArrows(all);
  if (options_.overlays.count(FigureOverlay::Contacts) > 0) {
    const std::pair<editor::ContactCause, const char*> causes[] = {
        {editor::ContactCause::Robot, "contact caused by robot"},
        {editor::ContactCause::Person, "contact caused by person"},
        {editor::ContactCause::Both, "contact caused by both"}};
    for (const auto& [cause, label] : causes) {
      all.push_back(textItem(11.0, QString::fromLatin1(label),
                             [&theme, why = cause](QPainter& painter, const QPointF& at) {
                               editor::OverlayPainter(painter, theme, {}, 0.8)
                                   .contactSign(at + QPointF(5.0, 0.0), why);
                             }));
    }
  }
  if (options_.timeMarks > 0.0) {
    all.push_back(textItem(0.0, QStringLiteral("○ every %1 s").arg(options_.timeMarks), {}));
  }
  return all;
}

double OverlayLegend::height(double width) const {
  double x = 0.0;
  int lines = 0;
  for (const Item& item : items()) {
    lines += lines == 0 || x + item.width > width + kKeyGap ? 1 : 0;
    x = x + item.width > width + kKeyGap ? item.width : x + item.width;
  }
  return lines * sizes_.row();
}

void OverlayLegend::paint(QPainter& painter, const QPointF& leftTop, double width) const {
  double x = 0.0;
  double y = leftTop.y() + 0.75 * sizes_.row();
  for (const Item& item : items()) {
    if (x > 0.0 && x + item.width > width + kKeyGap) {
      x = 0.0;
      y += sizes_.row();
    }
    item.paint(painter, {leftTop.x() + x, y});
    x += item.width;
  }
}

}  // namespace app
