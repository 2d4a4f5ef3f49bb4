#include "app/cli/RunPicture.h"

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
  const bool hasLine = map_.hasPaths();
  const double line = !hasLine ? -8.0 : sizes_.isNarrow ? 18.0 : 28.0;
  const double x = at.x();
  const QPointF mark(x + line + 14.0, at.y() - 4.0);
  if (hasLine) {
    painter.setPen(QPen(map_.colorOf(entry.id), sizes_.line() * 4.0 / 3.0,
                        entry.id < 0 ? Qt::DashLine : Qt::SolidLine));
    painter.drawLine(QPointF(x, mark.y()), QPointF(x + line, mark.y()));
  }
  if (entry.id >= 0) {
    editor::FigurePainter(theme).mark(painter, map_.lookOf(entry.id), mark, 10.0);
  } else if (!hasLine) {
    painter.save();
    painter.translate(mark);
    editor::FigurePainter(theme).robot(painter, {6.0, 0.0, {}});
    painter.restore();
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

namespace {

constexpr double kMaxMapHeight = 1.4;  // maximum map height relative to the picture width

}  // namespace

RunFigure::RunFigure(const sim2d::Trace& trace, const FigureSizes& sizes, bool textAsOutlines,
                     const FigureOptions& options)
    : seed_(trace.header.seed),
      sizes_(sizes),
      text_(textAsOutlines, options.isDark),
      map_(trace, sizes_, text_, options),
      legend_(trace, map_, sizes_, text_),
      key_(map_, sizes_, text_, options) {}

void RunFigure::paintGround(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRectF(QPointF(), size_), ground());
}

double RunFigure::paintFoot(QPainter& painter, const QPointF& leftTop, double width) const {
  map_.paintScale(painter, leftTop + QPointF(0.0, 0.6 * sizes_.foot()));
  const QPointF below = leftTop + QPointF(0.0, sizes_.foot());
  key_.paint(painter, below, width);
  return below.y() + key_.height(width);
}

RunPicture::RunPicture(const sim2d::Trace& trace, const PictureLayout& layout)
    : RunFigure(trace, FigureSizes(layout.width), layout.textAsOutlines, layout.options) {
  const double margin = sizes_.margin();
  const double width = layout.width - 2.0 * margin - sizes_.legend();
  map_.place(QRectF(0.0, 0.0, width, kMaxMapHeight * layout.width));  // scale for arrows of key_
  const double below = sizes_.isNarrow ? legend_.heightBelow(width) : 0.0;
  const double rest = 2.0 * margin + sizes_.foot() + key_.height(width) + below;
  const double most = layout.height ? *layout.height - rest : kMaxMapHeight * layout.width;
  const double scale = std::min(width / map_.world().width(), most / map_.world().height());
  const double beside = sizes_.isNarrow ? 0.0 : legend_.heightBeside() - 2.0 * margin;
  const double high = layout.height ? most : std::max(scale * map_.world().height(), beside);
  map_.place(QRectF(margin, margin, width, high));
  size_ = QSizeF(layout.width, layout.height ? *layout.height : std::ceil(high + rest));
}

void RunPicture::paint(QPainter& painter, std::optional<double> time) {
  paintGround(painter);
  map_.paint(painter, time);
  const double left = map_.drawnLeft();
  const double width = size_.width() - sizes_.margin() - sizes_.legend() - left;
  const double y = paintFoot(painter, {left, map_.mapRect().bottom()}, width);
  const double now = std::min(time.value_or(map_.lastTime()), map_.lastTime());
  const QString when = QStringLiteral("%1 s · seed %2").arg(now, 0, 'f', 1).arg(seed_);
  if (sizes_.isNarrow) {
    legend_.paintBelow(painter, {left, y}, width, when);
    return;
  }
  const QString stands =
      (map_.hasPaths() ? QStringLiteral("○ start   ") : QString()) +
      (time ? QStringLiteral("bodies drawn at %1 s").arg(now, 0, 'f', 1)
            : QStringLiteral("bodies drawn at the %1")
                  .arg(map_.hasPaths() ? QLatin1String("end") : QLatin1String("start")));
  legend_.paintBeside(painter, {size_.width() - sizes_.legend(), sizes_.margin()},
                      size_.height() - sizes_.margin() - 0.4 * sizes_.foot(), when, stands);
}

using editor::Role;

