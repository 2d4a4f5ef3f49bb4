#include "app/cli/FigureLegend.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

using editor::Role;

namespace {

constexpr double kLegendTop = 16.0;  // px to the title of a legend beside the map
constexpr double kKeyGap = 18.0;     // px between two items of a key

}  // namespace

FigureLegend::FigureLegend(const sim2d::Trace& trace, const FigureMap& map,
                           const FigureMeasures& measures, const FigureText& text)
    : title_(QString::fromStdString(trace.header.scenario)),
      map_(map),
      measures_(measures),
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
  constexpr std::size_t kMostRows = 24;
  const auto rows = static_cast<double>(std::min(kMostRows, entries_.size()));
  return kLegendTop + measures_.row() * (rows + 5.0) + measures_.foot();
}

int FigureLegend::columns(double width) const {
  return std::max(1, static_cast<int>(width / measures_.column()));
}

int FigureLegend::rows(double width) const {
  constexpr int kMostRows = 8;
  const auto count = static_cast<int>(entries_.size());
  return std::min(kMostRows, (count + columns(width) - 1) / columns(width));
}

double FigureLegend::heightBelow(double width) const {
  return measures_.row() * (rows(width) + 1);
}

void FigureLegend::paintBeside(QPainter& painter, const QPointF& leftTop, double foot,
                               const QString& when, const QString& last) const {
  const editor::Theme& theme = text_.theme();
  const double row = measures_.row();
  double y = leftTop.y() + kLegendTop;
  const double x = leftTop.x();
  text_.write(painter, {x, y}, theme.font(measures_.title(), QFont::DemiBold), Role::Text, title_);
  y += row;
  text_.write(painter, {x, y}, theme.figureFont(measures_.small()), Role::TextSecondary, when);
  y += 1.5 * row;
  const double bottom = foot - measures_.foot() - row;
  std::size_t shown = 0;
  for (const Entry& entry : entries_) {
    if (y > bottom) {
      break;
    }
    this->row(painter, {x, y}, entry, measures_.legend());
    y += row;
    ++shown;
  }
  const QFont font = theme.font(measures_.text());
  if (shown < entries_.size()) {
    text_.write(painter, {x, y}, font, Role::TextSecondary,
                QStringLiteral("and %1 more").arg(entries_.size() - shown));
  }
  text_.write(painter, {x, foot}, font, Role::TextSecondary, last);
}

/// In columns; the last one says how many have no place.
void FigureLegend::paintBelow(QPainter& painter, const QPointF& leftTop, double width,
                              const QString& when) const {
  const editor::Theme& theme = text_.theme();
  const double columnWidth = width / columns(width);
  double y = leftTop.y() + 0.8 * measures_.row();
  text_.write(painter, {leftTop.x(), y}, theme.font(measures_.text(), QFont::DemiBold), Role::Text,
              title_ + QStringLiteral(" · ") + when);
  y += measures_.row();
  const auto perColumn = static_cast<std::size_t>(std::max(1, rows(width)));
  const std::size_t places = static_cast<std::size_t>(columns(width)) * perColumn;
  const std::size_t shown = entries_.size() > places ? places - 1 : entries_.size();
  const auto placeOf = [&](std::size_t k) {
    const std::size_t column = k / perColumn;
    return QPointF(leftTop.x() + columnWidth * static_cast<double>(column),
                   y + measures_.row() * static_cast<double>(k % perColumn));
  };
  for (std::size_t k = 0; k < shown; ++k) {
    row(painter, placeOf(k), entries_[k], columnWidth);
  }
  if (shown < entries_.size()) {
    text_.write(painter, placeOf(shown), theme.font(measures_.text()), Role::TextSecondary,
                QStringLiteral("and %1 more").arg(entries_.size() - shown));
  }
}

/// In a column of that width; what does not fit is cut with dots.
void FigureLegend::row(QPainter& painter, const QPointF& at, const Entry& entry,
                       double width) const {
  const editor::Theme& theme = text_.theme();
  const double line = measures_.isNarrow ? 18.0 : 28.0;
  const double x = at.x();
  const double middle = at.y() - 4.0;
  painter.setPen(QPen(map_.colorOf(entry.id), measures_.line() * 4.0 / 3.0,
                      entry.id < 0 ? Qt::DashLine : Qt::SolidLine));
  painter.drawLine(QPointF(x, middle), QPointF(x + line, middle));
  if (entry.id >= 0) {
    editor::FigurePainter(theme).mark(painter, map_.lookOf(entry.id),
                                      QPointF(x + line + 14.0, middle), 10.0);
  }
  const QFont font = theme.font(measures_.text());
  const QFontMetricsF metrics(font);
  const double names = x + line + 28.0;
  const double room = measures_.isNarrow ? x + width - 6.0 - names : 176.0 - line - 34.0;
  const QString name = metrics.elidedText(entry.name, Qt::ElideRight, room);
  text_.write(painter, {names, at.y()}, font, Role::Text, name);
  const double kinds =
      measures_.isNarrow ? names + metrics.horizontalAdvance(name) + 6.0 : x + 176.0;
  if (kinds + metrics.horizontalAdvance(entry.kind) < x + width) {
    text_.write(painter, {kinds, at.y()}, font, Role::TextSecondary, entry.kind);
  }
}

