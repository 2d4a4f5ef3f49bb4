#include "app/cli/RunStrip.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

using editor::Role;

namespace {

constexpr double kCellGap = 10.0;       // [px] between two maps
constexpr double kTallestStrip = 0.95;  // height of the maps over the width

FigureMeasures smallMeasures() {
  return FigureMeasures(0.0);
}

/// Names would not be read at that size: colours and marks say who is who.
FigureOptions withoutNames(FigureOptions options) {
  options.names = false;
  return options;
}

/// For the largest maps in a strip that is not taller than wide, with whole rows where a few more
/// columns give them.
int bestColumns(std::size_t count, double width, double heightOverWidth, double titleHeight) {
  constexpr std::size_t kMostColumns = 4;
  std::size_t best = count;
  for (std::size_t columns = count; columns > 0; --columns) {
    const std::size_t rows = (count + columns - 1) / columns;
    const double cell = width / static_cast<double>(columns);
    if (static_cast<double>(rows) * (cell * heightOverWidth + titleHeight) <=
        kTallestStrip * width) {
      best = columns;
    }
  }
  for (std::size_t columns = best; columns <= std::min(count, kMostColumns); ++columns) {
    if (count % columns == 0) {
      return static_cast<int>(columns);
    }
  }
  return static_cast<int>(best);
}

/// Within the run: what is written above a map is the time of the state that it shows.
std::vector<double> withinRun(std::vector<double> times, const sim2d::Trace& trace) {
  if (!trace.frames.empty()) {
    for (double& time : times) {
      time = std::clamp(time, trace.frames.front().time, trace.frames.back().time);
    }
  }
  return times;
}

}  // namespace

std::vector<double> evenTimes(const sim2d::Trace& trace, int count) {
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
    : seed_(trace.header.seed),
      times_(withinRun(std::move(times), trace)),
      measures_(smallMeasures()),
      text_(layout.textAsOutlines),
      map_(trace, measures_, text_, withoutNames(layout.options)),
      legend_(trace, map_, measures_, text_),
      key_(map_, measures_, text_, layout.options) {
  const double width = layout.width - 2.0 * measures_.margin();
  const double tall = map_.world().height() / map_.world().width();
  columns_ = bestColumns(times_.size(), width, tall, measures_.row());
  const double cell = (width - kCellGap * (columns_ - 1)) / columns_;
  cell_ = QSizeF(cell, cell * tall);
  map_.place(QRectF(QPointF(), cell_));
  const auto columns = static_cast<std::size_t>(columns_);
  const std::size_t rows = (times_.size() + columns - 1) / columns;
  const double heightOfRow = cell_.height() + measures_.row() + 6.0;
  size_ = QSizeF(layout.width,
                 std::ceil(2.0 * measures_.margin() + static_cast<double>(rows) * heightOfRow +
                           measures_.foot() + key_.height(width) + legend_.heightBelow(width)));
}

QRectF RunStrip::cellOf(std::size_t k) const {
  const auto columns = static_cast<std::size_t>(columns_);
  const std::size_t below = k / columns;
  const auto column = static_cast<double>(k % columns);
  const auto row = static_cast<double>(below);
  return {measures_.margin() + column * (cell_.width() + kCellGap),
          measures_.margin() + measures_.row() + row * (cell_.height() + measures_.row() + 6.0),
          cell_.width(), cell_.height()};
}

void RunStrip::paint(QPainter& painter) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRectF(QPointF(), size_), Qt::white);
  const editor::Theme& theme = text_.theme();
  for (std::size_t k = 0; k < times_.size(); ++k) {
    const QRectF cell = cellOf(k);
    map_.place(cell);
    map_.paint(painter, times_[k]);
    const QString letter = QStringLiteral("(%1) ").arg(QChar(char16_t('a' + k % 26)));
    text_.write(painter, {map_.mapRect().left(), cell.top() - 5.0},
                theme.font(measures_.text(), QFont::DemiBold), Role::Text, letter);
    const double after =
        QFontMetricsF(theme.font(measures_.text(), QFont::DemiBold)).horizontalAdvance(letter);
    text_.write(painter, {map_.mapRect().left() + after, cell.top() - 5.0},
                theme.figureFont(measures_.text()), Role::Text,
                QStringLiteral("%1 s").arg(times_[k], 0, 'f', 1));
  }
  const double left = measures_.margin();
  const double width = size_.width() - 2.0 * left;
  double y = cellOf(times_.size() - 1).bottom();
  map_.paintScale(painter, {left, y + 0.6 * measures_.foot()});
  y += measures_.foot();
  key_.paint(painter, {left, y}, width);
  y += key_.height(width);
  legend_.paintBelow(painter, {left, y}, width, QStringLiteral("seed %1").arg(seed_));
}

}  // namespace app