namespace {

constexpr double kCellGap = 10.0;         // [px] between two maps
constexpr double kMaxStripHeight = 0.95;  // maximum height of all maps relative to the width

/// Names would be illegible at this size; colours and marks identify the bodies.
FigureOptions withoutNames(FigureOptions options) {
  options.names = false;
  return options;
}

/// Maximises the map size in a strip that is not taller than wide, preferring complete rows if a
/// few more columns give them.
int bestColumns(std::size_t count, double width, double heightOverWidth, double titleHeight) {
  constexpr std::size_t kMaxColumns = 4;
  std::size_t best = count;
  for (std::size_t columns = count; columns > 0; --columns) {
    const std::size_t rows = (count + columns - 1) / columns;
    const double cell = width / static_cast<double>(columns);
    if (static_cast<double>(rows) * (cell * heightOverWidth + titleHeight) <=
        kMaxStripHeight * width) {
      best = columns;
    }
  }
  for (std::size_t columns = best; columns <= std::min(count, kMaxColumns); ++columns) {
    if (count % columns == 0) {
      return static_cast<int>(columns);
    }
  }
  return static_cast<int>(best);
}

/// Clamps to the duration of the run, so that the label of a map is the time of the shown state.
std::vector<double> withinRun(std::vector<double> times, const sim2d::Trace& trace) {
  if (!trace.frames.empty()) {
    for (double& time : times) {
      time = std::clamp(time, trace.frames.front().time, trace.frames.back().time);
    }
  }
  return times;
}

}  // namespace

std::vector<double> equidistantTimes(const sim2d::Trace& trace, int count) {
  const double first = trace.frames.empty() ? 0.0 : trace.frames.front().time;
  const double last = trace.frames.empty() ? 0.0 : trace.frames.back().time;
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(std::max(count, 0)));
  for (int k = 0; k < count; ++k) {
    times.push_back(count == 1 ? last : first + (last - first) * k / (count - 1));
  }
  return times;
}

RunStrip::RunStrip(const sim2d::Trace& trace, const PictureLayout& layout,
                   std::vector<double> times)
    : RunFigure(trace, FigureSizes(0.0), layout.textAsOutlines, withoutNames(layout.options)),
      times_(withinRun(std::move(times), trace)) {
  const double width = layout.width - 2.0 * sizes_.margin();
  const double tall = map_.world().height() / map_.world().width();
  columns_ = bestColumns(times_.size(), width, tall, sizes_.row());
  const double cell = (width - kCellGap * (columns_ - 1)) / columns_;
  cell_ = QSizeF(cell, cell * tall);
  map_.place(QRectF(QPointF(), cell_));
  const auto columns = static_cast<std::size_t>(columns_);
  const std::size_t rows = (times_.size() + columns - 1) / columns;
  const double heightOfRow = cell_.height() + sizes_.row() + 6.0;
  size_ = QSizeF(layout.width,
                 std::ceil(2.0 * sizes_.margin() + static_cast<double>(rows) * heightOfRow +
                           sizes_.foot() + key_.height(width) + legend_.heightBelow(width)));
}

QRectF RunStrip::cellOf(std::size_t k) const {
  const auto columns = static_cast<std::size_t>(columns_);
  const std::size_t below = k / columns;
  const auto column = static_cast<double>(k % columns);
  const auto row = static_cast<double>(below);
  return {sizes_.margin() + column * (cell_.width() + kCellGap),
          sizes_.margin() + sizes_.row() + row * (cell_.height() + sizes_.row() + 6.0),
          cell_.width(), cell_.height()};
}

void RunStrip::paint(QPainter& painter) {
  paintGround(painter);
  const editor::Theme& theme = text_.theme();
  for (std::size_t k = 0; k < times_.size(); ++k) {
    const QRectF cell = cellOf(k);
    map_.place(cell);
    map_.paint(painter, times_[k]);
    const QString letter = QStringLiteral("(%1) ").arg(QChar(char16_t('a' + k % 26)));
    text_.write(painter, {map_.mapRect().left(), cell.top() - 5.0},
                theme.font(sizes_.text(), QFont::DemiBold), Role::Text, letter);
    const double after =
        QFontMetricsF(theme.font(sizes_.text(), QFont::DemiBold)).horizontalAdvance(letter);
    text_.write(painter, {map_.mapRect().left() + after, cell.top() - 5.0},
                theme.figureFont(sizes_.text()), Role::Text,
                QStringLiteral("%1 s").arg(times_[k], 0, 'f', 1));
  }
  const double left = sizes_.margin();
  const double width = size_.width() - 2.0 * left;
  const double y = paintFoot(painter, {left, cellOf(times_.size() - 1).bottom()}, width);
  legend_.paintBelow(painter, {left, y}, width, QStringLiteral("seed %1").arg(seed_));
}

}  // namespace app