FigureKey::FigureKey(const FigureMap& map, const FigureMeasures& measures, const FigureText& text,
                     const FigureOptions& options)
    : map_(map), measures_(measures), text_(text), options_(options) {}

FigureKey::Item FigureKey::words(double sample, const QString& says,
                                 std::function<void(QPainter&, const QPointF&)> paintSample) const {
  const QFont font = text_.theme().font(measures_.small());
  const double gap = sample > 0.0 ? 6.0 : 0.0;
  Item item;
  item.width = sample + gap + QFontMetricsF(font).horizontalAdvance(says) + kKeyGap;
  item.paint = [this, font, says, at = sample + gap, draw = std::move(paintSample)](
                   QPainter& painter, const QPointF& place) {
    if (draw) {
      draw(painter, place + QPointF(0.0, -3.5));
    }
    text_.write(painter, place + QPointF(at, 0.0), font, Role::TextSecondary, says);
  };
  return item;
}

/// Arrows with the length of one unit.
void FigureKey::addArrows(std::vector<Item>& items) const {
  const auto arrow = [this](double length, const QColor& color) {
    return [this, length, color](QPainter& painter, const QPointF& at) {
      const QPointF tip = at + QPointF(length, 0.0);
      painter.setPen(QPen(color, measures_.line()));
      painter.drawLine(at, tip);
      editor::FigurePainter(text_.theme()).arrowHead(painter, tip, 0.0, 5.0);
    };
  };
  if (options_.overlays.count(FigureOverlay::Velocities) > 0) {
    const double length = editor::kMetresPerVelocity * map_.scale();
    items.push_back(words(length, QStringLiteral("1 m/s"),
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
          words(14.0, QString::fromLatin1(name), arrow(14.0, text_.theme().color(role))));
    }
    const double length = editor::kMetresPerForce * map_.scale();
    items.push_back(words(length, QStringLiteral("1 m/s²"),
                          arrow(length, text_.theme().color(Role::TextSecondary))));
  }
}

std::vector<FigureKey::Item> FigureKey::items() const {
  std::vector<Item> all;
  const editor::Theme& theme = text_.theme();
  if (options_.overlays.count(FigureOverlay::Density) > 0) {
    const double most = map_.densityMost();
    all.push_back(words(60.0,
                        QStringLiteral("0 to %1 people per m² (kernel of R = %2 m)")
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
    all.push_back(words(0.0, QStringLiteral("zones of 0.45, 1.2, 3.6 m"), {}));
  }
  if (options_.overlays.count(FigureOverlay::Gaussian) > 0) {
    all.push_back(words(0.0, QStringLiteral("Gaussian spaces at 0.6, 0.2"), {}));
  }
  addArrows(all);
  if (options_.overlays.count(FigureOverlay::Contacts) > 0) {
    const std::pair<editor::ContactCause, const char*> causes[] = {
        {editor::ContactCause::Robot, "robot ran into it"},
        {editor::ContactCause::Person, "person ran into it"},
        {editor::ContactCause::Both, "both did"}};
    for (const auto& [cause, says] : causes) {
      all.push_back(words(11.0, QString::fromLatin1(says),
                          [&theme, why = cause](QPainter& painter, const QPointF& at) {
                            editor::OverlayPainter(painter, theme, {}, 0.8)
                                .contactSign(at + QPointF(5.0, 0.0), why);
                          }));
    }
  }
  if (options_.timeMarks > 0.0) {
    all.push_back(words(0.0, QStringLiteral("○ every %1 s").arg(options_.timeMarks), {}));
  }
  return all;
}

double FigureKey::height(double width) const {
  double x = 0.0;
  int lines = 0;
  for (const Item& item : items()) {
    lines += lines == 0 || x + item.width > width + kKeyGap ? 1 : 0;
    x = x + item.width > width + kKeyGap ? item.width : x + item.width;
  }
  return lines * measures_.row();
}

void FigureKey::paint(QPainter& painter, const QPointF& leftTop, double width) const {
  double x = 0.0;
  double y = leftTop.y() + 0.75 * measures_.row();
  for (const Item& item : items()) {
    if (x > 0.0 && x + item.width > width + kKeyGap) {
      x = 0.0;
      y += measures_.row();
    }
    item.paint(painter, {leftTop.x() + x, y});
    x += item.width;
  }
}

}  // namespace app
