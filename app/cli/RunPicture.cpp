#include "app/cli/RunPicture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

namespace {

constexpr double kMaxMapHeight = 1.4;  // maximum map height relative to the picture width

}  // namespace

RunFigure::RunFigure(const sim2d::Trace& trace, const FigureSizes& sizes, bool textAsOutlines,
                     const FigureOptions& options)
    : seed_(trace.header.seed),
      sizes_(sizes),
      text_(textAsOutlines),
      map_(trace, sizes_, text_, options),
      legend_(trace, map_, sizes_, text_),
      key_(map_, sizes_, text_, options) {}

void RunFigure::paintGround(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRectF(QPointF(), size_), Qt::white);
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
  const QString stands = time ? QStringLiteral("○ start   bodies drawn at %1 s").arg(now, 0, 'f', 1)
                              : QStringLiteral("○ start   bodies drawn at the end");
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
